//! Pixel weights by name.

use crate::integral::GaussLegendre;
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

/// The standard deviation along either axis of a weight of Q alone, cut off at Q = 1 as the filter cuts it, in
/// semi-axes: √(½ ∫ Q w dQ/∫ w dQ) over [0, 1], as u² and v² are Q/2 in the mean.
///
/// [`weight_sigma`] is that of the whole bell. Accuracy: 1e-6, by a sum over 200000 rings; 64 intervals of 16 nodes
/// of Gauss and Legendre, as a bell may end inside. A product is not of Q alone: its values along the major axis
/// count.
///
/// ```
/// use bellfit::{kernel::pixel::PixelWeight, scene::cut_deviation};
/// assert!((cut_deviation(PixelWeight::Box) - 0.5).abs() < 1e-14); // a uniform disc's: radius/2
/// // ∫ Q e^(-2Q) dQ/∫ e^(-2Q) dQ = ½ - 1/(e² - 1)
/// let half = (0.5 * (0.5 - 1.0 / (libm::exp(2.0) - 1.0))).sqrt();
/// assert!((cut_deviation(PixelWeight::Gaussian(0.5)) - half).abs() < 1e-14);
/// ```
pub fn cut_deviation(weight: PixelWeight<f64>) -> f64 {
    let rule = GaussLegendre::new(16);
    let edge = |i: u32| f64::from(i) / 64.0;
    let over = |f: &dyn Fn(f64) -> f64| (0..64).map(|i| rule.integrate(f, edge(i), edge(i + 1))).sum::<f64>();
    (0.5 * over(&|q| q * weight.at(q, 0.0)) / over(&|q| weight.at(q, 0.0))).sqrt()
}
