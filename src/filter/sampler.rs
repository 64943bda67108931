//! One texture lookup.

use super::bilinear::{bilinear, nearest};
use super::placed::{Placed, Shape, is_readable};
use super::rim::careful;
use super::scan::{Scan, Sum};
use super::weight::{LaneWeight, constants, with_lane_weight};
use super::{EllipseFilter, FilterError, Pyramid, Rim, Texture, Wrap};
use crate::kernel::pixel::Jacobian;
use crate::slice::{Job, Unit};

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

/// What a lookup found.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    pyramid: &'a Pyramid,
    wrap: Wrap,
    method: Method,
    unit: Unit,
    /// Sides of each level by those of level 0.
    ratios: Vec<[f64; 2]>,
    /// Of the ellipse's weight.
    constants: [f32; 3],
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
        // 0 times what is not finite is NaN.
        if s * 0.0 + t * 0.0 + ((j.ux * 0.0 + j.vx * 0.0) + (j.uy * 0.0 + j.vy * 0.0)) != 0.0 {
            return Lookup { level: f32::NAN, ..self.none() };
        }
        let position = [f64::from(s), f64::from(t)];
        let fixed = match level {
            Level::Auto => None,
            Level::Fixed(i) => Some(i.min(self.last())),
        };
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
                let request = Request { position, j, filter, fixed };
                let careful = || self.ellipse(&request, &Careful { wrap: self.wrap, filter });
                if filter.rim != Rim::None {
                    return careful();
                }
                let (sampler, unit, request) = (self, self.unit, &request);
                with_lane_weight!(filter.weight, self.constants, weight => match self.channels() {
                    1 => unit.run(Lanes::<_, 1> { sampler, request, weight }),
                    2 => unit.run(Lanes::<_, 2> { sampler, request, weight }),
                    3 => unit.run(Lanes::<_, 3> { sampler, request, weight }),
                    _ => unit.run(Lanes::<_, 4> { sampler, request, weight }),
                }, else careful())
            }
        }
    }

    fn channels(&self) -> usize {
        self.pyramid.level(0).channels()
    }

    fn last(&self) -> usize {
        self.pyramid.levels() - 1
    }

    /// Whether the level is one texel, which is all that can be read there.
    fn is_point(&self, i: usize) -> bool {
        i == self.last()
    }

    /// Nothing read.
    #[inline(always)]
    fn none(&self) -> Lookup {
        let mut value = [0.0; 4];
        value[..self.pyramid.level(0).channels()].fill(f32::NAN);
        Lookup { value, texels: 0, level: 0.0, fallback: false, refused: false }
    }

    /// ½ log₂ of a squared length, kept within the pyramid.
    #[inline(always)]
    fn level(&self, squared: f64) -> f32 {
        // Of 0: -∞, level 0.
        let level = 0.5 * libm::log2(squared) as f32;
        if level > 0.0 { level.min(self.last() as f32) } else { 0.0 }
    }

    /// A level and the position in it, within 2⁴⁰ texels.
    #[inline(always)]
    fn at(&self, i: usize, [s, t]: [f64; 2]) -> (&'a Texture, [f64; 2]) {
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

    fn four(&self, i: usize, position: [f64; 2]) -> Lookup {
        let (level, [s, t]) = self.at(i, position);
        let value = bilinear(level, self.wrap, s, t);
        Lookup { value, texels: 4, level: i as f32, ..self.none() }
    }

    /// The mean over an ellipse, `scan` being its sum in one level.
    #[inline(always)]
    fn ellipse(&self, request: &Request, scan: &impl Scanner) -> Lookup {
        let Request { position, j, filter, fixed } = *request;
        let mut shape = Shape::of(j, filter);
        // The axes are not free, and a fixed level without a limit needs none.
        let mut minor = 0.0;
        if fixed.is_none() || filter.anisotropy < f32::INFINITY {
            (shape, minor) = shape.limited(f64::from(filter.anisotropy));
        }
        let (first, fraction) = match fixed {
            Some(i) => (i, 0.0),
            None => {
                let level = self.ellipse_level(&shape, minor, filter);
                (level as usize, level - level.floor())
            }
        };
        let level = first as f32 + fraction;
        let mut found = Lookup { value: [0.0; 4], texels: 0, level, fallback: false, refused: false };
        // One loop, so that the scan is compiled once.
        let last = first + usize::from(fraction > 0.0);
        for i in first..last + 1 {
            let (level, place) = self.at(i, position);
            let footprint = shape.in_level(self.ratios[i], filter.padding);
            let mut mean = None;
            if self.is_point(i) {
                mean = Some(level.texel(0, 0));
                found.texels += 1;
            } else if footprint.determinant > 0.0 {
                if !is_readable(&footprint) {
                    return Lookup { level: found.level, refused: true, ..self.none() };
                }
                let sum = scan.sum(level, Placed::new(place, footprint), shape.tilt);
                mean = sum.mean();
                found.texels += sum.texels;
            }
            let value = mean.unwrap_or_else(|| {
                found.fallback = true;
                found.texels += 4;
                bilinear(level, self.wrap, place[0], place[1])
            });
            if i == first {
                found.value = value;
            } else {
                // Exact where the two are the same.
                found.value =
                    std::array::from_fn(|c| found.value[c] + fraction * (value[c] - found.value[c]));
            }
        }
        found
    }

    /// The level by the minor axis, or the first above it whose ellipse can be read.
    #[inline(always)]
    fn ellipse_level(&self, shape: &Shape, minor: f64, filter: &EllipseFilter) -> f32 {
        let cover = f64::from(filter.cover);
        let mut level = self.level(minor / (cover * cover));
        while !(self.is_point(level as usize)
            || is_readable(&shape.in_level(self.ratios[level as usize], filter.padding)))
        {
            level = (level as usize + 1) as f32;
        }
        level
    }
}

/// An elliptical lookup.
#[derive(Clone, Copy)]
struct Request<'f> {
    position: [f64; 2],
    j: Jacobian<f32>,
    filter: &'f EllipseFilter,
    fixed: Option<usize>,
}

/// How the texels of an ellipse are summed. Not a closure: those cannot be told to be inlined.
trait Scanner {
    fn sum(&self, level: &Texture, placed: Placed, tilt: Option<f64>) -> Sum;
}

struct Careful<'f> {
    wrap: Wrap,
    filter: &'f EllipseFilter,
}

impl Scanner for Careful<'_> {
    fn sum(&self, level: &Texture, placed: Placed, tilt: Option<f64>) -> Sum {
        careful(level, self.wrap, &placed, self.filter.weight, tilt, self.filter.rim)
    }
}

/// The whole lookup, compiled for each vector unit: what it computes once would cost as much as a small
/// ellipse itself if it went through memory.
struct Lanes<'s, 'a, W, const C: usize> {
    sampler: &'s Sampler<'a>,
    request: &'s Request<'s>,
    weight: W,
}

impl<W: LaneWeight, const C: usize> Scanner for Lanes<'_, '_, W, C> {
    #[inline(always)]
    fn sum(&self, level: &Texture, placed: Placed, _: Option<f64>) -> Sum {
        Scan::<W, C> { level, wrap: self.sampler.wrap, placed, weight: self.weight }.sum()
    }
}

impl<W: LaneWeight, const C: usize> Job for Lanes<'_, '_, W, C> {
    type Output = Lookup;

    #[inline(always)]
    fn run(self) -> Lookup {
        self.sampler.ellipse(self.request, &self)
    }
}
