//! The lobes and bells in exact arithmetic, to about 100 bits, by their formulas and no code of theirs.

use super::DoubleDouble;
use crate::kernel::constants::{CUBIC_COS_N, CUBIC_EXP, LINEAR_COS_N};
use crate::kernel::cubic::BellFormula;
use crate::kernel::stand_in::StandIn;

/// An angle, a double taken at its word, with what lobes need of it.
#[derive(Clone, Copy, Debug)]
pub struct Angle {
    theta: f64,
    versine: DoubleDouble,
    cosine: DoubleDouble,
    log: DoubleDouble,
    sine: DoubleDouble,
}

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

impl Angle {
    /// Of θ in [0, π/2], radians: 1 - cos θ = 2 sin²(θ/2) and ln cos θ = ln(1 - (1 - cos θ)), nothing cancelling.
    ///
    /// ```
    /// use bellfit::stability::Angle;
    /// assert_eq!(Angle::of(1e-8).versine().to_f64(), 0.5e-16);
    /// ```
    pub fn of(theta: f64) -> Self {
        let half = number(0.5 * theta);
        let (s, one) = (half.sin(), number(1.0));
        let versine = number(2.0) * s * s;
        // sin θ = 2 sin(θ/2) cos(θ/2)
        let sine = number(2.0) * s * (one - s * s).sqrt();
        Angle { theta, versine, cosine: one - versine, log: versine.log_one_minus(), sine }
    }

    /// θ.
    pub fn theta(&self) -> f64 {
        self.theta
    }

    /// 1 - cos θ.
    pub fn versine(&self) -> DoubleDouble {
        self.versine
    }

    /// cos θ.
    pub fn cosine(&self) -> DoubleDouble {
        self.cosine
    }

    /// sin θ.
    pub fn sine(&self) -> DoubleDouble {
        self.sine
    }

    /// cosⁿθ = e^(n ln cos θ).
    ///
    /// ```
    /// use bellfit::stability::Angle;
    /// let value = Angle::of(1e-6).cos_n(1e12).to_f64(); // e^(-½ - 1e-13/12...)
    /// assert!((value - libm::exp(-0.5)).abs() < 1e-12);
    /// ```
    pub fn cos_n(&self, n: f64) -> DoubleDouble {
        (number(n) * self.log).exp()
    }

    /// What stands for cosⁿ, with its exact constants of n, in exact arithmetic.
    ///
    /// Domain: n > 0. Below the n for which a bell was fitted its formula continues.
    ///
    /// ```
    /// use bellfit::{kernel::stand_in::StandIn, stability::Angle};
    /// let (angle, n) = (Angle::of(0.25), 64.0);
    /// for stand_in in StandIn::ALL {
    ///     let kernel = stand_in.at_versine(angle.versine().to_f64(), n);
    ///     assert!((angle.stand_in(stand_in, n).to_f64() - kernel).abs() < 1e-14, "{stand_in:?}");
    /// }
    /// ```
    pub fn stand_in(&self, stand_in: StandIn, n: f64) -> DoubleDouble {
        let t = number(n) * self.versine;
        match stand_in {
            StandIn::Cs16 => lyon_bell(16, t),
            StandIn::Linear2 => linear(&LINEAR_COS_N[0], n, t),
            StandIn::Linear4 => linear(&LINEAR_COS_N[1], n, t),
            StandIn::Linear8 => linear(&LINEAR_COS_N[2], n, t),
            StandIn::Linear16 => linear(&LINEAR_COS_N[3], n, t),
            StandIn::Linear32 => linear(&LINEAR_COS_N[4], n, t),
            StandIn::Cubic2 => cubic(&CUBIC_COS_N[0], n, t),
            StandIn::Cubic4 => cubic(&CUBIC_COS_N[1], n, t),
            StandIn::Cubic8 => cubic(&CUBIC_COS_N[2], n, t),
            StandIn::Schlick | StandIn::SchlickPrinted => self.cosine / (self.cosine + t),
            StandIn::SphericalGaussian => (-t).exp(),
            StandIn::Squarings | StandIn::Exp2Log2 | StandIn::Power => self.cos_n(n),
        }
    }
}

/// max(p, 0)^K for K a power of two.
fn power(base: DoubleDouble, k: u32) -> DoubleDouble {
    if base.to_f64() > 0.0 { base.squared(k.ilog2()) } else { number(0.0) }
}

/// max(1 - t/K, 0)^K, K a power of two: [`bell`](crate::kernel::bell::bell) in exact arithmetic.
///
/// ```
/// use bellfit::stability::{DoubleDouble, lyon_bell};
/// assert_eq!(lyon_bell(4, DoubleDouble::from(1.0)).to_f64(), 81.0 / 256.0);
/// ```
pub fn lyon_bell(k: u32, t: DoubleDouble) -> DoubleDouble {
    power(number(1.0) - t / number(f64::from(k)), k)
}

/// [`cubic_bell`](crate::kernel::cubic::cubic_bell) in exact arithmetic, K = 2, 4 or 8; `None` for another K.
///
/// ```
/// use bellfit::{kernel::cubic::cubic_bell, stability::{DoubleDouble, fitted_bell}};
/// let value = fitted_bell(8, DoubleDouble::from(1.5)).map(DoubleDouble::to_f64);
/// assert!((value.unwrap() - cubic_bell::<8, f64>(1.5)).abs() < 1e-15);
/// ```
pub fn fitted_bell(k: u32, t: DoubleDouble) -> Option<DoubleDouble> {
    let row = [2, 4, 8].iter().position(|power| *power == k)?;
    let [c1, c2, c3] = CUBIC_EXP[row].map(number);
    let y = t / number(f64::from(k));
    Some(power(number(1.0) - y * (c1 - y * (c2 - y * c3)), k))
}

/// c₀ + c₁/n + c₂/n².
fn of_reciprocal([a, b, c]: [f64; 3], n: f64) -> DoubleDouble {
    number(a) + (number(b) + number(c) / number(n)) / number(n)
}

fn linear(formula: &BellFormula, n: f64, t: DoubleDouble) -> DoubleDouble {
    power(number(1.0) - t / of_reciprocal(formula.reach, n), formula.power)
}

fn cubic(formula: &BellFormula, n: f64, t: DoubleDouble) -> DoubleDouble {
    let y = t / of_reciprocal(formula.reach, n);
    let (linear, square) = (of_reciprocal(formula.linear, n), of_reciprocal(formula.square, n));
    let one = number(1.0);
    power((one - y) * (one + y * (linear + y * square)), formula.power)
}
