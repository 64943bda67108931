//! The blocks of README.md that are generated, spliced in between their markers.

use super::artifacts::ArtifactError;
use super::better;
use super::cut;
use super::study::Study;
use super::summary::{Group, summaries_of};
use crate::verdict::Verdict;

/// The blocks a README may ask for.
const BLOCKS: [&str; 4] = ["verdicts", "kernels", "cut", "fails"];

/// The papers by the name in the table's head, and whether it is the one of pixels.
const PAPERS: [(&str, bool); 2] = [("lobe", false), ("pixel", true)];

fn begin(block: &str) -> String {
    format!("<!-- {block}: begin (written by `bellfit`, do not edit) -->")
}

fn end(block: &str) -> String {
    format!("<!-- {block}: end -->")
}

/// One row a claim: its text and its verdict.
fn table(study: &Study) -> String {
    let mut text = String::new();
    for (title, pixel) in PAPERS {
        text.push_str(&format!("| {title} | as stated | verdict |\n|---|---|---|\n"));
        for summary in summaries_of(study, pixel) {
            let verdict = summary.verdict();
            let word = if verdict.starts_with("does not") { format!("**{verdict}**") } else { verdict };
            text.push_str(&format!("| {} | {} | {word} |\n", summary.claim.id, cell(&summary.claim.text)));
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len() + 1);
    text
}

/// Of every claim with a reading that fails: why it fails, and why another holds; without the vacuous ones.
fn fails(study: &Study) -> String {
    let mut text = String::new();
    for (title, pixel) in PAPERS {
        text.push_str(&format!("The {title} paper:\n\n"));
        for summary in summaries_of(study, pixel) {
            let telling = |g: &&Group| !g.vacuous;
            let of = |verdict| summary.groups.iter().filter(telling).find(|g| g.verdict == verdict);
            let Some(refuted) = of(Verdict::Refuted) else { continue };
            let holds = of(Verdict::Proved).or_else(|| of(Verdict::Reproduced));
            let but = holds.map(|g| format!(" Another reading holds: {}.", g.reason)).unwrap_or_default();
            text.push_str(&format!("- **{}**: {}.{but}\n", summary.claim.id, refuted.reason));
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len() + 1);
    text
}

/// Markdown table cells know no bars and no line breaks.
pub(super) fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// `text` with every block it asks for written anew.
///
/// # Errors
/// If a block begins and does not end.
pub(super) fn splice_all(text: &str, study: &Study) -> Result<String, ArtifactError> {
    BLOCKS.into_iter().try_fold(text.to_owned(), |text, block| {
        let content = match block {
            "cut" => cut::cut(study),
            "kernels" => better::kernels(study),
            "fails" => fails(study),
            _ => table(study),
        };
        splice(&text, block, &content)
    })
}

/// `text` with what stands between the markers of `block` replaced; as it is if it has no such block.
fn splice(text: &str, block: &str, content: &str) -> Result<String, ArtifactError> {
    let (begin, end) = (begin(block), end(block));
    let Some(start) = text.find(&begin).map(|at| at + begin.len()) else {
        return Ok(text.to_owned());
    };
    let length = text[start..].find(&end);
    let stop = start + length.ok_or_else(|| ArtifactError::Readme(format!("the marker {end} is missing")))?;
    Ok(format!("{}\n\n{content}\n{}", &text[..start], &text[stop..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let (begin, end) = (begin("cut"), end("cut"));
        let before = format!("head\n{begin}\nold\n{end}\ntail\n");
        let after = splice(&before, "cut", "| new |\n").unwrap();
        assert_eq!(after, format!("head\n{begin}\n\n| new |\n\n{end}\ntail\n"));
        assert_eq!(splice(&after, "cut", "| new |\n").unwrap(), after);
        assert_eq!(splice("no markers", "cut", "x").unwrap(), "no markers");
        assert!(splice(&format!("{end} {begin}"), "cut", "x").is_err());
    }
}
