//! The largest error of many, with its argument, held against what is allowed there.

use std::fmt::Debug;

/// Below the normal numbers WGSL may flush to zero.
const FLUSHED: f64 = 1.2e-38;

/// Results of one function.
pub struct Measure {
    name: String,
    /// Largest error, its argument.
    worst: (f64, String),
    /// Largest error as a share of what is allowed, its argument.
    share: (f64, String),
    count: usize,
}

impl Measure {
    pub fn new(name: impl Into<String>) -> Self {
        Measure { name: name.into(), worst: (0.0, "none".into()), share: (0.0, "none".into()), count: 0 }
    }

    /// One value against its reference.
    pub fn add(&mut self, argument: impl Debug, found: f32, reference: f64, allowed: f64) {
        let (error, allowed) = ((f64::from(found) - reference).abs(), allowed + FLUSHED);
        // A NaN is not within anything.
        let share = if error.is_nan() { f64::INFINITY } else { error / allowed };
        if share >= 1.0 {
            panic!("{} at {argument:?}: {found:e}, not {reference:e}; allowed {allowed:.3e}", self.name);
        }
        if error > self.worst.0 {
            self.worst = (error, format!("{argument:?}"));
        }
        if share > self.share.0 {
            self.share = (share, format!("{argument:?}"));
        }
        self.count += 1;
    }

    pub fn report(self) -> usize {
        let Measure { name, worst, share, count } = self;
        assert!(count > 1000, "{name}: {count} values are too few");
        println!(
            "{name}: {count} values, largest error {:.4e} at {}; {:.3} of what is allowed at {}",
            worst.0, worst.1, share.0, share.1
        );
        count
    }
}
