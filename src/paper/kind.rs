//! The kinds of statement a claims file can make. The judge dispatches on these alone.

use super::{Normalisation, PixelKind, Printed};
use crate::bound::{Formula, Gaussian};
use crate::fit::{Form, Objective};
use crate::integral::albedo::Reflectance;
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;

/// Which extreme of a function is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statistic {
    /// The largest value, signed.
    Max,
    /// The largest absolute value.
    MaxAbs,
    /// The smallest value, signed.
    Min,
}

/// How the printed number and the computed one are said to relate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The computed number prints as these digits.
    Equal,
    /// The computed number is at most the printed decimal.
    AtMost,
}

/// What n ranges over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// The integers of the range, ends included.
    Integers,
    /// Every real number of the range.
    Reals,
}

/// How an approximate cut is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutForm {
    /// c/√n.
    OverRoot,
    /// √(c/n).
    RootOver,
}

/// What "less by order" means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// sup over the whole range below the other's sup.
    Less,
    /// At most a tenth of it.
    Tenth,
    /// Below it at every n of the range by itself.
    EachN,
}

/// A statement with its parameters. `n` is always a closed range of the specular exponent.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A convention or a figure: nothing to judge, regenerated at `place`.
    Definition {
        /// Where.
        place: String,
    },
    /// What is asked of the residual of one's own constants, for any lobe.
    Normalisation(Box<Normalisation>),
    /// An extreme of 2π coef(n) Int(n) - 1; without a printed number, a figure.
    FactorResidual {
        /// The integral.
        case: Case,
        /// coef(n).
        factor: Formula,
        /// coef(n) as the file writes it.
        text: String,
        /// First and last n.
        n: (u32, u32),
        /// Integers or reals.
        over: Over,
        /// Which extreme.
        statistic: Statistic,
        /// Equal or at most.
        relation: Relation,
        /// The number, if one is printed.
        printed: Option<Printed>,
        /// Where the figure is regenerated, if no number is printed.
        place: Option<String>,
    },
    /// 2π coef(n) Int(n) ≤ 1: the factor never gains energy.
    Energy {
        /// The integral.
        case: Case,
        /// coef(n).
        factor: Formula,
        /// First and last n.
        n: (u32, u32),
        /// Integers or reals.
        over: Over,
    },
    /// The directional albedo is at most 1 at every angle of incidence, for every whole n.
    EnergyAtEveryAngle {
        /// The model and its use.
        reflectance: Reflectance,
        /// The lobe, on its whole support.
        lobe: Lobe,
        /// coef(n).
        factor: Formula,
        /// First and last n.
        n: (u32, u32),
    },
    /// An extreme of cosⁿθ - cs_16 over every real n and θ.
    LobeDifference {
        /// Where cs_16 is cut.
        cut: Limit,
        /// First and last n.
        n: (u32, u32),
        /// Which extreme: max or min.
        statistic: Statistic,
        /// Equal or at most (for a minimum: at least).
        relation: Relation,
        /// The number.
        printed: Printed,
    },
    /// The cut of (1) is c/√n or √(c/n) with this c, to its printed digits.
    Cut {
        /// Which form.
        form: CutForm,
        /// First and last n.
        n: (u32, u32),
        /// c.
        printed: Printed,
    },
    /// Replacing the exact cut changes Δ by less than Δ itself.
    CutEffect {
        /// The approximate cut.
        cut: Limit,
        /// First and last n.
        n: (u32, u32),
        /// In which sense.
        comparison: Comparison,
    },
    /// The zero of (1): cos θ at it, as a formula in n.
    LobeZero {
        /// cos θ.
        zero: Formula,
    },
    /// The factor is exactly 1/(2π Int(n)) of cosⁿ.
    FactorIdentity {
        /// The model.
        model: Model,
        /// coef(n).
        factor: Formula,
        /// coef(n) as the file writes it.
        text: String,
    },
    /// lower(n) < upper(n) for every real n from some n on.
    FactorInequality {
        /// The smaller side.
        lower: Formula,
        /// The larger side.
        upper: Formula,
        /// From which even n on.
        from: u32,
    },
    /// Two models have the same Int(n), so the same factor.
    SameIntegral {
        /// One model.
        model: Model,
        /// The other.
        other: Model,
    },
    /// Least squares gives these digits.
    Fit {
        /// The integral.
        case: Case,
        /// The objective.
        objective: Objective,
        /// Which unknowns are free.
        form: Form,
        /// First and last n.
        n: (u32, u32),
        /// a as printed.
        a: Printed,
        /// b as printed, for the linear form.
        b: Option<Printed>,
    },
    /// sup |cosⁿ - Gaussian| falls as n grows, for every real n.
    GaussianFalls {
        /// Which Gaussian.
        gaussian: Gaussian,
        /// First and last n.
        n: (u32, u32),
    },
    /// sup |cosⁿ - Gaussian| over the range is below sup |cosⁿ - cs_16|.
    GaussianBeatsLobe {
        /// Which Gaussian.
        gaussian: Gaussian,
        /// First and last n.
        n: (u32, u32),
    },
    /// sup |e^-t - (1 - t/K)^K| falls as K grows through these.
    BellFalls {
        /// The powers K, ascending.
        powers: Vec<u32>,
    },
    /// A statement about pixels.
    Pixel(Box<PixelKind>),
}

impl Kind {
    /// Every kind's name in claims files: first the kind for one's own constants, then those that the papers' files
    /// need. [`super::schema`] tells the keys of each.
    pub const IDS: [&'static str; 36] = [
        "normalisation",
        "factor-identity",
        "factor-inequality",
        "factor-residual",
        "energy",
        "energy-at-every-angle",
        "same-integral",
        "fit",
        "lobe-difference",
        "lobe-zero",
        "cut",
        "cut-effect",
        "gaussian-falls",
        "gaussian-beats-lobe",
        "bell-falls",
        "definition",
        "derivatives-agree",
        "conic",
        "gaussian-volume",
        "gaussian-beyond-base",
        "rotation",
        "tilt",
        "axis-formula",
        "axes",
        "bell-number",
        "bell-is-nearest",
        "bell-uncut",
        "weight-number",
        "weight-on-rim",
        "weight",
        "weight-is-nearest",
        "clipped-volume",
        "clipped-volume-distance",
        "clipped-volume-fit",
        "rim-texel",
        "rim-volume",
    ];

    /// The name in claims files.
    pub const fn id(&self) -> &'static str {
        match self {
            Kind::Definition { .. } => "definition",
            Kind::Normalisation(_) => "normalisation",
            Kind::FactorResidual { .. } => "factor-residual",
            Kind::Energy { .. } => "energy",
            Kind::EnergyAtEveryAngle { .. } => "energy-at-every-angle",
            Kind::LobeDifference { .. } => "lobe-difference",
            Kind::Cut { .. } => "cut",
            Kind::CutEffect { .. } => "cut-effect",
            Kind::LobeZero { .. } => "lobe-zero",
            Kind::FactorIdentity { .. } => "factor-identity",
            Kind::FactorInequality { .. } => "factor-inequality",
            Kind::SameIntegral { .. } => "same-integral",
            Kind::Fit { .. } => "fit",
            Kind::GaussianFalls { .. } => "gaussian-falls",
            Kind::GaussianBeatsLobe { .. } => "gaussian-beats-lobe",
            Kind::BellFalls { .. } => "bell-falls",
            Kind::Pixel(kind) => kind.id(),
        }
    }
}
