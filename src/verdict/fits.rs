//! Statements that least squares gives certain digits.

use super::judge::Judge;
use super::judgement::{Finding, Verdict};
use crate::bound::enclose;
use crate::fit::{
    CertifiedFit, FitError, Form, Objective, Problem, certified_least_squares, scaled_integrals,
};
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
        let scaled = self.scaled.entry((case, n)).or_insert_with(|| scaled_integrals(&problem));
        let fit = certified_least_squares(&problem, scaled, objective, form)?;
        let CertifiedFit { a: a_ends, b: b_ends } = &fit;
        let of_b = b.map_or(Verdict::Proved, |b| against(b_ends, b));
        let verdict = match (against(a_ends, a), of_b) {
            (Verdict::Proved, Verdict::Proved) => Verdict::Proved,
            (Verdict::Refuted, _) | (_, Verdict::Refuted) => Verdict::Refuted,
            _ => Verdict::Undecided,
        };
        let mut witness = against_text("a", a_ends, a);
        if let Some(b) = b {
            witness = format!("{witness}, {}", against_text("b", b_ends, b));
        }
        let printed = b.map_or_else(|| a.text.clone(), |b| format!("{}; {}", a.text, b.text));
        let computed = Some(enclose(&a_ends.0).hull(enclose(&a_ends.1)));
        Ok(Finding { printed, computed, verdict, witness })
    }
}

/// "a = 1.066377 (printed 1.068: no)", or on which side of the printed digits' tie it lies.
fn against_text(name: &str, ends: &(RBig, RBig), printed: &Printed) -> String {
    let middle = |(lo, hi): &(RBig, RBig)| enclose(lo).hull(enclose(hi)).mid();
    let word = if against(ends, printed) == Verdict::Proved { "yes" } else { "no" };
    let text = &printed.text;
    for tie in [&printed.lowest, &printed.highest] {
        let at = middle(&((*tie).clone(), (*tie).clone()));
        if (middle(ends) - at).abs() < 1e-9 {
            let side = if ends.1 < *tie {
                "just below"
            } else if ends.0 > *tie {
                "just above"
            } else {
                "exactly at"
            };
            return format!("{name} is {side} the tie {at} (printed {text}: {word})");
        }
    }
    format!("{name} = {:.6} (printed {text}: {word})", middle(ends))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::decimal;

    /// 1.063 is printed for what lies from 1.0625 to 1.0635.
    #[test]
    fn digits_are_judged_and_ties_are_told() {
        let printed = Printed::parse("1.063").unwrap();
        let of = |lo: &str, hi: &str| (decimal(lo).unwrap().0, decimal(hi).unwrap().0);
        let (below, above) = ("1.062499999999", "1.062500000001");
        for (lo, hi, verdict, text) in [
            (below, below, Verdict::Refuted, "a is just below the tie 1.0625 (printed 1.063: no)"),
            ("1.0625", "1.0625", Verdict::Proved, "a is exactly at the tie 1.0625 (printed 1.063: yes)"),
            (above, above, Verdict::Proved, "a is just above the tie 1.0625 (printed 1.063: yes)"),
            (below, above, Verdict::Undecided, "a is exactly at the tie 1.0625 (printed 1.063: no)"),
            ("1.0635", "1.0635", Verdict::Proved, "a is exactly at the tie 1.0635 (printed 1.063: yes)"),
            ("1.07", "1.07", Verdict::Refuted, "a = 1.070000 (printed 1.063: no)"),
            ("1.06", "1.06", Verdict::Refuted, "a = 1.060000 (printed 1.063: no)"),
            ("1.06", "1.07", Verdict::Undecided, "a = 1.065000 (printed 1.063: no)"),
        ] {
            let ends = of(lo, hi);
            assert_eq!(against(&ends, &printed), verdict, "{lo}..{hi}");
            assert_eq!(against_text("a", &ends, &printed), text, "{lo}..{hi}");
        }
    }
}
