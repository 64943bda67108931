//! The report's part on what is better than printed: exact factors, factors that never gain energy, and
//! bells of the same cost.

use super::number::{short, short_up};
use super::plots::Plots;
use super::source::{source, source_alone};
use super::study::Study;
use crate::bound::Extremes;
use crate::fit::bell::{Cost, Shape};
use crate::fit::{FactorRow, Objective};
use crate::kernel::exact::{Support, cs_factor_cost};
use crate::kernel::model::Model;
use std::fmt::Write;

/// Every section of the part.
pub(super) fn sections(study: &Study, plots: &Plots<'_>, text: &mut String) {
    text.push_str("\n## The kernels and their frontier\n\n### Better bells for cosⁿ\n\n");
    text.push_str(&cosine(study));
    text.push_str(&source(&["fits/kernels-cosn.csv"]));
    let _ = write!(text, "\n{COSINE}");
    text.push_str(&plots.place(&["kernels", "kernels-over-n"]));
    cubic_factors(study, text);
    exact(text);
    factors(study, text);
    text.push_str(&plots.place(&["factors"]));
    shortest(study, text);
    exponential(study, text);
    text.push_str(&plots.place(&["kernels-error"]));
    text.push_str(DIRECTIONS);
}

const DIRECTIONS: &str = "\n### Drawing directions\n\n\
    `kernel::sampling`: `sample(u1, u2)` and `pdf` for the six models over cosⁿ and the bells (1 - t/K)^K, the \
    half vector's Jacobian included, 0 below the horizon. The own angle's distribution is inverted in closed \
    form (cosⁿ; bells per solid angle) or by a few Newton steps on a concave equation; χ² tests hold the samples to \
    the density, and planted wrong densities fail them.\n";

fn exact(text: &mut String) {
    text.push_str(
        "\n### Exact factors\n\n\
         The factor of the bell (1 - n w/K)^K on its true support is a closed expression for every real n ≥ 0 \
         (`kernel::exact::cs_factor`, K = 2 to 64), with a relative error below 16 ε (ε = 2⁻²³ in f32, 2⁻⁵² in f64). Where the \
         hemisphere cuts the support, below n = K (lobes in θ) or K/(1 - √½) (lobes in θ/2), a \
         second expression with positive terms takes over, as the first cancels there. Cost for K = 16, \
         operations + divisions:\n\n\
         | model | support inside the hemisphere | cut by it |\n|---|---|---|\n",
    );
    for model in Model::ALL {
        let cost = |support| {
            let cost = cs_factor_cost::<16>(model, support);
            format!("{} + {}", cost.operations, cost.divisions)
        };
        let _ = writeln!(text, "| {} | {} | {} |", model.title(), cost(Support::Inside), cost(Support::Cut));
    }
    text.push_str(&source(&["src/kernel/exact.rs"]));
}

fn span(Extremes { min, max }: &Extremes) -> String {
    format!("{} to {}", short(min.value.lo()), short(max.value.hi()))
}

/// What also makes a row of the factors.
const FIT: &str = "bellfit fit --model ... --form ... --objective ...";

fn is_the_papers(row: &FactorRow) -> bool {
    (row.range.from(), row.range.to()) == (16.0, 1024.0)
}

/// Whether the model's integrand is another's, in α for θ.
fn repeats(model: Model) -> bool {
    matches!(model, Model::BlinnPhongNdf | Model::BlinnPhongHeightfield)
}

fn factors(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Factors of cs_16: more forms, and never a gain\n\n\
         Over every real n of the range, on the lobe's true support. A form stands here where \
         its term more at least halves the largest residual. *One-sided*: 2π coef(n) Int(n) ≤ 1, proved, with the \
         least loss; it is the minimax factor over 1 + E, E its level. *Above the best*: how much its largest \
         |residual| (one-sided: its loss) may exceed what any factor of that form can do. Here n = 16..1024; the \
         file holds 16..∞ and 1..16 too, least squares and more, and `bellfit fit` any other range. The NDF's \
         factors are Phong's, the heightfield's those of Phong (modified).\n\n\
         | model | objective | factor | residual | above the best |\n|---|---|---|---|---|\n",
    );
    for row in &study.factors {
        let shown = matches!(row.objective, Objective::Minimax | Objective::OneSided) && is_the_papers(row);
        if !shown || repeats(row.model) {
            continue;
        }
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            row.model.id(),
            row.objective.id(),
            row.factor,
            span(&row.extremes),
            short(row.excess)
        );
    }
    text.push_str(&source_alone(&["fits/factors.csv"], FIT));
}

fn shortest(study: &Study, text: &mut String) {
    text.push_str(
        "\n### The shortest decimals that never gain\n\n\
         Of all pairs with so many significant digits the one of least loss that keeps 2π coef(n) Int(n) ≤ 1 for \
         every real n in 16..1024; the paper's 1.063 does not. One unit more in the last digit of a and energy is \
         gained.\n\n| model | digits | factor | largest loss |\n|---|---|---|---|\n",
    );
    for row in &study.factors {
        if row.objective == Objective::OneSidedRounded && is_the_papers(row) && !repeats(row.model) {
            let loss = short(0.0 - row.extremes.min.value.lo());
            let _ = writeln!(text, "| {} | {} | {} | {loss} |", row.model.id(), row.digits, row.factor);
        }
    }
    text.push_str(&source_alone(&["fits/factors.csv"], FIT));
}

fn exponential(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Better bells for e⁻ᵗ\n\n\
         p(t)^K, p = 1 - c₁ z + c₂ z² - c₃ z³, z = t/K, cut at its first zero; the error is \
         certified over all t ≥ 0. Degree 2 gains nothing as long as the bell is continuous: its best p tends to a \
         double zero, which is degree 1 at 2 K; only with a jump at the cut does it help.\n\n\
         | operations from t | shape | K | c₁, c₂, c₃ | largest error | at t | cut | continuous |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    let mut rows: Vec<_> = study.exponential.iter().filter(|row| row.shape != Shape::Double).collect();
    rows.sort_by(|a, b| {
        a.cost.from_t.cmp(&b.cost.from_t).then(b.error.value.hi().total_cmp(&a.error.value.hi()))
    });
    for row in rows {
        let [c1, c2, c3] = row.coefficients;
        let shape = if row.printed { "the papers'" } else { row.shape.id() };
        let _ = writeln!(
            text,
            "| {} | {shape} | {} | {c1}, {c2}, {c3} | {} | {} | {} | {} |",
            row.cost.from_t,
            row.power,
            short_up(row.error.value.hi()),
            short(row.error.at[0]),
            short(row.cut),
            if row.proof.continuous { "yes" } else { "no" }
        );
    }
    text.push_str(&source(&["fits/kernels.csv"]));
}

/// The bells for cosⁿ as a table and what it means: the README's block.
pub(super) fn kernels(study: &Study) -> String {
    format!("{}\n{COSINE}", cosine(study))
}

/// The bells for cosⁿ, a row each.
fn cosine(study: &Study) -> String {
    let mut text = String::from(
        "| lobe | operations from 1 - cos θ | from cos θ | where nothing fuses | largest error against cosⁿ | \
         against cs_16's |\n|---|---|---|---|---|---|\n",
    );
    let paper = study.cosine.iter().find(|row| row.printed).map_or(f64::NAN, |row| row.error.value.hi());
    for row in &study.cosine {
        let Cost { from_t, from_cos, unfused } = row.cost;
        let name = match (row.printed, row.shape) {
            (true, _) => "cs_16, the paper's".to_owned(),
            (_, Shape::Cubic) => format!("**cubic, K = {}**", row.formula.power),
            _ => format!("(1 - t/T)^{}, rescaled", row.formula.power),
        };
        let error = row.error.value.hi();
        let is_better = !row.printed && error < paper;
        let gain = if is_better { format!("{:.1} times less", paper / error) } else { String::new() };
        let _ =
            writeln!(text, "| {name} | {from_t} | {from_cos} | {unfused} | {} | {gain} |", short_up(error));
    }
    text
}

const COSINE: &str = "The largest error over every angle in [0, π/2] and every real n ≥ 16, n → ∞ included, proved; at n = 16 \
         cs_16 is cosⁿ itself. `fits/kernels-cosn.csv` has the bells' coefficients, (1 - y)(1 + α y + β y²) to the \
         K-th power with y = n (1 - cos θ)/T, where T, α and β are polynomials in 1/n. Each bell is continuous at its cut, falls to it and is never \
         negative, which is proved too. A fused multiply-add counts one, where nothing fuses two; what depends on n \
         alone is computed once a material.\n";

fn cubic_factors(study: &Study, text: &mut String) {
    text.push_str(
        "\n### Factors of the cubic bells, which never gain\n\n\
         coef(n) = (p₀ n + p₁ + p₂/n + p₃/n²)/(divisor π) for every real n ≥ 16 \
         (`kernel::factor::cubic_factor`).\n\n| lobe | model | factor | residual |\n|---|---|---|---|\n",
    );
    for row in study.cubic_factors.iter().filter(|row| !repeats(row.model)) {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            row.lobe,
            row.model.id(),
            row.factor,
            span(&row.extremes)
        );
    }
    text.push_str(&source(&["fits/factors.csv"]));
}
