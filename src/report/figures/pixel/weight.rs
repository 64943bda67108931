//! The weights: over the distance from the centre, and of the texels of the paper's figure.

use crate::fit::{FIGURE_AXES, TexelWeight, WeightRow};
use crate::kernel::pixel::{PaperReading, PixelWeight};
use crate::report::chart::{Axis, Chart, HeatMap, LineChart, Mark, Panels, Scale, Series, Style};
use crate::report::figures::Figure;
use crate::report::figures::sample::{curve, empty, number};
use core::f64::consts::PI;

/// σ of L/6 in units of the semi-axis.
const SIGMA: f64 = 1.0 / 3.0;

/// A curve over r.
type Curve = Box<dyn Fn(f64) -> f64>;

/// Labels and weights.
fn drawn() -> [(&'static str, PixelWeight<f64>); 6] {
    [
        ("Gaussian, σ = L/6", PixelWeight::Gaussian(SIGMA)),
        ("R1: (1 − Q)⁸", PixelWeight::Paper(PaperReading::R1)),
        ("R2: (1 − 9Q/16)⁸", PixelWeight::Paper(PaperReading::R2)),
        ("R3: (1 − Q/2)⁸", PixelWeight::Paper(PaperReading::R3)),
        ("R4: (1 − Q/8)⁸", PixelWeight::Paper(PaperReading::R4)),
        ("cubic, K = 4", PixelWeight::Cubic(4, SIGMA)),
    ]
}

/// Weights over r = √Q, and what is between them and the Gaussian.
pub(super) fn bells(rows: &[WeightRow]) -> Figure {
    let axis = || Axis::new("r = √Q (1 on the ellipse)", Scale::Linear, (0.0, 1.2));
    let series = |(i, (label, f)): (usize, (&str, Curve))| {
        let (style, colour) = match i {
            0 => (Style::Dashed, 6),
            5 => (Style::Dotted, 0),
            _ => (Style::Line, i),
        };
        Series { colour: Some(colour), ..Series::new(label, style, curve((0.0, 1.2), 240, f)) }
    };
    let at = |weight: PixelWeight<f64>| move |r: f64| weight.at(r * r, 0.0);
    let gaussian = at(PixelWeight::Gaussian(SIGMA));
    let values = drawn().into_iter().map(|(label, weight)| (label, Box::new(at(weight)) as Curve));
    let off = drawn().into_iter().map(|(label, weight)| {
        let difference = move |r: f64| at(weight)(r) - gaussian(r);
        (label, Box::new(difference) as Curve)
    });
    let curves = LineChart {
        title: "weight".into(),
        series: values.enumerate().map(series).collect(),
        ..empty(axis(), Axis::new("weight", Scale::Linear, (0.0, 1.02)))
    };
    // Without the Gaussian itself, and without R4, whose error is seen above.
    let errors = LineChart {
        title: "weight less the Gaussian (R4 leaves the picture)".into(),
        series: off.enumerate().skip(1).map(series).collect(),
        ..empty(axis(), Axis::new("weight − e^(−9Q/2)", Scale::Linear, (-0.26, 0.06)))
    };
    let size = |name: &str| rows.iter().find(|row| row.name == name).map_or(f64::NAN, |row| row.plane.value);
    let message = format!(
        "No reading of (9) is both 0 on the ellipse and near the Gaussian: R1 is {} off, R2 {}",
        number(size("r1-sum")),
        number(size("r2-sum"))
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: format!(
            "Q = (2 u₁/L)² + (2 v₁/d)². A cubic bell at one operation more than the paper's is {} off.",
            number(size("cubic-4"))
        ),
        columns: 2,
        charts: vec![curves, errors],
    });
    Figure { stem: "pixel-bells", alt: format!("{message}."), chart }
}

/// Cells of a map across and up.
const TILE: (usize, usize) = (7, 5);
/// Maps in three columns and two rows, a cell between them and one for a title.
const SHEET: (usize, usize) = (3 * TILE.0 + 2, 2 * TILE.1 + 3);

/// The weights of the texels inside the paper's ellipse, a map a weight.
pub(super) fn texels(texels: &[TexelWeight]) -> Figure {
    let (columns, rows) = SHEET;
    let mut values = vec![f64::NAN; columns * rows];
    let (mut curves, mut labels) = (Vec::new(), Vec::new());
    let (mut across, mut up) = (Vec::new(), Vec::new());
    let frame = FIGURE_AXES.frame();
    for (i, (name, weight)) in drawn().into_iter().enumerate() {
        // The middle of the map's middle cell.
        let x = ((i % 3) * (TILE.0 + 1)) as f64 + 3.5;
        let y = ((1 - i / 3) * (TILE.1 + 2)) as f64 + 2.5;
        for texel in texels.iter().filter(|texel| texel.weight == weight) {
            let at = (x + f64::from(texel.u), y + f64::from(texel.v));
            values[at.1 as usize * columns + at.0 as usize] = texel.value;
            let text = if texel.value == 1.0 { "1".to_owned() } else { hundredths(texel.value) };
            labels.push(Mark { at, text });
        }
        labels.push(Mark { at: (x, y + 3.0), text: name.into() });
        let outline = |t: f64| {
            let (a, b) = (frame.major * libm::cos(t), frame.minor * libm::sin(t));
            (x + a * frame.cos - b * frame.sin, y + a * frame.sin + b * frame.cos)
        };
        let points = curve((0.0, 2.0 * PI), 120, |t| t).into_iter().map(|(t, _)| outline(t)).collect();
        curves.push(Series { colour: Some(6), ..Series::new("", Style::Line, points) });
        let tick = |k: i32, middle: f64| (middle + f64::from(k), k.to_string());
        if i < 3 {
            across.extend([-2, 0, 2].map(|u| tick(u, x)));
        }
        if i % 3 == 0 {
            up.extend([-1, 0, 1].map(|v| tick(v, y)));
        }
    }
    let axis = |label: &str, ticks: Vec<(f64, String)>, cells: usize| Axis {
        ticks,
        ..Axis::new(label, Scale::Linear, (0.0, cells as f64))
    };
    let message =
        "Texel weights in the ellipse of diagonals 6 and 3, tilted by 30°: the readings of (9) disagree";
    let chart = Chart::Heat(HeatMap {
        title: message.into(),
        subtitle:
            "Its centre is a texel's. Weights to two decimals, 1 in the middle; no value where the texel's centre lies \
                   outside."
                .into(),
        x: axis("u (texels)", across, columns),
        y: axis("v (texels)", up, rows),
        value_label: "weight".into(),
        value_range: (0.0, 1.0),
        columns,
        rows,
        values,
        diverging: false,
        curves,
        labels,
    });
    Figure { stem: "pixel-weights", alt: format!("{message}."), chart }
}

/// `.07`: the cells have no room for more.
fn hundredths(value: f64) -> String {
    format!("{value:.2}").trim_start_matches('0').to_owned()
}
