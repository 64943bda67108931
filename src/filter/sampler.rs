//! Texture lookups.

use super::bilinear::{bilinear, nearest};
use super::elliptical::Desk;
use super::weight::constants;
use super::{EllipseFilter, FilterError, Pyramid, Texture, Wrap};
use crate::kernel::pixel::Jacobian;
use crate::slice::Unit;

/// How a texture is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The texel that holds the position.
    Nearest,
    /// Four texels.
    Bilinear,
    /// Four texels in each of two levels.
    Trilinear,
    /// All texels in the ellipse under the pixel.
    Ellipse(EllipseFilter),
}

/// Which level of the pyramid is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Level {
    /// By the Jacobian; nearest and bilinear read level 0.
    Auto,
    /// This one, or the coarsest if there are fewer.
    Fixed(usize),
}

/// A pixel in the texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its middle, in texels of level 0, texel centres at + ½.
    pub s: f32,
    /// Likewise.
    pub t: f32,
    /// Derivatives of both by the picture's x and y.
    pub jacobian: Jacobian<f32>,
}

impl Pixel {
    #[inline(always)]
    pub(super) fn is_finite(&self) -> bool {
        let Jacobian { ux, vx, uy, vy } = self.jacobian;
        let square = |x: f32| f64::from(x) * f64::from(x);
        let size = (square(ux) + square(uy)) + (square(vx) + square(vy));
        // 0 times what is not finite is NaN; in double precision nothing finite overflows.
        (f64::from(self.s) + f64::from(self.t) + size) * 0.0 == 0.0
    }
}

/// Elliptical lookups to be done, in one level or by the rule.
#[derive(Clone, Copy)]
pub(super) struct Asked<'s> {
    pub pixels: &'s [Pixel],
    pub filter: &'s EllipseFilter,
    pub fixed: Option<usize>,
}

/// What a lookup found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lookup {
    /// A channel each; absent channels are 0.
    pub value: [f32; 4],
    /// How many texels had Q ≤ 1, or were read by a bilinear lookup; of all levels together.
    pub texels: u64,
    /// The level, between two levels a fraction.
    pub level: f32,
    /// Whether no texel of the ellipse had weight, in one level at least, so that the bilinear value stands
    /// there instead.
    pub fallback: bool,
    /// Whether the ellipse in the fixed level has more texels than one lookup may read, so that nothing was
    /// read and the value is NaN.
    pub refused: bool,
}

/// Reads a pyramid.
///
/// ```
/// use bellfit::filter::{Method, Pyramid, Reduction, Sampler, Texture, Wrap};
/// use bellfit::kernel::pixel::Jacobian;
/// let ramp = Texture::new(4, 1, 1, &[0.0, 1.0, 2.0, 3.0])?;
/// let pyramid = Pyramid::new(ramp, Reduction::Box, Wrap::Clamp);
/// let pixel = Jacobian { ux: 1.0, vx: 0.0, uy: 0.0, vy: 1.0 };
/// let sampler = Sampler::new(&pyramid, Wrap::Clamp, Method::Bilinear)?;
/// assert_eq!(sampler.lookup(1.75, 0.5, pixel).value[0], 1.25);
/// # Ok::<(), bellfit::filter::FilterError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    pub(super) pyramid: &'a Pyramid,
    pub(super) wrap: Wrap,
    method: Method,
    pub(super) unit: Unit,
    /// Sides of each level by those of level 0.
    pub(super) ratios: Vec<[f64; 2]>,
    /// Of the ellipse's weight.
    pub(super) constants: [f32; 3],
}

impl<'a> Sampler<'a> {
    /// Errors: those of [`EllipseFilter::check`].
    pub fn new(pyramid: &'a Pyramid, wrap: Wrap, method: Method) -> Result<Self, FilterError> {
        let mut folded = [0.0; 3];
        if let Method::Ellipse(filter) = method {
            filter.check()?;
            folded = constants(filter.weight);
        }
        let base = pyramid.level(0);
        let ratio = |level: &Texture| {
            [level.width() as f64 / base.width() as f64, level.height() as f64 / base.height() as f64]
        };
        let ratios = (0..pyramid.levels()).map(|i| ratio(pyramid.level(i))).collect();
        Ok(Sampler { pyramid, wrap, method, unit: Unit::best(), ratios, constants: folded })
    }

    /// The same on a vector unit of choice. All give the same bits.
    pub fn on(self, unit: Unit) -> Self {
        Sampler { unit, ..self }
    }

    /// The texture at (s, t) under a pixel with derivatives `j`, all in texels of level 0, texel centres at
    /// + ½; the level by the method's own rule.
    ///
    /// - Nearest, bilinear: level 0.
    /// - Trilinear: λ = log₂ of the longer derivative vector, kept within the pyramid, between the two levels
    ///   around it (Vulkan specification, "Scale Factor Operation, Level-of-Detail Operation and Image Level(s)
    ///   Selection"; OpenGL 4.6, 8.14.1).
    /// - Ellipse: λ = log₂(minor semi-axis/cover), kept likewise, the minor axis that of the limited ellipse
    ///   before padding. Where the ellipse there is beyond 2²⁸ texels, or 2²¹ to a side, the first coarser
    ///   level where it is not; a level of 1 × 1 is read as what it is.
    ///
    /// A position or Jacobian that is not finite: NaN in every channel of the texture, no texels.
    pub fn lookup(&self, s: f32, t: f32, j: Jacobian<f32>) -> Lookup {
        self.lookup_at(s, t, j, Level::Auto)
    }

    /// The same in a level of choice. The ellipse there is M = J Jᵀ of the Jacobian in that level's texels,
    /// padded by one of them if asked to; the mean over Q ≤ 1 weighted by the method's weight.
    ///
    /// Accuracy of the ellipse without a rim rule: each sum rounds to 70 u relative, u = 2⁻²⁴ (a product, at
    /// most 64 additions in a lane, the lanes' sum), and Q to some 2⁻²² of the half axes' ratio, so that a
    /// texel nearer to the rim than that may count or not. The same bits on every machine and vector unit. The
    /// sums may overflow where texels exceed 10³⁵.
    pub fn lookup_at(&self, s: f32, t: f32, j: Jacobian<f32>, level: Level) -> Lookup {
        let pixel = Pixel { s, t, jacobian: j };
        if !pixel.is_finite() {
            return Lookup { level: f32::NAN, ..self.none() };
        }
        let position = [f64::from(s), f64::from(t)];
        let fixed = self.fixed(level);
        match &self.method {
            Method::Nearest => {
                let i = fixed.unwrap_or(0);
                let (level, [s, t]) = self.at(i, position);
                Lookup { value: nearest(level, self.wrap, s, t), texels: 1, level: i as f32, ..self.none() }
            }
            Method::Bilinear => self.four(fixed.unwrap_or(0), position),
            Method::Trilinear => match fixed {
                Some(i) => self.four(i, position),
                None => {
                    let x = f64::from(j.ux) * f64::from(j.ux) + f64::from(j.vx) * f64::from(j.vx);
                    let y = f64::from(j.uy) * f64::from(j.uy) + f64::from(j.vy) * f64::from(j.vy);
                    self.blend(self.level(if x > y { x } else { y }), |i| self.four(i, position))
                }
            },
            Method::Ellipse(filter) => {
                let (pixels, mut out) = (&[pixel], [Lookup::default()]);
                let asked = Asked { pixels, filter, fixed };
                match fixed {
                    Some(_) => self.ellipses(asked, &mut out, &mut Desk::<1>::new()),
                    None => self.ellipses(asked, &mut out, &mut Desk::<2>::new()),
                }
                out[0]
            }
        }
    }

    /// Several at once into `out`, the same bits as [`lookup_at`](Self::lookup_at) gives one by one, in less
    /// time: small ellipses in a third to a half of it (`cargo bench --bench filter`).
    ///
    /// Errors: [`FilterError::Slices`] if `pixels` and `out` differ in length; `out` is left as it was.
    ///
    /// ```
    /// use bellfit::filter::{
    ///     EllipseFilter, Level, Lookup, Method, Pixel, Pyramid, Reduction, Sampler, Texture, Wrap,
    /// };
    /// use bellfit::kernel::pixel::Jacobian;
    /// let ramp: Vec<f32> = (0..64 * 64).map(|i| (i % 64) as f32).collect();
    /// let pyramid = Pyramid::new(Texture::new(64, 64, 1, &ramp)?, Reduction::Box, Wrap::Clamp);
    /// let sampler = Sampler::new(&pyramid, Wrap::Clamp, Method::Ellipse(EllipseFilter::default()))?;
    /// let jacobian = Jacobian { ux: 3.0, vx: 0.0, uy: 0.0, vy: 2.0 };
    /// let row: Vec<Pixel> = (4..10).map(|x| Pixel { s: 6.0 * x as f32, t: 32.0, jacobian }).collect();
    /// let mut found = vec![Lookup::default(); row.len()];
    /// sampler.lookups(&row, Level::Auto, &mut found)?;
    /// assert!(found.iter().zip(&row).all(|(found, pixel)| (found.value[0] + 0.5 - pixel.s).abs() < 1e-4));
    /// # Ok::<(), bellfit::filter::FilterError>(())
    /// ```
    pub fn lookups(&self, pixels: &[Pixel], level: Level, out: &mut [Lookup]) -> Result<(), FilterError> {
        if pixels.len() != out.len() {
            return Err(FilterError::Slices { pixels: pixels.len(), lookups: out.len() });
        }
        if let Method::Ellipse(filter) = &self.method {
            let fixed = self.fixed(level);
            self.ellipses(Asked { pixels, filter, fixed }, out, &mut Desk::<32>::new());
        } else {
            for (pixel, out) in pixels.iter().zip(out) {
                *out = self.lookup_at(pixel.s, pixel.t, pixel.jacobian, level);
            }
        }
        Ok(())
    }

    fn fixed(&self, level: Level) -> Option<usize> {
        match level {
            Level::Auto => None,
            Level::Fixed(i) => Some(i.min(self.last())),
        }
    }

    pub(super) fn channels(&self) -> usize {
        self.pyramid.level(0).channels()
    }

    pub(super) fn last(&self) -> usize {
        self.pyramid.levels() - 1
    }

    /// Whether the level is one texel, which is all that can be read there.
    pub(super) fn is_point(&self, i: usize) -> bool {
        i == self.last()
    }

    /// Nothing read.
    #[inline(always)]
    pub(super) fn none(&self) -> Lookup {
        let mut value = [0.0; 4];
        value[..self.pyramid.level(0).channels()].fill(f32::NAN);
        Lookup { value, texels: 0, level: 0.0, fallback: false, refused: false }
    }

    /// ½ log₂ of a squared length, kept within the pyramid.
    #[inline(always)]
    pub(super) fn level(&self, squared: f64) -> f32 {
        // Of 0: -∞, level 0.
        let level = 0.5 * libm::log2(squared) as f32;
        if level > 0.0 { level.min(self.last() as f32) } else { 0.0 }
    }

    /// A level and the position in it, within 2⁴⁰ texels.
    #[inline(always)]
    pub(super) fn at(&self, i: usize, [s, t]: [f64; 2]) -> (&'a Texture, [f64; 2]) {
        let (level, [x, y]) = (self.pyramid.level(i), self.ratios[i]);
        (level, [self.wrap.near(s * x, level.width()), self.wrap.near(t * y, level.height())])
    }

    fn blend(&self, level: f32, lookup: impl Fn(usize) -> Lookup) -> Lookup {
        let fraction = level - level.floor();
        let fine = lookup(level as usize);
        if fraction == 0.0 {
            return fine;
        }
        let coarse = lookup(level as usize + 1);
        // Exact where the two are the same.
        let value = std::array::from_fn(|c| fine.value[c] + fraction * (coarse.value[c] - fine.value[c]));
        Lookup {
            value,
            texels: fine.texels + coarse.texels,
            level,
            fallback: fine.fallback || coarse.fallback,
            refused: fine.refused || coarse.refused,
        }
    }

    pub(super) fn four(&self, i: usize, position: [f64; 2]) -> Lookup {
        let (level, [s, t]) = self.at(i, position);
        let value = bilinear(level, self.wrap, s, t);
        Lookup { value, texels: 4, level: i as f32, ..self.none() }
    }
}
