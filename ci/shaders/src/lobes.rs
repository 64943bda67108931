//! Lobes against the kernels in double precision, and against cosⁿ by the bound in their comment.
//!
//! What is allowed beside that bound follows from the accuracy that WGSL asks for (WebGPU Shading Language,
//! "Floating Point Accuracy"): +, - and × correctly rounded, x/y 2.5 ulp, exp and exp2 (3 + 2 |x|) ulp, log2
//! 3 ulp, or 2⁻²¹ absolute for x in [1/2, 2], pow as exp2(y log2 x). An ulp is at most ε of the value.

use crate::adapter::Adapter;
use crate::measure::Measure;
use bellfit::bound::Format;
use bellfit::kernel::lobe::cos_n_versine;
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::{Argument, StandIn};
use bellfit::shader::{Language, Piece, emit};

pub const EPSILON: f64 = f32::EPSILON as f64;

/// Exponents in the papers' range, its ends among them.
const EXPONENTS: [f32; 8] = [16.0, 17.5, 32.0, 54.625, 100.0, 333.25, 777.0, 1024.0];

/// [0, 1]: a grid, and every exponent towards both ends.
fn unit() -> Vec<f32> {
    let mut all: Vec<f32> = (0..=49_152).map(|i| i as f32 / 49_152.0).collect();
    for e in 0..126 {
        for i in 0..64 {
            let x = (1.0 + i as f32 / 64.0) * 2.0_f32.powi(-e - 1);
            all.extend([x, 1.0 - x]);
        }
    }
    all
}

/// The call for a row (n, x), the constants computed on the spot.
fn expression(stand_in: StandIn, argument: Argument) -> String {
    let versine = argument == Argument::Versine;
    let suffix = if versine { "_versine" } else { "" };
    let stem = stand_in.id().replace('-', "_");
    match (stand_in, stand_in.bell()) {
        (_, Some((_, 1))) if versine => format!("{stem}_lobe_versine({stem}_slope(x0), x1)"),
        (_, Some(_)) => format!("{stem}_lobe{suffix}({stem}{suffix}_constants(x0), x1)"),
        (StandIn::Schlick, _) => format!("schlick_lobe{suffix}(x1, x0)"),
        (StandIn::SchlickPrinted, _) => format!("schlick_printed_lobe{suffix}(x1, x0)"),
        (StandIn::SphericalGaussian, _) => format!("spherical_gaussian{suffix}(x1, x0)"),
        (StandIn::Squarings, _) => format!("cos_n_squarings{suffix}(x1, u32(x0))"),
        (StandIn::Exp2Log2, _) => format!("cos_n_base_two{suffix}(x1, x0)"),
        _ => format!("cos_n_pow{suffix}(x1, x0)"),
    }
}

/// What rounding may do to the lobe at (n, x) whose value is v.
fn rounding(stand_in: StandIn, argument: Argument, n: f64, x: f64, v: f64) -> f64 {
    let versine = argument == Argument::Versine;
    let cos = if versine { 1.0 - x } else { x };
    // 1 - w rounds by ε/4 where c is above 1/2, and there alone: relative at most ε/2 in c.
    let handed = if versine { 0.5 } else { 0.0 };
    if let Some((power, degree)) = stand_in.bell() {
        let k = f64::from(power);
        // The slope of u or p: n/T and, for degree three, ∛β n/T, both below 0.4 n for K = 2, T = 2.7.
        let slope = if versine { 0.0 } else { 0.4 * n };
        // p, of what it is made: see the reasons.
        let base = match (degree, versine || power == 8) {
            // n/T relative 8 ε (two divisions, a product, two sums) times t/T ≤ 1, the product and the
            // difference; from cos θ the sum's terms are as large as the slope.
            (1, _) => 9.0 + slope,
            // k, k', k'' relative 7, 12 and 16 ε, with |k w| + |k' w²| + |k'' w³| at most 2.8, 3.3 and 1.5, and two
            // roundings of each in p. 1 - c adds ε/4 (k ≤ 2.8 n/T).
            (_, true) => 100.0 + slope,
            // u = a + b c, three roundings of terms as large as the slope and 47 ε of its shift, times
            // |dp/du| ≤ 3; c and d 162 and 250 ε.
            _ => 4.5 * slope + 600.0,
        };
        // δf = K p^(K - 1) δp, and squarings: (K - 1) ε/2 relative.
        return k * (base + 1.0) * EPSILON;
    }
    let exponent = if cos > 0.0 { (n * Real::log2(cos)).abs() } else { 0.0 };
    // log2's own error times n, the product's rounding, both in the exponent; then exp2's.
    let log2 = if cos >= 0.5 { 2.0_f64.powi(-21) } else { 3.0 * EPSILON * Real::log2(cos.max(1e-45)).abs() };
    let by_exponent =
        core::f64::consts::LN_2 * (n * log2 + exponent * EPSILON) + (3.0 + 2.0 * exponent) * EPSILON;
    let relative = match stand_in {
        StandIn::Schlick => (6.0 + 4.0 * handed) * EPSILON,
        // The denominator's terms are as large as n.
        StandIn::SchlickPrinted => {
            let denominator = n - n * cos + cos;
            (4.0 + (2.0 + handed) * n / denominator) * EPSILON
        }
        // n w rounds twice, in the exponent
        StandIn::SphericalGaussian => (3.0 + 4.0 * n * (1.0 - cos)) * EPSILON,
        StandIn::Squarings => 0.51 * n * EPSILON + handed * n * EPSILON,
        _ => by_exponent + handed * n * EPSILON,
    };
    // To first order; the second is small while this is.
    v * Real::expm1(relative)
}

/// The bound that the comment states of |lobe - cosⁿ|.
fn stated(code: &str) -> Option<f64> {
    let (_, after) = code.split_once("|lobe - cos^n theta| <= ")?;
    let number = after.split(',').next()?;
    Some(number.parse().expect("a number after the sign"))
}

/// Whether a lobe whose slope is 2 % short is out of bounds somewhere.
fn a_defect_is_seen(adapter: &Adapter, unit: &[f32]) -> bool {
    let (stand_in, argument) = (StandIn::Cs16, Argument::Versine);
    let piece = Piece::Lobe { stand_in, argument, error: None };
    let code = emit(&[piece], Format::Single, Language::Wgsl).expect("WGSL has every lobe");
    let defective = code.replace("n / 16.0", "n / 16.32");
    assert_ne!(code, defective);
    let rows: Vec<[f32; 2]> = unit.iter().map(|w| [100.0, *w]).collect();
    let found = adapter.run(&defective, &expression(stand_in, argument), &rows);
    rows.iter().zip(found).any(|(row, found)| {
        let [n, w] = row.map(f64::from);
        let value = stand_in.at_versine(w, n);
        (f64::from(found) - value).abs() > rounding(stand_in, argument, n, w, value)
    })
}

pub fn check(adapter: &Adapter) -> usize {
    let (unit, mut count) = (unit(), 0);
    assert!(a_defect_is_seen(adapter, &unit), "a planted defect stays within the bounds");
    for stand_in in StandIn::ALL {
        for argument in [Argument::Cosine, Argument::Versine] {
            let piece = Piece::Lobe { stand_in, argument, error: None };
            let code = emit(&[piece], Format::Single, Language::Wgsl).expect("WGSL has every lobe");
            let bound = stated(&code);
            assert_eq!(bound.is_some(), stand_in.bell().is_some(), "{}", stand_in.id());
            let name = expression(stand_in, argument);
            let mut kernel = Measure::new(format!("{name} against the kernel"));
            let mut cos_n = Measure::new(format!("{name} against cos^n, stated {:?}", bound.unwrap_or(0.0)));
            let ns: Vec<f32> = EXPONENTS
                .into_iter()
                .filter(|n| stand_in != StandIn::Squarings || n.fract() == 0.0)
                .collect();
            let rows: Vec<[f32; 2]> = ns.iter().flat_map(|n| unit.iter().map(|x| [*n, *x])).collect();
            let found = adapter.run(&code, &name, &rows);
            for (row, found) in rows.iter().zip(found) {
                let [n, x] = row.map(f64::from);
                let (value, versine) = match argument {
                    Argument::Cosine => (stand_in.at(x, n), 1.0 - x),
                    Argument::Versine => (stand_in.at_versine(x, n), x),
                };
                let allowed = rounding(stand_in, argument, n, x, value);
                kernel.add(row, found, value, allowed);
                if let Some(bound) = bound {
                    cos_n.add(row, found, cos_n_versine(versine, n), bound + allowed);
                }
            }
            count += kernel.report();
            if bound.is_some() {
                cos_n.report();
            }
        }
    }
    count
}
