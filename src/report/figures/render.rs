//! Figures as files.

use super::{Figure, FigureError};
use crate::report::chart::ChartError;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Pictures are large: each worker holds one of about 50 MB.
const WORKERS: usize = 2;

/// What a worker has drawn: indices into the pictures, with their bytes.
type Drawn = Vec<(usize, Result<Vec<u8>, ChartError>)>;

/// `<stem>.svg` and `<stem>.png` of every figure, with their bytes, in the figures' order.
///
/// # Errors
///
/// The first figure that cannot be drawn.
pub fn render(figures: &[Figure]) -> Result<Vec<(String, Vec<u8>)>, FigureError> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut drawn = Drawn::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(figure) = figures.get(i / 2) else { return drawn };
            drawn.push((i, picture(figure, i.is_multiple_of(2))));
        }
    };
    // Which worker draws what is left to chance; the bytes and their order are not.
    let mut drawn: Drawn = thread::scope(|scope| {
        let others: Vec<_> = (1..WORKERS).map(|_| scope.spawn(work)).collect();
        let mut all = work();
        for other in others {
            match other.join() {
                Ok(part) => all.extend(part),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    });
    drawn.sort_by_key(|&(i, _)| i);
    drawn
        .into_iter()
        .map(|(i, bytes)| {
            let stem = figures[i / 2].stem;
            let ending = if i.is_multiple_of(2) { "svg" } else { "png" };
            let bytes = bytes.map_err(|source| FigureError::Render { stem, source })?;
            Ok((format!("{stem}.{ending}"), bytes))
        })
        .collect()
}

fn picture(figure: &Figure, as_text: bool) -> Result<Vec<u8>, ChartError> {
    if as_text { figure.chart.svg().map(String::into_bytes) } else { figure.chart.png() }
}
