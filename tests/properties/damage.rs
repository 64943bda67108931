//! Damage to files: what a careless editor, a broken disk or an ill will makes of them.

use proptest::prelude::*;

/// Numbers that no file should hold, and some that it may.
pub const EXTREMES: [&str; 18] = [
    "nan",
    "inf",
    "-inf",
    "1e400",
    "-1e400",
    "1e-400",
    "-0",
    "-0.0",
    "0",
    "",
    "-1",
    "18446744073709551616",
    "9007199254740993",
    "1e308",
    "5e-324",
    "\"\"",
    "[]",
    "[1, 2]",
];

#[derive(Clone, Debug)]
pub enum Damage {
    Truncate(u16),
    Splice(u16, Vec<u8>),
    DropLine(u16),
    DoubleLine(u16),
    SwapLines(u16, u16),
    Number(u16, usize),
    Control(u16, char),
}

pub fn damage() -> impl Strategy<Value = Vec<Damage>> {
    let bytes = proptest::collection::vec(any::<u8>(), 1..12);
    let one = prop_oneof![
        1 => any::<u16>().prop_map(Damage::Truncate),
        2 => (any::<u16>(), bytes).prop_map(|(at, bytes)| Damage::Splice(at, bytes)),
        3 => any::<u16>().prop_map(Damage::DropLine),
        2 => any::<u16>().prop_map(Damage::DoubleLine),
        2 => (any::<u16>(), any::<u16>()).prop_map(|(a, b)| Damage::SwapLines(a, b)),
        4 => (any::<u16>(), 0..EXTREMES.len()).prop_map(|(at, with)| Damage::Number(at, with)),
        1 => (any::<u16>(), proptest::sample::select(vec!['\u{1b}', '\0', '\r', '"', '=', '½']))
            .prop_map(|(at, c)| Damage::Control(at, c)),
    ];
    proptest::collection::vec(one, 1..4)
}

/// A place in something so long.
fn place(at: u16, len: usize) -> usize {
    usize::from(at) * len / 65_536
}

pub fn apply(text: &str, damage: &[Damage]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for one in damage {
        let line = |bytes: &[u8]| -> Vec<Vec<u8>> {
            bytes.split_inclusive(|b| *b == b'\n').map(<[u8]>::to_vec).collect()
        };
        match one {
            Damage::Truncate(at) => bytes.truncate(place(*at, bytes.len())),
            Damage::Splice(at, new) => {
                let at = place(*at, bytes.len());
                bytes.splice(at..at, new.iter().copied());
            }
            Damage::Control(at, c) => {
                let at = place(*at, bytes.len());
                bytes.splice(at..at, c.to_string().into_bytes());
            }
            Damage::DropLine(at) => {
                let mut lines = line(&bytes);
                if !lines.is_empty() {
                    lines.remove(place(*at, lines.len()));
                }
                bytes = lines.concat();
            }
            Damage::DoubleLine(at) => {
                let mut lines = line(&bytes);
                if !lines.is_empty() {
                    let at = place(*at, lines.len());
                    lines.insert(at, lines[at].clone());
                }
                bytes = lines.concat();
            }
            Damage::SwapLines(a, b) => {
                let mut lines = line(&bytes);
                if !lines.is_empty() {
                    let (a, b) = (place(*a, lines.len()), place(*b, lines.len()));
                    lines.swap(a, b);
                }
                bytes = lines.concat();
            }
            Damage::Number(at, with) => {
                let numbers = numbers(&bytes);
                if !numbers.is_empty() {
                    let (from, to) = numbers[place(*at, numbers.len())];
                    bytes.splice(from..to, EXTREMES[*with].bytes());
                }
            }
        }
    }
    bytes
}

/// Where runs of digits, points and exponents stand.
fn numbers(bytes: &[u8]) -> Vec<(usize, usize)> {
    let (mut found, mut start) = (vec![], None);
    for (i, byte) in bytes.iter().chain(b" ").enumerate() {
        match (start, byte.is_ascii_digit() || *byte == b'.') {
            (None, true) => start = Some(i),
            (Some(from), false) => {
                found.push((from, i));
                start = None;
            }
            _ => {}
        }
    }
    found
}
