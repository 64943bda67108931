//! From what was chosen to what is emitted.

use super::Piece;
use crate::bound::{Format, Handed, Measure, short_up};
use crate::choose::{Candidate, Need};

/// 32 ε of f32: more than the roundings of any factor computed in it, at most 21 ε where a shading language
/// divides, and one each for its constants and the product.
const NUDGE: f64 = 32.0 * f32::EPSILON as f64;

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
    let (of, at) = match need.measure {
        Measure::Absolute => ("", String::new()),
        Measure::Relative { floor } => ("/cosⁿ θ", format!(" with cosⁿ θ >= {floor}")),
    };
    let range = if need.n.from() == need.n.to() {
        format!("n = {}", need.n.from())
    } else {
        let kind = if need.n.is_whole() { "whole" } else { "real" };
        format!("every {kind} n of {}..{}", need.n.from(), need.n.to())
    };
    let handed = match need.handed {
        Handed::Cosine => "cos θ rounded once",
        Handed::Versine => "1 - cos θ rounded once",
        Handed::Difference => "|a - b|^2/2 of unit vectors rounded once",
    };
    let basis = if candidate.assumes_elementary {
        format!(
            "given that pow, exp and log are within {} units in the last place, which WGSL and GLSL do not promise",
            need.ulps
        )
    } else {
        "certified".to_owned()
    };
    let constants = match (has_constants(candidate), need.format) {
        (true, Format::Double) => ", constants computed in f64",
        (true, _) => ", constants computed in f64 and rounded once",
        (false, _) => "",
    };
    let format = need.format.id();
    Some(format!(
        "|lobe - cosⁿ θ|{of} <= {} for every θ in [0, π/2]{at} and {range}, rounding in {format} from {handed} \
         included{constants}; {basis}.",
        short_up(bound)
    ))
}

/// Whether something is computed of n alone.
fn has_constants(candidate: &Candidate) -> bool {
    candidate.stand_in.bell().is_some()
}
