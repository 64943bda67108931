//! The list of contents: beside the page where there is room, else folded in front of it.

use std::fmt::Write;

/// A heading of the second or third level.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) level: u8,
    pub(super) anchor: String,
    /// As HTML.
    pub(super) title: String,
}

/// Titles as short as this stand side by side: the claims'.
const SHORT: usize = 4;

/// The list as nested HTML.
pub(super) fn list(entries: &[Entry]) -> String {
    let mut html = String::from("<ol>\n");
    let mut rest = entries;
    while let Some((entry, after)) = rest.split_first() {
        let count = after.iter().take_while(|below| below.level > entry.level).count();
        let (below, next) = after.split_at(count);
        let _ = write!(html, "<li><a href=\"#{}\">{}</a>", entry.anchor, entry.title);
        let below: Vec<&Entry> = below.iter().filter(|sub| sub.level == entry.level + 1).collect();
        if !below.is_empty() {
            let is_short = below.iter().all(|sub| sub.title.chars().count() <= SHORT);
            html.push_str(if is_short { "\n<ol class=\"short\">\n" } else { "\n<ol>\n" });
            for sub in below {
                let _ = writeln!(html, "<li><a href=\"#{}\">{}</a></li>", sub.anchor, sub.title);
            }
            html.push_str("</ol>\n");
        }
        html.push_str("</li>\n");
        rest = next;
    }
    html.push_str("</ol>\n");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_nests_as_the_headings_do() {
        let entry =
            |level, title: &str| Entry { level, anchor: title.to_lowercase(), title: title.to_owned() };
        let html =
            list(&[entry(2, "Claims"), entry(3, "L1"), entry(4, "Proof"), entry(3, "L2"), entry(2, "End")]);
        let expected = "<ol>\n<li><a href=\"#claims\">Claims</a>\n<ol class=\"short\">\n\
            <li><a href=\"#l1\">L1</a></li>\n<li><a href=\"#l2\">L2</a></li>\n</ol>\n</li>\n\
            <li><a href=\"#end\">End</a></li>\n</ol>\n";
        assert_eq!(html, expected);
    }
}
