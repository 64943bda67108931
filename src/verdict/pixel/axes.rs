//! The tilt and the lengths of an ellipse's axes from the two derivative vectors: exact.

use super::super::judgement::{Finding, Verdict};
use super::{decided, ratio, signed};
use crate::bound::Multivariate;
use crate::integral::Field;
use crate::kernel::pixel::TiltFormula;
use crate::paper::{AxesProperty, Octant, Sign, Vectors};
use dashu_ratio::RBig;

/// A polynomial in c, s, p, q, k, l: J = [[c, -s], [s, c]] diag(p, q) [[k, l], [-l, k]], c² + s² = k² + l² = 1.
type Turned = Multivariate<6>;

/// Ux, Vx, Uy, Vy.
fn jacobian(vectors: Vectors) -> [Turned; 4] {
    let [c, s, p, q, k, l] = Turned::variables();
    let (zero, one) = (Turned::int(0), Turned::int(1));
    let (k, l) = match vectors {
        Vectors::MajorX => (one, zero),
        Vectors::MajorY => (zero, one),
        Vectors::Skew => (k, l),
    };
    let [pk, pl, qk, ql] = [p.clone() * k.clone(), p * l.clone(), q.clone() * k, q * l];
    [
        c.clone() * pk.clone() + s.clone() * ql.clone(),
        s.clone() * pk - c.clone() * ql,
        c.clone() * pl.clone() - s.clone() * qk.clone(),
        s * pl + c * qk,
    ]
}

/// cos and sin, in fifths, of a direction in the octant.
const fn direction(octant: Octant) -> (i64, i64) {
    match octant {
        Octant::First => (4, 3),
        Octant::Second => (3, 4),
        Octant::Third => (-3, 4),
        Octant::Fourth => (-4, 3),
        Octant::Fifth => (-4, -3),
        Octant::Sixth => (-3, -4),
        Octant::Seventh => (3, -4),
        Octant::Eighth => (4, -3),
    }
}

/// The witness: the octant's direction, semi-axes 2 and 1, and 12/13, 5/13 for the skew.
fn point(octant: Octant) -> [RBig; 6] {
    let (c, s) = direction(octant);
    [ratio(c, 5), ratio(s, 5), ratio(2, 1), ratio(1, 1), ratio(12, 13), ratio(5, 13)]
}

/// Whether the formula's angle is the major axis's modulo π, for every ellipse of the octant.
pub(super) fn tilt(formula: TiltFormula, octant: Octant, vectors: Vectors) -> Finding {
    match formula {
        TiltFormula::Vector => vector_tilt(octant, vectors),
        TiltFormula::Conic => conic_tilt(octant, vectors),
    }
}

/// arctan(Vx/Ux) modulo π is the direction of (Ux, Vx): the axis's where Ux s - Vx c is 0.
fn vector_tilt(octant: Octant, vectors: Vectors) -> Finding {
    let [ux, vx, ..] = jacobian(vectors);
    let [c, s, ..] = Turned::variables();
    let residual = ux.clone() * s - vx.clone() * c;
    if residual.is_zero() {
        let witness = "(Ux, Vx) is parallel to the major axis: Ux sin φ = Vx cos φ identically".to_owned();
        return Finding::truth(true, None, witness);
    }
    let at = point(octant);
    let witness = format!(
        "semi-axes 2 and 1, the major along ({}, {}): (Ux, Vx) = ({}, {}), and Ux sin φ - Vx cos φ = {}",
        at[0],
        at[1],
        ux.at(&at),
        vx.at(&at),
        residual.at(&at)
    );
    decided(!residual.at(&at).is_zero(), witness)
}

/// tan 2φ = B/(A - C) for both axes; ½ arctan lies in (-π/4, π/4), where the major axis must then lie too.
fn conic_tilt(octant: Octant, vectors: Vectors) -> Finding {
    let [ux, vx, uy, vy] = jacobian(vectors);
    let [c, s, ..] = Turned::variables();
    let b = Turned::int(-2) * (ux.clone() * vx.clone() + uy.clone() * vy.clone());
    let difference = vx.power(2) + vy.power(2) - ux.power(2) - uy.power(2);
    let (cosine, sine) = (c.power(2) - s.power(2), Turned::int(2) * c * s);
    let residual = b * cosine.clone() - difference * sine;
    if !residual.is_zero() {
        let witness = "B cos 2φ = (A - C) sin 2φ does not hold identically".to_owned();
        return Finding { printed: String::new(), computed: None, verdict: Verdict::Undecided, witness };
    }
    // cos 2φ keeps its sign in an octant, which is bounded by the diagonals.
    let at = point(octant);
    if cosine.at(&at) > RBig::int(0) {
        let witness = "B cos 2φ = (A - C) sin 2φ identically, and cos 2φ > 0 as for every angle of ½ arctan";
        return Finding::truth(true, None, witness.to_owned());
    }
    let witness = format!(
        "the major axis along ({}, {}), steeper than 45°: ½ arctan never is, and is the minor axis",
        at[0], at[1]
    );
    Finding::truth(false, None, witness)
}

/// 4F (Ux² + Vx²)/(A Ux² + B Ux Vx + C Vx²) = 4 (Ux² + Vx²): the denominator is F itself.
pub(super) fn axis_formula(sign: Sign) -> Finding {
    let [ux, vx, uy, vy] = Multivariate::<4>::variables();
    let a = vx.power(2) + vy.power(2);
    let b = Multivariate::int(2) * (ux.clone() * vx.clone() + uy.clone() * vy.clone());
    let c = ux.power(2) + uy.power(2);
    let f = (ux.clone() * vy - uy * vx.clone()).power(2);
    let below = a * ux.power(2) + signed(sign, b) * ux * vx.clone() + c * vx.power(2);
    let residual = below.clone() - f.clone();
    if residual.is_zero() {
        let witness =
            "A Ux² + B Ux Vx + C Vx² = F as polynomials, so (10) is 4 (Ux² + Vx²) and needs no conic";
        return Finding::truth(true, None, witness.to_owned());
    }
    let at = [2, 1, 1, 3].map(|k| ratio(k, 1));
    let (below, f) = (below.at(&at), f.at(&at));
    let witness = format!("Ux = 2, Vx = 1, Uy = 1, Vy = 3: the denominator is {below}, F is {f}");
    decided(below != f, witness)
}

/// L² = 4 (Ux² + Vx²) and d² = 4 (Uy² + Vy²) against the axes 2p ≥ 2q of J's ellipse.
pub(super) fn axes_are(property: AxesProperty, vectors: Vectors) -> Finding {
    let [ux, vx, uy, vy] = jacobian(vectors);
    let [.., p, q, k, l] = Turned::variables();
    let [c, s, ..] = Turned::variables();
    // c² + s² and k² + l², both 1, make the two sides homogeneous.
    let turn = c.power(2) + s.power(2);
    let skew = match vectors {
        Vectors::Skew => k.power(2) + l.power(2),
        _ => Turned::int(1),
    };
    let (long, short) = (ux.power(2) + vx.power(2), uy.power(2) + vy.power(2));
    let sum = long.clone() + short.clone() - (p.power(2) + q.power(2)) * turn.clone() * skew.clone();
    let product =
        long.clone() * short.clone() - (p.clone() * q.clone() * turn.clone() * skew.clone()).power(2);
    let at = point(Octant::First);
    let lengths = format!("semi-axes 2 and 1: (L/2)² and (d/2)² are {}", text_pair(&long, &short, &at));
    let (holds, why, fails) = match property {
        AxesProperty::SumOfSquares => {
            (sum.is_zero(), "(L/2)² + (d/2)² = p² + q² identically: conjugate semi-diameters", sum)
        }
        AxesProperty::Area => (product.is_zero(), "(L/2)² (d/2)² = p² q² identically", product),
        AxesProperty::Lengths => {
            let both = sum.is_zero() && product.is_zero();
            (both, "sum and product of (L/2)² and (d/2)² are those of p² and q², identically", product)
        }
        AxesProperty::Longer => {
            // L² - d² is a positive multiple of p² - q² where the first vector is the major semi-axis.
            let rest = long.clone() - short.clone() - (p.power(2) - q.power(2)) * turn;
            let why = "(L/2)² - (d/2)² = p² - q² identically, and p ≥ q";
            if rest.is_zero() {
                return Finding::truth(true, None, why.to_owned());
            }
            // The first vector nearer to the minor axis than to the major one.
            let [c, s, p, q, k, l] = at;
            let at = [c, s, p, q, l, k];
            let found = text_pair(&long, &short, &at);
            let less = long.at(&at) < short.at(&at);
            return decided(less, format!("semi-axes 2 and 1: (L/2)² and (d/2)² are {found}"));
        }
    };
    if holds {
        Finding::truth(true, None, why.to_owned())
    } else {
        decided(!fails.at(&at).is_zero(), lengths)
    }
}

fn text_pair(long: &Turned, short: &Turned, at: &[RBig; 6]) -> String {
    format!("{} and {}", long.at(at), short.at(at))
}
