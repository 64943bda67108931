//! Rigorous enclosures: of Int(n), of a residual over all n, of a lobe's distance from another
//! over all arguments. Nothing here estimates.

mod approximation;
mod bell;
mod clipped;
mod compiled;
mod curve;
mod difference;
mod digits;
mod elementary;
mod error_function;
mod exact;
mod extremes;
mod fixed;
mod format;
mod formula;
mod gaussian;
mod gradient;
mod inequality;
mod integral;
mod integrals;
mod interval;
mod jet;
mod level;
mod lobe_integral;
mod measure;
mod multivariate;
mod polynomial;
mod polynomial_bell;
mod quadrature;
mod residual;
mod rounded;
mod rounding;
mod scaled_bell;
mod scaled_versine;
mod search;
mod taylor;
mod weight;

pub use approximation::approximation;
pub use bell::{BellProof, cosine_bell, exponential_bell};
pub use clipped::{ClippedPixel, clip_distance};
pub use curve::{Curve, curved_range};
pub use difference::{
    DifferenceExtreme, cos_n_range, cut_effect, cut_numerator, cut_range, difference_infimum,
    difference_supremum, reciprocal,
};
pub(crate) use digits::{short, short_down, short_up};
pub use exact::{decimal, enclose, exact, power_of_ten};
pub use fixed::Fixed;
pub use format::{Format, Handed};
pub use formula::{Formula, FormulaError};
pub use gaussian::{Gaussian, bell_distance, gaussian_distance};
pub use gradient::Gradient;
pub use inequality::{Decision, less_for_all};
pub use integral::Integral;
pub use integrals::{IntegralRow, IntegralTable, integral_enclosure};
pub use interval::Interval;
pub use jet::{Jet, range};
pub use lobe_integral::LobeIntegral;
pub use measure::Measure;
pub use multivariate::Multivariate;
pub use polynomial::{Coefficient, Exponents, Polynomial};
pub use polynomial_bell::{PolynomialBell, PolynomialBellError};
pub use quadrature::EnclosedRule;
pub use residual::{Extreme, Extremes, Residual, normalises_exactly};
pub use rounding::{ELEMENTARY_ULPS, assumes_elementary, rounding, rounding_with};
pub use scaled_bell::{BestScale, best_scale, scaled_bell_excess};
pub use search::{Supremum, infimum, supremum, supremum_near, supremum_until};
pub use weight::{BellTerms, WeightRegion};
