//! cosⁿ in lanes: 2^(n log₂ c).

use super::exponential::{exp2_flushed, scaled};
use super::lanes::Lanes;
use std::array::from_fn;

/// cosⁿ through log₂ and 2ʸ in the type itself; n log₂ c is rounded, so the relative error grows with it.
/// Subnormal results are 0.
#[inline(always)]
pub(super) fn exp2_log2<const FUSED: bool, F: Lanes>(cos: F, n: F) -> F {
    let c = cos.positive();
    let [lift, steps] = F::LIFT;
    let subnormal = c < F::LEAST;
    let (m, e) = (if subnormal { c * lift } else { c }).split();
    let e = if subnormal { e - steps } else { e };
    let f = m - F::ONE;
    let log = ends(c, F::fma::<FUSED>(f, f.polynomial::<FUSED>(F::LOG2), e));
    // At 0·∞ 1 as pow has it, but NaN for c = ∞ with n = 0, as the scalar has it.
    let one = log == F::ZERO || (n == F::ZERO && log != F::INFINITY);
    let y = if one { F::ZERO } else { n * log };
    let value = exp2_flushed::<FUSED, F>(y);
    if cos.is_nan() || n.is_nan() || y.is_nan() { F::NAN } else { value }
}

/// n log₂ c for c ≤ 1 and n > 1, with the bits that [`exp2_log2`] has; c below the least normal number counts
/// as that, whose power is flushed too.
#[inline(always)]
pub(super) fn exponents<const FUSED: bool, F: Lanes, const U: usize>(c: [F; U], n: [F; U]) -> [F; U] {
    let split = c.map(|c| (if F::LEAST > c { F::LEAST } else { c }).split());
    let f = split.map(|(m, _)| m - F::ONE);
    let p = F::polynomials::<FUSED, U>(f, F::LOG2);
    from_fn(|j| n[j] * F::fma::<FUSED>(f[j], p[j], split[j].1))
}

/// `log`, but -∞ at c = 0 and ∞ at ∞.
#[inline(always)]
fn ends<F: Lanes>(c: F, log: F) -> F {
    let log = if c == F::INFINITY { c } else { log };
    if c == F::ZERO { -F::INFINITY } else { log }
}

/// c = cos θ not below 0, from the cosine or the versine.
#[inline(always)]
fn cosine<const VERSINE: bool>(x: f64) -> f64 {
    (if VERSINE { 1.0 - x } else { x }).positive()
}

/// c's significand less 1. Of a versine with c about 1 it is the versine itself, which c has rounded away.
#[inline(always)]
fn excess<const VERSINE: bool>(x: f64, m: f64, e: f64) -> f64 {
    if VERSINE && e == 0.0 { -x } else { m - 1.0 }
}

/// Where n log₂ c is 0·∞: 1 as pow has it, but NaN for the versine -∞ with n = 0, as the scalar has it.
#[inline(always)]
fn is_one<const VERSINE: bool>(n: f64, log: f64) -> bool {
    log == 0.0 || (n == 0.0 && !(VERSINE && log == f64::INFINITY))
}

/// Through `f64`, in which a cosine, n and the result's exponent have digits to spare and subnormal numbers
/// of `f32` are normal; rounded once to `f32` at the end.
#[inline(always)]
pub(super) fn f32<const FUSED: bool, const VERSINE: bool, const U: usize>(
    x: [f32; U],
    n: [f32; U],
) -> [f32; U] {
    let (x, n) = (x.map(f64::from), n.map(f64::from));
    let c = x.map(cosine::<VERSINE>);
    let split = c.map(Lanes::split);
    let f = from_fn(|j| excess::<VERSINE>(x[j], split[j].0, split[j].1));
    let p = f64::polynomials::<FUSED, U>(f, &LOG2);
    let y: [f64; U] = from_fn(|j| {
        let log = ends(c[j], f64::fma::<FUSED>(f[j], p[j], split[j].1));
        if is_one::<VERSINE>(n[j], log) { 0.0 } else { n[j] * log }
    });
    let inside = y.map(|y| y.clamped(-200.0, 200.0));
    let whole = inside.map(|y| y + f64::ROUND);
    let g = from_fn(|j| inside[j] - (whole[j] - f64::ROUND));
    let p = f64::polynomials::<FUSED, U>(g, &EXP2);
    from_fn(|j| {
        let value = f64::fma::<FUSED>(g[j], p[j], 1.0).shifted(whole[j]) as f32;
        if x[j].is_nan() || n[j].is_nan() || y[j].is_nan() { f32::NAN } else { value }
    })
}

/// log₂(1 + f)/f on 1 + f in [√½, √2]: relative error 1.7e-11, so n log₂ c of at most 150 is off by 3e-9.
const LOG2: [f64; 13] = [
    1.4426950408686052,
    -0.7213475208713045,
    0.48089836144701786,
    -0.36067367444750575,
    0.28853728905519777,
    -0.24045317966653565,
    0.20617549722505846,
    -0.18030044561841702,
    0.15876796997045825,
    -0.14315631562795236,
    0.14475773146322188,
    -0.1428463718501339,
    0.07736386886411402,
];

/// (2ᶠ - 1)/f on |f| ≤ ½: relative error 2.4e-10.
const EXP2: [f64; 7] = [
    0.6931471805816171,
    0.24022650920784983,
    0.055504107276010024,
    0.009618056919281814,
    0.001333366926060362,
    0.00015461367631765515,
    1.5252800660260042e-05,
];

/// Through a logarithm of two doubles, high + low.
///
/// log₂ m = (2/ln 2) s (1 + s²/3 + s⁴ R(s²)), s = f/(2 + f), m = 1 + f. All that counts beyond the 53rd bit is
/// kept: s, s², the sum and the products.
#[inline(always)]
pub(super) fn f64<const FUSED: bool, const VERSINE: bool, const U: usize>(
    x: [f64; U],
    n: [f64; U],
) -> [f64; U] {
    // Not by a closure, which is too large to be inlined: see `Job`.
    let mut powers = x;
    for (x, n) in powers.iter_mut().zip(n) {
        *x = double::<FUSED, VERSINE>(*x, n);
    }
    powers
}

/// One of them.
#[inline(always)]
fn double<const FUSED: bool, const VERSINE: bool>(x: f64, n: f64) -> f64 {
    const THIRD: [f64; 2] = [0.3333333333333333, 1.850371707708594e-17];
    const TWO_LOG2_E: [f64; 2] = [2.8853900817779268, 4.0710547481862066e-17];
    let c = cosine::<VERSINE>(x);
    let [lift, steps] = f64::LIFT;
    let subnormal = c < f64::LEAST;
    let (m, e) = (if subnormal { c * lift } else { c }).split();
    let e = if subnormal { e - steps } else { e };
    let f = excess::<VERSINE>(x, m, e);
    // s = f/g, g = 2 + f, and what the division left.
    let g = 2.0 + f;
    let g_low = f - (g - 2.0);
    let inverse = 1.0 / g;
    let s = f * inverse;
    let (p, p_low) = product::<FUSED>(s, g);
    // Between 0.29 and 0.5 a versine leaves more digits than its cosine has; c is in [½, √½) there.
    let f_low = if VERSINE && e == -1.0 { 2.0 * ((1.0 - c) - x) } else { 0.0 };
    let s_low = (((f - p) - p_low) - s * g_low + f64::fma::<FUSED>(-s, f_low, f_low)) * inverse;
    let (q, q_low) = product::<FUSED>(s, s);
    let q_low = f64::fma::<FUSED>(2.0 * s, s_low, q_low);
    // 1/3 + q R(q), q times that, 1 + that
    let (a, a_low) = sum(THIRD[0], q * q.polynomial::<FUSED>(&ATANH));
    let a_low = a_low + THIRD[1];
    let (b, b_low) = product::<FUSED>(q, a);
    let b_low = b_low + f64::fma::<FUSED>(q, a_low, q_low * a);
    let (d, d_low) = sum(1.0, b);
    let d_low = d_low + b_low;
    // times s, times 2/ln 2, plus e
    let (t, t_low) = product::<FUSED>(s, d);
    let t_low = t_low + f64::fma::<FUSED>(s, d_low, s_low * d);
    let (l, l_low) = product::<FUSED>(t, TWO_LOG2_E[0]);
    let l_low = l_low + f64::fma::<FUSED>(t, TWO_LOG2_E[1], t_low * TWO_LOG2_E[0]);
    let (high, low) = sum(e, l);
    let (high, low) = (ends(c, high), low + l_low);
    // The least versines, halved on the way, are not 0.
    let high = if VERSINE && high == 0.0 { -x } else { high };
    // n times it; beyond the range, at 0·∞ and for an n of no use the low part has no meaning.
    let (y, y_low) = product::<FUSED>(n, high);
    let y_low = f64::fma::<FUSED>(n, low, y_low);
    let one = is_one::<VERSINE>(n, high);
    let y = if one { 0.0 } else { y };
    let y_low = if !one && y_low.abs() < 1.0 && y.abs() < 1100.0 { y_low } else { 0.0 };
    let inside = y.clamped(-1100.0, 1100.0);
    let k = (inside + f64::ROUND) - f64::ROUND;
    let g = (inside - k) + y_low;
    let p = f64::fma::<FUSED>(g, g.polynomial::<FUSED>(f64::EXP2), 1.0);
    let value = scaled::<FUSED, f64>(p, k);
    if x.is_nan() || n.is_nan() || y.is_nan() { f64::NAN } else { value }
}

/// R of (artanh s)/s = 1 + s²/3 + s⁴ R(s²), s² ≤ 0.0295: relative error 4.6e-18.
const ATANH: [f64; 8] = [
    0.2,
    0.14285714285714685,
    0.11111111110827618,
    0.0909090916775894,
    0.07692297475560081,
    0.06667402612282608,
    0.058531120752858254,
    0.05861643969240314,
];

/// a + b and what its rounding lost, for |a| ≥ |b| or a = 0 (Dekker 1971).
#[inline(always)]
fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a b and what its rounding lost: by a fused multiply-add, or by Veltkamp's halves (Dekker 1971), which
/// overflow beyond 2⁹⁹⁶.
#[inline(always)]
fn product<const FUSED: bool>(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if FUSED {
        return (product, a.mul_add(b, -product));
    }
    let halves = |x: f64| {
        let scaled = x * 134_217_729.0; // 2²⁷ + 1
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let ((a, a_low), (b, b_low)) = (halves(a), halves(b));
    (product, ((a * b - product) + a * b_low + a_low * b) + a_low * b_low)
}
