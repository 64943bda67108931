//! What may stand for cosⁿ: the bells of degree one, cosⁿ by other ways than `pow`, and the list of all.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::fit::bell::{Shape, cosine_bells};
use bellfit::kernel::constants::{CUBIC_COS_N, LINEAR_COS_N};
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::lobe::{cos_n, cs, cs_versine, versine};
use bellfit::kernel::power::{cos_n_exp2, cos_n_whole};
use bellfit::kernel::stand_in::{Argument, StandIn};
use draw::Draw;
use references::{Reference, rows};

const U32: f64 = f32::EPSILON as f64 / 2.0;
const U64: f64 = f64::EPSILON / 2.0;

/// (c, n, cⁿ) of the reference table.
fn powers() -> impl Iterator<Item = (f64, u32, Reference)> {
    let row = |[c, n, power]: [String; 3]| {
        (c.parse().unwrap(), n.parse().unwrap(), Reference::parse(&power).unwrap())
    };
    rows::<3>("powers.csv").into_iter().map(row)
}

#[test]
fn squarings_stay_within_their_roundings() {
    let mut met = 0;
    for (c, n, reference) in powers() {
        // (n - 1) u to the first order; the second adds n u of that, below a hundredth here
        let bound = 1.01 * f64::from(n - 1) * U64;
        assert!(reference.is_near(cos_n_whole(c, n), bound), "{c}^{n}");
        // f32: where c is one, and the result a normal number
        let value = cos_n_whole(c as f32, n);
        if f64::from(c as f32) == c && value > f32::MIN_POSITIVE {
            assert!(reference.is_near(f64::from(value), 1.01 * f64::from(n - 1) * U32), "{c}^{n} in f32");
            met += 1;
        }
    }
    assert!(met >= 10, "the table has {met} cosines that f32 holds");
}

#[test]
fn squarings_are_products() {
    // Powers of ½ and of 3 are exact as long as they fit.
    for n in 0..=1000 {
        assert_eq!(cos_n_whole(0.5_f64, n), libm::scalbn(1.0, -(n as i32)), "2^-{n}");
    }
    let mut product = 1.0_f64;
    for n in 0..=33 {
        assert_eq!(cos_n_whole(3.0_f64, n), product, "3^{n}");
        product *= 3.0;
    }
    assert_eq!(cos_n_whole(1.0_f32, u32::MAX), 1.0);
}

#[test]
fn the_power_through_base_two_loses_with_its_exponent() {
    for (c, n, reference) in powers() {
        let n = f64::from(n);
        let exponent = (n * libm::log2(c)).abs();
        // half an ulp of the product n log₂ c and one of log₂ (its own error below 1 ulp) stand in the exponent:
        // 3 u |n log₂ c| ln 2; exp2 adds its ulp, 2 u
        let bound = (3.0 * exponent * std::f64::consts::LN_2 + 2.0) * U64 * 1.01;
        assert!(reference.is_near(cos_n_exp2(c, n), bound), "{c}^{n}");
    }
}

#[test]
fn ways_to_the_power_agree_at_the_ends() {
    for n in [0.0, 1.0, 7.0, 64.0] {
        for c in [-1.0, -0.5, -0.0, 0.0, 1.0] {
            assert_eq!(cos_n_exp2(c, n), cos_n(c, n), "{c}^{n}");
            assert_eq!(cos_n_whole(c, n as u32), cos_n(c, n), "{c}^{n}");
        }
        assert!(cos_n_exp2(f64::NAN, n).is_nan() && cos_n_whole(f64::NAN, n as u32).is_nan());
    }
    assert_eq!(cos_n_exp2(0.5_f64, f64::INFINITY), 0.0);
    assert_eq!(cos_n_exp2(1.0_f64, f64::INFINITY), 1.0);
    assert!(cos_n_exp2(0.5_f64, f64::NAN).is_nan());
}

/// With T = K the folded form is the papers' bell, and the versine's form but for rounding.
#[test]
fn lyons_reach_gives_lyons_bell() {
    let mut draw = Draw(1);
    for _ in 0..2000 {
        let n = libm::exp2(draw.real(4.0, 17.0));
        let w = draw.real(0.0, 1.2) * 16.0_f64.min(n) / n;
        if w > 1.0 {
            continue;
        }
        let lobe = LinearLobe::<16, f64>::lyon(n);
        // A factor (1 + u)^±4 of the base, which is at most 1, and 15 roundings of the squarings: as the bell's
        // page counts them, twice for two such values.
        let (value, bell) = (lobe.at_versine(w), cs_versine::<16, f64>(w, n));
        assert!((value - bell).abs() <= 2.0 * (4.0 * 16.0 + 15.0) * U64, "n = {n}, w = {w}");
        // From the cosine the base's error is that of 1 - s + s c: u (2 s + 2), to the power 16.
        let c = 1.0 - w;
        let folded = (2.0 * n / 16.0 + 2.0) * 16.0 * U64 + 31.0 * U64;
        assert!((lobe.at(c) - cs::<16, f64>(c, n)).abs() <= 2.0 * folded, "n = {n}, c = {c}");
    }
}

#[test]
fn linear_lobes_are_bells() {
    fn check<const K: u32>() {
        for n in [16.0, 50.0, 1000.0, 1e6, 1e12] {
            let lobe = LinearLobe::<K, f64>::new(n);
            assert_eq!(lobe.at_versine(0.0), 1.0, "K = {K}, n = {n}");
            let reach = 1.0 / lobe.constants()[1];
            assert_eq!(lobe.at_versine(reach * (1.0 + 1e-15)), 0.0, "K = {K}, n = {n}: ends at T/n");
            let values: Vec<f64> =
                (0..=1000).map(|i| lobe.at_versine(reach * f64::from(i) / 900.0)).collect();
            assert!(values.windows(2).all(|pair| pair[0] >= pair[1]), "K = {K}, n = {n}: falls");
        }
        for n in [f64::NAN, -1.0, f64::INFINITY] {
            assert!(LinearLobe::<K, f64>::new(n).at(0.5).is_nan(), "K = {K}, n = {n}");
        }
        let lobe = LinearLobe::<K, f32>::new(64.0);
        assert_eq!((lobe.at(-0.1), lobe.at_versine(1.5), lobe.at(-f32::INFINITY)), (0.0, 0.0, 0.0));
        assert!(lobe.at(f32::NAN).is_nan() && lobe.at_versine(f32::NAN).is_nan());
    }
    check::<2>();
    check::<4>();
    check::<8>();
    check::<16>();
    check::<32>();
}

/// The adopted rows are those of the fits, whose certificates cover the kernels.
#[test]
fn adopted_bells_are_the_fits() {
    let fits = cosine_bells().unwrap();
    let adopted = LINEAR_COS_N.iter().map(|row| (Shape::Linear, row));
    for (shape, formula) in adopted.chain(CUBIC_COS_N.iter().map(|row| (Shape::Cubic, row))) {
        let fit = fits.iter().find(|f| !f.printed && f.shape == shape && f.formula.power == formula.power);
        let fit = fit.unwrap();
        assert_eq!(fit.formula, *formula);
        let mut draw = Draw(u64::from(formula.power));
        let stand_in = StandIn::ALL
            .into_iter()
            .find(|s| s.bell() == Some((formula.power, shape.degree())) && *s != StandIn::Cs16);
        for _ in 0..2000 {
            let n = libm::exp2(draw.real(4.0, 12.0));
            let w = draw.real(0.0, 1.0) * (40.0 / n).min(1.0);
            let exact = libm::exp(n * libm::log1p(-w));
            let value = stand_in.unwrap().at_versine(w, n);
            // 1e-12 for the rounding of n w = 40 under the squarings
            assert!((value - exact).abs() <= fit.error.value.hi() + 1e-12, "{stand_in:?}, n = {n}, w = {w}");
        }
    }
}

#[test]
fn every_stand_in_is_one_at_the_peak_and_knows_its_name() {
    for stand_in in StandIn::ALL {
        assert_eq!(StandIn::from_id(stand_in.id()), Some(stand_in));
        for n in [16.0, 64.0, 1000.0] {
            assert_eq!(stand_in.at_versine(0.0_f64, n), 1.0, "{stand_in:?}");
            // the folded forms round their constants: n u and what the power makes of it
            assert!((stand_in.at(1.0_f64, n) - 1.0).abs() <= 16.0 * n * U64, "{stand_in:?}");
            assert!(stand_in.at(f64::NAN, n).is_nan() && stand_in.at_versine(f64::NAN, n).is_nan());
            assert!(stand_in.at(0.5_f64, f64::NAN).is_nan(), "{stand_in:?}");
        }
    }
    assert_eq!(StandIn::from_id("cubic-3"), None);
    assert!(StandIn::Squarings.at(0.5_f64, 16.5).is_nan() && StandIn::Squarings.at(0.5_f64, 1e10).is_nan());
}

/// The same lobe, whichever argument it is handed.
#[test]
fn both_arguments_mean_the_same_angle() {
    let mut draw = Draw(7);
    for _ in 0..5000 {
        let (n, theta) = (libm::floor(libm::exp2(draw.real(4.0, 10.0))), draw.real(0.0, 0.5));
        let (c, w) = (libm::cos(theta), versine(theta));
        for stand_in in StandIn::ALL {
            let (by_cosine, by_versine) = (stand_in.at(c, n), stand_in.at_versine(w, n));
            // c is off by u and every lobe's slope in c at most 1.2 n; the folded forms add as much again and more
            let bound = 16.0 * n * U64;
            assert!((by_cosine - by_versine).abs() <= bound, "{stand_in:?}, n = {n}, θ = {theta}");
        }
    }
}

/// Operations by the formulas' own structure: degree, maximum, squarings; and by the fits' table.
#[test]
fn costs_are_those_of_the_fits() {
    for row in cosine_bells().unwrap() {
        let (power, degree) = (row.formula.power, row.shape.degree());
        let is_this = |s: &StandIn| s.bell() == Some((power, degree)) && (*s == StandIn::Cs16) == row.printed;
        let stand_in = StandIn::ALL.into_iter().find(is_this).unwrap();
        let cost = |argument| stand_in.cost(argument, 64.0);
        assert_eq!(cost(Argument::Cosine).operations, row.cost.from_cos, "{stand_in:?}");
        assert_eq!(cost(Argument::Versine).operations, row.cost.from_t, "{stand_in:?}");
        assert_eq!((cost(Argument::Cosine).divisions, cost(Argument::Cosine).transcendentals), (0, 0));
    }
    // c¹⁰²⁴: ten squarings; c¹⁰²³: nine and nine products; each after the maximum
    assert_eq!(StandIn::Squarings.cost(Argument::Cosine, 1024.0).operations, 11);
    assert_eq!(StandIn::Squarings.cost(Argument::Cosine, 1023.0).operations, 19);
}
