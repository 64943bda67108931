//! The kinds of statement about pixels: footprints, their axes, weights, and clipped volumes.

use super::Printed;
use super::pixel_words::{
    AxesProperty, Base, BellFigure, ClipProperty, ConstantTerm, Denominator, Octant, Region, RimShare, Shape,
    Sign, SignPair, Vectors, WeightFigure, WeightProperty,
};
use crate::bound::ClippedPixel;
use crate::kernel::pixel::{PaperReading, TiltFormula};

/// P(d) = constant ± d (linear ± square d).
#[derive(Clone, Debug, PartialEq)]
pub struct ClipFormula {
    /// The volume at d = 0.
    pub constant: Printed,
    /// Of d.
    pub linear: Printed,
    /// Of d².
    pub square: Printed,
    /// Before d.
    pub sign: Sign,
    /// Before d² within the parentheses.
    pub inner: Sign,
}

/// A reading of (9) against the Gaussian with σ = L/divisor.
#[derive(Clone, Debug, PartialEq)]
pub struct WeightFormula {
    /// Which scale.
    pub reading: PaperReading,
    /// Sum or product.
    pub shape: Shape,
    /// σ is the axis by this.
    pub divisor: Printed,
}

/// A statement about pixels with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum PixelKind {
    /// Forward differences are the derivatives of the mapping.
    DerivativesAgree {
        /// For which denominators.
        denominator: Denominator,
    },
    /// A U² + B U V + C V² = F is the image of a circle.
    Conic {
        /// B's.
        sign: Sign,
        /// F's.
        inner: Sign,
        /// Which circle.
        base: Base,
    },
    /// The volume of (3) with σ = axis/divisor is 1.
    GaussianVolume {
        /// σ is the axis by this.
        divisor: Printed,
        /// Over what.
        region: Region,
    },
    /// What of (3) lies beyond the ellipse: a figure.
    GaussianBeyondBase {
        /// σ is the axis by this.
        divisor: Printed,
        /// Where it is shown.
        place: String,
    },
    /// (3) of the rotated coordinates has its first axis at +α.
    Rotation {
        /// Of V sin α in u₁.
        sign: Sign,
        /// Of v₁.
        second: SignPair,
    },
    /// The tilt is the direction of the major axis, up to half turns.
    Tilt {
        /// Which tilt.
        formula: TiltFormula,
        /// Where the major axis lies.
        octant: Octant,
        /// How the vectors lie.
        vectors: Vectors,
    },
    /// (10) is four times the squared length of its vector.
    AxisFormula {
        /// B's.
        sign: Sign,
    },
    /// L and d have a property of the ellipse's axes.
    AxesAre {
        /// Which.
        property: AxesProperty,
        /// How the vectors lie.
        vectors: Vectors,
    },
    /// A number about (8).
    BellNumber {
        /// K.
        power: u32,
        /// n.
        exponent: u32,
        /// Which.
        figure: BellFigure,
        /// Where it is shown.
        place: String,
    },
    /// No other n in (8) is nearer to e^(-n x²/2) at this K.
    BellIsNearest {
        /// K.
        power: u32,
        /// n.
        exponent: u32,
    },
    /// (8) to the letter, nowhere cut, approximates e^(-n x²/2) for every x.
    BellUncut {
        /// K.
        power: u32,
        /// n.
        exponent: u32,
    },
    /// A number about (9).
    WeightNumber {
        /// The weight.
        weight: WeightFormula,
        /// Which.
        figure: WeightFigure,
        /// Over what.
        region: Region,
        /// Where it is shown.
        place: String,
    },
    /// The weight (9) less the Gaussian on the ellipse: a figure.
    WeightOnRim {
        /// The weight.
        weight: WeightFormula,
        /// Where it is shown.
        place: String,
    },
    /// (9) has a property.
    WeightHas {
        /// The weight.
        weight: WeightFormula,
        /// Which.
        property: WeightProperty,
    },
    /// No other reading of (9) in this shape is nearer to the Gaussian.
    WeightIsNearest {
        /// The weight.
        weight: WeightFormula,
        /// Over what.
        region: Region,
    },
    /// The clipped volume's formula has a property.
    ClipHas {
        /// The formula.
        formula: ClipFormula,
        /// Which.
        property: ClipProperty,
    },
    /// sup over 0 ≤ d ≤ ½ of the formula's distance from a pixel's clipped volume: a figure.
    ClipDistance {
        /// The formula.
        formula: ClipFormula,
        /// The pixel.
        pixel: ClippedPixel,
        /// Where it is shown.
        place: String,
    },
    /// Least squares over equidistant points of a pixel's clipped volume gives the formula's digits.
    ClipFit {
        /// The formula.
        formula: ClipFormula,
        /// The pixel.
        pixel: ClippedPixel,
        /// How many points, d = 0 and d = ½ among them.
        points: u32,
        /// How the constant is found.
        constant: ConstantTerm,
    },
    /// Texels on the rim count in proportion to the area that the ellipse cuts off.
    RimTexel {
        /// What they count.
        share: RimShare,
    },
    /// The same, counting the formula of the clipped volume.
    RimVolume {
        /// The formula.
        formula: ClipFormula,
    },
}

impl PixelKind {
    /// The name in claims files.
    pub const fn id(&self) -> &'static str {
        match self {
            PixelKind::DerivativesAgree { .. } => "derivatives-agree",
            PixelKind::Conic { .. } => "conic",
            PixelKind::GaussianVolume { .. } => "gaussian-volume",
            PixelKind::GaussianBeyondBase { .. } => "gaussian-beyond-base",
            PixelKind::Rotation { .. } => "rotation",
            PixelKind::Tilt { .. } => "tilt",
            PixelKind::AxisFormula { .. } => "axis-formula",
            PixelKind::AxesAre { .. } => "axes",
            PixelKind::BellNumber { .. } => "bell-number",
            PixelKind::BellIsNearest { .. } => "bell-is-nearest",
            PixelKind::BellUncut { .. } => "bell-uncut",
            PixelKind::WeightNumber { .. } => "weight-number",
            PixelKind::WeightOnRim { .. } => "weight-on-rim",
            PixelKind::WeightHas { .. } => "weight",
            PixelKind::WeightIsNearest { .. } => "weight-is-nearest",
            PixelKind::ClipHas { .. } => "clipped-volume",
            PixelKind::ClipDistance { .. } => "clipped-volume-distance",
            PixelKind::ClipFit { .. } => "clipped-volume-fit",
            PixelKind::RimTexel { .. } => "rim-texel",
            PixelKind::RimVolume { .. } => "rim-volume",
        }
    }

    /// Whether it states a number that nobody prints: a figure, and nothing to judge.
    pub const fn is_figure(&self) -> bool {
        matches!(
            self,
            PixelKind::GaussianBeyondBase { .. }
                | PixelKind::BellNumber { .. }
                | PixelKind::WeightNumber { .. }
                | PixelKind::WeightOnRim { .. }
                | PixelKind::ClipDistance { .. }
        )
    }
}
