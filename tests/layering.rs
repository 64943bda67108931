//! The modules keep their order, and the judge knows no claim by name.
//!
//! The order is the line in the crate's own documentation (src/lib.rs). Sources are split into tokens,
//! so comments, strings and doc links do not count; every path that starts with `crate`, `super` or
//! `self` is resolved to the module it names, use trees and inline modules included.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use bellfit::paper::{ClaimsFile, LOBE_PAPER, PIXEL_PAPER};
use bellfit::verdict::Judge;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Every .rs file under src with its path relative to src, sorted.
fn sources() -> Vec<(String, String)> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    let mut paths = Vec::new();
    walk(&root(), &mut paths);
    paths.sort();
    let read = |path: PathBuf| {
        let name = path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/");
        (name, fs::read_to_string(path).unwrap())
    };
    paths.into_iter().map(read).collect()
}

/// The order line of the crate's documentation.
fn order(lib: &str) -> Vec<String> {
    let lines: Vec<&str> = lib.lines().filter_map(|line| line.strip_prefix("//! kernel <")).collect();
    assert_eq!(lines.len(), 1, "one line of src/lib.rs states the order");
    format!("kernel <{}", lines[0]).split('<').map(|name| name.trim().to_owned()).collect()
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Word(String),
    /// The content of a string literal, escapes as written.
    Text(String),
    /// `::`
    Colons,
    Mark(char),
}

/// Comments dropped; lifetimes and character literals too.
fn tokens(source: &str) -> Vec<(usize, Token)> {
    let c: Vec<char> = source.chars().collect();
    let at = |i: usize| c.get(i).copied().unwrap_or('\0');
    let word = |x: char| x.is_alphanumeric() || x == '_';
    let (mut found, mut i, mut line) = (Vec::new(), 0, 1);
    while i < c.len() {
        let start = i;
        match at(i) {
            '/' if at(i + 1) == '/' => {
                while i < c.len() && at(i) != '\n' {
                    i += 1;
                }
            }
            '/' if at(i + 1) == '*' => {
                let mut depth = 0;
                loop {
                    match (at(i), at(i + 1)) {
                        ('/', '*') => (depth, i) = (depth + 1, i + 2),
                        ('*', '/') => (depth, i) = (depth - 1, i + 2),
                        _ => i += 1,
                    }
                    if depth == 0 || i >= c.len() {
                        break;
                    }
                }
            }
            '"' => {
                i += 1;
                while i < c.len() && at(i) != '"' {
                    i += if at(i) == '\\' { 2 } else { 1 };
                }
                found.push((line, Token::Text(c[start + 1..i.min(c.len())].iter().collect())));
                i += 1;
            }
            '\'' => {
                // 'x' or '\n' is a character, 'a without a second quote a lifetime.
                if at(i + 1) == '\\' {
                    i += 3;
                    while i < c.len() && at(i) != '\'' {
                        i += 1;
                    }
                    i += 1;
                } else if at(i + 2) == '\'' {
                    i += 3;
                } else {
                    i += 1;
                    while word(at(i)) {
                        i += 1;
                    }
                }
            }
            ':' if at(i + 1) == ':' => {
                found.push((line, Token::Colons));
                i += 2;
            }
            x if word(x) => {
                while word(at(i)) {
                    i += 1;
                }
                let name: String = c[start..i].iter().collect();
                let hashes = (i..).take_while(|&k| at(k) == '#').count();
                if ["r", "br"].contains(&name.as_str()) && at(i + hashes) == '"' {
                    let end: Vec<char> = std::iter::once('"').chain((0..hashes).map(|_| '#')).collect();
                    let from = i + hashes + 1;
                    i = from;
                    while i < c.len() && !c[i..].starts_with(&end) {
                        i += 1;
                    }
                    found.push((line, Token::Text(c[from..i].iter().collect())));
                    i += end.len();
                } else {
                    found.push((line, Token::Word(name)));
                }
            }
            x if x.is_whitespace() => i += 1,
            x => {
                found.push((line, Token::Mark(x)));
                i += 1;
            }
        }
        line += c[start..i.min(c.len())].iter().filter(|&&x| x == '\n').count();
    }
    found
}

/// The module that a file is: `bound/mod.rs` and `bound.rs` are bound, `bound/jet.rs` is bound::jet.
fn module_of(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs");
    let path = path.strip_suffix("/mod").unwrap_or(path);
    if path == "lib" { vec![] } else { path.split('/').map(str::to_owned).collect() }
}

/// The first components of every path below `prefix` that starts at token i: one for a plain path, one
/// a branch for a use tree. `super` and `self` may repeat in front.
fn expand(
    tokens: &[(usize, Token)],
    i: &mut usize,
    prefix: &[String],
    found: &mut Vec<(usize, Vec<String>)>,
) {
    let Some((line, token)) = tokens.get(*i) else { return };
    let followed = matches!(tokens.get(*i + 1), Some((_, Token::Colons)));
    match token {
        Token::Mark('{') => {
            *i += 1;
            while !matches!(tokens.get(*i), None | Some((_, Token::Mark('}')))) {
                expand(tokens, i, prefix, found);
                if matches!(tokens.get(*i), Some((_, Token::Word(w))) if w == "as") {
                    *i += 2;
                }
                if matches!(tokens.get(*i), Some((_, Token::Mark(',')))) {
                    *i += 1;
                }
            }
            *i += 1;
        }
        Token::Word(name) => {
            let mut path = prefix.to_vec();
            match name.as_str() {
                "super" => drop(path.pop()),
                "self" => {}
                _ => path.push(name.clone()),
            }
            *i += 1;
            if followed {
                *i += 1;
                expand(tokens, i, &path, found);
            } else {
                found.push((*line, path));
            }
        }
        Token::Mark('*') => {
            let mut path = prefix.to_vec();
            path.push("*".to_owned());
            found.push((*line, path));
            *i += 1;
        }
        // `::<`, a generic argument list: the path ends here.
        _ => {
            found.push((*line, prefix.to_vec()));
            *i += 1;
        }
    }
}

/// (line, absolute path) of everything that a source file reaches through the crate's own modules.
fn uses(file: &str, source: &str) -> Vec<(usize, Vec<String>)> {
    let tokens = tokens(source);
    let mut here = module_of(file);
    // Depth of braces at which each inline module opened.
    let (mut opened, mut depth, mut i) = (Vec::new(), 0, 0);
    let mut found = Vec::new();
    while i < tokens.len() {
        let before = i.checked_sub(1).map(|k| &tokens[k].1);
        match &tokens[i].1 {
            Token::Mark('{') => (depth, i) = (depth + 1, i + 1),
            Token::Mark('}') => {
                if opened.last() == Some(&depth) {
                    opened.pop();
                    here.pop();
                }
                (depth, i) = (depth - 1, i + 1);
            }
            Token::Word(word) if word == "mod" => {
                if let (Some((_, Token::Word(name))), Some((_, Token::Mark('{')))) =
                    (tokens.get(i + 1), tokens.get(i + 2))
                {
                    here.push(name.clone());
                    depth += 1;
                    opened.push(depth);
                    i += 3;
                } else {
                    i += 2;
                }
            }
            Token::Word(word)
                if before != Some(&Token::Colons)
                    && matches!(tokens.get(i + 1), Some((_, Token::Colons)))
                    && ["crate", "super", "self"].contains(&word.as_str()) =>
            {
                if word == "crate" {
                    i += 2;
                    expand(&tokens, &mut i, &[], &mut found);
                } else {
                    expand(&tokens, &mut i, &here, &mut found);
                }
            }
            _ => i += 1,
        }
    }
    found
}

/// What breaks the order in one file, in words. The root (lib.rs) and the program (main.rs) may name
/// every module.
fn violations(file: &str, source: &str, order: &[String]) -> Vec<String> {
    let place = |name: &String| order.iter().position(|o| o == name);
    if file == "lib.rs" || file == "main.rs" {
        return vec![];
    }
    let module = module_of(file)[0].clone();
    let Some(own) = place(&module) else { return vec![format!("{file}: {module} is not in the order")] };
    let mut found = Vec::new();
    for (line, path) in uses(file, source) {
        let problem = match path.first() {
            None => "names the whole crate".to_owned(),
            Some(used) => match place(used) {
                None => format!("uses {used}, which is not in the order"),
                Some(theirs) if theirs > own => format!("uses {used}, to its right"),
                Some(_) => continue,
            },
        };
        found.push(format!("{file}:{line}: {module} {problem}"));
    }
    found
}

#[test]
fn no_module_uses_one_to_its_right() {
    let sources = sources();
    let lib = &sources.iter().find(|(name, _)| name == "lib.rs").unwrap().1;
    let order = order(lib);
    assert_eq!((order[0].as_str(), order[order.len() - 1].as_str()), ("kernel", "cli"));
    let found: Vec<String> = sources.iter().flat_map(|(file, text)| violations(file, text, &order)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    // The walk saw what it should: every file, and paths in it.
    let count: usize = sources.iter().map(|(file, text)| uses(file, text).len()).sum();
    assert!(sources.len() > 40 && count > 100, "{} files, {count} paths", sources.len());
    // Every module that lib.rs declares has its place.
    for window in tokens(lib).windows(2) {
        if let [(_, Token::Word(key)), (_, Token::Word(name))] = window
            && key == "mod"
        {
            assert!(order.contains(name), "{name} is not in the order");
        }
    }
}

#[test]
fn planted_violations_are_seen() {
    let order = order("//! kernel < integral < bound < fit < verdict\n");
    let breaks = |file: &str, source: &str| violations(file, source, &order).len();
    for (file, source) in [
        ("bound/jet.rs", "use crate::fit::Problem;"),
        ("bound/jet.rs", "use crate::{integral::Field, fit};"),
        ("bound/jet.rs", "use crate::{integral::{Case, Edge}, kernel, fit::{Form as F}};"),
        ("bound/mod.rs", "use super::verdict::Judge;"),
        ("bound/mod.rs", "pub(super) use super::{verdict};"),
        ("bound/jet.rs", "use super::super::fit::Line;"),
        ("bound/jet.rs", "fn f(x: crate::fit::Line) {}"),
        ("bound/jet.rs", "let y = 'a'; let q = '\"'; let z = <crate::fit::Line>::new();"),
        ("bound/jet.rs", "mod inner { use super::super::super::fit::Line; }"),
        ("bound/jet.rs", "mod inner { fn f() {} } use super::super::fit::Line;"),
        (
            "bound/jet.rs",
            "/* crate::kernel */ const A: &str = r#\"\"crate\"#; type B<'a> = crate::fit::Line;",
        ),
        ("bound/jet.rs", "macro_rules! m { () => { $crate::fit::Line } }"),
        ("bound/jet.rs", "use crate::*;"),
        ("bound/jet.rs", "pub(in crate::fit) fn f() {}"),
        ("bound/jet.rs", "use crate::helpers::x;"),
        ("other/mod.rs", ""),
    ] {
        assert_eq!(breaks(file, source), 1, "{file}: {source}: {:?}", uses(file, source));
    }
    assert_eq!(breaks("bound/mod.rs", "use crate::{fit::{self, Form}, verdict};"), 3);
    for (file, source) in [
        (
            "fit/mod.rs",
            "use crate::{bound::{Interval, exact}, kernel::model::Model as M}; use super::integral;",
        ),
        ("bound/jet.rs", "use super::Interval; use super::elementary::{a, b}; use super::*; use self::x::y;"),
        ("bound/jet.rs", "pub(super) fn f() {} pub(crate) fn g() {} pub(in crate::bound) fn h() {}"),
        ("bound/jet.rs", "mod tests { use super::*; use super::super::Interval; use crate::kernel::x; }"),
        ("bound/jet.rs", "// crate::fit\n/// [`crate::fit::Line`]\nconst A: &str = \"crate::fit\";"),
        ("bound/jet.rs", "/* crate::fit /* crate::verdict */ crate::fit */ fn f<'a>(x: &'a str) {}"),
        ("bound/jet.rs", "const A: &str = r#\"\"crate::fit\"#; const B: &[u8] = b\"crate::fit\";"),
        ("verdict/mod.rs", "use crate::{kernel, integral, bound, fit};"),
        ("main.rs", "use bellfit::verdict::Judge; use bellfit::kernel;"),
    ] {
        assert_eq!(breaks(file, source), 0, "{file}: {source}: {:?}", uses(file, source));
    }
}

/// The ids of papers/lobe.md and papers/pixel.md.
fn claim_ids() -> Vec<String> {
    let lobe = (1..=16).map(|k| format!("L{k}"));
    let brief = (1..=2).map(|k| format!("G{k}"));
    lobe.chain(brief).chain((0..=13).map(|k| format!("P{k}"))).collect()
}

/// String literals that are a claim's id, or (in the judge) hold one as a word. Unit tests may name
/// claims: what follows `#[cfg(test)]` at a file's end does not count.
fn named_claims(file: &str, source: &str) -> Vec<String> {
    let code = source.split("#[cfg(test)]\nmod tests").next().unwrap();
    let ids = claim_ids();
    let judge = module_of(file).first().is_some_and(|module| module == "verdict");
    let names = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        ids.iter().any(|id| id == text) || (judge && words.any(|word| ids.iter().any(|id| id == word)))
    };
    let literals = tokens(code).into_iter().filter_map(|(line, token)| match token {
        Token::Text(text) if names(&text) => Some(format!("{file}:{line}: \"{text}\"")),
        _ => None,
    });
    literals.collect()
}

#[test]
fn no_code_names_a_claim() {
    let found: Vec<String> = sources().iter().flat_map(|(file, text)| named_claims(file, text)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    // The ids are those of the files, so that a new one is forbidden as well.
    let file = ClaimsFile::papers().unwrap();
    assert!(file.claims.iter().all(|claim| claim_ids().contains(&claim.id)));
    for (planted, source) in [
        (1, "fn f(id: &str) -> bool { id == \"L7\" }"),
        (1, "match id { \"G1\" => 1, _ => 0 }"),
        (1, "let text = \"as in L13, above\";"),
        (0, "// \"L7\"\n/// \"L7\"\nlet a = \"L70\"; let b = \"XL7\";"),
        (0, "fn f() {}\n#[cfg(test)]\nmod tests { const A: &str = \"L7\"; }"),
    ] {
        assert_eq!(named_claims("verdict/judge.rs", source).len(), planted, "{source}");
    }
    assert_eq!(named_claims("report/mod.rs", "let a = \"L7\"; let b = \"M0 L7\";").len(), 1);
}

#[test]
fn renaming_every_claim_changes_the_id_column_alone() {
    [LOBE_PAPER, PIXEL_PAPER].into_iter().for_each(renaming_changes_the_id_column_alone);
}

fn renaming_changes_the_id_column_alone(paper: &str) {
    let ids: Vec<String> = ClaimsFile::parse(paper).unwrap().claims.into_iter().map(|c| c.id).collect();
    let rename = |id: &str| format!("renamed {}", id.to_lowercase());
    let renamed = ids.iter().fold(paper.to_owned(), |text, id| {
        let line = format!("\nid = \"{id}\"\n");
        assert_eq!(text.matches(&line).count(), 1, "{id}");
        text.replace(&line, &format!("\nid = \"{}\"\n", rename(id)))
    });
    let judge = |text: &str| Judge::default().judge(&ClaimsFile::parse(text).unwrap()).unwrap();
    let (before, after) = (judge(paper), judge(&renamed));
    assert_eq!(before.len(), after.len());
    for (mut before, after) in before.into_iter().zip(after) {
        assert_ne!(before.claim, after.claim);
        before.claim = rename(&before.claim);
        assert_eq!(before, after);
    }
}
