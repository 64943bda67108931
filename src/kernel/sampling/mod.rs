//! Importance sampling of the six models: a direction to the light for a pair of uniform numbers, and
//! its probability density per solid angle.
//!
//! [`sample`] draws the lobe's own angle about the lobe's own axis and returns L; [`pdf`] is the density
//! of what it returns. A [`Density`] says what the own angle γ follows, c = cos γ > 0:
//!
//! | model | axis | density about it | weight, up to a constant |
//! |---|---|---|---|
//! | `phong` | R, the mirror of V | f(c) dω | 1 |
//! | `phong-modified` | R | f(c) dω | N·L ≤ 1 |
//! | `blinn-phong` | N, for H | f(c) c dω_h | V·H/N·H < 2/N·V |
//! | `blinn-phong-modified` | N, for H | f(c) c dω_h | (N·L)(V·H)/N·H < 2 |
//! | `blinn-phong-ndf` | N, for H | f(c) dω_h | G (V·H)/N·V ≤ 1/N·V |
//! | `blinn-phong-heightfield` | N, for H | f(c) c dω_h | G (V·H)/((N·V)(N·H)) < 2/(N·V)² |
//!
//! The weight is what a renderer averages: the light's share coef f (with N·L where the model is
//! modified, D G/(4 N·V) with D = coef f and a shadowing G ≤ 1 for the two distributions of normals) over
//! the pdf. The bounds hold for every L above the horizon, as 0 < N·L = 2 (V·H)(N·H) - N·V keeps N·H
//! above N·V/(2 V·H). Along the normal c dω_h is dω/4, and the weight of `blinn-phong` constant.
//! `phong-modified` does not take f(c) c: aslant its weight N·L/c is unbounded, and of infinite variance
//! at n = 0.
//!
//! What is covered: the pdf is positive wherever N·V > 0, N·L > 0 and the lobe is positive at c > 0. A lobe
//! counts as 0 at c ≤ 0, as the integrals of Table 1 stop there; of the bells that cuts those with n < K.
//! An L below the horizon (N·L ≤ 0) may be drawn, and is returned as `None`: a sample of weight 0 that
//! still counts in the mean. So the pdf integrates to the probability of staying above, at most 1.
//!
//! Another lobe, such as a bell that is nearer to cosⁿ, is sampled with [`Profile::CosN`]: the weight gains
//! the factor (its value)/cosⁿ, which is bounded if its support ends before c = 0, and at most 1 for
//! (1 - t/K)ᴷ with K ≤ n. For the [cubic lobes](super::cubic) with n ≥ 16 it is at most 1.33, 1.03 and 1.03
//! (K = 2, 4, 8; sampled).
//!
//! Accuracies are in units of ε = 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`), and sampled: against values proved to 20
//! digits for n up to 10⁶, and in `f32` against `f64` at 2·10⁷ arguments with n from 10⁻³ to 10⁴.
//!
//! ```
//! use bellfit::kernel::sampling::{Profile, pdf, sample};
//! use bellfit::kernel::{factor::cs_16_factor, lobe::cs_16, model::Model, vector::{dot, half_vector}};
//! let (model, profile, n, normal) = (Model::BlinnPhong, Profile::Cs16, 64.0_f64, [0.0, 0.0, 1.0]);
//! let to_view = normal;
//! // Reflected share of uniform light, ∫ coef f dω, from 8 × 8 strata.
//! let mut sum = 0.0;
//! for i in 0..64 {
//!     let (u1, u2) = (((i / 8) as f64 + 0.5) / 8.0, ((i % 8) as f64 + 0.5) / 8.0);
//!     let Some(to_light) = sample(model, profile, n, normal, to_view, u1, u2) else { continue };
//!     let half = half_vector(to_light, to_view).unwrap();
//!     let share = cs_16_factor(model).at(n) * cs_16(dot(normal, half), n);
//!     sum += share / pdf(model, profile, n, normal, to_view, to_light);
//! }
//! assert!((sum / 64.0 - 1.0).abs() < 1e-3); // the factor normalises it to 1 within 9.953e-4
//! ```

mod density;
mod direction;
mod versine;

pub use density::{Density, Measure, Profile, peak, radial_pdf};
pub use direction::{direction_about, pdf, sample};
pub use versine::sample_versine;
