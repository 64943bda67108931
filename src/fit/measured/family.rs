//! The families of lobes that are compared.

use super::lobe::Lobe;
use crate::kernel::exact::Cost;
use crate::kernel::stand_in::{Argument, StandIn};
use core::fmt;

/// A family of lobes: scale · g(w; n), g = 1 at w = 1 - cos θ = 0, and 0 for w > 1.
///
/// The linear bells have one curve for each place of their cut, whatever n it is called: K = 16 is cs_16's, whose
/// exponent is n; that of the cosⁿ it stands for is about 4 % larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// cosⁿθ.
    CosN,
    /// The lobe paper's cs_16 with its exact cut.
    Cs16,
    /// [`LinearLobe`](crate::kernel::linear::LinearLobe), K = 2.
    Linear2,
    /// The same, K = 4.
    Linear4,
    /// The same, K = 8.
    Linear8,
    /// The same, K = 32.
    Linear32,
    /// [`CubicLobe`](crate::kernel::cubic::CubicLobe), K = 2.
    Cubic2,
    /// The same, K = 4.
    Cubic4,
    /// The same, K = 8.
    Cubic8,
    /// e^(-n w), n its sharpness λ.
    SphericalGaussian,
    /// Schlick's c/(c + n w), c = cos θ.
    Schlick,
    /// ((1 - y)(1 + α y + β y²))², y = n w/(2 (1 - α)): the shape is fitted too.
    Free2,
    /// The same to the 4th power, y = n w/(4 (1 - α)).
    Free4,
    /// The same to the 8th power, y = n w/(8 (1 - α)).
    Free8,
}

/// The n from which the adopted bells' formulas hold.
const BELLS_FROM: f64 = 16.0;
/// The n searched for other families.
const WIDEST: f64 = 0.1;
const NARROWEST: f64 = 1e7;

impl Family {
    /// All of them.
    pub const ALL: [Family; 14] = [
        Family::CosN,
        Family::Cs16,
        Family::Linear2,
        Family::Linear4,
        Family::Linear8,
        Family::Linear32,
        Family::Cubic2,
        Family::Cubic4,
        Family::Cubic8,
        Family::SphericalGaussian,
        Family::Schlick,
        Family::Free2,
        Family::Free4,
        Family::Free8,
    ];

    /// The name on the command line and in answers.
    pub const fn id(self) -> &'static str {
        match self {
            Family::CosN => "cos-n",
            Family::Free2 => "free-2",
            Family::Free4 => "free-4",
            Family::Free8 => "free-8",
            _ => self.stand_in().id(),
        }
    }

    /// The family with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::fit::measured::Family;
    /// assert!(Family::ALL.iter().all(|family| Family::from_id(family.id()) == Some(*family)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.id() == id)
    }

    /// The kernel that computes it; of the free bells the cubic one, which takes the same steps with other
    /// constants.
    pub const fn stand_in(self) -> StandIn {
        match self {
            Family::CosN => StandIn::Power,
            Family::Cs16 => StandIn::Cs16,
            Family::Linear2 => StandIn::Linear2,
            Family::Linear4 => StandIn::Linear4,
            Family::Linear8 => StandIn::Linear8,
            Family::Linear32 => StandIn::Linear32,
            Family::Cubic2 | Family::Free2 => StandIn::Cubic2,
            Family::Cubic4 | Family::Free4 => StandIn::Cubic4,
            Family::Cubic8 | Family::Free8 => StandIn::Cubic8,
            Family::SphericalGaussian => StandIn::SphericalGaussian,
            Family::Schlick => StandIn::Schlick,
        }
    }

    /// Whether α and β are fitted.
    pub const fn is_free(self) -> bool {
        matches!(self, Family::Free2 | Family::Free4 | Family::Free8)
    }

    /// How many parameters: scale and n, and α and β of a free bell.
    pub const fn parameters(self) -> usize {
        if self.is_free() { 4 } else { 2 }
    }

    /// The n that are searched: 0.1 to 1e7, from 16 for the bells whose formulas are adopted from there.
    pub const fn exponents(self) -> (f64, f64) {
        match self {
            Family::Linear2
            | Family::Linear4
            | Family::Linear8
            | Family::Linear32
            | Family::Cubic2
            | Family::Cubic4
            | Family::Cubic8 => (BELLS_FROM, NARROWEST),
            _ => (WIDEST, NARROWEST),
        }
    }

    /// What a value costs from cos θ, as [`StandIn::cost`] counts; the cut of a free bell counts as the other
    /// bells' maximum.
    pub fn cost(self, n: f64) -> Cost {
        self.stand_in().cost(Argument::Cosine, n)
    }

    /// g(w; n) with the shape (α, β), which counts for the free bells alone.
    ///
    /// Domain: w in [0, 1], n > 0, and a shape that [falls](super::Shape::falls); accuracy as the kernels'.
    ///
    /// ```
    /// use bellfit::{fit::measured::{Family, Shape}, kernel::lobe::cs_versine};
    /// let (w, n) = (0.01, 50.0);
    /// assert!((Family::Cs16.value(w, n, Shape::default()) - cs_versine::<16, f64>(w, n)).abs() < 1e-15);
    /// // α = β = 0 is Lyon's bell
    /// assert!((Family::Free8.value(w, n, Shape::default()) - cs_versine::<8, f64>(w, n)).abs() < 1e-15);
    /// ```
    pub fn value(self, versine: f64, n: f64, shape: Shape) -> f64 {
        Lobe::new(self, n, shape).value(versine, libm::log1p(-versine))
    }

    /// k₁, k₂, k₃ of p = 1 - w (k₁ - w (k₂ - w k₃)) and the w of its cut, for a bell p^K; `None` for what is no bell.
    ///
    /// ```
    /// use bellfit::fit::measured::{Family, Shape};
    /// let (k, reach) = Family::Cs16.horner(64.0, Shape::default()).unwrap();
    /// assert_eq!((k, reach), ([4.0, 0.0, 0.0], 0.25)); // 1 - 64 w/16
    /// ```
    pub fn horner(self, n: f64, shape: Shape) -> Option<([f64; 3], f64)> {
        Lobe::new(self, n, shape).bell()
    }

    /// ∂g/∂ln n, and ∂g/∂α and ∂g/∂β of a free bell (else 0); domain as [`Self::value`].
    ///
    /// ```
    /// use bellfit::fit::measured::{Family, Shape};
    /// let (w, n) = (0.01, 50.0);
    /// let [slope, ..] = Family::SphericalGaussian.slopes(w, n, Shape::default());
    /// assert!((slope + n * w * libm::exp(-n * w)).abs() < 1e-16);
    /// ```
    pub fn slopes(self, versine: f64, n: f64, shape: Shape) -> [f64; 3] {
        Lobe::new(self, n, shape).slopes(versine, libm::log1p(-versine)).1
    }
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

/// α and β of p = (1 - y)(1 + α y + β y²).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shape {
    /// α, below 1.
    pub linear: f64,
    /// β.
    pub square: f64,
}

impl Shape {
    /// By how much p falls everywhere on [0, 1]: the least of -p'(y), -p' = (1 - α) - 2 (β - α) y + 3 β y².
    ///
    /// From p(0) = 1 to p(1) = 0 the bell then falls without a rise.
    pub fn margin(self) -> f64 {
        let (a, c) = (1.0 - self.linear, self.square - self.linear);
        let ends = a.min(1.0 + self.linear + self.square);
        // The parabola's lowest point, where it opens upwards and has it inside.
        let at = c / (3.0 * self.square);
        if self.square > 0.0 && (0.0..=1.0).contains(&at) { ends.min(a - c * at) } else { ends }
    }

    /// Whether p falls on all of [0, 1], and from 1 at once: a shape that is fitted.
    ///
    /// ```
    /// use bellfit::fit::measured::Shape;
    /// assert!(Shape::default().falls());
    /// assert!(!Shape { linear: -4.0, square: 4.0 }.falls()); // p(y) rises about y = 2/3
    /// ```
    pub fn falls(self) -> bool {
        self.margin() >= 0.0 && self.linear <= MOST_LINEAR && self.square.is_finite()
    }
}

impl Shape {
    /// Whether it stands where [`falls`](Shape::falls) ends.
    pub(super) fn is_near_edge(self) -> bool {
        self.margin() < EDGE || self.linear > (1.0 - EDGE) * MOST_LINEAR
    }
}

/// How near to the edge a shape stands at it, relatively.
const EDGE: f64 = 1e-2;
/// α stays this far below 1, where the peak would be flat and n nothing.
const MOST_LINEAR: f64 = 0.99;

#[cfg(test)]
mod tests {
    use super::*;

    /// -p' by its values on a fine grid, from the product's own derivative.
    #[test]
    fn the_margin_is_the_least_slope() {
        for i in -30..10 {
            for j in -10..40 {
                let shape = Shape { linear: f64::from(i) * 0.1, square: f64::from(j) * 0.1 };
                let slope = |y: f64| {
                    let (q, dq) = (
                        1.0 + shape.linear * y + shape.square * y * y,
                        shape.linear + 2.0 * shape.square * y,
                    );
                    q - (1.0 - y) * dq
                };
                let least = (0..=1000).map(|k| slope(f64::from(k) * 1e-3)).fold(f64::INFINITY, f64::min);
                // Between grid points the parabola 3 β y² is lower by up to 3 β (h/2)² = 3e-6.
                assert!(
                    (-1e-14..=4e-6).contains(&(least - shape.margin())),
                    "{shape:?}: {least} {}",
                    shape.margin()
                );
            }
        }
    }

    /// The edge is where -p' touches 0, from within a hundredth, or where the peak is all but flat.
    #[test]
    fn the_edge_is_told_from_inside() {
        for (linear, square, is_near) in [
            (0.0, 0.0, false),
            (-0.9, 0.7, false),
            (-1.0, 0.005, true), // 1 + α + β = 0.005 is the slope at y = 1
            (-1.0, 0.02, false),
            (0.985, 0.0, true), // the slope at 0 is 1 - α = 0.015: 0.985 is 99.5 % of what is let in
            (0.975, 0.0, false),
        ] {
            let shape = Shape { linear, square };
            assert!(shape.falls());
            assert_eq!(shape.is_near_edge(), is_near, "{shape:?}");
        }
    }

    #[test]
    fn the_adopted_bells_fall() {
        for family in [Family::Cubic2, Family::Cubic4, Family::Cubic8] {
            let (_, linear, square) = family.stand_in().formula().unwrap().at::<f64>(100.0);
            assert!(Shape { linear, square }.margin() > 0.1, "{family}");
        }
    }
}
