//! The fields of the kind for one's own constants.

use super::fields::{Fields, Problem};
use super::{ClaimedLobe, Normalisation, Over, Printed};
use crate::bound::{PolynomialBell, PolynomialBellError, decimal};
use crate::fit::{Exponents, Reals};
use crate::integral::{Field, Limit, Lobe};
use crate::kernel::model::{Convention, Model};
use crate::kernel::stand_in::StandIn;
use dashu_ratio::RBig;

/// Most characters of a coefficient.
const LONGEST: usize = 30;

/// The conventions by their names.
const CONVENTIONS: [(&str, Convention); 4] = [
    ("rdf", Convention::Rdf),
    ("rdf-cosine", Convention::RdfCosine),
    ("ndf", Convention::Ndf),
    ("heightfield", Convention::Heightfield),
];

impl Fields<'_> {
    pub(super) fn normalisation(&mut self) -> Result<Normalisation, Problem> {
        let model = self.model_by_convention()?;
        let lobe = self.any_lobe()?;
        let limit = self.any_limit(&lobe)?;
        let (factor, text) = (self.formula("factor")?, self.needed("factor")?.0);
        let n = self.exponents(&lobe)?;
        let bound = self.decimal_within("bound", "0 or more", |x| *x >= RBig::int(0))?;
        let is_asked = self.asked("energy").is_some();
        let only = |word: &str| (word == "never-gains").then_some(true);
        let never_gains = self.word_or("energy", false, only, "never-gains")?;
        let inside = |x: &RBig| *x >= RBig::int(0) && *x < RBig::int(1);
        let loss = self.decimal_within("loses-at-most", "0 or more and less than 1", inside)?;
        let at = self.raw.loses_at_most.as_ref().map_or(0, |field| field.span().start);
        if loss.is_some() && !is_asked {
            return Err((at, "`loses-at-most` stands beside `energy = \"never-gains\"` only".to_owned()));
        }
        if bound.is_none() && !is_asked {
            let message = "kind \"normalisation\" needs `bound` or `energy`: what is asked of the factor";
            return Err((self.raw.kind.span().start, message.to_owned()));
        }
        Ok(Normalisation { model, lobe, limit, factor, text, n, bound, never_gains, loss })
    }

    /// One of the six models, or "phong" and "blinn-phong" told apart by a convention.
    fn model_by_convention(&mut self) -> Result<Model, Problem> {
        let model = self.model("model")?;
        let Some(at) = self.asked("convention") else {
            return Ok(model);
        };
        let known = CONVENTIONS.map(|(word, _)| word).join(", ");
        let read = |word: &str| CONVENTIONS.into_iter().find(|(known, _)| *known == word);
        let (word, convention) = self.word("convention", read, &known)?;
        // A name without an ending leaves the convention open.
        let family = matches!(model, Model::Phong | Model::BlinnPhong);
        let of_family = |other: &Model| {
            *other == model
                || (family && other.id().strip_prefix(model.id()).is_some_and(|e| e.starts_with('-')))
        };
        let fits: Vec<Model> = Model::ALL.into_iter().filter(of_family).collect();
        fits.iter().copied().find(|m| m.convention() == convention).ok_or_else(|| {
            let words = CONVENTIONS.into_iter().filter(|(_, c)| fits.iter().any(|m| m.convention() == *c));
            let words: Vec<&str> = words.map(|(word, _)| word).collect();
            let id = model.id();
            (at, format!("model {id} has no `convention` \"{word}\"; it has {}", words.join(", ")))
        })
    }

    fn any_lobe(&mut self) -> Result<ClaimedLobe, Problem> {
        let known = ClaimedLobe::IDS.join(", ");
        let read = |word: &str| ClaimedLobe::IDS.into_iter().find(|id| *id == word);
        let name = self.word("lobe", read, &known)?;
        if name == "polynomial" {
            return Ok(ClaimedLobe::Polynomial { name: name.to_owned(), bell: self.polynomial()? });
        }
        if let Some(lobe) = Lobe::from_id(name) {
            return Ok(ClaimedLobe::Table(lobe));
        }
        if let Some(stand_in) = StandIn::from_id(name) {
            return Ok(ClaimedLobe::StandIn(stand_in));
        }
        let power = name.strip_prefix("cs").and_then(|power| power.parse().ok()).unwrap_or(0);
        let bell = PolynomialBell::new(&[RBig::int(1), RBig::int(-1)], power);
        let at = self.asked("lobe").unwrap_or(0);
        let bell = bell.map_err(|error| (at, error.to_string()))?;
        Ok(ClaimedLobe::Polynomial { name: name.to_owned(), bell })
    }

    /// A bell by `coefficients` and `power`.
    fn polynomial(&mut self) -> Result<PolynomialBell, Problem> {
        let powers = [1, 2, 4, 8, 16, 32, 64];
        let read = |word: &str| powers.into_iter().find(|power| power.to_string() == word);
        let power = self.word("power", read, &powers.map(|power| power.to_string()).join(", "))?;
        self.used.insert("coefficients");
        let list = self.raw.coefficients.as_ref().ok_or_else(|| self.missing("coefficients"))?;
        let mut exact = Vec::new();
        for number in list.get_ref() {
            let (text, at) = (&number.get_ref().0, number.span().start);
            let value = decimal(text).filter(|_| text.len() <= LONGEST).ok_or_else(|| {
                let shown: String = text.chars().take(2 * LONGEST).collect();
                let message =
                    format!("`coefficients` has \"{shown}\", not a decimal of at most {LONGEST} characters");
                (at, message)
            })?;
            exact.push(value.0);
        }
        if exact.is_empty() {
            return Err((
                list.span().start,
                "`coefficients`: the list is empty; it begins with 1, p's peak".to_owned(),
            ));
        }
        PolynomialBell::new(&exact, power).map_err(|error| {
            let at = match error {
                PolynomialBellError::Power { .. } => self.asked("power"),
                PolynomialBellError::Peak { .. } => list.get_ref().first().map(|number| number.span().start),
                _ => None,
            };
            (at.unwrap_or(list.span().start), format!("`coefficients`: {error}"))
        })
    }

    fn any_limit(&mut self, lobe: &ClaimedLobe) -> Result<Limit, Problem> {
        let known = Limit::ALL.map(Limit::id).join(", ");
        let limit = self.word_or("limit", Limit::Support, Limit::from_id, &known)?;
        if *lobe == ClaimedLobe::Table(Lobe::CosN) && limit != Limit::Support {
            let at = self.asked("limit").unwrap_or(0);
            return Err((at, "lobe cos-n is integrated over its support only".to_owned()));
        }
        Ok(limit)
    }

    /// The range of n, and what it is taken over: every real number unless `over` says otherwise.
    fn exponents(&mut self, lobe: &ClaimedLobe) -> Result<Exponents, Problem> {
        let over = if self.asked("over").is_some() { self.over()? } else { Over::Reals };
        let (text, at) = self.needed("n")?;
        let n = match over {
            Over::Integers => super::parse_range(&text).map(|(from, to)| Exponents::Integers(from, to)),
            Over::Reals => text.parse::<Reals>().map(Exponents::Reals).map_err(|error| {
                let hint = "; one whole n is asked about with `over = \"integers\"`";
                format!("{error}{}", if super::parse_range(&text).is_ok() { hint } else { "" })
            }),
        };
        let n = n.map_err(|message| (at, message))?;
        let first = match n {
            Exponents::Integers(from, _) => f64::from(from),
            Exponents::Reals(reals) => reals.outward().0,
        };
        if matches!(lobe, ClaimedLobe::StandIn(_)) && first < 16.0 {
            return Err((at, format!("n = {text}: lobe {} is there for n ≥ 16", lobe.id())));
        }
        Ok(n)
    }

    /// Where a word stands, if it does.
    fn asked(&self, key: &str) -> Option<usize> {
        let mut lists = self.raw.lists().into_iter().filter(|(name, _)| *name == key);
        lists.find_map(|(_, list)| list.as_ref().map(|list| list.span().start))
    }

    fn decimal_within(
        &mut self,
        key: &'static str,
        domain: &str,
        inside: impl Fn(&RBig) -> bool,
    ) -> Result<Option<Printed>, Problem> {
        let Some(printed) = self.printed(key)? else { return Ok(None) };
        if inside(&printed.value) {
            return Ok(Some(printed));
        }
        let at = self.text(key).map_or(0, |(_, at)| at);
        Err((at, format!("`{key}` is \"{}\": {domain} is needed", printed.text)))
    }
}
