//! The minimum of Δ(n, θ) = cosⁿθ - cs_16(n, θ) is 0 for every real n ≥ 16, and how that is proved.
//!
//! With x = 1 - cos θ in [0, 1] and r = n/16:
//!
//! 1. r ≥ 1, as n ≥ 16.
//! 2. Bernoulli: (1 - x)^r ≥ 1 - r x. The difference g(x) is 0 at x = 0 and g'(x) =
//!    r (1 - (1 - x)^(r - 1)) ≥ 0, because (1 - x)^(r - 1) ≤ 1 for r ≥ 1.
//! 3. Up to the zero of (1) the right side is not negative, so its 16th power keeps the order:
//!    cosⁿθ = ((1 - x)^r)^16 ≥ (1 - r x)^16 = cs_16.
//! 4. A cut beyond the zero lets (r x - 1)^16 in. Between zero and cut (1 - x)^r falls and r x - 1
//!    rises, so it is enough that (1 - x)^r > r x - 1 at the cut, for every n: shown by branch and
//!    bound in 1/n. Behind the cut Δ = cosⁿθ ≥ 0.
//! 5. Δ(n, 0) = 1 - 1 = 0, so the minimum is 0, at θ = 0 for every n.

use crate::bound::{Interval, cos_n_range, cut_range, infimum, reciprocal};
use crate::integral::{Field, Limit};

/// The steps of the proof, as they were checked.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumProof {
    /// One line a step.
    pub steps: Vec<String>,
    /// Whether every step holds.
    pub holds: bool,
}

/// Checks every step for n in from..=to (every real n of it) and the given cut.
///
/// ```
/// use bellfit::{integral::Limit, verdict::prove_minimum};
/// assert!(prove_minimum(Limit::Paper, 16, 1024).holds);
/// assert!(!prove_minimum(Limit::Paper, 10, 1024).holds); // below 16 the lobe lies above cosⁿ
/// ```
pub fn prove_minimum(cut: Limit, from: u32, to: u32) -> MinimumProof {
    let mut proof = MinimumProof { steps: vec![], holds: true };
    let mut step = |holds: bool, text: String| {
        proof.holds &= holds;
        proof.steps.push(format!("{}: {text}", if holds { "holds" } else { "fails" }));
    };
    step(from >= 16, format!("r = n/16 ≥ 1 for n ≥ {from}"));
    if from < 16 {
        return proof;
    }
    let n = Interval::new(f64::from(from), f64::from(to));
    let m = reciprocal(n);
    // Any base in (0, 1] to any power from 0 to r - 1: e^(power · ln base) with a product ≤ 0, up to
    // the subnormal step by which rounding goes outward.
    let most = (n / Interval::from(16.0) - Interval::from(1.0)).hi();
    let product = Interval::new(0.0, most) * Interval::new(f64::MIN_POSITIVE, 1.0).ln();
    step(
        product.hi() <= f64::MIN_POSITIVE,
        "0 ≤ (1 - x)^(r - 1) ≤ 1 on [0, 1], so (1 - x)^r ≥ 1 - r x (Bernoulli)".to_owned(),
    );
    let zero = cut_range(Limit::ExactZero, m);
    step(
        zero.lo() >= 0.0 && zero.hi() <= 16.0,
        "up to the zero (t ≤ 16) both sides are ≥ 0 and keep their order under the 16th power".to_owned(),
    );
    let margin = |[m]: &[Interval; 1]| {
        let t = cut_range(cut, *m);
        let base = Interval::from(1.0) - t * *m;
        let base = Interval::new(base.lo().max(0.0), base.hi().max(0.0));
        let root = (base.ln() / (Interval::int(16) * *m)).exp();
        root - (t / Interval::int(16) - Interval::int(1))
    };
    // A cut at the zero or before it lets nothing rise again.
    let beyond = cut_range(cut, m).hi() <= 16.0 || infimum(margin, [m], 1e-3, 20_000).value.lo() > 0.0;
    step(beyond, format!("at the cut ({}) cosⁿθ exceeds what (1) has risen to, for every n", cut.id()));
    let at_0 = cos_n_range(Interval::from(0.0), m);
    step(at_0.contains(1.0) && at_0.width() < 1e-9, "Δ(n, 0) = 1 - 1 = 0".to_owned());
    proof
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cut_is_proved_from_16_on_and_none_below() {
        for cut in Limit::ALL {
            assert!(prove_minimum(cut, 16, 1024).holds, "{cut:?}");
            assert!(!prove_minimum(cut, 15, 1024).holds, "{cut:?}");
        }
    }

    /// Above n = 16 nothing is taken for granted that is shown at 16.
    #[test]
    fn every_step_is_taken_at_every_n() {
        for (from, to) in [(16, 16), (17, 1024), (64, 64)] {
            let proof = prove_minimum(Limit::Paper, from, to);
            assert!(proof.holds && proof.steps.len() == 5, "{from}..{to}: {proof:?}");
            assert!(proof.steps.iter().all(|step| step.starts_with("holds: ")), "{proof:?}");
        }
        let below = prove_minimum(Limit::Paper, 15, 1024);
        assert!(!below.holds && below.steps.len() == 1 && below.steps[0].starts_with("fails: "), "{below:?}");
    }
}
