//! The kernels that a need has, for readers.

use super::number::{short, short_down, short_up};
use crate::bound::{Handed, Measure, Supremum};
use crate::choose::{
    Answer, Candidate, Costs, Demand, EnergyDemand, Exponents, Factor, Failure, Miss, Need, Price, Side,
    Verdict, theta,
};
use std::fmt::Write;

/// An answer: the kernels that qualify, cheapest first, why the cheaper ones fail, and the proofs.
pub fn choice_lines(answer: &Answer, costs: &Costs<'_>) -> String {
    let mut text = format!("{}\n", need_words(&answer.need));
    if answer.best().is_none() {
        text.push_str("nothing qualifies\n");
        if let Some(miss) = answer.nearest_miss() {
            let _ = writeln!(text, "nearest: {}", miss_words(&miss, &answer.need));
        } else {
            text.push_str("nearest: none, as no error has a bound here\n");
        }
    } else {
        text.push_str(&table(answer));
    }
    let _ = writeln!(text, "cost: {}", cost_words(answer, costs));
    let cheaper = answer.cheaper();
    if !cheaper.is_empty() {
        let which = if answer.best().is_some() { "the cheaper ones" } else { "they" };
        let _ = writeln!(text, "\nwhy {which} do not do");
        for candidate in cheaper {
            let (id, reason) = (candidate.stand_in.id(), why(candidate, &answer.need));
            let _ = writeln!(text, "  {id:<18} {reason}");
        }
    }
    if answer.best().is_some() {
        text.push_str("\nproofs\n");
        for candidate in answer.qualifying() {
            text.push_str(&proof(candidate, &answer.need));
        }
    }
    text
}

fn range_words(n: Exponents) -> String {
    let end = |x: f64| if x == libm::floor(x) { x.to_string() } else { short(x) };
    match (n.from() == n.to(), n.is_whole()) {
        (true, _) => format!("n = {}", end(n.from())),
        (false, whole) => {
            let kind = if whole { "whole " } else { "" };
            format!("{kind}n = {}..{}", end(n.from()), end(n.to()))
        }
    }
}

/// What was asked, in a line.
pub(super) fn need_words(need: &Need) -> String {
    let of = match need.measure {
        Measure::Absolute => "of the peak".to_owned(),
        Measure::Relative { floor } => {
            format!("of the value, where that is at least {} of the peak", short(floor))
        }
    };
    let handed = match need.handed {
        Handed::Cosine => "cos θ",
        Handed::Versine => "1 - cos θ",
        Handed::Difference => "|a - b|²/2",
    };
    let (n, format, error) = (range_words(need.n), need.format.id(), short(need.max_error));
    let mut text = format!("{n}, {format} from {handed}, error at most {error} {of}");
    if let Some(model) = need.model {
        let _ = write!(text, ", {}", model.id());
    }
    match need.energy {
        Some(EnergyDemand::NeverGains) => text.push_str(", ∫ ≤ 1"),
        Some(EnergyDemand::Unbiased { error }) => {
            let _ = write!(text, ", |∫ - 1| ≤ {}", short(error));
        }
        None => {}
    }
    for (asked, word) in [(need.division, ", no division"), (need.transcendental, ", no transcendental")] {
        if !asked {
            text.push_str(word);
        }
    }
    text
}

fn price_words(price: Price) -> String {
    match price {
        Price::Measured(ns) => format!("{} ns", short(ns)),
        Price::Operations(operations) => short(operations),
    }
}

fn cost_words(answer: &Answer, costs: &Costs<'_>) -> String {
    let measured = answer.candidates.iter().filter(|c| matches!(c.price, Price::Measured(_))).count();
    let (division, transcendental) = (costs.weights.division, costs.weights.transcendental);
    let counted = format!(
        "operations, a division counted as {}, an exponential or logarithm as {}",
        short(division),
        short(transcendental)
    );
    match measured {
        0 => counted,
        all if all == answer.candidates.len() => "nanoseconds a value, from the record".to_owned(),
        _ => format!("nanoseconds a value, from the record; what that does not have after them: {counted}"),
    }
}

/// n and θ of a supremum.
fn place(supremum: &Supremum<2>) -> String {
    let [n, t] = supremum.at;
    format!("n = {}, θ = {}", short(n), short(theta(n, t)))
}

fn table(answer: &Answer) -> String {
    let with_energy = answer.need.model.is_some();
    let mut rows = vec![
        vec!["", "kernel", "cost", "error at most", "at", "of it rounding", "evidence"]
            .into_iter()
            .map(str::to_owned)
            .collect::<Vec<_>>(),
    ];
    if with_energy {
        rows[0].push("∫ - 1".to_owned());
    }
    for (rank, c) in answer.qualifying().enumerate() {
        let (Some(bound), Some(r), Some((n, theta))) = (c.bound, c.rounding, c.worst()) else { continue };
        let at = format!("n = {}, θ = {}", short(n), short(theta));
        let mut row = vec![
            (rank + 1).to_string(),
            c.stand_in.id().to_owned(),
            price_words(c.price),
            short_up(bound),
            at,
            short_up(r.value.hi()),
            c.evidence().to_owned(),
        ];
        if with_energy {
            row.push(c.factors.first().map_or_else(|| "no factor".to_owned(), energy_words));
        }
        rows.push(row);
    }
    aligned(&rows)
}

/// Columns of equal width, two blanks between them.
pub(super) fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |i: usize| rows.iter().filter_map(|row| row.get(i)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|i| width(i).unwrap_or(0)).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, "{cell:<width$}  ");
        }
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

fn energy_words(factor: &Factor) -> String {
    let (max, min) = (factor.residual.max, factor.residual.min);
    format!("{} to {}", short_down(min.value.lo()), short_up(max.value.hi()))
}

/// Why a kernel does not do, in a line.
pub(super) fn why(candidate: &Candidate, need: &Need) -> String {
    match &candidate.verdict {
        Verdict::Qualifies => "qualifies".to_owned(),
        Verdict::Excluded(exclusion) => format!("left out: {}", exclusion.reason()),
        Verdict::Fails(Failure::Error(w)) => {
            let (n, theta) = (short(w.n), short(w.theta));
            let found = if w.error.is_finite() {
                format!("error {}", short_down(w.error))
            } else {
                "no finite value".to_owned()
            };
            format!("fails: {found} at n = {n}, θ = {theta}, {}", w.evidence.id())
        }
        Verdict::Fails(Failure::Energy { side, least, n }) => {
            let word = match side {
                Side::Gain => "gains",
                Side::Loss => "loses",
            };
            format!("fails: {word} at least {} of the energy at n = {}", short_down(*least), short(*n))
        }
        Verdict::Fails(Failure::NoFactor(reason)) => format!("fails: {reason}"),
        Verdict::Unproved => unproved(candidate, need),
    }
}

fn unproved(candidate: &Candidate, need: &Need) -> String {
    let found = candidate.measured.map_or_else(String::new, |w| {
        format!("; the largest found is {} at n = {}, θ = {}", short(w.error), short(w.n), short(w.theta))
    });
    match candidate.bound {
        None => format!("not proved: its rounding in {} has no bound here{found}", need.format.id()),
        Some(bound) if bound > need.max_error => {
            format!("not proved: error at most {}{found}", short_up(bound))
        }
        Some(_) => "not proved: its energy".to_owned(),
    }
}

/// What a qualifying kernel's bound is made of.
fn proof(c: &Candidate, need: &Need) -> String {
    let id = c.stand_in.id();
    let (Some(a), Some(r), Some(bound)) = (c.approximation, c.rounding, c.bound) else {
        return String::new();
    };
    let exact = if c.stand_in.is_exact() {
        "is cosⁿ in exact arithmetic".to_owned()
    } else {
        format!("is within {} of cosⁿ in exact arithmetic ({}), certified", short_up(a.value.hi()), place(&a))
    };
    let rounding = if c.assumes_elementary {
        format!(
            "assuming exp, exp2, log2, log1p and pow within {} ulp, which WGSL and GLSL do not promise",
            short(need.ulps)
        )
    } else {
        "certified".to_owned()
    };
    let mut text = format!(
        "  {id:<18} {exact};\n{:21}its rounding in {} adds at most {} ({}), {rounding}; together at most {}\n",
        "",
        need.format.id(),
        short_up(r.value.hi()),
        place(&r),
        short_up(bound)
    );
    if let Some(w) = c.measured {
        let (error, n, theta) = (short(w.error), short(w.n), short(w.theta));
        let _ = writeln!(text, "{:21}the largest measured is {error} (n = {n}, θ = {theta})", "");
    }
    for factor in &c.factors {
        let _ = writeln!(text, "{:21}factor {}", "", factor_words(factor));
    }
    if let Some(reason) = &c.no_factor {
        let _ = writeln!(text, "{:21}{reason}", "");
    }
    text
}

fn factor_words(factor: &Factor) -> String {
    let (max, min) = (factor.residual.max, factor.residual.min);
    let nudged = if factor.nudge > 0.0 {
        // A power of two by construction.
        format!(" (1 - 2^{})", libm::log2(factor.nudge))
    } else {
        String::new()
    };
    format!(
        "{}{nudged}, rounded once: ∫ - 1 of the exact lobe from {} (n = {}) to {} (n = {}), certified",
        factor.call,
        short_down(min.value.lo()),
        short(min.n),
        short_up(max.value.hi()),
        short(max.n)
    )
}

fn miss_words(miss: &Miss, need: &Need) -> String {
    let (id, ratio) = (miss.stand_in.id(), short(miss.ratio));
    match miss.demand {
        Demand::Error => format!(
            "{id}, whose error is at most {}, {ratio} times the {} that is allowed",
            short_up(miss.value),
            short(need.max_error)
        ),
        Demand::Energy => format!("{id}, whose energy is not kept as is asked"),
        Demand::Exclusion(exclusion) => {
            format!("{id}, error at most {}, would do, but {}", short_up(miss.value), exclusion.reason())
        }
    }
}
