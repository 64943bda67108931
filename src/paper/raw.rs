//! A claims file as it is written, before its numbers and names are read.

use serde::Deserialize;
use serde::de::{Deserializer, SeqAccess, Visitor};
use toml::Spanned;

/// The file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawFile {
    pub version: Spanned<u32>,
    #[serde(default)]
    pub claim: Vec<RawClaim>,
}

/// A claim.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawClaim {
    pub id: Spanned<String>,
    pub paper: String,
    pub locator: String,
    pub text: String,
    #[serde(default)]
    pub reading: Vec<RawReading>,
}

/// A reading: `kind` decides which of the rest must and may stand.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawReading {
    pub id: Spanned<String>,
    pub kind: Spanned<String>,
    pub place: Option<Spanned<String>>,
    pub model: Option<Spanned<OneOrMany>>,
    pub other: Option<Spanned<OneOrMany>>,
    pub lobe: Option<Spanned<OneOrMany>>,
    #[serde(rename = "use")]
    pub usage: Option<Spanned<OneOrMany>>,
    pub limit: Option<Spanned<OneOrMany>>,
    pub cut: Option<Spanned<OneOrMany>>,
    pub gaussian: Option<Spanned<OneOrMany>>,
    pub objective: Option<Spanned<OneOrMany>>,
    pub over: Option<Spanned<OneOrMany>>,
    pub statistic: Option<Spanned<OneOrMany>>,
    pub relation: Option<Spanned<OneOrMany>>,
    pub compared: Option<Spanned<OneOrMany>>,
    pub form: Option<Spanned<String>>,
    pub n: Option<Spanned<String>>,
    pub factor: Option<Spanned<String>>,
    pub zero: Option<Spanned<String>>,
    pub lower: Option<Spanned<String>>,
    pub upper: Option<Spanned<String>>,
    pub printed: Option<Spanned<String>>,
    pub a: Option<Spanned<String>>,
    pub b: Option<Spanned<String>>,
    pub powers: Option<Spanned<Vec<u32>>>,
}

/// One word, or a list of words that each make a reading of their own.
#[derive(Clone, Debug)]
pub(super) struct OneOrMany {
    pub words: Vec<String>,
    pub many: bool,
}

impl<'de> Deserialize<'de> for OneOrMany {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Words;
        impl<'de> Visitor<'de> for Words {
            type Value = OneOrMany;

            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str("a word or a list of words")
            }

            fn visit_str<E>(self, word: &str) -> Result<OneOrMany, E> {
                Ok(OneOrMany { words: vec![word.to_owned()], many: false })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<OneOrMany, A::Error> {
                let mut words = Vec::new();
                while let Some(word) = list.next_element()? {
                    words.push(word);
                }
                Ok(OneOrMany { words, many: true })
            }
        }
        deserializer.deserialize_any(Words)
    }
}
