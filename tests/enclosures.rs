//! Enclosures and the three routes against the high-precision tables of tests/references.
//!
//! Containment is decided in rationals: the reference's decimals and the interval's ends are exact
//! numbers, and only the reference's own half unit (it is rounded to 30 digits) is allowed for.
//! An enclosure that contains is not yet worth anything, so every test bounds its width as well.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/references.rs"]
mod references;

use bellfit::bound::{
    Gaussian, Interval, bell_distance, difference_infimum, difference_supremum, gaussian_distance,
    integral_enclosure,
};
use bellfit::integral::{AGREEMENT, Case, Edge, GaussTable, Limit, Lobe, Routes};
use bellfit::kernel::model::Model;
use references::{Reference, rows};

/// hi - lo relative to the reference.
fn relative_width(found: Interval, reference: &Reference) -> f64 {
    found.width() / reference.to_f64().abs()
}

fn integrals() -> Vec<(Case, f64, Reference)> {
    let read = |[model, lobe, limit, n, value]: [String; 5]| {
        let case = Case {
            model: Model::from_id(&model).unwrap(),
            lobe: Lobe::from_id(&lobe).unwrap(),
            limit: Limit::from_id(&limit).unwrap(),
        };
        (case, n.parse().unwrap(), Reference::parse(&value).unwrap())
    };
    rows("integrals.csv").into_iter().map(read).collect()
}

/// The rows of one function: its two arguments (the second NaN where there is none) and the value's
/// text.
fn functions(name: &str) -> Vec<(f64, f64, String)> {
    let read = |[function, first, second, value]: [String; 4]| {
        let second = if second.is_empty() { f64::NAN } else { second.parse().unwrap() };
        (function == name).then(|| (first.parse().unwrap(), second, value))
    };
    let found: Vec<_> = rows("functions.csv").into_iter().filter_map(read).collect();
    assert!(!found.is_empty(), "no row for {name}");
    found
}

#[test]
fn every_integral_is_enclosed() {
    let table = integrals();
    assert_eq!(table.len(), 450);
    for case in Case::all() {
        assert_eq!(table.iter().filter(|row| row.0 == case).count(), 15, "{case}");
    }
    let mut widest = 0.0_f64;
    for (case, n, reference) in table {
        let found = integral_enclosure(case, n);
        assert!(reference.is_enclosed(found), "Int({n}) of {case}: {found:?}, not {reference:?}");
        widest = widest.max(relative_width(found, &reference));
    }
    // What fits/integrals/*.csv promise.
    assert!(widest <= 1e-12, "{widest:e}");
}

/// The committed tables themselves, row by row: complete, narrow, and the quadrature beside the
/// enclosure no further from it than its own error and what routes may differ by.
#[test]
fn the_committed_tables_keep_their_promise() {
    for model in Model::ALL {
        let path = format!("{}/fits/integrals/{}.csv", env!("CARGO_MANIFEST_DIR"), model.id());
        let mut reader = csv::Reader::from_path(path).unwrap();
        let mut count = 0;
        for row in reader.records() {
            let row = row.unwrap();
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let (lo, hi, quadrature, error) = (number(4), number(5), number(6), number(7));
            assert!(0.0 < lo && lo <= hi && hi - lo <= 1e-12 * lo, "{row:?}");
            let reach = error + AGREEMENT * lo;
            assert!(lo - reach <= quadrature && quadrature <= hi + reach, "{row:?}");
            count += 1;
        }
        // cosⁿ on its support and cs_16 on four limits, 16..1024.
        assert_eq!(count, 5 * 1009, "{}", model.id());
    }
}

#[test]
fn every_route_meets_every_integral() {
    let mut table = GaussTable::default();
    for (case, n, reference) in integrals() {
        let routes = Routes::evaluate(case, n, &mut table);
        // The distance that two routes may have from one another, each has from the truth.
        for (route, value) in [
            ("closed form", routes.closed),
            ("Gauss-Legendre", routes.gauss),
            ("double exponential", routes.exponential.value),
        ] {
            assert!(reference.is_near(value, AGREEMENT), "Int({n}) of {case} by {route}: {value:e}");
        }
    }
}

/// Widths are stated in ε: how many of them an evaluation may lose from end to end.
const E: f64 = f64::EPSILON;
/// What a series of up to 18 terms may lose; its late terms hardly count, so far less than 18 · 4 ε.
const SERIES: f64 = 32.0 * E;

/// The relative width allowed to e^x: x - k ln 2 has the width of k ln 2, 4 ε of |x|, and an absolute
/// error of the exponent is a relative one of the power.
fn exponential_width(x: f64) -> f64 {
    SERIES + 4.0 * E * x.abs()
}

#[test]
fn exponentials_are_enclosed() {
    for (x, _, value) in functions("exp") {
        let (found, reference) = (Interval::from(x).exp(), Reference::parse(&value).unwrap());
        assert!(reference.is_enclosed(found), "exp {x}: {found:?}, not {value}");
        // Below the smallest normal double the spacing is absolute; there only the size is bounded.
        if reference.to_f64() >= f64::MIN_POSITIVE {
            assert!(relative_width(found, &reference) <= exponential_width(x), "exp {x}: {found:?}");
        } else {
            assert!(found.lo() >= 0.0 && found.hi() <= 1e-320, "exp {x}: {found:?}");
        }
    }
}

#[test]
fn logarithms_are_enclosed() {
    for (x, _, value) in functions("ln") {
        let (found, reference) = (Interval::from(x).ln(), Reference::parse(&value).unwrap());
        assert!(reference.is_enclosed(found), "ln {x}: {found:?}, not {value}");
        if x == 1.0 {
            // No relative width at 0; one step outward is a subnormal number.
            assert!(found.width() < f64::MIN_POSITIVE, "{found:?}");
        } else {
            assert!(relative_width(found, &reference) <= SERIES, "ln {x}: {found:?}");
        }
    }
}

#[test]
fn powers_are_enclosed() {
    let mut beyond = 0;
    for (base, n, value) in functions("pow") {
        let found = Interval::from(base).pow(Interval::from(n));
        let Some(reference) = Reference::parse(&value) else {
            // Below 10^-400 no double but 0 is near: 0 must be the lower end, and not the upper.
            assert!(value.contains("e-"), "{value}");
            assert!(found.lo() == 0.0 && 0.0 < found.hi() && found.hi() <= 1e-320, "{base}^{n}: {found:?}");
            beyond += 1;
            continue;
        };
        assert!(reference.is_enclosed(found), "{base}^{n}: {found:?}, not {value}");
        // As for exp.
        if reference.to_f64() >= f64::MIN_POSITIVE {
            let exponent = n * libm::log(base);
            let width = exponential_width(exponent) + (SERIES + 4.0 * E) * exponent.abs();
            assert!(relative_width(found, &reference) <= width, "{base}^{n}: {found:?}");
        }
    }
    assert!(beyond >= 2, "the table goes beyond the doubles");
}

#[test]
fn versine_ratios_are_enclosed() {
    for (y, _, value) in functions("versine_ratio") {
        let (found, reference) = (Interval::from(y).versine_ratio(), Reference::parse(&value).unwrap());
        assert!(reference.is_enclosed(found), "at {y}: {found:?}, not {value}");
        assert!(relative_width(found, &reference) <= SERIES, "at {y}: {found:?}");
        // The plain double beside it: √, sin (within an ulp), and four more roundings.
        assert!(reference.is_near(y.versine_ratio(), 4.0 * E), "at {y}");
    }
}

/// Suprema to this, of numbers from 1.7e-4 up: four digits and more of each.
const TOLERANCE: f64 = 1e-9;
/// How much wider than asked a supremum may come out: the rounding in the value where it was found.
const SLACK: f64 = 1e-14;

fn check_extreme(what: &str, found: Interval, value: &str) {
    let reference = Reference::parse(value).unwrap();
    assert!(reference.is_enclosed(found), "{what}: {found:?}, not {value}");
    assert!(found.width() <= TOLERANCE + SLACK, "{what}: {found:?} is {:e} wide", found.width());
}

#[test]
fn differences_of_the_lobes_are_enclosed() {
    for (n, _, value) in functions("difference_max") {
        let found = difference_supremum(Limit::ExactZero, Interval::from(n), TOLERANCE);
        check_extreme(&format!("sup Δ at n = {n}"), found.value, &value);
        assert_eq!(found.n, n);
    }
    for (n, _, value) in functions("difference_min") {
        let found = difference_infimum(n, TOLERANCE);
        check_extreme(&format!("inf Δ at n = {n}"), found.value, &value);
        assert_eq!(found.n, n);
    }
}

#[test]
fn distances_from_gaussians_are_enclosed() {
    for (name, kind) in
        [("gaussian_error_angle", Gaussian::Angle), ("gaussian_error_cosine", Gaussian::Cosine)]
    {
        for (n, _, value) in functions(name) {
            let found = gaussian_distance(kind, Interval::from(n), TOLERANCE);
            check_extreme(&format!("{kind:?} at n = {n}"), found.value, &value);
        }
    }
}

#[test]
fn distances_of_bells_from_the_exponential_are_enclosed() {
    for (k, _, value) in functions("bell_exp_error") {
        let found = bell_distance(k as u32, TOLERANCE);
        check_extreme(&format!("K = {k}"), found.value, &value);
    }
}
