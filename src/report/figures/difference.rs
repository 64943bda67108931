//! Δ(n, θ) = cosⁿθ − cs_16, the error of the paper's lobe.

use super::cut::CUTS;
use super::sample::{RANGE, curve, empty, enclosed, n_axis, over_n};
use super::{Figure, FigureError};
use crate::bound::{DifferenceExtreme, Interval, difference_infimum, difference_supremum, enclose};
use crate::integral::Limit;
use crate::kernel::lobe::{cos_n_versine, cs_16_cut, cs_versine, cut_card, versine};
use crate::paper::{ClaimsFile, Kind, LOBE_PAPER, Printed, Statistic};
use crate::report::chart::{Axis, Band, Chart, HeatMap, LineChart, Mark, Scale, Series, Style};
use core::f64::consts::FRAC_PI_2;

/// Exponents drawn from the papers' range.
const EXPONENTS: [f64; 7] = [16.0, 17.0, 20.0, 32.0, 64.0, 256.0, 1024.0];
/// One below it.
const BELOW: f64 = 10.0;
/// The end of the axis across: the exact cut at n = 16, in θ√n.
const REACH: f64 = 4.0 * FRAC_PI_2;
const STEPS: u32 = 500;
/// Extremes are enclosed to this: three digits are shown.
const TOLERANCE: f64 = 1e-6;

/// Δ with the exact zero as the cut; θ in radians.
fn difference(n: f64, theta: f64) -> f64 {
    let w = versine(theta);
    cos_n_versine(w, n) - cs_versine::<16, f64>(w, n)
}

/// A curve over θ in units of 1/√n.
fn scaled(n: f64, theta: (f64, f64), f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    curve(theta, STEPS, f).into_iter().map(|(x, y)| (x * libm::sqrt(n), y)).collect()
}

/// The extremes of Δ as the paper prints them.
fn printed() -> Result<Vec<(Statistic, Printed)>, FigureError> {
    let file = ClaimsFile::parse(LOBE_PAPER)?;
    let readings = file.claims.into_iter().flat_map(|claim| claim.readings);
    let stated = readings.filter_map(|reading| match reading.kind {
        Kind::LobeDifference { statistic, printed, .. } => Some((statistic, printed)),
        _ => None,
    });
    Ok(stated.collect())
}

fn first(all: &[(Statistic, Printed)], wanted: Statistic) -> Option<(f64, &str)> {
    let (_, found) = all.iter().find(|(statistic, _)| *statistic == wanted)?;
    Some((enclose(&found.value).mid(), &found.text))
}

/// sup Δ over the papers' range, every real n and every θ.
pub(super) fn highest() -> DifferenceExtreme {
    difference_supremum(Limit::ExactZero, Interval::new(RANGE.0, RANGE.1), TOLERANCE)
}

/// Δ over θ√n for several n, with the printed extremes.
pub(super) fn curves(highest: &DifferenceExtreme) -> Result<Figure, FigureError> {
    let last = RANGE.1;
    let end = |n: f64| (REACH / libm::sqrt(n)).min(FRAC_PI_2);
    let mut series = Vec::new();
    for (i, n) in EXPONENTS.into_iter().enumerate() {
        let points = scaled(n, (0.0, end(n)), |theta| difference(n, theta));
        series.push(Series { colour: Some(i), ..Series::new(format!("n = {n}"), Style::Line, points) });
    }
    // Both sides of the jump are sampled, so that it is drawn upright.
    let cut = cut_card(last);
    let cut_off = |theta: f64| cos_n_versine(versine(theta), last) - cs_16_cut(theta, last, cut);
    let mut jump = scaled(last, (0.0, cut), cut_off);
    jump.extend(scaled(last, (cut.next_up(), end(last)), cut_off));
    series.push(Series {
        colour: Some(EXPONENTS.len() - 1),
        ..Series::new(format!("n = {last}, cut √(6/n)"), Style::Dotted, jump)
    });
    let below = scaled(BELOW, (0.0, end(BELOW)), |theta| difference(BELOW, theta));
    series.push(Series { colour: Some(7), ..Series::new(format!("n = {BELOW}"), Style::Dashed, below) });

    let lowest = difference_infimum(BELOW, TOLERANCE);
    let jumps = difference_supremum(Limit::Card, Interval::from(last), TOLERANCE);
    let marks = vec![
        Mark {
            at: (highest.theta() * libm::sqrt(highest.n), highest.value.mid()),
            text: format!("max {} at n = {}", enclosed(highest.value), highest.n),
        },
        Mark {
            at: (lowest.theta() * libm::sqrt(BELOW), lowest.value.mid()),
            text: format!("min {} at n = {BELOW}, below the paper's range", enclosed(lowest.value)),
        },
    ];
    let stated = printed()?;
    let (min, max) = (first(&stated, Statistic::Min), first(&stated, Statistic::Max));
    let bands = match (min, max) {
        (Some((lo, least)), Some((hi, most))) => {
            vec![Band { label: format!("printed: {least} to {most}"), lo, hi }]
        }
        _ => vec![],
    };
    let least = min.map_or(String::new(), |(_, text)| format!(" {text}"));
    let chart = Chart::Line(LineChart {
        title: format!("Δ ≥ 0 from n = 16 on: the printed minimum{least} does not occur"),
        subtitle: format!(
            "Δ = cosⁿθ − cs_16 is 0 at n = 16 for every θ, and negative only below. Cut at √(6/n) instead of \
             the exact zero it jumps, to {} at n = {last}: dotted, beyond the axis.",
            enclosed(jumps.value)
        ),
        bands,
        series,
        marks,
        ..empty(
            Axis::new("scaled angle θ√n (rad)", Scale::Linear, (0.0, REACH)),
            Axis::new("Δ(n, θ) (1 = the lobe's peak)", Scale::Linear, (-0.0125, 0.02)),
        )
    });
    let alt = format!(
        "For n = 16 to 1024 the difference cosⁿθ − cs_16 lies between 0 and {}, and reaches the printed \
         minimum{least} only below n = 16.",
        enclosed(highest.value)
    );
    Ok(Figure { stem: "difference-curves", alt, chart })
}

/// Cells of the map.
const CELLS: (usize, usize) = (240, 300);
/// The paper's axis: 20 θ.
const AXIS: f64 = 20.0;

/// Δ over n and 20 θ, as the paper draws it.
pub(super) fn map(highest: &DifferenceExtreme) -> Result<Figure, FigureError> {
    let x = n_axis();
    let y = Axis::new("20 θ (θ in rad), the paper's axis", Scale::Linear, (0.0, 30.0));
    let (columns, rows) = CELLS;
    let exponents = x.centres(columns)?;
    let mut values = Vec::with_capacity(columns * rows);
    for theta in y.centres(rows)? {
        values.extend(exponents.iter().map(|&n| difference(n, theta / AXIS)));
    }
    let message =
        format!("Nowhere negative, Δ rises along θ ≈ 2/√n to {} at n = 1024", enclosed(highest.value));
    let chart = Chart::Heat(HeatMap {
        title: message,
        subtitle: "Red: cosⁿθ above cs_16; blue, the reverse, does not occur. Lines: the three cuts.".into(),
        value_label: "Δ = cosⁿθ − cs_16 (1 = the lobe's peak)".into(),
        value_range: (-0.0175, 0.0175),
        x,
        y,
        columns,
        rows,
        values,
        diverging: true,
        curves: CUTS.map(|cut| cut.series(cut.label, over_n(|n| AXIS * (cut.angle)(n)))).into(),
        labels: vec![],
    });
    let alt = format!(
        "Over n and θ the difference cosⁿθ − cs_16 is nowhere negative, and largest, {}, at n = 1024 near \
         θ = 2/√n.",
        enclosed(highest.value)
    );
    Ok(Figure { stem: "difference-map", alt, chart })
}
