//! The figures in the report's text: each once, at the claim that it belongs to or in its section.

use super::figures::{Figure, Shown, data};
use super::source::{REPRODUCE, link};
use crate::paper::ClaimsFile;
use std::collections::BTreeMap;

/// The figures, and the claims at which they stand.
pub(super) struct Plots<'a> {
    figures: &'a [Figure],
    homes: BTreeMap<&'static str, &'a str>,
    /// A claim's other figures, which stand elsewhere.
    others: BTreeMap<&'a str, Vec<&'static str>>,
}

impl<'a> Plots<'a> {
    /// Gives each figure to the first claim whose kind it shows.
    pub(super) fn new(figures: &'a [Figure], claims: &'a ClaimsFile) -> Self {
        let mut homes: BTreeMap<&'static str, &'a str> = BTreeMap::new();
        let mut others: BTreeMap<&'a str, Vec<&'static str>> = BTreeMap::new();
        for claim in &claims.claims {
            for reading in &claim.readings {
                let Shown { own, see } = Shown::of(&reading.kind);
                for stem in &own {
                    homes.entry(stem).or_insert(&claim.id);
                }
                let listed = others.entry(&claim.id).or_default();
                for stem in own.into_iter().chain(see) {
                    if !listed.contains(&stem) {
                        listed.push(stem);
                    }
                }
            }
        }
        Plots { figures, homes, others }
    }

    /// A claim's own figures, then where its others stand.
    pub(super) fn of_claim(&self, claim: &str) -> String {
        let own = self.figures.iter().filter(|figure| self.homes.get(figure.stem) == Some(&claim));
        let mut text: String = own.map(show).collect();
        let empty = Vec::new();
        let others = self.others.get(claim).unwrap_or(&empty);
        let elsewhere: Vec<&str> =
            others.iter().copied().filter(|stem| self.homes.get(stem) != Some(&claim)).collect();
        text.push_str(&self.see(&elsewhere));
        text
    }

    /// These figures, but for those that stand at a claim: of them where.
    pub(super) fn place(&self, stems: &[&str]) -> String {
        let free = |stem: &str| !self.homes.contains_key(stem);
        let here = self.figures.iter().filter(|figure| stems.contains(&figure.stem) && free(figure.stem));
        let mut text: String = here.map(show).collect();
        let elsewhere: Vec<&str> = stems.iter().copied().filter(|stem| !free(stem)).collect();
        text.push_str(&self.see(&elsewhere));
        text
    }

    /// A line that leads to figures that stand at claims.
    fn see(&self, stems: &[&str]) -> String {
        let mut claims: Vec<&str> = Vec::new();
        for stem in stems {
            if let Some(home) = self.homes.get(stem)
                && !claims.contains(home)
            {
                claims.push(home);
            }
        }
        let links: Vec<String> =
            claims.iter().map(|id| format!("[{id}](#{})", super::anchor::anchor(id))).collect();
        match links.as_slice() {
            [] => String::new(),
            [one] => format!("\nThe plot stands at {one}.\n"),
            all => format!("\nThe plots stand at {}.\n", all.join(", ")),
        }
    }
}

/// A figure with its source line.
fn show(figure: &Figure) -> String {
    let Figure { stem, alt, .. } = figure;
    let files: Vec<String> = data(stem).iter().map(|path| link(path)).collect();
    format!(
        "\n![{alt}](plots/{stem}.png)\n\n*Source:* {}; this plot as [SVG](plots/{stem}.svg) and \
         [PNG](plots/{stem}.png); remade by `{REPRODUCE}`.\n",
        files.join(", ")
    )
}
