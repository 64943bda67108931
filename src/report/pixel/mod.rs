//! The pixel paper's studies: what is computed once, its tables, its constants, its part of the report.

mod constants;
mod footprint;
mod section;
mod tables;

pub(super) use constants::{ADOPTED, adopted, clip_constants};
pub(super) use section::section;
pub(super) use tables::{clip_csv, footprint_csv, texels_csv, weights_csv};

use super::computed::Clock;
use crate::fit::clip::{ClipPoints, ClipRow, Recipe, SigmaRange, clip_rows, matching_sigmas, recipes};
use crate::fit::{TexelWeight, WeightRow, figure_weights, weight_rows};

/// Points up to which recipes for the printed P are sought.
pub(super) const MOST_POINTS: u32 = 201;

/// Everything computed of the pixel paper.
#[derive(Clone, Debug)]
pub struct PixelStudy {
    /// Refits of the clip volume.
    pub clip: Vec<ClipRow>,
    /// Least-squares recipes that print the digits of P.
    pub recipes: Vec<Recipe>,
    /// For the table's points, the σ that would.
    pub sigmas: Vec<SigmaRange>,
    /// The weights against the Gaussian.
    pub weights: Vec<WeightRow>,
    /// The weights of the texels of the paper's figure.
    pub texels: Vec<TexelWeight>,
}

impl PixelStudy {
    pub(super) fn run(clock: Clock<'_>) -> Self {
        clock.time("pixels", || {
            let sigmas = ClipPoints::ALL.into_iter().flat_map(|points| {
                [false, true].into_iter().filter_map(move |half| matching_sigmas(points, half))
            });
            PixelStudy {
                clip: clip_rows(),
                recipes: recipes(MOST_POINTS),
                sigmas: sigmas.collect(),
                weights: weight_rows(),
                texels: figure_weights(),
            }
        })
    }
}
