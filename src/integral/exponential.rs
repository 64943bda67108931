//! Double exponential quadrature in θ, through the kernels a renderer would call.

use super::{Case, Limit, Lobe};
use crate::kernel::lobe;
use crate::kernel::model::{Convention, LobeAngle};
use core::f64::consts::{FRAC_PI_2, PI};

/// A number with an estimate of its error: evidence, not proof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The value found.
    pub value: f64,
    /// The quadrature's own error estimate plus its rounding floor, absolute.
    pub error: f64,
    /// How often the integrand was evaluated.
    pub evaluations: u32,
}

/// The quadrature's target, relative to 1/n, the size of Int(n).
const TARGET: f64 = 1e-14;

/// Int(n) by the `quadrature` crate over θ in [0, limit].
///
/// The integrand is the public kernel times the model's weight, in θ as the lobe paper writes it.
/// Beyond nine standard deviations of the lobe the interval is split, so that the narrow peak is
/// never stepped over.
///
/// ```
/// use bellfit::integral::{double_exponential, Case, Limit, Lobe};
/// use bellfit::kernel::model::Model;
/// let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
/// let found = double_exponential(case, 64.0);
/// assert!((found.value * 65.0 - 1.0).abs() < 1e-13); // 1/(n + 1)
/// ```
pub fn double_exponential(case: Case, n: f64) -> Estimate {
    let own = match case.model.angle() {
        LobeAngle::Full => 1.0,
        LobeAngle::Half => 0.5,
    };
    let limit = match (case.lobe, case.limit) {
        (Lobe::CosN, _) => FRAC_PI_2,
        (Lobe::Cs16, Limit::Paper) => lobe::cut_paper(n),
        (Lobe::Cs16, Limit::Card) => lobe::cut_card(n),
        (Lobe::Cs16, Limit::ExactZero) => lobe::cut_exact(n),
        (Lobe::Cs16, Limit::Support) => lobe::cut_exact(n) / own,
    }
    .min(FRAC_PI_2);
    let value = |psi: f64| match (case.lobe, case.limit) {
        (Lobe::CosN, _) => lobe::cos_n_versine(lobe::versine(psi), n),
        // 6/√n reaches past the zero of (1), where its even power rises again: to the letter.
        (Lobe::Cs16, Limit::Paper) => lobe::cs_16_cut(psi, n, PI),
        (Lobe::Cs16, _) => lobe::cs_versine::<16, f64>(lobe::versine(psi), n),
    };
    let integrand = |theta: f64| {
        let weight = match case.model.convention() {
            Convention::Rdf | Convention::Ndf => 1.0,
            Convention::RdfCosine | Convention::Heightfield => libm::cos(theta),
        };
        value(own * theta) * weight * libm::sin(theta)
    };
    let split = (9.0 / libm::sqrt(n) / own).min(limit);
    let mut total = Estimate { value: 0.0, error: 0.0, evaluations: 0 };
    for (from, to) in [(0.0, split), (split, limit)] {
        if to > from {
            let part = quadrature::integrate(integrand, from, to, TARGET / n);
            total.value += part.integral;
            total.error += part.error_estimate;
            total.evaluations += part.num_function_evaluations;
        }
    }
    total.error += 4.0 * f64::EPSILON * total.value.abs();
    total
}
