//! The bells for cosⁿ: the limit's p with terms in 1/n.

use super::cost::{Cost, operations};
use super::exchange::polish;
use super::exponential::{rounded, uncertified};
use super::lawson::{Minimize, Row, lawson};
use super::shape::Shape;
use crate::bound::{BellProof, Supremum, cosine_bell, exponential_bell};
use crate::fit::FitError;
use crate::kernel::cubic::BellFormula;

/// The papers' smallest exponent, from which the formulas hold.
const FROM: f64 = 16.0;
/// To which the error is enclosed, relative.
const TOLERANCE: f64 = 2e-4;
/// Significant decimals of the formulas: what `f32` carries.
const DIGITS: usize = 7;

/// A bell for cosⁿ with its certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct CosineBell {
    /// Whether it is the lobe paper's cs_16, and not a fit.
    pub printed: bool,
    /// The shape of p.
    pub shape: Shape,
    /// The coefficients.
    pub formula: BellFormula,
    /// The n from which it holds, to infinity.
    pub from: f64,
    /// The level of the limit n → ∞, below which no such formula can come.
    pub limit: f64,
    /// sup over every angle in [0, π/2] and every real n ≥ `from` of |cosⁿ - bell|.
    pub error: Supremum<2>,
    /// What is proved of its form.
    pub proof: BellProof,
    /// Operations.
    pub cost: Cost,
}

/// One family of bells for cosⁿ.
struct Family {
    shape: Shape,
    power: u32,
    /// How many terms in 1/n, 1/n², … T, α and β get.
    terms: [usize; 3],
    /// What T gains from n = ∞ to n = 16, tried in turn; T's own terms come on top.
    stretches: &'static [f64],
}

/// As few terms as keep the limit's level for every n, or all but (K = 32). For K = 8 cosⁿ's own best T
/// runs off to twice its limit and back, where nothing depends on it; so T is given a slope, and the best
/// one kept. A cubic at K = 16 is not here: at n = 16 cosⁿ is (1 - t/16)^16 itself, which three such
/// formulas reach from the limit's p only with an error of 1.6e-4.
const FAMILIES: [Family; 8] = [
    Family { shape: Shape::Linear, power: 2, terms: [1, 0, 0], stretches: &[0.0] },
    Family { shape: Shape::Linear, power: 4, terms: [1, 0, 0], stretches: &[0.0] },
    Family { shape: Shape::Linear, power: 8, terms: [1, 0, 0], stretches: &[0.0] },
    Family { shape: Shape::Linear, power: 16, terms: [1, 0, 0], stretches: &[0.0] },
    Family { shape: Shape::Linear, power: 32, terms: [2, 0, 0], stretches: &[0.0] },
    Family { shape: Shape::Cubic, power: 2, terms: [0, 1, 1], stretches: &[0.0] },
    Family { shape: Shape::Cubic, power: 4, terms: [0, 1, 1], stretches: &[0.0] },
    Family {
        shape: Shape::Cubic,
        power: 8,
        terms: [0, 2, 2],
        stretches: &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2],
    },
];

/// The lobe paper's cs_16, then every bell for cosⁿ, fitted, rounded and certified.
///
/// # Errors
/// [`FitError::NoOptimum`] if a limit's fit fails, or no stretch gives a bell.
pub fn cosine_bells() -> Result<Vec<CosineBell>, FitError> {
    let mut rows = vec![printed()?];
    for family in &FAMILIES {
        rows.push(fitted(family)?);
    }
    Ok(rows)
}

fn printed() -> Result<CosineBell, FitError> {
    let formula = BellFormula { power: 16, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
    // Its error rises with n towards that of Lyon's bell.
    let limit = exponential_bell(16, [1.0, 0.0, 0.0], None, 1e-6).ok_or_else(|| uncertified(16))?.0;
    let seeds = [[0.0, limit.at[0] / 16.0]];
    let tolerance = TOLERANCE * limit.value.hi();
    let (error, proof) = cosine_bell(&formula, FROM, &seeds, tolerance).ok_or_else(|| uncertified(16))?;
    Ok(CosineBell {
        printed: true,
        shape: Shape::Linear,
        formula,
        from: FROM,
        limit: limit.value.mid(),
        error,
        proof,
        cost: operations(1, 16, false),
    })
}

fn fitted(family: &Family) -> Result<CosineBell, FitError> {
    let Family { shape, power, terms, stretches } = *family;
    let limit = polish(shape, power)?;
    let mut start = limit.unknowns.clone();
    start.resize(3, 0.0);
    let start = [start[0], start[1], start[2]].map(|c| rounded(c, DIGITS));
    let level = limit.level;
    let fits = stretches.iter().map(|&stretch| {
        let problem = Problem { shape, power, start, stretch, terms, level };
        let (x, worst) = lawson(&problem, &problem.first_guess(), STEPS);
        (problem, x, worst)
    });
    let (problem, x, _) = fits
        .filter(|(problem, x, _)| problem.is_clear(x))
        .min_by(|(.., a), (.., b)| a.total_cmp(b))
        .ok_or_else(|| FitError::NoOptimum { method: "Lawson's iteration", case: format!("K = {power}") })?;
    let formula = problem.formula(&x, DIGITS);
    let seeds: Vec<[f64; 2]> = limit.alternation.iter().map(|t| [0.0, t / limit.piece.reach]).collect();
    let (error, proof) =
        cosine_bell(&formula, FROM, &seeds, TOLERANCE * level).ok_or_else(|| uncertified(power))?;
    let by_difference = shape == Shape::Cubic && power > 4;
    let cost = operations(shape.degree(), power, by_difference);
    Ok(CosineBell { printed: false, shape, formula, from: FROM, limit: level, error, proof, cost })
}

/// Steps of Lawson's iteration, each about a millisecond.
const STEPS: u32 = 200;

struct Problem {
    shape: Shape,
    power: u32,
    /// T, α, β of the limit.
    start: [f64; 3],
    stretch: f64,
    terms: [usize; 3],
    level: f64,
}

/// Nodes in 16/n, from 0 to 1, and in t/T.
const NODES: (u32, u32) = (16, 240);
/// How far the second factor 1 + α y + β y² of p is to stay above 0 at the cut, and from there to the
/// hemisphere's edge, so that p has one zero only.
const CLEARANCE: f64 = 0.02;

impl CosineBell {
    /// t = n (1 - cos θ) at which the error is largest.
    pub fn t_at_maximum(&self) -> f64 {
        let [m, y] = self.error.at;
        let [a, b, c] = self.formula.reach;
        y * (a + m * (b + m * c))
    }

    /// n at which the error is largest; ∞ for the limit.
    pub fn n_at_maximum(&self) -> f64 {
        1.0 / self.error.at[0]
    }
}

impl Problem {
    /// T, α, β at v = 16/n. A longer T takes α with it so that the slope of p at t = 0, (1 - α)/T, stays
    /// what it is for every cosⁿ.
    fn at(&self, x: &[f64], v: f64) -> [f64; 3] {
        let mut values = self.start;
        values[0] += self.stretch * v;
        values[1] -= self.slope() * self.stretch * v;
        for (x, (i, j)) in x.iter().zip(self.unknowns()) {
            values[i] += x * libm::pow(v, f64::from(j));
        }
        values
    }

    /// -p'(0) of the limit, per unit of t.
    fn slope(&self) -> f64 {
        let [reach, alpha, _] = self.start;
        (1.0 - alpha) / reach
    }

    /// Whether p keeps one zero, at the nodes; the certificate decides for every n.
    fn is_clear(&self, x: &[f64]) -> bool {
        (1..=NODES.0).map(|node| f64::from(node) / f64::from(NODES.0)).all(|v| {
            let [reach, alpha, beta] = self.at(x, v);
            let edge = (FROM / (v * reach)).max(1.0);
            self.shape != Shape::Cubic
                || [1.0, edge].iter().all(|y| 1.0 + y * (alpha + y * beta) >= CLEARANCE)
        })
    }

    /// (which of T, α, β; power of v) of each unknown.
    fn unknowns(&self) -> impl Iterator<Item = (usize, u32)> + '_ {
        self.terms.iter().enumerate().flat_map(|(i, &count)| (1..=count as u32).map(move |j| (i, j)))
    }

    /// Derivatives by the unknowns from those by T, α and β.
    fn spread(&self, v: f64, slopes: [f64; 3]) -> Vec<f64> {
        self.unknowns().map(|(i, j)| slopes[i] * libm::pow(v, f64::from(j))).collect()
    }

    /// By cosⁿ's own K-th root: (1 - t m)^(1/(K m)) has the cubic coefficient (1 - K m)(1 - 2 K m)/6.
    fn first_guess(&self) -> Vec<f64> {
        let s = f64::from(self.power) / FROM;
        let guess = |(i, j)| match (i, j) {
            (2, 1) => -3.0 * s * self.start[2],
            (2, 2) => 2.0 * s * s * self.start[2],
            _ => 0.0,
        };
        self.unknowns().map(guess).collect()
    }

    /// The formula in 1/n with so many digits.
    fn formula(&self, x: &[f64], digits: usize) -> BellFormula {
        let mut table = [[0.0; 3]; 3];
        for (row, start) in table.iter_mut().zip(self.start) {
            row[0] = start;
        }
        table[0][1] = self.stretch;
        table[1][1] = -self.slope() * self.stretch;
        for (x, (i, j)) in x.iter().zip(self.unknowns()) {
            table[i][j as usize] += x;
        }
        for row in &mut table {
            for (j, c) in row.iter_mut().enumerate().skip(1) {
                *c = rounded(*c * libm::pow(FROM, j as f64), digits);
            }
        }
        let [reach, linear, square] = table;
        let (linear, square) =
            if self.shape == Shape::Cubic { (linear, square) } else { ([0.0; 3], [0.0; 3]) };
        BellFormula { power: self.power, reach, linear, square }
    }
}

/// cosⁿ at t = n (1 - cos θ) and its slope in t; m = 1/n.
fn cos_n(t: f64, m: f64) -> (f64, f64) {
    if m == 0.0 {
        let value = libm::exp(-t);
        return (value, -value);
    }
    if t * m >= 1.0 {
        return (0.0, 0.0);
    }
    let value = libm::exp(libm::log1p(-t * m) / m);
    (value, -value / (1.0 - t * m))
}

impl Minimize for Problem {
    fn residuals(&self, x: &[f64]) -> Vec<Row> {
        let k = f64::from(self.power);
        let mut rows = Vec::with_capacity((NODES.0 * (NODES.1 + 1)) as usize);
        for node in 1..=NODES.0 {
            let v = f64::from(node) / f64::from(NODES.0);
            let [reach, alpha, beta] = self.at(x, v);
            for i in 0..=NODES.1 {
                let y = f64::from(i) / f64::from(NODES.1);
                let (target, slope) = cos_n(y * reach, v / FROM);
                let p = (1.0 - y) * (1.0 + y * (alpha + y * beta));
                let bell = libm::pow(p, k);
                let by_p = -k * libm::pow(p, k - 1.0) * (1.0 - y) / self.level;
                let slopes = [slope * y / self.level, by_p * y, by_p * y * y];
                rows.push(Row { residual: (target - bell) / self.level, slopes: self.spread(v, slopes) });
            }
        }
        rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// T = 2 + 3 m + 5 m² at m = 1/2 is 19/4, and a quarter of it 19/16.
    #[test]
    fn the_place_of_the_largest_error_is_told_in_n_and_t() {
        let cs_16 = printed().unwrap();
        let at = |at| CosineBell {
            formula: BellFormula { reach: [2.0, 3.0, 5.0], ..cs_16.formula },
            error: Supremum { at, ..cs_16.error },
            ..cs_16.clone()
        };
        assert_eq!((at([0.5, 0.25]).n_at_maximum(), at([0.5, 0.25]).t_at_maximum()), (2.0, 1.1875));
        assert_eq!((at([0.0, 0.25]).n_at_maximum(), at([0.0, 0.25]).t_at_maximum()), (f64::INFINITY, 0.5));
    }

    #[test]
    fn slopes_of_cos_n_are_difference_quotients() {
        for (t, m) in [(0.5, 0.0), (2.0, 0.0), (0.5, 1.0 / 16.0), (2.0, 1.0 / 16.0), (7.0, 0.125)] {
            let h = 1e-6;
            let quotient = (cos_n(t + h, m).0 - cos_n(t - h, m).0) / (2.0 * h);
            // The rounding of values below 1 over 2h; what h² adds is less.
            assert!((cos_n(t, m).1 - quotient).abs() < 1e-9, "{t} {m}");
        }
        assert_eq!(cos_n(16.0, 1.0 / 16.0), (0.0, 0.0));
    }
}
