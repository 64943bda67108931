//! Rounding errors of the lobes that are no bells, against hand counts and against binary32 itself.

use super::super::count::{Count, Rounding, handed, place};
use super::*;
use crate::kernel::power::cos_n_whole;

/// At n = 849214966 the products in binary32 of 1 - 2⁻²⁴ round up more than down, by 4e-4 of the power; a cosine
/// that rounds to it may lie 2⁻²⁵ below, where cosⁿ is e⁻²⁵ of that.
#[test]
fn squarings_that_round_up_stay_inside_the_bound() {
    let n = 849_214_966_u32;
    let cosine = 1.0 - 2.999_999 / 33_554_432.0;
    let computed = f64::from(cos_n_whole(cosine as f32, n));
    let without = libm::exp(f64::from(n) * libm::log1p(-1.0 / 16_777_216.0));
    assert!(cosine as f32 == 1.0 - f32::EPSILON / 2.0 && computed > 1.0003 * without);
    let v = -f64::from(n) * libm::log1p(cosine - 1.0);
    let range = Interval::from(f64::from(n));
    let cell = Cell::new([range.ln(), Interval::from(libm::log1p(v))], range);
    let given = Argument::new(&cell, Format::Single, Handed::Cosine);
    let bound = squarings(&cell, &given, Format::Single);
    assert!(bound.value.hi() < 1e-6 * without && bound.error > computed - bound.value.lo(), "{bound:?}");
}

const FORMATS: [Format; 3] = [Format::Half, Format::Single, Format::Double];

/// A relative error of x + x² ≥ eˣ - 1, x ≤ 1, before a last operation within `ulps` units, of which u is the half.
fn carried(x: f64, ulps: f64, u: f64) -> f64 {
    (x + x * x) * (1.0 + 2.0 * ulps * u) + 2.0 * ulps * u
}

/// ln ĉ - ln c at the most: ĉ ≥ c - δ, and 1/ξ is at most 1/(c - δ) between.
fn moved(c: f64, delta: f64) -> f64 {
    delta / (c - delta)
}

/// Whether `found` is at least `least`, and above it by a share at most.
fn is_about(found: f64, least: f64, share: f64) -> bool {
    found >= least * (1.0 - 1e-12) && found <= least * (1.0 + share) + f64::MIN_POSITIVE
}

/// eˣ - 1 lies below x + x² up to 1, as 1/2! + 1/3! + … = e - 2 < 1, and below eˣ beyond.
#[test]
fn what_an_exponent_grows_by_lies_between_it_and_its_parabola() {
    for x in [0.0, 1e-9, 0.1, 0.5, 1.0, 1.5, 5.0] {
        let (found, most) = (growth(x).hi(), if x <= 1.0 { x + x * x } else { libm::exp(x) });
        assert!(found >= libm::expm1(x) && found <= most * (1.0 + 1e-12) + f64::MIN_POSITIVE, "{x}: {found}");
    }
}

#[test]
fn an_error_is_capped_where_both_numbers_lie_in_a_range() {
    let lost = |lo, hi| Rounded { value: Interval::new(lo, hi), error: f64::INFINITY };
    // 0 to 3/2, and the lobe a quarter up to a half: 5/4 at most; from 1 on it is the lobe itself, 5/4.
    assert!(is_about(capped(lost(0.25, 0.5), 1.5).error, 1.25, 1e-15));
    assert_eq!(capped(lost(1.0, 1.25), 1.5).error, 1.25);
    assert_eq!(capped(Rounded { error: 0.125, ..lost(0.25, 0.5) }, 1.5).error, 0.125);
    // Of e⁻ˣ, within 3 units in the last place: 1 + 6 u at most.
    let (by, u) = (Arithmetic::of(Format::Half), libm::scalbn(1.0, -11));
    let found = |value: f64| exponential(Interval::from(value), f64::INFINITY, by, 3.0).error;
    assert!(is_about(found(0.25), 0.75 + 6.0 * u, 1e-12) && found(0.9) == 0.9);
    // Of next to nothing only units of subnormal numbers are left: three of them and a half.
    let found = exponential(Interval::from(1e-300), 1.0, by, 3.0).error;
    assert!(is_about(found, 7.0 * libm::scalbn(1.0, -25), 1e-12), "{found}");
    let found = exponential(Interval::from(0.5), 0.125, by, 3.0).error;
    // 1/8 + 1/64 stands for e^(1/8) - 1.
    let exact = 0.5 * (0.140_625 * (1.0 + 6.0 * u) + 6.0 * u) + 7.0 * libm::scalbn(1.0, -25);
    assert!(is_about(found, exact, 1e-12), "{found} {exact}");
}

#[test]
fn a_logarithm_moves_by_the_error_over_the_least_cosine() {
    let off = |value: f64, error| Rounded { value: Interval::new(value, 0.75), error };
    let found = logarithm_error(off(0.5, 0.125));
    assert!(is_about(found.hi(), 1.0 / 3.0, 1e-14), "{found:?}");
    assert!([0.5, 0.6].iter().all(|error| logarithm_error(off(0.5, *error)).hi() == f64::INFINITY));
    // Over a box n and v count where they are largest: 1 + 20/3/2.
    let cell = Cell { n: Interval::new(10.0, 20.0), v: Interval::new(1.0, 2.0), ..place(10.0, 0.25) };
    assert!(is_about(slack(&cell, off(0.5, 0.125)).hi(), 1.0 + 10.0 / 3.0, 1e-14));
    let still = Cell { v: Interval::ZERO, ..cell };
    assert_eq!(slack(&still, off(0.5, 0.125)).hi(), f64::INFINITY);
    // The exponent counts where it is least: n, and one unit u or three roundings of it.
    let u = 1.0 / 2048.0;
    let found = least_exponent(&cell, Format::Half);
    assert!((found.lo() - 10.0 * (1.0 - u)).abs() < 1e-13 && found.width() < 1e-13);
    let found = shrunk(&cell, Format::Half, 3.0);
    assert!((found.lo() - 10.0 * (1.0 - u) * (1.0 - 6.0 * u) * (1.0 - u)).abs() < 1e-13, "{found:?}");
    assert!(found.width() < 1e-13);
}

/// Units of ln(1 - ŵ) are relative where ŵ u is no less than the half of the least number, 2⁻²⁵ of binary16.
#[test]
fn underflow_counts_where_the_versine_may_be_subnormal() {
    let (by, u, tiny) = (Arithmetic::of(Format::Half), libm::scalbn(1.0, -11), libm::scalbn(1.0, -25));
    let cell = Cell { n: Interval::new(4.0, 8.0), ..place(8.0, 0.0) };
    let at = |w: f64, error| underflow(&cell, Rounded { value: Interval::new(w, 1.0), error }, by, 3.0);
    let whole = 8.0 * (1.0 + u) * (1.0 + u) * 6.0 * tiny + tiny;
    let join = libm::scalbn(1.0, -14);
    for (w, error) in [(0.0, 0.0), (0.9999 * join, 0.0), (2.0 * join, 1.0001 * join)] {
        let found = at(w, error);
        assert!(is_about(found.hi(), whole, 1e-12) && found.lo() > 0.999 * whole, "{w}: {found:?}");
    }
    assert!([(1.0001 * join, 0.0), (2.0 * join, 0.9999 * join)].iter().all(|&(w, e)| at(w, e).hi() == 0.0));
}

/// c/(c + n w) and c/(n - n c + c) with every operation counted.
#[test]
fn schlicks_lobe_is_off_by_its_operations() {
    for format in FORMATS {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (n, w, way) in [
            (3.0, 0.03, Handed::Versine),
            (27.0, 0.01, Handed::Cosine),
            (50.0, 0.3, Handed::Difference),
            (400.0, 1e-3, Handed::Versine),
        ] {
            let (cell, errors) = (place(n, w), [0.3 * u, 1.7 * u * w]);
            let given = handed(&cell, way, errors);
            let (c, t) = (Count::new(1.0 - w, errors[0]), Count::new(n * w, n * errors[1]));
            let product = Count::exact(1.0).stored(by.relative()).times(t, by);
            let exact = c.over(c.plus(product, by), by, 1.0);
            let found = schlick(&cell, &given, format);
            assert!(exact.is_met(found, 1e-6), "{format:?} {n} {w}: {found:?} {exact:?}");
            let n = Count::exact(n).stored(by);
            let exact = c.over(n.minus(n.times(c, by), by).plus(c, by), by, f64::INFINITY);
            let found = schlick_printed(&cell, &given, format);
            assert!(exact.is_met(found, 1e-6), "{format:?} {w}: {found:?} {exact:?}");
        }
    }
    // Lobe and result lie in [0, 1]: where they may be 3/2 apart by their operations, ½ is left; as printed it is not.
    let cell = place(1.0, 0.5);
    let given = handed(&cell, Handed::Cosine, [0.3, 0.3]);
    assert!((schlick(&cell, &given, Format::Single).error - 0.5).abs() < 1e-12);
    assert!(schlick_printed(&cell, &given, Format::Single).error > 1.4);
}

/// n w counts with three relative errors, of n, w and the product, and the exponential with its own.
#[test]
fn the_gaussian_is_off_by_its_exponent() {
    for format in FORMATS {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (n, w) in [(3.0, 0.03), (27.0, 0.01), (50.0, 0.13)] {
            let cell = place(n, w);
            let given = handed(&cell, Handed::Versine, [0.4, 1.7 * u * w]);
            let t = Count::new(n * w, n * 1.7 * u * w);
            let exponent = Count::exact(1.0).stored(by.relative()).times(t, by).error;
            let value = libm::exp(-n * w);
            // And 7 halves of the least number.
            let exact = Count::new(value, value * carried(exponent, 3.0, u) + 7.0 * by.tiny);
            let found = spherical_gaussian(&cell, &given, format, 3.0);
            assert!(exact.is_met(found, 0.0), "{format:?} {n} {w}: {found:?} {exact:?}");
        }
    }
}

/// n (ln ĉ - ln c), and v off by the roundings of n, of n log c and, where it is rounded by itself, the logarithm.
#[test]
fn powers_are_off_by_their_exponents() {
    let ulps = 3.0;
    // The bound is computed in doubles: 1e-7 of it in binary32, and too much of it in theirs.
    for format in [Format::Half, Format::Single] {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (n, w) in [(3.0, 0.03), (27.0, 0.01), (50.0, 0.13)] {
            let (cell, c, errors) = (place(n, w), 1.0 - w, [1.3 * u, 1.7 * u * w]);
            let (v, value) = (-n * libm::log1p(-w), libm::exp(n * libm::log1p(-w)));
            let hold = |found: Rounded, total: f64, name: &str| {
                let exact = Count::new(value, value * carried(total, ulps, u) + 7.0 * by.tiny);
                assert!(exact.is_met(found, 1e-7), "{format:?} {n} {w} {name}: {found:?} {exact:?}");
            };
            let logs = (1.0 + u) * (1.0 + 2.0 * ulps * u) * (1.0 + u) - 1.0;
            // What errors are relative to is n |ln ĉ|, at most this.
            let size = |delta: f64| v + n * moved(c, delta);
            let found = pow(&cell, &handed(&cell, Handed::Cosine, errors), format, ulps);
            hold(found, n * moved(c, errors[0]) + u * size(errors[0]), "pow");
            let found = pow(&cell, &handed(&cell, Handed::Versine, errors), format, ulps);
            hold(found, n * moved(c, errors[1]) + logs * size(errors[1]), "from the versine");
            let found = exp2_log2(&cell, &handed(&cell, Handed::Versine, errors), format, ulps);
            hold(found, n * moved(c, errors[0]) + logs * size(errors[0]), "exp2");
        }
    }
    // At a versine of 0 that may be subnormal, units of the logarithm are absolute: n times six, and one.
    let (cell, tiny) = (place(64.0, 0.0), libm::scalbn(1.0, -25));
    let cell = Cell { v: Interval::from(libm::scalbn(1.0, -60)), ..cell };
    let found = pow(&cell, &handed(&cell, Handed::Versine, [0.0, 0.0]), Format::Half, ulps);
    let u = 1.0 / 2048.0;
    let lost = 64.0 * (1.0 + u) * (1.0 + u) * 6.0 * tiny + tiny;
    let exact = carried(lost, ulps, u) + 7.0 * tiny;
    assert!(is_about(found.error, exact, 1e-7), "{} {exact}", found.error);
}

/// Where ĉ may be 0, neither number is above what (c + δ)ⁿ may come out as.
#[test]
fn where_the_cosine_may_vanish_a_power_is_bounded_by_its_hull() {
    let (u, tiny) = (libm::scalbn(1.0, -24), libm::scalbn(1.0, -150));
    let cell = place(2.0, 1.0 - 1.0 / 1024.0);
    let given = handed(&cell, Handed::Cosine, [3.0 / 1024.0, 3.0 / 1024.0]);
    let top = libm::pow(1.0 / 256.0, 2.0);
    for (found, shrink, own) in [
        // The base is 2⁻⁸, to the power 2 (1 - u), or 2 (1 - u)² (1 - 6 u).
        (pow(&cell, &given, Format::Single, 3.0), u, 6.0 * u),
        (exp2_log2(&cell, &given, Format::Single, 3.0), 8.0 * u, 6.0 * u),
        // Both of its roundings may go up.
        (squarings(&cell, &given, Format::Single), 0.0, u),
    ] {
        let exact = top * libm::exp(shrink * 16.0 * core::f64::consts::LN_2) * (1.0 + own);
        assert!((found.error / exact - 1.0).abs() < 0.1 * u, "{} {exact}", found.error);
    }
    // Between 0 and 1 a lobe of 9/16 is off by no more than itself.
    let cell = place(2.0, 0.25);
    let found = pow(&cell, &handed(&cell, Handed::Cosine, [0.8, 0.0]), Format::Single, 3.0);
    assert!(is_about(found.error, 0.5625, 1e-14), "{found:?}");
    // Of nothing but units of subnormal numbers three and a half are left, beside (2⁻²⁰)² and six roundings.
    let gone = Cell { cosine: Interval::ZERO, v: Interval::from(700.0), ..cell };
    let given = handed(&gone, Handed::Cosine, [libm::scalbn(1.0, -20), 0.0]);
    let found = pow(&gone, &given, Format::Half, 3.0);
    assert!(is_about(found.error, libm::scalbn(1.0, -40) + 7.0 * libm::scalbn(1.0, -25), 1e-6), "{found:?}");
    // The lobe itself, where what is computed is less.
    let cell = Cell { cosine: Interval::from(0.0), v: Interval::from(0.5), ..cell };
    let given = handed(&cell, Handed::Cosine, [tiny, 0.0]);
    let found = pow(&cell, &given, Format::Single, 3.0);
    assert!(is_about(found.error, libm::exp(-0.5), 1e-14), "{found:?}");
}

/// n - 1 products of relative error u, or u/2 of 1 over the least of them; and 64 halves of the least number.
#[test]
fn squarings_are_off_by_a_rounding_a_factor() {
    for format in FORMATS {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (n, w) in [(1.0, 0.2), (2.0, 0.1), (37.0, 0.005), (37.0, 0.05)] {
            let (cell, c, delta) = (place(n, w), 1.0 - w, 1.3 * u);
            let (v, value) = (-n * libm::log1p(-w), libm::exp(n * libm::log1p(-w)));
            let least = v + n * (moved(c, delta) + u * (1.0 + u));
            let each = u * (0.5 * libm::exp(least)).min(1.0);
            let total = n * moved(c, delta) + (n - 1.0) * each / (1.0 - each);
            let exact = Count::new(value, value * carried(total, 0.0, u) + 65.0 * by.tiny);
            let found = squarings(&cell, &handed(&cell, Handed::Cosine, [delta, 0.4]), format);
            assert!(exact.is_met(found, 0.0), "{format:?} {n} {w}: {found:?} {exact:?}");
        }
    }
    // Over a box the exponent of the hull is the least, the count of products the largest.
    let cell = Cell { n: Interval::new(2.0, 3.0), ..place(2.0, 1.0 - 1.0 / 1024.0) };
    let given = handed(&cell, Handed::Cosine, [3.0 / 1024.0, 0.0]);
    let found = squarings(&cell, &given, Format::Single).error;
    let exact = libm::scalbn(1.0, -16) * (1.0 + 2.0 * libm::scalbn(1.0, -24));
    assert!(is_about(found, exact, 1e-9), "{found} {exact}");
}

/// binary16 ends at 65504; n c + n of the printed form at half of it.
#[test]
fn an_exponent_that_the_format_lacks_has_no_bound() {
    type Lobe<'a> = &'a dyn Fn(&Cell, &Argument) -> Rounded;
    let error = |n: f64, lobe: Lobe| {
        let cell = place(n, 1e-5);
        let found = lobe(&cell, &handed(&cell, Handed::Cosine, [1e-9, 1e-9]));
        // The lobe itself is known: between e^(-n w) and 1/(1 + n w).
        let t = n * 1e-5;
        assert!(
            found.value.lo() > 0.999 * libm::exp(-t) && found.value.hi() < 1.001 / (1.0 + t),
            "{found:?}"
        );
        found.error
    };
    let half = Format::Half;
    let lobes: [(f64, Lobe); 5] = [
        (65504.0, &|cell, given| schlick(cell, given, half)),
        (65504.0, &|cell, given| spherical_gaussian(cell, given, half, 1.0)),
        (65504.0, &|cell, given| pow(cell, given, half, 1.0)),
        (65504.0, &|cell, given| exp2_log2(cell, given, half, 1.0)),
        (32752.0, &|cell, given| schlick_printed(cell, given, half)),
    ];
    for (i, (last, lobe)) in lobes.into_iter().enumerate() {
        let within = error(if i == 4 { 1000.0 } else { last }, lobe);
        assert!(within.is_finite() && error(last + 0.5, lobe) == f64::INFINITY, "{i}: {within}");
    }
}
