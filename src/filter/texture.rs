//! An image of one to four channels.

use super::FilterError;

/// Texels of zeros behind the last, so that eight may be read from any on.
const SLACK: usize = 8;
/// Largest side: texel centres are exact in `f32`.
const LARGEST: usize = 1 << 24;

/// Texels of level 0 or of a mip level, one to four channels of `f32`.
///
/// Channels side by side in memory, row by row: the texels of a footprint lie in few cache lines.
///
/// ```
/// use bellfit::filter::Texture;
/// let texture = Texture::new(2, 1, 2, &[1.0, 2.0, 3.0, 4.0])?;
/// assert_eq!(texture.texel(1, 0), [3.0, 4.0, 0.0, 0.0]);
/// assert_eq!(texture.texels(), [1.0, 2.0, 3.0, 4.0]);
/// assert_eq!(texture.channel(1).collect::<Vec<_>>(), [2.0, 4.0]);
/// # Ok::<(), bellfit::filter::FilterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    width: usize,
    height: usize,
    channels: usize,
    texels: Vec<f32>,
}

impl Texture {
    /// Of `interleaved` values: channels side by side, row by row from the top.
    ///
    /// Errors: a side of 0 or beyond 2²⁴, channels other than 1 to 4, a length that is not
    /// width × height × channels, a value that is not finite.
    pub fn new(
        width: usize,
        height: usize,
        channels: usize,
        interleaved: &[f32],
    ) -> Result<Texture, FilterError> {
        if !(1..=LARGEST).contains(&width) || !(1..=LARGEST).contains(&height) {
            return Err(FilterError::Size { width, height });
        }
        if !(1..=4).contains(&channels) {
            return Err(FilterError::Channels { channels });
        }
        // Sides of 2²⁴ and four channels stay below 2⁶⁴.
        if (width as u64) * (height as u64) * (channels as u64) != interleaved.len() as u64 {
            return Err(FilterError::Length { found: interleaved.len(), width, height, channels });
        }
        if let Some(index) = interleaved.iter().position(|value| !value.is_finite()) {
            return Err(FilterError::NotFinite { index, value: interleaved[index] });
        }
        Ok(Self::from_texels(width, height, channels, interleaved.to_vec()))
    }

    /// Of width × height × channels values, finite.
    pub(super) fn from_texels(width: usize, height: usize, channels: usize, mut texels: Vec<f32>) -> Texture {
        texels.resize(texels.len() + SLACK * channels, 0.0);
        Texture { width, height, channels, texels }
    }

    /// Texels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// One to four.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// The texel in column x of row y; absent channels are 0.
    ///
    /// Panics outside the texture: [`Wrap::index`](super::Wrap::index) brings any integer inside.
    #[inline]
    pub fn texel(&self, x: usize, y: usize) -> [f32; 4] {
        assert!(x < self.width && y < self.height, "texel ({x}, {y}) of {} × {}", self.width, self.height);
        let at = (y * self.width + x) * self.channels;
        match self.texels[at..at + self.channels] {
            [] => [0.0; 4],
            [a] => [a, 0.0, 0.0, 0.0],
            [a, b] => [a, b, 0.0, 0.0],
            [a, b, c] => [a, b, c, 0.0],
            [a, b, c, d, ..] => [a, b, c, d],
        }
    }

    /// All texels, channels side by side, row by row.
    #[inline]
    pub fn texels(&self) -> &[f32] {
        &self.texels[..self.width * self.height * self.channels]
    }

    /// All values of a channel, row by row; panics if the channel is absent.
    pub fn channel(&self, channel: usize) -> impl ExactSizeIterator<Item = f32> + '_ {
        assert!(channel < self.channels, "channel {channel} of {}", self.channels);
        self.texels().iter().skip(channel).step_by(self.channels).copied()
    }

    /// The texels with [`SLACK`] texels of zeros behind.
    #[inline]
    pub(super) fn run(&self) -> &[f32] {
        &self.texels
    }
}
