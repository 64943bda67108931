//! Certificates of bells: what they refuse, and what they prove against plain doubles.

use super::*;

#[test]
fn what_rises_or_jumps_is_not_called_otherwise() {
    // 1 - 2z + 1.2 z² has no zero: it falls to z = 5/6 and rises.
    let (_, proof) = exponential_bell(4, [2.0, 1.2, 0.0], Some(3.0), 1e-3).unwrap();
    assert!(proof.decreasing && !proof.continuous);
    let (_, proof) = exponential_bell(4, [2.0, 1.2, 0.0], Some(3.5), 1e-3).unwrap();
    assert!(!proof.decreasing);
    // (1 - z)(1 - z/2): falls to 1, negative to 2, positive beyond.
    let (_, proof) = exponential_bell(4, [1.5, 0.5, 0.0], None, 1e-3).unwrap();
    assert!(proof.decreasing && proof.continuous && !proof.negative_beyond);
    assert!(proof.cut.contains(4.0) && proof.cut.width() < 1e-9);
}

#[test]
fn what_is_outside_the_domain_has_no_certificate() {
    for c in [[1.0, 1.0, 0.0], [0.01, 0.0, 0.0], [f64::NAN, 0.0, 0.0]] {
        assert!(exponential_bell(16, c, None, 1e-3).is_none(), "{c:?}");
    }
    for jump in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(exponential_bell(16, [1.0, 0.0, 0.0], Some(jump), 1e-3).is_none(), "{jump}");
    }
    let cs_16 = BellFormula { power: 16, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
    for from in [0.5, 0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(cosine_bell(&cs_16, from, &[], 1e-3).is_none(), "{from}");
    }
    // A seed outside the box is not looked at.
    let with_seed = cosine_bell(&cs_16, 16.0, &[[0.0, 7.0]], 1e-3).unwrap().0;
    assert!(with_seed.value.hi() < 2e-2, "{with_seed:?}");
}

#[test]
fn a_zero_at_the_scans_own_step_is_bracketed() {
    // Zero 16/(1 + 2^-52), a hair below the step at 16.
    let (_, proof) = exponential_bell(16, [1.0_f64.next_up(), 0.0, 0.0], None, 1e-3).unwrap();
    assert!(proof.cut.lo() < 16.0 && proof.cut.hi() >= 16.0 && proof.continuous, "{proof:?}");
    // Cut where p is still positive: a jump, and max(p, 0) is no cut.
    let (_, proof) = exponential_bell(4, [1.0, 0.0, 0.0], Some(3.0), 1e-3).unwrap();
    assert!(!proof.continuous && !proof.negative_beyond);
}

#[test]
fn a_bell_that_turns_within_its_reach_is_refused() {
    // q = 1 - 3 y + 3 y² has its least value 1/4 at y = 1/2; p = (1 - y)³ + … still falls; with
    // α = -4, β = 4 q touches 0 at 1/2 and p does not.
    let formula = |linear: f64, square: f64| BellFormula {
        power: 4,
        reach: [8.0, 0.0, 0.0],
        linear: [linear, 0.0, 0.0],
        square: [square, 0.0, 0.0],
    };
    assert!(cosine_bell(&formula(-1.17, 1.05), 16.0, &[], 1e-2).unwrap().1.decreasing);
    assert!(!cosine_bell(&formula(-4.0, 4.0), 16.0, &[], 1e-2).unwrap().1.decreasing);
    // q = (1 - y/1.2)(1 - y/1.5) is negative between: p is positive there.
    let (alpha, beta) = (-1.0 / 1.2 - 1.0 / 1.5, 1.0 / 1.8);
    assert!(!cosine_bell(&formula(alpha, beta), 16.0, &[], 1e-2).unwrap().1.negative_beyond);
}

/// cosⁿ - p⁴ = cosⁿ (1 - e^g). Over a small box g and cosⁿ are linear: the enclosure holds the values at the
/// corners and is no wider than both spread, but for terms of second order, 1e-5 of the place.
#[test]
fn the_logarithmic_form_is_the_range_over_a_small_box() {
    let formula =
        BellFormula { power: 4, reach: [7.5, -3.0, 2.0], linear: [-0.4, 0.9, 0.5], square: [0.3, -0.7, 0.6] };
    let bell = Bell { formula: &formula };
    let row = |[a, b, c]: [f64; 3], m: f64| a + m * (b + m * c);
    let cosine = |m: f64, t: f64| libm::exp(libm::log1p(-t * m) / m);
    let at = |(m, y): (f64, f64)| {
        let (linear, square) = (row(formula.linear, m), row(formula.square, m));
        let p = (1.0 - y) * (1.0 + y * (linear + y * square));
        (y * row(formula.reach, m), cosine(m, y * row(formula.reach, m)), p * p * p * p)
    };
    let ends = |values: [f64; 4]| {
        let lo = values.into_iter().fold(f64::INFINITY, f64::min);
        (lo, values.into_iter().fold(f64::NEG_INFINITY, f64::max))
    };
    for (m, y) in [(0.01, 0.1), (0.03, 0.4), (0.06, 0.2), (0.05, 0.7), (0.02, 0.9), (0.0625, 0.55)] {
        for (dm, dy) in [(1e-5 * m, 0.0), (0.0, 1e-5 * y), (1e-5 * m, 1e-5 * y)] {
            let corners = [(m, y), (m + dm, y), (m, y + dy), (m + dm, y + dy)].map(at);
            let (lo, hi) = ends(corners.map(|(_, cosine, power)| cosine - power));
            let g = ends(corners.map(|(_, cosine, power)| libm::log(power / cosine)));
            // The factor cosⁿ is enclosed over every t and every m of the box together.
            let t = ends(corners.map(|(t, ..)| t));
            let cosine = ends([(m, t.0), (m, t.1), (m + dm, t.0), (m + dm, t.1)].map(|(m, t)| cosine(m, t)));
            let spread = cosine.1 * libm::exp(g.1) * (g.1 - g.0)
                + (1.0 - libm::exp(g.0)).abs().max((1.0 - libm::exp(g.1)).abs()) * (cosine.1 - cosine.0);
            let cell = [Interval::new(m, m + dm), Interval::new(y, y + dy)];
            let found = bell.by_logarithm(cell).unwrap();
            let name = format!("{m} {y} {dm} {dy}: {found:?}, {lo} to {hi}, {spread}");
            // The corners' own rounding: of logarithms over m.
            assert!(found.lo() <= lo + 1e-12 && found.hi() >= hi - 1e-12, "{name}");
            assert!(found.width() <= 1.02 * spread + 1e-12, "{name}");
        }
    }
}

const fn row(x: f64) -> [f64; 3] {
    [x, 0.0, 0.0]
}

/// p = 1 - c₁ z + c₂ z² - c₃ z³ and its slopes by hand; z = t/4, so that t = 8 is z = 2.
#[test]
fn a_cubic_falls_beyond_its_cut_where_its_slope_cannot_rise() {
    let falls = |c: [f64; 3], z: f64| falls_beyond(4, c, 4.0 * z);
    for (c, z, known) in [
        // Straight lines: down, up, level.
        ([1.0, 0.0, 0.0], 1.0, true),
        ([-1.0, 0.0, 0.0], 1.0, false),
        ([0.0, 0.0, 0.0], 1.0, false),
        // p' = 1 - 0.8 z; it falls from z = 5/4 on.
        ([-1.0, -0.4, 0.0], 1.0, false),
        ([-1.0, -0.4, 0.0], 2.0, true),
        // p' = 1 - 0.3 z², likewise from z = 1.83 on.
        ([-1.0, 0.0, 0.1], 1.0, false),
        ([-1.0, 0.0, 0.1], 2.0, true),
        // A parabola that opens upward comes back.
        ([1.5, 0.5, 0.0], 1.0, false),
        // (1 - z/2)(1 - z/2 + z²/4): bent down at z = 2.
        ([1.0, 0.5, 0.125], 2.0, true),
        // Bent up at the zero, and p' largest 1/1.8 - 0.9 and 1.44/2.4 - 0.5 (z → z/2).
        ([0.9, 0.25, 0.025], 2.0, true),
        ([0.5, 0.3, 0.05], 1.0, false),
        ([1.0, 0.3, 0.025], 2.0, false),
        // p' = -1.2 + 4 z - 3 z² is above 0 between, and not from z = 1.65 on.
        ([1.2, 2.0, 1.0], 1.65, true),
        ([1.2, 2.0, 1.0], 0.5, false),
        // A cubic that rises in the end.
        ([2.0, -0.5, -0.5], 0.3, false),
        ([2.0, 0.0, -0.5], 0.3, false),
    ] {
        assert_eq!(falls(c, z), known, "{c:?} from {z}");
        // What is said is so: of those that fall, a long way on.
        let p = |z: f64| 1.0 - z * (c[0] - z * (c[1] - z * c[2]));
        let ahead = (1..4000).map(|i| z + f64::from(i) * 0.01);
        assert!(!known || ahead.into_iter().all(|x| p(x) < p(z)), "{c:?}");
    }
}

#[test]
fn a_property_is_proved_all_over_or_not() {
    let unit = Interval::new(0.0, 1.0);
    let point = Interval::from(0.5);
    let thin = |side: Interval| side.width() < 0.2;
    for domain in [
        [unit, unit],
        [unit, point],
        [point, unit],
        [Interval::new(0.0, 4.0), unit],
        [unit, Interval::new(0.0, 4.0)],
    ] {
        assert!(always(domain, |_| true));
        assert!(always(domain, |[x, _]| thin(x)) && always(domain, |[_, y]| thin(y)), "{domain:?}");
        assert!(always(domain, |[x, y]| thin(x) && thin(y)));
        assert!(!always(domain, |[x, _]| !x.contains(0.5)), "{domain:?}");
    }
    assert!(!always([unit, unit], |_| false) && !always([unit, unit], |[x, y]| !(x - y).contains(0.0)));
    assert!(!always([point, point], |_| false));
}

/// The first zero, and the supremum, against a grid in doubles.
#[test]
fn bells_for_the_exponential_are_as_far_as_a_grid_says() {
    for (power, c, jump) in [
        (4, [1.0, 0.0, 0.0], None),
        (4, [1.1, 0.4, 0.05], None),
        (8, [1.0, 0.43, 0.06], None),
        (8, [1.02, 0.4, 0.0], Some(6.5)),
        (2, [0.9, 0.3, 0.04], None),
    ] {
        let p = |t: f64| {
            let z = t / f64::from(power);
            1.0 - c[0] * z + c[1] * z * z - c[2] * z * z * z
        };
        let (found, proof) = exponential_bell(power, c, jump, 1e-7).unwrap();
        let name = format!("{power} {c:?}: {found:?} {proof:?}");
        if jump.is_none() {
            assert!(
                p(proof.cut.lo()) > -1e-14 && p(proof.cut.hi()) < 1e-14 && proof.cut.width() < 1e-9,
                "{name}"
            );
            assert!((0..1000).all(|i| p(proof.cut.lo() * f64::from(i) / 1000.0) > 0.0), "{name}");
        }
        let mut best = (0.0, 0.0);
        for i in 0..=40_000 {
            let t = f64::from(i) * 1e-3;
            let bell = if t < proof.cut.mid() { libm::pow(p(t).max(0.0), f64::from(power)) } else { 0.0 };
            let error = (libm::exp(-t) - bell).abs();
            if error > best.0 {
                best = (error, t);
            }
        }
        // Steps of 1e-3 miss a top by 1e-6 at most.
        assert!(found.value.hi() >= best.0 - 1e-12 && found.value.lo() <= best.0 + 1e-6, "{name} {best:?}");
        assert!(found.value.width() < 2e-7 && (found.at[0] - best.1).abs() < 2e-2, "{name} {best:?}");
        let decreasing = (1..1000).all(|i| {
            let t = |i: i32| proof.cut.hi() * f64::from(i) / 1000.0;
            p(t(i)) < p(t(i - 1))
        });
        assert_eq!(proof.decreasing, decreasing, "{name}");
    }
    // Cut at 1, e⁻¹ is left.
    let (found, proof) = exponential_bell(16, [1.0, 0.0, 0.0], Some(1.0), 1e-7).unwrap();
    assert!(found.at == [1.0] && found.value.contains(libm::exp(-1.0)) && found.value.width() < 1e-14);
    assert!(proof.decreasing && !proof.continuous && proof.cut == Interval::from(1.0));
}

/// Over small boxes everywhere, where the logarithms serve and where they do not.
#[test]
fn errors_are_their_range_over_a_small_box() {
    let formula =
        BellFormula { power: 4, reach: [7.5, -3.0, 2.0], linear: [-0.4, 0.9, 0.5], square: [0.3, -0.7, 0.6] };
    let bell = Bell { formula: &formula };
    let part = |[a, b, c]: [f64; 3], m: f64| a + b * m + c * m * m;
    let p =
        |m: f64, y: f64| (1.0 - y) * (1.0 + part(formula.linear, m) * y + part(formula.square, m) * y * y);
    let at = |m: f64, y: f64| {
        let t = y * part(formula.reach, m);
        libm::exp(libm::log1p(-t * m) / m) - libm::pow(p(m, y), 4.0)
    };
    for (m, y) in [(0.01, 0.1), (0.05, 0.7), (0.02, 0.985), (0.02, 0.9905), (0.03, 0.9985), (0.0625, 0.3)] {
        for (dm, dy) in [(0.0, 0.0), (1e-6, 0.0), (0.0, 1e-6), (1e-6, 1e-6)] {
            let found = bell.error([Interval::new(m, m + dm), Interval::new(y, y + dy)]);
            let corners = [at(m, y), at(m + dm, y), at(m, y + dy), at(m + dm, y + dy)];
            let lo = corners.into_iter().fold(f64::INFINITY, f64::min);
            let hi = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
            let name = format!("{m} {y} {dm} {dy}: {found:?} {lo} {hi}");
            assert!(found.lo() <= lo + 1e-13 && found.hi() >= hi - 1e-13, "{name}");
            // One sign of change or two: the mean value form adds them.
            let both = (at(m + dm, y) - at(m, y)).abs() + (at(m, y + dy) - at(m, y)).abs();
            assert!(found.width() <= 1.05 * both + 2e-13, "{name} {both}");
        }
        let exact = [Interval::from(m), Interval::from(y)];
        assert_eq!(bell.by_logarithm(exact).is_some(), y < 0.99, "{m} {y}");
        // The slope by hand, (1 - y)(α + 2 β y) - q.
        let (linear, square) = (part(formula.linear, m), part(formula.square, m));
        let slope = (1.0 - y) * (linear + 2.0 * square * y) - (1.0 + linear * y + square * y * y);
        assert_eq!(bell.falls(exact), slope < 0.0);
    }
    // q near 0, and 1 - t m near 0: no logarithm either.
    let near = |linear: f64, square: f64, reach: f64| {
        let formula = BellFormula { power: 2, reach: row(reach), linear: row(linear), square: row(square) };
        Bell { formula: &formula }.by_logarithm([0.1, 0.5].map(Interval::from)).is_some()
    };
    assert!(near(-4.0, 4.05, 8.0) && !near(-4.0, 4.03, 8.0) && near(0.0, 0.0, 19.7) && !near(0.0, 0.0, 19.9));
    // p = (1 - y)(1 + 2 y) rises to y = 1/4 and falls from there.
    let formula = BellFormula { power: 2, reach: row(8.0), linear: row(2.0), square: row(0.0) };
    let falls = |y: f64| Bell { formula: &formula }.falls([0.05, y].map(Interval::from));
    assert!(!falls(0.2) && falls(0.3));
    let formula = BellFormula { square: row(3.0), ..formula };
    // (1 - y)(1 + 2 y + 3 y²): 1 + 2 y - 9 y² is 0 at y = 0.4625.
    let falls = |y: f64| Bell { formula: &formula }.falls([0.05, y].map(Interval::from));
    assert!(!falls(0.46) && falls(0.465));
}

/// v = 1/y: v² q = v² + α v + β; beyond the edge of the hemisphere, v < m T, nothing counts.
#[test]
fn behind_its_zero_a_bell_stays_there_or_not() {
    let past = |linear: f64, square: f64, m: [f64; 2], v: [f64; 2]| {
        let formula = BellFormula { power: 2, reach: row(16.0), linear: row(linear), square: row(square) };
        Bell { formula: &formula }.is_past_its_zero([m, v].map(|[lo, hi]| Interval::new(lo, hi)))
    };
    let (near, wide) = ([0.0, 1e-3], [0.0, 1.0]);
    assert!(past(0.0, 0.0, near, wide), "straight");
    // α² < 4 β, although v (v + α) + β by intervals is not above 0; and α² > 4 β, zeros at 0.638 and 0.862.
    assert!(past(-1.17, 0.4, near, wide) && !past(-1.5, 0.55, near, wide));
    // β < 0 is below 0 in the end, v → 0; so is a line.
    assert!(
        !past(-0.2, -0.1, near, wide)
            && !past(-0.5, 0.0, near, [0.2, 0.4])
            && !past(0.0, -0.1, near, [0.0, 0.2])
    );
    // Point by point: (v - 0.638)(v - 0.862).
    for (v, known) in [(0.6, true), (0.65, false), (0.85, false), (0.9, true), (0.2, true)] {
        assert_eq!(past(-1.5, 0.55, [1e-3, 1e-3], [v, v]), known, "{v}");
    }
    // m T = 1.6 and 0.8 beyond, 0.16 before.
    assert!(past(-1.5, 0.55, [0.1, 0.1], [0.65, 0.85]) && past(-1.5, 0.55, [0.06, 0.07], [0.65, 0.85]));
    assert!(!past(-1.5, 0.55, [0.05, 0.07], [0.65, 0.85]) && !past(-1.5, 0.55, [0.01, 0.01], [0.65, 0.85]));
}

/// Where β moves fast with m the bell does, and at m = 0 itself cosⁿ is e⁻ᵗ: by the logarithms, over small boxes.
#[test]
fn logarithms_follow_the_rows_and_the_limit() {
    for (linear, square) in [([-0.4, 0.0, 0.0], [0.3, 90.0, -30.0]), ([-0.4, 70.0, 20.0], [0.3, 0.0, 0.0])] {
        let formula = BellFormula { power: 4, reach: [7.5, 40.0, 0.0], linear, square };
        let bell = Bell { formula: &formula };
        let part = |[a, b, c]: [f64; 3], m: f64| a + b * m + c * m * m;
        let at = |m: f64, y: f64| {
            let p = (1.0 - y) * (1.0 + part(linear, m) * y + part(square, m) * y * y);
            let t = y * part(formula.reach, m);
            let cosine = if m == 0.0 { libm::exp(-t) } else { libm::exp(libm::log1p(-t * m) / m) };
            (cosine, libm::pow(p, 4.0))
        };
        for (m, y) in [(0.01, 0.3), (0.004, 0.6), (0.0, 0.5)] {
            for (dm, dy) in [(0.0, 0.0), (1e-7, 0.0), (0.0, 1e-7)] {
                let found = bell.by_logarithm([Interval::new(m, m + dm), Interval::new(y, y + dy)]).unwrap();
                let (first, last) = (at(m, y), at(m + dm, y + dy));
                let (a, b) = (first.0 - first.1, last.0 - last.1);
                let name = format!("{m} {y} {dm} {dy}: {found:?} {a} {b}");
                let (lo, hi) = (a.min(b), a.max(b));
                // Doubles lose ε/m in the logarithm over m.
                assert!(found.lo() <= lo + 1e-12 && found.hi() >= hi - 1e-12, "{name}");
                // cosⁿ e^g moves with g, and 1 - e^g with cosⁿ.
                let quotient = [first.1 / first.0, last.1 / last.0];
                let spread = first.0 * (quotient[1] - quotient[0]).abs()
                    + (1.0 - quotient[0]).abs() * (last.0 - first.0).abs();
                assert!(found.width() <= 1.01 * spread + 1e-12, "{name} {spread:e}");
            }
        }
    }
}
