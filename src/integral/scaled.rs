//! What a fit and its certificate ask of an integral: n Int(n) in m = 1/n, over any arithmetic.

use super::{Case, Edge, Field, Limit, Lobe, scaled_bell, scaled_closed_form, scaled_cos_n, scaled_versine};
use crate::kernel::model::{Convention, LobeAngle, Model};

/// A lobe's integral over one model's hemisphere, as everything that fits a factor to it sees it.
///
/// The residual of a factor is 2π coef(n) Int(n) - 1 = 2π (coef(n)/n) (n Int(n)) - 1, and both brackets
/// are finite functions of m = 1/n down to m = 0: a range of n may end at infinity.
///
/// ```
/// use bellfit::integral::{Case, Edge, Field, Limit, Lobe, ScaledIntegral};
/// use bellfit::kernel::model::Model;
///
/// /// e^(-n (1 - cos θ)) over all t = n (1 - cos θ), without its hemisphere's edge: Int = 1/n.
/// struct Exponential;
/// impl ScaledIntegral for Exponential {
///     fn scaled<T: Edge>(&self, _m: &T) -> T {
///         T::int(1)
///     }
///     fn model(&self) -> Model {
///         Model::Phong
///     }
///     fn name(&self) -> String {
///         "exponential".into()
///     }
/// }
/// assert_eq!(Exponential.describe(), "phong, exponential, support");
/// let cosine = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
/// assert_eq!((cosine.name(), cosine.scaled(&0.0)), ("cos-n".to_owned(), 1.0)); // n/(n + 1) → 1
/// ```
pub trait ScaledIntegral {
    /// n Int(n), Int without its factor 2π, as a function of m = 1/n: finite and positive for
    /// 0 ≤ m ≤ 1.
    fn scaled<T: Edge>(&self, m: &T) -> T;

    /// The same for n ≥ `from` only, by terms that do not cancel there if those of
    /// [`ScaledIntegral::scaled`] do.
    fn scaled_from<T: Edge>(&self, _from: f64, m: &T) -> T {
        self.scaled(m)
    }

    /// The model whose factor it is.
    fn model(&self) -> Model;

    /// The lobe's name in files.
    fn name(&self) -> String;

    /// The limit's name in files.
    fn limit(&self) -> &'static str {
        Limit::Support.id()
    }

    /// n Int(n) where it is rational in m and h = 2^(-n/2), with the n from which on it is; then a
    /// residual of 0 can be told from one that is nearly 0.
    fn rational<T: Field>(&self, _m: &T, _h: &T) -> Option<(f64, T)> {
        None
    }

    /// The d of coef(n) = form/(d π): 2, or 8 for the lobes in θ/2, as the lobe paper prints.
    fn divisor(&self) -> u32 {
        match self.model().angle() {
            LobeAngle::Full => 2,
            LobeAngle::Half => 8,
        }
    }

    /// Model, lobe and limit, for messages.
    fn describe(&self) -> String {
        format!("{}, {}, {}", self.model().id(), self.name(), self.limit())
    }
}

/// By the closed forms: [`scaled_closed_form`], whose terms cancel for n < 16, and for these n integrated
/// by parts. Enclosures have a relative width below 1e-13 for n ≥ 16 and below 2e-12 for every n ≥ 1.
impl ScaledIntegral for Case {
    fn scaled<T: Edge>(&self, m: &T) -> T {
        scaled_closed_form(*self, m)
    }

    fn scaled_from<T: Edge>(&self, from: f64, m: &T) -> T {
        if from >= 16.0 || self.lobe == Lobe::CosN { self.scaled(m) } else { by_parts(*self, m) }
    }

    fn model(&self) -> Model {
        self.model
    }

    fn name(&self) -> String {
        self.lobe.id().to_owned()
    }

    fn limit(&self) -> &'static str {
        self.limit.id()
    }

    fn rational<T: Field>(&self, m: &T, h: &T) -> Option<(f64, T)> {
        let up_to_zero =
            matches!(self.limit, Limit::ExactZero | Limit::Support) && self.model.angle() == LobeAngle::Full;
        match self.lobe {
            Lobe::CosN => Some((0.0, scaled_cos_n(self.model, m, h))),
            // From here on the hemisphere holds the whole bell: its base at the limit is 0.
            Lobe::Cs16 if up_to_zero => Some((16.0, scaled_bell(self.model, m, &T::int(0)))),
            Lobe::Cs16 => None,
        }
    }
}

/// n Int(n) of cs_16 for any n ≥ 1 without a difference of large terms.
///
/// With B the bell's base and C the cosine of the lobe's own angle at the limit, both at least 0, and
/// s = 16 m: c = C + s (b - B), so n Int = 16 ∫_B^1 b^16 P(C + s (b - B)) db with a P in powers of b - B
/// whose coefficients are not negative; 2 c² - 1 is (2 C² - 1) + 4 C s (b - B) + 2 s² (b - B)². (At 6/√n,
/// beyond the bell's zero, B is negative and small.)
fn by_parts<T: Edge>(case: Case, m: &T) -> T {
    let int = T::int;
    let s = int(16) * m.clone();
    let c = int(1) - versine(case, m);
    let reach = scaled_versine(case.model, case.limit, m) / int(16);
    let base = int(1) - reach.clone();
    // ∫_B^1 b^k (b - B)^j db = ((1 - B)^j - j ∫_B^1 b^(k+1) (b - B)^(j-1) db)/(k + 1): what is subtracted is
    // by 1/(k + 2) the smaller where B is 0, and at n = 1 still leaves two digits less than there are.
    let moment = |j: u32| {
        let whole = |k: u32| (int(1) - base.power(k + 1)) / int(i64::from(k) + 1);
        (1..=j).fold(whole(16 + j), |inner, i| {
            let k = i64::from(16 + j - i);
            (reach.power(i) - int(i64::from(i)) * inner) / int(k + 1)
        })
    };
    let first = || c.clone() * moment(0) + s.clone() * moment(1);
    let integral = match (case.model.angle(), case.model.convention()) {
        (LobeAngle::Full, Convention::Rdf | Convention::Ndf) => moment(0),
        (LobeAngle::Full, Convention::RdfCosine | Convention::Heightfield) => first(),
        (LobeAngle::Half, Convention::Rdf | Convention::Ndf) => int(4) * first(),
        (LobeAngle::Half, Convention::RdfCosine | Convention::Heightfield) => {
            let d = int(2) * c.power(2) - int(1);
            let second = s.clone() * (d.clone() + int(4) * c.power(2));
            let third = int(6) * c.clone() * s.power(2);
            int(4)
                * (c.clone() * d * moment(0)
                    + second * moment(1)
                    + third * moment(2)
                    + int(2) * s.power(3) * moment(3))
        }
    };
    int(16) * integral
}

/// 1 - cos ψ at the limit, ψ in the lobe's own angle: m times [`scaled_versine`] without the product.
fn versine<T: Edge>(case: Case, m: &T) -> T {
    let by_angle = |square: i64| {
        let z = (T::int(square) * m.clone()).min(&T::half_pi_squared());
        let z = if case.model.angle() == LobeAngle::Half { z / T::int(4) } else { z };
        z.clone() * z.versine_ratio()
    };
    let half = T::int(1) / T::int(2);
    match (case.limit, case.model.angle()) {
        (Limit::Paper, _) => by_angle(36),
        (Limit::Card, _) => by_angle(6),
        (Limit::ExactZero | Limit::Support, LobeAngle::Full) => (T::int(16) * m.clone()).min(&T::int(1)),
        (Limit::ExactZero, LobeAngle::Half) => {
            let u = (T::int(8) * m.clone()).min(&half);
            u.clone() / (T::int(1) + (T::int(1) - u).sqrt())
        }
        (Limit::Support, LobeAngle::Half) => (T::int(16) * m.clone()).min(&(T::int(1) - half.sqrt())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_finite_and_positive_down_to_zero() {
        for case in Case::all() {
            for m in [0.0, 1e-300, 1e-12, 1.0 / 1024.0, 1.0 / 16.0, 0.5, 1.0] {
                let value = case.scaled(&m);
                assert!(value > 0.0 && value < 5.0, "{case}, m = {m}: {value}");
            }
            // Continuous at 0: Int is smooth there.
            assert!((case.scaled(&1e-12) - case.scaled(&0.0)).abs() < 1e-9, "{case}");
        }
    }

    #[test]
    fn the_rational_form_is_the_closed_form_from_where_it_says() {
        for case in Case::all() {
            for n in [2.0_f64, 16.0, 17.5, 100.0, 1024.0] {
                let Some((from, value)) = case.rational(&(1.0 / n), &libm::exp2(-n / 2.0)) else { continue };
                if n >= from {
                    // Both are a few roundings of the same formula.
                    assert!((value / case.scaled(&(1.0 / n)) - 1.0).abs() < 1e-14, "{case}, n = {n}");
                }
            }
        }
    }

    #[test]
    fn the_integral_by_parts_is_the_closed_form() {
        for case in Case::all().filter(|case| case.lobe == Lobe::Cs16) {
            for n in [1.0_f64, 1.5, 4.0, 8.0, 14.0, 16.0, 17.0, 54.0, 100.0, 1024.0, f64::INFINITY] {
                let m = 1.0 / n;
                let (by_parts, closed) = (by_parts(case, &m), case.scaled(&m));
                // The closed form's terms grow as n falls: of third powers of 16 m.
                let cancelled = 1e-14 * (1.0 + 4096.0 * m * m * m);
                assert!((by_parts / closed - 1.0).abs() < cancelled, "{case}, n = {n}: {by_parts} {closed}");
                assert_eq!(case.scaled_from(1.0, &m), by_parts);
                assert_eq!(case.scaled_from(16.0, &m), closed);
            }
        }
    }

    #[test]
    fn an_integral_is_described_by_its_model_lobe_and_limit() {
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Paper };
        assert_eq!(ScaledIntegral::describe(&case), "phong, cs16, paper");
    }
}
