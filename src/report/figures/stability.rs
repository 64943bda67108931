//! Rounding against the exponent, a panel a format, and against the ellipse's aspect and size.

use super::Figure;
use super::sample::{empty, number};
use crate::bound::{Format, Handed};
use crate::kernel::stand_in::StandIn;
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};
use crate::stability::{FootprintError, LobeErrors, QForm, Stability, limits};

/// The kernels drawn.
const DRAWN: [(StandIn, &str); 4] = [
    (StandIn::Cs16, "stability-cs-16"),
    (StandIn::Cubic4, "stability-cubic-4"),
    (StandIn::Cubic8, "stability-cubic-8"),
    (StandIn::Power, "stability-pow"),
];

/// The figures of rounding at the extremes, in the report's order.
pub fn stability(study: &Stability) -> Vec<Figure> {
    let mut figures: Vec<Figure> =
        DRAWN.iter().map(|(stand_in, stem)| by_exponent(study, *stand_in, stem)).collect();
    figures.push(footprints(study));
    figures
}

/// The least error of a panel.
const fn floor(format: Format) -> f64 {
    match format {
        Format::Half | Format::HalfStored => 1e-4,
        Format::Single => 1e-8,
        Format::Double => 1e-17,
    }
}

fn label(handed: Handed) -> &'static str {
    match handed {
        Handed::Cosine => "cos θ handed over",
        Handed::Versine => "1 − cos θ",
        Handed::Difference => "|a − b|²/2",
    }
}

/// Powers of ten, every so many.
fn powers(from: i32, to: i32, step: usize) -> Vec<(f64, String)> {
    (from..=to).step_by(step).map(|k| (libm::exp10(f64::from(k)), format!("1e{k}"))).collect()
}

fn by_exponent(study: &Stability, stand_in: StandIn, stem: &'static str) -> Figure {
    let points = |format: Format, handed: Handed, of: fn(LobeErrors) -> f64| -> Vec<(f64, f64)> {
        let own = study
            .lobes
            .iter()
            .filter(|row| (row.stand_in, row.format, row.handed) == (stand_in, format, handed));
        own.filter_map(|row| Some((row.n, of(row.errors?)))).collect()
    };
    let panel = |format: Format| {
        let ways = Handed::ALL.map(|handed| {
            Series::new(label(handed), Style::Line, points(format, handed, |e| e.rounding.value))
        });
        let mut series = ways.to_vec();
        if !stand_in.is_exact() {
            let own = points(Format::Double, Handed::Versine, |e| e.approximation.value);
            series.push(Series::new("the kernel's own distance from cosⁿ", Style::Dotted, own));
        }
        let x =
            Axis { ticks: powers(0, 12, 2), ..Axis::new("specular exponent n", Scale::Log10, (1.0, 1e12)) };
        let y = Axis::new("largest rounding error", Scale::Log10, (floor(format), 2.0));
        LineChart { title: format.id().into(), series, ..empty(x, y) }
    };
    let limit = |handed: Handed| {
        let found = limits(&study.lobes)
            .into_iter()
            .find(|limit| (limit.stand_in, limit.format, limit.handed) == (stand_in, Format::Single, handed));
        found.and_then(|limit| limit.below_display).map_or("none".to_owned(), |n| format!("{n:e}"))
    };
    let message = format!(
        "{}: in f32 rounding stays below 1/256 to n = {} from cos θ, to {} from |a − b|²/2, to {} from 1 − cos θ",
        stand_in.id(),
        limit(Handed::Cosine),
        limit(Handed::Difference),
        limit(Handed::Versine)
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle:
            "Largest |computed − the kernel in exact arithmetic| over θ from 1e-8 to π/2, sampled. Lines end \
                   where a constant leaves the format. Scales differ."
                .into(),
        columns: 2,
        charts: Format::ALL.into_iter().map(panel).collect(),
    });
    Figure { stem, alt: format!("{message}."), chart }
}

/// The forms drawn; the padded ones have the unpadded ones' errors where padding does not matter.
const FORMS: [(QForm, &str); 3] = [
    (QForm::ALL[4], "conic, absolute"),
    (QForm::ALL[0], "footprint, absolute"),
    (QForm::ALL[2], "inverse, relative"),
];

/// The aspect at which sizes are compared.
const ASPECT: f64 = 100.0;

fn footprints(study: &Stability) -> Figure {
    let series = |format: Format, x: &dyn Fn(&FootprintError) -> Option<f64>| -> Vec<Series> {
        let own = |form: QForm| study.footprints.iter().filter(move |r| (r.form, r.format) == (form, format));
        let points = |form| own(form).filter_map(|row| Some((x(row)?, row.error))).collect();
        FORMS.iter().map(|(form, label)| Series::new(*label, Style::Line, points(*form))).collect()
    };
    let mut charts = Vec::new();
    for format in [Format::Single, Format::Double] {
        let y = Axis::new("largest error of Q ≤ 1", Scale::Log10, (floor(format), 1e5));
        let x = Axis {
            ticks: powers(0, 6, 1),
            ..Axis::new("aspect of the ellipse, major semi-axis 1 texel", Scale::Log10, (1.0, 1e6))
        };
        charts.push(LineChart {
            title: format!("{}, by aspect", format.id()),
            series: series(format, &|row| (row.scale == 1.0).then_some(row.aspect)),
            ..empty(x, y)
        });
    }
    for format in [Format::Single, Format::Double] {
        let y = Axis::new("largest error of Q ≤ 1", Scale::Log10, (floor(format), 1e5));
        let x = Axis {
            ticks: powers(-20, 20, 10),
            ..Axis::new("major semi-axis [texels], aspect 100", Scale::Log10, (1e-20, 1e20))
        };
        charts.push(LineChart {
            title: format!("{}, by size", format.id()),
            series: series(format, &|row| (row.aspect == ASPECT).then_some(row.scale)),
            ..empty(x, y)
        });
    }
    let largest = |form: QForm, format: Format| {
        let own = study.footprints.iter().filter(|r| (r.form, r.format) == (form, format));
        let kept = own.filter(|r| r.scale == 1.0).map(|r| r.error);
        number(kept.fold(0.0, f64::max))
    };
    let message = format!(
        "Q of an ellipse with aspect up to 1e6 in f32: the conic is off by {}, the footprint by {}, the inverse by {}",
        largest(QForm::ALL[4], Format::Single),
        largest(QForm::ALL[0], Format::Single),
        largest(QForm::ALL[2], Format::Single)
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "Sampled over tilts and points. A line ends where the form leaves the type's range.".into(),
        columns: 2,
        charts,
    });
    Figure { stem: "stability-footprint", alt: format!("{message}."), chart }
}
