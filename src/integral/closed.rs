//! The closed forms of Int(n).
//!
//! With w = 1 - cos of the lobe's own angle (θ, α, or θ/2) and b = 1 - n w/16 the integrals of
//! cs_16 are ∫ b^16 P(cos) db with a polynomial P, so they need the lobe's value at the limit and
//! no quadrature. In m = 1/n the product n Int(n) has neither a pole nor a cancelling power of n.

use super::{Case, Edge, Field, Limit, Lobe};
use crate::kernel::model::{Convention, LobeAngle, Model};

/// The power of the lobe paper's bell, (1).
const POWER: i64 = 16;

/// n Int(n), Int without its factor 2π, as a function of m = 1/n.
///
/// For cs_16, with s = 16 m and B the bell's base at the limit:
/// n Int = 16 ∫_B^1 b^16 P(c) db, c = 1 - s + s b, where P is 1 (Phong, NDF), c (their cosine
/// weighted twins), 4 c (Blinn-Phong, from sin θ dθ = 4 cos(θ/2) sin(θ/2) d(θ/2)) or
/// 4 c (2 c² - 1). For cosⁿ see Table 1 of the lobe paper.
///
/// Accuracy: every term is positive for n ≥ 16 except in 2 c² - 1; the enclosures in the tables
/// have a relative width below 1e-13.
///
/// ```
/// use bellfit::integral::{scaled_closed_form, Case, Limit, Lobe};
/// use bellfit::kernel::model::Model;
/// let phong = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
/// // Int(n) = 16/(17 n)
/// assert!((scaled_closed_form(phong, &(1.0 / 64.0)) - 16.0 / 17.0).abs() < 1e-15);
/// ```
pub fn scaled_closed_form<T: Edge>(case: Case, m: &T) -> T {
    match case.lobe {
        Lobe::CosN => scaled_cos_n(case.model, m, &m.half_power()),
        Lobe::Cs16 => {
            let base = T::int(1) - scaled_versine(case.model, case.limit, m) / T::int(POWER);
            scaled_bell(case.model, m, &base)
        }
    }
}

/// Int(n) in floating point: [`scaled_closed_form`] divided by n.
pub fn closed_form(case: Case, n: f64) -> f64 {
    scaled_closed_form(case, &(1.0 / n)) / n
}

/// t = n (1 - cos ψ) at the limit, ψ in the lobe's own angle; m = 1/n.
pub fn scaled_versine<T: Edge>(model: Model, limit: Limit, m: &T) -> T {
    // n θ² at the limit is `square` unless the hemisphere's edge comes first.
    let by_angle = |square: i64| {
        let z = T::int(square).min(&(T::half_pi_squared() / m.clone()));
        let z = match model.angle() {
            LobeAngle::Full => z,
            LobeAngle::Half => z / T::int(4),
        };
        z.clone() * (z * m.clone()).versine_ratio()
    };
    match (limit, model.angle()) {
        (Limit::Paper, _) => by_angle(36),
        (Limit::Card, _) => by_angle(6),
        (Limit::ExactZero | Limit::Support, LobeAngle::Full) => T::int(POWER).min(&(T::int(1) / m.clone())),
        (Limit::ExactZero, LobeAngle::Half) => {
            // cos θ = 1 - 16 m, so cos(θ/2) = √(1 - 8 m); 1 - √(1 - u) = u/(1 + √(1 - u)).
            let half = T::int(1) / T::int(2);
            let u = (T::int(POWER / 2) * m.clone()).min(&half);
            let t = T::int(POWER / 2).min(&(half / m.clone()));
            t / (T::int(1) + (T::int(1) - u).sqrt())
        }
        (Limit::Support, LobeAngle::Half) => {
            // 1 - √½ is the versine of π/4, where the hemisphere ends for θ/2.
            let edge = T::int(1) - (T::int(1) / T::int(2)).sqrt();
            T::int(POWER).min(&(edge / m.clone()))
        }
    }
}

/// 16 ∫_B^1 b^16 P(1 - 16 m (1 - b)) db.
pub fn scaled_bell<T: Field>(model: Model, m: &T, base: &T) -> T {
    let s = T::int(POWER) * m.clone();
    let rest = T::int(1) - s.clone();
    // ∫_B^1 b^(16+j) db
    let moment = |j: u32| (T::int(1) - base.power(17 + j)) / T::int(17 + i64::from(j));
    let first = || rest.clone() * moment(0) + s.clone() * moment(1);
    let third = || {
        rest.power(3) * moment(0)
            + T::int(3) * rest.power(2) * s.clone() * moment(1)
            + T::int(3) * rest.clone() * s.power(2) * moment(2)
            + s.power(3) * moment(3)
    };
    let integral = match (model.angle(), model.convention()) {
        (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => moment(0),
        (LobeAngle::Full, Convention::RdfCosine | Convention::Heightfield) => first(),
        (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => T::int(4) * first(),
        (LobeAngle::Half, Convention::RdfCosine | Convention::Heightfield) => {
            T::int(8) * third() - T::int(4) * first()
        }
    };
    T::int(POWER) * integral
}

/// n Int(n) of cosⁿ over the hemisphere, with h = 2^(-n/2): 1/(1 + m), 1/(1 + 2 m),
/// (4 - 2 h)/(1 + 2 m) and 4 (1 + h m)/((1 + 2 m)(1 + 4 m)).
pub fn scaled_cos_n<T: Field>(model: Model, m: &T, h: &T) -> T {
    let plus = |k: i64| T::int(1) + T::int(k) * m.clone();
    match (model.angle(), model.convention()) {
        (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => T::int(1) / plus(1),
        (LobeAngle::Full, Convention::RdfCosine | Convention::Heightfield) => T::int(1) / plus(2),
        (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => (T::int(4) - T::int(2) * h.clone()) / plus(2),
        (LobeAngle::Half, Convention::RdfCosine | Convention::Heightfield) => {
            T::int(4) * (T::int(1) + h.clone() * m.clone()) / (plus(2) * plus(4))
        }
    }
}
