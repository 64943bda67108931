//! Factors over every real n: against 20-digit references, and against what makes them optimal.
//!
//! Where a check needs Int(n) it takes Gauss-Legendre in cos θ, a route that the fits (on the closed form)
//! share no code with; it is good to 1e-12 relative, and as 2π coef Int is near 1 that is also what it
//! leaves uncertain in a residual.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::bound::{Interval, Residual, decimal, enclose, power_of_ten, reciprocal};
use bellfit::fit::{
    Factor, FactorForm, FactorRow, FitError, Form, Objective, Problem, Reals, factor_rows, fit_case,
    fit_factor, one_sided_lines,
};
use bellfit::integral::{
    AGREEMENT, Case, Edge, GaussTable, Limit, Lobe, ScaledIntegral, gauss_legendre, scaled_cos_n,
};
use bellfit::kernel::model::Model;
use draw::Draw;
use references::{Reference, rows};
use std::sync::LazyLock;

/// The whole set of the tables.
static SET: LazyLock<Vec<FactorRow>> =
    LazyLock::new(|| factor_rows(&Model::ALL.map(support), range("16..1024")).unwrap());

fn support(model: Model) -> Case {
    Case { model, lobe: Lobe::Cs16, limit: Limit::Support }
}

fn range(text: &str) -> Reals {
    text.parse().unwrap()
}

fn name(row: &FactorRow) -> String {
    format!("{}, {}, {}, {}", row.model.id(), row.form().id(), row.objective.id(), row.digits)
}

fn is_one_sided(row: &FactorRow) -> bool {
    Objective::ONE_SIDED.contains(&row.objective)
}

/// What rounding to a row's digits may do to its residual: half a unit of each parameter, for m ≤ 1/16
/// together less than one unit of p0 < 10, times (2/divisor) n Int < 1.
fn unit(row: &FactorRow) -> f64 {
    libm::exp10(1.0 - row.digits as f64)
}

/// The residual of parameters in doubles, by Gauss-Legendre.
fn residual(row: &FactorRow, p: &[f64], n: f64, table: &mut GaussTable) -> f64 {
    let factor = n * row.form().per_n(p, &(1.0 / n)) / f64::from(row.factor.divisor());
    factor * 2.0 * gauss_legendre(support(row.model), n, table) - 1.0
}

fn parameters(row: &FactorRow) -> Vec<f64> {
    row.factor.parameters().iter().map(|p| p.parse().unwrap()).collect()
}

#[test]
fn the_set_holds_every_form_that_pays_and_no_other() {
    for model in Model::ALL {
        let of = |form: FactorForm, objective: Objective| {
            SET.iter().find(|r| r.model == model && r.form() == form && r.objective == objective)
        };
        let level = |form: FactorForm| {
            let row = fit_factor(&support(model), range("16..1024"), form, Objective::Minimax, 12).unwrap();
            row.extremes.magnitude().value
        };
        for form in FactorForm::ALL {
            let simpler: Vec<FactorForm> = std::iter::successors(form.simpler(), |f| f.simpler()).collect();
            let pays = simpler.iter().all(|f| 2.0 * level(form).hi() < level(*f).lo());
            assert_eq!(of(form, Objective::Minimax).is_some(), pays, "{}, {}", model.id(), form.id());
            assert_eq!(of(form, Objective::OneSided).is_some(), pays);
            let squares = pays && form != FactorForm::Ratio;
            assert_eq!(of(form, Objective::LsAbsolute).is_some(), squares);
            assert_eq!(of(form, Objective::LsRelative).is_some(), squares);
        }
        let short: Vec<usize> = SET
            .iter()
            .filter(|r| r.model == model && r.objective == Objective::OneSidedRounded)
            .map(|r| r.digits)
            .collect();
        assert_eq!(short, [3, 4, 5, 6]);
    }
    // Phong is (17/16) n exactly: nothing pays.
    assert!(SET.iter().all(|r| r.model != Model::Phong || r.form() == FactorForm::Proportional));
}

/// The certified lower bound, the reference and the certified residual of the rounded factor, in order.
#[test]
fn levels_meet_the_references() {
    let table = rows("factors_fit.csv");
    assert_eq!(table.len(), 52);
    for [model, form, from, to, level, p0, p1, p2, p3] in table {
        let case = support(Model::from_id(&model).unwrap());
        let form = FactorForm::from_id(&form).unwrap();
        let range = range(&format!("{from}..{to}"));
        let row = fit_factor(&case, range, form, Objective::Minimax, 12).unwrap();
        let name = format!("{case}, {}, {range}", form.id());
        let level = Reference::parse(&level).unwrap();
        let reached = row.extremes.magnitude().value;
        assert!(level.is_enclosed(Interval::new(row.optimum, reached.hi())), "{name}: {level:?}, {row:?}");
        // The bound is the level itself but for the exchange's evenness, the row but for its rounding.
        let evenness = 1e-9 * level.to_f64() + 1e-11;
        assert!(level.to_f64() - row.optimum <= evenness, "{name}: {level:?}, {:e}", row.optimum);
        assert!(reached.lo() - level.to_f64() <= 2.0 * unit(&row), "{name}: {level:?}, {reached:?}");
        assert!(row.excess >= reached.hi() - level.to_f64(), "{name}");
        for (found, expected) in row.factor.parameters().iter().zip([p0, p1, p2, p3]) {
            // Where the level is flat a parameter is not better known than the level's root.
            let expected = Reference::parse(&expected).unwrap();
            let size = expected.to_f64().abs().max(1.0);
            let distance = expected.distance(found.parse().unwrap()).to_f64().value();
            assert!(distance <= 1e-5 * size, "{name}: {found}, {expected:?}");
        }
    }
}

#[test]
fn minimax_residuals_equioscillate() {
    let mut table = GaussTable::default();
    for row in SET.iter().filter(|r| r.objective == Objective::Minimax) {
        let (name, level) = (name(row), row.extremes.magnitude().value.hi());
        if row.alternation.is_empty() {
            // Exact: 0, or what twelve digits leave of 0.
            assert!(row.optimum == 0.0 && level <= unit(row), "{name}");
            continue;
        }
        assert_eq!(row.alternation.len(), row.form().parameters() + 1, "{name}");
        assert!(row.alternation.is_sorted() && row.alternation.iter().all(|n| (16.0..=1024.0).contains(n)));
        let p = parameters(row);
        let heights: Vec<f64> = row.alternation.iter().map(|&n| residual(row, &p, n, &mut table)).collect();
        assert!(heights.windows(2).all(|w| w[0] * w[1] < 0.0), "{name}: {heights:?}");
        // Even to what was rounded away, and to the enclosure's six digits.
        let uneven = unit(row) + AGREEMENT + 1e-6 * level;
        assert!(heights.iter().all(|h| (h.abs() - level).abs() <= uneven), "{name}: {heights:?}, {level:e}");
    }
}

#[test]
fn one_sided_factors_gain_nothing_and_lose_least() {
    let mut table = GaussTable::default();
    let mut draw = Draw(1977);
    for row in SET.iter().filter(|r| is_one_sided(r)) {
        let (name, p) = (name(row), parameters(row));
        assert!(row.extremes.max.value.hi() <= 0.0, "{name}: {:?}", row.extremes.max);
        let loss = -row.extremes.min.value;
        assert!(loss.hi() >= row.least_loss(), "{name}");
        assert!(loss.hi() - row.least_loss() <= row.excess, "{name}");
        if row.objective == Objective::OneSided {
            // Two units for the rounding, six digits for the enclosure.
            let most = (1.0 + 2e-6) * row.least_loss() + 2.0 * unit(row);
            assert!(loss.hi() <= most, "{name}: {loss:?} against {:e}", row.least_loss());
        }
        for _ in 0..60 {
            let n = 1.0 / draw.real(1.0 / 1024.0, 1.0 / 16.0);
            let height = residual(row, &p, n, &mut table);
            let bounds = row.extremes.min.value.lo() - AGREEMENT..=AGREEMENT;
            assert!(bounds.contains(&height), "{name}: {height:e} at {n}");
        }
    }
}

/// One unit of the last digit more in p0, and for a shortest line also in p1, and energy is gained: proved.
#[test]
fn one_unit_more_is_refuted() {
    for row in SET.iter().filter(|r| is_one_sided(r)) {
        let raised = |k: usize| {
            let mut texts = row.factor.parameters().to_vec();
            let (value, _) = decimal(&texts[k]).unwrap();
            let whole = format!("{:e}", texts[k].parse::<f64>().unwrap());
            let exponent: i32 = whole.split_once('e').unwrap().1.parse().unwrap();
            // 0 has no last digit; the finest step that the search allows is what it could be raised by.
            let is_zero = value.is_zero();
            let places = row.digits as i32 + if is_zero { 1 } else { -1 - exponent };
            let sum = value + power_of_ten(-places);
            texts[k] = format!("{:.*}", places as usize, enclose(&sum).mid());
            assert_eq!(decimal(&texts[k]).unwrap().0, sum);
            Factor::new(row.form(), &texts, row.factor.divisor()).unwrap()
        };
        let free = if row.objective == Objective::OneSidedRounded { row.form().parameters() } else { 1 };
        for factor in (0..free).map(raised) {
            let largest = Residual::new(support(row.model), factor.formula()).largest(16.0, 1024.0);
            assert!(largest.value.lo() > 0.0, "{}: {factor}, {largest:?}", name(row));
            assert!(Residual::new(support(row.model), factor.formula()).at(largest.n).hi() > 0.0);
        }
    }
}

#[test]
fn shortest_decimals_meet_the_exhaustive_search() {
    let table = rows("factors_rounded.csv");
    assert_eq!(table.len(), 12);
    for [model, digits, a, b, loss] in table {
        let wanted = |r: &&FactorRow| {
            r.objective == Objective::OneSidedRounded
                && r.model.id() == model
                && r.digits.to_string() == digits
        };
        let row = SET.iter().find(wanted).unwrap();
        assert_eq!(row.factor.parameters(), [a, b], "{}", name(row));
        assert!(Reference::parse(&loss).unwrap().is_enclosed(-row.extremes.min.value), "{}", name(row));
    }
    // Phong is 1.0625 n: what fewer digits leave of it.
    let phong = SET.iter().filter(|r| r.model == Model::Phong && r.objective == Objective::OneSidedRounded);
    let texts: Vec<&str> = phong.map(|r| r.factor.parameters()[0].as_str()).collect();
    assert_eq!(texts, ["1.06", "1.062", "1.0625", "1.0625"]);
}

/// No other parameters do better, near or far: every draw has a residual of at least the bound somewhere,
/// and every draw that gains nothing loses at least 2E/(1 + E).
#[test]
fn random_parameters_never_beat_the_bound() {
    let (mut draw, mut table) = (Draw(1886), GaussTable::default());
    for row in SET.iter().filter(|r| r.objective == Objective::Minimax && !r.alternation.is_empty()) {
        let best = parameters(row);
        for round in 0..200 {
            let size = libm::exp10(-draw.real(1.0, 9.0));
            let mut p: Vec<f64> = best.iter().map(|p| p * (1.0 + draw.real(-size, size))).collect();
            if round % 2 == 0 {
                // Below everywhere: the one-sided bound's turn.
                p[0] -= row.optimum;
            }
            let heights: Vec<f64> =
                row.alternation.iter().map(|&n| residual(row, &p, n, &mut table)).collect();
            let most = heights.iter().fold(0.0_f64, |most, h| most.max(h.abs()));
            assert!(most >= row.optimum - AGREEMENT, "{}: {p:?}, {most:e}", name(row));
            let (lo, hi) =
                heights.iter().fold((0.0_f64, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
            assert!(hi > -AGREEMENT || -lo >= row.least_loss() - AGREEMENT, "{}: {p:?}", name(row));
        }
    }
}

/// The optimum of a sum of squares: every step away from it makes the sum larger.
#[test]
fn least_squares_is_a_minimum() {
    let mut table = GaussTable::default();
    let squares = |r: &&FactorRow| matches!(r.objective, Objective::LsAbsolute | Objective::LsRelative);
    for row in SET.iter().filter(squares).filter(|r| r.optimum > 0.0) {
        let mut sum = |p: &[f64]| -> f64 {
            let squares = (16..=1024).map(|n| {
                let n = f64::from(n);
                let r = residual(row, p, n, &mut table);
                let exact = 1.0 / (2.0 * gauss_legendre(support(row.model), n, &mut table));
                let miss = if row.objective == Objective::LsAbsolute { r * exact } else { r };
                miss * miss
            });
            squares.sum()
        };
        let best = parameters(row);
        let least = sum(&best);
        for k in 0..best.len() {
            for sign in [-1.0, 1.0] {
                let mut p = best.clone();
                // A step whose square stands above the sum's rounding, though it be along the weakest term.
                p[k] += sign * 1e-4 * libm::pow(16.0, k as f64);
                assert!(sum(&p) > least, "{}: p{k}", name(row));
            }
        }
    }
}

/// As documented: nothing cancels for small n.
#[test]
fn integrals_are_enclosed_tightly_down_to_one() {
    for case in Case::all() {
        for n in [1.0, 1.25, 2.0, 3.5, 8.0, 15.9, 16.0, 55.0, 1024.0, 1e6] {
            let enclosure = case.scaled_from(n, &reciprocal(Interval::from(n)));
            let widest = if n < 16.0 { 2e-12 } else { 1e-13 };
            assert!(enclosure.width() < widest * enclosure.lo(), "{case}, n = {n}: {enclosure:?}");
            assert!(!enclosure.is_disjoint(case.scaled(&reciprocal(Interval::from(n)))), "{case}, n = {n}");
        }
    }
}

#[test]
fn ranges_of_the_users_own_are_certified_throughout() {
    let mut draw = Draw(1958);
    let cases = Model::ALL.map(support).into_iter();
    for (i, case) in cases.chain(Case::all().filter(|c| c.limit != Limit::Support)).enumerate() {
        for text in ["1..16", "16..inf", "20.5..33.25"] {
            let form = FactorForm::ALL[(i + text.len()) % 5];
            for objective in [Objective::Minimax, Objective::OneSided] {
                let row = fit_factor(&case, range(text), form, objective, 12).unwrap();
                let name = format!("{case}, {text}, {}", name(&row));
                let residual = Residual::new(case, row.factor.formula());
                let (lo, hi) = (1.0 / row.range.to(), 1.0 / row.range.from());
                for _ in 0..40 {
                    let at = residual.at(1.0 / draw.real(lo, hi).max(1e-12));
                    let bounds = Interval::new(row.extremes.min.value.lo(), row.extremes.max.value.hi());
                    assert!(!bounds.is_disjoint(at), "{name}: {at:?}, {bounds:?}");
                }
                let reached = if objective == Objective::Minimax {
                    row.extremes.magnitude().value.hi()
                } else {
                    assert!(row.extremes.max.value.hi() <= 0.0, "{name}");
                    -row.extremes.min.value.lo()
                };
                // Rounded to 12 digits, six of them enclosed, it is the best there is.
                let goal = if objective == Objective::Minimax { row.optimum } else { row.least_loss() };
                assert!(
                    goal <= reached && reached <= goal * (1.0 + 3e-6) + 3.0 * unit(&row),
                    "{name}: {row:?}"
                );
            }
        }
    }
}

/// An integral of another type that does not tell that it is rational: 1/(n + 1).
#[derive(Clone)]
struct Shifted;

impl ScaledIntegral for Shifted {
    fn scaled<T: Edge>(&self, m: &T) -> T {
        scaled_cos_n(Model::Phong, m, &T::int(0))
    }
    fn model(&self) -> Model {
        Model::Phong
    }
    fn name(&self) -> String {
        "shifted".into()
    }
}

#[test]
fn any_integral_can_be_fitted() {
    let rows = factor_rows(&[Shifted], range("1..inf")).unwrap();
    let line =
        rows.iter().find(|r| r.form() == FactorForm::Linear && r.objective == Objective::Minimax).unwrap();
    assert_eq!((line.factor.to_string(), line.lobe.as_str()), ("(1 n + 1)/(2π)".to_owned(), "shifted"));
    // Where nothing else is said, the lobe is integrated over its support.
    assert_eq!(line.limit, Limit::Support.id());
    // Nothing cancels exactly without the rational form: the search ends with what boxes it has.
    assert!(line.extremes.magnitude().value.hi() < 1e-11, "{line:?}");
    // Without whole ends there is no sum, and beyond the exact line no form pays.
    assert!(rows.iter().all(|r| r.form().as_line().is_some() && r.objective != Objective::LsRelative));
}

#[test]
fn lines_for_the_table_of_lines_hold_over_integers_too() {
    for model in [Model::Phong, Model::BlinnPhongModified] {
        let problem = Problem::new(support(model), 16, 1024).unwrap();
        let lines = one_sided_lines(&problem).unwrap();
        assert_eq!(lines.len(), 5);
        for line in &lines {
            let (integers, reals) = (line.integers, line.reals);
            assert!(integers.max.value.hi() <= 1e-13 && reals.max.value.hi() <= 0.0);
            assert!(reals.min.value.lo() <= integers.min.value.hi());
        }
        let row = fit_case(&problem, Objective::OneSidedRounded, Form::Linear, 4).unwrap();
        let again = lines.iter().find(|l| l.line == row.line);
        // For Phong the shortest line is 1.062 n + 0.008, and b = 0 suffices.
        assert_eq!(again.is_some(), model != Model::Phong);
    }
}

#[test]
fn what_cannot_be_fitted_is_told() {
    let fit = |text: &str, form, objective, digits| {
        fit_factor(&support(Model::BlinnPhong), range(text), form, objective, digits).unwrap_err().to_string()
    };
    let told = fit("16..inf", FactorForm::Inverse, Objective::LsRelative, 12);
    assert_eq!(told, "ls-relative, inverse: n = 16..inf: a sum runs over whole n up to 65536");
    assert!(fit("16..99", FactorForm::Ratio, Objective::LsAbsolute, 12).contains("not linear in p3"));
    assert!(
        fit("16..99", FactorForm::Inverse, Objective::OneSidedRounded, 4).contains("linear and proportional")
    );
    assert!(fit("16..99", FactorForm::Linear, Objective::OneSidedRounded, 9).contains("9 digits"));
    assert!(fit("16..99", FactorForm::Linear, Objective::Minimax, 16).contains("16 digits"));
    let few = fit("16..17", FactorForm::InverseSquare, Objective::LsAbsolute, 12);
    assert_eq!(few, "n = 16..17: 4 values of n are needed and 2 given");
    // As many whole n as parameters are enough.
    for (form, text) in [(FactorForm::Linear, "16..17"), (FactorForm::Inverse, "16..18")] {
        for objective in [Objective::LsAbsolute, Objective::LsRelative] {
            let row = fit_factor(&support(Model::BlinnPhong), range(text), form, objective, 12).unwrap();
            assert_eq!((row.form(), row.objective), (form, objective));
        }
    }
    // No two doubles lie in it.
    let narrow = fit("16..16.0000000000000001", FactorForm::Linear, Objective::Minimax, 12);
    assert_eq!(narrow, FitError::Reals { text: "16..16".to_owned() }.to_string());
    assert!(matches!(Reals::new(f64::NAN, 3.0), Err(FitError::Reals { .. })));
    assert!(matches!(Reals::new(3.0, f64::NAN), Err(FitError::Reals { .. })));
}
