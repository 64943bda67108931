//! Statements that least squares gives certain digits.

use super::judge::Judge;
use super::judgement::{Finding, Verdict};
use crate::bound::enclose;
use crate::fit::{CertifiedFit, FitError, Form, Objective, Problem, certified_least_squares};
use crate::integral::Case;
use crate::paper::Printed;
use dashu_ratio::RBig;

impl Judge {
    pub(super) fn fit(
        &mut self,
        case: Case,
        (objective, form): (Objective, Form),
        n: (u32, u32),
        (a, b): (&Printed, Option<&Printed>),
    ) -> Result<Finding, FitError> {
        let problem = Problem::new(case, n.0, n.1)?;
        let fit = certified_least_squares(&problem, objective, form)?;
        let CertifiedFit { a: a_ends, b: b_ends } = &fit;
        let of_b = b.map_or(Verdict::Proved, |b| against(b_ends, b));
        let verdict = match (against(a_ends, a), of_b) {
            (Verdict::Proved, Verdict::Proved) => Verdict::Proved,
            (Verdict::Refuted, _) | (_, Verdict::Refuted) => Verdict::Refuted,
            _ => Verdict::Undecided,
        };
        let middle = |(lo, hi): &(RBig, RBig)| enclose(lo).hull(enclose(hi)).mid();
        let mut witness = format!("a = {:.6}", middle(a_ends));
        if (middle(a_ends) - middle(&(a.lowest.clone(), a.lowest.clone()))).abs() < 1e-9 {
            let side = match (a_ends.0 == a.lowest, a_ends.1 < a.lowest) {
                (true, _) => "exactly at",
                (_, true) => "just below",
                _ => "just above",
            };
            witness = format!("a is {side} the tie {}", middle(a_ends));
        }
        if b.is_some() {
            witness = format!("{witness}, b = {:.4}", middle(b_ends));
        }
        let printed = b.map_or_else(|| a.text.clone(), |b| format!("{}; {}", a.text, b.text));
        let computed = Some(enclose(&a_ends.0).hull(enclose(&a_ends.1)));
        Ok(Finding { printed, computed, verdict, witness })
    }
}

fn against((lo, hi): &(RBig, RBig), printed: &Printed) -> Verdict {
    if *lo >= printed.lowest && *hi <= printed.highest {
        Verdict::Proved
    } else if *hi < printed.lowest || *lo > printed.highest {
        Verdict::Refuted
    } else {
        Verdict::Undecided
    }
}
