//! A lobe as the albedo integrates it, and what can be wrong with what is asked.

use thiserror::Error;

/// What is outside the domain of an albedo.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum AlbedoError {
    /// An angle that is no angle of incidence.
    #[error("θ = {0}: an angle of incidence lies in [0, π/2], in radians")]
    Angle(f64),
    /// A factor that normalises nothing.
    #[error("factor {0}: it must be finite and not negative")]
    Factor(f64),
    /// An exponent that is no width.
    #[error("n = {0}: it must be finite and positive")]
    Exponent(f64),
    /// A lobe that ends nowhere on the sphere.
    #[error("the lobe's support ends at 1 - cos = {0}: it must lie in (0, 2]")]
    Support(f64),
    /// A lobe that is not 1 on its axis.
    #[error("the lobe is {0} on its axis: it must be 1")]
    Axis(f64),
    /// A lobe that is negative, not a number, or rises.
    #[error("the lobe is {value} at 1 - cos = {versine}: it must not be negative, nor rise from {before}")]
    Shape {
        /// Where.
        versine: f64,
        /// What it is there.
        value: f64,
        /// What it was a step nearer to the axis.
        before: f64,
    },
}

/// A lobe about its axis, as a function of w = 1 - cos of its own angle.
///
/// It is 1 on the axis, nowhere negative, never rises, is smooth up to the end of its support and 0 beyond;
/// n is its sharpness: its width in w is of the order of 1/n. The theorems about albedos need its shape,
/// their quadrature its smoothness.
#[derive(Clone, Copy)]
pub struct Profile<'a> {
    value: &'a dyn Fn(f64) -> f64,
    support: f64,
    n: f64,
}

/// Where a lobe is looked at for its shape: enough to catch a wrong one, no proof of a right one.
const LOOKS: u32 = 256;

/// What rounding may raise a lobe by, relative: a power of a cosine is good to 1e-13.
const ROUNDING: f64 = 1e-12;

impl<'a> Profile<'a> {
    /// A lobe with the end of its support in w and its sharpness n.
    ///
    /// # Errors
    /// [`AlbedoError`] for a support outside (0, 2], an n that is not positive, and a lobe that does not
    /// keep its shape where it is looked at, at 257 arguments.
    ///
    /// ```
    /// use bellfit::integral::albedo::Profile;
    /// use bellfit::kernel::lobe::cs_versine;
    /// let n = 64.0;
    /// let cs_16 = |w| cs_versine::<16, f64>(w, n);
    /// assert_eq!(Profile::new(&cs_16, 16.0 / n, n)?.at(0.0), 1.0);
    /// assert!(Profile::new(&|w| 1.0 + w, 1.0, n).is_err());
    /// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
    /// ```
    pub fn new(value: &'a dyn Fn(f64) -> f64, support: f64, n: f64) -> Result<Self, AlbedoError> {
        if !(n > 0.0 && n.is_finite()) {
            return Err(AlbedoError::Exponent(n));
        }
        if !(support > 0.0 && support <= 2.0) {
            return Err(AlbedoError::Support(support));
        }
        let mut before = value(0.0);
        if before.is_nan() || (before - 1.0).abs() > ROUNDING {
            return Err(AlbedoError::Axis(before));
        }
        for k in 1..=LOOKS {
            // Denser towards the axis, where the lobe is.
            let part = f64::from(k) / f64::from(LOOKS);
            let versine = support * part * part;
            let found = value(versine);
            if !(found >= 0.0 && found <= before + ROUNDING) {
                return Err(AlbedoError::Shape { versine, value: found, before });
            }
            before = found;
        }
        Ok(Profile { value, support, n })
    }

    /// The lobe at w.
    pub fn at(&self, versine: f64) -> f64 {
        if versine > self.support { 0.0 } else { (self.value)(versine) }
    }

    /// The end of its support, in w.
    pub const fn support(&self) -> f64 {
        self.support
    }

    /// Its sharpness n.
    pub const fn n(&self) -> f64 {
        self.n
    }
}

impl core::fmt::Debug for Profile<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Profile").field("support", &self.support).field("n", &self.n).finish_non_exhaustive()
    }
}
