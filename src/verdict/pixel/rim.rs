//! What a texel on the ellipse's rim counts: three readings of "in proportion to the area cut off".

use super::super::judgement::{Finding, Verdict};
use super::{ratio, text};
use crate::bound::Interval;
use crate::integral::{Edge, Field};
use crate::paper::{ClipFormula, RimShare};

/// ∫_x^1 √(1 - X²) dX.
fn segment(x: Interval) -> Interval {
    let one = Interval::from(1.0);
    (x.arccos() - x * ((one - x) * (one + x)).sqrt()) / Interval::from(2.0)
}

/// The unit circle's area within the unit squares centred on (1, 0) and on (1, 1).
fn shares() -> (Interval, Interval) {
    let half = Interval::from(0.5);
    let edge = (Interval::from(3.0) / Interval::from(4.0)).sqrt();
    let two = Interval::from(2.0);
    // From X = ½ the circle is higher than the square up to √¾, and lower from there.
    let beside = edge - half + two * segment(edge);
    // Above Y = ½, from X = ½ to √¾.
    let corner = segment(half) - segment(edge) - half * (edge - half);
    (beside, corner)
}

/// Over the unit circle around the middle of a texel, which nine texels cover: 1 + 4 beside it + 4 at the
/// corners.
pub(super) fn texel(share: RimShare) -> Finding {
    let (one, four) = (Interval::from(1.0), Interval::from(4.0));
    let (beside, corner) = shares();
    match share {
        RimShare::Area => {
            // That areas add up is why it holds; the nine are a check of it.
            let sum = one + four * (beside + corner);
            let holds = sum.lo() <= Interval::PI.hi() && Interval::PI.lo() <= sum.hi();
            let verdict = if holds { Verdict::Proved } else { Verdict::Undecided };
            let witness = format!(
                "areas add up to the ellipse's; nine texels of the unit circle: 1 + 4 · {:.6} + 4 · {:.6} = π",
                beside.mid(),
                corner.mid()
            );
            Finding { printed: String::new(), computed: Some(sum), verdict, witness }
        }
        RimShare::HalfPlane => {
            // A straight edge through the middle of the texel on (1, 0), for the rim passes there.
            let half = Interval::from(0.5);
            let verdict = if beside.is_disjoint(half) { Verdict::Refuted } else { Verdict::Undecided };
            // Across the corner texel's diagonal, √2 - 1 from its middle: a triangle of that height.
            let diagonal = Interval::from(2.0).sqrt();
            let triangle = (diagonal / Interval::from(2.0) - (diagonal - one)).power(2);
            let sum = one + four * (half + triangle);
            let witness = format!(
                "unit circle, texel centred on its rim: 1/2, where the circle holds {:.6} of it; nine texels add up to \
                 {:.4}, not π",
                beside.mid(),
                sum.mid()
            );
            Finding { printed: String::new(), computed: Some(beside), verdict, witness }
        }
    }
}

/// A straight rim along a texel's side, ¼ from its middle, cuts off a quarter of its area.
pub(super) fn volume(formula: &ClipFormula) -> Finding {
    let quarter = ratio(1, 4);
    let value = formula.at(&quarter);
    let told = crate::bound::enclose(&value);
    let witness = format!("a straight rim at d = 1/4 cuts off 1/4 of the area, P(1/4) = {}", text(&value));
    Finding::truth(value == quarter, Some(told), witness)
}
