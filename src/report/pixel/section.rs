//! The pixel paper's tables in the report.

use super::constants::{ADOPTED, adopted};
use super::footprint::footprint_rows;
use super::{MOST_POINTS, PixelStudy};
use crate::fit::clip::{ClipObjective, ClipPoints, ClipRow, ClipTarget, clip_printed};
use crate::fit::weight_name;
use crate::kernel::pixel::PixelWeight;
use crate::report::number::{short, short_up};
use crate::report::plots::Plots;
use crate::report::source::source;
use std::fmt::Write;

/// A heading a study, with its figures or where they stand.
pub(in crate::report) fn section(study: &PixelStudy, plots: &Plots<'_>, text: &mut String) {
    clip(study, text);
    text.push_str(&plots.place(&["clip-volume"]));
    axes(text);
    text.push_str(&plots.place(&["pixel-axes", "pixel-ellipses", "pixel-tilts"]));
    weights(study, text);
    text.push_str(&plots.place(&["pixel-bells"]));
    texels(study, text);
    text.push_str(&plots.place(&["pixel-weights"]));
}

/// `σ = 1/6`, or nothing.
fn sigma(target: ClipTarget) -> String {
    match target {
        ClipTarget::Gaussian(s) if s == libm::round(s) => format!(", σ = 1/{s}"),
        ClipTarget::GaussianCut(m) => format!(", σ = 1/{m}"),
        _ => target.sigma().map_or(String::new(), |s| format!(", σ = {s}")),
    }
}

fn polynomial([p0, p1, p2, p3]: [f64; 4], digits: usize) -> String {
    let term = |c: f64, power: &str| {
        let sign = if c < 0.0 { '-' } else { '+' };
        if c == 0.0 { String::new() } else { format!(" {sign} {:.digits$} {power}", c.abs()) }
    };
    format!("{p0:.digits$}{}{}{}", term(p1, "d"), term(p2, "d²"), term(p3, "d³"))
}

fn constant(half: bool) -> &'static str {
    if half { "½" } else { "free" }
}

fn points(points: ClipPoints) -> String {
    match points {
        ClipPoints::Equidistant(n) => format!("{n} points"),
        ClipPoints::Continuous => "integral".to_owned(),
    }
}

fn clip(study: &PixelStudy, text: &mut String) {
    let [_, p1, p2, _] = clip_printed();
    let lowest = -p1 / (2.0 * p2);
    let at_lowest = 0.5 + 0.5 * p1 * lowest;
    let _ = write!(
        text,
        "\n### The volume beyond a line\n\n\
         P(d) = 0.5 - d (2.151 - 2.358 d) is to be the volume of the pixel beyond a line at distance d from its centre, in \
         units of the pixel's base diameter. P falls to {} at d = {} and rises again, to {} at the base. \
         Errors are certified over every d in [0, ½].\n\n",
        short(at_lowest),
        short(lowest),
        short(0.5 + 0.5 * p1 + 0.25 * p2)
    );
    recipes(study, text);
    text.push_str("\n| pixel | largest error of the printed P | at d | least squares, 11 points, p₀ free | rounds to the printed digits |\n|---|---|---|---|---|\n");
    for target in ClipTarget::ALL {
        let of =
            |is: &dyn Fn(&ClipRow) -> bool| study.clip.iter().find(|row| row.target == target && is(row));
        let printed = of(&|row| row.objective == ClipObjective::Printed);
        let fitted = of(&|row| {
            (row.objective, row.points, row.half)
                == (ClipObjective::Squares, Some(ClipPoints::Equidistant(11)), Some(false))
        });
        let (Some(printed), Some(fitted)) = (printed, fitted) else { continue };
        let _ = writeln!(
            text,
            "| {}{} | {} | {} | {} | {} |",
            target.id(),
            sigma(target),
            short_up(printed.error),
            short(printed.at),
            polynomial(fitted.coefficients, 5),
            if fitted.digits { "yes" } else { "no" }
        );
    }
    text.push_str(&source(&["fits/clip.csv"]));
    for (objective, what) in
        [(ClipObjective::NearestSup, "largest error"), (ClipObjective::NearestSquares, "mean square")]
    {
        if let Some(row) = study.clip.iter().find(|row| row.objective == objective) {
            let sigma = row.target.sigma().unwrap_or(f64::NAN);
            let _ = writeln!(
                text,
                "\nThe whole Gaussian nearest to the printed P in {what} has σ = {} (estimated): there P is at most {} off, \
                 at d = {}.",
                short(sigma),
                short_up(row.error),
                short(row.at)
            );
        }
    }
    better(study, text);
}

/// The search for the printed digits, and the σ that would give them.
fn recipes(study: &PixelStudy, text: &mut String) {
    let targets = ClipTarget::ALL.len();
    let _ = write!(
        text,
        "Of the least-squares quadratics to {targets} pixels on 3 to {MOST_POINTS} equidistant points of [0, ½], p₀ free or \
         ½, these round to the printed digits:\n\n"
    );
    for recipe in &study.recipes {
        let _ = writeln!(
            text,
            "- **{}{}, {} points, p₀ {}: {}**",
            recipe.target.id(),
            sigma(recipe.target),
            recipe.points,
            constant(recipe.half),
            polynomial(recipe.coefficients, 6)
        );
    }
    if study.recipes.is_empty() {
        text.push_str("- none\n");
    }
    text.push_str(
        "\nThe paper states σ = L/6, which is 1/6 of the base diameter; P itself it quotes from another source, whose σ it does \
         not give. Left open, these σ would print p₁ and p₂ (sampled):\n\n\
         | least squares | p₀ | σ that prints p₁ | σ that prints p₂ | both |\n|---|---|---|---|---|\n",
    );
    for row in &study.sigmas {
        let range = |(lo, hi): (f64, f64)| format!("{lo:.5} to {hi:.5}");
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            points(row.points),
            constant(row.half),
            range(row.linear),
            range(row.square),
            row.both().map_or("none".to_owned(), range)
        );
    }
    text.push_str(&source(&["src/report/pixel", "fits/clip.csv"]));
}

fn better(study: &PixelStudy, text: &mut String) {
    text.push_str(
        "\nFor the paper's σ = 1/6 (adopted: `kernel::constants::CLIP_MINIMAX`). *Falling*: never rising, 0 at the base, so never \
         negative.\n\n\
         | polynomial | p₀ | largest error | at d | falls |\n|---|---|---|---|---|\n",
    );
    let rows = study.clip.iter().filter(|row| {
        row.target == ClipTarget::Gaussian(6.0)
            && matches!(
                row.objective,
                ClipObjective::Printed | ClipObjective::Minimax | ClipObjective::Falling
            )
    });
    for row in rows {
        let is_adopted = ADOPTED.iter().any(|&(objective, degree, half, _)| {
            adopted(study, objective, degree, half).is_some_and(|found| std::ptr::eq(found, row))
        });
        let name = match (row.objective, row.degree) {
            (ClipObjective::Printed, _) => "as printed",
            (ClipObjective::Falling, 2) => "quadratic, falling",
            (ClipObjective::Falling, _) => "cubic, falling",
            (_, 2) => "quadratic, minimax",
            _ => "cubic, minimax",
        };
        let _ = writeln!(
            text,
            "| {name}{}: {} | {} | {} | {} | {} |",
            if is_adopted { " (adopted)" } else { "" },
            polynomial(row.coefficients, 5),
            row.half.map_or("0.5", constant),
            short_up(row.error),
            short(row.at),
            if row.monotone { "yes" } else { "no" }
        );
    }
    text.push_str(&source(&["fits/clip.csv", "src/kernel/constants.rs"]));
}

fn axes(text: &mut String) {
    text.push_str(
        "\n### The axes of the footprint\n\n\
         (10) reduces to L² = 4 (Ux² + Vx²), and d² likewise: the paper's axes are twice the lengths of the two derivative \
         vectors. Those are conjugate semi-diameters of the pixel's image, its axes only where they are at right angles. \
         With φ the angle between them (`kernel::pixel::Skew` holds the closed forms and their proofs):\n\n\
         - the major axis is too short, by a factor of √2 at most (equal vectors, φ → 0);\n\
         - the minor axis is too long, without bound as φ → 0;\n\
         - the area is 1/|sin φ| of the true one;\n\
         - arctan(Vx/Ux), the first vector's direction, is off by less than 45° where the first vector is not the \
         shorter one, and by up to 90° else;\n\
         - ½ arctan(B/(A - C)) is the true tilt where that lies within ±45°, and 90° off elsewhere: for half of all \
         directions.\n\n\
         Half lengths in units of the first vector, which lies along the u axis:\n\n\
         | φ | second by first | major, paper | true | minor, paper | true | area, paper by true | tilt error of the vector | of the conic |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    let shown = |degrees: f64, ratio: f64| {
        [15.0, 30.0, 60.0, 85.0].contains(&degrees) && [0.5, 1.0, 2.0].contains(&ratio)
    };
    for row in footprint_rows().iter().filter(|row| shown(row.degrees, row.ratio)) {
        let angle = |error: Option<f64>| error.map_or(String::new(), |degrees| format!("{degrees:.2}°"));
        let _ = writeln!(
            text,
            "| {}° | {} | {:.4} | {:.4} | {:.4} | {:.4} | {:.4} | {} | {} |",
            row.degrees,
            row.ratio,
            row.paper.0,
            row.axes.major,
            row.paper.1,
            row.axes.minor,
            row.area,
            angle(row.vector_error),
            angle(row.conic_error)
        );
    }
    text.push_str(&source(&["fits/footprint.csv"]));
}

fn weights(study: &PixelStudy, text: &mut String) {
    text.push_str(
        "\n### The weight of a texel\n\n\
         Against the Gaussian of σ = L/6, e^(-9Q/2) with Q = (2 u₁/L)² + (2 v₁/d)². Errors are certified, \
         over every Q ≥ 0 and over the ellipse Q ≤ 1; on its rim the Gaussian is e^-4.5 = 0.0111. `sum` is one bell of Q, \
         `product` one of u₁ times one of v₁; `bell-K` is Lyon's (1 - t/K)^K, `cubic-K` the cubic one, t = 9Q/2. Volume by the \
         Gaussian's; operations from Q, or from both squares.\n\n\
         | weight | largest error | at Q | within the ellipse | on the rim | volume | operations |\n|---|---|---|---|---|---|---|\n",
    );
    for row in &study.weights {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} |",
            row.name,
            short_up(row.plane.value),
            short(row.plane.q),
            short_up(row.ellipse.value),
            short_up(row.rim),
            short(row.volume),
            row.operations
        );
    }
    text.push_str(&source(&["fits/pixel-weights.csv"]));
    let of = |name: &str| study.weights.iter().find(|row| row.name == name);
    let readings = ["r1-sum", "r2-sum", "r3-sum", "r4-sum", "cubic-4"].map(of);
    if let [Some(r1), Some(r2), Some(r3), Some(r4), Some(cubic)] = readings {
        let _ = writeln!(
            text,
            "\nNo reading is both 0 on the ellipse and near the Gaussian of σ = L/6: R1 ends there and is {} off; R2, (8) with \
             n = 1/σ² in place of the printed 8, ends at Q = 16/9 and is {} off. With n = 8 as printed R1, R3 and R4 are \
             left, of which R3 is nearest, {} off, and R4 {}. So R1 is meant if the ellipse is to be the pixel's base, \
             R2 or R3 if P4's σ is: the print does not decide. The cubic bell of {} operations is {} off.",
            short_up(r1.plane.value),
            short_up(r2.plane.value),
            short_up(r3.plane.value),
            short_up(r4.plane.value),
            cubic.operations,
            short_up(cubic.plane.value)
        );
    }
}

fn texels(study: &PixelStudy, text: &mut String) {
    let gaussian = study.texels.iter().filter(|texel| matches!(texel.weight, PixelWeight::Gaussian(_)));
    let inside: Vec<_> = gaussian.collect();
    let _ = write!(
        text,
        "\n### The texels of the figure\n\n\
         The ellipse of diagonals 6 and 3, tilted by 30°, its centre on a texel's, holds the centres of {} texels. \
         The middle one has this share of the whole weight:\n\n| weight | share |\n|---|---|\n",
        inside.len()
    );
    for texel in study.texels.iter().filter(|texel| (texel.u, texel.v) == (0, 0)) {
        let _ = writeln!(text, "| {} | {:.4} |", weight_name(texel.weight), texel.share);
    }
    text.push_str(&source(&["fits/weights.csv"]));
}
