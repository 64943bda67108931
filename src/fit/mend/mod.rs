//! Constants that do not hold what is asked of them: the nearest that do.

mod digits;
mod forms;
mod multiple;

use super::continuum::{Continuum, Sample};
use super::{Band, Exponents, Factor, FactorForm, Line};
use crate::bound::{Extremes, Formula, Residual};
use crate::integral::ScaledIntegral;

/// Whole numbers at the beginning of a range that a search looks at one by one; beyond, by steps.
const EACH: u32 = 256;
/// The step beyond, relative.
const STEP: f64 = 0.01;
/// What doubles may be wrong by, relative: nothing that touches an end is left out; enclosures decide.
const SLACK: f64 = 1e-11;
/// Candidates that enclosures may refuse before a search goes on to the next kind.
const TRIES: usize = 6;

/// How constants were changed.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// So many of the line's digits are others.
    Digits {
        /// The line with them.
        line: Line,
        /// How many.
        changed: usize,
    },
    /// All are multiplied by this decimal.
    Multiple {
        /// The decimal.
        by: String,
    },
    /// Another factor stands in their place, of the simplest form that can hold.
    Form {
        /// The factor.
        factor: Factor,
        /// Significant digits of its parameters, at most.
        digits: usize,
    },
}

impl Change {
    /// The word in files.
    pub const fn id(&self) -> &'static str {
        match self {
            Change::Digits { .. } => "digits",
            Change::Multiple { .. } => "multiple",
            Change::Form { .. } => "form",
        }
    }
}

/// A factor that holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Remedy {
    /// What was changed.
    pub change: Change,
    /// The factor as a claims file writes it.
    pub source: String,
    /// Its certified residual.
    pub extremes: Extremes,
}

/// A form no factor of which can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RuledOut {
    /// The form.
    pub form: FactorForm,
    /// A lower bound, certified, of the largest |residual| of any factor of this form.
    pub level: f64,
    /// The largest such level that a multiple brings inside what is asked.
    pub most: f64,
}

/// What there is in the place of constants that do not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    /// The nearest that hold, certified; `None` if none was found.
    pub remedy: Option<Remedy>,
    /// The forms that cannot, as far as they were looked at.
    pub ruled_out: Vec<RuledOut>,
}

/// The nearest constants that keep a residual inside a band.
///
/// In this order, the first that enclosures certify:
/// 1. of a line (a n + b)/(d π): the fewest digits of a and b changed, up to four, as it is written out with finite
///    decimals; among those the smallest |residual|; one that loses more than half, and more than the line does,
///    comes last;
/// 2. of any other factor: its multiple by the decimal of fewest digits, of those the nearest to 1;
/// 3. the simplest [`FactorForm`] that can, in the fewest digits that were found to do.
///
/// A form that provably cannot is in [`Mended::ruled_out`]. Searches are in doubles, and bounded: what is found
/// is proved, that nothing nearer exists is not.
///
/// ```
/// use bellfit::{bound::Integral, integral::{Case, Limit, Lobe}, kernel::model::Model};
/// use bellfit::fit::{Band, Exponents, mend};
/// let case = Case { model: Model::BlinnPhongModified, lobe: Lobe::CosN, limit: Limit::Support };
/// let (n, text) = (Exponents::Integers(16, 1024), "(n + 8)/(8*pi)");
/// let mended = mend(&Integral::Closed(case), n, (&text.parse()?, text), &Band::new(None, true, None));
/// assert_eq!(mended.remedy.expect("a line").source, "(n + 6)/(8*pi)");
/// # Ok::<(), bellfit::bound::FormulaError>(())
/// ```
pub fn mend<I: ScaledIntegral + Clone>(
    integral: &I,
    exponents: Exponents,
    (factor, text): (&Formula, &str),
    band: &Band,
) -> Mended {
    let mut mended = Mended { remedy: None, ruled_out: vec![] };
    let Some(reals) = exponents.reals().filter(|r| r.inward().is_some_and(|(first, last)| first < last))
    else {
        return mended;
    };
    let continuum = Continuum::new(integral, reals);
    let search = Search { samples: samples(&continuum, exponents), continuum: &continuum, exponents, band };
    let (found, losing) = match Line::from_formula(factor) {
        Some(line) => search.by_digits(&line),
        None => (search.by_multiple(factor, text), None),
    };
    mended.remedy = found;
    if mended.remedy.is_none() {
        (mended.remedy, mended.ruled_out) = search.by_form();
        mended.remedy = mended.remedy.or(losing);
    }
    mended
}

/// One integral, range and band.
struct Search<'a, I> {
    continuum: &'a Continuum<'a, I>,
    exponents: Exponents,
    band: &'a Band,
    /// What doubles look at.
    samples: Vec<Sample>,
}

impl<I: ScaledIntegral + Clone> Search<'_, I> {
    /// The factor's extremes, if they are proved to lie inside the band.
    fn certified(&self, factor: &Formula) -> Option<Extremes> {
        let extremes = self.exponents.extremes(&Residual::new(self.continuum.integral.clone(), factor));
        self.band.holds(&extremes).then_some(extremes)
    }

    /// Where 1 + residual has to lie, a little wider.
    fn allowed(&self) -> (f64, f64) {
        let (low, high) = self.band.ends();
        ((1.0 + low) * (1.0 - SLACK) - SLACK, (1.0 + high) * (1.0 + SLACK))
    }
}

/// Every whole number, or the first of them and steps; the continuum's own samples for reals.
fn samples<I: ScaledIntegral>(continuum: &Continuum<'_, I>, exponents: Exponents) -> Vec<Sample> {
    let Exponents::Integers(from, to) = exponents else { return continuum.samples.clone() };
    let mut n = from;
    let mut all = Vec::new();
    while n < to {
        all.push(n);
        let step = if n - from < EACH { 1.0 } else { libm::ceil(STEP * f64::from(n)) };
        n = n.saturating_add(step as u32);
    }
    all.push(to);
    all.into_iter().map(|n| continuum.at(1.0 / f64::from(n))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::decimal;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    fn case(model: Model, lobe: Lobe) -> Case {
        Case { model, lobe, limit: Limit::Support }
    }

    fn band(bound: &str, never_gains: bool) -> Band {
        let bound = decimal(bound).unwrap().0;
        Band::new(Some(&bound), never_gains, None)
    }

    fn found(case: Case, n: Exponents, text: &str, band: &Band) -> Mended {
        mend(&case, n, (&text.parse().unwrap(), text), band)
    }

    /// Phong's exact factor is 1.0625 n: from 1.0125 the one digit that helps is the third, whatever is asked.
    #[test]
    fn a_wrong_digit_is_found_again_for_every_demand() {
        let phong = case(Model::Phong, Lobe::Cs16);
        for n in [Exponents::Integers(16, 1024), Exponents::Reals("16..inf".parse().unwrap())] {
            for band in [band("1e-6", false), band("1e-6", true)] {
                let remedy = found(phong, n, "1.0125*n/(2*pi)", &band).remedy.unwrap();
                assert_eq!(remedy.source, "1.0625*n/(2*pi)");
                assert!(matches!(remedy.change, Change::Digits { changed: 1, .. }));
            }
        }
    }

    /// (n + 1)(1 + 2^-n) is no line; Int = 1/(n + 1) makes the residual 2^-n, 1/65536 at n = 16, so what never
    /// gains is a multiple below 1/(1 + 2^-16) = 0.99998474…, and with n = 64 almost at 1 what loses b is 1 - b.
    #[test]
    fn what_is_no_line_is_scaled() {
        let phong = case(Model::Phong, Lobe::CosN);
        let text = "(n + 1)*(1 + 2^(-n))/(2*pi)";
        let n = Exponents::Reals("16..64".parse().unwrap());
        for (bound, by) in [("0.2", "0.9"), ("0.02", "0.99"), ("1.5e-3", "0.999"), ("3e-5", "0.99998")] {
            let remedy = found(phong, n, text, &band(bound, true)).remedy.unwrap();
            assert_eq!(remedy.change, Change::Multiple { by: by.to_owned() }, "{bound}");
            assert!(remedy.source.parse::<Formula>().is_ok());
        }
    }

    /// Blinn-Phong (modified) over cs_16 is no line: 4.93e-3 is the least of all, and 1e-3 takes another form.
    #[test]
    fn where_no_line_can_another_form_does_and_the_line_is_ruled_out() {
        let blinn = case(Model::BlinnPhongModified, Lobe::Cs16);
        for n in [Exponents::Integers(16, 1024), Exponents::Reals("16..1024".parse().unwrap())] {
            let mended = found(blinn, n, "(1.027*n + 4.8)/(8*pi)", &band("1e-3", false));
            let forms: Vec<FactorForm> = mended.ruled_out.iter().map(|r| r.form).collect();
            assert_eq!(forms, [FactorForm::Proportional, FactorForm::Linear]);
            let line = &mended.ruled_out[1];
            assert!(line.level > 4.9e-3 && line.level < 4.932e-3 && line.most < 1.1e-3, "{line:?}");
            let remedy = mended.remedy.unwrap();
            assert!(
                matches!(remedy.change, Change::Form { .. })
                    && remedy.extremes.magnitude().value.hi() <= 1e-3
            );
        }
        // The best line itself is within 5e-3, at more digits than are printed.
        let n = Exponents::Integers(16, 1024);
        let mended = found(blinn, n, "(9*n + 9)/(8*pi)", &band("5e-3", false));
        let Some(Remedy { change: Change::Form { factor, .. }, .. }) = mended.remedy else {
            panic!("{mended:?}")
        };
        assert_eq!(factor.form(), FactorForm::Linear);
    }

    #[test]
    fn where_nothing_can_every_form_is_ruled_out() {
        let blinn = case(Model::BlinnPhongModified, Lobe::Cs16);
        let n = Exponents::Reals("1..1024".parse().unwrap());
        let mended = found(blinn, n, "(1.027*n + 4.8)/(8*pi)", &band("1e-12", false));
        assert!(mended.remedy.is_none() && mended.ruled_out.len() == FactorForm::ALL.len(), "{mended:?}");
        // One whole number rules nothing out.
        let mended = found(blinn, Exponents::Integers(100, 100), "n/(8*pi)", &band("1e-9", false));
        assert!(mended.ruled_out.is_empty(), "{mended:?}");
    }
    /// Whole numbers one by one at first, then by a hundredth; both ends are among them.
    #[test]
    fn whole_numbers_are_sampled_from_end_to_end() {
        let case = case(Model::Phong, Lobe::Cs16);
        for (from, to, count) in [(16, 16, 1), (16, 40, 25), (16, 271, 256), (16, 5000, 0)] {
            let reals = Exponents::Integers(from, to).reals().unwrap();
            let all = samples(&Continuum::new(&case, reals), Exponents::Integers(from, to));
            let n: Vec<f64> = all.iter().map(|s| 1.0 / s.m).collect();
            let is = |n: f64, whole: u32| (n / f64::from(whole) - 1.0).abs() < 1e-15;
            assert!(is(n[0], from) && is(n[n.len() - 1], to), "{from}..{to}");
            assert!(n.iter().zip(from..=271).all(|(n, whole)| is(*n, whole)), "{from}..{to}");
            assert!(count == 0 || n.len() == count, "{from}..{to}: {}", n.len());
            // A step of a hundredth, rounded up to a whole number.
            assert!(
                n.windows(2).all(|pair| pair[1] > pair[0] && pair[1] - pair[0] < 0.01 * pair[0] + 1.0 + 1e-9)
            );
        }
        let reals = Exponents::Integers(16, 65_536).reals().unwrap();
        let all = samples(&Continuum::new(&case, reals), Exponents::Integers(16, 65_536));
        // 256 of them, and ln(65536/272)/ln 1.01 = 551 steps; fewer, as steps are rounded up.
        assert!((700..=808).contains(&all.len()), "{}", all.len());
    }
}
