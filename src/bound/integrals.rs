//! The table of integrals: each Int(n) enclosed, and the three routes agreeing on it.

use super::difference::reciprocal;
use super::{Extremes, Interval};
use crate::integral::{Case, Disagreement, Estimate, GaussTable, Routes, scaled_closed_form};

/// One Int(n), without its factor 2π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegralRow {
    /// The specular exponent.
    pub n: u32,
    /// Encloses the exact value, relative width below 1e-12.
    pub enclosure: Interval,
    /// By double exponential quadrature.
    pub quadrature: Estimate,
}

/// Int(n) of one case, every integer n of a range.
#[derive(Clone, Debug, PartialEq)]
pub struct IntegralTable {
    /// Which integral.
    pub case: Case,
    /// In ascending n.
    pub rows: Vec<IntegralRow>,
}

/// Encloses Int(n): the closed form in interval arithmetic.
///
/// ```
/// use bellfit::{bound::integral_enclosure, integral::{Case, Limit, Lobe}, kernel::model::Model};
/// let case = Case { model: Model::BlinnPhong, lobe: Lobe::CosN, limit: Limit::Support };
/// let int = integral_enclosure(case, 16.0);
/// assert!(int.contains(2.0 / 9.0 * (1.0 - 1.0 / 512.0))); // 4 (1 - 2^(-9))/18
/// ```
pub fn integral_enclosure(case: Case, n: f64) -> Interval {
    let n = Interval::from(n);
    scaled_closed_form(case, &reciprocal(n)) / n
}

impl IntegralTable {
    /// Computes the table for the integers from..=to.
    ///
    /// # Errors
    /// If two routes disagree anywhere; the error names the place.
    pub fn compute(case: Case, from: u32, to: u32) -> Result<Self, Disagreement> {
        let mut gauss = GaussTable::default();
        let mut rows = Vec::with_capacity((to - from) as usize + 1);
        for n in from..=to {
            let x = f64::from(n);
            let routes = Routes::evaluate(case, x, &mut gauss);
            routes.agree(case, x)?;
            let enclosure = integral_enclosure(case, x);
            // The closed form in doubles is not proved; the enclosure is, so it is held to it.
            Routes { closed: enclosure.mid(), ..routes }.agree(case, x)?;
            rows.push(IntegralRow { n, enclosure, quadrature: routes.exponential });
        }
        Ok(IntegralTable { case, rows })
    }

    /// How much of `whole` this table's integrals keep, over the rows both have: the least and
    /// the largest quotient, each with its n.
    pub fn share_of(&self, whole: &IntegralTable) -> Option<Extremes> {
        let pairs = self.rows.iter().zip(&whole.rows).filter(|(part, all)| part.n == all.n);
        let shares: Vec<(f64, Interval)> =
            pairs.map(|(part, all)| (f64::from(part.n), part.enclosure / all.enclosure)).collect();
        Extremes::of(&shares)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::{Limit, Lobe};
    use crate::kernel::model::Model;

    /// Phong's integrals are 1/(n + 1) for cosⁿ and 16/(17 n) for cs_16: the quotient 16 (n + 1)/(17 n) falls
    /// from 1 at n = 16.
    #[test]
    fn a_share_is_the_quotient_of_the_integrals() {
        let table = |lobe, from, to| {
            let limit = if lobe == Lobe::CosN { Limit::Support } else { Limit::ExactZero };
            IntegralTable::compute(Case { model: Model::Phong, lobe, limit }, from, to).unwrap()
        };
        let (whole, part) = (table(Lobe::CosN, 16, 32), table(Lobe::Cs16, 16, 32));
        let share = part.share_of(&whole).unwrap();
        assert!(share.max.value.contains(1.0) && share.max.value.width() < 1e-12);
        assert!(share.min.value.contains(33.0 / 34.0) && share.min.value.width() < 1e-12);
        assert_eq!((share.max.n, share.min.n), (16.0, 32.0));
        assert!(table(Lobe::Cs16, 33, 40).share_of(&whole).is_none(), "no n in both");
    }
}
