//! The certified suprema of the papers' functions, by their parameters.

use super::study::SupremumRow;
use crate::bound::{Gaussian, Interval, bell_distance, difference_supremum, gaussian_distance};
use crate::integral::Limit;

/// How far cs_16 is from cosⁿ under each cut, cosⁿ from both Gaussians, and Lyon's bells from e⁻ᵗ.
pub(super) fn suprema() -> Vec<SupremumRow> {
    let exponents = [16.0, 17.0, 20.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0];
    let mut rows = Vec::new();
    for cut in [Limit::ExactZero, Limit::Paper, Limit::Card] {
        let ranges = exponents.iter().map(|&n| Interval::from(n)).chain([Interval::new(16.0, 1024.0)]);
        for n in ranges {
            let found = difference_supremum(cut, n, 1e-6);
            let theta = if found.beyond_cut { "theta -> cr+ =" } else { "theta =" };
            rows.push(SupremumRow {
                function: format!("cos^n - cs16 ({})", cut.id()),
                parameter: range_text(n),
                value: found.value,
                at: format!("n = {} {theta} {:.5}", short_n(found.n), found.theta()),
            });
        }
    }
    for kind in Gaussian::ALL {
        for &n in &exponents {
            let found = gaussian_distance(kind, Interval::from(n), 1e-4 / n);
            let name = if kind == Gaussian::Angle { "n theta^2/2" } else { "n (1 - cos theta)" };
            rows.push(SupremumRow {
                function: format!("{} - cos^n", kind.id()),
                parameter: range_text(Interval::from(n)),
                value: found.value,
                at: format!("{name} = {:.4}", found.at[1]),
            });
        }
    }
    for power in [4, 8, 16, 32] {
        let found = bell_distance(power, 1e-8);
        rows.push(SupremumRow {
            function: "e^-t - (1 - t/K)^K".to_owned(),
            parameter: format!("K = {power}"),
            value: found.value,
            at: format!("t = {:.4}", found.at[0]),
        });
    }
    rows
}

fn range_text(n: Interval) -> String {
    if n.lo() == n.hi() {
        format!("n = {}", n.lo())
    } else {
        format!("every real n in {}..{}", n.lo(), n.hi())
    }
}

fn short_n(n: f64) -> String {
    if n == libm::floor(n) { format!("{n}") } else { format!("{n:.2}") }
}
