//! The ellipse under a pixel, for readers.

use crate::filter::{AxesKind, EllipseFilter};
use crate::kernel::pixel::{Axes, Jacobian, Padding};

/// The ellipse that a filter reads, as it limits and pads it in level 0, in texels of level 0; without a
/// filter that of the conic, plain. Of the paper's axes `major` is the one along the tilt, longer or not; where
/// a tilt is 0/0 it is 0, as the filter takes it.
///
/// ```
/// use bellfit::{filter::EllipseFilter, kernel::pixel::Jacobian, scene::ellipse_axes};
/// let j = Jacobian { ux: 12.0, vx: 0.0, uy: 0.0, vy: 1.0 };
/// assert_eq!(ellipse_axes(j, None).minor, 1.0);
/// let limited = EllipseFilter { anisotropy: 4.0, ..EllipseFilter::default() }; // padded by default
/// assert_eq!(ellipse_axes(j, Some(&limited)).minor, 10.0_f64.sqrt());
/// ```
pub fn ellipse_axes(j: Jacobian<f64>, filter: Option<&EllipseFilter>) -> Axes<f64> {
    let Some(filter) = filter else { return Axes::of(j, Padding::Plain) };
    let plain = match filter.axes {
        AxesKind::Paper(formula) => Axes::paper(j, formula),
        AxesKind::True => Axes::of(j, Padding::Plain),
    };
    let limit = f64::from(filter.anisotropy);
    let pad = |axis: f64| if filter.padding == Padding::Padded { libm::hypot(axis, 1.0) } else { axis };
    Axes {
        major: pad(plain.major.max(plain.minor / limit)),
        minor: pad(plain.minor.max(plain.major / limit)),
        tilt: if plain.tilt.is_nan() { 0.0 } else { plain.tilt },
    }
}
