//! Ellipses with the paper's laid over them, and tilts round the circle.

use crate::kernel::pixel::{Axes, Frame, Jacobian, Padding, Skew, TiltFormula};
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};
use crate::report::figures::Figure;
use crate::report::figures::sample::{curve, empty};
use core::f64::consts::PI;

/// Skews and ratios that are drawn.
const DRAWN: [(f64, f64); 2] = [(60.0, 0.75), (30.0, 0.75)];
/// Half the axes' lengths, so that circles are round.
const EXTENT: (f64, f64) = (1.6, 1.072);

fn ellipse(frame: &Frame<f64>) -> Vec<(f64, f64)> {
    let at = |t: f64| {
        let (a, b) = (frame.major * libm::cos(t), frame.minor * libm::sin(t));
        (a * frame.cos - b * frame.sin, a * frame.sin + b * frame.cos)
    };
    curve((0.0, 2.0 * PI), 240, |t| t).into_iter().map(|(t, _)| at(t)).collect()
}

/// The ellipse of two skewed vectors, those vectors, its own axes, and the paper's ellipse.
pub(super) fn ellipses() -> Figure {
    let panel = |(degrees, ratio): (f64, f64)| {
        let skew = Skew { angle: f64::to_radians(degrees), ratio };
        let j = skew.jacobian();
        let (axes, paper) = (Axes::of(j, Padding::Plain), Axes::paper(j, TiltFormula::Vector));
        let frame = axes.frame();
        let line = |x: f64, y: f64| vec![(-x, -y), (x, y)];
        let series = |label: &str, style: Style, colour: usize, points: Vec<(f64, f64)>| Series {
            colour: Some(colour),
            ..Series::new(label, style, points)
        };
        let (cos, sin) = (frame.cos, frame.sin);
        LineChart {
            title: format!(
                "{degrees}° apart: paper's area {:.2} times the true, tilt {:.1}° off",
                skew.area(),
                skew.tilt().to_degrees()
            ),
            series: vec![
                series("the paper's ellipse", Style::Dashed, 1, ellipse(&paper.frame())),
                series("the pixel's image", Style::Line, 0, ellipse(&frame)),
                series("its axes", Style::Dotted, 0, line(axes.major * cos, axes.major * sin)),
                series("its axes", Style::Dotted, 0, line(-axes.minor * sin, axes.minor * cos)),
                series("derivative vectors: conjugate diameters", Style::Line, 6, line(j.ux, j.vx)),
                series("derivative vectors: conjugate diameters", Style::Line, 6, line(j.uy, j.vy)),
            ],
            ..empty(
                Axis::new("U (texels)", Scale::Linear, (-EXTENT.0, EXTENT.0)),
                Axis::new("V (texels)", Scale::Linear, (-EXTENT.1, EXTENT.1)),
            )
        }
    };
    let message = "Skewed derivative vectors are conjugate diameters of the pixel's image, not its axes";
    let chart = Chart::Panels(Panels {
        title: message.into(),
        subtitle:
            "The second vector is 0.75 of the first. The paper's ellipse has the vectors' lengths for axes, \
                   at right angles."
                .into(),
        columns: 2,
        charts: DRAWN.map(panel).into(),
    });
    Figure { stem: "pixel-ellipses", alt: format!("{message}."), chart }
}

/// Each formula's answer against the true tilt, turned through all octants.
pub(super) fn tilts() -> Figure {
    let panel = |degrees: f64| {
        let skew = Skew { angle: f64::to_radians(degrees), ratio: 0.75 };
        let base = skew.jacobian();
        let turned = |by: f64| {
            let (c, s) = (libm::cos(by), libm::sin(by));
            let turn = |u: f64, v: f64| (c * u - s * v, s * u + c * v);
            let ((ux, vx), (uy, vy)) = (turn(base.ux, base.vx), turn(base.uy, base.vy));
            Jacobian { ux, vx, uy, vy }
        };
        // The first vector so that the true tilt is what the axis says.
        let answers = |formula: TiltFormula| -> Vec<(f64, f64)> {
            let at = |i: u32| 0.5 * f64::from(i) + 0.25;
            let answer =
                |true_tilt: f64| formula.angle(turned(true_tilt.to_radians() - skew.tilt())).to_degrees();
            split((0..720).map(at).map(|t| (t, answer(t))).collect())
        };
        let series = |label: &str, style: Style, colour: usize, points: Vec<(f64, f64)>| Series {
            colour: Some(colour),
            ..Series::new(label, style, points)
        };
        let sought = |i: u32| {
            let t = 0.5 * f64::from(i) + 0.25;
            (t, t - 180.0 * libm::round(t / 180.0))
        };
        // A line every octant, a label every second.
        let degrees_axis = |label: &str, range: (f64, f64)| Axis {
            ticks: (-8..=8)
                .map(|k: i32| {
                    let text = if k % 2 == 0 { format!("{}°", 45 * k) } else { String::new() };
                    (f64::from(45 * k), text)
                })
                .collect(),
            ..Axis::new(label, Scale::Linear, range)
        };
        LineChart {
            title: format!("vectors {degrees}° apart"),
            series: vec![
                series("true, modulo 180°", Style::Line, 7, split((0..720).map(sought).collect())),
                series("arctan(Vx/Ux)", Style::Dashed, 1, answers(TiltFormula::Vector)),
                series("½ arctan(B/(A − C))", Style::Dotted, 0, answers(TiltFormula::Conic)),
            ],
            ..empty(
                degrees_axis("true tilt of the major axis", (0.0, 360.0)),
                degrees_axis("the formula's answer", (-95.0, 95.0)),
            )
        }
    };
    let message = "½ arctan(B/(A − C)) is right in half of the octants and 90° off in the others";
    let chart = Chart::Panels(Panels {
        title: message.into(),
        subtitle:
            "arctan(Vx/Ux) is off by the same angle everywhere, by nothing where the vectors are at right \
                   angles. Second vector 0.75 of the first."
                .into(),
        columns: 2,
        charts: [90.0, 60.0].map(panel).into(),
    });
    Figure { stem: "pixel-tilts", alt: format!("{message}."), chart }
}

/// With a gap where the answer jumps.
fn split(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut parts: Vec<(f64, f64)> = Vec::new();
    for point in points {
        if parts.last().is_some_and(|last| (last.1 - point.1).abs() > 45.0) {
            parts.push((point.0, f64::NAN));
        }
        parts.push(point);
    }
    parts
}
