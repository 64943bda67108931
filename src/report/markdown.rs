//! `reports/report.md`, of which `reports/report.html` is made: the verdicts first, then what they rest on.

use super::better;
use super::claim_section;
use super::cut;
use super::digest;
use super::energy;
use super::figures::Figure;
use super::filter_section;
use super::index;
use super::instead;
use super::introduction::{INTRODUCTION, READING};
use super::measured::Measured;
use super::plots::Plots;
use super::source::source;
use super::stability_section;
use super::study::Study;
use super::table_section;
use super::trade_section;
use std::fmt::Write;

/// The whole report; `paths` are the files that its last section lists.
pub(super) fn report(study: &Study, figures: &[Figure], measured: &Measured, paths: &[&str]) -> String {
    let plots = Plots::new(figures, &study.claims);
    let mut text = String::from(INTRODUCTION);
    text.push_str(
        "\n## The verdicts in short\n\nWhat each word means stands [below](#how-to-read-the-verdicts); each claim leads to its readings, \
         proof, witness and plot.\n",
    );
    digest::section(study, &mut text);
    instead::section(study, &mut text);
    let _ = write!(text, "\n### Is cr_n ≈ √(6/n)?\n\n{}", cut::answer(study));
    text.push_str(&source(&["reports/verdicts.csv"]));
    text.push_str("\nWhat either does to the integrals stands in [a table](#what-each-limit-keeps).\n");
    text.push_str(READING);
    claim_section::sections(study, &plots, &mut text);
    table_section::section(study, &plots, &mut text);
    better::sections(study, &plots, &mut text);
    energy::section(study, &plots, &mut text);
    filter_section::section(&study.filters, &mut text);
    stability_section::section(&study.stability, &plots, &mut text);
    trade_section::section(measured, &mut text);
    index::section(paths, figures, &mut text);
    text
}
