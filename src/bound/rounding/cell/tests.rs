//! Boxes of exponents and angles and what a kernel is handed, against plain doubles.

use super::super::count::{Count, Rounding, place};
use super::*;

/// The documented terms at places where the root is whole: √(6 t n) u = 12 u at n = 4, t = 6 and u at
/// n = 1, t = 1/6; 3 n u²/2 is 6 u² and 3/2 u². Arithmetic in doubles adds 5 · 2⁻⁵³ of it, which 1e-12 covers.
#[test]
fn a_gap_of_stored_vectors_is_off_by_its_terms() {
    let (stored, by) = (Arithmetic::stored(Format::HalfStored), Arithmetic::of(Format::Double));
    let u = 1.0 / 2048.0;
    for (t, n, exact) in [(6.0, 4.0, 12.0 * u + 6.0 * u * u), (1.0 / 6.0, 1.0, u + 1.5 * u * u)] {
        let found = gap_error(Interval::from(t), Interval::from(n), stored, by);
        assert!(found >= exact && found < exact + 1e-12, "{found} for {exact}");
    }
    // Alike vectors of doubles in single precision: (1 + v)⁵ - 1 of t and underflow are left.
    let (exact, single) = (Arithmetic::of(Format::Double), Arithmetic::of(Format::Single));
    let found = gap_error(Interval::from(1.0), Interval::from(1.0), exact, single);
    let v = single.unit;
    assert!(found >= 5.0 * v && found < 5.0 * v + 11.0 * v * v + 1e-15, "{found}");
    // At t = 0 underflow is what is left: four times n = 8 halves of the least number.
    let half = Arithmetic::of(Format::Half);
    let found = gap_error(Interval::from(0.0), Interval::from(8.0), exact, half);
    assert!(found >= 32.0 * half.tiny && found < 32.0 * half.tiny + 1e-12, "{found}");
}

/// n = 64 and cos θ = 0.9 by their logarithms.
#[test]
fn a_point_has_all_of_its_names() {
    let (n, c) = (64.0, 0.9);
    let v = -n * libm::log(c);
    let sides = [Interval::from(n).ln(), Interval::from(libm::log1p(v))];
    let cell = Cell::new(sides, Interval::new(1.0, 1e12));
    for (side, exact) in [
        (cell.n, n),
        (cell.m, 1.0 / n),
        (cell.v, v),
        (cell.t, n * (1.0 - c)),
        (cell.cosine, c),
        (cell.versine, 1.0 - c),
        (cell.target(), libm::pow(c, n)),
    ] {
        assert!((side.mid() / exact - 1.0).abs() < 1e-13 && side.width() < 1e-12 * exact, "{side:?} {exact}");
    }
    // Of a box the ends: cos θ = e^(-v/n), w ≤ 1, t ≤ n; and n stays in the range.
    let cell = Cell::new([Interval::new(2.0, 3.0), Interval::new(1.0, 2.0)], Interval::new(8.0, 16.0));
    assert_eq!((cell.n, cell.m), (Interval::new(8.0, 16.0), Interval::new(0.0625, 0.125)));
    let v = [libm::expm1(1.0), libm::expm1(2.0)];
    let c = [libm::exp(-v[1] / 8.0), libm::exp(-v[0] / 16.0)];
    let t = [-8.0 * libm::expm1(-v[0] / 8.0), -16.0 * libm::expm1(-v[1] / 16.0)];
    for (side, exact) in
        [(cell.v, v), (cell.cosine, c), (cell.t, t), (cell.versine, [1.0 - c[1], 1.0 - c[0]])]
    {
        let ends = [side.lo() - exact[0], side.hi() - exact[1]];
        assert!(ends[0] <= 1e-14 && ends[0] > -1e-12 && ends[1] >= -1e-14 && ends[1] < 1e-12, "{side:?}");
    }
    let last = Cell::new([Interval::new(2.0, 2.5), Interval::new(2.0, FURTHEST)], Interval::new(1.0, 1e12));
    assert!(last.v.hi() == f64::INFINITY && last.cosine.lo() == 0.0 && last.versine.hi() == 1.0);
    assert!(last.t.hi() >= libm::exp(2.5) && last.t.hi() < libm::exp(2.5) * (1.0 + 1e-12));
    let before = Cell::new([Interval::new(2.0, 2.5), Interval::new(2.0, 49.9)], Interval::new(1.0, 1e12));
    assert!(before.v.hi() < f64::INFINITY);
    let first = Cell::new([Interval::from(2.0), Interval::ZERO], Interval::new(1.0, 1e12));
    assert!(first.v.lo() == 0.0 && first.v.hi() < 1e-15 && first.cosine.hi() == 1.0 && first.t.lo() == 0.0);
}

/// A versine off by 1/4 comes out at 1 where cos θ ≤ 1/4: v ≥ 4 ln 4, t ≥ 4 · 3/4, w ≥ 3/4.
#[test]
fn the_edge_is_where_the_versine_may_reach_1() {
    let side = Interval::new;
    let cell = Cell {
        n: side(4.0, 8.0),
        m: side(0.125, 0.25),
        v: side(0.5, f64::INFINITY),
        t: side(0.5, 8.0),
        cosine: side(0.125, 0.9),
        versine: side(0.1, 0.875),
    };
    let edge = cell.edge(0.25).unwrap();
    assert_eq!((edge.n, edge.m, edge.cosine), (cell.n, cell.m, side(0.125, 0.25)));
    for (side, lo, hi) in
        [(edge.v, 4.0 * libm::log(4.0), f64::INFINITY), (edge.t, 3.0, 8.0), (edge.versine, 0.75, 0.875)]
    {
        assert!(side.lo() <= lo + 1e-15 && side.lo() > lo - 1e-13 && side.hi() == hi, "{side:?}");
    }
    assert!(cell.edge(0.125).is_some() && cell.edge(0.124).is_none() && cell.edge(0.0).is_none());
    // An error of 1 and more leaves the whole box, none of it only cos θ = 0.
    let whole = cell.edge(2.0).unwrap();
    assert_eq!((whole.v, whole.t, whole.cosine, whole.versine), (cell.v, cell.t, cell.cosine, cell.versine));
    let right = Cell { cosine: side(0.0, 0.5), ..cell }.edge(0.0).unwrap();
    assert_eq!((right.v, right.cosine), (cell.v, Interval::ZERO));
    assert!(right.t.lo() > 4.0 - 1e-13 && right.versine.lo() == 0.875);
}

/// 1 - ĉ is exact for ĉ ≥ ½ (Sterbenz), and rounded below; n times it counts at the largest n.
#[test]
fn a_cosine_is_rounded_once() {
    for (format, stored) in
        [(Format::Half, Format::Half), (Format::Single, Format::Single), (Format::HalfStored, Format::Half)]
    {
        let (inside, outside) = (Rounding::of(format), Rounding::of(stored));
        for w in [0.1, 0.49, 0.6, 0.9] {
            let cell = place(100.0, w);
            let found = Argument::new(&cell, format, Handed::Cosine);
            let cosine = Count::exact(1.0 - w).stored(outside);
            let rounded = Count::exact(1.0).minus(cosine, inside);
            let versine = if w < 0.5 { Count::new(w, cosine.error) } else { rounded };
            assert!(cosine.is_met(found.cosine, 0.0) && versine.is_met(found.versine, 0.0), "{format:?} {w}");
            assert!(Count::new(100.0 * w, 100.0 * versine.error).is_met(found.scaled, 0.0), "{format:?} {w}");
            assert_eq!(found.handed, Handed::Cosine);
        }
    }
    // At ½ and a rounding, ĉ may be below ½.
    let u = libm::scalbn(1.0, -11);
    let found = Argument::new(&place(2.0, 0.5 - 0.2 * u), Format::Half, Handed::Cosine);
    assert!(found.versine.error > found.cosine.error);
}

/// u w and half the least number, or u t over a box where w is known less well than t/n; 1 - ŵ is rounded once more.
#[test]
fn a_versine_is_off_relatively() {
    for (format, stored) in [(Format::Half, Format::Half), (Format::HalfStored, Format::Half)] {
        let (inside, outside) = (Rounding::of(format), Rounding::of(stored));
        let cell = Cell { n: Interval::new(50.0, 100.0), ..place(100.0, 0.02) };
        let off = outside.unit * 0.02 + outside.tiny;
        for (t, error) in [(2.0, 100.0 * off), (1.0, outside.unit + 100.0 * outside.tiny), (3.0, 100.0 * off)]
        {
            let cell = Cell { t: Interval::from(t), ..cell };
            let found = Argument::new(&cell, format, Handed::Versine);
            let versine = Count::new(0.02, off);
            assert!(versine.is_met(found.versine, 0.0), "{found:?}");
            assert!(Count::new(t, error).is_met(found.scaled, 0.0), "{found:?} {error}");
            assert!(Count::exact(1.0).minus(versine, inside).is_met(found.cosine, 0.0), "{found:?}");
        }
    }
    // From vectors: the documented terms with n = 1 for w, and for n w the less of n times that and n's own.
    let (by, outside) = (Arithmetic::of(Format::HalfStored), Arithmetic::stored(Format::HalfStored));
    let cell = place(100.0, 0.02);
    let found = Argument::new(&cell, Format::HalfStored, Handed::Difference);
    let (u, arithmetic) = (outside.unit, libm::pow(1.0 + by.unit, 5.0) - 1.0);
    let moved = u * libm::sqrt(6.0 * 0.02) + 1.5 * u * u;
    let exact = moved + arithmetic * (0.02 + moved) + 4.0 * by.tiny;
    assert!(Count::new(0.02, exact).is_met(found.versine, 0.0), "{found:?} {exact}");
    assert!(Count::new(2.0, 100.0 * exact).is_met(found.scaled, 0.0), "{found:?} {exact}");
    let small =
        Argument::new(&Cell { t: Interval::from(0.5), ..cell }, Format::HalfStored, Handed::Difference);
    let moved = u * libm::sqrt(6.0 * 0.5 * 100.0) + 150.0 * u * u;
    let exact = moved + arithmetic * (0.5 + moved) + 400.0 * by.tiny;
    assert!(Count::new(0.5, exact).is_met(small.scaled, 0.0), "{small:?} {exact}");
}

/// Each term of the gap's error by itself where no other hides it.
#[test]
fn every_term_of_a_gap_counts() {
    let (half, double) = (Arithmetic::of(Format::Half), Arithmetic::of(Format::Double));
    let at = |t: f64, n: f64, stored, by| gap_error(Interval::from(t), Interval::from(n), stored, by);
    let u = half.unit;
    for (t, n) in [(0.3, 7.0), (5.0, 7.0), (0.0, 7.0)] {
        let moved = u * libm::sqrt(6.0 * t * n) + 3.0 * n * u * u / 2.0;
        let exact = moved + (libm::pow(1.0 + u, 5.0) - 1.0) * (t + moved) + 4.0 * n * half.tiny;
        assert!((at(t, n, half, half) / exact - 1.0).abs() < 1e-12, "{t} {n}");
        assert!((at(t, n, half, double) / moved - 1.0).abs() < 1e-9, "{t} {n}");
    }
}
