//! The ellipse under a pixel, before it has a place.

use super::{AxesKind, EllipseFilter};
use crate::kernel::pixel::{Axes, Footprint, Jacobian, Padding, TiltFormula};

/// An ellipse in texels of level 0, not padded; in double precision, where squares of `f32` are
/// exact and nothing leaves the range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub footprint: Footprint<f64>,
    /// Direction of the paper's first axis, where the ellipse is the paper's.
    pub tilt: Option<f64>,
}

impl Shape {
    #[inline(always)]
    pub fn of(j: Jacobian<f32>, filter: &EllipseFilter) -> Shape {
        let j =
            Jacobian { ux: f64::from(j.ux), vx: f64::from(j.vx), uy: f64::from(j.uy), vy: f64::from(j.vy) };
        let (footprint, tilt) = match filter.axes {
            AxesKind::True => {
                // Both products are exact.
                let determinant = j.ux * j.vy - j.uy * j.vx;
                let footprint = Footprint {
                    uu: j.ux * j.ux + j.uy * j.uy,
                    uv: j.ux * j.vx + j.uy * j.vy,
                    vv: j.vx * j.vx + j.vy * j.vy,
                    determinant: determinant * determinant,
                };
                (footprint, None)
            }
            AxesKind::Paper(formula) => paper(j, formula),
        };
        Shape { footprint, tilt }
    }

    /// The semi-axes, squared: the longer, the shorter.
    #[inline(always)]
    pub fn axes(&self) -> [f64; 2] {
        let Footprint { uu, uv, vv, determinant } = self.footprint;
        let half = 0.5 * (uu - vv);
        let major = 0.5 * (uu + vv) + (half * half + uv * uv).sqrt();
        [major, if major > 0.0 { determinant / major } else { 0.0 }]
    }

    /// With the minor axis raised to major/limit where it is shorter; and the square of the minor axis.
    #[inline(always)]
    pub fn limited(mut self, limit: f64) -> (Shape, f64) {
        let [major, minor] = self.axes();
        let least = major / (limit * limit);
        if minor >= least {
            return (self, minor);
        }
        // M' = (1 - ρ) M + ρ major I has the same axes and the eigenvalues major and `least`.
        let Footprint { uu, uv, vv, .. } = self.footprint;
        let rho = (least - minor) / (major - minor);
        self.footprint = Footprint {
            uu: uu + rho * (major - uu),
            uv: uv - rho * uv,
            vv: vv + rho * (major - vv),
            determinant: major * least,
        };
        (self, least)
    }

    /// In a level whose sides are `ratio` times those of level 0, padded there if asked to.
    #[inline(always)]
    pub fn in_level(&self, ratio: [f64; 2], padding: Padding) -> Footprint<f64> {
        let Footprint { uu, uv, vv, determinant } = self.footprint;
        let [x, y] = ratio;
        let (uu, uv, vv) = (uu * x * x, uv * x * y, vv * y * y);
        let determinant = determinant * (x * y) * (x * y);
        match padding {
            Padding::Plain => Footprint { uu, uv, vv, determinant },
            Padding::Padded => {
                Footprint { uu: uu + 1.0, uv, vv: vv + 1.0, determinant: determinant + uu + vv + 1.0 }
            }
        }
    }
}

#[cold]
fn paper(j: Jacobian<f64>, formula: TiltFormula) -> (Footprint<f64>, Option<f64>) {
    let axes = Axes::paper(j, formula);
    // 0/0: a circle, or a vector of length 0; any direction does.
    let tilt = if axes.tilt.is_nan() { 0.0 } else { axes.tilt };
    (Footprint::along(&Axes { tilt, ..axes }.frame()), Some(tilt))
}

/// Most texels that one lookup in one level may have to look at.
const MOST: f64 = (1u64 << 28) as f64;
/// Longest half width and half height: whole numbers and halves are exact in `f32`.
const FARTHEST: f64 = (1u64 << 21) as f64;

/// Whether the ellipse is small enough to be read texel by texel: 2²⁸ texels, 2²¹ to either side.
#[inline(always)]
pub(super) fn is_readable(footprint: &Footprint<f64>) -> bool {
    let Footprint { uu, vv, determinant, .. } = *footprint;
    // Below 4096 to either side without a closer look; a line has nothing to read.
    uu + vv < f64::from(1 << 24) || determinant == 0.0 || is_readable_in_full(uu, vv, determinant)
}

/// By values: a reference would bring the ellipse into memory on every path.
#[cold]
fn is_readable_in_full(uu: f64, vv: f64, determinant: f64) -> bool {
    let (width, height) = (uu.sqrt(), vv.sqrt());
    // The longest row; eight are looked at together.
    let row = 2.0 * (determinant / vv).sqrt() + 8.0;
    width <= FARTHEST && height <= FARTHEST && (2.0 * height + 2.0) * row <= MOST
}
