//! Claims files: read, expanded into readings, and every error told with its place.

use super::raw::{OneOrMany, RawFile, RawReading};
use super::{Comparison, CutForm, Kind, Over, Printed, Relation, Statistic};
use crate::bound::{Formula, Gaussian};
use crate::fit::{Form, Objective};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;
use std::collections::BTreeSet;
use thiserror::Error;
use toml::Spanned;

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
    /// Reads a claims file (TOML, `version = 1`).
    ///
    /// # Errors
    /// [`ClaimsError`] for anything unknown, missing, doubled or unreadable, with its place.
    pub fn parse(text: &str) -> Result<Self, ClaimsError> {
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
                format!("version {found}: this program reads {VERSION}"),
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

/// An error with its byte offset.
type Problem = (usize, String);

/// The readings that a raw one stands for: the product of its lists.
fn expand(raw: &RawReading) -> Result<Vec<Reading>, Problem> {
    let lists: [(&str, &Option<Spanned<OneOrMany>>); 11] = [
        ("model", &raw.model),
        ("other", &raw.other),
        ("lobe", &raw.lobe),
        ("limit", &raw.limit),
        ("cut", &raw.cut),
        ("gaussian", &raw.gaussian),
        ("objective", &raw.objective),
        ("over", &raw.over),
        ("statistic", &raw.statistic),
        ("relation", &raw.relation),
        ("compared", &raw.compared),
    ];
    let mut choices: Vec<Vec<(&str, &str, usize)>> = vec![vec![]];
    let mut ids = vec![raw.id.get_ref().clone()];
    for (key, list) in lists {
        let Some(list) = list else { continue };
        let (at, list) = (list.span().start, list.get_ref());
        if list.words.is_empty() {
            return Err((at, format!("`{key}` is an empty list")));
        }
        let (mut next, mut next_ids) = (vec![], vec![]);
        for (choice, id) in choices.iter().zip(&ids) {
            for word in &list.words {
                let mut longer = choice.clone();
                longer.push((key, word.as_str(), at));
                next.push(longer);
                next_ids.push(if list.many { format!("{id}/{word}") } else { id.clone() });
            }
        }
        (choices, ids) = (next, next_ids);
    }
    let read = |(choice, id): (Vec<(&str, &str, usize)>, String)| {
        let mut fields = Fields { raw, choice, used: BTreeSet::new() };
        let kind = fields.kind()?;
        fields.none_left()?;
        Ok(Reading { id, kind })
    };
    choices.into_iter().zip(ids).map(read).collect()
}

/// The fields of one reading, each taken once by its kind.
struct Fields<'a> {
    raw: &'a RawReading,
    choice: Vec<(&'a str, &'a str, usize)>,
    used: BTreeSet<&'static str>,
}

impl Fields<'_> {
    fn missing(&self, key: &str) -> Problem {
        let kind = self.raw.kind.get_ref();
        (self.raw.kind.span().start, format!("kind \"{kind}\" needs `{key}`"))
    }

    fn text(&mut self, key: &'static str) -> Option<(String, usize)> {
        self.used.insert(key);
        let field = self.plain().into_iter().find(|(name, _)| *name == key);
        let field = field.and_then(|(_, field)| field.as_ref());
        field.map(|f| (f.get_ref().clone(), f.span().start))
    }

    fn plain(&self) -> [(&'static str, &Option<Spanned<String>>); 10] {
        let r = self.raw;
        [
            ("place", &r.place),
            ("form", &r.form),
            ("n", &r.n),
            ("factor", &r.factor),
            ("zero", &r.zero),
            ("lower", &r.lower),
            ("upper", &r.upper),
            ("printed", &r.printed),
            ("a", &r.a),
            ("b", &r.b),
        ]
    }

    fn needed(&mut self, key: &'static str) -> Result<(String, usize), Problem> {
        self.text(key).ok_or_else(|| self.missing(key))
    }

    fn word<T>(
        &mut self,
        key: &'static str,
        read: impl Fn(&str) -> Option<T>,
        known: &str,
    ) -> Result<T, Problem> {
        self.used.insert(key);
        let found = self.choice.iter().find(|(name, ..)| *name == key).copied();
        let (_, word, at) = found.ok_or_else(|| self.missing(key))?;
        read(word).ok_or_else(|| (at, format!("`{key}` is \"{word}\"; known are {known}")))
    }

    fn word_or<T>(
        &mut self,
        key: &'static str,
        default: T,
        read: impl Fn(&str) -> Option<T>,
        known: &str,
    ) -> Result<T, Problem> {
        self.used.insert(key);
        if self.choice.iter().any(|(name, ..)| *name == key) {
            self.word(key, read, known)
        } else {
            Ok(default)
        }
    }

    fn formula(&mut self, key: &'static str) -> Result<Formula, Problem> {
        let (text, at) = self.needed(key)?;
        text.parse().map_err(|error: crate::bound::FormulaError| (at, error.to_string()))
    }

    fn printed(&mut self, key: &'static str) -> Result<Option<Printed>, Problem> {
        let Some((text, at)) = self.text(key) else { return Ok(None) };
        let read = Printed::parse(&text).ok_or((at, format!("`{key}` is \"{text}\", not a decimal")))?;
        Ok(Some(read))
    }

    fn printed_needed(&mut self, key: &'static str) -> Result<Printed, Problem> {
        self.printed(key)?.ok_or_else(|| self.missing(key))
    }

    fn range(&mut self) -> Result<(u32, u32), Problem> {
        let (text, at) = self.needed("n")?;
        parse_range(&text).map_err(|message| (at, message))
    }

    /// A range that starts at 16 or later, where cs_16 has its zero within the hemisphere.
    fn range_from_16(&mut self) -> Result<(u32, u32), Problem> {
        let (from, to) = self.range()?;
        let at = self.raw.n.as_ref().map_or(0, |n| n.span().start);
        if from >= 16 {
            Ok((from, to))
        } else {
            Err((at, format!("n = {from}..{to}: this kind needs n ≥ 16")))
        }
    }

    fn model(&mut self, key: &'static str) -> Result<Model, Problem> {
        let known = Model::ALL.map(Model::id).join(", ");
        self.word(key, Model::from_id, &known)
    }

    fn case(&mut self) -> Result<Case, Problem> {
        let model = self.model("model")?;
        let lobe = self.word_or("lobe", Lobe::Cs16, Lobe::from_id, "cos-n, cs16")?;
        let limit = self.limit("limit")?;
        if !lobe.limits().contains(&limit) {
            let at = self.raw.kind.span().start;
            return Err((at, "lobe cos-n is integrated over its support only".to_owned()));
        }
        Ok(Case { model, lobe, limit })
    }

    fn limit(&mut self, key: &'static str) -> Result<Limit, Problem> {
        self.word(key, Limit::from_id, &Limit::ALL.map(Limit::id).join(", "))
    }

    fn over(&mut self) -> Result<Over, Problem> {
        let read = |word: &str| match word {
            "integers" => Some(Over::Integers),
            "reals" => Some(Over::Reals),
            _ => None,
        };
        self.word("over", read, "integers, reals")
    }

    fn statistic(&mut self) -> Result<Statistic, Problem> {
        let read = |word: &str| match word {
            "max" => Some(Statistic::Max),
            "max-abs" => Some(Statistic::MaxAbs),
            "min" => Some(Statistic::Min),
            _ => None,
        };
        self.word("statistic", read, "max, max-abs, min")
    }

    fn relation(&mut self) -> Result<Relation, Problem> {
        let read = |word: &str| match word {
            "=" => Some(Relation::Equal),
            "<=" => Some(Relation::AtMost),
            _ => None,
        };
        self.word_or("relation", Relation::Equal, read, "=, <=")
    }

    fn gaussian(&mut self) -> Result<Gaussian, Problem> {
        let read = |word: &str| Gaussian::ALL.into_iter().find(|g| g.id() == word);
        self.word("gaussian", read, "gaussian-angle, gaussian-cosine")
    }

    fn kind(&mut self) -> Result<Kind, Problem> {
        let kind = self.raw.kind.get_ref().as_str();
        Ok(match kind {
            "definition" => Kind::Definition { place: self.needed("place")?.0 },
            "factor-residual" => Kind::FactorResidual {
                case: self.case()?,
                factor: self.formula("factor")?,
                text: self.needed("factor")?.0,
                n: self.range()?,
                over: self.over()?,
                statistic: self.statistic()?,
                relation: self.relation()?,
                printed: self.printed("printed")?,
            },
            "energy" => Kind::Energy {
                case: self.case()?,
                factor: self.formula("factor")?,
                n: self.range()?,
                over: self.over()?,
            },
            "lobe-difference" => Kind::LobeDifference {
                cut: self.limit("cut")?,
                n: self.range_from_16()?,
                statistic: self.statistic()?,
                relation: self.relation()?,
                printed: self.printed_needed("printed")?,
            },
            "cut" => Kind::Cut {
                form: self.cut_form()?,
                n: self.range_from_16()?,
                printed: self.printed_needed("printed")?,
            },
            "cut-effect" => {
                let read = |word: &str| match word {
                    "less" => Some(Comparison::Less),
                    "tenth" => Some(Comparison::Tenth),
                    "each-n" => Some(Comparison::EachN),
                    _ => None,
                };
                let comparison = self.word("compared", read, "less, tenth, each-n")?;
                Kind::CutEffect { cut: self.limit("cut")?, n: self.range_from_16()?, comparison }
            }
            "lobe-zero" => Kind::LobeZero { zero: self.formula("zero")? },
            "factor-identity" => Kind::FactorIdentity {
                model: self.model("model")?,
                factor: self.formula("factor")?,
                text: self.needed("factor")?.0,
            },
            "factor-inequality" => {
                let (from, _) = self.range()?;
                Kind::FactorInequality { lower: self.formula("lower")?, upper: self.formula("upper")?, from }
            }
            "same-integral" => {
                Kind::SameIntegral { model: self.model("model")?, other: self.model("other")? }
            }
            "fit" => {
                let read = |word: &str| Objective::from_id(word).filter(|o| *o != Objective::Minimax);
                let (form, at) = self.needed("form")?;
                let form = Form::from_id(&form)
                    .ok_or((at, format!("`form` is \"{form}\"; known are linear, proportional")))?;
                let b = if form == Form::Linear { Some(self.printed_needed("b")?) } else { None };
                Kind::Fit {
                    case: self.case()?,
                    objective: self.word("objective", read, "ls-absolute, ls-relative")?,
                    form,
                    n: self.range()?,
                    a: self.printed_needed("a")?,
                    b,
                }
            }
            "gaussian-falls" => Kind::GaussianFalls { gaussian: self.gaussian()?, n: self.range_from_16()? },
            "gaussian-beats-lobe" => {
                Kind::GaussianBeatsLobe { gaussian: self.gaussian()?, n: self.range_from_16()? }
            }
            "bell-falls" => Kind::BellFalls { powers: self.powers()? },
            _ => {
                let message = format!("unknown kind \"{kind}\"");
                return Err((self.raw.kind.span().start, message));
            }
        })
    }

    fn cut_form(&mut self) -> Result<CutForm, Problem> {
        let (text, at) = self.needed("form")?;
        match text.as_str() {
            "c/sqrt(n)" => Ok(CutForm::OverRoot),
            "sqrt(c/n)" => Ok(CutForm::RootOver),
            _ => Err((at, format!("`form` is \"{text}\"; known are c/sqrt(n), sqrt(c/n)"))),
        }
    }

    fn powers(&mut self) -> Result<Vec<u32>, Problem> {
        self.used.insert("powers");
        let powers = self.raw.powers.as_ref().ok_or_else(|| self.missing("powers"))?;
        let list = powers.get_ref().clone();
        let sound = list.len() >= 2
            && list.windows(2).all(|w| w[0] < w[1])
            && list[0] >= 1
            && list[list.len() - 1] <= 64;
        if sound {
            Ok(list)
        } else {
            Err((powers.span().start, "`powers` needs two or more ascending K in 1..=64".to_owned()))
        }
    }

    /// What the kind has no use for is an error, not silently ignored.
    fn none_left(&self) -> Result<(), Problem> {
        let kind = self.raw.kind.get_ref();
        let unused = |key: &str, at: usize| (at, format!("kind \"{kind}\" has no `{key}`"));
        for (key, field) in self.plain() {
            if let Some(field) = field
                && !self.used.contains(key)
            {
                return Err(unused(key, field.span().start));
            }
        }
        for (key, _, at) in &self.choice {
            if !self.used.contains(key) {
                return Err(unused(key, *at));
            }
        }
        match &self.raw.powers {
            Some(powers) if !self.used.contains("powers") => Err(unused("powers", powers.span().start)),
            _ => Ok(()),
        }
    }
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
