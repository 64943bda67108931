//! Pictures by supersampling.

use super::rows::rows;
use super::view::{REACH, View, near, sky};
use super::{Image, PictureError, SceneError};
use crate::filter::Wrap;

/// Places a pixel's side has for samples: the strata's jitter is a whole number of these.
const PLACES: usize = 1024;
/// Strata along a pixel's side, at least and at most.
const STRATA: (usize, usize) = (16, 128);
/// Strata a texel, up to the most.
const STRATA_PER_TEXEL: f64 = 4.0;
/// Pixels on either side that one sample counts in, and itself.
const SPAN: usize = 2 * REACH + 1;

/// A reference picture with the pixels it holds for.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// The picture.
    pub image: Image,
    /// Its own error: the root mean square over the counted pixels of half the difference of two half sets
    /// of the samples. An estimate, and too large rather than too small, as a half set's strata are coarser.
    pub sampling_error: f64,
    counted: Vec<bool>,
}

impl Reference {
    /// The error of a picture of the same view.
    ///
    /// # Errors
    /// As [`PictureError::between`].
    pub fn error(&self, picture: &Image) -> Result<PictureError, SceneError> {
        PictureError::between(&self.image, picture, &self.counted)
    }
}

/// The two references of a view, from the same samples.
///
/// The mapping is sampled in strata with a fixed jitter, 16 to 128 along each side of a pixel by the length of
/// the derivative vector there (four a texel where that suffices). The texture between texel centres is
/// bilinear: what every method shows of it magnified, so that methods differ by their filter alone.
#[derive(Clone, Debug, PartialEq)]
pub struct References {
    /// The mean over the pixel's square.
    pub area: Reference,
    /// Weighted by exp(-2 r²), r in pixels from the middle: a Gaussian with σ = ½ pixel, cut off the square
    /// of 5 × 5 pixels (below 4e-6 of its peak). Renderers cut the same weight at r = 1 (M. Pharr, W. Jakob,
    /// G. Humphreys, "Physically Based Rendering", 3rd ed., 10.4.5, α = 2, and subtract what it is there).
    pub gaussian: Reference,
}

/// Sums of weight × value by channel, the last of them of the weight alone, for the two half sets. N is one
/// more than the channels: known when compiled, the loops over it unroll.
type Sums<const N: usize> = [[f64; N]; 2];

fn add<const N: usize>(to: &mut Sums<N>, from: &Sums<N>) {
    for (to, from) in to.iter_mut().flatten().zip(from.iter().flatten()) {
        *to += from;
    }
}

/// What one pixel's samples add to a pixel's own mean and to those of the 5 × 5 pixels around.
struct Cell<const N: usize> {
    area: Sums<N>,
    gaussian: [[[[f64; N]; SPAN]; SPAN]; 2],
}

/// A row of them, added up across: by the pixel of the picture, and by rows away.
struct Row<const N: usize> {
    area: Vec<Sums<N>>,
    gaussian: Vec<[Sums<N>; SPAN]>,
}

impl References {
    /// Samples the view, rows on so many threads.
    pub fn new(view: &View, threads: usize) -> References {
        match view.texture().channels() {
            1 => References::of::<2>(view, threads),
            2 => References::of::<3>(view, threads),
            3 => References::of::<4>(view, threads),
            _ => References::of::<5>(view, threads),
        }
    }

    fn of<const N: usize>(view: &View, threads: usize) -> References {
        let (width, height) = (view.width(), view.height());
        let bell = bell();
        // Rows and columns of cells begin `REACH` before the picture's.
        let sampled = rows(height + 2 * REACH, threads, |row| sample_row::<N>(view, row, &bell));
        let mut area = Vec::with_capacity(width * height);
        let mut gaussian = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                area.push(sampled[y + REACH].area[x]);
                let mut sums = [[0.0; N]; 2];
                for (away, row) in sampled[y..y + SPAN].iter().enumerate() {
                    add(&mut sums, &row.gaussian[x][away]);
                }
                gaussian.push(sums);
            }
        }
        References { area: finish(view, &area), gaussian: finish(view, &gaussian) }
    }
}

/// exp(-2 r²) along one axis: by the place in the pixel, and by the pixel that looks, from 2 to the right of
/// it to 2 to the left.
fn bell() -> Vec<[f64; SPAN]> {
    let place = |i: usize| (i as f64 + 0.5) / PLACES as f64;
    let weight = |i: usize, pixel: usize| {
        let off = place(i) - 0.5 + pixel as f64 - REACH as f64;
        libm::exp(-2.0 * off * off)
    };
    (0..PLACES).map(|i| std::array::from_fn(|pixel| weight(i, pixel))).collect()
}

fn sample_row<const N: usize>(view: &View, row: usize, bell: &[[f64; SPAN]]) -> Row<N> {
    let (width, height) = (view.width(), view.height());
    let mut line = Row { area: vec![[[0.0; N]; 2]; width], gaussian: vec![[[[0.0; N]; 2]; SPAN]; width] };
    let on_plane = |x: usize, y: usize| view.on_plane()[y * width + x];
    for column in 0..width + 2 * REACH {
        // The pixels of the picture that these samples count in.
        let (left, right) = (column.saturating_sub(2 * REACH), column.min(width - 1));
        let (top, bottom) = (row.saturating_sub(2 * REACH), row.min(height - 1));
        if !(top..=bottom).any(|y| (left..=right).any(|x| on_plane(x, y))) {
            continue;
        }
        let cell = sample_cell::<N>(view, column, row, bell);
        if (REACH..width + REACH).contains(&column) {
            line.area[column - REACH] = cell.area;
        }
        for x in left..=right {
            for (away, sums) in line.gaussian[x].iter_mut().enumerate() {
                // The sample lies `column - REACH - x` pixels right of x.
                add(sums, &[0, 1].map(|half: usize| cell.gaussian[half][away][column - x]));
            }
        }
    }
    line
}

/// Samples of the pixel `REACH` left of and above (column, row).
fn sample_cell<const N: usize>(view: &View, column: usize, row: usize, bell: &[[f64; SPAN]]) -> Cell<N> {
    let (x, y) = (column as f64 - REACH as f64, row as f64 - REACH as f64);
    let mapping = view.mapping();
    let (across, down) = mapping.jacobian(x + 0.5, y + 0.5).lengths();
    let (columns, rows) = (strata(across), strata(down));
    let (wide, tall) = (PLACES / columns, PLACES / rows);
    let mut cell = Cell { area: [[0.0; N]; 2], gaussian: [[[[0.0; N]; SPAN]; SPAN]; 2] };
    let mut state = mix(((column as u64) << 32) | row as u64);
    for b in 0..rows {
        for a in 0..columns {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let bits = mix(state) as usize;
            let (i, j) = (a * wide + (bits & (wide - 1)), b * tall + ((bits >> 16) & (tall - 1)));
            let place = |i: usize| (i as f64 + 0.5) / PLACES as f64;
            let (s, t) = mapping.at(x + place(i), y + place(j));
            let value: [f64; N] = bilinear(view, s, t);
            // Neighbouring strata lie in different halves.
            let half = (a + b) & 1;
            for (sum, value) in cell.area[half].iter_mut().zip(value) {
                *sum += value;
            }
            for (line, down) in cell.gaussian[half].iter_mut().zip(&bell[j]) {
                for (sums, across) in line.iter_mut().zip(&bell[i]) {
                    let weight = across * down;
                    for (sum, value) in sums.iter_mut().zip(value) {
                        *sum += weight * value;
                    }
                }
            }
        }
    }
    // Pixels count alike, however many samples they have.
    let share = 1.0 / (rows * columns) as f64;
    for sum in cell.gaussian.iter_mut().flatten().flatten().flatten() {
        *sum *= share;
    }
    cell
}

/// A power of two by the length of a derivative vector.
fn strata(length: f64) -> usize {
    let mut count = STRATA.0;
    while count < STRATA.1 && (count as f64) < STRATA_PER_TEXEL * length {
        count *= 2;
    }
    count
}

/// The finaliser of splitmix64.
fn mix(bits: u64) -> u64 {
    let z = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The texture at (s, t), bilinear between texel centres, and a 1 behind its channels.
fn bilinear<const N: usize>(view: &View, s: f64, t: f64) -> [f64; N] {
    let texture = view.texture();
    let (width, height) = (texture.width(), texture.height());
    let split = |position: f64, size: usize| -> (usize, usize, f64) {
        let at = near(view.wrap(), position, size as f64) - 0.5;
        let whole = at.floor();
        let index = |i: i64| Wrap::index(view.wrap(), i, size);
        (index(whole as i64), index(whole as i64 + 1), at - whole)
    };
    let ((x0, x1, fx), (y0, y1, fy)) = (split(s, width), split(t, height));
    let texels = texture.texels();
    let mut value = [1.0; N];
    for (channel, value) in value.iter_mut().enumerate().take(N - 1) {
        let at = |x: usize, y: usize| f64::from(texels[(y * width + x) * (N - 1) + channel]);
        let mix = |x: usize| at(x, y0) + fy * (at(x, y1) - at(x, y0));
        let (left, right) = (mix(x0), mix(x1));
        *value = left + fx * (right - left);
    }
    value
}

/// Means of both halves together, and their difference.
fn finish<const N: usize>(view: &View, sums: &[Sums<N>]) -> Reference {
    let channels = N - 1;
    let mut values = Vec::with_capacity(channels * sums.len());
    let (mut squares, mut count) = (0.0, 0usize);
    for (sums, &on) in sums.iter().zip(view.on_plane()) {
        if !on {
            values.extend_from_slice(&sky(channels)[..channels]);
            continue;
        }
        let [first, second] = sums;
        for c in 0..channels {
            values.push(((first[c] + second[c]) / (first[channels] + second[channels])) as f32);
            let off = 0.5 * (first[c] / first[channels] - second[c] / second[channels]);
            squares += off * off;
            count += 1;
        }
    }
    let image = Image::new(view.width(), view.height(), channels, values)
        .expect("as many values as the view has pixels and channels");
    let sampling_error = (squares / count.max(1) as f64).sqrt();
    Reference { image, sampling_error, counted: view.on_plane().to_vec() }
}
