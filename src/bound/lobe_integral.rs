//! Int(n) of the bells for cosⁿ, over the same arithmetic as the closed forms of cs_16.

use super::EnclosedRule;
use crate::integral::{Edge, ScaledIntegral};
use crate::kernel::cubic::BellFormula;
use crate::kernel::model::{Convention, LobeAngle, Model};

/// The integral of one bell under one model, on the lobe's support cut by the hemisphere.
///
/// ```
/// use bellfit::{bound::LobeIntegral, integral::ScaledIntegral};
/// use bellfit::kernel::{cubic::BellFormula, model::Model};
/// // The lobe paper's cs_16 under Phong: n Int(n) = 16/17.
/// let cs_16 = BellFormula { power: 16, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
/// let integral = LobeIntegral::new("cs16", cs_16, Model::Phong).expect("a low degree");
/// assert!((integral.scaled(&(1.0 / 64.0)) - 16.0 / 17.0).abs() < 1e-14);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LobeIntegral {
    name: String,
    formula: BellFormula,
    model: Model,
    rule: EnclosedRule,
}

impl LobeIntegral {
    /// The bell of that name, whose p has no zero before T; `None` for a power so large that no rule is exact to its degree.
    pub fn new(name: &str, formula: BellFormula, model: Model) -> Option<Self> {
        let straight = formula.linear == [0.0; 3] && formula.square == [0.0; 3];
        // The weights are at most cubic in the cosine.
        let degree = formula.power.checked_mul(if straight { 1 } else { 3 })?.checked_add(3)?;
        Some(LobeIntegral { name: name.to_owned(), formula, model, rule: EnclosedRule::exact_to(degree)? })
    }

    /// The bell.
    pub fn formula(&self) -> &BellFormula {
        &self.formula
    }
}

impl ScaledIntegral for LobeIntegral {
    fn model(&self) -> Model {
        self.model
    }

    fn name(&self) -> String {
        self.name.clone()
    }

    /// n Int(n), Int without its factor 2π, as a function of m = 1/n ≥ 0.
    ///
    /// n Int = T ∫_0^Y p^K P(1 - m T y) dy, p = (1 - y)(1 + α y + β y²), Y the smaller of 1 and the
    /// hemisphere's edge, P = 1 (Phong, NDF), c (their cosine weighted twins), 4 c (Blinn-Phong) or
    /// 4 c (2 c² - 1): a polynomial in y, for which the rule is exact.
    fn scaled<T: Edge>(&self, m: &T) -> T {
        let exactly = |x: f64| T::between(x, x);
        let at = |[a, b, c]: [f64; 3]| exactly(a) + m.clone() * (exactly(b) + m.clone() * exactly(c));
        let (reach, linear, square) =
            (at(self.formula.reach), at(self.formula.linear), at(self.formula.square));
        let one = T::int(1);
        let edge = match self.model.angle() {
            LobeAngle::Full => one.clone(),
            LobeAngle::Half => one.clone() - (one.clone() / T::int(2)).sqrt(),
        };
        let s = m.clone() * reach.clone();
        // max(1, s/edge) = -min(-1, -s/edge), without a division by an m of 0.
        let beyond = (T::int(-1)).min(&(T::int(0) - s.clone() / edge));
        let end = T::int(-1) / beyond;
        let weight = |c: T| match (self.model.angle(), self.model.convention()) {
            (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => T::int(1),
            (LobeAngle::Full, _) => c,
            (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => T::int(4) * c,
            (LobeAngle::Half, _) => T::int(4) * c.clone() * (T::int(2) * c.power(2) - T::int(1)),
        };
        let integrand = |x: T| {
            let y = end.clone() * x;
            let q = one.clone() + y.clone() * (linear.clone() + y.clone() * square.clone());
            let p = (one.clone() - y.clone()) * q;
            p.power(self.formula.power) * weight(one.clone() - s.clone() * y)
        };
        reach.clone() * end.clone() * self.rule.integrate(integrand)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::{Interval, integral_enclosure};
    use crate::integral::{Case, Limit, Lobe, ScaledIntegral};

    /// cs_16 written as a bell with T = 16 must have the closed form's integral, on both sides of
    /// n = 54.6, where the hemisphere starts to cut the lobes in θ/2.
    #[test]
    fn the_papers_lobe_has_its_closed_form() {
        let cs_16 = BellFormula { power: 16, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] };
        for model in Model::ALL {
            let integral = LobeIntegral::new("cs16", cs_16, model).unwrap();
            let case = Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
            for n in [16.0, 20.0, 54.0, 55.0, 300.0, 1024.0] {
                let n_interval = Interval::from(n);
                let found = integral.scaled(&(Interval::from(1.0) / n_interval)) / n_interval;
                assert!(!found.is_disjoint(integral_enclosure(case, n)), "{} {n}", model.id());
                assert!(found.width() < 1e-12 * found.hi(), "{} {n}: {found:?}", model.id());
            }
        }
    }
}
