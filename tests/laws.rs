//! Laws that tie the modules together: factors normalise, bounds contain what they bound and fit
//! inside one another, integrals keep the order of their integrands.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::bound::{
    Formula, Gaussian, Interval, Residual, cut_range, decimal, difference_supremum, exact, gaussian_distance,
    infimum, integral_enclosure, supremum,
};
use bellfit::fit::{Form, Problem, minimax};
use bellfit::integral::{AGREEMENT, Case, Edge, Field, GaussTable, Limit, Lobe, gauss_legendre};
use bellfit::kernel::constants::{CS16_MINIMAX, CS16_PRINTED};
use bellfit::kernel::factor::{cos_n_factor, cs_16_factor, cs_16_factor_printed};
use bellfit::kernel::model::Model;
use core::f64::consts::PI;
use draw::Draw;

fn cs16(model: Model, limit: Limit) -> Case {
    Case { model, lobe: Lobe::Cs16, limit }
}

fn cos_n(model: Model) -> Case {
    Case { model, lobe: Lobe::CosN, limit: Limit::Support }
}

/// A row of the constants, (a n + b)/(divisor π), as the exact numbers that its doubles are.
fn formula([a, b, divisor]: [f64; 3]) -> Formula {
    Formula::linear(&exact(a).unwrap(), &exact(b).unwrap(), &exact(divisor).unwrap())
}

/// Half of the draws even in n, half in 1/n, so that small exponents get their share.
fn exponent(draw: &mut Draw, from: f64, to: f64) -> f64 {
    let n = if draw.below(2) == 0 { draw.real(from, to) } else { 1.0 / draw.real(1.0 / to, 1.0 / from) };
    n.clamp(from, to)
}

/// [x] widened by a relative error.
fn within(x: f64, relative: f64) -> Interval {
    Interval::new(x * (1.0 - relative), x * (1.0 + relative))
}

#[test]
fn cos_n_factors_normalise_exactly() {
    let listed = [0.25, 1.0, 2.0, 3.5, 16.0, 16.5, 54.625, 100.25, 777.75, 1024.0, 65536.0, 1e9, 1e12];
    let mut draw = Draw(1977);
    let drawn = (0..200).map(|_| exponent(&mut draw, 1.0, 1e6));
    for n in listed.into_iter().chain(drawn) {
        for model in Model::ALL {
            let int = integral_enclosure(cos_n(model), n) * Interval::PI * Interval::from(2.0);
            // At most ten operations, the power of two within an ulp and n ± 2 exact or rounded once:
            // a relative error of 12 half ulps.
            let double = within(cos_n_factor(model, n), 6.0 * f64::EPSILON);
            assert!((double * int).contains(1.0), "{} at n = {n}: {:?}", model.id(), double * int);
            // In single precision n itself is another number.
            let n = n as f32;
            let int = integral_enclosure(cos_n(model), f64::from(n)) * Interval::PI * Interval::from(2.0);
            let single = within(f64::from(cos_n_factor(model, n)), 6.0 * f64::from(f32::EPSILON));
            assert!((single * int).contains(1.0), "{} in f32 at n = {n}: {:?}", model.id(), single * int);
        }
    }
}

/// Every real n, not only where it was computed: the exact factor's residual is 0, and one that is off by
/// 1e-6 of its value at n = 16 is seen to be.
#[test]
fn table_1_leaves_no_residual_over_the_reals() {
    for (model, factor) in [
        (Model::Phong, "(n + 1)/(2*pi)"),
        (Model::PhongModified, "(n + 2)/(2*pi)"),
        (Model::BlinnPhong, "(n + 2)/(4*pi*(2 - 2^(-n/2)))"),
        (Model::BlinnPhongModified, "(n + 2)*(n + 4)/(8*pi*(2^(-n/2) + n))"),
    ] {
        let off = format!("{factor}*(1 + 0.000016/n)").parse().unwrap();
        let factor: Formula = factor.parse().unwrap();
        let reals = Residual::new(cos_n(model), &factor).over_reals(16.0, 1024.0);
        assert_eq!((reals.max.value, reals.min.value), (Interval::from(0.0), Interval::from(0.0)));
        // 1.6e-5/n falls from 1e-6 to 1.5625e-8; the search is good to 1e-9.
        let reals = Residual::new(cos_n(model), &off).over_reals(16.0, 1024.0);
        for (extreme, value) in [(reals.max, 1e-6), (reals.min, 1.5625e-8)] {
            let found = extreme.value;
            assert!(found.contains(value) && found.width() < 1.1e-9, "{}: {extreme:?}", model.id());
        }
        // And the kernel is the formula: the same lobe held against both.
        let at = Residual::new(cos_n(model), &factor).at(123.25);
        let kernel = within(2.0 * PI * cos_n_factor(model, 123.25), 8.0 * f64::EPSILON);
        let product = kernel * integral_enclosure(cos_n(model), 123.25) - Interval::from(1.0);
        assert!(!at.is_disjoint(product), "{}: {at:?}, {product:?}", model.id());
    }
}

#[test]
fn the_refitted_factor_stays_within_its_certified_level() {
    let mut table = GaussTable::default();
    let mut draw = Draw(1993);
    for (model, row) in Model::ALL.into_iter().zip(CS16_MINIMAX) {
        let case = cs16(model, Limit::Support);
        let residual = Residual::new(case, &formula(row));
        let (integers, reals) = (residual.over_integers(16, 1024), residual.over_reals(16.0, 1024.0));
        let (level, over_reals) = (integers.magnitude().value.hi(), reals.magnitude().value.hi());
        let factor = cs_16_factor::<f64>(model);
        let mut at = |n: f64| 2.0 * PI * factor.at(n) * gauss_legendre(case, n, &mut table) - 1.0;
        for n in 16..=1024 {
            let height = at(f64::from(n)).abs();
            assert!(height <= level + AGREEMENT, "{case}: {height:e} at {n}, above {level:e}");
        }
        for _ in 0..200 {
            let n = exponent(&mut draw, 16.0, 1024.0);
            assert!(at(n).abs() <= over_reals + AGREEMENT, "{case} at {n}, above {over_reals:e}");
        }
        // No line does better than the exchange, and rounding to the constants' digits costs no more
        // than half a unit of the last ones: (δa n + δb)/(a n + b), largest at n = 16.
        let best = minimax(&Problem::new(case, 16, 1024).unwrap(), Form::Linear).unwrap().level;
        let half_unit = |x: f64| 0.5 * libm::pow(10.0, -f64::from(decimal(&format!("{x}")).unwrap().1));
        let rounding =
            (16.0 * half_unit(row[0]) + half_unit(row[1])) / (16.0 * row[0] + row[1]) * (1.0 + best);
        assert!(level >= best - AGREEMENT, "{case}: {level:e} is below the optimum {best:e}");
        assert!(level <= best + rounding + AGREEMENT, "{case}: {level:e}, {best:e}, {rounding:e}");
    }
}

#[test]
fn bounds_over_the_reals_contain_every_residual() {
    let mut table = GaussTable::default();
    let mut draw = Draw(1968);
    for (model, row) in Model::ALL.into_iter().zip(CS16_PRINTED) {
        let factor = cs_16_factor_printed::<f64>(model);
        for limit in Limit::ALL {
            let case = cs16(model, limit);
            let residual = Residual::new(case, &formula(row));
            let reals = residual.over_reals(16.0, 1024.0);
            let bounds = Interval::new(reals.min.value.lo(), reals.max.value.hi());
            for _ in 0..60 {
                let n = exponent(&mut draw, 16.0, 1024.0);
                let enclosed = residual.at(n);
                assert!(!enclosed.is_disjoint(bounds), "{case} at {n}: {enclosed:?}, outside {bounds:?}");
                let height = 2.0 * PI * factor.at(n) * gauss_legendre(case, n, &mut table) - 1.0;
                assert!(
                    (height - enclosed.mid()).abs() <= AGREEMENT,
                    "{case} at {n}: {height:e}, {enclosed:?}"
                );
            }
            // The integers are some of the reals.
            let integers = residual.over_integers(16, 1024);
            assert!(integers.max.value.lo() <= reals.max.value.hi(), "{case}: {integers:?}, {reals:?}");
            assert!(integers.min.value.hi() >= reals.min.value.lo(), "{case}: {integers:?}, {reals:?}");
        }
    }
}

/// 2π (s coef) Int - 1 = s (res + 1) - 1: extremes move with the factor.
#[test]
fn residuals_scale_with_their_factor() {
    let scale = Interval::from(1.25);
    for model in Model::ALL {
        let [a, b, divisor] = CS16_PRINTED[model as usize];
        let case = cs16(model, Limit::Paper);
        let plain = Residual::new(case, &formula([a, b, divisor])).over_reals(16.0, 1024.0);
        let scaled = formula([a, b, divisor]).times(&"5/4".parse().unwrap());
        let scaled = Residual::new(case, &scaled).over_reals(16.0, 1024.0);
        let one = Interval::from(1.0);
        for (before, after) in [(plain.max, scaled.max), (plain.min, scaled.min)] {
            let moved = (before.value + one) * scale - one;
            assert!(!moved.is_disjoint(after.value), "{case}: {moved:?}, {after:?}");
        }
    }
}

/// On [0, π/2] every weight is positive, cs_16 ≤ cosⁿ for n ≥ 16 (Bernoulli) up to its zero, and
/// √(6/n) lies before the zero, the zero before the support's end.
#[test]
fn integrals_keep_the_order_of_their_integrands() {
    let mut draw = Draw(1994);
    for _ in 0..300 {
        let n = exponent(&mut draw, 16.0, 1e5);
        for model in Model::ALL {
            let int = |limit| integral_enclosure(cs16(model, limit), n);
            let ordered = [
                int(Limit::Card),
                int(Limit::ExactZero),
                int(Limit::Support),
                integral_enclosure(cos_n(model), n),
            ];
            for pair in ordered.windows(2) {
                assert!(pair[0].lo() <= pair[1].hi(), "{} at n = {n}: {ordered:?}", model.id());
            }
            assert!(ordered[0].hi() < ordered[1].lo(), "{} at n = {n}: strictly", model.id());
        }
        // Beyond the zero the even power of (1) is positive again; up to 6/√n it is let in.
        let (zero, paper) = (cut_range(Limit::ExactZero, recip(n)), cut_range(Limit::Paper, recip(n)));
        let [without, with] =
            [Limit::ExactZero, Limit::Paper].map(|l| integral_enclosure(cs16(Model::Phong, l), n));
        if zero.hi() < paper.lo() {
            assert!(without.lo() <= with.hi(), "n = {n}: {without:?}, {with:?}");
        } else if paper.hi() < zero.lo() {
            assert!(with.lo() <= without.hi(), "n = {n}: {without:?}, {with:?}");
        }
    }
}

fn recip(n: f64) -> Interval {
    Interval::from(1.0) / Interval::from(n)
}

/// x ⊂ y gives f(x) ⊂ f(y), and f of every point lies in both.
#[test]
fn interval_functions_are_inclusion_monotone() {
    let mut draw = Draw(1966);
    let inside = |draw: &mut Draw, outer: Interval| {
        let (a, b) = (draw.real(outer.lo(), outer.hi()), draw.real(outer.lo(), outer.hi()));
        Interval::new(a.min(b), a.max(b))
    };
    type Function = fn(Interval) -> Interval;
    let functions: [(&str, f64, f64, Function); 8] = [
        ("exp", -30.0, 5.0, Interval::exp),
        ("ln", 1e-3, 20.0, Interval::ln),
        ("square root", 0.0, 9.0, Interval::square_root),
        ("versine ratio", 0.0, 2.4, |x| x.versine_ratio()),
        ("half power", 0.01, 2.0, |x| x.half_power()),
        ("square", -2.0, 3.0, |x| x.power(2)),
        ("cube", -2.0, 3.0, |x| x.power(3)),
        ("quotient", 0.1, 3.0, |x| Interval::from(1.0) / x - x * x),
    ];
    for (name, lo, hi, f) in functions {
        for _ in 0..500 {
            let outer = inside(&mut draw, Interval::new(lo, hi));
            let inner = inside(&mut draw, outer);
            let point = Interval::from(draw.real(inner.lo(), inner.hi()));
            assert!(f(outer).encloses(f(inner)), "{name}: {outer:?}, {inner:?}");
            assert!(f(inner).encloses(f(point)), "{name}: {inner:?}, {point:?}");
        }
    }
}

/// A part's supremum is no larger than the whole's, two halves' larger one is the whole's, and a finer
/// search agrees with a coarser one.
#[test]
fn suprema_fit_inside_one_another() {
    let one = Interval::from(1.0);
    // Hills of different height. Plain interval arithmetic bounds them to first order only, hence the
    // coarse tolerances.
    let hills = move |[x, y]: &[Interval; 2]| {
        (*x * (*x - one) * (*x - Interval::from(2.5)) + *y) * (one - *y * *y)
            - x.power(2) / Interval::from(5.0)
    };
    let mut draw = Draw(1979);
    let square = [Interval::new(0.0, 3.0), Interval::new(-1.0, 1.0)];
    let (coarse, fine, most) = (2e-2, 5e-3, 100_000);
    let (whole, least) = (supremum(hills, square, coarse, most), infimum(hills, square, coarse, most));
    // The width is the tolerance and the rounding where the best value was found.
    assert!(whole.value.width() <= 1.001 * coarse && least.value.width() <= 1.001 * coarse);
    let finer = supremum(hills, square, fine, most);
    assert!(finer.value.width() <= 1.001 * fine);
    assert!(!finer.value.is_disjoint(whole.value) && finer.boxes >= whole.boxes);
    for _ in 0..20 {
        let cut = draw.real(0.1, 2.9);
        let halves = [Interval::new(0.0, cut), Interval::new(cut, 3.0)]
            .map(|side| supremum(hills, [side, square[1]], coarse, most).value);
        assert!(halves.iter().all(|half| half.lo() <= whole.value.hi()), "{halves:?}, {whole:?}");
        assert!(!halves[0].max(halves[1]).is_disjoint(whole.value), "{halves:?}, {whole:?}");
    }
    for _ in 0..5000 {
        let value = hills(&[draw.real(0.0, 3.0), draw.real(-1.0, 1.0)].map(Interval::from));
        assert!(value.lo() <= whole.value.hi() && least.value.lo() <= value.hi());
    }
}

/// sup over a range is the larger of the suprema over its parts, for Δ and for the Gaussians.
#[test]
fn suprema_over_n_are_those_of_their_parts() {
    let split = |end: f64, middle: f64| {
        [(16.0, middle), (middle, end), (16.0, end)].map(|(from, to)| Interval::new(from, to))
    };
    for cut in [Limit::ExactZero, Limit::Card] {
        let [left, right, all] = split(1024.0, 100.0).map(|n| difference_supremum(cut, n, 1e-6).value);
        assert!(!left.max(right).is_disjoint(all), "{}: {left:?}, {right:?}, {all:?}", cut.id());
        assert!(left.hi() < right.lo(), "{}: Δ grows with n", cut.id());
    }
    for kind in Gaussian::ALL {
        let [left, right, all] = split(160.0, 48.0).map(|n| gaussian_distance(kind, n, 1e-6).value);
        assert!(!left.max(right).is_disjoint(all), "{}: {left:?}, {right:?}, {all:?}", kind.id());
        assert!(right.hi() < left.lo(), "{}: its distance falls with n", kind.id());
    }
}
