//! One's own constants: a factor, what it normalises, and what is asked of it.

use super::Printed;
use crate::bound::{Formula, PolynomialBell};
use crate::fit::Exponents;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::kernel::stand_in::StandIn;

/// The lobe that a factor stands before.
#[derive(Clone, Debug, PartialEq)]
pub enum ClaimedLobe {
    /// cosⁿ or the lobe paper's cs_16, which runs on to the limit.
    Table(Lobe),
    /// A bell whose coefficients depend on n, for n ≥ 16.
    StandIn(StandIn),
    /// A bell by its coefficients: the reader's own, or Lyon's (1 - t/K)^K.
    Polynomial {
        /// The name in files.
        name: String,
        /// The bell.
        bell: PolynomialBell,
    },
}

impl ClaimedLobe {
    /// The names that files know, a polynomial's last.
    pub const IDS: [&'static str; 16] = [
        "cos-n",
        "cs16",
        "cs2",
        "cs4",
        "cs8",
        "cs32",
        "cs64",
        "linear-2",
        "linear-4",
        "linear-8",
        "linear-16",
        "linear-32",
        "cubic-2",
        "cubic-4",
        "cubic-8",
        "polynomial",
    ];

    /// The name in files.
    pub fn id(&self) -> &str {
        match self {
            ClaimedLobe::Table(lobe) => lobe.id(),
            ClaimedLobe::StandIn(stand_in) => stand_in.id(),
            ClaimedLobe::Polynomial { name, .. } => name,
        }
    }
}

/// 2π coef(n) Int(n) - 1, the residual, stays within what is asked, for every n of a range.
#[derive(Clone, Debug, PartialEq)]
pub struct Normalisation {
    /// The model, its convention included.
    pub model: Model,
    /// The lobe.
    pub lobe: ClaimedLobe,
    /// How far it is integrated.
    pub limit: Limit,
    /// coef(n).
    pub factor: Formula,
    /// coef(n) as the file writes it.
    pub text: String,
    /// Which n.
    pub n: Exponents,
    /// |residual| is at most this decimal.
    pub bound: Option<Printed>,
    /// The residual is at most 0.
    pub never_gains: bool,
    /// The residual is at least the negative of this decimal.
    pub loss: Option<Printed>,
}
