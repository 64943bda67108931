//! The certified bounds of rounding errors contain every error that is measured, and are not far above them.
//!
//! Errors in `f64` are measured against tests/references/rounding.csv (mpmath); in `f32` and binary16 against
//! formulas in `f64`, whose own error of about 1e-14 is nothing beside 6e-8 and 5e-4.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::bound::{Format, Handed, Measure, assumes_elementary, rounding, rounding_with};
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::prepared::Prepared;
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::StandIn;
use bellfit::kernel::vector::versine_between;
use bellfit::stability::Half;
use draw::Draw;
use std::collections::BTreeMap;

const FLOOR: f64 = 1.0 / 256.0;

/// The kernel with the constants of n from `f64`, in the type F.
fn kernel<F: Real>(stand_in: StandIn, x: F, n: f64, handed: Handed) -> F {
    Prepared::new(stand_in, n).of(handed.argument(), x)
}

/// The stand-in in double precision, from the versine.
fn exactly(stand_in: StandIn, n: f64, w: f64) -> f64 {
    if let Some(formula) = stand_in.formula() {
        let row = |[a, b, c]: [f64; 3]| a + b / n + c / (n * n);
        let y = n * w / row(formula.reach);
        let base = (1.0 - y) * (1.0 + y * (row(formula.linear) + y * row(formula.square)));
        return libm::pow(base.max(0.0), f64::from(formula.power));
    }
    match stand_in {
        StandIn::Schlick | StandIn::SchlickPrinted => (1.0 - w) / (1.0 - w + n * w),
        StandIn::SphericalGaussian => libm::exp(-n * w),
        _ if w >= 1.0 => 0.0,
        _ => libm::exp(n * libm::log1p(-w)),
    }
}

/// To binary16, ties to even, subnormal numbers kept.
fn half(x: f64) -> f64 {
    let (_, exponent) = libm::frexp(x);
    let unit = libm::scalbn(1.0, (exponent - 11).max(-24));
    // Exact but for the rounding to whole numbers.
    libm::rint(x / unit) * unit
}

fn to_type<F: Real>(x: f64, stored: bool) -> F {
    F::from_f64(if stored { half(x) } else { x })
}

/// Two unit vectors at the versine w, as doubles.
fn vectors(draw: &mut Draw, w: f64) -> [[f64; 3]; 2] {
    let ball = |draw: &mut Draw| loop {
        let v: [f64; 3] = core::array::from_fn(|_| draw.real(-1.0, 1.0));
        let square: f64 = v.iter().map(|x| x * x).sum();
        if square > 0.01 && square < 1.0 {
            return v.map(|x| x / libm::sqrt(square));
        }
    };
    let (a, e) = (ball(draw), ball(draw));
    let along: f64 = (0..3).map(|i| a[i] * e[i]).sum();
    let e: [f64; 3] = core::array::from_fn(|i| e[i] - along * a[i]);
    let length = libm::sqrt(e.iter().map(|x| x * x).sum());
    let sine = libm::sqrt(w * (2.0 - w));
    [a, core::array::from_fn(|i| a[i] + (sine * e[i] / length - w * a[i]))]
}

/// The kernel's error at n and w, in a type that is coarser than double.
fn measured<F: Real>(
    stand_in: StandIn,
    stored: bool,
    handed: Handed,
    n: f64,
    w: f64,
    draw: &mut Draw,
) -> f64 {
    let argument = match handed {
        Handed::Cosine => to_type::<F>(1.0 - w, stored),
        Handed::Versine => to_type::<F>(w, stored),
        Handed::Difference => {
            let [a, b] = vectors(draw, w).map(|v| v.map(|x| to_type::<F>(x, stored)));
            versine_between(a, b)
        }
    };
    let value = kernel(stand_in, argument, n, handed).to_f64();
    let value = if stored { half(value) } else { value };
    (value - exactly(stand_in, n, w)).abs()
}

/// What doubles themselves may be off by in [`measured`]: a rounded 1 - w or vectors move t = n w.
fn slack(handed: Handed, n: f64) -> f64 {
    match handed {
        Handed::Cosine => 1e-13 + 3e-16 * n,
        Handed::Versine => 1e-13,
        Handed::Difference => 1e-13 + 1e-14 * libm::sqrt(n),
    }
}

/// An n of the range and a w of the lobe's support, of what lies beyond or near 0, or at the edge.
fn place(draw: &mut Draw, stand_in: StandIn, (from, to): (f64, f64)) -> (f64, f64) {
    let n = (from * libm::pow(to / from, draw.real(0.0, 1.0))).clamp(from, to);
    let n = if stand_in == StandIn::Squarings { libm::floor(n) } else { n };
    let t = match draw.below(8) {
        0 => libm::pow(10.0, draw.real(-9.0, 1.0)),
        1 => n * draw.real(0.0, 1.0),
        2 => n,
        3 => draw.real(0.0, 20.0),
        _ => draw.real(0.0, 4.0),
    };
    (n, (t / n).min(1.0))
}

const RANGES: [(f64, f64); 5] = [(16.0, 1024.0), (1.0, 40.0), (64.0, 64.0), (1e3, 1e6), (1.0, 1e12)];

#[test]
fn errors_in_single_and_stored_half_precision_stay_inside_the_bound() {
    let mut draw = Draw(0x0b0e);
    let mut bounds = 0;
    for stand_in in StandIn::ALL {
        for format in [Format::Single, Format::HalfStored] {
            for handed in Handed::ALL {
                for n in RANGES {
                    let bound = |measure| rounding(stand_in, format, handed, n, measure);
                    let (absolute, relative) =
                        (bound(Measure::Absolute), bound(Measure::Relative { floor: FLOOR }));
                    for _ in 0..400 {
                        let (n, w) = place(&mut draw, stand_in, n);
                        let stored = format == Format::HalfStored;
                        let error = measured::<f32>(stand_in, stored, handed, n, w, &mut draw);
                        let free = slack(handed, n);
                        let name = || format!("{} {} {}", stand_in.id(), format.id(), handed.id());
                        if let Some(bound) = &absolute {
                            let most = bound.value.hi() + free;
                            assert!(error <= most, "{}: n {n}, w {w}: {error:e} > {most:e}", name());
                        }
                        let target = exactly(StandIn::Power, n, w);
                        if let (Some(bound), true) = (&relative, target >= FLOOR * 1.001) {
                            let most = bound.value.hi() + free / target;
                            let error = error / target;
                            assert!(error <= most, "{}: n {n}, w {w}: {error:e} > {most:e}", name());
                        }
                    }
                    bounds += usize::from(absolute.is_some()) + usize::from(relative.is_some());
                }
            }
        }
    }
    // 15 × 2 × 3 × 5 × 2 of them but for the cases that the page of `rounding` names.
    assert!(bounds >= 780, "{bounds}");
}

/// p(t)^K from the versine and c/(c + n w), each step rounded to binary16.
fn in_half(stand_in: StandIn, n: f64, cosine: Option<f64>, w: f64) -> Option<f64> {
    let r = half;
    let power = |p: f64, k: u32| (0..k.trailing_zeros()).fold(p.max(0.0), |p, _| r(p * p));
    // The constants in double precision, as a material has them.
    if let Some(formula) = stand_in.formula() {
        let m = 1.0 / n;
        let row = |[a, b, c]: [f64; 3]| a + m * (b + m * c);
        let [reach, alpha, beta] = [formula.reach, formula.linear, formula.square].map(row);
        let s = n / reach;
        if formula.linear == [0.0; 3] {
            return Some(match cosine {
                Some(c) => power(r(r(1.0 - s) + r(r(s) * c)), formula.power),
                None if w > 1.0 => 0.0,
                None => power(r(1.0 - r(r(s) * w)), formula.power),
            });
        }
        if cosine.is_some() && formula.power <= 4 {
            return None;
        }
        let w = cosine.map_or(w, |c| r(1.0 - c));
        let [k1, k2, k3] = [(1.0 - alpha) * s, (beta - alpha) * s * s, beta * s * s * s].map(r);
        if w > 1.0 {
            return Some(0.0);
        }
        return Some(power(r(1.0 - r(w * r(k1 - r(w * r(k2 - r(w * k3)))))), formula.power));
    }
    let (c, w) = (cosine.unwrap_or(r(1.0 - w)), cosine.map_or(w, |c| r(1.0 - c)));
    match stand_in {
        StandIn::Schlick if c <= 0.0 => Some(0.0),
        StandIn::Schlick => Some(r(c / r(c + r(r(n) * w)))),
        StandIn::Squarings => {
            let whole = n as u32;
            let bits = (0..whole.ilog2()).rev();
            let base = c.max(0.0);
            Some(bits.fold(base, |p, bit| {
                let square = r(p * p);
                if (whole >> bit) & 1 == 1 { r(square * base) } else { square }
            }))
        }
        _ => None,
    }
}

/// A result of two 11-bit numbers fits double precision twice over: rounding it there first changes nothing.
#[test]
fn errors_in_half_precision_stay_inside_the_bound_and_come_near_it() {
    let mut draw = Draw(0x0f16);
    let mut checked = 0;
    for stand_in in StandIn::ALL {
        for handed in Handed::ALL {
            for range in [(16.0, 60.0), (1.0, 12.0), (64.0, 64.0), (100.0, 1000.0)] {
                let Some(bound) = rounding(stand_in, Format::Half, handed, range, Measure::Absolute) else {
                    continue;
                };
                let mut worst = 0.0_f64;
                for _ in 0..3000 {
                    let (n, w) = place(&mut draw, stand_in, range);
                    let computed = match handed {
                        Handed::Cosine => in_half(stand_in, n, Some(half(1.0 - w)), w),
                        Handed::Versine => in_half(stand_in, n, None, half(w)),
                        Handed::Difference => {
                            let [a, b] = vectors(&mut draw, w).map(|v| v.map(half));
                            let gap: [f64; 3] = core::array::from_fn(|i| half(a[i] - b[i]));
                            let square = gap.map(|x| half(x * x));
                            let versine = half(0.5 * half(half(square[0] + square[1]) + square[2]));
                            in_half(stand_in, n, None, versine)
                        }
                    };
                    let Some(computed) = computed else { break };
                    let error = (computed - exactly(stand_in, n, w)).abs();
                    let most = bound.value.hi() + slack(handed, n);
                    let name = || format!("{} {} {range:?}", stand_in.id(), handed.id());
                    assert!(error <= most, "{}: n {n}, w {w}: {error:e} > {most:e}", name());
                    worst = worst.max(error);
                    checked += 1;
                }
                // Sixteenth powers of sums that may all round one way: draws stay an order below the worst.
                let share = worst / bound.value.hi();
                let one_sided = handed == Handed::Difference && range.0 < 16.0; // the edge: θ = π/2 exactly
                assert!(
                    worst == 0.0 || one_sided || share > 0.08,
                    "{} {}: {share}",
                    stand_in.id(),
                    handed.id()
                );
            }
        }
    }
    assert!(checked > 200_000, "{checked}");
}

/// At one n, where the error is largest over θ: bounds are of worst cases, draws are not.
#[test]
fn bounds_are_a_few_times_what_is_measured() {
    let mut draw = Draw(0xfac7);
    let mut far = BTreeMap::new();
    for stand_in in StandIn::ALL {
        for handed in Handed::ALL {
            for n in [20.0, 100.0, 777.0, 4000.0] {
                let Some(bound) = rounding(stand_in, Format::Single, handed, (n, n), Measure::Absolute)
                else {
                    continue;
                };
                let mut worst = 0.0_f64;
                for k in 0..20_000 {
                    let t = if k % 2 == 0 { draw.real(0.0, 3.0) } else { draw.real(0.0, 0.1) };
                    worst = worst.max(measured::<f32>(stand_in, false, handed, n, t / n, &mut draw));
                }
                let factor = bound.value.hi() / worst;
                if factor > 4.0 {
                    far.insert(format!("{} {} {n}", stand_in.id(), handed.id()), factor);
                }
            }
        }
    }
    assert!(far.is_empty(), "{far:?}");
}

#[test]
fn errors_in_double_precision_stay_inside_the_bound() {
    let path = format!("{}/tests/references/rounding.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(path).unwrap();
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let rows: Vec<BTreeMap<String, f64>> = reader
        .records()
        .map(|row| {
            let row = row.unwrap();
            header.iter().cloned().zip(row.iter().map(|x| x.parse().unwrap())).collect()
        })
        .collect();
    assert!(rows.len() > 300);
    let (mut compared, mut near) = (0, 0);
    for stand_in in StandIn::ALL {
        for handed in Handed::ALL {
            let mut bounds: BTreeMap<u64, Option<f64>> = BTreeMap::new();
            for row in &rows {
                let n = row["n"];
                if stand_in == StandIn::Squarings && (n.fract() != 0.0 || n > 4e9) {
                    continue;
                }
                let argument = match handed {
                    Handed::Cosine => row["cosine"],
                    Handed::Versine => row["versine"],
                    Handed::Difference => {
                        let side = |s: &str| core::array::from_fn(|i| row[&format!("{s}{i}")]);
                        versine_between(side("a"), side("b"))
                    }
                };
                let column = match stand_in {
                    StandIn::SchlickPrinted => "schlick",
                    other if other.is_exact() => "pow",
                    other => other.id(),
                };
                let computed = kernel::<f64>(stand_in, argument, n, handed);
                let error = ((computed - row[&format!("{column}:hi")]) - row[&format!("{column}:lo")]).abs();
                let bound = bounds.entry(n.to_bits()).or_insert_with(|| {
                    let found = rounding(stand_in, Format::Double, handed, (n, n), Measure::Absolute);
                    found.map(|found| found.value.hi())
                });
                let Some(bound) = *bound else { continue };
                assert!(
                    error <= bound,
                    "{} {}: n {n}, w {}: {error:e} > {bound:e}",
                    stand_in.id(),
                    handed.id(),
                    row["versine"]
                );
                compared += 1;
                near += usize::from(error > 0.05 * bound);
            }
        }
    }
    // A bound that hardly any error comes near would be none.
    assert!(compared > 10_000 && near > compared / 20, "{near} of {compared}");
}

/// A logarithm that is a unit in the last place off and rounded: of subnormal versines that is no relative error.
#[test]
fn a_logarithm_off_by_units_of_subnormal_numbers_is_covered() {
    let n = 60_000.0; // a binary16 number
    let bound =
        rounding_with(StandIn::Power, Format::Half, Handed::Versine, (n, n), Measure::Absolute, 2.0).unwrap();
    let mut worst = 0.0_f64;
    for bits in 1..1024_u16 {
        let log = Real::log1p(-Half::from_bits(bits)).to_bits();
        for log in [log - 1, log + 1].map(Half::from_bits) {
            let value = Real::exp(Half::from_f64(n) * log).to_f64();
            // The ends of what rounds to this versine.
            for shift in [-0.499, 0.499] {
                let w = libm::scalbn(f64::from(bits) + shift, -24);
                worst = worst.max((value - exactly(StandIn::Power, n, w)).abs());
            }
        }
    }
    // n 2⁻²⁴ for the logarithm and half of it for the versine, of values near 1.
    assert!(worst > 1.4 * n * libm::exp2(-24.0) && worst <= bound.value.hi(), "{worst:e} {bound:?}");
}

#[test]
fn fused_code_is_covered() {
    // a + b c as one operation rounds once; the bound counts two.
    let mut draw = Draw(0xf05ed);
    let n = (16.0, 1024.0);
    let bound = rounding(StandIn::Linear16, Format::Single, Handed::Cosine, n, Measure::Absolute).unwrap();
    for _ in 0..20_000 {
        let (n, w) = place(&mut draw, StandIn::Linear16, n);
        let [offset, slope] = LinearLobe::<16, f64>::new(n).convert::<f32>().constants();
        let mut p = libm::fmaf(slope, (1.0 - w) as f32, offset).max(0.0);
        for _ in 0..4 {
            p *= p;
        }
        let error = (f64::from(p) - exactly(StandIn::Linear16, n, w)).abs();
        assert!(error <= bound.value.hi() + slack(Handed::Cosine, n), "{n} {w}: {error:e}");
    }
}

#[test]
fn a_wider_range_and_a_coarser_elementary_function_never_lower_the_bound() {
    // The search stops at 3 % above the largest bound it has seen.
    let stop = 1.03 + 1e-9;
    for stand_in in StandIn::ALL {
        for handed in Handed::ALL {
            let bound = |n, ulps| {
                rounding_with(stand_in, Format::Single, handed, n, Measure::Absolute, ulps)
                    .map_or(f64::INFINITY, |bound| bound.value.hi())
            };
            let (one, wide) = (bound((50.0, 50.0), 1.0), bound((20.0, 200.0), 1.0));
            assert!(one <= wide * stop, "{} {}: {one:e} {wide:e}", stand_in.id(), handed.id());
            let coarse = bound((50.0, 50.0), 8.0);
            assert!(one <= coarse * stop);
            // Only what calls an elementary function depends on it.
            assert!(assumes_elementary(stand_in) || coarse == one, "{}", stand_in.id());
        }
    }
}

#[test]
fn what_has_no_bound_is_told() {
    let bound = |stand_in, format, handed, n| rounding(stand_in, format, handed, n, Measure::Absolute);
    let (nan, infinity) = (f64::NAN, f64::INFINITY);
    for n in [(0.5, 2.0), (2.0, 1.0), (nan, 1.0), (1.0, nan), (1.0, 2e12), (1.0, infinity), (-1.0, 4.0)] {
        assert_eq!(bound(StandIn::Cs16, Format::Single, Handed::Cosine, n), None, "{n:?}");
    }
    for floor in [0.0, 1.0, -1.0, nan] {
        let measure = Measure::Relative { floor };
        assert_eq!(rounding(StandIn::Cs16, Format::Single, Handed::Cosine, (16.0, 32.0), measure), None);
    }
    // k₃ = β (n/T)³ is beyond 65504 from n = 200 or so; n/T is not.
    assert_eq!(bound(StandIn::Cubic2, Format::Half, Handed::Versine, (16.0, 1024.0)), None);
    assert!(bound(StandIn::Linear2, Format::Half, Handed::Versine, (16.0, 1024.0)).is_some());
    assert_eq!(bound(StandIn::Power, Format::Half, Handed::Cosine, (16.0, 70_000.0)), None);
    // β = 0 at n = 6.9: u³ + c u + d does not exist; from the versine there is no need of it.
    assert_eq!(bound(StandIn::Cubic4, Format::Single, Handed::Cosine, (4.0, 16.0)), None);
    assert!(bound(StandIn::Cubic4, Format::Single, Handed::Versine, (4.0, 16.0)).is_some());
    assert_eq!(bound(StandIn::SchlickPrinted, Format::Single, Handed::Cosine, (1.0, 1e9)), None);
    assert_eq!(bound(StandIn::Squarings, Format::Single, Handed::Cosine, (16.25, 16.75)), None);
    assert_eq!(bound(StandIn::Squarings, Format::Single, Handed::Cosine, (1e10, 1e11)), None);
}
