//! How much of a texel's square is inside the ellipse: what texels on the rim count.

use super::{Footprint, Row};
use crate::kernel::real::Real;

/// Area of the unit square about (u, v) that is inside the ellipse Q ≤ 1, (u, v) in texels from its middle.
///
/// Source: pixel paper, "in proportion to the area the ellipse cuts off", read to the letter. The square is
/// cut by the axes through the ellipse's middle into at most four rectangles, so that no arc exceeds half of
/// the ellipse. In each the area is that of the polygon of corners inside and crossings with the edges, in
/// coordinates of the square, and of the elliptic segments beyond its chords: √det M (θ - sin θ)/2, θ between
/// the chord's ends on the unit circle that the ellipse is the image of. Sectors from the middle would be as
/// exact but cancel for a texel that is small beside the ellipse.
///
/// - Values in [0, 1]; exactly 1 where all four corners have Q ≤ 1, exactly 0 where the square and the ellipse
///   are apart.
///   A degenerate footprint: 0. NaN in the footprint, u or v: NaN.
/// - Domain: u, v up to 2²² in `f32` and 2⁵¹ in `f64`, so that the corners are exact; the footprint's own.
/// - Accuracy: absolute error at most 8 u (1 + major), u = 2⁻²⁴ or 2⁻⁵³, the part with the major semi-axis from
///   the rounding of M, whose rim is known no better; sampled, 3.2 u (1 + major) met.
/// - Cost: three roots for each of four edges, sixteen edges about the middle, and an arctangent or a series an
///   arc. For texels on the rim, not for every one.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, coverage};
/// let circle = |radius: f64| {
///     Footprint::of(Jacobian { ux: radius, vx: 0.0, uy: 0.0, vy: radius }, Padding::Plain)
/// };
/// assert_eq!((coverage(&circle(1.0), 0.0, 0.0), coverage(&circle(1.0), 3.0, 0.0)), (1.0, 0.0));
/// let quarter = std::f64::consts::PI / 4.0; // a quarter of the unit circle, from its middle
/// assert!((coverage(&circle(1.0), 0.5, 0.5) - quarter).abs() < 1e-15);
/// assert!((coverage(&circle(0.25), 0.0, 0.0) - quarter * 0.25).abs() < 1e-15);
/// ```
pub fn coverage<F: Real>(footprint: &Footprint<F>, u: F, v: F) -> F {
    let (u0, u1, v0, v1) = (u - F::HALF, u + F::HALF, v - F::HALF, v + F::HALF);
    let q = |u: F, v: F| footprint.q(u, v);
    let largest = q(u0, v0).max(q(u1, v0)).max(q(u0, v1)).max(q(u1, v1));
    if largest.is_nan() {
        return F::NAN;
    }
    if largest <= F::ONE {
        return F::ONE;
    }
    let ellipse = Ellipse::of(footprint);
    let mut sum = F::ZERO;
    for [u0, u1] in halves(u0, u1).into_iter().flatten() {
        for [v0, v1] in halves(v0, v1).into_iter().flatten() {
            sum = sum + ellipse.area([u0, u1], [v0, v1]);
        }
    }
    sum.max(F::ZERO).min(F::ONE)
}

/// An interval cut at 0.
fn halves<F: Real>(from: F, to: F) -> [Option<[F; 2]>; 2] {
    if from < F::ZERO && to > F::ZERO {
        [Some([from, F::ZERO]), Some([F::ZERO, to])]
    } else {
        [Some([from, to]), None]
    }
}

/// An end of an edge's part inside.
#[derive(Clone, Copy)]
struct End<F> {
    /// From the rectangle's first corner.
    u: F,
    v: F,
    /// Where the map to the unit circle takes it: onto the circle, or inside for a corner of the rectangle.
    image: [F; 2],
}

/// Both ways of completing the square, and the turn between their unit circles.
struct Ellipse<F> {
    rows: Footprint<F>,
    columns: Footprint<F>,
    /// √det M.
    scale: F,
    /// √(det M/(uu vv)) and uv/√(uu vv): the cosine and sine of the turn.
    turn: [F; 2],
}

impl<F: Real> Ellipse<F> {
    fn of(footprint: &Footprint<F>) -> Self {
        let scale = footprint.determinant.sqrt();
        let (width, height) = footprint.bounds();
        let turn = [scale / width / height, footprint.uv / width / height];
        Ellipse { rows: *footprint, columns: footprint.swapped(), scale, turn }
    }

    /// Area in the rectangle, which reaches across neither axis.
    fn area(&self, u: [F; 2], v: [F; 2]) -> F {
        let mut ends: [Option<[End<F>; 2]>; 4] = [None; 4];
        for (edge, ends) in ends.iter_mut().enumerate() {
            *ends = self.edge(edge, u, v);
        }
        let mut sides = ends.into_iter().flatten();
        let Some(first) = sides.next() else { return F::ZERO };
        let mut area = F::ZERO;
        let mut last = first[1];
        for [from, to] in sides.chain([first]) {
            area = area + last.twice_triangle(&from) + from.twice_triangle(&to);
            // The arc from where an edge leaves the ellipse to where the next enters it; at a corner inside
            // both are the corner, and the segment is 0.
            area = area + self.scale * segment(last.image, from.image);
            last = to;
        }
        F::HALF * area
    }

    /// The part inside of an edge: bottom, right, top and left, anticlockwise.
    fn edge(&self, edge: usize, [u0, u1]: [F; 2], [v0, v1]: [F; 2]) -> Option<[End<F>; 2]> {
        let along_u = edge.is_multiple_of(2);
        let (offset, from, to) = match edge {
            0 => (v0, u0, u1),
            1 => (u1, v0, v1),
            2 => (v1, u0, u1),
            _ => (u0, v0, v1),
        };
        let of = if along_u { &self.rows } else { &self.columns };
        let Row { middle, least, curvature } = of.row(offset);
        // On the circle the edge is the chord at height b, from -a to a.
        let b = offset / of.vv.sqrt();
        let inside = F::ONE - least;
        if inside <= F::ZERO {
            return None;
        }
        let (a, half) = (inside.sqrt(), (inside / curvature).sqrt());
        let (low, high) = (middle - half, middle + half);
        if !(low < to && high > from) {
            return None;
        }
        let end = |place: F, a: F| {
            if along_u {
                End { u: place - u0, v: offset - v0, image: [a, b] }
            } else {
                End { u: offset - u0, v: place - v0, image: self.turned([a, b]) }
            }
        };
        let corner = |place: F| end(place, (place - middle) / half * a);
        let first = if low > from { end(low, -a) } else { corner(from) };
        let second = if high < to { end(high, a) } else { corner(to) };
        Some(if edge < 2 { [first, second] } else { [second, first] })
    }

    /// A point on the circle of the columns, (along v, along u), on that of the rows.
    fn turned(&self, [a, b]: [F; 2]) -> [F; 2] {
        let [cos, sin] = self.turn;
        [cos * b - sin * a, sin * b + cos * a]
    }
}

impl<F: Real> End<F> {
    /// Twice the signed area of the triangle with the first corner.
    fn twice_triangle(&self, to: &Self) -> F {
        self.u * to.v - self.v * to.u
    }
}

/// θ - sin θ of the angle between two points on the unit circle, at most π: twice the area beyond the chord.
fn segment<F: Real>([ax, ay]: [F; 2], [bx, by]: [F; 2]) -> F {
    let (dx, dy) = (bx - ax, by - ay);
    let square = F::from_f64(0.25) * (dx * dx + dy * dy);
    if square > F::from_f64(0.25) {
        let sin = F::cross(ax, ay, bx, by).abs();
        return sin.atan2(ax * bx + ay * by) - sin;
    }
    // With s = sin(θ/2) it is 2 arcsin s - 2 s √(1 - s²) = 4 Σ C(2k, k) 4⁻ᵏ s^(2k+3)/(2k + 3), which does not
    // cancel; s² ≤ ¼, so a term is less than a quarter of the one before.
    let mut power = F::from_u32(4) * square * square.sqrt();
    let mut sum = F::ZERO;
    for k in 0..32_u32 {
        let next = sum + power / F::from_u32(2 * k + 3);
        if next == sum {
            break;
        }
        sum = next;
        power = power * square * (F::from_u32(2 * k + 1) / F::from_u32(2 * k + 2));
    }
    sum
}

/// The tangent of the ellipse beside a texel, to first order.
///
/// √Q grows along its gradient g = M⁻¹x/√Q from its value at x = (u, v), so the rim √Q = 1 is near the line at
/// the signed distance (1 - √Q)/|g| from x along the unit normal g/|g|. It is the rim's tangent where x is on
/// it; |g|⁻¹ is the local width of √Q, so the distance is exact for a circle and along the axes.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, Tangent};
/// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
/// let tangent = Tangent::of(&Footprint::of(j, Padding::Plain), 2.75, 0.0);
/// assert!((tangent.distance - 0.25).abs() < 1e-15); // the rim is at 3
/// assert_eq!((tangent.nu, tangent.nv), (1.0, 0.0));
/// assert!((tangent.area() - 0.75).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent<F> {
    /// From the texel's centre outwards to the rim, in texels; negative for a centre outside.
    pub distance: F,
    /// Unit normal, outwards: along u.
    pub nu: F,
    /// Along v.
    pub nv: F,
}

impl<F: Real> Tangent<F> {
    /// Beside the texel centred at x = (u, v) from the middle: distance = (1 - √Q) √Q/|M⁻¹x|, normal M⁻¹x/|M⁻¹x|.
    ///
    /// At the middle itself no direction is nearest: the distance is +∞ and the normal 0. A degenerate
    /// footprint: -∞ and 0. NaN in the footprint, u or v: NaN. Accuracy: Q is off by u times the aspect, the
    /// normal by u times its square near the ends of the major axis: `u - middle` cancels, and the gradient
    /// across is that much steeper than along.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, Tangent};
    /// let circle = Footprint::of(Jacobian { ux: 5.0_f64, vx: 0.0, uy: 0.0, vy: 5.0 }, Padding::Plain);
    /// let tangent = Tangent::of(&circle, 6.0, -8.0);
    /// assert!((tangent.distance + 5.0).abs() < 1e-14);
    /// assert!((tangent.nu - 0.6).abs() + (tangent.nv + 0.8).abs() < 1e-15);
    /// ```
    pub fn of(footprint: &Footprint<F>, u: F, v: F) -> Self {
        let row = footprint.row(v);
        let off = u - row.middle;
        let root = (row.least + row.curvature * off * off).sqrt();
        if root == F::ZERO || root == F::INFINITY {
            let distance = if root == F::ZERO { F::INFINITY } else { -F::INFINITY };
            return Tangent { distance, nu: F::ZERO, nv: F::ZERO };
        }
        // M⁻¹x, halves of the derivatives of Q.
        let du = row.curvature * off;
        let dv = v / footprint.vv - footprint.uv / footprint.vv * du;
        let length = du.hypot(dv);
        Tangent { distance: (F::ONE - root) * root / length, nu: du / length, nv: dv / length }
    }

    /// Area of the unit square about the texel's centre on the inner side of the line, in [0, 1].
    ///
    /// ½ at distance 0; 1 and 0 beyond (|nu| + |nv|)/2. Absolute error 4 u, u = 2⁻²⁴ or 2⁻⁵³; by count. NaN:
    /// NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Tangent;
    /// let tangent = Tangent { distance: -0.5_f64, nu: 0.6, nv: 0.8 };
    /// // a corner is left: a right triangle of height 0.2 over its hypotenuse
    /// assert!((tangent.area() - 0.2 * 0.2 / (2.0 * 0.6 * 0.8)).abs() < 1e-15);
    /// ```
    pub fn area(self) -> F {
        let (a, b) = (self.nu.abs().max(self.nv.abs()), self.nu.abs().min(self.nv.abs()));
        let distance = self.distance.abs();
        if distance.is_nan() || a.is_nan() {
            return F::NAN;
        }
        // What is cut off on the far side: a triangle, or a trapezium across the square.
        let corner = F::HALF * (a + b);
        let cut = if distance >= corner {
            F::ZERO
        } else if distance >= F::HALF * (a - b) {
            let height = corner - distance;
            // a ≥ 1/√2; height/b ≤ 1 here
            F::HALF * (height / a) * (height / b)
        } else {
            F::HALF - distance / a
        };
        if self.distance > F::ZERO { F::ONE - cut } else { cut }
    }
}

/// Area of the unit square about (u, v) on the ellipse's side of its [`Tangent`]: [`coverage`] without arcs.
///
/// Source: pixel paper, the second reading of "in proportion to the area the ellipse cuts off". Domain, middle,
/// degenerate and NaN as [`Tangent::of`]: 1 in the middle, whatever the ellipse's size, 0 for a degenerate
/// footprint. Beside [`coverage`] it is too large by the sagitta of the rim: for a large circle of radius r on its
/// rim by 1/(24 r) along the axes to √2/(12 r) on the diagonals. Absolute error at most 8 u (1 + major) times the
/// square of the aspect, u = 2⁻²⁴ or 2⁻⁵³, from the normal: in `f32` nothing is left from 2000 or so. Sampled,
/// 2.6 of it met.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, coverage, half_plane};
/// let circle = Footprint::of(Jacobian { ux: 8.0_f64, vx: 0.0, uy: 0.0, vy: 8.0 }, Padding::Plain);
/// let (exact, line) = (coverage(&circle, 8.0, 0.0), half_plane(&circle, 8.0, 0.0));
/// assert!((line - 0.5).abs() < 1e-15);
/// assert!(line - exact > 0.0 && line - exact < 1.0 / 64.0);
/// ```
#[inline]
pub fn half_plane<F: Real>(footprint: &Footprint<F>, u: F, v: F) -> F {
    Tangent::of(footprint, u, v).area()
}
