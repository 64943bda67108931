//! What is integrated: the lobe, and how far.

use crate::kernel::model::Model;

/// The lobe under the integral.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Lobe {
    /// cosⁿ of the lobe's own angle.
    CosN,
    /// The lobe paper's cs_16, (n/16 (cos θ - 1) + 1)^16, equation (1).
    Cs16,
}

impl Lobe {
    /// Both, in the tables' order.
    pub const ALL: [Lobe; 2] = [Lobe::CosN, Lobe::Cs16];

    /// The name used in files and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Lobe::CosN => "cos-n",
            Lobe::Cs16 => "cs16",
        }
    }

    /// The lobe of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lobe| lobe.id() == id)
    }

    /// The limits for which the tables hold this lobe's integral.
    pub const fn limits(self) -> &'static [Limit] {
        match self {
            Lobe::CosN => &[Limit::Support],
            Lobe::Cs16 => &Limit::ALL,
        }
    }
}

/// The upper limit of integration in θ, never beyond π/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Limit {
    /// 6/√n, as the lobe paper's digits add up (L3).
    Paper,
    /// arccos(max(0, 1 - 16/n)), the zero of cs_16, taken in θ for every model.
    ExactZero,
    /// Where the lobe is nonzero: twice the exact zero for the lobes in θ/2.
    Support,
    /// √(6/n), as the project's brief wrote.
    Card,
}

impl Limit {
    /// All four, in the tables' order.
    pub const ALL: [Limit; 4] = [Limit::Paper, Limit::ExactZero, Limit::Support, Limit::Card];

    /// The name used in files and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Limit::Paper => "paper",
            Limit::ExactZero => "exact-zero",
            Limit::Support => "support",
            Limit::Card => "card",
        }
    }

    /// The limit of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|limit| limit.id() == id)
    }
}

/// One integral of the tables: which model, lobe and limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Case {
    /// The BRDF model, which fixes the integrand's cosines.
    pub model: Model,
    /// The lobe.
    pub lobe: Lobe,
    /// The upper limit.
    pub limit: Limit,
}

impl Case {
    /// Every case of the tables: six models, and for each cosⁿ on its support and cs_16 on the
    /// four limits.
    pub fn all() -> impl Iterator<Item = Case> {
        Model::ALL.into_iter().flat_map(|model| {
            Lobe::ALL
                .into_iter()
                .flat_map(move |lobe| lobe.limits().iter().map(move |&limit| Case { model, lobe, limit }))
        })
    }
}

impl core::fmt::Display for Case {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}, {}, {}", self.model.id(), self.lobe.id(), self.limit.id())
    }
}
