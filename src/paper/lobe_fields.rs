//! The fields of the kinds about lobes, and the choice among all kinds.

use super::claims::parse_range;
use super::fields::{Fields, Problem};
use super::{Comparison, CutForm, Kind, Over, Relation, Statistic};
use crate::bound::{Formula, Gaussian};
use crate::fit::{Form, Objective};
use crate::integral::albedo::{Reflectance, Usage};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;

impl Fields<'_> {
    pub(super) fn formula(&mut self, key: &'static str) -> Result<Formula, Problem> {
        let (text, at) = self.needed(key)?;
        text.parse().map_err(|error: crate::bound::FormulaError| (at, error.to_string()))
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

    pub(super) fn model(&mut self, key: &'static str) -> Result<Model, Problem> {
        let known = Model::ALL.map(Model::id).join(", ");
        self.word(key, Model::from_id, &known)
    }

    fn case(&mut self) -> Result<Case, Problem> {
        let model = self.model("model")?;
        let lobe = self.lobe()?;
        let limit = self.limit("limit")?;
        if !lobe.limits().contains(&limit) {
            let at = self.raw.kind.span().start;
            return Err((at, "lobe cos-n is integrated over its support only".to_owned()));
        }
        Ok(Case { model, lobe, limit })
    }

    fn lobe(&mut self) -> Result<Lobe, Problem> {
        self.word_or("lobe", Lobe::Cs16, Lobe::from_id, "cos-n, cs16")
    }

    /// A model in its use; only a distribution of normals has two.
    fn reflectance(&mut self) -> Result<Reflectance, Problem> {
        let model = self.model("model")?;
        let usage = self.word_or("use", Usage::Printed, Usage::from_id, "printed, microfacet")?;
        let at = self.raw.usage.as_ref().map_or(0, |u| u.span().start);
        Reflectance::new(model, usage)
            .ok_or_else(|| (at, format!("model {} has no use \"{}\"", model.id(), usage.id())))
    }

    fn limit(&mut self, key: &'static str) -> Result<Limit, Problem> {
        self.word(key, Limit::from_id, &Limit::ALL.map(Limit::id).join(", "))
    }

    pub(super) fn over(&mut self) -> Result<Over, Problem> {
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

    /// The reading's kind with its parameters.
    pub(super) fn kind(&mut self) -> Result<Kind, Problem> {
        let kind = self.raw.kind.get_ref().as_str();
        let unknown = || {
            let known = Kind::IDS.join(", ");
            (self.raw.kind.span().start, format!("unknown kind \"{kind}\"; known are {known}"))
        };
        if !Kind::IDS.contains(&kind) {
            return Err(unknown());
        }
        Ok(match kind {
            "normalisation" => Kind::Normalisation(Box::new(self.normalisation()?)),
            "definition" => Kind::Definition { place: self.needed("place")?.0 },
            "factor-residual" => {
                let printed = self.printed("printed")?;
                let place = if printed.is_none() { self.text("place").map(|(text, _)| text) } else { None };
                if printed.is_none() && place.is_none() {
                    return Err(self.missing("printed"));
                }
                Kind::FactorResidual {
                    case: self.case()?,
                    factor: self.formula("factor")?,
                    text: self.needed("factor")?.0,
                    n: self.range()?,
                    over: self.over()?,
                    statistic: self.statistic()?,
                    relation: self.relation()?,
                    printed,
                    place,
                }
            }
            "energy" => Kind::Energy {
                case: self.case()?,
                factor: self.formula("factor")?,
                n: self.range()?,
                over: self.over()?,
            },
            "energy-at-every-angle" => Kind::EnergyAtEveryAngle {
                reflectance: self.reflectance()?,
                lobe: self.lobe()?,
                factor: self.formula("factor")?,
                n: self.range()?,
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
            _ => match self.pixel_kind(kind)? {
                Some(pixel) => Kind::Pixel(Box::new(pixel)),
                None => return Err((self.raw.kind.span().start, format!("unknown kind \"{kind}\""))),
            },
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
}
