//! Curves cut into what can be drawn.

use super::scene::Point;

/// The parts of a polyline inside the unit square, cut where it crosses the border; an absent point
/// splits it.
pub(super) fn runs(points: impl IntoIterator<Item = Option<Point>>) -> Vec<Vec<Point>> {
    let mut runs = Vec::new();
    let mut run: Vec<Point> = Vec::new();
    let mut previous: Option<Point> = None;
    for point in points {
        let part = match (previous, point) {
            (_, None) => None,
            (None, Some(q)) => inside(q).then_some((q, q)),
            (Some(p), Some(q)) => segment(p, q),
        };
        previous = point;
        let Some((a, b)) = part else {
            end(&mut runs, &mut run);
            continue;
        };
        if run.last().is_some_and(|&last| last != a) {
            end(&mut runs, &mut run);
        }
        if run.is_empty() {
            run.push(a);
        }
        if run.last() != Some(&b) {
            run.push(b);
        }
    }
    end(&mut runs, &mut run);
    runs
}

/// Whether the point lies in the unit square, its border included.
pub(super) fn inside((x, y): Point) -> bool {
    (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y)
}

fn end(runs: &mut Vec<Vec<Point>>, run: &mut Vec<Point>) {
    if !run.is_empty() {
        runs.push(std::mem::take(run));
    }
}

/// The part of the segment inside the unit square (Liang and Barsky); ends inside come back unchanged.
fn segment(p: Point, q: Point) -> Option<(Point, Point)> {
    let d = (q.0 - p.0, q.1 - p.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (delta, room) in [(-d.0, p.0), (d.0, 1.0 - p.0), (-d.1, p.1), (d.1, 1.0 - p.1)] {
        if delta == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if delta < 0.0 {
            enter = enter.max(room / delta);
        } else {
            leave = leave.min(room / delta);
        }
    }
    // Rounding may leave a cut a hair outside.
    let at = |t: f64| ((p.0 + t * d.0).clamp(0.0, 1.0), (p.1 + t * d.1).clamp(0.0, 1.0));
    (enter <= leave).then(|| {
        let a = if enter > 0.0 { at(enter) } else { p };
        let b = if leave < 1.0 { at(leave) } else { q };
        (a, b)
    })
}

/// The polyline without the points whose absence moves it by no more than `tolerance` (Douglas and
/// Peucker); a curve of thousands of points is then as light as it looks.
pub(super) fn simplify(points: &[Point], tolerance: f64) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[last] = true;
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let mut worst = (tolerance, None);
        for (i, &point) in points.iter().enumerate().take(to).skip(from + 1) {
            let off = distance(point, points[from], points[to]);
            if off > worst.0 {
                worst = (off, Some(i));
            }
        }
        if let Some(i) = worst.1 {
            keep[i] = true;
            open.extend([(from, i), (i, to)]);
        }
    }
    points.iter().zip(keep).filter_map(|(&p, kept)| kept.then_some(p)).collect()
}

/// The distance of a point from a segment.
pub(super) fn distance(p: Point, a: Point, b: Point) -> f64 {
    let d = (b.0 - a.0, b.1 - a.1);
    let square = d.0 * d.0 + d.1 * d.1;
    let along = (p.0 - a.0) * d.0 + (p.1 - a.1) * d.1;
    let t = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    let off = (p.0 - a.0 - t * d.0, p.1 - a.1 - t * d.1);
    (off.0 * off.0 + off.1 * off.1).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{runs, simplify};

    #[test]
    fn a_line_is_cut_where_it_crosses_the_border() {
        let up_and_back = [(0.0, 0.5), (0.5, 1.5), (1.0, 0.5)].map(Some);
        assert_eq!(runs(up_and_back), [[(0.0, 0.5), (0.25, 1.0)], [(0.75, 1.0), (1.0, 0.5)]]);
        assert_eq!(runs([Some((-1.0, 0.5)), Some((2.0, 0.5))]), [[(0.0, 0.5), (1.0, 0.5)]]);
        assert!(runs([Some((-1.0, 0.5)), Some((0.5, 3.0))]).is_empty());
    }

    #[test]
    fn an_absent_point_splits_and_a_lone_one_stays() {
        let points = [Some((0.1, 0.1)), None, Some((0.2, 0.2)), Some((0.3, 0.3)), None];
        assert_eq!(runs(points), [vec![(0.1, 0.1)], vec![(0.2, 0.2), (0.3, 0.3)]]);
    }

    #[test]
    fn only_points_that_are_seen_are_kept() {
        let line = [(0.0, 0.0), (1.0, 0.05), (2.0, 0.0), (3.0, 5.0)];
        assert_eq!(simplify(&line, 0.1), [(0.0, 0.0), (2.0, 0.0), (3.0, 5.0)]);
    }
}
