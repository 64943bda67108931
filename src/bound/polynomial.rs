//! Polynomials in n, h = 2^(-n/2) and π with rational coefficients: what the papers' factors are
//! made of, so that identities between them are decided exactly.

use super::exact;
use crate::integral::Field;
use dashu_ratio::RBig;
use std::collections::BTreeMap;

/// The exponents of n, h and π in one term.
pub type Exponents = [u32; 3];

/// A polynomial in n, h = 2^(-n/2) and π.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial {
    terms: BTreeMap<Exponents, RBig>,
}

impl Polynomial {
    /// A constant.
    pub fn constant(value: RBig) -> Self {
        Self::monomial([0, 0, 0], value)
    }

    /// value · n^e₀ h^e₁ π^e₂.
    pub fn monomial(exponents: Exponents, value: RBig) -> Self {
        let mut terms = BTreeMap::new();
        if !value.is_zero() {
            terms.insert(exponents, value);
        }
        Polynomial { terms }
    }

    /// The variable n.
    pub fn n() -> Self {
        Self::monomial([1, 0, 0], RBig::int(1))
    }

    /// h = 2^(-n/2).
    pub fn h() -> Self {
        Self::monomial([0, 1, 0], RBig::int(1))
    }

    /// π.
    pub fn pi() -> Self {
        Self::monomial([0, 0, 1], RBig::int(1))
    }

    /// The terms with their coefficients, none of them 0.
    pub fn terms(&self) -> impl Iterator<Item = (&Exponents, &RBig)> {
        self.terms.iter()
    }

    /// Whether this is 0 identically: n, h and π are algebraically independent as functions of
    /// n, so a polynomial in them vanishes for every n only if all its coefficients do.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value if there is no variable in it.
    pub fn as_constant(&self) -> Option<RBig> {
        match self.terms.len() {
            0 => Some(RBig::int(0)),
            1 => self.terms.get(&[0, 0, 0]).cloned(),
            _ => None,
        }
    }

    /// The highest power of variable k (0 for n, 1 for h, 2 for π).
    pub fn degree(&self, k: usize) -> u32 {
        self.terms.keys().map(|e| e[k]).max().unwrap_or(0)
    }

    /// The highest power of π that divides every term.
    pub fn pi_content(&self) -> u32 {
        self.terms.keys().map(|e| e[2]).min().unwrap_or(0)
    }

    /// This divided by π^k, k at most [`Polynomial::pi_content`].
    pub fn without_pi(&self, k: u32) -> Self {
        let terms =
            self.terms.iter().map(|(e, c)| ([e[0], e[1], e[2].saturating_sub(k)], c.clone())).collect();
        Polynomial { terms }
    }

    /// The coefficient polynomial of h^k, as coefficients of n⁰, n¹, …; `None` if π occurs.
    pub fn in_n(&self, h_power: u32) -> Option<Vec<RBig>> {
        let mut coefficients = vec![RBig::int(0); self.degree(0) as usize + 1];
        for (e, c) in &self.terms {
            if e[2] != 0 {
                return None;
            }
            if e[1] == h_power {
                coefficients[e[0] as usize] = c.clone();
            }
        }
        Some(coefficients)
    }

    /// self + rhs.
    pub fn plus(&self, rhs: &Self) -> Self {
        let mut terms = self.terms.clone();
        for (e, c) in &rhs.terms {
            let sum = terms.remove(e).unwrap_or_else(|| RBig::int(0)) + c.clone();
            if !sum.is_zero() {
                terms.insert(*e, sum);
            }
        }
        Polynomial { terms }
    }

    /// self · value.
    pub fn scaled(&self, value: &RBig) -> Self {
        self.times(&Self::constant(value.clone()))
    }

    /// self - rhs.
    pub fn minus(&self, rhs: &Self) -> Self {
        self.plus(&rhs.scaled(&RBig::int(-1)))
    }

    /// self · rhs.
    pub fn times(&self, rhs: &Self) -> Self {
        let mut terms: BTreeMap<Exponents, RBig> = BTreeMap::new();
        for (a, x) in &self.terms {
            for (b, y) in &rhs.terms {
                let e = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
                let sum = terms.remove(&e).unwrap_or_else(|| RBig::int(0)) + x.clone() * y.clone();
                if !sum.is_zero() {
                    terms.insert(e, sum);
                }
            }
        }
        Polynomial { terms }
    }

    /// Evaluates the coefficients once, for repeated use over one arithmetic.
    pub fn compile<T: Coefficient>(&self) -> Vec<(T, Exponents)> {
        self.terms.iter().map(|(e, c)| (T::rational(c), *e)).collect()
    }
}

/// An arithmetic that can hold an exact rational and π.
pub trait Coefficient: Field {
    /// The exact number, or an enclosure of it.
    fn rational(value: &RBig) -> Self;
    /// π.
    fn pi() -> Self;
}

impl Coefficient for super::Interval {
    fn rational(value: &RBig) -> Self {
        exact::enclose(value)
    }
    fn pi() -> Self {
        super::Interval::PI
    }
}

impl Coefficient for super::Jet {
    fn rational(value: &RBig) -> Self {
        super::Jet::constant(exact::enclose(value))
    }
    fn pi() -> Self {
        super::Jet::constant(super::Interval::PI)
    }
}

impl Coefficient for f64 {
    fn rational(value: &RBig) -> Self {
        value.to_f64().value()
    }
    fn pi() -> Self {
        core::f64::consts::PI
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_differences_are_exact() {
        // (n + h)(n - h) = n² - h²
        let left = Polynomial::n().plus(&Polynomial::h()).times(&Polynomial::n().minus(&Polynomial::h()));
        let right = Polynomial::monomial([2, 0, 0], RBig::int(1))
            .minus(&Polynomial::monomial([0, 2, 0], RBig::int(1)));
        assert_eq!(left, right);
        assert!(left.minus(&right).is_zero());
        assert_eq!(left.degree(0), 2);
        assert_eq!(left.in_n(2), Some(vec![RBig::int(-1), RBig::int(0), RBig::int(0)]));
    }

    #[test]
    fn what_cancels_is_the_constant_0() {
        let n = Polynomial::n();
        assert_eq!(n.minus(&n).as_constant(), Some(RBig::int(0)));
        assert_eq!(Polynomial::constant(RBig::int(3)).as_constant(), Some(RBig::int(3)));
        assert!(n.as_constant().is_none() && n.plus(&Polynomial::pi()).as_constant().is_none());
    }
}
