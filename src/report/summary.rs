//! Verdicts gathered by claim: readings that share a verdict and its reason stand together.

use super::study::Study;
use crate::paper::Claim;
use crate::verdict::{Judgement, Verdict};

/// Readings of one claim with one verdict, for one reason.
pub(super) struct Group<'a> {
    pub verdict: Verdict,
    /// The expected verdict's reason; empty if another verdict was expected.
    pub reason: &'a str,
    /// Whether it holds for want of anything to fail it.
    pub vacuous: bool,
    pub members: Vec<&'a Judgement>,
}

/// A claim with its groups, in the order of its readings.
pub(super) struct Summary<'a> {
    pub claim: &'a Claim,
    pub groups: Vec<Group<'a>>,
}

impl Summary<'_> {
    /// How many readings have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.groups.iter().filter(|g| g.verdict == verdict).map(|g| g.members.len()).sum()
    }

    /// The claim's verdict in a word or two: which readings hold.
    pub fn verdict(&self) -> String {
        let proved = self.count(Verdict::Proved) + self.count(Verdict::Reproduced);
        let vacuous: usize = self.groups.iter().filter(|g| g.vacuous).map(|g| g.members.len()).sum();
        let refuted = self.count(Verdict::Refuted);
        let undecided = self.count(Verdict::Undecided);
        match (proved, refuted, undecided) {
            (0, 0, 0) => "definition".to_owned(),
            (_, 0, 0) => "holds".to_owned(),
            (0, _, 0) => "does not hold".to_owned(),
            (_, _, 0) if proved == vacuous => "does not hold but vacuously".to_owned(),
            (_, _, 0) => {
                let more = if vacuous == 0 { String::new() } else { format!(", {vacuous} more vacuously") };
                format!("holds under {} of {} readings{more}", proved - vacuous, proved + refuted)
            }
            _ => format!("{undecided} readings undecided"),
        }
    }
}

/// The pixel paper's name in its claims.
const PIXEL: &str = "pixel";

/// One summary a claim of the pixel paper, or of the lobe paper with the brief's.
pub(super) fn summaries_of(study: &Study, pixel: bool) -> Vec<Summary<'_>> {
    let of_paper = |summary: &Summary<'_>| (summary.claim.paper == PIXEL) == pixel;
    summaries(study).into_iter().filter(of_paper).collect()
}

/// One summary a claim.
pub(super) fn summaries(study: &Study) -> Vec<Summary<'_>> {
    study.claims.claims.iter().map(|claim| Summary { claim, groups: groups(study, claim) }).collect()
}

fn groups<'a>(study: &'a Study, claim: &Claim) -> Vec<Group<'a>> {
    let mut groups: Vec<Group<'a>> = Vec::new();
    for judgement in study.judgements.iter().filter(|j| j.claim == claim.id) {
        let expected = study.expectations.of(judgement).filter(|e| e.verdict == judgement.verdict);
        let reason = expected.map_or("", |e| e.reason.as_str());
        let vacuous = expected.is_some_and(|e| e.vacuous);
        match groups.iter_mut().find(|g| g.verdict == judgement.verdict && g.reason == reason) {
            Some(group) => group.members.push(judgement),
            None => {
                groups.push(Group { verdict: judgement.verdict, reason, vacuous, members: vec![judgement] })
            }
        }
    }
    groups
}
