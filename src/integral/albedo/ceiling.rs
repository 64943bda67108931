//! The largest albedo over all angles: what it is at most, by theorem, and what it reaches.

use super::{AlbedoError, DirectionalAlbedo, Profile, Reflectance, TARGET, check, directional_albedo};
use super::{over_lobe, scaled};
use crate::integral::Estimate;
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

/// What says that no angle has a larger albedo.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SupremumEvidence {
    /// A theorem: the value reaches the [`ceiling`] to within their errors.
    Bounded,
    /// A grid of angles and a search around the best; the ceiling is higher.
    Sampled,
}

impl SupremumEvidence {
    /// The kind of evidence in tables: where a theorem names the angle, the value there is an estimate.
    pub const fn id(self) -> &'static str {
        match self {
            SupremumEvidence::Bounded => "estimated",
            SupremumEvidence::Sampled => "sampled",
        }
    }
}

/// The largest albedo over θ in [0, π/2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supremum {
    /// Where it is reached; at π/2, the limit from below.
    pub at: DirectionalAlbedo,
    /// What no angle exceeds.
    pub ceiling: Estimate,
    /// Which of the two settles it.
    pub evidence: SupremumEvidence,
}

/// What no directional albedo exceeds at any angle.
///
/// Each line is a theorem for a lobe of [`Profile`]'s shape; its integral is estimated.
///
/// **Reflectances**: a(0). As it never rises, the lobe is a sum of level sets "closer to the axis than
/// α"; let S(θ) be the directions L above the horizon that belong to one. S(0) is a cap about N, or the
/// hemisphere, and no S(θ) has a larger solid angle |S(θ)|. As 1 and N·L do not rise away from N, among all
/// sets of at most that solid angle S(0) has the largest integral of either. That |S(θ)| ≤ |S(0)|:
/// - Phong: S(θ) is what the horizon leaves of a cap; |S(0)| is the cap's solid angle, or 2π.
/// - Blinn-Phong: |S(0)| = 2π for α ≥ π/4. Below, |S(θ)| ≤ ∫ 4 max(V·H, 0) dω_h over the cap of H. On its
///   circles V·H = a + b cos φ, a = cos α cos θ, b = sin α sin θ, and by Cauchy and Schwarz
///   ∫ max(V·H, 0) dφ ≤ √(2π ∫ (V·H)² dφ) = 2π √(a² + b²/2) ≤ 2π max(cos α, sin α/√2) = 2π cos α, which
///   integrates to 4π sin²α = |S(0)|.
///
/// **Heightfield, printed**: a(0). By cos φ₁ = -cot θ cot 2α the azimuths that count at α and at π/2 - α
/// add up to a full circle for every θ. The weights lobe · cos α sin α of the two differ by the lobe alone,
/// which is no less at the smaller angle, and at θ = 0 that one has the whole circle.
///
/// **NDF, printed**: the same with the weights lobe · sin α, so at most 2π coef ∫ max over the pairs, α up
/// to π/4: it is a(0) for lobes that are no wider than a cosine, lobe(s) c ≤ lobe(c) s for s ≤ c.
///
/// **Microfacet**: ∫ D cos α dω_h, which is 1 for a heightfield that is normalised. G is at most V's own
/// masking G₁ = min(1, 2 N·H N·V/V·H); H and its mirror image H' about N have V·H + V·H' = 2 N·H N·V, so
/// G₁ max(V·H, 0) and its like at H' add up to 2 N·H N·V, and ∫ D G₁ max(V·H, 0) dω_h = N·V ∫ D cos α dω_h
/// (Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 2014, where that
/// identity defines a consistent G₁). At grazing angles the bound is reached.
///
/// # Errors
/// [`AlbedoError::Factor`] outside its domain.
///
/// ```
/// use bellfit::integral::albedo::{Profile, Reflectance, ceiling};
/// use bellfit::kernel::{factor::cos_n_factor, lobe::cos_n_versine, model::Model};
/// let n = 64.0;
/// let lobe = |w| cos_n_versine(w, n);
/// let lobe = Profile::new(&lobe, 1.0, n)?;
/// let furnace = ceiling(Reflectance::HeightfieldMicrofacet, &lobe, cos_n_factor(Model::BlinnPhongHeightfield, n))?;
/// assert!((furnace.value - 1.0).abs() < 1e-12);
/// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
/// ```
pub fn ceiling(of: Reflectance, lobe: &Profile<'_>, factor: f64) -> Result<Estimate, AlbedoError> {
    check(factor, 0.0)?;
    let over = |end: f64, weight: &dyn Fn(f64) -> f64| {
        scaled(over_lobe(lobe, end, &[], TARGET, weight), factor / lobe.n())
    };
    match of {
        Reflectance::NdfMicrofacet | Reflectance::HeightfieldMicrofacet => {
            Ok(over(of.end(), &|w| 2.0 * PI * (1.0 - w)))
        }
        Reflectance::Ndf => {
            // The larger weight of a pair in terms of the nearer one's, where that is not 0.
            let larger = |w: f64| {
                let (near, sine) = (lobe.at(w), libm::sqrt(w * (2.0 - w)));
                if near > 0.0 { (lobe.at(1.0 - sine) / near * (1.0 - w) / sine).max(1.0) } else { 1.0 }
            };
            Ok(over(1.0 - FRAC_1_SQRT_2, &|w| 2.0 * PI * larger(w)))
        }
        _ => directional_albedo(of, lobe, factor, 0.0),
    }
}

/// Sections of the two degrees around the best, each by the golden ratio: to 1e-5 of a degree.
const SECTIONS: u32 = 24;

/// The largest albedo over all angles of incidence, with its angle.
///
/// If one end of the quarter circle reaches the [`ceiling`] to within the errors, that is it; ties go to
/// θ = 0. If not, every whole degree is looked at and the best is refined by golden section.
///
/// # Errors
/// [`AlbedoError::Factor`] outside its domain.
///
/// ```
/// use bellfit::integral::albedo::{Profile, Reflectance, SupremumEvidence, supremum_over_angles};
/// use bellfit::kernel::{factor::cos_n_factor, lobe::cos_n_versine, model::Model};
/// let n = 64.0;
/// let lobe = |w| cos_n_versine(w, n);
/// let lobe = Profile::new(&lobe, 1.0, n)?;
/// let found = supremum_over_angles(Reflectance::PhongModified, &lobe, cos_n_factor(Model::PhongModified, n))?;
/// assert_eq!((found.at.angle, found.evidence), (0.0, SupremumEvidence::Bounded));
/// assert!((found.at.value.value - 1.0).abs() < 1e-12);
/// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
/// ```
pub fn supremum_over_angles(
    of: Reflectance,
    lobe: &Profile<'_>,
    factor: f64,
) -> Result<Supremum, AlbedoError> {
    let ceiling = ceiling(of, lobe, factor)?;
    let albedo =
        |angle: f64| Ok(DirectionalAlbedo { angle, value: directional_albedo(of, lobe, factor, angle)? });
    let ends = [albedo(0.0)?, albedo(FRAC_PI_2)?];
    for at in ends {
        if at.value.value + at.value.error + ceiling.error >= ceiling.value {
            return Ok(Supremum { at, ceiling, evidence: SupremumEvidence::Bounded });
        }
    }
    let degree = |k: u32| FRAC_PI_2 * (f64::from(k) / 90.0);
    let (mut best, mut at) = (0, ends[0]);
    for k in 1..=90 {
        let next = albedo(degree(k))?;
        if exceeds(&next, &at) {
            (best, at) = (k, next);
        }
    }
    let (mut low, mut high) = (degree(best.max(1) - 1), degree((best + 1).min(90)));
    let golden = 0.5 * (libm::sqrt(5.0) - 1.0);
    for _ in 0..SECTIONS {
        let step = golden * (high - low);
        let (left, right) = (albedo(high - step)?, albedo(low + step)?);
        if right.value.value > left.value.value {
            low = left.angle;
        } else {
            high = right.angle;
        }
        for next in [left, right] {
            if exceeds(&next, &at) {
                at = next;
            }
        }
    }
    Ok(Supremum { at, ceiling, evidence: SupremumEvidence::Sampled })
}

/// By more than both can be off, so that ties go to the first seen.
fn exceeds(next: &DirectionalAlbedo, at: &DirectionalAlbedo) -> bool {
    next.value.value - next.value.error > at.value.value + at.value.error
}
