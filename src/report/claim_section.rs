//! Every claim: what is stated and where, the verdict and why, its plots, the proof, and every reading.

use super::number::enclosure;
use super::plots::Plots;
use super::source::source;
use super::study::Study;
use super::summary::{Group, Summary, summaries_of};
use super::words::{prose, prose_cell};
use crate::bound::Interval;
use crate::integral::Limit;
use crate::paper::{Claim, Kind, Statistic};
use crate::verdict::{Judgement, prove_minimum};
use std::fmt::Write;

/// Both papers' claims, a heading a claim.
pub(super) fn sections(study: &Study, plots: &Plots<'_>, text: &mut String) {
    for (pixel, title) in [(false, "Every claim of the lobe paper"), (true, "Every claim of the pixel paper")]
    {
        let _ = write!(text, "\n## {title}\n");
        for summary in &summaries_of(study, pixel) {
            claim(summary, plots, text);
        }
    }
}

const FILES: [&str; 2] = ["reports/verdicts.csv", "reports/verdicts.json"];

fn claim(summary: &Summary<'_>, plots: &Plots<'_>, text: &mut String) {
    let Summary { claim, groups } = summary;
    let Claim { id, locator, text: stated, .. } = claim;
    let _ = write!(
        text,
        "\n### {id}\n\n**{}** · {}\n\n> {}\n\n",
        summary.verdict(),
        prose(locator),
        prose(stated)
    );
    let count: usize = groups.iter().map(|group| group.members.len()).sum();
    for group in groups {
        let computed = computed(group).map_or(String::new(), |value| format!(" Computed: {value}."));
        let (verdict, reason) = (group.verdict.id(), prose(group.reason));
        let rest = match group.members.as_slice() {
            [one] if count == 1 => format!("Witness: {}.", prose(&one.witness)),
            _ => format!("{}.", prose(&readings(group))),
        };
        let how = if group.vacuous { " vacuously" } else { "" };
        let _ = writeln!(text, "- **{verdict}**{how}: {reason}.{computed} *{rest}*");
    }
    text.push_str(&source(&FILES));
    text.push_str(&plots.of_claim(id));
    proof(claim, text);
    if count > 1 {
        every_reading(groups, count, text);
    }
}

/// The readings of a group: how many, and word by word what they share and what they choose from.
fn readings(group: &Group<'_>) -> String {
    let split: Vec<Vec<&str>> = group.members.iter().map(|m| m.reading.split('/').collect()).collect();
    match split.as_slice() {
        [] => String::new(),
        [_] => group.members.iter().map(|m| format!("Reading: {}", m.reading)).collect(),
        [first, rest @ ..] if rest.iter().all(|words| words.len() == first.len()) => {
            let choices = (0..first.len()).map(|i| {
                let mut words: Vec<&str> = Vec::new();
                for all in &split {
                    if !words.contains(&all[i]) {
                        words.push(all[i]);
                    }
                }
                words.join(" or ")
            });
            format!("{} readings: {}", split.len(), choices.collect::<Vec<_>>().join(", "))
        }
        _ => format!("{} readings", split.len()),
    }
}

fn computed(group: &Group<'_>) -> Option<String> {
    let values = group.members.iter().filter_map(|m| m.computed);
    values.reduce(Interval::hull).map(enclosure)
}

/// The steps by which the minimum of the lobes' difference is proved, where that is what is stated.
fn proof(claim: &Claim, text: &mut String) {
    let stated = claim.readings.iter().find_map(|reading| match &reading.kind {
        Kind::LobeDifference { statistic: Statistic::Min, n, .. } => Some(*n),
        _ => None,
    });
    let Some((from, to)) = stated else { return };
    let _ = write!(
        text,
        "\n#### Why Δ has no negative value\n\nThe proof that min Δ = 0, as it was checked for the cut 6/√n and every \
         real n in [{from}, {to}] (r = n/16, x = 1 - cos θ):\n\n"
    );
    for step in prove_minimum(Limit::Paper, from, to).steps {
        let _ = writeln!(text, "1. {}", prose(&step));
    }
}

/// A row a reading, folded.
fn every_reading(groups: &[Group<'_>], count: usize, text: &mut String) {
    let _ = write!(
        text,
        "\n<details>\n<summary>All {count} readings, computed, with witness</summary>\n\n\
         | reading | verdict | printed | computed | evidence | witness |\n|---|---|---|---|---|---|\n"
    );
    let members = groups.iter().flat_map(|group| group.members.iter().map(move |m| (group.vacuous, m)));
    for (vacuous, judgement) in members {
        let Judgement { reading, verdict, printed, computed, evidence, witness, .. } = judgement;
        let _ = writeln!(
            text,
            "| {} | **{}**{} | {} | {} | {} | {} |",
            prose_cell(reading),
            verdict.id(),
            if vacuous { " vacuously" } else { "" },
            prose_cell(printed),
            computed.map(enclosure).unwrap_or_default(),
            evidence.map_or("", |evidence| evidence.id()),
            prose_cell(witness)
        );
    }
    text.push_str(&source(&FILES));
    text.push_str("\n</details>\n");
}
