//! The parts of a study that do not depend on each other, each timed.

use super::albedo_table::{ALBEDO_DEGREES, ALBEDO_EXPONENTS};
use super::figures::albedo_degrees;
use super::study::{NearestRow, PrintedFactor, StudyError, SupremumRow, case};
use super::suprema::suprema;
use crate::bound::{IntegralTable, LobeIntegral, Residual};
use crate::fit::bell::{CosineBell, ExponentialBell, Shape, cosine_bells, exponential_bells};
use crate::fit::{
    DIGITS, FactorForm, FactorRow, FitError, FitRow, Form, Line, Objective, Problem, Reals, factor_rows,
    fit_case, fit_factor, nearest, one_sided_lines,
};
use crate::integral::albedo::{AlbedoCurve, AlbedoSubject, albedo_curves};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::{ClaimsFile, Kind};
use crate::scene::{BUILT_IN, Comparison, Scene, SceneError, Technique};
use std::time::{Duration, Instant};

/// The papers' range of the specular exponent.
const RANGE: (u32, u32) = (16, 1024);
/// Ranges of n for which cs_16's factors are fitted: the papers', without an end, and below it.
pub(super) const RANGES: [(f64, f64); 3] = [(16.0, 1024.0), (16.0, f64::INFINITY), (1.0, 16.0)];
/// The exponents of the albedo figures.
const DRAWN_EXPONENTS: [f64; 2] = [16.0, 64.0];

/// Times the stages.
#[derive(Clone, Copy)]
pub(super) struct Clock<'a> {
    stage: &'a (dyn Fn(&str, Duration) + Sync),
}

impl<'a> Clock<'a> {
    pub(super) fn new(stage: &'a (dyn Fn(&str, Duration) + Sync)) -> Self {
        Clock { stage }
    }

    pub(super) fn time<T>(self, name: &str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let done = work();
        (self.stage)(name, start.elapsed());
        done
    }
}

/// What the papers state, computed: integrals, lines, suprema; and the factors of cs_16.
pub(super) struct Computed {
    pub(super) integrals: Vec<IntegralTable>,
    pub(super) fits: Vec<FitRow>,
    pub(super) printed: Vec<PrintedFactor>,
    pub(super) nearest: Vec<NearestRow>,
    pub(super) suprema: Vec<SupremumRow>,
    pub(super) factors: Vec<FactorRow>,
}

impl Computed {
    pub(super) fn run(claims: &ClaimsFile, clock: Clock<'_>) -> Result<Self, StudyError> {
        let (integrals, fits) = clock.time("integrals and lines", tables_and_lines)?;
        let printed = printed_factors(claims);
        let nearest = nearest_rows(&printed)?;
        let suprema = clock.time("suprema", suprema);
        let factors = clock.time("factors of cs_16", factors)?;
        Ok(Computed { integrals, fits, printed, nearest, suprema, factors })
    }
}

pub(super) fn tables_and_lines() -> Result<(Vec<IntegralTable>, Vec<FitRow>), StudyError> {
    let (from, to) = RANGE;
    let (mut integrals, mut fits) = (Vec::new(), Vec::new());
    for case in Case::all() {
        integrals.push(IntegralTable::compute(case, from, to)?);
        let problem = Problem::new(case, from, to)?;
        for objective in Objective::ALL {
            fits.push(fit_case(&problem, objective, Form::Linear, DIGITS)?);
        }
        if case.lobe == Lobe::Cs16 && case.limit == Limit::Support {
            fits.extend(one_sided_lines(&problem)?);
        }
    }
    Ok((integrals, fits))
}

/// The factors of cs_16 over every range.
pub(super) fn factors() -> Result<Vec<FactorRow>, StudyError> {
    let cases = Model::ALL.map(|model| case(model, Lobe::Cs16, Limit::Support));
    let mut rows = Vec::new();
    for (from, to) in RANGES {
        rows.extend(factor_rows(&cases, Reals::new(from, to)?)?);
    }
    Ok(rows)
}

/// Better bells, their factors, and the albedo of all.
pub(super) struct Better {
    pub(super) exponential: Vec<ExponentialBell>,
    pub(super) cosine: Vec<CosineBell>,
    pub(super) cubic_factors: Vec<FactorRow>,
    pub(super) albedos: Vec<AlbedoCurve>,
    pub(super) albedo_curves: Vec<AlbedoCurve>,
}

impl Better {
    pub(super) fn run(clock: Clock<'_>) -> Result<Self, StudyError> {
        let exponential = clock.time("bells for e^-t", exponential_bells)?;
        let cosine = clock.time("bells for cos^n", cosine_bells)?;
        let cubic_factors = clock.time("factors of the bells", || cubic_factors(&cosine))?;
        let subjects = AlbedoSubject::all();
        let (albedos, albedo_curves) = clock.time("albedo", || -> Result<_, StudyError> {
            let table = albedo_curves(&subjects, &ALBEDO_EXPONENTS, &ALBEDO_DEGREES)?;
            Ok((table, albedo_curves(&subjects, &DRAWN_EXPONENTS, &albedo_degrees())?))
        })?;
        Ok(Better { exponential, cosine, cubic_factors, albedos, albedo_curves })
    }
}

/// Threads of the pictures; their number changes no byte.
const THREADS: usize = 2;

/// Every texture filter on the built-in scenes.
pub(super) fn filter_comparisons() -> Result<Vec<Comparison>, SceneError> {
    let scenes = BUILT_IN.iter().filter_map(|name| Scene::built_in(name));
    scenes.map(|scene| Comparison::run(&scene, &Technique::all(), THREADS, &|_| ())).collect()
}

/// The name of a cubic lobe in files.
pub(super) fn cubic_name(power: u32) -> String {
    format!("cubic{power}")
}

/// One-sided factors of the cubic bells for every real n from 16 on.
pub(super) fn cubic_factors(bells: &[CosineBell]) -> Result<Vec<FactorRow>, StudyError> {
    let mut rows = Vec::new();
    for bell in bells.iter().filter(|bell| bell.shape == Shape::Cubic) {
        for model in Model::ALL {
            let name = cubic_name(bell.formula.power);
            let integral = LobeIntegral::new(&name, bell.formula, model).ok_or(StudyError::Worker)?;
            let range = Reals::new(bell.from, f64::INFINITY)?;
            let form = FactorForm::InverseSquare;
            rows.push(fit_factor(&integral, range, form, Objective::OneSided, DIGITS)?);
        }
    }
    Ok(rows)
}

pub(super) fn printed_factors(claims: &ClaimsFile) -> Vec<PrintedFactor> {
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
pub(super) fn nearest_rows(printed: &[PrintedFactor]) -> Result<Vec<NearestRow>, FitError> {
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
