//! The better bells beside the papers': error against operations, against n, and along the lobe.

use super::Figure;
use super::sample::{curve, empty, number};
use crate::fit::bell::{CosineBell, ExponentialBell, Shape};
use crate::kernel::cubic::{CubicLobe, cubic_bell};
use crate::kernel::lobe::{cos_n_versine, cs_versine};
use crate::report::chart::{Axis, Chart, LineChart, Mark, Panels, Scale, Series, Style};

/// Certified error against operations, from t for e⁻ᵗ and from cos θ for cosⁿ.
pub(super) fn frontier(exponential: &[ExponentialBell], cosine: &[CosineBell]) -> Figure {
    let of_exponential = |keep: &dyn Fn(&ExponentialBell) -> bool| -> Vec<(f64, f64)> {
        let kept = exponential.iter().filter(|row| keep(row));
        kept.map(|row| (f64::from(row.cost.from_t), row.error.value.hi())).collect()
    };
    let shape = |shape: Shape| of_exponential(&|row| row.shape == shape && !row.printed);
    let points = |label: &str, colour: usize, points: Vec<(f64, f64)>| Series {
        colour: Some(colour),
        ..Series::new(label, Style::Points, points)
    };
    let joined = |label: &str, colour: usize, points: Vec<(f64, f64)>| Series {
        colour: Some(colour),
        ..Series::new(label, Style::Line, points)
    };
    let operations = |label: &str| Axis {
        ticks: (3..=9).map(|k| (f64::from(k), k.to_string())).collect(),
        ..Axis::new(label, Scale::Linear, (2.6, 9.4))
    };
    let error = |label: &str| Axis::new(label, Scale::Log10, (3e-7, 2e-1));
    let mark = |points: &[(f64, f64)]| -> Vec<Mark> {
        points.iter().map(|&at| Mark { at, text: number(at.1) }).collect()
    };
    let cubic = shape(Shape::Cubic);
    let from_t = LineChart {
        title: "e^(−t), counted from t".into(),
        marks: mark(&cubic),
        series: vec![
            points("the papers': (1 − t/K)^K", 3, of_exponential(&|row| row.printed)),
            joined("the same, rescaled", 2, shape(Shape::Linear)),
            joined("degree 3", 0, cubic),
        ],
        ..empty(operations("operations from t"), error("largest error, proved"))
    };
    let of_cosine = |keep: &dyn Fn(&CosineBell) -> bool, count: fn(&CosineBell) -> u32| -> Vec<(f64, f64)> {
        let kept = cosine.iter().filter(|row| keep(row));
        kept.map(|row| (f64::from(count(row)), row.error.value.hi())).collect()
    };
    let from_cos = |row: &CosineBell| row.cost.from_cos;
    let is_cubic = |row: &CosineBell| row.shape == Shape::Cubic;
    let is_rescaled = |row: &CosineBell| row.shape == Shape::Linear && !row.printed;
    let by_difference = of_cosine(&is_cubic, |row| row.cost.from_t);
    let cubic = of_cosine(&is_cubic, from_cos);
    let cosines = LineChart {
        title: "cosⁿθ for every n ≥ 16, counted from cos θ".into(),
        marks: mark(&cubic),
        series: vec![
            points("the papers': cs_16", 3, of_cosine(&|row| row.printed, from_cos)),
            joined("the same, rescaled", 2, of_cosine(&is_rescaled, from_cos)),
            joined("degree 3, counted from 1 − cos θ", 4, by_difference),
            joined("degree 3, counted from cos θ", 0, cubic),
        ],
        ..empty(operations("operations from cos θ"), error("largest error, proved"))
    };
    let at_six = |points: &[(f64, f64)]| points.iter().find(|p| p.0 == 6.0).map_or(f64::NAN, |p| p.1);
    let (paper, ours) =
        (at_six(&cosines.series[0].points), at_six(&cosines.series[cosines.series.len() - 1].points));
    let message = format!(
        "At the papers' own six operations a cubic bell misses cosⁿ by {}, and cs_16 by {}",
        number(ours),
        number(paper)
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "Multiply, add, fused multiply-add and maximum count one each; what depends on n alone is \
                   computed once."
            .into(),
        columns: 2,
        charts: vec![from_t, cosines],
    });
    Figure { stem: "kernels", alt: format!("{message}."), chart }
}

/// A lobe of w = 1 - cos θ at one n.
type LobeAt = fn(f64, f64) -> f64;

const LOBES: [(&str, LobeAt); 4] = [
    ("cs_16, 6 operations", |w, n| cs_versine::<16, f64>(w, n)),
    ("cubic, K = 2, 5 operations", |w, n| CubicLobe::<2, f64>::new(n).at_versine(w)),
    ("cubic, K = 4, 6 operations", |w, n| CubicLobe::<4, f64>::new(n).at_versine(w)),
    ("cubic, K = 8, 7 operations", |w, n| CubicLobe::<8, f64>::new(n).at_versine(w)),
];

/// The largest error over the angle against n, sampled in t = n w.
pub(super) fn over_n() -> Figure {
    let largest = |lobe: LobeAt, n: f64| {
        let reach = n.min(20.0);
        let error = |i: u32| {
            let w = f64::from(i) / 800.0 * reach / n;
            (lobe(w, n) - cos_n_versine(w, n)).abs()
        };
        (0..=800).map(error).fold(0.0, f64::max)
    };
    let exponents = |i: u32| 16.0 * libm::exp2(f64::from(i) / 16.0);
    let series: Vec<Series> = LOBES
        .iter()
        .map(|(label, lobe)| {
            let points = (0..=192).map(exponents).map(|n| (n, largest(*lobe, n))).collect();
            Series::new(*label, Style::Line, points)
        })
        .collect();
    let grown = series[0].points.iter().map(|p| p.1).fold(0.0, f64::max);
    let message =
        format!("The cubic lobes keep their error for every exponent; cs_16's grows to {}", number(grown));
    let chart = Chart::Line(LineChart {
        title: message.clone(),
        subtitle: "Largest |lobe − cosⁿθ| over all angles, sampled; at n = 16 cs_16 is cosⁿ itself.".into(),
        series,
        ..empty(
            Axis::new("specular exponent n", Scale::Log2, (16.0, 65_536.0)),
            Axis::new("largest error over θ", Scale::Log10, (1e-6, 3e-2)),
        )
    });
    Figure { stem: "kernels-over-n", alt: format!("{message}."), chart }
}

/// A power with its bell.
type Bell = (u32, fn(f64) -> f64);

const BELLS: [Bell; 3] = [(2, cubic_bell::<2, f64>), (4, cubic_bell::<4, f64>), (8, cubic_bell::<8, f64>)];

/// The cubic bells' errors against e⁻ᵗ along t, in units of their largest.
pub(super) fn equioscillation(exponential: &[ExponentialBell]) -> Figure {
    let series = BELLS
        .iter()
        .filter_map(|(power, bell)| {
            let row = exponential.iter().find(|row| row.shape == Shape::Cubic && row.power == *power)?;
            let size = row.error.value.hi();
            let points = curve((0.0, 16.0), 800, |t| (libm::exp(-t) - bell(t)) / size);
            Some(Series::new(format!("K = {power}: largest {}", number(size)), Style::Line, points))
        })
        .collect();
    let message = "Each cubic bell's error reaches its largest size four times with alternating sign";
    let chart = Chart::Line(LineChart {
        title: message.into(),
        subtitle: "So no cubic p with p(0) = 1 does better. Beyond its cut the bell is 0 and e^(−t) is left."
            .into(),
        series,
        ..empty(
            Axis::new("t (dimensionless)", Scale::Linear, (0.0, 16.0)),
            Axis::new("(e^(−t) − bell)/largest", Scale::Linear, (-1.1, 1.1)),
        )
    });
    Figure { stem: "kernels-error", alt: format!("{message}."), chart }
}
