//! The plot area: its place, frame, grid, ticks and labels.

use super::ChartError;
use super::axis::{Axis, Span};
use super::clip::inside;
use super::colour::{FRAME, GREY, GRID, INK};
use super::font::Font;
use super::header::Sizes;
use super::scene::{Anchor, LEADING, Point, Rect, Scene};
use super::ticks::{Room, Tick, ticks};

const TICK: f64 = 8.0;
const GAP: f64 = 8.0;
/// The gap over the labels across: the lowest label on the left hangs down beside them.
const BELOW: f64 = 13.0;
/// The part of its outer width that a frame has at least; its label is planned for this.
const NARROWEST: f64 = 0.7;

/// A pair of axes, and which of their labels are wanted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plot<'a> {
    pub(super) x: &'a Axis,
    pub(super) y: &'a Axis,
    pub(super) sizes: &'a Sizes,
    pub(super) x_label: bool,
    pub(super) y_label: bool,
}

/// What an axis' texts take from each side.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Margins {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

impl Margins {
    /// The larger on each side: frames of one grid line up.
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
            bottom: self.bottom.max(other.bottom),
        }
    }
}

/// A plot area in its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) rect: Rect,
    pub(super) x: Span,
    pub(super) y: Span,
}

impl Frame {
    /// Where a point lies in the unit square and around it.
    pub(super) fn place(&self, (x, y): Point) -> Option<Point> {
        Some((self.x.place(x)?, self.y.place(y)?))
    }

    /// The pixel of a point of the unit square.
    pub(super) fn pixel(&self, (u, v): Point) -> Point {
        (self.rect.left + u * self.rect.width(), self.rect.bottom - v * self.rect.height())
    }

    /// The pixel of a point inside the ranges.
    pub(super) fn pixel_of(&self, point: Point) -> Option<Point> {
        self.place(point).filter(|&p| inside(p)).map(|p| self.pixel(p))
    }
}

impl Plot<'_> {
    /// What the texts need around a plot area inside this width and height.
    pub(super) fn margins(&self, font: &Font, width: f64, height: f64) -> Result<Margins, ChartError> {
        let Sizes { label, tick, .. } = *self.sizes;
        let lines = |axis: &Axis, wanted: bool, length: f64| {
            let count = if wanted { font.wrap(&axis.label, label, length).len() } else { 0 };
            if count > 0 { LEADING * label * count as f64 + GAP } else { 0.0 }
        };
        let top = 0.5 * tick;
        let bottom = TICK + BELOW + tick + lines(self.x, self.x_label, NARROWEST * width);
        let inner = height - top - bottom;
        let widest =
            self.y_ticks(font, inner)?.iter().map(|t| font.width(&t.label, tick)).fold(0.0, f64::max);
        let y_label = lines(self.y, self.y_label, inner);
        let left = TICK + GAP + 1.08 * widest + y_label;
        // The outermost labels stick out beyond the frame's corners.
        let length = width - left - tick;
        let (mut before, mut after) = (left, 0.5 * tick);
        for Tick { at, label } in self.x_ticks(font, length)? {
            let half = 0.55 * font.width(&label, tick);
            before = before.max(half - at * length);
            after = after.max(half - (1.0 - at) * length);
        }
        Ok(Margins { left: before, right: after, top, bottom })
    }

    /// The frame inside the outer rectangle.
    pub(super) fn frame(&self, outer: &Rect, margins: &Margins) -> Result<Frame, ChartError> {
        let rect = Rect {
            left: outer.left + margins.left,
            top: outer.top + margins.top,
            right: outer.right - margins.right,
            bottom: outer.bottom - margins.bottom,
        };
        Ok(Frame { rect, x: self.x.span()?, y: self.y.span()? })
    }

    /// Draws the grid, which lies under the data.
    pub(super) fn grid(&self, scene: &mut Scene, frame: &Frame) -> Result<(), ChartError> {
        let r = frame.rect;
        for tick in self.x_ticks(scene.font, r.width())? {
            let (x, _) = frame.pixel((tick.at, 0.0));
            scene.stroke(vec![(x, r.top), (x, r.bottom)], GRID, 1.5);
        }
        for tick in self.y_ticks(scene.font, r.height())? {
            let (_, y) = frame.pixel((0.0, tick.at));
            scene.stroke(vec![(r.left, y), (r.right, y)], GRID, 1.5);
        }
        Ok(())
    }

    /// Draws the frame, its ticks and labels.
    pub(super) fn surround(&self, scene: &mut Scene, frame: &Frame) -> Result<(), ChartError> {
        let r = frame.rect;
        let Sizes { label, tick: size, .. } = *self.sizes;
        scene.outline(&r, FRAME, 2.0);
        for tick in self.x_ticks(scene.font, r.width())? {
            let (x, _) = frame.pixel((tick.at, 0.0));
            scene.stroke(vec![(x, r.bottom), (x, r.bottom + TICK)], FRAME, 2.0);
            let at = (x, r.bottom + TICK + BELOW + 0.76 * size);
            scene.text(at, &tick.label, size, GREY, Anchor::Middle);
        }
        let mut widest = 0.0_f64;
        for tick in self.y_ticks(scene.font, r.height())? {
            widest = widest.max(1.08 * scene.font.width(&tick.label, size));
            let (_, y) = frame.pixel((0.0, tick.at));
            scene.stroke(vec![(r.left - TICK, y), (r.left, y)], FRAME, 2.0);
            scene.text((r.left - TICK - GAP, y + 0.36 * size), &tick.label, size, GREY, Anchor::End);
        }
        if self.x_label {
            let lines = scene.font.wrap(&self.x.label, label, r.width());
            for (i, line) in lines.iter().enumerate() {
                let down = TICK + BELOW + size + GAP + LEADING * label * i as f64 + 0.95 * label;
                let middle = 0.5 * (r.left + r.right);
                scene.text((middle, r.bottom + down), line, label, INK, Anchor::Middle);
            }
        }
        if self.y_label {
            let lines = scene.font.wrap(&self.y.label, label, r.height());
            for (i, line) in lines.iter().rev().enumerate() {
                let out = TICK + GAP + widest + GAP + LEADING * label * i as f64 + 0.3 * label;
                scene.text_upwards((r.left - out, 0.5 * (r.top + r.bottom)), line, label, INK);
            }
        }
        Ok(())
    }

    fn x_ticks(&self, font: &Font, length: f64) -> Result<Vec<Tick>, ChartError> {
        Ok(ticks(self.x, &self.x.span()?, font, Room { length, size: self.sizes.tick, across: true }))
    }

    fn y_ticks(&self, font: &Font, length: f64) -> Result<Vec<Tick>, ChartError> {
        Ok(ticks(self.y, &self.y.span()?, font, Room { length, size: self.sizes.tick, across: false }))
    }
}
