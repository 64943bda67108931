//! What the tests of the pixel kernels share.
#![allow(dead_code)] // every test file uses its part

use super::draw::Draw;
use super::references::Reference;
use bellfit::kernel::pixel::Jacobian;
use bellfit::kernel::real::Real;
use std::f64::consts::PI;

/// Half an ulp at 1.
pub fn unit<F: Real>() -> f64 {
    let single = F::from_f64(1.0 + f64::EPSILON) == F::ONE;
    if single { 1.0 / (1u32 << 24) as f64 } else { 1.0 / (1u64 << 53) as f64 }
}

/// ux, vx, uy, vy.
pub fn jacobian<F: Real>([ux, vx, uy, vy]: [f64; 4]) -> Jacobian<F> {
    let of = F::from_f64;
    Jacobian { ux: of(ux), vx: of(vx), uy: of(uy), vy: of(vy) }
}

/// |x - reference| in doubles, the difference taken exactly; infinite for a value that is not finite.
pub fn distance(reference: &Reference, x: f64) -> f64 {
    if x.is_finite() { reference.distance(x).to_f64().value() } else { f64::INFINITY }
}

/// The same by the reference's size.
pub fn relative(reference: &Reference, x: f64) -> f64 {
    let error = distance(reference, x);
    if error == 0.0 { 0.0 } else { error / reference.to_f64().abs() }
}

/// A rotation times diag(major, minor) times a rotation, and every second one mirrored.
pub fn drawn(draw: &mut Draw, major: f64, aspect: f64) -> [f64; 4] {
    let (a, b) = (draw.real(-PI, PI), draw.real(-PI, PI));
    let minor = major / aspect * if draw.below(2) == 0 { 1.0 } else { -1.0 };
    let ((ca, sa), (cb, sb)) = ((libm::cos(a), libm::sin(a)), (libm::cos(b), libm::sin(b)));
    [
        ca * major * cb - sa * minor * sb,
        sa * major * cb + ca * minor * sb,
        -ca * major * sb - sa * minor * cb,
        -sa * major * sb + ca * minor * cb,
    ]
}

/// Whether the type holds all of them exactly.
pub fn fits<F: Real>(values: &[f64]) -> bool {
    values.iter().all(|&x| F::from_f64(x).to_f64() == x)
}
