//! Rounding errors of the bells p^K: [`LinearLobe`](crate::kernel::linear::LinearLobe) and
//! [`CubicLobe`](crate::kernel::cubic::CubicLobe), step by step as their code goes.
//!
//! Constants that grow with n stand here divided by their power of n, and w multiplied by n: what is so scaled
//! does not depend on the size of n, and relative errors do not either.

use super::super::rounded::{Arithmetic, Rounded};
use super::super::{Format, Handed, Interval};
use super::cell::{Argument, Cell};
use crate::integral::Field;
use crate::kernel::cubic::BellFormula;

/// The lobe with its error, or no bound, where the constants leave the format's range.
pub(super) fn bell(formula: &BellFormula, cell: &Cell, given: &Argument, format: Format) -> Rounded {
    let by = Arithmetic::of(format);
    let constants = Constants::new(formula, cell);
    let whole = Interval::WHOLE;
    let y = cell.t / constants.reach.value;
    let one = Interval::from(1.0);
    let [alpha, beta] = [constants.linear.value, constants.square.value];
    let p = (one - y) * (one + y * (alpha + y * beta));
    let from_cosine = given.handed == Handed::Cosine;
    let straight = is_straight(formula);
    // The largest number that the code may compute for p: 1, where 1 - x has an x ≥ 0.
    let mut most = f64::INFINITY;
    let base = if straight && from_cosine {
        let slope = constants.slope(cell);
        let offset = Rounded::exact(one).minus(slope, whole, Arithmetic::constants());
        if format_lacks(&[slope, offset], by) {
            return unbounded(p);
        }
        let (slope, offset) = (convert(slope, format), convert(offset, format));
        offset.plus(slope.times(given.cosine, slope.value - y, by), p, by)
    } else if straight {
        if format_lacks(&[constants.slope(cell)], by) {
            return unbounded(p);
        }
        let slope = convert_scaled(constants.over_n, format);
        most = 1.0;
        slope.times(given.scaled, y, by).complement(p, by)
    } else if from_cosine && formula.power <= 4 {
        match depressed(&constants, cell, given, p, format) {
            Some(base) => base,
            None => return unbounded(p),
        }
    } else {
        let Some(subtracted) = horner(&constants, cell, given, one - p, format) else {
            return unbounded(p);
        };
        if subtracted.1 {
            most = 1.0;
            subtracted.0.complement(p, by)
        } else {
            Rounded::exact(one).minus(subtracted.0, p, by)
        }
    };
    let mut power = base.positive_part();
    for _ in 0..formula.power.trailing_zeros() {
        power = power.squared(by, most);
    }
    power
}

fn unbounded(p: Interval) -> Rounded {
    Rounded { value: p, error: f64::INFINITY }
}

fn is_straight(formula: &BellFormula) -> bool {
    formula.linear == [0.0; 3] && formula.square == [0.0; 3]
}

/// Whether the cubic loses its degree, and the form from cos θ with it, for some n of the range.
pub(super) fn degree_may_vanish(formula: &BellFormula, m: Interval) -> bool {
    // β over slices of the range of m: coarse ones would see zeros that are not there.
    let [a, b, c] = formula.square.map(Interval::from);
    let step = m.width() / 64.0;
    let slice = |k: i32| {
        let lo = m.lo() + f64::from(k) * step;
        Interval::new(lo.min(m.hi()), (lo + 1.01 * step).clamp(lo.min(m.hi()), m.hi()))
    };
    (0..64).map(slice).any(|m| (a + m * (b + m * c)).contains(0.0))
}

fn convert(x: Rounded, format: Format) -> Rounded {
    if format == Format::Double { x } else { x.stored(Arithmetic::of(format)) }
}

fn convert_scaled(x: Rounded, format: Format) -> Rounded {
    if format == Format::Double { x } else { x.stored(Arithmetic::of(format).scaled()) }
}

/// Whether the sizes of constants, together, leave the format's range: what is computed from them with factors
/// up to 1 stays inside otherwise.
fn format_lacks(constants: &[Rounded], by: Arithmetic) -> bool {
    let sum = constants.iter().fold(Interval::ZERO, |sum, x| sum + Interval::from(x.size()));
    sum.hi().is_nan() || sum.hi() > by.largest
}

/// T, α, β and 1/T as `f64` computes them.
struct Constants {
    reach: Rounded,
    linear: Rounded,
    square: Rounded,
    /// 1/T: n/T over n.
    over_n: Rounded,
}

impl Constants {
    fn new(formula: &BellFormula, cell: &Cell) -> Self {
        let by = Arithmetic::constants().scaled();
        let number = |x: f64| Rounded::exact(Interval::from(x));
        let m = Rounded::exact(cell.m).stored(by);
        let whole = Interval::WHOLE;
        let row = |[a, b, c]: [f64; 3]| {
            if b == 0.0 && c == 0.0 {
                return number(a); // a + m 0 is exact
            }
            let inner = number(b).plus(m.times(number(c), whole, by), whole, by);
            number(a).plus(m.times(inner, whole, by), whole, by)
        };
        let [reach, linear, square] = [formula.reach, formula.linear, formula.square].map(row);
        let over_n = number(1.0).over(reach, whole, by, f64::INFINITY);
        Constants { reach, linear, square, over_n }
    }

    /// s = n/T itself.
    fn slope(&self, cell: &Cell) -> Rounded {
        let n = cell.n;
        let error = (Interval::from(n.hi()) * Interval::from(self.over_n.error)).hi();
        Rounded { value: n * self.over_n.value, error }
    }

    /// k₁, k₂, k₃ over n, n², n³.
    fn horner(&self) -> [Rounded; 3] {
        let by = Arithmetic::constants().scaled();
        let whole = Interval::WHOLE;
        let (r, one) = (self.over_n, Rounded::exact(Interval::from(1.0)));
        let k1 = one.minus(self.linear, whole, by).times(r, whole, by);
        let k2 = self.square.minus(self.linear, whole, by).times(r, whole, by).times(r, whole, by);
        let k3 = self.square.times(r, whole, by).times(r, whole, by).times(r, whole, by);
        [k1, k2, k3]
    }
}

/// w (k₁ - w (k₂ - w k₃)) = 1 - p, and whether it is computed not negative; `None` where the constants leave the range.
fn horner(
    constants: &Constants,
    cell: &Cell,
    given: &Argument,
    value: Interval,
    format: Format,
) -> Option<(Rounded, bool)> {
    let (by, whole) = (Arithmetic::of(format), Interval::WHOLE);
    let scaled = by.scaled();
    let k = constants.horner();
    let n = Rounded::exact(Interval::from(cell.n.hi()));
    let grown: [Rounded; 3] = core::array::from_fn(|i| {
        let power = n.value.power(i as u32 + 1);
        Rounded { value: k[i].value * power, error: (Interval::from(k[i].error) * power).hi() }
    });
    if format_lacks(&grown, by) {
        return None;
    }
    let [k1, k2, k3] = k.map(|k| convert_scaled(k, format));
    let w = given.scaled;
    let inner = k2.minus(w.times(k3, whole, scaled), whole, scaled);
    let outer = k1.minus(w.times(inner, whole, scaled), whole, scaled);
    let positive = (Interval::from(outer.value.lo()) - Interval::from(outer.error)).lo() >= 0.0;
    Some((w.times(outer, value, by), positive))
}

/// (u² + c) u + d, u = a + b cos θ; `None` where there is no such form or its constants leave the range.
///
/// The cube root in its constants is `libm`'s, a port of CORE-MATH's correctly rounded one; one unit in the last
/// place is allowed for it.
fn depressed(
    constants: &Constants,
    cell: &Cell,
    given: &Argument,
    p: Interval,
    format: Format,
) -> Option<Rounded> {
    let (by, whole) = (Arithmetic::of(format), Interval::WHOLE);
    let doubles = Arithmetic::constants();
    let [k1, k2, k3] = constants.horner();
    let s = cube_root(k3)?;
    // In scaled numbers a constant of degree 0 in n is what it is.
    let (three, one) = (Rounded::exact(Interval::from(3.0)), Rounded::exact(Interval::from(1.0)));
    let by_n = doubles.scaled();
    let any = f64::INFINITY;
    let u0 = k2.over(three.times(s, whole, by_n).times(s, whole, by_n), whole, doubles, any);
    let square = three.times(u0, whole, doubles).times(u0, whole, doubles);
    let c = k1.over(s, whole, doubles, any).minus(square, whole, doubles);
    let inner = u0.squared(doubles, any).plus(c, whole, doubles);
    let d = one.minus(u0.times(inner, whole, doubles), whole, doubles);
    let grown_error = (Interval::from(cell.n.hi()) * Interval::from(s.error)).hi();
    let b = Rounded { value: cell.n * s.value, error: grown_error };
    let a = u0.minus(b, whole, doubles);
    if format_lacks(&[a, b, c, d], by) {
        return None;
    }
    let [a, b, c, d] = [a, b, c, d].map(|x| convert(x, format));
    let shift = s.value * cell.t;
    let u = a.plus(b.times(given.cosine, b.value - shift, by), u0.value - shift, by);
    let cubic = u.squared(by, any).plus(c, whole, by).times(u, p - d.value, by);
    Some(cubic.plus(d, p, by))
}

/// ∛x in doubles, within one unit in the last place; `None` where x may be 0.
fn cube_root(x: Rounded) -> Option<Rounded> {
    let least = Interval::from(x.value.abs().lo()) - Interval::from(x.error);
    if x.value.contains(0.0) || least.lo() <= 0.0 {
        return None;
    }
    let size = x.value.abs();
    let root = (size.ln() / Interval::from(3.0)).exp();
    // |∛x̂ - ∛x| ≤ |x̂ - x|/(3 ξ^(2/3)) ≤ ∛x |x̂ - x|/(3 ξ), ξ the smaller of the two
    let handed_on = Interval::from(x.error) / (Interval::from(3.0) * least);
    let unit = Interval::from(2.0 * Arithmetic::constants().unit);
    let error = Interval::from(root.hi()) * (handed_on + unit * (Interval::from(1.0) + handed_on));
    let value = if x.value.hi() < 0.0 { -root } else { root };
    Some(Rounded { value, error: error.hi() })
}

#[cfg(test)]
mod tests;
