//! The report's part on speed: what one machine's measurements hold, as they lie in reports/measured.

use super::measured::{FOLDER, Measured};
use super::source::source_by;
use super::words::prose;
use std::fmt::Write;

/// A page of measurements and its place in the section.
struct Page {
    heading: &'static str,
    /// The page's file.
    name: &'static str,
    command: &'static str,
}

const PAGES: [Page; 2] = [
    Page {
        heading: "cosⁿ and what stands for it",
        name: "trade.md",
        command: "bellfit trade --out reports/measured",
    },
    Page {
        heading: "A texture lookup",
        name: "filter.md",
        command: "bellfit render --measure --out reports/measured",
    },
];

/// The section.
pub(super) fn section(measured: &Measured, text: &mut String) {
    text.push_str(
        "\n## Speed against accuracy\n\n\
         Times depend on the machine, so nothing here is computed again with the rest: it is shown as it was measured once. \
         `bellfit trade` measures every kernel above, the platform's powers and tables of several sizes on the machine at hand, in \
         `f32` and `f64`, one by one and over slices, in cache and in memory; `bellfit render --measure` measures texture lookups.\n",
    );
    for page in &PAGES {
        let _ = write!(text, "\n### {}\n", page.heading);
        match measured.text(page.name) {
            Some(found) => shown(page, found, measured, text),
            None => {
                let _ = write!(text, "\nNothing is measured here yet: `{}` does.\n", page.command);
            }
        }
    }
}

/// The page within the report: its title dropped, its headings and long tables folded, its plot once, a source
/// line below each table.
fn shown(page: &Page, found: &str, measured: &Measured, text: &mut String) {
    let path = format!("{FOLDER}/{}", page.name);
    let stem = page.name.trim_end_matches(".md");
    let data: Vec<String> = measured
        .names()
        .filter(|name| name.starts_with(stem) && name.ends_with(".csv"))
        .map(|name| format!("{FOLDER}/{name}"))
        .collect();
    let files: Vec<&str> = data.iter().map(String::as_str).chain([path.as_str()]).collect();
    let source = source_by(&files, page.command);
    // Of whatever stands there no tag gets into the report.
    let lines = found.lines().filter(|line| !line.starts_with("# ")).map(|line| line.replace('<', "\\<"));
    let mut lines = lines.peekable();
    text.push('\n');
    while let Some(line) = lines.next() {
        if line.starts_with('|') {
            text.push_str("<details>\n<summary>The table</summary>\n\n");
            let _ = writeln!(text, "{line}");
            while let Some(row) = lines.next_if(|row| row.starts_with('|')) {
                let _ = writeln!(text, "{row}");
            }
            let _ = write!(text, "{source}\n</details>\n\n");
        } else if let Some((level, heading)) = heading(&line) {
            let _ = writeln!(text, "##{} {}", "#".repeat(level), prose(heading));
        } else if let Some((alt, plot)) = image(&line) {
            let _ = write!(text, "![{alt}](measured/{plot})\n{source}");
        } else {
            let _ = writeln!(text, "{line}");
        }
    }
}

/// A heading's level, of which two more leave room for the section's own, and its words.
fn heading(line: &str) -> Option<(usize, &str)> {
    let words = line.trim_start_matches('#');
    let level = line.len() - words.len();
    Some(((1..=4).contains(&level).then_some(level)?, words.strip_prefix(' ')?))
}

/// `![alt](file)` in a line of its own, the file beside the page.
fn image(line: &str) -> Option<(&str, &str)> {
    let (alt, file) = line.strip_prefix("![")?.strip_suffix(')')?.split_once("](")?;
    let is_name = !file.is_empty() && file.chars().all(|c| c.is_ascii_alphanumeric() || "-._".contains(c));
    is_name.then_some((alt, file))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section_of(files: &[(&str, &[u8])]) -> String {
        let files = files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec()));
        let mut text = String::new();
        section(&Measured::from_files(files), &mut text);
        text
    }

    #[test]
    fn what_is_missing_or_broken_is_said() {
        for text in [section_of(&[]), section_of(&[("trade.md", b"\xff\xfe"), ("trade.svg", b"<svg")])] {
            assert_eq!(text.matches("Nothing is measured here yet").count(), 2, "{text}");
            assert!(text.contains("`bellfit trade --out reports/measured` does"), "{text}");
        }
    }

    #[test]
    fn a_page_is_shown_within_the_report() {
        let page = b"# Title\n\nWords.\n\n![Plot](trade.png)\n\n## Part\n\n### Piece\n\n| a |\n|---|\n| 1 |\n\nEnd.\n";
        let text = section_of(&[("trade.md", page), ("trade-one.csv", b"a\n1\n")]);
        assert!(!text.contains("# Title") && text.contains("\n#### Part\n\n##### Piece\n"), "{text}");
        assert!(text.contains("![Plot](measured/trade.png)\n\n*Source:* "), "{text}");
        assert!(
            text.contains("| 1 |\n\n*Source:* [reports/measured/trade-one.csv](measured/trade-one.csv)"),
            "{text}"
        );
        assert_eq!(image("![a](../b.png)"), None);
    }
}
