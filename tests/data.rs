//! Lobes fitted to samples: known parameters come back, within the errors stated, whatever the rows' order and units.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::fit::measured::{
    Comparison, DataError, Doubt, EXAMPLE_DATA, Estimate, Family, INDISTINCT, NoFit, NoUncertainty, Samples,
    Shape, Unit, Weighting, chi_square_tails, student_quantile,
};
use bellfit::stability::DoubleDouble;
use core::f64::consts::PI;
use draw::Draw;
use references::rows;

type Row = (f64, f64, f64);

/// Normal numbers by Box and Muller.
fn normal(draw: &mut Draw) -> f64 {
    let (u, v) = (draw.real(0.0, 1.0), draw.real(0.0, 1.0));
    (-2.0 * libm::log(1.0 - u)).sqrt() * libm::cos(2.0 * PI * v)
}

fn versine(degrees: f64) -> f64 {
    let s = libm::sin(0.5 * degrees * (PI / 180.0));
    2.0 * s * s
}

/// A shape well inside those that fall, for the free bells: near the adopted cubic one of K = 4.
const SHAPE: Shape = Shape { linear: -0.9, square: 0.7 };

/// Samples of a family with its scale, at `count` angles evenly up to where the lobe has fallen to about e⁻⁶.
fn exact(family: Family, scale: f64, n: f64, count: usize) -> Vec<Row> {
    let end = (2.0 * (6.0 / n).sqrt()).min(1.5) * 180.0 / PI / 1.41;
    let at = |i: usize| end * i as f64 / (count - 1) as f64;
    let value = |degrees: f64| scale * family.value(versine(degrees), n, shape(family));
    (0..count).map(at).map(|degrees| (degrees, value(degrees), 1.0)).collect()
}

fn shape(family: Family) -> Shape {
    if family.is_free() { SHAPE } else { Shape::default() }
}

fn fitted(rows: &[Row], weighting: Weighting, family: Family) -> Estimate {
    let samples = Samples::new(Unit::Degrees, weighting, rows).unwrap();
    Comparison::of(&samples, &[family]).unwrap().estimates.remove(0)
}

/// `EXAMPLE_DATA` is what its first lines say, drawn here again.
#[test]
fn the_example_is_what_it_says() {
    let mut draw = Draw(60);
    let rows: Vec<String> = (-20..=20)
        .map(|i| 2.0 * f64::from(i))
        .map(|degrees| {
            let lobe = 0.8 * libm::pow(libm::cos(degrees * (PI / 180.0)), 60.0);
            format!("{degrees},{:.3}", lobe + 0.01 * normal(&mut draw))
        })
        .collect();
    let body: Vec<&str> = EXAMPLE_DATA.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(body[0], "theta_deg,value");
    assert_eq!(body[1..].join("\n"), rows.join("\n"));
}

/// Without noise the parameters come back to a few roundings of the values, magnified by what a value says of a
/// parameter; α and β of a free bell, which the samples know a hundred times less well, to 1e-10.
#[test]
fn exact_samples_give_the_parameters_back() {
    for family in Family::ALL {
        for (scale, n) in [(1.0, 20.0), (0.8, 60.0), (3e-40, 400.0), (2e50, 30_000.0)] {
            let found = fitted(&exact(family, scale, n, 60), Weighting::Equal, family);
            let tolerance = if family.is_free() { 1e-10 } else { 1e-13 };
            assert!((found.n / n - 1.0).abs() < tolerance, "{family} {n}: {}", found.n);
            assert!((found.scale / scale - 1.0).abs() < tolerance, "{family} {scale}: {}", found.scale);
            assert!(found.rms < 4.0 * f64::EPSILON * scale, "{family}: {:e}", found.rms);
            assert!((found.shape.linear - shape(family).linear).abs() < 1e-9, "{family} {:?}", found.shape);
            assert!(found.uncertainty.is_ok(), "{family} {n}: {:?}", found.uncertainty);
        }
    }
}

/// How many sets of samples a family is fitted to.
const SEEDS: u64 = 400;

/// Of 400 intervals of 95 % a binomial number holds the truth: 380 ± 4.36. Four of these to each side are exceeded
/// with probability 6e-5 a count, 2e-3 over the 28 counts (2 parameters of 14 families).
const HELD: core::ops::RangeInclusive<usize> = 363..=397;
/// The mean of 400 errors, each in units of its standard error, is 0 ± 1/20 (of Student's t with 56 and 58 degrees
/// of freedom 1.8 % more); four of these as above.
const BIAS: f64 = 4.0 * 1.02 / 20.0;

#[test]
fn parameters_come_back_within_their_errors() {
    for (k, family) in (0_u64..).zip(Family::ALL) {
        let (scale, n) = (0.8, 60.0);
        // α and β enter less linearly: their errors are kept smaller.
        let noise = if family.is_free() { 1e-4 } else { 0.01 };
        let clean = exact(family, scale, n, 60);
        let (mut held, mut off, mut trends) = ([0; 2], [0.0; 2], 0);
        for seed in 0..SEEDS {
            let mut draw = Draw(1000 * k + seed);
            let rows: Vec<Row> =
                clean.iter().map(|&(x, v, q)| (x, v + noise * normal(&mut draw), q)).collect();
            let found = fitted(&rows, Weighting::Equal, family);
            let u = found.uncertainty.unwrap_or_else(|e| panic!("{family}, seed {seed}: {e}"));
            let parts = [
                (found.n, n, u.n, found.n_interval().unwrap()),
                (found.scale, scale, u.scale, found.scale_interval().unwrap()),
            ];
            for (i, (found, truth, error, (lo, hi))) in parts.into_iter().enumerate() {
                held[i] += usize::from(lo <= truth && truth <= hi);
                off[i] += (found - truth) / error / SEEDS as f64;
            }
            trends += usize::from(found.trend.is_some_and(|trend| trend.is_misfit()));
        }
        assert!(held.iter().all(|held| HELD.contains(held)), "{family}: {held:?} of {SEEDS} intervals");
        assert!(off.iter().all(|off| off.abs() < BIAS), "{family}: {off:?} standard errors off");
        // Once in 740, and less after a fit has taken its part: more than 5 of 400 has probability 5e-5.
        assert!(trends <= 5, "{family}: {trends} of {SEEDS} right shapes called wrong");
    }
}

/// With σ told the errors are absolute: the same with every seed, and the intervals are of the normal distribution.
/// Noise of different sizes, and the weights that say so.
#[test]
fn told_errors_are_absolute() {
    let (scale, n) = (2.0, 150.0);
    let clean = exact(Family::CosN, scale, n, 40);
    let (mut held, mut error) = ([0; 2], None);
    for seed in 0..SEEDS {
        let mut draw = Draw(77_000 + seed);
        let noisy = |(i, &(x, v, _)): (usize, &Row)| {
            let sigma = 0.005 * (1.0 + (i % 7) as f64);
            (x, v + sigma * normal(&mut draw), sigma)
        };
        let rows: Vec<Row> = clean.iter().enumerate().map(noisy).collect();
        let told = fitted(&rows, Weighting::Sigma, Family::CosN);
        let weights: Vec<Row> = rows.iter().map(|&(x, v, sigma)| (x, v, 1.0 / (sigma * sigma))).collect();
        let weighted = fitted(&weights, Weighting::Weight, Family::CosN);
        for (i, found) in [&told, &weighted].into_iter().enumerate() {
            let (lo, hi) = found.n_interval().unwrap();
            held[i] += usize::from(lo <= n && n <= hi);
        }
        // The same optimum; the weights differ by their rounding.
        assert!((told.n / weighted.n - 1.0).abs() < 1e-12);
        let u = told.uncertainty.unwrap();
        assert_eq!((u.degrees, told.freedom), (None, 38));
        // s = √(χ²/38) is what the relative error has more.
        let s = (told.chi_square / 38.0).sqrt();
        assert!((weighted.uncertainty.unwrap().n / (u.n * s) - 1.0).abs() < 1e-9);
        // It moves with n alone, by a few per cent.
        let first = *error.get_or_insert(u.n);
        assert!((u.n / first - 1.0).abs() < 0.1, "{} {first}", u.n);
    }
    assert!(held.iter().all(|held| HELD.contains(held)), "{held:?}");
}

#[test]
fn scipy_finds_the_same() {
    let samples = rows::<3>("measured_samples.csv");
    let read = |text: &String| text.parse::<f64>().unwrap();
    let samples: Vec<Row> = samples.iter().map(|[x, v, s]| (read(x), read(v), read(s))).collect();
    let mut count = 0;
    for row in rows::<8>("measured.csv") {
        let family = Family::from_id(&row[0]).unwrap();
        let [scale, n, scale_error, n_error, correlation, chi_square] =
            [2, 3, 4, 5, 6, 7].map(|i| read(&row[i]));
        let found = match row[1].as_str() {
            "equal" => fitted(&samples, Weighting::Equal, family),
            "sigma" => fitted(&samples, Weighting::Sigma, family),
            _ => {
                let weights: Vec<Row> = samples.iter().map(|&(x, v, s)| (x, v, 1.0 / (s * s))).collect();
                fitted(&weights, Weighting::Weight, family)
            }
        };
        let u = found.uncertainty.unwrap();
        // MINPACK stops where a step no longer lowers the sum of squares, which is flat over √ε of an error.
        assert!((found.n - n).abs() < 1e-5 * n_error, "{row:?}: {}", found.n);
        assert!((found.scale - scale).abs() < 1e-5 * scale_error, "{row:?}: {}", found.scale);
        // The Jacobian moves with the parameters, by as much at most.
        for (own, other) in [(u.n, n_error), (u.scale, scale_error), (u.correlation, correlation)] {
            assert!((own / other - 1.0).abs() < 1e-6, "{row:?}: {own} {other}");
        }
        assert!((found.chi_square / chi_square - 1.0).abs() < 1e-10, "{row:?}: {}", found.chi_square);
        count += 1;
    }
    assert_eq!(count, 24);
}

#[test]
fn student_quantiles_are_the_published_ones() {
    // Two-sided 95 %, as printed: NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2.
    let printed = [(1, 12.706), (2, 4.303), (3, 3.182), (5, 2.571), (10, 2.228), (30, 2.042), (100, 1.984)];
    for (degrees, t) in printed {
        assert!((student_quantile(0.95, Some(degrees)) - t).abs() <= 5e-4, "{degrees}");
    }
    for [p, degrees, t] in rows::<3>("student.csv") {
        let found = student_quantile(p.parse().unwrap(), degrees.parse().ok());
        let t: f64 = t.parse().unwrap();
        assert!((found / t - 1.0).abs() < 1e-11, "{p} {degrees}: {found} {t}");
    }
}

#[test]
fn chi_square_tails_are_the_references() {
    let mut count = 0;
    for [degrees, x, below, above] in rows::<4>("chi_square.csv") {
        let found = chi_square_tails(x.parse().unwrap(), degrees.parse().unwrap());
        let (below, above): (f64, f64) = (below.parse().unwrap(), above.parse().unwrap());
        // The smaller tail as its documentation says; the larger is 1 less the other.
        let (small, exact) = if below < above { (found.0, below) } else { (found.1, above) };
        assert!((small / exact - 1.0).abs() < 1e-11, "{degrees} {x}: {small} {exact}");
        for (tail, exact) in [(found.0, below), (found.1, above)] {
            assert!((tail - exact).abs() < 1e-11 * small + 1e-15, "{degrees} {x}: {tail} {exact}");
        }
        count += 1;
    }
    assert_eq!(count, 120);
}

/// Sets of 40 samples with noise of 0.01, whose file says a tenth of it, the truth, and ten times as much.
#[test]
fn sigmas_that_do_not_hold_are_told() {
    let clean = exact(Family::CosN, 0.8, 60.0, 40);
    let (mut excess, mut short, mut mean) = ([0; 3], [0; 3], 0.0);
    for seed in 0..SEEDS {
        let mut draw = Draw(55_000 + seed);
        let values: Vec<(f64, f64)> =
            clean.iter().map(|&(x, v, _)| (x, v + 0.01 * normal(&mut draw))).collect();
        for (i, told) in [0.001, 0.01, 0.1].into_iter().enumerate() {
            let rows: Vec<Row> = values.iter().map(|&(x, v)| (x, v, told)).collect();
            let goodness = fitted(&rows, Weighting::Sigma, Family::CosN).goodness.unwrap();
            excess[i] += usize::from(goodness.is_excess());
            short[i] += usize::from(goodness.is_short());
            if i == 1 {
                mean += goodness.reduced / SEEDS as f64;
            }
        }
    }
    assert_eq!(([excess[0], short[0]], [excess[2], short[2]]), ([400, 0], [0, 400]));
    // Once in 1000 each: more than 4 of 400 has probability 6e-5.
    assert!(excess[1] <= 4 && short[1] <= 4, "{excess:?} {short:?}");
    // χ²/38 is 1 ± √(2/38), the mean of 400 of them 1 ± 0.0115; four of these.
    assert!((mean - 1.0).abs() < 0.046, "{mean}");
    // The wrong family's residuals are larger too, and nothing is said where no sigmas are.
    let rows: Vec<Row> = clean.iter().map(|&(x, v, _)| (x, v, 0.01)).collect();
    assert!(fitted(&rows, Weighting::Sigma, Family::Schlick).goodness.unwrap().is_excess());
    assert_eq!(fitted(&rows, Weighting::Equal, Family::Schlick).goodness, None);
}

/// ΔBIC tells families apart only where the sigmas by which it weighs the residuals hold.
#[test]
fn sigmas_too_small_tell_nothing_apart() {
    let of = |sigma: f64| {
        let rows: Vec<Row> =
            noisy(Family::CosN, 60, 0.01).into_iter().map(|(x, v, _)| (x, v, sigma)).collect();
        let samples = Samples::new(Unit::Degrees, Weighting::Sigma, &rows).unwrap();
        Comparison::of(&samples, &[Family::CosN, Family::Schlick]).unwrap()
    };
    let (held, small) = (of(0.01), of(0.001));
    assert!(held.is_told_apart() && held.doubts().is_empty(), "{:?}", held.doubts());
    assert!(!small.is_told_apart());
    assert_eq!((small.as_good().count(), small.doubts()), (1, vec![Doubt::Excess]));
}

/// Five samples more than parameters, or fewer, tell nothing apart, whatever their BIC.
#[test]
fn few_samples_tell_nothing_apart() {
    let of = |count: usize, families: &[Family]| {
        let samples = Samples::new(Unit::Degrees, Weighting::Equal, &noisy(Family::CosN, count, 1e-6));
        Comparison::of(&samples.unwrap(), families).unwrap()
    };
    let two = [Family::CosN, Family::Schlick];
    for count in [4, 7] {
        let found = of(count, &two);
        assert!(found.behind(&found.estimates[1]) > INDISTINCT, "{count}");
        assert_eq!(found.doubts(), [Doubt::FewLeft { freedom: count - 2 }]);
        assert!(!found.is_told_apart());
        // One alone is compared with nothing.
        assert_eq!(of(count, &two[..1]).doubts(), []);
    }
    assert!(of(8, &two).is_told_apart());
    // With a family of four parameters beside them nine are too few.
    assert_eq!(
        of(9, &[Family::CosN, Family::Schlick, Family::Free4]).doubts(),
        [Doubt::FewLeft { freedom: 5 }]
    );
}

/// A best family whose n or shape stands at an end is none that is told apart, and a known one goes before it.
#[test]
fn the_end_of_a_range_is_no_answer() {
    // A value that rises away from the axis.
    let rows: Vec<Row> = (0..40).map(f64::from).map(|x| (x, 1.0 + 1e-3 * x, 1.0)).collect();
    let samples = Samples::new(Unit::Degrees, Weighting::Equal, &rows).unwrap();
    let found = Comparison::of(&samples, &[Family::CosN, Family::Cubic4]).unwrap();
    assert!(found.behind(&found.estimates[1]) > INDISTINCT);
    assert_eq!(found.doubts(), [Doubt::NotKnown(NoUncertainty::AtBound { end: 0.1 })]);
    assert!(!found.is_told_apart());
    // cosⁿ with n = 10: the bells stop at 16. With much noise BIC does not see it, and the known family is handed out,
    // though a bell is cheaper.
    let wide = |noise: f64| {
        let mut draw = Draw(21);
        let value = |x: f64| libm::pow(libm::cos(x * (PI / 180.0)), 10.0);
        let rows: Vec<Row> =
            (0..40).map(f64::from).map(|x| (x, value(x) + noise * normal(&mut draw), 1.0)).collect();
        let samples = Samples::new(Unit::Degrees, Weighting::Equal, &rows).unwrap();
        Comparison::of(&samples, &[Family::CosN, Family::Cubic4]).unwrap()
    };
    let found = wide(0.5);
    assert_eq!(found.as_good().count(), 2);
    let bell = found.estimates.iter().find(|estimate| estimate.family == Family::Cubic4).unwrap();
    assert_eq!(bell.uncertainty, Err(NoUncertainty::AtBound { end: 16.0 }));
    assert_eq!(found.cheapest().family, Family::CosN);
}

/// Noise of half the scale: the interval of n, a factor to each side, stays above 0 where n ± t errors does not, and
/// holds the truth as often as it says.
#[test]
fn intervals_of_an_exponent_stay_positive() {
    let (scale, n) = (0.8, 60.0);
    let clean = exact(Family::CosN, scale, n, 40);
    let (mut held, mut below) = (0, 0);
    for seed in 0..SEEDS {
        let mut draw = Draw(91_000 + seed);
        let rows: Vec<Row> = clean.iter().map(|&(x, v, q)| (x, v + NOISE * normal(&mut draw), q)).collect();
        let found = fitted(&rows, Weighting::Equal, Family::CosN);
        let Ok(u) = found.uncertainty else { continue };
        let (lo, hi) = found.n_interval().unwrap();
        assert!(0.0 < lo && lo < found.n && found.n < hi && hi.is_finite(), "{found}: {lo} {hi}");
        // The same factor to both sides.
        assert!((found.n / lo / (hi / found.n) - 1.0).abs() < 1e-14);
        below += usize::from(found.n - u.quantile() * u.n <= 0.0);
        held += usize::from(lo <= n && n <= hi);
    }
    assert!(below > 0);
    assert!(HELD.contains(&held), "{held} of {SEEDS}, {below} below 0");
}
const NOISE: f64 = 0.4;

/// Differences in double-double: central ones over 1e-8 of the parameter, wrong by 1e-16 of its third derivative
/// and 1e-24 of rounding.
#[test]
fn slopes_are_derivatives() {
    type D = DoubleDouble;
    let d = D::from;
    let one = || d(1.0);
    // A number of double-double, as every constant of a formula is a double.
    let value = |family: Family, w: f64, n: D, shape: [D; 2]| -> D {
        let w = d(w);
        let bell = |power: u32, s: D, [a, b]: [D; 2]| {
            let y = s * w;
            let p = (one() - y) * (one() + a * y + b * y * y);
            if y < one() { p.squared(power.trailing_zeros()) } else { d(0.0) }
        };
        match family {
            Family::CosN => (n * w.log_one_minus()).exp(),
            Family::SphericalGaussian => (-(n * w)).exp(),
            Family::Schlick => (one() - w) / ((one() - w) + n * w),
            Family::Free2 | Family::Free4 | Family::Free8 => {
                let power = [Family::Free2, Family::Free4, Family::Free8].iter().position(|f| *f == family);
                let power = 2_u32 << power.unwrap();
                bell(power, n / (d(f64::from(power)) * (one() - shape[0])), shape)
            }
            _ => {
                let formula = family.stand_in().formula().unwrap();
                let m = one() / n;
                let at = |[a, b, c]: [f64; 3]| d(a) + m * (d(b) + m * d(c));
                bell(formula.power, n / at(formula.reach), [at(formula.linear), at(formula.square)])
            }
        }
    };
    for family in Family::ALL {
        for n in [16.5, 60.0, 1000.0, 1e6] {
            for t in [0.0, 0.1, 0.7, 2.0, 5.0_f64] {
                let w = (t / n).min(1.0);
                let shape = shape(family);
                let own = family.slopes(w, n, shape);
                let [a, b] = [shape.linear, shape.square];
                let h = 1e-8;
                let difference = |up: D, down: D| ((up - down) / d(2.0 * h)).to_f64();
                let by_n = difference(
                    value(family, w, d(n) + d(n) * d(h), [d(a), d(b)]),
                    value(family, w, d(n) - d(n) * d(h), [d(a), d(b)]),
                );
                let mut expected = [by_n, 0.0, 0.0];
                if family.is_free() {
                    let at = |da: f64, db: f64| value(family, w, d(n), [d(a) + d(da), d(b) + d(db)]);
                    expected[1] = difference(at(h, 0.0), at(-h, 0.0));
                    expected[2] = difference(at(0.0, h), at(0.0, -h));
                }
                for (own, expected) in own.iter().zip(expected) {
                    // Values of size 1 with a dozen roundings, each magnified by K.
                    assert!((own - expected).abs() < 1e-13, "{family} {n} {t}: {own} {expected}");
                }
            }
        }
    }
}

/// A set of samples with noise, to be turned about.
fn noisy(family: Family, count: usize, noise: f64) -> Vec<Row> {
    let mut draw = Draw(5);
    let clean = exact(family, 0.8, 60.0, count);
    clean.into_iter().map(|(x, v, _)| (x, v + noise * normal(&mut draw), 1.0)).collect()
}

const THREE: [Family; 3] = [Family::CosN, Family::Cubic2, Family::Free4];

#[test]
fn the_order_of_the_rows_does_not_matter() {
    let rows = noisy(Family::CosN, 50, 1e-3);
    let mut shuffled = rows.clone();
    let mut draw = Draw(9);
    for i in (1..shuffled.len()).rev() {
        shuffled.swap(i, draw.below(i + 1));
    }
    for family in THREE {
        let [a, b] = [&rows, &shuffled].map(|rows| fitted(rows, Weighting::Equal, family));
        // To the bit but for the row's own number, which moves with the row.
        assert_eq!(rows[a.worst.row - 1], shuffled[b.worst.row - 1]);
        assert_eq!(Estimate { worst: a.worst, ..b }, a);
    }
}

#[test]
fn scaled_values_scale_the_scale_and_its_error() {
    let rows = noisy(Family::CosN, 50, 1e-3);
    for factor in [1024.0, 1e-30, 3e40] {
        let scaled: Vec<Row> = rows.iter().map(|&(x, v, q)| (x, v * factor, q)).collect();
        for family in THREE {
            let [a, b] = [&rows, &scaled].map(|rows| fitted(rows, Weighting::Equal, family));
            let (ua, ub) = (a.uncertainty.unwrap(), b.uncertainty.unwrap());
            // Values rounded anew move a parameter by a part of its error that rounding is of the noise: 1e-13.
            let near = |x: f64, y: f64| (x / y - 1.0).abs() < 1e-11;
            assert!(near(b.n, a.n) && near(b.scale, a.scale * factor), "{family} {factor}");
            assert!(near(ub.n, ua.n) && near(ub.scale, ua.scale * factor), "{family} {factor}");
            assert!(near(b.rms, a.rms * factor) && near(b.chi_square, a.chi_square * factor * factor));
            if factor == 1024.0 {
                assert_eq!((b.n, b.scale), (a.n, a.scale * factor)); // a power of two: to the bit
            }
        }
    }
}

#[test]
fn weights_count_by_their_ratios_and_like_copies() {
    let rows = noisy(Family::CosN, 50, 1e-3);
    let weighted: Vec<Row> = (0..).zip(&rows).map(|(i, &(x, v, _))| (x, v, f64::from(1 + i % 3))).collect();
    let doubled: Vec<Row> = weighted.iter().map(|&(x, v, q)| (x, v, 2.0 * q)).collect();
    let copies: Vec<Row> =
        weighted.iter().flat_map(|&(x, v, q)| std::iter::repeat_n((x, v, 1.0), q as usize)).collect();
    let mut with_none = weighted.clone();
    with_none.push((1.0, 1e6, 0.0)); // nonsense that does not count
    for family in THREE {
        let fit = |rows: &[Row]| fitted(rows, Weighting::Weight, family);
        let (a, b, c, z) = (fit(&weighted), fit(&doubled), fit(&copies), fit(&with_none));
        assert_eq!((a.n, a.scale, a.uncertainty), (b.n, b.scale, b.uncertainty), "{family}");
        assert_eq!((a.n, a.uncertainty), (z.n, z.uncertainty), "{family}");
        // The sum of squares is the same, the degrees of freedom are those of more samples.
        let (p, near) = (family.parameters(), |x: f64, y: f64| (x / y - 1.0).abs() < 1e-10);
        let (ua, uc) = (a.uncertainty.unwrap(), c.uncertainty.unwrap());
        let freedom = ((copies.len() - p) as f64 / (rows.len() - p) as f64).sqrt();
        assert!(near(c.n, a.n) && near(c.chi_square, a.chi_square) && near(ua.n, uc.n * freedom), "{family}");
    }
}

/// k copies of every row shrink the errors by √k, but for the degrees of freedom: √((k N - p)/(N - p)).
#[test]
fn more_of_the_same_shrinks_the_errors() {
    let rows = noisy(Family::CosN, 50, 1e-3);
    for k in [2, 9] {
        let more: Vec<Row> = std::iter::repeat_n(&rows, k).flatten().copied().collect();
        for family in THREE {
            let [a, b] = [&rows, &more].map(|rows| fitted(rows, Weighting::Equal, family));
            let p = family.parameters();
            let shrunk = ((k * rows.len() - p) as f64 / (rows.len() - p) as f64).sqrt();
            let (ua, ub) = (a.uncertainty.unwrap(), b.uncertainty.unwrap());
            for (a, b) in [(ua.n, ub.n), (ua.scale, ub.scale)] {
                assert!((a / (b * shrunk) - 1.0).abs() < 1e-10, "{family} {k}");
            }
            assert!((a.n / b.n - 1.0).abs() < 1e-11, "{family} {k}");
        }
    }
}

#[test]
fn every_unit_gives_the_same_fit() {
    let rows = noisy(Family::CosN, 50, 1e-3);
    let of = |unit: Unit, angle: &dyn Fn(f64) -> f64| {
        let rows: Vec<Row> = rows.iter().map(|&(x, v, q)| (angle(x), v, q)).collect();
        let samples = Samples::new(unit, Weighting::Equal, &rows).unwrap();
        Comparison::of(&samples, &[Family::CosN]).unwrap().estimates.remove(0)
    };
    let degrees = of(Unit::Degrees, &|x| x);
    let others = [
        of(Unit::Degrees, &|x| if x.to_bits() % 2 == 0 { -x } else { x }),
        of(Unit::Radians, &|x| x * (PI / 180.0)),
        of(Unit::Cosine, &|x| libm::cos(x * (PI / 180.0))),
        of(Unit::Versine, &versine),
    ];
    for other in others {
        // A cosine is rounded to 1e-16, which n = 60 makes 6e-15 of the value.
        assert!(
            (other.n / degrees.n - 1.0).abs() < 1e-12 && (other.scale / degrees.scale - 1.0).abs() < 1e-12
        );
        let [a, b] = [&other, &degrees].map(|e| e.uncertainty.unwrap().n);
        assert!((a / b - 1.0).abs() < 1e-11);
    }
}

/// From samples of each family with little noise that family, or a free bell that holds it; the others are far
/// behind, and Schlick's tail is seen in a trend.
#[test]
fn the_right_family_wins() {
    for family in Family::ALL.into_iter().filter(|family| !family.is_free()) {
        let rows = noisy(family, 400, 1e-6);
        let samples = Samples::new(Unit::Degrees, Weighting::Equal, &rows).unwrap();
        let named: Vec<Family> = Family::ALL.into_iter().filter(|family| !family.is_free()).collect();
        let found = Comparison::of(&samples, &named).unwrap();
        assert_eq!(found.best().family, family);
        assert!(found.behind(&found.estimates[1]) > 10.0, "{family}: {}", found.estimates[1]);
        assert_eq!(found.cheapest().family, family);
        for other in &found.estimates[1..] {
            assert!(other.trend.unwrap().is_misfit(), "{family} fitted by {other}");
        }
        assert!(!found.best().trend.unwrap().is_misfit());
    }
    // With noise of a hundredth the cubic bell of K = 4, 4.8e-4 from cosⁿ, is as good and cheaper.
    let samples = Samples::new(Unit::Degrees, Weighting::Equal, &noisy(Family::CosN, 60, 0.01)).unwrap();
    let found = Comparison::of(&samples, &Family::ALL).unwrap();
    let good: Vec<Family> = found.as_good().map(|estimate| estimate.family).collect();
    assert!(good.contains(&Family::CosN) && good.contains(&Family::Cubic4), "{good:?}");
    assert_eq!(found.cheapest().family.cost(60.0).transcendentals, 0);
    assert!(!good.contains(&Family::Schlick));
}

/// The free bell's own shape, from samples of it.
#[test]
fn a_free_bell_finds_its_shape_with_its_errors() {
    let truth = Shape { linear: -0.9, square: 0.7 };
    let mut held = [0; 2];
    for seed in 0..SEEDS {
        let mut draw = Draw(31_000 + seed);
        let clean = exact(Family::Free4, 0.8, 60.0, 80);
        let rows: Vec<Row> =
            clean.into_iter().map(|(x, v, q)| (x, v + 1e-3 * normal(&mut draw), q)).collect();
        let found = fitted(&rows, Weighting::Equal, Family::Free4);
        let u = found.uncertainty.unwrap();
        let (linear, square) = u.shape.unwrap();
        held[0] += usize::from((found.shape.linear - truth.linear).abs() <= u.quantile() * linear);
        held[1] += usize::from((found.shape.square - truth.square).abs() <= u.quantile() * square);
    }
    assert!(held.iter().all(|held| HELD.contains(held)), "{held:?}");
}

#[test]
fn what_is_not_known_says_why() {
    // Flat: a lobe wider than any.
    let flat: Vec<Row> = (0..30).map(|i| (f64::from(i), 1.0, 1.0)).collect();
    let found = fitted(&flat, Weighting::Equal, Family::CosN);
    assert_eq!((found.n, found.uncertainty), (0.1, Err(NoUncertainty::AtBound { end: 0.1 })));
    // cos³θ is wider than the adopted bells go.
    let cubed = |degrees: f64| libm::pow(libm::cos(degrees * (PI / 180.0)), 3.0);
    let wide: Vec<Row> = (0..80).map(f64::from).map(|degrees| (degrees, cubed(degrees), 1.0)).collect();
    let found = fitted(&wide, Weighting::Equal, Family::Cubic4);
    assert_eq!((found.n, found.uncertainty), (16.0, Err(NoUncertainty::AtBound { end: 16.0 })));
    assert!((fitted(&wide, Weighting::Equal, Family::CosN).n - 3.0).abs() < 1e-12);
    // Schlick's tail is longer than a bell of K = 2 can have: its shape goes to the edge.
    let tail = |degrees: f64| Family::Schlick.value(versine(degrees), 100.0, Shape::default());
    let tail: Vec<Row> = (0..100).map(|i| 0.3 * f64::from(i)).map(|x| (x, tail(x), 1.0)).collect();
    let found = fitted(&tail, Weighting::Equal, Family::Free2);
    assert_eq!(found.uncertainty, Err(NoUncertainty::AtEdge), "{found:?}");
    // Below 0 there is no lobe.
    let below: Vec<Row> = (0..30).map(|i| (f64::from(i), -1.0, 1.0)).collect();
    let samples = Samples::new(Unit::Degrees, Weighting::Equal, &below).unwrap();
    assert_eq!(Comparison::of(&samples, &Family::ALL), Err(DataError::NoLobe));
    let one = Err(DataError::NoFit { family: Family::CosN, reason: NoFit::NoLobe });
    assert_eq!(Comparison::of(&samples, &[Family::CosN]), one);
    // Enough for two parameters, not for four.
    let few = Samples::new(Unit::Degrees, Weighting::Equal, &exact(Family::CosN, 1.0, 60.0, 4)).unwrap();
    let found = Comparison::of(&few, &Family::ALL).unwrap();
    assert_eq!(found.failures.len(), 3);
    assert!(
        found.failures.iter().all(|(f, e)| f.is_free() && *e == NoFit::TooFew { found: 4, parameters: 4 })
    );
    // Two samples in the lobe, one of them the peak: whatever n, one value alone says it.
    let spike: Vec<Row> = (0..30).map(|i| (f64::from(i) * 3.0, f64::from(u8::from(i == 0)), 1.0)).collect();
    let found = fitted(&spike, Weighting::Equal, Family::Cs16);
    assert!(found.uncertainty.is_err(), "{found:?}");
}
