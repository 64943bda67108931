//! The better bells: their levels against references, their certificates against samples, and the
//! kernels that carry them.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::bound::{Interval, LobeIntegral, Residual, decimal, exponential_bell};
use bellfit::fit::bell::{CosineBell, ExponentialBell, Shape, cosine_bells, exponential_bells, polish};
use bellfit::fit::{Factor, FactorForm, Objective, fit_factor};
use bellfit::integral::{GaussLegendre, ScaledIntegral};
use bellfit::kernel::constants::{CUBIC_COS_N, CUBIC_EXP};
use bellfit::kernel::cubic::{BellFormula, CubicLobe, cubic_bell, cubic_lobe};
use bellfit::kernel::factor::cubic_factor;
use bellfit::kernel::lobe::cos_n_versine;
use bellfit::kernel::model::{Convention, LobeAngle, Model};
use bellfit::kernel::real::Real;
use draw::Draw;
use references::{Reference, rows};
use std::sync::OnceLock;

fn exponential() -> &'static [ExponentialBell] {
    static ROWS: OnceLock<Vec<ExponentialBell>> = OnceLock::new();
    ROWS.get_or_init(|| exponential_bells().unwrap())
}

fn cosine() -> &'static [CosineBell] {
    static ROWS: OnceLock<Vec<CosineBell>> = OnceLock::new();
    ROWS.get_or_init(|| cosine_bells().unwrap())
}

/// p(t)^K as a row states it, cut where the row says.
fn value(row: &ExponentialBell, t: f64) -> f64 {
    let ([c1, c2, c3], z) = (row.coefficients, t / f64::from(row.power));
    let p = 1.0 - z * (c1 - z * (c2 - z * c3));
    if t > row.proof.cut.lo() { 0.0 } else { libm::pow(p, f64::from(row.power)) }
}

/// What the bells are for: at so many operations, at most this error.
#[test]
fn the_frontier_is_where_it_was_promised() {
    let best = |rows: &mut dyn Iterator<Item = (u32, f64)>, operations: u32| {
        rows.filter(|row| row.0 <= operations).map(|row| row.1).fold(f64::INFINITY, f64::min)
    };
    for (operations, promised) in [(5, 3.6e-3), (6, 5.0e-4), (7, 6.0e-5)] {
        let proper = |row: &&ExponentialBell| row.proof.continuous && row.proof.decreasing;
        let mut rows = exponential().iter().filter(proper).map(|r| (r.cost.from_t, r.error.value.hi()));
        assert!(best(&mut rows, operations) <= promised, "exp, {operations} operations");
        let proper = |row: &&CosineBell| {
            row.proof.continuous && row.proof.decreasing && row.proof.negative_beyond && row.from <= 16.0
        };
        let mut rows = cosine().iter().filter(proper).map(|r| (r.cost.from_t, r.error.value.hi()));
        assert!(best(&mut rows, operations) <= promised, "cos^n from t, {operations} operations");
    }
    for (operations, promised) in [(6, 2.4e-3), (7, 5.0e-4), (8, 6.0e-5)] {
        let mut rows = cosine().iter().map(|row| (row.cost.from_cos, row.error.value.hi()));
        assert!(best(&mut rows, operations) <= promised, "cos^n from cos, {operations} operations");
    }
    let rescaled = exponential().iter().find(|r| r.shape == Shape::Linear && r.power == 16 && !r.printed);
    assert!(rescaled.unwrap().error.value.hi() <= 8.0e-3);
}

#[test]
fn levels_and_coefficients_are_the_references() {
    for [power, c1, c2, c3, level, cut] in rows("bells.csv") {
        let power: u32 = power.parse().unwrap();
        let row = exponential().iter().find(|r| r.shape == Shape::Cubic && r.power == power).unwrap();
        // The system's Jacobian leaves the coefficients about six digits fewer than the level.
        assert!(Reference::parse(&level).unwrap().is_near(row.level, 1e-9), "level, K = {power}");
        for (found, expected) in row.coefficients.iter().zip([c1, c2, c3]) {
            assert!(Reference::parse(&expected).unwrap().is_near(*found, 1e-5), "K = {power}: {found}");
        }
        let certified = row.error.value;
        let expected = Reference::parse(&level).unwrap().to_f64();
        assert!(certified.lo() >= expected * (1.0 - 1e-6), "K = {power}: no p is better than the best");
        assert!(certified.hi() <= expected * 1.0003, "K = {power}: {certified:?}");
        assert!(Reference::parse(&cut).unwrap().is_near(row.cut, 1e-5), "K = {power}");
    }
}

#[test]
fn the_minimax_error_equioscillates() {
    for row in exponential().iter().filter(|row| !row.printed) {
        let unknowns = row.shape.unknowns();
        assert_eq!(row.alternation.len(), unknowns + 1, "{} {}", row.shape.id(), row.power);
        let cut = row.proof.cut.lo();
        let errors: Vec<f64> = row
            .alternation
            .iter()
            .enumerate()
            .map(|(i, &t)| {
                // The last place of a bell that jumps is beyond its cut, the one before may be at it.
                let beyond = i == unknowns && row.shape == Shape::Jump;
                libm::exp(-t) - if beyond { 0.0 } else { value(row, t.min(cut)) }
            })
            .collect();
        for pair in errors.windows(2) {
            assert!(pair[0] * pair[1] < 0.0, "{} {}: {errors:?}", row.shape.id(), row.power);
        }
        for error in &errors {
            // Twelve digits of the coefficients, K times in the power.
            let slack = 1e-11 * f64::from(row.power) + 1e-6 * row.level;
            assert!((error.abs() - row.level).abs() < slack, "{} {}: {errors:?}", row.shape.id(), row.power);
        }
    }
}

/// Around an optimum every way leads up.
#[test]
fn no_neighbour_is_nearer() {
    let mut draw = Draw(7);
    for power in [2, 4, 8] {
        let best = polish(Shape::Cubic, power).unwrap();
        for _ in 0..200 {
            let moved: Vec<f64> =
                best.unknowns.iter().map(|x| x * (1.0 + 1e-3 * draw.real(-1.0, 1.0))).collect();
            let piece = Shape::Cubic.piece(&moved);
            let error = |i: u32| {
                let y = f64::from(i) / 2000.0;
                (libm::exp(-y * piece.reach) - libm::pow(piece.at(y), f64::from(power))).abs()
            };
            let worst = (0..=2000).map(error).fold(0.0, f64::max);
            // The grid misses an extreme by the square of its step: 1e-5 of the level.
            assert!(worst > best.level * (1.0 - 1e-4), "K = {power}: {worst} below {}", best.level);
        }
    }
}

#[test]
fn certificates_hold_what_samples_show() {
    for row in exponential() {
        let certified = row.error.value;
        let worst = (0..=40_000)
            .map(|i| f64::from(i) * 1e-3)
            .map(|t| (libm::exp(-t) - value(row, t)).abs())
            .fold(0.0, f64::max);
        assert!(worst <= certified.hi(), "{} {}: {worst}", row.shape.id(), row.power);
        let at = row.error.at[0];
        // At its cut a bell that jumps is looked at from beyond.
        let there = if at < row.proof.cut.lo() { value(row, at) } else { 0.0 };
        let reached = (libm::exp(-at) - there).abs();
        assert!(reached >= certified.lo() - 1e-13, "{} {}", row.shape.id(), row.power);
        assert!(certified.width() <= 1e-5 * certified.hi(), "{} {}", row.shape.id(), row.power);
        assert!(row.proof.decreasing, "{} {}", row.shape.id(), row.power);
        assert_eq!(row.proof.continuous, row.shape.is_continuous(), "{} {}", row.shape.id(), row.power);
        let turns = matches!(row.shape, Shape::Double | Shape::Jump);
        assert_eq!(row.proof.negative_beyond, !turns, "{} {}", row.shape.id(), row.power);
    }
    let mut draw = Draw(11);
    for row in cosine() {
        let (formula, certified) = (row.formula, row.error.value);
        for _ in 0..200_000 {
            let n = 16.0 * libm::exp2(draw.real(0.0, 20.0));
            let w = draw.real(0.0, (formula.reach[0] * 1.2 / n).min(1.0));
            let (reach, linear, square) = formula.at(n);
            let y = n * w / reach;
            let bell = if y > 1.0 { 0.0 } else { (1.0 - y) * (1.0 + y * (linear + y * square)) };
            let error = libm::pow(bell, f64::from(formula.power)) - cos_n_versine(w, n);
            assert!(error.abs() <= certified.hi() + 1e-14, "{formula:?} n = {n}, w = {w}: {error}");
        }
        assert!(row.proof.decreasing && row.proof.continuous && row.proof.negative_beyond, "{formula:?}");
        assert!(certified.width() <= 3e-4 * certified.hi(), "{formula:?}: {certified:?}");
        // Reached where it says, to the rounding of a few operations.
        let [m, y] = row.error.at;
        let p = |row: [f64; 3]| row[0] + m * (row[1] + m * row[2]);
        let (reach, linear, square) = (p(formula.reach), p(formula.linear), p(formula.square));
        let bell = libm::pow((1.0 - y) * (1.0 + y * (linear + y * square)), f64::from(formula.power));
        let target = if m == 0.0 { libm::exp(-y * reach) } else { cos_n_versine(y * reach * m, 1.0 / m) };
        let reached = (bell - target).abs();
        assert!(reached >= certified.lo() - 1e-13 && reached <= certified.hi() + 1e-13, "{formula:?}");
        // The limit's level is a floor for every formula, and reached to a per cent, or three where two
        // terms in 1/n do not quite do.
        let reach = if formula.power == 32 { 1.03 } else { 1.01 };
        assert!(certified.hi() >= row.limit * 0.999 && certified.hi() <= row.limit * reach, "{formula:?}");
    }
}

#[test]
fn a_coefficient_moved_is_a_certificate_lost() {
    let row = exponential().iter().find(|r| r.shape == Shape::Cubic && r.power == 4).unwrap();
    let [c1, c2, c3] = row.coefficients;
    let (error, _) = exponential_bell(4, [c1 + 1e-4, c2, c3], None, 1e-8).unwrap();
    assert!(error.value.lo() > row.error.value.hi(), "{error:?}");
}

#[test]
fn integrals_of_bells_are_the_references() {
    for [model, power, t0, t1, t2, a0, a1, a2, b0, b1, b2, n, scaled] in rows("bell-integrals.csv") {
        let number = |text: &str| text.parse::<f64>().unwrap();
        let formula = BellFormula {
            power: power.parse().unwrap(),
            reach: [number(&t0), number(&t1), number(&t2)],
            linear: [number(&a0), number(&a1), number(&a2)],
            square: [number(&b0), number(&b1), number(&b2)],
        };
        let integral = LobeIntegral::new("bell", formula, Model::from_id(&model).unwrap()).unwrap();
        let expected = Reference::parse(&scaled).unwrap();
        let m = Interval::from(1.0) / Interval::from(number(&n));
        let found = integral.scaled(&m);
        assert!(expected.is_enclosed(found), "{model} {formula:?} {n}: {found:?}");
        assert!(found.width() < 1e-12 * found.hi(), "{model} {formula:?} {n}: {found:?}");
        assert!(expected.is_near(integral.scaled(&m.mid()), 1e-13), "{model} {formula:?} {n}");
    }
}

/// The adopted constants are the rows, and the docs' numbers hold for them.
#[test]
fn the_kernels_carry_the_certified_bells() {
    let promised = [3.5e-3, 4.8e-4, 5.4e-5];
    for (i, power) in [2, 4, 8].into_iter().enumerate() {
        let row = exponential().iter().find(|r| r.shape == Shape::Cubic && r.power == power).unwrap();
        assert_eq!(row.coefficients, CUBIC_EXP[i]);
        assert!(row.error.value.hi() <= promised[i]);
        let row = cosine().iter().find(|r| r.shape == Shape::Cubic && r.formula.power == power).unwrap();
        assert_eq!(row.formula, CUBIC_COS_N[i]);
        assert!(row.error.value.hi() <= promised[i], "{row:?}");
    }
}

fn kernel_laws<F: Real, const K: u32>(bound: f64, epsilon: f64) {
    let f = F::from_f64;
    // Exact ends, and never rising in floating point: steps of the argument far above rounding.
    assert_eq!(cubic_bell::<K, F>(F::ZERO).to_f64(), 1.0);
    assert_eq!(cubic_bell::<K, F>(f(1e30)).to_f64(), 0.0);
    let mut last = 1.0;
    for i in 0..4000 {
        let t = f64::from(i) * 0.005;
        let found = cubic_bell::<K, F>(f(t)).to_f64();
        assert!((found - libm::exp(-f(t).to_f64())).abs() <= bound + 8.0 * epsilon, "K = {K}, t = {t}");
        assert!(found <= last, "K = {K}, t = {t}");
        last = found;
    }
    for n in [16.0, 20.0, 100.0, 1024.0, 65_536.0] {
        let lobe = CubicLobe::<K, F>::new(f(n));
        assert_eq!(lobe.at_versine(F::ZERO).to_f64(), 1.0);
        for i in 0..=2000 {
            let w = f(f64::from(i) / 2000.0 * (20.0_f64 / n).min(1.0));
            let found = lobe.at_versine(w).to_f64();
            let error = (found - cos_n_versine(w.to_f64(), n)).abs();
            assert!(error <= bound + 16.0 * epsilon, "K = {K}, n = {n}, w = {w:?}: {error}");
            // From an exact cosine: what the page says of the depressed form, beside the power's rounding
            // (K - 1 and the few roundings of p, K times).
            let cos = F::ONE - w;
            let exact = cos_n_versine(1.0 - cos.to_f64(), n);
            let error = (lobe.at(cos).to_f64() - exact).abs();
            let by_form = if K > 4 { 0.0 } else { 0.7 * n };
            assert!(error <= bound + (by_form + 16.0) * epsilon, "K = {K}, n = {n}, cos = {cos:?}: {error}");
        }
        assert_eq!(lobe.at(f(-0.25)).to_f64(), 0.0);
        assert_eq!(lobe.at_versine(f(1.5)).to_f64(), 0.0);
        assert!(lobe.at(F::NAN).is_nan() && lobe.at_versine(F::NAN).is_nan());
        assert_eq!(cubic_lobe::<K, F>(f(0.75), f(n)), lobe.at(f(0.75)));
    }
    for n in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(CubicLobe::<K, F>::new(f(n)).at_versine(f(0.01)).is_nan(), "n = {n}");
    }
    assert!(cubic_bell::<K, F>(F::NAN).is_nan());
    assert_eq!(cubic_bell::<K, F>(f(f64::INFINITY)).to_f64(), 0.0);
    assert!(cubic_bell::<K, F>(f(-0.5)).to_f64() > 1.0);
}

/// Importance sampling by cosⁿ: the ratio that its documentation promises.
#[test]
fn cos_n_covers_the_cubic_lobes() {
    fn largest<const K: u32>() -> f64 {
        let mut largest = 0.0_f64;
        for i in 0..=160 {
            let n = 16.0 * libm::exp2(f64::from(i) / 10.0);
            let lobe = CubicLobe::<K, f64>::new(n);
            for j in 0..=2000 {
                let w = f64::from(j) / 2000.0 * (16.0_f64 / n).min(1.0);
                let (bell, cosine) = (lobe.at_versine(w), cos_n_versine(w, n));
                if bell > 0.0 {
                    largest = largest.max(bell / cosine);
                }
            }
        }
        largest
    }
    let found = [largest::<2>(), largest::<4>(), largest::<8>()];
    assert!(found[0] <= 1.33 && found[1] <= 1.03 && found[2] <= 1.03, "{found:?}");
    assert!(found[0] > 1.3 && found[1] > 1.02 && found[2] > 1.02, "{found:?}");
}

/// The drop-in law: factor times lobe integrates to 1 and never above, by the model's own convention.
#[test]
fn cubic_factors_normalise_the_cubic_lobes() {
    // The losses that the constants' notes state, by model.
    fn check<const K: u32>(losses: [f64; 6]) {
        let rule = GaussLegendre::new(40);
        for (model, loss) in Model::ALL.into_iter().zip(losses) {
            let (edge, own) = match model.angle() {
                LobeAngle::Full => (1.0, 1.0),
                LobeAngle::Half => (1.0 - core::f64::consts::FRAC_1_SQRT_2, 4.0),
            };
            for i in 0..=80 {
                let n = 16.0 * libm::exp2(f64::from(i) / 8.0);
                let lobe = CubicLobe::<K, f64>::new(n);
                let end = (CUBIC_COS_N[K.trailing_zeros() as usize - 1].at(n).0 / n).min(edge);
                let weight = |w: f64| {
                    let c = 1.0 - w;
                    match (model.angle(), model.convention()) {
                        (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => 1.0,
                        (LobeAngle::Half, Convention::RdfCosine) => own * c * (2.0 * c * c - 1.0),
                        _ => own * c,
                    }
                };
                let integral = rule.integrate(|w| lobe.at_versine(w) * weight(w), 0.0, end);
                let share = core::f64::consts::TAU * cubic_factor::<K, f64>(model, n) * integral;
                // The rule is exact for these polynomials; what remains is rounding.
                assert!(share <= 1.0 + 1e-13, "K = {K}, {}, n = {n}: {share}", model.id());
                assert!(share >= 1.0 - loss, "K = {K}, {}, n = {n}: {share}", model.id());
            }
            assert!(cubic_factor::<K, f64>(model, f64::NAN).is_nan());
            assert_eq!(cubic_factor::<K, f32>(model, f32::INFINITY), f32::INFINITY);
        }
    }
    check::<2>([1.6e-7, 3.3e-7, 4.81e-4, 3.4e-5, 1.6e-7, 3.3e-7]);
    check::<4>([6.2e-7, 1.4e-6, 1.81e-4, 2.6e-5, 6.2e-7, 1.4e-6]);
    check::<8>([7.1e-6, 8.4e-6, 1.47e-4, 1.8e-5, 7.1e-6, 8.4e-6]);
}

/// One unit more in the last digit of p₀, and energy is gained somewhere.
#[test]
fn a_factor_one_unit_higher_is_refuted() {
    let bell = cosine().iter().find(|r| r.shape == Shape::Cubic && r.formula.power == 4).unwrap();
    for model in [Model::Phong, Model::BlinnPhong, Model::BlinnPhongModified] {
        let integral = LobeIntegral::new("cubic4", bell.formula, model).unwrap();
        let (range, form) = ("16..inf".parse().unwrap(), FactorForm::InverseSquare);
        let row = fit_factor(&integral, range, form, Objective::OneSided, 8).unwrap();
        assert!(row.extremes.max.value.hi() <= 0.0, "{}", row.factor);
        let mut parameters = row.factor.parameters().to_vec();
        let (value, places) = decimal(&parameters[0]).unwrap();
        let unit = libm::exp10(-f64::from(places));
        parameters[0] = format!("{:.*}", places as usize, value.to_f64().value() + unit);
        let higher = Factor::new(form, &parameters, row.factor.divisor()).unwrap();
        let found = Residual::new(integral, higher.formula()).largest(16.0, f64::INFINITY);
        assert!(found.value.lo() > 0.0, "{higher}: {found:?}");
    }
}

#[test]
fn kernels_keep_their_bounds_in_both_types() {
    kernel_laws::<f64, 2>(3.5e-3, f64::EPSILON);
    kernel_laws::<f64, 4>(4.8e-4, f64::EPSILON);
    kernel_laws::<f64, 8>(5.4e-5, f64::EPSILON);
    let single = f64::from(f32::EPSILON);
    kernel_laws::<f32, 2>(3.5e-3, single);
    kernel_laws::<f32, 4>(4.8e-4, single);
    kernel_laws::<f32, 8>(5.4e-5, single);
}
