//! What stands over a picture.

use super::colour::{GREY, INK, Rgb};
use super::font::Font;
use super::scene::{Anchor, EDGE, LEADING, Scene, WIDTH};

/// The sizes of one picture's texts and lines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes {
    pub(super) title: f64,
    pub(super) subtitle: f64,
    pub(super) label: f64,
    pub(super) tick: f64,
    pub(super) mark: f64,
    pub(super) line: f64,
}

/// A picture of its own, to be shown at half its width.
pub(super) const FULL: Sizes =
    Sizes { title: 38.0, subtitle: 28.0, label: 29.0, tick: 26.0, mark: 26.0, line: 4.0 };
/// One of several.
pub(super) const SMALL: Sizes =
    Sizes { title: 28.0, subtitle: 24.0, label: 25.0, tick: 23.0, mark: 23.0, line: 3.6 };

/// Draws title and subtitle at the picture's top; returns where the rest begins.
pub(super) fn header(scene: &mut Scene, title: &str, subtitle: &str) -> f64 {
    let heading = Heading::new(scene.font, title, subtitle, WIDTH - 2.0 * EDGE, &FULL);
    heading.draw(scene, EDGE, EDGE);
    EDGE + heading.height
}

/// Title and subtitle, broken into lines.
#[derive(Debug)]
pub(super) struct Heading {
    lines: Vec<(String, f64, Rgb)>,
    pub(super) height: f64,
}

impl Heading {
    pub(super) fn new(font: &Font, title: &str, subtitle: &str, width: f64, sizes: &Sizes) -> Self {
        let mut lines = Vec::new();
        for (text, size, colour) in [(title, sizes.title, INK), (subtitle, sizes.subtitle, GREY)] {
            lines.extend(font.wrap(text, size, width).into_iter().map(|line| (line, size, colour)));
        }
        let below = if lines.is_empty() { 0.0 } else { 0.25 * sizes.subtitle };
        let height = lines.iter().map(|(_, size, _)| LEADING * size).sum::<f64>() + below;
        Self { lines, height }
    }

    /// Draws the lines from this upper left corner on.
    pub(super) fn draw(&self, scene: &mut Scene, left: f64, top: f64) {
        let mut y = top;
        for (line, size, colour) in &self.lines {
            scene.text((left, y + 0.95 * size), line, *size, *colour, Anchor::Start);
            y += LEADING * size;
        }
    }
}
