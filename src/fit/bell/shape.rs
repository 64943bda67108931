//! The shapes of p that are fitted, and their error against e⁻ᵗ.

/// How p is spanned by its unknowns, in y = t/T, T the place of the cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shape {
    /// 1 - y; unknown T. The papers' shape with a free scale.
    Linear,
    /// (1 - y)(1 - 0.999 y): the nearest to a double zero that still changes sign; unknown T. A double
    /// zero, the limit, is the best continuous p of degree 2, and is the linear shape at 2 K.
    Double,
    /// 1 - b₁ y + b₂ y², positive at the cut: the bell jumps to 0 there; unknowns T, b₁, b₂.
    Jump,
    /// (1 - y)(1 + α y + β y²); unknowns T, α, β.
    Cubic,
}

/// The second zero of [`Shape::Double`] as a multiple of the first, inverted.
const SECOND: f64 = 0.999;

/// p on [0, T]: coefficients in y = t/T, ascending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// T.
    pub reach: f64,
    /// p = Σ aᵢ yⁱ, ascending, a₀ = 1.
    pub coefficients: [f64; 4],
}

/// Where an error is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// At t = y T, up to the cut.
    At(f64),
    /// Beyond the cut, where the bell is 0 and e⁻ᵗ largest at T.
    Beyond,
}

impl Shape {
    /// All four.
    pub const ALL: [Shape; 4] = [Shape::Linear, Shape::Double, Shape::Jump, Shape::Cubic];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Shape::Linear => "linear",
            Shape::Double => "double zero",
            Shape::Jump => "jump",
            Shape::Cubic => "cubic",
        }
    }

    /// Degree of p.
    pub const fn degree(self) -> u32 {
        match self {
            Shape::Linear => 1,
            Shape::Double | Shape::Jump => 2,
            Shape::Cubic => 3,
        }
    }

    /// Whether the bell ends without a jump.
    pub const fn is_continuous(self) -> bool {
        !matches!(self, Shape::Jump)
    }

    /// How many unknowns.
    pub const fn unknowns(self) -> usize {
        match self {
            Shape::Linear | Shape::Double => 1,
            Shape::Jump | Shape::Cubic => 3,
        }
    }

    /// p for these unknowns, T first.
    pub fn piece(self, x: &[f64]) -> Piece {
        let coefficients = match self {
            Shape::Linear => [1.0, -1.0, 0.0, 0.0],
            Shape::Double => [1.0, -1.0 - SECOND, SECOND, 0.0],
            Shape::Jump => [1.0, -x[1], x[2], 0.0],
            Shape::Cubic => [1.0, x[1] - 1.0, x[2] - x[1], -x[2]],
        };
        Piece { reach: x[0], coefficients }
    }
}

impl Piece {
    /// p at t = y T.
    pub fn at(&self, y: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, c| sum * y + c)
    }

    /// e⁻ᵗ - p(t)^K, signed.
    pub(super) fn error(&self, power: u32, place: Place) -> f64 {
        match place {
            Place::At(y) => libm::exp(-y * self.reach) - libm::pow(self.at(y), f64::from(power)),
            Place::Beyond => libm::exp(-self.reach),
        }
    }

    /// c₁, c₂, c₃ of p = 1 - c₁ z + c₂ z² - c₃ z³ in z = t/K.
    pub fn scaled(&self, power: u32) -> [f64; 3] {
        let s = f64::from(power) / self.reach;
        let [_, b1, b2, b3] = self.coefficients;
        [-b1 * s, b2 * s * s, -b3 * s * s * s]
    }

    /// Whether p falls from 1 and stays at or above 0 up to the cut, on so many steps.
    pub(super) fn is_bell(&self, steps: u32) -> bool {
        let y = |i: u32| f64::from(i) / f64::from(steps);
        self.reach > 0.0
            && (0..steps).all(|i| self.at(y(i)) > self.at(y(i + 1)))
            // A factor 1 - y leaves the rounding of three sums of numbers up to 4.
            && self.at(1.0) >= -4.0 * f64::EPSILON
    }
}
