//! The plot of a trade record.

use super::chart::{Axis, Chart, LineChart, Mark, Panels, Scale, Series, Style};
use super::figures::Figure;
use super::trade_words::{FORMATS, best, heading};
use crate::bound::Format;
use crate::kernel::stand_in::StandIn;
use crate::trade::{Place, Record, Row, Subject};

/// Where an error of 0 is drawn, below every other.
const NONE: f64 = 1e-18;

/// What a subject is drawn as.
fn group(subject: Subject) -> &'static str {
    match subject {
        Subject::StandIn(stand_in) => match stand_in.bell() {
            Some((_, 1)) => GROUPS[0],
            Some(_) => GROUPS[1],
            None if stand_in.is_exact() => GROUPS[3],
            None => GROUPS[2],
        },
        Subject::Powf | Subject::Powi => GROUPS[3],
        Subject::Table(_) => GROUPS[4],
    }
}

const GROUPS: [&str; 5] = [
    "cs_16 and other bells of degree one",
    "cubic bells",
    "Schlick, spherical Gaussian",
    "cosⁿ itself",
    "tables: sampled in, lookup, samples",
];
/// Those with a name in the plot beside the frontier's; the table has all.
const NAMED: [Subject; 3] =
    [Subject::StandIn(StandIn::Cs16), Subject::Powf, Subject::StandIn(StandIn::Schlick)];
/// Of the frontier's members that lie nearer than this, as a share of the frame, one has a name.
const APART: f64 = 0.07;

pub(super) fn figure(record: &Record) -> Figure {
    let machine = &record.machine.processor;
    // Both formats of a place side by side.
    let charts =
        Place::ALL.iter().flat_map(|place| FORMATS.map(|format| panel(record, format, *place))).collect();
    Figure {
        stem: "trade",
        alt: format!(
            "Largest error of cosⁿ's stand-ins against nanoseconds an element, with the frontier, on {machine}."
        ),
        chart: Chart::Panels(Panels {
            title: format!("Error against time an element: {machine}"),
            subtitle: format!(
                "largest error against cosⁿ, n = {}; one thread, vector unit {}",
                record.n, record.machine.unit
            ),
            columns: 2,
            charts,
        }),
    }
}

fn at(row: &Row) -> (f64, f64) {
    (row.time.median, row.sup_error.max(NONE))
}

fn panel(record: &Record, format: Format, place: Place) -> LineChart {
    let rows = record.rows_of(format, place);
    let best = best(&rows);
    let line = Series::new(
        "frontier: nothing is both faster and nearer",
        Style::Line,
        best.iter().map(|row| at(row)).collect(),
    );
    let line = Series { colour: Some(7), ..line };
    let series = GROUPS.iter().enumerate().filter_map(|(colour, name)| {
        let points: Vec<_> =
            rows.iter().filter(|row| group(row.subject) == *name).map(|row| at(row)).collect();
        let series = Series::new(*name, Style::Points, points);
        (!series.points.is_empty()).then_some(Series { colour: Some(colour), ..series })
    });
    let x = Axis::new("nanoseconds an element", Scale::Log10, range(&rows, |row| row.time.median));
    let y = Axis::new("largest error", Scale::Log10, range(&rows, |row| at(row).1));
    let marks = named(&rows, &best, x.range, y.range);
    LineChart {
        title: heading(format, place),
        subtitle: String::new(),
        x,
        y,
        bands: vec![],
        series: std::iter::once(line).filter(|line| !line.points.is_empty()).chain(series).collect(),
        marks,
    }
}

/// From the least to the most, with room for the names.
fn range(rows: &[&Row], of: impl Fn(&Row) -> f64) -> (f64, f64) {
    let values = rows.iter().map(|row| of(row)).filter(|x| x.is_finite());
    let (lo, hi) = values.fold((f64::INFINITY, 0.0_f64), |(lo, hi), x| (lo.min(x), hi.max(x)));
    (0.4 * lo, 2.5 * hi)
}

/// The names in a panel: of [`NAMED`], of the frontier's kernels, then of its tables, as far as there is room.
fn named(rows: &[&Row], best: &[&Row], x: (f64, f64), y: (f64, f64)) -> Vec<Mark> {
    let share = |(lo, hi): (f64, f64), a: f64, b: f64| libm::log(a / b) / libm::log(hi / lo);
    let near = |a: (f64, f64), b: (f64, f64)| libm::hypot(share(x, a.0, b.0), share(y, a.1, b.1)) < APART;
    let is_table = |row: &&&Row| matches!(row.subject, Subject::Table(_));
    let fixed = rows.iter().filter(|row| NAMED.contains(&row.subject));
    let kernels = best.iter().filter(|row| !is_table(row) && !NAMED.contains(&row.subject));
    let mut marks: Vec<Mark> = Vec::new();
    for row in fixed.chain(kernels).chain(best.iter().filter(is_table)) {
        let at = at(row);
        if NAMED.contains(&row.subject) || !marks.iter().any(|mark| near(mark.at, at)) {
            let id = row.subject.id();
            let text = id.strip_prefix("table-").unwrap_or(&id).to_owned();
            marks.push(Mark { at, text });
        }
    }
    marks
}
