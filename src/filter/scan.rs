//! The weighted sum over the texels of an ellipse, in lanes.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

use super::placed::Placed;
use super::weight::LaneWeight;
use super::{Texture, Wrap};

/// Columns, and rows, looked at together: a tile. One is enough for most round ellipses, and a loop that
/// always runs as often is a branch that is never mispredicted.
const LANES: usize = 8;
const PAIR: usize = 2 * LANES;
/// Tiles that are added up in single precision before the sum goes on in double precision.
const PENDING: u32 = 8;

type Lanes = [f32; LANES];
/// Two rows of a tile.
type Pair = [f32; PAIR];
type Tile = [Pair; LANES / 2];

/// Sums over the texels with Q ≤ 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sum {
    /// Of the weights.
    pub weight: f64,
    /// Of weight × value; absent channels 0.
    pub values: [f64; 4],
    /// Of texels.
    pub texels: u64,
}

impl Sum {
    /// The weighted mean, or `None` without weight.
    #[inline(always)]
    pub fn mean(&self) -> Option<[f32; 4]> {
        (self.weight > 0.0).then(|| self.values.map(|value| (value / self.weight) as f32))
    }
}

/// One ellipse over C channels of a level.
///
/// With M = [[a, b], [b, c]] and d = det M, Q = v²/c + (c/d) (u - v b/c)². The ellipse is cut into strips of
/// [`LANES`] columns; along a strip, u √(c/d) stays and each row takes two numbers, v b/c √(c/d) and v²/c: no
/// root and no division a row. A texel counts if the Q computed so is ≤ 1, and the strips' rows are chosen
/// wide enough for that alone to decide. u and v are k + ½ - fraction with k a whole number from the middle's
/// texel, so that a mirrored texture, position and ellipse give the same Q to the last bit, and a texel on the
/// rim counts in both or in neither.
///
/// A tile's weights are computed first and then meet the channels one after the other: loops
/// that end in a store or in one sum are those the compiler reliably turns into vectors.
pub(super) struct Scan<'a, W, const C: usize> {
    pub level: &'a Texture,
    pub wrap: Wrap,
    pub placed: Placed,
    pub weight: W,
}

/// What a row needs of the ellipse.
struct Rows {
    /// √(c/d).
    root: f32,
    /// b/c √(c/d).
    slope: f32,
    /// 1/c.
    inverse: f32,
    /// The middle's place in its row of texels.
    fraction: f32,
}

impl Rows {
    /// Weights of the rows from k on along a strip with offsets `us` = u √(c/d), two rows at a time.
    #[inline(always)]
    fn weigh<W: LaneWeight>(&self, weight: W, us: &Pair, k: i32, tile: &mut Tile, texels: &mut [u32; PAIR]) {
        let (us, mut count) = (*us, *texels);
        let mut centre = [k as f32 + 0.5; PAIR];
        for i in LANES..PAIR {
            centre[i] += 1.0;
        }
        for pair in tile {
            for i in 0..PAIR {
                let v = centre[i] - self.fraction;
                let e = us[i] - v * self.slope;
                let q = v * (v * self.inverse) + e * e;
                // A mask where a branch would be natural: branches do not become vectors.
                let mask = if q <= 1.0 { u32::MAX } else { 0 };
                pair[i] = f32::from_bits(weight.at(q).to_bits() & mask);
                count[i] = count[i].wrapping_sub(mask);
                centre[i] += 2.0;
            }
        }
        *texels = count;
    }
}

struct Totals<const C: usize> {
    weight: Pair,
    values: [Lanes; C],
    texels: [u32; PAIR],
    /// Tiles in them.
    pending: u32,
}

impl<const C: usize> Totals<C> {
    #[inline(always)]
    fn new() -> Self {
        Totals { weight: [0.0; PAIR], values: [[0.0; LANES]; C], texels: [0; PAIR], pending: 0 }
    }

    #[inline(always)]
    fn add_weights(&mut self, tile: &Tile) {
        let mut sum = self.weight;
        for pair in tile {
            for i in 0..PAIR {
                sum[i] += pair[i];
            }
        }
        self.weight = sum;
        self.pending += 1;
    }

    #[inline(always)]
    fn add_row(&mut self, c: usize, weights: &[f32], values: &[f32]) {
        for i in 0..LANES {
            self.values[c][i] += weights[i] * values[i];
        }
    }

    /// Moves everything into `sum`. A call that stays one: lanes that pass through memory as a whole are
    /// kept as a whole in the loops before, while a sum over lanes in sight of them splits them into pairs.
    #[inline(never)]
    fn flush(&mut self, sum: &mut Sum) {
        let weight: Lanes = std::array::from_fn(|i| self.weight[i] + self.weight[i + LANES]);
        sum.weight += total(&weight);
        for (sum, lanes) in sum.values.iter_mut().zip(&self.values) {
            *sum += total(lanes);
        }
        sum.texels += u64::from(self.texels.iter().sum::<u32>());
        *self = Totals::new();
    }
}

#[inline(always)]
fn total(lanes: &Lanes) -> f64 {
    let four: [f32; 4] = std::array::from_fn(|i| lanes[i] + lanes[i + 4]);
    f64::from((four[0] + four[2]) + (four[1] + four[3]))
}

impl<W: LaneWeight, const C: usize> Scan<'_, W, C> {
    /// The sums.
    #[inline(always)]
    pub fn sum(self) -> Sum {
        let Placed { texel, fraction, footprint } = self.placed;
        let inverse = 1.0 / footprint.vv;
        // Of an ellipse thinner than 10⁻³⁸: still 0 times it is 0.
        let single = |x: f64| x.min(f64::from(f32::MAX)) as f32;
        let root = (footprint.vv / footprint.determinant).sqrt();
        let rows = Rows {
            root: single(root),
            slope: (footprint.uv * inverse * root) as f32,
            inverse: single(inverse),
            fraction: fraction[1],
        };
        let (width, height) = (footprint.uu.sqrt(), footprint.vv.sqrt());
        let (first, last) = texels(-width, width, fraction[0]);
        let (top, bottom) = texels(-height, height, fraction[1]);
        let (w, h) = (self.level.width(), self.level.height());
        let (x, y) = (texel[0] + first, texel[1] + top);
        // Tiles may reach over the ellipse, as far as weights of 0 go.
        let reach = LANES as i64 - 1;
        let inside = x >= 0 && texel[0] + last < w as i64 && y >= 0 && texel[1] + bottom + reach < h as i64;
        // Of one length in sight of the compiler, which then checks a row's bounds once for all channels.
        let length = self.level.run(0).len();
        let planes: [&[f32]; C] = std::array::from_fn(|c| &self.level.run(c)[..length]);
        let mut tile = [[0.0; PAIR]; LANES / 2];
        let (mut sum, mut totals) = (Sum::default(), Totals::<C>::new());
        let mut start = first;
        while start <= last {
            let mut us = [0.0; PAIR];
            for i in 0..PAIR {
                us[i] = (((start as i32 + (i % LANES) as i32) as f32 + 0.5) - fraction[0]) * rows.root;
            }
            let (mut from, mut to) = (top, bottom);
            if last - first >= LANES as i64 {
                let left = start as f64 + 0.5 - f64::from(fraction[0]);
                let (low, high) = self.placed.heights(width, height, left, left + (LANES - 1) as f64);
                (from, to) = texels(low, high, fraction[1]);
            }
            while from <= to {
                if totals.pending == PENDING {
                    totals.flush(&mut sum);
                }
                rows.weigh(self.weight, &us, from as i32, &mut tile, &mut totals.texels);
                totals.add_weights(&tile);
                if inside {
                    // Lanes beyond the ellipse may read the next row, or the zeros behind the last.
                    let at = (texel[1] + from) as usize * w + (texel[0] + start) as usize;
                    for c in 0..C {
                        let mut sum = totals.values[c];
                        for r in 0..LANES {
                            let start = at + r * w;
                            let values = &planes[c][start..start + LANES];
                            for i in 0..LANES {
                                sum[i] += tile[r / 2][r % 2 * LANES + i] * values[i];
                            }
                        }
                        totals.values[c] = sum;
                    }
                } else {
                    self.wrapped(&tile, &mut totals, [texel[0] + start, texel[1] + from]);
                }
                from += LANES as i64;
            }
            start += LANES as i64;
        }
        totals.flush(&mut sum);
        sum
    }

    /// A tile that lies across an edge, or beyond.
    #[inline(always)]
    fn wrapped(&self, tile: &Tile, totals: &mut Totals<C>, at: [i64; 2]) {
        let (w, h) = (self.level.width(), self.level.height());
        let mut columns = [0; LANES];
        let mut rows = [0; LANES];
        for i in 0..LANES {
            columns[i] = self.wrap.index(at[0] + i as i64, w);
            rows[i] = self.wrap.index(at[1] + i as i64, h) * w;
        }
        for c in 0..C {
            let plane = self.level.run(c);
            for r in 0..LANES {
                let mut values = [0.0; LANES];
                for i in 0..LANES {
                    values[i] = plane[rows[r] + columns[i]];
                }
                totals.add_row(c, &tile[r / 2][r % 2 * LANES..][..LANES], &values);
            }
        }
    }
}

/// First and last k with k + ½ - fraction in [low, high], and what rounding may add to either side.
#[inline(always)]
fn texels(low: f64, high: f64, fraction: f32) -> (i64, i64) {
    /// Makes whatever a readable ellipse holds positive, so that the casts round up and down.
    const SHIFT: f64 = (1u64 << 30) as f64;
    // Offsets are rounded to 2⁻²² of the larger end, Q's terms to as much of theirs.
    let slack = 1e-5 + 1e-5 * high.abs().max(low.abs());
    let middle = f64::from(fraction) - 0.5;
    let down = |x: f64| (x + SHIFT) as i64 - SHIFT as i64;
    (-down(slack - middle - low), down(middle + high + slack))
}

impl Placed {
    /// Least and greatest v of the ellipse of these half sides for u from `left` to `right`, both taken into
    /// its width.
    #[inline(always)]
    fn heights(&self, width: f64, height: f64, left: f64, right: f64) -> (f64, f64) {
        let f = &self.footprint;
        let (left, right) = (left.max(-width).min(width), right.min(width).max(-width));
        let inverse = 1.0 / f.uu;
        let half = |u: f64| (f.determinant * (f.uu - u * u).max(0.0)).sqrt() * inverse;
        let (m0, h0) = (left * f.uv * inverse, half(left));
        let (m1, h1) = (right * f.uv * inverse, half(right));
        // The boundary's highest point, ± the lowest.
        let peak = f.uv / height;
        let high = if left <= peak && peak <= right { height } else { (m0 + h0).max(m1 + h1) };
        let low = if left <= -peak && -peak <= right { -height } else { (m0 - h0).min(m1 - h1) };
        (low, high)
    }
}
