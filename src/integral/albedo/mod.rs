//! Energy at every angle: the directional albedo a(θ) of a lobe with its factor, V at θ from the normal.
//!
//! a(θ) = ∫ f_r(L, V) (N·L) dω over the hemisphere of L, with f_r by [`Reflectance`]. The conditions of
//! Table 1 look along the normal, or at no direction at all; light that grazes is another matter.
//!
//! This is what V sees of a surface in a furnace, light 1 from everywhere. Of a beam from L the surface
//! reflects ∫ f_r(L, V) (N·V) dω over V: the same number where f_r is reciprocal
//! ([`Reflectance::is_reciprocal`]). Phong's and Blinn-Phong's are not: by the same factor and lobe that share
//! is the modified model's a(θ) over cos θ, and beyond every bound at grazing light.
//!
//! The lobe is narrow and the hemisphere wide, so the integral runs about the lobe's own axis: over
//! w = 1 - cos of its own angle, numerically, and over the azimuth, in closed form. A second route,
//! [`directional_albedo_plain`], takes both numerically, from vectors alone.

mod azimuth;
mod ceiling;
mod curve;
mod panels;
mod plain;
mod profile;
mod reflectance;

pub use ceiling::{Supremum, SupremumEvidence, ceiling, supremum_over_angles};
pub use curve::{AlbedoCurve, AlbedoSubject, Factor, Shape, albedo_curves};
pub use plain::directional_albedo_plain;
pub use profile::{AlbedoError, Profile};
pub use reflectance::{Reflectance, Usage};

use super::Estimate;
use azimuth::Incidence;
use core::f64::consts::FRAC_PI_2;
use panels::over_lobe;

/// What a panel may be off by, for a lobe of unit height in t = n w.
const TARGET: f64 = 1e-13;

/// An albedo with the angle it is seen from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalAlbedo {
    /// θ, from the normal, in radians.
    pub angle: f64,
    /// a(θ).
    pub value: Estimate,
}

/// a(θ) = ∫ f_r(L, V) (N·L) dω, V at θ from the normal.
///
/// = coef ∫ lobe(w) A(w, θ) dw with the azimuth's integral A in closed form; the rest by Gauss-Legendre
/// in panels that end where A has a kink. At θ = π/2 a microfacet model's albedo is its limit from
/// below, coef ∫ lobe cos α dω_h.
///
/// Source: the integral is the lobe paper's law ∫ f_r cos θ dω ≤ 1; the readings are [`Reflectance`]'s.
///
/// - Domain: θ in [0, π/2], in radians; `factor` ≥ 0, per steradian.
/// - Accuracy: the estimate's own error, about 1e-12 of the albedo; estimated, from two orders.
///
/// # Errors
/// [`AlbedoError`] for an angle or factor outside its domain, NaN among them.
///
/// ```
/// use bellfit::integral::albedo::{Profile, Reflectance, directional_albedo};
/// use bellfit::kernel::{factor::cos_n_factor, lobe::cos_n_versine, model::Model};
/// use std::f64::consts::FRAC_PI_2;
/// let n = 64.0;
/// let lobe = |w| cos_n_versine(w, n);
/// let lobe = Profile::new(&lobe, 1.0, n)?;
/// let albedo = |theta| directional_albedo(Reflectance::Phong, &lobe, cos_n_factor(Model::Phong, n), theta);
/// assert!((albedo(0.0)?.value - 1.0).abs() < 1e-12);
/// assert!((albedo(FRAC_PI_2)?.value - 0.5).abs() < 1e-12); // half of the lobe is below the horizon
/// assert!(albedo(-0.1).is_err());
/// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
/// ```
pub fn directional_albedo(
    of: Reflectance,
    lobe: &Profile<'_>,
    factor: f64,
    theta: f64,
) -> Result<Estimate, AlbedoError> {
    check(factor, theta)?;
    let incidence = Incidence::new(theta);
    let integral = over_lobe(lobe, of.end(), &of.kinks(theta), TARGET, &|w| of.azimuth(&incidence, w));
    Ok(scaled(integral, factor / lobe.n()))
}

impl Reflectance {
    /// The end of the integral in w: half vectors and normals stay above the surface.
    fn end(self) -> f64 {
        if self.is_about_mirror() { 2.0 } else { 1.0 }
    }
}

fn check(factor: f64, theta: f64) -> Result<(), AlbedoError> {
    if !(factor >= 0.0 && factor.is_finite()) {
        return Err(AlbedoError::Factor(factor));
    }
    if (0.0..=FRAC_PI_2).contains(&theta) { Ok(()) } else { Err(AlbedoError::Angle(theta)) }
}

fn scaled(of: Estimate, by: f64) -> Estimate {
    Estimate { value: of.value * by, error: of.error * by, ..of }
}
