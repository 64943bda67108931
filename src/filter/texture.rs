//! An image of one to four channels.

use super::FilterError;

/// Floats behind each plane, so that a run of lanes may start at any texel.
pub(super) const SLACK: usize = 16;
/// Largest side: texel centres are exact in `f32`.
const LARGEST: usize = 1 << 24;

/// Texels of level 0 or of a mip level, one to four channels of `f32`.
///
/// Planar in memory: a plane a channel, its rows one behind the other.
///
/// ```
/// use bellfit::filter::Texture;
/// let texture = Texture::new(2, 1, 2, &[1.0, 2.0, 3.0, 4.0])?;
/// assert_eq!(texture.texel(1, 0), [3.0, 4.0, 0.0, 0.0]);
/// assert_eq!(texture.plane(1), [2.0, 4.0]);
/// # Ok::<(), bellfit::filter::FilterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    width: usize,
    height: usize,
    channels: usize,
    planes: Vec<f32>,
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
        let plane = |c: usize| interleaved.iter().skip(c).step_by(channels).copied();
        Ok(Self::from_planes(width, height, (0..channels).map(plane)))
    }

    /// Of planes of width × height values each.
    pub(super) fn from_planes<P: Iterator<Item = f32>>(
        width: usize,
        height: usize,
        from: impl ExactSizeIterator<Item = P>,
    ) -> Texture {
        let channels = from.len();
        let mut planes = Vec::with_capacity(channels * (width * height + SLACK));
        for plane in from {
            planes.extend(plane);
            planes.extend([0.0; SLACK]);
        }
        Texture { width, height, channels, planes }
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
        let mut value = [0.0; 4];
        for (c, value) in value.iter_mut().enumerate().take(self.channels) {
            *value = self.plane(c)[y * self.width + x];
        }
        value
    }

    /// All texels of a channel, row by row; panics if the channel is absent.
    #[inline]
    pub fn plane(&self, channel: usize) -> &[f32] {
        &self.run(channel)[..self.width * self.height]
    }

    /// The same with [`SLACK`] zeros behind.
    #[inline]
    pub(super) fn run(&self, channel: usize) -> &[f32] {
        let size = self.width * self.height + SLACK;
        &self.planes[channel * size..][..size]
    }
}
