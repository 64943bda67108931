//! A picture's colours in a palette, which makes a PNG half as large and less.

use std::collections::BTreeMap;

/// Pixels by their places in a palette.
pub(super) struct Indexed {
    /// Red, green, blue, a colour after the other.
    pub(super) palette: Vec<u8>,
    /// A place a pixel.
    pub(super) pixels: Vec<u8>,
}

/// A palette of at most `most` + 1 colours, chosen one by one, each time the colour whose absence is felt
/// most: its pixels times the square of its distance from the nearest one chosen. Every other colour becomes
/// the nearest of them.
///
/// What is drawn in large is drawn in few colours, and a ramp's are far apart; of the thousands of mixtures
/// on edges, each rare, most move by a few steps of 256. Ties go to the more frequent, then the darker.
pub(super) fn indexed(pixels: &[u8], most: u8) -> Indexed {
    let mut counts: BTreeMap<[u8; 3], u64> = BTreeMap::new();
    for pixel in pixels.chunks_exact(3) {
        *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
    }
    let mut colours: Vec<([u8; 3], u64)> = counts.into_iter().collect();
    // Stable, so that equal counts keep the colours' order.
    colours.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
    let mut palette: Vec<[u8; 3]> = Vec::new();
    // For each colour the square of the distance to the nearest chosen, and its place.
    let mut nearest = vec![(u64::MAX, 0_u8); colours.len()];
    while palette.len() < colours.len().min(usize::from(most) + 1) {
        let missed = |i: usize| colours[i].1.saturating_mul(nearest[i].0);
        let next = (0..colours.len()).fold(0, |best, i| if missed(i) > missed(best) { i } else { best });
        let chosen = colours[next].0;
        for (near, (colour, _)) in nearest.iter_mut().zip(&colours) {
            let distance = square(*colour, chosen);
            if distance < near.0 {
                *near = (distance, palette.len() as u8);
            }
        }
        palette.push(chosen);
    }
    let places: BTreeMap<[u8; 3], u8> =
        colours.iter().zip(&nearest).map(|(&(colour, _), near)| (colour, near.1)).collect();
    let place = |pixel: &[u8]| places.get(&[pixel[0], pixel[1], pixel[2]]).copied().unwrap_or(0);
    Indexed { palette: palette.concat(), pixels: pixels.chunks_exact(3).map(place).collect() }
}

/// The square of two colours' distance.
fn square(a: [u8; 3], b: [u8; 3]) -> u64 {
    (0..3).map(|i| u64::from(a[i].abs_diff(b[i])) * u64::from(a[i].abs_diff(b[i]))).sum()
}

#[cfg(test)]
mod tests {
    use super::indexed;

    #[test]
    fn few_colours_stay_as_they_are() {
        let pixels = [9, 9, 9, 1, 2, 3, 9, 9, 9, 4, 5, 6];
        let found = indexed(&pixels, 127);
        let back: Vec<u8> =
            found.pixels.iter().flat_map(|&i| found.palette[3 * usize::from(i)..][..3].to_vec()).collect();
        assert_eq!(back, pixels);
        assert_eq!(found.palette[..3], [9, 9, 9]); // the most frequent first
    }

    #[test]
    fn rare_colours_go_to_the_nearest() {
        // 128 colours twice, and one of its own beside the second.
        let twice: Vec<u8> = (0..128).flat_map(|i| [2 * i, 0, 200].repeat(2)).collect();
        let mut pixels = twice.clone();
        pixels.extend([2, 1, 200]);
        let found = indexed(&pixels, 127);
        assert_eq!((found.palette.len(), found.pixels.len()), (3 * 128, 257));
        assert_eq!(found.palette[3 * usize::from(found.pixels[256])..][..3], [2, 0, 200]);
        assert_eq!(found.pixels[..256], indexed(&twice, 127).pixels);
    }
}
