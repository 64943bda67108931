//! Lobes fitted to measured samples, for readers.

use super::data_fit_code::data_fit_code;
use super::number::short;
use crate::fit::measured::{
    CONFIDENCE, Comparison, Estimate, FEW_ANGLES, Goodness, INDISTINCT, NoUncertainty, Samples, Weighting,
};
use crate::kernel::exact::Cost;
use std::fmt::Write;

/// A comparison of families: what the samples say, a row a family, which are as good, and code for the cheapest.
pub fn data_fit_lines(samples: &Samples, found: &Comparison) -> String {
    let mut text = format!("{}\n", samples_words(samples, found));
    text.push_str(&table(found));
    let _ = writeln!(text, "\n{}", verdict(found));
    let best = found.best();
    if let Some(trend) = best.trend.filter(|trend| trend.is_misfit()) {
        let _ = writeln!(
            text,
            "{} does not have the samples' shape: residuals of neighbouring angles are correlated by {}, and by 0 ± {} \
             if they were noise; its intervals then say too little",
            best.family,
            short(trend.correlation),
            short(1.0 / (trend.angles as f64).sqrt())
        );
    }
    if let Some(words) = best.goodness.and_then(|goodness| goodness_words(best, &goodness)) {
        let _ = writeln!(text, "{words}");
    }
    for (reason, families) in by_reason(found) {
        let _ = writeln!(text, "{}: no uncertainty, as {reason}", families.join(", "));
    }
    for (family, reason) in &found.failures {
        let _ = writeln!(text, "{family}: not fitted, {reason}");
    }
    if found.angles < FEW_ANGLES {
        let _ =
            writeln!(text, "misfit: not looked for, {} angles being fewer than {FEW_ANGLES}", found.angles);
    }
    if samples.may_be_radians(best.n) {
        let _ = writeln!(
            text,
            "every angle is at most 1.571 degrees, and n is {}; if these are radians, name the column theta_rad",
            short(best.n)
        );
    }
    let noise = match found.weighting {
        Weighting::Equal => "of one variance, which the residuals tell",
        Weighting::Weight => "of variance s²/weight, s² from the residuals",
        Weighting::Sigma => "of the sigma given",
    };
    let _ = writeln!(
        text,
        "estimated; from and to are n e^(-t σ) and n e^(t σ), σ the standard error of ln n, ± is t standard errors: \
         {:.0} % intervals, if the family is right and the noise independent and {noise}",
        100.0 * CONFIDENCE
    );
    let _ = write!(text, "\n{}", data_fit_code(found.cheapest()));
    text
}

/// What sigmas that do not hold mean for the answer.
fn goodness_words(best: &Estimate, goodness: &Goodness) -> Option<String> {
    let below = |p: f64| if p < 1e-99 { "less than 1e-99".to_owned() } else { format!("{p:.1e}") };
    let (size, more, p, so) = if goodness.is_excess() {
        let so =
            "the sigmas are too small, or the lobe has another shape; intervals and ΔBIC then say too much";
        ("larger", "more", goodness.above, so)
    } else if goodness.is_short() {
        (
            "smaller",
            "less",
            goodness.below,
            "the sigmas are too large; intervals and ΔBIC then say too little",
        )
    } else {
        return None;
    };
    Some(format!(
        "warning: the residuals of {} are {size} than the sigmas: χ²/(N - p) is {} with N - p = {}, and noise of these \
         sigmas makes it {more} with probability {}; {so}",
        best.family,
        ratio(goodness.reduced),
        best.freedom,
        below(p)
    ))
}

/// The families without an uncertainty, from the best on, a line a reason.
fn by_reason(found: &Comparison) -> Vec<(NoUncertainty, Vec<&'static str>)> {
    let mut reasons: Vec<(NoUncertainty, Vec<&'static str>)> = Vec::new();
    for estimate in &found.estimates {
        let Err(reason) = estimate.uncertainty else { continue };
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, families)) => families.push(estimate.family.id()),
            None => reasons.push((reason, vec![estimate.family.id()])),
        }
    }
    reasons
}

fn samples_words(samples: &Samples, found: &Comparison) -> String {
    let ends = samples.all().iter().filter(|sample| sample.weight > 0.0).map(|sample| sample.theta_deg);
    let (lo, hi) = ends.fold((90.0_f64, 0.0_f64), |(lo, hi), degrees| (lo.min(degrees), hi.max(degrees)));
    let weighting = match found.weighting {
        Weighting::Equal => "of equal weight",
        Weighting::Weight => "by their weights",
        Weighting::Sigma => "by their sigmas",
    };
    let out = match found.left_out {
        0 => String::new(),
        count => format!(", {count} of weight 0 left out"),
    };
    format!(
        "{} samples at {} angles from {}° to {}°, {weighting}{out}",
        found.counted,
        found.angles,
        short(lo),
        short(hi)
    )
}

/// A number and what it may be off, to two digits of the latter; without it, five digits.
pub(super) fn with_error(x: f64, error: Option<f64>) -> (String, String) {
    let Some(error) = error else { return (short(x), String::new()) };
    if !(error > 0.0 && (1e-6..1e6).contains(&error) && x.abs() < 1e9) {
        return (short(x), format!("{error:.1e}"));
    }
    let decimals = (1.0 - libm::floor(libm::log10(error))).max(0.0) as usize;
    (format!("{x:.decimals$}"), format!("{error:.decimals$}"))
}

/// n with the ends of its interval, to two digits of the narrower half.
pub(super) fn exponent(estimate: &Estimate) -> [String; 3] {
    let n = estimate.n;
    let Some((lo, hi)) = estimate.n_interval() else { return [short(n), String::new(), String::new()] };
    let half = n - lo;
    if !(half > 1e-6 && hi < 1e9) {
        return [n, lo, hi].map(short);
    }
    let decimals = (1.0 - libm::floor(libm::log10(half))).max(0.0) as usize;
    [n, lo, hi].map(|x| format!("{x:.decimals$}"))
}

/// The scale with half of its interval.
fn scale(estimate: &Estimate) -> (String, String) {
    with_error(estimate.scale, estimate.uncertainty.as_ref().ok().map(|u| u.scale * u.quantile()))
}

/// χ²/(N - p).
fn ratio(reduced: f64) -> String {
    if (0.01..1e4).contains(&reduced) { format!("{reduced:.3}") } else { format!("{reduced:.2e}") }
}

/// A difference of BIC, to so many decimals that it does not seem to be at the threshold when it is beyond.
fn difference(behind: f64) -> String {
    let tells = |text: &String| text.parse::<f64>().is_ok_and(|x| (x > INDISTINCT) == (behind > INDISTINCT));
    let decimals = (2..=16).map(|decimals| format!("{behind:.decimals$}"));
    decimals.into_iter().find(tells).unwrap_or_else(|| behind.to_string())
}

/// What a value costs, from cos θ.
fn cost_words(cost: Cost) -> String {
    let mut text = cost.operations.to_string();
    for (count, letter) in [(cost.divisions, "d"), (cost.transcendentals, "t")] {
        if count > 0 {
            let _ = write!(text, " + {count}{letter}");
        }
    }
    text
}

fn table(found: &Comparison) -> String {
    let is_told = found.weighting == Weighting::Sigma;
    let mut head = vec!["family", "cost", "n", "from", "to", "scale", "±", "rms", "largest", "at", "row"];
    head.extend(is_told.then_some("χ²/(N - p)"));
    head.extend(["ΔBIC", "misfit"]);
    let row = |estimate: &Estimate| {
        let [n, lo, hi] = exponent(estimate);
        let (scale, scale_error) = scale(estimate);
        let mut row = vec![
            estimate.family.id().to_owned(),
            cost_words(estimate.family.cost(estimate.n)),
            n,
            lo,
            hi,
            scale,
            scale_error,
            format!("{:.3e}", estimate.rms),
            format!("{:.2e}", estimate.worst.value),
            format!("{}°", short(estimate.worst.theta_deg)),
            estimate.worst.row.to_string(),
        ];
        let reduced = estimate.goodness.map_or("-".to_owned(), |goodness| ratio(goodness.reduced));
        row.extend(is_told.then_some(reduced));
        row.push(difference(found.behind(estimate)));
        row.push(estimate.trend.map_or("-", |trend| if trend.is_misfit() { "yes" } else { "no" }).to_owned());
        row
    };
    let head = head.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    let rows: Vec<Vec<String>> =
        std::iter::once(head.clone()).chain(found.estimates.iter().map(row)).collect();
    let widths: Vec<usize> =
        (0..head.len()).map(|i| rows.iter().map(|row| row[i].chars().count()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (i, (cell, width)) in row.iter().zip(&widths).enumerate() {
            let pad = " ".repeat(width - cell.chars().count());
            // Names stand at the left, numbers at the right.
            let _ = if i == 0 { write!(line, "{cell}{pad}") } else { write!(line, "  {pad}{cell}") };
        }
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text.push_str(
        "cost: operations from cos θ, d a division, t a transcendental; largest: sample less lobe; misfit: residuals of \
         neighbouring angles are alike\n",
    );
    text
}

fn verdict(found: &Comparison) -> String {
    let best = found.best();
    let others: Vec<&str> = found.as_good().skip(1).map(|estimate| estimate.family.id()).collect();
    let mut text = format!("best: {}", best.family);
    if !others.is_empty() {
        let _ = write!(
            text,
            "; not told apart from it by these samples (ΔBIC at most {INDISTINCT}): {}; cheapest of them: {}",
            others.join(", "),
            found.cheapest().family
        );
    } else if let Some(next) = found.estimates.get(1) {
        let apart = if found.is_told_apart() { ", told apart from the others: " } else { "; " };
        let behind = difference(found.behind(next));
        let _ = write!(text, "{apart}{} is next, {behind} behind in BIC", next.family);
    } else {
        text.push_str(", the only one fitted");
    }
    let doubts: Vec<String> = found.doubts().iter().map(ToString::to_string).collect();
    if !doubts.is_empty() {
        let _ = write!(text, "; not a final answer: {}", doubts.join("; "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_have_two_digits_and_numbers_as_many_decimals() {
        let both = |x, error| with_error(x, Some(error));
        assert_eq!(both(60.3123, 1.234), ("60.3".to_owned(), "1.2".to_owned()));
        assert_eq!(both(0.798_12, 0.006_12), ("0.7981".to_owned(), "0.0061".to_owned()));
        assert_eq!(both(60_312.3, 1234.0), ("60312".to_owned(), "1234".to_owned()));
        assert_eq!(both(3e-40, 1e-42), ("3.0000e-40".to_owned(), "1.0e-42".to_owned()));
        assert_eq!(with_error(60.3123, None), ("60.3123".to_owned(), String::new()));
    }

    #[test]
    fn a_difference_near_the_threshold_shows_its_side() {
        let shown = [0.0, 1.996, 2.0, 2.004, 2.000_01, 2.07, 104.2].map(difference);
        assert_eq!(shown, ["0.00", "2.00", "2.00", "2.004", "2.00001", "2.07", "104.20"]);
    }
}
