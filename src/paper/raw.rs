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
    pub convention: Option<Spanned<OneOrMany>>,
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
    pub denominator: Option<Spanned<OneOrMany>>,
    pub tilt: Option<Spanned<OneOrMany>>,
    pub weight: Option<Spanned<OneOrMany>>,
    pub shape: Option<Spanned<OneOrMany>>,
    pub power: Option<Spanned<OneOrMany>>,
    pub exponent: Option<Spanned<OneOrMany>>,
    pub sign: Option<Spanned<OneOrMany>>,
    pub inner: Option<Spanned<OneOrMany>>,
    pub second: Option<Spanned<OneOrMany>>,
    pub base: Option<Spanned<OneOrMany>>,
    pub vectors: Option<Spanned<OneOrMany>>,
    pub octant: Option<Spanned<OneOrMany>>,
    pub figure: Option<Spanned<OneOrMany>>,
    pub property: Option<Spanned<OneOrMany>>,
    pub region: Option<Spanned<OneOrMany>>,
    pub pixel: Option<Spanned<OneOrMany>>,
    pub points: Option<Spanned<OneOrMany>>,
    #[serde(rename = "constant-term")]
    pub constant_term: Option<Spanned<OneOrMany>>,
    pub share: Option<Spanned<OneOrMany>>,
    pub energy: Option<Spanned<OneOrMany>>,
    pub form: Option<Spanned<String>>,
    pub n: Option<Spanned<String>>,
    pub factor: Option<Spanned<String>>,
    pub zero: Option<Spanned<String>>,
    pub lower: Option<Spanned<String>>,
    pub upper: Option<Spanned<String>>,
    pub printed: Option<Spanned<String>>,
    pub a: Option<Spanned<String>>,
    pub b: Option<Spanned<String>>,
    pub divisor: Option<Spanned<String>>,
    pub constant: Option<Spanned<String>>,
    pub linear: Option<Spanned<String>>,
    pub square: Option<Spanned<String>>,
    pub bound: Option<Spanned<String>>,
    #[serde(rename = "loses-at-most")]
    pub loses_at_most: Option<Spanned<String>>,
    pub powers: Option<Spanned<Vec<u32>>>,
    pub coefficients: Option<Spanned<Vec<Spanned<Number>>>>,
}

impl RawReading {
    /// The lists of words, in the order in which they are appended to a reading's id.
    pub(super) fn lists(&self) -> [(&'static str, &Option<Spanned<OneOrMany>>); 33] {
        [
            ("model", &self.model),
            ("convention", &self.convention),
            ("other", &self.other),
            ("lobe", &self.lobe),
            ("use", &self.usage),
            ("limit", &self.limit),
            ("cut", &self.cut),
            ("gaussian", &self.gaussian),
            ("objective", &self.objective),
            ("over", &self.over),
            ("statistic", &self.statistic),
            ("relation", &self.relation),
            ("compared", &self.compared),
            ("denominator", &self.denominator),
            ("tilt", &self.tilt),
            ("weight", &self.weight),
            ("shape", &self.shape),
            ("power", &self.power),
            ("exponent", &self.exponent),
            ("sign", &self.sign),
            ("inner", &self.inner),
            ("second", &self.second),
            ("base", &self.base),
            ("vectors", &self.vectors),
            ("octant", &self.octant),
            ("figure", &self.figure),
            ("property", &self.property),
            ("region", &self.region),
            ("pixel", &self.pixel),
            ("points", &self.points),
            ("constant-term", &self.constant_term),
            ("share", &self.share),
            ("energy", &self.energy),
        ]
    }

    /// The fields that hold one text.
    pub(super) fn texts(&self) -> [(&'static str, &Option<Spanned<String>>); 16] {
        [
            ("place", &self.place),
            ("form", &self.form),
            ("n", &self.n),
            ("factor", &self.factor),
            ("zero", &self.zero),
            ("lower", &self.lower),
            ("upper", &self.upper),
            ("printed", &self.printed),
            ("a", &self.a),
            ("b", &self.b),
            ("divisor", &self.divisor),
            ("constant", &self.constant),
            ("linear", &self.linear),
            ("square", &self.square),
            ("bound", &self.bound),
            ("loses-at-most", &self.loses_at_most),
        ]
    }
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

            // A power is a word that looks like a number: with quotes or without.
            fn visit_i64<E>(self, word: i64) -> Result<OneOrMany, E> {
                Ok(OneOrMany { words: vec![word.to_string()], many: false })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<OneOrMany, A::Error> {
                let mut words = Vec::new();
                while let Some(OneWord(word)) = list.next_element()? {
                    words.push(word);
                }
                Ok(OneOrMany { words, many: true })
            }
        }
        deserializer.deserialize_any(Words)
    }
}

/// A word of a list.
struct OneWord(String);

impl<'de> Deserialize<'de> for OneWord {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Word;
        impl Visitor<'_> for Word {
            type Value = OneWord;

            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str("a word")
            }

            fn visit_str<E>(self, word: &str) -> Result<OneWord, E> {
                Ok(OneWord(word.to_owned()))
            }

            fn visit_i64<E>(self, word: i64) -> Result<OneWord, E> {
                Ok(OneWord(word.to_string()))
            }
        }
        deserializer.deserialize_any(Word)
    }
}

/// A number that is taken as it is printed: a whole one, or a decimal in quotes.
#[derive(Clone, Debug)]
pub(super) struct Number(pub String);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Digits;
        impl Visitor<'_> for Digits {
            type Value = Number;

            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str("a whole number, or a decimal in quotes, which is taken exactly as printed")
            }

            fn visit_i64<E>(self, value: i64) -> Result<Number, E> {
                Ok(Number(value.to_string()))
            }

            fn visit_str<E>(self, text: &str) -> Result<Number, E> {
                Ok(Number(text.to_owned()))
            }
        }
        deserializer.deserialize_any(Digits)
    }
}
