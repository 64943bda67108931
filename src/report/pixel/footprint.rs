//! The grid of footprints whose axes are compared.

use crate::kernel::pixel::{Axes, Padding, Skew, TiltFormula};

/// Angles between the derivative vectors, in degrees: beyond 90° lengths repeat and tilts change sign.
const DEGREES: [f64; 17] =
    [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 75.0, 85.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0];
/// Ratios of the second vector's length to the first's.
const RATIOS: [f64; 9] = [0.125, 0.25, 0.5, 0.75, 1.0, 1.25, 2.0, 4.0, 8.0];

/// A footprint's axes, half lengths in units of the first vector.
pub(super) struct FootprintRow {
    pub(super) degrees: f64,
    pub(super) ratio: f64,
    /// The longer and the shorter of the paper's.
    pub(super) paper: (f64, f64),
    pub(super) axes: Axes<f64>,
    pub(super) area: f64,
    /// Degrees between the formula's direction and the major axis; none for a circle.
    pub(super) vector_error: Option<f64>,
    pub(super) conic_error: Option<f64>,
}

/// A line's angle to another, in [0°, 90°].
fn between(a: f64, b: f64) -> f64 {
    let turned = (a - b).to_degrees().abs();
    // Directions repeat every 180°.
    let rest = turned - 180.0 * libm::round(turned / 180.0);
    rest.abs()
}

/// Every footprint of the grid, the first vector along the u axis.
pub(super) fn footprint_rows() -> Vec<FootprintRow> {
    let mut rows = Vec::new();
    for ratio in RATIOS {
        for degrees in DEGREES {
            let skew = Skew { angle: degrees.to_radians(), ratio };
            let j = skew.jacobian();
            let axes = Axes::of(j, Padding::Plain);
            let (first, second) = j.lengths();
            let circle = ratio == 1.0 && degrees == 90.0;
            let error = |formula: TiltFormula| (!circle).then(|| between(formula.angle(j), axes.tilt));
            rows.push(FootprintRow {
                degrees,
                ratio,
                paper: (first.max(second), first.min(second)),
                axes,
                area: skew.area(),
                vector_error: error(TiltFormula::Vector),
                conic_error: error(TiltFormula::Conic),
            });
        }
    }
    rows
}
