//! Statements about one's own constants: one verdict on all that is asked, and what would hold instead.

use super::judgement::{Finding, Verdict, compare};
use crate::bound::{Extreme, Extremes, Integral, Interval, LobeIntegral, Residual, short_up};
use crate::fit::{Band, Exponents, FitError, Mended, mend};
use crate::integral::{Case, Field};
use crate::paper::{ClaimedLobe, Normalisation, Printed, Relation};
use dashu_ratio::RBig;

/// Enclosures of a residual, which is relative, that are narrower are so for rounding: no factor of a renderer is
/// given to as many digits.
const HAIR: f64 = 1e-9;

/// What is asked of a factor.
#[derive(Clone, Debug, PartialEq)]
pub enum Demand {
    /// The factor is positive: without that it normalises nothing. Told only where it fails.
    Positive,
    /// |residual| is at most this.
    Bound(Printed),
    /// The residual is at most 0.
    NeverGains,
    /// The residual is at least the negative of this.
    LosesAtMost(Printed),
}

impl Demand {
    /// The word in files.
    pub const fn id(&self) -> &'static str {
        match self {
            Demand::Positive => "positive",
            Demand::Bound(_) => "bound",
            Demand::NeverGains => "never-gains",
            Demand::LosesAtMost(_) => "loses-at-most",
        }
    }

    /// The number asked for, as printed; empty where there is none.
    pub fn printed(&self) -> &str {
        match self {
            Demand::Bound(printed) | Demand::LosesAtMost(printed) => &printed.text,
            Demand::Positive | Demand::NeverGains => "",
        }
    }
}

impl core::fmt::Display for Demand {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Demand::Positive => write!(f, "is positive"),
            Demand::Bound(printed) => write!(f, "|residual| ≤ {}", printed.text),
            Demand::NeverGains => write!(f, "never gains"),
            Demand::LosesAtMost(printed) => write!(f, "loses at most {}", printed.text),
        }
    }
}

/// What one demand came to.
#[derive(Clone, Debug, PartialEq)]
pub struct DemandFinding {
    /// What is asked.
    pub demand: Demand,
    /// The number that decides it: |residual| for a bound, the largest residual for what never gains, the loss
    /// (the negative of the smallest residual) for what loses at most so much.
    pub computed: Interval,
    /// The n at which it is reached; ∞ where it is a limit.
    pub n: f64,
    /// Whether it holds.
    pub verdict: Verdict,
}

/// All that came of one's own constants.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalisationFinding {
    /// Over which n.
    pub exponents: Exponents,
    /// The residual 2π coef(n) Int(n) - 1, certified.
    pub extremes: Extremes,
    /// What is asked, one by one.
    pub demands: Vec<DemandFinding>,
    /// Where not all holds, what would.
    pub mended: Option<Mended>,
}

/// The verdict on all that is asked, with its parts.
///
/// # Errors
/// [`FitError::NoOptimum`] if no rule integrates the lobe, which no lobe that files can name causes.
pub(super) fn normalisation(claim: &Normalisation) -> Result<(Finding, NormalisationFinding), FitError> {
    let integral = integral(claim).ok_or_else(|| FitError::NoOptimum {
        method: "a rule",
        case: format!("{}, {}", claim.model.id(), claim.lobe.id()),
    })?;
    let residual = Residual::new(integral.clone(), &claim.factor);
    let extremes = claim.n.extremes(&residual);
    let demands = demands(claim, &residual, &extremes);
    let verdict = [Verdict::Refuted, Verdict::Undecided]
        .into_iter()
        .find(|verdict| demands.iter().any(|d| d.verdict == *verdict))
        .unwrap_or(Verdict::Proved);
    let band = Band::new(
        claim.bound.as_ref().map(|b| &b.value),
        claim.never_gains,
        claim.loss.as_ref().map(|l| &l.value),
    );
    let mended =
        (verdict != Verdict::Proved).then(|| mend(&integral, claim.n, (&claim.factor, &claim.text), &band));
    // What decides: the first that has the verdict.
    let deciding = demands.iter().find(|d| d.verdict == verdict);
    let asked: Vec<String> =
        demands.iter().filter(|d| d.demand != Demand::Positive).map(|d| d.demand.to_string()).collect();
    let finding = Finding {
        printed: asked.join(", "),
        computed: deciding.map(|d| d.computed),
        verdict,
        witness: witness(verdict, deciding, &extremes),
    };
    Ok((finding, NormalisationFinding { exponents: claim.n, extremes, demands, mended }))
}

fn integral(claim: &Normalisation) -> Option<Integral> {
    let (model, limit) = (claim.model, claim.limit);
    let bell = match &claim.lobe {
        ClaimedLobe::Table(lobe) => return Some(Integral::Closed(Case { model, lobe: *lobe, limit })),
        ClaimedLobe::StandIn(stand_in) => LobeIntegral::new(stand_in.id(), stand_in.formula()?, model)?,
        ClaimedLobe::Polynomial { name, bell } => LobeIntegral::of_polynomial(name, bell.clone(), model)?,
    };
    Some(Integral::Bell(Box::new(bell.at_limit(limit))))
}

fn demands(claim: &Normalisation, residual: &Residual<Integral>, extremes: &Extremes) -> Vec<DemandFinding> {
    let Extremes { max, min } = extremes;
    let (loss, zero) = (-min.value, RBig::int(0));
    let mut found = Vec::new();
    let mut add = |demand, computed, n, verdict| found.push(DemandFinding { demand, computed, n, verdict });
    if min.value.lo() <= -1.0 && !claim.n.have_positive_factor(residual) {
        add(Demand::Positive, min.value, min.n, sign(claim, residual, min));
    }
    // What enclosures leave open is asked of exact numbers: whether all keep the level, or one at hand does not.
    let exactly = |verdict, keeps: &dyn Fn() -> bool, breaks: &dyn Fn(&RBig) -> bool| {
        let at = || [max.n, min.n].into_iter().filter_map(|n| claim.n.exactly(residual, n));
        match verdict {
            Verdict::Undecided if keeps() => Verdict::Proved,
            Verdict::Undecided if at().any(|x| breaks(&x)) => Verdict::Refuted,
            decided => decided,
        }
    };
    if let Some(bound) = &claim.bound {
        let Extreme { value, n } = extremes.magnitude();
        let (lowest, highest) = (zero.clone() - bound.value.clone(), &bound.value);
        let verdict = exactly(
            compare(value, bound, Relation::AtMost),
            &|| claim.n.stay_at_most(residual, highest) && claim.n.stay_at_least(residual, &lowest),
            &|x| *x > *highest || *x < lowest,
        );
        add(Demand::Bound(bound.clone()), value, n, verdict);
    }
    if claim.never_gains {
        let verdict = match () {
            () if max.value.hi() <= 0.0 => Verdict::Proved,
            () if max.value.lo() > 0.0 => Verdict::Refuted,
            () => Verdict::Undecided,
        };
        let verdict = exactly(verdict, &|| claim.n.stay_at_most(residual, &zero), &|x| *x > zero);
        add(Demand::NeverGains, max.value, max.n, verdict);
    }
    if let Some(most) = &claim.loss {
        let lowest = zero.clone() - most.value.clone();
        let verdict = exactly(
            compare(loss, most, Relation::AtMost),
            &|| claim.n.stay_at_least(residual, &lowest),
            &|x| *x < lowest,
        );
        add(Demand::LosesAtMost(most.clone()), loss, min.n, verdict);
    }
    for open in found.iter_mut().filter(|d| d.verdict == Verdict::Undecided) {
        if !open.computed.width().is_finite() {
            open.n = claim.n.unbounded_near(residual).unwrap_or(open.n);
        }
    }
    found
}

/// Of a factor that is not proved positive: whether it is proved not to be at an n. A limit of -1 at n = ∞ says
/// nothing.
fn sign(claim: &Normalisation, residual: &Residual<Integral>, min: &Extreme) -> Verdict {
    let limit = RBig::int(-1);
    let not_positive = min.value.hi() < -1.0
        || residual.has_no_factor()
        || (min.n.is_finite() && claim.n.exactly(residual, min.n).is_some_and(|x| x <= limit));
    if not_positive { Verdict::Refuted } else { Verdict::Undecided }
}

fn witness(verdict: Verdict, deciding: Option<&DemandFinding>, extremes: &Extremes) -> String {
    let Extremes { max, min } = extremes;
    let lowest = format!("{} at {}", number(min.value), place(min.n));
    match deciding {
        Some(d) if verdict != Verdict::Proved => {
            let (value, place) = (number(d.computed), place(d.n));
            let says = match (&d.demand, verdict) {
                (Demand::Positive, Verdict::Refuted) => "is not positive: 2π coef Int - 1 is",
                (Demand::Positive, _) => "is not proved positive: 2π coef Int - 1 is within",
                (Demand::Bound(_), Verdict::Refuted) => "|2π coef Int - 1| reaches",
                (Demand::NeverGains, Verdict::Refuted) => "gains energy: 2π coef Int - 1 reaches",
                (Demand::LosesAtMost(_), Verdict::Refuted) => "loses too much: 1 - 2π coef Int reaches",
                (Demand::Bound(_), _) => "|2π coef Int - 1| is within",
                (Demand::NeverGains, _) => "2π coef Int - 1 reaches up to a value within",
                (Demand::LosesAtMost(_), _) => "1 - 2π coef Int is within",
            };
            format!("{says} {value} at {place}{}", nearly(verdict, d))
        }
        _ if number(max.value) == number(min.value) => format!("2π coef Int - 1 is {lowest}"),
        _ => format!("2π coef Int - 1 runs from {lowest} to {} at {}", number(max.value), place(max.n)),
    }
}

/// What is undecided by a hair is met or missed by one.
fn nearly(verdict: Verdict, found: &DemandFinding) -> String {
    let width = found.computed.width();
    if verdict == Verdict::Undecided && found.demand != Demand::Positive && width < HAIR {
        format!("; met to within {}, which is not decided", short_up(width))
    } else {
        String::new()
    }
}

/// The middle, or both ends where there are not four digits of it.
fn number(value: Interval) -> String {
    let middle = value.mid();
    if value == Interval::ZERO {
        "0".to_owned()
    } else if value.width() > 1e-4 * middle.abs() {
        format!("[{:.2e}, {:.2e}]", value.lo(), value.hi())
    } else if (0.1..1e5).contains(&middle.abs()) {
        format!("{middle:.4}")
    } else {
        format!("{middle:.4e}")
    }
}

fn place(n: f64) -> String {
    if n == f64::INFINITY { "n → ∞".to_owned() } else { format!("n = {}", super::residuals::exponent(n)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_as_far_as_they_are_known() {
        for ((lo, hi), text) in [
            ((0.0, 0.0), "0"),
            ((0.25, 0.25), "0.2500"),
            ((1.0 / 3.0, 1.0 / 3.0 + 1e-9), "0.3333"),
            ((0.05, 0.05), "5.0000e-2"),
            ((2e5, 2e5), "2.0000e5"),
            ((-0.5, -0.5), "-0.5000"),
            ((1.0, 1.001), "[1.00e0, 1.00e0]"),
            ((-1e-9, 2e-9), "[-1.00e-9, 2.00e-9]"),
        ] {
            assert_eq!(number(Interval::new(lo, hi)), text);
        }
    }
    fn asked(demand: Demand, (lo, hi): (f64, f64), verdict: Verdict) -> DemandFinding {
        DemandFinding { demand, computed: Interval::new(lo, hi), n: 16.0, verdict }
    }

    #[test]
    fn demands_print_what_is_asked() {
        let number = Printed::parse("1e-3").unwrap();
        for (demand, id, text, words) in [
            (Demand::Positive, "positive", "", "is positive"),
            (Demand::Bound(number.clone()), "bound", "1e-3", "|residual| ≤ 1e-3"),
            (Demand::NeverGains, "never-gains", "", "never gains"),
            (Demand::LosesAtMost(number), "loses-at-most", "1e-3", "loses at most 1e-3"),
        ] {
            assert_eq!((demand.id(), demand.printed(), demand.to_string().as_str()), (id, text, words));
        }
    }

    /// Only what is left open is called nearly met, and only where the enclosure is a hair wide.
    #[test]
    fn a_hair_is_told_of_what_is_left_open() {
        let (hair, wide) = ((-1e-12, 1e-12), (-1e-3, 1e-3));
        for (demand, ends, verdict, says) in [
            (Demand::NeverGains, hair, Verdict::Undecided, true),
            (Demand::NeverGains, hair, Verdict::Proved, false),
            (Demand::NeverGains, hair, Verdict::Refuted, false),
            (Demand::NeverGains, wide, Verdict::Undecided, false),
            (Demand::Positive, hair, Verdict::Undecided, false),
        ] {
            let text = nearly(verdict, &asked(demand.clone(), ends, verdict));
            assert_eq!(text.contains("met to within 2.000"), says, "{demand:?} {verdict:?}: {text}");
            assert_eq!(text.is_empty(), !says, "{demand:?} {verdict:?}: {text}");
        }
    }

    /// The words say which demand decides, where, and whether it is decided.
    #[test]
    fn witnesses_say_what_decides() {
        let number = Printed::parse("1e-3").unwrap();
        let extreme = |x: f64, n: f64| Extreme { value: Interval::from(x), n };
        let extremes = Extremes { max: extreme(0.25, 16.0), min: extreme(0.125, f64::INFINITY) };
        for (demand, decided, open) in [
            (Demand::Positive, "is not positive", "is not proved positive"),
            (Demand::Bound(number.clone()), "Int - 1| reaches", "Int - 1| is within"),
            (Demand::NeverGains, "gains energy", "reaches up to a value within"),
            (Demand::LosesAtMost(number), "loses too much", "1 - 2π coef Int is within"),
        ] {
            for (verdict, words) in [(Verdict::Refuted, decided), (Verdict::Undecided, open)] {
                let text = witness(verdict, Some(&asked(demand.clone(), (0.5, 0.5), verdict)), &extremes);
                assert!(text.contains(words) && text.contains("0.5000 at n = 16"), "{text}");
            }
        }
        // What is proved is told of all n, whatever demand came first.
        let proved = asked(Demand::NeverGains, (-0.5, -0.5), Verdict::Proved);
        assert_eq!(
            witness(Verdict::Proved, Some(&proved), &extremes),
            "2π coef Int - 1 runs from 0.1250 at n → ∞ to 0.2500 at n = 16"
        );
        let flat = Extremes { max: extreme(0.25, 16.0), min: extreme(0.25, 16.0) };
        assert_eq!(witness(Verdict::Proved, None, &flat), "2π coef Int - 1 is 0.2500 at n = 16");
    }
}
