//! Pixels of revolution, of base diameter 1 and volume 1, by their volume beyond a line.

use crate::fit::digits::round_to;
use crate::integral::GaussLegendre;
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

/// What the pixel's bell may be, r its distance from the centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClipTarget {
    /// e^(-r²/(2σ²)), not cut, by 1/σ: the volume is ½ erfc(d/(σ√2)).
    Gaussian(f64),
    /// The same cut at r = ½ and normalised again.
    GaussianCut(u32),
    /// 1 - 2r.
    Cone,
    /// (1 - 4r²)^k; k = 0 is the uniform disk.
    Parabola(u32),
}

impl ClipTarget {
    /// The pixels that are compared, in the table's order.
    pub const ALL: [ClipTarget; 11] = [
        ClipTarget::Gaussian(6.0),
        ClipTarget::Gaussian(5.0),
        ClipTarget::Gaussian(4.0),
        ClipTarget::GaussianCut(6),
        ClipTarget::GaussianCut(5),
        ClipTarget::GaussianCut(4),
        ClipTarget::Parabola(0),
        ClipTarget::Cone,
        ClipTarget::Parabola(1),
        ClipTarget::Parabola(2),
        ClipTarget::Parabola(8),
    ];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            ClipTarget::Gaussian(_) => "gaussian",
            ClipTarget::GaussianCut(_) => "gaussian-cut",
            ClipTarget::Cone => "cone",
            ClipTarget::Parabola(0) => "disk",
            ClipTarget::Parabola(1) => "parabola-1",
            ClipTarget::Parabola(2) => "parabola-2",
            ClipTarget::Parabola(8) => "parabola-8",
            ClipTarget::Parabola(_) => "parabola",
        }
    }

    /// σ, for those that have one: the shorter decimal where two give the same 1/σ.
    pub fn sigma(self) -> Option<f64> {
        let s = match self {
            ClipTarget::Gaussian(s) => s,
            ClipTarget::GaussianCut(m) => f64::from(m),
            ClipTarget::Cone | ClipTarget::Parabola(_) => return None,
        };
        let short = round_to(1.0 / s, 8).parse().unwrap_or(f64::NAN);
        Some(if 1.0 / short == s { short } else { 1.0 / s })
    }
}

/// A target ready to be evaluated.
#[derive(Clone, Debug)]
pub struct ClipPixel {
    /// Which.
    pub target: ClipTarget,
    rule: GaussLegendre,
}

/// Nodes of the cut Gaussian's quadrature: its integrand is entire, and 40 leave 1e-15.
const ORDER: usize = 40;

impl ClipPixel {
    /// Of a target.
    pub fn new(target: ClipTarget) -> Self {
        ClipPixel { target, rule: GaussLegendre::new(ORDER) }
    }

    /// The volume beyond the line at d in [0, ½]: from ½ down to 0, or to the tail of the whole Gaussian.
    ///
    /// With x = 2d and w = √(1 - x²): (1 - 4r²)^k has ½ J_k(x)/J_k(0), J_k = ∫ₓ¹ (1 - t²)^(k+½) dt by its
    /// recursion from arccos x; the cone (arccos x - 2 x w + x³ arcosh(1/x))/π. The cut Gaussian is
    /// ∫_d^½ φ(s/σ)/σ erf(√(¼ - s²)/(σ√2)) ds by quadrature in s = ½ sin t, over its whole, 1 - e^(-1/(8σ²)).
    ///
    /// ```
    /// use bellfit::fit::clip::{ClipPixel, ClipTarget};
    /// let disk = ClipPixel::new(ClipTarget::Parabola(0));
    /// // at half the radius: the segment of 120°
    /// let segment = 1.0 / 3.0 - 3.0_f64.sqrt() / (4.0 * std::f64::consts::PI);
    /// assert!((disk.volume(0.25) - segment).abs() < 1e-15);
    /// ```
    pub fn volume(&self, d: f64) -> f64 {
        let x = (2.0 * d).clamp(0.0, 1.0);
        let square = (1.0 - x) * (1.0 + x);
        let w = libm::sqrt(square);
        match self.target {
            ClipTarget::Gaussian(s) => 0.5 * libm::erfc(d * s * FRAC_1_SQRT_2),
            ClipTarget::GaussianCut(m) => self.cut_gaussian(x, f64::from(m)),
            ClipTarget::Cone => {
                let cubic = if x > 0.0 { x * x * x * libm::log((1.0 + w) / x) } else { 0.0 };
                (libm::acos(x) - 2.0 * x * w + cubic) / PI
            }
            ClipTarget::Parabola(k) => {
                let (mut part, mut whole) = (libm::acos(x), FRAC_PI_2);
                // (1 - x²)^(j+½), j rising from -1.
                let mut power = w;
                for j in 0..=k {
                    let p = f64::from(j) + 0.5;
                    part = (2.0 * p * part - x * power) / (2.0 * p + 1.0);
                    whole = 2.0 * p * whole / (2.0 * p + 1.0);
                    power *= square;
                }
                0.5 * part / whole
            }
        }
    }

    fn cut_gaussian(&self, x: f64, s: f64) -> f64 {
        let marginal = |t: f64| {
            let (along, across) = (0.5 * s * libm::sin(t), 0.5 * s * libm::cos(t));
            across * libm::exp(-0.5 * along * along) * libm::erf(across * FRAC_1_SQRT_2)
        };
        let part = self.rule.integrate(marginal, libm::asin(x), FRAC_PI_2);
        part / (libm::sqrt(2.0 * PI) * -libm::expm1(-0.125 * s * s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume's derivative by d is minus the integral of the bell along the line: trapezia over the bell
    /// itself, which share nothing with the closed forms.
    #[test]
    fn volumes_are_integrals_of_the_bells() {
        for target in ClipTarget::ALL {
            let pixel = ClipPixel::new(target);
            let bell = |r: f64| match target {
                ClipTarget::Gaussian(s) => libm::exp(-0.5 * r * r * s * s),
                ClipTarget::GaussianCut(m) => libm::exp(-0.5 * r * r * f64::from(m * m)),
                ClipTarget::Cone => 1.0 - 2.0 * r,
                ClipTarget::Parabola(k) => libm::pow(1.0 - 4.0 * r * r, f64::from(k)),
            };
            let reach = if matches!(target, ClipTarget::Gaussian(_)) { 3.0 } else { 0.5 };
            // Midpoints of cells over the half plane x > d.
            let cells = 1200;
            let step = reach / f64::from(cells);
            let beyond = |d: f64| {
                let mut sum = 0.0;
                for i in 0..cells {
                    for j in 0..cells {
                        let (x, y) = ((f64::from(i) + 0.5) * step, (f64::from(j) + 0.5) * step);
                        let r = libm::sqrt(x * x + y * y);
                        if x > d && r < reach {
                            sum += bell(r);
                        }
                    }
                }
                sum
            };
            // d on cells' edges.
            let (whole, part) = (beyond(0.0), beyond(80.0 * step));
            let found = pixel.volume(80.0 * step);
            // Cells on the circle are taken whole or not at all.
            assert!((found - 0.5 * part / whole).abs() < 2e-5, "{target:?}: {found} {}", 0.5 * part / whole);
            assert!((pixel.volume(0.0) - 0.5).abs() < 1e-15, "{target:?}");
        }
    }

    #[test]
    fn sigma_is_the_shorter_decimal() {
        assert_eq!(ClipTarget::Gaussian(6.0).sigma(), Some(1.0 / 6.0));
        assert_eq!(ClipTarget::GaussianCut(4).sigma(), Some(0.25));
        // 1/(1/0.22) is 0.21999999999999997.
        assert_eq!(ClipTarget::Gaussian(1.0 / 0.22).sigma(), Some(0.22));
        assert!(ClipTarget::Cone.sigma().is_none() && ClipTarget::Parabola(8).sigma().is_none());
    }
}
