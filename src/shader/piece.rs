//! What is emitted.

use crate::kernel::model::Model;
use crate::kernel::pixel::PixelWeight;
use crate::kernel::stand_in::{Argument, StandIn};

/// One thing to emit: a few functions, with the structure that they share.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A lobe, and for a bell the function that computes its constants from n, once a material.
    Lobe {
        /// What stands for cosⁿ.
        stand_in: StandIn,
        /// What it takes.
        argument: Argument,
        /// The sentence about its error in the comment; without it that of the certified distance from cosⁿ,
        /// where the lobe has one.
        error: Option<String>,
    },
    /// The factor coef(n) of a lobe under a model: for cs-16 the line that never gains energy and the exact
    /// form, for other bells of degree one the exact form, for those of degree three the fitted one, for cosⁿ
    /// its own.
    Factor {
        /// The row of the lobe paper's Table 1.
        model: Model,
        /// The lobe.
        stand_in: StandIn,
        /// What is taken off the factor, coef (1 - nudge), so that its rounding gains nothing; 0 to leave it as
        /// it is.
        nudge: f64,
    },
    /// From a Jacobian to Q, plain and padded.
    Footprint,
    /// The weight of a texel from Q, or for a product from the two squares.
    Weight(PixelWeight<f64>),
}
