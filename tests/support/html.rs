//! HTML as its tags and texts, read strictly: what is not closed in its turn is an error.
#![allow(dead_code)] // every test file uses its part

use std::collections::BTreeMap;

#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Open { name: String, attributes: BTreeMap<String, String>, empty: bool },
    Close(String),
    Text(String),
}

/// Elements without an end tag in HTML.
const VOID: [&str; 4] = ["meta", "img", "br", "hr"];

/// The tokens of a page, or the first thing that is wrong with it.
pub fn tokens(page: &str) -> Result<Vec<Token>, String> {
    let mut rest = page.strip_prefix("<!DOCTYPE html>\n").ok_or("no doctype")?;
    let (mut found, mut open): (Vec<Token>, Vec<String>) = (Vec::new(), Vec::new());
    while !rest.is_empty() {
        let start = rest.find('<').unwrap_or(rest.len());
        if start > 0 {
            let text = &rest[..start];
            if text.contains('>') && open.last().is_none_or(|name| name != "style") {
                return Err(format!("a bare > in {text:?}"));
            }
            found.push(Token::Text(unescaped(text)?));
            rest = &rest[start..];
            continue;
        }
        let end = rest.find('>').ok_or("a tag without its end")?;
        let inside = &rest[1..end];
        rest = &rest[end + 1..];
        if let Some(name) = inside.strip_prefix('/') {
            match open.pop() {
                Some(last) if last == name => found.push(Token::Close(name.to_owned())),
                last => return Err(format!("</{name}> closes {last:?}")),
            }
            continue;
        }
        let (inside, slash) = inside.strip_suffix('/').map_or((inside, false), |inside| (inside, true));
        let (name, attributes) = inside.split_once(' ').unwrap_or((inside, ""));
        let empty = slash || VOID.contains(&name);
        if !name.chars().all(|c| c.is_ascii_alphanumeric()) || name.is_empty() {
            return Err(format!("a tag <{inside}>"));
        }
        if !empty {
            open.push(name.to_owned());
        }
        found.push(Token::Open { name: name.to_owned(), attributes: pairs(attributes)?, empty });
    }
    if open.is_empty() { Ok(found) } else { Err(format!("left open: {open:?}")) }
}

fn pairs(text: &str) -> Result<BTreeMap<String, String>, String> {
    let mut found = BTreeMap::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (name, after) = rest.split_once("=\"").ok_or_else(|| format!("an attribute {rest:?}"))?;
        let (value, after) =
            after.split_once('"').ok_or_else(|| format!("an attribute {name} without end"))?;
        if found.insert(name.to_owned(), unescaped(value)?).is_some() {
            return Err(format!("{name} twice"));
        }
        rest = after.trim_start();
    }
    Ok(found)
}

fn unescaped(text: &str) -> Result<String, String> {
    let mut found = String::new();
    let mut parts = text.split('&');
    found.push_str(parts.next().unwrap_or_default());
    for part in parts {
        let (name, after) = part.split_once(';').ok_or_else(|| format!("a bare & before {part:?}"))?;
        found.push(match name {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            "apos" | "#39" | "#x27" => '\'',
            _ => return Err(format!("&{name}; is unknown")),
        });
        found.push_str(after);
    }
    Ok(found)
}

/// The texts of every element of some names, in order.
pub fn texts(tokens: &[Token], names: &[&str]) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut inside = false;
    for token in tokens {
        match token {
            Token::Open { name, empty: false, .. } if names.contains(&name.as_str()) => {
                inside = true;
                found.push((name.clone(), String::new()));
            }
            Token::Close(name) if names.contains(&name.as_str()) => inside = false,
            Token::Text(text) if inside => found.last_mut().expect("it was opened").1.push_str(text),
            _ => {}
        }
    }
    found
}

/// The attributes of every element of a name, in order.
pub fn elements<'a>(tokens: &'a [Token], of: &'a str) -> impl Iterator<Item = &'a BTreeMap<String, String>> {
    tokens.iter().filter_map(move |token| match token {
        Token::Open { name, attributes, .. } if name == of => Some(attributes),
        _ => None,
    })
}
