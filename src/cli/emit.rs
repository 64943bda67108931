//! The code that `bellfit choose --emit` prints.

use super::known;
use crate::bound::Format;
use crate::choose::{Answer, SceneAnswer};
use crate::kernel::pixel::PixelWeight;
use crate::scene::{weight_from_id, weight_ids};
use crate::shader::{Language, Piece, emit, pieces_of};
use anyhow::{Result, bail};

/// σ of an emitted weight in semi-axes, half a pixel: what texture filters with a Gaussian use (Heckbert 1989).
const SIGMA: f32 = 0.5;

/// The best kernel of an answer with its factor, and what else was asked for.
pub(super) fn of_answer(answer: &Answer, extras: &[Piece], language: Language) -> Result<Option<String>> {
    let Some(best) = answer.best() else { return Ok(None) };
    let mut pieces = pieces_of(best, &answer.need);
    pieces.extend_from_slice(extras);
    Ok(Some(emit(&pieces, answer.need.format, language)?))
}

/// The best kernel of every material, and for surfaces the footprint and the cheapest weight of each.
pub(super) fn of_scene(answer: &SceneAnswer, extras: &[Piece], language: Language) -> Result<Option<String>> {
    if !answer.is_met() {
        return Ok(None);
    }
    let mut pieces: Vec<Piece> = Vec::new();
    let mut format: Option<(Format, &str)> = None;
    for material in &answer.materials {
        let Some(best) = material.answer.best() else { return Ok(None) };
        let need = &material.answer.need;
        match format {
            None => format = Some((need.format, &material.name)),
            Some((first, name)) if first != need.format => bail!(
                "--emit: \"{name}\" is in {} and \"{}\" in {}: one text has one float; keep one's materials in the file",
                first.id(),
                material.name,
                need.format.id()
            ),
            Some(_) => {}
        }
        for piece in pieces_of(best, need) {
            // Two materials with one lobe share its code; its comment then speaks of the first.
            if !pieces.iter().any(|known| is_same_code(known, &piece)) {
                pieces.push(piece);
            }
        }
    }
    if !answer.surfaces.is_empty() {
        pieces.push(Piece::Footprint);
    }
    let weights = answer.surfaces.iter().filter_map(|surface| surface.weight());
    let weights = weights.filter_map(|found| weight(&found.id));
    let extras = weights.chain(extras.iter().cloned());
    for piece in extras {
        if !pieces.contains(&piece) {
            pieces.push(piece);
        }
    }
    Ok(Some(emit(&pieces, format.map_or(Format::Single, |(format, _)| format), language)?))
}

/// Whether the two differ in their comments alone.
fn is_same_code(a: &Piece, b: &Piece) -> bool {
    match (a, b) {
        (Piece::Lobe { stand_in: a, argument: x, .. }, Piece::Lobe { stand_in: b, argument: y, .. }) => {
            a == b && x == y
        }
        _ => a == b,
    }
}

fn weight(id: &str) -> Option<Piece> {
    let double = |weight: PixelWeight<f32>| match weight {
        PixelWeight::Gaussian(sigma) => PixelWeight::Gaussian(f64::from(sigma)),
        PixelWeight::Paper(reading) => PixelWeight::Paper(reading),
        PixelWeight::PaperProduct(reading) => PixelWeight::PaperProduct(reading),
        PixelWeight::Box => PixelWeight::Box,
        PixelWeight::Bell(k, sigma) => PixelWeight::Bell(k, f64::from(sigma)),
        PixelWeight::Cubic(k, sigma) => PixelWeight::Cubic(k, f64::from(sigma)),
    };
    weight_from_id(id, SIGMA).map(|weight| Piece::Weight(double(weight)))
}

/// `footprint`, or a weight's name.
pub(super) fn extra(word: &str) -> Result<Piece, String> {
    let piece = if word == "footprint" { Some(Piece::Footprint) } else { weight(word) };
    let words: Vec<String> = std::iter::once("footprint".to_owned()).chain(weight_ids()).collect();
    known(piece, words.iter().map(String::as_str))
}

pub(super) fn language(word: &str) -> Result<Language, String> {
    known(Language::from_id(word), Language::ALL.map(Language::id))
}
