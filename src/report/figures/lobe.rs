//! cosⁿθ and the paper's lobe at one n.

use super::Figure;
use super::cut::CUTS;
use super::sample::{curve, empty, enclosed};
use crate::bound::{Interval, difference_supremum};
use crate::integral::Limit;
use crate::kernel::lobe::{cos_n, cs_16, cs_16_cut, cut_card, cut_exact, cut_paper};
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};

/// The exponent that the paper draws.
const N: f64 = 128.0;
/// In radians.
const REACH: (f64, f64) = (0.0, 0.8);
const STEPS: u32 = 400;

/// cos¹²⁸θ and cs_16 with the three cuts, on a linear scale as the paper has it, and on a logarithmic
/// one, where the cuts are seen.
pub(super) fn lobes() -> Figure {
    let sup = difference_supremum(Limit::ExactZero, Interval::from(N), 1e-6).value;
    let (zero, paper) = (cut_exact(N), cut_paper(N));
    let panel = |y: Axis| {
        let cuts = CUTS.map(|cut| {
            let angle = (cut.angle)(N);
            let label = format!("{}: {angle:.3} rad", cut.label);
            cut.series(label, vec![(angle, y.range.0), (angle, y.range.1)])
        });
        let lobes = [
            Series {
                colour: Some(5),
                ..Series::new("cos¹²⁸θ", Style::Line, curve(REACH, STEPS, |t| cos_n(libm::cos(t), N)))
            },
            Series {
                colour: Some(6),
                ..Series::new("cs_16", Style::Dashed, curve(REACH, STEPS, |t| cs_16(libm::cos(t), N)))
            },
        ];
        let series = cuts.into_iter().chain(lobes).collect();
        LineChart { series, ..empty(Axis::new("angle θ (rad)", Scale::Linear, REACH), y) }
    };
    let linear = LineChart {
        title: "linear, as the paper draws it".into(),
        ..panel(Axis::new("lobe (1 at θ = 0)", Scale::Linear, (0.0, 1.0)))
    };
    let mut logarithmic = LineChart {
        title: "logarithmic".into(),
        ..panel(Axis::new("lobe (1 at θ = 0)", Scale::Log10, (1e-18, 1.0)))
    };
    logarithmic.series.push(Series {
        colour: Some(3),
        ..Series::new(
            "what the cut at 6/√n lets through",
            Style::Line,
            curve((zero, paper), 60, |t| cs_16_cut(t, N, paper)),
        )
    });
    let message = format!("cs_16 misses cos¹²⁸θ by up to {}, and ends at {zero:.3} rad", enclosed(sup));
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: format!(
            "The cut at 6/√n lets up to {:.0e} through; the one at √(6/n) cuts where cs_16 is {:.3}.",
            cs_16_cut(paper, N, paper),
            cs_16(libm::cos(cut_card(N)), N)
        ),
        columns: 2,
        charts: vec![linear, logarithmic],
    });
    Figure { stem: "lobes-128", alt: format!("At n = 128 {message}."), chart }
}
