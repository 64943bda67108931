//! `reports/report.md`.

use super::better;
use super::energy;
use super::figures::Figure;
use super::filter_section;
use super::number::{enclosure, short};
use super::pixel;
use super::readme::cell;
use super::stability_section;
use super::study::{NearestRow, Study, case};
use super::summary::{Group, Summary, summaries, summaries_of};
use super::table_one;
use super::trade_words;
use crate::bound::Interval;
use crate::fit::Objective;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::Kind;
use crate::verdict::{Verdict, prove_minimum};
use std::fmt::Write;

/// The whole report; the pixel paper's figures and those of rounding stand in their sections, the others together.
pub(super) fn report(
    study: &Study,
    figures: &[Figure],
    of_pixels: &[Figure],
    of_stability: &[Figure],
) -> String {
    let mut text = String::from(
        "# The lobe and the pixel paper, verified\n\n\
         Written by `bellfit` (`cargo run --release`); every number here is computed, and stands with all its \
         digits in the files named beside it. *Proved* and *refuted* rest on enclosures or exact arithmetic, \
         over what the row says: the integers 16..1024, every real n of that range, every θ in [0, π/2]; only L13's \
         readings at every angle rest on quadrature with a stated error, and hold as *reproduced*.\n\n",
    );
    let _ = write!(text, "## Is cr_n ≈ √(6/n)?\n\n{}\n", cut(study));
    verdicts(study, &mut text);
    text.push_str("## Table 1, printed and recomputed\n\n");
    text.push_str("`fits/table1.csv`, `reports/table1.md`, `reports/table1.tex`.\n\n");
    text.push_str(&table_one::markdown(study));
    fits(study, &mut text);
    nearest(study, &mut text);
    minimum(&mut text);
    suprema(study, &mut text);
    better::sections(study, &mut text);
    energy::sections(study, &mut text);
    text.push_str(&pixel::section(&study.pixel, of_pixels));
    filter_section::section(&study.filters, &mut text);
    stability_section::section(&study.stability, of_stability, &mut text);
    text.push_str(trade_words::SECTION);
    text.push_str("\n## Plots\n");
    for Figure { stem, alt, .. } in figures {
        let _ = write!(text, "\n![{alt}](plots/{stem}.png)\n\n*{alt}* ([SVG](plots/{stem}.svg))\n");
    }
    details(study, &mut text);
    text
}

/// Whether cr_n ≈ √(6/n), what it does to each integral, and what holds instead.
pub(super) fn cut(study: &Study) -> String {
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
    text.push_str(
        "\nWhat each limit keeps of the lobe's whole integral, least and most over the integers 16..1024:\n\n\
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
    text.push_str(
        "\nFor the lobes in θ/2 a limit in θ that is the lobe's own zero stops half way: their support is twice as \
         wide, cut by the hemisphere where 16/n > 1 - √½.\n",
    );
    text
}

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map_or(String::new(), |first| first.to_uppercase().collect::<String>() + characters.as_str())
}

fn verdicts(study: &Study, text: &mut String) {
    text.push_str("## Verdicts\n\n`reports/verdicts.csv`, `reports/verdicts.json`: one row a reading.\n");
    for (pixel, title) in [(false, "The lobe paper"), (true, "The pixel paper")] {
        let _ = write!(text, "\n### {title}\n\n");
        verdict_table(summaries_of(study, pixel), text);
    }
    text.push('\n');
}

fn verdict_table(summaries: Vec<Summary<'_>>, text: &mut String) {
    text.push_str("| claim | as stated | verdict | readings | computed | why |\n|---|---|---|---|---|---|\n");
    for Summary { claim, groups } in &summaries {
        for (i, group) in groups.iter().enumerate() {
            let (id, stated) =
                if i == 0 { (claim.id.as_str(), cell(&claim.text)) } else { ("", String::new()) };
            let _ = writeln!(
                text,
                "| {id} | {stated} | **{}** | {} | {} | {} |",
                group.verdict.id(),
                cell(&readings(group)),
                computed(group),
                cell(group.reason)
            );
        }
    }
}

/// The readings of a group: word by word what they share, and what they choose from.
fn readings(group: &Group<'_>) -> String {
    let split: Vec<Vec<&str>> = group.members.iter().map(|m| m.reading.split('/').collect()).collect();
    match split.as_slice() {
        [] => String::new(),
        [_] => group.members.iter().map(|m| m.reading.clone()).collect(),
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
            format!("{} of: {}", split.len(), choices.collect::<Vec<_>>().join(", "))
        }
        _ => format!("{} readings", split.len()),
    }
}

fn computed(group: &Group<'_>) -> String {
    let values = group.members.iter().filter_map(|m| m.computed);
    values.reduce(Interval::hull).map(enclosure).unwrap_or_default()
}

fn fits(study: &Study, text: &mut String) {
    text.push_str(
        "\n## Least squares: what reproduces the printed constants\n\n\
         coef(n) = (a n + b)/(divisor π) over the integers 16..1024 (`fits/coefficients.csv`, twelve digits and \
         certified residuals). The L14 rows of the verdicts enclose the solutions themselves.\n\n\
         | model | limit | objective | a | b | residual, integers | residual, every real n |\n|---|---|---|---|---|---|---|\n",
    );
    for model in Model::ALL {
        for limit in Limit::ALL {
            for objective in Objective::ALL {
                let Some(row) = study.fit(case(model, Lobe::Cs16, limit), objective) else { continue };
                let span = |e: &crate::bound::Extremes| {
                    format!("{} to {}", short(e.min.value.lo()), short(e.max.value.hi()))
                };
                let _ = writeln!(
                    text,
                    "| {} | {} | {} | {} | {} | {} | {} |",
                    model.id(),
                    limit.id(),
                    objective.id(),
                    row.line.a(),
                    row.line.b(),
                    span(&row.integers),
                    span(&row.reals)
                );
            }
        }
    }
    text.push_str(
        "\nWhat that says of the printed digits, from enclosures of the least-squares solutions themselves:\n\n\
         | as printed | limit, objective | verdict | solution |\n|---|---|---|---|\n",
    );
    for judgement in &study.judgements {
        if !matches!(study.kind(judgement), Some(Kind::Fit { .. })) {
            continue;
        }
        let (stem, choice) = judgement.reading.split_once('/').unwrap_or((&judgement.reading, ""));
        let _ = writeln!(
            text,
            "| {}, {stem} | {} | {} | {} |",
            judgement.claim,
            choice.replace('/', ", "),
            judgement.verdict.id(),
            judgement.witness
        );
    }
}

fn nearest(study: &Study, text: &mut String) {
    text.push_str(
        "\n## Printed constants that break their bound, mended\n\n\
         Fewest printed digits changed, and of those b's as few as can be, residual certified over the integers 16..1024 \
         (`fits/nearest.csv`).\n\n\
         | claim | model | limit | printed | bound | its max abs residual | nearest that keeps it | its max abs residual |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    for NearestRow { printed, nearest } in &study.nearest {
        let worst = printed.integers.magnitude();
        let (line, residual) =
            nearest.as_ref().map_or(("none with as many digits".to_owned(), String::new()), |n| {
                let worst = n.extremes.magnitude();
                (n.line.to_string(), format!("{} at n = {}", short(worst.value.hi()), worst.n))
            });
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} at n = {} | {line} | {residual} |",
            printed.claim,
            printed.case.model.id(),
            printed.case.limit.id(),
            printed.line,
            printed.bound.as_ref().map_or("", |b| &b.text),
            short(worst.value.hi()),
            worst.n,
        );
    }
}

fn minimum(text: &mut String) {
    text.push_str(
        "\n## Why Δ has no negative value\n\nThe proof that min Δ = 0, as it was checked for the cut 6/√n and every \
         real n in [16, 1024] (r = n/16, x = 1 - cos θ):\n\n",
    );
    for step in prove_minimum(Limit::Paper, 16, 1024).steps {
        let _ = writeln!(text, "1. {step}");
    }
}

fn suprema(study: &Study, text: &mut String) {
    text.push_str(
        "\n## Certified suprema\n\n`fits/suprema.csv`; over every θ in [0, π/2], or every t ≥ 0.\n\n\
         | function | for | supremum | at |\n|---|---|---|---|\n",
    );
    for row in &study.suprema {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            row.function,
            row.parameter,
            enclosure(row.value),
            row.at
        );
    }
}

fn details(study: &Study, text: &mut String) {
    text.push_str("\n## Every claim\n");
    for Summary { claim, groups } in &summaries(study) {
        let _ = write!(text, "\n### {}: {}\n\nWhere: {}.\n\n", claim.id, claim.text, claim.locator);
        for group in groups {
            let _ = writeln!(text, "- **{}**: {}", group.verdict.id(), group.reason);
            for member in &group.members {
                let value = member.computed.map(|c| format!(" {};", enclosure(c))).unwrap_or_default();
                let _ = writeln!(text, "  - {}:{value} {}", member.reading, member.witness);
            }
        }
    }
}
