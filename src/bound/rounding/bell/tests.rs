//! Rounding errors of the bells, operation by operation in plain doubles.

use super::super::count::{Count, Rounding, handed, place};
use super::*;

/// (8 + δ)^⅓ - 2 is δ/12 to first order; a unit in the last place of 2 is 4.4e-16.
#[test]
fn a_cube_root_hands_the_error_on() {
    let of = |value: f64, error| cube_root(Rounded { value: Interval::from(value), error });
    let exact = of(8.0, 0.0).unwrap();
    assert!(exact.value.contains(2.0) && exact.value.width() < 1e-14);
    assert!(exact.error >= 4.4e-16 && exact.error < 4.5e-16, "{}", exact.error);
    let off = of(8.0, 1e-6).unwrap().error;
    let least = libm::cbrt(8.0 + 1e-6) - 2.0;
    assert!(off >= least && off < 1.001 * least, "{off} for {least}");
    let negative = of(-27.0, 0.0).unwrap();
    assert!(negative.value.contains(-3.0) && negative.value.width() < 1e-14);
    assert!(of(0.0, 0.0).is_none() && of(1.0, 1.0).is_none() && of(1.0, 2.0).is_none());
    assert!(of(1.0, 0.999).is_some());
}

#[test]
fn a_degree_vanishes_where_its_coefficient_has_a_zero() {
    let vanishes = |square, m| {
        let formula = BellFormula { power: 4, reach: [8.0, 0.0, 0.0], linear: [0.0; 3], square };
        degree_may_vanish(&formula, m)
    };
    let m = Interval::new(0.0, 1.0);
    // (m - ½)² with 0.01 more, and with 0.0001 less: two zeros.
    assert!(!vanishes([0.26, -1.0, 1.0], m) && vanishes([0.2499, -1.0, 1.0], m));
    // A zero at an end, inside and outside.
    assert!(vanishes([-1.0, 1.0, 0.0], m) && vanishes([-0.3, 1.0, 0.0], m));
    assert!(!vanishes([-1.1, 1.0, 0.0], m) && !vanishes([0.1, 1.0, 0.0], m));
    assert!(!vanishes([-0.3, 1.0, 0.0], Interval::new(0.5, 1.0)));
}

const ANY: f64 = f64::INFINITY;

const CUBIC: BellFormula =
    BellFormula { power: 4, reach: [7.5, -3.0, 2.0], linear: [-1.1, 0.9, 0.5], square: [1.2, -0.7, 0.6] };

/// A row c₀ + c₁ m + c₂ m², in doubles whose errors are relative.
fn row([a, b, c]: [f64; 3], n: f64, by: Rounding) -> Count {
    if b == 0.0 && c == 0.0 {
        return Count::exact(a);
    }
    let m = Count::exact(1.0 / n).stored(by);
    Count::exact(a).plus(m.times(Count::exact(b).plus(m.times(Count::exact(c), by), by), by), by)
}

/// What depends on n alone is computed in doubles and rounded to the format, except where that is double.
fn material(x: Count, n_power: f64, format: Format, relative: bool) -> Count {
    let x = Count::new(x.value * n_power, x.error * n_power);
    let by = Rounding::of(format);
    if format == Format::Double { x } else { x.stored(if relative { by.relative() } else { by }) }
}

fn doubles() -> Rounding {
    Rounding::of(Format::Double).relative()
}

/// k₁, k₂, k₃ over n, n², n³, from 1/T, α and β.
fn horner_constants(formula: &BellFormula, n: f64) -> [Count; 3] {
    let by = doubles();
    let [reach, linear, square] = [formula.reach, formula.linear, formula.square].map(|c| row(c, n, by));
    let r = Count::exact(1.0).over(reach, by, ANY);
    let k2 = square.minus(linear, by).times(r, by).times(r, by);
    [Count::exact(1.0).minus(linear, by).times(r, by), k2, square.times(r, by).times(r, by).times(r, by)]
}

fn squarings(base: Count, power: u32, most: f64, by: Rounding) -> Count {
    let positive = Count::new(base.value.max(0.0), base.error.min((base.value + base.error).max(0.0)));
    (0..power.ilog2()).fold(positive, |p, _| p.squared(by, most))
}

/// (1 - s w)^K and (1 - s + s cos θ)^K, s = n/T.
#[test]
fn straight_bells_are_off_by_their_operations() {
    for format in [Format::Half, Format::Single, Format::Double] {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (power, reach) in [(2, [5.3, 0.0, 0.0]), (8, [9.0, -2.0, 3.0]), (16, [16.0, 0.0, 0.0])] {
            let formula = BellFormula { power, reach, linear: [0.0; 3], square: [0.0; 3] };
            // In the middle, near the top, and behind the zero.
            for (n, w) in [(19.0, 0.11), (700.0, 3e-4), (40.0, 0.9)] {
                let (cell, errors) = (place(n, w), [0.7 * u, 1.3 * u * w]);
                let r = Count::exact(1.0).over(row(reach, n, doubles()), doubles(), ANY);
                let t = Count::new(n * w, n * errors[1]);
                let product = material(r, 1.0, format, true).times(t, by);
                let base = Count::new(1.0 - product.value, product.error).rounded(by, 1.0);
                let exact = squarings(base, power, 1.0, by);
                let found = bell(&formula, &cell, &handed(&cell, Handed::Versine, errors), format);
                assert!(exact.is_met(found, 1e-6), "{format:?} {power} {n} {w}: {found:?} {exact:?}");

                let slope = material(r, n, Format::Double, true);
                let offset = Count::exact(1.0).minus(slope, Rounding::of(Format::Double));
                let [slope, offset] = [slope, offset].map(|x| material(x, 1.0, format, false));
                let c = Count::new(1.0 - w, errors[0]);
                let exact = squarings(offset.plus(slope.times(c, by), by), power, ANY, by);
                let found = bell(&formula, &cell, &handed(&cell, Handed::Cosine, errors), format);
                assert!(exact.is_met(found, 1e-6), "{format:?} {power} {n} {w}: {found:?} {exact:?}");
            }
        }
    }
}

/// 1 - w (k₁ - w (k₂ - w k₃)), with n from 1 - cos θ for K = 8; from w it is computed at most 1 where the bracket is
/// not negative.
#[test]
fn cubic_bells_are_off_by_their_operations() {
    let rising = BellFormula { linear: [1.3, 0.0, 0.0], ..CUBIC };
    let back = BellFormula { reach: [8.0, 0.0, 0.0], square: [0.0; 3], ..rising };
    for format in [Format::Half, Format::Single, Format::Double] {
        let (by, u) = (Rounding::of(format), Arithmetic::of(format).unit);
        for (formula, way) in [
            (CUBIC, Handed::Versine),
            (BellFormula { power: 8, ..CUBIC }, Handed::Cosine),
            (BellFormula { linear: [-1.1, 0.0, 0.0], ..CUBIC }, Handed::Difference),
            (BellFormula { square: [0.0; 3], ..CUBIC }, Handed::Versine),
            (rising, Handed::Versine),
            (back, Handed::Versine),
        ] {
            // And where p of the last comes back to 1: whether the bracket is negative is then rounding's matter.
            for (n, w) in
                [(19.0, 0.11), (35.0, 3e-3), (33.0, 0.4), (19.0, 8.0 / 19.0 * 0.3 / 1.3 * (1.0 + 1e-9))]
            {
                let (cell, errors) = (place(n, w), [0.7 * u, 1.3 * u * w]);
                let [k1, k2, k3] = horner_constants(&formula, n).map(|k| material(k, 1.0, format, true));
                let (t, relative) = (Count::new(n * w, n * errors[1]), by.relative());
                let inner = k2.minus(t.times(k3, relative), relative);
                let outer = k1.minus(t.times(inner, relative), relative);
                let subtracted = t.times(outer, by);
                let most = if outer.value >= outer.error { 1.0 } else { ANY };
                let base = Count::new(1.0 - subtracted.value, subtracted.error).rounded(by, most);
                let exact = squarings(base, formula.power, most, by);
                let found = bell(&formula, &cell, &handed(&cell, way, errors), format);
                assert!(exact.is_met(found, 1e-6), "{format:?} {way:?} {n} {w}: {found:?} {exact:?}");
            }
        }
    }
}

/// (u² + c) u + d, u = a + b cos θ, with s³ = k₃, u₀ = k₂/(3 s²), c = k₁/s - 3 u₀², d = 1 - u₀ (u₀² + c), a = u₀ - s.
#[test]
fn depressed_bells_are_off_by_their_operations() {
    for format in [Format::Half, Format::Single, Format::Double] {
        let (by, u, plain) =
            (Rounding::of(format), Arithmetic::of(format).unit, Rounding::of(Format::Double));
        for formula in [CUBIC, BellFormula { power: 2, square: [-0.4, 0.3, 0.0], ..CUBIC }] {
            for (n, w) in [(19.0, 0.11), (35.0, 3e-3), (33.0, 0.3)] {
                let (cell, errors) = (place(n, w), [0.7 * u, 1.3 * u * w]);
                let [k1, k2, k3] = horner_constants(&formula, n);
                // The root's own unit in the last place, and a third of what k₃ is off by.
                let size = k3.value.abs();
                let (lost, unit) = (k3.error / (3.0 * (size - k3.error)), 2.0 * plain.unit);
                let root = libm::cbrt(k3.value);
                let s = Count::new(root, root.abs() * (lost + unit * (1.0 + lost)));
                let (three, one) = (Count::exact(3.0), Count::exact(1.0));
                let u0 = k2.over(three.times(s, doubles()).times(s, doubles()), plain, ANY);
                let c = k1.over(s, plain, ANY).minus(three.times(u0, plain).times(u0, plain), plain);
                let d = one.minus(u0.times(u0.squared(plain, ANY).plus(c, plain), plain), plain);
                let b = Count::new(n * s.value, n * s.error);
                let a = u0.minus(b, plain);
                let [a, b, c, d] = [a, b, c, d].map(|x| material(x, 1.0, format, false));
                let at = a.plus(b.times(Count::new(1.0 - w, errors[0]), by), by);
                let base = at.squared(by, ANY).plus(c, by).times(at, by).plus(d, by);
                let exact = squarings(base, formula.power, ANY, by);
                let found = bell(&formula, &cell, &handed(&cell, Handed::Cosine, errors), format);
                // Squares of enclosures are wider than the enclosures of squares by rounding.
                assert!(exact.is_met(found, 1e-6), "{format:?} {n} {w}: {found:?} {exact:?}");
            }
        }
    }
}

/// Constants beyond 65504 in binary16: the slope n/T, its sum with the offset, k₃ n³, and a where k₃ may be 0.
#[test]
fn constants_beyond_the_format_leave_no_bound() {
    let error = |formula: &BellFormula, n: f64, way| {
        let cell = place(n, 1e-5);
        bell(formula, &cell, &handed(&cell, way, [1e-9, 1e-9]), Format::Half).error
    };
    let straight = BellFormula { power: 2, reach: [2.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
    assert!(error(&straight, 131_000.0, Handed::Versine).is_finite());
    assert_eq!(error(&straight, 131_016.0, Handed::Versine), ANY);
    // Slope and offset together, s + s - 1.
    assert!(error(&straight, 65_500.0, Handed::Cosine).is_finite());
    assert_eq!(error(&straight, 65_512.0, Handed::Cosine), ANY);
    // k₃ alone counts: (n/4)³, with k₁ = n/4 and k₂ = (n/4)².
    let cubic = BellFormula { power: 2, reach: [4.0, 0.0, 0.0], linear: [0.0; 3], square: [1.0, 0.0, 0.0] };
    // x + x² + x³ = 65504 at x = 39.97.
    assert!(error(&cubic, 4.0 * 39.9, Handed::Versine).is_finite());
    assert_eq!(error(&cubic, 4.0 * 40.0, Handed::Versine), ANY);
    let flat = BellFormula { linear: [-1.0, 0.0, 0.0], square: [0.0; 3], ..cubic };
    assert!(error(&flat, 20.0, Handed::Versine).is_finite() && error(&flat, 20.0, Handed::Cosine) == ANY);
    let by = Arithmetic::of(Format::Half);
    let sizes = |a: f64, b: f64| [a, b].map(|x| Rounded::exact(Interval::from(x)));
    assert!(!format_lacks(&sizes(-60_000.0, 5_503.0), by) && format_lacks(&sizes(-60_000.0, 5_505.0), by));
}

/// Over a box a product counts where it is largest, and no larger than it is known to be from elsewhere: n from 10 to
/// 24, cos θ from ½ to 0.95 and y = ½, so that s cos θ = s - y ≤ 1.9 for s = n/10.
#[test]
fn over_a_box_a_product_is_known_from_both_sides() {
    let formula = BellFormula { power: 2, reach: [10.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
    let cell = Cell {
        n: Interval::new(10.0, 24.0),
        m: Interval::new(1.0 / 24.0, 0.1),
        t: Interval::from(5.0),
        cosine: Interval::new(0.5, 0.95),
        ..place(10.0, 0.5)
    };
    let found = bell(&formula, &cell, &handed(&cell, Handed::Cosine, [0.0, 0.0]), Format::Single);
    let u = Arithmetic::of(Format::Single).unit;
    // s ≤ 2.4 is rounded by 2 u, 1 - s by u, the product below 2 by u and their sum above ½ by u/2.
    let base = 0.95 * 2.0 * u + u + u + 0.5 * u;
    // (½ + base)², a number above ¼.
    let exact = base + base * base + 0.25 * u;
    assert!((found.error / exact - 1.0).abs() < 1e-6, "{} {exact:e}", found.error);
}

/// Over boxes every value of the lobe lies in the enclosure, which is no wider than three times their spread.
#[test]
fn values_over_a_box_are_enclosed() {
    let straight = BellFormula { power: 4, linear: [0.0; 3], square: [0.0; 3], ..CUBIC };
    let curved = BellFormula { square: [-0.4, 0.3, 0.0], ..CUBIC };
    for formula in [CUBIC, straight, curved, BellFormula { power: 8, ..CUBIC }] {
        for way in [Handed::Cosine, Handed::Versine] {
            for (log_n, log_v) in [(3.0, 0.1), (3.0, 0.6), (4.0, 0.3), (6.0, 0.8), (5.0, 0.9)] {
                let (dn, dv) = (0.02, 0.03);
                let sides = [Interval::new(log_n, log_n + dn), Interval::new(log_v, log_v + dv)];
                let cell = Cell::new(sides, Interval::new(1.0, 1e12));
                let found = bell(&formula, &cell, &Argument::new(&cell, Format::Single, way), Format::Single);
                let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
                for i in 0..=10 {
                    for j in 0..=10 {
                        let n = libm::exp(log_n + dn * f64::from(i) / 10.0);
                        let v = libm::expm1(log_v + dv * f64::from(j) / 10.0);
                        let [reach, linear, square] = [formula.reach, formula.linear, formula.square]
                            .map(|[a, b, c]| a + (b + c / n) / n);
                        let y = -n * libm::expm1(-v / n) / reach;
                        let p = (1.0 - y) * (1.0 + y * (linear + y * square));
                        let value = libm::pow(p.max(0.0), f64::from(formula.power));
                        (lo, hi) = (lo.min(value), hi.max(value));
                    }
                }
                let name = format!("{formula:?} {way:?} {log_n} {log_v}: {found:?} {lo} {hi}");
                assert!(found.value.lo() <= lo + 1e-12 && found.value.hi() >= hi - 1e-12, "{name}");
                assert!(found.value.width() <= 3.0 * (hi - lo), "{name}");
            }
        }
    }
}
