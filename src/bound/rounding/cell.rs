//! A box of exponents and angles, with every way to write its angles.

use super::super::difference::reciprocal;
use super::super::rounded::{Arithmetic, Rounded};
use super::super::scaled_versine::scaled_versine;
use super::super::{Format, Handed, Interval};
use crate::integral::Field;

/// ln(1 + v) from which on v counts as going on to ∞.
pub(super) const FURTHEST: f64 = 50.0;

/// Exponents and angles: n with m = 1/n, v = -ln cosⁿ, c = cos θ, w = 1 - c and t = n w.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) n: Interval,
    pub(super) m: Interval,
    pub(super) v: Interval,
    pub(super) t: Interval,
    pub(super) cosine: Interval,
    pub(super) versine: Interval,
}

impl Cell {
    /// From boxes of ln n and ln(1 + v), n within its range.
    pub(super) fn new([log_n, log_v]: [Interval; 2], range: Interval) -> Self {
        // The logarithm of an end is rounded outward and may lead past it.
        let around = log_n.exp();
        let within = |n: f64| n.clamp(range.lo(), range.hi());
        let n = Interval::new(within(around.lo()), within(around.hi()));
        let m = reciprocal(n);
        let v = log_v.exp() - Interval::from(1.0);
        let last = if log_v.hi() >= FURTHEST { f64::INFINITY } else { v.hi() };
        let v = Interval::new(v.lo().max(0.0), last.max(0.0));
        let cosine = (-(v * m)).exp().least(Interval::from(1.0));
        let t = scaled_versine(m, v).least(Interval::from(n.hi()));
        let versine = (Interval::from(1.0) - cosine).max(Interval::ZERO).intersect(t * m);
        Cell { n, m, v, t, cosine, versine: versine.least(Interval::from(1.0)) }
    }

    /// The part of it where a versine off by `error` may come out at 1 or above; `None` if there is none.
    pub(super) fn edge(&self, error: f64) -> Option<Self> {
        let error = Interval::from(error.min(1.0));
        if self.cosine.lo() > error.hi() {
            return None;
        }
        let least = (Interval::from(1.0) - error).lo();
        // v = -n ln c; where the error is 0, so is cos θ.
        let v =
            if error.hi() > 0.0 { (-(Interval::from(self.n.lo()) * error.ln())).lo() } else { self.v.lo() };
        let from = |side: Interval, lo: f64| Interval::new(side.lo().max(lo).min(side.hi()), side.hi());
        Some(Cell {
            v: from(self.v, v),
            t: from(self.t, (Interval::from(self.n.lo()) * Interval::from(least)).lo()),
            cosine: Interval::new(self.cosine.lo(), self.cosine.hi().min(error.hi())),
            versine: from(self.versine, least),
            ..*self
        })
    }

    /// cosⁿ.
    pub(super) fn target(&self) -> Interval {
        (-self.v).exp()
    }
}

/// What a kernel is handed: its angle, as float or with what float makes of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Argument {
    pub(super) handed: Handed,
    /// ĉ: rounded, or 1 - ŵ.
    pub(super) cosine: Rounded,
    /// ŵ: 1 - ĉ, rounded, or computed.
    pub(super) versine: Rounded,
    /// n ŵ, n exact.
    pub(super) scaled: Rounded,
}

impl Argument {
    pub(super) fn new(cell: &Cell, format: Format, handed: Handed) -> Self {
        let (stored, by) = (Arithmetic::stored(format), Arithmetic::of(format));
        let one = Rounded::exact(Interval::from(1.0));
        let n = Interval::from(cell.n.hi());
        let times_n = |error: f64| (n * Interval::from(error)).hi();
        if handed == Handed::Cosine {
            let cosine = Rounded::exact(cell.cosine).stored(stored);
            let mut versine = one.minus(cosine, cell.versine, by);
            // 1 - ĉ is exact for ĉ ≥ ½ (Sterbenz).
            if (Interval::from(cell.cosine.lo()) - Interval::from(cosine.error)).lo() >= 0.5 {
                versine.error = cosine.error;
            }
            let scaled = Rounded { value: cell.t, error: times_n(versine.error) };
            return Argument { handed, cosine, versine, scaled };
        }
        let error = if handed == Handed::Versine {
            let u = Interval::from(stored.unit);
            // Relative to t: w itself may be known less well over a box.
            let relative = u * Interval::from(cell.t.hi()) + n * Interval::from(stored.tiny);
            let plain = u * Interval::from(cell.versine.hi()) + Interval::from(stored.tiny);
            [plain.hi(), relative.hi().min(times_n(plain.hi()))]
        } else {
            let plain = gap_error(cell.versine, Interval::from(1.0), stored, by);
            [plain, gap_error(cell.t, n, stored, by).min(times_n(plain))]
        };
        let versine = Rounded { value: cell.versine, error: error[0] };
        let scaled = Rounded { value: cell.t, error: error[1] };
        Argument { handed, cosine: one.minus(versine, cell.cosine, by), versine, scaled }
    }
}

/// A bound of the error of n |a - b|²/2, t = n w.
///
/// A component below 1 in size is rounded by at most u/2, so that each vector moves by at most √3 u/2 and the gap
/// δ between their ends by √3 u: |δ̂|²/2 is off by at most |δ| √3 u + 3 u²/2, |δ| = √(2w). The three
/// differences, squares and two sums round relatively, by (1 + u)⁵ at most; the half is exact but for
/// underflow, as which three squares and the half count.
fn gap_error(t: Interval, n: Interval, stored: Arithmetic, by: Arithmetic) -> f64 {
    let u = Interval::from(stored.unit);
    let (two, three) = (Interval::from(2.0), Interval::from(3.0));
    let top = Interval::from(t.hi());
    let moved = u * (two * three * top * n).square_root() + n * three * u * u / two;
    let arithmetic = (Interval::from(1.0) + Interval::from(by.unit)).power(5) - Interval::from(1.0);
    (moved + arithmetic * (top + moved) + Interval::from(4.0) * n * Interval::from(by.tiny)).hi()
}

#[cfg(test)]
mod tests;
