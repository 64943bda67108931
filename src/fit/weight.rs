//! The pixel weights beside one another: error against the Gaussian of σ = 1/3, volume, cost; and the
//! weights of the paper's figure.

use super::bell::{Cost, operations};
use crate::bound::{BellTerms, Interval, WeightRegion};
use crate::integral::Field;
use crate::kernel::constants::CUBIC_EXP;
use crate::kernel::pixel::{Axes, PaperReading, PixelWeight};
use core::f64::consts::{FRAC_PI_6, PI};

/// σ of the pixel paper as a fraction of the semi-axis: L/6 of L/2.
const SIGMA: f64 = 1.0 / 3.0;
/// The proofs' tolerance, absolute.
const TOLERANCE: f64 = 1e-9;

/// A largest |Gaussian - weight|, proved, with the Q where it is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightError {
    /// An upper bound, within the tolerance of what is reached.
    pub value: f64,
    /// Q there.
    pub q: f64,
}

/// A weight against e^(-9Q/2).
#[derive(Clone, Debug, PartialEq)]
pub struct WeightRow {
    /// The name in files.
    pub name: String,
    /// Over every Q ≥ 0.
    pub plane: WeightError,
    /// Over Q ≤ 1.
    pub ellipse: WeightError,
    /// On Q = 1, where the Gaussian is e^-4.5 = 0.0111.
    pub rim: f64,
    /// Volume over the plane by the Gaussian's.
    pub volume: f64,
    /// Operations from Q, or from a² and b² for a product; constants folded beforehand.
    pub operations: u32,
}

/// The name of a weight in files.
pub fn weight_name(weight: PixelWeight<f64>) -> String {
    let reading = |reading: PaperReading| match reading {
        PaperReading::R1 => "r1",
        PaperReading::R2 => "r2",
        PaperReading::R3 => "r3",
        PaperReading::R4 => "r4",
    };
    match weight {
        PixelWeight::Gaussian(_) => "gaussian".to_owned(),
        PixelWeight::Paper(r) => format!("{}-sum", reading(r)),
        PixelWeight::PaperProduct(r) => format!("{}-product", reading(r)),
        PixelWeight::Box => "box".to_owned(),
        PixelWeight::Bell(k, _) => format!("bell-{k}"),
        PixelWeight::Cubic(k, _) => format!("cubic-{k}"),
    }
}

/// Every weight of the table: the paper's readings as sum and as product, Lyon's bells, the cubic ones.
pub fn pixel_weights() -> Vec<PixelWeight<f64>> {
    let mut all: Vec<_> = PaperReading::ALL.map(PixelWeight::Paper).to_vec();
    all.extend(PaperReading::ALL.map(PixelWeight::PaperProduct));
    all.extend([2, 4, 8, 16, 32, 64].map(|k| PixelWeight::Bell(k, SIGMA)));
    all.extend([2, 4, 8].map(|k| PixelWeight::Cubic(k, SIGMA)));
    all
}

/// p of a weight's max(p, 0)^K in z = 9Q/(2K); none for the Gaussian and the box, which have none.
fn terms(weight: PixelWeight<f64>) -> Option<BellTerms> {
    let zero = Interval::from(0.0);
    let straight = |power: u32, slope: Interval| BellTerms { power, terms: [slope, zero, zero] };
    match weight {
        // 1 - c Q = 1 - (16 c/9) z, c exact in binary.
        PixelWeight::Paper(r) | PixelWeight::PaperProduct(r) => {
            Some(straight(8, Interval::from(16.0 * r.scale::<f64>()) / Interval::int(9)))
        }
        PixelWeight::Bell(k, _) => Some(straight(k, Interval::from(1.0))),
        PixelWeight::Cubic(k, _) => {
            let row = CUBIC_EXP.get((k.trailing_zeros() as usize).wrapping_sub(1))?;
            Some(BellTerms { power: k, terms: row.map(Interval::from) })
        }
        PixelWeight::Gaussian(_) | PixelWeight::Box => None,
    }
}

/// The table of [`pixel_weights`].
///
/// ```
/// use bellfit::fit::weight_rows;
/// let rows = weight_rows();
/// // R3, (1 - Q/2)^8, has the volume of the Gaussian: 1/(9c) against 2/9
/// assert!(rows.iter().any(|row| row.name == "r3-sum" && (row.volume - 1.0).abs() < 1e-14));
/// ```
pub fn weight_rows() -> Vec<WeightRow> {
    let row = |weight: PixelWeight<f64>| {
        let terms = terms(weight)?;
        let found = |region: WeightRegion| {
            let of = |terms: BellTerms| {
                let found = terms.distance(region, TOLERANCE);
                WeightError { value: found.value.hi(), q: found.at[0] }
            };
            let axis = of(terms);
            if weight.is_radial() {
                return axis;
            }
            // At one Q a product takes the values from (1 - c Q)^8, on an axis, to (1 - c Q/2)^16, on a
            // diagonal: with the sum of two factors given it is largest where they are equal.
            let diagonal = of(BellTerms { power: 2 * terms.power, ..terms });
            if diagonal.value > axis.value { diagonal } else { axis }
        };
        let degree = if matches!(weight, PixelWeight::Cubic(..)) { 3 } else { 1 };
        let Cost { from_t, .. } = operations(degree, terms.power, false);
        let (plane, ellipse) = (found(WeightRegion::Plane), found(WeightRegion::Ellipse));
        Some(WeightRow {
            name: weight_name(weight),
            // What bounds the plane bounds its part.
            ellipse: WeightError { value: ellipse.value.min(plane.value), ..ellipse },
            plane,
            rim: found(WeightRegion::Rim).value,
            volume: volume(weight, &terms),
            // Two bells and their product.
            operations: if weight.is_radial() { from_t } else { 2 * from_t + 1 },
        })
    };
    pixel_weights().into_iter().filter_map(row).collect()
}

/// ∫ weight by ∫ e^(-9Q/2) over the plane: for (1 - cQ)^K it is 9/(2c(K + 1)); for products the square of
/// 2/√c ∏ 2j/(2j + 1), j = 1..K, by 2π/9; for the cubic bells, by Gauss-Legendre quadrature, exact up to
/// rounding for their degree 3K.
fn volume(weight: PixelWeight<f64>, terms: &BellTerms) -> f64 {
    let k = terms.power;
    match weight {
        PixelWeight::Paper(r) => 4.5 / (r.scale::<f64>() * f64::from(k + 1)),
        PixelWeight::PaperProduct(r) => {
            let half: f64 = (1..=k).map(|j| f64::from(2 * j) / f64::from(2 * j + 1)).product();
            4.0 * half * half / r.scale::<f64>() * 4.5 / PI
        }
        PixelWeight::Cubic(..) => {
            // The zero of p in z, between 0 and 4, by bisection.
            let [c1, c2, c3] = terms.terms.map(Interval::mid);
            let p = |z: f64| 1.0 - z * (c1 - z * (c2 - z * c3));
            let (mut lo, mut hi) = (0.0, 4.0);
            for _ in 0..60 {
                let mid = 0.5 * (lo + hi);
                if p(mid) > 0.0 { lo = mid } else { hi = mid }
            }
            let rule = crate::integral::GaussLegendre::new(13);
            // ∫ weight dt, t = K z, against ∫ e⁻ᵗ dt = 1.
            rule.integrate(|z| p(z).power(k), 0.0, lo) * f64::from(k)
        }
        _ => f64::from(k) / f64::from(k + 1),
    }
}

/// The ellipse of the pixel paper's figure: diagonals 6 and 3, tilted by 30°.
pub const FIGURE_AXES: Axes<f64> = Axes { major: 3.0, minor: 1.5, tilt: FRAC_PI_6 };

/// The weight of one texel in that ellipse.
#[derive(Clone, Debug, PartialEq)]
pub struct TexelWeight {
    /// Which weight.
    pub weight: PixelWeight<f64>,
    /// Column, from the ellipse's centre.
    pub u: i32,
    /// Row.
    pub v: i32,
    /// Q there.
    pub q: f64,
    /// The weight, 1 in the middle.
    pub value: f64,
    /// By the sum over the texels inside.
    pub share: f64,
}

/// The weights of the texels inside [`FIGURE_AXES`], whose centre is a texel's: the Gaussian of (3) and the
/// readings of (9), as sum and as product, and the cubic bell of K = 4.
pub fn figure_weights() -> Vec<TexelWeight> {
    let frame = FIGURE_AXES.frame();
    let mut weights = vec![PixelWeight::Gaussian(SIGMA)];
    weights.extend(PaperReading::ALL.map(PixelWeight::Paper));
    weights.extend(PaperReading::ALL.map(PixelWeight::PaperProduct));
    weights.push(PixelWeight::Cubic(4, SIGMA));
    let mut rows = Vec::new();
    for weight in weights {
        let first = rows.len();
        for v in -3..=3 {
            for u in -3..=3 {
                let (a, b) = frame.coordinates(f64::from(u), f64::from(v));
                let (aa, bb) = (a * a, b * b);
                if aa + bb <= 1.0 {
                    let value = weight.at(aa, bb);
                    rows.push(TexelWeight { weight, u, v, q: aa + bb, value, share: 0.0 });
                }
            }
        }
        let sum: f64 = rows[first..].iter().map(|row| row.value).sum();
        for row in &mut rows[first..] {
            row.share = row.value / sum;
        }
    }
    rows
}
