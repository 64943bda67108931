//! The elliptical filter's parameters.

use super::FilterError;
use crate::kernel::pixel::{Padding, PixelWeight, TiltFormula};

/// Which axes the ellipse has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxesKind {
    /// Those of the conic, M = J Jᵀ.
    True,
    /// The pixel paper's: half lengths of the two derivative vectors, (10), the first along the tilt, (5).
    /// The same ellipse where the two vectors are perpendicular, another where they are skew.
    Paper(TiltFormula),
}

impl AxesKind {
    /// All three.
    pub const ALL: [AxesKind; 3] =
        [AxesKind::True, AxesKind::Paper(TiltFormula::Vector), AxesKind::Paper(TiltFormula::Conic)];

    /// `conic`, `paper-vector` or `paper-conic`.
    pub fn id(self) -> &'static str {
        match self {
            AxesKind::True => "conic",
            AxesKind::Paper(TiltFormula::Vector) => "paper-vector",
            AxesKind::Paper(TiltFormula::Conic) => "paper-conic",
        }
    }

    /// The one with this id.
    pub fn from_id(id: &str) -> Option<AxesKind> {
        AxesKind::ALL.into_iter().find(|kind| kind.id() == id)
    }
}

/// How texels on the ellipse's rim count: readings of "in proportion to the area the ellipse cuts off". A texel
/// whose square the ellipse does not touch counts in none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rim {
    /// Whole where Q ≤ 1 at the centre, not at all elsewhere.
    None,
    /// By the exact area of the texel's square inside the ellipse.
    Area,
    /// By the area of the texel's square on the inner side of a line, the rim's tangent at the centre's
    /// distance from the rim.
    HalfPlane,
    /// By the pixel's volume P(d) = 0.5 - d (2.151 - 2.358 d) in place of the area; d the distance of the
    /// centre from the rim: 1 - P(d) inside, P(d) outside, 1 and 0 from d = ½ on.
    Volume,
}

impl Rim {
    /// All four.
    pub const ALL: [Rim; 4] = [Rim::None, Rim::Area, Rim::HalfPlane, Rim::Volume];

    /// `none`, `area`, `half-plane` or `volume`.
    pub fn id(self) -> &'static str {
        match self {
            Rim::None => "none",
            Rim::Area => "area",
            Rim::HalfPlane => "half-plane",
            Rim::Volume => "volume",
        }
    }

    /// The one with this id.
    pub fn from_id(id: &str) -> Option<Rim> {
        Rim::ALL.into_iter().find(|rim| rim.id() == id)
    }
}

/// The weighted mean over the ellipse under a pixel.
///
/// ```
/// use bellfit::filter::EllipseFilter;
/// let filter = EllipseFilter { anisotropy: 16.0, ..EllipseFilter::default() };
/// assert!(filter.check().is_ok());
/// assert!(EllipseFilter { anisotropy: 0.5, ..filter }.check().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipseFilter {
    /// Of a texel, by its place in the ellipse.
    pub weight: PixelWeight<f32>,
    /// Whether one texel of the level that is read is added to the ellipse: M + I.
    pub padding: Padding,
    /// Which axes.
    pub axes: AxesKind,
    /// Longest ratio of the axes: a longer ellipse has its minor axis raised. 1 or more; +∞: no limit.
    pub anisotropy: f32,
    /// How texels on the rim count.
    pub rim: Rim,
    /// Texels of the finer level that the minor semi-axis spans at least, where the level is chosen:
    /// 1/16 to 1024.
    pub cover: f32,
}

impl Default for EllipseFilter {
    /// The cubic bell with K = 4 and σ = 1/3 (the paper's L/6), padded, true axes, no limit, the plain
    /// rim, at least two texels.
    fn default() -> Self {
        EllipseFilter {
            weight: PixelWeight::Cubic(4, 1.0 / 3.0),
            padding: Padding::Padded,
            axes: AxesKind::True,
            anisotropy: f32::INFINITY,
            rim: Rim::None,
            cover: 2.0,
        }
    }
}

impl EllipseFilter {
    /// Whether every parameter lies in its domain.
    pub fn check(&self) -> Result<(), FilterError> {
        let (power, allowed): (_, &[u32]) = match self.weight {
            PixelWeight::Bell(power, _) => (power, &[2, 4, 8, 16, 32, 64]),
            PixelWeight::Cubic(power, _) => (power, &[2, 4, 8]),
            _ => (2, &[2]),
        };
        if !allowed.contains(&power) {
            let allowed = if allowed.len() > 3 { "2, 4, 8, 16, 32 or 64" } else { "2, 4 or 8" };
            return Err(FilterError::Power { power, allowed });
        }
        if let PixelWeight::Gaussian(sigma) | PixelWeight::Bell(_, sigma) | PixelWeight::Cubic(_, sigma) =
            self.weight
            && !(1.0 / 1024.0..=1024.0).contains(&sigma)
        {
            return Err(FilterError::Sigma { sigma });
        }
        if self.anisotropy.is_nan() || self.anisotropy < 1.0 {
            return Err(FilterError::Anisotropy { limit: self.anisotropy });
        }
        if !(0.0625..=1024.0).contains(&self.cover) {
            return Err(FilterError::Cover { cover: self.cover });
        }
        Ok(())
    }
}
