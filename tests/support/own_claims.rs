//! Readings of one's own constants: files of them, and what they come to.
#![allow(dead_code)] // every test file takes what it needs

use bellfit::paper::ClaimsFile;
use bellfit::verdict::{Judge, Judgement, NormalisationFinding};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// A file with one claim of these readings, each without its id.
pub fn file(readings: &[String]) -> String {
    let numbered = readings.iter().enumerate();
    let readings =
        numbered.map(|(i, r)| format!("[[claim.reading]]\nid = \"r{i}\"\nkind = \"normalisation\"\n{r}\n"));
    let head =
        "version = 1\n[[claim]]\nid = \"mine\"\npaper = \"π\"\nlocator = \"line 1\"\ntext = \"as printed\"\n";
    head.to_owned() + &readings.collect::<String>()
}

pub fn judge(readings: &[String]) -> Vec<Judgement> {
    let text = file(readings);
    Judge::default().judge(&ClaimsFile::parse(&text).unwrap_or_else(|e| panic!("{e}\n{text}"))).unwrap()
}

pub fn one(reading: &str) -> Judgement {
    judge(&[reading.to_owned()]).remove(0)
}

pub fn parts(judgement: &Judgement) -> &NormalisationFinding {
    judgement.normalisation.as_ref().unwrap()
}

/// Always the same cases.
pub fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

/// The exact factors of cosⁿ: Table 1 of the lobe paper, whose integrals are elementary.
pub const EXACT: [(&str, &str); 6] = [
    ("phong", "(n + 1)/(2*pi)"),
    ("phong-modified", "(n + 2)/(2*pi)"),
    ("blinn-phong", "(n + 2)/(4*pi*(2 - 2^(-n/2)))"),
    ("blinn-phong-modified", "(n + 2)*(n + 4)/(8*pi*(2^(-n/2) + n))"),
    ("blinn-phong-ndf", "(n + 1)/(2*pi)"),
    ("blinn-phong-heightfield", "(n + 2)/(2*pi)"),
];
