//! What stands against a best family.

use super::NoUncertainty;
use thiserror::Error;

/// N - p up to which BIC is no judge: it is the first term of an expansion for many samples, and what it leaves out is
/// not small beside it then. (Hurvich & Tsai, Biometrika 76, 1989, on the same fault of AIC.)
pub const FEW_LEFT: usize = 5;

/// Why the family of the least BIC is no final answer.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum Doubt {
    /// The best one's parameters have no uncertainty: n at an end of its range, a shape at its edge.
    #[error("{0}")]
    NotKnown(NoUncertainty),
    /// Some family has [`FEW_LEFT`] samples more than parameters, or fewer.
    #[error("N - p is {freedom}, and up to {FEW_LEFT} BIC, which is for many samples, is no judge")]
    FewLeft {
        /// The least N - p.
        freedom: usize,
    },
    /// Its residuals are larger than the sigmas allow, by which BIC weighs them.
    #[error("its residuals are larger than the sigmas, by which BIC weighs them")]
    Excess,
}
