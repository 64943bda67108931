//! How far a subject is from cosⁿ.

use super::cosines::{at, reach};
use super::element::Element;

/// Arguments with t in the range that times are taken of.
const INSIDE: u32 = 1 << 16;
/// Arguments over the rest of the hemisphere.
const BEYOND: u32 = 1 << 12;

/// Error against cosⁿ, absolute, where cosⁿ is 1 at its peak; sampled, so that the largest may be a little
/// larger in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// The largest, over 65536 cosines uniform in t = n (1 - cos θ) up to min(32, n), 4096 over the rest of the
    /// hemisphere, and cos θ = 1.
    pub sup: f64,
    /// The cosine where it is.
    pub at: f64,
    /// The mean over the first 65536.
    pub mean: f64,
}

impl Accuracy {
    /// Of code that takes cosines to values. The cosine counts as exact once it is in the format.
    pub(super) fn of<F: Element>(n: u32, run: impl Fn(&[F], &mut [F])) -> Accuracy {
        let end = reach(n);
        let inside = (0..INSIDE).map(|i| end * (f64::from(i) + 0.5) / f64::from(INSIDE));
        let rest = f64::from(n) - end;
        let beyond = (1..=BEYOND).map(|i| end + rest * f64::from(i) / f64::from(BEYOND));
        let cosines: Vec<F> = inside.chain(beyond).chain([0.0]).map(|t| at(n, t)).collect();
        let mut values = vec![F::ZERO; cosines.len()];
        run(&cosines, &mut values);
        let (mut sup, mut sup_at, mut sum) = (0.0, 1.0, 0.0);
        for (i, (cos, value)) in cosines.iter().zip(&values).enumerate() {
            let error = distance(value.to_f64(), cos.to_f64(), n);
            // A NaN is an error beyond all.
            if error > sup || error.is_nan() {
                (sup, sup_at) = (if error.is_nan() { f64::INFINITY } else { error }, cos.to_f64());
            }
            if i < INSIDE as usize {
                sum += error;
            }
        }
        Accuracy { sup, at: sup_at, mean: sum / f64::from(INSIDE) }
    }
}

/// |value - cosⁿ|, to some 2⁻⁵³ of itself.
fn distance(value: f64, cos: f64, n: u32) -> f64 {
    let (high, low) = power(cos, n);
    ((value - high) - low).abs()
}

/// cⁿ as an unevaluated sum of two doubles, c in [0, 1] and n ≥ 1: squarings in twice the precision, relative
/// error about n 2⁻¹⁰⁴ as long as nothing underflows, and below 1e-290 then.
fn power(c: f64, n: u32) -> (f64, f64) {
    // Products as T. J. Dekker, Numerische Mathematik 18, 1971, with the fused multiply-add for his split.
    let times = |(a, b): (f64, f64), (c, d): (f64, f64)| {
        let high = a * c;
        let low = libm::fma(a, c, -high) + (a * d + b * c);
        let sum = high + low;
        (sum, low - (sum - high))
    };
    let base = (c, 0.0);
    let mut power = base;
    for bit in (0..n.ilog2()).rev() {
        power = times(power, power);
        if (n >> bit) & 1 == 1 {
            power = times(power, base);
        }
    }
    power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::power_of_ten;
    use crate::integral::Field;
    use dashu_ratio::RBig;

    #[test]
    fn the_reference_has_twice_the_digits() {
        let tiny = power_of_ten(-28);
        for n in [16, 64, 100, 1023] {
            for c in [1.0, 0.999, 0.9, 0.75, 0.5] {
                let (high, low) = power(c, n);
                let exact = |x: f64| RBig::try_from(x).unwrap();
                let whole = (0..n).fold(RBig::int(1), |product, _| product * exact(c));
                let off = exact(high) + exact(low) - whole.clone();
                let off = if off < RBig::int(0) { RBig::int(0) - off } else { off };
                // n 2⁻¹⁰⁴ is 5e-29 at n = 1023.
                assert!(off <= whole * tiny.clone(), "{c}^{n}");
            }
        }
    }

    #[test]
    fn errors_are_those_put_in() {
        // cosⁿ moved by a bump at one argument, and by a constant.
        let moved = |by: f64| {
            Accuracy::of::<f64>(64, |x, out| {
                for (x, out) in x.iter().zip(out) {
                    *out = power(*x, 64).0 + by;
                }
            })
        };
        let found = moved(0.25);
        assert!((found.sup - 0.25).abs() < 1e-15 && (found.mean - 0.25).abs() < 1e-13);
        let one = Accuracy::of::<f64>(64, |x, out| {
            for (x, out) in x.iter().zip(out) {
                *out = if *x == 1.0 { 0.5 } else { power(*x, 64).0 };
            }
        });
        assert_eq!((one.sup, one.at), (0.5, 1.0));
        let broken = Accuracy::of::<f32>(64, |_, out| out[7] = f32::NAN);
        assert_eq!(broken.sup, f64::INFINITY);
    }
}
