//! Evaluations of lobes, bells and factors: each draws arguments, runs the kernel and its formula, and says by what
//! the error is divided.

use crate::exact::*;
use crate::references::rows;
use crate::seen::Seen;
use crate::{Draw, pick, pick_log};
use bellfit::kernel::bell::bell;
use bellfit::kernel::constants::{
    CS16_MINIMAX, CS16_ONE_SIDED, CS16_PRINTED, CUBIC_COS_N, CUBIC_EXP, LINEAR_COS_N,
};
use bellfit::kernel::cubic::{BellFormula, CubicLobe, cubic_bell, cubic_lobe};
use bellfit::kernel::exact::{cs_16_factor_exact, cs_factor};
use bellfit::kernel::factor::{
    LinearFactor, cos_n_factor, cs_16_factor, cs_16_factor_one_sided, cs_16_factor_printed, cubic_factor,
};
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::lobe::*;
use bellfit::kernel::model::Model;
use bellfit::kernel::power::{cos_n_exp2, cos_n_whole};
use bellfit::kernel::prepared::Prepared;
use bellfit::kernel::real::Real;
use bellfit::kernel::shading::{PhongLambert, phong_lambert, phong_lambert_with};
use bellfit::kernel::stand_in::StandIn;
use bellfit::stability::{Angle, Factor};

/// Runs `$body` with K bound to a constant drawn from a list.
macro_rules! one_of {
    ($draw:expr, [$($k:literal),+], $body:ident) => {{
        let all = [$($k),+];
        let chosen: u32 = all[$draw.below(all.len())];
        match chosen {
            $($k => { const K: u32 = $k; $body!(K) })+
            _ => unreachable!(),
        }
    }};
}

pub fn bell_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let t: F = pick(draw, 0.0, 0.6 * f64::from($k));
            let (exact, _) = lyon($k, x(t));
            let scale = exact.to_f64() * f64::from(2 * $k - 1);
            seen.of(bell::<$k, F>(t), exact, scale, &[f64::from($k), t.to_f64()]);
        }};
    }
    one_of!(draw, [2, 4, 8, 16, 32, 64], body)
}

pub fn bell_formula<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let formulas: Vec<&BellFormula> = LINEAR_COS_N.iter().chain(&CUBIC_COS_N).collect();
    let formula = formulas[draw.below(formulas.len())];
    let n: F = pick_log(draw, 16.0, 1e6);
    let (reach, linear, square) = formula.at(n);
    let m = 1.0 / n.to_f64();
    let size = |[a, b, c]: [f64; 3]| a.abs() + m * b.abs() + m * m * c.abs();
    let parts = [(reach, formula.reach), (linear, formula.linear), (square, formula.square)];
    for ((value, row), exact) in parts.into_iter().zip(at_exponent(formula, x(n))) {
        seen.of(value, exact, size(row), &[f64::from(formula.power), n.to_f64()]);
    }
}

pub fn cubic_bell_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let t: F = pick(draw, 0.0, 16.0);
            let [c1, c2, c3] = CUBIC_EXP[$k.ilog2() as usize - 1].map(number);
            let y = x(t) / number(f64::from($k));
            let p = number(1.0) - y * (c1 - y * (c2 - y * c3));
            let exact = if p.to_f64() > 0.0 { power(p, $k) } else { number(0.0) };
            seen.of(cubic_bell::<$k, F>(t), exact, f64::from($k), &[f64::from($k), t.to_f64()]);
        }};
    }
    one_of!(draw, [2, 4, 8], body)
}

/// Constants of n computed in the type, against the formulas.
pub fn linear_constants<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let n: F = pick_log(draw, 16.0, 1e6);
            let fitted = draw.below(2) == 0;
            let reach = at_exponent(&LINEAR_COS_N[$k.ilog2() as usize - 1], x(n))[0];
            let slope = x(n) / if fitted { reach } else { number(f64::from($k)) };
            let lobe = if fitted { LinearLobe::<$k, F>::new(n) } else { LinearLobe::lyon(n) };
            let [offset, s] = lobe.constants();
            let at = [f64::from($k), n.to_f64()];
            seen.relative(s, slope, &at);
            seen.of(offset, number(1.0) - slope, slope.to_f64() + 1.0, &at);
        }};
    }
    one_of!(draw, [2, 4, 8, 16, 32], body)
}

/// Constants rounded from f64, against the f64 ones.
pub fn converted<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let n = draw.real(16.0, 1e4);
    let double = LinearLobe::<16, f64>::new(n);
    for (value, exact) in double.convert::<F>().constants().into_iter().zip(double.constants()) {
        seen.relative(value, number(exact), &[n]);
    }
    let double = CubicLobe::<4, f64>::new(n);
    let rounded = double.convert::<F>();
    for (value, exact) in rounded.horner().into_iter().zip(double.horner()) {
        seen.relative(value, number(exact), &[n]);
    }
    for (value, exact) in rounded.depressed().into_iter().zip(double.depressed()) {
        seen.relative(value, number(exact), &[n]);
    }
}

/// k₁, k₂, k₃ against the formulas of T, α and β.
pub fn horner<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let n: F = pick_log(draw, 16.0, 1e6);
            let [reach, linear, square] = at_exponent(&CUBIC_COS_N[$k.ilog2() as usize - 1], x(n));
            let r = x(n) / reach;
            let exact = [(number(1.0) - linear) * r, (square - linear) * r * r, square * r * r * r];
            for (value, exact) in CubicLobe::<$k, F>::new(n).horner().into_iter().zip(exact) {
                seen.relative(value, exact, &[f64::from($k), n.to_f64()]);
            }
        }};
    }
    one_of!(draw, [2, 4, 8], body)
}

/// u³ + c u + d of the depressed constants in exact arithmetic, against p of the formulas, over c = cos θ in [0, 1]:
/// what the constants' own rounding does.
pub fn depressed<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let n: F = pick_log(draw, 16.0, 1e4);
            let formula = &CUBIC_COS_N[$k.ilog2() as usize - 1];
            let ([reach, linear, square], one) = (at_exponent(formula, x(n)), number(1.0));
            // Inside the bell's support.
            let w = number(draw.real(0.0, reach.to_f64() / n.to_f64()));
            let y = x(n) * w / reach;
            let exact = (one - y) * (one + y * (linear + y * square));
            let [a, b, c, d] = CubicLobe::<$k, F>::new(n).depressed().map(x);
            let u = a + b * (one - w);
            let error = (u * u * u + c * u + d - exact).abs().to_f64();
            seen.off(error, n.to_f64(), &[f64::from($k), n.to_f64(), w.to_f64()]);
        }};
    }
    one_of!(draw, [2, 4], body)
}

/// (n, w) with t = n w up to 24, so inside every bell's support and a little beyond.
fn exponent_and_versine<F: Real>(draw: &mut Draw) -> (F, F) {
    let n: F = pick_log(draw, 16.0, 1000.0);
    (n, pick(draw, 0.0, (24.0 / n.to_f64()).min(1.0)))
}

macro_rules! bell_lobes {
    ($from_cosine:ident, $from_versine:ident, $lobe:ident, $rows:ident, [$($k:literal),+], $powers:expr) => {
        pub fn $from_cosine<F: Real>(draw: &mut Draw, seen: &mut Seen) {
            macro_rules! body {
                ($kk:ident) => {{
                    let (n, w) = exponent_and_versine::<F>(draw);
                    let c = F::ONE - w;
                    let exact = fitted(&$rows[$powers($kk)], x(n), number(1.0) - x(c));
                    let scale = f64::from($kk) + n.to_f64();
                    seen.of($lobe::<$kk, F>::new(n).at(c), exact, scale, &[f64::from($kk), n.to_f64(), c.to_f64()]);
                }};
            }
            one_of!(draw, [$($k),+], body)
        }

        pub fn $from_versine<F: Real>(draw: &mut Draw, seen: &mut Seen) {
            macro_rules! body {
                ($kk:ident) => {{
                    let (n, w) = exponent_and_versine::<F>(draw);
                    let exact = fitted(&$rows[$powers($kk)], x(n), x(w));
                    let lobe = $lobe::<$kk, F>::new(n);
                    seen.of(lobe.at_versine(w), exact, f64::from($kk), &[f64::from($kk), n.to_f64(), w.to_f64()]);
                }};
            }
            one_of!(draw, [$($k),+], body)
        }
    };
}
bell_lobes!(linear_at, linear_at_versine, LinearLobe, LINEAR_COS_N, [2, 4, 8, 16, 32], |k: u32| k.ilog2()
    as usize
    - 1);
bell_lobes!(cubic_at, cubic_at_versine, CubicLobe, CUBIC_COS_N, [2, 4, 8], |k: u32| k.ilog2() as usize - 1);

pub fn cubic_lobe_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (n, w) = exponent_and_versine::<F>(draw);
    let c = F::ONE - w;
    let exact = fitted(&CUBIC_COS_N[1], x(n), number(1.0) - x(c));
    seen.of(cubic_lobe::<4, F>(c, n), exact, 4.0 + n.to_f64(), &[n.to_f64(), c.to_f64()]);
}

pub fn versine_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let theta: F = pick_log(draw, 1e-6, 1.5);
    seen.relative(versine(theta), Angle::of(theta.to_f64()).versine(), &[theta.to_f64()]);
}

pub fn cos_n_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, n): (F, F) = (pick(draw, 0.3, 1.0), pick(draw, 0.0, 64.0));
    seen.relative(cos_n(c, n), real_power(x(c), x(n)), &[c.to_f64(), n.to_f64()]);
}

pub fn cos_n_exp2_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, n): (F, F) = (pick(draw, 0.3, 1.0), pick(draw, 0.5, 64.0));
    let exact = real_power(x(c), x(n));
    let exponent = (x(n) * ln(x(c))).to_f64().abs();
    seen.of(cos_n_exp2(c, n), exact, exact.to_f64() * (2.0 + 3.0 * exponent), &[c.to_f64(), n.to_f64()]);
}

pub fn cos_n_whole_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, n): (F, u32) = (pick(draw, 0.3, 1.0), 1 + draw.below(64) as u32);
    let exact = power(x(c), n);
    let scale = exact.to_f64() * f64::from(n - 1);
    seen.of(cos_n_whole(c, n), exact, scale, &[c.to_f64(), f64::from(n)]);
}

pub fn cos_n_versine_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (n, w) = exponent_and_versine::<F>(draw);
    let w = w.min(F::from_f64(0.7));
    let exponent = x(n) * x(w).log_one_minus();
    if exponent.to_f64() < -80.0 {
        return;
    }
    let scale = exponent.exp().to_f64() * (2.0 + 3.0 * exponent.to_f64().abs());
    seen.of(cos_n_versine(w, n), exponent.exp(), scale, &[w.to_f64(), n.to_f64()]);
}

/// Below, the last squarings underflow in f32, and no relative accuracy is promised.
const UNDERFLOWS: f64 = 1e-30;

macro_rules! lyon_lobe {
    ($k:ident, $n:expr, $w:expr, $roundings:expr) => {{
        let t = x($n) * $w;
        let (exact, slope) = lyon($k, t);
        (exact, exact.to_f64() * f64::from(2 * $k - 1) + $roundings * t.to_f64().abs() * slope)
    }};
}

pub fn cs_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let (n, w) = exponent_and_versine::<F>(draw);
            let c = F::ONE - w;
            let (exact, scale) = lyon_lobe!($k, n, number(1.0) - x(c), 2.0);
            if exact.to_f64() < UNDERFLOWS {
                return;
            }
            seen.of(cs::<$k, F>(c, n), exact, scale, &[f64::from($k), c.to_f64(), n.to_f64()]);
        }};
    }
    one_of!(draw, [2, 4, 8, 16, 32, 64], body)
}

pub fn cs_versine_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    macro_rules! body {
        ($k:ident) => {{
            let (n, w) = exponent_and_versine::<F>(draw);
            let (exact, scale) = lyon_lobe!($k, n, x(w), 1.0);
            if exact.to_f64() < UNDERFLOWS {
                return;
            }
            seen.of(cs_versine::<$k, F>(w, n), exact, scale, &[f64::from($k), w.to_f64(), n.to_f64()]);
        }};
    }
    one_of!(draw, [2, 4, 8, 16, 32, 64], body)
}

pub fn cs_16_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    const K: u32 = 16;
    let (n, w) = exponent_and_versine::<F>(draw);
    let c = F::ONE - w;
    let (exact, scale) = lyon_lobe!(K, n, number(1.0) - x(c), 2.0);
    if exact.to_f64() < UNDERFLOWS {
        return;
    }
    seen.of(cs_16(c, n), exact, scale, &[c.to_f64(), n.to_f64()]);
}

pub fn cs_16_cut_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    const K: u32 = 16;
    let n: F = pick_log(draw, 16.0, 1000.0);
    let theta: F = pick(draw, 0.0, 5.0 / libm::sqrt(n.to_f64()));
    // versine's five, the product and the difference.
    let (exact, scale) = lyon_lobe!(K, n, Angle::of(theta.to_f64()).versine(), 7.0);
    seen.of(cs_16_cut(theta, n, F::TWO), exact, scale, &[theta.to_f64(), n.to_f64()]);
}

pub fn cut_exact_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let n: F = pick_log(draw, 16.0, 1e6);
    // 2 arcsin s, s² = 8/n, of which arctan2(s, √(1 - s²)) is half.
    let square = number(8.0) / x(n);
    let exact = number(2.0) * arctan2(square.sqrt(), (number(1.0) - square).sqrt());
    seen.relative(cut_exact(n), exact, &[n.to_f64()]);
}

pub fn cut_paper_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let n: F = pick_log(draw, 1e-3, 1e6);
    seen.relative(cut_paper(n), number(6.0) / x(n).sqrt(), &[n.to_f64()]);
}

pub fn cut_card_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let n: F = pick_log(draw, 1e-3, 1e6);
    seen.relative(cut_card(n), (number(6.0) / x(n)).sqrt(), &[n.to_f64()]);
}

pub fn schlick_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, n): (F, F) = (pick(draw, 1e-3, 1.0), pick_log(draw, 0.1, 1e4));
    let exact = x(c) / (x(c) + x(n) * (number(1.0) - x(c)));
    seen.relative(schlick(c, n), exact, &[c.to_f64(), n.to_f64()]);
}

pub fn schlick_printed_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, n): (F, F) = (pick(draw, 1e-3, 1.0), pick_log(draw, 0.1, 1e3));
    let below = x(c) + x(n) * (number(1.0) - x(c));
    // A product, two sums and the quotient, the first three by the denominator.
    let lost = (n.to_f64() * (c.to_f64() + 1.0 - c.to_f64()) + below.to_f64()) / below.to_f64();
    let exact = x(c) / below;
    seen.of(schlick_printed(c, n), exact, exact.to_f64() * (1.0 + lost), &[c.to_f64(), n.to_f64()]);
}

pub fn spherical<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (c, l): (F, F) = (pick(draw, 0.0, 1.0), pick_log(draw, 0.1, 60.0));
    let exponent = x(l) * (number(1.0) - x(c));
    let exact = (-exponent).exp();
    let scale = exact.to_f64() * (2.0 + 2.0 * exponent.to_f64());
    seen.of(spherical_gaussian(c, l), exact, scale, &[c.to_f64(), l.to_f64()]);
}

pub fn spherical_versine<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (w, l): (F, F) = (pick(draw, 0.0, 1.0), pick_log(draw, 0.1, 60.0));
    let exponent = x(l) * x(w);
    let exact = (-exponent).exp();
    let scale = exact.to_f64() * (2.0 + exponent.to_f64());
    seen.of(spherical_gaussian_versine(w, l), exact, scale, &[w.to_f64(), l.to_f64()]);
}

pub fn gaussian_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (theta, n): (F, F) = (pick(draw, 0.0, 1.5), pick_log(draw, 0.1, 60.0));
    let exponent = number(0.5) * x(n) * x(theta) * x(theta);
    let exact = (-exponent).exp();
    let scale = exact.to_f64() * (2.0 + 2.0 * exponent.to_f64());
    seen.of(gaussian(theta, n), exact, scale, &[theta.to_f64(), n.to_f64()]);
}

/// What a stand-in stands for at n and w by its formula.
pub fn meant(stand_in: StandIn, n: Exact, w: Exact) -> Exact {
    if let Some(formula) = stand_in.formula() {
        return fitted(&formula, n, w);
    }
    let c = number(1.0) - w;
    match stand_in {
        StandIn::Schlick | StandIn::SchlickPrinted => c / (c + n * w),
        StandIn::SphericalGaussian => (-(n * w)).exp(),
        _ if c.to_f64() <= 0.0 => number(0.0),
        _ => (n * w.log_one_minus()).exp(),
    }
}

/// A stand-in, a whole n that both types hold, and w.
fn stand_in_at<F: Real>(draw: &mut Draw) -> (StandIn, F, F) {
    let stand_in = StandIn::ALL[draw.below(StandIn::ALL.len())];
    let n = F::from_f64(libm::round(draw.real(16.0, 1000.0)));
    (stand_in, n, pick(draw, 0.0, (24.0 / n.to_f64()).min(0.99)))
}

pub fn stand_in<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (stand_in, n, w) = stand_in_at::<F>(draw);
    let c = F::ONE - w;
    let at = [stand_in as u32 as f64, n.to_f64(), w.to_f64()];
    seen.of(stand_in.at(c, n), meant(stand_in, x(n), number(1.0) - x(c)), n.to_f64(), &at);
    seen.of(stand_in.at_versine(w, n), meant(stand_in, x(n), x(w)), n.to_f64(), &at);
}

pub fn prepared<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (stand_in, n, w) = stand_in_at::<F>(draw);
    let (c, lobe) = (F::ONE - w, Prepared::<F>::new(stand_in, n.to_f64()));
    let at = [stand_in as u32 as f64, n.to_f64(), w.to_f64()];
    seen.of(lobe.at(c), meant(stand_in, x(n), number(1.0) - x(c)), n.to_f64(), &at);
    seen.of(lobe.at_versine(w), meant(stand_in, x(n), x(w)), n.to_f64(), &at);
    let (a, b) = (crate::vectors::unit::<F>(draw), crate::vectors::unit::<F>(draw));
    let gap = sub(vector(a), vector(b));
    let half_square = number(0.5) * dot(gap, gap);
    if half_square.to_f64() < 0.99 {
        seen.of(lobe.between(a, b), meant(stand_in, x(n), half_square), n.to_f64(), &at);
    }
}

pub fn linear_factor<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (n, model): (F, _) = (pick_log(draw, 1.0, 1e5), Model::ALL[draw.below(6)]);
    let line = |[a, b, divisor]: [f64; 3]| LinearFactor {
        a: F::from_f64(a),
        b: F::from_f64(b),
        divisor: F::from_f64(divisor),
    };
    let row = model as usize;
    let values = [
        (cs_16_factor_printed(model), CS16_PRINTED[row]),
        (cs_16_factor(model), CS16_MINIMAX[row]),
        (cs_16_factor_one_sided(model), CS16_ONE_SIDED[row]),
        (line([1.5, 0.25, 2.0]), [1.5, 0.25, 2.0]),
    ];
    for (factor, [a, b, divisor]) in values {
        let exact = (number(a) * x(n) + number(b)) / (number(divisor) * Exact::pi());
        seen.relative(factor.at(n), exact, &[row as f64, n.to_f64()]);
    }
}

fn factor<F: Real>(draw: &mut Draw, seen: &mut Seen, from: f64, of: Factor, at: fn(Model, F) -> F) {
    let (n, model): (F, _) = (pick_log(draw, from, 1e5), Model::ALL[draw.below(6)]);
    seen.relative(at(model, n), of.exact(model, n.to_f64()), &[model as u32 as f64, n.to_f64()]);
}

pub fn cos_n_factor_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    factor(draw, seen, 0.01, Factor::CosN, cos_n_factor::<F>);
}

pub fn cs_16_factor_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    factor(draw, seen, 0.01, Factor::Cs16, cs_16_factor_exact::<F>);
}

pub fn cubic_factor_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    match draw.below(3) {
        0 => factor(draw, seen, 16.0, Factor::Cubic2, cubic_factor::<2, F>),
        1 => factor(draw, seen, 16.0, Factor::Cubic4, cubic_factor::<4, F>),
        _ => factor(draw, seen, 16.0, Factor::Cubic8, cubic_factor::<8, F>),
    }
}

/// The rows of tests/references/factors.csv (mpmath), n as far as the type holds it.
pub fn cs_factor_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    use std::sync::OnceLock;
    static ROWS: OnceLock<Vec<[String; 4]>> = OnceLock::new();
    let rows = ROWS.get_or_init(|| rows::<4>("factors.csv"));
    let [model, power, n, value] = &rows[draw.below(rows.len())];
    let (model, n) = (Model::from_id(model).expect("a model"), n.parse::<f64>().expect("a number"));
    if F::from_f64(n).to_f64() != n {
        return;
    }
    let exact = of_rational(&crate::references::Reference::parse(value).expect("a number").value);
    let n = F::from_f64(n);
    let value = match power.as_str() {
        "2" => cs_factor::<2, F>(model, n),
        "4" => cs_factor::<4, F>(model, n),
        "8" => cs_factor::<8, F>(model, n),
        "16" => cs_factor::<16, F>(model, n),
        "32" => cs_factor::<32, F>(model, n),
        _ => cs_factor::<64, F>(model, n),
    };
    seen.relative(value, exact, &[model as u32 as f64, power.parse().expect("a number"), n.to_f64()]);
}

pub fn shading<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let [normal, light, view] = [0; 3].map(|_| crate::vectors::unit::<F>(draw));
    let [ambient, diffuse, specular] = [0; 3].map(|_| pick::<F>(draw, 0.0, 1.0));
    let n: F = F::from_f64(libm::round(draw.real(1.0, 64.0)));
    let material = PhongLambert { ambient, diffuse, specular, n };
    let (around, bright): (F, F) = (pick(draw, 0.0, 1.0), pick(draw, 0.0, 10.0));
    let n_l = dot(vector(normal), vector(light));
    let r_v = dot(reflect(vector(light), vector(normal)), vector(view));
    if n_l.to_f64() <= 1e-3 || r_v.to_f64() <= 1e-3 {
        return;
    }
    let at = [n.to_f64(), n_l.to_f64(), r_v.to_f64()];
    let ambient_part = x(around) * x(ambient);
    let with = |lobe: Exact| ambient_part + x(bright) * (x(diffuse) * n_l + x(specular) * lobe);
    let c = r_v.to_f64();
    // The dot product is off by some u, which the lobe's slope n cⁿ⁻¹ raises.
    let scale =
        |slope: f64| (ambient_part + x(bright) * (x(diffuse) + x(specular) * number(1.0 + slope))).to_f64();
    let lobe = power(r_v, n.to_f64() as u32);
    let slope = n.to_f64() * lobe.to_f64() / c;
    let value = phong_lambert(material, around, bright, normal, light, view);
    seen.of(value, with(lobe), scale(slope), &at);
    let value = phong_lambert_with(material, around, bright, normal, light, view, |c, _| c);
    seen.of(value, with(r_v), scale(1.0), &at);
}
