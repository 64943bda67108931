//! The formula of the clipped volume, P(d), against the volumes themselves.

use super::super::judgement::{Finding, Verdict, compare};
use super::{ratio, text};
use crate::bound::{ClippedPixel, Interval, Jet, clip_distance, enclose};
use crate::integral::Field;
use crate::paper::{ClipFormula, ClipProperty, ConstantTerm, Printed, Relation, Sign};
use dashu_ratio::RBig;

/// Suprema are enclosed to this, four digits of those found.
const TOLERANCE: f64 = 1e-7;

impl ClipFormula {
    /// P(d) = p₀ + p₁ d + p₂ d².
    pub(super) fn coefficients(&self) -> [RBig; 3] {
        let sign = |sign: Sign, value: &RBig| match sign {
            Sign::Plus => value.clone(),
            Sign::Minus => RBig::ZERO - value.clone(),
        };
        let square = sign(self.inner, &self.square.value);
        [self.constant.value.clone(), sign(self.sign, &self.linear.value), sign(self.sign, &square)]
    }

    /// P(d), exactly.
    pub(super) fn at(&self, d: &RBig) -> RBig {
        let [p0, p1, p2] = self.coefficients();
        p0 + d.clone() * (p1 + d.clone() * p2)
    }

    /// Where P' = 0, if that is within [0, ½].
    fn vertex(&self) -> Option<RBig> {
        let [_, p1, p2] = self.coefficients();
        if p2.is_zero() {
            return None;
        }
        let vertex = RBig::ZERO - p1 / (RBig::int(2) * p2);
        (vertex >= RBig::ZERO && vertex <= ratio(1, 2)).then_some(vertex)
    }
}

pub(super) fn has(formula: &ClipFormula, property: ClipProperty) -> Finding {
    let half = ratio(1, 2);
    let (start, end) = (formula.at(&RBig::ZERO), formula.at(&half));
    let vertex = formula.vertex();
    let told = match &vertex {
        Some(v) => format!(
            "P(0) = {}, P(1/2) = {}, P' = 0 at d = {} with P = {:.6}",
            text(&start),
            text(&end),
            v,
            enclose(&formula.at(v)).mid()
        ),
        None => format!("P(0) = {}, P(1/2) = {}, without a turn between", text(&start), text(&end)),
    };
    let mut values = vec![start.clone(), end.clone()];
    values.extend(vertex.iter().map(|v| formula.at(v)));
    let span = values.iter().map(enclose).reduce(Interval::hull);
    let holds = match property {
        ClipProperty::Volume => start == half && values.iter().all(|v| *v >= RBig::ZERO && *v <= half),
        // A parabola whose turn is at neither end rises on one side of it.
        ClipProperty::Falls => end < start && vertex.is_none_or(|v| v == half || v.is_zero()),
        ClipProperty::ZeroAtBase => end.is_zero(),
    };
    Finding::truth(holds, span, told)
}

/// sup over d in [0, ½] of |P(d) - V(d)|.
pub(super) fn distance(formula: &ClipFormula, pixel: ClippedPixel) -> Finding {
    let [a, b, c] = formula.coefficients().map(|c| enclose(&c));
    let p = [a, b, c, Interval::from(0.0)];
    let found = clip_distance(p, pixel, TOLERANCE);
    let d = Interval::from(found.at[0]);
    let at = p[0] + d * (p[1] + d * p[2]) - pixel.share_beyond(Jet::constant(d)).value;
    let side = if at.lo() > 0.0 { "above" } else { "below" };
    Finding::figure(found.value, format!("P(d) is {side} the volume at d = {:.4}", found.at[0]))
}

/// The least squares over d = i/(2(N - 1)), i = 0..N-1: a linear function of the enclosed volumes with exact
/// rational coefficients, so that nothing is lost but the volumes' own width.
fn solution(pixel: ClippedPixel, points: u32, fixed: Option<&RBig>) -> Option<Vec<Interval>> {
    let nodes: Vec<RBig> = (0..points).map(|i| ratio(i64::from(i), 2 * i64::from(points - 1))).collect();
    let first = u32::from(fixed.is_some());
    let powers: Vec<u32> = (first..=2).collect();
    let gram: Vec<Vec<RBig>> = powers
        .iter()
        .map(|i| powers.iter().map(|j| sum(nodes.iter().map(|d| d.power(i + j)))).collect())
        .collect();
    let inverse = inverse(gram)?;
    // Σ_i dᵢ^k (Vᵢ - constant).
    let offset = enclose(fixed.unwrap_or(&RBig::ZERO));
    let volumes: Vec<Interval> =
        nodes.iter().map(|d| pixel.share_beyond(Jet::constant(enclose(d))).value - offset).collect();
    let solve = |row: &Vec<RBig>| {
        nodes.iter().zip(&volumes).fold(Interval::from(0.0), |total, (d, v)| {
            let weight = sum(row.iter().zip(&powers).map(|(g, k)| g.clone() * d.power(*k)));
            total + enclose(&weight) * *v
        })
    };
    Some(inverse.iter().map(solve).collect())
}

fn sum(terms: impl Iterator<Item = RBig>) -> RBig {
    terms.fold(RBig::ZERO, |total, term| total + term)
}

/// By elimination; `None` if it is singular.
fn inverse(matrix: Vec<Vec<RBig>>) -> Option<Vec<Vec<RBig>>> {
    let size = matrix.len();
    let unit = |i: usize| (0..size).map(move |j| RBig::int(i64::from(i == j)));
    let mut rows: Vec<Vec<RBig>> =
        matrix.into_iter().enumerate().map(|(i, row)| row.into_iter().chain(unit(i)).collect()).collect();
    for k in 0..size {
        let pivot = (k..size).find(|&i| !rows[i][k].is_zero())?;
        rows.swap(k, pivot);
        let by = rows[k][k].clone();
        rows[k].iter_mut().for_each(|x| *x = x.clone() / by.clone());
        for i in (0..size).filter(|&i| i != k) {
            let factor = rows[i][k].clone();
            let by = rows[k].clone();
            rows[i].iter_mut().zip(by).for_each(|(x, y)| *x = x.clone() - factor.clone() * y);
        }
    }
    Some(rows.into_iter().map(|row| row[size..].to_vec()).collect())
}

pub(super) fn fit(
    formula: &ClipFormula,
    pixel: ClippedPixel,
    points: u32,
    constant: ConstantTerm,
) -> Finding {
    let fixed = (constant == ConstantTerm::Fixed).then_some(&formula.constant.value);
    let printed = format!("{}, {}, {}", formula.constant.text, formula.linear.text, formula.square.text);
    let Some(found) = solution(pixel, points, fixed) else {
        let witness = format!("{points} points do not determine it");
        return Finding { printed, computed: None, verdict: Verdict::Undecided, witness };
    };
    // As they are printed: without the signs before them.
    let [_, p1, p2] = formula.coefficients();
    let positive = |sign: &RBig, v: Interval| if *sign < RBig::ZERO { -v } else { v };
    let (linear, square) = (positive(&p1, found[found.len() - 2]), positive(&p2, found[found.len() - 1]));
    let free = if fixed.is_some() { vec![] } else { vec![(found[0], &formula.constant)] };
    let pairs: Vec<(Interval, &Printed)> =
        free.into_iter().chain([(linear, &formula.linear), (square, &formula.square)]).collect();
    let verdicts: Vec<Verdict> = pairs.iter().map(|(v, p)| compare(*v, p, Relation::Equal)).collect();
    let verdict = if verdicts.contains(&Verdict::Refuted) {
        Verdict::Refuted
    } else if verdicts.iter().all(|v| *v == Verdict::Proved) {
        Verdict::Proved
    } else {
        Verdict::Undecided
    };
    let list: Vec<String> = pairs.iter().map(|(v, p)| format!("{:.5} for {}", v.mid(), p.text)).collect();
    let witness = format!("{points} points: {}", list.join(", "));
    Finding { printed, computed: Some(linear), verdict, witness }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_times_its_matrix_is_one() {
        let matrix: Vec<Vec<RBig>> =
            [[3, 1, 2], [1, 0, 5], [2, 5, 7]].iter().map(|r| r.map(RBig::int).to_vec()).collect();
        let found = inverse(matrix.clone()).unwrap();
        for (i, row) in matrix.iter().enumerate() {
            for j in 0..3 {
                let product = sum(row.iter().zip(&found).map(|(a, b)| a.clone() * b[j].clone()));
                assert_eq!(product, RBig::int(i64::from(i == j)));
            }
        }
        let singular: Vec<Vec<RBig>> = [[1, 2], [2, 4]].iter().map(|r| r.map(RBig::int).to_vec()).collect();
        assert!(inverse(singular).is_none());
    }
}
