//! An estimate's numbers are those of its own lobe over the samples: sums made here again, from the rows.
#![cfg(feature = "toolkit")]

use bellfit::fit::measured::{Comparison, Family, Samples, Shape, Unit, Weighting};
use core::f64::consts::PI;

/// Angles in degrees, values in thousands with a wobble that no lobe follows, weights from 1 to 3.
fn rows() -> Vec<(f64, f64, f64)> {
    let at = |i: i32| {
        let degrees = 1.5 * f64::from(i);
        let lobe = 4000.0 * libm::pow(libm::cos(degrees * PI / 180.0), 30.0);
        (degrees, lobe + 40.0 * libm::sin(2.3 * f64::from(i * i)), 1.0 + f64::from(i % 3))
    };
    (0..30).map(at).collect()
}

fn versine(degrees: f64) -> f64 {
    let s = libm::sin(degrees * PI / 360.0);
    2.0 * s * s
}

/// The relative error of a sum of thirty squares, each of a residual that has lost three digits.
const SUMS: f64 = 1e-11;

#[track_caller]
fn near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= SUMS * b.abs(), "{what}: {a:e} {b:e}");
}

#[test]
fn the_numbers_of_an_estimate_are_those_of_its_lobe() {
    let rows = rows();
    for weighting in [Weighting::Equal, Weighting::Weight, Weighting::Sigma] {
        let samples = Samples::new(Unit::Degrees, weighting, &rows).unwrap();
        let found = Comparison::of(&samples, &Family::ALL).unwrap();
        let count = rows.len() as f64;
        let mut criteria: Vec<(Family, f64, f64)> = Vec::new();
        for estimate in &found.estimates {
            let family = estimate.family;
            let weight = |q: f64| match weighting {
                Weighting::Equal => 1.0,
                Weighting::Weight => q,
                Weighting::Sigma => 1.0 / (q * q),
            };
            let residual = |&(degrees, value, _): &(f64, f64, f64)| {
                let w = versine(degrees);
                near(estimate.at(w), estimate.scale * family.value(w, estimate.n, estimate.shape), "at");
                value - estimate.at(w)
            };
            let squares: f64 = rows.iter().map(|row| weight(row.2) * residual(row) * residual(row)).sum();
            let weights: f64 = rows.iter().map(|row| weight(row.2)).sum();
            near(estimate.rms, (squares / weights).sqrt(), "rms");
            near(estimate.chi_square, squares, "chi square");
            let parameters = if family.is_free() { 4 } else { 2 };
            assert_eq!(estimate.freedom, rows.len() - parameters, "{family}");
            let worst = rows.iter().map(|row| residual(row).abs()).fold(0.0, f64::max);
            near(estimate.worst.value.abs(), worst, "worst");
            let row = &rows[estimate.worst.row - 1];
            near(residual(row).abs(), worst, "the row of the worst");
            assert!((estimate.worst.theta_deg - row.0).abs() < 1e-12, "{family}");
            if let Ok(known) = &estimate.uncertainty {
                let (low, high) = estimate.n_interval().unwrap();
                near(libm::log(high / low), 2.0 * known.quantile() * known.n / estimate.n, "interval of n");
                near(low * high, estimate.n * estimate.n, "middle of n");
                let (low, high) = estimate.scale_interval().unwrap();
                near(high - low, 2.0 * known.quantile() * known.scale, "interval of the scale");
                near(high + low, 2.0 * estimate.scale, "middle of the scale");
            }
            // BIC but for what is the same for every family: N ln Σ, or Σ where the sigmas are known.
            let penalty = parameters as f64 * libm::log(count);
            let fit = if weighting == Weighting::Sigma { squares } else { count * libm::log(squares) };
            criteria.push((family, estimate.bic, fit + penalty));
        }
        let (_, bic, own) = criteria[0];
        for (family, other, expected) in &criteria[1..] {
            // Logarithms of sums: their relative error, absolute and thirty times; of plain sums their size.
            let tolerance = SUMS * expected.abs().max(count);
            assert!(((other - bic) - (expected - own)).abs() < tolerance, "{weighting:?}, {family}");
        }
    }
}

#[test]
fn families_have_the_names_that_the_help_lists() {
    let names = [
        "cos-n",
        "linear-2",
        "linear-4",
        "linear-8",
        "cs-16",
        "linear-32",
        "cubic-2",
        "cubic-4",
        "cubic-8",
        "spherical-gaussian",
        "schlick",
        "free-2",
        "free-4",
        "free-8",
    ];
    let mut own = Family::ALL.map(Family::id).to_vec();
    own.sort_unstable();
    let mut names = names.to_vec();
    names.sort_unstable();
    assert_eq!(own, names);
    for family in Family::ALL {
        assert_eq!(Family::from_id(family.id()), Some(family));
    }
}

/// max(1 - w (k₁ - w (k₂ - w k₃)), 0)^K is the value, and the cut is where it ends.
#[test]
fn a_bells_coefficients_are_its_values() {
    for family in Family::ALL {
        let shape = if family.is_free() { Shape { linear: -0.9, square: 0.7 } } else { Shape::default() };
        let power = match family {
            Family::Linear2 | Family::Cubic2 | Family::Free2 => 2,
            Family::Linear4 | Family::Cubic4 | Family::Free4 => 4,
            Family::Linear8 | Family::Cubic8 | Family::Free8 => 8,
            Family::Cs16 => 16,
            Family::Linear32 => 32,
            Family::CosN | Family::SphericalGaussian | Family::Schlick => {
                assert_eq!(family.horner(64.0, shape), None, "{family}");
                continue;
            }
        };
        let ([k1, k2, k3], reach) = family.horner(64.0, shape).unwrap();
        for i in 0..40 {
            let w = reach * f64::from(i) / 32.0;
            let p = 1.0 - w * (k1 - w * (k2 - w * k3));
            let expected = if w < reach { libm::pow(p, f64::from(power)) } else { 0.0 };
            // Rounding of p, K times.
            let tolerance = 4.0 * f64::EPSILON * f64::from(power) * (1.0 + k1 * w);
            assert!((family.value(w, 64.0, shape) - expected).abs() < tolerance, "{family} at {w}");
        }
    }
}

/// At a right angle cosⁿ is 0 for every n, and so are its slopes: no ln 0 gets into them.
#[test]
fn at_a_right_angle_nothing_changes() {
    for family in [Family::CosN, Family::Cs16, Family::Cubic4] {
        assert_eq!(family.value(1.0, 60.0, Shape::default()), 0.0, "{family}");
        assert_eq!(family.slopes(1.0, 60.0, Shape::default())[0], 0.0, "{family}");
    }
}

/// One sample more than parameters can be fitted, and as many angles as parameters; fewer say how many there are.
#[test]
fn the_fewest_samples_are_one_more_than_parameters() {
    let of = |family: Family, degrees: &[f64]| {
        let shape = if family.is_free() { Shape { linear: -0.9, square: 0.7 } } else { Shape::default() };
        let row =
            |(i, &d): (usize, &f64)| (d, family.value(versine(d), 40.0, shape) + 1e-3 * (i % 2) as f64, 1.0);
        let rows: Vec<(f64, f64, f64)> = degrees.iter().enumerate().map(row).collect();
        let samples = Samples::new(Unit::Degrees, Weighting::Equal, &rows).unwrap();
        Comparison::of(&samples, &[family])
    };
    let one = |family, degrees: &[f64]| of(family, degrees).unwrap().estimates.remove(0);
    for angles in [&[0.0, 8.0, 16.0][..], &[4.0, 4.0, 14.0]] {
        let found = one(Family::CosN, angles);
        assert_eq!(found.freedom, 1);
        assert!((20.0..80.0).contains(&found.n), "{}", found.n);
        assert_eq!(found.to_string(), format!("cos-n: n = {}, scale = {}", found.n, found.scale));
    }
    for angles in [&[0.0, 5.0, 10.0, 15.0, 20.0][..], &[0.0, 0.0, 8.0, 14.0, 20.0]] {
        assert_eq!(one(Family::Free4, angles).freedom, 1);
    }
    let refused = |family, degrees: &[f64]| match of(family, degrees) {
        Ok(found) => found.failures.iter().map(|(_, why)| why.to_string()).collect::<Vec<_>>().join(""),
        Err(error) => error.to_string(),
    };
    assert!(refused(Family::Free4, &[0.0, 5.0, 10.0, 15.0]).contains("4 samples for 4 parameters"));
    assert!(refused(Family::Free4, &[0.0, 0.0, 5.0, 10.0, 10.0]).contains("3 angles for 4 parameters"));
}
