//! What lies on the plane.

use super::{Image, ImageError, Transfer};
use std::path::PathBuf;

/// A texture's source.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern {
    /// Squares of 0.1 and 0.9, linear light.
    Checker {
        /// Texels of the texture's side.
        size: usize,
        /// Texels of a square's side.
        square: usize,
    },
    /// ½ + 0.4 cos(2π f r²/size), r from the middle: the local frequency 2 f r/size grows from 0 to f cycles
    /// a texel at the middle of each edge.
    ZonePlate {
        /// Texels of the texture's side.
        size: usize,
        /// f; at ½ the texel grid's own limit.
        frequency: f64,
    },
    /// A PNG file.
    File {
        /// Which.
        path: PathBuf,
        /// How its values are read.
        transfer: Transfer,
    },
}

impl Pattern {
    /// The texels.
    ///
    /// # Errors
    /// [`ImageError`] if a file cannot be read, or for a size of 0.
    pub fn image(&self) -> Result<Image, ImageError> {
        match *self {
            Pattern::Checker { size, square } => {
                let value = |x: usize, y: usize| {
                    if (x / square.max(1) + y / square.max(1)).is_multiple_of(2) { 0.9 } else { 0.1 }
                };
                drawn(size, value)
            }
            Pattern::ZonePlate { size, frequency } => drawn(size, |x, y| {
                let off = |i: usize| i as f64 + 0.5 - 0.5 * size as f64;
                let rr = off(x) * off(x) + off(y) * off(y);
                0.5 + 0.4 * libm::cos(2.0 * std::f64::consts::PI * frequency * rr / size as f64)
            }),
            Pattern::File { ref path, transfer } => Image::read(path, transfer),
        }
    }
}

fn drawn(size: usize, value: impl Fn(usize, usize) -> f64) -> Result<Image, ImageError> {
    let texels = (0..size * size).map(|i| value(i % size, i / size) as f32);
    Image::new(size, size, 1, texels.collect())
}
