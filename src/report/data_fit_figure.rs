//! The plot of fitted lobes: samples with curves, and residuals.

use super::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};
use super::data_fit::exponent;
use crate::fit::measured::{Comparison, Estimate, Family, Sample, Samples};
use crate::kernel::lobe::versine;

/// Points drawn at most; of more, every so many-th.
const POINTS: usize = 1000;
/// Steps of a curve.
const STEPS: u32 = 600;
/// Parts of the angles over which residuals are averaged.
const BINS: usize = 48;
/// Curves drawn at most: the palette's colours less the samples' grey.
const CURVES: usize = 7;
const GREY: usize = 7;

/// Samples with the fitted lobes above, and what is left of the samples below: the best family's residuals one by
/// one, every family's averaged over 1/48 of the angles.
///
/// Of more than seven families the best of each kind is drawn, of more than 1000 samples every so many-th in the
/// order of their angles.
pub fn data_fit_figure(samples: &Samples, found: &Comparison) -> Chart {
    let mut sorted: Vec<&Sample> = samples.all().iter().filter(|sample| sample.weight > 0.0).collect();
    sorted.sort_by(|a, b| a.theta_deg.total_cmp(&b.theta_deg).then(a.row.cmp(&b.row)));
    let every = sorted.len().div_ceil(POINTS);
    let shown: Vec<&Sample> = sorted.iter().step_by(every).copied().collect();
    let end = sorted.iter().map(|sample| sample.theta_deg).fold(0.0, f64::max);
    let families = drawn(found);
    let best = found.best();

    let points = |of: &dyn Fn(&Sample) -> f64| shown.iter().map(|s| (s.theta_deg, of(s))).collect();
    let dots =
        |label: String, points| Series { colour: Some(GREY), ..Series::new(label, Style::Points, points) };
    let label = if every == 1 { "samples".to_owned() } else { format!("samples, every {}", ordinal(every)) };
    let curve = |estimate: &Estimate| {
        let at = |i: u32| end * f64::from(i) / f64::from(STEPS);
        let value = |degrees: f64| estimate.at(versine(degrees.to_radians()).min(1.0));
        (0..=STEPS).map(at).map(|degrees| (degrees, value(degrees))).collect()
    };
    let line = |(i, estimate): (usize, &&Estimate), points| {
        let style = [Style::Line, Style::Dashed, Style::Dotted][i % 3];
        Series { colour: Some(i), ..Series::new(estimate.family.id(), style, points) }
    };
    let mut above = vec![dots(label, points(&|s| s.value))];
    above.extend(families.iter().enumerate().map(|(i, e)| line((i, e), curve(e))));
    let left = |e: &Estimate, s: &Sample| s.value - e.at(s.versine);
    // The panel's title names them; the legend has their grey once.
    let mut below = vec![dots(String::new(), points(&|s| left(best, s)))];
    below.extend(families.iter().enumerate().map(|(i, e)| line((i, e), means(&sorted, end, |s| left(e, s)))));

    let [n, lo, hi] = exponent(best);
    let n = if lo.is_empty() { n } else { format!("{n} ({lo} to {hi})") };
    let angles = || Axis::new("angle from the lobe's axis θ (degrees)", Scale::Linear, (0.0, end));
    let chart = |title: &str, y: &str, series: Vec<Series>| LineChart {
        title: title.into(),
        subtitle: String::new(),
        x: angles(),
        y: Axis::new(y, Scale::Linear, range(&series)),
        bands: vec![],
        series,
        marks: vec![],
    };
    Chart::Panels(Panels {
        title: format!("{} comes nearest to {} samples: n = {n}", best.family, found.counted),
        subtitle:
            "Fitted by least squares. Where a line of residuals leaves 0 for long, the family has another \
                   shape than the samples."
                .into(),
        columns: 1,
        charts: vec![
            chart("Samples and fitted lobes", "value (the samples' unit)", above),
            chart(
                &format!("Residuals: dots of {}, lines averaged over 1/{BINS} of the angles", best.family),
                "sample − lobe (the samples' unit)",
                below,
            ),
        ],
    })
}

/// All families, or the best of each kind, from the best on.
fn drawn(found: &Comparison) -> Vec<&Estimate> {
    if found.estimates.len() <= CURVES {
        return found.estimates.iter().collect();
    }
    let mut kinds = Vec::new();
    let mut first_of_kind = |estimate: &&Estimate| {
        let kind = kind(estimate.family);
        let is_new = !kinds.contains(&kind);
        if is_new {
            kinds.push(kind);
        }
        is_new
    };
    found.estimates.iter().filter(|estimate| first_of_kind(estimate)).collect()
}

/// One of seven.
fn kind(family: Family) -> &'static str {
    match family {
        Family::CosN => "cos",
        Family::Cs16 => "cs",
        Family::Linear2 | Family::Linear4 | Family::Linear8 | Family::Linear32 => "linear",
        Family::Cubic2 | Family::Cubic4 | Family::Cubic8 => "cubic",
        Family::SphericalGaussian => "gaussian",
        Family::Schlick => "schlick",
        Family::Free2 | Family::Free4 | Family::Free8 => "free",
    }
}

/// The weighted mean over each part of the angles that has samples, at their mean angle.
fn means(sorted: &[&Sample], end: f64, of: impl Fn(&Sample) -> f64) -> Vec<(f64, f64)> {
    let mut bins = [(0.0, 0.0, 0.0); BINS];
    for sample in sorted {
        let bin = &mut bins[((sample.theta_deg / end * BINS as f64) as usize).min(BINS - 1)];
        let q = sample.weight;
        *bin = (bin.0 + q, bin.1 + q * sample.theta_deg, bin.2 + q * of(sample));
    }
    bins.iter().filter(|bin| bin.0 > 0.0).map(|bin| (bin.1 / bin.0, bin.2 / bin.0)).collect()
}

/// From the least to the most of what is drawn, with room.
fn range(series: &[Series]) -> (f64, f64) {
    let values = series.iter().flat_map(|s| s.points.iter().map(|point| point.1));
    let (lo, hi) = values.fold((0.0_f64, 0.0_f64), |(lo, hi), v| (lo.min(v), hi.max(v)));
    // Residuals that are all 0 still need an axis.
    let room = if hi > lo { 0.05 * (hi - lo) } else { 1.0 };
    (lo - room, hi + room)
}

/// 2nd, 3rd, 4th, …
fn ordinal(n: usize) -> String {
    let ending = match (n % 10, n % 100) {
        (1, tens) if tens != 11 => "st",
        (2, tens) if tens != 12 => "nd",
        (3, tens) if tens != 13 => "rd",
        _ => "th",
    };
    format!("{n}{ending}")
}
