//! Times, taken.

use super::accuracy::Accuracy;
use super::cosines::drawn;
use super::element::Element;
use super::path::Path;
use super::proven::{Proven, approximation, rounding};
use super::record::{Record, VERSION};
use super::row::{Floor, Row};
use super::{Machine, Place, Plan, Spread, Subject, TradeError};
use crate::bound::Format;
use crate::kernel::exact::Cost;
use std::hint::black_box;
use std::time::Instant;

/// Steps of the reference loop; each waits for the one before.
const STEPS: u32 = 1 << 17;

/// Measures every subject in both formats and all places, on the calling thread.
///
/// Warm-up first, in which each subject's number of passes a sample is found too; then in each round the
/// reference loop and one sample of everything after the other, every second round in reverse, so that a
/// change of the machine's speed meets all of them. `done` hears what is finished.
///
/// # Errors
/// [`TradeError::Exponent`] and [`TradeError::Plan`] for a plan outside its domain.
pub fn measure(plan: &Plan, done: &dyn Fn(&str)) -> Result<Record, TradeError> {
    plan.check()?;
    let (mut single, mut double) = (Bench::<f32>::new(plan), Bench::<f64>::new(plan));
    let accuracies = (single.accuracies(), double.accuracies());
    done("errors");
    let approximations: Vec<_> = Subject::all().map(|subject| approximation(subject, plan.n)).collect();
    done("proved bounds");
    single.warm_up();
    double.warm_up();
    done("warm-up");
    let mut reference = Vec::new();
    for round in 0..plan.rounds {
        reference.push(reference_loop());
        single.round(round % 2 == 1);
        double.round(round % 2 == 1);
    }
    reference.push(reference_loop());
    done("times");
    let (mut rows, mut floors) = (Vec::new(), Vec::new());
    single.report(&approximations, &accuracies.0, &mut rows, &mut floors);
    double.report(&approximations, &accuracies.1, &mut rows, &mut floors);
    Ok(Record {
        version: VERSION,
        machine: Machine::this(),
        n: plan.n,
        rounds: plan.rounds,
        elements: plan.elements,
        memory: plan.memory,
        reference: spread(&reference),
        floors,
        rows,
    })
}

/// Clocks give finite times, and at least one was taken.
fn spread(times: &[f64]) -> Spread {
    Spread::of(times).expect("one finite time at least").rounded()
}

/// Microseconds of [`STEPS`] multiplications and additions that wait for each other.
fn reference_loop() -> f64 {
    let (slope, offset) = (black_box(0.999), black_box(0.001));
    let start = Instant::now();
    let mut x = black_box(0.5);
    for _ in 0..STEPS {
        x = x * slope + offset;
    }
    black_box(x);
    start.elapsed().as_secs_f64() * 1e6
}

/// One subject in one place, with its times.
struct Entry<F> {
    /// `None`: the loop by itself.
    subject: Option<Subject>,
    path: Path<F>,
    place: Place,
    passes: usize,
    /// Nanoseconds an element, a round each.
    times: Vec<f64>,
}

/// Everything in one format.
struct Bench<F> {
    n: u32,
    sample: f64,
    entries: Vec<Entry<F>>,
    near: (Vec<F>, Vec<F>),
    far: (Vec<F>, Vec<F>),
    window: usize,
    /// Where the next window begins.
    next: usize,
}

impl<F: Element> Bench<F> {
    fn new(plan: &Plan) -> Self {
        let n = plan.n;
        let mut entries = Vec::new();
        for place in Place::ALL {
            let entry = |subject, path| Entry { subject, path, place, passes: 1, times: Vec::new() };
            entries.push(entry(None, Path::Copy));
            entries.extend(Subject::all().map(|subject| entry(Some(subject), Path::new(subject, n))));
        }
        let both = |count| (drawn(n, count), vec![F::ONE; count]);
        let (near, far) = (both(plan.elements), both(plan.memory / size_of::<F>()));
        Bench { n, sample: plan.sample, entries, near, far, window: plan.window, next: 0 }
    }

    /// By entry; what a slice gives does not depend on where it lies.
    fn accuracies(&self) -> Vec<Accuracy> {
        let mut found: Vec<Accuracy> = Vec::new();
        for (i, Entry { path, place, .. }) in self.entries.iter().enumerate() {
            found.push(match place {
                Place::Single => Accuracy::of(self.n, |x, out| path.single(self.n, x, out)),
                Place::Cache => Accuracy::of(self.n, |x, out| path.slice(self.n, x, out)),
                Place::Memory => found[i - self.entries.len() / Place::ALL.len()],
            });
        }
        found
    }

    /// Until a sample is as long as asked for.
    fn warm_up(&mut self) {
        for i in 0..self.entries.len() {
            // The slices in memory were written when they were made.
            while self.entries[i].place != Place::Memory {
                let elements = self.near.0.len() * self.entries[i].passes;
                let seconds = self.time(i) * 1e-9 * elements as f64;
                if seconds >= self.sample {
                    break;
                }
                self.entries[i].passes *= 2;
            }
        }
    }

    fn round(&mut self, reverse: bool) {
        let count = self.entries.len();
        for i in 0..count {
            let i = if reverse { count - 1 - i } else { i };
            let time = self.time(i);
            self.entries[i].times.push(time);
        }
    }

    /// Nanoseconds an element of one sample.
    fn time(&mut self, i: usize) -> f64 {
        let Entry { path, place, passes, .. } = &self.entries[i];
        if *place == Place::Memory && self.next + self.window > self.far.0.len() {
            self.next = 0;
        }
        let (x, out) = match place {
            Place::Memory => {
                let window = self.next..self.next + self.window;
                self.next += self.window;
                (&self.far.0[window.clone()], &mut self.far.1[window])
            }
            _ => (&self.near.0[..], &mut self.near.1[..]),
        };
        let elements = x.len() * passes;
        let start = Instant::now();
        for _ in 0..*passes {
            match place {
                Place::Single => path.single(self.n, black_box(x), black_box(&mut *out)),
                _ => path.slice(self.n, black_box(x), black_box(&mut *out)),
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        black_box(out);
        // A clock may stand still over a short pass; a time is above 0 all the same.
        seconds.max(1e-10) * 1e9 / elements as f64
    }

    fn report(
        &self,
        approximations: &[Option<f64>],
        accuracies: &[Accuracy],
        rows: &mut Vec<Row>,
        floors: &mut Vec<Floor>,
    ) {
        let format: Format = F::FORMAT;
        for (entry, accuracy) in self.entries.iter().zip(accuracies) {
            let (place, time) = (entry.place, spread(&entry.times));
            let Some(subject) = entry.subject else {
                floors.push(Floor { format, place, time });
                continue;
            };
            let cost: Cost = subject.cost(self.n);
            let known = Subject::all().position(|s| s == subject);
            let approximation = known.and_then(|i| approximations[i]);
            let proven = Proven { approximation, rounding: rounding(subject, self.n, format) };
            let Accuracy { sup: sup_error, at: sup_at, mean: mean_error } = *accuracy;
            rows.push(Row { subject, format, place, time, cost, sup_error, sup_at, mean_error, proven });
        }
    }
}
