//! Vectors of three components, as far as a lobe needs them.
//!
//! Sums and products are the plain expressions in component order: NaN and infinities go through as
//! IEEE 754 has it, and lengths beyond the type's range overflow. Only [`normalize`] guards itself.

use super::real::Real;

/// Three Cartesian components.
pub type Vec3<F> = [F; 3];

/// Dot product a·b = a₀b₀ + a₁b₁ + a₂b₂.
///
/// NaN in a component: NaN.
///
/// ```
/// use bellfit::kernel::vector::dot;
/// assert_eq!(dot([1.0_f64, 2.0, 3.0], [4.0, 5.0, 6.0]), 1.0 * 4.0 + 2.0 * 5.0 + 3.0 * 6.0);
/// ```
#[inline]
pub fn dot<F: Real>(a: Vec3<F>, b: Vec3<F>) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Product s v = (s v₀, s v₁, s v₂) with a number.
///
/// ```
/// use bellfit::kernel::vector::scale;
/// assert_eq!(scale(2.0_f64, [1.0, -2.0, 3.0]), [2.0, -4.0, 6.0]);
/// ```
#[inline]
pub fn scale<F: Real>(s: F, v: Vec3<F>) -> Vec3<F> {
    [s * v[0], s * v[1], s * v[2]]
}

/// Sum a + b = (a₀ + b₀, a₁ + b₁, a₂ + b₂).
///
/// ```
/// use bellfit::kernel::vector::add;
/// assert_eq!(add([1.0_f64, 2.0, 3.0], [4.0, 5.0, 6.0]), [5.0, 7.0, 9.0]);
/// ```
#[inline]
pub fn add<F: Real>(a: Vec3<F>, b: Vec3<F>) -> Vec3<F> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Difference a - b = (a₀ - b₀, a₁ - b₁, a₂ - b₂).
///
/// ```
/// use bellfit::kernel::vector::sub;
/// assert_eq!(sub([1.0_f64, 2.0, 3.0], [4.0, 6.0, 8.0]), [-3.0, -4.0, -5.0]);
/// ```
#[inline]
pub fn sub<F: Real>(a: Vec3<F>, b: Vec3<F>) -> Vec3<F> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Versine of the angle between two unit vectors, without the cancellation of 1 - a·b.
///
/// w = 1 - cos θ = |a - b|²/2, what the `_versine` lobes take.
///
/// Source: |a - b|² = 2 - 2 a·b for |a| = |b| = 1. Values in [0, 2]; for other lengths it is half the square
/// of the gap. Relative error a few ε/√w from the vectors' own rounding. NaN in a component: NaN.
///
/// ```
/// use bellfit::kernel::vector::versine_between;
/// assert_eq!(versine_between([1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0]), 1.0);
/// let near = versine_between([0.0_f64, 0.0, 1.0], [1e-9, 0.0, 1.0]);
/// assert!((near / 0.5e-18 - 1.0).abs() < 1e-15); // 1 - a·b would be 0
/// ```
#[inline]
pub fn versine_between<F: Real>(a: Vec3<F>, b: Vec3<F>) -> F {
    let gap = sub(a, b);
    F::HALF * dot(gap, gap)
}

/// Unit vector v/|v|, |v| = √(v·v); `None` for the zero vector and where a component is NaN or infinite.
///
/// Every finite nonzero length is served: the largest component is divided out first, so that squares
/// neither overflow nor vanish.
///
/// ```
/// use bellfit::kernel::vector::normalize;
/// let length = libm::sqrt(3.0 * 3.0 + 4.0 * 4.0);
/// let unit = normalize([3.0_f64, 0.0, -4.0]).unwrap();
/// assert!((unit[0] - 3.0 / length).abs() < 1e-15 && (unit[2] + 4.0 / length).abs() < 1e-15);
/// assert_eq!(normalize([0.0_f32; 3]), None);
/// ```
#[inline]
pub fn normalize<F: Real>(v: Vec3<F>) -> Option<Vec3<F>> {
    let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
    // Real::max hands a NaN on, so one look at the largest sees every component.
    if !(largest > F::ZERO && largest.is_finite()) {
        return None;
    }
    let v = v.map(|x| x / largest);
    let length = dot(v, v).sqrt();
    Some(v.map(|x| x / length))
}

/// Mirror direction of l about the unit vector n.
///
/// R = 2 (L·N) N - L.
///
/// Source: Phong's reflection vector as the lobe paper states it. n is not normalised here, and l may
/// have any length, which is kept. NaN in a component: NaN in all three.
///
/// ```
/// use bellfit::kernel::vector::reflect;
/// let (l, n) = ([0.6_f64, 0.0, 0.8], [0.0, 0.0, 1.0]);
/// assert_eq!(reflect(l, n), [-0.6, 0.0, 2.0 * 0.8 - 0.8]);
/// ```
#[inline]
pub fn reflect<F: Real>(l: Vec3<F>, n: Vec3<F>) -> Vec3<F> {
    sub(scale(F::TWO * dot(l, n), n), l)
}

/// Half vector between the unit vectors l and v.
///
/// H = (L + V)/|L + V|; `None` where it has no direction: L = -V exactly, or a component NaN or
/// infinite. Nearly opposite vectors give a unit vector whose direction is mostly rounding.
///
/// Source: Blinn's half vector as the lobe paper states it.
///
/// ```
/// use bellfit::kernel::vector::half_vector;
/// let h = half_vector([1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
/// assert!((h[0] - 1.0 / libm::sqrt(2.0)).abs() < 1e-15 && h[0] == h[1]);
/// assert_eq!(half_vector([1.0_f64, 0.0, 0.0], [-1.0, 0.0, 0.0]), None);
/// ```
#[inline]
pub fn half_vector<F: Real>(l: Vec3<F>, v: Vec3<F>) -> Option<Vec3<F>> {
    normalize(add(l, v))
}

/// Two unit vectors that complete a unit vector a to a right-handed orthonormal basis.
///
/// With s = -1 for a_z < 0, else 1, and q = -1/(s + a_z): (1 + s q a_x², s q a_x a_y, -s a_x) and
/// (q a_x a_y, s + q a_y², -a_y).
///
/// Source: T. Duff et al., "Building an Orthonormal Basis, Revisited", Journal of Computer Graphics
/// Techniques 6(1), 2017, after J. R. Frisvad, 2012, whose form loses every digit near a = -z.
///
/// - Domain: unit vectors. a is not normalised here; another length gives vectors that are neither unit
///   nor orthogonal. NaN in a component: NaN in both.
/// - Accuracy: |s + a_z| ≥ 1, so nothing cancels: lengths and dot products within 4 u of 1 and 0 on top
///   of a's own rounding, u = 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`); sampled. The basis jumps where a_z = 0.
/// - Cost: 1 division, about a dozen multiplications and additions.
///
/// ```
/// use bellfit::kernel::vector::basis;
/// assert_eq!(basis([0.0_f64, 0.0, 1.0]), ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
/// assert_eq!(basis([0.0_f64, 0.0, -1.0]), ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]));
/// let (s, q, x, y) = (1.0_f64, -1.0 / (1.0 + 6.0 / 7.0), 2.0 / 7.0, 3.0 / 7.0);
/// let (tangent, _) = basis([x, y, 6.0 / 7.0]);
/// assert_eq!(tangent, [1.0 + s * (q * x) * x, s * ((q * x) * y), -s * x]);
/// ```
#[inline]
pub fn basis<F: Real>(unit: Vec3<F>) -> (Vec3<F>, Vec3<F>) {
    let [x, y, z] = unit;
    let s = if z < F::ZERO { -F::ONE } else { F::ONE };
    let q = -F::ONE / (s + z);
    let (qx, qy) = (q * x, q * y);
    ([F::ONE + s * (qx * x), s * (qx * y), -s * x], [qx * y, s + qy * y, -y])
}
