//! Weights of texels from Q.

use super::ShaderError;
use super::function::{Function, Item, Statement, Type, squarings};
use super::language::Target;
use super::proof::exponential_error;
use crate::bound::{Format, short};
use crate::kernel::constants::CUBIC_EXP;
use crate::kernel::pixel::{PaperReading, PixelWeight};
use crate::kernel::real::Real;
use crate::stability::Half;

const DOMAIN: &str = "Domain: Q in [0, 1e9]; values in [0, 1]. NaN: unspecified.";

pub(super) fn items(weight: PixelWeight<f64>, target: Target) -> Result<Vec<Item>, ShaderError> {
    let digits = target.digits();
    let let_p = |value: String| Statement::Let("p", format!("max({value}, 0.0)"));
    let item = match weight {
        PixelWeight::Gaussian(sigma) => {
            let scale = digits.of(scale(sigma, 1, target)?);
            let about = vec![
                format!(
                    "Weight of a texel: the Gaussian e^(-Q/(2 σ²)), σ = {} of the semi-axis.",
                    short(sigma)
                ),
                DOMAIN.to_owned(),
                "Error: that of exp, and of the rounded factor of Q.".to_owned(),
                "Source: the pixel paper, (3) and (4), without their factor.".to_owned(),
            ];
            radial("gaussian_weight", about, vec![Statement::Return(format!("exp(-({scale} * q))"))])
        }
        PixelWeight::Box => {
            let about = vec![
                "Weight of a texel under equal weights: 1.".to_owned(),
                DOMAIN.to_owned(),
                "Error: none.".to_owned(),
                "Source: the definition.".to_owned(),
            ];
            radial("box_weight", about, vec![Statement::Unused("q"), Statement::Return("1.0".to_owned())])
        }
        PixelWeight::Paper(reading) => {
            let c: f64 = reading.scale();
            let mut body = vec![let_p(format!("1.0 - {} * q", digits.of(c)))];
            body.extend(squarings(8));
            radial(&format!("{}_weight", paper(reading)), paper_about(reading, false)?, body)
        }
        PixelWeight::PaperProduct(reading) => {
            let c: f64 = reading.scale();
            let edge = digits.of(c);
            let set = |name, value: &str| Statement::Let(name, value.to_owned());
            // The eighth power of the product: three squarings serve both.
            let body = vec![
                Statement::Let("a", format!("max(1.0 - {edge} * aa, 0.0)")),
                Statement::Let("b", format!("max(1.0 - {edge} * bb, 0.0)")),
                set("p", "a * b"),
                set("squared", "p * p"),
                set("fourth", "squared * squared"),
                Statement::Return("fourth * fourth".to_owned()),
            ];
            Item::Function(Function {
                name: format!("{}_weight_product", paper(reading)),
                about: paper_about(reading, true)?,
                parameters: vec![("aa", Type::Real), ("bb", Type::Real)],
                result: Type::Real,
                arithmetic: Type::Real,
                body,
            })
        }
        PixelWeight::Bell(power, sigma) => {
            if !(power.is_power_of_two() && (2..=64).contains(&power)) {
                return Err(ShaderError::Power { power, weight: "the bell", offered: "2, 4, 8, 16, 32, 64" });
            }
            let scale = digits.of(scale(sigma, power, target)?);
            let mut body = vec![let_p(format!("1.0 - {scale} * q"))];
            body.extend(squarings(power));
            let source = "Source: R. F. Lyon, Apple Technical Report 43, 1993; the pixel paper, (8).";
            let formula = format!("max(1 - t/{power}, 0)^{power}");
            radial(&format!("bell_{power}_weight"), bell_about(&formula, power, false, sigma, source)?, body)
        }
        PixelWeight::Cubic(power, sigma) => {
            let Some([c1, c2, c3]) = cubic_row(power) else {
                return Err(ShaderError::Power { power, weight: "the cubic bell", offered: "2, 4, 8" });
            };
            let scale = digits.of(scale(sigma, power, target)?);
            let [c1, c2, c3] = [c1, c2, c3].map(|c| digits.of(c));
            let mut body = vec![
                Statement::Let("y", format!("{scale} * q")),
                let_p(format!("1.0 - y * ({c1} - y * ({c2} - y * {c3}))")),
            ];
            body.extend(squarings(power));
            let formula = format!("max(1 - c1 y + c2 y² - c3 y³, 0)^{power}, y = t/{power},");
            let source = "Source: bellfit's fit.";
            radial(&format!("cubic_{power}_weight"), bell_about(&formula, power, true, sigma, source)?, body)
        }
    };
    Ok(vec![item])
}

fn cubic_row(power: u32) -> Option<[f64; 3]> {
    matches!(power, 2 | 4 | 8).then(|| CUBIC_EXP[power.trailing_zeros() as usize - 1])
}

fn radial(name: &str, about: Vec<String>, body: Vec<Statement>) -> Item {
    Item::Function(Function {
        name: name.to_owned(),
        about,
        parameters: vec![("q", Type::Real)],
        result: Type::Real,
        arithmetic: Type::Real,
        body,
    })
}

/// 1/(2 σ² K), which takes Q to t/K; a normal number of the format.
fn scale(sigma: f64, power: u32, target: Target) -> Result<f64, ShaderError> {
    let scale = 1.0 / (2.0 * sigma * sigma * f64::from(power));
    let (rounded, least) = match target.format {
        Format::Half => (Half::from_f64(scale).to_f64(), 1.0 / 16384.0),
        Format::Double => (scale, f64::MIN_POSITIVE),
        _ => (f64::from(scale as f32), f64::from(f32::MIN_POSITIVE)),
    };
    let holds = sigma > 0.0 && rounded.is_finite() && rounded >= least;
    if holds { Ok(scale) } else { Err(ShaderError::Sigma(sigma)) }
}

fn bell_about(
    formula: &str,
    power: u32,
    cubic: bool,
    sigma: f64,
    source: &str,
) -> Result<Vec<String>, ShaderError> {
    Ok(vec![
        format!(
            "Weight of a texel: the bell {formula} of t = Q/(2 σ²), σ = {} of the semi-axis.",
            short(sigma)
        ),
        DOMAIN.to_owned(),
        format!("Error: |weight - e^-t| <= {}.", exponential_error(power, cubic)?),
        source.to_owned(),
    ])
}

fn paper(reading: PaperReading) -> &'static str {
    match reading {
        PaperReading::R1 => "paper_r1",
        PaperReading::R2 => "paper_r2",
        PaperReading::R3 => "paper_r3",
        PaperReading::R4 => "paper_r4",
    }
}

fn paper_about(reading: PaperReading, is_product: bool) -> Result<Vec<String>, ShaderError> {
    let c: f64 = reading.scale();
    let (t, bound) = (short(8.0 * c), exponential_error(8, false)?);
    let (formula, error) = if is_product {
        (
            format!("(1 - {c} a²)^8 (1 - {c} b²)^8, each clamped at 0, of the squares along the two axes"),
            format!("Error: |weight - e^-t|, t = {t} (a² + b²), is at most twice that of one bell, {bound}."),
        )
    } else {
        (format!("max(1 - {c} Q, 0)^8"), format!("Error: |weight - e^-t| <= {bound}; t = {t} Q."))
    };
    Ok(vec![
        format!("Weight of a texel: the pixel paper's {formula}, in the reading c = {c}."),
        DOMAIN.to_owned(),
        error,
        "Source: the pixel paper, (8) and (9), whose print lost c.".to_owned(),
    ])
}
