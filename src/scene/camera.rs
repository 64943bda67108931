//! A pinhole camera over a plane.

use crate::kernel::pixel::Polygon;

/// A pinhole camera over the plane Z = 0, at the origin of X (right) and Y (ahead).
///
/// The ray through the picture's (x, y), of width W and height H, is
/// d = ahead + k (x - W/2) right - k (y - H/2) up, k = 2 tan(½ field of view)/W, with `ahead` pitched below
/// the horizontal and `right` and `up` turned about it by the roll; it meets the plane at
/// (X, Y) = height (d_X, d_Y)/(-d_Z). All three are linear in (x, y): a [`Polygon`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Over the plane, in units of length; above 0.
    pub height: f64,
    /// Below the horizontal, degrees, from -89 to 90.
    pub pitch: f64,
    /// About the direction of view, degrees.
    pub roll: f64,
    /// Across the picture, degrees, between 0 and 180.
    pub field_of_view: f64,
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

impl Camera {
    /// The mapping from a picture of this size to texels, `scale` of them a unit of length along X and Y.
    /// Its w is positive below the horizon.
    ///
    /// ```
    /// use bellfit::scene::Camera;
    /// // Straight down from 1: the picture's width is 2 tan 45° = 2 units, of 8 texels each.
    /// let camera = Camera { height: 1.0, pitch: 90.0, roll: 0.0, field_of_view: 90.0 };
    /// let mapping = camera.mapping(16, 16, [8.0, 8.0]);
    /// let (s, t) = mapping.at(16.0, 8.0);
    /// assert!((s - 8.0).abs() < 1e-12 && t.abs() < 1e-12);
    /// ```
    pub fn mapping(&self, width: usize, height: usize, scale: [f64; 2]) -> Polygon<f64> {
        let (half_width, half_height) = (0.5 * width as f64, 0.5 * height as f64);
        let k = libm::tan(0.5 * self.field_of_view * DEGREE) / half_width;
        let (sin, cos) = (libm::sin(self.pitch * DEGREE), libm::cos(self.pitch * DEGREE));
        let (turn_sin, turn_cos) = (libm::sin(self.roll * DEGREE), libm::cos(self.roll * DEGREE));
        let ahead = [0.0, cos, -sin];
        let (level, over) = ([1.0, 0.0, 0.0], [0.0, sin, cos]);
        // One component of d as coefficients of x, y and 1.
        let row = |i: usize, factor: f64| {
            let right = turn_cos * level[i] + turn_sin * over[i];
            let up = turn_cos * over[i] - turn_sin * level[i];
            let constant = ahead[i] - k * half_width * right + k * half_height * up;
            [factor * k * right, -factor * k * up, factor * constant]
        };
        Polygon { u: row(0, self.height * scale[0]), v: row(1, self.height * scale[1]), w: row(2, -1.0) }
    }
}
