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
        if comparison == Comparison::EachN {
            return self.cut_effect_at_each_n(cut, n);
        }
        let exact = self.difference(Limit::ExactZero, n);
        let effect = cut_effect(cut, range(n), 1e-9);
        let scale = Interval::from(if comparison == Comparison::Tenth { 10.0 } else { 1.0 });
        let witness = format!(
            "the cut changes Δ by up to {:.3e} (n = {}), and sup |Δ| is {:.4e}",
            effect.value.hi(),
            exponent(effect.n),
            exact.value.hi()
        );
        let verdict = below(effect.value * scale, exact.value);
        Finding { printed: String::new(), computed: Some(effect.value), verdict, witness }
    }

    /// sup Δ rises with n, as cosⁿθ does at fixed t: if the first n's exceeds the cut's effect at all n,
    /// every n's does; if it does not exceed the effect at that n, that n is the witness.
    fn cut_effect_at_each_n(&mut self, cut: Limit, n: (u32, u32)) -> Finding {
        let (first, from) = ((n.0, n.0), Interval::from(f64::from(n.0)));
        // At n = 16 (1) is cos^16 θ itself, so Δ with the exact cut is 0 for every θ.
        let exact =
            if n.0 == 16 { Interval::from(0.0) } else { self.difference(Limit::ExactZero, first).value };
        let (here, anywhere) = (cut_effect(cut, from, 1e-30).value, cut_effect(cut, range(n), 1e-9).value);
        let verdict = match (below(anywhere, exact), below(here, exact)) {
            (Verdict::Proved, _) => Verdict::Proved,
            (_, Verdict::Refuted) => Verdict::Refuted,
            _ => Verdict::Undecided,
        };
        let size = if n.0 == 16 { "0 at every θ".to_owned() } else { format!("up to {:.3e}", exact.hi()) };
        let effect = here.hi();
        let witness =
            format!("at n = {} Δ with the exact cut is {size}, and this cut changes it by {effect:.1e}", n.0);
        Finding { printed: String::new(), computed: Some(here), verdict, witness }
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
        let list: Vec<String> = values.iter().map(|(n, v)| format!("{:.3e} at {n}", v.hi())).collect();
        let values: Vec<Interval> = values.into_iter().map(|(_, v)| v).collect();
        falls(&values, format!("sup over θ of |cosⁿθ - {}|: {}", kind.formula(), list.join(", ")))
    }

    pub(super) fn gaussian_beats_lobe(&mut self, kind: Gaussian, n: (u32, u32)) -> Finding {
        let (gauss, at) = self.gaussian(kind, n);
        let lobe = self.difference(Limit::ExactZero, n);
        let verdict = below(gauss, lobe.value);
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

/// Whether what `smaller` encloses is below what `larger` does.
fn below(smaller: Interval, larger: Interval) -> Verdict {
    if smaller.hi() < larger.lo() {
        Verdict::Proved
    } else if smaller.lo() >= larger.hi() {
        Verdict::Refuted
    } else {
        Verdict::Undecided
    }
}

/// Whether each value is below the one before it.
fn falls(values: &[Interval], witness: String) -> Finding {
    let steps: Vec<Verdict> = values.windows(2).map(|pair| below(pair[1], pair[0])).collect();
    let verdict = if steps.contains(&Verdict::Refuted) {
        Verdict::Refuted
    } else if steps.contains(&Verdict::Undecided) {
        Verdict::Undecided
    } else {
        Verdict::Proved
    };
    Finding { printed: String::new(), computed: values.first().copied(), verdict, witness }
}

/// The smallest power's error first.
pub(super) fn bell_falls(powers: &[u32]) -> Finding {
    let values: Vec<_> = powers.iter().map(|&k| (k, bell_distance(k, 1e-8))).collect();
    let list: Vec<String> =
        values.iter().map(|(k, v)| format!("K = {k}: {:.4e} at t = {:.3}", v.value.hi(), v.at[0])).collect();
    let values: Vec<Interval> = values.into_iter().map(|(_, v)| v.value).collect();
    falls(&values, format!("sup over t ≥ 0 of |e^-t - (1 - t/K)^K|: {}", list.join(", ")))
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

/// For which n < 16 the printed minimum does occur. The minimum rises with n
/// (bound::difference_infimum); the crossings are bisected and then certified from both sides.
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
    // The whole numbers on either side of where it occurs.
    let (left, right) = (libm::ceil(from) - 1.0, libm::floor(to) + 1.0);
    format!(
        "the printed value occurs for n in [{from:.2}, {to:.2}] only, below the range, which holds {} whole number{} \
         (n = {left} gives {:.3e}, n = {right} {:.3e})",
        if whole == 0 { "no".to_owned() } else { whole.to_string() },
        if whole == 1 { "" } else { "s" },
        least(left).mid(),
        least(right).mid()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlap_decides_nothing() {
        let [low, middle, high] = [(0.0, 1.0), (0.5, 1.5), (2.0, 3.0)].map(|(a, b)| Interval::new(a, b));
        assert_eq!(below(low, high), Verdict::Proved);
        assert_eq!(below(high, low), Verdict::Refuted);
        assert_eq!(below(low, middle), Verdict::Undecided);
        let verdict = |values: &[Interval]| falls(values, String::new()).verdict;
        assert_eq!(verdict(&[high, middle]), Verdict::Proved);
        assert_eq!(verdict(&[high, middle, low]), Verdict::Undecided);
        assert_eq!(verdict(&[low, high, middle]), Verdict::Refuted);
    }

    /// From n = 32 on the error stands far above what 6/√n changes, and far below what √(6/n) does.
    #[test]
    fn a_cuts_effect_is_decided_at_each_n_where_the_range_starts_later() {
        let verdict = |cut| Judge::default().cut_effect(cut, (32, 1024), Comparison::EachN).verdict;
        assert_eq!(verdict(Limit::Paper), Verdict::Proved);
        assert_eq!(verdict(Limit::Card), Verdict::Refuted);
    }
}
