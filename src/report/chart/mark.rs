use super::clip::distance;
use super::colour::{INK, WHITE};
use super::frame::Frame;
use super::header::Sizes;
use super::scene::{Anchor, Point, Rect, Scene};

/// A dot with a short label, such as an extremum; not drawn where it lies outside the ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where the dot stands.
    pub at: (f64, f64),
    /// What stands beside it.
    pub text: String,
}

/// The gap between a dot and its label, and between a label and the frame.
const GAP: f64 = 14.0;

/// Draws the marks; labels stay inside the frame and, where there is room, clear of the lines.
pub(super) fn draw(scene: &mut Scene, marks: &[Mark], frame: &Frame, lines: &[Vec<Point>], sizes: &Sizes) {
    let placed: Vec<(Point, &str)> =
        marks.iter().filter_map(|m| Some((frame.pixel_of(m.at)?, m.text.as_str()))).collect();
    let dots: Vec<Point> = placed.iter().map(|&(dot, _)| dot).collect();
    let mut taken: Vec<Rect> = Vec::new();
    for &(dot, text) in &placed {
        if text.is_empty() {
            continue;
        }
        let width = 1.06 * scene.font.width(text, sizes.mark);
        let Some(label) = candidates(dot, width, sizes.mark, &frame.rect)
            .into_iter()
            .map(|c| (crowding(&c, lines, &dots, &taken) + 0.01 * far(dot, &c), c))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, label)| label)
        else {
            continue;
        };
        // A label that had to move away keeps its dot by a thin line.
        let near = (dot.0.clamp(label.left, label.right), dot.1.clamp(label.top, label.bottom));
        if far(dot, &label) > 2.2 * GAP {
            scene.stroke(vec![dot, near], INK, 1.5);
        }
        scene.fill(label, WHITE, 0.8);
        let at = (label.left + 0.03 * width, label.top + 0.92 * sizes.mark);
        scene.text(at, text, sizes.mark, INK, Anchor::Start);
        taken.push(label);
    }
    for dot in dots {
        scene.ringed_dot(dot, 1.7 * sizes.line);
    }
}

/// Places for a label around a dot, the preferred first, all inside the frame.
fn candidates(dot: Point, width: f64, size: f64, frame: &Rect) -> Vec<Rect> {
    let height = 1.2 * size;
    let mut places = Vec::new();
    for ring in [1.0, 3.0, 5.5, 9.0] {
        let off = ring * GAP;
        for (right, down) in [
            (1.0, -1.0),
            (-1.0, -1.0),
            (1.0, 1.0),
            (-1.0, 1.0),
            (0.0, -1.0),
            (0.0, 1.0),
            (1.0, 0.0),
            (-1.0, 0.0),
        ] {
            let left = dot.0 + right * off + (right - 1.0) * 0.5 * width;
            let top = dot.1 + down * off + (down - 1.0) * 0.5 * height;
            // A text wider than the frame begins at its left.
            let left = left.min(frame.right - GAP - width).max(frame.left + GAP);
            let top = top.min(frame.bottom - GAP - height).max(frame.top + GAP);
            places.push(Rect { left, top, right: left + width, bottom: top + height });
        }
    }
    places
}

/// How much lies under a label.
fn crowding(label: &Rect, lines: &[Vec<Point>], dots: &[Point], taken: &[Rect]) -> f64 {
    let covers = |p: Point, by: f64| {
        p.0 > label.left - by && p.0 < label.right + by && p.1 > label.top - by && p.1 < label.bottom + by
    };
    let crossed =
        lines.iter().flat_map(|line| line.windows(2)).filter(|pair| crosses(label, pair[0], pair[1]));
    let overlaps = taken.iter().filter(|t| {
        t.left < label.right && label.left < t.right && t.top < label.bottom && label.top < t.bottom
    });
    let hidden = dots.iter().filter(|&&dot| covers(dot, 0.5 * GAP));
    4.0 * (crossed.count().min(20) as f64) + 200.0 * overlaps.count() as f64 + 100.0 * hidden.count() as f64
}

/// Whether a segment passes through the label's box, taken as the line through its middle with round
/// ends: near enough, and without a case distinction.
fn crosses(label: &Rect, a: Point, b: Point) -> bool {
    let outside = a.0.max(b.0) < label.left
        || a.0.min(b.0) > label.right
        || a.1.max(b.1) < label.top
        || a.1.min(b.1) > label.bottom;
    let middle = 0.5 * (label.top + label.bottom);
    let steps = 12;
    !outside
        && (0..=steps).any(|i| {
            let x = label.left + label.width() * f64::from(i) / f64::from(steps);
            distance((x, middle), a, b) < 0.6 * label.height()
        })
}

fn far(dot: Point, label: &Rect) -> f64 {
    let near = (dot.0.clamp(label.left, label.right), dot.1.clamp(label.top, label.bottom));
    distance(dot, near, near)
}
