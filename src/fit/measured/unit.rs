//! What a column of angles holds, and the versine it stands for.

use crate::kernel::lobe::versine;
use core::f64::consts::PI;

/// The unit of a sample's angle θ from the lobe's axis.
///
/// Each lobe is a function of the versine w = 1 - cos θ: an angle gives it as 2 sin²(θ/2), which keeps its digits;
/// from a cosine it is the difference, whose rounding moves a lobe of exponent n by up to n 2⁻⁵³, and by far more
/// if the file has few decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// θ in degrees, -90 to 90.
    Degrees,
    /// θ in radians, -π/2 to π/2.
    Radians,
    /// cos θ, 0 to 1.
    Cosine,
    /// w = 1 - cos θ, 0 to 1.
    Versine,
}

/// The largest radians that are still π/2, printed with three decimals or more.
pub(super) const MOST_RADIANS: f64 = 1.571;
/// How far beyond its end a cosine may lie: what normalising two vectors in `f32` leaves.
const ROUNDED: f64 = 1e-6;

impl Unit {
    /// All four.
    pub const ALL: [Unit; 4] = [Unit::Degrees, Unit::Radians, Unit::Cosine, Unit::Versine];

    /// The name on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Unit::Degrees => "deg",
            Unit::Radians => "rad",
            Unit::Cosine => "cos",
            Unit::Versine => "one-minus-cos",
        }
    }

    /// The unit with this [`id`](Self::id); `None` if there is none.
    ///
    /// ```
    /// use bellfit::fit::measured::Unit;
    /// assert!(Unit::ALL.iter().all(|unit| Unit::from_id(unit.id()) == Some(*unit)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.id() == id)
    }

    /// The name of its column.
    pub const fn column(self) -> &'static str {
        match self {
            Unit::Degrees => "theta_deg",
            Unit::Radians => "theta_rad",
            Unit::Cosine => "cos_theta",
            Unit::Versine => "one_minus_cos",
        }
    }

    /// What its values may be, in words.
    pub const fn domain(self) -> &'static str {
        match self {
            Unit::Degrees => "degrees from -90 to 90",
            Unit::Radians => "radians from -π/2 to π/2",
            Unit::Cosine => "a cosine from 0 to 1",
            Unit::Versine => "1 - cos θ from 0 to 1",
        }
    }

    /// (w, |θ| in degrees) of a value; `None` outside the [domain](Self::domain).
    ///
    /// A scan across the peak has angles on both sides of it, and a lobe is even: the sign of θ does not count.
    /// Radians up to 1.571 count as π/2, cosines and versines up to 1e-6 beyond an end as that end.
    ///
    /// ```
    /// use bellfit::fit::measured::Unit;
    /// let (versine, degrees) = Unit::Cosine.read(0.5).unwrap();
    /// assert!(versine == 0.5 && (degrees - 60.0).abs() < 1e-13);
    /// assert_eq!(Unit::Degrees.read(-30.0), Unit::Degrees.read(30.0));
    /// assert_eq!(Unit::Degrees.read(90.5), None);
    /// ```
    pub fn read(self, value: f64) -> Option<(f64, f64)> {
        let of_angle = |theta: f64| versine(theta).min(1.0);
        let of_versine = |w: f64| {
            let w = w.clamp(0.0, 1.0);
            (w, 2.0 * libm::asin((0.5 * w).sqrt()) * (180.0 / PI))
        };
        let size = value.abs();
        match self {
            Unit::Degrees if size <= 90.0 => Some((of_angle(size * (PI / 180.0)), size)),
            Unit::Radians if size <= MOST_RADIANS => {
                let theta = size.min(PI / 2.0);
                Some((of_angle(theta), theta * (180.0 / PI)))
            }
            Unit::Cosine if (-ROUNDED..=1.0 + ROUNDED).contains(&value) => Some(of_versine(1.0 - value)),
            Unit::Versine if (-ROUNDED..=1.0 + ROUNDED).contains(&value) => Some(of_versine(value)),
            _ => None,
        }
    }

    /// What a value outside the domain may be instead.
    pub(super) fn hint(self, value: f64) -> &'static str {
        let size = value.abs();
        match self {
            Unit::Degrees if size <= 180.0 => "; behind the lobe nothing is fitted",
            Unit::Radians if size <= 90.0 => "; if these are degrees, name the column theta_deg",
            Unit::Cosine if (-1.0..0.0).contains(&value) => "; behind the lobe nothing is fitted",
            Unit::Cosine if size <= 90.0 => "; if these are angles, name the column theta_deg or theta_rad",
            Unit::Versine if size <= 2.0 => "; behind the lobe nothing is fitted",
            Unit::Versine if size <= 90.0 => "; if these are angles, name the column theta_deg or theta_rad",
            _ => "",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_angle_in_four_units() {
        for degrees in [0.0, 1e-3, 0.7, 30.0, 60.0, 89.0, 90.0_f64] {
            let theta = degrees * (PI / 180.0);
            let (w, _) = Unit::Degrees.read(degrees).unwrap();
            for (unit, value) in
                [(Unit::Radians, -theta), (Unit::Cosine, libm::cos(theta)), (Unit::Versine, w)]
            {
                let (other, back) = unit.read(value).unwrap();
                // The cosine is rounded to 2⁻⁵⁴ below 1, and the difference with it.
                assert!((other - w).abs() <= 1.2e-16 + 4e-16 * w, "{unit:?} {degrees}: {other} {w}");
                // Roundings of the inverse, and dθ = dw/sin θ of what the cosine's rounding is in w.
                let rounded =
                    if unit == Unit::Cosine && degrees > 0.0 { 1.2e-16 / libm::sin(theta) } else { 0.0 };
                let allowed = rounded * (180.0 / PI) + 1e-15 * degrees;
                assert!((back - degrees).abs() <= allowed, "{unit:?} {degrees}: {back}");
            }
        }
    }

    /// A hint is for what the value may be; what is nothing gets none.
    #[test]
    fn hints_end_where_they_make_no_sense() {
        for (unit, value, word) in [
            (Unit::Degrees, 120.0, "behind"),
            (Unit::Degrees, -180.0, "behind"),
            (Unit::Degrees, 181.0, ""),
            (Unit::Radians, 45.0, "theta_deg"),
            (Unit::Radians, 91.0, ""),
            (Unit::Cosine, -0.5, "behind"),
            (Unit::Cosine, 45.0, "theta_deg"),
            (Unit::Cosine, 91.0, ""),
            (Unit::Versine, 1.5, "behind"),
            (Unit::Versine, 45.0, "theta_deg"),
            (Unit::Versine, 91.0, ""),
        ] {
            let hint = unit.hint(value);
            assert!(
                if word.is_empty() { hint.is_empty() } else { hint.contains(word) },
                "{unit:?} {value}: {hint}"
            );
        }
    }

    #[test]
    fn ends_are_rounded_and_no_further() {
        assert_eq!(Unit::Radians.read(1.571).unwrap().1, 90.0);
        assert_eq!(Unit::Cosine.read(1.000_000_1), Some((0.0, 0.0)));
        for (unit, value) in
            [(Unit::Radians, 1.58), (Unit::Cosine, 1.001), (Unit::Cosine, -0.1), (Unit::Versine, 1.1)]
        {
            assert_eq!(unit.read(value), None, "{unit:?} {value}");
            assert!(!unit.hint(value).is_empty());
        }
        for unit in Unit::ALL {
            assert!(unit.read(f64::NAN).is_none() && unit.read(f64::INFINITY).is_none());
        }
    }
}
