//! The verdict table in README.md, spliced in between its markers.

use super::artifacts::ArtifactError;
use super::study::Study;
use super::summary::{Group, summaries};
use crate::verdict::Verdict;

const BEGIN: &str = "<!-- verdicts: begin (written by `bellfit`, do not edit) -->";
const END: &str = "<!-- verdicts: end -->";

/// One row a claim: its text, its verdict, and the reasons, without the vacuous ones.
pub(super) fn table(study: &Study) -> String {
    let mut text = String::from("| claim | as stated | verdict | why |\n|---|---|---|---|\n");
    for summary in summaries(study) {
        let telling = |g: &&Group| !g.vacuous;
        let of = |verdict| summary.groups.iter().filter(telling).find(|g| g.verdict == verdict);
        let reasons: Vec<String> = if summary.groups.iter().all(|g| g.verdict == Verdict::Definition) {
            summary.groups.iter().map(|g| g.reason.to_owned()).collect()
        } else {
            [(Verdict::Proved, "holds"), (Verdict::Refuted, "fails")]
                .into_iter()
                .filter_map(|(verdict, word)| of(verdict).map(|g| format!("{word}: {}", g.reason)))
                .collect()
        };
        text.push_str(&format!(
            "| {} | {} | {} | {} |\n",
            summary.claim.id,
            cell(&summary.claim.text),
            summary.verdict(),
            cell(&reasons.join("; "))
        ));
    }
    text
}

/// Markdown table cells know no bars and no line breaks.
pub(super) fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// Whether this README asks for the table.
pub(super) fn wants_table(text: &str) -> bool {
    text.contains(BEGIN)
}

/// `text` with what stands between the markers replaced.
pub(super) fn splice(text: &str, table: &str) -> Result<String, ArtifactError> {
    let lost = |marker: &str| ArtifactError::Readme(format!("the marker {marker} is missing"));
    let begin = text.find(BEGIN).ok_or_else(|| lost(BEGIN))? + BEGIN.len();
    let end = begin + text[begin..].find(END).ok_or_else(|| lost(END))?;
    Ok(format!("{}\n\n{table}\n{}", &text[..begin], &text[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let before = format!("head\n{BEGIN}\nold\n{END}\ntail\n");
        let after = splice(&before, "| new |\n").unwrap();
        assert_eq!(after, format!("head\n{BEGIN}\n\n| new |\n\n{END}\ntail\n"));
        assert_eq!(splice(&after, "| new |\n").unwrap(), after);
        assert!(splice("no markers", "x").is_err());
        assert!(splice(&format!("{END} {BEGIN}"), "x").is_err());
    }
}
