//! What no other beats in both.

/// The places of the points (time, error) that no other point beats, by rising time.
///
/// One point beats another if it is at most as large in both and less in one; equal points do not
/// beat each other. A point with a NaN is never on the frontier and beats none.
///
/// ```
/// use bellfit::trade::frontier;
/// let points = [(3.0, 0.1), (1.0, 0.5), (2.0, 0.7), (3.0, 0.2)];
/// assert_eq!(frontier(&points), [1, 0]);
/// ```
pub fn frontier(points: &[(f64, f64)]) -> Vec<usize> {
    let told = |&i: &usize| !points[i].0.is_nan() && !points[i].1.is_nan();
    let mut order: Vec<usize> = (0..points.len()).filter(told).collect();
    order.sort_by(|&i, &j| {
        let (a, b) = (points[i], points[j]);
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)).then(i.cmp(&j))
    });
    // Of those that are as fast or faster none may be as accurate, but for an equal.
    let mut kept: Vec<usize> = Vec::new();
    for i in order {
        if kept.last().is_none_or(|&last| points[i].1 < points[last].1 || points[i] == points[last]) {
            kept.push(i);
        }
    }
    kept
}
