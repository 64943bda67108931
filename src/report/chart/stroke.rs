//! Lines broken into dashes and dots.

use super::clip::simplify;
use super::colour::Rgb;
use super::scene::{Point, Scene};
use super::series::Style;

/// Less than this is not seen, in pixels.
const TOLERANCE: f64 = 0.15;

/// Draws one run of a series in its style.
pub(super) fn draw(scene: &mut Scene, run: &[Point], style: Style, colour: Rgb, width: f64) {
    let (dash, gap) = match style {
        Style::Line => (f64::INFINITY, 0.0),
        // Round ends make each dash longer by the line's width.
        Style::Dashed => (3.5 * width, 3.0 * width),
        Style::Dotted => (0.0, 2.1 * width),
        Style::Points => {
            for &at in run {
                scene.dot(at, 1.4 * width, colour);
            }
            return;
        }
    };
    let run = simplify(run, TOLERANCE);
    if let [only] = run[..] {
        // A point between two gaps would vanish.
        scene.dot(only, 0.8 * width, colour);
    } else if style == Style::Line {
        scene.stroke(run, colour, width);
    } else {
        for part in dashes(&run, dash, gap) {
            match part[..] {
                [only] => scene.dot(only, 0.55 * width, colour),
                _ => scene.stroke(part, colour, width),
            }
        }
    }
}

/// The parts of a line that its dashes cover; a dash of length 0 is a point.
fn dashes(run: &[Point], dash: f64, gap: f64) -> Vec<Vec<Point>> {
    let mut parts = Vec::new();
    let mut part: Vec<Point> = run.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, dash);
    for pair in run.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let length = ((b.0 - a.0) * (b.0 - a.0) + (b.1 - a.1) * (b.1 - a.1)).sqrt();
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let t = done / length;
            let point = (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1));
            if drawing {
                if part.last() != Some(&point) {
                    part.push(point);
                }
                parts.push(std::mem::take(&mut part));
            } else {
                part.push(point);
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= length - done;
        if drawing && part.last() != Some(&b) {
            part.push(b);
        }
    }
    if drawing && part.len() > 1 {
        parts.push(part);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::dashes;

    #[test]
    fn dashes_go_round_corners() {
        let run = [(0.0, 0.0), (5.0, 0.0), (5.0, 10.0)];
        let parts = dashes(&run, 4.0, 2.0);
        assert_eq!(parts[0], [(0.0, 0.0), (4.0, 0.0)]);
        assert_eq!(parts[1], [(5.0, 1.0), (5.0, 5.0)]);
        assert_eq!(parts[2], [(5.0, 7.0), (5.0, 10.0)]);
    }

    #[test]
    fn dots_stand_at_equal_distances() {
        let parts = dashes(&[(0.0, 0.0), (10.0, 0.0)], 0.0, 3.0);
        assert_eq!(parts, [[(0.0, 0.0)], [(3.0, 0.0)], [(6.0, 0.0)], [(9.0, 0.0)]]);
    }
}
