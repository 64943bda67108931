//! Certificates of bells p^K: their distance from e⁻ᵗ over all t ≥ 0 and from cosⁿ over every angle and
//! every real n from some n on, and that they fall to their cut without a jump.

use super::difference::{MOST_BOXES, cos_n_range};
use super::gradient::growth;
use super::{Gradient, Interval, Jet, Supremum, range, supremum, supremum_near};
use crate::integral::Field;
use crate::kernel::cubic::BellFormula;

/// What is proved of a bell's form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BellProof {
    /// Where it ends: encloses the first zero of p, or is the place where it is cut.
    pub cut: Interval,
    /// p falls strictly from 1 at 0 to the cut.
    pub decreasing: bool,
    /// p is 0 at the cut, so that the bell is continuous there; else it jumps by p(cut)^K.
    pub continuous: bool,
    /// Beyond the cut p stays at or below 0, so that max(p, 0) is the cut and needs no comparison.
    pub negative_beyond: bool,
}

/// Pieces after which a proof that is not done is given up.
const MOST_PIECES: u32 = 100_000;

/// 1 - c₁ z + c₂ z² - c₃ z³, z = t/K.
fn base<T: Field>(power: &T, [c1, c2, c3]: [T; 3], t: T) -> T {
    let z = t / power.clone();
    T::int(1) - z.clone() * (c1 - z.clone() * (c2 - z * c3))
}

/// sup over t ≥ 0 of |e⁻ᵗ - bell| with what is proved of the bell max(p, 0)^K, p = 1 - c₁ z + c₂ z² -
/// c₃ z³, z = t/K, cut at its first zero or, for one that jumps, at `jump`.
///
/// Up to the cut by branch and bound; beyond it the bell is 0 and e⁻ᵗ falls. `None` if p has no zero up to
/// t = 20 K, or `jump` is not a positive number.
///
/// ```
/// use bellfit::bound::exponential_bell;
/// // Lyon's (1 - t/16)^16
/// let (error, proof) = exponential_bell(16, [1.0, 0.0, 0.0], None, 1e-7).expect("a zero");
/// assert!(error.value.lo() > 1.7e-2 && error.value.hi() < 1.8e-2);
/// assert!(proof.cut.contains(16.0) && proof.decreasing && proof.continuous && proof.negative_beyond);
/// ```
pub fn exponential_bell(
    power: u32,
    c: [f64; 3],
    jump: Option<f64>,
    tolerance: f64,
) -> Option<(Supremum<1>, BellProof)> {
    let k = Jet::int(i64::from(power));
    let jets = c.map(|c| Jet::constant(Interval::from(c)));
    let p = |t: Jet| base(&k, jets, t);
    let cut = match jump {
        Some(jump) if jump > 0.0 && jump.is_finite() => Interval::from(jump),
        Some(_) => return None,
        None => first_zero(power, c)?,
    };
    let proof = BellProof {
        cut,
        decreasing: always([Interval::new(0.0, cut.hi()), Interval::from(0.0)], |[t, _]| {
            p(Jet::variable(t)).slope.hi() < 0.0
        }),
        // At a bracketed zero by the intermediate value theorem.
        continuous: jump.is_none(),
        negative_beyond: jump.is_none() && falls_beyond(power, c, cut.hi()),
    };
    let distance = |t: Jet| {
        let base = p(t);
        // Falling to 0 at the cut: what the enclosure has below 0 is beyond it.
        let value = base.value.max(Interval::from(0.0));
        let slope = if base.value.lo() < 0.0 { base.slope.hull(Interval::from(0.0)) } else { base.slope };
        (Jet::int(0) - t).exp() - Jet { value, slope }.power(power)
    };
    let domain = [Interval::new(0.0, cut.hi())];
    let found = supremum(|[t]| range(distance, *t).abs(), domain, tolerance, MOST_BOXES);
    let beyond = (-Interval::from(cut.lo())).exp();
    let value = found.value.max(beyond);
    let at = if beyond.lo() > found.value.lo() { [cut.lo()] } else { found.at };
    Some((Supremum { value, at, boxes: found.boxes }, proof))
}

/// Brackets the first zero of p by a scan and bisection, both signs certified. That no zero lies before it
/// is what [`BellProof::decreasing`] says.
fn first_zero(power: u32, c: [f64; 3]) -> Option<Interval> {
    let k = Interval::int(i64::from(power));
    let sign = |t: f64| base(&k, c.map(Interval::from), Interval::from(t));
    // Two zeros nearer than K/4096 may be stepped over; those of a near double one are 0.001 T apart.
    let step = f64::from(power) / 4096.0;
    let hit = (1..=81_920).find(|&i| sign(f64::from(i) * step).hi() < 0.0)?;
    // The step before may be too near the zero to tell; p(0) = 1 ends the way back.
    let before = (0..hit).rev().find(|&i| sign(f64::from(i) * step).lo() > 0.0)?;
    let (from, to) = (f64::from(before) * step, f64::from(hit) * step);
    // The last place certified above 0, and the first below: between them the enclosures cannot tell.
    let last = |certified: &dyn Fn(f64) -> bool, mut yes: f64, mut no: f64| {
        for _ in 0..60 {
            let mid = 0.5 * (yes + no);
            if certified(mid) { yes = mid } else { no = mid }
        }
        yes
    };
    let lo = last(&|t| sign(t).lo() > 0.0, from, to);
    let hi = last(&|t| sign(t).hi() < 0.0, to, from);
    Some(Interval::new(lo, hi))
}

/// Whether p < 0 for every t > cut: its Taylor coefficients there are not positive.
fn falls_beyond(power: u32, c: [f64; 3], cut: f64) -> bool {
    let z = Interval::from(cut) / Interval::int(i64::from(power));
    let [c1, c2, c3] = c.map(Interval::from);
    let (two, three) = (Interval::from(2.0), Interval::from(3.0));
    let slope = -(c1 - z * (two * c2 - three * c3 * z));
    // p'' /2 = c₂ - 3 c₃ z; where that is positive p' must still be negative at its largest.
    let bend = c2 - three * c3 * z;
    let top_slope = if c3.lo() > 0.0 { c2 * c2 / (three * c3) - c1 } else { slope };
    // A straight line falls for ever.
    let straight = c2 == Interval::from(0.0) && c3 == Interval::from(0.0);
    slope.hi() < 0.0
        && (straight || bend.hi() <= 0.0 && c3.lo() >= 0.0 || (c3.lo() > 0.0 && top_slope.hi() < 0.0))
}

/// Whether a property holds all over a box, by halving where the test does not show it.
fn always(domain: [Interval; 2], holds: impl Fn([Interval; 2]) -> bool) -> bool {
    let mut rest = vec![domain];
    let mut pieces = 0;
    while let Some(cell) = rest.pop() {
        pieces += 1;
        if pieces > MOST_PIECES {
            return false;
        }
        if holds(cell) {
            continue;
        }
        let share =
            |i: usize| if domain[i].width() > 0.0 { cell[i].width() / domain[i].width() } else { 0.0 };
        let side = usize::from(share(1) > share(0));
        let (left, right) = cell[side].bisect();
        if left.width() == 0.0 || right.width() == 0.0 {
            return false;
        }
        for half in [left, right] {
            let mut part = cell;
            part[side] = half;
            rest.push(part);
        }
    }
    true
}

/// sup over every angle in [0, π/2] and every real n ≥ `from` of |cosⁿ - bell|, the limit n → ∞
/// included, with what is proved of the bell's form; `at` is (1/n, t/T).
///
/// `None` unless 1 ≤ `from` < ∞. `seeds` are points (1/n, t/T) where the supremum may be: none are needed,
/// good ones save time.
/// In m = 1/n and y = t/T(m) by branch and bound; beyond the cut, y = 1, cosⁿ falls and the bell is 0.
///
/// ```
/// use bellfit::{bound::cosine_bell, kernel::cubic::BellFormula};
/// // The lobe paper's cs_16: T = 16 for every n.
/// let cs_16 = BellFormula { power: 16, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
/// let (error, proof) = cosine_bell(&cs_16, 16.0, &[[0.0, 0.122]], 1e-5).expect("n from 1 on");
/// assert!(error.value.lo() > 1.727e-2 && error.value.hi() < 1.729e-2);
/// assert_eq!(error.at, [0.0, 0.122]); // reached as n → ∞, at t = 1.95
/// assert!(proof.decreasing && proof.continuous && proof.negative_beyond);
/// ```
pub fn cosine_bell(
    formula: &BellFormula,
    from: f64,
    seeds: &[[f64; 2]],
    tolerance: f64,
) -> Option<(Supremum<2>, BellProof)> {
    if !(from >= 1.0 && from.is_finite()) {
        return None;
    }
    let m = Interval::new(0.0, (Interval::from(1.0) / Interval::from(from)).hi());
    let domain = [m, Interval::new(0.0, 1.0)];
    let bell = Bell { formula };
    let found = supremum_near(|cell| bell.error(*cell).abs(), domain, seeds, tolerance, MOST_BOXES);
    // p has the factor 1 - y: zero at the cut by construction.
    let proof = BellProof {
        cut: bell.parameters(m).0[0].value,
        decreasing: always(domain, |cell| bell.falls(cell)),
        continuous: true,
        negative_beyond: always(domain, |cell| bell.is_past_its_zero(cell)),
    };
    Some((found, proof))
}

/// p = (1 - y) q, q = 1 + α y + β y², y = t/T, over boxes of (m, y).
struct Bell<'a> {
    formula: &'a BellFormula,
}

impl Bell<'_> {
    /// T, α, β and their derivatives by m.
    fn parameters(&self, m: Interval) -> ([Jet; 3], Jet) {
        let m = Jet::variable(m);
        let number = |x: f64| Jet::constant(Interval::from(x));
        let rows = [self.formula.reach, self.formula.linear, self.formula.square];
        (rows.map(|[a, b, c]| number(a) + m * (number(b) + m * number(c))), m)
    }

    /// The same in both variables.
    fn lifted(&self, m: Gradient) -> [Gradient; 3] {
        let number = |x: f64| Gradient::constant(Interval::from(x));
        let rows = [self.formula.reach, self.formula.linear, self.formula.square];
        rows.map(|[a, b, c]| number(a) + m * (number(b) + m * number(c)))
    }

    /// cosⁿ - p^K over a box: the mean value form, and where p is well above 0 the logarithmic one.
    fn error(&self, cell: [Interval; 2]) -> Interval {
        let plain = Gradient::range(
            |[m, y]| {
                let one = Gradient::int(1);
                let [reach, linear, square] = self.lifted(m);
                let p = (one - y) * (one + y * (linear + y * square));
                Gradient::cos_n(y * reach, m) - p.power(self.formula.power)
            },
            cell,
        );
        let is_point = cell.iter().all(|side| side.lo() == side.hi());
        if is_point { plain } else { self.by_logarithm(cell).map_or(plain, |fine| plain.intersect(fine)) }
    }

    /// cosⁿ (1 - e^g) with g = K ln p - n ln(1 - t m) by its mean value form. Both logarithms fall
    /// alike, and in g's slopes what they have in common cancels exactly: boxes may be many times as
    /// large as for the difference itself.
    fn by_logarithm(&self, [m, y]: [Interval; 2]) -> Option<Interval> {
        let one = Interval::from(1.0);
        let ([reach, linear, square], _) = self.parameters(m);
        let q = one + y * (linear.value + y * square.value);
        let t = y * reach.value;
        let x = t * m;
        if (one - y).lo() <= 0.01 || q.lo() <= 0.01 || x.hi() >= 0.99 {
            return None;
        }
        let k = Interval::int(i64::from(self.formula.power));
        // ∂g/∂y = N/((1 - y) q (1 - x)), N = K p_y (1 - x) + T p, a polynomial whose terms nearly cancel.
        let numerator = Gradient::range(
            |[m, y]| {
                let [reach, linear, square] = self.lifted(m);
                let (one, two, three) = (Gradient::int(1), Gradient::int(2), Gradient::int(3));
                let k = Gradient::constant(k);
                let (a, b, s) = (linear - one, square - linear, reach * m);
                let n0 = k * a + reach;
                let n1 = k * (two * b - s * a) + reach * a;
                let n2 = reach * b - k * (three * square + two * s * b);
                let n3 = square * (three * k * s - reach);
                n0 + y * (n1 + y * (n2 + y * n3))
            },
            [m, y],
        );
        let by_y = numerator / ((one - y) * q * (one - x));
        let by_m = k * y * (linear.slope + y * square.slope) / q + y * reach.slope / (one - x)
            - t.power(2) * growth(x);
        let (mm, my) = (Interval::from(m.mid()), Interval::from(y.mid()));
        let ([reach, linear, square], _) = self.parameters(mm);
        let p = (one - my) * (one + my * (linear.value + my * square.value));
        let t_mid = my * reach.value;
        let log_cos = if mm.hi() == 0.0 { -t_mid } else { (one - t_mid * mm).ln() / mm };
        let g = k * p.ln() - log_cos + by_y * (y - my) + by_m * (m - mm);
        Some(cos_n_range(t, m) * (one - g.exp()))
    }

    /// ∂p/∂y < 0.
    fn falls(&self, cell: [Interval; 2]) -> bool {
        let slope = |[m, y]: [Gradient; 2]| {
            let (one, two) = (Gradient::int(1), Gradient::int(2));
            let [_, linear, square] = self.lifted(m);
            (one - y) * (linear + two * square * y) - (one + y * (linear + y * square))
        };
        Gradient::range(slope, cell).hi() < 0.0
    }

    /// q > 0 at y = 1/v ≥ 1 or that y lies behind the hemisphere's edge, y > 1/(m T): beyond its zero p
    /// is not positive.
    fn is_past_its_zero(&self, [m, v]: [Interval; 2]) -> bool {
        let ([reach, linear, square], m_jet) = self.parameters(m);
        let outside = v.hi() < (m_jet.value * reach.value).lo();
        let four = Interval::from(4.0);
        let no_zero = square.value.lo() > 0.0 && (linear.value.power(2) - four * square.value).hi() < 0.0;
        let straight = self.formula.linear == [0.0; 3] && self.formula.square == [0.0; 3];
        // v² q
        let scaled = |[m, v]: [Gradient; 2]| {
            let [_, linear, square] = self.lifted(m);
            v * (v + linear) + square
        };
        outside || no_zero || straight || Gradient::range(scaled, [m, v]).lo() > 0.0
    }
}

#[cfg(test)]
mod tests;
