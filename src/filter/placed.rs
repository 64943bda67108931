//! The ellipse under a pixel in its place in a level.

use super::Texture;
use super::gathered::LANES;
use super::walk::ROWS;
use crate::kernel::pixel::Footprint;

/// An ellipse in a level, and the texels that it may hold.
///
/// With M = [[a, b], [b, c]] and d = det M, Q = v²/c + (c/d) (u - v b/c)²: no root and no division a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// The texel that holds the middle.
    pub texel: [i64; 2],
    /// The middle's place in it, 0 to 1.
    pub fraction: [f32; 2],
    /// The ellipse.
    pub footprint: Footprint<f64>,
    /// c/d.
    pub curvature: f32,
    /// b/c.
    pub slope: f32,
    /// 1/c.
    pub inverse: f32,
    /// First column and row that may hold a texel of it, counted from the middle's.
    pub first: [i32; 2],
    /// Last ones.
    pub last: [i32; 2],
}

impl Placed {
    /// To be written over.
    pub const NONE: Placed = Placed {
        texel: [0; 2],
        fraction: [0.0; 2],
        footprint: Footprint { uu: 0.0, uv: 0.0, vv: 0.0, determinant: 0.0 },
        curvature: 0.0,
        slope: 0.0,
        inverse: 0.0,
        first: [0; 2],
        last: [0; 2],
    };

    #[inline(always)]
    pub fn new([s, t]: [f64; 2], footprint: Footprint<f64>) -> Placed {
        /// Adding it leaves a whole number up to 2⁵¹ in the last bits.
        const WHOLE: f64 = 6_755_399_441_055_744.0;
        let (x, y) = (s.floor(), t.floor());
        let whole = |x: f64| (x + WHOLE).to_bits().wrapping_sub(WHOLE.to_bits()) as i64;
        let texel = [whole(x), whole(y)];
        let (fu, fv) = ((s - x) as f32, (t - y) as f32);
        // Of an ellipse thinner than 10⁻³⁸: still 0 times it is 0.
        let single = |x: f64| x.min(f64::from(f32::MAX)) as f32;
        let Footprint { uu, uv, vv, determinant } = footprint;
        let inverse = 1.0 / vv;
        let (left, right) = texels(uu, fu);
        let (top, bottom) = texels(vv, fv);
        Placed {
            texel,
            fraction: [fu, fv],
            footprint,
            curvature: single(vv / determinant),
            slope: (uv * inverse) as f32,
            inverse: single(inverse),
            first: [left, top],
            last: [right, bottom],
        }
    }

    /// Whether all that is read lies in the level, or behind it in memory.
    #[inline(always)]
    pub fn is_inside(&self, level: &Texture) -> bool {
        let Placed { texel, first, last, .. } = *self;
        texel[0] + i64::from(first[0]) >= 0
            && texel[0] + i64::from(last[0]) < level.width() as i64
            && texel[1] + i64::from(first[1]) >= 0
            && texel[1] + i64::from(last[1]) < level.height() as i64
    }

    /// The first texel, if one strip inside the level holds all.
    #[inline(always)]
    pub fn strip(&self, level: &Texture) -> Option<usize> {
        let Placed { texel, first, last, .. } = *self;
        if last[0] - first[0] >= LANES as i32 || last[1] - first[1] >= ROWS || !self.is_inside(level) {
            return None;
        }
        let [x, y] = [0, 1].map(|i| (texel[i] + i64::from(first[i])) as usize);
        Some(y * level.width() + x)
    }
}

/// First and last k that hold every k with (k + ½ - fraction)² ≤ square.
#[inline(always)]
fn texels(square: f64, fraction: f32) -> (i32, i32) {
    let half = (square as f32).sqrt();
    // Offsets are rounded to 2⁻²² of the end, Q's terms to as much of theirs.
    let reach = half + (1e-5 + 1e-5 * half);
    let middle = fraction - 0.5;
    (-down(reach - middle), down(reach + middle))
}

/// The whole number below x, or x itself or one less where it is one; |x| < 2²².
#[inline(always)]
pub(super) fn down(x: f32) -> i32 {
    /// Adding it leaves the nearest whole number in the last bits.
    const ROUND: f32 = 12_582_912.0;
    ((x - 0.5) + ROUND).to_bits().wrapping_sub(ROUND.to_bits()) as i32
}
