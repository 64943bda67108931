//! The pixel paper's studies: the clip volume and its polynomials, the axes of skewed footprints, the
//! weights.
//!
//! References: tests/references/clip-volume.csv, clip-recipe.csv, clip-fits.csv, skew.csv and
//! weight-errors.csv, written by pixel_study.py without this crate.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::bound::{ClippedPixel, Interval, Jet, decimal, exponential_bell};
use bellfit::fit::clip::{
    ClipFamily, ClipObjective, ClipPixel, ClipPoints, ClipRow, ClipTarget, Ending, clip_least_squares,
    clip_printed, clip_rows, matching_sigmas, recipes,
};
use bellfit::fit::{FIGURE_AXES, figure_weights, pixel_weights, weight_name, weight_rows};
use bellfit::integral::Field;
use bellfit::kernel::constants::CUBIC_EXP;
use bellfit::kernel::pixel::{
    Axes, ClipPolynomial, Footprint, Jacobian, Padding, PixelWeight, Skew, TiltFormula,
};
use dashu_ratio::RBig;
use draw::Draw;
use references::{Reference, rows};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

fn target(name: &str, reciprocal: &str) -> ClipTarget {
    let found = ClipTarget::ALL.into_iter().find(|t| {
        let same = match t {
            ClipTarget::Gaussian(s) => s.to_string() == reciprocal,
            ClipTarget::GaussianCut(m) => m.to_string() == reciprocal,
            _ => reciprocal.is_empty(),
        };
        t.id() == name && same
    });
    found.unwrap_or_else(|| panic!("{name}, {reciprocal}"))
}

#[test]
fn volumes_agree_with_quadrature_of_the_bells() {
    let table = rows::<4>("clip-volume.csv");
    assert_eq!(table.len(), 80);
    for [name, reciprocal, d, volume] in table {
        let reference = Reference::parse(&volume).unwrap();
        let (target, d) = (target(&name, &reciprocal), d.parse::<f64>().unwrap());
        let found = ClipPixel::new(target).volume(d);
        // Forty products of a quadrature, or eight steps of a recursion, of numbers up to 2.
        assert!((found - reference.to_f64()).abs() < 1e-14, "{name} {reciprocal} {d}: {found}");
        if let ClipTarget::Gaussian(s) = target {
            // The distances are dyadic: s d is exact.
            let whole = ClippedPixel::Gaussian(Interval::from(s));
            let tail = whole.share_beyond(Jet::constant(Interval::from(d))).value;
            assert!(reference.is_enclosed(tail) && tail.width() < 1e-12, "{d}: {tail:?}");
        }
    }
}

/// Determinant of a 3 × 3 matrix.
fn determinant(m: &[[RBig; 3]; 3]) -> RBig {
    let minor = |a: usize, b: usize| m[1][a].clone() * m[2][b].clone() - m[1][b].clone() * m[2][a].clone();
    m[0][0].clone() * minor(1, 2) - m[0][1].clone() * minor(0, 2) + m[0][2].clone() * minor(0, 1)
}

/// Least squares in exact rationals: the normal equations by Cramer's rule.
fn exact_squares(points: &[(RBig, RBig)]) -> [RBig; 3] {
    let sum = |f: &dyn Fn(&(RBig, RBig)) -> RBig| points.iter().fold(RBig::int(0), |s, p| s + f(p));
    let power = |d: &RBig, k: usize| (0..k).fold(RBig::int(1), |p, _| p * d.clone());
    let moments: Vec<RBig> = (0..5).map(|k| sum(&|p| power(&p.0, k))).collect();
    let images: Vec<RBig> = (0..3).map(|k| sum(&|p| power(&p.0, k) * p.1.clone())).collect();
    let system: [[RBig; 3]; 3] = [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| moments[i + j].clone()));
    let whole = determinant(&system);
    [0, 1, 2].map(|column| {
        let mut replaced = system.clone();
        for (row, image) in replaced.iter_mut().zip(&images) {
            row[column] = image.clone();
        }
        determinant(&replaced) / whole.clone()
    })
}

/// Half a unit of the last printed digit to either side.
fn prints(value: &RBig, printed: &str) -> bool {
    let (middle, places) = decimal(printed).unwrap();
    let half = bellfit::bound::power_of_ten(-places) / RBig::int(2);
    middle.clone() - half.clone() <= *value && *value <= middle + half
}

/// The finding itself, without a line of the crate's fits: exact normal equations on high-precision volumes.
#[test]
fn eleven_points_and_sigma_one_fifth_print_the_digits() {
    let table = rows::<3>("clip-recipe.csv");
    for (reciprocal, expected) in [("5", true), ("6", false)] {
        let points: Vec<(RBig, RBig)> = table
            .iter()
            .filter(|row| row[0] == reciprocal)
            .map(|row| (decimal(&row[1]).unwrap().0, decimal(&row[2]).unwrap().0))
            .collect();
        assert_eq!(points.len(), 11);
        assert_eq!(clip_printed(), [0.5, -2.151, 2.358, 0.0]);
        let c = exact_squares(&points);
        let same = c.iter().zip(["0.5", "-2.151", "2.358"]).all(|(c, printed)| prints(c, printed));
        assert_eq!(same, expected, "1/σ = {reciprocal}");
        // QR finds the same; its condition number is below 1e3.
        let pixel = ClipPixel::new(target("gaussian", reciprocal));
        let found =
            clip_least_squares(&pixel, ClipPoints::Equidistant(11), ClipFamily::quadratic(false)).unwrap();
        for (found, exact) in found.iter().zip(&c) {
            assert!((found - exact.to_f64().value()).abs() < 1e-12, "{found}");
        }
    }
}

#[test]
fn no_other_recipe_prints_the_digits() {
    let found = recipes(201);
    assert_eq!(found.len(), 1, "{found:?}");
    let recipe = found[0];
    assert_eq!((recipe.target, recipe.points, recipe.half), (ClipTarget::Gaussian(5.0), 11, false));
    for points in ClipPoints::ALL {
        for half in [false, true] {
            let both = matching_sigmas(points, half).unwrap().both();
            let expected = (points, half) == (ClipPoints::Equidistant(11), false);
            assert_eq!(both.is_some(), expected, "{points:?} {half}");
            assert!(both.is_none_or(|(lo, hi)| lo < 0.2 && 0.2 < hi && hi - lo < 1e-4));
        }
    }
}

fn row(table: &[ClipRow], target: ClipTarget, objective: ClipObjective, degree: u32, half: bool) -> &ClipRow {
    let is = |row: &&ClipRow| {
        (row.target, row.objective, row.degree, row.half) == (target, objective, degree, Some(half))
    };
    table.iter().find(is).unwrap()
}

#[test]
fn fits_agree_with_normal_equations_and_linear_programs() {
    let table = clip_rows();
    for [reciprocal, points, constant, objective, p0, p1, p2, p3, level] in rows::<9>("clip-fits.csv") {
        let (target, half) = (target("gaussian", &reciprocal), constant == "half");
        if objective == "ls" {
            let points = points.parse().map_or(ClipPoints::Continuous, ClipPoints::Equidistant);
            let pixel = ClipPixel::new(target);
            let found = clip_least_squares(&pixel, points, ClipFamily::quadratic(half)).unwrap();
            for (found, reference) in found.iter().zip([p0, p1, p2]) {
                let reference = Reference::parse(&reference).unwrap().to_f64();
                // A condition number below 1e3 and 101 rows; 64 nodes of quadrature.
                assert!((found - reference).abs() < 1e-12, "{reciprocal} {points:?}: {found} {reference}");
            }
            continue;
        }
        let degree = if p3.is_empty() { 2 } else { 3 };
        let kind = match objective.as_str() {
            "minimax" => ClipObjective::Minimax,
            _ => ClipObjective::Falling,
        };
        let found = row(&table, target, kind, degree, half);
        let level = Reference::parse(&level).unwrap().to_f64();
        // The program's own tolerance is 1e-10 of numbers up to 10, the proof's 1e-9, the grid's 1e-7
        // relative.
        let tolerance = 3e-9 + 2e-7 * level;
        assert!((found.error - level).abs() < tolerance, "{found:?}: {level}");
        // A condition that holds exactly.
        let [c0, c1, c2, c3] = found.coefficients;
        assert!(!half || c0 == 0.5);
        assert!(
            kind != ClipObjective::Falling || (found.monotone && c0 + c1 / 2.0 + c2 / 4.0 + c3 / 8.0 == 0.0)
        );
    }
}

#[test]
fn errors_hold_and_are_reached() {
    for row in clip_rows() {
        let pixel = ClipPixel::new(row.target);
        let [p0, p1, p2, p3] = row.coefficients;
        let error = |d: f64| (p0 + d * (p1 + d * (p2 + d * p3)) - pixel.volume(d)).abs();
        // What a scan finds besides the stated argument may exceed it by its rounding alone.
        let rounding = 1e-14;
        let scanned = (0..=4000).map(|i| error(f64::from(i) / 8000.0)).fold(0.0, f64::max);
        assert!(scanned <= row.error + rounding, "{row:?}: {scanned}");
        assert!(row.error - error(row.at) < 2e-9, "{row:?}: {}", error(row.at));
        let falls = (0..1000).all(|i| {
            let p = |i: i32| {
                let d = f64::from(i) / 2000.0;
                p0 + d * (p1 + d * (p2 + d * p3))
            };
            // A rounded sum of four terms of size 1.
            p(i + 1) <= p(i) + 1e-15
        });
        assert_eq!(falls, row.monotone, "{row:?}");
    }
}

#[test]
fn too_few_points_have_no_fit() {
    let pixel = ClipPixel::new(ClipTarget::Cone);
    for (points, half, fits) in [(2, false, false), (3, false, true), (1, true, false), (0, true, false)] {
        let found = clip_least_squares(&pixel, ClipPoints::Equidistant(points), ClipFamily::quadratic(half));
        assert_eq!(found.is_some(), fits, "{points} {half}");
    }
    // Nothing is left free, and so nothing is fitted.
    let fixed = ClipFamily { degree: 2, half: true, ending: Ending::Landing };
    let found = clip_least_squares(&pixel, ClipPoints::Equidistant(5), fixed);
    assert!(found.is_none_or(|p| p == [0.5, -2.0, 2.0, 0.0]), "{found:?}");
}

#[test]
fn the_adopted_polynomials_are_the_tables() {
    let table = clip_rows();
    for (polynomial, objective, degree, half) in [
        (ClipPolynomial::Quadratic, ClipObjective::Minimax, 2, false),
        (ClipPolynomial::Centred, ClipObjective::Minimax, 2, true),
        (ClipPolynomial::Falling, ClipObjective::Falling, 3, true),
    ] {
        let row = row(&table, ClipTarget::Gaussian(6.0), objective, degree, half);
        assert_eq!(polynomial.coefficients(), row.coefficients);
        for i in 0..=500 {
            let d = f64::from(i) / 1000.0;
            let exact = 0.5 * libm::erfc(d * 6.0 / SQRT_2);
            assert!((polynomial.at(d) - exact).abs() <= row.error + 1e-15);
            // f32: four roundings of terms up to 5.2/4.
            assert!((f64::from(polynomial.at(d as f32)) - polynomial.at(d)).abs() < 1e-6);
        }
        assert!(polynomial.at(f64::NAN).is_nan());
    }
    // Where the documentation says that they are negative.
    let below = |p: ClipPolynomial, d: f64| p.at(d) < 0.0;
    assert!(below(ClipPolynomial::Quadratic, 0.373) && !below(ClipPolynomial::Quadratic, 0.372));
    assert!(below(ClipPolynomial::Quadratic, 0.460) && !below(ClipPolynomial::Quadratic, 0.461));
    assert!(below(ClipPolynomial::Centred, 0.366) && !below(ClipPolynomial::Centred, 0.365));
    assert!(below(ClipPolynomial::Centred, 0.459) && !below(ClipPolynomial::Centred, 0.460));
    assert!((0..=500).all(|i| ClipPolynomial::Falling.at(f64::from(i) / 1000.0) >= 0.0));
}

/// Angle of two lines, in [0, π/2].
fn between(a: f64, b: f64) -> f64 {
    let off = a - b;
    (off - PI * libm::round(off / PI)).abs()
}

#[test]
fn skewed_axes_agree_with_singular_values() {
    let table = rows::<5>("skew.csv");
    assert_eq!(table.len(), 71);
    for fields in table {
        let [degrees, ratio, major, minor, tilt] = fields.map(|f| f.parse::<f64>().unwrap());
        let skew = Skew { angle: degrees.to_radians(), ratio };
        let axes = skew.axes();
        // LAPACK's error is some ε of the largest singular value; an angle's that by their difference.
        let tolerance = 8.0 * f64::EPSILON * major;
        assert!((axes.major - major).abs() < tolerance && (axes.minor - minor).abs() < tolerance, "{skew:?}");
        let turned = tolerance * 2.0 / (major - minor);
        assert!(between(axes.tilt, tilt.to_radians()) < turned + 1e-15, "{skew:?}: {axes:?} {tilt}");
    }
}

#[test]
fn closed_forms_agree_with_the_footprints_own_axes() {
    let mut draw = Draw(11);
    for _ in 0..4000 {
        let mut component = || draw.real(-3.0, 3.0);
        let j = Jacobian { ux: component(), vx: component(), uy: component(), vy: component() };
        let skew = Skew::of(j);
        let axes = Axes::of(j, Padding::Plain);
        let (first, second) = j.lengths();
        // Angle and ratio are rounded, and so sin φ to ε/|φ| of itself.
        let sine = libm::sin(skew.angle).abs();
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14 * (1.0 + 1.0 / sine);
        assert!(near(skew.major() * first.max(second), axes.major), "{j:?}");
        assert!(near(skew.minor() * first.min(second), axes.minor), "{j:?}");
        assert!(near(skew.area(), first * second / (axes.major * axes.minor)), "{j:?}");
        let paper = |formula: TiltFormula| between(formula.angle(j), axes.tilt);
        // Near a circle the tilt has no digits.
        if axes.minor < 0.99 * axes.major {
            let vector = paper(TiltFormula::Vector);
            assert!((vector - between(skew.tilt(), 0.0)).abs() < 1e-11, "{j:?}: {vector}");
            let first = libm::atan2(j.vx, j.ux);
            let conic = paper(TiltFormula::Conic);
            let expected = if skew.conic_is_turned(first) { FRAC_PI_2 } else { 0.0 };
            assert!((conic - expected).abs() < 1e-11, "{j:?}: {conic}");
        }
    }
}

#[test]
fn suprema_over_skew_and_ratio() {
    let mut draw = Draw(12);
    let rounding = 8.0 * f64::EPSILON;
    for _ in 0..20_000 {
        let skew = Skew { angle: draw.real(-PI, PI), ratio: libm::exp2(draw.real(-6.0, 6.0)) };
        let sine = libm::sin(skew.angle).abs();
        let (major, minor, tilt) = (skew.major(), skew.minor(), skew.tilt());
        assert!((1.0 - rounding..=SQRT_2 + rounding).contains(&major), "{skew:?}");
        assert!(minor <= 1.0 + rounding && minor >= sine / SQRT_2 * (1.0 - rounding), "{skew:?}");
        assert!((skew.area() * major * minor - 1.0).abs() < rounding);
        if skew.ratio < 1.0 {
            let most = 0.5 * libm::asin(skew.ratio * skew.ratio);
            assert!(tilt.abs() <= most + rounding && most < PI / 4.0, "{skew:?}");
            // Reached where cos 2φ = -ρ².
            let angle = 0.5 * libm::acos(-skew.ratio * skew.ratio);
            assert!((Skew { angle, ..skew }.tilt() - most).abs() < 1e-7, "{skew:?}");
        }
    }
    // √2 is reached where two equal vectors coincide; the minor axis is nothing there.
    let flat = Skew { angle: 0.0, ratio: 1.0 };
    assert!((flat.major() - SQRT_2).abs() < rounding && flat.minor() == 0.0 && flat.area() == f64::INFINITY);
    // Equal vectors: half the angle, towards 45°; the second longer, at right angles: 90°.
    let almost = Skew { angle: 89.999_f64.to_radians(), ratio: 1.0 };
    assert!((almost.tilt().to_degrees() - 44.9995).abs() < 1e-9);
    assert!((Skew { angle: FRAC_PI_2, ratio: 2.0 }.tilt() - FRAC_PI_2).abs() < rounding);
    let nan = Skew { angle: f64::NAN, ratio: 1.0 };
    assert!(nan.major().is_nan() && nan.minor().is_nan() && nan.area().is_nan());
}

#[test]
fn weights_errors_agree_with_references_and_hold() {
    let table = weight_rows();
    let references = rows::<5>("weight-errors.csv");
    for [name, plane, ellipse, rim, volume] in &references {
        let row = table.iter().find(|row| row.name == *name).unwrap();
        // A sum's reference is a root of the derivative; a product's a scan, low by half a step's square
        // times a second derivative up to 40.
        let slack = if name.ends_with("product") { 4e-6 } else { 2e-9 };
        for (found, reference) in [(row.plane.value, plane), (row.ellipse.value, ellipse), (row.rim, rim)] {
            let reference = Reference::parse(reference).unwrap().to_f64();
            let above = found - reference;
            assert!(above > -1e-10 && above < slack, "{name}: {found} {reference}");
        }
        let volume = Reference::parse(volume).unwrap().to_f64();
        // Ten digits are printed.
        assert!((row.volume / volume - 1.0).abs() < 1e-9, "{name}: {}", row.volume);
    }
    assert_eq!((references.len(), table.len()), (14, 17));
    let mut draw = Draw(13);
    for (weight, row) in pixel_weights().into_iter().zip(&table) {
        assert_eq!(weight_name(weight), row.name);
        for _ in 0..4000 {
            let (aa, bb) = (draw.real(0.0, 3.0), draw.real(0.0, 3.0));
            let error = (weight.at(aa, bb) - libm::exp(-4.5 * (aa + bb))).abs();
            assert!(error <= row.plane.value + 1e-14, "{}", row.name);
            let (aa, bb) = (aa / 6.0, bb / 6.0);
            let error = (weight.at(aa, bb) - libm::exp(-4.5 * (aa + bb))).abs();
            assert!(error <= row.ellipse.value + 1e-14, "{}", row.name);
        }
    }
}

/// Against e⁻ᵗ over t ≥ 0 the errors of bells are those of fits/kernels.csv, whatever σ is.
#[test]
fn bells_keep_their_errors_in_q() {
    let table = weight_rows();
    for (i, k) in [2_u32, 4, 8].into_iter().enumerate() {
        let (certificate, _) = exponential_bell(k, CUBIC_EXP[i], None, 1e-9).unwrap();
        let row = table.iter().find(|row| row.name == format!("cubic-{k}")).unwrap();
        assert!((row.plane.value - certificate.value.hi()).abs() < 2e-9, "{k}");
        // Where in t = 9Q/2 the bell touches its error: to the square root of the tolerance.
        assert!(
            (libm::exp(-4.5 * row.plane.q) - PixelWeight::Cubic(k, 1.0 / 3.0).at(row.plane.q, 0.0)).abs()
                > row.plane.value - 2e-9
        );
    }
}

#[test]
fn the_figures_texels_lie_inside_and_mirror() {
    let texels = figure_weights();
    let footprint = Footprint::along(&FIGURE_AXES.frame());
    let inside: Vec<(i32, i32)> = (-6..=6)
        .flat_map(|v| (-6..=6).map(move |u| (u, v)))
        .filter(|&(u, v)| footprint.q(f64::from(u), f64::from(v)) <= 1.0)
        .collect();
    for weight in texels.iter().filter(|t| (t.u, t.v) == (0, 0)).map(|t| t.weight) {
        let of: Vec<_> = texels.iter().filter(|t| t.weight == weight).collect();
        let places: Vec<(i32, i32)> = of.iter().map(|t| (t.u, t.v)).collect();
        assert_eq!(places, inside, "{weight:?}");
        let sum: f64 = of.iter().map(|t| t.share).sum();
        assert!((sum - 1.0).abs() < 1e-14);
        for texel in &of {
            // Q of the matrix and Q of the frame round differently.
            assert!((texel.q - footprint.q(f64::from(texel.u), f64::from(texel.v))).abs() < 1e-14);
            let mirrored = of.iter().find(|t| (t.u, t.v) == (-texel.u, -texel.v)).unwrap();
            assert_eq!((texel.value, texel.q), (mirrored.value, mirrored.q));
        }
    }
    assert_eq!(texels.iter().filter(|t| (t.u, t.v) == (0, 0)).count(), 10);
}
