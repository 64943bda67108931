//! What a scene needs of a kernel.

use super::{EnergyDemand, Exponents};
use crate::bound::{ELEMENTARY_ULPS, Format, Handed, Measure};
use crate::kernel::model::Model;
use crate::kernel::stand_in::StandIn;
use thiserror::Error;

/// Why a need cannot be met or read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum NeedError {
    /// No range of exponents.
    #[error("n = \"{text}\": a range A..B, or one number, needs 1 ≤ A ≤ B ≤ 1e12")]
    Exponents {
        /// As given.
        text: String,
    },
    /// No range of roughnesses.
    #[error("roughness \"{text}\": a range A..B, or one number, needs 0 < A ≤ B ≤ 1")]
    Roughness {
        /// As given.
        text: String,
    },
    /// An n below 1.
    #[error("roughness {alpha}: n = 2/α² - 2 is {n:.4}, and lobes are asked for with n ≥ 1 (α ≤ 0.8164)")]
    TooRough {
        /// α.
        alpha: f64,
        /// Its exponent.
        n: f64,
    },
    /// An n beyond 1e12.
    #[error(
        "roughness {alpha}: n = 2/α² - 2 is {n:.4e}, and lobes are asked for with n ≤ 1e12 (α ≥ 1.42e-6)"
    )]
    TooSmooth {
        /// α.
        alpha: f64,
        /// Its exponent.
        n: f64,
    },
    /// An error out of its domain.
    #[error("{name} {value}: more than 0 and at most 1 is needed")]
    Error {
        /// Which.
        name: &'static str,
        /// As given.
        value: f64,
    },
    /// A floor out of its domain.
    #[error("floor {value}: a part of the peak, at least 1e-300 and less than 1, is needed")]
    Floor {
        /// As given.
        value: f64,
    },
    /// An accuracy of elementary functions out of its domain.
    #[error("ulps {value}, of the elementary functions: from 0.5 to 1e6 are needed")]
    Ulps {
        /// As given.
        value: f64,
    },
    /// Energy without a model.
    #[error("energy {energy}: of no use without a model, whose integral it is of")]
    NoModel {
        /// The demand's name.
        energy: &'static str,
    },
    /// A range of whole n with none in it.
    #[error("n = {range}: no whole number lies in it")]
    NoWhole {
        /// The range.
        range: Exponents,
    },
    /// A weight of the costs out of its domain.
    #[error("weight {value} of a {name}: a number of operations from 0 to 1e6 is needed")]
    Weight {
        /// Which.
        name: &'static str,
        /// As given.
        value: f64,
    },
}

/// What is asked of a kernel for every angle in [0, π/2] and every n of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// The exponents.
    pub n: Exponents,
    /// The largest error against cosⁿ, rounding included.
    pub max_error: f64,
    /// What an error is: of the peak, or of the value where that is at least a part of the peak.
    pub measure: Measure,
    /// The arithmetic.
    pub format: Format,
    /// How the lobe's angle is handed over.
    pub handed: Handed,
    /// The model whose factor comes along.
    pub model: Option<Model>,
    /// What is asked of lobe and factor together.
    pub energy: Option<EnergyDemand>,
    /// Whether a kernel may divide.
    pub division: bool,
    /// Whether a kernel may take an exponential, a logarithm or the like.
    pub transcendental: bool,
    /// Units in the last place within which exp, exp2, log2, log1p and pow are taken to be.
    pub ulps: f64,
    /// Asks of one kernel alone.
    pub only: Option<StandIn>,
}

impl Need {
    /// An absolute error in `f32` with cos θ handed over, nothing else asked.
    ///
    /// ```
    /// use bellfit::{bound::Format, choose::Need};
    /// let need = Need { format: Format::Double, ..Need::new("16..64".parse()?, 1e-4) };
    /// assert!(need.check().is_ok());
    /// assert!(Need { max_error: -1.0, ..need }.check().is_err());
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn new(n: Exponents, max_error: f64) -> Self {
        Need {
            n,
            max_error,
            measure: Measure::Absolute,
            format: Format::Single,
            handed: Handed::Cosine,
            model: None,
            energy: None,
            division: true,
            transcendental: true,
            ulps: ELEMENTARY_ULPS,
            only: None,
        }
    }

    /// Whether every number lies in its domain.
    ///
    /// # Errors
    /// The first [`NeedError`] there is.
    pub fn check(&self) -> Result<(), NeedError> {
        let within = |name, value: f64| {
            if value > 0.0 && value <= 1.0 { Ok(()) } else { Err(NeedError::Error { name, value }) }
        };
        within("max-error", self.max_error)?;
        if let Measure::Relative { floor } = self.measure
            && !(1e-300..1.0).contains(&floor)
        {
            return Err(NeedError::Floor { value: floor });
        }
        if !(0.5..=1e6).contains(&self.ulps) {
            return Err(NeedError::Ulps { value: self.ulps });
        }
        if let Some(demand) = self.energy {
            if self.model.is_none() {
                return Err(NeedError::NoModel { energy: demand.id() });
            }
            if let EnergyDemand::Unbiased { error } = demand {
                within("energy-error", error)?;
            }
        }
        Ok(())
    }
}
