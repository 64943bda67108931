//! Enclosures hold the exact results, and not much more.

use super::*;
use dashu_ratio::RBig;

#[test]
fn operations_contain_exact_results() {
    // 0.1 + 0.2 as doubles is exactly representable in more bits; sums of integers scaled by
    // 2^-60 are exact in i128, an arithmetic outside the code under test.
    let scale = (1u64 << 60) as f64;
    let mut state = 12345u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as i64 - (1 << 52)
    };
    for _ in 0..2000 {
        let (a, b) = (next(), next());
        let (x, y) = (Interval::from(a as f64), Interval::from(b as f64));
        let product = i128::from(a) * i128::from(b);
        let p = x * y;
        assert!(p.lo() as i128 <= product && product <= p.hi() as i128);
        let sum = (x / Interval::from(scale)) + (y / Interval::from(scale));
        assert!(sum.lo() * scale <= (a + b) as f64 && (a + b) as f64 <= sum.hi() * scale);
        if b != 0 {
            let q = x / y;
            // q.lo ≤ a/b ≤ q.hi as q.lo b ≤ a ≤ q.hi b for b > 0, with the products enclosed.
            let back = q * y;
            assert!(back.contains(a as f64));
        }
    }
}

#[test]
fn powers_respect_the_sign() {
    let x = Interval::new(-0.5, 0.25);
    assert_eq!(x.power(2).lo(), 0.0);
    assert!(x.power(2).contains(0.25) && x.power(2).hi() < 0.2501);
    assert!(x.power(17).contains(-7.62939453125e-6) && x.power(17).lo() > -7.63e-6);
}

#[test]
fn what_is_not_known_is_not_excluded() {
    assert_eq!(Interval::new(f64::NAN, 1.0), Interval::WHOLE);
    assert_eq!(Interval::new(2.0, 1.0), Interval::WHOLE);
    assert_eq!(Interval::from(f64::NAN), Interval::WHOLE);
    assert_eq!(Interval::from(f64::INFINITY) + Interval::WHOLE, Interval::WHOLE);
    assert!(Interval::WHOLE.contains(Interval::WHOLE.mid()) && Interval::WHOLE.mid().is_finite());
    assert_eq!(Interval::from(1.0) / Interval::new(-1.0, 1.0), Interval::WHOLE);
    assert_eq!(Interval::from(-1.0) / Interval::new(0.0, 1.0), Interval::WHOLE);
    assert_eq!(Interval::from(0.0) / Interval::from(0.0), Interval::WHOLE);
}

#[test]
fn towards_zero_a_positive_quotient_grows_without_end() {
    let q = Interval::new(1.0, 2.0) / Interval::new(0.0, 4.0);
    assert!(q.lo() <= 0.25 && q.lo() > 0.2499 && q.hi() == f64::INFINITY);
    assert!((Interval::from(1.0) / Interval::from(0.0)).lo() >= f64::MAX);
}

#[test]
fn pi_and_ln_2_lie_inside() {
    // The next digits of π after its double 3.141592653589793115997963... are ...238462643,
    // of ln 2 after 0.693147180559945286226764 are ...309417232 (any table of constants).
    assert!(Interval::PI.width() < 1e-15 && Interval::LN_2.width() < 3e-16);
    assert!(Interval::PI.lo() < Interval::PI.hi());
}

fn draw(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    // Between -2 and 2 in steps of 2⁻⁵⁰.
    (*state >> 12) as f64 * libm::scalbn(1.0, -50) - 2.0
}

/// The range of an operation on points of two intervals, exactly, against ends that may be one double outside.
#[test]
fn ends_are_the_exact_ones_or_next_to_them() {
    let exact = |x: f64| crate::bound::exact(x).unwrap();
    let mut state = 3;
    for round in 0..400 {
        let mut side = || {
            let (a, b) = (draw(&mut state), draw(&mut state));
            // Points, intervals, and ends at 0.
            match round % 4 {
                0 => Interval::from(a),
                1 => Interval::new(a.min(0.0), a.max(0.0)),
                _ => Interval::new(a.min(b), a.max(b)),
            }
        };
        let (x, y) = (side(), side());
        let pairs = [(x.lo(), y.lo()), (x.lo(), y.hi()), (x.hi(), y.lo()), (x.hi(), y.hi())];
        let hold = |found: Interval, of: &dyn Fn(RBig, RBig) -> RBig, name: &str| {
            let values = pairs.map(|(a, b)| of(exact(a), exact(b)));
            let (lo, hi) = (values.iter().min().unwrap(), values.iter().max().unwrap());
            let name = format!("{x:?} {name} {y:?}: {found:?}");
            assert!(exact(found.lo()) <= *lo && *hi <= exact(found.hi()), "{name}");
            let inner = (found.lo().next_up().next_up(), found.hi().next_down().next_down());
            assert!(exact(inner.0) >= *lo && *hi >= exact(inner.1), "{name}");
        };
        hold(x + y, &|a, b| a + b, "+");
        hold(x - y, &|a, b| a - b, "-");
        hold(x * y, &|a, b| a * b, "×");
        if !y.contains(0.0) {
            hold(x / y, &|a, b| a / b, "/");
        }
        hold(-x, &|a, _| -a, "-");
        let bigger = x.hull(y);
        assert!(bigger.encloses(x) && bigger.encloses(y));
    }
}

#[test]
fn powers_are_the_powers_of_their_ends() {
    let exact = |x: f64| crate::bound::exact(x).unwrap();
    for (lo, hi) in [(0.5, 1.3), (-1.7, -0.3), (-0.7, 1.1), (-1.3, 0.2), (0.0, 0.9), (-0.9, 0.0), (0.7, 0.7)]
    {
        let x = Interval::new(lo, hi);
        for k in 0..=9_u32 {
            let found = x.power(k);
            let [a, b] = [lo, hi].map(|x| (0..k).fold(RBig::int(1), |p, _| p * exact(x)));
            let (mut least, most) = if a < b { (a, b) } else { (b, a) };
            if k > 0 && k % 2 == 0 && x.contains(0.0) {
                least = RBig::int(0);
            }
            assert!(exact(found.lo()) <= least && most <= exact(found.hi()), "{x:?}^{k}: {found:?}");
            // A product a bit of k, twice, each one double outside.
            let size = libm::pow(lo.abs().max(hi.abs()), f64::from(k));
            let room = 20.0 * f64::EPSILON * size;
            assert!(
                exact(found.lo() + room) >= least && most >= exact(found.hi() - room),
                "{x:?}^{k}: {found:?}"
            );
        }
        assert_eq!(x.power(0), Interval::from(1.0));
    }
    // Far below the least double the sign still holds.
    assert!(Interval::from(1e-200).power(2).lo() == 0.0 && Interval::from(-1e-200).power(3).hi() <= 0.0);
    assert!(Interval::from(-1e-200).power(3).lo() < 0.0);
}

#[test]
fn sets_are_compared_end_by_end() {
    let of = Interval::new;
    let x = of(-1.0, 2.0);
    assert!([-1.0, 0.0, 2.0].iter().all(|p| x.contains(*p)) && ![-1.1, 2.1].iter().any(|p| x.contains(*p)));
    for (y, inside, apart) in [
        (of(-1.0, 2.0), true, false),
        (of(-0.5, 1.0), true, false),
        (of(-1.5, 1.0), false, false),
        (of(0.0, 3.0), false, false),
        (of(2.0, 3.0), false, false),
        (of(-3.0, -1.0), false, false),
        (of(2.5, 3.0), false, true),
        (of(-3.0, -1.5), false, true),
    ] {
        assert_eq!((x.encloses(y), x.is_disjoint(y), y.is_disjoint(x)), (inside, apart, apart), "{y:?}");
    }
    assert_eq!(x.intersect(of(0.0, 5.0)), of(0.0, 2.0));
    assert_eq!(x.intersect(of(2.0, 5.0)), Interval::from(2.0));
    assert_eq!(x.intersect(of(3.0, 5.0)), x);
    assert_eq!(
        (x.abs(), of(1.0, 2.0).abs(), of(-3.0, -1.0).abs()),
        (of(0.0, 2.0), of(1.0, 2.0), of(1.0, 3.0))
    );
    assert_eq!(
        (of(-3.0, 2.0).abs(), of(-3.0, 0.0).abs(), of(0.0, 2.0).abs()),
        (of(0.0, 3.0), of(0.0, 3.0), of(0.0, 2.0))
    );
    assert_eq!((x.max(of(0.0, 1.0)), x.least(of(0.0, 1.0))), (of(0.0, 2.0), of(-1.0, 1.0)));
    assert_eq!(x.hull(of(-3.0, 1.0)), of(-3.0, 2.0));
    assert_eq!(x.bisect(), (of(-1.0, 0.5), of(0.5, 2.0)));
    assert!(x.width() >= 3.0 && x.width() <= 3.0_f64.next_up() && Interval::from(0.1).width() == 0.0);
    assert_eq!(Interval::new(1.0, 1.0), Interval::from(1.0));
}

#[test]
fn middles_are_finite_and_inside() {
    for (lo, hi, middle) in [
        (1.0, 2.0, 1.5),
        (-4.0, 2.0, -1.0),
        (f64::MIN, f64::MAX, 0.0),
        (f64::NEG_INFINITY, f64::INFINITY, 0.0),
        (f64::MIN, 0.5 * f64::MAX, -0.25 * f64::MAX),
        (0.0, f64::INFINITY, 0.5 * f64::MAX),
        (f64::INFINITY, f64::INFINITY, f64::INFINITY),
    ] {
        assert_eq!(Interval::new(lo, hi).mid(), middle, "{lo} {hi}");
    }
}

#[test]
fn roots_are_tight_and_never_negative() {
    let x = Interval::new(4.0, 9.0).square_root();
    assert!(x.lo() >= 2.0_f64.next_down() && x.lo() <= 2.0 && x.hi() >= 3.0 && x.hi() <= 3.0_f64.next_up());
    let two = Interval::from(2.0).square_root();
    let exact = |x: f64| crate::bound::exact(x).unwrap();
    let square = |x: f64| exact(x) * exact(x);
    assert!(square(two.lo()) < RBig::int(2) && RBig::int(2) < square(two.hi()) && two.width() < 5e-16);
    assert_eq!(Interval::new(-1.0, 0.0).square_root().lo(), 0.0);
    assert!(Interval::new(-1.0, 1.0).square_root().lo() == 0.0);
}

#[test]
fn infinite_ends_are_not_multiplied_by_0() {
    let (zero, far) = (Interval::ZERO, Interval::new(1.0, f64::INFINITY));
    assert_eq!((zero * far, far * zero), (Interval::WHOLE, Interval::WHOLE));
    assert_eq!((far / far, far * Interval::WHOLE), (Interval::WHOLE, Interval::WHOLE));
    let product = Interval::new(2.0, 3.0) * far;
    assert!(product.lo() <= 2.0 && product.lo() > 1.99 && product.hi() == f64::INFINITY);
    let quotient = Interval::from(1.0) / far;
    assert!(quotient.lo() <= 0.0 && quotient.lo() > -1e-300 && quotient.hi() >= 1.0 && quotient.hi() < 1.01);
    let negative = Interval::new(-3.0, -2.0) / Interval::new(-4.0, -2.0);
    assert!(negative.lo() <= 0.5 && negative.lo() > 0.499 && negative.hi() >= 1.5 && negative.hi() < 1.501);
    // Where 0 is the upper end of the divisor, or the dividend may be negative, nothing is known.
    for (x, y) in [((1.0, 2.0), (-1.0, 0.0)), ((-1.0, 2.0), (0.0, 1.0)), ((0.0, 2.0), (0.0, 0.0))] {
        assert_eq!(Interval::new(x.0, x.1) / Interval::new(y.0, y.1), Interval::WHOLE, "{x:?} {y:?}");
    }
    let upward = Interval::new(0.0, 2.0) / Interval::new(0.0, 4.0);
    assert!(upward.lo() <= 0.0 && upward.lo() > -1e-300 && upward.hi() == f64::INFINITY);
}
