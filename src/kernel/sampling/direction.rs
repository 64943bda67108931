//! Directions to the light: the own angle and an azimuth about the model's axis, mirrored at H where the
//! axis is the normal's.

use super::density::{Density, Profile, is_exponent, radial_pdf};
use super::versine::sample_versine;
use crate::kernel::model::Model;
use crate::kernel::real::Real;
use crate::kernel::vector::{Vec3, add, basis, dot, half_vector, reflect, scale, versine_between};

/// Whether the model's lobe is about the half vector rather than the mirror direction.
#[inline]
const fn takes_half_vector(model: Model) -> bool {
    match model {
        Model::Phong | Model::PhongModified => false,
        Model::BlinnPhong
        | Model::BlinnPhongModified
        | Model::BlinnPhongNdf
        | Model::BlinnPhongHeightfield => true,
    }
}

/// The unit vector at a given versine w = 1 - cos γ from an axis, its azimuth a fraction of a turn.
///
/// (1 - w) axis + √(w (2 - w)) (cos 2πu t + sin 2πu s), (t, s) the axis's [`basis`].
///
/// - Domain: a unit axis, w in [0, 2], any finite u. w outside and NaN: NaN. Neither the axis nor the
///   result is normalised.
/// - Accuracy: sin γ comes from w, so that a small angle keeps its digits until it is added to the axis,
///   where every component rounds by up to ε; ε as on the [module's page](super).
/// - Cost: 1 square root, 1 sine, 1 cosine, [`basis`], about 20 multiplications and additions.
///
/// ```
/// use bellfit::kernel::{lobe::versine, sampling::direction_about};
/// let v = direction_about([0.0, 0.0, 1.0], versine(0.5_f64), 0.25);
/// for (got, want) in v.into_iter().zip([0.0, libm::sin(0.5), libm::cos(0.5)]) {
///     assert!((got - want).abs() < 1e-15);
/// }
/// ```
#[inline]
pub fn direction_about<F: Real>(axis: Vec3<F>, versine: F, u: F) -> Vec3<F> {
    let (tangent, side) = basis(axis);
    let sine = (versine * (F::TWO - versine)).sqrt();
    let azimuth = F::TWO * F::PI * u;
    let across = add(scale(sine * azimuth.cos(), tangent), scale(sine * azimuth.sin(), side));
    add(scale(F::ONE - versine, axis), across)
}

/// A unit direction L to the light, drawn for a model and a lobe by two uniform numbers.
///
/// u1 gives the own angle by [`sample_versine`] with [`Density::of`] the model, u2 its azimuth by
/// [`direction_about`]: about R = 2 (N·V) N - V for the Phong models, which makes L itself, about N for
/// the Blinn-Phong models, which makes H and L = 2 (V·H) H - V.
///
/// `None` for L below the horizon, N·L ≤ 0: the sample counts, with weight 0. Source: for cosⁿ about R
/// E. P. Lafortune and Y. D. Willems, report CW 197, K.U. Leuven, 1994.
///
/// - Domain: unit N and V, finite n ≥ 0, u1 and u2 in [0, 1). Outside, for N·V ≤ 0 and for NaN: `None`.
/// - Monotone: the own angle grows with u1, the azimuth with u2.
/// - Rounding may put an L at the lobe's very edge where its [`pdf`] is 0; skip such a sample too.
/// - Cost: [`sample_versine`], [`direction_about`], one [`reflect`] and 2 dot products.
///
/// ```
/// use bellfit::kernel::{model::Model, sampling::{Profile, sample}};
/// let (normal, to_view) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
/// // u1 = 0: on the axis, so the mirror direction for every model.
/// for model in Model::ALL {
///     let to_light = sample(model, Profile::Cs16, 50.0_f64, normal, to_view, 0.0, 0.7).unwrap();
///     assert!((to_light[0] + 0.6).abs() < 1e-15 && (to_light[2] - 0.8).abs() < 1e-15);
/// }
/// assert_eq!(sample(Model::Phong, Profile::Cs16, 50.0, normal, [0.6, 0.0, -0.8], 0.0, 0.7), None);
/// ```
#[inline]
pub fn sample<F: Real>(
    model: Model,
    profile: Profile,
    n: F,
    normal: Vec3<F>,
    to_view: Vec3<F>,
    u1: F,
    u2: F,
) -> Option<Vec3<F>> {
    let versine = sample_versine(Density::of(model, profile), n, u1);
    let seen = dot(normal, to_view) > F::ZERO;
    if !(seen && u2 >= F::ZERO && u2 < F::ONE) || versine.is_nan() {
        return None;
    }
    let to_light = if takes_half_vector(model) {
        // V·H ≤ 0 needs no look of its own: it gives N·L = 2 (V·H)(N·H) - N·V < 0.
        reflect(to_view, direction_about(normal, versine, u2))
    } else {
        direction_about(reflect(to_view, normal), versine, u2)
    };
    (dot(normal, to_light) > F::ZERO).then_some(to_light)
}

/// Density of what [`sample`] returns, per solid angle of L; 0 for L below the horizon.
///
/// Phong models: [`radial_pdf`] about R, at w = |L - R|²/2. Blinn-Phong models: [`radial_pdf`] about N, at
/// w = |H - N|²/2, times dω_h/dω = 1/(4 V·H). Integrates to the share of samples that are not `None`.
///
/// Source of the Jacobian: K. E. Torrance and E. M. Sparrow, "Theory for off-specular reflection from
/// roughened surfaces", 1967; B. Walter et al., "Microfacet models for refraction through rough
/// surfaces", EGSR 2007, its half-direction transform for reflection.
///
/// - Domain: unit N, V, L; finite n ≥ 0; per steradian. N·V ≤ 0 or N·L ≤ 0: 0. Other n and NaN in any
///   argument: NaN.
/// - Accuracy: w carries the vectors' own rounding, relatively a few ε/√w, and the lobe n times its
///   absolute error; the rest is [`radial_pdf`]'s.
/// - Cost: [`radial_pdf`], 3 or 4 dot products, one [`reflect`] or one [`half_vector`] (1 square root,
///   6 divisions).
///
/// ```
/// use bellfit::kernel::{factor::cos_n_factor, model::Model, sampling::{Profile, pdf}};
/// let (n, up, to_light) = (8.0_f64, [0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
/// let phong = pdf(Model::Phong, Profile::CosN, n, up, up, to_light);
/// assert!((phong / (cos_n_factor(Model::Phong, n) * libm::pow(0.8, n)) - 1.0).abs() < 1e-14);
/// // N·H = V·H = √0.9
/// let (h, pi) = (libm::sqrt(0.9), std::f64::consts::PI);
/// let ndf = pdf(Model::BlinnPhongNdf, Profile::CosN, n, up, up, to_light);
/// assert!((ndf / ((n + 1.0) / (2.0 * pi) * libm::pow(h, n) / (4.0 * h)) - 1.0).abs() < 1e-14);
/// ```
#[inline]
pub fn pdf<F: Real>(
    model: Model,
    profile: Profile,
    n: F,
    normal: Vec3<F>,
    to_view: Vec3<F>,
    to_light: Vec3<F>,
) -> F {
    let (n_v, n_l) = (dot(normal, to_view), dot(normal, to_light));
    if n_v.is_nan() || n_l.is_nan() || !is_exponent(n) {
        return F::NAN;
    }
    if n_v <= F::ZERO || n_l <= F::ZERO {
        return F::ZERO;
    }
    let density = Density::of(model, profile);
    if !takes_half_vector(model) {
        return radial_pdf(density, n, versine_between(to_light, reflect(to_view, normal)));
    }
    let Some(half) = half_vector(to_light, to_view) else { return F::NAN };
    radial_pdf(density, n, versine_between(half, normal)) / (F::from_u32(4) * dot(to_view, half))
}
