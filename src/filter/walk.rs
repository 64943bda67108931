//! The strips of ellipses that are wider than one.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

use super::Pyramid;
use super::gathered::LANES;
use super::placed::{Placed, down};
use super::plan::{Plan, Read};
use crate::kernel::pixel::Footprint;

/// Most rows of a strip.
pub(super) const ROWS: i32 = 16;
/// Rows of an ellipse that are added up in single precision before its sum goes on in double precision.
const PENDING: i32 = 64;
/// Columns or rows from which on each strip's own rows are looked for: the rows of fewer are read sooner.
const MANY: i32 = 18;

/// Some rows of eight columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    /// Whose it is.
    pub plan: usize,
    /// First column and row, counted from the texel that holds the ellipse's middle.
    pub first: [i32; 2],
    /// How many rows, up to [`ROWS`].
    pub rows: i32,
    /// The first texel's place in the level, where all of the ellipse is in the level.
    pub at: Option<usize>,
    /// Whether as many rows wait in the ellipse's lanes as may.
    pub full: bool,
}

impl Strip {
    /// To be written over.
    pub const NONE: Strip = Strip { plan: 0, first: [0; 2], rows: 0, at: None, full: false };
}

/// A walk over the ellipses of several plans, strip by strip from left to right, each from the top.
pub(super) struct Walk<'s> {
    pyramid: &'s Pyramid,
    plans: &'s [Plan],
    plan: usize,
    /// -1 before the first.
    strip: i32,
    /// The next row in the strip, and its last.
    rows: [i32; 2],
    /// First and last rows of this strip and its neighbours.
    ends: [[i32; STRIPS]; 2],
    inside: bool,
    /// Rows that may still wait in the ellipse's lanes.
    room: i32,
}

impl<'s> Walk<'s> {
    pub fn new(pyramid: &'s Pyramid, plans: &'s [Plan]) -> Self {
        let ends = [[0; STRIPS]; 2];
        Walk { pyramid, plans, plan: 0, strip: -1, rows: [0, -1], ends, inside: false, room: PENDING }
    }

    /// The next strips: as many as there is room for, none beyond one that is full. 0 at the end.
    pub fn fill(&mut self, strips: &mut [Strip]) -> usize {
        let mut found = 0;
        while let Some(plan) = self.plans.get(self.plan)
            && found < strips.len()
        {
            let Placed { texel, first, last, .. } = plan.placed;
            if plan.read != Read::Strips {
                self.plan += 1;
                continue;
            }
            if self.rows[0] > self.rows[1] {
                self.strip += 1;
                if first[0] + self.strip * LANES as i32 > last[0] {
                    (self.plan, self.strip, self.room) = (self.plan + 1, -1, PENDING);
                } else {
                    self.enter(plan);
                }
                continue;
            }
            let first = [first[0] + self.strip * LANES as i32, self.rows[0]];
            let rows = (self.rows[1] - self.rows[0] + 1).min(self.room).min(ROWS);
            let at = self.inside.then(|| {
                let [x, y] = [0, 1].map(|i| (texel[i] + i64::from(first[i])) as usize);
                y * self.pyramid.level(plan.level).width() + x
            });
            (self.rows[0], self.room) = (self.rows[0] + rows, self.room - rows);
            let full = self.room == 0;
            strips[found] = Strip { plan: self.plan, first, rows, at, full };
            found += 1;
            if full {
                self.room = PENDING;
                break;
            }
        }
        found
    }

    /// Finds the rows of a strip just come to.
    fn enter(&mut self, plan: &Plan) {
        let Placed { first: [left, top], last: [right, bottom], fraction, footprint, .. } = plan.placed;
        self.rows = [top, bottom];
        if self.strip == 0 {
            self.inside = plan.placed.is_inside(self.pyramid.level(plan.level));
        }
        if (right - left).max(bottom - top) >= MANY {
            let k = self.strip as usize % STRIPS;
            if k == 0 {
                self.ends = rows_of_strips(footprint, left + self.strip * LANES as i32, fraction);
            }
            // A strip's ends are rounded outward by more than the whole's, which decide what is inside.
            self.rows = [self.ends[0][k].max(top), self.ends[1][k].min(bottom)];
        }
    }
}

/// Strips whose rows are found together.
const STRIPS: usize = 4;

/// First and last row of each strip from the column `start` on.
///
/// The boundary is v = u b/a ± √(d/a) √(1 - u²/a), highest and lowest at u = ±b/√c.
#[inline(never)]
fn rows_of_strips(f: Footprint<f64>, start: i32, fraction: [f32; 2]) -> [[i32; STRIPS]; 2] {
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
