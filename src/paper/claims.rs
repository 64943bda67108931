//! Claims files: read, expanded into readings, and every error told with its place.

use super::Kind;
use super::fields::expand;
use super::raw::RawFile;
use std::collections::BTreeSet;
use thiserror::Error;

/// The schema this version reads.
const VERSION: u32 = 1;

/// What is wrong with a claims file, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("line {line}, column {column}: {message}")]
pub struct ClaimsError {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters.
    pub column: usize,
    /// What is wrong, in one line.
    pub message: String,
}

/// A statement of a paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Unique in its file.
    pub id: String,
    /// Which paper.
    pub paper: String,
    /// Where in it.
    pub locator: String,
    /// As printed.
    pub text: String,
    /// What the text can mean, each judged by itself.
    pub readings: Vec<Reading>,
}

/// One meaning of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Unique in its claim; words chosen from lists are appended after slashes.
    pub id: String,
    /// What it states.
    pub kind: Kind,
}

/// A claims file.
///
/// ```
/// use bellfit::paper::{ClaimsFile, LOBE_PAPER};
/// let file = ClaimsFile::parse(LOBE_PAPER)?;
/// assert!(file.claims.iter().any(|claim| claim.id == "L7"));
/// # Ok::<(), bellfit::paper::ClaimsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimsFile {
    /// In the file's order.
    pub claims: Vec<Claim>,
}

impl ClaimsFile {
    /// Both papers' claims, the lobe paper's first.
    ///
    /// # Errors
    /// As for [`ClaimsFile::parse`].
    pub fn papers() -> Result<Self, ClaimsError> {
        let mut all = Self::parse(super::LOBE_PAPER)?;
        all.claims.extend(Self::parse(super::PIXEL_PAPER)?.claims);
        Ok(all)
    }

    /// Reads a claims file (TOML, `version = 1`).
    ///
    /// # Errors
    /// [`ClaimsError`] for anything unknown, missing, doubled or unreadable, with its place.
    pub fn parse(text: &str) -> Result<Self, ClaimsError> {
        // Some editors begin a file with a mark that is no character of it.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let place = |at: usize, message: String| {
            let before = &text[..floor_boundary(text, at)];
            let line = before.matches('\n').count() + 1;
            let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
            ClaimsError { line, column, message: one_line(&message) }
        };
        let raw: RawFile = toml::from_str(text).map_err(|error| {
            let message = error.message().lines().collect::<Vec<_>>().join(", ");
            place(error.span().map_or(0, |span| span.start), message)
        })?;
        if *raw.version.get_ref() != VERSION {
            let found = raw.version.get_ref();
            return Err(place(
                raw.version.span().start,
                format!("version {found}: this program reads version {VERSION}"),
            ));
        }
        let mut seen = BTreeSet::new();
        let mut claims = Vec::new();
        for claim in raw.claim {
            let at = claim.id.span().start;
            let id = claim.id.into_inner();
            if !seen.insert(id.clone()) {
                return Err(place(at, format!("a claim \"{id}\" stands above already")));
            }
            if claim.reading.is_empty() {
                return Err(place(at, format!("claim \"{id}\" has no reading")));
            }
            let mut readings: Vec<Reading> = Vec::new();
            for reading in &claim.reading {
                for expanded in expand(reading).map_err(|(at, message)| place(at, message))? {
                    if readings.iter().any(|r| r.id == expanded.id) {
                        let message = format!("claim \"{id}\" has a reading \"{}\" already", expanded.id);
                        return Err(place(reading.id.span().start, message));
                    }
                    readings.push(expanded);
                }
            }
            let (paper, locator, text) = (claim.paper, claim.locator, claim.text);
            claims.push(Claim { id, paper, locator, text, readings });
        }
        Ok(ClaimsFile { claims })
    }
}

/// The file's own words are quoted in messages; a line break or a terminal's escape in them is shown,
/// not sent.
fn one_line(message: &str) -> String {
    let show = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    message.chars().map(show).collect()
}

fn floor_boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

/// Reads a range A..B of whole n, ends included, 1 ≤ A ≤ B ≤ 65536.
///
/// # Errors
/// One line that names the text and the domain.
pub fn parse_range(text: &str) -> Result<(u32, u32), String> {
    let problem = || format!("n = \"{text}\": a range A..B of whole numbers needs 1 ≤ A ≤ B ≤ 65536");
    let (from, to) = text.split_once("..").ok_or_else(problem)?;
    let read = |end: &str| end.trim().parse::<u32>().map_err(|_| problem());
    let (from, to) = (read(from)?, read(to)?);
    if (1..=to).contains(&from) && to <= 65_536 { Ok((from, to)) } else { Err(problem()) }
}
