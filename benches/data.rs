//! What a fit of lobes to measured samples takes, from the file's bytes to the comparison.
//!
//! `cargo bench --bench data`. 10 000 samples of 0.8 cos⁶⁰θ with Gaussian noise of 0.01, at even angles up to 40°, in
//! degrees with six decimals; reading, each family alone, and all of them with the reading. One thread; the rows take
//! turns run by run, and the median run counts. The columns `n` and `from` to `to` are the same on every machine, the
//! times are not.

#[path = "../tests/support/draw.rs"]
mod draw;

use bellfit::fit::measured::{Comparison, DataError, Family, Samples};
use draw::Draw;
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 11;
const COUNT: usize = 10_000;

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The file.
fn csv() -> String {
    let mut draw = Draw(60);
    let mut text = "theta_deg,value\n".to_owned();
    for i in 0..COUNT {
        let degrees = 40.0 * i as f64 / (COUNT - 1) as f64;
        let (u, v) = (draw.real(0.0, 1.0), draw.real(0.0, 1.0));
        let noise = (-2.0 * libm::log(1.0 - u)).sqrt() * libm::cos(core::f64::consts::TAU * v);
        let value = 0.8 * libm::pow(libm::cos(degrees.to_radians()), 60.0) + 0.01 * noise;
        text.push_str(&format!("{degrees:.6},{value:.6}\n"));
    }
    text
}

fn main() -> Result<(), DataError> {
    let text = csv();
    let samples = Samples::parse(text.as_bytes(), None)?;
    println!("ms for {COUNT} samples, median of {RUNS} interleaved runs\n");
    println!("{:28} {:>9} {:>12} {:>12} {:>12}", "", "ms", "n", "from", "to");
    // Reading, all with reading, then the families.
    let mut times = vec![Vec::new(); 2 + Family::ALL.len()];
    for run in 0..=RUNS {
        for (row, times) in times.iter_mut().enumerate() {
            let start = Instant::now();
            match row {
                0 => drop(black_box(Samples::parse(black_box(text.as_bytes()), None)?)),
                1 => {
                    let read = Samples::parse(black_box(text.as_bytes()), None)?;
                    drop(black_box(Comparison::of(&read, &Family::ALL)?));
                }
                _ => drop(black_box(Comparison::of(black_box(&samples), &[Family::ALL[row - 2]])?)),
            }
            // The first run warms up.
            if run > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let mut medians = times.into_iter().map(median);
    for name in ["reading", "reading and all families"] {
        println!("{name:28} {:9.2}", medians.next().unwrap_or(f64::NAN));
    }
    for (family, ms) in Family::ALL.into_iter().zip(medians) {
        let found = Comparison::of(&samples, &[family])?;
        let (lo, hi) = found.best().n_interval().unwrap_or((f64::NAN, f64::NAN));
        println!("{:28} {ms:9.2} {:12.4} {lo:12.4} {hi:12.4}", family.id(), found.best().n);
    }
    Ok(())
}
