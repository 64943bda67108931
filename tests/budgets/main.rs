//! Every public kernel has an error budget in one table, a formula in its documentation that an example evaluates, and
//! a row in the generated tables; and every budget holds, with no more room than [`MARGIN`].
//!
//! References are the formulas in double-double arithmetic at the arguments that the kernel was given, or tables from
//! mpmath (tests/references): nothing of the kernel's own.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "../support/draw.rs"]
mod draw;
mod exact;
mod lobes;
mod pixels;
#[path = "../support/references.rs"]
mod references;
mod seen;
mod sources;
mod table;
mod vectors;

use bellfit::kernel::real::Real;
use draw::Draw;
use seen::Seen;
use std::collections::BTreeSet;
use table::{BUDGETS, NO_NUMBER, Row};

/// A budget over this many times what is met is no budget but an excuse: tighten it.
const MARGIN: f64 = 16.0;
/// Arguments of each kernel in each type.
const DRAWS: usize = 6000;

/// A number of [lo, hi], rounded to the type.
pub fn pick<F: Real>(draw: &mut Draw, lo: f64, hi: f64) -> F {
    F::from_f64(draw.real(lo, hi))
}

/// The same, evenly in the logarithm; lo > 0.
pub fn pick_log<F: Real>(draw: &mut Draw, lo: f64, hi: f64) -> F {
    F::from_f64(libm::exp(draw.real(libm::log(lo), libm::log(hi))))
}

#[test]
fn every_budget_holds_and_none_is_an_excuse() {
    let mut wrong = Vec::new();
    for (i, budget) in BUDGETS.iter().enumerate() {
        for (type_name, new, most, evaluate) in [
            ("f32", Seen::new::<f32> as fn() -> Seen, budget.most[0], budget.evaluate[0]),
            ("f64", Seen::new::<f64>, budget.most[1], budget.evaluate[1]),
        ] {
            let (mut draw, mut seen) = (Draw(i as u64), new());
            for _ in 0..DRAWS {
                evaluate(&mut draw, &mut seen);
            }
            let of = format!("{} ({}) in {type_name}", budget.kernels.join(", "), budget.domain);
            let met = format!("{:.4} u of {} at {:?}", seen.error, budget.scale, seen.at);
            if seen.count < DRAWS / 50 {
                wrong.push(format!("{of}: {} values only", seen.count));
            }
            if seen.error > most {
                wrong.push(format!("{of}: {met}, over {most} ({})", budget.reason));
            }
            if seen.error * MARGIN < most {
                wrong.push(format!("{of}: {met}, and {most} allowed: more than {MARGIN} times as much"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_public_kernel_has_its_budget_formula_and_example() {
    let kernels = sources::kernels();
    assert!(kernels.len() > 100, "the walk found {}", kernels.len());
    let budgeted: BTreeSet<&str> = BUDGETS.iter().flat_map(|budget| budget.kernels).copied().collect();
    let numberless: BTreeSet<&str> = NO_NUMBER.iter().map(|(kernel, _)| *kernel).collect();
    let mut wrong = Vec::new();
    for kernel in &kernels {
        let name = kernel.name.as_str();
        match (budgeted.contains(name), numberless.contains(name)) {
            (false, false) => wrong.push(format!("{}: {name} has no budget", kernel.file)),
            (true, true) => wrong.push(format!("{name} is said to give no number, and has a budget")),
            (true, false) => {
                wrong.extend(kernel.undocumented().map(|what| format!("{}: {name} {what}", kernel.file)))
            }
            (false, true) => {}
        }
    }
    let known: BTreeSet<&str> = kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    assert_eq!(known.len(), kernels.len(), "names are unique");
    wrong.extend(
        budgeted.union(&numberless).filter(|name| !known.contains(*name)).map(|n| format!("no kernel {n}")),
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_kernel_has_its_row_in_a_generated_table_or_a_reason() {
    let path = |file: &str| format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    // What the tables name in their first columns.
    let mut named = BTreeSet::new();
    for entry in std::fs::read_dir(path("fits")).unwrap() {
        let file = entry.unwrap().path();
        if file.extension().is_some_and(|e| e == "csv") {
            let mut reader = csv::Reader::from_path(file).unwrap();
            named.extend(reader.records().map(|record| record.unwrap()[0].to_owned()));
        }
    }
    assert!(named.contains("clip-volume") && named.contains("cs-16"), "{named:?}");
    let mut wrong = Vec::new();
    for budget in BUDGETS {
        let kernels = budget.kernels.join(", ");
        match &budget.row {
            Row::In(file, wanted) => {
                let mut reader = csv::Reader::from_path(path(file)).unwrap();
                let header = reader.headers().unwrap().clone();
                let column = |name: &str| header.iter().position(|column| column == name);
                let places: Option<Vec<(usize, &str)>> =
                    wanted.iter().map(|(name, value)| Some((column(name)?, *value))).collect();
                let Some(places) = places else {
                    wrong.push(format!("{kernels}: {file} has no such columns: {wanted:?}"));
                    continue;
                };
                let is_row =
                    |record: csv::StringRecord| places.iter().all(|(i, value)| record.get(*i) == Some(value));
                if !reader.records().any(|record| is_row(record.unwrap())) {
                    wrong.push(format!("{kernels}: no row of {file} has {wanted:?}"));
                }
            }
            // The exception is needed no longer where a table has the kernel by its name.
            Row::Unlisted(reason) => {
                for kernel in budget.kernels {
                    let name = kernel.rsplit("::").next().unwrap().replace('_', "-");
                    if named.contains(&name) {
                        wrong.push(format!("{kernel} has rows {name}, and is excepted: {reason}"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn planted_gaps_are_seen() {
    let source = |doc: &str| format!("{doc}#[inline]\npub fn planted(x: f64) -> f64 {{\n    x\n}}\n");
    let gap = |doc: &str| sources::of_file("planted.rs", &source(doc))[0].undocumented();
    let whole = "/// f = 2 x.\n///\n/// ```\n/// assert_eq!(planted(1.0), 2.0);\n/// ```\n";
    assert_eq!(gap(whole), None);
    assert_eq!(gap(&whole.replace("f = 2 x", "Twice")), Some("states no formula"));
    assert_eq!(gap(&whole.replace("assert_eq!", "drop")), Some("has no example that evaluates it"));
    assert_eq!(gap(&whole.replace("planted(1.0)", "other(1.0)")), Some("has no example that evaluates it"));
    assert_eq!(gap("/// f = 2 x.\n"), Some("has no example that evaluates it"));
    let method = "impl<const K: u32, F: Real> Lobe<K, F> {\n    /// x.\n    pub const fn at(self) {}\n    pub(super) fn no() {}\n}\n";
    let names: Vec<String> =
        sources::of_file("planted.rs", method).into_iter().map(|kernel| kernel.name).collect();
    assert_eq!(names, ["Lobe::at"]);
    // A seen error counts in u, and nothing that is not finite passes.
    let mut seen = Seen::new::<f32>();
    seen.of(1.0 + f32::EPSILON, exact::number(1.0), 1.0, &[3.0]);
    assert_eq!((seen.error, &seen.at[..]), (2.0, &[3.0][..]));
    seen.of(f32::NAN, exact::number(1.0), 1.0, &[4.0]);
    assert_eq!(seen.error, f64::INFINITY);
}
