//! The albedo by quadrature in both dimensions, from vectors.

use super::panels::{over_lobe, panel};
use super::{AlbedoError, Profile, Reflectance, check, scaled};
use crate::integral::Estimate;
use crate::kernel::vector::{Vec3, add, dot, reflect, scale};
use core::f64::consts::{FRAC_PI_2, PI};

/// What a panel may be off by, over w and over the azimuth, for a lobe of unit height in t = n w.
const TARGET: (f64, f64) = (1e-9, 1e-11);

/// Halvings that put the horizon within rounding of its azimuth.
const HALVINGS: u32 = 52;

/// [`directional_albedo`](super::directional_albedo) by plain quadrature, over w and over the azimuth for
/// each w: for checking, as it takes some thousand times as long.
///
/// The integrand is [`Reflectance::value`] at vectors. No formula tells where anything changes: the
/// azimuth at which L meets the horizon is bisected, and both integrals halve their way to every kink.
///
/// - Domain: θ in [0, π/2), as V at π/2 is not above the surface.
/// - Accuracy: the estimate's error counts the outer integral alone. With the inner ones a few 1e-9 of the
///   albedo up to 89°, found by comparison; V-cavities, whose kinks sharpen at grazing angles, 1e-6 at
///   89.9999°.
///
/// # Errors
/// As [`directional_albedo`](super::directional_albedo), and for θ = π/2.
///
/// ```
/// use bellfit::integral::albedo::{Profile, Reflectance, directional_albedo, directional_albedo_plain};
/// use bellfit::kernel::lobe::cs_versine;
/// let lobe = |w| cs_versine::<16, f64>(w, 64.0);
/// let lobe = Profile::new(&lobe, 0.25, 64.0)?;
/// let plain = directional_albedo_plain(Reflectance::BlinnPhongModified, &lobe, 3.0, 1.0)?;
/// let found = directional_albedo(Reflectance::BlinnPhongModified, &lobe, 3.0, 1.0)?;
/// assert!((plain.value - found.value).abs() < 1e-7 * found.value);
/// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
/// ```
pub fn directional_albedo_plain(
    of: Reflectance,
    lobe: &Profile<'_>,
    factor: f64,
    theta: f64,
) -> Result<Estimate, AlbedoError> {
    check(factor, theta)?;
    if theta >= FRAC_PI_2 {
        return Err(AlbedoError::Angle(theta));
    }
    // The vectors' integrand has the lobe in it already.
    let flat = |_: f64| 1.0;
    let everywhere = Profile::new(&flat, lobe.support(), lobe.n())?;
    let around = |w: f64| {
        let place = Place::new(of, theta, w);
        let horizon = place.horizon();
        let density = |azimuth: f64| place.density(of, lobe, azimuth);
        let parts = [(0.0, horizon), (horizon, PI)].map(|part| panel(&density, part, TARGET.1).value);
        2.0 * (parts[0] + parts[1])
    };
    Ok(scaled(over_lobe(&everywhere, of.end(), &[], TARGET.0, &around), factor / lobe.n()))
}

/// The circle of directions at 1 - cos = w from the lobe's axis.
struct Place {
    mirror: bool,
    to_view: Vec3<f64>,
    /// The circle's centre and its radii in and across the plane of incidence.
    circle: [Vec3<f64>; 3],
}

impl Place {
    fn new(of: Reflectance, theta: f64, w: f64) -> Self {
        let mirror = of.is_about_mirror();
        let (s, c) = (libm::sin(theta), libm::cos(theta));
        let radius = libm::sqrt(w * (2.0 - w));
        let (axis, across) =
            if mirror { ([s, 0.0, c], [c, 0.0, -s]) } else { ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]) };
        let to_view = if mirror { [-s, 0.0, c] } else { [s, 0.0, c] };
        let circle = [scale(1.0 - w, axis), scale(radius, across), [0.0, radius, 0.0]];
        Place { mirror, to_view, circle }
    }

    /// L, and dω/(dw dφ).
    fn light(&self, azimuth: f64) -> (Vec3<f64>, f64) {
        let [centre, x, y] = self.circle;
        let on_circle = add(centre, add(scale(libm::cos(azimuth), x), scale(libm::sin(azimuth), y)));
        if self.mirror {
            return (on_circle, 1.0);
        }
        // H is on the circle; dω = 4 (V·H) dω_h.
        (reflect(self.to_view, on_circle), 4.0 * dot(self.to_view, on_circle).max(0.0))
    }

    /// The azimuth in [0, π] at which L crosses the horizon; 0 where it never does.
    fn horizon(&self) -> f64 {
        let above = |azimuth: f64| self.light(azimuth).0[2] > 0.0;
        let (mut low, mut high) = (0.0, PI);
        let start = above(low);
        if start == above(high) {
            return 0.0;
        }
        for _ in 0..HALVINGS {
            let mid = 0.5 * (low + high);
            if above(mid) == start { low = mid } else { high = mid }
        }
        0.5 * (low + high)
    }

    /// f_r (N·L) dω/(dw dφ), less the factor.
    fn density(&self, of: Reflectance, lobe: &Profile<'_>, azimuth: f64) -> f64 {
        let (to_light, stretch) = self.light(azimuth);
        if to_light[2] <= 0.0 {
            return 0.0;
        }
        of.value(lobe, 1.0, to_light, self.to_view) * to_light[2] * stretch
    }
}
