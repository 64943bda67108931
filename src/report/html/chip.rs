//! Verdict words as chips: a word, a sign and a colour, so that none tells by its colour alone.

use pulldown_cmark::{CowStr, Event, Tag, TagEnd};

/// The class of a verdict's words, if these are some.
fn class(words: &str) -> Option<&'static str> {
    Some(match words {
        "proved" | "holds" => "proved",
        "reproduced" => "reproduced",
        "refuted" | "does not hold" | "does not hold but vacuously" => "refuted",
        "definition" => "definition",
        "undecided" => "open",
        _ if words.starts_with("holds under ") => "partly",
        _ if words.ends_with(" readings undecided") => "open",
        _ => return None,
    })
}

/// The events with each verdict that is set in bold as a chip.
pub(super) fn chips(events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let mut found = Vec::with_capacity(events.len());
    let mut events = events.into_iter().peekable();
    let mut open = false;
    while let Some(event) = events.next() {
        let verdict = match (&event, events.peek()) {
            (Event::Start(Tag::Strong), Some(Event::Text(words))) => class(words),
            _ => None,
        };
        match event {
            Event::Start(Tag::Strong) if verdict.is_some() => {
                let class = verdict.unwrap_or_default();
                found.push(Event::InlineHtml(CowStr::from(format!("<strong class=\"chip {class}\">"))));
                open = true;
            }
            Event::End(TagEnd::Strong) if open => {
                found.push(Event::InlineHtml(CowStr::Borrowed("</strong>")));
                open = false;
            }
            event => found.push(event),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::Verdict;
    use pulldown_cmark::{Parser, html::push_html};

    #[test]
    fn verdicts_alone_become_chips() {
        let mut html = String::new();
        push_html(&mut html, chips(Parser::new("**refuted** and **no** verdict").collect()).into_iter());
        assert_eq!(
            html,
            "<p><strong class=\"chip refuted\">refuted</strong> and <strong>no</strong> verdict</p>\n"
        );
        for verdict in
            [Verdict::Proved, Verdict::Reproduced, Verdict::Refuted, Verdict::Undecided, Verdict::Definition]
        {
            assert!(class(verdict.id()).is_some(), "{}", verdict.id());
        }
        assert_eq!(class("holds under 2 of 6 readings"), Some("partly"));
    }
}
