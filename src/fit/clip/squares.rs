//! Least squares of the clip volume's polynomial.

use super::ClipPixel;
use super::family::ClipFamily;
use crate::integral::GaussLegendre;
use core::f64::consts::FRAC_PI_2;
use nalgebra::{DMatrix, DVector};

/// Where the squares are summed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipPoints {
    /// So many of equal distance over [0, ½], both ends among them.
    Equidistant(u32),
    /// Integrated over [0, ½].
    Continuous,
}

impl ClipPoints {
    /// Those of the table.
    pub const ALL: [ClipPoints; 6] = [
        ClipPoints::Equidistant(6),
        ClipPoints::Equidistant(11),
        ClipPoints::Equidistant(21),
        ClipPoints::Equidistant(51),
        ClipPoints::Equidistant(101),
        ClipPoints::Continuous,
    ];

    /// The number of points, or `continuous`.
    pub fn id(self) -> String {
        match self {
            ClipPoints::Equidistant(n) => n.to_string(),
            ClipPoints::Continuous => "continuous".to_owned(),
        }
    }

    /// d and the weight of its square.
    pub(super) fn weighted(self) -> Vec<(f64, f64)> {
        match self {
            ClipPoints::Equidistant(n) => {
                let last = n.saturating_sub(1).max(1);
                (0..n).map(|i| (f64::from(i) / f64::from(2 * last), 1.0)).collect()
            }
            ClipPoints::Continuous => {
                // In d = ½ sin t, where volumes that end in a root of ½ - d are smooth.
                let half = 0.5 * FRAC_PI_2;
                let point = |(x, weight): (f64, f64)| {
                    let t = half * (1.0 + x);
                    (0.5 * libm::sin(t), half * weight * 0.5 * libm::cos(t))
                };
                GaussLegendre::new(64).pairs().map(point).collect()
            }
        }
    }
}

/// The polynomial of a family of least Σ (P(d) - volume(d))², by Householder QR; `None` for fewer points than
/// unknowns.
///
/// ```
/// use bellfit::fit::clip::{ClipFamily, ClipPixel, ClipPoints, ClipTarget, clip_least_squares};
/// let pixel = ClipPixel::new(ClipTarget::Gaussian(5.0)); // σ = 1/5
/// let family = ClipFamily::quadratic(false);
/// let p = clip_least_squares(&pixel, ClipPoints::Equidistant(11), family).expect("11 > 3");
/// // the digits of P10: 0.5 - 2.151 d + 2.358 d²
/// assert!((p[1] + 2.151).abs() < 5e-4 && (p[2] - 2.358).abs() < 5e-4);
/// ```
pub fn clip_least_squares(pixel: &ClipPixel, points: ClipPoints, family: ClipFamily) -> Option<[f64; 4]> {
    let values: Vec<(f64, f64, f64)> =
        points.weighted().into_iter().map(|(d, weight)| (d, weight, pixel.volume(d))).collect();
    weighted_squares(&values, family)
}

/// The same from (d, weight, value).
pub(super) fn weighted_squares(values: &[(f64, f64, f64)], family: ClipFamily) -> Option<[f64; 4]> {
    let basis = family.basis();
    if values.len() < basis.len() {
        return None;
    }
    let mut matrix = DMatrix::zeros(values.len(), basis.len());
    let mut target = DVector::zeros(values.len());
    for (i, &(d, weight, value)) in values.iter().enumerate() {
        let root = libm::sqrt(weight);
        for (j, b) in basis.iter().enumerate() {
            matrix[(i, j)] = root * super::at(*b, d);
        }
        target[i] = root * (value - super::at(family.offset(), d));
    }
    let qr = matrix.qr();
    qr.q_tr_mul(&mut target);
    let solution = qr.r().solve_upper_triangular(&target.rows(0, basis.len()).into_owned())?;
    let unknowns: Vec<f64> = solution.iter().copied().collect();
    unknowns.iter().all(|u| u.is_finite()).then(|| family.polynomial(&unknowns))
}
