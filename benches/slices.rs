//! What the kernels over slices cost, in cache, on one core.
//!
//! `cargo bench --bench slices`. The routes take turns run by run, and the median run counts; the spread
//! beside it is half of what lies between the quartiles, as a share of the median. The arithmetic peak is that
//! of this machine in the same runs: independent chains of fused multiply-adds (a multiply and an add where
//! the unit fuses nothing), in registers, the best of three counts. A kernel's share of it counts six
//! operations an element; it can exceed 1, as a maximum and an add may run beside the multiplications.
//!
//! Errors are the largest in units in the last place over the rows of tests/references/slices.csv whose arguments
//! are cosines and normal numbers, as their results are, for powers alone: not every power that is measured here takes
//! subnormal numbers. For a stand-in the distance from cosⁿ is its own matter (`bellfit::kernel::cubic`).

#[path = "../tests/support/draw.rs"]
mod draw;
#[path = "../tests/support/ulp.rs"]
mod ulp;

use bellfit::kernel::pixel::PixelWeight;
use bellfit::kernel::stand_in::{Argument, StandIn};
use bellfit::slice::{Bell, Exponents, Float, Job, Unit, bell, lobe, lobe_in_place, lobe_sum, weight};
use draw::Draw;
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 15;
/// In the second cache with the results, and so many that what a call computes once does not show.
const BYTES: usize = 65536;
const N: f64 = 64.0;

/// Chains, one a lane, each step one fused multiply-add or a multiply and an add. So many as the compiler
/// unrolls wholly and keeps in registers.
struct Chains<F, const LANES: usize> {
    steps: usize,
    fused: bool,
    factor: F,
}

macro_rules! chains {
    ($float:ident) => {
        impl<const LANES: usize> Job for Chains<$float, LANES> {
            type Output = $float;

            #[inline(always)]
            fn run(self) -> $float {
                let mut lanes = [1.0 as $float; LANES];
                let (a, b) = (self.factor, 1e-9 as $float);
                if self.fused {
                    for _ in 0..self.steps {
                        for lane in &mut lanes {
                            *lane = lane.mul_add(a, b);
                        }
                    }
                } else {
                    for _ in 0..self.steps {
                        for lane in &mut lanes {
                            *lane = *lane * a + b;
                        }
                    }
                }
                lanes.iter().sum()
            }
        }
    };
}

chains!(f32);
chains!(f64);

/// The power of `wide`, whose functions are compiled for the unit with the loop around them.
struct Wide<'a, F>(&'a [F], F, &'a mut [F]);

macro_rules! wide {
    ($float:ident, $vector:ident, $lanes:literal) => {
        impl Job for Wide<'_, $float> {
            type Output = ();

            #[inline(always)]
            fn run(self) {
                for (x, out) in self.0.chunks_exact($lanes).zip(self.2.chunks_exact_mut($lanes)) {
                    let x: [$float; $lanes] = x.try_into().expect("a chunk");
                    out.copy_from_slice(
                        &wide::$vector::new(x).powf_simd(wide::$vector::splat(self.1)).to_array(),
                    );
                }
            }
        }
    };
}

wide!(f32, f32x8, 8);
wide!(f64, f64x4, 4);

/// What only one type can say of itself.
trait Element: Float + Into<f64> {
    const NAME: &'static str;
    const WIDTH: u32;
    /// The least normal number.
    const LEAST: f64;

    fn std_power(self, n: Self) -> Self;
    fn wide(unit: Unit, x: &[Self], n: Self, out: &mut [Self]);
    /// Seconds and operations of chains that long, for each of three counts of them.
    fn chains(unit: Unit, steps: usize) -> [(f64, f64); 3];
}

fn timed<J: Job>(unit: Unit, job: J, operations: usize) -> (f64, f64)
where
    J::Output: std::fmt::Debug,
{
    let start = Instant::now();
    black_box(unit.run(job));
    (start.elapsed().as_secs_f64(), operations as f64)
}

macro_rules! element {
    ($float:ident, $width:literal) => {
        impl Element for $float {
            const NAME: &'static str = stringify!($float);
            const WIDTH: u32 = $width;
            const LEAST: f64 = $float::MIN_POSITIVE as f64;

            #[allow(clippy::disallowed_methods)] // the platform's own, to measure beside
            fn std_power(self, n: Self) -> Self {
                self.powf(n)
            }

            fn wide(unit: Unit, x: &[Self], n: Self, out: &mut [Self]) {
                unit.run(Wide(x, n, out));
            }

            fn chains(unit: Unit, steps: usize) -> [(f64, f64); 3] {
                const BASE: usize = 512 / $width;
                let (fused, factor) = (unit != Unit::plain(), black_box(0.999));
                let each = if fused { 1 } else { 2 };
                let count = |lanes: usize| steps * lanes * each;
                [
                    timed(unit, Chains::<$float, { BASE * 2 }> { steps, fused, factor }, count(BASE * 2)),
                    timed(unit, Chains::<$float, { BASE * 4 }> { steps, fused, factor }, count(BASE * 4)),
                    timed(unit, Chains::<$float, { BASE * 6 }> { steps, fused, factor }, count(BASE * 6)),
                ]
            }
        }
    };
}

element!(f32, 32);
element!(f64, 64);

/// Median, and half the distance of the quartiles by it.
fn summary(mut times: Vec<f64>) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    let (n, median) = (times.len(), times[times.len() / 2]);
    (median, (times[n * 3 / 4] - times[n / 4]) / 2.0 / median)
}

/// Over arguments, out of place: cosines for lobes, anything in [0, 1] for the rest.
type Route<F> = Box<dyn Fn(&[F], &[F], &mut [F])>;

struct Row<F> {
    name: String,
    /// Operations, where the share of the peak means something.
    operations: Option<f64>,
    /// Whether it is a vectorised power that the stand-ins are measured against.
    power: bool,
    route: Route<F>,
}

fn row<F>(name: &str, operations: Option<f64>, route: impl Fn(&[F], &[F], &mut [F]) + 'static) -> Row<F> {
    Row { name: name.to_owned(), operations, power: false, route: Box::new(route) }
}

fn rows<F: Element>() -> Vec<Row<F>> {
    let n = F::from_f64(N);
    let same = "slices of one length";
    let stand_in = move |name: &str, operations, of: StandIn, argument: Argument| {
        row(name, operations, move |x, _, out: &mut [F]| {
            lobe(of, argument, Exponents::One(n), x, out).expect(same);
        })
    };
    let power = |row: Row<F>| Row { power: true, ..row };
    let (cosine, versine) = (Argument::Cosine, Argument::Versine);
    vec![
        row("std powf", None, move |x, _, out: &mut [F]| {
            for (x, out) in x.iter().zip(out) {
                *out = x.std_power(n);
            }
        }),
        power(row("wide powf", None, move |x, _, out: &mut [F]| F::wide(Unit::best(), x, n, out))),
        power(row("wide powf, plain unit", None, move |x, _, out: &mut [F]| {
            F::wide(Unit::plain(), x, n, out)
        })),
        power(stand_in("pow", None, StandIn::Power, cosine)),
        power(stand_in("exp2-log2", None, StandIn::Exp2Log2, cosine)),
        stand_in("pow, versine", None, StandIn::Power, versine),
        stand_in("squarings", None, StandIn::Squarings, cosine),
        stand_in("cs-16", Some(6.0), StandIn::Cs16, cosine),
        stand_in("linear-16", Some(6.0), StandIn::Linear16, cosine),
        stand_in("cubic-4", Some(6.0), StandIn::Cubic4, cosine),
        stand_in("cubic-4, versine", Some(6.0), StandIn::Cubic4, versine),
        row("cubic-4, in place", Some(6.0), move |x, _, out: &mut [F]| {
            // From 1 down to what is left after a few times: the time does not depend on the values.
            out[0] = x[0];
            lobe_in_place(StandIn::Cubic4, cosine, Exponents::One(n), out).expect(same);
        }),
        row("cubic-4, weighted sum", None, move |x, w, out: &mut [F]| {
            out[0] = lobe_sum(StandIn::Cubic4, cosine, Exponents::One(n), x, w).expect(same);
        }),
        stand_in("cubic-8", Some(8.0), StandIn::Cubic8, cosine),
        stand_in("schlick", None, StandIn::Schlick, cosine),
        stand_in("spherical-gaussian", None, StandIn::SphericalGaussian, cosine),
        row("cubic-4, n an element", None, move |x, w, out: &mut [F]| {
            lobe(StandIn::Cubic4, cosine, Exponents::Each(w), x, out).expect(same);
        }),
        row("pow, n an element", None, move |x, w, out: &mut [F]| {
            lobe(StandIn::Power, cosine, Exponents::Each(w), x, out).expect(same);
        }),
        row("bell K = 16", Some(6.0), |x, _, out: &mut [F]| bell(Bell::Lyon(16), x, out).expect(same)),
        row("cubic bell K = 4", Some(6.0), |x, _, out: &mut [F]| bell(Bell::Cubic(4), x, out).expect(same)),
        row("exponential", None, |x, _, out: &mut [F]| bell(Bell::Exponential, x, out).expect(same)),
        row("weight, cubic K = 4", Some(6.0), |x, _, out: &mut [F]| {
            weight(PixelWeight::Cubic(4, F::from_f64(1.0 / 3.0)), x, out).expect(same);
        }),
    ]
}

/// Largest error in ulp against the references, of a power with n.
fn error<F: Element>(route: impl Fn(&[F], F, &mut [F])) -> f64 {
    let references = ulp::references().into_iter().filter(|r| r.width == F::WIDTH && r.function == "cosine");
    let errors = references.filter(|r| r.x >= F::LEAST && r.is_normal()).map(|r| {
        let (x, mut out) = (vec![F::from_f64(r.x); 16], vec![F::ZERO; 16]);
        route(&x, F::from_f64(r.n), &mut out);
        r.ulps(out[0].to_f64())
    });
    errors.fold(0.0, f64::max)
}

fn table<F: Element>() {
    let mut draw = Draw(5);
    let count = BYTES / size_of::<F>();
    let x: Vec<F> = (0..count).map(|_| F::from_f64(draw.real(0.0, 1.0))).collect();
    let beside: Vec<F> = (0..count).map(|_| F::from_f64(draw.real(16.0, 512.0))).collect();
    let mut out = vec![F::ZERO; count];
    let rows = rows::<F>();
    let mut times = vec![vec![]; rows.len()];
    let mut peaks = vec![vec![]; 3];
    // The first run warms up and says how often each must be repeated for a twentieth of a millisecond or more.
    let mut repeats = vec![1; rows.len()];
    for run in 0..=RUNS {
        for (i, row) in rows.iter().enumerate() {
            let start = Instant::now();
            for _ in 0..repeats[i] {
                (row.route)(black_box(&x), black_box(&beside), &mut out);
                black_box(&mut out);
            }
            let ns = start.elapsed().as_nanos() as f64 / (repeats[i] * count) as f64;
            if run == 0 {
                repeats[i] = (1e5 / (ns * count as f64)).ceil().max(1.0) as usize;
            } else {
                times[i].push(ns);
            }
        }
        for (peak, (seconds, operations)) in peaks.iter_mut().zip(F::chains(Unit::best(), 10_000)) {
            if run > 0 {
                peak.push(seconds * 1e9 / operations);
            }
        }
    }
    let peak = peaks.into_iter().map(|times| summary(times).0).fold(f64::INFINITY, f64::min);
    println!("\n{}: peak {:.1} G lane operations a second", F::NAME, 1.0 / peak);
    let times: Vec<(f64, f64)> = times.into_iter().map(summary).collect();
    let fastest = rows.iter().zip(&times).filter(|(row, _)| row.power).map(|(_, t)| t.0);
    let (std, fastest) = (times[0].0, fastest.fold(f64::INFINITY, f64::min));
    println!("{:24} {:>8} {:>7} {:>7} {:>8} {:>9}", "", "ns", "spread", "peak", "std powf", "vec. pow");
    for (row, (ns, spread)) in rows.iter().zip(&times) {
        let share = row.operations.map_or(String::new(), |k| format!("{:.0} %", 100.0 * k * peak / ns));
        let (name, spread) = (&row.name, 100.0 * spread);
        println!("{name:24} {ns:8.4} {spread:5.1} % {share:>7} {:8.1} {:9.2}", std / ns, fastest / ns);
    }
    println!("largest error in ulp:");
    let ours = |of| {
        move |x: &[F], n, out: &mut [F]| {
            lobe(of, Argument::Cosine, Exponents::One(n), x, out).expect("slices of one length");
        }
    };
    println!("  std powf {:.3}", error(|x: &[F], n, out| out[0] = x[0].std_power(n)));
    println!("  wide powf {:.3e}", error(|x: &[F], n, out| F::wide(Unit::best(), x, n, out)));
    println!("  pow {:.3}", error(ours(StandIn::Power)));
    println!("  exp2-log2 {:.3e}", error(ours(StandIn::Exp2Log2)));
}

/// A slice of one against the scalar call.
fn single<F: Element>() {
    let of = [StandIn::Cs16, StandIn::Linear16, StandIn::Cubic4, StandIn::Power];
    let mut times = vec![[vec![], vec![]]; of.len()];
    const CALLS: usize = 20_000;
    for _ in 0..=RUNS {
        for (of, times) in of.iter().zip(&mut times) {
            let (x, n) = (F::from_f64(0.9), F::from_f64(N));
            let start = Instant::now();
            for _ in 0..CALLS {
                black_box(black_box(*of).at(black_box(x), black_box(n)));
            }
            times[0].push(start.elapsed().as_nanos() as f64 / CALLS as f64);
            let (x, mut out) = ([x], [F::ZERO]);
            let start = Instant::now();
            for _ in 0..CALLS {
                let n = Exponents::One(black_box(n));
                lobe(black_box(*of), Argument::Cosine, n, black_box(&x), &mut out).expect("one and one");
                black_box(&mut out);
            }
            times[1].push(start.elapsed().as_nanos() as f64 / CALLS as f64);
        }
    }
    println!("\n{}: ns of the scalar call, and of a slice of one", F::NAME);
    for (of, [scalar, slice]) in of.iter().zip(times) {
        println!("{:24} {:8.2} {:8.2}", of.id(), summary(scalar).0, summary(slice).0);
    }
}

fn main() {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpu.lines().find_map(|line| line.strip_prefix("model name")).unwrap_or("unknown");
    println!("processor {}, unit {}", model.trim_matches([' ', '\t', ':']), Unit::best().id());
    println!(
        "ns an element, median of {RUNS} interleaved runs over {BYTES} bytes, n = {N}; share of the peak;\n\
         times the speed of std's powf and of the fastest vectorised power"
    );
    table::<f32>();
    table::<f64>();
    single::<f32>();
    single::<f64>();
}
