//! The transfer function of sRGB.

/// How a file's values stand for linear light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Transfer {
    /// By the curve of IEC 61966-2-1.
    Srgb,
    /// As they are.
    Linear,
}

impl Transfer {
    /// A file's value in 0..1 to linear light.
    pub fn decode(self, value: f64) -> f64 {
        match self {
            Transfer::Srgb => decode_srgb(value),
            Transfer::Linear => value,
        }
    }

    /// Linear light to a file's value.
    pub fn encode(self, light: f64) -> f64 {
        match self {
            Transfer::Srgb => encode_srgb(light),
            Transfer::Linear => light,
        }
    }
}

/// Linear light of an sRGB value: v/12.92 up to 0.04045, ((v + 0.055)/1.055)^2.4 above.
///
/// Source: IEC 61966-2-1:1999, with the standard's own rounded constants, between which the two pieces are
/// 1e-8 apart. Domain: 0..1. Accuracy: that of `libm::pow`, within one unit in the last place.
///
/// ```
/// use bellfit::scene::decode_srgb;
/// assert_eq!((decode_srgb(0.0), decode_srgb(1.0)), (0.0, 1.0));
/// assert!((decode_srgb(0.5) - 0.21404114048223255).abs() < 1e-15);
/// ```
pub fn decode_srgb(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

/// sRGB value of linear light: 12.92 l up to 0.0031308, 1.055 l^(1/2.4) - 0.055 above.
///
/// Source, domain and accuracy as of [`decode_srgb`].
///
/// ```
/// use bellfit::scene::{decode_srgb, encode_srgb};
/// assert!((encode_srgb(decode_srgb(0.5)) - 0.5).abs() < 1e-15);
/// ```
pub fn encode_srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055 }
}
