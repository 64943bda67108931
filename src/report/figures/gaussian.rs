//! cosⁿθ against the two Gaussians that stand for it.

use super::Figure;
use super::sample::{RANGE, curve, doublings, empty, enclosed, n_axis, over_n};
use crate::bound::{Gaussian, Interval, difference_supremum, gaussian_distance};
use crate::integral::Limit;
use crate::kernel::lobe::{cos_n_versine, gaussian, spherical_gaussian_versine, versine};
use crate::report::chart::{Axis, Chart, LineChart, Scale, Series, Style};
use core::f64::consts::FRAC_PI_2;

/// Suprema are enclosed to this part of 1/n, which they are proportional to.
const TOLERANCE: f64 = 1e-4;

/// The look of a Gaussian: its formula and its place in the palette.
fn look(kind: Gaussian) -> (&'static str, usize) {
    match kind {
        Gaussian::Angle => ("e^(−nθ²/2)", 0),
        Gaussian::Cosine => ("e^(−n(1 − cos θ))", 1),
    }
}

fn supremum(kind: Gaussian, n: f64) -> Interval {
    gaussian_distance(kind, Interval::from(n), TOLERANCE / n).value
}

/// Largest distances over n: the Gaussians', which fall as 1/n, and that of cs_16, which rises.
pub(super) fn distances() -> Figure {
    let mut series = Vec::new();
    for kind in Gaussian::ALL {
        let (formula, colour) = look(kind);
        let points: Vec<(f64, f64)> = doublings().map(|n| (n, supremum(kind, n).mid())).collect();
        // The guide goes through the last point: the law holds for large n.
        let slope = points.last().map_or(0.0, |&(n, value)| n * value);
        series.push(Series {
            colour: Some(colour),
            ..Series::new(format!("{slope:.3}/n"), Style::Dashed, over_n(|n| slope / n))
        });
        series.push(Series {
            colour: Some(colour),
            ..Series::new(format!("sup |cosⁿθ − {formula}|"), Style::Points, points)
        });
    }
    // At n = 16 cs_16 is cosⁿθ itself; 0 has no place on a logarithmic axis.
    let more = [17.0, 18.0, 20.0, 24.0].into_iter().chain(doublings().skip(1));
    let lobe: Vec<(f64, f64)> = more
        .map(|n| (n, difference_supremum(Limit::ExactZero, Interval::from(n), 1e-6).value.mid()))
        .collect();
    series.push(Series { colour: Some(2), ..Series::new("sup |cosⁿθ − cs_16|", Style::Points, lobe) });
    let chart = Chart::Line(LineChart {
        title: "Both Gaussians approach cosⁿθ as 1/n; cs_16 departs from it".into(),
        subtitle: "Points: largest distances over every θ, certified. At n = 16 cs_16 is cosⁿθ itself."
            .into(),
        series,
        ..empty(n_axis(), Axis::new("largest distance (1 = the lobe's peak)", Scale::Log10, (1e-4, 3e-2)))
    });
    let alt = "The largest distance of cosⁿθ from either Gaussian falls as 1/n, while that from cs_16 rises \
               from 0 at n = 16."
        .into();
    Figure { stem: "gaussians", alt, chart }
}

/// cosⁿθ less each Gaussian, at two n.
pub(super) fn curves() -> Figure {
    let mut series = Vec::new();
    for (n, style) in [(16.0, Style::Line), (128.0, Style::Dashed)] {
        for kind in Gaussian::ALL {
            let (formula, colour) = look(kind);
            let root = libm::sqrt(n);
            let value = |u: f64| {
                let w = versine(u / root);
                let bell = match kind {
                    Gaussian::Angle => gaussian(u / root, n),
                    Gaussian::Cosine => spherical_gaussian_versine(w, n),
                };
                cos_n_versine(w, n) - bell
            };
            // θ = π/2 at n = 16 ends the axis.
            let points = curve((0.0, 4.0 * FRAC_PI_2), 400, value);
            series.push(Series {
                colour: Some(colour),
                ..Series::new(format!("n = {n}: cosⁿθ − {formula}"), style, points)
            });
        }
    }
    let [angle, cosine] = Gaussian::ALL.map(|kind| enclosed(supremum(kind, RANGE.0)));
    let message = format!("Both Gaussians exceed cosⁿθ, at n = 16 by {angle} and {cosine}");
    let chart = Chart::Line(LineChart {
        title: message.clone(),
        subtitle:
            "The one in the angle is closer. Eight times the exponent, about an eighth of the difference."
                .into(),
        series,
        ..empty(
            Axis::new("scaled angle θ√n (rad)", Scale::Linear, (0.0, 4.0 * FRAC_PI_2)),
            Axis::new("cosⁿθ − Gaussian (1 = the lobe's peak)", Scale::Linear, (-0.0185, 0.0015)),
        )
    });
    Figure {
        stem: "gaussian-curves",
        alt: format!("{message} (in θ and in cos θ), and at n = 128 by about an eighth of that."),
        chart,
    }
}
