//! How far stand-ins lie from cosⁿ: enclosures against samples, a theorem, printed digits and an older path.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use bellfit::bound::{Interval, Measure, approximation};
use bellfit::kernel::stand_in::StandIn;

const FLOOR: f64 = 1.0 / 256.0;
const RANGES: [(f64, f64); 6] =
    [(16.0, 1024.0), (1.0, 16.0), (64.0, 64.0), (16.0, f64::INFINITY), (1.0, 1e12), (1e6, 1e12)];

/// The stand-in in double precision at m = 1/n and t = n w, off by 1e-13 at most.
fn exactly(stand_in: StandIn, m: f64, t: f64) -> f64 {
    if let Some(formula) = stand_in.formula() {
        let row = |[a, b, c]: [f64; 3]| a + m * (b + m * c);
        let y = t / row(formula.reach);
        let base = (1.0 - y) * (1.0 + y * (row(formula.linear) + y * row(formula.square)));
        return libm::pow(base.max(0.0), f64::from(formula.power));
    }
    match stand_in {
        StandIn::SphericalGaussian => libm::exp(-t),
        _ => (1.0 - m * t) / (1.0 - m * t + t),
    }
}

#[test]
fn enclosures_hold_a_dense_sample_and_little_more() {
    for stand_in in StandIn::ALL.into_iter().filter(|stand_in| !stand_in.is_exact()) {
        for (from, to) in RANGES {
            for measure in [Measure::Absolute, Measure::Relative { floor: FLOOR }] {
                let found = approximation(stand_in, (from, to), measure).unwrap();
                let (lo, hi) = (found.value.lo(), found.value.hi());
                let name = format!("{} {from}..{to} {measure:?}", stand_in.id());
                // A thousandth, as the page says.
                assert!(hi <= lo * 1.0011 + 1.1e-12, "{name}: {lo:e} {hi:e}");
                let relative = measure != Measure::Absolute;
                let end = if relative { -libm::log(FLOOR) } else { 40.0 };
                let mut most = 0.0_f64;
                for i in 0..=80 {
                    // n over the range geometrically, 1/n evenly where it is unbounded.
                    let m = if to == f64::INFINITY {
                        f64::from(i) / (80.0 * from)
                    } else {
                        1.0 / (from * libm::pow(to / from, f64::from(i) / 80.0))
                    };
                    for k in 0..=400 {
                        let v = end * f64::from(k) / 400.0;
                        let t = if m > 0.0 { -libm::expm1(-v * m) / m } else { v };
                        let distance = (exactly(stand_in, m, t) - libm::exp(-v)).abs();
                        most = most.max(if relative { distance * libm::exp(v) } else { distance });
                    }
                }
                // Doubles are off by 1e-13, relative to cosⁿ 256 times that.
                assert!(most <= hi + 1e-10, "{name}: {most:e} > {hi:e}");
                // The sample's steps of 1/80 of the range and 1/10 in v miss little of the top.
                assert!(most >= 0.97 * lo - 1e-10, "{name}: {most:e} < {lo:e}");
                let [n, t] = found.at;
                let v = -n * libm::log1p(-t / n);
                if n < 1e6 && t < 0.999 * n {
                    let distance = (exactly(stand_in, 1.0 / n, t) - libm::exp(-v)).abs();
                    let there = if relative { distance * libm::exp(v) } else { distance };
                    assert!((there / lo - 1.0).abs() < 1e-6, "{name}: {there:e} at {n} {t}, {lo:e}");
                }
            }
        }
    }
}

/// The older path: branch and bound over n ≥ 16 in other variables, each row enclosed to 2e-4.
#[test]
fn the_table_of_bells_says_the_same() {
    let path = format!("{}/fits/kernels-cosn.csv", env!("CARGO_MANIFEST_DIR"));
    let mut seen = 0;
    for row in csv::Reader::from_path(path).unwrap().records() {
        let row = row.unwrap();
        let id = if &row[23] == "true" { "cs-16".to_owned() } else { format!("{}-{}", &row[21], &row[1]) };
        let Some(stand_in) = StandIn::from_id(&id) else { continue };
        let most: f64 = row[13].parse().unwrap();
        let found = approximation(stand_in, (16.0, f64::INFINITY), Measure::Absolute).unwrap().value;
        assert!(found.lo() <= most && found.hi() >= most * (1.0 - 3e-4), "{id}: {found:?} {most:e}");
        seen += 1;
    }
    assert_eq!(seen, 9);
}

/// Lyon's bell against e⁻ᵗ is 1.7277e-2 (the lobe paper's 1.7e-2, and the row of fits/kernels.csv); at n = 16 cosⁿ
/// is (1 - t/16)¹⁶, so e⁻ᵗ is as far from it.
#[test]
fn lyons_bell_and_the_gaussian_at_sixteen_are_equally_far() {
    let lyon = approximation(StandIn::Cs16, (1e12, f64::INFINITY), Measure::Absolute).unwrap().value;
    let gaussian = approximation(StandIn::SphericalGaussian, (16.0, 16.0), Measure::Absolute).unwrap().value;
    let printed = Interval::new(1.72765e-2, 1.72775e-2);
    assert!(!lyon.is_disjoint(gaussian) && !lyon.is_disjoint(printed) && !gaussian.is_disjoint(printed));
}

/// e^(v - t) - 1 rises with v and falls with n: at the floor F and the least n it is e^g - 1 with g = -ln F - n (1 -
/// F^(1/n)).
#[test]
fn the_gaussians_relative_error_is_its_closed_form() {
    for (from, to) in [(1.0, 64.0), (16.0, f64::INFINITY), (1000.0, 1000.0)] {
        let measure = Measure::Relative { floor: FLOOR };
        let found = approximation(StandIn::SphericalGaussian, (from, to), measure).unwrap().value;
        let g = -libm::log(FLOOR) + from * libm::expm1(libm::log(FLOOR) / from);
        let exact = libm::expm1(g);
        assert!(
            found.lo() <= exact * (1.0 + 1e-12) && exact * (1.0 - 1e-12) <= found.hi(),
            "{from}: {found:?}"
        );
    }
}

#[test]
fn what_is_cos_n_is_at_no_distance_and_what_is_no_range_is_told() {
    for measure in [Measure::Absolute, Measure::Relative { floor: FLOOR }] {
        for (stand_in, n) in [
            (StandIn::Power, (1.0, f64::INFINITY)),
            (StandIn::Exp2Log2, (16.0, 1024.0)),
            (StandIn::Squarings, (2.0, 3.0)),
            (StandIn::Cs16, (16.0, 16.0)),
            (StandIn::Schlick, (1.0, 1.0)),
        ] {
            assert_eq!(approximation(stand_in, n, measure).unwrap().value, Interval::ZERO);
        }
    }
    // Next to n = 16 the two part.
    assert!(approximation(StandIn::Cs16, (16.0, 16.1), Measure::Absolute).unwrap().value.lo() > 1e-5);
    let (nan, infinity) = (f64::NAN, f64::INFINITY);
    for n in [(0.5, 2.0), (2.0, 1.0), (nan, 2.0), (1.0, nan), (infinity, infinity), (-2.0, -1.0)] {
        assert_eq!(approximation(StandIn::Cs16, n, Measure::Absolute), None, "{n:?}");
    }
    for floor in [0.0, 1.0, nan, -0.5] {
        assert_eq!(approximation(StandIn::Cs16, (16.0, 32.0), Measure::Relative { floor }), None);
    }
}
