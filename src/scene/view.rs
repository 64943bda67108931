//! A scene ready to be looked at.

use super::rows::rows;
use super::{Image, Scene, SceneError, Technique};
use crate::filter::{Level, Lookup, Pixel, Pyramid, Reduction, Sampler, Texture, Wrap};
use crate::kernel::pixel::{Jacobian, Polygon};

/// Half a side of the square of pixels around a pixel that must lie on the plane: the reach of the wider
/// reference filter.
pub(super) const REACH: usize = 2;
/// The sky's value, in every channel but alpha.
const SKY: f32 = 0.5;

/// A scene with its texture, its mip pyramid and its mapping.
#[derive(Debug)]
pub struct View {
    width: usize,
    height: usize,
    mapping: Polygon<f64>,
    wrap: Wrap,
    pyramid: Pyramid,
    on_plane: Vec<bool>,
}

/// A picture by one technique.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// The picture.
    pub image: Image,
    /// Texels a pixel, mean over the pixels on the plane.
    pub mean_texels: f64,
    /// Texels of the pixel that reads most.
    pub largest_texels: u64,
}

impl View {
    /// Reads or draws the texture and builds its pyramid (box reduction).
    ///
    /// # Errors
    /// [`SceneError`] for what cannot be read or lies out of its domain.
    pub fn new(scene: &Scene) -> Result<Self, SceneError> {
        scene.check()?;
        let texture = scene.pattern.image()?.texture()?;
        let (width, height) = (scene.width, scene.height);
        let mapping = scene.camera.mapping(width, height, scene.scale);
        let reach = REACH as f64;
        let below_horizon = |x: f64, y: f64| mapping.w[0] * x + mapping.w[1] * y + mapping.w[2] > 0.0;
        let on_plane: Vec<bool> = (0..width * height)
            .map(|i| {
                let (x, y) = ((i % width) as f64, (i / width) as f64);
                let corner = |dx: f64, dy: f64| below_horizon(x + dx, y + dy);
                let (near, far) = (-reach, 1.0 + reach);
                corner(near, near) && corner(near, far) && corner(far, near) && corner(far, far)
            })
            .collect();
        if !on_plane.contains(&true) {
            return Err(SceneError::Sky);
        }
        let pyramid = Pyramid::new(texture, Reduction::Box, scene.wrap);
        Ok(View { width, height, mapping, wrap: scene.wrap, pyramid, on_plane })
    }

    /// Pixels across.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> usize {
        self.height
    }

    /// From the picture to texels of level 0.
    pub fn mapping(&self) -> &Polygon<f64> {
        &self.mapping
    }

    /// Whether the plane fills the 5 × 5 pixels around each pixel, row by row. The others are sky in every
    /// picture and count in no error.
    pub fn on_plane(&self) -> &[bool] {
        &self.on_plane
    }

    pub(super) fn wrap(&self) -> Wrap {
        self.wrap
    }

    pub(super) fn texture(&self) -> &Texture {
        self.pyramid.level(0)
    }

    /// A sampler of the technique.
    ///
    /// # Errors
    /// [`SceneError::Filter`].
    pub(super) fn sampler(&self, technique: &Technique) -> Result<Sampler<'_>, SceneError> {
        Ok(Sampler::new(&self.pyramid, self.wrap, technique.method)?)
    }

    /// Position and Jacobian under the middle of a pixel, in the sampler's precision; the position is taken
    /// into the texture first where it repeats, so that nothing is lost far away.
    pub(super) fn under(&self, x: usize, y: usize, diameter: u8) -> Pixel {
        let (x, y) = (x as f64 + 0.5, y as f64 + 0.5);
        let (s, t) = self.mapping.at(x, y);
        let j = self.mapping.jacobian(x, y).scaled(0.5 * f64::from(diameter));
        let texture = self.texture();
        let near = |position: f64, size: usize| near(self.wrap, position, size as f64) as f32;
        let single = |x: f64| x as f32;
        Pixel {
            s: near(s, texture.width()),
            t: near(t, texture.height()),
            jacobian: Jacobian { ux: single(j.ux), vx: single(j.vx), uy: single(j.uy), vy: single(j.vy) },
        }
    }

    /// The picture by one technique, rows on so many threads.
    ///
    /// # Errors
    /// [`SceneError`] for a technique that the filters refuse.
    pub fn picture(&self, technique: &Technique, threads: usize) -> Result<Rendered, SceneError> {
        let sampler = self.sampler(technique)?;
        let channels = self.texture().channels();
        let computed = rows(self.height, threads, |y| {
            let on_plane = |x: &usize| self.on_plane[y * self.width + x];
            let under = |x: usize| self.under(x, y, technique.diameter);
            let pixels: Vec<Pixel> = (0..self.width).filter(on_plane).map(under).collect();
            let mut found = vec![Lookup::default(); pixels.len()];
            sampler.lookups(&pixels, Level::Auto, &mut found).expect("slices of one length");
            let mut next = found.iter();
            let value = |x: usize| if on_plane(&x) { next.next().map(|found| found.value) } else { None };
            let row = (0..self.width).map(value).map(|value| value.unwrap_or(sky(channels)));
            let values: Vec<f32> = row.flat_map(|value| value.into_iter().take(channels)).collect();
            let texels: u64 = found.iter().map(|found| found.texels).sum();
            let largest = found.iter().map(|found| found.texels).max().unwrap_or(0);
            (values, texels, largest)
        });
        let pixels = self.on_plane.iter().filter(|&&on| on).count();
        let texels: u64 = computed.iter().map(|row| row.1).sum();
        let largest_texels = computed.iter().map(|row| row.2).max().unwrap_or(0);
        let values = computed.into_iter().flat_map(|row| row.0).collect();
        let image = Image::new(self.width, self.height, channels, values)?;
        Ok(Rendered { image, mean_texels: texels as f64 / pixels as f64, largest_texels })
    }
}

/// The sky in so many channels, alpha 1.
pub(super) fn sky(channels: usize) -> [f32; 4] {
    let mut sky = [SKY; 4];
    if channels == 2 || channels == 4 {
        sky[channels - 1] = 1.0;
    }
    sky
}

/// How far outside a clamped texture a position stays as it is.
const FAR: f64 = (1 << 23) as f64;

/// The same place of a texture of this size, near the origin, so that single precision holds it: the
/// remainder where the texture repeats, and no more than 2²³ texels outside a clamped one.
///
/// ```
/// use bellfit::{filter::Wrap, scene::near};
/// assert_eq!(near(Wrap::Repeat, -1.25, 8.0), 6.75);
/// assert_eq!(near(Wrap::Mirror, 17.0, 8.0), 1.0);
/// ```
pub fn near(wrap: Wrap, position: f64, size: f64) -> f64 {
    match wrap {
        Wrap::Repeat => position - size * (position / size).floor(),
        Wrap::Mirror => position - 2.0 * size * (position / (2.0 * size)).floor(),
        Wrap::Clamp => position.clamp(-FAR, size + FAR),
    }
}
