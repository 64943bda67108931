//! What is fitted: Int(n) over a range, and what counts as close.

use crate::bound::Interval;
use crate::bound::integral_enclosure;
use crate::integral::Case;
use crate::kernel::model::LobeAngle;
use thiserror::Error;

/// What a fit minimises. With res(n) = 2π coef(n) Int(n) - 1:
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Objective {
    /// Σ (a n + b - divisor/(2 Int(n)))²: squares of the error of coef itself.
    LsAbsolute,
    /// Σ res(n)²: squares of the error relative to the exact coef.
    LsRelative,
    /// max |res(n)|.
    Minimax,
    /// max -res(n), with res(n) ≤ 0 for every real n of the range: the factor never gains energy.
    OneSided,
    /// The same over all parameters of so many significant digits.
    OneSidedRounded,
}

impl Objective {
    /// Those that err to both sides, in the tables' order.
    pub const ALL: [Objective; 3] = [Objective::LsAbsolute, Objective::LsRelative, Objective::Minimax];
    /// Those that never gain energy.
    pub const ONE_SIDED: [Objective; 2] = [Objective::OneSided, Objective::OneSidedRounded];

    /// The name in files and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Objective::LsAbsolute => "ls-absolute",
            Objective::LsRelative => "ls-relative",
            Objective::Minimax => "minimax",
            Objective::OneSided => "one-sided",
            Objective::OneSidedRounded => "one-sided-rounded",
        }
    }

    /// The objective of [`Objective::ALL`] of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|objective| objective.id() == id)
    }
}

/// Which of a and b are free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// a n + b.
    Linear,
    /// a n, with b = 0.
    Proportional,
}

impl Form {
    /// Both.
    pub const ALL: [Form; 2] = [Form::Linear, Form::Proportional];

    /// The name in claims and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Form::Linear => "linear",
            Form::Proportional => "proportional",
        }
    }

    /// The form of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.id() == id)
    }
}

/// Why a fit cannot be made.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FitError {
    /// The range of n is empty, reversed or outside 1..=65536.
    #[error("n = {from}..{to}: a range A..B needs 1 ≤ A ≤ B ≤ 65536")]
    Range {
        /// First n.
        from: u32,
        /// Last n.
        to: u32,
    },
    /// No range of real n.
    #[error("n = \"{text}\": a range A..B of real n needs 1 ≤ A < B, plain decimals; B may be inf")]
    Reals {
        /// As given.
        text: String,
    },
    /// An objective that a form, range or number of digits does not have.
    #[error("{objective}, {form}: {reason}")]
    Unsupported {
        /// The objective's name.
        objective: &'static str,
        /// The form's name.
        form: &'static str,
        /// Why, with the value and the domain.
        reason: String,
    },
    /// Fewer values of n than the form has unknowns (minimax: one more).
    #[error("n = {from}..{to}: {needed} values of n are needed and {} given", to - from + 1)]
    TooFew {
        /// First n.
        from: u32,
        /// Last n.
        to: u32,
        /// How many are needed.
        needed: u32,
    },
    /// The optimiser gave no finite answer.
    #[error("{method} found no finite optimum for {case}")]
    NoOptimum {
        /// Which method.
        method: &'static str,
        /// For which integral.
        case: String,
    },
    /// Two methods that must agree do not.
    #[error("{case}: {left} gives {found}, and {right} {other}")]
    Disagreement {
        /// For which integral and objective.
        case: String,
        /// One method.
        left: &'static str,
        /// Its a and b.
        found: String,
        /// The other.
        right: &'static str,
        /// Its a and b.
        other: String,
    },
}

/// Int(n) over the integers of a range, ready to be fitted.
#[derive(Clone, Debug)]
pub struct Problem {
    /// Which integral.
    pub case: Case,
    /// First n.
    pub from: u32,
    /// Last n.
    pub to: u32,
    /// The d of coef(n) = (a n + b)/(d π): 2, or 8 for the lobes in θ/2, as the lobe paper prints.
    pub divisor: u32,
    /// (n, Int(n)), Int from the middle of its enclosure.
    pub points: Vec<(f64, f64)>,
}

impl Problem {
    /// The integers from..=to of `case`.
    ///
    /// # Errors
    /// [`FitError::Range`] for an empty, reversed or too large range.
    pub fn new(case: Case, from: u32, to: u32) -> Result<Self, FitError> {
        if from < 1 || to < from || to > 65_536 {
            return Err(FitError::Range { from, to });
        }
        let divisor = match case.model.angle() {
            LobeAngle::Full => 2,
            LobeAngle::Half => 8,
        };
        let int = |n: f64| integral_enclosure(case, n).mid();
        let points = (from..=to).map(|n| (f64::from(n), int(f64::from(n)))).collect();
        Ok(Problem { case, from, to, divisor, points })
    }

    /// # Errors
    /// [`FitError::TooFew`] when the range has fewer than `needed` integers.
    pub fn require(&self, needed: u32) -> Result<(), FitError> {
        if self.points.len() < needed as usize {
            return Err(FitError::TooFew { from: self.from, to: self.to, needed });
        }
        Ok(())
    }

    /// (2 n Int/divisor, 2 Int/divisor): res(n) = a p + b q - 1.
    pub fn columns(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let scale = 2.0 / f64::from(self.divisor);
        self.points.iter().map(move |&(n, int)| (scale * n * int, scale * int))
    }

    /// The range as an interval.
    pub fn range(&self) -> Interval {
        Interval::new(f64::from(self.from), f64::from(self.to))
    }
}
