//! From what was chosen to what is emitted.

use super::Piece;
use crate::bound::{Format, Measure};
use crate::choose::{Candidate, Need};

/// 16 ε of f32: more than the roundings of any factor computed in it, at most 10.29 ε by the kernels' pages and
/// one each for its constants and the product.
const NUDGE: f64 = 16.0 * f32::EPSILON as f64;

/// The lobe of a candidate with what is proved of it in its comment, and, where a model was asked for, the factor
/// that comes along.
///
/// ```
/// use bellfit::choose::{Costs, Need, choose};
/// use bellfit::shader::{Language, emit, pieces_of};
/// let need = Need::new("16..64".parse()?, 0.02);
/// let answer = choose(&need, &Costs::default())?;
/// let pieces = pieces_of(answer.best().expect("cs_16 does"), &need);
/// let text = emit(&pieces, need.format, Language::Wgsl)?;
/// assert!(text.contains("16..64"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pieces_of(candidate: &Candidate, need: &Need) -> Vec<Piece> {
    let stand_in = candidate.stand_in;
    let lobe = Piece::Lobe { stand_in, argument: need.handed.argument(), error: sentence(candidate, need) };
    let factor = candidate.factors.first();
    let factor = factor.map(|factor| {
        // The code's own arithmetic rounds more often than a factor of f64 rounded once, whose nudge it is.
        let more = if need.format == Format::Double { factor.nudge } else { NUDGE };
        let nudge = if factor.nudge > 0.0 { factor.nudge.max(more) } else { 0.0 };
        Piece::Factor { model: factor.model, stand_in, nudge }
    });
    std::iter::once(lobe).chain(factor).collect()
}

/// What is proved, over what and on what condition; `None` where nothing is.
fn sentence(candidate: &Candidate, need: &Need) -> Option<String> {
    let bound = candidate.bound?;
    let of = match need.measure {
        Measure::Absolute => String::new(),
        Measure::Relative { floor } => format!("/cosⁿ θ where cosⁿ θ >= {}", upwards(floor)),
    };
    let range = if need.n.from() == need.n.to() {
        format!("n = {}", need.n.from())
    } else {
        let kind = if need.n.is_whole() { "whole" } else { "real" };
        format!("every {kind} n of {}..{}", need.n.from(), need.n.to())
    };
    let handed = match need.handed.id() {
        "cosine" => "cos θ rounded once",
        "versine" => "1 - cos θ rounded once",
        _ => "|a - b|^2/2 of unit vectors rounded once",
    };
    let basis = if candidate.assumes_elementary {
        format!(
            "given that pow, exp and log are within {} units in the last place, which WGSL and GLSL do not promise",
            need.ulps
        )
    } else {
        "certified".to_owned()
    };
    let constants = match (stand_in_has_constants(candidate), need.format) {
        (true, Format::Double) => ", constants computed in f64",
        (true, _) => ", constants computed in f64 and rounded once",
        (false, _) => "",
    };
    let format = need.format.id();
    Some(format!(
        "|lobe - cosⁿ θ|{of} <= {} for every θ in [0, π/2] and {range}, rounding in {format} from {handed} \
         included{constants}; {basis}.",
        upwards(bound)
    ))
}

/// Whether something is computed of n alone.
fn stand_in_has_constants(candidate: &Candidate) -> bool {
    candidate.stand_in.bell().is_some()
}

/// Five digits, rounded up so that what is printed still bounds.
fn upwards(x: f64) -> String {
    let text = format!("{x:.4e}");
    if text.parse::<f64>().is_ok_and(|printed| printed >= x) {
        return text;
    }
    // one unit of the fifth digit, by the decimal exponent that was printed
    let exponent: i32 = text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    format!("{:.4e}", x + 0.5 * libm::exp10(f64::from(exponent - 4)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_bounds_are_not_below() {
        let mut x = 1.234567e-9_f64;
        while x < 3.0 {
            let printed: f64 = upwards(x).parse().expect("a number");
            assert!(printed >= x && printed <= x * 1.0002, "{x:e}");
            x *= 1.37;
        }
        assert_eq!(upwards(0.25), "2.5000e-1");
    }
}
