//! Statements about 2π coef(n) Int(n) - 1.

use super::judge::Judge;
use super::judgement::{Finding, Verdict, compare};
use crate::bound::{Extreme, Extremes, Formula, Residual};
use crate::integral::Case;
use crate::paper::{Over, Printed, Relation, Statistic};

impl Judge {
    /// The extremes, computed once for all readings that ask for them.
    pub(super) fn extremes(&mut self, case: Case, factor: &Formula, n: (u32, u32), over: Over) -> Extremes {
        let known = self.residuals.iter().find(|r| r.0 == case && r.1 == *factor && r.2 == n && r.3 == over);
        if let Some((.., extremes)) = known {
            return *extremes;
        }
        let residual = Residual::new(case, factor);
        let extremes = match over {
            Over::Integers => residual.over_integers(n.0, n.1),
            Over::Reals => residual.over_reals(f64::from(n.0), f64::from(n.1)),
        };
        self.residuals.push((case, factor.clone(), n, over, extremes));
        extremes
    }

    pub(super) fn factor_residual(
        &mut self,
        of: (Case, &Formula, (u32, u32), Over),
        statistic: Statistic,
        relation: Relation,
        printed: Option<&Printed>,
    ) -> Finding {
        let extremes = self.extremes(of.0, of.1, of.2, of.3);
        let Extreme { value, n } = match statistic {
            Statistic::Max => extremes.max,
            Statistic::Min => extremes.min,
            Statistic::MaxAbs => extremes.magnitude(),
        };
        Finding {
            printed: printed.map(|p| p.text.clone()).unwrap_or_default(),
            computed: Some(value),
            verdict: printed.map_or(Verdict::Definition, |p| compare(value, p, relation)),
            witness: format!("n = {}", exponent(n)),
        }
    }

    pub(super) fn energy(&mut self, case: Case, factor: &Formula, n: (u32, u32), over: Over) -> Finding {
        let Extreme { value, n } = self.extremes(case, factor, n, over).max;
        let (verdict, what) = if value.hi() <= 0.0 {
            (Verdict::Proved, "2π coef Int - 1 is at most")
        } else if value.lo() > 0.0 {
            (Verdict::Refuted, "gains energy: 2π coef Int - 1 reaches")
        } else {
            (Verdict::Undecided, "2π coef Int - 1 reaches up to")
        };
        Finding {
            printed: String::new(),
            computed: Some(value),
            verdict,
            witness: format!("{what} {:.4e}, at n = {}", value.mid(), exponent(n)),
        }
    }
}

/// n where an extreme was found: one of few decimals as it is, for it is an end of the range, any other in
/// three digits, since where a smooth extreme lies is known to the root only of how well its value is.
pub(super) fn exponent(n: f64) -> String {
    let text = n.to_string();
    match text.split_once('.') {
        Some((_, decimals)) if decimals.len() > 2 => format!("{n:.*}", usize::from(n < 100.0)),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_a_range_stand_as_they_are_and_found_places_in_three_digits() {
        for (n, text) in
            [(16.0, "16"), (2.25, "2.25"), (32.271_33, "32.3"), (207.391, "207"), (1024.5, "1024.5")]
        {
            assert_eq!(exponent(n), text);
        }
    }
}
