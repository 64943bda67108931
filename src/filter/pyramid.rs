//! A texture and its coarser levels.

use super::reduction::Taps;
use super::{Reduction, Texture, Wrap};

/// A texture with its mip levels.
///
/// Level N + 1 has max(1, ⌊w/2⌋) by max(1, ⌊h/2⌋) texels, w by h those of level N, down to 1 × 1: the sizes
/// of the Vulkan and OpenGL specifications. A texel of a level of w_N columns stands for w₀/w_N columns of
/// level 0, a whole number or not.
///
/// ```
/// use bellfit::filter::{Pyramid, Reduction, Texture, Wrap};
/// let row = Texture::new(5, 1, 1, &[0.0, 0.0, 3.0, 6.0, 1.0])?;
/// let pyramid = Pyramid::new(row, Reduction::Box, Wrap::Clamp);
/// assert_eq!(pyramid.levels(), 3); // 5, 2 and 1 texels
/// assert_eq!(pyramid.level(1).texels(), [0.6, 3.4]); // (0 + 0 + 3/2)/2.5 and (3/2 + 6 + 1)/2.5
/// assert_eq!(pyramid.level(2).texels(), [2.0]);
/// # Ok::<(), bellfit::filter::FilterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pyramid {
    levels: Vec<Texture>,
}

impl Pyramid {
    /// All levels, each filtered from level 0 in double precision and rounded once; `wrap` is what the
    /// filter reads beyond the edges (the box reads nothing there).
    ///
    /// Accuracy: a value is within 2⁻²⁴ of itself, and 2⁻⁴⁰ of the largest texel, of the exact weighted mean.
    pub fn new(texture: Texture, reduction: Reduction, wrap: Wrap) -> Pyramid {
        let (mut w, mut h) = (texture.width(), texture.height());
        let mut levels = vec![texture];
        while w > 1 || h > 1 {
            (w, h) = ((w / 2).max(1), (h / 2).max(1));
            levels.push(reduced(&levels[0], w, h, reduction, wrap));
        }
        Pyramid { levels }
    }

    /// How many; at least one.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Level i; panics if there is none.
    pub fn level(&self, i: usize) -> &Texture {
        &self.levels[i]
    }
}

/// The texture with `to_w` by `to_h` texels: columns first, then rows.
fn reduced(from: &Texture, to_w: usize, to_h: usize, reduction: Reduction, wrap: Wrap) -> Texture {
    let (w, h) = (from.width(), from.height());
    let columns: Vec<Taps> = (0..to_w).map(|i| reduction.taps(i, w, to_w, wrap)).collect();
    let rows: Vec<Taps> = (0..to_h).map(|i| reduction.taps(i, h, to_h, wrap)).collect();
    let channels = from.channels();
    let mut texels = vec![0.0; to_w * to_h * channels];
    for c in 0..channels {
        let narrow: Vec<f64> = from
            .texels()
            .chunks_exact(w * channels)
            .flat_map(|row| {
                columns.iter().map(move |taps| weighted(taps, |x| f64::from(row[x * channels + c])))
            })
            .collect();
        for (i, texel) in texels.chunks_exact_mut(channels).enumerate() {
            texel[c] = weighted(&rows[i / to_w], |y| narrow[y * to_w + i % to_w]) as f32;
        }
    }
    Texture::from_texels(to_w, to_h, channels, texels)
}

fn weighted(taps: &Taps, value: impl Fn(usize) -> f64) -> f64 {
    taps.places.iter().zip(&taps.weights).map(|(&place, &weight)| weight * value(place)).sum()
}
