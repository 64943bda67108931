//! Branch and bound: the supremum of a function over a box, enclosed.

use super::Interval;
use core::cmp::Ordering;
use std::collections::BinaryHeap;

/// The supremum of f over a box, with where it was found and what it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supremum<const D: usize> {
    /// Encloses sup f: its lower end is reached at `at`, its upper end is never exceeded.
    pub value: Interval,
    /// A point of the box at which f ≥ `value.lo()`.
    pub at: [f64; D],
    /// Boxes examined.
    pub boxes: usize,
}

struct Candidate<const D: usize> {
    upper: f64,
    cell: [Interval; D],
}

impl<const D: usize> PartialEq for Candidate<D> {
    fn eq(&self, other: &Self) -> bool {
        self.upper == other.upper
    }
}
impl<const D: usize> Eq for Candidate<D> {}
impl<const D: usize> PartialOrd for Candidate<D> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl<const D: usize> Ord for Candidate<D> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper)
    }
}

/// Encloses sup f over `domain`, where `f` encloses its range over any box it is given.
///
/// The box with the largest upper bound is halved along its relatively widest side until that
/// bound is within `tolerance` of the best value seen, or `most` boxes have been examined; either
/// way the result is an enclosure, only its width differs.
///
/// ```
/// use bellfit::bound::{Interval, supremum};
/// // x (1 - x) on [0, 1]: 1/4 at 1/2
/// let best = supremum(|[x]| *x * (Interval::from(1.0) - *x), [Interval::new(0.0, 1.0)], 1e-6, 100_000);
/// assert!(best.value.contains(0.25) && best.value.width() <= 1.1e-6);
/// assert!((best.at[0] - 0.5).abs() < 1e-2);
/// ```
pub fn supremum<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    tolerance: f64,
    most: usize,
) -> Supremum<D> {
    supremum_until(f, domain, |best, upper| upper <= best + tolerance, most)
}

/// The same, until `enough` is satisfied with the best value seen and the upper bound.
pub fn supremum_until<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    enough: impl Fn(f64, f64) -> bool,
    most: usize,
) -> Supremum<D> {
    let corners =
        |cell: &[Interval; D]| vec![cell.map(Interval::lo), cell.map(Interval::hi), cell.map(Interval::mid)];
    let scale = domain.map(Interval::width);
    search(f, domain, corners, |cell| widest(cell, &scale), &[], enough, most)
}

/// [`supremum`] where points near the supremum are known: these are looked at first (those outside the
/// domain are not), and of each box its middle alone, which is less than half the work.
pub fn supremum_near<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    seeds: &[[f64; D]],
    tolerance: f64,
    most: usize,
) -> Supremum<D> {
    let enough = |best: f64, upper: f64| upper <= best + tolerance;
    let scale = domain.map(Interval::width);
    let middle = |cell: &[Interval; D]| vec![cell.map(Interval::mid)];
    search(f, domain, middle, |cell| widest(cell, &scale), seeds, enough, most)
}

/// [`supremum_until`] where the caller chooses the side along which a box is halved, and the points of it that
/// are looked at.
pub(super) fn supremum_split<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    points: impl Fn(&[Interval; D]) -> Vec<[f64; D]>,
    side: impl Fn(&[Interval; D]) -> usize,
    enough: impl Fn(f64, f64) -> bool,
    most: usize,
) -> Supremum<D> {
    search(f, domain, points, side, &[], enough, most)
}

fn search<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    points: impl Fn(&[Interval; D]) -> Vec<[f64; D]>,
    side: impl Fn(&[Interval; D]) -> usize,
    seeds: &[[f64; D]],
    enough: impl Fn(f64, f64) -> bool,
    most: usize,
) -> Supremum<D> {
    let mut best = f64::NEG_INFINITY;
    let mut at = domain.map(Interval::mid);
    let mut look = |points: &[[f64; D]], best: &mut f64| {
        for point in points {
            let value = f(&point.map(Interval::from)).lo();
            if value > *best {
                (*best, at) = (value, *point);
            }
        }
    };
    let within = |seed: &&[f64; D]| seed.iter().zip(&domain).all(|(x, side)| side.contains(*x));
    let seeds: Vec<[f64; D]> = seeds.iter().filter(within).copied().collect();
    look(&seeds, &mut best);
    look(&points(&domain), &mut best);
    let mut heap = BinaryHeap::new();
    heap.push(Candidate { upper: f(&domain).hi(), cell: domain });
    let mut boxes = 1;
    let upper = loop {
        let Some(top) = heap.pop() else { break best };
        if enough(best, top.upper) || boxes >= most {
            break top.upper.max(best);
        }
        let side = side(&top.cell);
        let (left, right) = top.cell[side].bisect();
        if left.width() == 0.0 || right.width() == 0.0 {
            break top.upper; // as fine as doubles go
        }
        for half in [left, right] {
            let mut cell = top.cell;
            cell[side] = half;
            look(&points(&cell), &mut best);
            // A part's range lies in the whole's.
            let upper = f(&cell).hi().min(top.upper);
            boxes += 1;
            if upper > best {
                heap.push(Candidate { upper, cell });
            }
        }
    };
    Supremum { value: Interval::new(best, upper), at, boxes }
}

/// The infimum, as the supremum of -f.
pub fn infimum<const D: usize>(
    f: impl Fn(&[Interval; D]) -> Interval,
    domain: [Interval; D],
    tolerance: f64,
    most: usize,
) -> Supremum<D> {
    let negated = supremum(|cell| -f(cell), domain, tolerance, most);
    Supremum { value: -negated.value, ..negated }
}

/// The side of a box that is widest by a scale, of those that can be halved.
pub(super) fn widest<const D: usize>(cell: &[Interval; D], scale: &[f64; D]) -> usize {
    let share = |k: usize| {
        let splits = cell[k].lo() < cell[k].mid() && cell[k].mid() < cell[k].hi();
        if splits { cell[k].width() / scale[k] } else { 0.0 }
    };
    (0..D).fold(0, |best, k| if share(k) > share(best) { k } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::Field;

    #[test]
    fn a_plane_wave_is_bounded_in_two_dimensions() {
        // x y (1 - x)(1 - y) has its maximum 1/16 at the centre.
        let one = Interval::from(1.0);
        let f = |[x, y]: &[Interval; 2]| *x * (one - *x) * *y * (one - *y);
        let best = supremum(f, [Interval::new(0.0, 1.0); 2], 1e-4, 65_536);
        assert!(best.value.contains(0.0625) && best.value.width() < 1.1e-4);
        let least = infimum(f, [Interval::new(0.0, 1.0); 2], 1e-4, 65_536);
        assert!(least.value.contains(0.0));
    }

    #[test]
    fn running_out_of_boxes_still_encloses() {
        let f = |[x]: &[Interval; 1]| *x - *x; // 0, with a dependency that never resolves exactly
        let best = supremum(f, [Interval::new(0.0, 1.0)], 0.0, 64);
        assert!(best.value.contains(0.0) && best.value.hi() > 0.0);
    }

    #[test]
    fn a_side_too_thin_to_split_does_not_stop_the_others() {
        let thin = Interval::new(1.0, 1.0_f64.next_up());
        let one = Interval::from(1.0);
        let f = |[a, x]: &[Interval; 2]| *a * *x * (one - *x);
        let best = supremum(f, [thin, Interval::new(0.0, 1.0)], 1e-5, 100_000);
        assert!(best.value.contains(0.25) && best.value.width() < 1.1e-5);
    }

    #[test]
    fn a_supremum_at_an_end_is_found_there() {
        let best = supremum(|[x]| *x, [Interval::new(0.0, 3.0)], 1e-12, 1000);
        assert_eq!(best.at, [3.0]);
        assert!(best.value.contains(3.0));
    }

    #[test]
    fn candidates_compare_by_their_bounds() {
        let of = |upper: f64, side: f64| Candidate { upper, cell: [Interval::from(side)] };
        assert!(of(1.0, 2.0) == of(1.0, 3.0) && of(1.0, 2.0) != of(1.5, 2.0));
        assert!(of(1.0, 2.0) < of(1.5, 0.0) && of(2.0, 0.0) > of(1.0, 9.0));
        assert_eq!(of(1.0, 0.0).partial_cmp(&of(1.0, 1.0)), Some(Ordering::Equal));
    }

    #[test]
    fn the_widest_side_is_so_by_its_scale() {
        let cell = [Interval::new(0.0, 1.0), Interval::new(0.0, 3.0), Interval::new(5.0, 7.0)];
        assert_eq!(widest(&cell, &[1.0, 1.0, 1.0]), 1);
        assert_eq!(widest(&cell, &[1.0, 4.0, 3.0]), 0);
        assert_eq!(widest(&cell, &[4.0, 9.0, 3.0]), 2);
        // What cannot be halved does not count; of equals the first.
        let thin = [Interval::new(0.0, 1.0), Interval::from(2.0), Interval::new(1.0, 1.0_f64.next_up())];
        assert_eq!(widest(&thin, &[1.0, 1e-300, 1e-300]), 0);
        assert_eq!(widest(&[Interval::new(0.0, 1.0); 3], &[1.0; 3]), 0);
        assert_eq!(widest(&[thin[2], thin[1], cell[0]], &[1.0; 3]), 2);
    }

    /// -(x - 0.3)² - (y - 0.7)² is 0 at (0.3, 0.7), and found in the few hundred boxes that halving takes.
    #[test]
    fn a_top_is_found_with_few_boxes() {
        let f = |[x, y]: &[Interval; 2]| {
            -((*x - Interval::from(0.3)).power(2) + (*y - Interval::from(0.7)).power(2))
        };
        let unit = [Interval::new(0.0, 1.0), Interval::new(0.0, 1.0)];
        let plain = supremum(f, unit, 1e-6, 100_000);
        let seeded = supremum_near(f, unit, &[[0.3, 0.7], [0.5, 2.0]], 1e-6, 100_000);
        let until = supremum_until(f, unit, |best, upper| upper <= best + 1e-6, 100_000);
        assert_eq!(plain, until);
        for found in [plain, seeded] {
            assert!(found.value.lo() <= 0.0 && found.value.hi() >= 0.0 && found.value.width() <= 1.1e-6);
            assert!((found.at[0] - 0.3).abs() < 2e-3 && (found.at[1] - 0.7).abs() < 2e-3, "{found:?}");
            assert!(found.boxes < 400, "{found:?}");
        }
        assert_eq!(seeded.at, [0.3, 0.7]);
        // Seeds outside are not looked at, though they would be higher.
        let rising = |[x]: &[Interval; 1]| *x;
        let found = supremum_near(rising, [Interval::new(0.0, 1.0)], &[[5.0]], 1e-6, 1000);
        assert!(found.value.hi() <= 1.0 && found.at[0] <= 1.0, "{found:?}");
        // Stopped at 9 boxes it says so, and still encloses.
        let stopped = supremum(f, unit, 0.0, 9);
        assert!(stopped.boxes == 9 && stopped.value.hi() >= 0.0, "{stopped:?}");
        let lowest = infimum(f, unit, 1e-3, 100_000);
        // -0.49 - 0.49 at (1, 0).
        assert!(lowest.value.contains(-0.98) && lowest.value.width() < 2e-3, "{lowest:?}");
        // A step as fine as doubles ends where no half is left.
        let step = |[x]: &[Interval; 1]| if x.hi() > 0.5 { Interval::new(0.0, 1.0) } else { Interval::ZERO };
        let found = supremum(step, [Interval::new(0.0, 1.0)], 0.0, 100_000);
        assert!(found.value == Interval::new(0.0, 1.0) && found.boxes < 2000, "{found:?}");
        let first =
            supremum_split(f, unit, |_| vec![[0.3, 0.7]], |_| 0, |best, upper| upper <= best + 1.0, 1000);
        assert!(first.at == [0.3, 0.7] && first.boxes < 10, "{first:?}");
    }
}
