//! The search for the largest rounding error: what it refuses, which code it takes for which stand-in, and that it
//! ends at the largest of what it was given.

use super::count::{handed, place};
use super::*;
use crate::kernel::prepared::Prepared;

fn draw(state: &mut u64, lo: f64, hi: f64) -> f64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    lo + (hi - lo) * ((*state >> 11) as f64 * libm::scalbn(1.0, -53))
}

const fn of(stand_in: StandIn, format: Format, handed: Handed) -> Kernel {
    Kernel { stand_in, format, handed, measure: Measure::Absolute, ulps: 1.0 }
}

#[test]
fn what_is_outside_the_domain_has_no_bound() {
    let absolute = Measure::Absolute;
    let found = |stand_in, n, measure, ulps| {
        rounding_with(stand_in, Format::Double, Handed::Versine, n, measure, ulps).is_some()
    };
    for (n, known) in [
        ((1.0, 1.0), true),
        ((MOST_N, MOST_N), true),
        ((0.999, 2.0), false),
        ((2.0, 1.0), false),
        ((MOST_N, MOST_N * 1.001), false),
        ((f64::NAN, 2.0), false),
        ((2.0, f64::NAN), false),
    ] {
        assert_eq!(found(StandIn::Schlick, n, absolute, 1.0), known, "{n:?}");
    }
    for (ulps, known) in [(0.0, true), (-0.5, false), (f64::NAN, false), (f64::INFINITY, false)] {
        assert_eq!(found(StandIn::Power, (2.0, 2.0), absolute, ulps), known, "{ulps}");
    }
    for (floor, known) in [(0.5, true), (0.0, false), (1.0, false), (f64::NAN, false)] {
        assert_eq!(found(StandIn::Power, (2.0, 2.0), Measure::Relative { floor }, 1.0), known, "{floor}");
    }
    // Squarings want a whole n that a u32 holds; others take any.
    let last = f64::from(u32::MAX);
    for (n, known) in [
        ((1.2, 1.8), false),
        ((1.5, 2.0), true),
        ((2.0, 2.9), true),
        ((last, last), true),
        ((last, last + 0.5), true),
        ((last, last + 1.0), false),
    ] {
        assert_eq!(found(StandIn::Squarings, n, absolute, 1.0), known, "{n:?}");
    }
    assert!(
        found(StandIn::Power, (1.2, 1.3), absolute, 1.0) && found(StandIn::Power, (5e9, 5e9), absolute, 1.0)
    );
    // A power of two whose cubic loses its degree at n = 6.9 has no form from cos θ there.
    let by_cosine = |n| rounding(StandIn::Cubic4, Format::Double, Handed::Cosine, n, absolute).is_some();
    assert!(
        by_cosine((7.5, 7.5)) && !by_cosine((6.0, 8.0)) && found(StandIn::Cubic4, (6.0, 8.0), absolute, 1.0)
    );
    // Half precision ends before n does.
    let half = |n| rounding(StandIn::Schlick, Format::Half, Handed::Versine, (16.0, n), absolute).is_some();
    assert!(half(65_504.0) && !half(65_600.0));
}

/// n w, n u and v u of them: which code stands behind which name.
#[test]
fn every_stand_in_is_judged_by_its_own_code() {
    let (n, w) = (3000.0, 1e-3);
    let cell = place(n, w);
    let single = |stand_in, way| of(stand_in, Format::Single, way);
    for stand_in in StandIn::ALL {
        for way in Handed::ALL {
            let value = single(stand_in, way).result(&cell, &handed(&cell, way, [0.0, 0.0])).value;
            let exact: f64 = stand_in.at_versine(w, n);
            assert!((value.mid() - exact).abs() < 1e-11 && value.width() < 1e-11, "{stand_in:?} {value:?}");
        }
    }
    // In units of u: what is large of one code is small of the others.
    let u = Format::Single.unit_roundoff();
    let error =
        |stand_in, way| single(stand_in, way).result(&cell, &handed(&cell, way, [0.0, 0.0])).error / u;
    assert!(error(StandIn::Schlick, Handed::Versine) < 3.0);
    assert!(error(StandIn::SchlickPrinted, Handed::Versine) > 100.0);
    assert!(error(StandIn::Squarings, Handed::Cosine) > 100.0);
    let [power, by_log] = [StandIn::Power, StandIn::Exp2Log2].map(|stand_in| error(stand_in, Handed::Cosine));
    assert!(power < 6.0 * 0.05 && by_log > 1.5 * power && by_log < 1.0, "{power} {by_log}");
    // Sixteen units in the last place, where one was assumed.
    for (stand_in, changes) in [
        (StandIn::Power, true),
        (StandIn::Exp2Log2, true),
        (StandIn::SphericalGaussian, true),
        (StandIn::Cs16, false),
    ] {
        let worse = Kernel { ulps: 16.0, ..single(stand_in, Handed::Versine) };
        let given = handed(&cell, Handed::Versine, [0.0, 0.0]);
        let plain = single(stand_in, Handed::Versine).result(&cell, &given).error;
        assert_eq!(worse.result(&cell, &given).error > 4.0 * plain, changes, "{stand_in:?}");
        assert_eq!(assumes_elementary(stand_in), changes);
    }
}

/// A w that rounds to 1 ends Schlick's lobe, one above 1 a bell; the powers are 0 there anyway.
#[test]
fn lobes_end_early_where_the_versine_may_pass_their_end() {
    for stand_in in StandIn::ALL {
        let [cosine, versine, difference] =
            Handed::ALL.map(|way| of(stand_in, Format::Single, way).may_end_early());
        let schlick = matches!(stand_in, StandIn::Schlick | StandIn::SchlickPrinted);
        assert_eq!((cosine, versine), (false, schlick), "{stand_in:?}");
        assert_eq!(difference, schlick || stand_in.bell().is_some(), "{stand_in:?}");
    }
    // At n = 4 < T = 16 the bell is (3/4)¹⁶ at θ = π/2, of which rounded vectors may lose all; w itself does not.
    let right = Cell { cosine: Interval::ZERO, ..place(4.0, 1.0) };
    let whole = libm::pow(0.75, 16.0);
    let error = |way| of(StandIn::Cs16, Format::Single, way).bound(&right);
    assert!(error(Handed::Difference) >= whole && error(Handed::Difference) < 1.001 * whole);
    assert!(error(Handed::Versine) < 1e-7);
    let before = place(4.0, 0.9);
    assert!(of(StandIn::Cs16, Format::Single, Handed::Difference).bound(&before) < 1e-6);
}

/// Over cosⁿ = 1/4 an error counts four times; a result stored in binary16 by half a unit more.
#[test]
fn measures_and_stored_results_count() {
    let cell = Cell { v: Interval::from(libm::log(4.0)), ..place(19.0, 0.1) };
    let kernel = of(StandIn::Cubic8, Format::HalfStored, Handed::Versine);
    let relative = Kernel { measure: Measure::Relative { floor: 0.1 }, ..kernel };
    let (absolute, relative) = (kernel.bound(&cell), relative.bound(&cell));
    assert!((relative / absolute - 4.0).abs() < 1e-12, "{absolute} {relative}");
    let given = Argument::new(&cell, Format::HalfStored, Handed::Versine);
    let result = kernel.result(&cell, &given);
    // The lobe is about 0.13, a number of binary16 with units of 2⁻¹³.
    assert!(result.value.lo() > 0.126 && result.value.hi() < 0.249, "{result:?}");
    let exact = result.error + libm::scalbn(1.0, -14) + libm::scalbn(1.0, -25);
    assert!((absolute / exact - 1.0).abs() < 1e-12, "{absolute} {exact}");
    let plain = Kernel { format: Format::Single, ..kernel };
    let given = Argument::new(&cell, Format::Single, Handed::Versine);
    assert_eq!(plain.bound(&cell), plain.result(&cell, &given).error);
}

/// Over boxes, not only at points: binary32 itself stays below.
#[test]
fn a_box_holds_what_binary32_does_in_it() {
    let mut state = 5;
    for stand_in in StandIn::ALL {
        for way in [Handed::Cosine, Handed::Versine] {
            let kernel = of(stand_in, Format::Single, way);
            for _ in 0..6 {
                let (log_n, log_v) = (draw(&mut state, 2.8, 8.0), draw(&mut state, 0.0, 2.0));
                let sides = [Interval::new(log_n, log_n + 0.05), Interval::new(log_v, log_v + 0.05)];
                let cell = Cell::new(sides, Interval::new(1.0, MOST_N));
                let bound = kernel.bound(&cell);
                for _ in 0..40 {
                    let mut n = draw(&mut state, cell.n.lo(), cell.n.hi()) as f32;
                    if stand_in == StandIn::Squarings {
                        n = libm::roundf(n);
                    }
                    let n = f64::from(n);
                    let v = draw(&mut state, cell.v.lo(), cell.v.hi());
                    if !cell.n.contains(n) {
                        continue;
                    }
                    let w = -libm::expm1(-v / n);
                    let x = if way == Handed::Cosine { (1.0 - w) as f32 } else { w as f32 };
                    let single = Prepared::new(stand_in, n).of(way.argument(), x);
                    let error = (f64::from(single) - stand_in.at_versine(w, n)).abs();
                    assert!(error <= bound + 1e-12, "{stand_in:?} {way:?} {n} {w}: {error:e} {bound:e}");
                }
            }
        }
    }
}

/// The supremum is no less than the bound at any point, and within 3 % of the largest at one; `at` names it.
#[test]
fn the_search_ends_near_the_largest_bound() {
    for (stand_in, way, n, measure) in [
        (StandIn::Schlick, Handed::Versine, (3.0, 40.0), Measure::Absolute),
        (StandIn::Power, Handed::Versine, (16.0, 16.0), Measure::Absolute),
        (StandIn::Cs16, Handed::Cosine, (16.0, 64.0), Measure::Absolute),
        (StandIn::Linear4, Handed::Versine, (16.0, 64.0), Measure::Relative { floor: 0.25 }),
    ] {
        let found = rounding(stand_in, Format::Single, way, n, measure).unwrap();
        let kernel = Kernel { measure, ..of(stand_in, Format::Single, way) };
        let last = if measure == Measure::Absolute { 40.0 } else { libm::log(4.0) };
        let range = Interval::new(n.0, n.1);
        let mut best = 0.0_f64;
        for i in 0..=10 {
            for j in 0..=150 {
                let (i, j) = (f64::from(i) / 10.0, f64::from(j) / 150.0);
                let log_n = libm::log(n.0) + i * libm::log(n.1 / n.0);
                let point = [Interval::from(log_n), Interval::from(j * libm::log1p(last))];
                best = best.max(kernel.bound(&Cell::new(point, range)));
            }
        }
        let most = found.value.hi();
        assert_eq!(found.value.lo(), 0.0);
        assert!(most >= best * (1.0 - 1e-12) && most <= 1.04 * best, "{stand_in:?}: {found:?} {best:e}");
        // A few hundred boxes do; the most are ten times that.
        assert!(found.boxes < 1000, "{stand_in:?}: {found:?}");
        let [at_n, t] = found.at;
        assert!(range.contains(at_n), "{found:?}");
        let cell = Cell::new(
            [Interval::from(libm::log(at_n)), Interval::from(libm::log1p(-at_n * libm::log1p(-t / at_n)))],
            range,
        );
        assert!(kernel.bound(&cell) >= most / 1.04, "{stand_in:?}: {found:?}");
    }
}
