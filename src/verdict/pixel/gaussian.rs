//! The Gaussian pixel (3) and its base.

use super::super::judgement::{Finding, compare};
use super::axis_by_sigma;
use crate::bound::{Interval, enclose};
use crate::integral::Field;
use crate::paper::{Printed, Region, Relation};
use dashu_ratio::RBig;

/// e^(-a²/2) with a the semi-axis by σ: the share of (3) that lies beyond the ellipse, for in elliptical
/// polar coordinates dV = e^(-ρ²/2) ρ dρ; and the height on its rim by that in the middle.
fn beyond(divisor: &Printed) -> Interval {
    let axis = enclose(&axis_by_sigma(divisor));
    (-(axis.power(2) / Interval::from(2.0))).exp()
}

pub(super) fn volume(divisor: &Printed, region: Region) -> Finding {
    let one = Printed { text: "1".to_owned(), value: RBig::ONE, lowest: RBig::ONE, highest: RBig::ONE };
    let (volume, witness) = match region {
        Region::Plane => {
            let text = "1/(2π σ1 σ2) · 2π σ1 σ2 ∫_0^∞ e^(-ρ²/2) ρ dρ = 1 for every σ1, σ2".to_owned();
            (Interval::from(1.0), text)
        }
        Region::Ellipse => {
            let share = beyond(divisor);
            let text = format!("{:.4e} of it lies beyond the ellipse", share.mid());
            (Interval::from(1.0) - share, text)
        }
    };
    let verdict = compare(volume, &one, Relation::Equal);
    Finding { printed: one.text, computed: Some(volume), verdict, witness }
}

pub(super) fn beyond_base(divisor: &Printed) -> Finding {
    let share = beyond(divisor);
    let witness = format!(
        "e^(-a²/2), a = {} semi-axes by σ: of the volume beyond the ellipse, and of the height on its rim",
        super::text(&axis_by_sigma(divisor))
    );
    Finding::figure(share, witness)
}
