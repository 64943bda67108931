//! Int(n) of any lobe: by a closed form where there is one, else by a rule.

use super::LobeIntegral;
use crate::integral::{Case, Edge, Field, ScaledIntegral};
use crate::kernel::model::Model;

/// An integral of the tables, or a bell's.
///
/// ```
/// use bellfit::{bound::Integral, integral::{Case, Limit, Lobe, ScaledIntegral}, kernel::model::Model};
/// let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
/// assert_eq!(Integral::Closed(case).describe(), "phong, cos-n, support");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Integral {
    /// cosⁿ or cs_16, by its closed form.
    Closed(Case),
    /// A bell, by a rule that is exact for it.
    Bell(Box<LobeIntegral>),
}

impl ScaledIntegral for Integral {
    fn scaled<T: Edge>(&self, m: &T) -> T {
        match self {
            Integral::Closed(case) => case.scaled(m),
            Integral::Bell(bell) => bell.scaled(m),
        }
    }

    fn scaled_from<T: Edge>(&self, from: f64, m: &T) -> T {
        match self {
            Integral::Closed(case) => case.scaled_from(from, m),
            Integral::Bell(bell) => bell.scaled_from(from, m),
        }
    }

    fn model(&self) -> Model {
        match self {
            Integral::Closed(case) => case.model,
            Integral::Bell(bell) => bell.model(),
        }
    }

    fn name(&self) -> String {
        match self {
            Integral::Closed(case) => case.name(),
            Integral::Bell(bell) => bell.name(),
        }
    }

    fn limit(&self) -> &'static str {
        match self {
            Integral::Closed(case) => ScaledIntegral::limit(case),
            Integral::Bell(bell) => ScaledIntegral::limit(bell.as_ref()),
        }
    }

    fn rational<T: Field>(&self, m: &T, h: &T) -> Option<(f64, T)> {
        match self {
            Integral::Closed(case) => case.rational(m, h),
            Integral::Bell(bell) => bell.rational(m, h),
        }
    }
}
