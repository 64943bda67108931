//! Rounding errors of the lobes that are no bells: Schlick's, the spherical Gaussian, and the ways to cosⁿ.

use super::super::rounded::{Arithmetic, Rounded};
use super::super::{Format, Handed, Interval};
use super::cell::{Argument, Cell};

/// n rounded to the format, over n.
fn exponent(format: Format) -> Rounded {
    Rounded::exact(Interval::from(1.0)).stored(Arithmetic::of(format).scaled())
}

/// Whether the format has no number for n.
fn lacks(cell: &Cell, format: Format) -> bool {
    cell.n.hi() > Arithmetic::of(format).largest
}

/// The error may be capped where both the lobe and what is computed lie in [0, `most`].
fn capped(x: Rounded, most: f64) -> Rounded {
    let cap = x.value.hi().max((Interval::from(most) - Interval::from(x.value.lo())).hi());
    Rounded { error: x.error.min(cap), ..x }
}

/// c/(c + n (1 - c)).
pub(super) fn schlick(cell: &Cell, given: &Argument, format: Format) -> Rounded {
    let by = Arithmetic::of(format);
    let value = cell.cosine / (cell.cosine + cell.t);
    if lacks(cell, format) {
        return Rounded { value, error: f64::INFINITY };
    }
    let product = exponent(format).times(given.scaled, cell.t, by);
    let below = given.cosine.plus(product, Interval::WHOLE, by);
    // Sums keep the order when rounded: the divisor is not below ĉ > 0.
    let quotient = given.cosine.over(below, Interval::new(0.0, 1.0), by, 1.0);
    capped(quotient, 1.0)
}

/// c/(n - n c + c).
pub(super) fn schlick_printed(cell: &Cell, given: &Argument, format: Format) -> Rounded {
    let (by, whole) = (Arithmetic::of(format), Interval::WHOLE);
    let value = cell.cosine / (cell.cosine + cell.t);
    // n c + n is the largest number on the way.
    if 2.0 * cell.n.hi() > by.largest {
        return Rounded { value, error: f64::INFINITY };
    }
    let n = Rounded::exact(cell.n).stored(by);
    let product = n.times(given.cosine, cell.n - cell.t, by);
    let below = n.minus(product, cell.t, by).plus(given.cosine, whole, by);
    given.cosine.over(below, Interval::new(0.0, 1.0), by, f64::INFINITY)
}

/// e^(-n w).
pub(super) fn spherical_gaussian(cell: &Cell, given: &Argument, format: Format, ulps: f64) -> Rounded {
    let by = Arithmetic::of(format);
    let value = (-cell.t).exp();
    if lacks(cell, format) {
        return Rounded { value, error: f64::INFINITY };
    }
    let exponent = exponent(format).times(given.scaled, cell.t, by);
    exponential(value, exponent.error, by, ulps)
}

/// e⁻ˣ, in `value`, where x is computed with an error and e⁻ˣ within some units in the last place.
fn exponential(value: Interval, error: f64, by: Arithmetic, ulps: f64) -> Rounded {
    let own = Interval::from(2.0 * by.unit) * Interval::from(ulps);
    let factor = growth(error) * (Interval::from(1.0) + own) + own;
    let absolute = Interval::from(value.hi()) * factor
        + Interval::from(by.tiny) * (Interval::from(2.0 * ulps) + Interval::from(1.0));
    let error = if absolute.hi().is_nan() { f64::INFINITY } else { absolute.hi() };
    capped(Rounded { value, error }, (Interval::from(1.0) + own).hi())
}

/// An upper bound of eˣ - 1 for x ≥ 0.
fn growth(x: f64) -> Interval {
    let x = Interval::from(x);
    // eˣ - 1 ≤ x + x² up to x = 1
    if x.hi() <= 1.0 { x + x * x } else { x.exp() }
}

/// Bounds |ln ĉ - ln c|; ∞ where ĉ may be 0.
fn logarithm_error(cosine: Rounded) -> Interval {
    let least = Interval::from(cosine.value.lo()) - Interval::from(cosine.error);
    if least.lo() > 0.0 { Interval::from(cosine.error) / least } else { Interval::from(f64::INFINITY) }
}

/// cosⁿ with a relative error e^`error`, all of it, or else, where ĉ may be 0, by the hull of both. What goes before
/// the last operation is at most ĉ to the `exponent` times e^`above`.
fn power(
    cell: &Cell,
    cosine: Rounded,
    exponent: Interval,
    [error, above]: [Interval; 2],
    by: Arithmetic,
    ulps: f64,
) -> Rounded {
    let value = cell.target();
    let total = Interval::from(cell.n.hi()) * logarithm_error(cosine) + error;
    let by_logarithm =
        exponential(value, if total.hi().is_nan() { f64::INFINITY } else { total.hi() }, by, ulps);
    let (one, ulps) = (Interval::from(1.0), Interval::from(2.0) * Interval::from(ulps));
    let own = one + ulps * Interval::from(by.unit);
    // ĉ ≤ c + δ, and neither what is computed nor cosⁿ is negative.
    let top = Interval::from(cosine.size().min(1.0)).pow(exponent) * above.exp();
    let most = (top * own + Interval::from(by.tiny) * (ulps + one)).hi();
    let most = if most.is_nan() { f64::INFINITY } else { most.max(value.hi()) };
    Rounded { error: by_logarithm.error.min(most), ..by_logarithm }
}

/// n̂ where it is least.
fn least_exponent(cell: &Cell, format: Format) -> Interval {
    Interval::from(cell.n.lo()) * (Interval::from(1.0) - Interval::from(Arithmetic::of(format).unit))
}

/// `pow(c, n)`, from the versine e^(n ln(1 - w)).
pub(super) fn pow(cell: &Cell, given: &Argument, format: Format, ulps: f64) -> Rounded {
    let by = Arithmetic::of(format);
    if lacks(cell, format) {
        return Rounded { value: cell.target(), error: f64::INFINITY };
    }
    let (u, v, one) = (Interval::from(by.unit), Interval::from(cell.v.hi()), Interval::from(1.0));
    if given.handed == Handed::Cosine {
        return power(
            cell,
            given.cosine,
            least_exponent(cell, format),
            [v * u * slack(cell, given.cosine), Interval::ZERO],
            by,
            ulps,
        );
    }
    // ln(1 - ŵ) itself is not handed 1 - ŵ rounded.
    let cosine = Rounded { value: cell.cosine, error: given.versine.error };
    let own = u * Interval::from(2.0 * ulps);
    let product = (one + u) * (one + own) * (one + u) - one;
    let lost = underflow(cell, given.versine, by, ulps);
    let error = v * product * slack(cell, cosine) + lost;
    power(cell, cosine, shrunk(cell, format, ulps), [error, lost], by, ulps)
}

/// 2^(n log₂ c).
pub(super) fn exp2_log2(cell: &Cell, given: &Argument, format: Format, ulps: f64) -> Rounded {
    let by = Arithmetic::of(format);
    if lacks(cell, format) {
        return Rounded { value: cell.target(), error: f64::INFINITY };
    }
    let (u, v, one) = (Interval::from(by.unit), Interval::from(cell.v.hi()), Interval::from(1.0));
    let own = u * Interval::from(2.0 * ulps);
    let product = (one + u) * (one + own) * (one + u) - one;
    let error = v * product * slack(cell, given.cosine);
    // ĉ is 1 or at least u from it: neither log₂ ĉ nor n times it is subnormal.
    power(cell, given.cosine, shrunk(cell, format, ulps), [error, Interval::ZERO], by, ulps)
}

/// The least factor of n on the way through a logarithm: n, the logarithm and their product each rounded.
fn shrunk(cell: &Cell, format: Format, ulps: f64) -> Interval {
    let (u, one) = (Interval::from(Arithmetic::of(format).unit), Interval::from(1.0));
    let own = u * Interval::from(2.0 * ulps);
    Interval::from(cell.n.lo()) * (one - u) * (one - own) * (one - u)
}

/// What n ln(1 - ŵ) is off by beside its relative errors: where ŵ may be subnormal, units of the logarithm are
/// those of subnormal numbers, and the product rounds to them.
fn underflow(cell: &Cell, versine: Rounded, by: Arithmetic, ulps: f64) -> Interval {
    let [u, tiny, one] = [by.unit, by.tiny, 1.0].map(Interval::from);
    let least = Interval::from(versine.value.lo()) - Interval::from(versine.error);
    if (least * u - tiny).lo() >= 0.0 {
        return Interval::ZERO;
    }
    let logarithm = Interval::from(2.0) * Interval::from(ulps) * tiny;
    Interval::from(cell.n.hi()) * (one + u) * (one + u) * logarithm + tiny
}

/// n |ln ĉ| over v: what errors relative to n ln ĉ are multiplied with.
fn slack(cell: &Cell, cosine: Rounded) -> Interval {
    let moved = Interval::from(cell.n.hi()) * logarithm_error(cosine);
    if cell.v.hi() > 0.0 {
        Interval::from(1.0) + moved / Interval::from(cell.v.hi())
    } else {
        Interval::from(f64::INFINITY)
    }
}

/// cosⁿ by squarings, for the whole n of the box.
///
/// Of the tree of its products the node that makes cosʲ counts n/j times: n - 1 roundings together. Each is at
/// most u relative to its result, and u/2 absolute below 1.
pub(super) fn squarings(cell: &Cell, given: &Argument, format: Format) -> Rounded {
    let by = Arithmetic::of(format);
    let (u, one) = (Interval::from(by.unit), Interval::from(1.0));
    let n = Interval::from(cell.n.hi());
    // The least result on the way is not below the last one, whose error at the worst is this.
    let worst = n * (logarithm_error(given.cosine) + u * (one + u));
    let lift = (Interval::from(cell.v.hi()) + worst).exp() / Interval::from(2.0);
    let each = if lift.hi() < 1.0 { u * lift } else { u };
    // -ln(1 - x) ≤ x/(1 - x)
    let error = (n - one).max(Interval::ZERO) * each / (one - each);
    let exponent = Interval::from(cell.n.lo());
    // All of its roundings may go up.
    let lobe = power(cell, given.cosine, exponent, [error, error], by, 0.0);
    // Underflow on the way: once tiny, squares shrink; at most two products a bit of n.
    let lost = Interval::from(64.0) * Interval::from(by.tiny);
    let error = (Interval::from(lobe.error) + lost).hi();
    Rounded { error, ..lobe }
}

#[cfg(test)]
mod tests;
