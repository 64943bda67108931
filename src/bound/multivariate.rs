//! Polynomials in any number of variables with rational coefficients: identities between them are decided
//! exactly, and where one fails an exact point says so.

use crate::integral::Field;
use core::ops::{Add, Mul, Sub};
use dashu_ratio::RBig;
use std::collections::BTreeMap;

/// A polynomial in N variables.
///
/// ```
/// use bellfit::bound::Multivariate;
/// let [x, y] = Multivariate::<2>::variables();
/// // (x + y)(x - y) = x² - y²
/// let difference = (x.clone() + y.clone()) * (x.clone() - y.clone()) - (x.power(2) - y.power(2));
/// assert!(difference.is_zero());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Multivariate<const N: usize> {
    /// Coefficients by exponents, none of them 0.
    terms: BTreeMap<[u32; N], RBig>,
}

impl<const N: usize> Multivariate<N> {
    /// The N variables.
    pub fn variables() -> [Self; N] {
        core::array::from_fn(|k| {
            let exponents = core::array::from_fn(|i| u32::from(i == k));
            Multivariate { terms: BTreeMap::from([(exponents, RBig::int(1))]) }
        })
    }

    /// A number.
    pub fn constant(value: RBig) -> Self {
        let terms = if value.is_zero() { BTreeMap::new() } else { BTreeMap::from([([0; N], value)]) };
        Multivariate { terms }
    }

    /// A whole number.
    pub fn int(value: i64) -> Self {
        Self::constant(RBig::int(value))
    }

    /// selfᵏ.
    pub fn power(&self, k: u32) -> Self {
        (0..k).fold(Self::int(1), |product, _| product * self.clone())
    }

    /// Whether it is 0 at every point, which over an infinite field is to have no coefficient but 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value.
    pub fn at(&self, point: &[RBig; N]) -> RBig {
        self.terms.iter().fold(RBig::int(0), |sum, (exponents, coefficient)| {
            let powers = point.iter().zip(exponents).map(|(x, k)| x.power(*k));
            sum + powers.fold(coefficient.clone(), |product, power| product * power)
        })
    }
}

impl<const N: usize> Add for Multivariate<N> {
    type Output = Self;
    fn add(mut self, rhs: Self) -> Self {
        for (exponents, coefficient) in rhs.terms {
            let sum = self.terms.remove(&exponents).unwrap_or(RBig::int(0)) + coefficient;
            if !sum.is_zero() {
                self.terms.insert(exponents, sum);
            }
        }
        self
    }
}

impl<const N: usize> Sub for Multivariate<N> {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        self + rhs * Self::int(-1)
    }
}

impl<const N: usize> Mul for Multivariate<N> {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        let mut product = Multivariate { terms: BTreeMap::new() };
        for (a, x) in &self.terms {
            for (b, y) in &rhs.terms {
                let exponents = core::array::from_fn(|k| a[k] + b[k]);
                let term = BTreeMap::from([(exponents, x.clone() * y.clone())]);
                product = product + Multivariate { terms: term };
            }
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_products_agree_with_rational_arithmetic() {
        let [x, y, z] = Multivariate::<3>::variables();
        let polynomial = (x.clone() - y.clone() * z.clone()).power(3) + Multivariate::int(2) * y - z;
        for (a, b, c) in [(0, 0, 0), (1, 2, 3), (-5, 7, 2), (4, -1, -9)] {
            let expected = (a - b * c) * (a - b * c) * (a - b * c) + 2 * b - c;
            let found = polynomial.at(&[a, b, c].map(RBig::int));
            assert_eq!(found, RBig::int(expected), "{a}, {b}, {c}");
        }
        assert!(!polynomial.is_zero() && (polynomial.clone() - polynomial).is_zero());
    }
}
