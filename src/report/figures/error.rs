use crate::paper::ClaimsError;
use crate::report::chart::ChartError;

/// Why a figure cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// No residual to draw.
    #[error("no factor was given whose residual could be drawn")]
    NoLines,
    /// The printed numbers cannot be read.
    #[error("the claims: {0}")]
    Claims(#[from] ClaimsError),
    /// A chart's axis cannot be drawn.
    #[error(transparent)]
    Chart(#[from] ChartError),
    /// A figure's picture cannot be drawn.
    #[error("figure {stem}: {source}")]
    Render {
        /// Which figure.
        stem: &'static str,
        /// Why.
        source: ChartError,
    },
}
