//! The forms of a factor beyond the papers' line.

use super::Form;
use crate::integral::Field;

/// A factor coef(n) = form/(divisor π) in parameters p0..p3.
///
/// Each form but the first is a simpler one with one more term:
/// proportional < linear < inverse < inverse-square, and inverse < ratio.
///
/// ```
/// use bellfit::fit::FactorForm;
/// let form = FactorForm::from_id("ratio").expect("a form");
/// assert_eq!(form.formula(), "p0 n + p1 + p2/(n + p3)");
/// // coef(n) divisor π/n at n = 4: 1 + 2/4 + 3/(4 (4 + 2))
/// assert_eq!(form.per_n(&[1.0, 2.0, 3.0, 2.0], &0.25), 1.625);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FactorForm {
    /// p0 n.
    Proportional,
    /// p0 n + p1, the papers' form.
    Linear,
    /// p0 n + p1 + p2/n.
    Inverse,
    /// p0 n + p1 + p2/n + p3/n².
    InverseSquare,
    /// p0 n + p1 + p2/(n + p3), without a pole in the range.
    Ratio,
}

impl FactorForm {
    /// All, each after what it extends.
    pub const ALL: [FactorForm; 5] = [
        FactorForm::Proportional,
        FactorForm::Linear,
        FactorForm::Inverse,
        FactorForm::InverseSquare,
        FactorForm::Ratio,
    ];

    /// The name on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            FactorForm::Proportional => "proportional",
            FactorForm::Linear => "linear",
            FactorForm::Inverse => "inverse",
            FactorForm::InverseSquare => "inverse-square",
            FactorForm::Ratio => "ratio",
        }
    }

    /// The form of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.id() == id)
    }

    /// The formula, as files spell it.
    pub const fn formula(self) -> &'static str {
        match self {
            FactorForm::Proportional => "p0 n",
            FactorForm::Linear => "p0 n + p1",
            FactorForm::Inverse => "p0 n + p1 + p2/n",
            FactorForm::InverseSquare => "p0 n + p1 + p2/n + p3/n^2",
            FactorForm::Ratio => "p0 n + p1 + p2/(n + p3)",
        }
    }

    /// How many parameters it has.
    pub const fn parameters(self) -> usize {
        match self {
            FactorForm::Proportional => 1,
            FactorForm::Linear => 2,
            FactorForm::Inverse => 3,
            FactorForm::InverseSquare | FactorForm::Ratio => 4,
        }
    }

    /// The form that this one extends by a term; p3 = 0 makes a ratio an inverse.
    pub const fn simpler(self) -> Option<Self> {
        match self {
            FactorForm::Proportional => None,
            FactorForm::Linear => Some(FactorForm::Proportional),
            FactorForm::Inverse => Some(FactorForm::Linear),
            FactorForm::InverseSquare | FactorForm::Ratio => Some(FactorForm::Inverse),
        }
    }

    /// The same as a form of the two unknowns a and b, if it is one.
    pub const fn as_line(self) -> Option<Form> {
        match self {
            FactorForm::Proportional => Some(Form::Proportional),
            FactorForm::Linear => Some(Form::Linear),
            FactorForm::Inverse | FactorForm::InverseSquare | FactorForm::Ratio => None,
        }
    }

    /// form(n)/n at m = 1/n, m = 0 included: a polynomial in m, or for the ratio
    /// p0 + p1 m + p2 m²/(1 + p3 m).
    ///
    /// # Panics
    /// With fewer than [`FactorForm::parameters`].
    pub fn per_n<T: Field>(self, p: &[T], m: &T) -> T {
        let terms = if self == FactorForm::Ratio { 2 } else { self.parameters() };
        let polynomial = p[..terms].iter().rev().fold(T::int(0), |sum, c| sum * m.clone() + c.clone());
        if self == FactorForm::Ratio {
            let pole = T::int(1) + p[3].clone() * m.clone();
            polynomial + p[2].clone() * m.power(2) / pole
        } else {
            polynomial
        }
    }
}

impl From<Form> for FactorForm {
    fn from(form: Form) -> Self {
        match form {
            Form::Linear => FactorForm::Linear,
            Form::Proportional => FactorForm::Proportional,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_holds_the_simpler_one() {
        for form in FactorForm::ALL {
            assert_eq!(FactorForm::from_id(form.id()), Some(form));
            assert!(form.formula().contains(&format!("p{}", form.parameters() - 1)));
            let Some(simpler) = form.simpler() else { continue };
            assert_eq!(form.parameters(), simpler.parameters() + 1);
            let p = [1.25, -0.5, 3.0, 0.0];
            for m in [0.0, 0.001, 0.0625, 1.0] {
                let mut padded = p;
                padded[simpler.parameters()..].fill(0.0);
                assert_eq!(form.per_n(&padded, &m), simpler.per_n(&p, &m), "{}", form.id());
            }
        }
    }
}
