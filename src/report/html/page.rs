//! The page: the Markdown's blocks in the order of the Markdown, with a list of contents.

use super::block::{Block, blocks, text};
use super::chip::chips;
use super::contents::{Entry, list};
use super::figure::{escaped, figure};
use super::number::whole;
use super::picture::Pictures;
use super::style::style;
use crate::report::anchor::Anchors;
use pulldown_cmark::html::push_html;
use pulldown_cmark::{Event, HeadingLevel};

/// The page made of the report's Markdown.
pub(in crate::report) fn page(markdown: &str, pictures: &Pictures<'_>) -> String {
    let mut anchors = Anchors::default();
    let (mut title, mut entries, mut main) = (String::new(), Vec::new(), String::new());
    let mut blocks = blocks(markdown).into_iter().peekable();
    while let Some(block) = blocks.next() {
        match block {
            Block::Heading(level, events) => {
                let words = text(&events);
                let anchor = anchors.next(&words);
                let (number, inside) = (number(level), html(events));
                if number == 1 && title.is_empty() {
                    title = escaped(&words);
                }
                main.push_str(&format!("<h{number} id=\"{anchor}\">{inside}</h{number}>\n"));
                if (2..=3).contains(&number) {
                    entries.push(Entry { level: number, anchor, title: escaped(&words) });
                }
            }
            Block::Figure { url, alt } => {
                let caption = blocks.next_if(|next| matches!(next, Block::Source(_)));
                let caption = caption.map_or(String::new(), |caption| match caption {
                    Block::Source(events) => html(events),
                    _ => String::new(),
                });
                main.push_str(&figure(&url, &alt, &caption, pictures));
            }
            Block::Source(events) => main.push_str(&format!("<p class=\"source\">{}</p>\n", html(events))),
            Block::Table(events) => {
                let table = html(events);
                main.push_str(&format!(
                    "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\">\n{table}</div>\n"
                ));
            }
            Block::Raw(tags) => main.push_str(&folds(&tags)),
            Block::Other(events) => main.push_str(&html_of(whole(own_tags_only(events)))),
        }
    }
    let (style, contents) = (style(), list(&entries));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n\
         <nav class=\"beside\" aria-label=\"Contents\">\n<p>Contents</p>\n{contents}</nav>\n\
         <nav class=\"folded\" aria-label=\"Contents\">\n<details>\n<summary>Contents</summary>\n{contents}</details>\n</nav>\n\
         <main>\n{main}</main>\n</body>\n</html>\n"
    )
}

fn html(events: Vec<Event<'_>>) -> String {
    html_of(own_tags_only(events))
}

/// No tag but our own: whatever else the Markdown holds is shown as text.
fn own_tags_only(events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let shown = |event| match event {
        Event::InlineHtml(tag) | Event::Html(tag) => Event::Text(tag),
        event => event,
    };
    events.into_iter().map(shown).collect()
}

fn html_of(events: Vec<Event<'_>>) -> String {
    let mut html = String::new();
    push_html(&mut html, chips(events).into_iter());
    html
}

const fn number(level: HeadingLevel) -> u8 {
    level as u8
}

/// The tags that fold a part, as they are; anything else as text.
fn folds(tags: &str) -> String {
    let line = |line: &str| match line {
        "<details>" | "</details>" => format!("{line}\n"),
        _ => match line.strip_prefix("<summary>").and_then(|rest| rest.strip_suffix("</summary>")) {
            Some(words) => format!("<summary>{}</summary>\n", escaped(words)),
            None => format!("<p>{}</p>\n", escaped(line)),
        },
    };
    tags.lines().map(|text| line(text.trim())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::measured::Measured;
    use std::collections::BTreeMap;

    fn made(markdown: &str) -> String {
        page(markdown, &Pictures { files: &BTreeMap::new(), measured: &Measured::default() })
    }

    #[test]
    fn tags_that_are_not_ours_are_shown_and_not_meant() {
        let html = made(
            "# T\n\nAn <b onclick=\"x()\">inline</b> tag.\n\n<script>alert(1)</script>\n\n| <i>c</i> |\n|---|\n| 1 |\n",
        );
        assert!(!html.contains("<script") && !html.contains("<b ") && !html.contains("<i>"), "{html}");
        assert!(html.contains("&lt;script&gt;alert(1)&lt;/script&gt;"), "{html}");
    }

    #[test]
    fn parts_fold_and_headings_have_names() {
        let html = made(
            "# T\n\n## One, two\n\n<details>\n<summary>All 3 < 4</summary>\n\nText.\n\n</details>\n\n## One, two\n",
        );
        assert!(html.contains("<h2 id=\"one-two\">") && html.contains("<h2 id=\"one-two-1\">"), "{html}");
        assert!(
            html.contains("<details>\n<summary>All 3 &lt; 4</summary>\n<p>Text.</p>\n</details>\n"),
            "{html}"
        );
        assert_eq!(html.matches("<a href=\"#one-two-1\">").count(), 2, "{html}");
    }
}
