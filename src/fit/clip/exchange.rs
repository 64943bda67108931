//! The polynomial of a family of least largest error, by exchange.

use super::family::{ClipFamily, Ending, falls};
use super::{ClipPixel, at};
use crate::fit::continuum::{Sample, golden_section};
use crate::fit::exchange::alternation;
use nalgebra::{DMatrix, DVector};

/// Steps of a scan for extremes.
const SCAN: u32 = 1000;
/// Exchanges after which there is something wrong; five are usual.
const MOST: u32 = 60;
/// How evenly the extremes are levelled, relative: golden section finds a value to less.
const EVEN: f64 = 1e-10;

/// d of a scan's step, finer towards both ends.
fn place(i: u32) -> f64 {
    let turn = core::f64::consts::PI * f64::from(i) / f64::from(SCAN);
    if i == SCAN { 0.5 } else { 0.25 * (1.0 - libm::cos(turn)) }
}

/// The extremes of f over [0, ½], one a run of equal sign, in order: d and f.
pub(super) fn extremes(f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut runs: Vec<(u32, f64)> = Vec::new();
    for i in 0..=SCAN {
        let value = f(place(i));
        match runs.last_mut() {
            Some(last) if (last.1 < 0.0) == (value < 0.0) => {
                if value.abs() > last.1.abs() {
                    *last = (i, value);
                }
            }
            _ => runs.push((i, value)),
        }
    }
    let refined = |(i, value): (u32, f64)| {
        let (lo, hi) = (place(i.saturating_sub(1)), place((i + 1).min(SCAN)));
        let d = golden_section((lo, hi), |d| -f(d).abs());
        // Golden section comes near an end, not onto it.
        if f(d).abs() > value.abs() * (1.0 + 1e-12) { (d, f(d)) } else { (place(i), value) }
    };
    runs.into_iter().map(refined).collect()
}

/// The largest |f| over [0, ½], with its d: found by a scan, not proved.
pub(super) fn largest(f: impl Fn(f64) -> f64) -> (f64, f64) {
    let found = extremes(f);
    found.into_iter().fold((0.0, 0.0), |best, (d, v)| if v.abs() > best.1 { (d, v.abs()) } else { best })
}

/// The unknowns of least largest error of a family, by Remez' exchange, ended by an alternation.
///
/// `None` if it does not end: where the base's own error, which no unknown moves, is the largest.
pub(super) fn minimax(pixel: &ClipPixel, family: ClipFamily) -> Option<Vec<f64>> {
    let basis = family.basis();
    let count = basis.len();
    if count == 0 {
        return Some(vec![]);
    }
    // Inner points: at the ends a family may leave nothing free.
    let start = |i: usize| {
        let turn = core::f64::consts::PI * (i as f64 + 0.5) / (count + 1) as f64;
        0.25 * (1.0 - libm::cos(turn))
    };
    let mut reference: Vec<f64> = (0..=count).map(start).collect();
    for _ in 0..MOST {
        let mut matrix = DMatrix::zeros(count + 1, count + 1);
        let mut right = DVector::zeros(count + 1);
        for (i, &d) in reference.iter().enumerate() {
            for (j, b) in basis.iter().enumerate() {
                matrix[(i, j)] = at(*b, d);
            }
            matrix[(i, count)] = if i.is_multiple_of(2) { -1.0 } else { 1.0 };
            right[i] = pixel.volume(d) - at(family.offset(), d);
        }
        let solution = matrix.lu().solve(&right)?;
        let unknowns: Vec<f64> = solution.iter().take(count).copied().collect();
        let level = solution[count].abs();
        let p = family.polynomial(&unknowns);
        let found = extremes(|d| at(p, d) - pixel.volume(d));
        let worst = found.iter().map(|e| e.1.abs()).fold(0.0, f64::max);
        if worst <= level * (1.0 + EVEN) {
            return Some(unknowns);
        }
        // A sample here is a place and no more.
        let samples: Vec<(Sample, f64)> = found.iter().map(|&(d, v)| (Sample { m: d, g: 1.0 }, v)).collect();
        reference = alternation(&samples, count + 1)?.iter().map(|s| s.m).collect();
    }
    None
}

/// The best of a degree, P(0) = ½ or free, that falls to 0 at the base and so is never negative.
///
/// The condition P(½) = 0 alone is put first. If the best then has P'(½) ≤ 0 and falls, it is the answer.
/// If P'(½) > 0, the best with P'(½) ≤ 0 has P'(½) = 0: the error is a convex function of the unknowns, and
/// the condition a half space of them that leaves out its minimum, so its minimum there lies on the border;
/// and if that one falls everywhere, nothing that falls is better. `None` if it does not.
pub(super) fn falling(pixel: &ClipPixel, degree: u32, half: bool) -> Option<[f64; 4]> {
    let of = |ending: Ending| {
        let family = ClipFamily { degree, half, ending };
        minimax(pixel, family).map(|unknowns| family.rounded(&unknowns))
    };
    let zero = of(Ending::Zero)?;
    let slope = zero[1] + zero[2] + 0.75 * zero[3];
    let best = if slope > 0.0 { of(Ending::Landing)? } else { zero };
    falls(best).then_some(best)
}
