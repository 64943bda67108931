//! How far a kernel's floating-point result lies from the same kernel in exact arithmetic.
//!
//! A running error analysis of the kernel's code over boxes of n and θ, halved where the bound is largest until it
//! is known to a few parts in a hundred.

mod bell;
mod cell;
mod smooth;

use super::difference::reciprocal;
use super::rounded::{Arithmetic, Rounded};
use super::search::{supremum_split, widest};
use super::{Format, Handed, Interval, Measure, Supremum};
use crate::kernel::stand_in::StandIn;
use cell::{Argument, Cell, FURTHEST};

/// Units in the last place within which [`rounding`] takes exp, exp2, log2, log1p and pow to be, as `libm`
/// aims at: an assumption, not a proof.
pub const ELEMENTARY_ULPS: f64 = 1.0;

/// The largest exponent that is asked for.
const MOST_N: f64 = 1e12;
/// How much above its largest value at a point the bound may stay.
const SHARE: f64 = 0.03;
/// Widths of ln n and ln(1 + v) over which the bound changes alike.
const SCALE: [f64; 2] = [4.0, 1.0];
/// Boxes after which a search settles for the bound it has.
const MOST_BOXES: usize = 4000;

/// Whether [`rounding`] of this stand-in rests on [`ELEMENTARY_ULPS`]. All others are certified, the cubic bells
/// from cos θ given that the cube root among their constants, computed by `libm`, is within one unit in the last place
/// (its source, CORE-MATH, proves it correctly rounded).
///
/// ```
/// use bellfit::{bound::assumes_elementary, kernel::stand_in::StandIn};
/// assert!(assumes_elementary(StandIn::Power) && !assumes_elementary(StandIn::Cubic4));
/// ```
pub const fn assumes_elementary(stand_in: StandIn) -> bool {
    matches!(stand_in, StandIn::SphericalGaussian | StandIn::Exp2Log2 | StandIn::Power)
}

/// Bound of |floating-point result - the same stand-in exactly|, over every n in `n.0..=n.1` and every θ in
/// [0, π/2]; relative: over cosⁿ, where that is at least the floor. Certified, but see [`assumes_elementary`].
///
/// `value.hi()` is the bound, `value.lo()` is 0: that the bound is attained is not said. `at` is the (n, t),
/// t = n (1 - cos θ), where it is largest.
///
/// - The kernel is the code of [`kernel`](crate::kernel) that [`StandIn::at`] and
///   [`StandIn::at_versine`] name, every operation rounded to nearest in the format. Code that fuses
///   multiplications with additions rounds less often and is covered.
/// - What depends on n alone is computed in `f64` and rounded once to the format (n itself, where that is the
///   constant; in binary32 for [`Format::HalfStored`]: a material's constants are uniforms, what is stored
///   is arguments and results). The n of squarings is a whole number and exact.
/// - [`Handed::Difference`]: two unit vectors, each component rounded once, their difference squared by
///   [`versine_between`](crate::kernel::vector::versine_between). Rounded lengths may put w above 1 at
///   θ = π/2, where the lobes end: a bell that is not 0 there (n < T) loses all of it.
///
/// `None` where there is no finite bound: a range outside [1, 1e12], reversed or NaN; a floor outside (0, 1);
/// constants beyond the format's range (binary16 ends at 65504); a denominator that may vanish
/// ([`StandIn::SchlickPrinted`] at large n); [`StandIn::Cubic2`] and [`StandIn::Cubic4`] from cos θ over a range
/// with the n at which their cubic loses its degree (2.1 and 6.9); squarings without a whole n in the range or
/// beyond `u32`.
///
/// ```
/// use bellfit::{bound::{Format, Handed, Measure, rounding}, kernel::stand_in::StandIn};
/// let bound = |handed| {
///     let n = (16.0, 1024.0);
///     rounding(StandIn::Cubic4, Format::Single, handed, n, Measure::Absolute).expect("a range").value.hi()
/// };
/// // cos θ in f32 costs a hundred times the digits that the versine does at n = 1024.
/// assert!(bound(Handed::Cosine) < 3e-4 && bound(Handed::Versine) < 2e-6);
/// ```
pub fn rounding(
    stand_in: StandIn,
    format: Format,
    handed: Handed,
    n: (f64, f64),
    measure: Measure,
) -> Option<Supremum<2>> {
    rounding_with(stand_in, format, handed, n, measure, ELEMENTARY_ULPS)
}

/// [`rounding`] with another accuracy of exp, exp2, log2, log1p and pow, in units in the last place of the
/// format: for a platform that promises less than `libm`. `None` for one below 0 or NaN, too.
///
/// ```
/// use bellfit::{bound::{Format, Handed, Measure, rounding_with}, kernel::stand_in::StandIn};
/// let bound = |ulps| {
///     let (n, format) = ((64.0, 64.0), Format::Single);
///     rounding_with(StandIn::Power, format, Handed::Versine, n, Measure::Absolute, ulps)
/// };
/// assert!(bound(16.0).expect("a range").value.hi() > 4.0 * bound(0.5).expect("a range").value.hi());
/// assert_eq!(bound(-1.0), None);
/// ```
pub fn rounding_with(
    stand_in: StandIn,
    format: Format,
    handed: Handed,
    n: (f64, f64),
    measure: Measure,
    ulps: f64,
) -> Option<Supremum<2>> {
    let in_range = n.0 >= 1.0 && n.0 <= n.1 && n.1 <= MOST_N;
    if !(in_range && measure.is_valid() && ulps >= 0.0 && ulps.is_finite()) {
        return None;
    }
    let (from, to) = if stand_in == StandIn::Squarings { (libm::ceil(n.0), libm::floor(n.1)) } else { n };
    if from > to || (stand_in == StandIn::Squarings && to > f64::from(u32::MAX)) {
        return None;
    }
    let range = Interval::new(from, to);
    let kernel = Kernel { stand_in, format, handed, measure, ulps };
    if kernel.loses_its_form(reciprocal(range)) {
        return None;
    }
    let end = match measure {
        Measure::Absolute => FURTHEST,
        Measure::Relative { floor } => (Interval::from(1.0) - Interval::from(floor).ln()).ln().hi(),
    };
    let log_n = range_logarithm(range);
    let bound = |cell: &[Interval; 2]| Interval::from(kernel.bound(&Cell::new(*cell, range)));
    // Constants are largest at the largest n: where these have no bound, there is none.
    if !bound(&[Interval::from(log_n.hi()), Interval::ZERO]).hi().is_finite() {
        return None;
    }
    let enough = |best: f64, upper: f64| upper <= best * (1.0 + SHARE);
    // Along the side whose width costs most: without it the bound is lower than without the other.
    let side = |cell: &[Interval; 2]| {
        let [n, v] = cell.map(|side| Interval::from(side.mid()));
        let [without_n, without_v] = [[n, cell[1]], [cell[0], v]].map(|part| bound(&part).hi());
        let splits = |side: Interval| side.lo() < side.mid() && side.mid() < side.hi();
        if without_n == without_v || !cell.iter().all(|side| splits(*side)) {
            return widest(cell, &SCALE);
        }
        usize::from(without_v < without_n)
    };
    let points = |cell: &[Interval; 2]| {
        let [n, v] = cell.map(Interval::mid);
        vec![[n, v], [cell[0].hi(), v]]
    };
    let domain = [log_n, Interval::new(0.0, end)];
    let found = supremum_split(bound, domain, points, side, enough, MOST_BOXES);
    if !found.value.hi().is_finite() {
        return None;
    }
    let at = Cell::new(found.at.map(Interval::from), range);
    let value = Interval::new(0.0, found.value.hi());
    Some(Supremum { value, at: [at.n.mid(), at.t.mid()], boxes: found.boxes })
}

/// ln n over the range.
fn range_logarithm(range: Interval) -> Interval {
    let logarithm = range.ln();
    Interval::new(logarithm.lo().max(0.0), logarithm.hi().max(0.0))
}

struct Kernel {
    stand_in: StandIn,
    format: Format,
    handed: Handed,
    measure: Measure,
    ulps: f64,
}

impl Kernel {
    /// Whether the form that takes cos θ does not exist for an n of the range.
    fn loses_its_form(&self, m: Interval) -> bool {
        let by_cosine = matches!(self.stand_in, StandIn::Cubic2 | StandIn::Cubic4);
        let formula = self.stand_in.formula().filter(|_| by_cosine && self.handed == Handed::Cosine);
        formula.is_some_and(|formula| bell::degree_may_vanish(&formula, m))
    }

    /// Whether near θ = π/2 rounding alone may put w where the code ends the lobe: a bell beyond w = 1, Schlick's at
    /// w = 1. Of cosⁿ the bound holds at 0 anyway, and the Gaussian goes on.
    fn may_end_early(&self) -> bool {
        match self.stand_in {
            StandIn::Schlick | StandIn::SchlickPrinted => self.handed != Handed::Cosine,
            _ => self.stand_in.formula().is_some() && self.handed == Handed::Difference,
        }
    }

    /// Bounds the error over a box; ∞ where nothing is known.
    fn bound(&self, cell: &Cell) -> f64 {
        let given = Argument::new(cell, self.format, self.handed);
        let mut result = self.result(cell, &given);
        let edge = if self.may_end_early() { cell.edge(given.cosine.error) } else { None };
        if let Some(edge) = edge {
            result.error = result.error.max(self.result(&edge, &given).value.hi());
        }
        if self.format == Format::HalfStored {
            result = result.stored(Arithmetic::stored(self.format));
        }
        let error = match self.measure {
            Measure::Absolute => result.error,
            Measure::Relative { .. } => (Interval::from(result.error) * cell.v.exp()).hi(),
        };
        if error.is_nan() { f64::INFINITY } else { error }
    }

    fn result(&self, cell: &Cell, given: &Argument) -> Rounded {
        let (format, ulps) = (self.format, self.ulps);
        if let Some(formula) = self.stand_in.formula() {
            return bell::bell(&formula, cell, given, format);
        }
        match self.stand_in {
            StandIn::Schlick => smooth::schlick(cell, given, format),
            StandIn::SchlickPrinted => smooth::schlick_printed(cell, given, format),
            StandIn::SphericalGaussian => smooth::spherical_gaussian(cell, given, format, ulps),
            StandIn::Squarings => smooth::squarings(cell, given, format),
            StandIn::Exp2Log2 => smooth::exp2_log2(cell, given, format, ulps),
            _ => smooth::pow(cell, given, format, ulps),
        }
    }
}

#[cfg(test)]
mod count;
#[cfg(test)]
mod tests;
