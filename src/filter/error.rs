//! What a texture or a sampler refuses.

/// Why a texture, a pyramid or a sampler was not made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FilterError {
    /// A side of 0 or beyond 2²⁴ texels.
    #[error("a texture of {width} × {height} texels: each side must be 1 to 16777216")]
    Size {
        /// As given.
        width: usize,
        /// As given.
        height: usize,
    },
    /// Neither 1, 2, 3 nor 4.
    #[error("{channels} channels: must be 1 to 4")]
    Channels {
        /// As given.
        channels: usize,
    },
    /// Values that do not fill the texture.
    #[error("{found} values for {width} × {height} texels of {channels} channels")]
    Length {
        /// Of the slice.
        found: usize,
        /// Of the texture.
        width: usize,
        /// Of the texture.
        height: usize,
        /// Of the texture.
        channels: usize,
    },
    /// NaN or an infinity among the values, which would spoil texels that it has no weight in.
    #[error("value {index} is {value}: must be finite")]
    NotFinite {
        /// In the interleaved values.
        index: usize,
        /// The value.
        value: f32,
    },
    /// A standard deviation out of its domain.
    #[error("σ = {sigma}: must be 1/1024 to 1024 semi-axes")]
    Sigma {
        /// As given.
        sigma: f32,
    },
    /// A power that the bell does not come in.
    #[error("K = {power}: must be {allowed}")]
    Power {
        /// As given.
        power: u32,
        /// The list.
        allowed: &'static str,
    },
    /// A limit of anisotropy below 1.
    #[error("anisotropy limit {limit}: must be 1 or more, +∞ for none")]
    Anisotropy {
        /// As given.
        limit: f32,
    },
    /// A cover out of its domain.
    #[error("cover {cover}: must be 1/16 to 1024 texels")]
    Cover {
        /// As given.
        cover: f32,
    },
    /// Slices of different lengths.
    #[error("{pixels} pixels, but room for {lookups} lookups: must be the same")]
    Slices {
        /// Given.
        pixels: usize,
        /// Given.
        lookups: usize,
    },
}
