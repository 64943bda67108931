//! The number formats of a lobe's arithmetic, and how its angle is handed over.

use crate::kernel::stand_in::Argument;

/// The number format of a lobe's arithmetic; rounding to nearest, ties to even, subnormal numbers kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Format {
    /// IEEE 754 binary16, every operation rounded to it.
    Half,
    /// binary16 for what is stored, arguments and result; binary32 for the arithmetic between and for a material's
    /// constants.
    HalfStored,
    /// binary32.
    Single,
    /// binary64.
    Double,
}

impl Format {
    /// All four.
    pub const ALL: [Format; 4] = [Format::Half, Format::HalfStored, Format::Single, Format::Double];

    /// The name in files and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Format::Half => "f16",
            Format::HalfStored => "f16-stored",
            Format::Single => "f32",
            Format::Double => "f64",
        }
    }

    /// The format with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::bound::Format;
    /// assert!(Format::ALL.iter().all(|format| Format::from_id(format.id()) == Some(*format)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.id() == id)
    }

    /// u, the largest relative error of one rounding of the arithmetic: 2⁻¹¹, 2⁻²⁴ (for what is stored as
    /// binary16 too) or 2⁻⁵³.
    ///
    /// ```
    /// use bellfit::bound::Format;
    /// assert_eq!(Format::Single.unit_roundoff(), f64::from(f32::EPSILON) / 2.0);
    /// ```
    pub const fn unit_roundoff(self) -> f64 {
        match self {
            Format::Half => 1.0 / 2048.0,
            Format::HalfStored | Format::Single => f32::EPSILON as f64 / 2.0,
            Format::Double => f64::EPSILON / 2.0,
        }
    }
}

/// How the lobe's angle is handed over, rounded to the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Handed {
    /// cos θ, rounded once: a dot product at its best.
    Cosine,
    /// 1 - cos θ, rounded once.
    Versine,
    /// |a - b|²/2, computed in the format from two unit vectors whose components are rounded once.
    Difference,
}

impl Handed {
    /// All three.
    pub const ALL: [Handed; 3] = [Handed::Cosine, Handed::Versine, Handed::Difference];

    /// The name in files and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Handed::Cosine => "cosine",
            Handed::Versine => "versine",
            Handed::Difference => "difference",
        }
    }

    /// The way with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::bound::Handed;
    /// assert!(Handed::ALL.iter().all(|handed| Handed::from_id(handed.id()) == Some(*handed)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|handed| handed.id() == id)
    }

    /// What the lobe takes.
    pub const fn argument(self) -> Argument {
        match self {
            Handed::Cosine => Argument::Cosine,
            Handed::Versine | Handed::Difference => Argument::Versine,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_exact_names_are_known() {
        assert_eq!(Handed::from_id("versine"), Some(Handed::Versine));
        assert!(["", "Versine", "versine "].iter().all(|id| Handed::from_id(id).is_none()));
    }

    /// IEEE 754, table 3.5: precisions of 11, 24 and 53 digits, of which rounding to nearest loses half a unit.
    #[test]
    fn units_are_those_of_the_standard() {
        let units = Format::ALL.map(|format| libm::log2(format.unit_roundoff()));
        assert_eq!(units, [-11.0, -24.0, -24.0, -53.0]);
        let arguments = Handed::ALL.map(Handed::argument);
        assert_eq!(arguments, [Argument::Cosine, Argument::Versine, Argument::Versine]);
    }
}
