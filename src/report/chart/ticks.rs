//! Where an axis has ticks, and what they say.

use super::axis::{Axis, Scale, Span};
use super::font::Font;
use super::number::{Decimal, labels, powers_of_two};

/// A tick at a place in [0, 1]; its label is empty where there is no room for one.
#[derive(Clone, Debug)]
pub(super) struct Tick {
    pub(super) at: f64,
    pub(super) label: String,
}

/// The room that an axis' labels have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    pub(super) length: f64,
    pub(super) size: f64,
    /// Labels stand side by side, not above each other.
    pub(super) across: bool,
}

/// The caller's ticks, or as many round ones as fit.
pub(super) fn ticks(axis: &Axis, span: &Span, font: &Font, room: Room) -> Vec<Tick> {
    if !axis.ticks.is_empty() {
        return thinned(placed(span, axis.ticks.iter().cloned()), font, room);
    }
    let mut coarsest = Vec::new();
    for candidate in candidates(axis) {
        let ticks = placed(span, candidate);
        if ticks.len() >= 2 {
            if fits(&ticks, font, room) {
                return ticks;
            }
            coarsest = ticks;
        }
    }
    thinned(coarsest, font, room)
}

fn placed(span: &Span, ticks: impl IntoIterator<Item = (f64, String)>) -> Vec<Tick> {
    let mut placed: Vec<Tick> = ticks
        .into_iter()
        .filter_map(|(value, label)| {
            // A tick on an end may be rounded off it.
            let at = span.place(value).filter(|at| (-1e-9..=1.0 + 1e-9).contains(at))?;
            Some(Tick { at: at.clamp(0.0, 1.0), label })
        })
        .collect();
    placed.sort_by(|a, b| a.at.total_cmp(&b.at));
    placed
}

/// Sets of ticks, the finest first.
fn candidates(axis: &Axis) -> Vec<Vec<(f64, String)>> {
    let (lo, hi) = axis.range;
    let mut sets = Vec::new();
    match axis.scale {
        Scale::Linear => {}
        Scale::Log2 => {
            let (first, last) = (libm::ceil(libm::log2(lo)) as i32, libm::floor(libm::log2(hi)) as i32);
            if last - first >= 2 {
                for stride in 1..=(last - first) {
                    let exponents: Vec<i32> = multiples(first, last, stride);
                    let values = exponents.iter().map(|&k| libm::exp2(f64::from(k)));
                    sets.push(values.zip(powers_of_two(&exponents)).collect());
                }
            }
        }
        Scale::Log10 => {
            let (first, last) = (libm::floor(libm::log10(lo)) as i32, libm::ceil(libm::log10(hi)) as i32);
            if last - first <= 3 {
                let fine: Vec<Decimal> = (first..=last)
                    .flat_map(|exponent| [1, 2, 5].map(|mantissa| Decimal { mantissa, exponent }))
                    .filter(|d| (lo..=hi).contains(&d.value()))
                    .collect();
                if fine.len() >= 3 {
                    sets.push(labelled(&fine));
                }
            }
            if last - first >= 3 {
                for stride in 1..=(last - first) {
                    let decades: Vec<Decimal> = multiples(first, last, stride)
                        .into_iter()
                        .map(|exponent| Decimal { mantissa: 1, exponent })
                        .filter(|d| (lo..=hi).contains(&d.value()))
                        .collect();
                    sets.push(labelled(&decades));
                }
            }
        }
    }
    // Short logarithmic ranges have too few powers; round numbers serve there too.
    if sets.is_empty() {
        sets.extend((2..=8).rev().map(|count| labelled(&round(lo, hi, count))));
    }
    sets
}

fn multiples(first: i32, last: i32, stride: i32) -> Vec<i32> {
    (first..=last).filter(|k| k.rem_euclid(stride) == 0).collect()
}

fn labelled(ticks: &[Decimal]) -> Vec<(f64, String)> {
    ticks.iter().map(|t| t.value()).zip(labels(ticks)).collect()
}

/// The multiples of 1, 2 or 5 × 10^k in the range, about `count` of them and not more than one above.
fn round(lo: f64, hi: f64, count: i32) -> Vec<Decimal> {
    let raw = (hi - lo) / f64::from(count);
    let base = libm::floor(libm::log10(raw)) as i32;
    let steps = [(1, base), (2, base), (5, base), (1, base + 1), (2, base + 1)];
    let step = steps
        .map(|(mantissa, exponent)| Decimal { mantissa, exponent })
        .into_iter()
        .find(|step| step.value() >= raw * (1.0 - 1e-9));
    let Some(step) = step else { return Vec::new() };
    // The ends themselves are ticks even where the quotient is rounded past them.
    let (first, last) = (libm::ceil(lo / step.value() - 1e-9), libm::floor(hi / step.value() + 1e-9));
    // Beyond this the multiples are no longer exact, nor is there a readable label.
    if !(first.abs() < 1e15 && last.abs() < 1e15 && last - first <= 100.0) {
        return Vec::new();
    }
    (first as i64..=last as i64)
        .map(|k| Decimal { mantissa: k * step.mantissa, exponent: step.exponent })
        .collect()
}

/// Half of what a label needs along the axis.
fn reach(label: &str, font: &Font, room: Room) -> f64 {
    // A fifth on top of the width leaves room for a browser's font.
    if room.across { 0.6 * font.width(label, room.size) + 0.35 * room.size } else { 0.95 * room.size }
}

fn fits(ticks: &[Tick], font: &Font, room: Room) -> bool {
    ticks.windows(2).all(|pair| {
        let need = reach(&pair[0].label, font, room) + reach(&pair[1].label, font, room);
        (pair[1].at - pair[0].at) * room.length >= need
    })
}

/// The ticks without the labels that would lie over the one before.
fn thinned(mut ticks: Vec<Tick>, font: &Font, room: Room) -> Vec<Tick> {
    let mut free = f64::NEG_INFINITY;
    for tick in &mut ticks {
        let half = reach(&tick.label, font, room);
        let middle = tick.at * room.length;
        if middle - half < free {
            tick.label.clear();
        } else {
            free = middle + half;
        }
    }
    ticks
}

#[cfg(test)]
mod tests {
    use super::{Room, ticks};
    use crate::report::chart::font::font;
    use crate::report::chart::{Axis, Scale};

    fn texts(scale: Scale, range: (f64, f64), length: f64) -> Vec<String> {
        let axis = Axis::new("", scale, range);
        let room = Room { length, size: 24.0, across: true };
        let found = ticks(&axis, &axis.span().unwrap(), font().unwrap(), room);
        found.into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(texts(Scale::Linear, (0.0, 1.0), 700.0), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(texts(Scale::Linear, (-0.013, 0.012), 700.0), ["-0.010", "-0.005", "0", "0.005", "0.010"]);
        assert_eq!(
            texts(Scale::Log2, (16.0, 1024.0), 900.0),
            ["16", "32", "64", "128", "256", "512", "1024"]
        );
        assert_eq!(texts(Scale::Log2, (16.0, 1024.0), 260.0), ["16", "64", "256", "1024"]);
        assert_eq!(
            texts(Scale::Log10, (1e-7, 1e-1), 900.0),
            ["1e-7", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1"]
        );
        assert_eq!(texts(Scale::Log10, (1.0, 100.0), 900.0), ["1", "2", "5", "10", "20", "50", "100"]);
    }

    #[test]
    fn odd_ranges_have_ticks_or_none_but_do_not_hang() {
        assert!(texts(Scale::Log2, (20.0, 30.0), 900.0).len() >= 2);
        assert!(texts(Scale::Log10, (3.0, 4.0), 900.0).len() >= 2);
        texts(Scale::Linear, (1.0, 1.0 + f64::EPSILON), 900.0);
        texts(Scale::Linear, (-8e307, 8e307), 900.0);
        texts(Scale::Linear, (0.0, f64::MIN_POSITIVE / 1e10), 900.0);
        texts(Scale::Log10, (1e-300, 1e300), 900.0);
        texts(Scale::Log2, (1e-300, 1e300), 900.0);
    }
}
