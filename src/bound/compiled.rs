//! Quotients of polynomials as they are evaluated: in m = 1/n, over any arithmetic.

use super::{Coefficient, Exponents, Formula, Interval, Polynomial};
use crate::integral::Field;
use dashu_ratio::RBig;

/// A quotient of polynomials in n, 2^(-n/2) and π with its coefficients read into one arithmetic.
#[derive(Clone, Debug)]
pub(super) struct Compiled<C> {
    numerator: Vec<(C, Exponents)>,
    pub(super) numerator_degree: u32,
    denominator: Vec<(C, Exponents)>,
    pub(super) denominator_degree: u32,
    pub(super) has_power_of_two: bool,
    pi: C,
}

impl<C> Compiled<C> {
    pub(super) fn new(factor: &Formula, compile: impl Fn(&Polynomial) -> Vec<(C, Exponents)>, pi: C) -> Self {
        let Formula { numerator, denominator } = factor;
        Compiled {
            numerator_degree: numerator.degree(0),
            denominator_degree: denominator.degree(0),
            has_power_of_two: numerator.degree(1) + denominator.degree(1) > 0,
            numerator: compile(numerator),
            denominator: compile(denominator),
            pi,
        }
    }

    /// The quotient times m^factors at m = 1/n: both polynomials times the power of m that clears their
    /// poles. h is asked for only where there is a power of 2.
    pub(super) fn at<T: Field>(&self, m: &T, factors: u32, lift: impl Fn(&C) -> T, h: impl Fn() -> T) -> T {
        let h = if self.has_power_of_two { h() } else { T::int(0) };
        let sum = |terms: &[(C, Exponents)], degree: u32| {
            terms.iter().fold(T::int(0), |total, (c, e)| {
                let mut term = lift(c) * m.power(degree - e[0]);
                if e[1] > 0 {
                    term = term * h.power(e[1]);
                }
                if e[2] > 0 {
                    term = term * lift(&self.pi).power(e[2]);
                }
                total + term
            })
        };
        let quotient =
            sum(&self.numerator, self.numerator_degree) / sum(&self.denominator, self.denominator_degree);
        let (up, down) = (factors + self.denominator_degree, self.numerator_degree);
        if up >= down { quotient * m.power(up - down) } else { quotient / m.power(down - up) }
    }
}

impl Compiled<RBig> {
    /// Exactly, where there is no π to enclose.
    pub(super) fn in_rationals(factor: &Formula) -> Option<Self> {
        let free_of_pi = factor.numerator.degree(2) + factor.denominator.degree(2) == 0;
        let exactly = |p: &Polynomial| p.terms().map(|(e, c)| (c.clone(), *e)).collect();
        free_of_pi.then(|| Compiled::new(factor, exactly, RBig::int(0)))
    }

    /// What the quotient is divided by at m.
    pub(super) fn denominator_at(&self, m: &RBig, h: &RBig) -> RBig {
        let terms = self.denominator.iter();
        terms.fold(RBig::int(0), |total, (c, e)| {
            total + c.clone() * m.power(self.denominator_degree - e[0]) * h.power(e[1])
        })
    }
}

impl Compiled<Interval> {
    pub(super) fn in_intervals(factor: &Formula) -> Self {
        Compiled::new(factor, Polynomial::compile, Coefficient::pi())
    }
}
