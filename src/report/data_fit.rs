//! Lobes fitted to measured samples, for readers.

use super::number::short;
use crate::fit::measured::{CONFIDENCE, Comparison, Estimate, Family, INDISTINCT, Samples, Weighting};
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
             if they were noise; the ± above then says too little",
            best.family,
            short(trend.correlation),
            short(1.0 / (trend.angles as f64).sqrt())
        );
    }
    for estimate in &found.estimates {
        if let Err(reason) = estimate.uncertainty {
            let _ = writeln!(text, "{}: no uncertainty, as {reason}", estimate.family);
        }
    }
    for (family, reason) in &found.failures {
        let _ = writeln!(text, "{family}: not fitted, {reason}");
    }
    if samples.may_be_radians() {
        text.push_str(
            "every angle is below 1.571 degrees; if these are radians, name the column theta_rad\n",
        );
    }
    let noise = match found.weighting {
        Weighting::Equal => "of one variance, which the residuals tell",
        Weighting::Weight => "of variance s²/weight, s² from the residuals",
        Weighting::Sigma => "of the sigma given",
    };
    let _ = writeln!(
        text,
        "estimated; ± is half of a {:.0} % interval, if the family is right and the noise independent and {noise}",
        100.0 * CONFIDENCE
    );
    let _ = write!(text, "\n{}", data_fit_code(found.cheapest()));
    text
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

/// n and scale, each with half of its interval.
pub(super) fn parameters(estimate: &Estimate) -> [(String, String); 2] {
    let known = estimate.uncertainty.as_ref().ok();
    let half = |error: f64, quantile: f64| error * quantile;
    [
        with_error(estimate.n, known.map(|u| half(u.n, u.quantile()))),
        with_error(estimate.scale, known.map(|u| half(u.scale, u.quantile()))),
    ]
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
    let head = ["family", "cost", "n", "±", "scale", "±", "rms", "largest", "at", "row", "ΔBIC", ""];
    let rows = found.estimates.iter().map(|estimate| {
        let [(n, n_error), (scale, scale_error)] = parameters(estimate);
        [
            estimate.family.id().to_owned(),
            cost_words(estimate.family.cost(estimate.n)),
            n,
            n_error,
            scale,
            scale_error,
            format!("{:.3e}", estimate.rms),
            format!("{:.2e}", estimate.worst.value),
            format!("{}°", short(estimate.worst.theta_deg)),
            estimate.worst.row.to_string(),
            format!("{:.1}", found.behind(estimate)),
            if estimate.trend.is_some_and(|trend| trend.is_misfit()) { "misfit" } else { "" }.to_owned(),
        ]
    });
    let rows: Vec<[String; 12]> = std::iter::once(head.map(str::to_owned)).chain(rows).collect();
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
        "cost: operations from cos θ, d a division, t a transcendental; largest: sample less lobe\n",
    );
    text
}

fn verdict(found: &Comparison) -> String {
    let best = found.best();
    let others: Vec<&str> = found.as_good().skip(1).map(|estimate| estimate.family.id()).collect();
    let cheapest = found.cheapest();
    let mut text = format!("best: {}", best.family);
    if others.is_empty() {
        match found.estimates.get(1) {
            Some(next) => {
                let _ = write!(
                    text,
                    ", told apart from the others: {} is next, {:.1} behind in BIC",
                    next.family,
                    found.behind(next)
                );
            }
            None => text.push_str(", the only one fitted"),
        }
    } else {
        let _ = write!(
            text,
            "; not told apart from it by these samples (ΔBIC at most {INDISTINCT}): {}; cheapest of them: {}",
            others.join(", "),
            cheapest.family
        );
    }
    text
}

/// A few lines of Rust that compute the lobe at `cos`, in `f32`.
pub fn data_fit_code(estimate: &Estimate) -> String {
    let (family, n, scale) = (estimate.family, estimate.n as f32, estimate.scale as f32);
    let scale = format!("{scale:?}_f32");
    let function = |name: &str, path: &str| {
        format!("use bellfit::kernel::lobe::{path};\nlet value = {scale} * {name}(cos, {n:?});\n")
    };
    let lobe = |module: &str, name: &str, k: u32| {
        format!(
            "use bellfit::kernel::{module}::{name};\nlet lobe = {name}::<{k}, f32>::new({n:?}); // once a material\n\
             let value = {scale} * lobe.at(cos);\n"
        )
    };
    match family {
        Family::CosN => function("cos_n", "cos_n"),
        Family::Cs16 => function("cs_16", "cs_16"),
        Family::SphericalGaussian => function("spherical_gaussian", "spherical_gaussian"),
        Family::Schlick => function("schlick", "schlick"),
        Family::Linear2 => lobe("linear", "LinearLobe", 2),
        Family::Linear4 => lobe("linear", "LinearLobe", 4),
        Family::Linear8 => lobe("linear", "LinearLobe", 8),
        Family::Linear32 => lobe("linear", "LinearLobe", 32),
        Family::Cubic2 => lobe("cubic", "CubicLobe", 2),
        Family::Cubic4 => lobe("cubic", "CubicLobe", 4),
        Family::Cubic8 => lobe("cubic", "CubicLobe", 8),
        Family::Free2 => free(estimate, &scale, "p * p"),
        Family::Free4 => free(estimate, &scale, "(p * p) * (p * p)"),
        Family::Free8 => free(estimate, &scale, "(p * p) * (p * p) * ((p * p) * (p * p))"),
    }
}

fn free(estimate: &Estimate, scale: &str, power: &str) -> String {
    let Some(([k1, k2, k3], reach)) = estimate.family.horner(estimate.n, estimate.shape) else {
        return String::new();
    };
    let [k1, k2, k3, reach] = [k1, k2, k3, reach].map(|x| x as f32);
    format!(
        "let w = 1.0 - cos;\n\
         let p = if w < {reach:?} {{ 1.0 - w * ({k1:?} - w * ({k2:?} - w * {k3:?})) }} else {{ 0.0_f32 }};\n\
         let value = {scale} * {power};\n"
    )
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
}
