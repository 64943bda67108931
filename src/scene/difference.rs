//! How far two pictures are apart.

use super::{Image, SceneError};
use ssimulacra2::{LinearRgb, compute_frame_ssimulacra2};

/// The error of a picture against a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureError {
    /// Root of the mean squared difference of linear light, over the channels of the pixels that count.
    pub rmse: f64,
    /// -20 log₁₀ RMSE, decibels, the peak being 1; +∞ for equal pictures.
    pub psnr: f64,
    /// SSIMULACRA 2 of the whole pictures, to two decimals: 100 equal, 90 hardly to be told apart, 50 low
    /// quality, below 0 extreme distortion. Values are clamped to 0..1, alpha is left out.
    pub perceptual: f64,
    /// How much of the reference's contrast the picture keeps: cov(picture, reference)/var(reference) over
    /// the pixels that count. Above 1: sharper than the reference; below: more blurred.
    pub gain: f64,
    /// What one gain does not explain: root mean square of picture less gain × reference, about its mean.
    /// Aliasing, and contrast that is kept unequally over the frequencies, as any blur does.
    pub alien: f64,
}

impl PictureError {
    /// Of picture `b` against the reference `a` of the same shape, `counted` saying of each pixel whether it counts in the first two.
    ///
    /// # Errors
    /// [`SceneError::Perceptual`] for pictures of unequal size or below 8 pixels.
    pub fn between(a: &Image, b: &Image, counted: &[bool]) -> Result<Self, SceneError> {
        let channels = a.channels();
        let pixels = (0..counted.len()).filter(|&i| counted[i]);
        let pairs: Vec<(f64, f64)> = pixels
            .flat_map(|i| channels * i..channels * (i + 1))
            .map(|at| (f64::from(a.values()[at]), f64::from(b.values()[at])))
            .collect();
        let mean =
            |of: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len().max(1) as f64;
        let rmse = mean(&|(a, b)| (a - b) * (a - b)).sqrt();
        let (middle, other) = (mean(&|pair| pair.0), mean(&|pair| pair.1));
        let variance = mean(&|(a, _)| (a - middle) * (a - middle));
        let gain = mean(&|(a, b)| (a - middle) * (b - other)) / variance;
        let alien = mean(&|(a, b)| {
            let off = b - other - gain * (a - middle);
            off * off
        })
        .sqrt();
        let psnr = -20.0 * libm::log10(rmse);
        // Its one platform-dependent step is a last power in double precision: two decimals hide its bits.
        let score = compute_frame_ssimulacra2(rgb(a)?, rgb(b)?)
            .map_err(|error| SceneError::Perceptual(error.to_string()))?;
        Ok(PictureError { rmse, psnr, perceptual: libm::round(100.0 * score) / 100.0, gain, alien })
    }
}

fn rgb(image: &Image) -> Result<LinearRgb, SceneError> {
    let pixel = |values: &[f32]| {
        let colour = if values.len() < 3 { [values[0]; 3] } else { [values[0], values[1], values[2]] };
        colour.map(|value| value.clamp(0.0, 1.0))
    };
    let pixels = image.values().chunks_exact(image.channels()).map(pixel).collect();
    LinearRgb::new(pixels, image.width(), image.height())
        .map_err(|error| SceneError::Perceptual(error.to_string()))
}
