//! Where cs_16 is cut: the exact zero and the two readings of its approximation.

use super::Figure;
use super::sample::{RANGE, empty, n_axis, over_n};
use crate::bound::cut_numerator;
use crate::kernel::lobe::{cut_card, cut_exact, cut_paper};
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};

/// A cut: its name, its angle in radians at n, and its look, the same in every figure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) label: &'static str,
    pub(super) angle: fn(f64) -> f64,
    style: Style,
    colour: usize,
}

/// The exact zero and both readings of the approximation.
pub(super) const CUTS: [Cut; 3] = [
    Cut { label: "exact zero", angle: cut_exact::<f64>, style: Style::Line, colour: 0 },
    Cut { label: "6/√n", angle: cut_paper::<f64>, style: Style::Dashed, colour: 1 },
    Cut { label: "√(6/n)", angle: cut_card::<f64>, style: Style::Dotted, colour: 2 },
];

impl Cut {
    /// Points in the cut's look.
    pub(super) fn series(&self, label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { colour: Some(self.colour), ..Series::new(label, self.style, points) }
    }
}

/// The three cuts over n, in radians and times √n.
pub(super) fn cuts() -> Figure {
    // √n cr falls in n, so the ends of the range are its extremes.
    let off = |n: f64| 6.0 / cut_numerator(n).mid() - 1.0;
    let worst = 100.0 * off(RANGE.0).abs().max(off(RANGE.1).abs());
    let short = |n: f64| 100.0 * (1.0 - cut_card(n) / cut_exact(n));
    let message = format!(
        "6/√n misses the zero of cs_16 by up to {worst:.1} %, √(6/n) by {:.0} to {:.0} %",
        short(RANGE.1),
        short(RANGE.0)
    );
    let panel = |y: Axis, scaled: bool| {
        let series = CUTS.map(|cut| {
            let value = |n: f64| (cut.angle)(n) * if scaled { libm::sqrt(n) } else { 1.0 };
            cut.series(cut.label, over_n(value))
        });
        LineChart { series: series.into(), ..empty(n_axis(), y) }
    };
    let angle = LineChart {
        title: "the cut".into(),
        ..panel(Axis::new("angle cr of the cut (rad)", Scale::Log10, (0.07, 1.7)), false)
    };
    let scaled = LineChart {
        title: "the cut times √n".into(),
        ..panel(Axis::new("√n · cr (rad)", Scale::Linear, (2.0, 6.6)), true)
    };
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "The zero is arccos(1 − 16/n), which falls from 2π/√n at n = 16 to √32/√n for large n."
            .into(),
        columns: 2,
        charts: vec![angle, scaled],
    });
    Figure { stem: "cuts", alt: format!("Over n = 16 to 1024, {message}."), chart }
}
