//! What a scene needs and does not need, for readers.

use super::choice::{choice_lines, need_words};
use super::number::short_up;
use crate::choose::{Costs, MaterialAnswer, SceneAnswer, SurfaceAnswer};
use std::fmt::Write;

/// A scene's answer: what it does not need first, then each material's kernels and each surface's bounds.
pub fn scene_choice_lines(answer: &SceneAnswer, costs: &Costs<'_>) -> String {
    let mut text = String::from("what the scene does not need\n");
    let sentences = not_needed(answer);
    if sentences.is_empty() {
        text.push_str("  it needs all of it\n");
    }
    for sentence in sentences {
        let _ = writeln!(text, "  {sentence}");
    }
    if !answer.materials.is_empty() {
        text.push_str("\nmaterials\n");
    }
    for material in &answer.materials {
        let _ = writeln!(text, "  {}: {}", material.name, summary(material));
    }
    let common = match (answer.materials.len(), answer.common) {
        (0 | 1, _) => String::new(),
        (_, Some(stand_in)) => format!("  one kernel for all of them: {}\n", stand_in.id()),
        (_, None) => "  no one kernel does for all of them\n".to_owned(),
    };
    text.push_str(&common);
    if !answer.surfaces.is_empty() {
        text.push_str(
            "\nsurfaces (but for the pyramid against the ellipse's Gaussian, with texels taken as fine beside it)\n",
        );
    }
    for surface in &answer.surfaces {
        text.push_str(&surface_lines(surface));
    }
    for material in &answer.materials {
        let _ = write!(text, "\n{}\n{}", material.name, choice_lines(&material.answer, costs));
    }
    text
}

fn summary(material: &MaterialAnswer) -> String {
    match material.answer.best() {
        Some(best) if material.within_cost => {
            let id = best.stand_in.id();
            format!("{id}, error at most {}", best.bound.map_or_else(String::new, short_up))
        }
        Some(best) => format!("{} would do, and is beyond the budget's cost", best.stand_in.id()),
        None => format!("nothing qualifies: {}", need_words(&material.answer.need)),
    }
}

/// One sentence for each thing, with its bound.
pub(super) fn not_needed(answer: &SceneAnswer) -> Vec<String> {
    let mut sentences = Vec::new();
    for material in &answer.materials {
        if let (Some(squarings), Some(best)) = (material.by_squarings(), material.answer.best()) {
            let bound = squarings.bound.map_or_else(String::new, short_up);
            let operations = squarings.cost.operations;
            let as_cheap = if best.stand_in == squarings.stand_in { "cheapest" } else { "as cheap as any" };
            sentences.push(format!(
                "{}: no stand-in; cosⁿ by squarings is exact but for rounding, at most {bound}, and {as_cheap} at {operations} operations",
                material.name
            ));
        }
    }
    for answer in &answer.surfaces {
        let surface = &answer.surface;
        for part in answer.parts.iter().filter(|part| part.dispensable && part.bound < 1.0) {
            let (name, bound) =
                (&surface.name, if part.bound > 0.0 { short_up(part.bound) } else { "0".into() });
            let sentence = match part.id.as_str() {
                "pyramid" => format!(
                    "{name}: no pyramid; no derivative exceeds a texel (the longest is {}), so trilinear filtering is bilinear, exactly",
                    surface.shape.longest
                ),
                "anisotropy" => format!(
                    "{name}: no anisotropy; aspect at most {}, {}, changes a colour by at most {bound}",
                    short_up(surface.shape.aspect()),
                    part.instead
                ),
                _ => format!(
                    "{name}: no true axes; skew at most {}°, {} change a colour by at most {bound}",
                    short_up_or_zero(surface.shape.skew * (180.0 / std::f64::consts::PI)),
                    part.instead
                ),
            };
            sentences.push(sentence);
        }
        if let Some(weight) = answer.weight().filter(|weight| weight.bound < 1.0) {
            sentences.push(format!(
                "{}: no exponential; the weight {} changes a colour by at most {}, in {} operations from t = Q/(2σ²)",
                surface.name,
                weight.id,
                short_up(weight.bound),
                weight.operations.unwrap_or(0)
            ));
        }
    }
    sentences
}

fn short_up_or_zero(x: f64) -> String {
    if x > 0.0 { short_up(x) } else { "0".to_owned() }
}

fn surface_lines(answer: &SurfaceAnswer) -> String {
    let surface = &answer.surface;
    let mut text = format!("  {}: a colour may change by at most {}\n", surface.name, surface.max_error);
    let within_a_texel = answer.surface.shape.longest <= 1.0;
    for part in answer.parts.iter().take(if within_a_texel { 1 } else { usize::MAX }) {
        let word = if part.dispensable { "within" } else { "beyond" };
        let bound = if part.bound >= 1.0 { "1".to_owned() } else { short_up_or_zero(part.bound) };
        let _ = writeln!(text, "    no {:<15} at most {bound}, {word}: {}", part.id, part.instead);
    }
    if within_a_texel {
        text.push_str("    of the others nothing is claimed within a texel\n");
        return text;
    }
    for weight in &answer.weights {
        let word = if weight.dispensable { "within" } else { "beyond" };
        let _ = writeln!(text, "    weight {:<11} at most {}, {word}", weight.id, short_up(weight.bound));
        if weight.dispensable {
            break;
        }
    }
    let fits = if answer.together_fits() { "within" } else { "beyond" };
    let _ =
        writeln!(text, "    axes and weight together at most {}, {fits}", short_up_or_zero(answer.together));
    text
}
