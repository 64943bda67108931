//! The bell (8), (1 - n x²/(2K))^K, against e^(-n x²/2). With t = n x²/2 it is (1 - t/K)^K: no n is left.

use super::super::judgement::{Finding, Verdict};
use crate::bound::{Interval, best_scale, scaled_bell_excess};
use crate::integral::{Edge, Field};
use crate::paper::BellFigure;

/// Suprema are enclosed to this.
const TOLERANCE: f64 = 1e-9;
/// Halvings of the bracket around the best scale: enough to reach what suprema of 1e-9 can tell apart.
const STEPS: u32 = 34;

/// sup over t ≥ 0 of |e⁻ᵗ - (1 - t/T)^K| and its argument.
fn distance(power: u32, reach: Interval) -> (Interval, f64) {
    let z = Interval::from(1.0) / reach;
    let [below, above] = scaled_bell_excess(power, z, f64::INFINITY, TOLERANCE);
    let at = if below.value.lo() >= above.value.lo() { below.at[0] } else { above.at[0] };
    (below.value.max(above.value), at)
}

/// √(K/π) B(½, K + 1): area under the curve by the Gaussian's.
fn area(power: u32) -> Interval {
    // B(½, K + 1) = 2 Π 2j/(2j + 1), j = 1..K.
    let beta = (1..=i64::from(power))
        .fold(Interval::from(2.0), |b, j| b * Interval::int(2 * j) / Interval::int(2 * j + 1));
    (Interval::int(i64::from(power)) / Interval::PI).sqrt() * beta
}

pub(super) fn number(power: u32, exponent: u32, figure: BellFigure) -> Finding {
    let k = Interval::int(i64::from(power));
    match figure {
        BellFigure::Sup => {
            let (error, at) = distance(power, k);
            let x = libm::sqrt(2.0 * at / f64::from(exponent));
            let witness = format!("at t = n x²/2 = {at:.4}, whatever n; x = {x:.4} for n = {exponent}");
            Finding::figure(error, witness)
        }
        BellFigure::Volume => {
            let ratio = k / (k + Interval::from(1.0));
            Finding::figure(ratio, format!("{power}/{} exactly, whatever n", power + 1))
        }
        BellFigure::Area => Finding::figure(area(power), "√(K/π) B(½, K + 1), whatever n".to_owned()),
        BellFigure::BestSup => {
            let best = best_scale(power, STEPS);
            let n = f64::from(exponent) * f64::from(power) / best.at;
            Finding::figure(best.error, format!("at n = {n:.4} in the bell, against e^(-{exponent} x²/2)"))
        }
        BellFigure::BestN => {
            let best = best_scale(power, STEPS);
            let n = Interval::int(i64::from(exponent)) * k / best.reach;
            let witness = format!(
                "where the bell is as far above e^(-{exponent} x²/2) as below, {:.4e}: T = {:.5}",
                best.error.hi(),
                best.at
            );
            Finding::figure(n, witness)
        }
    }
}

pub(super) fn is_nearest(power: u32, exponent: u32) -> Finding {
    let (own, at) = distance(power, Interval::int(i64::from(power)));
    let best = best_scale(power, STEPS);
    let n = f64::from(exponent) * f64::from(power) / best.at;
    let verdict = if best.error.hi() < own.lo() { Verdict::Refuted } else { Verdict::Undecided };
    let witness = format!(
        "n = {n:.4} in the bell is at most {:.4e} from e^(-{exponent} x²/2); n = {exponent} is {:.4e} at t = {at:.4}",
        best.error.hi(),
        own.lo()
    );
    Finding { printed: String::new(), computed: Some(best.error), verdict, witness }
}

/// Beyond x = √(2K/n) an even power rises again, without end.
pub(super) fn uncut(power: u32, exponent: u32) -> Finding {
    // At n x²/2 = 2K the bell is (-1)^K again, and e^(-2K) of the Gaussian is left.
    let left = (-Interval::int(2 * i64::from(power))).exp();
    let bell = Interval::from(-1.0).power(power);
    let off = (bell - left).abs();
    let x = 2.0 * libm::sqrt(f64::from(power) / f64::from(exponent));
    let (within, _) = distance(power, Interval::int(i64::from(power)));
    let verdict = if off.lo() > within.hi() { Verdict::Refuted } else { Verdict::Undecided };
    let witness = format!(
        "at x = {x:.4} (8) is 1 again and e^(-n x²/2) {:.1e}, and it rises without end; cut at its zero it is within {:.4e}",
        left.hi(),
        within.hi()
    );
    Finding { printed: String::new(), computed: Some(off), verdict, witness }
}
