//! Whether residuals look like noise.

use super::points::Points;

/// The lag-1 autocorrelation of the residuals over the angles: each angle's mean residual in units of its error with
/// that of the next angle.
///
/// Independent noise leaves it at 0 ± 1/√angles. Clearly above, the residuals follow one another: the lobe has
/// another shape than the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Between -1 and 1.
    pub correlation: f64,
    /// Different angles.
    pub angles: usize,
}

/// Errors above 0 from which a trend is a sign of misfit: once in 740 by chance.
const MISFIT: f64 = 3.0;
/// Fewer different angles have no trend to speak of, and none is looked for.
pub const FEW_ANGLES: usize = 20;

impl Trend {
    /// Whether it lies three errors above 0 and more.
    ///
    /// ```
    /// use bellfit::fit::measured::Trend;
    /// assert!(Trend { correlation: 0.5, angles: 100 }.is_misfit());
    /// assert!(!Trend { correlation: 0.2, angles: 100 }.is_misfit());
    /// ```
    pub fn is_misfit(&self) -> bool {
        self.correlation * (self.angles as f64).sqrt() > MISFIT
    }
}

/// The trend of the residuals, in the points' order.
pub(super) fn trend(points: &Points, square: f64, residuals: &[f64]) -> Option<Trend> {
    if points.angles < FEW_ANGLES || square <= points.rounding() {
        return None;
    }
    // Σ q r/√(Σ q) of each angle: of unit variance, up to the noise's factor.
    let mut means: Vec<f64> = Vec::with_capacity(points.angles);
    let (mut sum, mut weight) = (0.0, 0.0);
    for (i, r) in residuals.iter().enumerate() {
        let q = points.weight[i];
        (sum, weight) = (sum + q * r, weight + q);
        if points.versine.get(i + 1) != Some(&points.versine[i]) {
            means.push(sum / f64::sqrt(weight));
            (sum, weight) = (0.0, 0.0);
        }
    }
    let squares: f64 = means.iter().map(|m| m * m).sum();
    let products: f64 = means.windows(2).map(|pair| pair[0] * pair[1]).sum();
    (squares > 0.0).then(|| Trend { correlation: products / squares, angles: means.len() })
}
