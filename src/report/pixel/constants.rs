//! The adopted polynomials of the clip volume.

use super::PixelStudy;
use crate::fit::clip::{ClipObjective, ClipRow, ClipTarget};
use crate::report::number::{short, short_up};
use std::fmt::Write;

/// What is adopted, all for σ = 1/6: objective, degree, whether P(0) = ½, and what it is.
pub(in crate::report) const ADOPTED: [(ClipObjective, u32, bool, &str); 3] = [
    (ClipObjective::Minimax, 2, false, "quadratic"),
    (ClipObjective::Minimax, 2, true, "quadratic, P(0) = ½"),
    (ClipObjective::Falling, 3, true, "cubic, P(0) = ½, falling to P(½) = 0"),
];

/// The row of the table.
pub(in crate::report) fn adopted(
    study: &PixelStudy,
    objective: ClipObjective,
    degree: u32,
    half: bool,
) -> Option<&ClipRow> {
    let is = |row: &&ClipRow| {
        (row.target, row.objective, row.degree, row.half)
            == (ClipTarget::Gaussian(6.0), objective, degree, Some(half))
    };
    study.clip.iter().find(is)
}

/// The source of `CLIP_MINIMAX`; `None` if a row is missing.
pub(in crate::report) fn clip_constants(study: &PixelStudy) -> Option<String> {
    let mut text = String::from(
        "/// Stand-ins for the volume of the Gaussian pixel, σ = 1/6, beyond a line at distance d in [0, ½]:\n\
         /// p₀ + p₁ d + p₂ d² + p₃ d³ for ½ erfc(d/(σ√2)), read through\n\
         /// [`ClipPolynomial`](super::pixel::ClipPolynomial).\n///\n\
         /// Above each row a bound of the error, certified over [0, ½], and where it is reached to six digits.\n\
         pub const CLIP_MINIMAX: [[f64; 4]; 3] = [\n",
    );
    for (objective, degree, half, name) in ADOPTED {
        let row = adopted(study, objective, degree, half)?;
        let values: Vec<String> = row.coefficients.iter().map(|v| format!("{v:?}")).collect();
        let _ = write!(
            text,
            "    // {name}: {} (d = {})\n    [{}],\n",
            short_up(row.error),
            short(row.at),
            values.join(", ")
        );
    }
    text.push_str("];\n");
    Some(text)
}
