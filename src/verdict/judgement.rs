//! What came of one reading.

use super::NormalisationFinding;
use crate::bound::{Interval, exact};
use crate::paper::{Printed, Relation};
use dashu_ratio::RBig;
use serde::{Deserialize, Serialize};

/// What is known of one reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// A certified enclosure lies inside what the printed digits mean.
    Proved,
    /// The same, on weaker evidence.
    Reproduced,
    /// Disjoint from what is stated, with a witness.
    Refuted,
    /// The enclosure straddles an end of what the digits mean.
    Undecided,
    /// A convention or a figure: nothing to judge.
    Definition,
}

impl Verdict {
    /// The word in tables.
    pub const fn id(self) -> &'static str {
        match self {
            Verdict::Proved => "proved",
            Verdict::Reproduced => "reproduced",
            Verdict::Refuted => "refuted",
            Verdict::Undecided => "undecided",
            Verdict::Definition => "definition",
        }
    }
}

/// How strong the number behind a verdict is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Evidence {
    /// An enclosure or exact arithmetic proves it.
    Certified,
    /// Quadrature or an optimiser suggests it.
    Estimated,
}

impl Evidence {
    /// The word in tables.
    pub const fn id(self) -> &'static str {
        match self {
            Evidence::Certified => "certified",
            Evidence::Estimated => "estimated",
        }
    }
}

/// One reading, judged.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The claim's id.
    pub claim: String,
    /// Which paper.
    pub paper: String,
    /// Where in it.
    pub locator: String,
    /// The reading's id.
    pub reading: String,
    /// The name of its kind.
    pub kind: &'static str,
    /// The statement's number as printed, if there is one.
    pub printed: String,
    /// The computed enclosure, if the statement is about a number.
    pub computed: Option<Interval>,
    /// How strong it is; none for definitions.
    pub evidence: Option<Evidence>,
    /// The verdict.
    pub verdict: Verdict,
    /// The argument that decides it, or where a definition is regenerated.
    pub witness: String,
    /// For one's own constants: what each demand came to, and the nearest constants that would hold.
    pub normalisation: Option<Box<NormalisationFinding>>,
}

/// What a kind's judge hands back; the claim's own words are added around it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    pub printed: String,
    pub computed: Option<Interval>,
    pub verdict: Verdict,
    pub witness: String,
}

impl Finding {
    /// A statement that is true or false by exact arithmetic or proof.
    pub fn truth(holds: bool, computed: Option<Interval>, witness: String) -> Self {
        let verdict = if holds { Verdict::Proved } else { Verdict::Refuted };
        Finding { printed: String::new(), computed, verdict, witness }
    }

    /// A number that nobody states: nothing to judge.
    pub fn figure(computed: Interval, witness: String) -> Self {
        let verdict = Verdict::Definition;
        Finding { printed: String::new(), computed: Some(computed), verdict, witness }
    }
}

/// A certified enclosure against what is printed.
pub(super) fn compare(computed: Interval, printed: &Printed, relation: Relation) -> Verdict {
    // An infinite end bounds nothing on its side.
    let (lo, hi) = (exact(computed.lo()), exact(computed.hi()));
    let at_least = |bound: &RBig| lo.as_ref().is_some_and(|lo| lo >= bound);
    let above = |bound: &RBig| lo.as_ref().is_some_and(|lo| lo > bound);
    let at_most = |bound: &RBig| hi.as_ref().is_some_and(|hi| hi <= bound);
    let below = |bound: &RBig| hi.as_ref().is_some_and(|hi| hi < bound);
    let (inside, outside) = match relation {
        Relation::Equal => {
            let (lowest, highest) = (&printed.lowest, &printed.highest);
            (at_least(lowest) && at_most(highest), below(lowest) || above(highest))
        }
        Relation::AtMost => (at_most(&printed.value), above(&printed.value)),
    };
    match (inside, outside) {
        (true, _) => Verdict::Proved,
        (_, true) => Verdict::Refuted,
        _ => Verdict::Undecided,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_mean_what_rounds_to_them() {
        let printed = Printed::parse("1.7e-2").unwrap();
        let check = |lo, hi, relation| compare(Interval::new(lo, hi), &printed, relation);
        assert_eq!(check(0.01701, 0.01702, Relation::Equal), Verdict::Proved);
        assert_eq!(check(0.01701, 0.01702, Relation::AtMost), Verdict::Refuted);
        assert_eq!(check(0.0169, 0.01702, Relation::AtMost), Verdict::Undecided);
        assert_eq!(check(0.0174, 0.0176, Relation::Equal), Verdict::Undecided);
        assert_eq!(check(0.0176, 0.0177, Relation::Equal), Verdict::Refuted);
        assert_eq!(check(f64::NEG_INFINITY, 0.0, Relation::AtMost), Verdict::Proved);
        assert_eq!(check(1.0, f64::INFINITY, Relation::AtMost), Verdict::Refuted);
        assert_eq!(check(f64::NEG_INFINITY, f64::INFINITY, Relation::Equal), Verdict::Undecided);
    }
}
