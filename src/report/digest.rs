//! The verdicts in short: what holds and what does not, a line a claim, from the judgements alone.

use super::anchor::anchor;
use super::source::source;
use super::study::Study;
use super::summary::{Group, Summary, summaries};
use super::words::prose;
use crate::verdict::Verdict;
use std::fmt::Write;

/// Where a claim stands among the lists.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Standing {
    Holds,
    InPart,
    Fails,
    Nothing,
}

fn standing(summary: &Summary<'_>) -> Standing {
    let telling = |verdicts: &[Verdict]| {
        summary.groups.iter().any(|group| !group.vacuous && verdicts.contains(&group.verdict))
    };
    let holds = telling(&[Verdict::Proved, Verdict::Reproduced]);
    let fails = telling(&[Verdict::Refuted, Verdict::Undecided]);
    match (holds, fails) {
        (true, false) => Standing::Holds,
        (true, true) => Standing::InPart,
        (false, true) => Standing::Fails,
        (false, false) => Standing::Nothing,
    }
}

/// The lists, and last what there is nothing to judge about.
pub(super) fn section(study: &Study, text: &mut String) {
    let summaries = summaries(study);
    let of = |wanted: &'static [Standing]| {
        summaries.iter().filter(move |summary| wanted.contains(&standing(summary)))
    };
    text.push_str("\n### What holds\n\n");
    for summary in of(&[Standing::Holds, Standing::InPart]) {
        line(summary, &[Verdict::Proved, Verdict::Reproduced], text);
    }
    text.push_str("\n### What does not hold\n\n");
    for summary in of(&[Standing::Fails, Standing::InPart]) {
        line(summary, &[Verdict::Refuted, Verdict::Undecided], text);
    }
    let rest: Vec<String> = of(&[Standing::Nothing]).map(named).collect();
    let _ = write!(text, "\nDefinitions and figures, nothing to judge: {}.\n", rest.join(", "));
    text.push_str(&source(&["reports/verdicts.csv", "reports/verdicts.json"]));
}

fn named(summary: &Summary<'_>) -> String {
    let id = &summary.claim.id;
    format!("[{id}](#{})", anchor(id))
}

/// The claim, its verdict, and the first reason that tells something under one of the verdicts; what it states
/// only where it stands first.
fn line(summary: &Summary<'_>, verdicts: &[Verdict], text: &mut String) {
    let telling = |group: &&Group<'_>| !group.vacuous && verdicts.contains(&group.verdict);
    let reason = summary.groups.iter().find(telling).map_or(String::new(), |group| prose(group.reason));
    let stated = prose(&summary.claim.text);
    let told = match (standing(summary), verdicts.contains(&Verdict::Proved)) {
        (Standing::InPart, true) => format!("{stated}. It does, for one: {reason}"),
        (Standing::InPart, false) => format!("it fails, for one: {reason}"),
        _ => format!("{stated}. Why: {reason}"),
    };
    let _ = writeln!(text, "- {} **{}**: {told}.", named(summary), summary.verdict());
}
