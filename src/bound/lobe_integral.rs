//! Int(n) of bells by a rule that is exact for them, over the same arithmetic as the closed forms of cs_16.

use super::{EnclosedRule, Interval, PolynomialBell, reciprocal};
use crate::integral::{Edge, Field, Limit, ScaledIntegral, scaled_versine};
use crate::kernel::cubic::BellFormula;
use crate::kernel::model::{Convention, LobeAngle, Model};
use dashu_ratio::RBig;

/// How far an n is looked for from which on a limit lies beyond the bell, and by how many halvings.
const FARTHEST: f64 = 65_536.0;
const HALVINGS: u32 = 64;

/// The integral of one bell under one model, on the lobe's support cut by the hemisphere unless another
/// [`Limit`] is asked for.
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
    shape: Shape,
    model: Model,
    limit: Limit,
    rule: EnclosedRule,
}

/// p as a function of u = t/T in [0, 1], T where the bell ends.
#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Formula(BellFormula),
    Polynomial { bell: Box<PolynomialBell>, moments: Option<Box<[RBig; 4]>> },
}

impl LobeIntegral {
    /// The bell of that name, whose p has no zero before T; `None` for a power so large that no rule is exact to its degree.
    pub fn new(name: &str, formula: BellFormula, model: Model) -> Option<Self> {
        let straight = formula.linear == [0.0; 3] && formula.square == [0.0; 3];
        let degree = formula.power.checked_mul(if straight { 1 } else { 3 })?;
        Self::with_shape(name, Shape::Formula(formula), degree, model)
    }

    /// The bell of that name whose coefficients are decimals, exactly.
    ///
    /// `None` never for a [`PolynomialBell`], whose degree is bounded for this.
    ///
    /// ```
    /// use bellfit::bound::{LobeIntegral, PolynomialBell, decimal};
    /// use bellfit::{integral::{Limit, ScaledIntegral}, kernel::model::Model};
    /// let [one, minus] = ["1", "-1"].map(|text| decimal(text).expect("a decimal").0);
    /// let bell = PolynomialBell::new(&[one, minus], 8)?;
    /// let integral = LobeIntegral::of_polynomial("mine", bell, Model::Phong).expect("a low degree");
    /// // (1 - t/8)^8: 8/9 on its support, 8/9 (1 - (1 - t/8)^9) up to t = n (1 - cos √(6/n)).
    /// assert!((integral.scaled(&(1.0 / 64.0)) - 8.0 / 9.0).abs() < 1e-14);
    /// let t = 64.0 * (1.0 - (6.0_f64 / 64.0).sqrt().cos());
    /// let beyond = (1.0 - t / 8.0).powi(9);
    /// let found = integral.at_limit(Limit::Card).scaled(&(1.0 / 64.0));
    /// assert!((found - 8.0 / 9.0 * (1.0 - beyond)).abs() < 1e-13);
    /// # Ok::<(), bellfit::bound::PolynomialBellError>(())
    /// ```
    pub fn of_polynomial(name: &str, bell: PolynomialBell, model: Model) -> Option<Self> {
        let degree = bell.power() * bell.degree();
        let moments = bell.moments().map(Box::new);
        Self::with_shape(name, Shape::Polynomial { bell: Box::new(bell), moments }, degree, model)
    }

    fn with_shape(name: &str, shape: Shape, degree: u32, model: Model) -> Option<Self> {
        // The weights are at most cubic in the cosine.
        let rule = EnclosedRule::exact_to(degree.checked_add(3)?)?;
        Some(LobeIntegral { name: name.to_owned(), shape, model, limit: Limit::Support, rule })
    }

    /// The same bell integrated up to another limit: the smaller of it, the bell's own end and the
    /// hemisphere. [`Limit::ExactZero`] is the angle θ of the bell's own zero, whatever the lobe's angle.
    pub fn at_limit(self, limit: Limit) -> Self {
        LobeIntegral { limit, ..self }
    }

    /// The weight that the model lays over the bell, c the cosine of the lobe's own angle: 1 (Phong, NDF),
    /// c (their cosine weighted twins), 4 c (Blinn-Phong) or 4 c (2 c² - 1).
    fn weight<T: Field>(&self, c: T) -> T {
        match (self.model.angle(), self.model.convention()) {
            (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => T::int(1),
            (LobeAngle::Full, _) => c,
            (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => T::int(4) * c,
            (LobeAngle::Half, _) => T::int(4) * c.clone() * (T::int(2) * c.power(2) - T::int(1)),
        }
    }

    /// u at the limit, s = T/n.
    fn end<T: Edge>(&self, m: &T, reach: &T, s: &T) -> T {
        let one = T::int(1);
        match (self.limit, self.model.angle()) {
            (Limit::Paper | Limit::Card, _) => {
                one.min(&(scaled_versine(self.model, self.limit, m) / reach.clone()))
            }
            (Limit::ExactZero, LobeAngle::Half) => {
                // cos θ = 1 - s: 1 - cos(θ/2) = (s/2)/(1 + √(1 - s/2)), and θ = π/2 from s = 1 on.
                let half = one.clone() / T::int(2);
                let root = (one.clone() - (s.clone() / T::int(2)).min(&half)).sqrt();
                T::int(-1) / (T::int(-2).min(&(T::int(-2) * s.clone())) * (one + root))
            }
            (Limit::ExactZero | Limit::Support, angle) => {
                let edge = match angle {
                    LobeAngle::Full => one.clone(),
                    LobeAngle::Half => one.clone() - (one / T::int(2)).sqrt(),
                };
                // max(1, s/edge) = -min(-1, -s/edge), without a division by an m of 0.
                T::int(-1) / (T::int(-1)).min(&(T::int(0) - s.clone() / edge))
            }
        }
    }
}

impl LobeIntegral {
    /// The n ≥ `held` from which on the limit 6/√n or √(6/n) lies beyond the bell's end, if it ever does.
    ///
    /// t at the limit never falls as n grows: it is n times a constant up to the hemisphere's edge, and then
    /// n (1 - cos (c/√n)), because (1 - cos x)/x² falls.
    fn limit_beyond(&self, reach: f64, held: f64) -> Option<f64> {
        let square = if self.limit == Limit::Paper { 36.0 } else { 6.0 };
        if (Interval::half_pi_squared() * Interval::from(held)).hi() <= square {
            return Some(held); // the limit is the hemisphere's edge there, and so no nearer later
        }
        let beyond =
            |n: f64| scaled_versine(self.model, self.limit, &reciprocal(Interval::from(n))).lo() >= reach;
        let (mut before, mut from) = (held, FARTHEST);
        if !beyond(from) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (before + from);
            if beyond(middle) { from = middle } else { before = middle }
        }
        Some(from)
    }
}

impl ScaledIntegral for LobeIntegral {
    fn model(&self) -> Model {
        self.model
    }

    fn name(&self) -> String {
        self.name.clone()
    }

    fn limit(&self) -> &'static str {
        self.limit.id()
    }

    /// n Int(n), Int without its factor 2π, as a function of m = 1/n ≥ 0.
    ///
    /// n Int = T ∫_0^U p^K P(1 - m T u) du, U the smaller of 1, the limit and the hemisphere's edge, P the
    /// model's weight: a polynomial in u, for which the rule is exact.
    fn scaled<T: Edge>(&self, m: &T) -> T {
        let exactly = |x: f64| T::between(x, x);
        let at = |[a, b, c]: [f64; 3]| exactly(a) + m.clone() * (exactly(b) + m.clone() * exactly(c));
        let enclosed = |i: &Interval| T::between(i.lo(), i.hi());
        let (reach, power, factors) = match &self.shape {
            Shape::Formula(f) => (at(f.reach), f.power, vec![T::int(1), at(f.linear), at(f.square)]),
            Shape::Polynomial { bell, .. } => {
                (enclosed(&bell.reach()), bell.power(), bell.unit().iter().map(enclosed).collect())
            }
        };
        let is_formula = matches!(self.shape, Shape::Formula(_));
        let one = T::int(1);
        let s = m.clone() * reach.clone();
        let end = self.end(m, &reach, &s);
        let integrand = |x: T| {
            let u = end.clone() * x;
            let horner = |sum: Option<T>, c: &T| {
                Some(sum.map_or_else(|| c.clone(), |sum| c.clone() + u.clone() * sum))
            };
            let q = factors.iter().rev().fold(None, horner).unwrap_or_else(|| T::int(0));
            // The formulas have their zero factored out.
            let p = if is_formula { (one.clone() - u.clone()) * q } else { q };
            p.power(power) * self.weight(one.clone() - s.clone() * u)
        };
        reach.clone() * end.clone() * self.rule.integrate(integrand)
    }

    /// Where a polynomial's zero is rational and hemisphere and limit hold the whole bell: T times the moments of
    /// p^K in powers of T m.
    fn rational<T: Field>(&self, m: &T, _h: &T) -> Option<(f64, T)> {
        let Shape::Polynomial { bell, moments: Some(moments) } = &self.shape else { return None };
        let reach = bell.rational_reach()?;
        // From here on the hemisphere holds the whole bell.
        let held = match self.model.angle() {
            LobeAngle::Full => bell.reach().hi(),
            LobeAngle::Half => {
                let root = (Interval::from(1.0) / Interval::from(2.0)).square_root();
                (bell.reach() / (Interval::from(1.0) - root)).hi()
            }
        };
        let from = match (self.limit, self.model.angle()) {
            (Limit::Support, _) | (Limit::ExactZero, LobeAngle::Full) => held,
            (Limit::ExactZero, LobeAngle::Half) => return None,
            (Limit::Paper | Limit::Card, _) => self.limit_beyond(bell.reach().hi(), held)?,
        };
        let reach: T = rational(&reach);
        let s = m.clone() * reach.clone();
        let [m0, m1, m2, m3] = moments.each_ref().map(|moment| rational::<T>(moment));
        let first = || m0.clone() - s.clone() * m1.clone();
        let third = || {
            m0.clone() - T::int(3) * s.clone() * m1.clone() + T::int(3) * s.power(2) * m2.clone()
                - s.power(3) * m3.clone()
        };
        let integral = match (self.model.angle(), self.model.convention()) {
            (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => m0.clone(),
            (LobeAngle::Full, _) => first(),
            (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => T::int(4) * first(),
            (LobeAngle::Half, _) => T::int(8) * third() - T::int(4) * first(),
        };
        Some((from, reach * integral))
    }
}

/// An exact number in any field, from pieces that fit.
fn rational<T: Field>(value: &RBig) -> T {
    let digits = |text: String| {
        let negative = text.starts_with('-');
        let size = text
            .bytes()
            .filter(u8::is_ascii_digit)
            .fold(T::int(0), |sum, digit| sum * T::int(10) + T::int(i64::from(digit - b'0')));
        if negative { T::int(0) - size } else { size }
    };
    digits(value.numerator().to_string()) / digits(value.denominator().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::{Integral, Interval, integral_enclosure};
    use crate::integral::{Case, Limit, Lobe, ScaledIntegral};
    use crate::kernel::stand_in::StandIn;

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

    fn polynomial(coefficients: &[&str], power: u32) -> PolynomialBell {
        let exact: Vec<RBig> = coefficients.iter().map(|c| crate::bound::decimal(c).unwrap().0).collect();
        PolynomialBell::new(&exact, power).unwrap()
    }

    /// (1 - t/16)^16 by its coefficients is cs_16: on every limit that ends before its zero, and on the paper's,
    /// where what the formula has beyond the zero is below every enclosure's width.
    #[test]
    fn a_bell_by_its_coefficients_has_the_closed_form() {
        for model in Model::ALL {
            for limit in Limit::ALL {
                let bell = LobeIntegral::of_polynomial("mine", polynomial(&["1", "-1"], 16), model);
                let integral = bell.unwrap().at_limit(limit);
                let case = Case { model, lobe: Lobe::Cs16, limit };
                for n in [16.0, 20.0, 54.0, 55.0, 300.0, 1024.0] {
                    let n_interval = Interval::from(n);
                    let found = integral.scaled(&(Interval::from(1.0) / n_interval)) / n_interval;
                    assert!(!found.is_disjoint(integral_enclosure(case, n)), "{case} {n}");
                    assert!(found.width() < 1e-12 * found.hi(), "{case} {n}: {found:?}");
                }
            }
        }
    }

    /// 1 - y/2 - y²/2 = (1 - y)(1 + y/2), and two that end at 10/3: the closed form, by its exact moments, and the
    /// rule share no code.
    #[test]
    fn exact_moments_and_the_rule_agree() {
        let bells: [&[&str]; 3] = [&["1", "-0.5", "-0.5"], &["1", "-0.3"], &["1", "-0.1", "-0.06"]];
        for (model, bell) in Model::ALL.into_iter().flat_map(|model| bells.map(|bell| (model, bell))) {
            let integral = LobeIntegral::of_polynomial("mine", polynomial(bell, 4), model).unwrap();
            for n in [4.0, 14.0, 20.0, 300.0] {
                let m = Interval::from(1.0) / Interval::from(n);
                let (from, closed) = integral.rational(&m, &Interval::from(0.0)).unwrap();
                if n >= from {
                    let found = integral.scaled(&m);
                    assert!(!found.is_disjoint(closed) && closed.width() < 1e-12, "{} {n}", model.id());
                }
            }
        }
        assert!(
            LobeIntegral::of_polynomial("mine", polynomial(&["1", "0", "-2"], 2), Model::Phong)
                .unwrap()
                .rational(&Interval::from(0.0), &Interval::from(0.0))
                .is_none()
        );
    }
    /// Messages name the model, the lobe and the limit as files do.
    #[test]
    fn an_integral_says_which_it_is() {
        for limit in Limit::ALL {
            let bell = LobeIntegral::of_polynomial("mine", polynomial(&["1", "-1"], 16), Model::Phong);
            let bell = Integral::Bell(Box::new(bell.unwrap().at_limit(limit)));
            assert_eq!(bell.describe(), format!("phong, mine, {}", limit.id()));
            let closed = Integral::Closed(Case { model: Model::BlinnPhong, lobe: Lobe::Cs16, limit });
            assert_eq!(closed.describe(), format!("blinn-phong, cs16, {}", limit.id()));
        }
        let adopted = StandIn::Cubic4;
        let bell = LobeIntegral::new(adopted.id(), adopted.formula().unwrap(), Model::Phong).unwrap();
        assert_eq!(bell.describe(), format!("phong, cubic-4, {}", Limit::Support.id()));
    }
}
