//! The sentences on errors, from enclosures computed at emission.

use super::ShaderError;
use super::lobe::formula;
use crate::bound::{
    Extremes, Formula, LobeIntegral, Residual, cosine_bell, exponential_bell, short, short_down, short_up,
};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::constants::{CS16_ONE_SIDED, CUBIC_EXP, CUBIC_FACTOR};
use crate::kernel::model::Model;
use crate::kernel::stand_in::StandIn;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// The smallest n of the proofs.
const FROM: f64 = 16.0;
/// To which suprema are enclosed, relative: that of the tables, so that both print the same bound.
const TOLERANCE: f64 = 2e-4;

/// Sentences by what they are about, each computed once a process.
static SENTENCES: Mutex<BTreeMap<String, String>> = Mutex::new(BTreeMap::new());

fn once(about: String, compute: impl FnOnce() -> Option<String>) -> Result<String, ShaderError> {
    let mut sentences = SENTENCES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = sentences.get(&about) {
        return Ok(known.clone());
    }
    let sentence = compute().ok_or_else(|| ShaderError::Uncertified(about.clone()))?;
    sentences.insert(about, sentence.clone());
    Ok(sentence)
}

fn place(n: f64) -> String {
    if n.is_finite() { format!("n = {}", short(n)) } else { "n -> infinity".to_owned() }
}

/// How far a stand-in is from cosⁿ, and what is proved of that.
pub(super) fn lobe_error(stand_in: StandIn) -> Result<String, ShaderError> {
    if formula(stand_in).is_some() {
        return once(stand_in.id().to_owned(), || bell_error(stand_in));
    }
    Ok(match stand_in {
        StandIn::Squarings => {
            "cosⁿ but for rounding: relative at most (n - 1) u to the first order, u half the type's epsilon, \
             barring underflow."
        }
        StandIn::Exp2Log2 | StandIn::Power => {
            "cosⁿ but for rounding, which is the language's: that of n log2 cos θ stands in the exponent."
        }
        StandIn::Schlick => {
            "another lobe than cosⁿ, of which no distance is stated here; its rounding relative at most 4 u to the \
             first order for correctly rounded operations, u half the type's epsilon."
        }
        StandIn::SchlickPrinted => {
            "another lobe than cosⁿ, of which no distance is stated here; the denominator near 1 loses about n u, u \
             half the type's epsilon."
        }
        _ => "another lobe than cosⁿ, of which no distance is stated here; rounding is that of the language's exp.",
    }
    .to_owned())
}

fn bell_error(stand_in: StandIn) -> Option<String> {
    let bell = formula(stand_in)?;
    let power = bell.power;
    // Where |e⁻ᵗ - bell| has its maximum, cosⁿ's is not far for any n: a seed saves time and proves nothing.
    let [reach, alpha, beta] = [bell.reach[0], bell.linear[0], bell.square[0]];
    // (1 - y)(1 + α y + β y²), y = t/T, in z = t/K
    let ratio = f64::from(power) / reach;
    let coefficients = [(1.0 - alpha) * ratio, (beta - alpha) * ratio * ratio, beta * ratio * ratio * ratio];
    let limit = exponential_bell(power, coefficients, None, 1e-9)?.0;
    let seeds = [[0.0, limit.at[0] / reach], [1.0 / FROM, limit.at[0] / reach]];
    let (error, proof) = cosine_bell(&bell, FROM, &seeds, TOLERANCE * limit.value.hi())?;
    if !(proof.decreasing && proof.continuous && proof.negative_beyond) {
        return None;
    }
    let [m, y] = error.at;
    let [a, b, c] = bell.reach;
    Some(format!(
        "|lobe - cosⁿ θ| <= {}, certified in exact arithmetic for every θ in [0, pi/2] and every real n >= 16; reached \
         to {TOLERANCE:e} of it at {}, n (1 - cos θ) = {}. It falls to its cut without a jump.",
        short_up(error.value.hi()),
        place(1.0 / m),
        short(y * (a + m * (b + m * c)))
    ))
}

/// The residual of the line of cs_16.
pub(super) fn line_error(model: Model) -> Result<String, ShaderError> {
    once(format!("the line of cs-16, {}", model.id()), || {
        let [a, b, divisor] = CS16_ONE_SIDED[model as usize];
        let factor: Formula = format!("({a}*n + {b})/({divisor}*pi)").parse().ok()?;
        let case = Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
        let extremes = Residual::new(case, &factor).over_reals(FROM, 1024.0);
        Some(residual(extremes, "every real n of 16..1024"))
    })
}

/// The residual of a cubic lobe's factor.
pub(super) fn cubic_factor_error(stand_in: StandIn, model: Model) -> Result<String, ShaderError> {
    once(format!("the factor of {}, {}", stand_in.id(), model.id()), || {
        let bell = formula(stand_in)?;
        let row = bell.power.trailing_zeros() as usize - 1;
        let [p0, p1, p2, p3, divisor] = CUBIC_FACTOR[row][model as usize];
        let text = format!("({p0}*n + ({p1}) + ({p2})/n + ({p3})/n^2)/({divisor}*pi)");
        let factor: Formula = text.parse().ok()?;
        let integral = LobeIntegral::new(stand_in.id(), bell, model)?;
        let extremes = Residual::new(integral, &factor).over_reals(FROM, f64::INFINITY);
        Some(residual(extremes, "every real n >= 16"))
    })
}

fn residual(Extremes { min, max }: Extremes, domain: &str) -> String {
    if min.value.lo() == 0.0 && max.value.hi() == 0.0 {
        return format!("the lobe integrates to 1 exactly for {domain}, in exact arithmetic.");
    }
    format!(
        "the lobe integrates to 1 + r, {} <= r <= {}, certified in exact arithmetic for {domain}; the ends at {} and {}.",
        short_down(min.value.lo()),
        short_up(max.value.hi()),
        place(min.n),
        place(max.n)
    )
}

/// How far a bell of degree one or three is from e⁻ᵗ.
pub(super) fn exponential_error(power: u32, cubic: bool) -> Result<String, ShaderError> {
    let about = format!("the bell of {} degree with K = {power}", if cubic { "third" } else { "first" });
    once(about, || {
        let row = power.trailing_zeros() as usize - 1;
        let coefficients = if cubic { *CUBIC_EXP.get(row)? } else { [1.0, 0.0, 0.0] };
        let (error, proof) = exponential_bell(power, coefficients, None, 1e-9)?;
        (proof.decreasing && proof.continuous && proof.negative_beyond).then(|| {
            let (bound, at) = (short_up(error.value.hi()), short(error.at[0]));
            format!("{bound}, certified in exact arithmetic for every t >= 0 and reached to 1e-9 at t = {at}")
        })
    })
}
