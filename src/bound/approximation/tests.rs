//! Distances of stand-ins from cosⁿ, against plain doubles.

use super::*;
use crate::kernel::constants::CUBIC_COS_N;

/// Over a small box the distance is linear: what encloses it holds its values at the corners, and is no
/// wider than they spread but for terms of second order.
#[test]
fn distances_are_the_range_over_a_small_box() {
    let cubic = CUBIC_COS_N[1];
    let bell = |m: f64, t: f64| {
        let [reach, linear, square] =
            [cubic.reach, cubic.linear, cubic.square].map(|[a, b, c]| a + m * (b + m * c));
        let y = t / reach;
        let p = ((1.0 - y) * (1.0 + y * (linear + y * square))).max(0.0);
        p * p * p * p
    };
    let schlick = |m: f64, v: f64, t: f64| libm::exp(-v * m) / (libm::exp(-v * m) + t);
    for (stand_in, formula) in
        [(StandIn::Cubic4, Some(cubic)), (StandIn::SphericalGaussian, None), (StandIn::Schlick, None)]
    {
        let at = |m: f64, v: f64, relative: bool| {
            // cos θ = e^(-v m), t = n (1 - cos θ)
            let t = -libm::expm1(-v * m) / m;
            let value = match stand_in {
                StandIn::Cubic4 => bell(m, t),
                StandIn::Schlick => schlick(m, v, t),
                _ => libm::exp(-t),
            };
            if relative { value * libm::exp(v) - 1.0 } else { value - libm::exp(-v) }
        };
        for relative in [false, true] {
            let distance = Distance { stand_in, formula, relative };
            for (m, v) in [(0.01, 0.5), (0.03, 2.0), (0.06, 1.0), (0.05, 4.0), (0.0625, 0.1)] {
                let (dm, dv) = (1e-5 * m, 1e-5 * v);
                for (dm, dv) in [(0.0, 0.0), (dm, 0.0), (0.0, dv), (dm, dv)] {
                    let found = distance.over([Interval::new(m, m + dm), Interval::new(v, v + dv)]);
                    let corners = [(m, v), (m + dm, v), (m, v + dv), (m + dm, v + dv)];
                    let corners = corners.map(|(m, v)| at(m, v, relative));
                    let lo = corners.into_iter().fold(f64::INFINITY, f64::min);
                    let hi = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
                    let name = format!("{stand_in:?} {relative} {m} {v} {dm} {dv}: {found:?} {lo} {hi}");
                    // 1e-12: the corners' own rounding, e^v of it where relative.
                    assert!(found.lo() <= lo + 1e-12 && found.hi() >= hi - 1e-12, "{name}");
                    assert!(found.width() <= 1.01 * (hi - lo) + 1e-9 * (dm + dv) + 1e-12, "{name}");
                }
            }
        }
    }
}

const STRAIGHT: BellFormula =
    BellFormula { power: 2, reach: [5.0, 3.0, 2.0], linear: [0.0; 3], square: [0.0; 3] };

fn of(formula: BellFormula, relative: bool) -> Distance {
    Distance { stand_in: StandIn::Cubic4, formula: Some(formula), relative }
}

/// p by its definition.
fn root(formula: &BellFormula, m: f64, t: f64) -> f64 {
    let row = |[a, b, c]: [f64; 3]| a + b * m + c * m * m;
    let y = t / row(formula.reach);
    (1.0 - y) * (1.0 + row(formula.linear) * y + row(formula.square) * y * y)
}

#[test]
fn ranges_outside_the_domain_are_refused() {
    let absolute = Measure::Absolute;
    for (n, known) in [
        ((1.0, 1.0), true),
        ((1.0, f64::INFINITY), true),
        ((0.999, 2.0), false),
        ((2.0, 1.0), false),
        ((f64::INFINITY, f64::INFINITY), false),
        ((f64::NAN, 2.0), false),
        ((2.0, f64::NAN), false),
    ] {
        let found = approximation(StandIn::Power, n, absolute);
        assert_eq!(found, known.then_some(Supremum { value: Interval::ZERO, at: [n.0, 0.0], boxes: 0 }));
    }
    assert_eq!(approximation(StandIn::Power, (1.0, 2.0), Measure::Relative { floor: 1.0 }), None);
    // 1 - 16 w/16 is cos θ, and c/(c + 1 - c) is c; nothing else is, and neither is over a range.
    for stand_in in StandIn::ALL {
        let schlick = matches!(stand_in, StandIn::Schlick | StandIn::SchlickPrinted);
        let found = [1.0, 2.0, 16.0].map(|n| coincides(stand_in, (n, n)));
        assert_eq!(found, [schlick, false, stand_in == StandIn::Cs16], "{stand_in:?}");
        assert!(!coincides(stand_in, (1.0, 16.0)));
    }
    assert_eq!(approximation(StandIn::Schlick, (1.0, 1.0), absolute).unwrap().value, Interval::ZERO);
}

/// Against a grid in doubles of every θ at a few n; c/(c + n w) and e^(-n w) by their definitions.
#[test]
fn suprema_are_the_largest_of_a_grid() {
    let relative = Measure::Relative { floor: 1.0 / 256.0 };
    for (stand_in, n, measure) in [
        (StandIn::Linear2, (16.0, 16.0), Measure::Absolute),
        (StandIn::Schlick, (2.0, 4.0), Measure::Absolute),
        (StandIn::SphericalGaussian, (8.0, f64::INFINITY), Measure::Absolute),
        (StandIn::Linear4, (16.0, 16.0), relative),
        (StandIn::SphericalGaussian, (20.0, 50.0), relative),
        // Below its fit a cubic bell is large at θ = π/2 as well.
        (StandIn::Cubic2, (1.0, 64.0), Measure::Absolute),
        // e^(-n w) is e⁻¹ at θ = π/2 and n = 1, where cosⁿ is 0: what lies beyond v = 37.
        (StandIn::SphericalGaussian, (1.0, 1.0), Measure::Absolute),
        // That far nothing counts that is below the floor: e^(-1/10)/0.9 - 1.
        (StandIn::SphericalGaussian, (1.0, 1.0), Measure::Relative { floor: 0.9 }),
    ] {
        let distance = |n: f64, v: f64| {
            let w = -libm::expm1(-v / n);
            let value: f64 = match stand_in {
                StandIn::Schlick => (1.0 - w) / (1.0 - w + n * w),
                StandIn::SphericalGaussian => libm::exp(-n * w),
                _ => stand_in.at_versine(w, n),
            };
            let target = libm::exp(-v);
            if measure == Measure::Absolute { (value - target).abs() } else { (value / target - 1.0).abs() }
        };
        let end = match measure {
            Measure::Absolute => 60.0,
            Measure::Relative { floor } => -libm::log(floor),
        };
        let most_n = n.1.min(1e9);
        let mut best = 0.0_f64;
        for i in 0..=20 {
            for j in 0..=2000 {
                let at_n = n.0 * libm::pow(most_n / n.0, f64::from(i) / 20.0);
                best = best.max(distance(at_n, end * f64::from(j) / 2000.0));
            }
        }
        let found = approximation(stand_in, n, measure).unwrap();
        let name = format!("{stand_in:?} {n:?}: {found:?} {best:e}");
        assert!(found.value.hi() >= best * (1.0 - 1e-12) && found.value.lo() <= best * 1.001, "{name}");
        assert!(found.value.hi() <= 1.0011 * best + 1e-12 && found.value.lo() >= 0.998 * best, "{name}");
        // A thousandth takes hundreds of boxes, not the most there may be.
        assert!(found.boxes < 5000, "{name}");
        let [at_n, t] = found.at;
        assert!(at_n >= n.0 && at_n <= n.1, "{name}");
        let at_n = at_n.min(1e9);
        let reached = distance(at_n, (-at_n * libm::log1p(-(t / at_n).min(1.0))).min(end));
        assert!((reached / found.value.lo() - 1.0).abs() < 2e-3, "{name} {reached:e}");
    }
}

/// A row is c₀, c₀ + c₁ m or c₀ + c₁ m + c₂ m², and what has neither α nor β is a straight line.
#[test]
fn bases_are_made_of_every_row() {
    let some = [0.3, 0.7, -0.4];
    let rows = [[0.6, 0.0, 0.0], [0.6, 1.3, 0.0], [0.6, 0.0, 1.7], [0.6, 1.3, 1.7]];
    let mut all = vec![];
    for row in rows {
        let reach = row.map(|c| 5.0 * c);
        all.push((reach, some, [0.0; 3]));
        all.push((reach, [0.0; 3], some));
        all.push((reach, [0.0; 3], [0.0; 3]));
        all.push(([5.0, 0.0, 0.0], row, some));
        all.push(([5.0, 0.0, 0.0], some, row));
    }
    for (reach, linear, square) in all {
        let formula = BellFormula { power: 4, reach, linear, square };
        for (m, t) in [(0.03, 2.0), (0.25, 0.7), (0.0, 3.1)] {
            let point = [m, t].map(Interval::from);
            let found = base(&formula, Interval::from, &point[0], &point[1]);
            let exact = root(&formula, m, t);
            assert!((found.mid() - exact).abs() < 1e-13 && found.width() < 1e-13, "{formula:?} {m} {t}");
        }
    }
}

/// Across p = 0 the enclosure holds the values and is no wider than the mean value form by hand: the largest slope
/// by v, K max(p, 0)^(K-1) p' + e⁻ᵛ, over the box.
#[test]
fn across_its_zero_a_bell_keeps_a_slope() {
    let turned = BellFormula { power: 4, linear: [-0.5, 0.2, 0.1], square: [0.3, 0.1, 0.0], ..STRAIGHT };
    for formula in [STRAIGHT, turned] {
        for relative in [false, true] {
            for (m, half_m, half_v) in
                [(0.03, 0.0, 0.02), (0.03, 0.0, 0.1), (0.02, 1e-4, 0.05), (0.01, 1e-3, 0.0)]
            {
                // v at the zero of p, by bisection.
                let t = |m: f64, v: f64| -libm::expm1(-v * m) / m;
                let (mut lo, mut hi) = (1.0, 15.0);
                for _ in 0..60 {
                    let mid = 0.5 * (lo + hi);
                    if root(&formula, m, t(m, mid)) > 0.0 { lo = mid } else { hi = mid }
                }
                let k = f64::from(formula.power);
                let at = |m: f64, v: f64| {
                    let power = libm::pow(root(&formula, m, t(m, v)).max(0.0), k);
                    if relative { power * libm::exp(v) - 1.0 } else { power - libm::exp(-v) }
                };
                let cell = [Interval::new(m - half_m, m + half_m), Interval::new(lo - half_v, lo + half_v)];
                let found = of(formula, relative).over(cell);
                let (mut least, mut most, mut steepest) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
                let points =
                    |side: Interval| (0..=20).map(move |i| side.lo() + side.width() * f64::from(i) / 20.0);
                for m in points(cell[0]) {
                    for v in points(cell[1]) {
                        let value = at(m, v);
                        (least, most) = (least.min(value), most.max(value));
                        let step = 1e-6;
                        let p = |v: f64| root(&formula, m, t(m, v));
                        let slope = k * libm::pow(p(v).max(0.0), k - 1.0) * (p(v + step) - p(v - step))
                            / (2.0 * step);
                        // The two terms are enclosed apart: each at its end.
                        steepest = steepest
                            .max(slope + libm::exp(-cell[1].lo()))
                            .max(-slope - libm::exp(-cell[1].hi()));
                    }
                }
                let name = format!("{formula:?} {relative} {m} {half_m} {half_v}: {found:?} {least} {most}");
                assert!(found.lo() <= least + 1e-14 && found.hi() >= most - 1e-14, "{name}");
                if half_m == 0.0 && !relative {
                    let mean = 2.0 * half_v * steepest;
                    assert!(found.width() <= 1.02 * mean.max(most - least), "{name} {mean}");
                } else {
                    // By intervals alone: e⁻ᵛ and p^K spread apart, one at its most where the other is at its least.
                    let (first, last) = (cell[1].lo(), cell[1].hi());
                    let spread = if relative { most - least } else { libm::exp(-first) - libm::exp(-last) };
                    let top = libm::pow(
                        points(cell[0]).map(|m| root(&formula, m, t(m, first))).fold(0.0, f64::max),
                        k,
                    );
                    let top = if relative { top * libm::exp(last) } else { top };
                    assert!(found.width() <= 1.2 * (spread + top) + 1e-12, "{name} {spread} {top}");
                }
            }
        }
    }
}

/// What is left beyond v = 37, t from n (1 - e^(-37/n)) to n, by hand.
#[test]
fn the_tail_is_bounded_by_what_is_left_of_either() {
    let target = libm::exp(-37.0);
    let hi = |distance: &Distance, m: Interval| {
        let found = distance.beyond(m);
        assert_eq!(found.lo(), 0.0);
        found.hi()
    };
    let is = |found: f64, exact: f64, name: &str| {
        assert!(
            found >= exact * (1.0 - 1e-12) && found <= exact * (1.0 + 1e-9),
            "{name}: {found:e} {exact:e}"
        );
    };
    let first_t = |n: f64| -n * libm::expm1(-37.0 / n);
    let lobe = |stand_in| Distance { stand_in, formula: None, relative: false };
    let (m, box_m) = (Interval::from(1.0 / 64.0), Interval::new(1.0 / 64.0, 1.0 / 32.0));
    is(hi(&lobe(StandIn::SphericalGaussian), m), libm::exp(-first_t(64.0)), "e^(-n w)");
    is(hi(&lobe(StandIn::SphericalGaussian), box_m), libm::exp(-first_t(32.0)), "e^(-n w), 32 to 64");
    is(hi(&lobe(StandIn::SphericalGaussian), Interval::ZERO), target, "e⁻ᵗ");
    let c = libm::exp(-37.0 / 64.0);
    is(hi(&lobe(StandIn::Schlick), m), c / (c + first_t(64.0)), "Schlick");
    is(hi(&lobe(StandIn::SchlickPrinted), box_m), c / (c + first_t(32.0)), "Schlick, 32 to 64");
    // Straight bells: past their end nothing, before it what they are where t is least.
    is(hi(&of(STRAIGHT, false), m), target, "past its end");
    for reach in [[20.0, 8.0, 16.0], [20.0, 0.0, 0.0], [70.0, 3.0, -5.0]] {
        let long = BellFormula { reach, ..STRAIGHT };
        let exact = libm::pow(root(&long, 1.0 / 16.0, first_t(16.0)), 2.0);
        is(hi(&of(long, false), Interval::from(1.0 / 16.0)), exact, "before its end");
    }
    // A hair before its end, whatever makes the reach: a + b/16 + c/256.
    for (b, c) in [(8.0, 8.0), (8.0, 1.0), (8.0, -8.0), (-3.0, 8.0)] {
        let t = first_t(16.0);
        let near = BellFormula { reach: [t + 0.02 - b / 16.0 - c / 256.0, b, c], ..STRAIGHT };
        let exact = libm::pow(0.02 / (t + 0.02), 2.0);
        is(hi(&of(near, false), Interval::from(1.0 / 16.0)), exact, "a hair before its end");
    }
    // (1 - y) q past y = 1 with q > 0 everywhere, α² < 4β: nothing, though q's enclosure over y in [1.004, 2.28]
    // holds negative numbers.
    let row = |x: f64| [x, 0.0, 0.0];
    let curved = |reach: f64, linear: f64, square: f64| {
        of(BellFormula { power: 2, reach: row(reach), linear: row(linear), square: row(square) }, false)
    };
    is(hi(&curved(28.0, -1.0, 0.3), m), target, "q without a zero");
    // A q with a zero, or falling for ever, lifts p above 0 again.
    for (linear, square) in [(-0.25, 1.0 / 72.0), (0.0, -1.0), (-0.25, 0.0), (-4.0, 0.5)] {
        let distance = curved(5.0, linear, square);
        let formula = distance.formula.unwrap();
        let most = (0..=200)
            .map(|i| first_t(64.0) + (64.0 - first_t(64.0)) * f64::from(i) / 200.0)
            .map(|t| root(&formula, 1.0 / 64.0, t).max(0.0))
            .fold(0.0, f64::max);
        assert!(most > 0.0 && hi(&distance, m) >= most * most, "{linear} {square}: {most}");
    }
    // Before y = 1 even a q without a zero leaves something.
    let distance = curved(60.0, -1.0, 0.3);
    assert!(hi(&distance, m) >= libm::pow(root(&distance.formula.unwrap(), 1.0 / 64.0, first_t(64.0)), 2.0));
}
