//! The volume of a pixel beyond a line: exact, as printed, and refitted.

use crate::fit::clip::{ClipObjective, ClipPixel, ClipRow, ClipTarget, clip_printed};
use crate::report::chart::{Axis, Chart, LineChart, Mark, Panels, Scale, Series, Style};
use crate::report::figures::Figure;
use crate::report::figures::sample::{curve, empty, number};

/// The polynomials that are drawn against σ = 1/6: label, objective, degree, constant fixed, colour.
const REFITS: [(&str, ClipObjective, u32, bool, usize); 2] = [
    ("quadratic, minimax", ClipObjective::Minimax, 2, false, 2),
    ("cubic, falling to 0", ClipObjective::Falling, 3, true, 0),
];

fn polynomial([a, b, c, e]: [f64; 4]) -> impl Fn(f64) -> f64 {
    move |d| a + d * (b + d * (c + d * e))
}

/// Curves above their errors against σ = 1/6 and σ = 1/5.
pub(super) fn volumes(rows: &[ClipRow]) -> Figure {
    let printed = clip_printed();
    // Where P' = 0.
    let lowest = -printed[1] / (2.0 * printed[2]);
    let exact = |s: f64| {
        let pixel = ClipPixel::new(ClipTarget::Gaussian(s));
        move |d: f64| pixel.volume(d)
    };
    let series = |label: &str, style: Style, colour: usize, points: Vec<(f64, f64)>| Series {
        colour: Some(colour),
        ..Series::new(label, style, points)
    };
    let of = |objective: ClipObjective, degree: u32, half: bool| {
        let is = |row: &&ClipRow| {
            row.target == ClipTarget::Gaussian(6.0)
                && row.objective == objective
                && row.degree == degree
                && row.half == Some(half)
        };
        rows.iter().find(is)
    };
    let range = (0.0, 0.5);
    let steps = 250;
    let d_axis = || Axis::new("distance d (pixel diameters)", Scale::Linear, range);
    let mut drawn = vec![
        series("exact, σ = 1/6", Style::Dashed, 6, curve(range, steps, exact(6.0))),
        series("exact, σ = 1/5", Style::Dotted, 6, curve(range, steps, exact(5.0))),
        series("P as printed", Style::Line, 1, curve(range, steps, polynomial(printed))),
    ];
    let mut errors = vec![
        series(
            "P as printed",
            Style::Line,
            1,
            curve(range, steps, |d| polynomial(printed)(d) - exact(6.0)(d)),
        ),
        series(
            "P as printed against σ = 1/5",
            Style::Dashed,
            1,
            curve(range, steps, |d| polynomial(printed)(d) - exact(5.0)(d)),
        ),
    ];
    for (label, objective, degree, half, colour) in REFITS {
        let Some(row) = of(objective, degree, half) else { continue };
        let refit = polynomial(row.coefficients);
        errors.push(series(label, Style::Line, colour, curve(range, steps, |d| refit(d) - exact(6.0)(d))));
        drawn.push(series(label, Style::Line, colour, curve(range, steps, refit)));
    }
    let whole = LineChart {
        title: "volume beyond the line".into(),
        series: drawn.clone(),
        ..empty(d_axis(), Axis::new("volume", Scale::Linear, (-0.02, 0.52)))
    };
    let end = LineChart {
        title: format!("near the base: P rises from d = {lowest:.3} on"),
        marks: vec![
            Mark { at: (lowest, polynomial(printed)(lowest)), text: number(polynomial(printed)(lowest)) },
            Mark { at: (0.5, polynomial(printed)(0.5)), text: number(polynomial(printed)(0.5)) },
        ],
        series: drawn,
        ..empty(
            Axis::new("distance d (pixel diameters)", Scale::Linear, (0.36, 0.51)),
            Axis::new("volume", Scale::Linear, (-0.01, 0.06)),
        )
    };
    let error = LineChart {
        title: "error, against σ = 1/6 unless said".into(),
        series: errors,
        ..empty(d_axis(), Axis::new("polynomial − exact", Scale::Linear, (-0.025, 0.055)))
    };
    let size = |target: ClipTarget| {
        let is = |row: &&ClipRow| row.target == target && row.objective == ClipObjective::Printed;
        rows.iter().find(is).map_or(f64::NAN, |row| row.error)
    };
    let message = format!(
        "The printed P is the volume of the pixel with σ = 1/5, to {}; from the paper's σ = 1/6 it is {} off",
        number(size(ClipTarget::Gaussian(5.0))),
        number(size(ClipTarget::Gaussian(6.0))),
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "P(d) = 0.5 − d (2.151 − 2.358 d), pixel of base diameter 1. The refits are for σ = 1/6."
            .into(),
        columns: 3,
        charts: vec![whole, end, error],
    });
    Figure { stem: "clip-volume", alt: format!("{message}."), chart }
}
