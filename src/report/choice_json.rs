//! The same answers as JSON, `version` 1.

use super::artifacts::ArtifactError;
use super::choice::why;
use super::choice_scene::not_needed;
use crate::bound::{Measure, Supremum};
use crate::choose::{
    Answer, Candidate, Costs, Demand, Dispensable, EnergyDemand, Evidence, Factor, Need, Price, SceneAnswer,
    SurfaceAnswer, Verdict, Witness, handed_word, theta,
};
use serde::Serialize;

/// The schema's version.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct NeedJson {
    n_from: f64,
    n_to: f64,
    whole: bool,
    max_error: f64,
    /// Null for an absolute error.
    relative_floor: Option<f64>,
    float: &'static str,
    angle: &'static str,
    model: Option<&'static str>,
    energy: Option<&'static str>,
    energy_error: Option<f64>,
    division: bool,
    transcendental: bool,
    elementary_ulps: f64,
}

#[derive(Serialize)]
struct BoundJson {
    lo: f64,
    hi: f64,
    n: f64,
    theta: f64,
}

#[derive(Serialize)]
struct WitnessJson {
    /// Null for a value that is no number.
    error: Option<f64>,
    n: f64,
    theta: f64,
    evidence: &'static str,
}

#[derive(Serialize)]
struct FactorJson {
    kind: &'static str,
    call: String,
    nudge: f64,
    gain_hi: f64,
    n_at_gain: f64,
    loss_hi: f64,
    n_at_loss: f64,
    evidence: &'static str,
}

#[derive(Serialize)]
struct KernelJson {
    id: &'static str,
    verdict: &'static str,
    /// Null where it qualifies.
    reason: Option<String>,
    cost: f64,
    cost_unit: &'static str,
    operations: u32,
    divisions: u32,
    transcendentals: u32,
    error_bound: Option<f64>,
    evidence: &'static str,
    approximation: Option<BoundJson>,
    rounding: Option<BoundJson>,
    /// What shows that it fails, where something does.
    witness: Option<WitnessJson>,
    largest_measured: Option<WitnessJson>,
    factors: Vec<FactorJson>,
    no_factor: Option<String>,
}

#[derive(Serialize)]
struct MissJson {
    id: &'static str,
    demand: &'static str,
    ratio: f64,
    value: f64,
}

#[derive(Serialize)]
struct AnswerJson {
    version: u32,
    need: NeedJson,
    division_weight: f64,
    transcendental_weight: f64,
    best: Option<&'static str>,
    nearest_miss: Option<MissJson>,
    /// Cheapest first.
    kernels: Vec<KernelJson>,
}

fn need_json(need: &Need) -> NeedJson {
    NeedJson {
        n_from: need.n.from(),
        n_to: need.n.to(),
        whole: need.n.is_whole(),
        max_error: need.max_error,
        relative_floor: match need.measure {
            Measure::Absolute => None,
            Measure::Relative { floor } => Some(floor),
        },
        float: need.format.id(),
        angle: handed_word(need.handed),
        model: need.model.map(|model| model.id()),
        energy: need.energy.map(EnergyDemand::id),
        energy_error: match need.energy {
            Some(EnergyDemand::Unbiased { error }) => Some(error),
            _ => None,
        },
        division: need.division,
        transcendental: need.transcendental,
        elementary_ulps: need.ulps,
    }
}

fn bound_json(supremum: &Supremum<2>) -> BoundJson {
    let [n, t] = supremum.at;
    BoundJson { lo: supremum.value.lo(), hi: supremum.value.hi(), n, theta: theta(n, t) }
}

fn witness_json(witness: Witness) -> WitnessJson {
    let Witness { n, theta, error, evidence } = witness;
    WitnessJson { error: Some(error).filter(|e| e.is_finite()), n, theta, evidence: evidence.id() }
}

fn factor_json(factor: &Factor) -> FactorJson {
    let (max, min) = (factor.residual.max, factor.residual.min);
    FactorJson {
        kind: factor.kind.id(),
        call: factor.call.clone(),
        nudge: factor.nudge,
        gain_hi: max.value.hi(),
        n_at_gain: max.n,
        loss_hi: -min.value.lo(),
        n_at_loss: min.n,
        evidence: Evidence::Certified.id(),
    }
}

fn kernel_json(candidate: &Candidate, need: &Need) -> KernelJson {
    let (cost, cost_unit) = match candidate.price {
        Price::Measured(ns) => (ns, "ns"),
        Price::Operations(operations) => (operations, "operations"),
    };
    KernelJson {
        id: candidate.stand_in.id(),
        verdict: candidate.verdict.id(),
        reason: (candidate.verdict != Verdict::Qualifies).then(|| why(candidate, need)),
        cost,
        cost_unit,
        operations: candidate.cost.operations,
        divisions: candidate.cost.divisions,
        transcendentals: candidate.cost.transcendentals,
        error_bound: candidate.bound,
        evidence: candidate.evidence(),
        approximation: candidate.approximation.as_ref().map(bound_json),
        rounding: candidate.rounding.as_ref().map(bound_json),
        witness: candidate.witness().map(witness_json),
        largest_measured: candidate.measured.map(witness_json),
        factors: candidate.factors.iter().map(factor_json).collect(),
        no_factor: candidate.no_factor.clone(),
    }
}

fn answer_json(answer: &Answer, costs: &Costs<'_>) -> AnswerJson {
    AnswerJson {
        version: VERSION,
        need: need_json(&answer.need),
        division_weight: costs.weights.division,
        transcendental_weight: costs.weights.transcendental,
        best: answer.best().map(|best| best.stand_in.id()),
        nearest_miss: answer.nearest_miss().map(|miss| MissJson {
            id: miss.stand_in.id(),
            demand: match miss.demand {
                Demand::Error => "error",
                Demand::Energy => "energy",
                Demand::Exclusion(_) => "exclusion",
            },
            ratio: miss.ratio,
            value: miss.value,
        }),
        kernels: answer.candidates.iter().map(|candidate| kernel_json(candidate, &answer.need)).collect(),
    }
}

fn text<T: Serialize>(value: &T) -> Result<String, ArtifactError> {
    let text =
        serde_json::to_string_pretty(value).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}

/// One need's answer as a JSON object.
///
/// # Errors
/// [`ArtifactError::Table`] if the text cannot be made, which no answer causes.
pub fn choice_json(answer: &Answer, costs: &Costs<'_>) -> Result<String, ArtifactError> {
    text(&answer_json(answer, costs))
}

#[derive(Serialize)]
struct MaterialJson<'a> {
    name: &'a str,
    within_cost: bool,
    needs_no_stand_in: bool,
    answer: AnswerJson,
}

#[derive(Serialize)]
struct PartJson<'a> {
    id: &'a str,
    bound: f64,
    dispensable: bool,
    operations: Option<u32>,
}

#[derive(Serialize)]
struct SurfaceJson<'a> {
    name: &'a str,
    max_error: f64,
    longest: f64,
    ratio: (f64, f64),
    skew: f64,
    aspect: f64,
    parts: Vec<PartJson<'a>>,
    weights: Vec<PartJson<'a>>,
    weight: Option<&'a str>,
    together: f64,
}

#[derive(Serialize)]
struct SceneJson<'a> {
    version: u32,
    is_met: bool,
    not_needed: Vec<String>,
    common: Option<&'static str>,
    materials: Vec<MaterialJson<'a>>,
    surfaces: Vec<SurfaceJson<'a>>,
}

fn surface_json(answer: &SurfaceAnswer) -> SurfaceJson<'_> {
    let surface = &answer.surface;
    SurfaceJson {
        name: &surface.name,
        max_error: surface.max_error,
        longest: surface.shape.longest,
        ratio: surface.shape.ratio,
        skew: surface.shape.skew,
        aspect: surface.shape.aspect(),
        parts: answer.parts.iter().map(part_json).collect(),
        weights: answer.weights.iter().map(part_json).collect(),
        weight: answer.weight().map(|weight| weight.id.as_str()),
        together: answer.together,
    }
}

fn part_json(part: &Dispensable) -> PartJson<'_> {
    let Dispensable { id, bound, dispensable, operations, .. } = part;
    PartJson { id, bound: *bound, dispensable: *dispensable, operations: *operations }
}

/// A scene's answer as a JSON object.
///
/// # Errors
/// [`ArtifactError::Table`] if the text cannot be made, which no answer causes.
pub fn scene_choice_json(answer: &SceneAnswer, costs: &Costs<'_>) -> Result<String, ArtifactError> {
    text(&SceneJson {
        version: VERSION,
        is_met: answer.is_met(),
        not_needed: not_needed(answer),
        common: answer.common.map(|stand_in| stand_in.id()),
        materials: answer
            .materials
            .iter()
            .map(|material| MaterialJson {
                name: &material.name,
                within_cost: material.within_cost,
                needs_no_stand_in: material.by_squarings().is_some(),
                answer: answer_json(&material.answer, costs),
            })
            .collect(),
        surfaces: answer.surfaces.iter().map(surface_json).collect(),
    })
}
