//! Every f32 argument of the kernels of one variable, against double-double: a billion each, so by name only.
//!
//!     cargo test --release --test stability_exhaustive -- --ignored
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/worst.rs"]
mod worst;

use worst::{Kernel, WORST, error, kernels};

/// The largest error over the floats with bits in the range, and the bits of the first such.
///
/// A double-double is asked only where the kernel in f64, whose distance from exact is below `slack`, allows
/// an error as large as the largest so far.
fn worst_in(kernel: &Kernel, bits: std::ops::RangeInclusive<u32>, start: f64) -> (f64, u32) {
    let mut largest = (start, u32::MAX);
    for bits in bits {
        let t = f32::from_bits(bits);
        let near = (f64::from((kernel.single)(t)) - (kernel.double)(f64::from(t))).abs();
        // A NaN passes, and fails below.
        if near + kernel.slack < largest.0 {
            continue;
        }
        let error = error(kernel, t);
        assert!(error.is_finite(), "{} at {t:e}", kernel.name);
        if error > largest.0 || (error == largest.0 && bits < largest.1) {
            largest = (error, bits);
        }
    }
    largest
}

#[test]
#[ignore = "exhausts 12 billion floats: under two minutes on two cores in a release build, by name"]
fn every_float_is_within_the_worst_case_kept() {
    let mut found = Vec::new();
    for kernel in &kernels() {
        let end = kernel.end.to_bits();
        // A coarse pass first, so that few floats of the fine one are near the largest.
        let start =
            (0..=end).step_by(9973).map(|bits| error(kernel, f32::from_bits(bits))).fold(0.0, f64::max);
        let threads = std::thread::available_parallelism().map_or(1, usize::from) as u32;
        // Interleaved pieces, as a kernel may be slower at one end.
        let pieces = 64;
        let size = end / pieces + 1;
        let parts: Vec<(f64, u32)> = std::thread::scope(|scope| {
            let run = |thread: u32| {
                scope.spawn(move || {
                    let mut largest = (start, u32::MAX);
                    for piece in (thread..pieces).step_by(threads as usize) {
                        let last = (piece * size + (size - 1)).min(end);
                        let part = worst_in(kernel, piece * size..=last, largest.0);
                        if part.1 != u32::MAX && (part.0 > largest.0 || part.1 < largest.1) {
                            largest = part;
                        }
                    }
                    largest
                })
            };
            let handles: Vec<_> = (0..threads).map(run).collect();
            handles.into_iter().map(|handle| handle.join().unwrap()).collect()
        });
        let largest =
            parts.into_iter().reduce(|a, b| if b.0 > a.0 || (b.0 == a.0 && b.1 < a.1) { b } else { a });
        let (error, bits) = largest.unwrap();
        println!("    (\"{}\", 0x{bits:08x}, {error:e}),", kernel.name);
        found.push((kernel.name, bits, error));
    }
    assert_eq!(found, WORST);
}
