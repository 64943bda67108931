//! The mapping's derivatives, the conic of the footprint, and the rotation of its axes: identities between
//! polynomials.

use super::super::judgement::Finding;
use super::{decided, ratio, signed};
use crate::bound::Multivariate;
use crate::integral::Field;
use crate::paper::{Base, Denominator, Sign, SignPair};
use dashu_ratio::RBig;

/// u = N/w along x, N = a x + b y + c: u(x+1) - u(x) against ∂u/∂x, for y and v by renaming.
pub(super) fn derivatives_agree(denominator: Denominator) -> Finding {
    let [a, b, c, d, e, f, x, y] = Multivariate::<8>::variables();
    let zero = Multivariate::int(0);
    let (d, e) = match denominator {
        Denominator::Constant => (zero.clone(), zero),
        Denominator::Any => (d, e),
    };
    let above = a.clone() * x.clone() + b * y.clone() + c;
    let below = d.clone() * x + e * y + f;
    // u(x+1) - u(x) = difference/(w (w + d)), ∂u/∂x = derivative/w².
    let difference =
        (above.clone() + a.clone()) * below.clone() - above.clone() * (below.clone() + d.clone());
    let derivative = a * below.clone() - above * d.clone();
    let residual = difference * below.clone() - derivative * (below + d);
    if residual.is_zero() {
        let witness = "u(x+1, y) - u(x, y) = A1/F = ∂u/∂x as rational functions".to_owned();
        return Finding::truth(true, None, witness);
    }
    // u = x/(x + 1) at x = 0.
    let at = [1, 0, 0, 1, 0, 1, 0, 0].map(RBig::int);
    let differs = !residual.at(&at).is_zero();
    let witness = "u = x/(x + 1) at x = 0: the derivative is 1, the difference 1/2".to_owned();
    decided(differs, witness)
}

/// With (U, V) = J (x, y): A U² + B U V + C V² - F (x² + y²)/r² is 0 identically, so that the conic holds
/// on the image of the circle of radius r and nowhere else.
pub(super) fn conic(sign: Sign, inner: Sign, base: Base) -> Finding {
    let [ux, vx, uy, vy, x, y] = Multivariate::<6>::variables();
    let a = vx.power(2) + vy.power(2);
    let b = Multivariate::int(2) * (ux.clone() * vx.clone() + uy.clone() * vy.clone());
    let c = ux.power(2) + uy.power(2);
    let f = (ux.clone() * vy.clone() + signed(inner, uy.clone() * vx.clone())).power(2);
    let u = ux * x.clone() + uy * y.clone();
    let v = vx * x.clone() + vy * y.clone();
    let left = a * u.power(2) + signed(sign, b) * u * v.clone() + c * v.power(2);
    // 1/r².
    let (over, radius) = match base {
        Base::Radius => (1, ratio(1, 1)),
        Base::Diameter => (4, ratio(1, 2)),
    };
    let right = f * Multivariate::int(over) * (x.power(2) + y.power(2));
    let residual = left.clone() - right;
    if residual.is_zero() {
        let witness = "A U² + B U V + C V² = F (x² + y²) for (U, V) = J (x, y), as polynomials".to_owned();
        return Finding::truth(true, None, witness);
    }
    // J = [[2, 1], [1, 3]], a point of the circle on the diagonal 3 : 4.
    let point = |k: i64| radius.clone() * ratio(k, 5);
    let at = [ratio(2, 1), ratio(1, 1), ratio(1, 1), ratio(3, 1), point(3), point(4)];
    let (left, miss) = (left.at(&at), residual.at(&at));
    let witness = format!(
        "Ux = 2, Vx = 1, Uy = 1, Vy = 3, (x, y) = ({}, {}) on the circle: A U² + B U V + C V² = {left}, F = {}",
        at[4],
        at[5],
        left.clone() - miss.clone()
    );
    decided(!miss.is_zero(), witness)
}

/// u₁²/σ1² + v₁²/σ2² against the same of an ellipse whose first axis lies at +α, in p = 1/σ1, q = 1/σ2.
pub(super) fn rotation(sign: Sign, second: SignPair) -> Finding {
    let [u, v, c, s, p, q] = Multivariate::<6>::variables();
    let form = |first: Sign, (of_u, of_v): (Sign, Sign)| {
        let u1 = u.clone() * c.clone() + signed(first, v.clone() * s.clone());
        let v1 = signed(of_u, u.clone() * s.clone()) + signed(of_v, v.clone() * c.clone());
        (u1 * p.clone()).power(2) + (v1 * q.clone()).power(2)
    };
    let pair = |pair: SignPair| match pair {
        SignPair::MinusPlus => (Sign::Minus, Sign::Plus),
        SignPair::PlusPlus => (Sign::Plus, Sign::Plus),
        SignPair::PlusMinus => (Sign::Plus, Sign::Minus),
        SignPair::MinusMinus => (Sign::Minus, Sign::Minus),
    };
    // The axes are (c, s) and (-s, c).
    let wanted = form(Sign::Plus, (Sign::Minus, Sign::Plus));
    let found = form(sign, pair(second));
    if (found.clone() - wanted.clone()).is_zero() {
        let witness = "u₁ and ±v₁ are the components along (cos α, sin α) and across it".to_owned();
        return Finding::truth(true, None, witness);
    }
    let turned = form(Sign::Minus, (Sign::Plus, Sign::Plus));
    let what = if (found.clone() - turned).is_zero() {
        "the first axis lies at -α"
    } else {
        "no rotation: u₁ and v₁ are not at right angles"
    };
    let at = [1, 2, 3, 4, 1, 2].map(|k| ratio(k, 1));
    // α = arctan(4/3), of cosine 3/5: everything is of degree 2 in (c, s), so the fifth divides out.
    let (found, wanted) = (found.at(&at) / ratio(25, 1), wanted.at(&at) / ratio(25, 1));
    let witness = format!(
        "{what}; at (U, V) = (1, 2), cos α = 3/5, sin α = 4/5, σ1 = 1, σ2 = 1/2: u₁²/σ1² + v₁²/σ2² = {found}, not {wanted}"
    );
    decided(found != wanted, witness)
}
