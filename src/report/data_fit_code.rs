//! A lobe fitted to measured samples, as code.

use crate::fit::measured::{Estimate, Family};
use std::fmt::Write;

/// A few lines of Rust that compute the lobe at `cos`, in `f32`, or in `f64` if the scale is beyond its normal numbers.
///
/// Where the estimate's parameters have no uncertainty, as with n at an end of its range, a comment says that they are
/// not final; where 1 - cos is formed, another what that loses.
pub fn data_fit_code(estimate: &Estimate) -> String {
    let mut code = String::new();
    if let Err(reason) = estimate.uncertainty {
        let _ = writeln!(code, "// not final: {reason}");
    }
    code + &if (estimate.scale as f32).is_normal() {
        code_in::<f32>(estimate)
    } else {
        code_in::<f64>(estimate)
    }
}

/// A float type as code names and prints it.
trait Spelt {
    const NAME: &str;
    /// The nearest number of the type, as a literal.
    fn literal(x: f64) -> String;
}

impl Spelt for f32 {
    const NAME: &str = "f32";
    fn literal(x: f64) -> String {
        format!("{:?}", x as f32)
    }
}

impl Spelt for f64 {
    const NAME: &str = "f64";
    fn literal(x: f64) -> String {
        format!("{x:?}")
    }
}

fn code_in<T: Spelt>(estimate: &Estimate) -> String {
    let family = estimate.family;
    let (n, float) = (T::literal(estimate.n), T::NAME);
    let scale = format!("{}_{float}", T::literal(estimate.scale));
    let function =
        |name: &str| format!("use bellfit::kernel::lobe::{name};\nlet value = {scale} * {name}(cos, {n});\n");
    let lobe = |module: &str, name: &str, k: u32| {
        format!(
            "use bellfit::kernel::{module}::{name};\nlet lobe = {name}::<{k}, {float}>::new({n}); // once a material\n\
             let value = {scale} * lobe.at(cos);\n"
        )
    };
    match family {
        Family::CosN => function("cos_n"),
        Family::Cs16 => function("cs_16"),
        Family::SphericalGaussian => function("spherical_gaussian"),
        Family::Schlick => function("schlick"),
        Family::Linear2 => lobe("linear", "LinearLobe", 2),
        Family::Linear4 => lobe("linear", "LinearLobe", 4),
        Family::Linear8 => lobe("linear", "LinearLobe", 8),
        Family::Linear32 => lobe("linear", "LinearLobe", 32),
        Family::Cubic2 => lobe("cubic", "CubicLobe", 2),
        Family::Cubic4 => lobe("cubic", "CubicLobe", 4),
        Family::Cubic8 => lobe("cubic", "CubicLobe", 8),
        Family::Free2 => free::<T>(estimate, &scale, "p * p"),
        Family::Free4 => free::<T>(estimate, &scale, "(p * p) * (p * p)"),
        Family::Free8 => free::<T>(estimate, &scale, "(p * p) * (p * p) * ((p * p) * (p * p))"),
    }
}

fn free<T: Spelt>(estimate: &Estimate, scale: &str, power: &str) -> String {
    let Some(([k1, k2, k3], reach)) = estimate.family.horner(estimate.n, estimate.shape) else {
        return String::new();
    };
    let [k1, k2, k3, reach] = [k1, k2, k3, reach].map(T::literal);
    format!(
        "let w = 1.0 - cos; // what cos is rounded by counts n times in the value: of an angle, w = 2 sin²(θ/2) keeps it\n\
         let p = if w < {reach} {{ 1.0 - w * ({k1} - w * ({k2} - w * {k3})) }} else {{ 0.0_{float} }};\n\
         let value = {scale} * {power};\n",
        float = T::NAME
    )
}
