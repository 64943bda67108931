//! Errors measured where they are large: what tells a kernel that fails from one that is not proved.

use super::Exponents;
use crate::bound::{Format, Handed, Measure};
use crate::kernel::prepared::Prepared;
use crate::kernel::real::Real;
use crate::kernel::stand_in::StandIn;
use crate::kernel::vector::versine_between;
use crate::stability::Half;

/// How an error is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// By enclosures: the approximation's error there exceeds all that rounding can take back.
    Certified,
    /// By running the kernel there in its format, against double precision.
    Measured,
}

impl Evidence {
    /// `certified` or `measured`.
    pub const fn id(self) -> &'static str {
        match self {
            Evidence::Certified => "certified",
            Evidence::Measured => "measured",
        }
    }
}

/// An error that occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Witness {
    /// The exponent.
    pub n: f64,
    /// The angle in radians.
    pub theta: f64,
    /// A lower bound of the error there; +∞ for a value that is no number.
    pub error: f64,
    /// How it is known.
    pub evidence: Evidence,
}

/// θ of t = n (1 - cos θ), without the cancellation of 1 - cos θ.
///
/// ```
/// use bellfit::choose::theta;
/// assert!((theta(1.0, 1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
pub fn theta(n: f64, t: f64) -> f64 {
    2.0 * libm::asin(libm::sqrt((0.5 * t / n).clamp(0.0, 1.0)))
}

/// Angles of one exponent that are looked at, besides those that are given.
const ANGLES: u32 = 192;
/// Exponents, besides the ends and those that are given.
const EXPONENTS: u32 = 6;
/// Directions in which a pair of vectors is laid.
const TURNS: u32 = 4;

/// The largest error found; `None` where every cosⁿ that was looked at is below the floor.
pub(super) fn largest(
    stand_in: StandIn,
    format: Format,
    handed: Handed,
    n: Exponents,
    measure: Measure,
    seeds: &[[f64; 2]],
) -> Option<Witness> {
    let mut best: Option<Witness> = None;
    let mut look = |n: f64, t: f64| {
        let w = (t / n).clamp(0.0, 1.0);
        for turn in 0..if handed == Handed::Difference { TURNS } else { 1 } {
            let Some(error) = error(stand_in, format, handed, n, w, turn, measure) else { continue };
            if best.is_none_or(|b| error > b.error) {
                best = Some(Witness { n, theta: theta(n, n * w), error, evidence: Evidence::Measured });
            }
        }
    };
    let mut exponents = vec![n.from(), n.to()];
    exponents.extend(seeds.iter().map(|seed| seed[0]));
    exponents.extend((1..EXPONENTS).map(|i| {
        let share = f64::from(i) / f64::from(EXPONENTS);
        n.from() * libm::pow(n.to() / n.from(), share)
    }));
    for m in exponents {
        let m = if n.is_whole() { libm::round(m) } else { m }.clamp(n.from(), n.to());
        for i in 0..=ANGLES {
            let share = f64::from(i) / f64::from(ANGLES);
            look(m, m.min(36.0) * share * share);
        }
        for seed in seeds {
            // A few roundings of the angle around the place.
            for step in -8..=8 {
                look(m, seed[1] * (1.0 + f64::from(step) / 512.0));
            }
        }
    }
    best
}

/// A lower bound of the error of one value at the versine w; `None` where cosⁿ is below the floor.
fn error(
    stand_in: StandIn,
    format: Format,
    handed: Handed,
    n: f64,
    w: f64,
    turn: u32,
    measure: Measure,
) -> Option<f64> {
    let exponent = n * libm::log1p(-w);
    let exact = if w == 0.0 { 1.0 } else { libm::exp(exponent) };
    // log1p, the product and exp: three roundings and a half in the exponent, one and a half after.
    let slack = exact * f64::EPSILON * (2.0 + 4.0 * exponent.abs().min(745.0)) + f64::MIN_POSITIVE;
    let half = |x: f64| Half::from_f64(x).to_f64();
    let found = match format {
        Format::Double => value::<f64>(stand_in, handed, n, w, turn, |x| x),
        Format::Single => value::<f32>(stand_in, handed, n, w, turn, |x| x as f32),
        Format::HalfStored => half(value::<f32>(stand_in, handed, n, w, turn, |x| half(x) as f32)),
        Format::Half => value::<Half>(stand_in, handed, n, w, turn, Half::from_f64),
    };
    if found.is_nan() {
        return Some(f64::INFINITY);
    }
    let distance = ((found - exact).abs() - slack).max(0.0);
    match measure {
        Measure::Absolute => Some(distance),
        Measure::Relative { floor } => (exact - slack >= floor).then(|| distance / (exact + slack)),
    }
}

/// The kernel's value as a renderer computes it: constants of n in `f64`, rounded once; the angle handed over
/// by `store`.
fn value<F: Real>(
    stand_in: StandIn,
    handed: Handed,
    n: f64,
    w: f64,
    turn: u32,
    store: impl Fn(f64) -> F,
) -> f64 {
    let x = match handed {
        Handed::Cosine => store(1.0 - w),
        Handed::Versine => store(w),
        Handed::Difference => {
            let (sin, cos) = (libm::sqrt(w * (2.0 - w)), 1.0 - w);
            // Turned, the vectors' own doubles move the angle: by what f32 does not see.
            let turn = if F::from_f64(f64::EPSILON / 2.0 + 1.0) == F::ONE && w > 1e-12 { turn } else { 0 };
            let place = |v: [f64; 3]| turned(v, turn).map(&store);
            versine_between(place([0.0, 0.0, 1.0]), place([sin, 0.0, cos]))
        }
    };
    Prepared::new(stand_in, n).of(handed.argument(), x).to_f64()
}

/// A rotation about two axes, the identity for 0.
fn turned([x, y, z]: [f64; 3], turn: u32) -> [f64; 3] {
    let (a, b) = (0.7 * f64::from(turn), 1.9 * f64::from(turn));
    let (x, z) = (x * libm::cos(a) + z * libm::sin(a), z * libm::cos(a) - x * libm::sin(a));
    [x * libm::cos(b) - y * libm::sin(b), x * libm::sin(b) + y * libm::cos(b), z]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At n = 16 cs_16 is cosⁿ, so in doubles nothing but rounding is found, a few ε.
    #[test]
    fn nothing_is_found_where_there_is_nothing() {
        let n = Exponents::new(16.0, 16.0).unwrap();
        for handed in [Handed::Cosine, Handed::Versine] {
            let found = largest(StandIn::Cs16, Format::Double, handed, n, Measure::Absolute, &[]).unwrap();
            assert!(found.error < 1e-14, "{found:?}");
        }
        // sup |e⁻ᵗ - (1 - t/16)^16| is 1.7277e-2 as n → ∞.
        let far = Exponents::new(1e6, 1e6).unwrap();
        let found = largest(StandIn::Cs16, Format::Double, Handed::Versine, far, Measure::Absolute, &[]);
        assert!((found.unwrap().error - 1.7277e-2).abs() < 1e-5, "{found:?}");
    }
}
