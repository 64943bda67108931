//! How a row of texels becomes a shorter one.

use super::Wrap;
use std::f64::consts::PI;

/// The filter between level 0 and a coarser level. Every level is filtered from level 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// The mean over the texel's area, exactly: fractions of texels at its edges count by their length.
    /// Keeps the mean of the whole texture, whatever its size.
    Box,
    /// A sinc at the level's own Nyquist frequency under a Kaiser window of three texels to either side,
    /// β = 4; normalised, so that constants stay. Passes up to 0.6 of that frequency within 3 %, a half at the
    /// frequency itself, and beyond 1.4 times it less than 3 %. Its negative lobes may overshoot at edges.
    Kaiser,
}

/// Half width of the Kaiser window in texels of the coarser level.
const RADIUS: f64 = 3.0;
const BETA: f64 = 4.0;

/// The texels that one texel of the coarser row is made of: the first, wrapped already, and the weights.
pub(super) struct Taps {
    pub places: Vec<usize>,
    pub weights: Vec<f64>,
}

impl Reduction {
    /// Both.
    pub const ALL: [Reduction; 2] = [Reduction::Box, Reduction::Kaiser];

    /// `box` or `kaiser`.
    pub fn id(self) -> &'static str {
        match self {
            Reduction::Box => "box",
            Reduction::Kaiser => "kaiser",
        }
    }

    /// The one with this id.
    pub fn from_id(id: &str) -> Option<Reduction> {
        Reduction::ALL.into_iter().find(|reduction| reduction.id() == id)
    }

    /// Of texel i, where `from` texels become `to` ≤ `from`. The weights' sum is 1 to rounding.
    pub(super) fn taps(self, i: usize, from: usize, to: usize, wrap: Wrap) -> Taps {
        if from == to {
            return Taps { places: vec![i], weights: vec![1.0] };
        }
        match self {
            // In units of 1/to of a texel all ends are whole: [i from, (i + 1) from) and [k to, (k + 1) to).
            Reduction::Box => {
                let (start, end) = (i * from, (i + 1) * from);
                let places: Vec<usize> = (start / to..end.div_ceil(to)).collect();
                let overlap = |&k: &usize| (end.min((k + 1) * to) - start.max(k * to)) as f64 / from as f64;
                let weights = places.iter().map(overlap).collect();
                Taps { places, weights }
            }
            Reduction::Kaiser => {
                let scale = from as f64 / to as f64;
                let middle = (i as f64 + 0.5) * scale;
                let reach = RADIUS * scale;
                let first = (middle - reach - 0.5).ceil() as i64;
                let last = (middle + reach - 0.5).floor() as i64;
                let weight = |k: i64| kaiser_sinc((k as f64 + 0.5 - middle) / scale);
                let sum: f64 = (first..=last).map(weight).sum();
                Taps {
                    places: (first..=last).map(|k| wrap.index(k, from)).collect(),
                    weights: (first..=last).map(|k| weight(k) / sum).collect(),
                }
            }
        }
    }
}

/// sinc x under the Kaiser window I₀(β √(1 - (x/3)²))/I₀(β).
///
/// J. F. Kaiser, "Nonrecursive digital filter design using the I₀-sinh window function", 1974.
fn kaiser_sinc(x: f64) -> f64 {
    let inside = 1.0 - (x / RADIUS) * (x / RADIUS);
    if inside < 0.0 {
        return 0.0;
    }
    let sinc = if x == 0.0 { 1.0 } else { libm::sin(PI * x) / (PI * x) };
    sinc * bessel_i0(BETA * inside.sqrt()) / bessel_i0(BETA)
}

/// I₀(x) = Σ (x²/4)ᵏ/k!², for |x| ≤ 4 to rounding in 30 terms.
fn bessel_i0(x: f64) -> f64 {
    let quarter = 0.25 * x * x;
    let (mut sum, mut term) = (1.0, 1.0);
    for k in 1..30 {
        term *= quarter / f64::from(k * k);
        sum += term;
    }
    sum
}
