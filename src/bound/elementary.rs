//! exp, ln and the versine of intervals, from truncated series with their remainders.
//!
//! Nothing here trusts a library function: each series is summed in interval arithmetic and the
//! tail is bounded by its first term left out.

use super::Interval;
use crate::integral::{Edge, Field};

/// Degree of the exponential series after reduction to 0 ≤ r ≤ 0.7: 0.7^18/18! < 3e-19.
const EXP_DEGREE: usize = 17;
/// Degree in z² of the series of ln, z² ≤ 0.0295: 0.0295^13 < 2e-20.
const LN_DEGREE: usize = 12;

/// 17!/j!, so that 17! eˣ is summed with whole coefficients: 17! < 2^53, all are exact.
const EXP_COEFFICIENTS: [f64; EXP_DEGREE + 1] = {
    let mut c = [1.0; EXP_DEGREE + 1];
    let mut j = EXP_DEGREE;
    while j > 0 {
        c[j - 1] = c[j] * j as f64;
        j -= 1;
    }
    c
};

/// lcm(1, 3, …, 25)/(2j + 1): 9 · 25 · 7 · 11 · 13 · 17 · 19 · 23 < 2^53, all are exact.
const LN_SCALE: u64 = 9 * 25 * 7 * 11 * 13 * 17 * 19 * 23;
const LN_COEFFICIENTS: [f64; LN_DEGREE + 1] = {
    let mut c = [0.0; LN_DEGREE + 1];
    let mut j = 0;
    while j <= LN_DEGREE {
        assert!(LN_SCALE.is_multiple_of(2 * j as u64 + 1));
        c[j] = (LN_SCALE / (2 * j as u64 + 1)) as f64;
        j += 1;
    }
    c
};

/// Terms of the versine series for y ≤ 3: 3^12/26! < 2e-21.
const VERSINE_TERMS: i64 = 12;

impl Interval {
    /// eˣ for every x of the interval.
    ///
    /// ```
    /// use bellfit::bound::Interval;
    /// let e = Interval::from(1.0).exp();
    /// assert!(e.contains(core::f64::consts::E) && e.width() < 1e-14);
    /// ```
    pub fn exp(self) -> Self {
        // Monotone: the ends suffice.
        Interval::new(exp_point(self.lo()).lo(), exp_point(self.hi()).hi())
    }

    /// ln x for every positive x of the interval; an end at or below 0 gives -∞.
    pub fn ln(self) -> Self {
        Interval::new(ln_point(self.lo()).lo(), ln_point(self.hi()).hi())
    }

    /// A lower bound of base^(1/m) for 0 ≤ base ≤ 1 and m > 0; 0 for base ≤ 0.
    pub(super) fn root_below(base: f64, m: f64) -> f64 {
        if base <= 0.0 {
            return 0.0;
        }
        let exponent = Interval::from(ln_point(base).lo()) / Interval::from(m);
        exp_point(exponent.lo()).lo()
    }

    /// An upper bound of base^(1/m) for 0 ≤ base ≤ 1 and m > 0; 0 for base ≤ 0.
    pub(super) fn root_above(base: f64, m: f64) -> f64 {
        if base <= 0.0 {
            return 0.0;
        }
        let exponent = Interval::from(ln_point(base).hi()) / Interval::from(m);
        exp_point(exponent.hi()).hi()
    }

    /// self^y = e^(y ln self) for self ≥ 0 and y > 0, with 0^y = 0.
    pub fn pow(self, y: Interval) -> Self {
        (y * self.ln()).exp()
    }
}

fn exp_point(x: f64) -> Interval {
    if x.is_nan() {
        return Interval::WHOLE;
    }
    if x < -740.0 {
        // e^-740 = 4.2e-322 is still a (subnormal) double; below it, 0 ≤ eˣ ≤ e^-740.
        return Interval::new(0.0, 1e-321);
    }
    if x > 700.0 {
        return Interval::new(1e304, f64::INFINITY); // e^700 = 1.01e304
    }
    // Rounded down, so that every term is positive; a k one off only makes r a little larger.
    let k = libm::floor(x / core::f64::consts::LN_2);
    let r = Interval::from(x) - Interval::from(k) * Interval::LN_2;
    // Horner; the tail is below twice the first term left out, as r/19 < 1/2, and that term below
    // r^17/17! · r/18.
    let mut sum = Interval::from(1.0);
    for c in EXP_COEFFICIENTS[..EXP_DEGREE].iter().rev() {
        sum = Interval::from(*c) + sum * r;
    }
    let tail = Interval::from(2.0) * r.abs().power(EXP_DEGREE as u32 + 1) / Interval::from(18.0);
    sum = (sum + Interval::new(-tail.hi(), tail.hi())) / Interval::from(EXP_COEFFICIENTS[0]);
    // Powers of two scale exactly until they underflow; then one step outward covers it.
    let scale = |v: f64| libm::scalbn(v, k as i32);
    Interval::new(scale(sum.lo()).next_down().max(0.0), scale(sum.hi()).next_up())
}

fn ln_point(x: f64) -> Interval {
    if x.is_nan() {
        return Interval::WHOLE;
    }
    if x <= 0.0 {
        return Interval::new(f64::NEG_INFINITY, -744.0); // ln of the smallest double is -744.4
    }
    if x == f64::INFINITY {
        return Interval::new(709.0, f64::INFINITY);
    }
    let (mut f, mut k) = libm::frexp(x);
    if f < core::f64::consts::FRAC_1_SQRT_2 {
        (f, k) = (2.0 * f, k - 1);
    }
    // ln f = 2 artanh z, z = (f - 1)/(f + 1), |z| < 0.1716; f - 1 is exact (Sterbenz).
    let z = Interval::from(f - 1.0) / (Interval::from(f) + Interval::from(1.0));
    let square = z.power(2);
    let mut sum = Interval::from(0.0);
    for c in LN_COEFFICIENTS.iter().rev() {
        sum = Interval::from(*c) + sum * square;
    }
    // Σ_{j>N} z^2j/(2j+1) < z^(2N+2), as 1/((2N+3)(1 - z²)) < 1.
    let tail = square.power(LN_DEGREE as u32 + 1).hi();
    let series = sum / Interval::from(LN_SCALE as f64) + Interval::new(0.0, tail);
    Interval::from(2.0) * z * series + Interval::from(f64::from(k)) * Interval::LN_2
}

/// Σ_{j<terms} (-y)^j/(2j+2)! by Horner, over any field: (1 - cos √y)/y without its tail, which
/// is below y^terms/(2 terms + 2)! as long as the terms fall (y < 12).
pub(super) fn versine_series<T: Field>(y: &T, terms: i64) -> T {
    let mut sum = T::int(1);
    for j in (1..terms).rev() {
        sum = T::int(1) - sum * y.clone() / T::int((2 * j + 1) * (2 * j + 2));
    }
    sum / T::int(2)
}

/// d/dy of (1 - cos √y)/y for 0 ≤ y ≤ 3.
pub(super) fn versine_ratio_slope(y: Interval) -> Interval {
    // Σ_{j≥1} (-1)^j j y^(j-1)/(2j+2)!, alternating with falling terms for y ≤ 3.
    let point = |x: f64| {
        let x = Interval::from(x);
        let mut sum = Interval::from(0.0);
        let mut term = Interval::from(-1.0) / Interval::from(24.0);
        for j in 1..VERSINE_TERMS {
            sum = sum + term;
            // a_(j+1)/a_j = -y (j+1)/(j (2j+3)(2j+4))
            term = -(term * x * Interval::int(j + 1)) / Interval::int(j * (2 * j + 3) * (2 * j + 4));
        }
        sum + Interval::new(-term.abs().hi(), term.abs().hi())
    };
    // Increasing for y ≤ 3: the second derivative's series starts 2/720 - 6 y/40320 > 0.
    Interval::new(point(y.lo().max(0.0)).lo(), point(y.hi()).hi())
}

impl Edge for Interval {
    fn between(lo: f64, hi: f64) -> Self {
        Interval::new(lo, hi)
    }

    fn sqrt(&self) -> Self {
        self.square_root()
    }

    fn versine_ratio(&self) -> Self {
        let point = |y: f64| {
            let y = Interval::from(y.max(0.0));
            let mut tail = Interval::from(0.5);
            for j in 1..=VERSINE_TERMS {
                tail = tail * y / Interval::int((2 * j + 1) * (2 * j + 2));
            }
            versine_series(&y, VERSINE_TERMS) + Interval::new(-tail.hi(), tail.hi())
        };
        // Falling for √y < π, and y ≤ π²/4 up to rounding here.
        Interval::new(point(self.hi()).lo(), point(self.lo()).hi())
    }

    fn half_power(&self) -> Self {
        if self.lo() <= 0.0 {
            // Rising from its limit 0 at m = 0.
            let hi = if self.hi() > 0.0 { Interval::from(self.hi()).half_power().hi() } else { 0.0 };
            return Interval::new(0.0, hi);
        }
        (-(Interval::LN_2 / (Interval::from(2.0) * *self))).exp()
    }

    fn min(&self, other: &Self) -> Self {
        self.least(*other)
    }

    fn half_pi_squared() -> Self {
        (Interval::PI / Interval::from(2.0)).power(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identities_hold_inside_the_enclosures() {
        for i in 0..400 {
            let x = -20.0 + 0.1 * f64::from(i) + 1e-3;
            let e = Interval::from(x).exp();
            assert!(e.ln().contains(x), "ln exp {x}");
            assert!((e * Interval::from(-x).exp()).contains(1.0), "exp {x} exp -{x}");
            assert!(e.width() < 1e-13 * e.hi());
        }
        assert!(
            Interval::from(2.0).ln().encloses(Interval::LN_2) || Interval::from(2.0).ln().width() < 4e-16
        );
        assert!(Interval::from(1.0).ln().contains(0.0) && Interval::from(1.0).ln().width() < 1e-300);
    }

    #[test]
    fn the_versine_ratio_at_right_angles_is_exact() {
        // 1 - cos(π/2) = 1 and 1 - cos(π/3) = 1/2.
        let y = Interval::half_pi_squared();
        assert!((y * y.versine_ratio()).contains(1.0));
        let y = (Interval::PI / Interval::from(3.0)).power(2);
        assert!((y * y.versine_ratio()).contains(0.5));
    }

    #[test]
    fn the_slope_encloses_difference_quotients() {
        // By the mean value theorem a difference quotient is the slope at a point between.
        for i in 0..24 {
            let y = Interval::new(0.1 * f64::from(i), 0.1 * f64::from(i + 1));
            let (a, b) = (Interval::from(y.lo()), Interval::from(y.hi()));
            let quotient = (b.versine_ratio() - a.versine_ratio()) / (b - a);
            assert!(!versine_ratio_slope(y).is_disjoint(quotient), "{y:?}");
        }
    }

    #[test]
    fn extremes_stay_enclosed() {
        assert!(Interval::from(-800.0).exp().contains(0.0));
        assert!(Interval::from(800.0).exp().hi() == f64::INFINITY);
        assert!(Interval::from(0.0).ln().lo() == f64::NEG_INFINITY);
        assert!(Interval::new(0.0, 0.5).pow(Interval::from(3.0)).contains(0.125));
        assert_eq!(Interval::new(0.0, 0.5).pow(Interval::from(3.0)).lo(), 0.0);
        assert_eq!(Interval::from(0.0).half_power(), Interval::from(0.0));
        // 2^(-1/(2/8)) = 1/16 at m = 1/8.
        assert_eq!(Interval::new(0.0, 0.125).half_power().lo(), 0.0);
        assert!(Interval::new(0.0, 0.125).half_power().contains(0.0625));
    }
}
