//! Bells given by the coefficients of a polynomial: p(t/K)^K, cut at p's first zero, which is found exactly
//! enough to be proved.

use super::{Interval, enclose};
use crate::integral::Field;
use dashu_ratio::RBig;
use thiserror::Error;

/// Why coefficients are no bell.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PolynomialBellError {
    /// The bell is not 1 at its peak.
    #[error("p begins with {value}: a lobe is 1 at its peak, so the first coefficient is 1")]
    Peak {
        /// p(0).
        value: String,
    },
    /// K is not a power of two, or too large.
    #[error("K = {power}: a power of two from 1 to 64 is needed")]
    Power {
        /// K.
        power: u32,
    },
    /// No rule is exact to that degree, or there is nothing but the constant.
    #[error("p has degree {degree}: with K = {power} an integral can be proved for 1 to {most}")]
    Degree {
        /// p's degree.
        degree: usize,
        /// K.
        power: u32,
        /// The largest that can be proved.
        most: u32,
    },
    /// A coefficient out of all proportion.
    #[error("a coefficient of size {value:e}: 0 or a size from 1e-12 to 1e12 is needed", value = f64::from_bits(*bits))]
    Coefficient {
        /// Its size in doubles, as bits.
        bits: u64,
    },
    /// p stays above 0.
    #[error("p has no zero in 0 < y ≤ {most}: the bell has no end to cut it at", most = FARTHEST)]
    NoZero,
}

/// How far a zero is looked for, in y = t/K: a power of two, whose halves are exact.
const FARTHEST: i64 = 1 << 20;
/// The largest degree of p.
const HIGHEST: u32 = 16;
/// The largest K · degree: 69, to which a rule is exact, less the weight's three.
const MOST: u32 = 66;
/// Halvings after which the zero is enclosed to the last bit of a double and beyond.
const HALVINGS: u32 = 200;

/// p(y)^K, p = c₀ + c₁ y + c₂ y² + …, c₀ = 1, y = t/K, t = n (1 - cos θ); 0 from p's first zero on.
///
/// p is positive before its first zero, because it is 1 at 0; it need not fall.
///
/// ```
/// use bellfit::bound::{PolynomialBell, PolynomialBellError, decimal};
/// let bell = |texts: &[&str], k| {
///     let exact: Vec<_> = texts.iter().map(|text| decimal(text).expect("a decimal").0).collect();
///     PolynomialBell::new(&exact, k)
/// };
/// // 1 - y²/2 ends at y = √2, t = 4 √2.
/// let reach = bell(&["1", "0", "-0.5"], 4)?.reach();
/// assert!(reach.contains(libm::sqrt(32.0)) && reach.width() < 1e-14);
/// assert_eq!(bell(&["1", "0", "0.5"], 4), Err(PolynomialBellError::NoZero));
/// # Ok::<(), PolynomialBellError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialBell {
    coefficients: Vec<RBig>,
    power: u32,
    /// The first zero lies between these; it is both, if it is known to be rational.
    zero: (RBig, RBig),
    /// The coefficients of p in u = y/zero.
    unit: Vec<Interval>,
}

impl PolynomialBell {
    /// From c₀, c₁, …, exactly, and K.
    ///
    /// # Errors
    /// [`PolynomialBellError`], which names the value and the domain.
    pub fn new(coefficients: &[RBig], power: u32) -> Result<Self, PolynomialBellError> {
        if !power.is_power_of_two() || power > 64 {
            return Err(PolynomialBellError::Power { power });
        }
        let p = trimmed(coefficients.to_vec());
        if p.first() != Some(&RBig::int(1)) {
            let value = p.first().map_or_else(|| "0".to_owned(), |c| format!("{}", c.to_f64().value()));
            return Err(PolynomialBellError::Peak { value });
        }
        let (degree, most) = (p.len() - 1, HIGHEST.min(MOST / power));
        if degree < 1 || degree > most as usize {
            return Err(PolynomialBellError::Degree { degree, power, most });
        }
        for size in p.iter().filter(|c| !c.is_zero()).map(|c| c.to_f64().value().abs()) {
            if !(1e-12..=1e12).contains(&size) {
                return Err(PolynomialBellError::Coefficient { bits: size.to_bits() });
            }
        }
        let zero = first_zero(&p).ok_or(PolynomialBellError::NoZero)?;
        let mut powers = (RBig::int(1), RBig::int(1));
        let mut unit = Vec::with_capacity(p.len());
        for c in &p {
            unit.push(
                enclose(&(c.clone() * powers.0.clone())).hull(enclose(&(c.clone() * powers.1.clone()))),
            );
            powers = (powers.0 * zero.0.clone(), powers.1 * zero.1.clone());
        }
        Ok(PolynomialBell { coefficients: p, power, zero, unit })
    }

    /// c₀, c₁, …, the last not 0.
    pub fn coefficients(&self) -> &[RBig] {
        &self.coefficients
    }

    /// K.
    pub fn power(&self) -> u32 {
        self.power
    }

    /// The degree of p.
    pub fn degree(&self) -> u32 {
        self.coefficients.len() as u32 - 1
    }

    /// Encloses T, the t where the bell ends: K times p's first zero.
    pub fn reach(&self) -> Interval {
        let k = RBig::int(i64::from(self.power));
        enclose(&(self.zero.0.clone() * k.clone())).hull(enclose(&(self.zero.1.clone() * k)))
    }

    /// T, if p's first zero was found to be rational.
    pub fn rational_reach(&self) -> Option<RBig> {
        (self.zero.0 == self.zero.1).then(|| self.zero.0.clone() * RBig::int(i64::from(self.power)))
    }

    /// Encloses the coefficients of p in u = t/T.
    pub(super) fn unit(&self) -> &[Interval] {
        &self.unit
    }

    /// ∫_0^1 p^K u^j du for j = 0..=3, exactly, where T is rational.
    pub(super) fn moments(&self) -> Option<[RBig; 4]> {
        self.rational_reach()?;
        let mut scale = RBig::int(1);
        let mut base = Vec::with_capacity(self.coefficients.len());
        for c in &self.coefficients {
            base.push(c.clone() * scale.clone());
            scale *= self.zero.0.clone();
        }
        let whole = (0..self.power.trailing_zeros()).fold(base, |p, _| product(&p, &p));
        Some([0, 1, 2, 3].map(|j| {
            let term = |(i, c): (usize, &RBig)| c.clone() / RBig::int(i as i64 + j + 1);
            whole.iter().enumerate().map(term).fold(RBig::int(0), |sum, term| sum + term)
        }))
    }
}

fn trimmed(mut p: Vec<RBig>) -> Vec<RBig> {
    while p.last().is_some_and(RBig::is_zero) {
        p.pop();
    }
    p
}

fn product(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
    let mut all = vec![RBig::int(0); p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            all[i + j] = all[i + j].clone() + a.clone() * b.clone();
        }
    }
    all
}

fn value(p: &[RBig], x: &RBig) -> RBig {
    p.iter().rev().fold(RBig::int(0), |sum, c| sum * x.clone() + c.clone())
}

/// Quotient and remainder; q is not 0.
fn divided(p: &[RBig], q: &[RBig]) -> (Vec<RBig>, Vec<RBig>) {
    let mut rest = p.to_vec();
    let mut quotient = vec![RBig::int(0); p.len().saturating_sub(q.len()) + 1];
    while rest.len() >= q.len() {
        let (shift, lead) = (rest.len() - q.len(), rest[rest.len() - 1].clone() / q[q.len() - 1].clone());
        for (i, c) in q.iter().enumerate() {
            rest[shift + i] = rest[shift + i].clone() - lead.clone() * c.clone();
        }
        quotient[shift] = lead;
        rest.pop();
        rest = trimmed(rest);
    }
    (trimmed(quotient), rest)
}

/// Sturm's sequence: each next the negative remainder, scaled to a leading coefficient of size 1.
fn sturm(p: &[RBig]) -> Vec<Vec<RBig>> {
    let slope = p.iter().enumerate().skip(1).map(|(i, c)| c.clone() * RBig::int(i as i64)).collect();
    let mut all = vec![p.to_vec(), trimmed(slope)];
    while all.last().is_some_and(|last| last.len() > 1) {
        let rest = divided(&all[all.len() - 2], &all[all.len() - 1]).1;
        let Some(lead) = rest.last().cloned() else { break };
        // Divided by -|lead|.
        let lead = if lead > RBig::int(0) { RBig::int(0) - lead } else { lead };
        all.push(rest.into_iter().map(|c| c / lead.clone()).collect());
    }
    all
}

/// Changes of sign along the sequence at x, zeros left out.
fn variations(sequence: &[Vec<RBig>], x: &RBig) -> usize {
    let zero = RBig::int(0);
    let signs: Vec<bool> =
        sequence.iter().map(|p| value(p, x)).filter(|v| *v != zero).map(|v| v > zero).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Encloses the least positive zero of p, p(0) ≠ 0, by Sturm's theorem; both ends are the zero where it is
/// found to be rational.
fn first_zero(p: &[RBig]) -> Option<(RBig, RBig)> {
    // Multiple zeros once: p over its common divisor with its slope.
    let sequence = sturm(p);
    let common = sequence.last().filter(|last| last.len() > 1);
    let simple = common.map_or_else(|| p.to_vec(), |common| divided(p, common).0);
    let sequence = if common.is_some() { sturm(&simple) } else { sequence };
    let (mut lo, mut hi) = (RBig::int(0), RBig::int(FARTHEST));
    let before = variations(&sequence, &lo);
    let count = |x: &RBig| before.saturating_sub(variations(&sequence, x));
    let mut inside = count(&hi);
    if inside == 0 {
        return None;
    }
    let positive = value(&simple, &lo) > RBig::int(0);
    for _ in 0..HALVINGS {
        let middle = (lo.clone() + hi.clone()) / RBig::int(2);
        let at = value(&simple, &middle);
        if inside == 1 {
            // One simple zero: the sign tells the side.
            if at.is_zero() {
                return Some((middle.clone(), middle));
            }
            if (at > RBig::int(0)) == positive { lo = middle } else { hi = middle }
        } else {
            let left = count(&middle);
            if left > 0 { (hi, inside) = (middle, left) } else { lo = middle }
        }
        if inside == 1 && (hi.clone() - lo.clone()) * RBig::int(1 << 50) * RBig::int(1 << 30) < hi {
            break;
        }
    }
    // The simplest number between them is the zero, if a simple one is.
    let simplest =
        if value(&simple, &hi).is_zero() { hi.clone() } else { RBig::simplest_in(lo.clone(), hi.clone()) };
    if value(&simple, &simplest).is_zero() { Some((simplest.clone(), simplest)) } else { Some((lo, hi)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::decimal;

    fn bell(coefficients: &[&str], power: u32) -> Result<PolynomialBell, PolynomialBellError> {
        let exact: Vec<RBig> = coefficients.iter().map(|c| decimal(c).unwrap().0).collect();
        PolynomialBell::new(&exact, power)
    }

    #[test]
    fn the_first_zero_is_the_first_and_rational_ones_are_known() {
        let rational = |coefficients: &[&str]| bell(coefficients, 1).unwrap().rational_reach();
        let third = |a: i64, b: i64| Some(RBig::int(a) / RBig::int(b));
        assert_eq!(rational(&["1", "-1"]), third(1, 1));
        assert_eq!(rational(&["1", "-0.3"]), third(10, 3));
        // (1 - y)(1 - 2 y)(1 - 4 y): 1/4 of three; and beyond 2 y = 1 it rises again.
        assert_eq!(rational(&["1", "-7", "14", "-8"]), third(1, 4));
        // (1 - y)² touches 0 and is cut there; (1 - 3 y)²(1 - y) too.
        assert_eq!(rational(&["1", "-2", "1"]), third(1, 1));
        assert_eq!(rational(&["1", "-7", "15", "-9"]), third(1, 3));
        let root = bell(&["1", "0", "-2"], 1).unwrap();
        assert!(root.rational_reach().is_none() && root.reach().contains(libm::sqrt(0.5)));
        // Trailing zeros are no degree.
        assert_eq!(bell(&["1", "-1", "0.0"], 64).unwrap().degree(), 1);
    }

    #[test]
    fn two_zeros_beside_one_another_are_told_apart() {
        // (1 - 1000 y)(1 - 999.999 y): the nearer by 1e-9.
        let found = bell(&["1", "-1999.999", "999999"], 2).unwrap().rational_reach();
        assert_eq!(found, Some(RBig::int(2) / RBig::int(1000)));
    }

    #[test]
    fn what_is_no_bell_is_told_with_its_domain() {
        for (coefficients, power, words) in [
            (&["2", "-1"][..], 4, "p begins with 2"),
            (&["0"][..], 4, "p begins with 0"),
            (&["1", "-1"][..], 3, "K = 3"),
            (&["1", "-1"][..], 128, "1 to 64"),
            (&["1"][..], 4, "degree 0"),
            (&["1", "-1", "1", "-1"][..], 32, "with K = 32 an integral can be proved for 1 to 2"),
            (&["1", "-1e13"][..], 4, "1e13"),
            (&["1", "1"][..], 4, "no zero"),
            (&["1", "-1", "1"][..], 4, "no zero"),
            (&["1", "-1e-9"][..], 4, "no zero in 0 < y ≤ 1048576"),
        ] {
            let error = bell(coefficients, power).unwrap_err().to_string();
            assert!(error.contains(words), "{coefficients:?}: {error}");
        }
    }

    #[test]
    fn moments_are_beta_functions_for_lyons_bells() {
        // ∫_0^1 (1 - u)^8 u^j du = j! 8!/(9 + j)!
        let moments = bell(&["1", "-1"], 8).unwrap().moments().unwrap();
        for (j, (a, b)) in [(1, 9), (1, 90), (1, 495), (1, 1980)].into_iter().enumerate() {
            assert_eq!(moments[j], RBig::int(a) / RBig::int(b), "{j}");
        }
    }
    #[test]
    fn a_bell_keeps_what_it_was_made_of() {
        let found = bell(&["1", "-0.9", "-0.125", "0"], 8).unwrap();
        let exact = ["1", "-0.9", "-0.125"].map(|c| decimal(c).unwrap().0);
        assert_eq!((found.coefficients(), found.power(), found.degree()), (&exact[..], 8, 2));
    }
}
