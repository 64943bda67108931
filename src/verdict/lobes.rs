//! Statements about cosⁿ, cs_16, its cut, and Gaussians.

use super::judge::Judge;
use super::judgement::{Finding, Verdict, compare};
use super::minimum::prove_minimum;
use super::residuals::exponent;
use crate::bound::{
    DifferenceExtreme, Gaussian, Interval, bell_distance, cut_effect, cut_numerator, difference_infimum,
    difference_supremum, enclose, gaussian_distance,
};
use crate::integral::Limit;
use crate::paper::{Comparison, CutForm, Printed, Relation, Statistic};

/// Suprema are enclosed to this, four digits of the smallest number printed about them.
const TOLERANCE: f64 = 1e-7;

pub(super) fn range(n: (u32, u32)) -> Interval {
    Interval::new(f64::from(n.0), f64::from(n.1))
}

impl Judge {
    /// sup Δ over the range, computed once a cut.
    pub(super) fn difference(&mut self, cut: Limit, n: (u32, u32)) -> DifferenceExtreme {
        *self.differences.entry((cut, n)).or_insert_with(|| difference_supremum(cut, range(n), TOLERANCE))
    }

    fn gaussian(&mut self, kind: Gaussian, n: (u32, u32)) -> (Interval, f64) {
        *self.gaussians.entry((kind, n)).or_insert_with(|| {
            // Relative to 1/n, which the distance is proportional to.
            let found = gaussian_distance(kind, range(n), 1e-5 / f64::from(n.0));
            (found.value, 1.0 / found.at[0])
        })
    }

    pub(super) fn lobe_difference(
        &mut self,
        cut: Limit,
        n: (u32, u32),
        statistic: Statistic,
        relation: Relation,
        printed: &Printed,
    ) -> Finding {
        if statistic == Statistic::Min {
            return self.minimum(cut, n, relation, printed);
        }
        let found = self.difference(cut, n);
        let place = if found.beyond_cut {
            format!("not attained: θ → cr+ = {:.4}, n = {}", found.theta(), exponent(found.n))
        } else {
            format!("n = {}, θ = {:.4} (t = {:.3})", exponent(found.n), found.theta(), found.t)
        };
        Finding {
            printed: printed.text.clone(),
            computed: Some(found.value),
            verdict: compare(found.value, printed, relation),
            witness: place,
        }
    }

    fn minimum(&mut self, cut: Limit, n: (u32, u32), relation: Relation, printed: &Printed) -> Finding {
        let proof = prove_minimum(cut, n.0, n.1);
        let text = printed.text.clone();
        if !proof.holds {
            let witness = proof.steps.join("; ");
            return Finding { printed: text, computed: None, verdict: Verdict::Undecided, witness };
        }
        let zero = Interval::from(0.0);
        let elsewhere = self.below_16.entry(text.clone()).or_insert_with(|| below_16(printed));
        Finding {
            printed: text,
            computed: Some(zero),
            verdict: compare(zero, printed, relation),
            witness: format!("Δ ≥ 0 for every real n ≥ 16 (Bernoulli), and Δ(n, 0) = 0; {elsewhere}"),
        }
    }

    pub(super) fn cut_effect(&mut self, cut: Limit, n: (u32, u32), comparison: Comparison) -> Finding {
        let exact = self.difference(Limit::ExactZero, n);
        if comparison == Comparison::EachN {
            // At n = 16 (1) is cos^16 θ itself, so Δ with the exact cut is 0 for every θ.
            let effect = cut_effect(cut, Interval::from(f64::from(n.0)), 1e-30);
            let decided = n.0 == 16 && effect.value.lo() > 0.0;
            return Finding {
                printed: String::new(),
                computed: Some(effect.value),
                verdict: if decided { Verdict::Refuted } else { Verdict::Undecided },
                witness: format!(
                    "n = 16: (1) is cos^16 θ itself, Δ = 0 at every θ with the exact cut, and {:.1e} is cut off by this one",
                    effect.value.hi()
                ),
            };
        }
        let effect = cut_effect(cut, range(n), 1e-9);
        let scale = Interval::from(if comparison == Comparison::Tenth { 10.0 } else { 1.0 });
        let scaled = effect.value * scale;
        let verdict = if scaled.hi() < exact.value.lo() {
            Verdict::Proved
        } else if scaled.lo() >= exact.value.hi() {
            Verdict::Refuted
        } else {
            Verdict::Undecided
        };
        let witness = format!(
            "the cut changes Δ by up to {:.3e} (n = {}), and sup |Δ| is {:.4e}",
            effect.value.hi(),
            exponent(effect.n),
            exact.value.hi()
        );
        Finding { printed: String::new(), computed: Some(effect.value), verdict, witness }
    }

    pub(super) fn gaussian_falls(&mut self, kind: Gaussian, n: (u32, u32)) -> Finding {
        // Pointwise in the scaled angle the distance falls with n for every real n (bound::gaussian);
        // the enclosures at doublings make sure of it.
        let mut at = n.0;
        let mut values: Vec<(u32, Interval)> = Vec::new();
        while at <= n.1 {
            values.push((at, self.gaussian(kind, (at, at)).0));
            at *= 2;
        }
        let falls = values.windows(2).all(|w| w[1].1.hi() < w[0].1.lo());
        let list: Vec<String> = values.iter().map(|(n, v)| format!("{:.3e} at {n}", v.hi())).collect();
        let computed = values.first().map(|(_, v)| *v);
        Finding::truth(
            falls,
            computed,
            format!("sup over θ of |cosⁿθ - {}|: {}", kind.formula(), list.join(", ")),
        )
    }

    pub(super) fn gaussian_beats_lobe(&mut self, kind: Gaussian, n: (u32, u32)) -> Finding {
        let (gauss, at) = self.gaussian(kind, n);
        let lobe = self.difference(Limit::ExactZero, n);
        let verdict = if gauss.hi() < lobe.value.lo() {
            Verdict::Proved
        } else if gauss.lo() >= lobe.value.hi() {
            Verdict::Refuted
        } else {
            Verdict::Undecided
        };
        let witness = format!(
            "sup |cosⁿθ - {}| = {:.4e} at n = {}, sup |cosⁿθ - cs_16| = {:.4e} at n = {}",
            kind.formula(),
            gauss.hi(),
            exponent(at),
            lobe.value.hi(),
            exponent(lobe.n)
        );
        Finding { printed: String::new(), computed: Some(gauss), verdict, witness }
    }
}

/// The smallest power's error first.
pub(super) fn bell_falls(powers: &[u32]) -> Finding {
    let values: Vec<_> = powers.iter().map(|&k| (k, bell_distance(k, 1e-8))).collect();
    let falls = values.windows(2).all(|w| w[1].1.value.hi() < w[0].1.value.lo());
    let list: Vec<String> =
        values.iter().map(|(k, v)| format!("K = {k}: {:.4e} at t = {:.3}", v.value.hi(), v.at[0])).collect();
    let computed = values.first().map(|(_, v)| v.value);
    Finding::truth(falls, computed, format!("sup over t ≥ 0 of |e^-t - (1 - t/K)^K|: {}", list.join(", ")))
}

/// c or c² with which the approximate cut would be exact, over the range.
pub(super) fn cut(form: CutForm, n: (u32, u32), printed: &Printed) -> Finding {
    // √n · cr falls in n (bound::cut_numerator), so the ends of the range are its extremes.
    let (first, last) = (cut_numerator(f64::from(n.0)), cut_numerator(f64::from(n.1)));
    let (first, last) = match form {
        CutForm::OverRoot => (first, last),
        CutForm::RootOver => (first * first, last * last),
    };
    let ends = [compare(first, printed, Relation::Equal), compare(last, printed, Relation::Equal)];
    let verdict = if ends.contains(&Verdict::Refuted) {
        Verdict::Refuted
    } else if ends == [Verdict::Proved; 2] {
        Verdict::Proved
    } else {
        Verdict::Undecided
    };
    let name = match form {
        CutForm::OverRoot => "c in c/√n",
        CutForm::RootOver => "c in √(c/n)",
    };
    Finding {
        printed: printed.text.clone(),
        computed: Some(first.hull(last)),
        verdict,
        witness: format!(
            "the {name} that meets arccos((n - 16)/n) runs from {:.4} at n = {} to {:.4} at n = {}",
            first.mid(),
            n.0,
            last.mid(),
            n.1
        ),
    }
}

/// For which n < 16 the printed minimum does occur. At fixed t cosⁿθ rises with n, so the minimum
/// rises with n; the crossings are bisected and then certified from both sides.
fn below_16(printed: &Printed) -> String {
    // Rounded outward: an end of the interval that encloses each exact end.
    let (lowest, highest) = (enclose(&printed.lowest).lo(), enclose(&printed.highest).hi());
    let least = |n: f64| difference_infimum(n, TOLERANCE).value;
    let crossing = |target: f64| {
        let (mut low, mut high) = (2.0_f64, 16.0_f64);
        for _ in 0..14 {
            let mid = 0.5 * (low + high);
            if least(mid).mid() < target { low = mid } else { high = mid }
        }
        low
    };
    // 14 halvings leave a thousandth; two of them outward move the minimum by far more than the
    // enclosures' width.
    let (from, to) = (crossing(lowest) - 2e-3, crossing(highest) + 2e-3);
    if least(from).hi() >= lowest || least(to).lo() <= highest {
        return "below 16 the printed value was not located".to_owned();
    }
    let whole = (libm::ceil(from) as i64..=libm::floor(to) as i64).count();
    format!(
        "the printed value occurs for n in [{from:.2}, {to:.2}] only, below the range, which holds {} whole number{} \
         (n = 10 gives {:.3e}, n = 11 {:.3e})",
        if whole == 0 { "no".to_owned() } else { whole.to_string() },
        if whole == 1 { "" } else { "s" },
        least(10.0).mid(),
        least(11.0).mid()
    )
}
