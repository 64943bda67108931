//! What was met of an error, in the units in which budgets are stated.

use crate::exact::Exact;
use bellfit::kernel::real::Real;

/// The largest error in units of u = 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`) times the scale that the budget's row states.
pub struct Seen {
    /// Half an ulp at 1.
    unit: f64,
    /// The largest.
    pub error: f64,
    /// Where.
    pub at: Vec<f64>,
    /// How many were looked at.
    pub count: usize,
}

impl Seen {
    pub fn new<F: Real>() -> Self {
        let single = F::from_f64(1.0 + f64::EPSILON) == F::ONE;
        let unit = if single { f64::from(f32::EPSILON) / 2.0 } else { f64::EPSILON / 2.0 };
        Seen { unit, error: 0.0, at: vec![], count: 0 }
    }

    /// |value - exact|/(u scale); what is not finite counts as infinite, and an error at scale 0 too.
    pub fn of<F: Real>(&mut self, value: F, exact: Exact, scale: f64, at: &[f64]) {
        self.off((crate::exact::x(value) - exact).abs().to_f64(), scale, at);
    }

    /// Relative to the exact value.
    pub fn relative<F: Real>(&mut self, value: F, exact: Exact, at: &[f64]) {
        self.of(value, exact, exact.abs().to_f64(), at);
    }

    pub fn off(&mut self, error: f64, scale: f64, at: &[f64]) {
        let error = if error == 0.0 { 0.0 } else { error / (self.unit * scale) };
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.count += 1;
        if error > self.error {
            (self.error, self.at) = (error, at.to_vec());
        }
    }
}
