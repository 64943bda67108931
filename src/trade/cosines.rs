//! The arguments that are timed.

use super::element::Element;

/// The end of what is drawn, in t = n (1 - cos θ): twice the cut of cs_16, and cosⁿ ≤ e⁻³².
pub const REACH: f64 = 32.0;

/// Any number; the same draws on every run.
const SEED: u64 = 0x7261_6465;

/// The last t that is drawn for n: where the hemisphere ends, if that is sooner.
pub(super) fn reach(n: u32) -> f64 {
    REACH.min(f64::from(n))
}

/// cos θ at t, rounded to the format.
pub(super) fn at<F: Element>(n: u32, t: f64) -> F {
    F::from_f64(1.0 - t / f64::from(n))
}

/// Cosines with t = n (1 - cos θ) uniform in [0, min([`REACH`], n)), at a fixed seed: for n ≥ 32 half of them
/// beyond the cut of cs_16, and none so far that cosⁿ underflows, which would slow some powers down.
pub(super) fn drawn<F: Element>(n: u32, count: usize) -> Vec<F> {
    let mut state = SEED;
    let mut next = || {
        // splitmix64: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    let mut unit = || (next() >> 11) as f64 / (1_u64 << 53) as f64;
    (0..count).map(|_| at(n, reach(n) * unit())).collect()
}
