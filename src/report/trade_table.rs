//! A trade record as tables.

use super::number::short_up;
use super::trade_words::{FORMATS, best, conditions, heading, nanoseconds, short2, up2, verdict};
use crate::bound::Format;
use crate::kernel::exact::Cost;
use crate::trade::{Place, Record, Row, Subject};
use std::fmt::Write;

/// A subject's three rows in one format.
struct Line<'a> {
    subject: Subject,
    rows: [&'a Row; 3],
    /// In which places it is on the frontier.
    best: [bool; 3],
}

fn lines(record: &Record, format: Format) -> Vec<Line<'_>> {
    let frontiers = Place::ALL.map(|place| best(&record.rows_of(format, place)));
    let line = |subject: Subject| {
        let row = |place| record.row(subject, format, place);
        let rows = [row(Place::Single)?, row(Place::Cache)?, row(Place::Memory)?];
        let best = [0, 1, 2].map(|i: usize| frontiers[i].iter().any(|row| row.subject == subject));
        Some(Line { subject, rows, best })
    };
    Subject::all().filter_map(line).collect()
}

/// `6`, `1 + 1 div`, `2 + 2 elem`.
fn cost(cost: Cost) -> String {
    let Cost { operations, divisions, transcendentals } = cost;
    let mut text = operations.to_string();
    for (count, what) in [(divisions, "div"), (transcendentals, "elem")] {
        if count > 0 {
            let _ = write!(text, " + {count} {what}");
        }
    }
    text
}

fn time(row: &Row) -> String {
    let [median, least, most] = [row.time.median, row.time.least, row.time.most].map(nanoseconds);
    format!("{median} ({least} to {most})")
}

/// `8.0626e-3 + 7.9e-6`: the approximation and, where that is proved too, the rounding.
fn bound(row: &Row) -> String {
    let digits = |bound: f64| if bound == 0.0 { "0".to_owned() } else { short_up(bound) };
    match (row.proven.approximation, row.proven.rounding) {
        (Some(approximation), Some(rounding)) => {
            format!("{} + {}", digits(approximation), up2(rounding))
        }
        (Some(approximation), None) => digits(approximation),
        (None, _) => String::new(),
    }
}

/// A record for the terminal: a table a format, then the words.
///
/// A star marks what is on the frontier of its place.
pub fn trade_lines(record: &Record) -> String {
    let mut text = String::new();
    for format in FORMATS {
        let _ = writeln!(
            text,
            "{} at n = {}, ns an element (least to most of {} rounds), * on the frontier\n\
             {:<23}{:<12}{:<26}{:<26}{:<26}{:<10}{:<10}{:<10}proved",
            format.id(),
            record.n,
            record.rounds,
            "kernel",
            "operations",
            "one by one",
            "slice in cache",
            "slice in memory",
            "error",
            "of slices",
            "mean"
        );
        for Line { subject, rows, best } in lines(record, format) {
            let _ = write!(text, "{:<23}{:<12}", subject.id(), cost(rows[0].cost));
            for (row, best) in rows.iter().zip(best) {
                let star = if best { "*" } else { "" };
                let _ = write!(text, "{:<26}", format!("{}{star}", time(row)));
            }
            let [single, slice, _] = rows;
            let errors = [single.sup_error, slice.sup_error, slice.mean_error].map(short2);
            let line = format!("{:<10}{:<10}{:<10}{}", errors[0], errors[1], errors[2], bound(slice));
            let _ = writeln!(text, "{}", line.trim_end());
        }
        text.push('\n');
    }
    for line in conditions(record) {
        let _ = writeln!(text, "{}\n", line.replace(['*', '`'], ""));
    }
    for format in FORMATS {
        for place in Place::ALL {
            let _ = writeln!(text, "{}", heading(format, place));
            for line in verdict(record, format, place) {
                let _ = writeln!(text, "  {line}");
            }
            text.push('\n');
        }
    }
    text.pop();
    text
}

/// A record as a page.
pub(super) fn markdown(record: &Record) -> String {
    let mut text = format!("# Speed against accuracy of cosⁿ and what stands for it, n = {}\n", record.n);
    for line in conditions(record) {
        let _ = write!(text, "\n{line}\n");
    }
    text.push_str(
        "\nNever measured again by `bellfit reproduce`, nor compared.\n\n\
         ![Largest error against time an element, by format and place](trade.png)\n\n## What lies on the frontier\n",
    );
    for format in FORMATS {
        for place in Place::ALL {
            let _ = write!(text, "\n### {}\n\n", heading(format, place));
            for line in verdict(record, format, place) {
                let _ = writeln!(text, "- {line}");
            }
        }
    }
    text.push_str(
        "\n## Everything\n\nNanoseconds an element, least to most in brackets; **bold** on the frontier of its place. \
         *Operations* from cos θ, what depends on n alone computed before: *div* divisions, *elem* elementary functions, a \
         table's loads one each. *pow* is `libm`'s one by one and this crate's over slices, *powf* and *powi* are the \
         platform's. *table-cos* is sampled evenly in cos θ, *table-t* in n (1 - cos θ) up to 16.\n",
    );
    for format in FORMATS {
        let _ = write!(
            text,
            "\n### All in {}\n\n| kernel | operations | one by one | slice in cache | slice in memory | largest error, one by one | \
             of slices | at t | mean | proved |\n|---|---|---|---|---|---|---|---|---|---|\n",
            format.id()
        );
        for Line { subject, rows, best } in lines(record, format) {
            let _ = write!(text, "| {} | {} |", subject.id(), cost(rows[0].cost));
            for (row, best) in rows.iter().zip(best) {
                let bold = if best { "**" } else { "" };
                let _ = write!(text, " {bold}{}{bold} |", time(row));
            }
            let [single, slice, _] = rows;
            let t = f64::from(record.n) * (1.0 - slice.sup_at);
            let errors = [single.sup_error, slice.sup_error].map(short2);
            let mean = short2(slice.mean_error);
            let _ = writeln!(text, " {} | {} | {t:.2} | {mean} | {} |", errors[0], errors[1], bound(slice));
        }
    }
    text
}
