//! Elliptical lookups: planned, read and blended several at once.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

use super::gathered::Gathered;
use super::plan::{Plan, Planning, Read};
use super::rim::careful;
use super::sampler::Asked;
use super::scan::Scan;
use super::shape::Shape;
use super::walk::{Strip, Walk};
use super::weight::with_lane_weight;
use super::{Lookup, Pixel, Rim, Sampler};
use crate::slice::Job;

/// Room for plans, what they gather, and strips: as much as there is work at once. That of several lookups
/// side by side is done sooner, as the next need not wait for the last.
pub(super) struct Desk<const PLANS: usize> {
    plans: [Plan; PLANS],
    gathered: [Gathered; PLANS],
    strips: [Strip; PLANS],
}

impl<const PLANS: usize> Desk<PLANS> {
    pub fn new() -> Self {
        Desk { plans: [Plan::NONE; PLANS], gathered: [Gathered::NONE; PLANS], strips: [Strip::NONE; PLANS] }
    }
}

impl Sampler<'_> {
    /// As many lookups as are asked for.
    pub(super) fn ellipses<const PLANS: usize>(
        &self,
        asked: Asked,
        out: &mut [Lookup],
        desk: &mut Desk<PLANS>,
    ) {
        // One level each, or two.
        let together = if asked.fixed.is_some() { PLANS } else { PLANS / 2 };
        let mut start = 0;
        while start < asked.pixels.len() {
            let end = (start + together).min(asked.pixels.len());
            let part = Asked { pixels: &asked.pixels[start..end], ..asked };
            self.part(part, &mut out[start..end], &mut desk.plans, &mut desk.gathered, &mut desk.strips);
            start = end;
        }
    }

    /// As many as there is room for.
    fn part(
        &self,
        asked: Asked,
        out: &mut [Lookup],
        plans: &mut [Plan],
        gathered: &mut [Gathered],
        strips: &mut [Strip],
    ) {
        let n = self.unit.run(Planning { sampler: self, asked, out, plans, gathered });
        let (plans, gathered) = (&plans[..n], &mut gathered[..n]);
        let mut walk = Walk::new(self.pyramid, plans);
        let mut singles = true;
        loop {
            let n = walk.fill(strips);
            if n == 0 && !singles {
                break;
            }
            if asked.filter.rim != Rim::None || !self.scan(asked, plans, singles, &strips[..n], gathered) {
                self.careful(asked, plans, gathered);
                break;
            }
            singles = false;
        }
        self.unit.run(Finish { sampler: self, pixels: asked.pixels, plans, gathered, out });
    }

    /// Reads strips in lanes; false if the weight has no such form.
    fn scan(
        &self,
        asked: Asked,
        plans: &[Plan],
        singles: bool,
        strips: &[Strip],
        gathered: &mut [Gathered],
    ) -> bool {
        let Sampler { pyramid, wrap, unit, .. } = *self;
        with_lane_weight!(asked.filter.weight, self.constants, weight => match self.channels() {
            1 => unit.run(Scan::<_, 1> { pyramid, wrap, plans, singles, strips, gathered, weight }),
            2 => unit.run(Scan::<_, 2> { pyramid, wrap, plans, singles, strips, gathered, weight }),
            3 => unit.run(Scan::<_, 3> { pyramid, wrap, plans, singles, strips, gathered, weight }),
            _ => unit.run(Scan::<_, 4> { pyramid, wrap, plans, singles, strips, gathered, weight }),
        }, else return false);
        true
    }

    /// Reads texel by texel in double precision.
    fn careful(&self, asked: Asked, plans: &[Plan], gathered: &mut [Gathered]) {
        for (plan, gathered) in plans.iter().zip(gathered) {
            if matches!(plan.read, Read::Strip(_) | Read::Strips) {
                let (level, filter) = (self.pyramid.level(plan.level), asked.filter);
                let tilt = Shape::of(asked.pixels[plan.lookup].jacobian, filter).tilt;
                let sum = careful(level, self.wrap, &plan.placed, filter.weight, tilt, filter.rim);
                *gathered = Gathered { sum, ..Gathered::NONE };
            }
        }
    }
}

/// Means of what was gathered, two levels blended.
struct Finish<'s, 'a> {
    sampler: &'s Sampler<'a>,
    pixels: &'s [Pixel],
    plans: &'s [Plan],
    gathered: &'s [Gathered],
    out: &'s mut [Lookup],
}

impl Job for Finish<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        match self.sampler.channels() {
            1 => self.means::<1>(),
            2 => self.means::<2>(),
            3 => self.means::<3>(),
            _ => self.means::<4>(),
        }
    }
}

impl Finish<'_, '_> {
    #[inline(always)]
    fn means<const C: usize>(self) {
        for (plan, gathered) in self.plans.iter().zip(self.gathered) {
            let found = &mut self.out[plan.lookup];
            let mut mean = None;
            match plan.read {
                Read::Strip(_) | Read::Strips => {
                    let sum = gathered.total::<C>();
                    mean = sum.mean::<C>();
                    found.texels += sum.texels;
                }
                Read::Point => {
                    mean = Some(self.sampler.pyramid.level(plan.level).texel(0, 0));
                    found.texels += 1;
                }
                Read::Four => {}
            }
            let value = mean.unwrap_or_else(|| {
                let Pixel { s, t, .. } = self.pixels[plan.lookup];
                found.fallback = true;
                found.texels += 4;
                self.sampler.four(plan.level, [f64::from(s), f64::from(t)]).value
            });
            if plan.share == 1.0 {
                found.value = value;
            } else {
                // Exact where the two are the same.
                for c in 0..C {
                    found.value[c] += plan.share * (value[c] - found.value[c]);
                }
            }
        }
    }
}
