//! Residuals against parabolas, poles and quotients worked out by hand.

use super::*;
use crate::bound::polynomial::Polynomial;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;

/// For Phong (modified) on the support Int = (16/17n)(1 - 8/(9n)) by hand, so with
/// (1.063 n + 1) the residual is (16/17)(1.063 + m)(1 - 8m/9) - 1, a parabola in m with its
/// top at m = 9/16 - 1.063/2.
#[test]
fn a_parabola_is_bounded_at_its_top() {
    let case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
    let factor: Formula = "(1.063*n + 1)/(2*pi)".parse().unwrap();
    let residual = Residual::new(case, &factor);
    let m = 9.0 / 16.0 - 1.063 / 2.0;
    let top = 16.0 / 17.0 * (1.063 + m) * (1.0 - 8.0 * m / 9.0) - 1.0;
    let reals = residual.over_reals(16.0, 1024.0);
    // The formula above loses a few ε of 1 by cancellation.
    assert!((reals.max.value.mid() - top).abs() < 1e-8 && reals.max.value.width() < 1e-8);
    assert!((reals.max.n - 1.0 / m).abs() < 0.1, "{}", reals.max.n);
    let integers = residual.over_integers(16, 1024);
    assert_eq!(integers.max.n, libm::round(1.0 / m));
    assert!(integers.max.value.hi() <= reals.max.value.hi());
    assert_eq!(integers.min.n, 16.0);
    assert!(integers.min.value.contains(4.0 / 9000.0)); // (16/17)(1.063 + 1/16)(17/18) - 1
}

/// A pole at an end of the range leaves the residual unknown there, and nothing else happens.
#[test]
fn a_pole_is_not_divided_by() {
    let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
    let residual = Residual::new(case, &"1/(n - 16)".parse().unwrap());
    assert_eq!(residual.in_rationals(1.0 / 16.0), None);
    let found = residual.over_reals(16.0, 64.0);
    assert!(found.max.value.hi() == f64::INFINITY && residual.at(16.0) == Interval::WHOLE);
}

/// A slow rise in which neighbours overlap must not leave the first n in the maximum's name.
#[test]
fn the_n_of_an_extreme_reaches_it() {
    let values: Vec<(f64, Interval)> =
        (0..10).map(f64::from).map(|n| (n, Interval::new(n, n + 1.5))).collect();
    let found = Extremes::of(&values).unwrap();
    assert_eq!((found.max.value, found.max.n), (Interval::new(9.0, 10.5), 8.0));
    assert_eq!((found.min.value, found.min.n), (Interval::new(0.0, 1.5), 0.0));
    assert!(Extremes::of(&[]).is_none());
}

#[test]
fn ties_go_to_the_smallest_n() {
    let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
    let residual = Residual::new(case, &"1.063*n/(2*pi)".parse().unwrap());
    assert_eq!(residual.over_integers(16, 1024).max.n, 16.0);
    assert_eq!(residual.over_reals(16.0, 1024.0).max.n, 16.0);
    assert_eq!(residual.over_integers(16, 1024).magnitude().n, 16.0);
}

/// (n² 2^(-n/2) + 3 π n + 5)/(n π + 2^(-n)) and other degrees, at n = 4: h = 1/4.
#[test]
fn quotients_are_read_term_by_term() {
    let pi = core::f64::consts::PI;
    for (text, value) in [
        ("(n^2*2^(-n/2) + 3*pi*n + 5)/(n*pi + 2^(-n))", (4.0 + 12.0 * pi + 5.0) / (4.0 * pi + 0.0625)),
        ("(n^3 - 2*n)/(n + 1)", 56.0 / 5.0),
        ("1/(n^2 + pi^2)", 1.0 / (16.0 + pi * pi)),
        ("2^(-n/2)", 0.25),
        ("3*n*2^(-n)/(n + 2^(-n/2))", 0.75 / 4.25),
        ("7", 7.0),
    ] {
        let formula: Formula = text.parse().unwrap();
        let compiled = Compiled::in_intervals(&formula);
        for factors in 0..4_i32 {
            let quarter = Interval::from(0.25);
            let found = compiled.at(&quarter, factors as u32, |c| *c, || quarter);
            let exact = value / libm::pow(4.0, f64::from(factors));
            assert!((found.mid() / exact - 1.0).abs() < 1e-14, "{text} {factors}: {found:?} {exact}");
            assert!(found.width() < 1e-13 * exact, "{text}: {found:?}");
        }
        // The same without a pole at n = ∞, m = 0, where the degrees allow it.
        let [top, bottom] = [&formula.numerator, &formula.denominator].map(|p| p.degree(0));
        let far = compiled.at(&Interval::ZERO, top.saturating_sub(bottom), |c| *c, || Interval::ZERO);
        assert!(far.lo().is_finite() && far.hi().is_finite() || text.starts_with("2^"), "{text}: {far:?}");
    }
    // Which of it is 0 exactly: (n - 4) h at n = 4.
    let formula: Formula = "(n*n + 8*2^(-n/2))/(n - 4*2^(-n/2))".parse().unwrap();
    let exactly = |p: &Polynomial| p.terms().map(|(e, c)| (c.clone(), *e)).collect();
    let compiled = Compiled::new(&formula, exactly, RBig::int(0));
    let quarter = RBig::int(1) / RBig::int(4);
    // (16 + 2)/(4 - 1) and, times m, 3/4 below the bar.
    assert_eq!(compiled.at(&quarter, 0, RBig::clone, || quarter.clone()), RBig::int(6));
    assert_eq!(compiled.denominator_at(&quarter, &quarter), RBig::int(3) / RBig::int(4));
}

/// At even n and at n = ∞ residuals are known exactly, elsewhere only without h, a root there.
#[test]
fn residuals_are_rational_at_even_exponents() {
    // Phong's cosⁿ: Int = 1/(n + 1), so n/(2π) leaves n/(n + 1) - 1 = -1/(n + 1).
    let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
    let residual = Residual::new(case, &"n/(2*pi)".parse().unwrap());
    for n in [16.0, 32.0, 1024.0] {
        let exact = enclose(&(RBig::int(-1) / RBig::int(n as i64 + 1)));
        assert_eq!(residual.in_rationals(1.0 / n), Some(exact), "{n}");
        assert!(residual.at(n).encloses(exact) && residual.at(n).width() < 1e-14);
    }
    assert_eq!(residual.in_rationals(0.0), Some(Interval::ZERO));
    // Without powers of ½ everywhere: -m/(1 + m), at 3/32 -3/35.
    assert_eq!(residual.in_rationals(3.0 / 32.0), Some(enclose(&(RBig::int(-3) / RBig::int(35)))));
    // Blinn-Phong has powers of ½: 4 (1 - 2^(-(n+2)/2)... in h; with n/(2π) the quotient is exact at even n.
    let blinn = Case { model: Model::BlinnPhong, ..case };
    let residual = Residual::new(blinn, &"n/(2*pi)".parse().unwrap());
    for n in [16.0, 64.0] {
        let found = residual.in_rationals(1.0 / n).unwrap();
        assert!(residual.at(n).encloses(found) && found.width() < 1e-15, "{n}: {found:?}");
    }
    assert_eq!(residual.in_rationals(1.0 / 17.0), None);
    assert_eq!(residual.in_rationals(1.0 / 1e5), None, "h = 2^-50000 is not worked out");
    // A factor that keeps its π, or rises over n, has no rational limit.
    assert_eq!(Residual::new(case, &"n".parse().unwrap()).in_rationals(1.0 / 16.0), None);
    assert_eq!(Residual::new(case, &"n^3/(2*pi)".parse().unwrap()).in_rationals(0.0), None);
    // (n + 1)/(2π) is Phong's own factor.
    assert!(normalises_exactly(case, &"(n + 1)/(2*pi)".parse().unwrap()));
    assert!(!normalises_exactly(case, &"(n + 2)/(2*pi)".parse().unwrap()));
    let own = Residual::new(case, &"(n + 1)/(2*pi)".parse().unwrap());
    assert!(own.is_exact(16.0, f64::INFINITY) && own.at(20.0) == Interval::ZERO);
}

#[test]
fn magnitudes_are_the_larger_side() {
    let of = |lo: f64, hi: f64, n: f64| Extreme { value: Interval::new(lo, hi), n };
    let found = Extremes { max: of(0.5, 0.75, 20.0), min: of(-2.0, -1.0, 30.0) }.magnitude();
    assert_eq!(found, of(1.0, 2.0, 30.0));
    let found = Extremes { max: of(3.0, 4.0, 20.0), min: of(-2.0, -1.0, 30.0) }.magnitude();
    assert_eq!(found, of(3.0, 4.0, 20.0));
    let found = Extremes { max: of(1.0, 4.0, 20.0), min: of(-4.0, -1.0, 30.0) }.magnitude();
    assert_eq!(found, of(1.0, 4.0, 20.0));
}
