//! What to use instead of what the papers print: kernels and constants, each with its certified error and its row.

use super::number::{short, short_up};
use super::pixel::{ADOPTED, adopted};
use super::source::link;
use super::study::{NearestRow, Study};
use crate::fit::bell::Shape;
use crate::fit::{FactorRow, Objective};
use crate::kernel::model::Model;
use std::fmt::Write;

/// Significant digits of the constants named: as many as the papers print in full, and one more.
const DIGITS: usize = 5;

/// The list, from the study's rows alone.
pub(super) fn section(study: &Study, text: &mut String) {
    text.push_str("\n### What to use instead\n\n");
    lobe(study, text);
    factors(study, text);
    mended(study, text);
    weight(study, text);
    text.push_str(
        "- **For the footprint's axes** those of the conic, `kernel::pixel::Axes`, which are exact for every pair of \
         derivative vectors: [what the paper's lose](#the-axes-of-the-footprint).\n",
    );
    clip(study, text);
}

fn lobe(study: &Study, text: &mut String) {
    let Some(paper) = study.cosine.iter().find(|row| row.printed) else { return };
    let cubic = study.cosine.iter().filter(|row| row.shape == Shape::Cubic).map(|row| {
        let (power, cost) = (row.formula.power, row.cost.from_t);
        format!("\n  - K = {power}: at most {} off, {cost} operations", short_up(row.error.value.hi()))
    });
    let _ = writeln!(
        text,
        "- **For cs_16** (at most {} from cosⁿ, {} operations from 1 - cos θ) a cubic to the K-th power, `kernel::cubic`, certified \
         over every angle and every real n ≥ 16 ({}, [the table](#the-kernels-and-their-frontier)):{}",
        short_up(paper.error.value.hi()),
        paper.cost.from_t,
        link("fits/kernels-cosn.csv"),
        cubic.collect::<String>()
    );
}

fn factors(study: &Study, text: &mut String) {
    let short_one = |model: Model| -> Option<&FactorRow> {
        let range = (16.0, 1024.0);
        study.factors.iter().find(|row| {
            row.objective == Objective::OneSidedRounded
                && row.model == model
                && row.digits == DIGITS
                && (row.range.from(), row.range.to()) == range
        })
    };
    let named = Model::ALL.into_iter().filter_map(|model| {
        let row = short_one(model)?;
        let loss = short_up(0.0 - row.extremes.min.value.lo());
        let loss = if loss == "0" { "loses nothing".to_owned() } else { format!("loses at most {loss}") };
        Some(format!("\n  - {}: {}, {loss}", model.title(), row.factor))
    });
    let _ = writeln!(
        text,
        "- **For the printed factors of cs_16** these, which gain energy at no real n in 16..1024, proved (rows with objective \
         `one-sided-rounded` and {DIGITS} digits of {}), or for every n the [exact factors](#exact-factors):{}",
        link("fits/factors.csv"),
        named.collect::<String>()
    );
}

/// The printed constants with the fewest digits changed.
fn mended(study: &Study, text: &mut String) {
    let named = study.nearest.iter().filter_map(|NearestRow { printed, nearest }| {
        let mended = nearest.as_ref()?;
        let bound = &printed.bound.as_ref()?.text;
        let worst = short_up(mended.extremes.magnitude().value.hi());
        let (line, before, limit) = (&mended.line, &printed.line, printed.case.limit.id());
        Some(format!("\n  - {line} for {before}, limit `{limit}`: at most {worst}, where {bound} is printed"))
    });
    let named: String = named.collect();
    if !named.is_empty() {
        let _ = writeln!(
            text,
            "- **To keep the paper's own bounds** on the residual with the fewest digits changed, certified over the integers \
             16..1024 ({}):{named}",
            link("fits/nearest.csv")
        );
    }
}

fn weight(study: &Study, text: &mut String) {
    let of = |name: &str| study.pixel.weights.iter().find(|row| row.name == name);
    let Some(cubic) = of("cubic-4") else { return };
    let readings = study.pixel.weights.iter().filter(|row| row.name.starts_with('r'));
    let nearest = readings.min_by(|a, b| a.plane.value.total_cmp(&b.plane.value));
    let Some(nearest) = nearest else { return };
    let _ = writeln!(
        text,
        "- **For the texel's weight** `{}`, {} from the Gaussian of σ = L/6 in {} operations, where the nearest reading of the \
         paper's, `{}`, is {} off in {}. Certified over every Q ≥ 0: {}, [the table](#the-weight-of-a-texel).",
        cubic.name,
        short_up(cubic.plane.value),
        cubic.operations,
        nearest.name,
        short_up(nearest.plane.value),
        nearest.operations,
        link("fits/pixel-weights.csv")
    );
}

fn clip(study: &Study, text: &mut String) {
    let named = ADOPTED.into_iter().filter_map(|(objective, degree, half, name)| {
        let row = adopted(&study.pixel, objective, degree, half)?;
        Some(format!("\n  - {name}: at most {} off, at d = {}", short_up(row.error), short(row.at)))
    });
    let _ = writeln!(
        text,
        "- **For the volume beyond a line**, P(d) of the pixel with σ = L/6, `kernel::constants::CLIP_MINIMAX`, certified over d in \
         [0, ½] ({}, [the table](#the-volume-beyond-a-line)):{}",
        link("fits/clip.csv"),
        named.collect::<String>()
    );
}
