//! Texels on the rim, texel by texel in double precision: for study, not for speed.

use super::gathered::Sum;
use super::placed::Placed;
use super::{Rim, Texture, Wrap};
use crate::kernel::pixel::{Footprint, Frame, PixelWeight, Tangent, clip_volume_paper, coverage, half_plane};

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

/// What a texel counts that the ellipse touches. The tangent alone would let others count too: beside a thin
/// ellipse's end its distance, of first order, is far too small.
fn touched(footprint: &Footprint<f64>, rim: Rim, u: f64, v: f64) -> f64 {
    let area = coverage(footprint, u, v);
    match rim {
        _ if area <= 0.0 => 0.0,
        Rim::None | Rim::Area => area,
        Rim::HalfPlane => half_plane(footprint, u, v),
        Rim::Volume => volume(Tangent::of(footprint, u, v).distance),
    }
}

/// What a texel counts whose centre is `distance` inside the rim, by P(d) in place of the area: the paper gives
/// P for d from 0 to ½.
fn volume(distance: f64) -> f64 {
    match distance {
        d if d >= 0.5 => 1.0,
        d if d >= 0.0 => 1.0 - clip_volume_paper(d),
        d if d > -0.5 => clip_volume_paper(-d),
        _ => 0.0,
    }
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
            let share = if rim == Rim::None {
                f64::from(u8::from(footprint.q(u, v) <= 1.0))
            } else {
                touched(footprint, rim, u, v)
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
