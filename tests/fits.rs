//! Fits against 20-digit references, and against what makes them optimal.
//!
//! Where a check needs Int(n) it takes Gauss-Legendre in cos θ, a route that the fits (on enclosures
//! of the closed form) share no code with; it is good to 1e-12 relative, and as 2π coef Int is near 1
//! that is also what it leaves uncertain in a residual.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::bound::power_of_ten;
use bellfit::fit::{
    Form, Objective, Problem, certified_least_squares, fit_case, least_squares, minimax, scaled_integrals,
    simplex_search,
};
use bellfit::integral::{AGREEMENT, Case, Field, GaussTable, Limit, Lobe, gauss_legendre};
use bellfit::kernel::model::Model;
use dashu_ratio::RBig;
use draw::Draw;
use references::{Reference, rows};

const E: f64 = f64::EPSILON;

struct Row {
    problem: Problem,
    objective: Objective,
    form: Form,
    a: Reference,
    b: Option<Reference>,
}

impl Row {
    fn name(&self) -> String {
        format!("{}, {}, {}", self.problem.case, self.objective.id(), self.form.id())
    }

    fn b_or_zero(&self) -> Reference {
        self.b.clone().unwrap_or_else(|| Reference::parse("0").unwrap())
    }
}

fn fits() -> Vec<Row> {
    let read = |[model, limit, objective, form, a, b]: [String; 6]| {
        let (model, limit) = (Model::from_id(&model).unwrap(), Limit::from_id(&limit).unwrap());
        let case = Case { model, lobe: Lobe::Cs16, limit };
        Row {
            problem: Problem::new(case, 16, 1024).unwrap(),
            objective: Objective::from_id(&objective).unwrap(),
            form: Form::from_id(&form).unwrap(),
            a: Reference::parse(&a).unwrap(),
            b: Reference::parse(&b),
        }
    };
    let table: Vec<Row> = rows("fits.csv").into_iter().map(read).collect();
    assert_eq!(table.len(), 80);
    table
}

/// coef(n) = (a n + b)/(divisor π) against Int by Gauss-Legendre.
fn residual(problem: &Problem, (a, b): (f64, f64), n: f64, table: &mut GaussTable) -> f64 {
    let int = gauss_legendre(problem.case, n, table);
    (a * n + b) * 2.0 * int / f64::from(problem.divisor) - 1.0
}

/// What the double-precision fits may lose in a, relative: each of the 1009 values of Int and each
/// step of a sum over them rounds once.
const A: f64 = 1009.0 * E;
/// And in b: the line stays where the data are, so a slope wrong by δ moves its value at 0 by no more
/// than δ times the largest n.
const B: f64 = 1024.0 * A;

fn assert_near(row: &Row, (a, b): (f64, f64), (in_a, in_b): (f64, f64)) {
    let name = row.name();
    assert!(row.a.is_near(a, in_a), "{name}: a = {a}, not {:?}", row.a);
    let distance = row.b_or_zero().distance(b).to_f64().value();
    assert!(distance <= in_b, "{name}: b = {b}, not {:?}", row.b);
}

#[test]
fn least_squares_meets_the_references() {
    for row in fits().into_iter().filter(|row| row.objective != Objective::Minimax) {
        let found = least_squares(&row.problem, row.objective, row.form).unwrap();
        assert_near(&row, found, (A, B));
        if row.form == Form::Proportional {
            assert_eq!(found.1, 0.0);
        }
    }
}

#[test]
fn the_exchange_meets_the_references() {
    for row in fits().into_iter().filter(|row| row.objective == Objective::Minimax) {
        let best = minimax(&row.problem, row.form).unwrap();
        assert_near(&row, (best.a, best.b), (A, B));
    }
}

#[test]
fn the_simplex_search_meets_the_references() {
    let linear = |row: &Row| row.objective != Objective::Minimax && row.form == Form::Linear;
    for row in fits().into_iter().filter(linear) {
        let found = simplex_search(&row.problem, row.objective).unwrap();
        // A sum of squares is flat to rounding within √ε = 1.5e-8 of its minimum, along its weakest
        // direction more; 1e-6 is what a fit tolerates between its methods.
        let size = row.b_or_zero().to_f64().abs().max(1.0);
        assert_near(&row, found, (1e-6, 1e-6 * size));
    }
}

#[test]
fn certified_solutions_contain_the_references() {
    // 2^-128 = 3e-39, through sums over 1009 n and a division: to all 20 digits of the references.
    let widest = power_of_ten(-30);
    for row in fits().into_iter().filter(|row| row.objective != Objective::Minimax) {
        let found =
            certified_least_squares(&row.problem, &scaled_integrals(&row.problem), row.objective, row.form)
                .unwrap();
        let (name, b) = (row.name(), row.b_or_zero());
        assert!(row.a.is_within(&found.a.0, &found.a.1), "{name}: {:?}, not {:?}", found.a, row.a);
        assert!(b.is_within(&found.b.0, &found.b.1), "{name}: {:?}, not {b:?}", found.b);
        for (lo, hi) in [found.a, found.b] {
            assert!(RBig::int(0) <= hi.clone() - lo.clone() && hi - lo <= widest, "{name}");
        }
    }
}

/// By Chebyshev's theorem a line is the best if and only if its residual reaches its largest size with
/// alternating signs once more often than it has unknowns.
#[test]
fn minimax_residuals_equioscillate() {
    let mut table = GaussTable::default();
    for model in Model::ALL {
        for limit in Limit::ALL {
            let case = Case { model, lobe: Lobe::Cs16, limit };
            let problem = Problem::new(case, 16, 1024).unwrap();
            for (form, unknowns) in [(Form::Linear, 2), (Form::Proportional, 1)] {
                let best = minimax(&problem, form).unwrap();
                let name = format!("{case}, {}", form.id());
                let mut at = |n: f64| residual(&problem, (best.a, best.b), n, &mut table);
                let worst = (16..=1024).map(|n| at(f64::from(n)).abs()).fold(0.0, f64::max);
                assert!((worst - best.level).abs() <= AGREEMENT, "{name}: {worst:e}, {:e}", best.level);
                if best.alternation.is_empty() {
                    // The line is Int itself: nothing is left to alternate.
                    assert!(worst <= AGREEMENT, "{name}: {worst:e}");
                    continue;
                }
                assert!(worst > 1e3 * AGREEMENT, "{name}: a level above the routes' own differences");
                assert_eq!(best.alternation.len(), unknowns + 1, "{name}");
                let heights: Vec<f64> = best.alternation.iter().map(|&n| at(n)).collect();
                for (n, height) in best.alternation.iter().zip(&heights) {
                    assert!((16.0..=1024.0).contains(n) && *n == libm::floor(*n), "{name}: n = {n}");
                    assert!((height.abs() - worst).abs() <= AGREEMENT, "{name}: {heights:?}, {worst:e}");
                }
                // In the proportional form the order of the two is that of their size, not of n.
                assert!(heights.windows(2).all(|w| w[0] * w[1] < 0.0), "{name}: {heights:?}");
                assert!(form == Form::Proportional || best.alternation.is_sorted(), "{name}");
            }
        }
    }
}

/// The optimum of a sum of squares: every step away from it makes the sum larger.
#[test]
fn least_squares_is_a_minimum() {
    let case = Case { model: Model::BlinnPhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
    let problem = Problem::new(case, 16, 1024).unwrap();
    let mut table = GaussTable::default();
    let ints: Vec<f64> = (16..=1024).map(|n| gauss_legendre(case, f64::from(n), &mut table)).collect();
    for objective in [Objective::LsAbsolute, Objective::LsRelative] {
        let sum = |a: f64, b: f64| -> f64 {
            let squares = (16..=1024).zip(&ints).map(|(n, int)| {
                let (coefficient, exact) = (a * f64::from(n) + b, f64::from(problem.divisor) / (2.0 * int));
                let scale = if objective == Objective::LsRelative { exact } else { 1.0 };
                (coefficient / scale - exact / scale) * (coefficient / scale - exact / scale)
            });
            squares.sum()
        };
        let (a, b) = least_squares(&problem, objective, Form::Linear).unwrap();
        let least = sum(a, b);
        // A millionth of a unit: its square still stands far above the rounding of the sum.
        for (in_a, in_b) in
            [(1e-6, 0.0), (-1e-6, 0.0), (0.0, 1e-4), (0.0, -1e-4), (1e-6, 1e-4), (-1e-6, 1e-4)]
        {
            assert!(sum(a + in_a, b + in_b) > least, "{}: {in_a}, {in_b}", objective.id());
        }
    }
}

#[test]
fn certified_extremes_bound_the_residual_everywhere() {
    let mut draw = Draw(1975);
    let mut table = GaussTable::default();
    for (model, limit) in [
        (Model::PhongModified, Limit::Paper),
        (Model::BlinnPhong, Limit::Support),
        (Model::BlinnPhong, Limit::Card),
        (Model::BlinnPhongModified, Limit::Support),
        (Model::BlinnPhongModified, Limit::ExactZero),
        (Model::BlinnPhongHeightfield, Limit::Support),
    ] {
        let problem = Problem::new(Case { model, lobe: Lobe::Cs16, limit }, 16, 1024).unwrap();
        for objective in Objective::ALL {
            let row = fit_case(&problem, objective, Form::Linear, 12).unwrap();
            let name = format!("{}, {}", problem.case, objective.id());
            let line: (f64, f64) = (row.line.a().parse().unwrap(), row.line.b().parse().unwrap());
            let mut at = |n: f64| residual(&problem, line, n, &mut table);
            let (reals, integers) = (row.reals, row.integers);
            // Half of the draws in 1/n, so that small n get their share.
            for i in 0..100 {
                let n =
                    if i % 2 == 0 { draw.real(16.0, 1024.0) } else { 1.0 / draw.real(1.0 / 1024.0, 0.0625) };
                let height = at(n);
                let bounds = (reals.min.value.lo() - AGREEMENT)..=(reals.max.value.hi() + AGREEMENT);
                assert!(bounds.contains(&height), "{name}: {height:e} at {n}, outside {bounds:?}");
            }
            for n in 16..=1024 {
                let height = at(f64::from(n));
                let bounds = (integers.min.value.lo() - AGREEMENT)..=(integers.max.value.hi() + AGREEMENT);
                assert!(bounds.contains(&height), "{name}: {height:e} at {n}, outside {bounds:?}");
            }
            // And they are reached where they say: no bound is wider than what it names.
            for extreme in [reals.max, reals.min, integers.max, integers.min] {
                let miss = (at(extreme.n) - extreme.value.mid()).abs();
                assert!(miss <= extreme.value.width() + AGREEMENT, "{name}: {extreme:?} missed by {miss:e}");
            }
            assert!(reals.max.value.hi() >= integers.max.value.lo(), "{name}");
            assert!(reals.min.value.lo() <= integers.min.value.hi(), "{name}");
            // What the search promises: six digits of the larger of the two, and never finer than 1e-9;
            // a tenth more for the rounding in the value where it was found.
            let promised = 1.1 * (1e-6 * reals.magnitude().value.hi()).max(1e-9);
            assert!(reals.max.value.width() <= promised, "{name}: {:?}", reals.max);
            assert!(reals.min.value.width() <= promised, "{name}: {:?}", reals.min);
        }
    }
}
