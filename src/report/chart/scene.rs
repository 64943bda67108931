//! A picture laid out: what both formats render.

use super::ChartError;
use super::colour::{INK, Rgb, WHITE};
use super::font::{Font, font};

/// The width of every picture, in pixels of the PNG.
pub(super) const WIDTH: f64 = 1600.0;
/// The distance of everything from the picture's edges.
pub(super) const EDGE: f64 = 28.0;
/// The distance from one line of text to the next, in font sizes.
pub(super) const LEADING: f64 = 1.3;

/// A position, across and down (in a frame's unit square: across and up).
pub(super) type Point = (f64, f64);

/// An upright rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }
}

/// Which part of a text stands at its position.
#[derive(Clone, Copy, Debug)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Text on one line, its baseline through `at`.
#[derive(Clone, Debug)]
pub(super) struct Text {
    pub(super) at: Point,
    pub(super) text: String,
    pub(super) size: f64,
    pub(super) colour: Rgb,
    pub(super) anchor: Anchor,
    /// False: turned to read upwards.
    pub(super) upright: bool,
}

/// One thing to draw.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// A line with round ends and joints.
    Stroke { points: Vec<Point>, colour: Rgb, width: f64 },
    /// A filled rectangle.
    Fill { rect: Rect, colour: Rgb, alpha: f64 },
    /// A filled circle.
    Dot { at: Point, radius: f64, colour: Rgb },
    /// A line of text.
    Text(Text),
}

/// A rectangle of coloured cells, from the top row down.
#[derive(Clone, Debug)]
pub(super) struct Raster {
    pub(super) rect: Rect,
    pub(super) columns: usize,
    pub(super) rows: usize,
    pub(super) cells: Vec<Rgb>,
}

/// Everything on one picture; cells lie under shapes, shapes over those before them.
#[derive(Debug)]
pub(super) struct Scene {
    pub(super) font: &'static Font,
    pub(super) title: String,
    pub(super) height: f64,
    pub(super) rasters: Vec<Raster>,
    pub(super) shapes: Vec<Shape>,
}

impl Scene {
    pub(super) fn new(title: &str) -> Result<Self, ChartError> {
        Ok(Self {
            font: font()?,
            title: printable(title),
            height: 0.0,
            rasters: Vec::new(),
            shapes: Vec::new(),
        })
    }

    /// A straight or bent line.
    pub(super) fn stroke(&mut self, points: Vec<Point>, colour: Rgb, width: f64) {
        self.shapes.push(Shape::Stroke { points, colour, width });
    }

    /// A rectangle's outline.
    pub(super) fn outline(&mut self, r: &Rect, colour: Rgb, width: f64) {
        let corners =
            vec![(r.left, r.top), (r.right, r.top), (r.right, r.bottom), (r.left, r.bottom), (r.left, r.top)];
        self.stroke(corners, colour, width);
    }

    pub(super) fn fill(&mut self, rect: Rect, colour: Rgb, alpha: f64) {
        self.shapes.push(Shape::Fill { rect, colour, alpha });
    }

    pub(super) fn dot(&mut self, at: Point, radius: f64, colour: Rgb) {
        self.shapes.push(Shape::Dot { at, radius, colour });
    }

    /// A dot that stands out from the lines it lies on.
    pub(super) fn ringed_dot(&mut self, at: Point, radius: f64) {
        self.dot(at, radius + 3.0, WHITE);
        self.dot(at, radius, INK);
    }

    pub(super) fn text(&mut self, at: Point, text: &str, size: f64, colour: Rgb, anchor: Anchor) {
        let text = Text { at, text: printable(text), size, colour, anchor, upright: true };
        self.shapes.push(Shape::Text(text));
    }

    /// Text that reads upwards, its middle at `at`.
    pub(super) fn text_upwards(&mut self, at: Point, text: &str, size: f64, colour: Rgb) {
        let text = Text { at, text: printable(text), size, colour, anchor: Anchor::Middle, upright: false };
        self.shapes.push(Shape::Text(text));
    }
}

/// XML has no place for control characters, nor has a line of text.
fn printable(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c })
        .collect()
}
