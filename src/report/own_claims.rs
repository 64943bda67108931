//! What came of a claims file: for readers, and as JSON for programs.

use super::artifacts::ArtifactError;
use super::number::{enclosure, short, short_down, short_up};
use crate::bound::{Extreme, Extremes, Interval};
use crate::fit::{Change, Exponents, Mended, Remedy, RuledOut};
use crate::verdict::{DemandFinding, Judgement};
use serde::Serialize;
use std::fmt::Write;

/// One line a reading: claim, reading, verdict, numbers, witness; and below constants of one's own that do
/// not hold, the nearest that do.
pub fn judgement_lines(judgements: &[Judgement]) -> String {
    let mut text = String::new();
    for j in judgements {
        let printed = if j.printed.is_empty() { String::new() } else { format!(" stated {};", j.printed) };
        let computed = j.computed.map(|c| format!(" computed {};", enclosure(c))).unwrap_or_default();
        let _ = writeln!(
            text,
            "{}, {}: {}.{printed}{computed} {}",
            j.claim,
            j.reading,
            j.verdict.id(),
            j.witness
        );
        if let Some(mended) = j.normalisation.as_ref().and_then(|parts| parts.mended.as_ref()) {
            text.push_str(&mended_lines(mended));
        }
    }
    text
}

fn mended_lines(Mended { remedy, ruled_out }: &Mended) -> String {
    let mut text = String::new();
    for RuledOut { form, level, most } in ruled_out {
        let _ = writeln!(
            text,
            "    ruled out: {}, whose |residual| is {} or more whatever its constants; scaled, {} would do",
            form.formula(),
            short_down(*level),
            short(*most),
        );
    }
    let _ = match remedy {
        Some(Remedy { change, source, extremes: Extremes { max, min } }) => {
            let how = match change {
                Change::Digits { changed: 1, .. } => "1 digit changed".to_owned(),
                Change::Digits { changed, .. } => format!("{changed} digits changed"),
                Change::Multiple { by } => format!("{by} times the factor"),
                Change::Form { digits, .. } => format!("another factor, of {digits} digits"),
            };
            let place = |n: f64| {
                if n == f64::INFINITY { "n → ∞".to_owned() } else { format!("n = {}", short(n)) }
            };
            let (least, most) = (short_down(min.value.lo()), short_up(max.value.hi()));
            let run = format!("{least} ({}) to {most} ({})", place(min.n), place(max.n));
            writeln!(text, "    nearest that holds: {source}, {how}; 2π coef Int - 1 from {run}, proved")
        }
        None => writeln!(text, "    no constants near these were found to hold"),
    };
    text
}

/// The version of the JSON below: fields may be added to it, and none changes its meaning.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct FileJson<'a> {
    version: u32,
    judgements: Vec<JudgementJson<'a>>,
}

#[derive(Serialize)]
struct JudgementJson<'a> {
    claim: &'a str,
    paper: &'a str,
    locator: &'a str,
    reading: &'a str,
    kind: &'static str,
    verdict: &'static str,
    evidence: Option<&'static str>,
    stated: Option<&'a str>,
    computed: Option<EnclosureJson>,
    witness: &'a str,
    residual: Option<ResidualJson>,
    demands: Vec<DemandJson<'a>>,
    nearest: Option<NearestJson<'a>>,
    ruled_out: Vec<RuledOutJson>,
}

/// Both ends; null where there is none, which is not known to be finite.
#[derive(Serialize)]
struct EnclosureJson {
    lo: Option<f64>,
    hi: Option<f64>,
}

#[derive(Serialize)]
struct ExtremeJson {
    lo: Option<f64>,
    hi: Option<f64>,
    n: Option<f64>,
}

#[derive(Serialize)]
struct ResidualJson {
    over: &'static str,
    n_from: f64,
    n_to: Option<f64>,
    max: ExtremeJson,
    min: ExtremeJson,
}

#[derive(Serialize)]
struct DemandJson<'a> {
    demand: &'static str,
    stated: Option<&'a str>,
    verdict: &'static str,
    computed: ExtremeJson,
}

#[derive(Serialize)]
struct NearestJson<'a> {
    change: &'static str,
    factor: &'a str,
    digits_changed: Option<usize>,
    multiple: Option<&'a str>,
    form: Option<&'static str>,
    digits: Option<usize>,
    max: ExtremeJson,
    min: ExtremeJson,
}

#[derive(Serialize)]
struct RuledOutJson {
    form: &'static str,
    formula: &'static str,
    level: f64,
    most: f64,
}

fn finite(x: f64) -> Option<f64> {
    Some(x).filter(|x| x.is_finite())
}

fn enclosed(value: Interval) -> EnclosureJson {
    EnclosureJson { lo: finite(value.lo()), hi: finite(value.hi()) }
}

fn reached(value: Interval, n: f64) -> ExtremeJson {
    ExtremeJson { lo: finite(value.lo()), hi: finite(value.hi()), n: finite(n) }
}

fn extreme(Extreme { value, n }: Extreme) -> ExtremeJson {
    reached(value, n)
}

fn stated(text: &str) -> Option<&str> {
    Some(text).filter(|text| !text.is_empty())
}

/// Judgements as one JSON object; its fields are told in [`crate::paper::schema`].
///
/// # Errors
/// If the text cannot be made, which no finite number causes.
pub fn judgements_json(judgements: &[Judgement]) -> Result<String, ArtifactError> {
    let file = FileJson { version: VERSION, judgements: judgements.iter().map(judgement).collect() };
    let text =
        serde_json::to_string_pretty(&file).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}

fn judgement(j: &Judgement) -> JudgementJson<'_> {
    let parts = j.normalisation.as_deref();
    let mended = parts.and_then(|parts| parts.mended.as_ref());
    JudgementJson {
        claim: &j.claim,
        paper: &j.paper,
        locator: &j.locator,
        reading: &j.reading,
        kind: j.kind,
        verdict: j.verdict.id(),
        evidence: j.evidence.map(|e| e.id()),
        stated: stated(&j.printed),
        computed: j.computed.map(enclosed),
        witness: &j.witness,
        residual: parts.map(|parts| residual(parts.exponents, &parts.extremes)),
        demands: parts.map_or(vec![], |parts| parts.demands.iter().map(demand).collect()),
        nearest: mended.and_then(|mended| mended.remedy.as_ref()).map(nearest),
        ruled_out: mended.map_or(vec![], |mended| mended.ruled_out.iter().map(ruled_out).collect()),
    }
}

fn residual(exponents: Exponents, extremes: &Extremes) -> ResidualJson {
    let (from, to) = exponents.ends();
    let (max, min) = (extreme(extremes.max), extreme(extremes.min));
    ResidualJson { over: exponents.over(), n_from: from, n_to: finite(to), max, min }
}

fn demand(found: &DemandFinding) -> DemandJson<'_> {
    DemandJson {
        demand: found.demand.id(),
        stated: stated(found.demand.printed()),
        verdict: found.verdict.id(),
        computed: reached(found.computed, found.n),
    }
}

fn nearest(remedy: &Remedy) -> NearestJson<'_> {
    let mut json = NearestJson {
        change: remedy.change.id(),
        factor: &remedy.source,
        digits_changed: None,
        multiple: None,
        form: None,
        digits: None,
        max: extreme(remedy.extremes.max),
        min: extreme(remedy.extremes.min),
    };
    match &remedy.change {
        Change::Digits { changed, .. } => json.digits_changed = Some(*changed),
        Change::Multiple { by } => json.multiple = Some(by),
        Change::Form { factor, digits } => {
            (json.form, json.digits) = (Some(factor.form().id()), Some(*digits));
        }
    }
    json
}

fn ruled_out(of: &RuledOut) -> RuledOutJson {
    RuledOutJson { form: of.form.id(), formula: of.form.formula(), level: of.level, most: of.most }
}
