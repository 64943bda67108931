//! What lookups read, level by level.

use super::gathered::Gathered;
use super::placed::Placed;
use super::sampler::Asked;
use super::shape::{Shape, is_readable};
use super::{Lookup, Pixel, Sampler};
use crate::slice::Job;

/// How a level is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Read {
    /// The level is one texel.
    Point,
    /// The ellipse holds nothing: bilinearly.
    Four,
    /// One strip, from this texel on, holds the ellipse.
    Strip(usize),
    /// Strip by strip.
    Strips,
}

/// What one lookup reads in one level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    /// Whose it is.
    pub lookup: usize,
    pub level: usize,
    /// 1 of the first level; of the second its share of the blend, which is less.
    pub share: f32,
    pub read: Read,
    /// The ellipse, if texels are read.
    pub placed: Placed,
}

impl Plan {
    /// To be written over.
    pub const NONE: Plan = Plan { lookup: 0, level: 0, share: 0.0, read: Read::Four, placed: Placed::NONE };
}

/// Plans lookups: notes in `out` what is known of each, and gives the number of plans. At most two a lookup
/// must find room; where strips will be read, `gathered` is made ready.
pub(super) struct Planning<'s, 'a> {
    pub sampler: &'s Sampler<'a>,
    pub asked: Asked<'s>,
    pub out: &'s mut [Lookup],
    pub plans: &'s mut [Plan],
    pub gathered: &'s mut [Gathered],
}

impl Job for Planning<'_, '_> {
    type Output = usize;

    #[inline(always)]
    fn run(mut self) -> usize {
        let mut len = 0;
        for (i, pixel) in self.asked.pixels.iter().enumerate() {
            self.out[i] = self.plan(pixel, i, &mut len);
        }
        len
    }
}

impl Planning<'_, '_> {
    /// One lookup: one level, or two.
    #[inline(always)]
    fn plan(&mut self, pixel: &Pixel, lookup: usize, len: &mut usize) -> Lookup {
        let Pixel { s, t, jacobian: j } = *pixel;
        let (sampler, filter, fixed) = (self.sampler, self.asked.filter, self.asked.fixed);
        if !pixel.is_finite() {
            return Lookup { level: f32::NAN, ..sampler.none() };
        }
        let mut shape = Shape::of(j, filter);
        // The axes are not free, and a fixed level without a limit needs none.
        let mut minor = 0.0;
        if fixed.is_none() || filter.anisotropy < f32::INFINITY {
            (shape, minor) = shape.limited(f64::from(filter.anisotropy));
        }
        let (level, fraction) = match fixed {
            Some(i) => (i, 0.0),
            None => {
                let level = self.level(&shape, minor);
                (level as usize, level - level.floor())
            }
        };
        let position = [f64::from(s), f64::from(t)];
        let (before, blended) = (*len, level as f32 + fraction);
        let first = Plan { lookup, level, share: 1.0, ..Plan::NONE };
        let second = Plan { lookup, level: level + 1, share: fraction, ..Plan::NONE };
        if !self.add(first, &shape, position, len)
            || fraction > 0.0 && !self.add(second, &shape, position, len)
        {
            *len = before;
            return Lookup { level: blended, refused: true, ..sampler.none() };
        }
        Lookup { level: blended, ..Lookup::default() }
    }

    /// One level of it; false if the ellipse there is too large.
    #[inline(always)]
    fn add(&mut self, head: Plan, shape: &Shape, position: [f64; 2], len: &mut usize) -> bool {
        let Plan { lookup, level, share, .. } = head;
        let (texture, place) = self.sampler.at(level, position);
        let footprint = shape.in_level(self.sampler.ratios[level], self.asked.filter.padding);
        let plan = &mut self.plans[*len];
        (plan.lookup, plan.level, plan.share) = (lookup, level, share);
        plan.read = if self.sampler.is_point(level) {
            Read::Point
        } else if footprint.determinant > 0.0 {
            if !is_readable(&footprint) {
                return false;
            }
            let placed = Placed::new(place, footprint);
            // Asked before it is stored: a load of two numbers stored one by one waits for both.
            let strip = placed.strip(texture);
            plan.placed = placed;
            strip.map_or(Read::Strips, Read::Strip)
        } else {
            Read::Four
        };
        if plan.read == Read::Strips {
            self.gathered[*len] = Gathered::NONE;
        }
        *len += 1;
        true
    }

    /// The level by the minor axis, or the first above it whose ellipse can be read.
    #[inline(always)]
    fn level(&self, shape: &Shape, minor: f64) -> f32 {
        let (sampler, filter) = (self.sampler, self.asked.filter);
        let cover = f64::from(filter.cover);
        let mut level = sampler.level(minor / (cover * cover));
        while !(sampler.is_point(level as usize)
            || is_readable(&shape.in_level(sampler.ratios[level as usize], filter.padding)))
        {
            level = (level as usize + 1) as f32;
        }
        level
    }
}
