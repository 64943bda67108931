//! One family's fit: its parameters, and how well the samples know them.

use super::points::Points;
use super::polish::{Member, polish};
use super::trend::trend;
use super::triangle::System;
use super::{Family, Goodness, Shape, Trend, Weighting, free, search, student_quantile};
use core::fmt;
use thiserror::Error;

/// A sample's distance from the fitted lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// The sample's row.
    pub row: usize,
    /// Its angle in degrees.
    pub theta_deg: f64,
    /// Sample less lobe, in the values' unit.
    pub value: f64,
}

/// What the samples say of a family: estimates, which more or other samples change.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Of which family.
    pub family: Family,
    /// The lobe's value at θ = 0, in the values' unit.
    pub scale: f64,
    /// The exponent n (of [`Family::SphericalGaussian`] the sharpness λ).
    pub n: f64,
    /// α and β of a free bell; 0 and 0 else.
    pub shape: Shape,
    /// How far off the parameters may be, or why that is not known.
    pub uncertainty: Result<Uncertainty, NoUncertainty>,
    /// N - p: samples of positive weight less parameters.
    pub freedom: usize,
    /// Σ q (v - lobe)², q the weights as given, or 1/σ².
    pub chi_square: f64,
    /// Whether the residuals have the size of the sigmas; `None` where none are given.
    pub goodness: Option<Goodness>,
    /// √(Σ q r²/Σ q) in the values' unit.
    pub rms: f64,
    /// The largest |residual|; of equal ones that of the smallest angle.
    pub worst: Residual,
    /// The Bayesian information criterion: N ln(χ²/N) + (p + 1) ln N, σ being the parameter more; where σ is given
    /// χ² + p ln N. Smaller is better, and only differences count (Schwarz 1978).
    pub bic: f64,
    /// What residuals of neighbouring angles have in common.
    pub trend: Option<Trend>,
}

/// Standard errors from the weighted Jacobian J at the optimum: covariance s² (JᵀWJ)⁻¹, s² = χ²/(N - p), or 1 where
/// the samples' σ are given.
///
/// They presume that the lobe is of the family, that the noise of different samples is independent, of mean 0 and
/// of the variance that the weights say, and that the lobe is nearly linear in ln n and in the others over a few errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// Of the scale.
    pub scale: f64,
    /// Of n: n times the standard error of ln n, in which the lobe is nearer to linear.
    pub n: f64,
    /// Of a free bell's α and β.
    pub shape: Option<(f64, f64)>,
    /// Correlation of scale and n, -1 to 1.
    pub correlation: f64,
    /// N - p, the degrees of freedom that s² has; `None` where σ is given.
    pub degrees: Option<usize>,
}

/// The share of samples' sets whose interval holds the true parameter.
pub const CONFIDENCE: f64 = 0.95;

impl Uncertainty {
    /// Standard errors to each side of the estimate for [`CONFIDENCE`]: Student's quantile, or the normal one where σ
    /// is given.
    ///
    /// ```
    /// use bellfit::fit::measured::Uncertainty;
    /// let u = Uncertainty { scale: 0.1, n: 1.0, shape: None, correlation: 0.5, degrees: Some(2) };
    /// assert!((u.quantile() - 4.303).abs() < 5e-4);
    /// ```
    pub fn quantile(&self) -> f64 {
        student_quantile(CONFIDENCE, self.degrees)
    }
}

/// Why there is no uncertainty.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum NoUncertainty {
    /// The samples want an n beyond the range.
    #[error("n stands at the end {end} of the range searched")]
    AtBound {
        /// Which end.
        end: f64,
    },
    /// The samples want a bell that rises somewhere, or a flatter peak or a longer tail than is searched.
    #[error(
        "the shape stands at the edge of those searched, most often where the bell would rise before its cut"
    )]
    AtEdge,
    /// Parameters that change the lobe in the same way, at these angles.
    #[error("the samples do not tell the parameters apart")]
    Singular,
    /// As many parameters as samples.
    #[error("no sample is left over to estimate the noise from")]
    NoFreedom,
    /// The last steps still moved.
    #[error("the search did not settle")]
    Unsettled,
}

/// Why a family has no fit.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum NoFit {
    /// Fewer samples than parameters and one.
    #[error("{found} samples for {parameters} parameters: at least {needed} are needed", needed = .parameters + 1)]
    TooFew {
        /// Samples of positive weight.
        found: usize,
        /// Of the family.
        parameters: usize,
    },
    /// Fewer angles than parameters.
    #[error("samples at {found} angles for {parameters} parameters")]
    TooFewAngles {
        /// Different ones.
        found: usize,
        /// Of the family.
        parameters: usize,
    },
    /// No lobe of positive scale is nearer than none.
    #[error("no lobe above 0 comes nearer to the values than 0 does")]
    NoLobe,
}

impl Estimate {
    /// Fits one family.
    pub(super) fn of(points: &Points, family: Family) -> Result<Self, NoFit> {
        let (found, parameters) = (points.len(), family.parameters());
        if found < parameters + 1 {
            return Err(NoFit::TooFew { found, parameters });
        }
        if points.angles < parameters {
            return Err(NoFit::TooFewAngles { found: points.angles, parameters });
        }
        // Of many samples some show where the optimum lies; all of them say where exactly, and are searched
        // themselves if the steps from there do not settle.
        let some = points.thinned(SEARCHED);
        let near = some.as_ref().and_then(|some| settle(points, family, starts(some, family)));
        let near = near.filter(|found| is_settled(points, found));
        let found = near.or_else(|| settle(points, family, starts(points, family)));
        let found = found.ok_or(NoFit::NoLobe)?;
        Ok(Self::finished(points, &found))
    }

    fn finished(points: &Points, found: &Settled) -> Self {
        let Settled { square, ref member, .. } = *found;
        let lobe = member.lobe();
        let count = points.len();
        let residuals: Vec<f64> =
            points.iter().map(|(w, l, v, _)| v - member.scale * lobe.value(w, l)).collect();
        let worst =
            (0..count).fold(0, |best, i| if residuals[i].abs() > residuals[best].abs() { i } else { best });
        let weights: f64 = points.weight.iter().sum();
        let chi_square = square * points.unit * points.unit * points.heaviest;
        let freedom = count - member.family.parameters();
        let is_absolute = points.weighting == Weighting::Sigma && freedom > 0;
        Estimate {
            family: member.family,
            scale: member.scale * points.unit,
            n: member.n(),
            shape: member.shape,
            uncertainty: uncertainty(points, found),
            freedom,
            chi_square,
            goodness: is_absolute.then(|| Goodness::of(chi_square, freedom)),
            rms: (square / weights).sqrt() * points.unit,
            worst: Residual {
                row: points.row[worst],
                theta_deg: points.theta_deg[worst],
                value: residuals[worst] * points.unit,
            },
            bic: bic(points, square, chi_square, member.family.parameters()),
            trend: trend(points, square, &residuals),
        }
    }

    /// The lobe with its scale at w = 1 - cos θ in [0, 1], in the values' unit.
    pub fn at(&self, versine: f64) -> f64 {
        self.scale * self.family.value(versine, self.n, self.shape)
    }

    /// The 95 % interval of n, if its uncertainty is known: n e^(-t σ) to n e^(t σ), σ the standard error of ln n and
    /// t the [quantile](Uncertainty::quantile). Both ends are positive, however little the samples say of n.
    pub fn n_interval(&self) -> Option<(f64, f64)> {
        let u = self.uncertainty.as_ref().ok()?;
        let factor = libm::exp(u.quantile() * u.n / self.n);
        Some((self.n / factor, self.n * factor))
    }

    /// The 95 % interval of the scale, if its uncertainty is known: the scale and t standard errors to each side.
    pub fn scale_interval(&self) -> Option<(f64, f64)> {
        let u = self.uncertainty.as_ref().ok()?;
        Some((self.scale - u.quantile() * u.scale, self.scale + u.quantile() * u.scale))
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: n = {}, scale = {}", self.family, self.n, self.scale)
    }
}

/// Samples that are searched; of more, every so many-th.
const SEARCHED: usize = 16_384;

/// Where the steps ended, with the sum of squares there.
struct Settled {
    square: f64,
    member: Member,
    system: System,
}

/// (ln n, shape) near minima of the sum of squares.
fn starts(points: &Points, family: Family) -> Vec<(f64, Shape)> {
    if family.is_free() {
        return free::shapes(points, family);
    }
    let shape = Shape::default();
    vec![(search::exponent(points, family, shape).0, shape)]
}

/// The lowest of where Gauss-Newton steps lead; `None` if no lobe above 0 lowers the sum.
fn settle(points: &Points, family: Family, starts: Vec<(f64, Shape)>) -> Option<Settled> {
    let mut best: Option<Settled> = None;
    for (u, shape) in starts {
        let mut member = Member { family, scale: 0.0, u, shape };
        member.scale = points.project(&member.lobe()).0;
        if member.scale <= 0.0 {
            continue;
        }
        let (member, system) = polish(points, member);
        let square = points.square(member.scale, &member.lobe());
        if best.as_ref().is_none_or(|best| square < best.square) {
            best = Some(Settled { square, member, system });
        }
    }
    best
}

/// Whether the point is stationary, to a small part of a standard error.
fn is_settled(points: &Points, found: &Settled) -> bool {
    let noise = (found.square / points.len() as f64).sqrt();
    // Of data without noise the residuals are rounding themselves.
    found.system.along() <= SETTLED * noise + 1e-13 * points.total.sqrt()
}

/// How far from stationary a point may be, in standard errors of a parameter, and still count as the optimum.
const SETTLED: f64 = 1e-2;
/// How near to an end of the range n stands at it, relatively.
const AT_END: f64 = 1e-9;

fn uncertainty(points: &Points, found: &Settled) -> Result<Uncertainty, NoUncertainty> {
    let Settled { square, ref member, ref system } = *found;
    let (from, to) = member.family.exponents();
    let n = member.n();
    for end in [from, to] {
        if (n / end - 1.0).abs() < AT_END {
            return Err(NoUncertainty::AtBound { end });
        }
    }
    let parameters = member.family.parameters();
    let degrees = points.len() - parameters;
    if degrees == 0 {
        return Err(NoUncertainty::NoFreedom);
    }
    let covariance = system.covariance().ok_or(NoUncertainty::Singular)?;
    if !is_settled(points, found) {
        let is_edge = member.family.is_free() && member.shape.is_near_edge();
        return Err(if is_edge { NoUncertainty::AtEdge } else { NoUncertainty::Unsettled });
    }
    let noise = (square / degrees as f64).sqrt();
    let (noise, degrees) = match points.weighting {
        // In the units that the values and weights were divided by.
        Weighting::Sigma => (1.0 / (points.unit * points.heaviest.sqrt()), None),
        Weighting::Equal | Weighting::Weight => (noise, Some(degrees)),
    };
    let error = |i: usize| noise * covariance[i][i].sqrt();
    let known = Uncertainty {
        scale: member.scale * points.unit * error(0),
        n: n * error(1),
        shape: (parameters == 4).then(|| (error(2), error(3))),
        correlation: covariance[0][1] / (covariance[0][0] * covariance[1][1]).sqrt(),
        degrees,
    };
    // Values that are nothing beside their sigmas: an error beyond the doubles is none that is known.
    let most = n * libm::exp(known.quantile() * error(1));
    let is_finite = [known.scale, known.n, known.correlation, most].iter().all(|x| x.is_finite());
    if is_finite { Ok(known) } else { Err(NoUncertainty::Singular) }
}

fn bic(points: &Points, square: f64, chi_square: f64, parameters: usize) -> f64 {
    let count = points.len() as f64;
    match points.weighting {
        Weighting::Sigma => chi_square + parameters as f64 * libm::log(count),
        // Residuals of rounding alone are equally good, however small.
        Weighting::Equal | Weighting::Weight => {
            let square = square.max(points.rounding()).max(f64::MIN_POSITIVE);
            count * libm::log(square / count) + (parameters + 1) as f64 * libm::log(count)
        }
    }
}
