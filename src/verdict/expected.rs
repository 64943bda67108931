//! The verdicts the papers' claims are expected to get, with the reason for each: a run fails if
//! any changes, a refuted one that passes included.

use super::{Judgement, Verdict};
use serde::Deserialize;
use std::collections::BTreeMap;
use thiserror::Error;

/// The expected verdicts of the lobe paper's claims.
pub const EXPECTED: &str = include_str!("expected.toml");

/// The expected verdicts of the pixel paper's claims.
pub const EXPECTED_PIXEL: &str = include_str!("expected-pixel.toml");

/// What is wrong between expectations and judgements.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ExpectedError {
    /// The file cannot be read.
    #[error("expected verdicts: {0}")]
    Unreadable(String),
    /// Two entries for one reading.
    #[error("expected verdicts: {0}, {1} stands twice")]
    Doubled(String, String),
    /// A reading without an expectation.
    #[error("{claim}, {reading}: {verdict}, and no verdict is expected")]
    Unexpected {
        /// The claim.
        claim: String,
        /// The reading.
        reading: String,
        /// What it got.
        verdict: &'static str,
    },
    /// An expectation without a reading.
    #[error("{claim}, {reading}: a verdict is expected and there is no such reading")]
    Absent {
        /// The claim.
        claim: String,
        /// The reading.
        reading: String,
    },
    /// Another verdict than expected.
    #[error("{claim}, {reading}: {verdict} where {expected} is expected ({reason})")]
    Differs {
        /// The claim.
        claim: String,
        /// The reading.
        reading: String,
        /// What it got.
        verdict: &'static str,
        /// What it should get.
        expected: &'static str,
        /// Why.
        reason: String,
    },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile {
    version: u32,
    expect: Vec<RawExpect>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawExpect {
    claim: String,
    verdict: Verdict,
    reason: String,
    #[serde(default)]
    vacuous: bool,
    readings: Vec<String>,
}

/// One expected verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expectation {
    /// Which verdict.
    pub verdict: Verdict,
    /// Why.
    pub reason: String,
    /// Whether it holds for want of anything to fail it, as a negative number is below a bound on
    /// its size.
    pub vacuous: bool,
}

/// Expected verdicts by claim and reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expectations {
    by_reading: BTreeMap<(String, String), Expectation>,
}

impl Expectations {
    /// Those of both papers.
    ///
    /// # Errors
    /// [`ExpectedError`] as for [`Expectations::parse`], and for a reading in both files.
    pub fn papers() -> Result<Self, ExpectedError> {
        let mut all = Self::parse(EXPECTED)?;
        for (key, expectation) in Self::parse(EXPECTED_PIXEL)?.by_reading {
            if all.by_reading.contains_key(&key) {
                return Err(ExpectedError::Doubled(key.0, key.1));
            }
            all.by_reading.insert(key, expectation);
        }
        Ok(all)
    }

    /// Reads the file.
    ///
    /// # Errors
    /// [`ExpectedError`] if it is unreadable, of another version, or names a reading twice.
    pub fn parse(text: &str) -> Result<Self, ExpectedError> {
        let raw: RawFile =
            toml::from_str(text).map_err(|e| ExpectedError::Unreadable(e.message().to_owned()))?;
        if raw.version != 1 {
            return Err(ExpectedError::Unreadable(format!("version {}: this program reads 1", raw.version)));
        }
        let mut by_reading = BTreeMap::new();
        for RawExpect { claim, verdict, reason, vacuous, readings } in raw.expect {
            for reading in readings {
                let expectation = Expectation { verdict, reason: reason.clone(), vacuous };
                if by_reading.insert((claim.clone(), reading.clone()), expectation).is_some() {
                    return Err(ExpectedError::Doubled(claim, reading));
                }
            }
        }
        Ok(Expectations { by_reading })
    }

    /// What one reading is expected to get.
    pub fn of(&self, judgement: &Judgement) -> Option<&Expectation> {
        self.by_reading.get(&(judgement.claim.clone(), judgement.reading.clone()))
    }

    /// Everything in which judgements and expectations differ, empty when all is as expected.
    pub fn differences(&self, judgements: &[Judgement]) -> Vec<ExpectedError> {
        let mut found = Vec::new();
        for judgement in judgements {
            let (claim, reading) = (judgement.claim.clone(), judgement.reading.clone());
            let verdict = judgement.verdict.id();
            match self.of(judgement) {
                None => found.push(ExpectedError::Unexpected { claim, reading, verdict }),
                Some(e) if e.verdict != judgement.verdict => found.push(ExpectedError::Differs {
                    claim,
                    reading,
                    verdict,
                    expected: e.verdict.id(),
                    reason: e.reason.clone(),
                }),
                Some(_) => {}
            }
        }
        for (claim, reading) in self.by_reading.keys() {
            if !judgements.iter().any(|j| j.claim == *claim && j.reading == *reading) {
                found.push(ExpectedError::Absent { claim: claim.clone(), reading: reading.clone() });
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const THREE: &str = r#"
version = 1
[[expect]]
claim = "a"
verdict = "proved"
reason = "by hand"
readings = ["one", "two"]
[[expect]]
claim = "b"
verdict = "refuted"
reason = "a witness"
readings = ["one"]
"#;

    fn judged(claim: &str, reading: &str, verdict: Verdict) -> Judgement {
        Judgement {
            claim: claim.into(),
            paper: String::new(),
            locator: String::new(),
            reading: reading.into(),
            kind: "",
            printed: String::new(),
            computed: None,
            evidence: None,
            verdict,
            witness: String::new(),
            normalisation: None,
        }
    }

    /// Each way to differ is told by claim and reading, and nothing else is.
    #[test]
    fn differences_are_told_one_by_one() {
        let expected = Expectations::parse(THREE).unwrap();
        let [one, two, other] = [("a", "one"), ("a", "two"), ("b", "one")];
        let as_expected = [
            judged(one.0, one.1, Verdict::Proved),
            judged(two.0, two.1, Verdict::Proved),
            judged(other.0, other.1, Verdict::Refuted),
        ];
        assert_eq!(expected.differences(&as_expected), []);
        let otherwise = [
            judged(one.0, one.1, Verdict::Undecided),
            judged(other.0, other.1, Verdict::Refuted),
            judged("c", "one", Verdict::Proved),
        ];
        assert_eq!(
            expected.differences(&otherwise),
            [
                ExpectedError::Differs {
                    claim: "a".into(),
                    reading: "one".into(),
                    verdict: "undecided",
                    expected: "proved",
                    reason: "by hand".into(),
                },
                ExpectedError::Unexpected { claim: "c".into(), reading: "one".into(), verdict: "proved" },
                ExpectedError::Absent { claim: "a".into(), reading: "two".into() },
            ]
        );
    }
}
