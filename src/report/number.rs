//! How numbers are written in text: few digits for readers; the files hold all of them.

use crate::bound::Interval;

/// Five significant digits: 0.0170 as 1.7013e-2, 32.26 as 32.26.
pub(super) fn short(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-1..1e5).contains(&size) {
        let text = format!("{x:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{x:.4e}")
    }
}

/// A positive bound in five significant digits, rounded up: what is printed bounds as well.
pub(super) fn short_up(x: f64) -> String {
    let unit = libm::exp10(libm::floor(libm::log10(x)) - 4.0);
    let text = short(x);
    // Rounded to nearest it may have come down, by half a unit at most.
    if text.parse::<f64>().is_ok_and(|read| read >= x) { text } else { short(x + 0.5 * unit) }
}

/// An enclosure in few digits: one number if both ends read the same, else both.
pub(super) fn enclosure(value: Interval) -> String {
    let (lo, hi) = (short(value.lo()), short(value.hi()));
    if lo == hi { lo } else { format!("{lo} to {hi}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_get_five_digits() {
        assert_eq!(short(0.01701256), "1.7013e-2");
        assert_eq!(short(-32.26), "-32.26");
        assert_eq!(short(1024.0), "1024");
        assert_eq!((short_up(4.774700628e-4), short_up(4.7747e-4)), ("4.7748e-4".into(), "4.7747e-4".into()));
        assert_eq!(short_up(1.72768e-2), "1.7277e-2");
        assert_eq!(enclosure(Interval::new(5.0, 6.25)), "5 to 6.25");
        assert_eq!(enclosure(Interval::new(4.70588235e-4, 4.70588236e-4)), "4.7059e-4");
    }
}
