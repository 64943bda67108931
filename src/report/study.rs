//! Everything the report is made of, computed once.

use super::computed::{Better, Clock, Computed, RANGES, cubic_name, filter_comparisons};
use super::pixel::PixelStudy;
use crate::bound::{Extremes, IntegralTable, Interval};
use crate::fit::bell::{CosineBell, ExponentialBell, Shape};
use crate::fit::{FactorRow, FitError, FitRow, Line, Nearest, Objective};
use crate::integral::albedo::{AlbedoCurve, AlbedoError};
use crate::integral::{Case, Disagreement, Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::{ClaimsError, ClaimsFile, Kind, Printed};
use crate::scene::{Comparison, SceneError};
use crate::stability::Stability;
use crate::verdict::{Expectations, ExpectedError, Judge, Judgement};
use std::time::Duration;
use thiserror::Error;

/// What can stop a study.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StudyError {
    /// Two routes to an integral differ.
    #[error(transparent)]
    Integral(#[from] Disagreement),
    /// A fit failed, or two methods disagree.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// An albedo outside its domain.
    #[error(transparent)]
    Albedo(#[from] AlbedoError),
    /// The claims cannot be read.
    #[error("claims: {0}")]
    Claims(#[from] ClaimsError),
    /// The expected verdicts cannot be read.
    #[error(transparent)]
    Expected(#[from] ExpectedError),
    /// A scene cannot be shown.
    #[error(transparent)]
    Scene(#[from] SceneError),
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
    /// Factors of cs_16 on its support in more forms, and one-sided ones.
    pub factors: Vec<FactorRow>,
    /// Bells for e⁻ᵗ.
    pub exponential: Vec<ExponentialBell>,
    /// Bells for cosⁿ.
    pub cosine: Vec<CosineBell>,
    /// Factors of the adopted cubic bells for cosⁿ.
    pub cubic_factors: Vec<FactorRow>,
    /// Directional albedo at the tables' angles and exponents.
    pub albedos: Vec<AlbedoCurve>,
    /// The same at the figures' angles and exponents.
    pub albedo_curves: Vec<AlbedoCurve>,
    /// The pixel paper's studies.
    pub pixel: PixelStudy,
    /// Texture filters on the built-in scenes.
    pub filters: Vec<Comparison>,
    /// What rounding does at the extremes.
    pub stability: Stability,
    /// The claims.
    pub claims: ClaimsFile,
    /// Their verdicts.
    pub judgements: Vec<Judgement>,
    /// The verdicts they should get.
    pub expectations: Expectations,
}

impl Study {
    /// Computes everything, on threads whose results do not depend on each other; `stage` is told what
    /// was done, and how long it took.
    ///
    /// # Errors
    /// [`StudyError`] for whatever stops it.
    pub fn run(stage: &(dyn Fn(&str, Duration) + Sync)) -> Result<Self, StudyError> {
        let claims = ClaimsFile::papers()?;
        let expectations = Expectations::papers()?;
        let clock = Clock::new(stage);
        let (judged, computed, better, pixel) = std::thread::scope(|scope| {
            let judge = scope.spawn(|| clock.time("verdicts", || Judge::default().judge(&claims)));
            let better = scope.spawn(|| Better::run(clock));
            let computed = Computed::run(&claims, clock);
            let pixel = PixelStudy::run(clock);
            (judge.join(), computed, better.join(), pixel)
        });
        let judgements = judged.map_err(|_| StudyError::Worker)??;
        let Computed { integrals, fits, printed, nearest, suprema, factors } = computed?;
        let Better { exponential, cosine, cubic_factors, albedos, albedo_curves } =
            better.map_err(|_| StudyError::Worker)??;
        let filters = clock.time("texture filters", filter_comparisons)?;
        let stability = clock.time("stability", Stability::run).ok_or(StudyError::Worker)?;
        Ok(Study {
            integrals,
            fits,
            printed,
            nearest,
            suprema,
            factors,
            exponential,
            cosine,
            cubic_factors,
            albedos,
            albedo_curves,
            pixel,
            filters,
            stability,
            claims,
            judgements,
            expectations,
        })
    }

    /// The one-sided line of cs_16 for a model over the papers' range.
    pub fn one_sided_line(&self, model: Model) -> Option<&FactorRow> {
        let range = RANGES[0];
        self.factors
            .iter()
            .filter(|row| row.model == model && row.factor.line().is_some())
            .rfind(|row| row.objective == Objective::OneSided && (row.range.from(), row.range.to()) == range)
    }

    /// The cubic bell of a power for e⁻ᵗ.
    pub fn exponential_bell(&self, power: u32) -> Option<&ExponentialBell> {
        self.exponential.iter().find(|row| row.shape == Shape::Cubic && row.power == power)
    }

    /// The cubic bell of a power for cosⁿ.
    pub fn cosine_bell(&self, shape: Shape, power: u32) -> Option<&CosineBell> {
        self.cosine.iter().find(|row| !row.printed && row.shape == shape && row.formula.power == power)
    }

    /// The factor of the cubic bell of a power under a model.
    pub fn cubic_factor(&self, power: u32, model: Model) -> Option<&FactorRow> {
        let name = cubic_name(power);
        self.cubic_factors.iter().find(|row| row.lobe == name && row.model == model)
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

/// The paper's Int(n) of cs_16 in all four limits, or of cosⁿ, for one model.
pub(super) const fn case(model: Model, lobe: Lobe, limit: Limit) -> Case {
    Case { model, lobe, limit }
}
