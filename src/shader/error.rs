//! What cannot be emitted.

use super::Language;
use thiserror::Error;

/// A combination that is not offered, or a piece outside its domain.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ShaderError {
    /// The language lacks the format, or it is not offered.
    #[error("{language} in {format} is not offered: {offered}")]
    Format {
        /// Language.
        language: Language,
        /// The format's id.
        format: &'static str,
        /// What is.
        offered: &'static str,
    },
    /// The language has no such elementary function in the format.
    #[error("{language} has no {function} in {format}")]
    Elementary {
        /// Language.
        language: Language,
        /// The format's id.
        format: &'static str,
        /// Name of the function in WGSL.
        function: &'static str,
    },
    /// The footprint's squares and its determinant leave the range of f16.
    #[error("the footprint's determinant leaves the range of f16, which ends at 65504: f32 holds it")]
    Range,
    /// The lobe has no factor.
    #[error("{0} has no factor: cs-16, linear-K, cubic-K, squarings, exp2-log2 and pow have")]
    NoFactor(&'static str),
    /// σ of a weight.
    #[error("sigma = {0}: 1/(2 sigma^2 K) is not a positive normal number of the format")]
    Sigma(f64),
    /// K of a weight.
    #[error("K = {power} is no power of {weight}: {offered}")]
    Power {
        /// K.
        power: u32,
        /// The kind of weight.
        weight: &'static str,
        /// What is.
        offered: &'static str,
    },
    /// Two pieces of one name are not the same, such as a weight with two σ.
    #[error("two pieces are named {0} and differ: emit them apart")]
    Name(String),
    /// No piece was asked for.
    #[error("no piece was asked for")]
    Empty,
    /// A bound for the comment could not be computed.
    #[error("no bound of {0} could be certified")]
    Uncertified(String),
    /// naga refused the text.
    #[error("{language}: {message}")]
    Translation {
        /// Language.
        language: Language,
        /// What naga says.
        message: String,
    },
}
