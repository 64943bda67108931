//! Where the two derivative vectors are farthest from perpendicular.

use super::View;
use crate::kernel::pixel::{Axes, Padding, TiltFormula};

/// The pixel of a view whose derivative vectors enclose the smallest angle, and its ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skew {
    /// Column and row.
    pub pixel: (usize, usize),
    /// Between the two vectors, degrees, 0 to 90.
    pub degrees: f64,
    /// The conic's major by minor axis.
    pub aspect: f64,
    /// Longer by shorter of the paper's axes, which are the vectors' lengths.
    pub paper_aspect: f64,
    /// From the conic's major axis to the paper's longer one, degrees, 0 to 90: with the tilt of the first
    /// vector, and with ½ arctan(B/(A - C)).
    pub tilt_errors: [f64; 2],
}

/// Over the pixels on the plane; the first of equal ones.
pub(super) fn skewest(view: &View) -> Skew {
    let mut found: Option<((usize, usize), f64)> = None;
    for y in 0..view.height() {
        for x in (0..view.width()).filter(|x| view.on_plane()[y * view.width() + x]) {
            let j = view.mapping().jacobian(x as f64 + 0.5, y as f64 + 0.5);
            let (across, down) = j.lengths();
            let sine = (j.determinant() / (across * down)).abs();
            if found.is_none_or(|(_, least)| sine < least) {
                found = Some(((x, y), sine));
            }
        }
    }
    // A view has pixels on the plane, or it would not have been made.
    let (pixel, sine) = found.unwrap_or(((0, 0), f64::NAN));
    let j = view.mapping().jacobian(pixel.0 as f64 + 0.5, pixel.1 as f64 + 0.5);
    let degrees = |radians: f64| radians * (180.0 / std::f64::consts::PI);
    let axes = Axes::of(j, Padding::Plain);
    let tilt_error = |formula| {
        let paper = Axes::paper(j, formula);
        let quarter = if paper.major < paper.minor { std::f64::consts::FRAC_PI_2 } else { 0.0 };
        let off = libm::fabs(libm::sin(paper.tilt + quarter - axes.tilt));
        degrees(libm::asin(off.min(1.0)))
    };
    let (across, down) = j.lengths();
    Skew {
        pixel,
        degrees: degrees(libm::asin(sine.min(1.0))),
        aspect: axes.aspect(),
        paper_aspect: across.max(down) / across.min(down),
        tilt_errors: [tilt_error(TiltFormula::Vector), tilt_error(TiltFormula::Conic)],
    }
}
