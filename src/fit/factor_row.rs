//! One factor from integral to certificate, and the whole set of them.

use super::continuum::Continuum;
use super::digits::round_to;
use super::exchange::{Optimum, lower_bound, minimax};
use super::least_squares::sum_of_squares;
use super::{Factor, FactorForm, FitError, Objective, Reals, one_sided, shortest::shortest};
use crate::bound::{Extremes, Interval, Residual};
use crate::integral::ScaledIntegral;
use crate::kernel::model::Model;

/// Decimals to which parameters are rounded where nothing else is said.
pub const DIGITS: usize = 12;
/// The significant digits for which the set holds a shortest factor.
pub const SHORT_DIGITS: core::ops::RangeInclusive<usize> = 3..=6;
/// Beyond these doubles cannot tell the decimals apart in which a shortest line is searched.
const MOST_SHORT: usize = 8;

/// A fitted factor with its certified residual.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorRow {
    /// The model.
    pub model: Model,
    /// The lobe's name.
    pub lobe: String,
    /// The limit's name.
    pub limit: &'static str,
    /// What was minimised.
    pub objective: Objective,
    /// The factor, rounded.
    pub factor: Factor,
    /// Significant digits of its parameters.
    pub digits: usize,
    /// The range.
    pub range: Reals,
    /// The residual of the rounded factor over every real n of the range, certified.
    pub extremes: Extremes,
    /// A lower bound of max |residual| for this form whatever its parameters, certified.
    pub optimum: f64,
    /// By how much the row's own max |residual| may exceed `optimum`; for a one-sided objective by how
    /// much its loss may exceed 2E/(1 + E), E = `optimum`.
    pub excess: f64,
    /// The n, rising, at which the residual of the minimax form alternates before it is rounded; empty for
    /// sums of squares, and where the form is exact.
    pub alternation: Vec<f64>,
}

impl FactorRow {
    /// The form.
    pub fn form(&self) -> FactorForm {
        self.factor.form()
    }

    /// 2E/(1 + E) with E = [`FactorRow::optimum`], rounded down: what no factor of this form that gains
    /// nothing can lose less than.
    pub fn least_loss(&self) -> f64 {
        one_sided::least_loss(self.optimum).lo()
    }

    /// What the residuals were certified over, as files say it.
    pub const OVER: &'static str = "reals";
}

/// Fits `form` to one integral over every real n of `range` (sums of squares: over its integers), rounds
/// to `digits` significant decimals and certifies what was rounded.
///
/// # Errors
/// [`FitError::Unsupported`] for an objective that the form, the range or the digits do not have;
/// [`FitError::NoOptimum`] if a method fails.
///
/// ```
/// use bellfit::{fit::*, integral::{Case, Limit, Lobe}, kernel::model::Model};
/// let case = Case { model: Model::BlinnPhong, lobe: Lobe::Cs16, limit: Limit::Support };
/// let (range, form) = ("16..1024".parse()?, FactorForm::Linear);
/// let row = fit_factor(&case, range, form, Objective::OneSidedRounded, 3)?;
/// assert_eq!(row.factor.to_string(), "(1.06 n + 1.04)/(8π)");
/// // It never gains energy, and no line loses less than 2E/(1 + E).
/// assert!(row.extremes.max.value.hi() <= 0.0);
/// assert!(-row.extremes.min.value.hi() > 2.0 * row.optimum / (1.0 + row.optimum));
/// # Ok::<(), FitError>(())
/// ```
pub fn fit_factor<I: ScaledIntegral + Clone>(
    integral: &I,
    range: Reals,
    form: FactorForm,
    objective: Objective,
    digits: usize,
) -> Result<FactorRow, FitError> {
    has_doubles(range)?;
    supported(range, form, objective, digits)?;
    let continuum = Continuum::new(integral, range);
    Fitting::new(&continuum, form)?.row(objective, digits)
}

/// The set of the tables, for each integral: the forms that pay, by every objective that they have, to
/// [`DIGITS`]; then the shortest line for each of [`SHORT_DIGITS`].
///
/// A form pays if its minimax row's certified max |residual| is less than half that of every simpler
/// form; the proportional form, the simplest, always stands. Where a line does not pay, the shortest
/// factors are proportional.
///
/// # Errors
/// As for [`fit_factor`].
pub fn factor_rows<I: ScaledIntegral + Clone>(
    integrals: &[I],
    range: Reals,
) -> Result<Vec<FactorRow>, FitError> {
    has_doubles(range)?;
    let mut rows = Vec::new();
    for integral in integrals {
        let continuum = Continuum::new(integral, range);
        let paying = paying(&continuum, &FactorForm::ALL)?;
        for (fitting, best) in &paying {
            if sums(range, fitting.form) {
                rows.push(fitting.row(Objective::LsAbsolute, DIGITS)?);
                rows.push(fitting.row(Objective::LsRelative, DIGITS)?);
            }
            rows.push(best.clone());
            rows.push(fitting.row(Objective::OneSided, DIGITS)?);
        }
        if let Some((line, _)) = paying.iter().rfind(|(f, _)| f.form.as_line().is_some()) {
            for digits in SHORT_DIGITS {
                rows.push(line.row(Objective::OneSidedRounded, digits)?);
            }
        }
    }
    Ok(rows)
}

/// The one-sided row of the line, or the proportional factor where that suffices, to [`DIGITS`] and to
/// each of [`SHORT_DIGITS`].
pub(super) fn shortest_factors<I: ScaledIntegral + Clone>(
    integral: &I,
    range: Reals,
) -> Result<Vec<FactorRow>, FitError> {
    let continuum = Continuum::new(integral, range);
    let paying = paying(&continuum, &[FactorForm::Proportional, FactorForm::Linear])?;
    let mut rows = Vec::new();
    if let Some((line, _)) = paying.last() {
        rows.push(line.row(Objective::OneSided, DIGITS)?);
        for digits in SHORT_DIGITS {
            rows.push(line.row(Objective::OneSidedRounded, digits)?);
        }
    }
    Ok(rows)
}

/// Those of the forms that pay, each with its minimax row.
fn paying<'a, I: ScaledIntegral + Clone>(
    continuum: &'a Continuum<'a, I>,
    forms: &[FactorForm],
) -> Result<Vec<(Fitting<'a, I>, FactorRow)>, FitError> {
    let mut levels: Vec<(FactorForm, Interval)> = Vec::new();
    let mut paying = Vec::new();
    for &form in forms {
        let fitting = Fitting::new(continuum, form)?;
        let best = fitting.row(Objective::Minimax, DIGITS)?;
        let level = best.extremes.magnitude().value;
        let pays = core::iter::successors(form.simpler(), |f| f.simpler())
            .flat_map(|simpler| levels.iter().find(|(f, _)| *f == simpler))
            .all(|(_, of_simpler)| 2.0 * level.hi() < of_simpler.lo());
        levels.push((form, level));
        if pays {
            paying.push((fitting, best));
        }
    }
    Ok(paying)
}

/// A fit samples the range: two doubles of it are needed.
fn has_doubles(range: Reals) -> Result<(), FitError> {
    match range.inward() {
        Some((first, last)) if first < last => Ok(()),
        _ => Err(FitError::Reals { text: range.to_string() }),
    }
}

fn supported(range: Reals, form: FactorForm, objective: Objective, digits: usize) -> Result<(), FitError> {
    let reason = match objective {
        Objective::LsAbsolute | Objective::LsRelative if form == FactorForm::Ratio => {
            "not linear in p3; minimax and one-sided fit it".to_owned()
        }
        Objective::LsAbsolute | Objective::LsRelative if range.whole().is_none() => {
            format!("n = {range}: a sum runs over whole n up to 65536")
        }
        Objective::LsAbsolute | Objective::LsRelative if !sums(range, form) => {
            let (from, to) = range.whole().unwrap_or_default();
            return Err(FitError::TooFew { from, to, needed: form.parameters() as u32 });
        }
        Objective::OneSidedRounded if form.as_line().is_none() => {
            "shortest decimals are searched for linear and proportional".to_owned()
        }
        Objective::OneSidedRounded if !(1..=MOST_SHORT).contains(&digits) => {
            format!("{digits} digits: shortest decimals are searched for 1 to {MOST_SHORT}")
        }
        _ if !(1..=15).contains(&digits) => format!("{digits} digits: 1 to 15 can be told apart"),
        _ => return Ok(()),
    };
    Err(FitError::Unsupported { objective: objective.id(), form: form.id(), reason })
}

/// Whether a sum of squares over the range's integers determines the form.
fn sums(range: Reals, form: FactorForm) -> bool {
    let needed = form.parameters() as u32;
    form != FactorForm::Ratio && range.whole().is_some_and(|(from, to)| to - from + 1 >= needed)
}

/// One form over one range with its minimax solution.
struct Fitting<'a, I> {
    continuum: &'a Continuum<'a, I>,
    form: FactorForm,
    minimax: Optimum,
    optimum: f64,
}

impl<'a, I: ScaledIntegral + Clone> Fitting<'a, I> {
    fn new(continuum: &'a Continuum<'a, I>, form: FactorForm) -> Result<Self, FitError> {
        let minimax = minimax(continuum, form)?;
        let optimum = lower_bound(continuum, form, &minimax);
        Ok(Fitting { continuum, form, minimax, optimum })
    }

    fn row(&self, objective: Objective, digits: usize) -> Result<FactorRow, FitError> {
        let Fitting { continuum, form, minimax, optimum } = self;
        let (form, integral) = (*form, continuum.integral);
        let is_exact = minimax.alternation.is_empty();
        let (factor, largest) = match objective {
            // Zero is the least sum of squares there is.
            Objective::LsAbsolute | Objective::LsRelative if !is_exact => {
                let whole = continuum.reals.whole().unwrap_or_default();
                (self.nearest(&sum_of_squares(integral, whole, objective, form)?, digits)?, None)
            }
            Objective::LsAbsolute | Objective::LsRelative | Objective::Minimax => {
                (self.nearest(&minimax.parameters, digits)?, None)
            }
            Objective::OneSidedRounded if form == FactorForm::Linear => {
                let best = one_sided::optimum(form, minimax);
                let (factor, largest) = shortest(continuum, best[0], digits)?;
                (factor, Some(largest))
            }
            Objective::OneSided | Objective::OneSidedRounded => {
                let best = one_sided::optimum(form, minimax);
                let (factor, largest) = one_sided::rounded(continuum, form, &best, digits)?;
                (factor, Some(largest))
            }
        };
        let (from, to) = continuum.reals.outward();
        let residual = Residual::new(integral.clone(), factor.formula());
        let max = largest.unwrap_or_else(|| residual.largest(from, to));
        let extremes = Extremes { max, min: residual.smallest(from, to) };
        let one_sided = Objective::ONE_SIDED.contains(&objective);
        let (reached, goal) = if one_sided {
            (-extremes.min.value, one_sided::least_loss(*optimum))
        } else {
            (extremes.magnitude().value, Interval::from(*optimum))
        };
        let is_sum = matches!(objective, Objective::LsAbsolute | Objective::LsRelative);
        let alternation = if is_sum { &[][..] } else { &minimax.alternation[..] };
        let excess = reached.hi() - goal.lo();
        Ok(FactorRow {
            model: integral.model(),
            lobe: integral.name(),
            limit: integral.limit(),
            objective,
            factor,
            digits,
            range: continuum.reals,
            extremes,
            optimum: *optimum,
            excess: if excess > 0.0 { excess.next_up() } else { 0.0 },
            alternation: alternation.iter().rev().copied().collect(),
        })
    }

    /// Each parameter to its nearest decimal.
    fn nearest(&self, parameters: &[f64], digits: usize) -> Result<Factor, FitError> {
        let texts: Vec<String> = parameters.iter().map(|p| round_to(*p, digits)).collect();
        let failure = || FitError::NoOptimum { method: "rounding", case: self.continuum.integral.describe() };
        Factor::new(self.form, &texts, self.continuum.divisor).ok_or_else(failure)
    }
}
