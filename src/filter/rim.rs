//! Texels on the rim, texel by texel in double precision: for study, not for speed.

use super::placed::Placed;
use super::scan::Sum;
use super::{Rim, Texture, Wrap};
use crate::kernel::pixel::{Footprint, Frame, PixelWeight};

/// The pixel's volume beyond a line at distance d from its centre, P(d) = 0.5 - d (2.151 - 2.358 d).
fn volume(d: f64) -> f64 {
    0.5 - d * (2.151 - 2.358 * d)
}

/// The weight in double precision.
fn double(weight: PixelWeight<f32>) -> PixelWeight<f64> {
    match weight {
        PixelWeight::Gaussian(sigma) => PixelWeight::Gaussian(f64::from(sigma)),
        PixelWeight::Paper(reading) => PixelWeight::Paper(reading),
        PixelWeight::PaperProduct(reading) => PixelWeight::PaperProduct(reading),
        PixelWeight::Box => PixelWeight::Box,
        PixelWeight::Bell(k, sigma) => PixelWeight::Bell(k, f64::from(sigma)),
        PixelWeight::Cubic(k, sigma) => PixelWeight::Cubic(k, f64::from(sigma)),
    }
}

/// Semi-axes along `tilt`, or along the ellipse's own axes.
fn frame(footprint: &Footprint<f64>, tilt: Option<f64>) -> Frame<f64> {
    let Footprint { uu, uv, vv, .. } = *footprint;
    let tilt = tilt.unwrap_or_else(|| 0.5 * libm::atan2(2.0 * uv, uu - vv));
    let (sin, cos) = (libm::sin(tilt), libm::cos(tilt));
    let major = (uu * cos * cos + 2.0 * uv * cos * sin + vv * sin * sin).sqrt();
    Frame { cos, sin, major, minor: footprint.determinant.sqrt() / major }
}

/// Sums over every texel that the rim lets count.
pub(super) fn careful(
    level: &Texture,
    wrap: Wrap,
    placed: &Placed,
    weight: PixelWeight<f32>,
    tilt: Option<f64>,
    rim: Rim,
) -> Sum {
    let footprint = &placed.footprint;
    let (weight, frame) = (double(weight), frame(footprint, tilt));
    let [fx, fy] = placed.fraction.map(f64::from);
    // A square that the rim cuts has its centre within half a texel of the box.
    let border = if rim == Rim::None { 1e-5 } else { 0.5 };
    let (_, height) = footprint.bounds();
    let height = height + border;
    let mut sum = Sum::default();
    for k in (fy - 0.5 - height).ceil() as i64..=(fy - 0.5 + height).floor() as i64 {
        let v = k as f64 + 0.5 - fy;
        let y = wrap.index(placed.texel[1] + k, level.height());
        // The row's part of the ellipse that has no rim and its square's shadow.
        let low = (v.abs() - border).max(0.0);
        let reach =
            (footprint.determinant * (1.0 - (low * low / footprint.vv).min(1.0)) / footprint.vv).sqrt();
        let lean = footprint.uv / footprint.vv;
        let (from, to) = (v - border, v + border);
        let left = (from * lean).min(to * lean) - reach - border;
        let right = (from * lean).max(to * lean) + reach + border;
        for i in (fx - 0.5 + left).ceil() as i64..=(fx - 0.5 + right).floor() as i64 {
            let u = i as f64 + 0.5 - fx;
            let q = footprint.q(u, v);
            let share = match rim {
                Rim::None => f64::from(u8::from(q <= 1.0)),
                Rim::Area => area(&frame, u, v),
                Rim::HalfPlane => half_plane(footprint, q, u, v),
                Rim::Volume => match distance(footprint, q, u, v).0 {
                    d if d >= 0.5 => 1.0,
                    d if d >= 0.0 => 1.0 - volume(d),
                    d if d > -0.5 => volume(-d),
                    _ => 0.0,
                },
            };
            if share <= 0.0 {
                continue;
            }
            let (a, b) = frame.coordinates(u, v);
            let w = share * weight.at(a * a, b * b);
            let texel = level.texel(wrap.index(placed.texel[0] + i, level.width()), y);
            sum.weight += w;
            for (sum, value) in sum.values.iter_mut().zip(texel) {
                *sum += w * f64::from(value);
            }
            sum.texels += 1;
        }
    }
    sum
}

/// The centre's distance from the rim to first order, positive inside, (1 - √Q)/|∇√Q|, and the normal.
fn distance(footprint: &Footprint<f64>, q: f64, u: f64, v: f64) -> (f64, f64, f64) {
    let Footprint { uu, uv, vv, determinant } = *footprint;
    // ½ ∇Q
    let (gu, gv) = ((vv * u - uv * v) / determinant, (uu * v - uv * u) / determinant);
    let length = gu.hypot(gv);
    if length == 0.0 {
        return (f64::INFINITY, 1.0, 0.0); // the middle
    }
    let root = q.sqrt();
    ((1.0 - root) * root / length, gu / length, gv / length)
}

/// Area of the unit square on the inner side of the rim's tangent.
fn half_plane(footprint: &Footprint<f64>, q: f64, u: f64, v: f64) -> f64 {
    let (d, nu, nv) = distance(footprint, q, u, v);
    // The square's shadow along the normal is a trapezoid of area 1: b wide at its foot, a at its top.
    let (a, b) = (nu.abs().min(nv.abs()), nu.abs().max(nv.abs()));
    let (short, long) = (0.5 * (b - a), 0.5 * (b + a));
    let x = d.abs();
    let beyond = if x >= long {
        0.0
    } else if x <= short {
        0.5 - x / b
    } else {
        (long - x) * (long - x) / (2.0 * a * b)
    };
    if d >= 0.0 { 1.0 - beyond } else { beyond }
}

/// Exact area of the unit square around (u, v) inside the ellipse: of its image inside the unit circle.
fn area(frame: &Frame<f64>, u: f64, v: f64) -> f64 {
    let corner = |du: f64, dv: f64| frame.coordinates(u + du, v + dv);
    let corners = [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    // All inside, as the ellipse is convex.
    if corners.iter().all(|&(x, y)| x * x + y * y <= 1.0) {
        return 1.0;
    }
    let sectors: f64 = (0..4).map(|i| edge(corners[i], corners[(i + 1) % 4])).sum();
    sectors.abs() * frame.major * frame.minor
}

/// Signed area of the triangle (0, p, q) inside the unit circle.
fn edge(p: (f64, f64), q: (f64, f64)) -> f64 {
    let sector =
        |a: (f64, f64), b: (f64, f64)| 0.5 * libm::atan2(a.0 * b.1 - a.1 * b.0, a.0 * b.0 + a.1 * b.1);
    let triangle = |a: (f64, f64), b: (f64, f64)| 0.5 * (a.0 * b.1 - a.1 * b.0);
    let (dx, dy) = (q.0 - p.0, q.1 - p.1);
    // |p + t (q - p)|² = 1
    let (a, b, c) = (dx * dx + dy * dy, p.0 * dx + p.1 * dy, p.0 * p.0 + p.1 * p.1 - 1.0);
    let discriminant = b * b - a * c;
    if discriminant <= 0.0 {
        return sector(p, q);
    }
    let root = discriminant.sqrt();
    let (from, to) = (((-b - root) / a).clamp(0.0, 1.0), ((-b + root) / a).clamp(0.0, 1.0));
    let at = |t: f64| (p.0 + t * dx, p.1 + t * dy);
    if from >= to {
        return sector(p, q);
    }
    let (r, s) = (at(from), at(to));
    sector(p, r) + triangle(r, s) + sector(s, q)
}
