//! A trade record in words: all of it from the record's numbers.

use super::number::short;
use crate::bound::Format;
use crate::kernel::stand_in::StandIn;
use crate::trade::{Lookup, Over, Place, Record, Row, Sampling, Spread, Subject, frontier};

/// What is in common use, and so is told where it is beaten.
const COMMON: [Subject; 10] = [
    Subject::Powf,
    Subject::Powi,
    Subject::StandIn(StandIn::Squarings),
    Subject::StandIn(StandIn::Exp2Log2),
    Subject::StandIn(StandIn::Schlick),
    Subject::StandIn(StandIn::SchlickPrinted),
    Subject::StandIn(StandIn::SphericalGaussian),
    Subject::StandIn(StandIn::Cs16),
    Subject::Table(Sampling { over: Over::Cosine, lookup: Lookup::Nearest, samples: 1024 }),
    Subject::Table(Sampling { over: Over::Cosine, lookup: Lookup::Linear, samples: 256 }),
];

/// Of a subject and the empty loop: nearer than this, its own time is not told.
const AT_FLOOR: f64 = 1.1;

/// The two formats of a record.
pub(super) const FORMATS: [Format; 2] = [Format::Single, Format::Double];

/// A format and place for readers.
pub(super) fn heading(format: Format, place: Place) -> String {
    let place = match place {
        Place::Single => "one by one",
        Place::Cache => "slice in cache",
        Place::Memory => "slice in memory",
    };
    format!("{}, {place}", format.id())
}

/// Nanoseconds in three significant digits.
pub(super) fn nanoseconds(x: f64) -> String {
    let digits = if x >= 100.0 {
        0
    } else if x >= 10.0 {
        1
    } else if x >= 1.0 {
        2
    } else {
        3
    };
    format!("{x:.digits$}")
}

/// Two significant digits.
pub(super) fn short2(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") }
}

/// A positive bound in two significant digits, rounded up.
pub(super) fn up2(x: f64) -> String {
    let text = short2(x);
    // Rounded to nearest it may have come down, by a twentieth at most.
    if text.parse::<f64>().is_ok_and(|read| read >= x) { text } else { short2(x + 0.05 * unit(x)) }
}

/// The power of ten at a positive number's first digit.
fn unit(x: f64) -> f64 {
    libm::exp10(libm::floor(libm::log10(x)))
}

/// The rows that no other beats in both, from the fastest on.
pub(super) fn best<'a>(rows: &[&'a Row]) -> Vec<&'a Row> {
    let points: Vec<_> = rows.iter().map(|row| (row.time.median, row.sup_error)).collect();
    frontier(&points).into_iter().map(|i| rows[i]).collect()
}

/// By how much medians stray from their least, as ratios: of half the rows at most, and of 19 in 20.
fn stray(record: &Record) -> (f64, f64) {
    let mut all: Vec<f64> = record.rows.iter().map(|row| row.time.wander()).collect();
    all.sort_by(f64::total_cmp);
    let at = |share: f64| all.get((share * all.len() as f64) as usize).copied().unwrap_or(1.0);
    (at(0.5), at(0.95))
}

/// Ratios of time below this mean little.
fn doubt(record: &Record) -> f64 {
    stray(record).1.max(record.reference.wander())
}

/// What was measured on what, and how steady it was.
pub(super) fn conditions(record: &Record) -> Vec<String> {
    let machine = &record.machine;
    let Spread { median, least, most } = record.reference;
    let relative = record.reference.relative();
    let word = match doubt(record) {
        x if x <= 1.05 => "quiet",
        x if x <= 1.25 => "restless",
        _ => "noisy",
    };
    let (half, most_rows) = stray(record);
    let percent = |ratio: f64| short2_percent(100.0 * (ratio - 1.0));
    vec![
        format!(
            "Measured by `bellfit trade` on one thread of {} ({}, {}; slices by the vector unit {}), at n = {}: medians \
             of {} rounds, in each of which everything is timed after the other.",
            machine.processor, machine.architecture, machine.system, machine.unit, record.n, record.rounds
        ),
        format!(
            "Arguments are cosines, drawn so that t = n (1 - cos θ) is uniform in [0, {}): none so far out that cosⁿ \
             underflows. *One by one* is the throughput of inlined calls whose argument and result are hidden from the compiler, \
             with what depends on n alone computed before; *in cache* a slice of {} elements; *in memory* slices of {} MiB \
             each, read and written, {}.",
            short(record.n.min(32).into()),
            record.elements,
            record.memory >> 20,
            match machine.cache {
                Some(cache) => format!("with a last-level cache of {} MiB", cache >> 20),
                None => "the size of the last-level cache not known".to_owned(),
            }
        ),
        format!(
            "The machine was {word}: a reference loop of operations that wait for each other took {} µs, {} to {} over \
             the rounds, a spread of {} %. Half of the medians lie within {} % of their fastest round, 19 in 20 within {} %. \
             Ratios of time below {:.2} mean little here, and neighbours on a frontier that are as near change places from \
             run to run.",
            short(median),
            short(least),
            short(most),
            short2_percent(100.0 * relative),
            percent(half),
            percent(most_rows),
            doubt(record)
        ),
        "Errors are absolute, against cosⁿ of the cosine as the format holds it, of the very code that was timed, sampled \
         at 69633 angles; a proved bound is over every angle and for exact arithmetic, and what rounding adds to it at most follows a plus where \
         that is proved too. Tables are warm here: in a program other work drives them out of the nearest cache."
            .to_owned(),
    ]
}

/// One decimal below ten, none from there on.
fn short2_percent(x: f64) -> String {
    if x < 10.0 { format!("{x:.1}") } else { format!("{x:.0}") }
}

fn told(row: &Row) -> String {
    let bound = row.proven.approximation.map_or(String::new(), |bound| {
        let rounding = row.proven.rounding.map_or(String::new(), |rounding| format!(" + {}", up2(rounding)));
        format!(", proved {}{rounding}", up2(bound))
    });
    format!(
        "{} ({} ns, error {}{bound})",
        row.subject.id(),
        nanoseconds(row.time.median),
        short2(row.sup_error)
    )
}

/// "3.1 times" or, where that is next to nothing, none.
fn times(ratio: f64) -> String {
    if ratio >= 10.0 { format!("{ratio:.0} times") } else { format!("{ratio:.1} times") }
}

/// What is on the frontier of a format and place, what in common use is not, and what cannot be told.
pub(super) fn verdict(record: &Record, format: Format, place: Place) -> Vec<String> {
    let rows = record.rows_of(format, place);
    let best = best(&rows);
    let mut lines = vec![format!(
        "On the frontier: {}.",
        best.iter().map(|row| told(row)).collect::<Vec<_>>().join("; ")
    )];
    let beaten: Vec<String> =
        COMMON.iter().filter_map(|common| beaten(record, *common, &rows, &best)).collect();
    if !beaten.is_empty() {
        lines.push(format!("Of what is in common use, beaten: {}.", beaten.join("; ")));
    }
    if let Some(floor) = record.floor(format, place) {
        let at = |row: &&&Row| row.time.median <= AT_FLOOR * floor.median;
        let hidden: Vec<String> = rows.iter().filter(at).map(|row| row.subject.id()).collect();
        let what = if place == Place::Single { "the loop by itself" } else { "a copy of the slice" };
        let floor = nanoseconds(floor.median);
        lines.push(if hidden.is_empty() {
            format!("{} takes {floor} ns, told apart from all of them.", capital(what))
        } else {
            format!(
                "{} takes {floor} ns; within a tenth of it, so that their own time is not told: {}.",
                capital(what),
                hidden.join(", ")
            )
        });
    }
    lines
}

/// By what a common choice is beaten, if it is: the fastest that is no less accurate.
fn beaten(record: &Record, common: Subject, rows: &[&Row], best: &[&Row]) -> Option<String> {
    let row = rows.iter().find(|row| row.subject == common)?;
    if best.iter().any(|other| other.subject == common) {
        return None;
    }
    let by = best.iter().find(|other| other.sup_error <= row.sup_error)?;
    let (speed, gain) = (row.time.median / by.time.median, row.sup_error / by.sup_error);
    if speed < doubt(record) && gain < 1.05 {
        return Some(format!("{} by {}, but by no more than the noise", told(row), by.subject.id()));
    }
    let faster =
        if speed < doubt(record) { "no slower".to_owned() } else { format!("{} as fast", times(speed)) };
    let nearer = if gain < 1.05 { "as accurate".to_owned() } else { format!("{} as accurate", times(gain)) };
    Some(format!("{} by {}, {faster} and {nearer}", told(row), by.subject.id()))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
