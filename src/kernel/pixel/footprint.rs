//! The footprint Q = xᵀ M⁻¹ x of a pixel.

use super::{Frame, Jacobian};
use crate::kernel::real::Real;

/// Whether a texel's own size is added to the footprint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Padding {
    /// M = J Jᵀ.
    Plain,
    /// M = J Jᵀ + I, so that no axis is shorter than one texel.
    Padded,
}

/// Ellipse of texels under a pixel, by its matrix M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint<F> {
    /// M's entry of u with u: the square of the half width.
    pub uu: F,
    /// Of u with v.
    pub uv: F,
    /// Of v with v: the square of the half height.
    pub vv: F,
    /// det M, computed without cancellation.
    pub determinant: F,
}

/// One row of an ellipse: Q = `least` + `curvature` (u - `middle`)².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row<F> {
    /// u where Q is least.
    pub middle: F,
    /// Q there.
    pub least: F,
    /// Half the second derivative of Q along u.
    pub curvature: F,
}

impl<F: Real> Footprint<F> {
    /// Of a Jacobian.
    #[inline]
    pub fn of(j: Jacobian<F>, padding: Padding) -> Self {
        let (uu, vv) = (j.ux * j.ux + j.uy * j.uy, j.vx * j.vx + j.vy * j.vy);
        let (uv, det) = (j.ux * j.vx + j.uy * j.vy, j.determinant());
        match padding {
            Padding::Plain => Footprint { uu, uv, vv, determinant: det * det },
            Padding::Padded => {
                Footprint { uu: uu + F::ONE, uv, vv: vv + F::ONE, determinant: det * det + uu + vv + F::ONE }
            }
        }
    }

    /// Of axes.
    #[inline]
    pub fn along(frame: &Frame<F>) -> Self {
        let [uu, uv, vv] = frame.matrix();
        let area = frame.major * frame.minor;
        Footprint { uu, uv, vv, determinant: area * area }
    }

    /// Half width and half height of the bounding box.
    #[inline]
    pub fn bounds(&self) -> (F, F) {
        (self.uu.sqrt(), self.vv.sqrt())
    }

    /// Q along the row at v from the middle: a sum of two squares, where nothing cancels.
    #[inline]
    pub fn row(&self, v: F) -> Row<F> {
        Row {
            middle: v * (self.uv / self.vv),
            least: v * (v / self.vv),
            curvature: self.vv / self.determinant,
        }
    }

    /// Q at (u, v) from the middle, in texels.
    #[inline]
    pub fn q(&self, u: F, v: F) -> F {
        let row = self.row(v);
        let off = u - row.middle;
        row.least + row.curvature * off * off
    }
}
