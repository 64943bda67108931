//! How far cosⁿ is from a Gaussian, and a Gaussian from Lyon's bells: suprema over every θ or t.

use super::difference::{MOST_BOXES, cos_n_jet, reciprocal};
use super::{Interval, Jet, Supremum, range, supremum};
use crate::integral::{Edge, Field};

/// Which Gaussian stands for cosⁿθ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Gaussian {
    /// e^(-n θ²/2), in the angle.
    Angle,
    /// e^(-n (1 - cos θ)), in the cosine: the spherical Gaussian.
    Cosine,
}

impl Gaussian {
    /// Both.
    pub const ALL: [Gaussian; 2] = [Gaussian::Angle, Gaussian::Cosine];

    /// The name in claims and tables.
    pub const fn id(self) -> &'static str {
        match self {
            Gaussian::Angle => "gaussian-angle",
            Gaussian::Cosine => "gaussian-cosine",
        }
    }

    /// The formula.
    pub const fn formula(self) -> &'static str {
        match self {
            Gaussian::Angle => "e^(-nθ²/2)",
            Gaussian::Cosine => "e^(-n(1 - cos θ))",
        }
    }
}

/// Where both functions are below e^-19 for every n ≥ 16, so that the rest of the hemisphere
/// (n π²/8 ≥ 19.7 in the angle's variable) need not be searched.
const FAR: f64 = 19.0;

/// Gaussian - cosⁿθ as a jet in x at one m = 1/n, x = n θ²/2 (angle) or n (1 - cos θ) (cosine).
fn distance(kind: Gaussian, x: Jet, m: Interval) -> Jet {
    let negative = Jet::int(0) - x;
    let t = match kind {
        Gaussian::Cosine => x,
        // t = n (1 - cos θ) = 2 x (1 - cos √y)/y with y = θ² = 2 x m
        Gaussian::Angle => {
            let two = Jet::int(2);
            let y = (two * x * Jet::constant(m)).min(&Jet::half_pi_squared());
            two * x * y.versine_ratio()
        }
    };
    negative.exp() - cos_n_jet(t, m)
}

/// sup over θ in [0, π/2] and every real n of the range (n ≥ 16) of |cosⁿθ - Gaussian|; `at` is
/// (1/n, x).
///
/// Either Gaussian lies above cosⁿθ, and cosⁿθ at fixed x falls in m: ln(1 - x m)/m =
/// -(x + x² m/2 + …) and ln cos √y/y = -(1/2 + y/12 + …) have negative coefficients only. So the
/// distance rises with m, and a box is bounded at its largest and smallest m. For the same reason
/// the supremum over θ falls with n, for every real n.
pub fn gaussian_distance(kind: Gaussian, n: Interval, tolerance: f64) -> Supremum<2> {
    let domain = [reciprocal(n), Interval::new(0.0, FAR)];
    let cell = |[m, x]: &[Interval; 2]| {
        let at = |m: f64| range(|x| distance(kind, x, Interval::from(m)), *x);
        Interval::new(at(m.lo()).lo(), at(m.hi()).hi())
    };
    let found = supremum(cell, domain, tolerance, MOST_BOXES);
    let tail = Interval::from(-FAR).exp().hi();
    Supremum { value: Interval::new(found.value.lo(), found.value.hi().max(tail)), ..found }
}

/// sup over t ≥ 0 of |e^-t - (1 - t/K)^K₊|; `at` is t.
///
/// ```
/// use bellfit::bound::bell_distance;
/// let k16 = bell_distance(16, 1e-8);
/// assert!(k16.value.lo() > 1.7e-2 && k16.value.hi() < 1.8e-2);
/// ```
pub fn bell_distance(power: u32, tolerance: f64) -> Supremum<1> {
    let k = Jet::int(i64::from(power));
    // The bell lies below e^-t (Lyon; 1 - x ≤ e^-x to the power K), so the distance has one sign.
    let distance = |t: Jet| {
        let base = Jet::int(1) - t / k;
        let clamped = if base.value.hi() <= 0.0 {
            Jet::int(0)
        } else if base.value.lo() >= 0.0 {
            base
        } else {
            let value = Interval::new(0.0, base.value.hi());
            Jet { value, slope: base.slope.hull(Interval::from(0.0)) }
        };
        (Jet::int(0) - t).exp() - clamped.power(power)
    };
    let f = |[t]: &[Interval; 1]| range(distance, *t);
    // From t = 40 on both lie between 0 and e^-40.
    let found = supremum(f, [Interval::new(0.0, 40.0)], tolerance, MOST_BOXES);
    let tail = Interval::from(-40.0).exp().hi();
    Supremum { value: Interval::new(found.value.lo(), found.value.hi().max(tail)), ..found }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cosine_gaussian_misses_cos_16_by_lyons_distance() {
        // At n = 16 cosⁿθ is the bell (1 - t/16)^16 itself.
        let gauss = gaussian_distance(Gaussian::Cosine, Interval::from(16.0), 1e-7);
        let bell = bell_distance(16, 1e-7);
        assert!(!gauss.value.is_disjoint(bell.value), "{gauss:?} {bell:?}");
    }

    #[test]
    fn a_gaussian_is_called_by_its_argument() {
        for kind in Gaussian::ALL {
            let (formula, in_angle) = (kind.formula(), kind == Gaussian::Angle);
            assert!(formula.starts_with("e^(-n") && formula.contains("θ²") == in_angle);
            assert!(formula.contains("cos θ") != in_angle && kind.id().ends_with("angle") == in_angle);
        }
    }

    /// By the angle on a grid: |e^(-n θ²/2) - cosⁿ θ| and |e^(-n (1 - cos θ)) - cosⁿ θ|, largest at the least n.
    #[test]
    fn distances_are_those_of_a_grid() {
        for kind in Gaussian::ALL {
            for n in [16.0, 40.0] {
                let at = |theta: f64| {
                    let versine = 2.0 * libm::pow(libm::sin(0.5 * theta), 2.0);
                    let exponent = if kind == Gaussian::Angle { 0.5 * theta * theta } else { versine };
                    libm::exp(-n * exponent) - libm::exp(n * libm::log1p(-versine))
                };
                let best = (0..10_000).map(|i| at(1.5 * f64::from(i) * 1e-4).abs()).fold(0.0, f64::max);
                let found = gaussian_distance(kind, Interval::from(n), 1e-6);
                let name = format!("{kind:?} {n}: {found:?} {best:e}");
                assert!(found.value.hi() >= best && found.value.lo() <= best + 1e-6, "{name}");
                assert!(found.value.width() < 1.1e-6 && (found.at[0] * n - 1.0).abs() < 1e-15, "{name}");
                let x = found.at[1] / n;
                let theta = if kind == Gaussian::Angle {
                    libm::sqrt(2.0 * x)
                } else {
                    2.0 * libm::asin(libm::sqrt(0.5 * x))
                };
                assert!((at(theta) - best).abs() < 1e-5, "{name}");
            }
        }
        for power in [1, 2, 5] {
            let k = f64::from(power);
            let at = |t: f64| libm::exp(-t) - libm::pow((1.0 - t / k).max(0.0), k);
            let best = (0..20_000).map(|i| at(f64::from(i) * 1e-3).abs()).fold(0.0, f64::max);
            let found = bell_distance(power, 1e-7);
            assert!(found.value.hi() >= best && found.value.lo() <= best + 1e-6, "{power}: {found:?} {best}");
            assert!(
                found.value.width() < 2e-7 && (at(found.at[0]) - best).abs() < 1e-6,
                "{power}: {found:?}"
            );
        }
    }
}
