//! What one Int(n) costs by each route: closed form, Gauss-Legendre, double exponential, and the
//! rigorous enclosure.
//!
//! `cargo bench --bench routes`. Every model, lobe and limit at a few exponents; the routes take turns
//! run by run, so that a slow spell of the machine falls on all of them, and the median run counts.
//! Gauss-Legendre's nodes are computed beforehand, as the table's 1009 exponents share them.
//! The columns `evaluations` and `widest` are the same on every machine, the times are not.

use bellfit::bound::integral_enclosure;
use bellfit::integral::{Case, GaussTable, Lobe, Routes, closed_form, double_exponential, gauss_legendre};
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 11;
const EXPONENTS: [f64; 4] = [16.0, 54.625, 128.0, 1024.0];
const ROUTES: [&str; 4] = ["closed form", "Gauss-Legendre", "double exponential", "enclosure"];

/// How often a route goes over all integrals in one run: each run then takes some milliseconds.
const REPEATS: [usize; 4] = [100, 20, 1, 20];

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    println!("ns per Int(n), median of {RUNS} interleaved runs, and times the closed form's\n");
    println!(
        "{:6} {:20} {:>12} {:>10} {:>12} {:>10}",
        "lobe", "route", "ns", "ratio", "evaluations", "widest"
    );
    for lobe in Lobe::ALL {
        let of_lobe = Case::all().filter(|case| case.lobe == lobe);
        let integrals: Vec<(Case, f64)> = of_lobe.flat_map(|case| EXPONENTS.map(|n| (case, n))).collect();
        let mut table = GaussTable::default();
        let (mut evaluations, mut widest) = (0, 0.0_f64);
        for &(case, n) in &integrals {
            let routes = Routes::evaluate(case, n, &mut table);
            if let Err(error) = routes.agree(case, n) {
                println!("{error}");
                std::process::exit(1);
            }
            evaluations += routes.exponential.evaluations;
            let enclosure = integral_enclosure(case, n);
            widest = widest.max(enclosure.width() / enclosure.lo());
        }
        let mut times: [Vec<f64>; 4] = Default::default();
        for run in 0..=RUNS {
            for (route, times) in times.iter_mut().enumerate() {
                let start = Instant::now();
                for _ in 0..REPEATS[route] {
                    for &(case, n) in &integrals {
                        let (case, n) = black_box((case, n));
                        black_box(match route {
                            0 => closed_form(case, n),
                            1 => gauss_legendre(case, n, &mut table),
                            2 => double_exponential(case, n).value,
                            _ => integral_enclosure(case, n).hi(),
                        });
                    }
                }
                let taken = start.elapsed().as_nanos() as f64;
                if run > 0 {
                    // The first run warms up.
                    times.push(taken / (REPEATS[route] * integrals.len()) as f64);
                }
            }
        }
        let medians = times.map(median);
        for (route, name) in ROUTES.iter().enumerate() {
            let evaluations = match route {
                2 => format!("{:.0}", f64::from(evaluations) / integrals.len() as f64),
                _ => String::new(),
            };
            let widest = if route == 3 { format!("{widest:.1e}") } else { String::new() };
            let (ns, ratio) = (medians[route], medians[route] / medians[0]);
            println!("{:6} {name:20} {ns:12.1} {ratio:10.1} {evaluations:>12} {widest:>10}", lobe.id());
        }
    }
    println!(
        "\nevaluations: of the integrand, mean a double exponential quadrature; widest: an enclosure's width, relative"
    );
}
