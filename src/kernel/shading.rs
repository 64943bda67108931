//! Phong's shading model with Lambert's diffuse term.

use super::lobe::cos_n;
use super::real::Real;
use super::vector::{Vec3, dot, reflect};

/// Coefficients of the shading model, for one colour channel.
///
/// Source: the lobe paper, its shading model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhongLambert<F> {
    /// k_a, share of the ambient light.
    pub ambient: F,
    /// k_d, Lambert's share.
    pub diffuse: F,
    /// k_s, the lobe's share; a normalising factor, if wanted, is multiplied in here.
    pub specular: F,
    /// n, specular exponent.
    pub n: F,
}

/// Light leaving a surface towards V, for one colour channel, with the lobe cosⁿ.
///
/// I_a k_a + I (k_d (N·L) + k_s (R·V)ⁿ), R = 2 (L·N) N - L; `ambient_light` is I_a, `light` is I.
///
/// Source: the lobe paper, its shading model, which prints no clamp. Here a negative dot product counts
/// as 0, and with N·L ≤ 0 there is neither a diffuse nor a specular term: only I_a k_a is left.
///
/// Domain: unit vectors L, V, N; everything else is used as it is. A NaN in N·L, R·V or a factor of a
/// term that counts gives NaN. n as in [`cos_n`].
///
/// ```
/// use bellfit::kernel::shading::{PhongLambert, phong_lambert};
/// let m = PhongLambert { ambient: 0.1_f64, diffuse: 0.5, specular: 0.25, n: 2.0 };
/// let (up, slant, mirror) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// let i = phong_lambert(m, 0.3, 2.0, up, slant, mirror);
/// let (n_l, r_v) = (0.8, 1.0);
/// assert!((i - (0.1 * 0.3 + 2.0 * (0.5 * n_l + 0.25 * r_v * r_v))).abs() < 1e-15);
/// ```
#[inline]
pub fn phong_lambert<F: Real>(
    material: PhongLambert<F>,
    ambient_light: F,
    light: F,
    normal: Vec3<F>,
    to_light: Vec3<F>,
    to_view: Vec3<F>,
) -> F {
    phong_lambert_with(material, ambient_light, light, normal, to_light, to_view, cos_n)
}

/// [`phong_lambert`] with any lobe, called as `lobe(max(R·V, 0), n)`.
///
/// I_a k_a + I (k_d (N·L) + k_s f(R·V, n)). Source, clamps and domain as there; a lobe that is not 0 at
/// a zero cosine, such as cs_16 with n < 16, shines behind the mirror direction too.
///
/// ```
/// use bellfit::kernel::{lobe::cs_16, shading::{PhongLambert, phong_lambert_with}};
/// let m = PhongLambert { ambient: 0.0_f64, diffuse: 0.0, specular: 1.0, n: 32.0 };
/// let (up, slant) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
/// let i = phong_lambert_with(m, 0.0, 2.0, up, slant, up, cs_16);
/// assert_eq!(i, 2.0 * cs_16(0.8, 32.0)); // R·V = 0.8
/// ```
#[inline]
pub fn phong_lambert_with<F: Real>(
    material: PhongLambert<F>,
    ambient_light: F,
    light: F,
    normal: Vec3<F>,
    to_light: Vec3<F>,
    to_view: Vec3<F>,
    lobe: impl FnOnce(F, F) -> F,
) -> F {
    let ambient = ambient_light * material.ambient;
    let n_l = dot(normal, to_light);
    if n_l <= F::ZERO {
        return ambient;
    }
    let r_v = dot(reflect(to_light, normal), to_view).max(F::ZERO);
    ambient + light * (material.diffuse * n_l + material.specular * lobe(r_v, material.n))
}
