//! The pixel paper's claims: every computed number against references made from definitions by mpmath
//! (tests/references/pixel_claims.py), the exact verdicts against the kernels at drawn ellipses, planted
//! claims, and mistakes in a file.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::kernel::pixel::{
    Axes, Conic, Frame, Jacobian, Padding, PaperReading, PixelWeight, Polygon, TiltFormula,
};
use bellfit::paper::{ClaimsFile, PIXEL_PAPER};
use bellfit::verdict::{Evidence, Judge, Judgement, Verdict};
use core::f64::consts::PI;
use draw::Draw;
use references::{Reference, rows};
use std::collections::BTreeSet;
use std::sync::OnceLock;

fn judgements() -> &'static [Judgement] {
    static JUDGED: OnceLock<Vec<Judgement>> = OnceLock::new();
    JUDGED.get_or_init(|| judge(PIXEL_PAPER))
}

fn judge(text: &str) -> Vec<Judgement> {
    Judge::default().judge(&ClaimsFile::parse(text).unwrap()).unwrap()
}

fn of(claim: &str, reading: &str) -> &'static Judgement {
    let found = judgements().iter().find(|j| j.claim == claim && j.reading == reading);
    found.unwrap_or_else(|| panic!("{claim}, {reading}"))
}

/// A file with one reading.
fn file(reading: &str) -> String {
    format!(
        "version = 1\n[[claim]]\nid = \"mine\"\npaper = \"\"\nlocator = \"\"\ntext = \"\"\n[[claim.reading]]\nid = \"one\"\n{reading}\n"
    )
}

fn one(reading: &str) -> Judgement {
    let mut all = judge(&file(reading));
    assert_eq!(all.len(), 1, "{reading}");
    all.remove(0)
}

/// Every number computed about the paper holds its reference, and none is without one.
#[test]
fn every_computed_number_is_enclosed() {
    let table = rows::<4>("pixel_claims.csv");
    let mut seen = BTreeSet::new();
    for [claim, reading, lo, hi] in &table {
        let computed = of(claim, reading).computed.unwrap_or_else(|| panic!("{claim}, {reading}"));
        let [lo, hi] = [lo, hi].map(|text| Reference::parse(text).unwrap());
        assert!(lo.is_enclosed(computed) && hi.is_enclosed(computed), "{claim}, {reading}: {computed:?}");
        // The searches stop at 1e-7 and 1e-9. The bracket of the best n is halved until two errors known to
        // 1e-9 cannot be told apart at its middle, which leaves a few times 1e-7: chosen by hand.
        let most = if reading.ends_with("/best-n") { 1e-6 } else { 1.1e-7 };
        let slack = computed.width() - (hi.to_f64() - lo.to_f64());
        assert!(slack < most, "{claim}, {reading}: {computed:?} is {slack:e} too wide");
        assert!(seen.insert((claim.clone(), reading.clone())), "{claim}, {reading} stands twice");
    }
    for judgement in judgements().iter().filter(|j| j.computed.is_some()) {
        let key = (judgement.claim.clone(), judgement.reading.clone());
        assert!(seen.contains(&key), "{key:?} has no reference");
    }
}

#[test]
fn everything_is_certified_but_definitions() {
    for judgement in judgements() {
        let certified = judgement.evidence == Some(Evidence::Certified);
        // A convention has neither evidence nor a number; a figure has both.
        assert_eq!(certified, judgement.verdict != Verdict::Definition || judgement.computed.is_some());
        assert!(!judgement.witness.is_empty(), "{}, {}", judgement.claim, judgement.reading);
    }
}

/// An ellipse of semi-axes p > q with its major axis at φ, under vectors turned by κ on the circle.
fn jacobian(p: f64, q: f64, phi: f64, kappa: f64) -> Jacobian<f64> {
    let ((s, c), (l, k)) = (libm::sincos(phi), libm::sincos(kappa));
    Jacobian {
        ux: c * p * k + s * q * l,
        vx: s * p * k - c * q * l,
        uy: c * p * l - s * q * k,
        vy: s * p * l + c * q * k,
    }
}

/// What is proved of a tilt holds for every drawn ellipse of its octant, and what is refuted for none.
#[test]
fn tilts_are_what_the_kernels_give() {
    let mut draw = Draw(11);
    let octants = ["0..45", "45..90", "90..135", "135..180", "180..225", "225..270", "270..315", "315..360"];
    for (i, octant) in octants.iter().enumerate() {
        for vectors in ["major-x", "major-y", "skew"] {
            for _ in 0..20 {
                let (q, more) = (draw.real(0.2, 3.0), draw.real(0.2, 5.0));
                // Inside the octant, and away from both axes under skew: by a hundredth at least.
                let phi = (i as f64 + draw.real(0.02, 0.98)) * PI / 4.0;
                let kappa = match vectors {
                    "major-x" => 0.0,
                    "major-y" => PI / 2.0,
                    _ => draw.real(0.05, PI / 2.0 - 0.05),
                };
                let j = jacobian(q + more, q, phi, kappa);
                let axes = Axes::of(j, Padding::Plain);
                for (word, formula) in [("vector", TiltFormula::Vector), ("conic", TiltFormula::Conic)] {
                    let verdict =
                        of("P6", &format!("along the major axis/{word}/{vectors}/{octant}")).verdict;
                    // Apart modulo π: a few roundings, or far more.
                    let off = libm::sin(formula.angle(j) - axes.tilt).abs();
                    assert!(!(1e-12..=1e-3).contains(&off), "{word} {vectors} {octant}: {off}");
                    assert_eq!(verdict == Verdict::Proved, off < 1e-12, "{word} {vectors} {octant}: {off}");
                }
            }
        }
    }
}

/// The same for the lengths (10), and for the conic itself.
#[test]
fn lengths_are_what_the_kernels_give() {
    let mut draw = Draw(12);
    for _ in 0..300 {
        for vectors in ["major-x", "major-y", "skew"] {
            let (q, more, phi) = (draw.real(0.2, 3.0), draw.real(0.2, 5.0), draw.real(0.0, 2.0 * PI));
            let kappa = match vectors {
                "major-x" => 0.0,
                "major-y" => PI / 2.0,
                // Nearer to the minor axis, where L is the shorter.
                _ => draw.real(PI / 4.0 + 0.05, PI / 2.0 - 0.05),
            };
            let j = jacobian(q + more, q, phi, kappa);
            let (truth, paper) = (Axes::of(j, Padding::Plain), Axes::paper(j, TiltFormula::Vector));
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
            let sorted = (paper.major.max(paper.minor), paper.major.min(paper.minor));
            let holds = [
                ("lengths", near(sorted.0, truth.major) && near(sorted.1, truth.minor)),
                ("longer", paper.major > paper.minor),
                ("area", near(paper.major * paper.minor, truth.major * truth.minor)),
                (
                    "sum-of-squares",
                    near(
                        paper.major * paper.major + paper.minor * paper.minor,
                        truth.major * truth.major + truth.minor * truth.minor,
                    ),
                ),
            ];
            for (property, holds) in holds {
                let verdict = of("P7", &format!("L and d of the ellipse/{vectors}/{property}")).verdict;
                assert_eq!(verdict == Verdict::Proved, holds, "{vectors} {property}: {j:?}");
            }
            // (10) to the letter; its terms cancel for long ellipses.
            let Conic { a, b, c, f } = Conic::of(j);
            let (u, v) = (j.ux, j.vx);
            let square = 4.0 * f * (u * u + v * v) / (a * u * u + b * u * v + c * v * v);
            assert!((square / (4.0 * paper.major * paper.major) - 1.0).abs() < 1e-9, "{j:?}");
            // The circle of radius 1 lands on the conic.
            let (y, x) = libm::sincos(draw.real(0.0, 2.0 * PI));
            let on = Conic::of(j).q(j.ux * x + j.uy * y, j.vx * x + j.vy * y);
            assert!((on - 1.0).abs() < 1e-9, "{on}");
        }
    }
    assert_eq!(of("P2", "image of the circle/-/-/radius-1").verdict, Verdict::Proved);
}

#[test]
fn rotations_are_the_kernels_frame() {
    let (u, v, frame) = (1.0, 2.0, Frame { cos: 0.6_f64, sin: 0.8, major: 1.0, minor: 0.5 });
    let (a, b) = frame.coordinates(u, v);
    // As the refuted readings' witness says what is right: 137/25.
    assert!((a * a + b * b - 137.0 / 25.0).abs() < 1e-14);
    assert!(of("P5", "axis at +α/-/++").witness.contains("not 137/25"));
    let differences = |plane: Polygon<f64>| (plane.jacobian(0.0, 0.0).ux, plane.differences(0.0, 0.0).ux);
    let plane = |d: f64| Polygon { u: [1.0, 0.0, 0.0], v: [0.0, 1.0, 0.0], w: [d, 0.0, 1.0] };
    assert_eq!(differences(plane(1.0)), (1.0, 0.5)); // the witness
    assert_eq!(differences(plane(0.0)), (1.0, 1.0));
}

/// No weight of the kernels is farther from the Gaussian than its reading's supremum, and one comes near.
#[test]
fn weights_keep_their_suprema() {
    let mut draw = Draw(13);
    for (name, reading) in ["R1", "R2", "R3", "R4"].into_iter().zip(PaperReading::ALL) {
        for shape in ["sum", "product"] {
            let weight = match shape {
                "sum" => PixelWeight::Paper(reading),
                _ => PixelWeight::PaperProduct(reading),
            };
            for (region, to) in [("ellipse", 1.0), ("plane", 16.0)] {
                let of = of("P9", &format!("how far from the Gaussian/{name}/{shape}/sup/{region}"));
                let sup = of.computed.unwrap();
                let mut largest = 0.0_f64;
                for i in 0..20_000 {
                    // The axes and the diagonals among them.
                    let (q, share) = (draw.real(0.0, to), [0.0, 0.5, draw.real(0.0, 1.0)][i % 3]);
                    let (aa, bb) = (q * share, q * (1.0 - share));
                    let gaussian = PixelWeight::Gaussian(1.0 / 3.0).at(aa, bb);
                    largest = largest.max((weight.at(aa, bb) - gaussian).abs());
                }
                // Draws are 16/6667 apart on average, and at a maximum the error is quadratic: 1e-3 is ample.
                assert!(largest <= sup.hi() + 1e-15, "{name} {shape} {region}: {largest} {sup:?}");
                assert!(largest > sup.lo() - 1e-3, "{name} {shape} {region}: {largest} {sup:?}");
            }
        }
    }
}

/// The coefficients of the fits as numpy.polyfit's kind of solution prints them, planted as claims.
#[test]
fn planted_digits_are_told_from_others() {
    let fit = |pixel: &str, points: u32, [a, b, c]: [&str; 3]| {
        one(&format!(
            "kind = \"clipped-volume-fit\"\nconstant = \"{a}\"\nlinear = \"{b}\"\nsquare = \"{c}\"\nsign = \"-\"\ninner = \"-\"\n\
             pixel = \"{pixel}\"\npoints = \"{points}\"\nconstant-term = \"free\""
        ))
        .verdict
    };
    // numpy.polyfit of ½ erfc(6d/√2) at 11 points: 0.49198, -2.42007, 2.94290.
    assert_eq!(fit("gaussian-6", 11, ["0.492", "2.420", "2.943"]), Verdict::Proved);
    assert_eq!(fit("gaussian-6", 11, ["0.492", "2.421", "2.943"]), Verdict::Refuted);
    assert_eq!(fit("gaussian-5", 11, ["0.500", "2.151", "2.358"]), Verdict::Proved);
    assert_eq!(fit("gaussian-5", 12, ["0.500", "2.151", "2.358"]), Verdict::Refuted);
}

#[test]
fn other_parameters_are_judged_by_themselves() {
    // With σ = axis/4 the semi-axis is 2σ: 8 c = 2 for c = 1/4, so no reading has its curvature.
    let weight = |reading: &str, divisor: &str, property: &str| {
        one(&format!(
            "kind = \"weight\"\nweight = \"{reading}\"\nshape = \"sum\"\ndivisor = \"{divisor}\"\nproperty = \"{property}\""
        ))
        .verdict
    };
    for reading in ["R1", "R2", "R3", "R4"] {
        assert_eq!(weight(reading, "4", "sigma"), Verdict::Refuted);
    }
    // e^(-8Q), whose semi-axis is 4σ: R1 is both.
    assert_eq!(weight("R1", "8", "both"), Verdict::Proved);
    assert_eq!(weight("R2", "8", "both"), Verdict::Refuted);
    // 1 - d (1 - 0): a line from ½ to 0 falls and ends at the base.
    let line = |property: &str, linear: &str| {
        one(&format!(
            "kind = \"clipped-volume\"\nconstant = \"0.5\"\nlinear = \"{linear}\"\nsquare = \"0\"\nsign = \"-\"\ninner = \"-\"\nproperty = \"{property}\""
        ))
        .verdict
    };
    for property in ["volume", "falls", "zero-at-base"] {
        assert_eq!(line(property, "1"), Verdict::Proved, "{property}");
    }
    assert_eq!(line("volume", "1.01"), Verdict::Refuted);
    assert_eq!(line("zero-at-base", "0.99"), Verdict::Refuted);
    assert_eq!(line("falls", "-1"), Verdict::Refuted);
    // P(1/4) = 1/4 there: a straight rim would be counted right.
    let rim = |linear: &str| {
        one(&format!(
            "kind = \"rim-volume\"\nconstant = \"0.5\"\nlinear = \"{linear}\"\nsquare = \"0\"\nsign = \"-\"\ninner = \"-\""
        ))
        .verdict
    };
    assert_eq!((rim("1"), rim("1.1")), (Verdict::Proved, Verdict::Refuted));
}

#[test]
fn mistakes_are_told_with_their_words() {
    for (reading, words) in [
        (
            "kind = \"tilt\"\ntilt = \"vector\"\nvectors = \"skew\"\noctant = \"0..90\"",
            vec!["octant", "0..90", "45..90"],
        ),
        ("kind = \"tilt\"\ntilt = \"vector\"\nvectors = \"skew\"", vec!["tilt", "`octant`"]),
        ("kind = \"conic\"\nsign = \"±\"\ninner = \"-\"\nbase = \"radius-1\"", vec!["sign", "±", "+, -"]),
        (
            "kind = \"gaussian-volume\"\ndivisor = \"0.5\"\nregion = \"plane\"",
            vec!["divisor", "0.5", "1 to 16"],
        ),
        (
            "kind = \"gaussian-volume\"\ndivisor = \"six\"\nregion = \"plane\"",
            vec!["divisor", "six", "not a decimal"],
        ),
        (
            "kind = \"gaussian-volume\"\ndivisor = \"6\"\nregion = \"plane\"\npixel = \"disk\"",
            vec!["gaussian-volume", "no `pixel`"],
        ),
        ("kind = \"bell-uncut\"\npower = \"7\"\nexponent = \"8\"", vec!["power", "7", "2, 4, 8"]),
        ("kind = \"bell-uncut\"\npower = \"8\"\nexponent = \"0\"", vec!["exponent", "0", "1 to 1024"]),
        (
            "kind = \"bell-number\"\npower = \"8\"\nexponent = \"8\"\nfigure = \"sup\"",
            vec!["bell-number", "`place`"],
        ),
        (
            "kind = \"clipped-volume-fit\"\nconstant = \"0.5\"\nlinear = \"1\"\nsquare = \"1\"\nsign = \"-\"\ninner = \"-\"\npixel = \"disk\"\npoints = \"2\"\nconstant-term = \"free\"",
            vec!["points", "2", "3 to 1001"],
        ),
    ] {
        let error = ClaimsFile::parse(&file(reading)).unwrap_err();
        assert!(error.line >= 9 && !error.message.chars().any(char::is_control), "{error}");
        for word in words {
            assert!(error.message.contains(word), "{error}: no {word:?}");
        }
    }
}
