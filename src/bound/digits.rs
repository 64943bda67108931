//! Bounds and places in few digits for readers, rounded so that what is printed bounds as well; the files hold all
//! digits.

/// Whether [`short`] prints four decimals and no exponent.
fn is_plain(x: f64) -> bool {
    (1e-1..1e5).contains(&x.abs())
}

/// Five significant digits: 0.0170 as 1.7013e-2, 32.26 as 32.26.
pub(crate) fn short(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if is_plain(x) {
        let text = format!("{x:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{x:.4e}")
    }
}

/// A bound from above in the digits of [`short`], rounded up.
pub(crate) fn short_up(x: f64) -> String {
    outward(x, |read| read >= x)
}

/// A bound from below, rounded down.
pub(crate) fn short_down(x: f64) -> String {
    outward(x, |read| read <= x)
}

/// The first of the nearest decimal and its neighbours that `bounds`.
fn outward(x: f64, bounds: impl Fn(f64) -> bool) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let unit = if is_plain(x) { 1e-4 } else { libm::exp10(libm::floor(libm::log10(x.abs())) - 4.0) };
    // Rounded to nearest it is off by half a unit at most; 0.6 is past that, and no whole unit.
    let texts = [0.0, 0.6, -0.6].map(|step| short(x + step * unit));
    texts.into_iter().find(|text| text.parse().is_ok_and(&bounds)).unwrap_or_else(|| format!("{x:?}"))
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
        assert_eq!(
            (short_down(1.72768e-2), short_down(-4.774700628e-4)),
            ("1.7276e-2".into(), "-4.7748e-4".into())
        );
    }

    #[test]
    fn printed_bounds_still_bound() {
        let mut x = 1e-12;
        while x < 1e8 {
            for x in [x, -x] {
                let (up, down): (f64, f64) = (short_up(x).parse().unwrap(), short_down(x).parse().unwrap());
                // Four decimals of 0.1 are coarsest, a thousandth on both sides together.
                assert!(down <= x && x <= up && up - down <= 1.01e-3 * x.abs(), "{x}: {down} {up}");
                assert!(short_up(x).len() <= 11, "{x}: {}", short_up(x));
            }
            x *= 1.0137;
        }
    }

    /// A decimal of five digits is its own bound, and one step of the double past it the next.
    #[test]
    fn a_printed_number_stays_and_its_neighbour_moves() {
        for exponent in [-9, -3, -2, 7] {
            for digits in (10_000..100_000).step_by(97) {
                let text = format!("{}.{:04}e{exponent}", digits / 10_000, digits % 10_000);
                let x: f64 = text.parse().unwrap();
                assert_eq!((short_up(x), short_down(x)), (text.clone(), text.clone()));
                assert_ne!(short_up(x.next_up()), text);
                assert_ne!(short_down(x.next_down()), text);
            }
        }
    }
}
