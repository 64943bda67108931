//! PNG files in and out.

use super::Transfer;
use crate::filter::{FilterError, Texture};
use std::io::Cursor;
use std::path::Path;
use thiserror::Error;

/// Why an image could not be read or written.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ImageError {
    /// The file cannot be opened or read.
    #[error("{path}: {reason}")]
    File {
        /// Which file.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// The bytes are no whole PNG.
    #[error("not a readable PNG: {0}")]
    Decode(String),
    /// More pixels than [`Image::LARGEST`].
    #[error("{width} × {height} pixels: at most {} are read", Image::LARGEST)]
    TooLarge {
        /// As the file says.
        width: u32,
        /// As the file says.
        height: u32,
    },
    /// No pixels, or values that do not fill them, or channels other than 1 to 4.
    #[error("{values} values for {width} × {height} pixels of {channels} channels (1 to 4)")]
    Shape {
        /// Across.
        width: usize,
        /// Down.
        height: usize,
        /// Asked for.
        channels: usize,
        /// Given.
        values: usize,
    },
    /// The encoder failed.
    #[error("PNG encoding failed: {0}")]
    Encode(String),
}

/// An image in linear light, one to four channels side by side: grey, grey and alpha, RGB, RGBA.
///
/// Alpha is linear always and multiplies nothing: PNG stores colours as they are without it, and each channel
/// is filtered by itself. A gamma or colour profile in a file is not looked at.
///
/// ```
/// use bellfit::scene::{Image, Transfer};
/// let image = Image::new(2, 1, 1, vec![0.0, 1.0])?;
/// assert_eq!(Image::decode(&image.encode(Transfer::Srgb)?, Transfer::Srgb)?, image);
/// # Ok::<(), bellfit::scene::ImageError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: usize,
    height: usize,
    channels: usize,
    values: Vec<f32>,
}

impl Image {
    /// The most pixels that are read: 2²⁶, which are 1 GiB with four channels.
    pub const LARGEST: u64 = 1 << 26;

    /// Of values row by row from the top, channels side by side.
    ///
    /// # Errors
    /// [`ImageError::Shape`].
    pub fn new(width: usize, height: usize, channels: usize, values: Vec<f32>) -> Result<Self, ImageError> {
        let filled = width.checked_mul(height).and_then(|n| n.checked_mul(channels)) == Some(values.len());
        if !filled || values.is_empty() || channels > 4 {
            return Err(ImageError::Shape { width, height, channels, values: values.len() });
        }
        Ok(Image { width, height, channels, values })
    }

    /// Pixels across.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> usize {
        self.height
    }

    /// One to four.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// Row by row from the top, channels side by side.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The same as a texture.
    ///
    /// # Errors
    /// [`FilterError`] for a value that is not finite.
    pub fn texture(&self) -> Result<Texture, FilterError> {
        Texture::new(self.width, self.height, self.channels, &self.values)
    }

    /// Reads a PNG file.
    ///
    /// # Errors
    /// [`ImageError::File`], [`ImageError::Decode`] or [`ImageError::TooLarge`].
    pub fn read(path: &Path, transfer: Transfer) -> Result<Self, ImageError> {
        let fail = |reason: String| ImageError::File { path: path.display().to_string(), reason };
        if path.is_dir() {
            return Err(fail("a folder, not a PNG file".to_owned()));
        }
        let bytes = std::fs::read(path).map_err(|error| {
            let text = error.to_string();
            fail(text.split(" (os error").next().unwrap_or(&text).to_lowercase())
        })?;
        Image::decode(&bytes, transfer).map_err(|error| fail(error.to_string()))
    }

    /// Of a PNG file's bytes: 1 to 16 bits a channel, grey, RGB or palette, with or without alpha or a
    /// transparent colour. Of an animation the still picture.
    ///
    /// # Errors
    /// [`ImageError::Decode`] or [`ImageError::TooLarge`].
    pub fn decode(bytes: &[u8], transfer: Transfer) -> Result<Self, ImageError> {
        let fail = |error: png::DecodingError| {
            let text = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
            // What follows is a dump of the decoder's own struct.
            ImageError::Decode(text.split(" while decoding ").next().unwrap_or(&text).to_owned())
        };
        // Room for the largest image of 8 bytes a pixel; the size itself is checked before any is taken.
        let limits = png::Limits { bytes: 9 * Image::LARGEST as usize };
        let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
        decoder.set_transformations(png::Transformations::EXPAND);
        let header = decoder.read_header_info().map_err(fail)?;
        let (width, height) = (header.width, header.height);
        if u64::from(width) * u64::from(height) > Image::LARGEST {
            return Err(ImageError::TooLarge { width, height });
        }
        let mut reader = decoder.read_info().map_err(fail)?;
        let size = reader.output_buffer_size().ok_or(ImageError::TooLarge { width, height })?;
        let mut raw = vec![0; size];
        let frame = reader.next_frame(&mut raw).map_err(fail)?;
        let raw = &raw[..frame.buffer_size()];
        let channels = frame.color_type.samples();
        let codes: Vec<u16> = match frame.bit_depth {
            png::BitDepth::Sixteen => {
                raw.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect()
            }
            _ => raw.iter().map(|&byte| u16::from(byte)).collect(),
        };
        let largest = if frame.bit_depth == png::BitDepth::Sixteen { 65_535.0 } else { 255.0 };
        let linear = |code: u16| (f64::from(code) / largest) as f32;
        let light = Light::new(transfer, largest, codes.len());
        let has_alpha = channels == 2 || channels == 4;
        let values = codes.iter().enumerate().map(|(i, &code)| {
            if has_alpha && i % channels == channels - 1 { linear(code) } else { light.of(code) }
        });
        Image::new(frame.width as usize, frame.height as usize, channels, values.collect())
    }

    /// As the bytes of a PNG file, 8 bits a channel; values beyond 0..1 are clamped.
    ///
    /// # Errors
    /// [`ImageError::Encode`].
    pub fn encode(&self, transfer: Transfer) -> Result<Vec<u8>, ImageError> {
        let has_alpha = self.channels == 2 || self.channels == 4;
        let code = |(i, &value): (usize, &f32)| {
            let alpha = has_alpha && i % self.channels == self.channels - 1;
            let light = f64::from(value).clamp(0.0, 1.0);
            let stored = if alpha { light } else { transfer.encode(light) };
            libm::round(255.0 * stored) as u8
        };
        let pixels: Vec<u8> = self.values.iter().enumerate().map(code).collect();
        let kind = match self.channels {
            1 => png::ColorType::Grayscale,
            2 => png::ColorType::GrayscaleAlpha,
            3 => png::ColorType::Rgb,
            _ => png::ColorType::Rgba,
        };
        encode_bytes(&pixels, self.width, self.height, kind)
    }
}

fn encode_bytes(
    pixels: &[u8],
    width: usize,
    height: usize,
    kind: png::ColorType,
) -> Result<Vec<u8>, ImageError> {
    let fail = |error: png::EncodingError| ImageError::Encode(error.to_string());
    let side = |n: usize| u32::try_from(n).map_err(|error| ImageError::Encode(error.to_string()));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side(width)?, side(height)?);
    encoder.set_color(kind);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().map_err(fail)?;
    writer.write_image_data(pixels).map_err(fail)?;
    writer.finish().map_err(fail)?;
    Ok(bytes)
}

/// Linear light of a file's codes: by a table where there are more values than codes.
enum Light {
    Table(Vec<f32>),
    Direct(Transfer, f64),
}

impl Light {
    fn new(transfer: Transfer, largest: f64, values: usize) -> Self {
        let direct = Light::Direct(transfer, largest);
        if (values as f64) <= largest {
            return direct;
        }
        Light::Table((0..=largest as u16).map(|code| direct.of(code)).collect())
    }

    fn of(&self, code: u16) -> f32 {
        match self {
            Light::Table(table) => table[usize::from(code)],
            Light::Direct(transfer, largest) => transfer.decode(f64::from(code) / largest) as f32,
        }
    }
}
