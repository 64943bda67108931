//! How far a stand-in lies from cosⁿ in exact arithmetic, over any range of real n.
//!
//! By branch and bound over m = 1/n and v = -ln cosⁿ, in which cosⁿ is e⁻ᵛ and every stand-in is smooth, n = ∞
//! included; each box by Taylor's theorem to the fifth degree, so that boxes may be large although
//! the two lobes nearly agree.

use super::difference::reciprocal;
use super::scaled_versine::{scaled_versine, scaled_versine_taylor};
use super::search::{supremum_split, widest};
use super::taylor::Taylor;
use super::{Interval, Measure, Supremum, supremum_until};
use crate::integral::Field;
use crate::kernel::cubic::BellFormula;
use crate::kernel::stand_in::StandIn;

/// v from which cosⁿ is below 1e-16 and counts as the tail.
const TAIL: f64 = 37.0;
/// How near the two ends of an enclosure shall be, relative to the lower one, and at all.
const TOLERANCE: [f64; 2] = [1e-3, 1e-12];
/// Boxes after which a search settles for the enclosure it has.
const MOST_BOXES: usize = 20_000;
/// Widths of m and v over which a lobe changes alike.
const SCALE: [f64; 2] = [0.1, 1.0];

/// sup over every real n in `n.0..=n.1` and every θ in [0, π/2] of the distance of a stand-in from
/// cosⁿ, both in exact arithmetic: |stand-in - cosⁿ|, or |stand-in/cosⁿ - 1| where cosⁿ ≥ floor.
///
/// `at` is (n, t), t = n (1 - cos θ); n may be ∞ there. Certified: `value.hi()` is never exceeded, `value.lo()`
/// is reached at `at` up to the rounding of its two numbers. The two are within 1e-3 of each other
/// (or 1e-12, where that is more).
///
/// - Domain: 1 ≤ `n.0` ≤ `n.1` ≤ ∞, `n.0` finite; below n = 16 the formulas of the bells were not fitted, but
///   the bound holds. `None` for any other range, NaN included, and for a floor outside (0, 1).
/// - Exactly 0 for those that are cosⁿ but for rounding ([`StandIn::is_exact`]; for squarings that speaks of
///   the whole n of the range), for cs-16 at n = 16 and Schlick's lobe at n = 1.
///
/// ```
/// use bellfit::{bound::{Measure, approximation}, kernel::stand_in::StandIn};
/// // The lobe paper's cs_16 against cosⁿ: largest as n → ∞, where it is Lyon's bell against e⁻ᵗ.
/// let error = approximation(StandIn::Cs16, (16.0, f64::INFINITY), Measure::Absolute).expect("a range");
/// assert!(error.value.lo() > 1.72e-2 && error.value.hi() < 1.74e-2 && error.at[0] > 1e4);
/// let exact = approximation(StandIn::Power, (16.0, 64.0), Measure::Absolute).expect("a range");
/// assert_eq!(exact.value.hi(), 0.0);
/// assert_eq!(approximation(StandIn::Cs16, (64.0, 16.0), Measure::Absolute), None);
/// ```
pub fn approximation(stand_in: StandIn, n: (f64, f64), measure: Measure) -> Option<Supremum<2>> {
    let (from, to) = n;
    if !(from >= 1.0 && from.is_finite() && from <= to && measure.is_valid()) {
        return None;
    }
    if stand_in.is_exact() || coincides(stand_in, n) {
        return Some(Supremum { value: Interval::ZERO, at: [from, 0.0], boxes: 0 });
    }
    let end = match measure {
        Measure::Absolute => TAIL,
        Measure::Relative { floor } => (-Interval::from(floor).ln()).hi(),
    };
    let m = reciprocal(Interval::new(from, to));
    let distance = Distance { stand_in, formula: stand_in.formula(), relative: measure != Measure::Absolute };
    let [share, least] = TOLERANCE;
    // Suprema lie inside, at the least or the largest n, and at the floor.
    let points = |[m, v]: &[Interval; 2]| {
        let [first, middle, last] = [m.lo(), m.mid(), m.hi()];
        vec![[middle, v.mid()], [first, v.mid()], [last, v.mid()], [first, v.hi()], [last, v.hi()]]
    };
    let found = supremum_split(
        |cell| distance.over(*cell).abs(),
        [m, Interval::new(0.0, end)],
        points,
        |cell| widest(cell, &SCALE),
        |best, upper| upper <= best * (1.0 + share) + least,
        MOST_BOXES,
    );
    let [at_m, at_v] = found.at;
    let t = scaled_versine(Interval::from(at_m), Interval::from(at_v)).mid();
    let mut value = found.value;
    let mut boxes = found.boxes;
    if !distance.relative {
        let enough = |best: f64, upper: f64| upper <= value.hi().max(best * (1.0 + share) + least);
        let tail = supremum_until(|[m]| distance.beyond(*m), [m], enough, MOST_BOXES);
        boxes += tail.boxes;
        value = Interval::new(value.lo(), value.hi().max(tail.value.hi()));
    }
    Some(Supremum { value, at: [(1.0 / at_m).clamp(from, to), t], boxes })
}

/// Whether the stand-in is cosⁿ for the one n of the range: 1 - n w/16 is cos θ at n = 16, and
/// c/(c + n (1 - c)) at n = 1.
fn coincides(stand_in: StandIn, n: (f64, f64)) -> bool {
    match stand_in {
        StandIn::Cs16 => n == (16.0, 16.0),
        StandIn::Schlick | StandIn::SchlickPrinted => n == (1.0, 1.0),
        _ => false,
    }
}

/// p = (1 - y)(1 + α y + β y²), y = t/T, in any arithmetic.
fn base<T: Field>(formula: &BellFormula, number: impl Fn(f64) -> T, m: &T, t: &T) -> T {
    let row = |[a, b, c]: [f64; 3]| match (b, c) {
        (0.0, 0.0) => number(a),
        (_, 0.0) => number(a) + m.clone() * number(b),
        _ => number(a) + m.clone() * (number(b) + m.clone() * number(c)),
    };
    let y = t.clone() / row(formula.reach);
    let straight = T::int(1) - y.clone();
    if formula.linear == [0.0; 3] && formula.square == [0.0; 3] {
        return straight;
    }
    straight * (T::int(1) + y.clone() * (row(formula.linear) + y * row(formula.square)))
}

/// stand-in - cosⁿ, or stand-in/cosⁿ - 1, over boxes of m and v.
struct Distance {
    stand_in: StandIn,
    formula: Option<BellFormula>,
    relative: bool,
}

impl Distance {
    fn power(&self) -> u32 {
        self.formula.map_or(1, |formula| formula.power)
    }

    fn over(&self, cell: [Interval; 2]) -> Interval {
        let value = self.plain(cell);
        if cell.iter().all(|side| side.lo() == side.hi()) {
            return value;
        }
        let middle = cell.map(|side| Interval::from(side.mid()));
        let offsets = [cell[0] - middle[0], cell[1] - middle[1]];
        let over = self.base(Taylor::variables(cell));
        if over.value().hi() <= 0.0 {
            return value;
        }
        let v = |cell: [Interval; 2]| Taylor::variables(cell)[1];
        if over.value().lo() > 0.0 {
            let at = |base: Taylor, cell| {
                let power = base.power(self.power());
                if self.relative {
                    power * v(cell).exp() - Taylor::int(1)
                } else {
                    power - (Taylor::int(0) - v(cell)).exp()
                }
            };
            let (middle, over) = (at(self.base(Taylor::variables(middle)), middle), at(over, cell));
            return value.intersect(Taylor::range(&middle, &over, offsets));
        }
        // Across the zero of p: max(p, 0)^K has the continuous slope K max(p, 0)^(K-1) p', K ≥ 2.
        let k = self.power();
        let positive = over.value().max(Interval::ZERO);
        let slopes = over.slopes().map(|slope| Interval::int(i64::from(k)) * positive.power(k - 1) * slope);
        let mut mean = self.plain(middle);
        let [along, target] = if self.relative {
            let up = cell[1].exp();
            [[slopes[0] * up, slopes[1] * up], [Interval::ZERO, positive.power(k) * up]]
        } else {
            [slopes, [Interval::ZERO, (-cell[1]).exp()]]
        };
        for i in 0..2 {
            mean = mean + (along[i] + target[i]) * offsets[i];
        }
        value.intersect(mean)
    }

    /// By intervals alone.
    fn plain(&self, [m, v]: [Interval; 2]) -> Interval {
        let t = scaled_versine(m, v);
        let base = match (&self.formula, self.stand_in) {
            (Some(formula), _) => base(formula, Interval::from, &m, &t).max(Interval::ZERO),
            (None, StandIn::SphericalGaussian) => (-t).exp(),
            (None, _) => {
                let cosine = (-(v * m)).exp();
                cosine / (cosine + t)
            }
        };
        let power = base.power(self.power());
        if self.relative { power * v.exp() - Interval::from(1.0) } else { power - (-v).exp() }
    }

    /// The stand-in's root: p of a bell, else itself.
    fn base(&self, [m, v]: [Taylor; 2]) -> Taylor {
        let t = scaled_versine_taylor(m, v);
        match (&self.formula, self.stand_in) {
            (Some(formula), _) => base(formula, |x| Taylor::constant(Interval::from(x)), &m, &t),
            (None, StandIn::SphericalGaussian) => (Taylor::int(0) - t).exp(),
            (None, _) => {
                let cosine = (Taylor::int(0) - m * v).exp();
                cosine / (cosine + t)
            }
        }
    }

    /// A bound of |stand-in - cosⁿ| behind the tail's begin: both are at least 0 there.
    fn beyond(&self, m: Interval) -> Interval {
        let cosine = (-Interval::from(TAIL)).exp();
        // From there up to θ = π/2, t = n.
        let t = scaled_versine(m, Interval::new(TAIL, f64::INFINITY));
        let stand_in = match &self.formula {
            Some(formula) => self.bell_beyond(formula, m, t),
            None if self.stand_in == StandIn::SphericalGaussian => (-t).exp(),
            None => {
                let cosine = Interval::new(0.0, (-(Interval::from(TAIL) * m)).exp().hi());
                // c/(c + t) falls in t and rises with c.
                let most =
                    Interval::from(cosine.hi()) / (Interval::from(cosine.hi()) + Interval::from(t.lo()));
                Interval::new(0.0, most.hi())
            }
        };
        Interval::new(0.0, cosine.hi().max(stand_in.hi()))
    }

    fn bell_beyond(&self, formula: &BellFormula, m: Interval, t: Interval) -> Interval {
        let number = Interval::from;
        let row = |[a, b, c]: [f64; 3]| number(a) + m * (number(b) + m * number(c));
        let [reach, linear, square] = [formula.reach, formula.linear, formula.square].map(row);
        let straight = formula.linear == [0.0; 3] && formula.square == [0.0; 3];
        // Where q = 1 + α y + β y² has no zero, p is below 0 from y = 1 on.
        let no_zero = square.lo() > 0.0 && (linear.power(2) - number(4.0) * square).hi() < 0.0;
        let y = t / reach;
        if (straight || no_zero) && y.lo() >= 1.0 {
            return Interval::ZERO;
        }
        base(formula, Interval::from, &m, &t).max(Interval::ZERO).power(formula.power)
    }
}

#[cfg(test)]
mod tests;
