//! Everything the report is made of, computed once.

use crate::bound::{
    Extremes, Gaussian, IntegralTable, Interval, Residual, bell_distance, difference_supremum,
    gaussian_distance,
};
use crate::fit::{FitError, FitRow, Form, Line, Nearest, Objective, Problem, fit_case, nearest};
use crate::integral::{Case, Disagreement, Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::{ClaimsError, ClaimsFile, Kind, LOBE_PAPER, Printed};
use crate::verdict::{EXPECTED, Expectations, ExpectedError, Judge, Judgement};
use thiserror::Error;

/// The papers' range of the specular exponent.
const RANGE: (u32, u32) = (16, 1024);
/// Decimals to which a fit is rounded before it is certified and printed.
const DIGITS: usize = 12;

/// What can stop a study.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StudyError {
    /// Two routes to an integral differ.
    #[error(transparent)]
    Integral(#[from] Disagreement),
    /// A fit failed, or two methods disagree.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The claims cannot be read.
    #[error("claims: {0}")]
    Claims(#[from] ClaimsError),
    /// The expected verdicts cannot be read.
    #[error(transparent)]
    Expected(#[from] ExpectedError),
    /// A worker thread ended early.
    #[error("a worker thread stopped")]
    Worker,
}

/// A factor as printed, under one reading, with its certified residual.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedFactor {
    /// The claim that prints it.
    pub claim: String,
    /// The factor as the claims file writes it.
    pub reading: String,
    /// The integral it is held against.
    pub case: Case,
    /// The line.
    pub line: Line,
    /// The printed bound on its residual, if there is one.
    pub bound: Option<Printed>,
    /// Residual over the integers.
    pub integers: Extremes,
    /// Residual over every real n.
    pub reals: Extremes,
}

/// What would keep a printed bound.
#[derive(Clone, Debug, PartialEq)]
pub struct NearestRow {
    /// The factor as printed.
    pub printed: PrintedFactor,
    /// The nearest that keeps its bound, if changing digits helps.
    pub nearest: Option<Nearest>,
}

/// A certified supremum, one row of `fits/suprema.csv`.
#[derive(Clone, Debug, PartialEq)]
pub struct SupremumRow {
    /// Of what, as a formula.
    pub function: String,
    /// The parameter's name and value or range.
    pub parameter: String,
    /// The enclosure.
    pub value: Interval,
    /// Where.
    pub at: String,
}

/// Everything computed.
#[derive(Debug)]
pub struct Study {
    /// Int(n), a table a case.
    pub integrals: Vec<IntegralTable>,
    /// Refitted factors.
    pub fits: Vec<FitRow>,
    /// Factors as printed.
    pub printed: Vec<PrintedFactor>,
    /// Mended factors.
    pub nearest: Vec<NearestRow>,
    /// Certified suprema by parameter.
    pub suprema: Vec<SupremumRow>,
    /// The claims.
    pub claims: ClaimsFile,
    /// Their verdicts.
    pub judgements: Vec<Judgement>,
    /// The verdicts they should get.
    pub expectations: Expectations,
}

impl Study {
    /// Computes everything, on two threads whose results do not depend on each other.
    ///
    /// # Errors
    /// [`StudyError`] for whatever stops it.
    pub fn run() -> Result<Self, StudyError> {
        let claims = ClaimsFile::parse(LOBE_PAPER)?;
        let expectations = Expectations::parse(EXPECTED)?;
        let (judged, computed) = std::thread::scope(|scope| {
            let judge = scope.spawn(|| Judge::default().judge(&claims));
            let computed = Computed::run(&claims);
            (judge.join(), computed)
        });
        let judgements = judged.map_err(|_| StudyError::Worker)??;
        let Computed { integrals, fits, printed, nearest, suprema } = computed?;
        Ok(Study { integrals, fits, printed, nearest, suprema, claims, judgements, expectations })
    }

    /// The table of one case.
    pub fn integral(&self, case: Case) -> Option<&IntegralTable> {
        self.integrals.iter().find(|table| table.case == case)
    }

    /// The refit of one case and objective.
    pub fn fit(&self, case: Case, objective: Objective) -> Option<&FitRow> {
        self.fits.iter().find(|row| row.case == case && row.objective == objective)
    }

    /// The factor as a model's claim first prints it.
    pub fn printed(&self, model: Model) -> Option<&PrintedFactor> {
        self.printed.iter().find(|p| p.case.model == model)
    }

    /// What a judgement's reading states.
    pub fn kind(&self, judgement: &Judgement) -> Option<&Kind> {
        let claim = self.claims.claims.iter().find(|c| c.id == judgement.claim)?;
        claim.readings.iter().find(|r| r.id == judgement.reading).map(|r| &r.kind)
    }

    /// Where verdicts and expectations differ; empty when all is as expected.
    pub fn surprises(&self) -> Vec<ExpectedError> {
        self.expectations.differences(&self.judgements)
    }
}

struct Computed {
    integrals: Vec<IntegralTable>,
    fits: Vec<FitRow>,
    printed: Vec<PrintedFactor>,
    nearest: Vec<NearestRow>,
    suprema: Vec<SupremumRow>,
}

impl Computed {
    fn run(claims: &ClaimsFile) -> Result<Self, StudyError> {
        let (from, to) = RANGE;
        let mut integrals = Vec::new();
        let mut fits = Vec::new();
        for case in Case::all() {
            integrals.push(IntegralTable::compute(case, from, to)?);
            let problem = Problem::new(case, from, to)?;
            for objective in Objective::ALL {
                fits.push(fit_case(&problem, objective, Form::Linear, DIGITS)?);
            }
        }
        let printed = printed_factors(claims);
        let nearest = nearest_rows(&printed)?;
        Ok(Computed { integrals, fits, printed, nearest, suprema: suprema() })
    }
}

fn printed_factors(claims: &ClaimsFile) -> Vec<PrintedFactor> {
    let mut found: Vec<PrintedFactor> = Vec::new();
    for claim in &claims.claims {
        for reading in &claim.readings {
            let Kind::FactorResidual { case, factor, text, n, printed, .. } = &reading.kind else { continue };
            let Some(line) = Line::from_formula(factor) else { continue };
            if found.iter().any(|p| p.claim == claim.id && p.case == *case && p.line == line) {
                continue;
            }
            let residual = Residual::new(*case, factor);
            found.push(PrintedFactor {
                claim: claim.id.clone(),
                reading: text.clone(),
                case: *case,
                line,
                bound: printed.clone(),
                integers: residual.over_integers(n.0, n.1),
                reals: residual.over_reals(f64::from(n.0), f64::from(n.1)),
            });
        }
    }
    found
}

/// For every printed factor that breaks its printed bound, where the limit is not the misread one.
fn nearest_rows(printed: &[PrintedFactor]) -> Result<Vec<NearestRow>, FitError> {
    let mut rows = Vec::new();
    for factor in printed {
        let Some(bound) = &factor.bound else { continue };
        let bound = crate::bound::enclose(&bound.value).lo();
        let kept = factor.integers.magnitude().value.hi() <= bound;
        // Where a multiplies the whole bracket, b of the line is not a printed number.
        let (a, b) = (factor.line.a(), factor.line.b());
        let as_printed = b == "0" || factor.reading.starts_with(&format!("({a}*n + {b})"));
        if kept || !as_printed || factor.case.limit == Limit::Card {
            continue;
        }
        let problem = Problem::new(factor.case, RANGE.0, RANGE.1)?;
        let nearest = nearest(&problem, &factor.line, bound);
        rows.push(NearestRow { printed: factor.clone(), nearest });
    }
    Ok(rows)
}

fn suprema() -> Vec<SupremumRow> {
    let exponents = [16.0, 17.0, 20.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0];
    let mut rows = Vec::new();
    for cut in [Limit::ExactZero, Limit::Paper, Limit::Card] {
        let ranges = exponents.iter().map(|&n| Interval::from(n)).chain([Interval::new(16.0, 1024.0)]);
        for n in ranges {
            let found = difference_supremum(cut, n, 1e-6);
            let theta = if found.beyond_cut { "theta -> cr+ =" } else { "theta =" };
            rows.push(SupremumRow {
                function: format!("cos^n - cs16 ({})", cut.id()),
                parameter: range_text(n),
                value: found.value,
                at: format!("n = {} {theta} {:.5}", short_n(found.n), found.theta()),
            });
        }
    }
    for kind in Gaussian::ALL {
        for &n in &exponents {
            let found = gaussian_distance(kind, Interval::from(n), 1e-4 / n);
            let name = if kind == Gaussian::Angle { "n theta^2/2" } else { "n (1 - cos theta)" };
            rows.push(SupremumRow {
                function: format!("{} - cos^n", kind.id()),
                parameter: range_text(Interval::from(n)),
                value: found.value,
                at: format!("{name} = {:.4}", found.at[1]),
            });
        }
    }
    for power in [4, 8, 16, 32] {
        let found = bell_distance(power, 1e-8);
        rows.push(SupremumRow {
            function: "e^-t - (1 - t/K)^K".to_owned(),
            parameter: format!("K = {power}"),
            value: found.value,
            at: format!("t = {:.4}", found.at[0]),
        });
    }
    rows
}

fn range_text(n: Interval) -> String {
    if n.lo() == n.hi() {
        format!("n = {}", n.lo())
    } else {
        format!("every real n in {}..{}", n.lo(), n.hi())
    }
}

fn short_n(n: f64) -> String {
    if n == libm::floor(n) { format!("{n}") } else { format!("{n:.2}") }
}

/// The paper's Int(n) of cs_16 in all four limits, or of cosⁿ, for one model.
pub(super) const fn case(model: Model, lobe: Lobe, limit: Limit) -> Case {
    Case { model, lobe, limit }
}
