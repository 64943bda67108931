//! Numbers such as 4.7e-4 that a line must not break after their hyphen.

use pulldown_cmark::{CowStr, Event};

/// The events with each number that holds a hyphen kept on one line.
pub(super) fn whole(events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let mut found = Vec::with_capacity(events.len());
    for event in events {
        match event {
            Event::Text(text) if text.contains("e-") => {
                for word in text.split_inclusive(' ') {
                    let piece = Event::Text(CowStr::from(word.to_owned()));
                    if has_exponent(word) {
                        found.push(Event::InlineHtml(CowStr::Borrowed("<span class=\"whole\">")));
                        found.push(piece);
                        found.push(Event::InlineHtml(CowStr::Borrowed("</span>")));
                    } else {
                        found.push(piece);
                    }
                }
            }
            event => found.push(event),
        }
    }
    found
}

/// Whether a digit, e, a hyphen and a digit follow each other.
fn has_exponent(word: &str) -> bool {
    let is_one = |four: &[u8]| four[0].is_ascii_digit() && &four[1..3] == b"e-" && four[3].is_ascii_digit();
    word.as_bytes().windows(4).any(is_one)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulldown_cmark::{Parser, html::push_html};

    #[test]
    fn numbers_stay_whole_and_words_do_not_change() {
        let mut html = String::new();
        push_html(&mut html, whole(Parser::new("at most 7.9588e-4, re-use e-t").collect()).into_iter());
        assert_eq!(html, "<p>at most <span class=\"whole\">7.9588e-4, </span>re-use e-t</p>\n");
    }
}
