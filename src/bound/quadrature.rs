//! Gauss-Legendre rules with every node and weight enclosed, so that the integral of a polynomial of
//! low enough degree is enclosed too.

use super::{Fixed, Interval, power_of_ten};
use crate::integral::{Edge, Field};
use dashu_ratio::RBig;

/// The largest degree whose nodes are told apart and whose weights keep their digits.
const MOST: u32 = 69;

/// A rule on [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub struct EnclosedRule {
    /// (node, weight), nodes descending.
    pairs: Vec<(Interval, Interval)>,
}

impl EnclosedRule {
    /// The rule that is exact for polynomials up to this degree; `None` for a degree above 69, where the
    /// recurrence's growth leaves too few of the 128 bits.
    ///
    /// ```
    /// use bellfit::bound::{EnclosedRule, Interval};
    /// let rule = EnclosedRule::exact_to(7).expect("a low degree");
    /// let integral = rule.integrate(|y: Interval| y * y * y);
    /// assert!(integral.contains(0.25) && integral.width() < 1e-14);
    /// ```
    pub fn exact_to(degree: u32) -> Option<Self> {
        if degree > MOST {
            return None;
        }
        let order = degree / 2 + 1;
        let pairs: Option<Vec<_>> = (0..order).map(|i| enclosed_pair(order, i)).collect();
        let pairs = pairs?;
        // As many sign changes in disjoint intervals as zeros: each holds exactly one.
        pairs.windows(2).all(|pair| pair[1].0.hi() < pair[0].0.lo()).then_some(EnclosedRule { pairs })
    }

    /// ∫_0^1 f for a polynomial f of at most the rule's degree, over any arithmetic.
    pub fn integrate<T: Edge>(&self, f: impl Fn(T) -> T) -> T {
        self.pairs.iter().fold(T::int(0), |sum, (node, weight)| {
            let node = T::between(node.lo(), node.hi());
            sum + T::between(weight.lo(), weight.hi()) * f(node)
        })
    }
}

/// P_order(x) and P_(order-1)(x) by their recurrence.
fn legendre<T: Field>(order: u32, x: &T) -> (T, T) {
    let (mut previous, mut value) = (T::int(1), x.clone());
    for k in 2..=i64::from(order) {
        let next = (T::int(2 * k - 1) * x.clone() * value.clone() - T::int(k - 1) * previous) / T::int(k);
        (previous, value) = (value, next);
    }
    (value, previous)
}

/// P'_order from both.
fn slope<T: Field>(order: u32, x: &T, (value, previous): (T, T)) -> T {
    let one = T::int(1);
    let edge = (one.clone() - x.clone()) * (one + x.clone());
    T::int(i64::from(order)) * (previous - x.clone() * value) / edge
}

/// Half the width of a node's enclosure. Intervals of width w come out of the recurrence up to
/// 2.42^order times as wide, so 10^-27 leaves the weights sixteen digits at order 26; and the same
/// factor on 2^-128 keeps the signs at the ends certain.
const REACH: i32 = -27;

/// The node that Newton's iteration finds from cos(π (i + ¾)/(order + ½)), in doubles and once more in 128 bits, with the signs of P on both sides of it as proof; with its
/// weight, mapped to [0, 1].
fn enclosed_pair(order: u32, i: u32) -> Option<(Interval, Interval)> {
    let mut x = libm::cos(core::f64::consts::PI * (f64::from(i) + 0.75) / (f64::from(order) + 0.5));
    for _ in 0..6 {
        let values = legendre(order, &x);
        x -= values.0 / slope(order, &x, values);
    }
    let start = Fixed::between(x, x);
    let values = legendre(order, &start);
    let better = start.clone() - values.0.clone() / slope(order, &start, values);
    let (lo, hi) = better.ends();
    let (lo, hi) = (lo - power_of_ten(REACH), hi + power_of_ten(REACH));
    let value_at = |end: &RBig| legendre(order, &Fixed::rational(end)).0.to_interval();
    let (left, right) = (value_at(&lo), value_at(&hi));
    if !(left.hi() < 0.0 && right.lo() > 0.0 || left.lo() > 0.0 && right.hi() < 0.0) {
        return None;
    }
    let node = Fixed::rational(&lo).hull(Fixed::rational(&hi));
    let (one, two) = (Fixed::int(1), Fixed::int(2));
    // P itself is 0 at the node.
    let previous = legendre(order, &node).1;
    let slope = slope(order, &node, (Fixed::int(0), previous));
    let weight = one.clone() / ((one.clone() - node.clone()) * (one.clone() + node.clone()) * slope.power(2));
    Some((((one + node) / two).to_interval(), weight.to_interval()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn monomials_up_to_the_degree_are_enclosed_and_the_next_is_not() {
        assert!(EnclosedRule::exact_to(MOST + 1).is_none());
        for degree in [1, 3, 15, 27, 51, MOST] {
            let rule = EnclosedRule::exact_to(degree).unwrap();
            for k in 0..=degree {
                let found = rule.integrate(|y: Interval| y.power(k));
                let exact = Interval::from(1.0) / Interval::int(i64::from(k) + 1);
                assert!(!found.is_disjoint(exact) && found.width() < 1e-12, "y^{k} by {degree}: {found:?}");
            }
            if degree <= 15 {
                let beyond = rule.integrate(|y: Interval| y.power(degree + 1));
                assert!(beyond.is_disjoint(Interval::from(1.0) / Interval::int(i64::from(degree) + 2)));
            }
        }
    }
}
