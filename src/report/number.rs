//! How numbers are written in the report's text: few digits for readers; the files hold all of them.

pub(super) use crate::bound::{short, short_down, short_up};

use crate::bound::Interval;

/// An enclosure in few digits: one number if both ends read the same, else both.
pub(super) fn enclosure(value: Interval) -> String {
    let (lo, hi) = (short(value.lo()), short(value.hi()));
    if lo == hi { lo } else { format!("{lo} to {hi}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_that_read_the_same_are_one_number() {
        assert_eq!(enclosure(Interval::new(5.0, 6.25)), "5 to 6.25");
        assert_eq!(enclosure(Interval::new(4.70588235e-4, 4.70588236e-4)), "4.7059e-4");
    }
}
