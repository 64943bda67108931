//! Volume of a Gaussian pixel beyond a straight edge.

use crate::kernel::real::Real;

/// Radius of the paper's pixel, in pixels: half of its base diameter 1.
pub const RADIUS: f64 = 0.5;

/// Standard deviation of the paper's pixel, in pixels: a sixth of its base diameter, from σ1 = L/6.
pub const SIGMA: f64 = 1.0 / 6.0;

/// Digits of P(d) as the pixel paper prints them: c₀, c₁, c₂ of c₀ - d (c₁ - c₂ d).
///
/// ```
/// use bellfit::kernel::pixel::{CLIP_PRINTED, clip_volume_paper};
/// assert_eq!(clip_volume_paper(0.0), CLIP_PRINTED[0]);
/// ```
pub const CLIP_PRINTED: [f64; 3] = [0.5, 2.151, 2.358];

/// Volume beyond a line at distance d from its middle of a Gaussian pixel of volume 1, which is not cut.
///
/// ½ erfc(d/(σ √2)): the marginal of a Gaussian of revolution is the Gaussian in one dimension.
///
/// Source: pixel paper, (3); what P(d) may stand for.
///
/// - Domain: every d, σ > 0, in one unit (pixels); values in [0, 1]. d < 0: the middle is beyond the line, and
///   V(-d) = 1 - V(d). d = ±∞: 0 and 1.
/// - σ ≤ 0, σ = +∞ and NaN: NaN.
/// - Accuracy: relative error at most 4 u + 3 u (d/σ)², u = 2⁻²⁴ or 2⁻⁵³, the second from the rounding of the
///   argument, as long as V is a normal number (d/σ up to 12.9 or 37); absolute at most 2 u. By count from 2 ulp
///   of `libm`'s erfc (sampled).
///
/// ```
/// use bellfit::kernel::pixel::{SIGMA, clip_volume};
/// assert_eq!(clip_volume(0.0, SIGMA), 0.5);
/// // one standard deviation: the upper tail of the normal distribution
/// assert!((clip_volume(SIGMA, SIGMA) - 0.15865525393145705).abs() < 1e-16);
/// ```
#[inline]
pub fn clip_volume<F: Real>(d: F, sigma: F) -> F {
    if !(sigma > F::ZERO && sigma.is_finite()) {
        return F::NAN;
    }
    F::HALF * (d / sigma * F::HALF.sqrt()).erfc()
}

/// The same for the pixel cut at the rim of its base and normalised to volume 1.
///
/// V(d) = (1/π) ∫₀^α (e^(-d²/(2σ² cos²φ)) - E) dφ/(1 - E), E = e^(-r²/(2σ²)), cos α = d/r: in polar coordinates
/// the radius runs from d/cos φ to r. By x = tan φ it is Owen's T(h, a) = (1/2π) ∫₀^a e^(-h²(1 + x²)/2)/(1 + x²)
/// dx, at h = d/σ and a = tan α:
///
/// V = (2 T(h, a) - E α/π)/(1 - E), with T(h, a) + T(h a, 1/a) = ¼ - ¼ erf(h/√2) erf(h a/√2) where a > 1, and
/// for a ≤ 1 the series 2π T(h, a) = arctan a - Σ (-1)ʲ P_j a^(2j+1)/(2j + 1), P_j = 1 - e^(-y) Σ_{i≤j} yⁱ/i!,
/// y = h²/2 (D. B. Owen, Annals of Mathematical Statistics 27, 1956). No quadrature, no table.
///
/// - Domain: every d, σ > 0, radius > 0, in one unit (pixels); values in [0, 1]. d ≥ r: 0. d < 0: 1 - V(-d), so 1
///   from -r on. radius = +∞: [`clip_volume`]. σ = +∞: the segment of a flat disc, (α - sin α cos α)/π.
/// - σ ≤ 0, radius ≤ 0 and NaN: NaN.
/// - Accuracy: absolute error at most 8 u, u = 2⁻²⁴ or 2⁻⁵³, for every σ and r; sampled, 2.6 u met. Where V is
///   small the relative error is larger.
/// - Cost: 3 exponentials, 2 erf, 1 arctangent, and y + 15 terms or so of the series; 40 σ from the middle and
///   beyond, none.
///
/// ```
/// use bellfit::kernel::pixel::{RADIUS, SIGMA, clip_volume, clip_volume_cut};
/// assert_eq!((clip_volume_cut(0.0, SIGMA, RADIUS), clip_volume_cut(0.5, SIGMA, RADIUS)), (0.5, 0.0));
/// let (cut, whole) = (clip_volume_cut(0.25, SIGMA, RADIUS), clip_volume(0.25, SIGMA));
/// assert!(cut < whole && whole - cut < 0.01);
/// ```
pub fn clip_volume_cut<F: Real>(d: F, sigma: F, radius: F) -> F {
    if d.is_nan() || !(sigma > F::ZERO && radius > F::ZERO) {
        return F::NAN;
    }
    if d < F::ZERO {
        return F::ONE - clip_volume_cut(-d, sigma, radius);
    }
    if d >= radius {
        return if radius.is_finite() { F::ZERO } else { clip_volume(d, sigma) };
    }
    if !radius.is_finite() {
        return clip_volume(d, sigma);
    }
    // Of α, from quotients, which stay in the type's range whatever d and r are.
    let cos = d / radius;
    let sin = ((radius - d) / radius).sqrt() * (F::ONE + cos).sqrt();
    let alpha = sin.atan2(cos);
    // h/√2 and h a/√2: d and the chord's half length in the unit of erf.
    let (near, flat) = (d / sigma * F::HALF.sqrt(), radius / sigma * F::HALF.sqrt());
    let far = sin * flat;
    let rate = flat * flat;
    // Where e⁻ʳᵃᵗᵉ is 1 up to rounding the Gaussian is flat; its series would be quotients of subnormals.
    if F::ONE + rate == F::ONE {
        return (alpha - sin * cos) / F::PI;
    }
    // 1 - E, by which everything is divided: for wide Gaussians it is small, and so is what it divides.
    let volume = -(-rate).expm1();
    if sin <= cos {
        // arctan a = α, and E α goes into it.
        return ((alpha - series(sin / cos, near * near) / volume) / F::PI).max(F::ZERO);
    }
    // The same with ¼ - ¼ erf erf - T(h a, 1/a), and β = π/2 - α.
    let beta = cos.atan2(sin);
    let corner = F::HALF * near.erf() * far.erf() - series(cos / sin, far * far) / F::PI;
    F::HALF - beta / F::PI - corner / volume
}

/// Σ (-1)ʲ P_j(y) a^(2j+1)/(2j + 1) for 0 ≤ a ≤ 1: arctan a less 2π Owen's T(√(2y), a).
fn series<F: Real>(a: F, y: F) -> F {
    // T is below e⁻ʸ/8 there, under half an ulp of V.
    if y > F::from_u32(40) {
        return a.atan2(F::ONE);
    }
    let square = a * a;
    // yʲ e⁻ʸ/j!, and what is beyond it in the Poisson distribution.
    let mut weight = (-y).exp();
    let mut beyond = -(-y).expm1();
    let mut power = a;
    let mut sum = F::ZERO;
    // Past j = y the weights fall, and past 3 y + 30 they are below rounding.
    for j in 0..160_u32 {
        let next = sum + beyond * power / F::from_u32(2 * j + 1);
        if next == sum {
            break;
        }
        sum = next;
        weight = weight * y / F::from_u32(j + 1);
        beyond = beyond - weight;
        power = -(power * square);
    }
    sum
}

/// P(d) as the pixel paper prints it: 0.5 - d (2.151 - 2.358 d), the digits in [`CLIP_PRINTED`].
///
/// - Domain: d in pixels, 0 ≤ d ≤ ½, where it falls from ½ to 0.0095 at d = 0.4561 and rises to 0.014 again.
///   Elsewhere the parabola as it is, above ½ for d < 0 and beyond 0.9122: the paper says nothing of it.
/// - ±∞: +∞. NaN: NaN.
///
/// ```
/// use bellfit::kernel::pixel::{SIGMA, clip_volume, clip_volume_paper};
/// let d = 0.25_f64;
/// assert_eq!(clip_volume_paper(d), 0.5 - d * (2.151 - 2.358 * d));
/// assert!((clip_volume_paper(d) - clip_volume(d, SIGMA)).abs() < 0.05);
/// ```
#[inline]
pub fn clip_volume_paper<F: Real>(d: F) -> F {
    let [c0, c1, c2] = CLIP_PRINTED.map(F::from_f64);
    c0 - d * (c1 - c2 * d)
}
