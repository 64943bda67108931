//! The kernels as code in other languages: lobes, factors, footprints and weights to paste into a renderer.
//!
//! One text is written for all of them, with its constants from [`kernel`](crate::kernel) in the digits that
//! read back in the type. Spelt as WGSL it is what runs; naga validates it and translates it into GLSL, HLSL
//! and MSL; C and Rust are spelt from the same text.
//!
//! | language | f16 | f32 | f64 |
//! |---|---|---|---|
//! | Rust, C | | yes | yes |
//! | WGSL | yes, but for the footprint | yes | |
//! | GLSL, HLSL | | yes | where it needs no exponential, power or cube root |
//! | MSL | | yes | |
//!
//! What is not in the table is a [`ShaderError`]. f16 is the lobe's own arithmetic; what depends on n alone
//! is computed in f32 and then rounded.
//!
//! NaN: Rust and C keep IEEE 754; a maximum there gives its other argument for a NaN, unlike the kernels'.
//! In shaders NaN and infinities are unspecified, and none is made from arguments in the domain.

mod chosen;
mod error;
mod factor;
mod footprint;
mod function;
mod language;
mod lobe;
mod number;
mod piece;
mod proof;
mod spelling;
mod translation;
mod weight;

pub use chosen::pieces_of;
pub use error::ShaderError;
pub use language::Language;
pub use piece::Piece;

use crate::bound::Format;
use function::{Item, Program};
use language::Target;

/// The pieces as code, each function with its meaning, formula, domain, proven error and source above it.
///
/// A helper that two pieces share is there once. For the shading languages the text has no entry point and
/// no `#version`: it is to be pasted.
///
/// # Errors
/// [`ShaderError`] for what the table of [the module](self) lacks, for a factor of a lobe that has none, for
/// a weight outside its domain, and for two weights of one name with different σ.
///
/// Bounds are computed on the way, once a process: about a second each for a cubic lobe and its factor.
///
/// ```
/// use bellfit::bound::Format;
/// use bellfit::kernel::stand_in::{Argument, StandIn};
/// use bellfit::shader::{Language, Piece, emit};
/// let piece = Piece::Lobe { stand_in: StandIn::Cs16, argument: Argument::Versine, error: None };
/// let text = emit(&[piece], Format::Single, Language::C)?;
/// assert!(text.contains("static inline float cs_16_lobe_versine(float slope, float versine) {"));
/// assert!(text.contains("1.7280e-2")); // sup |cs_16 - cosⁿ|, rounded up
/// # Ok::<(), bellfit::shader::ShaderError>(())
/// ```
pub fn emit(pieces: &[Piece], format: Format, language: Language) -> Result<String, ShaderError> {
    let target = Target::new(language, format)?;
    let mut program = Program::default();
    for piece in pieces {
        let items: Vec<Item> = match piece {
            Piece::Lobe { stand_in, argument, error } => {
                lobe::items(*stand_in, *argument, error.as_deref(), target)?
            }
            Piece::Factor { model, stand_in, nudge } => factor::items(*model, *stand_in, *nudge, target)?,
            Piece::Footprint => footprint::items(target)?,
            Piece::Weight(weight) => weight::items(*weight, target)?,
        };
        items.into_iter().try_for_each(|item| program.add(item))?;
    }
    if program.is_empty() {
        return Err(ShaderError::Empty);
    }
    if let Some(function) = target.missing(&program) {
        return Err(ShaderError::Elementary { language, format: format.id(), function });
    }
    match language {
        Language::Rust | Language::C => Ok(spelling::text(&program, target)),
        _ => translation::text(&program, target),
    }
}
