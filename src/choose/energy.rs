//! The factor that comes along with a lobe, and what it does to the energy.

use super::Exponents;
use crate::bound::{Extreme, Extremes, Format, Interval, LobeIntegral, Residual};
use crate::fit::{self, FactorForm};
use crate::integral::{Case, Limit, Lobe, ScaledIntegral};
use crate::kernel::constants::{CS16_ONE_SIDED, CUBIC_FACTOR};
use crate::kernel::exact::cs_factor;
use crate::kernel::factor::{cos_n_factor, cs_16_factor_one_sided, cubic_factor};
use crate::kernel::model::Model;
use crate::kernel::stand_in::StandIn;

/// What is asked of ∫ = 2π coef(n) Int(n), the integral of lobe and factor under a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EnergyDemand {
    /// ∫ ≤ 1 for every n, the factor's rounding included.
    NeverGains,
    /// |∫ - 1| ≤ error for every n, likewise.
    Unbiased {
        /// The largest |∫ - 1|.
        error: f64,
    },
}

impl EnergyDemand {
    /// `never-gains` or `unbiased`.
    pub const fn id(self) -> &'static str {
        match self {
            EnergyDemand::NeverGains => "never-gains",
            EnergyDemand::Unbiased { .. } => "unbiased",
        }
    }
}

/// Where a factor comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FactorKind {
    /// The closed form of the lobe's own integral, [`cs_factor`] or [`cos_n_factor`].
    Exact,
    /// [`cs_16_factor_one_sided`], a straight line.
    Line,
    /// [`cubic_factor`].
    Cubic,
}

impl FactorKind {
    /// `exact`, `line` or `cubic`.
    pub const fn id(self) -> &'static str {
        match self {
            FactorKind::Exact => "exact",
            FactorKind::Line => "line",
            FactorKind::Cubic => "cubic",
        }
    }
}

/// Which of the two suprema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// ∫ - 1, what is gained.
    Gain,
    /// 1 - ∫, what is lost.
    Loss,
}

/// A factor for every n of a range, computed in `f64` and rounded once to the format.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// Where it comes from.
    pub kind: FactorKind,
    /// The model.
    pub model: Model,
    /// The kernel, as code calls it.
    pub call: String,
    /// What is taken off it before it is rounded to the format: coef (1 - nudge). 0 if it is used as it is.
    pub nudge: f64,
    /// Encloses ∫ - 1 of the lobe in exact arithmetic with this factor as rounded, over every n of the range.
    pub residual: Extremes,
}

impl Factor {
    /// sup of ∫ - 1 or of 1 - ∫, an upper bound with the n that it belongs to; below 0 where nothing is gained
    /// or lost.
    pub fn supremum(&self, side: Side) -> (f64, f64) {
        match side {
            Side::Gain => (self.residual.max.value.hi(), self.residual.max.n),
            Side::Loss => (-self.residual.min.value.lo(), self.residual.min.n),
        }
    }

    /// Upper bound of |∫ - 1| with its n.
    pub fn bias(&self) -> (f64, f64) {
        let (gain, loss) = (self.supremum(Side::Gain), self.supremum(Side::Loss));
        if gain.0 >= loss.0 { gain } else { loss }
    }

    /// Whether the demand is met, by enclosure.
    pub fn meets(&self, demand: EnergyDemand) -> bool {
        match demand {
            EnergyDemand::NeverGains => self.supremum(Side::Gain).0 <= 0.0,
            EnergyDemand::Unbiased { error } => self.bias().0 <= error,
        }
    }

    /// coef(n), computed in `f64` with the nudge and not yet rounded to a format.
    ///
    /// ```
    /// use bellfit::choose::{Costs, EnergyDemand, Need, choose};
    /// use bellfit::kernel::{exact::cs_factor, model::Model, stand_in::StandIn};
    /// let need = Need {
    ///     model: Some(Model::Phong),
    ///     energy: Some(EnergyDemand::NeverGains),
    ///     only: Some(StandIn::Cs16),
    ///     ..Need::new("64".parse()?, 0.02)
    /// };
    /// let answer = choose(&need, &Costs::default())?;
    /// let factor = &answer.best().expect("cs_16 is within 1.8e-2").factors[0];
    /// let exact = cs_factor::<16, f64>(Model::Phong, 64.0);
    /// let rounded = f64::from(factor.at(StandIn::Cs16, 64.0).expect("an n of the range") as f32);
    /// assert!(rounded < exact && rounded > exact * (1.0 - 4.0 * f64::from(f32::EPSILON)));
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn at(&self, stand_in: StandIn, n: f64) -> Option<f64> {
        Some(value(self.kind, stand_in, self.model, n)? * (1.0 - self.nudge))
    }
}

/// The power and the reach T of a bell of degree one.
fn reach(stand_in: StandIn) -> Option<(u32, [f64; 3])> {
    let (_, degree) = stand_in.bell()?;
    stand_in.formula().filter(|_| degree == 1).map(|formula| (formula.power, formula.reach))
}

/// coef(n) in `f64`.
fn value(kind: FactorKind, stand_in: StandIn, model: Model, n: f64) -> Option<f64> {
    let m = 1.0 / n;
    match (kind, stand_in) {
        (FactorKind::Line, StandIn::Cs16) => Some(cs_16_factor_one_sided(model).at(n)),
        (FactorKind::Cubic, StandIn::Cubic2) => Some(cubic_factor::<2, f64>(model, n)),
        (FactorKind::Cubic, StandIn::Cubic4) => Some(cubic_factor::<4, f64>(model, n)),
        (FactorKind::Cubic, StandIn::Cubic8) => Some(cubic_factor::<8, f64>(model, n)),
        (FactorKind::Exact, _) if stand_in.is_exact() => Some(cos_n_factor(model, n)),
        (FactorKind::Exact, _) => {
            // (1 - n w/T)ᴷ is cs_K at the exponent K n/T.
            let (k, [a, b, c]) = reach(stand_in)?;
            let s = f64::from(k) * n / (a + m * (b + m * c));
            match k {
                2 => Some(cs_factor::<2, f64>(model, s)),
                4 => Some(cs_factor::<4, f64>(model, s)),
                8 => Some(cs_factor::<8, f64>(model, s)),
                16 => Some(cs_factor::<16, f64>(model, s)),
                32 => Some(cs_factor::<32, f64>(model, s)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Relative error of [`cs_factor`] in `f64`: its page's 10.29 ε, rounded up.
const EXACT_BELL: f64 = 11.0 * f64::EPSILON;
/// Of [`cos_n_factor`]: at most ten roundings of ε/2, and libm's 2^(-n/2), within 1 ulp of at most 1.
const EXACT_COSINE: f64 = 8.0 * f64::EPSILON;
/// Of [`cubic_factor`] and the straight line: their pages' 4 ε and 2 ε, and ε for each constant's decimal that
/// was certified.
const FITTED: f64 = 6.0 * f64::EPSILON;

/// The factors that there are for a lobe and a model over a range, best first, as they are; or, where a
/// demand asks for ∫ ≤ 1, lowered until they keep to it. An empty list says why.
pub(super) fn factors(
    stand_in: StandIn,
    model: Model,
    n: Exponents,
    format: Format,
    demand: Option<EnergyDemand>,
) -> Result<Vec<Factor>, String> {
    let mut found = Vec::new();
    let kinds = [FactorKind::Exact, FactorKind::Cubic, FactorKind::Line];
    for kind in kinds {
        let Some((exact, arithmetic)) = certificate(kind, stand_in, model, n)? else { continue };
        // Rounded to the format once more, with the product by 1 - nudge before.
        let error = arithmetic + f64::EPSILON + format.unit_roundoff();
        let call = call(kind, stand_in, model);
        let mut factor = Factor { kind, model, call, nudge: 0.0, residual: spread(exact, 0.0, error) };
        if demand == Some(EnergyDemand::NeverGains) && !factor.meets(EnergyDemand::NeverGains) {
            let gain = factor.supremum(Side::Gain).0;
            // The least power of two that takes it all off: exact as a double, and so is 1 less it.
            factor.nudge = libm::exp2(libm::ceil(libm::log2(gain)));
            factor.residual = spread(exact, factor.nudge, error);
        }
        found.push(factor);
    }
    if found.is_empty() {
        return Err(format!("no factor is known for {}", stand_in.id()));
    }
    let (format_most, largest) =
        (most(format), found.iter().filter_map(|f| f.at(stand_in, n.to())).fold(0.0, f64::max));
    if largest > format_most {
        return Err(format!("the factor, {largest:.4e} at n = {}, is beyond {}", n.to(), format.id()));
    }
    found.sort_by(|a, b| a.bias().0.total_cmp(&b.bias().0));
    Ok(found)
}

/// The largest number of a format, with room for a rounding.
fn most(format: Format) -> f64 {
    match format {
        Format::Half => 65504.0,
        // The factor of a material is a constant: in the arithmetic's format.
        Format::HalfStored | Format::Single => f64::from(f32::MAX),
        Format::Double => f64::MAX,
    }
}

/// (1 + residual)(1 - nudge)(1 ± error) - 1.
fn spread(exact: Extremes, nudge: f64, error: f64) -> Extremes {
    let one = Interval::from(1.0);
    let error = one + Interval::new(-error, error);
    let of =
        |e: Extreme| Extreme { value: (one + e.value) * (one - Interval::from(nudge)) * error - one, n: e.n };
    Extremes { max: of(exact.max), min: of(exact.min) }
}

/// The residual of a factor in exact arithmetic over the range, and the relative error of its `f64` code;
/// `None` where the kind is not one of this lobe's.
fn certificate(
    kind: FactorKind,
    stand_in: StandIn,
    model: Model,
    n: Exponents,
) -> Result<Option<(Extremes, f64)>, String> {
    let (from, to) = n.outward();
    let nothing = Extreme { value: Interval::from(0.0), n: n.from() };
    let zero = Extremes { max: nothing, min: nothing };
    match (kind, stand_in) {
        (FactorKind::Exact, _) if stand_in.is_exact() => Ok(Some((zero, EXACT_COSINE))),
        (FactorKind::Exact, _) => {
            let Some((_, coefficients)) = reach(stand_in) else { return Ok(None) };
            // |d ln coef/d ln n| ≤ 1, as n Int(n) rises with n and Int(n) falls: T's error counts at most once.
            let m = Interval::new((1.0 / to).next_down(), (1.0 / from).next_up());
            let [a, b, c] = coefficients.map(Interval::from);
            let reach = a + m * (b + m * c);
            if reach.lo() <= 0.0 {
                return Ok(None);
            }
            let terms = a.abs() + m * (b.abs() + m * c.abs());
            let of_reach = 4.0 * f64::EPSILON * terms.hi() / reach.lo();
            Ok(Some((zero, EXACT_BELL + of_reach + 2.0 * f64::EPSILON)))
        }
        (FactorKind::Line, StandIn::Cs16) => {
            let [a, b, divisor] = CS16_ONE_SIDED[model as usize];
            let factor = decimal_factor(FactorForm::Linear, &[a, b], divisor)?;
            let case = Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
            let extremes = extremes(&Residual::new(case, factor.formula()), from, to);
            // Outside 16..1024 the line goes on and is worth nothing.
            let is_useful = extremes.min.value.lo() > -0.01 && extremes.max.value.hi() < 0.01;
            Ok(is_useful.then_some((extremes, FITTED)))
        }
        (FactorKind::Cubic, StandIn::Cubic2 | StandIn::Cubic4 | StandIn::Cubic8) => {
            if from < 16.0 {
                return Err(format!("the factor of {} is proved from n = 16 on", stand_in.id()));
            }
            let Some(formula) = stand_in.formula() else { return Ok(None) };
            let row = formula.power.trailing_zeros() as usize - 1;
            let [parameters @ .., divisor] = CUBIC_FACTOR[row][model as usize];
            let factor = decimal_factor(FactorForm::InverseSquare, &parameters, divisor)?;
            let integral = LobeIntegral::new(stand_in.id(), formula, model).ok_or("no integral")?;
            Ok(Some((extremes(&Residual::new(integral, factor.formula()), from, to), FITTED)))
        }
        _ => Ok(None),
    }
}

fn extremes<I: ScaledIntegral>(residual: &Residual<I>, from: f64, to: f64) -> Extremes {
    if from == to {
        let here = Extreme { value: residual.at(from), n: from };
        return Extremes { max: here, min: here };
    }
    Extremes { max: residual.largest(from, to), min: residual.smallest(from, to) }
}

/// The constants as the decimals that they were printed from.
fn decimal_factor(form: FactorForm, parameters: &[f64], divisor: f64) -> Result<fit::Factor, String> {
    let texts: Vec<String> = parameters.iter().map(f64::to_string).collect();
    fit::Factor::new(form, &texts, divisor as u32).ok_or_else(|| format!("{texts:?} are no decimals"))
}

fn call(kind: FactorKind, stand_in: StandIn, model: Model) -> String {
    let model = format!("Model::{model:?}");
    match (kind, stand_in.bell()) {
        (FactorKind::Line, _) => format!("cs_16_factor_one_sided({model}).at(n)"),
        (FactorKind::Cubic, Some((k, _))) => format!("cubic_factor::<{k}, f64>({model}, n)"),
        (FactorKind::Exact, Some((16, _))) if stand_in == StandIn::Cs16 => {
            format!("cs_factor::<16, f64>({model}, n)")
        }
        (FactorKind::Exact, Some((k, _))) => format!("cs_factor::<{k}, f64>({model}, {k} n/T)"),
        _ => format!("cos_n_factor::<f64>({model}, n)"),
    }
}
