//! The weighted sums over strips, in lanes.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

use super::gathered::{Gathered, LANES, Lanes};
use super::placed::Placed;
use super::plan::{Plan, Read};
use super::walk::{ROWS, Strip};
use super::weight::LaneWeight;
use super::{Pyramid, Texture, Wrap};
use crate::slice::Job;

const MOST: usize = ROWS as usize;

/// Adds the texels of strips, in levels of C channels, to what their ellipses have gathered.
///
/// A texel counts if Q as computed here is ≤ 1; the strips are wide enough for that alone to decide. u and v
/// are k + ½ - fraction with k a whole number from the middle's texel, so that a mirrored texture, position
/// and ellipse give the same Q to the last bit, and a texel on the rim counts in both or in neither.
///
/// The shape is what the compiler reliably turns into vectors: a loop over rows, as many as there are, whose
/// body is the same step for each lane; weights first, then values, so that no loop has two kinds of sums.
pub(super) struct Scan<'s, W, const C: usize> {
    pub pyramid: &'s Pyramid,
    pub wrap: Wrap,
    pub plans: &'s [Plan],
    /// Those of one strip too, or only `strips`.
    pub singles: bool,
    pub strips: &'s [Strip],
    pub gathered: &'s mut [Gathered],
    pub weight: W,
}

impl<W: LaneWeight, const C: usize> Job for Scan<'_, W, C> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Scan { pyramid, wrap, plans, singles, strips, gathered, weight } = self;
        let mut rows = Rows { shift: [0.0; MOST], height: [0.0; MOST], weights: [[0.0; LANES]; MOST] };
        if singles {
            for (plan, into) in plans.iter().zip(&mut *gathered) {
                if let Read::Strip(at) = plan.read {
                    let Placed { first: [left, top], last: [_, bottom], .. } = plan.placed;
                    let mut lanes = Gathered::NONE;
                    let n = rows.measure(&plan.placed, top, bottom - top + 1);
                    rows.weigh(n, weight, &plan.placed, left, &mut lanes);
                    rows.add::<C>(n, pyramid.level(plan.level), at, &mut lanes);
                    (into.weight, into.texels, into.sum) = (lanes.weight, lanes.texels, lanes.sum);
                    into.values[..C].copy_from_slice(&lanes.values[..C]);
                }
            }
        }
        for strip in strips {
            let Plan { placed, level, .. } = &plans[strip.plan];
            let (level, into) = (pyramid.level(*level), &mut gathered[strip.plan]);
            let n = rows.measure(placed, strip.first[1], strip.rows);
            rows.weigh(n, weight, placed, strip.first[0], into);
            match strip.at {
                Some(at) => rows.add::<C>(n, level, at, into),
                None => {
                    let first = [0, 1].map(|i| placed.texel[i] + i64::from(strip.first[i]));
                    rows.add_wrapped::<C>(n, level, wrap, first, into);
                }
            }
            if strip.full {
                into.flush::<C>();
            }
        }
    }
}

/// A strip's rows: Q = height + curvature (u - shift)².
struct Rows {
    /// v b/c.
    shift: [f32; MOST],
    /// v²/c.
    height: [f32; MOST],
    weights: [Lanes; MOST],
}

impl Rows {
    /// Shift and height of so many rows from `top` on; gives their number.
    #[inline(always)]
    fn measure(&mut self, placed: &Placed, top: i32, rows: i32) -> usize {
        let Placed { slope, inverse, fraction: [_, fraction], .. } = *placed;
        let n = (rows as usize).min(MOST);
        let mut centre = [0.0; LANES];
        for i in 0..LANES {
            centre[i] = top as f32 + (i as f32 + 0.5);
        }
        let eights = self.shift.chunks_exact_mut(LANES).zip(self.height.chunks_exact_mut(LANES));
        for (shift, height) in eights.take(n.div_ceil(LANES)) {
            for i in 0..LANES {
                let v = centre[i] - fraction;
                shift[i] = v * slope;
                height[i] = v * (v * inverse);
                // Exact, and carried from turn to turn: so the eight become the vector, not the turns.
                centre[i] += LANES as f32;
            }
        }
        n
    }

    /// The weights of the first n rows from column `left` on.
    #[inline(always)]
    fn weigh<W: LaneWeight>(&mut self, n: usize, weight: W, placed: &Placed, left: i32, into: &mut Gathered) {
        let Placed { curvature, fraction: [fraction, _], .. } = *placed;
        let mut us = [0.0; LANES];
        for i in 0..LANES {
            us[i] = (left as f32 + (i as f32 + 0.5)) - fraction;
        }
        let (mut sum, mut count) = (into.weight, into.texels);
        let rows = self.shift[..n].iter().zip(&self.height[..n]);
        for (weights, (&shift, &height)) in self.weights[..n].iter_mut().zip(rows) {
            for i in 0..LANES {
                let e = us[i] - shift;
                let q = height + (e * e) * curvature;
                // A mask where a branch would be natural: branches do not become vectors.
                let mask = if q <= 1.0 { u32::MAX } else { 0 };
                weights[i] = f32::from_bits(weight.at(q).to_bits() & mask);
                count[i] = count[i].wrapping_sub(mask);
                sum[i] += weights[i];
            }
        }
        (into.weight, into.texels) = (sum, count);
    }

    /// Adds the first n rows' weights times the texels from `at` on. Beyond the ellipse those may be the next
    /// row's, or the zeros behind the last.
    #[inline(always)]
    fn add<const C: usize>(&self, n: usize, level: &Texture, at: usize, into: &mut Gathered) {
        let mut values = [[0.0; LANES]; C];
        values.copy_from_slice(&into.values[..C]);
        let texels = level.run();
        let (mut at, step) = (at * C, level.width() * C);
        for weights in &self.weights[..n] {
            let row = &texels[at..at + LANES * C];
            for k in 0..C {
                for i in 0..LANES {
                    values[k][i] += weights[(k * LANES + i) / C] * row[k * LANES + i];
                }
            }
            at += step;
        }
        into.values[..C].copy_from_slice(&values);
    }

    /// The same of a strip that may lie across an edge, or beyond.
    #[inline(always)]
    fn add_wrapped<const C: usize>(
        &self,
        n: usize,
        level: &Texture,
        wrap: Wrap,
        [x, y]: [i64; 2],
        into: &mut Gathered,
    ) {
        let mut columns = [0; LANES];
        for i in 0..LANES {
            columns[i] = wrap.index(x + i as i64, level.width());
        }
        let texels = level.run();
        for (r, weights) in self.weights[..n].iter().enumerate() {
            let row = wrap.index(y + r as i64, level.height()) * level.width();
            for i in 0..LANES {
                for c in 0..C {
                    let k = i * C + c;
                    into.values[k / LANES][k % LANES] += weights[i] * texels[(row + columns[i]) * C + c];
                }
            }
        }
    }
}
