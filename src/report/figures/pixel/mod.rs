//! The figures of the pixel paper.

mod axes;
mod clip;
mod footprint;
mod weight;

use super::Figure;
use crate::fit::clip::ClipRow;
use crate::fit::{TexelWeight, WeightRow};

/// What the pixel paper's figures draw.
#[derive(Clone, Copy, Debug)]
pub struct Pixel<'a> {
    /// Refits of the clip volume.
    pub clip: &'a [ClipRow],
    /// The weights' errors.
    pub weights: &'a [WeightRow],
    /// The weights of the texels of the paper's figure.
    pub texels: &'a [TexelWeight],
}

/// The figures of the pixel paper, in the report's order.
pub fn pixel(drawn: Pixel) -> Vec<Figure> {
    vec![
        clip::volumes(drawn.clip),
        axes::errors(),
        footprint::ellipses(),
        footprint::tilts(),
        weight::bells(drawn.weights),
        weight::texels(drawn.texels),
    ]
}
