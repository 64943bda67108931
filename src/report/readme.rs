//! The blocks of README.md that are generated, spliced in between their markers.

use super::artifacts::ArtifactError;
use super::better;
use super::markdown;
use super::study::Study;
use super::summary::{Group, summaries_of};
use crate::verdict::Verdict;

/// The blocks a README may ask for.
const BLOCKS: [&str; 4] = ["cut", "verdicts", "kernels", "verdicts-pixel"];

fn begin(block: &str) -> String {
    format!("<!-- {block}: begin (written by `bellfit`, do not edit) -->")
}

fn end(block: &str) -> String {
    format!("<!-- {block}: end -->")
}

/// One row a claim: its text, its verdict, and the reasons, without the vacuous ones.
fn table(study: &Study, pixel: bool) -> String {
    let mut text = String::from("| claim | as stated | verdict | why |\n|---|---|---|---|\n");
    for summary in summaries_of(study, pixel) {
        let telling = |g: &&Group| !g.vacuous;
        let of = |verdict| summary.groups.iter().filter(telling).find(|g| g.verdict == verdict);
        let reasons: Vec<String> = if summary.groups.iter().all(|g| g.verdict == Verdict::Definition) {
            summary.groups.iter().map(|g| g.reason.to_owned()).collect()
        } else {
            [
                (Verdict::Proved, "holds"),
                (Verdict::Reproduced, "holds by quadrature"),
                (Verdict::Refuted, "fails"),
            ]
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

/// `text` with every block it asks for written anew.
///
/// # Errors
/// If a block begins and does not end.
pub(super) fn splice_all(text: &str, study: &Study) -> Result<String, ArtifactError> {
    BLOCKS.into_iter().try_fold(text.to_owned(), |text, block| {
        let content = match block {
            "cut" => markdown::cut(study),
            "kernels" => better::kernels(study),
            "verdicts-pixel" => table(study, true),
            _ => table(study, false),
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
