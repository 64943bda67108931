//! Time a lookup.

use super::{SceneError, Technique, View};
use crate::filter::{Level, Lookup, Pixel};
use std::hint::black_box;
use std::time::Instant;

/// The time of a technique's lookups in one scene, on one thread.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// Its name.
    pub technique: String,
    /// Nanoseconds a lookup: the median over the rounds of the mean over the picture.
    pub nanoseconds: f64,
    /// The fastest round.
    pub least: f64,
    /// The slowest round.
    pub most: f64,
}

/// Measures lookups, all in one call, under every `stride`-th pixel of the plane, the techniques one after
/// the other in each of `rounds` rounds, so that a change of the machine's speed meets all of them.
///
/// # Errors
/// [`SceneError`] for a technique that the filters refuse.
pub fn time_lookups(
    view: &View,
    techniques: &[Technique],
    stride: usize,
    rounds: usize,
) -> Result<Vec<Timing>, SceneError> {
    let samplers = techniques.iter().map(|t| view.sampler(t)).collect::<Result<Vec<_>, _>>()?;
    let pixels: Vec<usize> = (0..view.on_plane().len()).filter(|&i| view.on_plane()[i]).collect();
    let pixels: Vec<usize> = pixels.into_iter().step_by(stride.max(1)).collect();
    let mut times = vec![Vec::with_capacity(rounds); techniques.len()];
    for _ in 0..rounds.max(1) {
        for ((technique, sampler), times) in techniques.iter().zip(&samplers).zip(&mut times) {
            let under = |&i: &usize| view.under(i % view.width(), i / view.width(), technique.diameter);
            let places: Vec<Pixel> = pixels.iter().map(under).collect();
            let mut found = vec![Lookup::default(); places.len()];
            let start = Instant::now();
            sampler.lookups(black_box(&places), Level::Auto, &mut found).expect("slices of one length");
            black_box(&found);
            times.push(start.elapsed().as_secs_f64() * 1e9 / places.len() as f64);
        }
    }
    let timing = |(technique, mut times): (&Technique, Vec<f64>)| {
        times.sort_by(f64::total_cmp);
        Timing {
            technique: technique.id.clone(),
            nanoseconds: times[times.len() / 2],
            least: times[0],
            most: times[times.len() - 1],
        }
    };
    Ok(techniques.iter().zip(times).map(timing).collect())
}
