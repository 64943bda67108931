//! Which colour each series has, and the legend that says so.

use super::colour::{INK, Rgb, band, series};
use super::header::Sizes;
use super::line::LineChart;
use super::scene::{Anchor, LEADING, Rect, Scene};
use super::series::{Series, Style};
use super::stroke;

const SAMPLE: f64 = 58.0;
const GAP: f64 = 14.0;
const BETWEEN: f64 = 44.0;
/// Bands let each other show through, in the legend too.
pub(super) const OPACITY: f64 = 0.75;

/// What stands before a legend's text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Key {
    /// A piece of the line.
    Series(Style, Rgb),
    /// Fill, its opacity, and border.
    Patch(Rgb, f64, Rgb),
}

/// Texts and their keys, each text once.
#[derive(Debug, Default)]
pub(super) struct Legend {
    entries: Vec<(String, Key)>,
}

/// Colours by label, so that one label has one colour in every panel.
#[derive(Debug, Default)]
pub(super) struct Colours {
    seen: Vec<String>,
}

impl Colours {
    pub(super) fn series(&mut self, s: &Series) -> Rgb {
        series(s.colour.unwrap_or_else(|| self.index(&s.label)))
    }

    pub(super) fn band(&mut self, label: &str) -> (Rgb, Rgb) {
        band(self.index(label))
    }

    fn index(&mut self, label: &str) -> usize {
        let known = self.seen.iter().position(|seen| seen == label).filter(|_| !label.is_empty());
        known.unwrap_or_else(|| {
            self.seen.push(label.to_owned());
            self.seen.len() - 1
        })
    }
}

impl Legend {
    pub(super) fn add(&mut self, label: &str, key: Key) {
        if !label.is_empty() && !self.entries.iter().any(|(text, k)| text == label && *k == key) {
            self.entries.push((label.to_owned(), key));
        }
    }

    /// The entries of charts whose colours go by label.
    pub(super) fn of<'a>(charts: impl IntoIterator<Item = &'a LineChart>) -> Self {
        let mut legend = Self::default();
        let (mut lines, mut bands) = (Colours::default(), Colours::default());
        let mut patches = Self::default();
        for chart in charts {
            for s in &chart.series {
                let colour = lines.series(s);
                legend.add(&s.label, Key::Series(s.style, colour));
            }
            for b in &chart.bands {
                let (fill, border) = bands.band(&b.label);
                patches.add(&b.label, Key::Patch(fill, OPACITY, border));
            }
        }
        legend.entries.extend(patches.entries);
        legend
    }

    /// Draws the entries in columns, row by row, from the room's upper left corner on; returns their
    /// height.
    pub(super) fn draw(&self, scene: &mut Scene, room: &Rect, sizes: &Sizes) -> f64 {
        let (size, font) = (sizes.tick, scene.font);
        let texts: Vec<Vec<String>> =
            self.entries.iter().map(|(t, _)| font.wrap(t, size, room.width() - SAMPLE - GAP)).collect();
        let widest = texts.iter().flatten().map(|line| font.width(line, size)).fold(0.0, f64::max);
        let step = SAMPLE + GAP + 1.1 * widest + BETWEEN;
        let columns = (((room.width() + BETWEEN) / step) as usize).clamp(1, texts.len().max(1));
        let mut top = room.top;
        for (keys, row) in self.entries.chunks(columns).zip(texts.chunks(columns)) {
            for (i, ((_, key), lines)) in keys.iter().zip(row).enumerate() {
                let left = room.left + step * i as f64;
                sample(scene, *key, left, top + 0.65 * size, sizes);
                for (j, line) in lines.iter().enumerate() {
                    let at = (left + SAMPLE + GAP, top + (1.0 + LEADING * j as f64) * size);
                    scene.text(at, line, size, INK, Anchor::Start);
                }
            }
            let lines = row.iter().map(Vec::len).max().unwrap_or(0);
            top += (LEADING * lines as f64 + 0.15) * size;
        }
        top - room.top
    }
}

fn sample(scene: &mut Scene, key: Key, left: f64, middle: f64, sizes: &Sizes) {
    match key {
        Key::Series(Style::Points, colour) => {
            scene.dot((left + 0.5 * SAMPLE, middle), 1.4 * sizes.line, colour)
        }
        Key::Series(style, colour) => {
            stroke::draw(scene, &[(left, middle), (left + SAMPLE, middle)], style, colour, sizes.line);
        }
        Key::Patch(fill, alpha, border) => {
            let half = 0.42 * sizes.tick;
            let rect = Rect { left, top: middle - half, right: left + SAMPLE, bottom: middle + half };
            scene.fill(rect, fill, alpha);
            scene.outline(&rect, border, 2.0);
        }
    }
}
