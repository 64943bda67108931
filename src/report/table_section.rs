//! The tables: what is printed beside what is computed.

use super::cut;
use super::number::{enclosure, short};
use super::pixel;
use super::plots::Plots;
use super::source::{source, source_alone};
use super::study::{NearestRow, Study, case};
use super::table_one;
use super::words::prose_cell;
use crate::fit::Objective;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::Kind;
use std::fmt::Write;

/// The section.
pub(super) fn section(study: &Study, plots: &Plots<'_>, text: &mut String) {
    text.push_str("\n## The tables\n\n### Table 1, printed and recomputed\n\n");
    text.push_str(&table_one::markdown(study));
    text.push_str(&source(&["fits/table1.csv", "reports/table1.md", "reports/table1.tex"]));
    let _ = write!(text, "\n### What each limit keeps\n\n{}", cut::shares(study));
    text.push_str(&source(&["fits/integrals"]));
    let _ = write!(text, "\n{}", cut::NOTE);
    fits(study, text);
    nearest(study, text);
    suprema(study, text);
    pixel::section(&study.pixel, plots, text);
}

fn fits(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Least squares: what reproduces the printed constants\n\n\
         coef(n) = (a n + b)/(divisor π) over the integers 16..1024, twelve digits and certified residuals. The L14 rows of the verdicts enclose the solutions themselves.\n\n\
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
    let command = "bellfit fit --model ... --limit ... --objective ...";
    text.push_str(&source_alone(&["fits/coefficients.csv"], command));
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
            "| {}, {} | {} | **{}** | {} |",
            judgement.claim,
            prose_cell(stem),
            prose_cell(&choice.replace('/', ", ")),
            judgement.verdict.id(),
            prose_cell(&judgement.witness)
        );
    }
    text.push_str(&source(&["reports/verdicts.csv"]));
}

fn nearest(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Printed constants that break their bound, mended\n\n\
         Fewest printed digits changed, and of those b's as few as can be, residual certified over the integers \
         16..1024.\n\n\
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
    text.push_str(&source(&["fits/nearest.csv"]));
}

fn suprema(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Certified suprema\n\nOver every θ in [0, π/2], or every t ≥ 0.\n\n\
         | function | for | supremum | at |\n|---|---|---|---|\n",
    );
    for row in &study.suprema {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            prose_cell(&row.function),
            prose_cell(&row.parameter),
            enclosure(row.value),
            prose_cell(&row.at)
        );
    }
    text.push_str(&source(&["fits/suprema.csv"]));
}
