//! Table 1 of the lobe paper, regenerated beside the printed one.

use super::artifacts::ArtifactError;
use super::number::short;
use super::study::{PrintedFactor, Study, case};
use crate::fit::{FitRow, Objective};
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::Kind;
use crate::verdict::Verdict;
use serde::Serialize;

/// A model's row: what is printed and what it should be.
struct Row<'a> {
    model: Model,
    /// The exact factor of cosⁿ: the printed reading that is proved.
    cosine: &'a str,
    printed: Option<&'a PrintedFactor>,
    /// The printed factor over the whole support.
    on_support: Option<&'a PrintedFactor>,
    /// Least squares by the paper's own limit and the relative objective.
    refit: Option<&'a FitRow>,
    /// The best line over the whole support.
    minimax: Option<&'a FitRow>,
}

fn rows(study: &Study) -> Vec<Row<'_>> {
    Model::ALL
        .into_iter()
        .map(|model| {
            let on = |limit| case(model, Lobe::Cs16, limit);
            let printed = study.printed(model);
            let whole = |p: &&PrintedFactor| {
                let same_angle = p.case.limit == Limit::Support || p.case.limit == Limit::ExactZero;
                p.case.model == model && same_angle && printed.is_some_and(|first| first.line == p.line)
            };
            // For lobes in their full angle the exact zero is the support; the others print both.
            let on_support =
                study.printed.iter().filter(whole).max_by_key(|p| p.case.limit == Limit::Support);
            Row {
                model,
                cosine: exact_cosine(study, model),
                printed,
                on_support,
                refit: study.fit(on(Limit::Paper), Objective::LsAbsolute),
                minimax: study.fit(on(Limit::Support), Objective::Minimax),
            }
        })
        .collect()
}

/// The text of the cosⁿ factor that was proved exact.
fn exact_cosine(study: &Study, model: Model) -> &str {
    let claims = &study.claims.claims;
    let readings = claims.iter().flat_map(|c| c.readings.iter().map(move |r| (&c.id, r)));
    readings
        .filter_map(|(claim, reading)| match &reading.kind {
            Kind::FactorIdentity { model: of, text, .. } if *of == model => Some((claim, &reading.id, text)),
            _ => None,
        })
        .find(|(claim, reading, _)| {
            let proved = |j: &&crate::verdict::Judgement| j.verdict == Verdict::Proved;
            study.judgements.iter().filter(proved).any(|j| j.claim == **claim && j.reading == **reading)
        })
        .map_or("", |(.., text)| text.as_str())
}

#[derive(Serialize)]
struct Line<'a> {
    model: &'static str,
    cos_n_exact: &'a str,
    cs16_printed: String,
    printed_bound: &'a str,
    printed_residual_paper_limit: Option<f64>,
    printed_residual_support: Option<f64>,
    cs16_ls_absolute_paper_limit: String,
    cs16_minimax_support: String,
    minimax_residual_support: Option<f64>,
}

/// `fits/table1.csv`.
pub(super) fn csv(study: &Study) -> Result<Vec<u8>, ArtifactError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows(study) {
        let worst = |p: Option<&PrintedFactor>| p.map(|p| p.integers.magnitude().value.hi());
        writer.serialize(Line {
            model: row.model.id(),
            cos_n_exact: row.cosine,
            cs16_printed: row.printed.map(|p| p.line.to_string()).unwrap_or_default(),
            printed_bound: row.printed.and_then(|p| p.bound.as_ref()).map_or("", |b| &b.text),
            printed_residual_paper_limit: worst(row.printed),
            printed_residual_support: worst(row.on_support),
            cs16_ls_absolute_paper_limit: row.refit.map(|f| f.line.to_string()).unwrap_or_default(),
            cs16_minimax_support: row.minimax.map(|f| f.line.to_string()).unwrap_or_default(),
            minimax_residual_support: row.minimax.map(|f| f.integers.magnitude().value.hi()),
        })?;
    }
    writer.into_inner().map_err(|error| ArtifactError::Table(error.to_string()))
}

/// The cells of a row as readers see them.
fn cells(row: &Row<'_>) -> [String; 7] {
    let size =
        |p: Option<&PrintedFactor>| p.map(|p| short(p.integers.magnitude().value.hi())).unwrap_or_default();
    [
        row.model.title().to_owned(),
        row.printed.map(|p| p.line.to_string()).unwrap_or_default(),
        row.printed.and_then(|p| p.bound.as_ref()).map_or_else(|| "-".to_owned(), |b| b.text.clone()),
        size(row.printed),
        size(row.on_support),
        row.minimax.map(|f| f.line.to_string()).unwrap_or_default(),
        row.minimax.map(|f| short(f.integers.magnitude().value.hi())).unwrap_or_default(),
    ]
}

const HEADS: [&str; 8] = [
    "model",
    "cosⁿ, exact (proved)",
    "cs_16, printed",
    "printed bound",
    "max abs residual to 6/√n",
    "max abs residual on the support",
    "cs_16, best line on the support",
    "its max abs residual",
];

/// `reports/table1.md`.
pub(super) fn markdown(study: &Study) -> String {
    let mut text = format!("| {} |\n|{}\n", HEADS.join(" | "), "---|".repeat(HEADS.len()));
    for row in rows(study) {
        let [model, printed, bound, paper, support, best, residual] = cells(&row);
        let cosine = row.cosine.replace("*pi", "π").replace('*', "");
        text.push_str(&format!(
            "| {model} | {cosine} | {printed} | {bound} | {paper} | {support} | {best} | {residual} |\n"
        ));
    }
    text
}

/// `reports/table1.tex`: a `tabular` to `\input`, with no package beyond LaTeX's own.
pub(super) fn latex(study: &Study) -> String {
    let mut text = String::from(
        "% Table 1 of the lobe paper, printed and recomputed; written by `bellfit reproduce`.\n\
         \\begin{tabular}{llllllll}\n\\hline\n\
         model & $\\cos^n$, exact & $cs_{16}$, printed & bound & $\\max|res|$, $6/\\sqrt n$ & \
         $\\max|res|$, support & best line & $\\max|res|$ \\\\\n\\hline\n",
    );
    for row in rows(study) {
        let [model, printed, bound, paper, support, best, residual] = cells(&row);
        let cosine = row.cosine.replace("2^(-n/2)", "2^{-n/2}").replace("*pi", "\\pi").replace('*', "");
        let line = |l: &str| l.replace('π', "\\pi");
        text.push_str(&format!(
            "{model} & ${cosine}$ & ${}$ & {bound} & {paper} & {support} & ${}$ & {residual} \\\\\n",
            line(&printed),
            line(&best)
        ));
    }
    text.push_str("\\hline\n\\end{tabular}\n");
    text
}
