//! Words of claims and witnesses as Markdown, which must not read formulas as its own signs.

/// Text that shows as it is, in one line: a star, a tag or a link in it is none.
///
/// Underscores within words, as in cs_16, and a sign of comparison before a space need no escape.
pub(super) fn prose(text: &str) -> String {
    let characters: Vec<char> = text.chars().collect();
    let at = |i: usize| characters.get(i).copied().unwrap_or(' ');
    let mut escaped = String::with_capacity(text.len());
    for (i, &c) in characters.iter().enumerate() {
        let before = if i == 0 { ' ' } else { at(i - 1) };
        let is_sign = match c {
            '*' | '`' | '\\' => true,
            '_' => !(before.is_alphanumeric() && at(i + 1).is_alphanumeric()),
            '<' => at(i + 1).is_ascii_alphabetic() || matches!(at(i + 1), '/' | '!' | '?'),
            '&' => at(i + 1).is_ascii_alphabetic() || at(i + 1) == '#',
            ']' => matches!(at(i + 1), '(' | '['),
            _ => false,
        };
        if is_sign {
            escaped.push('\\');
        }
        escaped.push(if c.is_control() { ' ' } else { c });
    }
    escaped
}

/// The same in a table's cell, which ends at a bar.
pub(super) fn prose_cell(text: &str) -> String {
    prose(text).replace('|', "\\|")
}

/// With a capital in front.
pub(super) fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map_or(String::new(), |first| first.to_uppercase().collect::<String>() + characters.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulldown_cmark::{Event, Options, Parser};

    #[test]
    fn formulas_show_as_they_are() {
        for text in [
            "1.063*n/(2*pi), so cs_16 and _x_ stay",
            "a <b> & c &amp; n < 16 <= m",
            "at [0, 1](n) and [8], `code` \\ end",
            "|residual| is 2.9e-2",
        ] {
            let escaped = prose(text);
            let shown: String = Parser::new_ext(&escaped, Options::ENABLE_TABLES)
                .filter_map(|event| match event {
                    Event::Text(text) => Some(text.into_string()),
                    Event::Code(_) | Event::InlineHtml(_) | Event::Html(_) => Some("NOT TEXT".to_owned()),
                    _ => None,
                })
                .collect();
            assert_eq!(shown, text);
        }
        assert_eq!(prose_cell("|x|"), "\\|x\\|");
        assert_eq!(
            (capital("√n is"), capital("holds"), capital("")),
            ("√n is".into(), "Holds".into(), "".into())
        );
    }
}
