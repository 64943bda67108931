//! All tables of a run.

use super::{
    ClipError, FactorError, FootprintError, LobeRow, angles, clip_errors, exponents, factor_errors,
    footprint_errors, lobe_rows,
};

/// What rounding does to every kernel, sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// Lobes by exponent, which rises.
    pub lobes: Vec<LobeRow>,
    /// Factors by exponent.
    pub factors: Vec<FactorError>,
    /// Q by aspect and size.
    pub footprints: Vec<FootprintError>,
    /// Clip volumes by distance.
    pub clips: Vec<ClipError>,
}

impl Stability {
    /// Everything, the lobes at [`exponents`] and [`angles`]; two threads, whose number changes nothing. `None`
    /// if one of them stopped.
    pub fn run() -> Option<Self> {
        let grid = exponents();
        std::thread::scope(|scope| {
            let lobes = |part: &[f64]| -> Vec<LobeRow> {
                part.iter().flat_map(|n| lobe_rows(*n, &angles(*n))).collect()
            };
            let (low, high) = grid.split_at(grid.len() / 2);
            let low = scope.spawn(move || (lobes(low), factor_errors(&exponents()), clip_errors()));
            let (high, footprints) = (lobes(high), footprint_errors());
            let (mut all, factors, clips) = low.join().ok()?;
            all.extend(high);
            Some(Stability { lobes: all, factors, footprints, clips })
        })
    }
}
