//! Rounding at the extremes: binary16 exhausted, the reference against mpmath, the tables against what theory
//! allows, and the worst f32 cases that exhausting them found.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;
#[path = "support/worst.rs"]
mod worst;

use bellfit::bound::{Format, Handed, exact};
use bellfit::integral::Field;
use bellfit::kernel::bell::bell;
use bellfit::kernel::constants::CUBIC_EXP;
use bellfit::kernel::cubic::{CubicLobe, cubic_bell};
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::model::Model;
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::StandIn;
use bellfit::stability::{
    Angle, Clip, DISPLAY_STEP, DoubleDouble, Factor, Half, LobeRow, Stability, angles, fitted_bell, limits,
    lobe_rows, lyon_bell,
};
use dashu_int::IBig;
use dashu_ratio::RBig;
use draw::Draw;
use references::{Reference, rows};
use std::sync::OnceLock;

/// Unit roundoff of binary16.
const U: f64 = 1.0 / 2048.0;

fn study() -> &'static Stability {
    static STUDY: OnceLock<Stability> = OnceLock::new();
    STUDY.get_or_init(|| Stability::run().unwrap())
}

/// Every binary16 number that is not NaN, by value.
fn every_half() -> impl Iterator<Item = Half> {
    let finite_and_infinite = 0..=0x7c00_u16;
    finite_and_infinite
        .clone()
        .rev()
        .map(|bits| Half::from_bits(bits | 0x8000))
        .chain(finite_and_infinite.map(Half::from_bits))
}

#[test]
fn all_65536_bit_patterns_are_what_the_standard_says() {
    for bits in 0..=u16::MAX {
        let half = Half::from_bits(bits);
        let (sign, exponent, fraction) = (bits >> 15, i32::from(bits >> 10 & 31), f64::from(bits & 1023));
        let size = match exponent {
            0 => fraction / 16_777_216.0,
            31 if fraction == 0.0 => f64::INFINITY,
            31 => f64::NAN,
            _ => (1.0 + fraction / 1024.0) * libm::exp2(f64::from(exponent - 15)),
        };
        if size.is_nan() {
            assert!(half.is_nan() && half.to_f64().is_nan() && half.to_bits() == 0x7e00);
            continue;
        }
        let value = if sign == 1 { -size } else { size };
        assert_eq!(half.to_f64().to_bits(), value.to_bits(), "{bits:04x}");
        assert_eq!((half.to_bits(), Half::from_f64(value).to_bits()), (bits, bits));
        assert_eq!(half.is_finite(), value.is_finite());
    }
}

/// Between every two neighbours: their middle goes to the even one, a double more or less to its side.
#[test]
fn rounding_is_to_nearest_and_ties_to_even() {
    for bits in 0..0x7c00_u16 {
        let (low, next) = (Half::from_bits(bits).to_f64(), bits + 1);
        // Beyond the largest, the number that would follow.
        let high = if next == 0x7c00 { 65536.0 } else { Half::from_bits(next).to_f64() };
        let middle = 0.5 * (low + high); // exact
        let even = if bits & 1 == 0 { bits } else { next };
        for (x, expected) in [(middle, even), (middle.next_down(), bits), (middle.next_up(), next)] {
            assert_eq!(Half::from_f64(x).to_bits(), expected, "{x:e}");
            assert_eq!(Half::from_f64(-x).to_bits(), expected | 0x8000, "{x:e}");
        }
    }
    assert_eq!(Half::from_f64(1e300).to_bits(), 0x7c00);
    assert_eq!(Half::from_f64(-1e-300).to_bits(), 0x8000);
}

/// In binary64 sums and products of binary16 numbers are exact, quotients and roots have 53 ≥ 2·11 + 2 bits: one
/// more rounding gives the correct one. `Half` goes by way of binary32.
#[test]
fn arithmetic_rounds_once() {
    let mut draw = Draw(16);
    for _ in 0..400_000 {
        let [a, b] = [0, 1].map(|_| Half::from_bits(draw.bits() as u16));
        let (x, y) = (a.to_f64(), b.to_f64());
        let pairs =
            [(a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y), (a.sqrt(), libm::sqrt(x))];
        for (i, (half, double)) in pairs.into_iter().enumerate() {
            let expected = Half::from_f64(double);
            assert_eq!(half.to_bits(), expected.to_bits(), "operation {i} of {x:e} and {y:e}");
        }
        assert_eq!((a < b, a == b, a > b), (x < y, x == y, x > y));
    }
}

fn rational(x: DoubleDouble) -> RBig {
    let (hi, lo) = x.parts();
    exact(hi).unwrap() + exact(lo).unwrap()
}

#[test]
fn the_reference_keeps_its_digits() {
    let mut seen = 0;
    for [function, x, y, value] in rows::<4>("stability.csv") {
        let (x, n): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap_or(f64::NAN));
        let computed = match function.as_str() {
            "versine" => Angle::of(x).versine(),
            "cosine" => Angle::of(x).cosine(),
            "sine" => Angle::of(x).sine(),
            "cos-n" => Angle::of(x).cos_n(n),
            "cs-16" | "schlick" | "spherical-gaussian" => {
                Angle::of(x).stand_in(StandIn::from_id(&function).unwrap(), n)
            }
            "log-one-minus" => DoubleDouble::from(x).log_one_minus(),
            "exp" => DoubleDouble::from(x).exp(),
            "erf" => DoubleDouble::from(x).erf(),
            "clip-volume" => Clip::Whole.exact(x, n),
            "clip-volume-cut" => Clip::Cut.exact(x, n),
            other => {
                let (factor, model) = other.split_once('/').unwrap();
                let factor = Factor::ALL.into_iter().find(|f| f.id() == factor).unwrap();
                let model = Model::ALL.into_iter().find(|m| m.id() == model).unwrap();
                factor.exact(model, x)
            }
        };
        let reference = Reference::parse(&value).unwrap();
        let size = rational(computed.abs()).max(RBig::int(0));
        let gap = rational(computed) - reference.value.clone();
        let gap = if gap < RBig::int(0) { RBig::int(0) - gap } else { gap };
        // 2⁻⁹⁰ = 8e-28 relative, which is what an exponent of 640 leaves of 102 bits; absolutely as much of 1
        // where a cosine or a logarithm's 1 - x has cancelled. f64 needs 1e-19 of it.
        let relative = matches!(function.as_str(), "versine" | "sine" | "exp" | "erf" | "log-one-minus")
            || function.contains("factor");
        let allowed = exact(libm::exp2(-90.0)).unwrap();
        let allowed = if relative { allowed * size } else { allowed };
        assert!(gap <= allowed, "{function} at {x}, {y}: off by {}", gap.to_f64().value());
        seen += 1;
    }
    assert!(seen > 200, "{seen} rows");
}

/// e^(n ln c) = e^(-n w) where w is so small that the next term is n w²/2 < 1e-21: the ends of the table.
#[test]
fn the_smallest_angles_meet_their_limit() {
    for theta in [1e-8, 2e-8, 3e-7] {
        let value = Angle::of(theta).cos_n(1e12) / (DoubleDouble::from(-5e11 * theta * theta)).exp();
        // ln cos θ = -θ²/2 - θ⁴/12; and 5e11 θ² is rounded.
        let allowed = 1e12 * theta * theta * theta * theta / 12.0 + 5e11 * theta * theta * 3e-16;
        assert!((value - DoubleDouble::from(1.0)).abs().to_f64() <= 1.1 * allowed, "{theta}");
    }
    // Only the doubles' ends: nothing to round.
    let half = DoubleDouble::from(1.0) + DoubleDouble::from(libm::exp2(-60.0));
    assert_eq!(half.round::<f64>(), 1.0);
    assert_eq!((half - DoubleDouble::from(1.0)).to_f64(), libm::exp2(-60.0));
    assert!(DoubleDouble::from(f64::NAN).exp().to_f64().is_nan());
}

/// A bell p(t)^K over every binary16 t in [0, end], its value in whole units of 2⁻²⁴ as the kernel in binary16
/// gives it; and p(t) 2^shift as an integer.
struct Exhausted {
    k: u32,
    end: f64,
    shift: usize,
    base: Box<dyn Fn(u64) -> IBig>,
    half: fn(Half) -> Half,
    single: fn(f32) -> f32,
    reference: Box<dyn Fn(f64) -> DoubleDouble>,
}

fn exhausted<const K: u32>() -> Exhausted {
    let shift = 24 + K.trailing_zeros() as usize;
    Exhausted {
        k: K,
        end: f64::from(K),
        shift,
        // t = m 2⁻²⁴: 1 - t/K = (K 2²⁴ - m)/(K 2²⁴)
        base: Box::new(move |m| (IBig::ONE << shift) - IBig::from(m)),
        half: bell::<K, Half>,
        single: bell::<K, f32>,
        reference: Box::new(|t| lyon_bell(K, DoubleDouble::from(t))),
    }
}

fn exhausted_cubic<const K: u32>() -> Exhausted {
    let row = K.trailing_zeros() as usize - 1;
    let unit = 24 + K.trailing_zeros() as usize;
    // The coefficients are doubles above 2⁻¹⁰: whole multiples of 2⁻⁶².
    let scaled = CUBIC_EXP[row].map(|c| {
        let whole = exact(c).unwrap() * RBig::from(IBig::ONE << 62);
        assert!(whole.clone() == RBig::from(whole.numerator().clone()));
        whole.numerator().clone()
    });
    let shift = 62 + 3 * unit;
    Exhausted {
        k: K,
        end: 16.0,
        shift,
        base: Box::new(move |m| {
            let (m, [c1, c2, c3]) = (IBig::from(m), &scaled);
            (IBig::ONE << shift) - ((c1 * &m) << (2 * unit)) + ((c2 * &m * &m) << unit) - c3 * &m * &m * &m
        }),
        half: cubic_bell::<K, Half>,
        single: cubic_bell::<K, f32>,
        reference: Box::new(|t| fitted_bell(K, DoubleDouble::from(t)).unwrap()),
    }
}

/// Both modes of binary16, every argument: the largest error and its first argument by exact integers are those
/// by double-double, and no more than the count of roundings allows.
#[test]
fn binary16_bells_are_exhausted() {
    let all = [
        exhausted::<2>(),
        exhausted::<4>(),
        exhausted::<8>(),
        exhausted::<16>(),
        exhausted::<32>(),
        exhausted::<64>(),
        exhausted_cubic::<2>(),
        exhausted_cubic::<4>(),
        exhausted_cubic::<8>(),
    ];
    for bell in all {
        let power = bell.shift * bell.k as usize;
        let mut modes = [(IBig::ZERO, 0.0, 0.0, 0.0), (IBig::ZERO, 0.0, 0.0, 0.0)];
        for t in every_half().filter(|t| (0.0..=bell.end).contains(&t.to_f64())) {
            let x = t.to_f64();
            let base = (bell.base)((x * 16_777_216.0) as u64);
            let truth = if base > IBig::ZERO { base.pow(bell.k as usize) } else { IBig::ZERO };
            let reference = (bell.reference)(x);
            let stored = Half::from_f64(f64::from((bell.single)(x as f32)));
            for (mode, value) in modes.iter_mut().zip([(bell.half)(t), stored]) {
                assert!((0.0..=1.0).contains(&value.to_f64()), "K = {} at {x}", bell.k);
                let units = IBig::from((value.to_f64() * 16_777_216.0) as u64);
                let gap = (units << (power - 24)) - truth.clone();
                let gap = if gap < IBig::ZERO { -gap } else { gap };
                if gap > mode.0 {
                    (mode.0, mode.1) = (gap, x);
                }
                let gap = (DoubleDouble::from(value.to_f64()) - reference).abs().to_f64();
                if gap > mode.2 {
                    (mode.2, mode.3) = (gap, x);
                }
            }
        }
        for (mode, (exact_gap, exact_at, gap, at)) in modes.into_iter().enumerate() {
            let name = format!("K = {}, end {}, mode {mode}", bell.k, bell.end);
            assert_eq!(exact_at, at, "{name}");
            let exact_gap = RBig::from(exact_gap) / RBig::from(IBig::ONE << power);
            // The double-double is good to 1e-28; its difference from a binary16 number rounds to a double once.
            assert!((exact_gap.to_f64().value() / gap - 1.0).abs() < 1e-15, "{name}: {gap:e}");
            if mode == 1 {
                // One rounding of a number up to 1, and f32's own 1e-5.
                assert!(gap <= 0.5 * U + 1e-5, "{name}: {gap:e} at {at}");
            } else if bell.end == f64::from(bell.k) {
                // bell's page: (1 + u)^(2K - 1), of values up to 1; below 2⁻¹⁴ half a unit a step besides.
                let allowed = libm::pow(1.0 + U, 2.0 * f64::from(bell.k) - 1.0) - 1.0 + 1e-6;
                assert!(gap <= allowed && gap > 0.25 * U, "{name}: {gap:e} at {at}");
            }
        }
    }
}

/// The exponential in binary16, all arguments: the operation itself is rounded from binary64.
#[test]
fn binary16_exponential_is_exhausted() {
    let mut largest = (0.0, 0.0);
    for t in every_half().filter(|t| (0.0..=20.0).contains(&t.to_f64())) {
        let value = Real::exp(-t);
        let gap =
            (DoubleDouble::from(value.to_f64()) - (-DoubleDouble::from(t.to_f64())).exp()).abs().to_f64();
        if gap > largest.0 {
            largest = (gap, t.to_f64());
        }
        // Correctly rounded: within half the distance of its neighbours, if no closer than 2⁻⁴⁰ of it to a tie.
        let unit = libm::exp2(f64::from(value.exponent().max(-14) - 10));
        assert!(gap <= 0.5 * unit * (1.0 + libm::exp2(-40.0)), "{t:?}");
    }
    // Half a unit of the largest numbers below 1 is 2⁻¹², met to a part in a thousand.
    assert!(largest.0 <= libm::exp2(-12.0) && largest.0 > 0.999 * libm::exp2(-12.0), "{largest:?}");
}

/// Lobes over every binary16 argument: 1 on the axis, never above from the versine, 0 past the cut, and never
/// rising where each step keeps the order.
#[test]
fn binary16_lobes_keep_their_laws() {
    fn linear<const K: u32>(n: f64) {
        let lobe = LinearLobe::<K, f64>::lyon(n).convert::<Half>();
        let mut last = f64::INFINITY;
        for w in every_half().filter(|w| (0.0..=1.0).contains(&w.to_f64())) {
            let value = lobe.at_versine(w).to_f64();
            assert!((0.0..=1.0).contains(&value) && value <= last, "K = {K}, n = {n}, {w:?}");
            // The slope n/K is a power of two or has three bits: exact, and so is the cut.
            assert!(w.to_f64() < f64::from(K) / n || value == 0.0);
            last = value;
        }
        let mut last = 0.0;
        for c in every_half().filter(|c| (0.0..=1.0).contains(&c.to_f64())) {
            let value = lobe.at(c).to_f64();
            assert!(value >= last, "K = {K}, n = {n}, {c:?}");
            last = value;
        }
    }
    for n in [1.0, 16.0, 64.0, 96.0, 1024.0, 8192.0] {
        linear::<4>(n);
        linear::<16>(n);
    }
    fn cubic<const K: u32>(n: f64) {
        let lobe = CubicLobe::<K, f64>::new(n).convert::<Half>();
        assert_eq!(lobe.at_versine(Half::ZERO), Half::ONE);
        for w in every_half().filter(|w| (0.0..=1.0).contains(&w.to_f64())) {
            let value = lobe.at_versine(w).to_f64();
            // Two roundings of the inner cubic, about 1/2 each, one of the product: the base may lie above the
            // exact one, which is at most 1, by no more than 1 - w (…) rounds to.
            assert!((0.0..=1.0).contains(&value), "K = {K}, n = {n}, {w:?}: {value}");
            // p falls to its cut at w = T/n and stays negative: T < 16 for each of the three.
            assert!(n * w.to_f64() < 20.0 || value == 0.0, "K = {K}, n = {n}, {w:?}: {value}");
        }
    }
    for n in [16.0, 20.0, 64.0, 100.0, 200.0] {
        cubic::<2>(n);
        cubic::<4>(n);
        cubic::<8>(n);
    }
    // Neither a NaN nor what is behind passes for a value.
    let lobe = CubicLobe::<4, f64>::new(64.0).convert::<Half>();
    assert!(lobe.at(Half::NAN).is_nan() && lobe.at_versine(Half::NAN).is_nan());
    assert_eq!((lobe.at(-Half::ONE), lobe.at_versine(Half::TWO)), (Half::ZERO, Half::ZERO));
    // Where constants overflow the lobe is no lobe, and the table says so.
    assert!(CubicLobe::<4, f64>::new(1e6).convert::<Half>().horner().iter().any(|k| !k.is_finite()));
}

fn row(stand_in: StandIn, format: Format, handed: Handed, n: f64) -> &'static LobeRow {
    let own = |r: &&LobeRow| (r.stand_in, r.format, r.handed, r.n) == (stand_in, format, handed, n);
    study().lobes.iter().find(own).unwrap()
}

/// What the argument's rounding must do, and what it cannot exceed.
#[test]
fn the_rows_lie_where_theory_puts_them() {
    for (format, u) in
        [(Format::Single, Format::Single.unit_roundoff()), (Format::Double, Format::Double.unit_roundoff())]
    {
        for decade in 0..=12 {
            let n = libm::exp10(f64::from(decade));
            let rounding = |stand_in, handed| row(stand_in, format, handed, n).errors.unwrap().rounding.value;
            // c in [½, 1) is off by u/2 at most, and d cⁿ/dc ≤ n; pow adds an ulp of 1, u.
            let cosine = rounding(StandIn::Power, Handed::Cosine);
            assert!(cosine <= (0.5 * n + 1.0) * u, "{} at n = {n}: {cosine:e}", format.id());
            // Among 300 angles near the axis some c is off by nearly as much: a third, until the lobe is lost.
            assert!(cosine >= (0.17 * n * u).min(0.5), "{} at n = {n}: {cosine:e}", format.id());
            // w is off by u, and t e⁻ᵗ ≤ 1/e: so are log1p and the product, of 1 ulp and ½; exp adds u.
            let versine = rounding(StandIn::Power, Handed::Versine);
            assert!(
                versine <= (4.0 / std::f64::consts::E + 1.0) * u,
                "{} at n = {n}: {versine:e}",
                format.id()
            );
            // Components are off by u/2 each, the chord by 2·√3·u/2 at most and w by √(2w) of it; the arithmetic by
            // 4 u. With w = t/n and √t e⁻ᵗ < 0.43.
            let difference = rounding(StandIn::Power, Handed::Difference);
            let chord = 3.0_f64.sqrt() * u;
            let moved = 0.43 * (2.0 * n).sqrt() * chord + n * chord * chord;
            assert!(difference <= moved + 5.0 * u, "{} at n = {n}: {difference:e}", format.id());
        }
    }
    // In binary16 n itself is a constant, and ends.
    assert!(row(StandIn::Power, Format::Half, Handed::Cosine, 5e4).errors.is_some());
    assert!(row(StandIn::Power, Format::Half, Handed::Cosine, 1e5).errors.is_none());
    assert!(row(StandIn::Squarings, Format::Double, Handed::Cosine, 5e9).errors.is_none());
    assert_eq!(study().lobes.len(), 37 * 15 * 4 * 3);
}

/// Other angles, drawn at random: what the table holds is not beaten by much, or its grid would be too coarse.
#[test]
fn other_angles_find_no_more() {
    let mut draw = Draw(7);
    for n in [20.0, 1e3, 1e5, 1e7, 1e11] {
        let near = (0..400).map(|_| draw.real(1e-3, 6.0) / libm::sqrt(n));
        let thetas: Vec<f64> = near.filter(|theta| (1e-8..=1.57).contains(theta)).collect();
        for found in lobe_rows(n, &thetas) {
            let kept = row(found.stand_in, found.format, found.handed, n);
            assert_eq!(found.errors.is_some(), kept.errors.is_some());
            let Some((found, kept)) = found.errors.zip(kept.errors) else { continue };
            // Both are maxima of some 350 samples of rounding errors: a quarter more is not rare, twice is.
            for (f, k) in [(found.rounding, kept.rounding), (found.total, kept.total)] {
                assert!(
                    f.value.is_nan() || f.value <= 2.0 * k.value,
                    "n = {n}: {f:?} against {k:?}, {kept:?}"
                );
            }
        }
    }
}

/// Every row's maxima are what the kernel gives at the angle named.
#[test]
fn a_maximum_is_met_at_its_angle() {
    for kept in study().lobes.iter().step_by(13) {
        let Some(errors) = kept.errors else { continue };
        let peaks = [errors.rounding, errors.total];
        for (i, peak) in peaks.into_iter().enumerate().filter(|(_, peak)| peak.value.is_finite()) {
            // An error of 0 everywhere has no angle.
            if peak.value == 0.0 {
                continue;
            }
            let again = lobe_rows(kept.n, &[peak.theta]);
            let own =
                |r: &&LobeRow| (r.stand_in, r.format, r.handed) == (kept.stand_in, kept.format, kept.handed);
            let again = again.iter().find(own).unwrap().errors.unwrap();
            assert_eq!([again.rounding, again.total][i], peak);
        }
    }
}

#[test]
fn limits_are_where_the_rows_say() {
    let rows = &study().lobes;
    for limit in limits(rows) {
        let from =
            if limit.stand_in.bell().is_some() && limit.stand_in != StandIn::Cs16 { 16.0 } else { 1.0 };
        let own = rows
            .iter()
            .filter(|r| (r.stand_in, r.format, r.handed) == (limit.stand_in, limit.format, limit.handed));
        let meant: Vec<&LobeRow> = own.filter(|r| r.n >= from).collect();
        for (bound, good_to) in
            [(DISPLAY_STEP, limit.below_display), (limit.approximation, limit.below_approximation)]
        {
            if bound == 0.0 {
                assert!(limit.stand_in.is_exact() && good_to.is_none());
                continue;
            }
            let bad = |r: &&&LobeRow| !r.errors.is_some_and(|e| e.rounding.value <= bound);
            let first_bad = meant.iter().find(bad).map_or(f64::INFINITY, |r| r.n);
            // All below the first bad one are good to, and none from it on.
            let good = meant.iter().filter(|r| r.n < first_bad).map(|r| r.n).fold(f64::NAN, f64::max);
            assert_eq!(good_to, Some(good).filter(|n| !n.is_nan()), "{limit:?}");
        }
    }
}

/// Factors, clip volumes and footprints within what their pages promise.
#[test]
fn the_other_kernels_keep_their_pages() {
    for row in &study().factors {
        let u = row.format.unit_roundoff();
        let Some((error, model, n)) = row.relative else {
            assert!(matches!(row.format, Format::Half | Format::HalfStored) && row.n > 3e4, "{row:?}");
            continue;
        };
        // cs_factor: 10.29 ε = 20.58 u; cos_n_factor: eight roundings and an exp2; cubic_factor from n = 16: 4 ε.
        let allowed = match row.factor {
            Factor::Cs16 => 20.58,
            Factor::CosN => 10.0,
            _ if row.n < 16.0 => continue,
            _ => 8.0,
        };
        let result = if row.format == Format::HalfStored { U } else { 0.0 };
        assert!(error <= 1.01 * allowed * u + result, "{row:?}, {} at {n}", model.id());
    }
    for row in &study().clips {
        let u = row.format.unit_roundoff();
        let allowed = match row.clip {
            Clip::Whole => 2.0 * u,
            Clip::Cut => 8.0 * u,
            // Three roundings of numbers up to 1.2, times d ≤ ½, one of 1 and the coefficients'.
            Clip::Printed => 3.0 * u,
        };
        let result = if row.format == Format::HalfStored { 0.25 * U } else { 0.0 };
        assert!(row.error <= allowed + result, "{row:?}");
    }
    for row in &study().footprints {
        let u = row.format.unit_roundoff();
        if row.form.is_relative() {
            let allowed = if row.form.id() == "inverse" { 12.0 } else { 26.0 };
            assert!(row.error <= allowed * u, "{row:?}");
        } else if row.form.id().starts_with("footprint") && (row.format == Format::Double || row.scale == 1.0)
        {
            // Within the range that its page states. The rounded Jacobian's aspect may be larger by u aspect.
            assert!(row.error <= 16.0 * u * row.aspect * (1.0 + 2.0 * u * row.aspect), "{row:?}");
        }
    }
    assert_eq!((study().factors.len(), study().footprints.len()), (5 * 4 * 37, 5 * 2 * 19 * 9));
}

/// The worst that every f32 was found to be (tests/stability_exhaustive.rs), again; and for the bells by exact
/// rationals.
#[test]
fn the_worst_f32_cases_are_still_the_worst() {
    for (kernel, (name, bits, error)) in worst::kernels().iter().zip(worst::WORST) {
        assert_eq!(kernel.name, name);
        let t = f32::from_bits(bits);
        assert!((0.0..=kernel.end).contains(&t));
        assert_eq!(worst::error(kernel, t), error, "{name} at {t:e}");
        // Neighbours and a coarse sample do no worse.
        let near =
            (bits.saturating_sub(1000)..=bits + 1000).chain((0..=kernel.end.to_bits()).step_by(1_000_003));
        for bits in near.filter(|bits| *bits <= kernel.end.to_bits()) {
            let t = f32::from_bits(bits);
            assert!(worst::error(kernel, t) <= error, "{name} at {t:e}");
        }
        let k: Option<u32> = name.rsplit(' ').next().unwrap().parse().ok();
        let Some(k) = k else { continue };
        let y = exact(f64::from(t)).unwrap() / RBig::from(k);
        let base = if name.starts_with("cubic") {
            let [c1, c2, c3] = CUBIC_EXP[k.trailing_zeros() as usize - 1].map(|c| exact(c).unwrap());
            RBig::int(1) - y.clone() * (c1 - y.clone() * (c2 - y * c3))
        } else {
            RBig::int(1) - y
        };
        let truth = (0..k.ilog2()).fold(base, |power, _| power.clone() * power);
        let gap = exact(f64::from((kernel.single)(t))).unwrap() - truth;
        assert!((gap.to_f64().value().abs() / error - 1.0).abs() < 1e-12, "{name} at {t:e}");
    }
}

/// Angles of the table: inside, rising, with both ends.
#[test]
fn angles_reach_both_ends() {
    for n in [1.0, 1e6, 1e12] {
        let thetas = angles(n);
        assert!(thetas.windows(2).all(|w| w[0] <= w[1]) && thetas.len() > 100);
        assert_eq!((thetas[0], thetas[thetas.len() - 1]), (1e-8, std::f64::consts::FRAC_PI_2));
    }
}
