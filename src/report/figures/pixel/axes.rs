//! How far the paper's axes are from the ellipse's, over the angle between the derivative vectors.

use crate::kernel::pixel::Skew;
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};
use crate::report::figures::Figure;
use crate::report::figures::sample::empty;

/// Ratios ρ of the two vectors' lengths; the first, where the second vector is the longer, for the tilt only,
/// as the lengths' curves are those of 1/ρ.
const RATIOS: [f64; 5] = [2.0, 1.0, 0.75, 0.5, 0.25];

/// Panels of length, area and tilt.
pub(super) fn errors() -> Figure {
    // From 1° on: at 0° the ellipse is a line.
    let over = |ratio: f64, f: &dyn Fn(Skew<f64>) -> f64| -> Vec<(f64, f64)> {
        let at = |i: u32| f64::from(i) * 0.5;
        // At 90° equal vectors make a circle, which has no tilt.
        let degrees = (2..=180).map(at).filter(|d| ratio != 1.0 || *d < 90.0);
        degrees.map(|d| (d, f(Skew { angle: d.to_radians(), ratio }))).collect()
    };
    let skew = || Axis {
        ticks: [0, 15, 30, 45, 60, 75, 90].map(|d| (f64::from(d), format!("{d}°"))).into(),
        ..Axis::new("angle between the derivative vectors", Scale::Linear, (0.0, 90.0))
    };
    let panel = |title: &str, y: Axis, from: usize, f: &dyn Fn(Skew<f64>) -> f64| {
        let one = |(colour, ratio): (usize, &f64)| Series {
            colour: Some(colour),
            ..Series::new(format!("|second|/|first| = {ratio}"), Style::Line, over(*ratio, f))
        };
        LineChart {
            title: title.into(),
            series: RATIOS.iter().enumerate().skip(from).map(one).collect(),
            ..empty(skew(), y)
        }
    };
    let charts = vec![
        panel("major axis: true by the paper's", Axis::new("ratio", Scale::Linear, (0.98, 1.45)), 1, &|s| {
            s.major()
        }),
        panel("minor axis: true by the paper's", Axis::new("ratio", Scale::Linear, (0.0, 1.02)), 1, &|s| {
            s.minor()
        }),
        panel(
            "area: the paper's by the true, at any ratio",
            Axis::new("ratio", Scale::Log10, (0.9, 60.0)),
            1,
            &|s| s.area(),
        ),
        panel(
            "tilt: true less the first vector's",
            Axis::new("angle (°)", Scale::Linear, (0.0, 92.0)),
            0,
            &|s| s.tilt().to_degrees(),
        ),
    ];
    let message = "The paper's major axis is up to √2 too short, its minor axis too long without bound";
    let chart = Chart::Panels(Panels {
        title: message.into(),
        subtitle:
            "It takes the two derivative vectors for the semi-axes, which they are at right angles only; \
                   beyond 90° the lengths repeat and the tilt changes its sign."
                .into(),
        columns: 2,
        charts,
    });
    Figure { stem: "pixel-axes", alt: format!("{message}."), chart }
}
