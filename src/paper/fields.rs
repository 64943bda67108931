//! The fields of a reading: each taken once by its kind, and none left over.

use super::Printed;
use super::claims::Reading;
use super::raw::RawReading;
use std::collections::BTreeSet;

/// An error with its byte offset.
pub(super) type Problem = (usize, String);

/// The most readings that one entry's lists may multiply to.
const MOST: usize = 1024;

/// The readings that a raw one stands for: the product of its lists.
pub(super) fn expand(raw: &RawReading) -> Result<Vec<Reading>, Problem> {
    let mut choices: Vec<Vec<(&str, &str, usize)>> = vec![vec![]];
    let mut ids = vec![raw.id.get_ref().clone()];
    for (key, list) in raw.lists() {
        let Some(list) = list else { continue };
        let (at, list) = (list.span().start, list.get_ref());
        if list.words.is_empty() {
            return Err((at, format!("`{key}` is an empty list")));
        }
        if choices.len() * list.words.len() > MOST {
            return Err((at, format!("`{key}`: the lists make more than {MOST} readings")));
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
pub(super) struct Fields<'a> {
    pub(super) raw: &'a RawReading,
    choice: Vec<(&'a str, &'a str, usize)>,
    pub(super) used: BTreeSet<&'static str>,
}

impl Fields<'_> {
    pub(super) fn missing(&self, key: &str) -> Problem {
        let kind = self.raw.kind.get_ref();
        (self.raw.kind.span().start, format!("kind \"{kind}\" needs `{key}`"))
    }

    pub(super) fn text(&mut self, key: &'static str) -> Option<(String, usize)> {
        self.used.insert(key);
        let field = self.raw.texts().into_iter().find(|(name, _)| *name == key);
        let field = field.and_then(|(_, field)| field.as_ref());
        field.map(|f| (f.get_ref().clone(), f.span().start))
    }

    pub(super) fn needed(&mut self, key: &'static str) -> Result<(String, usize), Problem> {
        self.text(key).ok_or_else(|| self.missing(key))
    }

    pub(super) fn word<T>(
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

    pub(super) fn word_or<T>(
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

    /// One of a list of words.
    pub(super) fn one_of<T: Copy>(
        &mut self,
        key: &'static str,
        all: &[T],
        id: impl Fn(T) -> &'static str,
    ) -> Result<T, Problem> {
        let known: Vec<&str> = all.iter().map(|word| id(*word)).collect();
        self.word(key, |word| all.iter().copied().find(|known| id(*known) == word), &known.join(", "))
    }

    pub(super) fn printed(&mut self, key: &'static str) -> Result<Option<Printed>, Problem> {
        let Some((text, at)) = self.text(key) else { return Ok(None) };
        let read = Printed::parse(&text).ok_or((at, format!("`{key}` is \"{text}\", not a decimal")))?;
        Ok(Some(read))
    }

    pub(super) fn printed_needed(&mut self, key: &'static str) -> Result<Printed, Problem> {
        self.printed(key)?.ok_or_else(|| self.missing(key))
    }

    /// What the kind has no use for is an error, not silently ignored.
    fn none_left(&self) -> Result<(), Problem> {
        let kind = self.raw.kind.get_ref();
        let unused = |key: &str, at: usize| (at, format!("kind \"{kind}\" has no `{key}`"));
        for (key, field) in self.raw.texts() {
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
        let powers = self.raw.powers.as_ref().map(|powers| ("powers", powers.span().start));
        let coefficients = self.raw.coefficients.as_ref().map(|list| ("coefficients", list.span().start));
        match powers.into_iter().chain(coefficients).find(|(key, _)| !self.used.contains(key)) {
            Some((key, at)) => Err(unused(key, at)),
            None => Ok(()),
        }
    }
}
