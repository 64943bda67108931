//! Whether cr_n ≈ √(6/n), what it does to each integral, and what holds instead: for the report and the README.

use super::study::{Study, case};
use super::words::capital;
use crate::bound::Interval;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::Kind;
use crate::verdict::Verdict;
use std::fmt::Write;

/// The README's block.
pub(super) fn cut(study: &Study) -> String {
    format!("{}\n{}\n{NOTE}", answer(study), shares(study))
}

/// Yes or no to each reading.
pub(super) fn answer(study: &Study) -> String {
    let mut text = String::new();
    for judgement in &study.judgements {
        if matches!(study.kind(judgement), Some(Kind::Cut { .. })) {
            let word = if judgement.verdict == Verdict::Proved { "yes" } else { "no" };
            let _ = writeln!(
                text,
                "- **cr_n ≈ {}: {word}** ({}). {}.",
                judgement.reading,
                judgement.verdict.id(),
                capital(&judgement.witness)
            );
        }
    }
    text
}

/// What each limit keeps of the integral, a row a model.
pub(super) fn shares(study: &Study) -> String {
    let mut text = String::from(
        "What each limit keeps of the lobe's whole integral, least and most over the integers 16..1024:\n\n\
         | model | √(6/n) keeps | 6/√n keeps | exact zero in θ keeps |\n|---|---|---|---|\n",
    );
    for model in Model::ALL {
        let share = |limit| {
            let part = study.integral(case(model, Lobe::Cs16, limit));
            let whole = study.integral(case(model, Lobe::Cs16, Limit::Support));
            let share = part.zip(whole).and_then(|(p, w)| p.share_of(w));
            share.map_or(String::new(), |s| {
                let percent = |v: Interval| format!("{:.2} %", 100.0 * v.mid());
                let (low, high) = (percent(s.min.value), percent(s.max.value));
                if low == high { low } else { format!("{low} to {high}") }
            })
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            model.title(),
            share(Limit::Card),
            share(Limit::Paper),
            share(Limit::ExactZero)
        );
    }
    text
}

/// Why half of the models lose more.
pub(super) const NOTE: &str = "For the lobes in θ/2 a limit in θ that is the lobe's own zero stops half way: their \
    support is twice as wide, cut by the hemisphere where 16/n > 1 - √½.\n";
