//! Printed constants that break their bound: the nearest that keep it, by printed digits changed.

use super::{Line, Problem};
use crate::bound::{Extremes, Residual};

/// Constants that keep a bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    /// The line.
    pub line: Line,
    /// How many printed digits differ.
    pub changed: usize,
    /// Its certified residual over the integers of the range.
    pub extremes: Extremes,
}

/// The line with the fewest digits changed whose |residual| is at most `bound` for every integer
/// of the range, b kept if it can be, and among those the smallest |residual|; `None` if that
/// does not help.
///
/// Up to four digits are tried, at most three of them b's; candidates are ranked in doubles and the one
/// returned is certified.
pub fn nearest(problem: &Problem, printed: &Line, bound: f64) -> Option<Nearest> {
    let columns: Vec<(f64, f64)> = problem.columns().collect();
    let worst = |a: f64, b: f64, enough: f64| {
        let mut worst = 0.0_f64;
        for &(p, q) in &columns {
            worst = worst.max((a * p + b * q - 1.0).abs());
            if worst > enough {
                break;
            }
        }
        worst
    };
    // By the number of digits changed, then by how many of them are b's.
    let ways = (0..=4).flat_map(|total| (0..=total.min(3)).map(move |in_b| (in_b, total - in_b)));
    for (in_b, in_a) in ways {
        let mut ranked: Vec<(f64, String, String)> = Vec::new();
        for b in variants(printed.b(), in_b) {
            for a in variants(printed.a(), in_a) {
                let (Ok(x), Ok(y)) = (a.parse::<f64>(), b.parse::<f64>()) else { continue };
                let found = worst(x, y, bound);
                if found <= bound {
                    ranked.push((found, a, b.clone()));
                }
            }
        }
        ranked.sort_by(|x, y| x.0.total_cmp(&y.0).then_with(|| (&x.1, &x.2).cmp(&(&y.1, &y.2))));
        for (_, a, b) in ranked {
            let line = Line::new(&a, &b, printed.divisor())?;
            let extremes =
                Residual::new(problem.case, line.formula()).over_integers(problem.from, problem.to);
            if extremes.magnitude().value.hi() <= bound {
                return Some(Nearest { line, changed: in_a + in_b, extremes });
            }
        }
    }
    None
}

/// Every text that differs from `text` in exactly `changed` digits; a sign, a point and the
/// number of digits stay.
pub(super) fn variants(text: &str, changed: usize) -> Vec<String> {
    fn extend(characters: &mut Vec<char>, from: usize, left: usize, found: &mut Vec<String>) {
        if left == 0 {
            found.push(characters.iter().collect());
            return;
        }
        for i in from..characters.len() {
            let original = characters[i];
            if !original.is_ascii_digit() {
                continue;
            }
            for digit in ('0'..='9').filter(|d| *d != original) {
                characters[i] = digit;
                extend(characters, i + 1, left - 1, found);
            }
            characters[i] = original;
        }
    }
    let mut found = Vec::new();
    extend(&mut text.chars().collect(), 0, changed, &mut found);
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    #[test]
    fn variants_change_exactly_so_many_digits() {
        assert_eq!(variants("1.06", 0), ["1.06"]);
        assert_eq!(variants("1.06", 1).len(), 27);
        assert_eq!(variants("1.06", 2).len(), 3 * 81);
        assert!(variants("-0.5", 1).iter().all(|v| v.starts_with('-') && v.len() == 4));
    }

    #[test]
    fn a_wrong_digit_is_found_again() {
        // Phong on its support is exactly 1.0625 n: from 1.0125 the one digit that helps is the third.
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
        let problem = Problem::new(case, 16, 1024).unwrap();
        let printed = Line::new("1.0125", "0", "2").unwrap();
        let found = nearest(&problem, &printed, 1e-6).unwrap();
        assert_eq!((found.line.a(), found.changed), ("1.0625", 1));
        assert!(nearest(&problem, &Line::new("9", "0", "2").unwrap(), 1e-9).is_none());
    }
}
