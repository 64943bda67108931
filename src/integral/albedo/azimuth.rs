//! The integral over the azimuth, in closed form.
//!
//! At the angle γ or α from the lobe's axis every integrand is a polynomial in cos φ, or the least of
//! three, cut where L meets the horizon. V lies at θ, φ counts from the plane of incidence, and
//! w = 1 - cos of the lobe's own angle throughout.

use super::Reflectance;
use crate::kernel::lobe::versine;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// What is known of θ alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incidence {
    sin: f64,
    cos: f64,
    /// 1 - sin θ, without its cancellation.
    rest: f64,
}

impl Incidence {
    pub(super) fn new(theta: f64) -> Self {
        let (sin, cos) = (libm::sin(theta), libm::cos(theta));
        Incidence { sin, cos, rest: versine(FRAC_PI_2 - theta) }
    }

    /// φ₁ and sin θ sin γ sin φ₁ for L at γ from the mirror direction, w = 1 - cos γ.
    ///
    /// L_z = cos θ cos γ + sin θ sin γ cos φ > 0 for |φ| < φ₁, cos φ₁ = -cot θ cot γ, and
    /// (sin θ sin γ sin φ₁)² = sin²θ - cos²γ = (w - (1 - sin θ)) (1 + sin θ - w): no cancellation.
    fn above(&self, w: f64) -> (f64, f64) {
        let (past, left) = (w - self.rest, 1.0 + self.sin - w);
        if past <= 0.0 {
            return (PI, 0.0);
        }
        if left <= 0.0 {
            return (0.0, 0.0);
        }
        let across = libm::sqrt(past * left);
        (libm::atan2(across, -self.cos * (1.0 - w)), across)
    }
}

impl Reflectance {
    /// Where the azimuth's range or formula changes, in w: outside (0, end) too, in no order.
    pub(super) fn kinks(self, theta: f64) -> Vec<f64> {
        let rest = FRAC_PI_2 - theta;
        if self.is_about_mirror() {
            // The full circle ends, and the last arc.
            return [rest, FRAC_PI_2 + theta].map(versine).to_vec();
        }
        // The same for L, which lies at 2 α from the mirror direction of V about N.
        let mut angles = vec![0.5 * rest, 0.5 * (FRAC_PI_2 + theta)];
        if self.usage() == super::Usage::Microfacet {
            // Where in the plane of incidence shadowing, or masking, sets in.
            angles.extend([(PI - 2.0 * theta) / 6.0, (PI + 2.0 * theta) / 6.0, theta, rest, FRAC_PI_4]);
        }
        angles.into_iter().map(versine).collect()
    }

    /// ∫ f_r (N·L) dω/(dw dφ) dφ over the azimuths with L above the horizon, less the factor and the lobe.
    ///
    /// | use | integrand | integral over \|φ\| < φ₁ |
    /// |---|---|---|
    /// | Phong | 1 | 2 φ₁ |
    /// | Phong, modified | L_z = p + q cos φ | 2 (p φ₁ + q sin φ₁) |
    /// | Blinn-Phong | 4 d, d = V·H = a + b cos φ | 8 (a φ₁ + b sin φ₁) |
    /// | Blinn-Phong, modified | 4 d L_z, L_z = 2 c d - cos θ | below, by ∫ d and ∫ d² |
    /// | NDF; heightfield | 1; c | 2 φ₁; 2 c φ₁ |
    /// | microfacet | G d/cos θ | [`cavities`] |
    ///
    /// c = cos α, a = c cos θ, b = sin α sin θ, p = cos γ cos θ, q = sin γ sin θ.
    pub(super) fn azimuth(self, of: &Incidence, w: f64) -> f64 {
        let c = 1.0 - w;
        match self {
            Self::Phong => 2.0 * of.above(w).0,
            Self::PhongModified => {
                let (range, across) = of.above(w);
                2.0 * (c * of.cos * range + across)
            }
            Self::NdfMicrofacet | Self::HeightfieldMicrofacet => cavities(of.sin / of.cos, w),
            _ if c <= 0.0 => 0.0,
            _ => {
                // L lies at 2 α: 1 - cos 2α = 2 sin²α = 2 w (2 - w).
                let (range, across) = of.above(2.0 * w * (2.0 - w));
                // across = sin θ sin 2α sin φ₁ = 2 c b sin φ₁
                let (a, b_sin) = (c * of.cos, across / (2.0 * c));
                let first = 2.0 * (a * range + b_sin);
                match self {
                    Self::Ndf => 2.0 * range,
                    Self::Heightfield => 2.0 * c * range,
                    Self::BlinnPhong => 4.0 * first,
                    _ => {
                        // ∫ d² = 2 (a² φ₁ + 2 a b sin φ₁ + b² (φ₁ + sin φ₁ cos φ₁)/2), and where the circle
                        // is cut b cos φ₁ is d - a at the horizon, d = cos θ/(2 c).
                        let b2 = w * (2.0 - w) * of.sin * of.sin;
                        let at_end = of.cos / (2.0 * c) - a;
                        let second =
                            2.0 * (a * a * range + 2.0 * a * b_sin + 0.5 * (b2 * range + b_sin * at_end));
                        8.0 * c * second - 4.0 * of.cos * first
                    }
                }
            }
        }
    }
}

/// ∫ G (V·H)/(N·V) dφ for V-cavities.
///
/// With u = V·H/N·V = c + b cos φ, b = sin α tan θ, and L_z = (2 c u - 1) N·V the integrand is
/// min(u, 2 c, 2 c (2 c u - 1)), from u = 1/(2 c) on, where L rises above the horizon: three straight
/// lines. The steep one ends at 2 c/(4 c² - 1) and the level one starts at 2 c for α < 45°; beyond, both
/// meet at 1/c. Near grazing b is large and the differences of b sin φ are formed without it.
fn cavities(tan: f64, w: f64) -> f64 {
    let c = 1.0 - w;
    if c <= 0.0 {
        return 0.0;
    }
    let b = libm::sqrt(w * (2.0 - w)) * tan;
    let (shadowed, masked) =
        if 2.0 * c * c > 1.0 { (2.0 * c / (4.0 * c * c - 1.0), 2.0 * c) } else { (1.0 / c, 1.0 / c) };
    if b <= 0.0 {
        return 2.0 * PI * c.min(2.0 * c * (2.0 * c * c - 1.0)).max(0.0);
    }
    // u exceeds a threshold for |φ| < φ: (b cos φ, b sin φ, φ).
    let place = |threshold: f64| {
        let y = (threshold - c).clamp(-b, b);
        let across = libm::sqrt((b - y) * (b + y));
        (y, across, libm::atan2(across, y))
    };
    let [horizon, shadowed, masked] = [0.5 / c, shadowed, masked].map(place);
    // ∫ (level + slope u) dφ between two thresholds.
    let piece = |from: (f64, f64, f64), to: (f64, f64, f64), level: f64, slope: f64| {
        let sum = from.1 + to.1;
        let sines = if sum > 0.0 { (to.0 - from.0) * (to.0 + from.0) / sum } else { 0.0 };
        (level + slope * c) * (from.2 - to.2) + slope * sines
    };
    let steep = piece(horizon, shadowed, -2.0 * c, 4.0 * c * c);
    2.0 * (steep + piece(shadowed, masked, 0.0, 1.0) + 2.0 * c * masked.2)
}
