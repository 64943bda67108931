//! Gauss-Legendre quadrature in w = 1 - cos of the lobe's own angle, where cs_16's integrands are
//! polynomials and cosⁿ's are for whole n.

use super::{Case, Limit, Lobe};
use crate::kernel::model::{Convention, LobeAngle, Model};
use core::f64::consts::{FRAC_PI_2, PI};
use std::collections::BTreeMap;

/// Nodes and weights on [-1, 1], nodes ascending.
///
/// Exact for polynomials of degree 2 order - 1 and no higher. The nodes are the zeros of the
/// Legendre polynomial P_order by Newton's iteration from cos(π (i + ¾)/(order + ½)); the weights
/// 2/((1 - x²) P'²) (Abramowitz & Stegun 25.4.29).
///
/// ```
/// use bellfit::integral::GaussLegendre;
/// let rule = GaussLegendre::new(2);
/// // x³ + x² over [0, 1] is 1/4 + 1/3
/// assert!((rule.integrate(|x| x * x * x + x * x, 0.0, 1.0) - 7.0 / 12.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GaussLegendre {
    nodes: Vec<f64>,
    weights: Vec<f64>,
}

impl GaussLegendre {
    /// The rule with `order` nodes; an order of 0 is taken as 1.
    pub fn new(order: usize) -> Self {
        let order = order.max(1);
        let n = order as f64;
        let (mut nodes, mut weights) = (vec![0.0; order], vec![0.0; order]);
        for i in 0..order.div_ceil(2) {
            let mut x = libm::cos(PI * (i as f64 + 0.75) / (n + 0.5));
            let mut slope = 1.0;
            // Quadratic convergence from a start good to O(n^-2): six steps leave only rounding.
            for _ in 0..6 {
                let (value, previous) = legendre(order, x);
                slope = n * (previous - x * value) / ((1.0 - x) * (1.0 + x));
                x -= value / slope;
            }
            if order % 2 == 1 && i == order / 2 {
                x = 0.0; // odd orders have their middle node at 0, by symmetry
                slope = n * legendre(order, 0.0).1;
            }
            let weight = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
            (nodes[i], weights[i]) = (-x, weight);
            (nodes[order - 1 - i], weights[order - 1 - i]) = (x, weight);
        }
        GaussLegendre { nodes, weights }
    }

    /// How many nodes.
    pub fn order(&self) -> usize {
        self.nodes.len()
    }

    /// Nodes with their weights on [-1, 1].
    pub fn pairs(&self) -> impl Iterator<Item = (f64, f64)> {
        self.nodes.iter().copied().zip(self.weights.iter().copied())
    }

    /// ∫_a^b f.
    pub fn integrate(&self, f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
        let (half, mid) = (0.5 * (b - a), 0.5 * (a + b));
        let pairs = self.nodes.iter().zip(&self.weights);
        half * pairs.fold(0.0, |sum, (&x, &w)| sum + w * f(mid + half * x))
    }
}

/// P_n(x) and P_{n-1}(x) by their recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut previous, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (previous, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k);
    }
    (value, previous)
}

/// Rules by order, each computed once.
#[derive(Clone, Debug, Default)]
pub struct GaussTable {
    rules: BTreeMap<usize, GaussLegendre>,
}

impl GaussTable {
    /// The rule with `order` nodes.
    pub fn rule(&mut self, order: usize) -> &GaussLegendre {
        self.rules.entry(order).or_insert_with(|| GaussLegendre::new(order))
    }
}

/// Int(n) by Gauss-Legendre in w, with as many nodes as make it exact where the integrand is a
/// polynomial: always for cs_16, for whole n for cosⁿ. Between whole n the cosⁿ integrand is
/// smooth of order n at its end, and 16 nodes more leave less than rounding for n ≥ 16.
pub fn gauss_legendre(case: Case, n: f64, table: &mut GaussTable) -> f64 {
    let weight_degree = match (case.model.angle(), case.model.convention()) {
        (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => 0,
        (LobeAngle::Full, _) | (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => 1,
        (LobeAngle::Half, _) => 3,
    };
    let order = match case.lobe {
        Lobe::Cs16 => (16 + weight_degree + 2) / 2,
        Lobe::CosN => {
            let extra = if n == libm::floor(n) { 0 } else { 16 };
            // Rounded up to a multiple of 16, so that 1009 exponents share 33 rules.
            ((libm::ceil(n) as usize + weight_degree + 2) / 2 + extra).next_multiple_of(16)
        }
    };
    let lobe = |w: f64| match case.lobe {
        Lobe::Cs16 => {
            let base = 1.0 - n * w / 16.0;
            let fourth = (base * base) * (base * base);
            (fourth * fourth) * (fourth * fourth)
        }
        Lobe::CosN => libm::pow(1.0 - w, n),
    };
    let weight = |w: f64| {
        let c = 1.0 - w;
        match (case.model.angle(), case.model.convention()) {
            (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => 1.0,
            (LobeAngle::Full, _) => c,
            (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => 4.0 * c,
            (LobeAngle::Half, _) => 4.0 * c * (2.0 * c * c - 1.0),
        }
    };
    table.rule(order).integrate(|w| lobe(w) * weight(w), 0.0, upper_versine(case, n))
}

/// 2 sin²(ψ/2) at the limit ψ of the lobe's own angle.
fn upper_versine(case: Case, n: f64) -> f64 {
    let zero = if n > 8.0 { 2.0 * libm::asin(libm::sqrt(8.0 / n)) } else { PI };
    let theta = match (case.lobe, case.limit) {
        (Lobe::CosN, _) => FRAC_PI_2,
        (_, Limit::Paper) => 6.0 / libm::sqrt(n),
        (_, Limit::Card) => libm::sqrt(6.0 / n),
        (_, Limit::ExactZero) => zero,
        (_, Limit::Support) => zero * own_angle_divisor(case.model),
    };
    let s = libm::sin(0.5 * theta.min(FRAC_PI_2) / own_angle_divisor(case.model));
    2.0 * s * s
}

fn own_angle_divisor(model: Model) -> f64 {
    match model.angle() {
        LobeAngle::Full => 1.0,
        LobeAngle::Half => 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫_-1^1 x^k = 2/(k + 1) for even k.
    #[test]
    fn exact_to_its_degree_and_not_one_beyond() {
        for order in [1, 2, 5, 9, 10, 33] {
            let rule = GaussLegendre::new(order);
            let degree = 2 * order - 1;
            for k in 0..=degree {
                let exact = if k % 2 == 0 { 2.0 / (k as f64 + 1.0) } else { 0.0 };
                let sum = rule.integrate(|x| libm::pow(x, k as f64), -1.0, 1.0);
                // Weights sum to 2 and each is good to a few ε times the order.
                assert!((sum - exact).abs() < 1e-14 * order as f64, "order {order}, degree {k}");
            }
            // The first miss is by the monic Legendre polynomial's norm, (order!)⁴ 2^(2 order + 1)
            // /((2 order + 1) ((2 order)!)²), far above rounding for small orders.
            if order <= 10 {
                let k = (degree + 1) as f64;
                let sum = rule.integrate(|x| libm::pow(x, k), -1.0, 1.0);
                let mut miss = 2.0 / (2.0 * order as f64 + 1.0);
                for j in 1..=order {
                    // ((order!)² 2^order/(2 order)!)² as a product of small factors
                    let j = j as f64;
                    let factor = 2.0 * j * j / ((2.0 * j) * (2.0 * j - 1.0));
                    miss *= factor * factor;
                }
                let found = 2.0 / (k + 1.0) - sum;
                assert!((found - miss).abs() < 1e-13, "order {order}: {found:e} against {miss:e}");
                assert!(found > 1e-7 * 2.0 / (k + 1.0));
            }
        }
    }

    #[test]
    fn large_orders_keep_their_digits() {
        let rule = GaussLegendre::new(515);
        let sum = rule.integrate(|x| libm::pow(x, 1028.0), 0.0, 1.0);
        assert!((sum * 1029.0 - 1.0).abs() < 2e-13, "{:e}", sum * 1029.0 - 1.0);
        assert!(rule.nodes.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
