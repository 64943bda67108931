//! e^(−t) against Lyon's bells.

use super::Figure;
use super::sample::{curve, empty, enclosed};
use crate::bound::{Supremum, bell_distance};
use crate::kernel::bell::bell;
use crate::report::chart::{Axis, Chart, LineChart, Mark, Scale, Series, Style};

/// A bell's power K, and the bell.
type Power = (u32, fn(f64) -> f64);

const POWERS: [Power; 4] =
    [(4, bell::<4, f64>), (8, bell::<8, f64>), (16, bell::<16, f64>), (32, bell::<32, f64>)];

/// The end of the axis: the differences have died away.
const REACH: (f64, f64) = (0.0, 10.0);

/// e^(−t) − (1 − t/K)^K for K = 4, 8, 16, 32.
pub(super) fn bells() -> Figure {
    let found = POWERS.map(|(k, _)| bell_distance(k, 1e-6));
    let series = POWERS.map(|(k, bell)| {
        Series::new(format!("K = {k}"), Style::Line, curve(REACH, 400, |t| libm::exp(-t) - bell(t)))
    });
    let mark = |sup: &Supremum<1>| Mark {
        at: (sup.at[0], sup.value.mid()),
        text: format!("{} at t = {:.2}", enclosed(sup.value), sup.at[0]),
    };
    let errors = found.map(|sup| enclosed(sup.value));
    let message =
        format!("Doubling K about halves Lyon's error: {} at K = 4, {} at 32", errors[0], errors[3]);
    let chart = Chart::Line(LineChart {
        title: message.clone(),
        subtitle:
            "The bell (1 − t/K)^K lies below e^(−t) everywhere, and is 0 from t = K on; K = 16 is the paper's."
                .into(),
        series: series.into(),
        marks: found.iter().map(mark).collect(),
        ..empty(
            Axis::new("t (dimensionless)", Scale::Linear, REACH),
            Axis::new("e^(−t) − (1 − t/K)^K", Scale::Linear, (0.0, 0.08)),
        )
    });
    Figure { stem: "bells", alt: format!("{message}."), chart }
}
