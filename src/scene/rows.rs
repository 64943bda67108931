//! Rows on threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// `row(y)` for every y below `height`, in order, computed on so many threads (at least one). Which thread
/// computes which row is left to chance; no row sees another.
pub(super) fn rows<T: Send>(height: usize, threads: usize, row: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let y = next.fetch_add(1, Ordering::Relaxed);
            if y >= height {
                return done;
            }
            done.push((y, row(y)));
        }
    };
    let mut all = thread::scope(|scope| {
        let others: Vec<_> = (1..threads.min(height)).map(|_| scope.spawn(work)).collect();
        let mut all = work();
        for other in others {
            match other.join() {
                Ok(part) => all.extend(part),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    });
    all.sort_by_key(|&(y, _)| y);
    all.into_iter().map(|(_, row)| row).collect()
}
