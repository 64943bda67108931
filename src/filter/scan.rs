//! The weighted sum over the texels of an ellipse, in lanes.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

use super::placed::Placed;
use super::weight::LaneWeight;
use super::{Texture, Wrap};
use crate::kernel::pixel::Footprint;

/// Columns, and rows, looked at together: a tile. One is enough for most round ellipses, and a loop that
/// always runs as often is a branch that is never mispredicted.
const LANES: usize = 8;
const PAIR: usize = 2 * LANES;
/// Tiles that are added up in single precision before the sum goes on in double precision.
const PENDING: u32 = 8;

type Lanes = [f32; LANES];
/// Two rows of a tile.
type Pair = [f32; PAIR];
type Tile = [Pair; LANES / 2];

/// Sums over the texels with Q ≤ 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sum {
    /// Of the weights.
    pub weight: f64,
    /// Of weight × value; absent channels 0.
    pub values: [f64; 4],
    /// Of texels.
    pub texels: u64,
}

impl Sum {
    /// The weighted mean, or `None` without weight.
    #[inline(always)]
    pub fn mean(&self) -> Option<[f32; 4]> {
        (self.weight > 0.0).then(|| self.values.map(|value| (value / self.weight) as f32))
    }
}

/// One ellipse over C channels of a level.
///
/// With M = [[a, b], [b, c]] and d = det M, Q = v²/c + (c/d) (u - v b/c)²: no root and no division a row. The
/// ellipse is cut into strips of [`LANES`] columns. A texel counts if the Q computed so is ≤ 1, and the strips' rows are chosen
/// wide enough for that alone to decide. u and v are k + ½ - fraction with k a whole number from the middle's
/// texel, so that a mirrored texture, position and ellipse give the same Q to the last bit, and a texel on the
/// rim counts in both or in neither.
///
/// A tile's weights are computed first and then meet the channels one after the other: loops
/// that end in a store or in one sum are those the compiler reliably turns into vectors.
pub(super) struct Scan<'a, W, const C: usize> {
    pub level: &'a Texture,
    pub wrap: Wrap,
    pub placed: Placed,
    pub weight: W,
}

/// What a row needs of the ellipse.
struct Rows {
    /// c/d.
    curvature: f32,
    /// b/c.
    slope: f32,
    /// 1/c.
    inverse: f32,
    /// The middle's place in its row of texels.
    fraction: f32,
}

impl Rows {
    /// Weights of the rows from k on along a strip with offsets `us`, two rows at a time.
    #[inline(always)]
    fn weigh<W: LaneWeight>(&self, weight: W, us: &Pair, k: i32, tile: &mut Tile, texels: &mut [u32; PAIR]) {
        let (us, mut count) = (*us, *texels);
        let mut centre = [k as f32 + 0.5; PAIR];
        for i in LANES..PAIR {
            centre[i] += 1.0;
        }
        for pair in tile {
            for i in 0..PAIR {
                let v = centre[i] - self.fraction;
                let e = us[i] - v * self.slope;
                let q = v * (v * self.inverse) + (e * e) * self.curvature;
                // A mask where a branch would be natural: branches do not become vectors.
                let mask = if q <= 1.0 { u32::MAX } else { 0 };
                pair[i] = f32::from_bits(weight.at(q).to_bits() & mask);
                count[i] = count[i].wrapping_sub(mask);
                centre[i] += 2.0;
            }
        }
        *texels = count;
    }
}

struct Totals<const C: usize> {
    weight: Pair,
    values: [Lanes; C],
    texels: [u32; PAIR],
    /// Tiles in them.
    pending: u32,
}

impl<const C: usize> Totals<C> {
    #[inline(always)]
    fn new() -> Self {
        Totals { weight: [0.0; PAIR], values: [[0.0; LANES]; C], texels: [0; PAIR], pending: 0 }
    }

    #[inline(always)]
    fn add_weights(&mut self, tile: &Tile) {
        let mut sum = self.weight;
        for pair in tile {
            for i in 0..PAIR {
                sum[i] += pair[i];
            }
        }
        self.weight = sum;
        self.pending += 1;
    }

    #[inline(always)]
    fn add_row(&mut self, c: usize, weights: &[f32], values: &[f32]) {
        for i in 0..LANES {
            self.values[c][i] += weights[i] * values[i];
        }
    }

    /// Moves everything into `sum`. A call that stays one: lanes that pass through memory as a whole are
    /// kept as a whole in the loops before, while a sum over lanes in sight of them splits them into pairs.
    #[inline(never)]
    fn flush(&mut self, sum: &mut Sum) {
        let weight: Lanes = std::array::from_fn(|i| self.weight[i] + self.weight[i + LANES]);
        sum.weight += total(&weight);
        for (sum, lanes) in sum.values.iter_mut().zip(&self.values) {
            *sum += total(lanes);
        }
        sum.texels += u64::from(self.texels.iter().sum::<u32>());
        *self = Totals::new();
    }
}

#[inline(always)]
fn total(lanes: &Lanes) -> f64 {
    let four: [f32; 4] = std::array::from_fn(|i| lanes[i] + lanes[i + 4]);
    f64::from((four[0] + four[2]) + (four[1] + four[3]))
}

impl<W: LaneWeight, const C: usize> Scan<'_, W, C> {
    /// The sums.
    #[inline(always)]
    pub fn sum(self) -> Sum {
        let Placed { texel, fraction, footprint } = self.placed;
        let inverse = 1.0 / footprint.vv;
        // Of an ellipse thinner than 10⁻³⁸: still 0 times it is 0.
        let single = |x: f64| x.min(f64::from(f32::MAX)) as f32;
        let rows = Rows {
            curvature: single(footprint.vv / footprint.determinant),
            slope: (footprint.uv * inverse) as f32,
            inverse: single(inverse),
            fraction: fraction[1],
        };
        let (first, last) = texels(footprint.uu, fraction[0]);
        let (top, bottom) = texels(footprint.vv, fraction[1]);
        let (w, h) = (self.level.width(), self.level.height());
        let (x, y) = (texel[0] + i64::from(first), texel[1] + i64::from(top));
        // Tiles may reach over the ellipse, as far as weights of 0 go.
        let reach = LANES as i64 - 1;
        let inside = x >= 0
            && texel[0] + i64::from(last) < w as i64
            && y >= 0
            && texel[1] + i64::from(bottom) + reach < h as i64;
        // Of one length in sight of the compiler, which then checks a row's bounds once for all channels.
        let length = self.level.run(0).len();
        let planes: [&[f32]; C] = std::array::from_fn(|c| &self.level.run(c)[..length]);
        let mut tile = [[0.0; PAIR]; LANES / 2];
        let (mut sum, mut totals) = (Sum::default(), Totals::<C>::new());
        let mut ends = [[top; STRIPS], [bottom; STRIPS]];
        let mut start = first;
        let mut strip = 0;
        while start <= last {
            // Four tiles are read sooner than the rows that they hold are found.
            if (last - first).max(bottom - top) >= PAIR as i32 && strip % STRIPS == 0 {
                ends = rows_of_strips(&footprint, start, fraction);
            }
            // A strip's ends are rounded outward by more than the whole's, which decide what is inside.
            let (mut from, to) = (ends[0][strip % STRIPS].max(top), ends[1][strip % STRIPS].min(bottom));
            strip += 1;
            let mut us = [0.0; PAIR];
            for i in 0..PAIR {
                us[i] = (start as f32 + ((i % LANES) as f32 + 0.5)) - fraction[0];
            }
            while from <= to {
                if totals.pending == PENDING {
                    totals.flush(&mut sum);
                }
                rows.weigh(self.weight, &us, from, &mut tile, &mut totals.texels);
                totals.add_weights(&tile);
                if inside {
                    // Lanes beyond the ellipse may read the next row, or the zeros behind the last.
                    let at =
                        (texel[1] + i64::from(from)) as usize * w + (texel[0] + i64::from(start)) as usize;
                    for c in 0..C {
                        let mut sum = totals.values[c];
                        for r in 0..LANES {
                            let start = at + r * w;
                            let values = &planes[c][start..start + LANES];
                            for i in 0..LANES {
                                sum[i] += tile[r / 2][r % 2 * LANES + i] * values[i];
                            }
                        }
                        totals.values[c] = sum;
                    }
                } else {
                    let at = [texel[0] + i64::from(start), texel[1] + i64::from(from)];
                    self.wrapped(&tile, &mut totals, at);
                }
                from += LANES as i32;
            }
            start += LANES as i32;
        }
        totals.flush(&mut sum);
        sum
    }

    /// A tile that lies across an edge, or beyond.
    #[inline(always)]
    fn wrapped(&self, tile: &Tile, totals: &mut Totals<C>, at: [i64; 2]) {
        let (w, h) = (self.level.width(), self.level.height());
        let mut columns = [0; LANES];
        let mut rows = [0; LANES];
        for i in 0..LANES {
            columns[i] = self.wrap.index(at[0] + i as i64, w);
            rows[i] = self.wrap.index(at[1] + i as i64, h) * w;
        }
        for c in 0..C {
            let plane = self.level.run(c);
            for r in 0..LANES {
                let mut values = [0.0; LANES];
                for i in 0..LANES {
                    values[i] = plane[rows[r] + columns[i]];
                }
                totals.add_row(c, &tile[r / 2][r % 2 * LANES..][..LANES], &values);
            }
        }
    }
}

/// First and last k that hold every k with (k + ½ - fraction)² ≤ square.
///
/// Of small ellipses one or two tiles about the texel's corner that is nearer to the middle: with the root's
/// latency out of the way, the next lookup starts before this one is done.
#[inline(always)]
fn texels(square: f64, fraction: f32) -> (i32, i32) {
    let nearer = i32::from(fraction >= 0.5);
    let tiles = |n: i32| (nearer - n, nearer + n - 1);
    // The first centre beyond is more than 4 or 8 away.
    if square < 15.99 {
        tiles(LANES as i32 / 2)
    } else if square < 63.9 {
        tiles(LANES as i32)
    } else {
        far_texels(square as f32, fraction)
    }
}

#[cold]
fn far_texels(square: f32, fraction: f32) -> (i32, i32) {
    let half = square.sqrt();
    // Offsets are rounded to 2⁻²² of the end, Q's terms to as much of theirs.
    let reach = half + (1e-5 + 1e-5 * half);
    let middle = fraction - 0.5;
    (-down(reach - middle), down(reach + middle))
}

/// The whole number below x, or x itself or one less where it is one; |x| < 2²².
#[inline(always)]
fn down(x: f32) -> i32 {
    /// Adding it leaves the nearest whole number in the last bits.
    const ROUND: f32 = 12_582_912.0;
    ((x - 0.5) + ROUND).to_bits().wrapping_sub(ROUND.to_bits()) as i32
}

/// Strips whose rows are found together.
const STRIPS: usize = 4;

/// First and last row of each strip from the column `start` on.
///
/// The boundary is v = u b/a ± √(d/a) √(1 - u²/a), highest and lowest at u = ±b/√c.
#[inline(never)]
fn rows_of_strips(f: &Footprint<f64>, start: i32, fraction: [f32; 2]) -> [[i32; STRIPS]; 2] {
    let (width, height) = ((f.uu as f32).sqrt(), (f.vv as f32).sqrt());
    let chord = ((f.determinant / f.uu) as f32).sqrt();
    let (lean, narrow) = ((f.uv / f.uu) as f32, 1.0 / width);
    let peak = f.uv as f32 / height;
    // Of the ends as above; and √(1 - x²) near x = 1 by what x = u/width is rounded by there.
    let slack = 1e-5 + 1e-5 * height + 1e-3 * chord;
    let middle = fraction[1] - 0.5;
    let mut ends = [[0; STRIPS]; 2];
    for i in 0..STRIPS {
        let left = (start as f32 + ((i * LANES) as f32 + 0.5)) - fraction[0];
        let right = (left + (LANES - 1) as f32).max(-width).min(width);
        let left = left.max(-width).min(width);
        let half = |u: f32| chord * ((1.0 - u * narrow) * (1.0 + u * narrow)).max(0.0).sqrt();
        let (m0, h0, m1, h1) = (left * lean, half(left), right * lean, half(right));
        let high = (m0 + h0).max(m1 + h1);
        let low = (m0 - h0).min(m1 - h1);
        let high = if left <= peak && peak <= right { height } else { high };
        let low = if left <= -peak && -peak <= right { -height } else { low };
        ends[0][i] = -down(slack - low - middle);
        ends[1][i] = down(slack + high + middle);
    }
    ends
}
