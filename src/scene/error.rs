//! What can stop a picture.

use super::ImageError;
use crate::filter::FilterError;
use thiserror::Error;

/// Why a scene is not shown.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// The texture cannot be read.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// The texture or a technique is refused.
    #[error(transparent)]
    Filter(#[from] FilterError),
    /// A picture side out of its domain.
    #[error("picture of {width} × {height} pixels: each side must be 16 to 1024")]
    Size {
        /// As given.
        width: usize,
        /// As given.
        height: usize,
    },
    /// A number out of its domain.
    #[error("{name} = {value}: must be {domain}")]
    Number {
        /// Which.
        name: &'static str,
        /// As given.
        value: f64,
        /// The domain in words.
        domain: &'static str,
    },
    /// No pixel's surroundings lie on the plane.
    #[error("the camera sees no pixel of the plane")]
    Sky,
    /// The perceptual measure failed.
    #[error("ssimulacra2: {0}")]
    Perceptual(String),
}
