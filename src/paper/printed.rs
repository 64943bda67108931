//! What printed digits mean.

use crate::bound::{decimal, power_of_ten};
use crate::integral::Field;
use dashu_ratio::RBig;

/// A number as printed: its text, its exact value, and the numbers that would print so.
///
/// ```
/// use bellfit::paper::Printed;
/// let bound = Printed::parse("1.7e-2").unwrap();
/// // 1.65e-2 to 1.75e-2, both ends included
/// assert_eq!((bound.lowest.to_string(), bound.highest.to_string()), ("33/2000".into(), "7/400".into()));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Printed {
    /// As printed.
    pub text: String,
    /// The decimal itself.
    pub value: RBig,
    /// The value less half a unit of its last digit.
    pub lowest: RBig,
    /// The value plus half a unit of its last digit.
    pub highest: RBig,
}

impl Printed {
    /// Reads a decimal; `None` if it is none.
    pub fn parse(text: &str) -> Option<Self> {
        let (value, places) = decimal(text)?;
        let half = power_of_ten(-places) / RBig::int(2);
        Some(Printed {
            text: text.to_owned(),
            lowest: value.clone() - half.clone(),
            highest: value.clone() + half,
            value,
        })
    }
}
