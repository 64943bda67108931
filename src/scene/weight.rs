//! Pixel weights by name.

use crate::kernel::pixel::{PaperReading, PixelWeight};

/// Powers of Lyon's bell and of the cubic one.
const BELLS: [u32; 6] = [2, 4, 8, 16, 32, 64];
const CUBICS: [u32; 3] = [2, 4, 8];
const READINGS: [&str; 4] = ["paper-r1", "paper-r2", "paper-r3", "paper-r4"];

/// Every weight's name: `gaussian`, `box`, `paper-r1` to `paper-r4`, the same with `-product`, `bell-2` to
/// `bell-64`, `cubic-2`, `cubic-4`, `cubic-8`.
pub fn weight_ids() -> Vec<String> {
    let mut ids = vec!["gaussian".to_owned(), "box".to_owned()];
    ids.extend(READINGS.map(str::to_owned));
    ids.extend(READINGS.map(|id| format!("{id}-product")));
    ids.extend(BELLS.map(|k| format!("bell-{k}")));
    ids.extend(CUBICS.map(|k| format!("cubic-{k}")));
    ids
}

/// The weight of a name, with this standard deviation (in semi-axes) where it has one; none for a name that
/// [`weight_ids`] does not list.
///
/// ```
/// use bellfit::kernel::pixel::PixelWeight;
/// use bellfit::scene::weight_from_id;
/// assert_eq!(weight_from_id("cubic-4", 0.5), Some(PixelWeight::Cubic(4, 0.5)));
/// assert_eq!(weight_from_id("cubic-3", 0.5), None);
/// ```
pub fn weight_from_id(id: &str, sigma: f32) -> Option<PixelWeight<f32>> {
    let number = |prefix: &str, known: &[u32]| {
        known.iter().copied().find(|k| id.strip_prefix(prefix) == Some(k.to_string().as_str()))
    };
    match id {
        "gaussian" => return Some(PixelWeight::Gaussian(sigma)),
        "box" => return Some(PixelWeight::Box),
        _ => {}
    }
    if let Some(k) = number("bell-", &BELLS) {
        return Some(PixelWeight::Bell(k, sigma));
    }
    if let Some(k) = number("cubic-", &CUBICS) {
        return Some(PixelWeight::Cubic(k, sigma));
    }
    let (stem, product) = id.strip_suffix("-product").map_or((id, false), |stem| (stem, true));
    let reading = PaperReading::ALL[READINGS.iter().position(|&known| known == stem)?];
    Some(if product { PixelWeight::PaperProduct(reading) } else { PixelWeight::Paper(reading) })
}

/// The standard deviation in semi-axes, of the weights that have one.
pub fn weight_sigma(weight: PixelWeight<f32>) -> Option<f32> {
    match weight {
        PixelWeight::Gaussian(sigma) | PixelWeight::Bell(_, sigma) | PixelWeight::Cubic(_, sigma) => {
            Some(sigma)
        }
        PixelWeight::Paper(_) | PixelWeight::PaperProduct(_) | PixelWeight::Box => None,
    }
}
