//! Markdown as a row of blocks: what the page treats in its own way, and the rest as it is.

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

/// A block with its events.
#[derive(Debug, PartialEq)]
pub(super) enum Block<'a> {
    /// A heading's level, and what stands between its tags.
    Heading(HeadingLevel, Vec<Event<'a>>),
    /// An image alone in its paragraph.
    Figure { url: CowStr<'a>, alt: String },
    /// Where numbers stand: a paragraph that begins with *Source:*, without its tags.
    Source(Vec<Event<'a>>),
    /// A table, tags included.
    Table(Vec<Event<'a>>),
    /// Tags in the Markdown.
    Raw(String),
    /// Anything else, tags included.
    Other(Vec<Event<'a>>),
}

/// The Markdown's blocks in order.
pub(super) fn blocks(markdown: &str) -> Vec<Block<'_>> {
    let (mut found, mut events, mut depth) = (Vec::new(), Vec::new(), 0_usize);
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        match &event {
            Event::Start(_) => depth += 1,
            Event::End(_) => depth -= 1,
            _ => {}
        }
        events.push(event);
        if depth == 0 {
            found.push(block(std::mem::take(&mut events)));
        }
    }
    found
}

fn block(events: Vec<Event<'_>>) -> Block<'_> {
    match events.as_slice() {
        [Event::Start(Tag::Heading { level, .. }), ..] => Block::Heading(*level, inner(events)),
        [Event::Start(Tag::Table(_)), ..] => Block::Table(events),
        [Event::Start(Tag::HtmlBlock), ..] => Block::Raw(text(&events)),
        [Event::Start(Tag::Paragraph), Event::Start(Tag::Image { dest_url, .. }), alt @ .., end, _]
            if *end == Event::End(TagEnd::Image) =>
        {
            Block::Figure { url: dest_url.clone(), alt: text(alt) }
        }
        [Event::Start(Tag::Paragraph), Event::Start(Tag::Emphasis), Event::Text(word), ..]
            if word.as_ref() == "Source:" =>
        {
            Block::Source(inner(events))
        }
        _ => Block::Other(events),
    }
}

/// Without the first tag and the last.
fn inner(mut events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    events.pop();
    events.drain(..1.min(events.len()));
    events
}

/// The text of some events alone.
pub(super) fn text(events: &[Event<'_>]) -> String {
    let parts = events.iter().map(|event| match event {
        Event::Text(text) | Event::Code(text) | Event::Html(text) | Event::InlineHtml(text) => text.as_ref(),
        Event::SoftBreak | Event::HardBreak => " ",
        _ => "",
    });
    parts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_block_is_what_it_looks_like() {
        let markdown = "# A `b`\n\n![alt\\*](p.png)\n\n*Source:* [f](f)\n\n| a |\n|---|\n| 1 |\n\n<details>\n\nWith ![in](x.png) it.\n\n- list\n";
        let found = blocks(markdown);
        assert_eq!(found.len(), 7, "{found:#?}");
        assert!(matches!(&found[0], Block::Heading(HeadingLevel::H1, inner) if text(inner) == "A b"));
        assert!(matches!(&found[1], Block::Figure { url, alt } if url.as_ref() == "p.png" && alt == "alt*"));
        assert!(matches!(&found[2], Block::Source(inner) if text(inner) == "Source: f"));
        assert!(matches!(&found[3], Block::Table(_)));
        assert_eq!(found[4], Block::Raw("<details>\n".to_owned()));
        assert!(matches!((&found[5], &found[6]), (Block::Other(_), Block::Other(_))));
    }
}
