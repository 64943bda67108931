//! The error function and the arc cosine of intervals, from series with their remainders.

use super::Interval;
use crate::integral::Field;

/// Beyond it 1 - erf x is below e^-36/(6 √π) < 3e-17, and no further digit is looked for.
const FAR: f64 = 6.0;
/// Terms of the series of erf: at x = 6 the last of them is below 1e-19 of the sum.
const ERF_TERMS: i64 = 170;
/// Degree in z² of the series of arctan, |z| ≤ tan(π/16) < 0.2: 0.04^13 < 7e-19.
const ARCTAN_DEGREE: i64 = 12;

impl Interval {
    /// erf x = 2/√π ∫_0^x e^-s² ds for every x of the interval.
    ///
    /// e^x² erf x = 2/√π Σ 2ᵏ x^(2k+1)/(1·3·…·(2k+1)), whose terms are all positive: nothing cancels. Widths
    /// stay below 1e-12.
    ///
    /// ```
    /// use bellfit::bound::Interval;
    /// let half = Interval::from(0.5).erf(); // 0.5204998778130465…
    /// assert!(half.contains(0.5204998778130465) && half.width() < 1e-13);
    /// ```
    pub fn erf(self) -> Self {
        // Rising: the ends suffice.
        Interval::new(erf_point(self.lo()).lo(), erf_point(self.hi()).hi())
    }

    /// arccos x for every x of the interval within [0, 1]; beyond it what the nearer end gives.
    ///
    /// ```
    /// use bellfit::bound::Interval;
    /// let third = Interval::from(0.5).arccos(); // π/3
    /// assert!((third * Interval::from(3.0)).contains(core::f64::consts::PI) && third.width() < 1e-13);
    /// ```
    pub fn arccos(self) -> Self {
        // Falling.
        Interval::new(arccos_point(self.hi()).lo(), arccos_point(self.lo()).hi())
    }
}

fn erf_point(x: f64) -> Interval {
    if x < 0.0 {
        return -erf_point(-x);
    }
    if x > FAR {
        return Interval::new(erf_point(FAR).lo(), 1.0);
    }
    let v = Interval::from(x);
    let twice = Interval::from(2.0) * v.power(2);
    let (mut term, mut sum) = (v, v);
    for k in 1..ERF_TERMS {
        term = term * twice / Interval::int(2 * k + 1);
        sum = sum + term;
    }
    // From here each term is below half of the one before: 2x² ≤ 72 and 2k + 1 > 340.
    let tail = Interval::new(0.0, term.hi());
    let scale = Interval::from(2.0) / Interval::PI.square_root();
    let value = scale * (-v.power(2)).exp() * (sum + tail);
    Interval::new(value.lo().max(0.0), value.hi().min(1.0))
}

fn arccos_point(x: f64) -> Interval {
    let half_pi = Interval::PI / Interval::from(2.0);
    if x.is_nan() {
        return Interval::new(0.0, half_pi.hi());
    }
    if x <= 0.0 {
        return half_pi;
    }
    if x >= 1.0 {
        return Interval::from(0.0);
    }
    // arccos x = 2 arctan(z) with z = √((1 - x)/(1 + x)) ≤ 1; twice more halved, z ≤ tan(π/16).
    let one = Interval::from(1.0);
    let v = Interval::from(x);
    let mut z = ((one - v) / (one + v)).square_root();
    for _ in 0..2 {
        z = z / (one + (one + z.power(2)).square_root());
    }
    let square = z.power(2);
    let mut sum = Interval::from(0.0);
    for j in (0..=ARCTAN_DEGREE).rev() {
        sum = one / Interval::int(2 * j + 1) - square * sum;
    }
    // Alternating with falling terms: the first left out bounds the rest.
    let tail = square.power(ARCTAN_DEGREE as u32 + 1).hi();
    Interval::from(8.0) * z * (sum + Interval::new(-tail, tail))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arc_cosines_of_known_angles() {
        // cos(π/3) = ½, cos(π/4) = √½, cos(π/6) = √¾.
        let three_quarters = (Interval::from(3.0) / Interval::from(4.0)).square_root();
        for (cosine, parts) in
            [(Interval::from(0.5), 3), (Interval::from(0.5).square_root(), 4), (three_quarters, 6)]
        {
            let whole = cosine.arccos() * Interval::int(parts);
            assert!(whole.contains(Interval::PI.lo()) && whole.width() < 1e-13, "{parts}: {whole:?}");
        }
        assert_eq!(Interval::from(1.0).arccos(), Interval::from(0.0));
        assert!(Interval::from(0.0).arccos().contains(core::f64::consts::FRAC_PI_2));
    }

    /// The derivative 2/√π e^-x² bounds every difference.
    #[test]
    fn differences_of_erf_lie_between_its_slopes() {
        let scale = Interval::from(2.0) / Interval::PI.square_root();
        for i in 0..118 {
            let (a, b) = (Interval::from(0.05 * f64::from(i)), Interval::from(0.05 * f64::from(i + 1)));
            let quotient = (b.erf() - a.erf()) / (b - a);
            let slopes = scale * (-a.hull(b).power(2)).exp();
            assert!(!slopes.is_disjoint(quotient), "{a:?}: {quotient:?} {slopes:?}");
            assert!(b.erf().width() < 1e-12);
        }
        assert!(Interval::from(-1.0).erf().contains(-Interval::from(1.0).erf().mid()));
        assert!(Interval::WHOLE.erf().encloses(Interval::new(-1.0, 1.0)));
    }
}
