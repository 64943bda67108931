//! The tails of the χ² distribution.

use core::f64::consts::PI;

/// (P(X < x), P(X > x)), X of the χ² distribution with so many degrees of freedom; the smaller of the two is not the
/// difference of the other from 1, and keeps its digits.
///
/// Source: the regularised incomplete gamma functions P(a, y) and Q(a, y), a = degrees/2 and y = x/2: below their
/// middle the series, Abramowitz & Stegun 6.5.29, above it the continued fraction, ibid. 6.5.31, by Lentz's method.
///
/// Domain: x ≥ 0, which may be infinite, and one degree or more; else NaN. Accuracy: relative 1e-11 for the smaller
/// tail down to 1e-260 and up to five million degrees, tested against a table of 25 digits; far below it is 0.
///
/// ```
/// use bellfit::fit::measured::chi_square_tails;
/// let (below, above) = chi_square_tails(18.307, 10); // the printed tables' 5 %
/// assert!((above - 0.05).abs() < 1e-5 && (below - 0.95).abs() < 1e-5);
/// ```
pub fn chi_square_tails(x: f64, degrees: usize) -> (f64, f64) {
    if x.is_nan() || x < 0.0 || degrees == 0 {
        return (f64::NAN, f64::NAN);
    }
    let (a, y) = (0.5 * degrees as f64, 0.5 * x);
    if y == 0.0 {
        (0.0, 1.0)
    } else if y == f64::INFINITY {
        (1.0, 0.0)
    } else if y < a + 1.0 {
        let below = (term(a, y) * series(a, y)).min(1.0);
        (below, 1.0 - below)
    } else {
        let above = (a * term(a, y) * fraction(a, y)).min(1.0);
        (1.0 - above, above)
    }
}

/// From here on Γ is taken by Stirling's series, whose first term left out is 1/(1188 a⁹) = 1.3e-14.
const LARGE: f64 = 16.0;

/// yᵃ e⁻ʸ/Γ(a + 1). Of a large a its parts are large and nearly cancel: their difference is formed from
/// μ = (y - a)/a instead.
fn term(a: f64, y: f64) -> f64 {
    if a < LARGE {
        return libm::exp(a * libm::log(y) - y - libm::lgamma(a + 1.0));
    }
    let mu = (y - a) / a;
    let m = 1.0 / (a * a);
    let stirling = (1.0 / 12.0 - m * (1.0 / 360.0 - m * (1.0 / 1260.0 - m / 1680.0))) / a;
    // Far from the middle it is y/a that has the digits, near to it μ.
    let log = if mu.abs() < 0.5 { libm::log1p(mu) } else { libm::log(y / a) };
    libm::exp(-a * (mu - log) - stirling) / (2.0 * PI * a).sqrt()
}

/// 1 + y/(a + 1) + y²/((a + 1)(a + 2)) + …: about √a terms and forty, as y < a + 1.
fn series(a: f64, y: f64) -> f64 {
    let (mut term, mut sum, mut k) = (1.0, 1.0, a);
    while term > f64::EPSILON * 0.1 * sum {
        k += 1.0;
        term *= y / k;
        sum += term;
    }
    sum
}

/// Levels of the fraction at most: it settles after about √a of them, and a is 2.5 million at most.
const LEVELS: u32 = 1_000_000;

/// 1/(y + 1 - a - 1 (1 - a)/(y + 3 - a - 2 (2 - a)/(y + 5 - a - …))).
fn fraction(a: f64, y: f64) -> f64 {
    let mut b = y + 1.0 - a;
    // b is at least 2, as y ≥ a + 1, and the denominators stay positive: no guard against 0 is needed.
    let mut d = 1.0 / b;
    let (mut c, mut value) = (f64::INFINITY, d);
    for k in (1..LEVELS).map(f64::from) {
        let numerator = -k * (k - a);
        b += 2.0;
        d = 1.0 / (b + numerator * d);
        c = b + numerator / c;
        let step = c * d;
        value *= step;
        if (step - 1.0).abs() < f64::EPSILON {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of even degrees P(X > x) is the sum e⁻ʸ (1 + y + y²/2 + … ) of degrees/2 terms: both sides of the middle, and of
    /// where Stirling's series takes over.
    #[test]
    fn even_degrees_have_a_finite_sum() {
        for half in [1_u32, 2, 15, 16, 17, 40] {
            for y in [0.01, 0.5, 1.9, 8.0, 16.9, 17.1, 30.0, 45.0, 80.0] {
                let (mut term, mut sum) = (1.0, 1.0);
                for k in 1..half {
                    term *= y / f64::from(k);
                    sum += term;
                }
                let exact = libm::exp(-y) * sum;
                let (below, above) = chi_square_tails(2.0 * y, 2 * half as usize);
                // Where the upper tail is nearly 1 it is 1 less the other.
                assert!((above / exact - 1.0).abs() < 1e-12, "{half} {y}: {above} {exact}");
                assert!((below + above - 1.0).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn ends_and_what_lies_outside() {
        assert_eq!(chi_square_tails(0.0, 3), (0.0, 1.0));
        assert_eq!(chi_square_tails(f64::INFINITY, 3), (1.0, 0.0));
        assert_eq!(chi_square_tails(1e300, 3), (1.0, 0.0));
        for (x, degrees) in [(-1.0, 3), (f64::NAN, 3), (1.0, 0)] {
            assert!(chi_square_tails(x, degrees).0.is_nan());
        }
    }
}
