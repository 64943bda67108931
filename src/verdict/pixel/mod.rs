//! Statements about pixels: footprints, weights, and clipped volumes.

mod axes;
mod bell;
mod clip;
mod footprint;
mod gaussian;
mod rim;
mod weight;

use super::judgement::{Finding, Verdict};
use crate::bound::{Multivariate, enclose};
use crate::paper::{PixelKind, Printed, Sign};
use dashu_ratio::RBig;

/// Everything here is exact or enclosed.
pub(super) fn judge(kind: &PixelKind) -> Finding {
    match kind {
        PixelKind::DerivativesAgree { denominator } => footprint::derivatives_agree(*denominator),
        PixelKind::Conic { sign, inner, base } => footprint::conic(*sign, *inner, *base),
        PixelKind::Rotation { sign, second } => footprint::rotation(*sign, *second),
        PixelKind::GaussianVolume { divisor, region } => gaussian::volume(divisor, *region),
        PixelKind::GaussianBeyondBase { divisor, place } => shown(gaussian::beyond_base(divisor), place),
        PixelKind::Tilt { formula, octant, vectors } => axes::tilt(*formula, *octant, *vectors),
        PixelKind::AxisFormula { sign } => axes::axis_formula(*sign),
        PixelKind::AxesAre { property, vectors } => axes::axes_are(*property, *vectors),
        PixelKind::BellNumber { power, exponent, figure, place } => {
            shown(bell::number(*power, *exponent, *figure), place)
        }
        PixelKind::BellIsNearest { power, exponent } => bell::is_nearest(*power, *exponent),
        PixelKind::BellUncut { power, exponent } => bell::uncut(*power, *exponent),
        PixelKind::WeightNumber { weight, figure, region, place } => {
            shown(weight::number(weight, *figure, *region), place)
        }
        PixelKind::WeightOnRim { weight, place } => shown(weight::on_rim(weight), place),
        PixelKind::WeightHas { weight, property } => weight::has(weight, *property),
        PixelKind::WeightIsNearest { weight, region } => weight::is_nearest(weight, *region),
        PixelKind::ClipHas { formula, property } => clip::has(formula, *property),
        PixelKind::ClipDistance { formula, pixel, place } => shown(clip::distance(formula, *pixel), place),
        PixelKind::ClipFit { formula, pixel, points, constant } => {
            clip::fit(formula, *pixel, *points, *constant)
        }
        PixelKind::RimTexel { share } => rim::texel(*share),
        PixelKind::RimVolume { formula } => rim::volume(formula),
    }
}

/// A figure with its place.
fn shown(mut found: Finding, place: &str) -> Finding {
    found.witness = format!("{}; {place}", found.witness);
    found
}

/// Refuted where the two sides differ at the witness; where they do not, it decides nothing.
fn decided(differs: bool, witness: String) -> Finding {
    let verdict = if differs { Verdict::Refuted } else { Verdict::Undecided };
    Finding { printed: String::new(), computed: None, verdict, witness }
}

/// a/b.
fn ratio(a: i64, b: i64) -> RBig {
    RBig::from_parts_signed(a.into(), b.into())
}

/// The number with its sign.
fn signed<const N: usize>(sign: Sign, value: Multivariate<N>) -> Multivariate<N> {
    match sign {
        Sign::Plus => value,
        Sign::Minus => Multivariate::int(0) - value,
    }
}

/// The semi-axis by σ: half the divisor of σ = axis/divisor.
fn axis_by_sigma(divisor: &Printed) -> RBig {
    divisor.value.clone() / RBig::from(2)
}

/// An exact number as it reads best: a decimal where that is short.
fn text(value: &RBig) -> String {
    let double = enclose(value);
    let decimal = double.mid().to_string();
    if double.lo() == double.hi() && decimal.len() <= 12 { decimal } else { value.to_string() }
}
