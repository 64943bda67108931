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

/// An upper bound in the digits of [`short`], rounded up: what is printed bounds as well.
pub(super) fn short_up(x: f64) -> String {
    let size = x.abs();
    let is_plain = (1e-1..1e5).contains(&size);
    let unit = if is_plain { 1e-4 } else { libm::exp10(libm::floor(libm::log10(size)) - 4.0) };
    let bounds = |text: &String| text.parse::<f64>().is_ok_and(|read| read >= x);
    // Rounded to nearest it may have come down, by half a unit at most.
    let texts = [0.0, 0.5, 1.0].map(|up| short(x + up * unit));
    texts.into_iter().find(bounds).unwrap_or_else(|| x.to_string())
}

/// A lower bound, rounded down likewise.
pub(super) fn short_down(x: f64) -> String {
    let text = short_up(-x);
    match text.strip_prefix('-') {
        _ if x == 0.0 => text,
        Some(size) => size.to_owned(),
        None => format!("-{text}"),
    }
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
        assert_eq!((short_up(0.0), short_down(0.0)), ("0".into(), "0".into()));
        assert_eq!(enclosure(Interval::new(5.0, 6.25)), "5 to 6.25");
        assert_eq!(enclosure(Interval::new(4.70588235e-4, 4.70588236e-4)), "4.7059e-4");
    }

    #[test]
    fn printed_bounds_still_bound() {
        let mut x = 1e-12;
        while x < 1e8 {
            for x in [x, -x] {
                let [up, down]: [f64; 2] = [short_up(x), short_down(x)].map(|text| text.parse().unwrap());
                // Four decimals of 0.1 are coarsest, a thousandth on both sides together.
                assert!(down <= x && x <= up && up - down <= 1.01e-3 * x.abs(), "{x}: {down} to {up}");
            }
            x *= 1.0137;
        }
    }
}
