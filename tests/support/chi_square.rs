//! Pearson's χ² test of a histogram against expected counts.
#![allow(dead_code)] // every test file uses its part

/// Cells are pooled with their neighbours up to this expectation, so that χ² is near its limit law.
const LEAST: f64 = 10.0;

/// Probability that χ² with an even number of degrees of freedom exceeds `x`.
///
/// Exact: e^(-x/2) Σ (x/2)ʲ/j! over j < dof/2, the Erlang (Poisson) tail; Abramowitz & Stegun 26.4.21.
pub fn survival(dof: usize, x: f64) -> f64 {
    assert!(dof >= 2 && dof.is_multiple_of(2) && x >= 0.0, "{dof}, {x}");
    let half = x / 2.0;
    let (mut sum, mut log_term) = (0.0, -half);
    for j in 0..dof / 2 {
        if j > 0 {
            log_term += libm::log(half / j as f64);
        }
        sum += libm::exp(log_term);
    }
    sum
}

/// Probability of a χ² as large as the histogram's if each cell's expectation is right; the cells must
/// be all there are, so that one degree of freedom goes to the count.
pub fn p_value(observed: &[u32], expected: &[f64]) -> f64 {
    assert_eq!(observed.len(), expected.len());
    let mut cells: Vec<(f64, f64)> = vec![(0.0, 0.0)];
    for (&o, &e) in observed.iter().zip(expected) {
        assert!(e >= 0.0, "an expectation of {e}");
        let last = cells.last_mut().expect("never empty");
        *last = (last.0 + f64::from(o), last.1 + e);
        if last.1 >= LEAST {
            cells.push((0.0, 0.0));
        }
    }
    // What is left over joins its neighbour; an even count of cells one more, for `survival`.
    let join = |cells: &mut Vec<(f64, f64)>| {
        let (o, e) = cells.pop().expect("a cell");
        let last = cells.last_mut().expect("a second cell");
        *last = (last.0 + o, last.1 + e);
    };
    join(&mut cells);
    if cells.len().is_multiple_of(2) {
        join(&mut cells);
    }
    let square: f64 = cells.iter().map(|(o, e)| (o - e) * (o - e) / e).sum();
    survival(cells.len() - 1, square)
}

/// The level at which each of `tests` independent tests must be held for `all` of them together (Šidák).
pub fn sidak(all: f64, tests: usize) -> f64 {
    -libm::expm1(libm::log1p(-all) / tests as f64)
}
