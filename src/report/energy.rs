//! The report's part on energy at every angle.

use super::number::short;
use super::plots::Plots;
use super::source::source;
use super::study::Study;
use crate::integral::albedo::{AlbedoCurve, Reflectance, SupremumEvidence};
use std::fmt::Write;

/// The section.
pub(super) fn section(study: &Study, plots: &Plots<'_>, text: &mut String) {
    text.push_str(
        "\n## Energy at every angle\n\n\
         Directional albedo a(θ): what the eye at θ sees of a surface lit by 1 from the whole hemisphere \
         (in the files angles are in degrees from the normal, and `use` is `printed` or, with V-cavities, `microfacet`). For the unmodified RDFs the \
         factor times the lobe is f cos θ, for the modified ones it is f; an NDF stands once as printed, for the \
         share of its normalisation that this direction sees, and once as the D of a microfacet model with F = 1 \
         and V-cavities. *Bounded*: a theorem allows no more at any angle, so the value along the normal (or at \
         grazing) is the largest; the values themselves are quadrature.\n\n\
         Largest albedo over the angles, and over n = 16, 64, 256, 1024:\n\n",
    );
    let mut subjects: Vec<String> = Vec::new();
    for curve in &study.albedos {
        if !subjects.contains(&name(curve)) {
            subjects.push(name(curve));
        }
    }
    let _ = writeln!(text, "| model | reciprocal | {} |", subjects.join(" | "));
    let _ = writeln!(text, "|---|---|{}", "---|".repeat(subjects.len()));
    for of in Reflectance::ALL {
        let reciprocal = if of.is_reciprocal() { "yes" } else { "no" };
        let _ = write!(text, "| {} | {reciprocal} |", of.title());
        for subject in &subjects {
            let curves = study.albedos.iter().filter(|c| c.reflectance == of && name(c) == *subject);
            let highest = curves.map(|c| c.supremum.at.value.value).fold(0.0, f64::max);
            // Seven digits: a gain of 1e-6 shows, the quadrature's rounding does not.
            let _ = write!(text, " {highest:.6} |");
        }
        text.push('\n');
    }
    text.push_str(&source(&["fits/albedo-suprema.csv", "fits/albedo.csv"]));
    let bounded = study.albedos.iter().filter(|c| c.supremum.evidence == SupremumEvidence::Bounded).count();
    let error = study.albedos.iter().flat_map(|c| &c.points).map(|p| p.value.error).fold(0.0, f64::max);
    let all = study.albedos.len();
    let which =
        if bounded == all { format!("All {all}") } else { format!("{bounded} of {all}, the others sampled") };
    let _ = writeln!(
        text,
        "\nSuprema that are bounded: {which}; the largest stated error is {}. A factor that \
         meets its condition of Table 1 exactly gains at no angle, whatever the model; the unmodified RDFs are not \
         reciprocal, so theirs is the energy seen from θ, not that reflected of a beam from θ.",
        short(error)
    );
    text.push_str(&plots.place(&["albedo-16", "albedo-64", "albedo-difference"]));
}

fn name(curve: &AlbedoCurve) -> String {
    format!("{}, {}", curve.lobe, curve.factor)
}
