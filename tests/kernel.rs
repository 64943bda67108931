//! The kernels against their laws, hand-computed values, a second route, and bad input.
//!
//! References come from outside the code: exact fractions worked out by hand (each with its working
//! beside it), theorems, and Simpson's rule over the papers' integrands written out anew.

use std::f64::consts::PI;

use bellfit::kernel::bell::bell;
use bellfit::kernel::factor::{LinearFactor, cos_n_factor, cs_16_factor, cs_16_factor_printed};
use bellfit::kernel::lobe::*;
use bellfit::kernel::model::{Convention, LobeAngle, Model};
use bellfit::kernel::real::Real;
use bellfit::kernel::shading::{PhongLambert, phong_lambert, phong_lambert_with};
use bellfit::kernel::vector::*;

/// Half an ulp at 1: one correctly rounded operation is within a factor 1 ± U.
const U32: f64 = 1.0 / (1u32 << 24) as f64;
const U64: f64 = 1.0 / (1u64 << 53) as f64;

const INF: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;

/// splitmix64, so that the same arguments are drawn everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * (self.next() >> 11) as f64 * U64
    }

    fn within_f32(&mut self, lo: f64, hi: f64) -> f32 {
        self.within(lo, hi) as f32
    }

    /// A unit vector, by rejection from the cube.
    fn direction(&mut self) -> Vec3<f64> {
        loop {
            let v = [self.within(-1.0, 1.0), self.within(-1.0, 1.0), self.within(-1.0, 1.0)];
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if (1e-3..=1.0).contains(&square) {
                return v.map(|x| x / libm::sqrt(square));
            }
        }
    }
}

fn r<F: Real>(value: f64) -> F {
    F::from_f64(value)
}

fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance, "got {got:e}, want {want:e} within {tolerance:e}");
}

/// Runs a generic test with K = 2, 4, …, 64 and both types.
macro_rules! every_bell {
    ($test:ident) => {
        every_bell!($test, 2, 4, 8, 16, 32, 64)
    };
    ($test:ident, $($k:literal),+) => {{
        $($test::<$k, f32>(); $test::<$k, f64>();)+
    }};
}

// ---- Laws ----

#[test]
fn bell_falls_from_one_to_zero() {
    fn test<const K: u32, F: Real>() {
        assert_eq!(bell::<K, F>(F::ZERO), F::ONE);
        assert_eq!(bell::<K, F>(F::from_u32(K)), F::ZERO);
        assert_eq!(bell::<K, F>(r(K as f64 * 1.5)), F::ZERO);
        assert!(bell::<K, F>(r(K as f64 * 0.5)) > F::ZERO);
        let mut t: Vec<f64> = (0..=2000).map(|i| i as f64 * K as f64 / 1990.0).collect();
        // Neighbouring floats too: order is kept down to the last bit.
        let mut random = Random(1);
        for _ in 0..500 {
            let x = random.within_f32(0.0, K as f64);
            t.extend([x as f64, x.next_up() as f64, x.next_up().next_up() as f64]);
        }
        t.sort_by(f64::total_cmp);
        let values: Vec<F> = t.into_iter().map(|t| bell::<K, F>(r(t))).collect();
        assert!(values.windows(2).all(|pair| pair[0] >= pair[1]));
        assert!(values.iter().all(|&f| f >= F::ZERO && f <= F::ONE));
    }
    every_bell!(test);
}

/// 0 ≤ e⁻ᵗ - (1 - t/K)ᴷ ≤ t² e⁻ᵗ/K for 0 ≤ t ≤ K: with x = t/K, 1 + x ≤ eˣ ≤ 1/(1 - x) gives
/// 1 - x² ≤ eˣ (1 - x) ≤ 1, and the K-th power of the left is at least 1 - K x² (Bernoulli).
#[test]
fn bell_approaches_the_exponential_from_below() {
    fn test<const K: u32, F: Real>() {
        let k = K as f64;
        let u = if size_of::<F>() == 4 { U32 } else { U64 };
        for i in 0..=4000 {
            let t = (i as f64 * k / 4000.0) as f32 as f64;
            let exp = libm::exp(-t);
            let gap = exp - bell::<K, F>(r(t)).to_f64();
            // The bell's stated relative error, and exp's own.
            let rounding = (2.0 * k + 1.0) * u * exp;
            assert!((-rounding..=t * t * exp / k + rounding).contains(&gap), "K = {K}, t = {t}: {gap:e}");
        }
    }
    every_bell!(test);
}

#[test]
fn bell_keeps_its_stated_relative_error() {
    fn test<const K: u32>() {
        let mut random = Random(2);
        let mut worst = 0.0_f64;
        for _ in 0..20_000 {
            let t = random.within_f32(0.0, K as f64);
            let (single, double) = (bell::<K, f32>(t) as f64, bell::<K, f64>(t as f64));
            // Below, a squaring may underflow, which the bound excludes.
            if double > f32::MIN_POSITIVE as f64 {
                worst = worst.max((single / double - 1.0).abs());
            }
        }
        let powers = 2.0 * K as f64 - 1.0;
        let allowed = libm::expm1(powers * libm::log1p(U32)) + 2.0 * powers * U64;
        assert!(worst > U32 / 2.0 && worst <= allowed, "K = {K}: {worst:e}");
    }
    test::<2>();
    test::<4>();
    test::<8>();
    test::<16>();
    test::<32>();
    test::<64>();
}

/// With n = K the base 1 - n (1 - c)/K is c itself, without a rounding while 1 - c is exact.
#[test]
fn cs_at_n_equal_to_k_is_the_power() {
    fn test<const K: u32, F: Real>() {
        for i in 0..=64 {
            let c = 0.5 + i as f64 / 128.0;
            let mut power: F = r(c);
            let mut k = 1;
            while k < K {
                power = power * power;
                k *= 2;
            }
            assert_eq!(cs::<K, F>(r(c), F::from_u32(K)), power);
        }
        // A cosine below ½ of few digits is as good.
        assert_eq!(cs::<2, F>(r(0.25), r(2.0)), r(0.0625));
    }
    every_bell!(test);
    near(cs_16(0.9_f64, 16.0), cos_n(0.9_f64, 16.0), 33.0 * U64);
}

#[test]
fn the_forms_of_one_lobe_agree() {
    let mut random = Random(3);
    for _ in 0..5000 {
        let (theta, n) = (random.within(0.0, PI / 2.0), random.within(0.0, 1024.0));
        let (c, w) = (libm::cos(theta), versine(theta));
        assert_eq!(cs_16(c, n), cs::<16, f64>(c, n));
        assert_eq!(cs::<8, f64>(c, n), cs_versine::<8, f64>(1.0 - c, n));
        // c's own rounding, an ulp or 2 u at most, times n, the steepest that a lobe here is in w.
        let tolerance = 2.0 * n * U64 + 40.0 * U64;
        near(cs_16(c, n), cs_versine::<16, f64>(w, n), tolerance);
        near(spherical_gaussian(c, n), spherical_gaussian_versine(w, n), tolerance);
        near(cos_n(c, n), cos_n_versine(w, n), tolerance);
        // (1) with the exact cut; at the cut itself both are below any digit.
        near(cs_16_cut(theta, n, cut_exact(n)), cs_versine::<16, f64>(w, n), 1e-200);
        assert_eq!(cs_16_cut(-theta, n, 1.0), cs_16_cut(theta, n, 1.0));
    }
}

#[test]
fn past_its_zero_the_printed_base_rises_again() {
    let n = 64.0_f64; // exact cut arccos(3/4) = 0.7227, paper's 0.75
    let (exact, paper) = (cut_exact(n), cut_paper(n));
    let theta = 0.74;
    assert!(exact < theta && theta < paper);
    let base = 4.0 * (libm::cos(theta) - 1.0) + 1.0;
    assert!(base < 0.0);
    let want = libm::pow(-base, 16.0);
    near(cs_16_cut(theta, n, paper), want, 1e-11 * want); // 16 relative roundings of a base of 0.05
    assert_eq!(cs_16_cut(theta, n, exact), 0.0);
    assert_eq!(cs_16_cut(paper, n, paper), cs_16_cut(paper, n, 1.0)); // the cut belongs to the lobe
    assert_eq!(cs_16_cut(paper.next_up(), n, paper), 0.0);
}

#[test]
fn lobes_are_one_on_axis_and_order_as_their_curvatures() {
    fn test<F: Real>() {
        for n in [0.5, 1.0, 7.5, 16.0, 1000.25] {
            let n: F = r(n);
            for lobe in [cos_n::<F>, cs_16, cs::<4, F>, schlick, schlick_printed, spherical_gaussian] {
                assert_eq!(lobe(F::ONE, n), F::ONE);
            }
            for lobe in [cos_n_versine::<F>, cs_versine::<16, F>, spherical_gaussian_versine, gaussian] {
                assert_eq!(lobe(F::ZERO, n), F::ONE);
            }
        }
    }
    test::<f32>();
    test::<f64>();
    // ln c ≤ c - 1, and (1 - t/K)ᴷ ≤ e⁻ᵗ ≤ 1/(1 + t): cosⁿ and the bell lie below the spherical
    // Gaussian; cosⁿθ ≤ e^(-nθ²/2) ≤ e^(n(c - 1)).
    let mut random = Random(4);
    for _ in 0..5000 {
        let (theta, n) = (random.within(0.05, 1.5), random.within(16.0, 1024.0));
        let c = libm::cos(theta);
        // Small next to the gap, nθ⁴/24 in the exponent, for these θ.
        let above = 1.0 + 1e-9;
        assert!(cos_n(c, n) <= gaussian(theta, n) * above);
        assert!(gaussian(theta, n) <= spherical_gaussian(c, n) * above);
        assert!(cs_16(c, n) <= spherical_gaussian(c, n) * above);
        assert!(cs::<4, f64>(c, n) <= cs_16(c, n) * above && cs_16(c, n) <= cs::<64, f64>(c, n) * above);
    }
}

#[test]
fn single_precision_agrees_with_double() {
    let mut random = Random(5);
    let tiny = f32::MIN_POSITIVE as f64; // below it f32 has no full precision to compare
    for _ in 0..20_000 {
        let (c, w) = (random.within_f32(-1.0, 1.0), random.within_f32(0.0, 2.0));
        let (theta, n) = (random.within_f32(0.0, 1.6), random.within_f32(0.0, 300.0));
        let (c64, w64, theta64, n64) = (c as f64, w as f64, theta as f64, n as f64);

        // A bell's (2K - 1) u, plus t's relative error of 2 u (1 - c, times n) times max |t f'| ≤ ½.
        near(cs_16(c, n) as f64, cs_16(c64, n64), 32.0 * U32);
        near(cs::<4, f32>(c, n) as f64, cs::<4, f64>(c64, n64), 8.0 * U32);
        near(cs_versine::<16, f32>(w, n) as f64, cs_versine::<16, f64>(w64, n64), 32.0 * U32);

        // The exponent's relative error in u, then libm's promise of less than an ulp, at most 2 u.
        let exponential = |got: f32, want: f64, roundings: f64| {
            near(got as f64, want, want * U32 * (2.0 + roundings * libm::log(want.max(tiny)).abs()) + tiny);
        };
        exponential(cos_n(c, n), cos_n(c64, n64), 0.0);
        exponential(cos_n_versine(w, n), cos_n_versine(w64, n64), 3.0); // log1p 2, product 1
        exponential(spherical_gaussian(c, n), spherical_gaussian(c64, n64), 2.0);
        exponential(spherical_gaussian_versine(w, n), spherical_gaussian_versine(w64, n64), 1.0);
        exponential(gaussian(theta, n), gaussian(theta64, n64), 2.0);

        // sin's ulp (2 u), squared, and a product; ½ θ and the doubling are exact.
        near(versine(theta) as f64, versine(theta64), 5.0 * U32 * versine(theta64) + tiny);

        let m = random.within_f32(9.0, 1024.0);
        let m64 = m as f64;
        near(cut_paper(m) as f64, cut_paper(m64), 2.0 * U32 * cut_paper(m64));
        near(cut_card(m) as f64, cut_card(m64), 1.5 * U32 * cut_card(m64) * (1.0 + U32));
        // asin's ulp (2 u) on s with 1.5 u; its condition s/(√(1 - s²) arcsin s) is below 2.4 for m > 9.
        near(cut_exact(m) as f64, cut_exact(m64), (2.0 + 1.5 * 2.4) * U32 * cut_exact(m64));

        for model in Model::ALL {
            let (got, want) = (cos_n_factor(model, n) as f64, cos_n_factor(model, n64));
            near(got, want, 10.0 * U32 * want); // at most ten roundings of positive terms
            let (got, want) = (cs_16_factor(model).at(n) as f64, cs_16_factor(model).at(n64));
            near(got, want, 8.0 * U32 * want); // three constants, π, four operations
        }
    }
}

#[test]
fn schlick_keeps_the_digits_that_the_printed_form_loses() {
    let mut random = Random(6);
    let (mut rewritten, mut printed) = (0.0_f64, 0.0_f64);
    for _ in 0..20_000 {
        let (c, n) = (random.within_f32(0.99, 1.0), random.within_f32(512.0, 1024.0));
        let (c64, n64) = (c as f64, n as f64);
        let want = c64 / (c64 + n64 * (1.0 - c64));
        rewritten = rewritten.max((schlick(c, n) as f64 / want - 1.0).abs());
        printed = printed.max((schlick_printed(c, n) as f64 / want - 1.0).abs());
    }
    assert!(rewritten <= 4.0 * U32 * (1.0 + 1e-6), "{rewritten:e}");
    // n c < 1024 rounds by up to 512 u against a denominator of 0.99 or more; four more roundings as
    // above. Lost are at least two digits of what the other form keeps.
    assert!(printed > 100.0 * U32 && printed < (512.0 / 0.99 + 4.0) * U32, "{printed:e}");
}

// ---- Models and factors ----

/// Int(n) by Simpson's rule over the integrand as the paper's table writes it.
fn integral(model: Model, upper: f64, f: impl Fn(f64) -> f64) -> f64 {
    let integrand = |a: f64| {
        let (c, s, half) = (libm::cos(a), libm::sin(a), libm::cos(a / 2.0));
        match model {
            Model::Phong | Model::BlinnPhongNdf => f(c) * s,
            Model::PhongModified | Model::BlinnPhongHeightfield => f(c) * c * s,
            Model::BlinnPhong => f(half) * s,
            Model::BlinnPhongModified => f(half) * c * s,
        }
    };
    let panels = 2000;
    let h = upper / (2 * panels) as f64;
    let sum: f64 = (0..panels)
        .map(|i| {
            let a = 2.0 * i as f64 * h;
            integrand(a) + 4.0 * integrand(a + h) + integrand(a + 2.0 * h)
        })
        .sum();
    sum * h / 3.0
}

#[test]
fn cos_n_factor_normalises_its_model() {
    for model in Model::ALL {
        for n in [0.0, 1.0, 2.0, 4.5, 16.0, 100.25, 1024.0] {
            let int = integral(model, PI / 2.0, |c| libm::pow(c.max(0.0), n));
            // Simpson's leading error h⁴ |f'''(0)|/180 is at most h⁴ 3(n + 2)/180 on Int of about 1/n.
            near(2.0 * PI * cos_n_factor(model, n) * int, 1.0, 1e-9);
        }
    }
}

#[test]
fn cos_n_factor_at_16_and_0_by_hand() {
    // With x = cos θ: ∫ x¹⁶ = 1/17, ∫ x¹⁷ = 1/18. With x = cos²(θ/2), sin θ dθ = -2 dx, cos θ = 2x - 1:
    // 2 ∫ x⁸ over [½, 1] = 2/9 · 511/512 = 511/2304;
    // 2 ∫ x⁸ (2x - 1) = 2 (1/5 · 1023/1024 - 1/9 · 511/512) = 4097/23040.
    let at_16 =
        [17.0 / 2.0, 18.0 / 2.0, 2304.0 / (2.0 * 511.0), 23040.0 / (2.0 * 4097.0), 17.0 / 2.0, 18.0 / 2.0];
    // n = 0: ∫ dω = 2π, ∫ cos θ dω = π.
    let at_0 = [0.5, 1.0, 0.5, 1.0, 0.5, 1.0];
    for (i, model) in Model::ALL.into_iter().enumerate() {
        for (n, want) in [(16.0, at_16[i]), (0.0, at_0[i])] {
            near(PI * cos_n_factor(model, n), want, 10.0 * U64 * want);
        }
        // Monotone in n: a narrower lobe needs the larger factor.
        for i in 0..4000 {
            let n = i as f64 / 8.0;
            assert!(cos_n_factor(model, n) < cos_n_factor(model, n + 0.125));
        }
    }
}

/// The bounds that Table 1 prints around its two longer factors.
#[test]
fn blinn_phong_factors_lie_between_the_bounds_of_table_1() {
    let pi8 = 8.0 * PI;
    for n in (16..=1024).map(f64::from) {
        let coef = cos_n_factor(Model::BlinnPhong, n);
        // The lower bound is met to the last bit once 2^(-n/2) is below it.
        assert!((n + 2.0) / pi8 <= coef * (1.0 + 4.0 * U64) && coef < (n + 4.0) / pi8);
        let coef = cos_n_factor(Model::BlinnPhongModified, n);
        assert!((n + 6.0) / pi8 < coef && coef < (n + 8.0) / pi8);
    }
}

#[test]
fn linear_factors_are_those_of_table_1() {
    // At n = 100: 1.063 n; 1.063 n + 1; 1.068 n + 0.96; 1.027 n + 4.8, worked out by hand.
    let printed = [106.3 / 2.0, 107.3 / 2.0, 107.76 / 8.0, 107.5 / 8.0, 106.3 / 2.0, 107.3 / 2.0];
    for (model, want) in Model::ALL.into_iter().zip(printed) {
        near(PI * cs_16_factor_printed::<f64>(model).at(100.0), want, 8.0 * U64 * want);
        near(PI * cs_16_factor_printed::<f32>(model).at(100.0) as f64, want, 8.0 * U32 * want);
    }
    let line = LinearFactor { a: 2.0, b: 3.0, divisor: 4.0 };
    near(line.at(5.0), 13.0 / (4.0 * PI), 4.0 * U64);
}

#[test]
fn the_refit_is_never_worse_than_the_print() {
    for model in Model::ALL {
        let (mut printed, mut refitted) = (0.0_f64, 0.0_f64);
        // Every integer where the support still meets the hemisphere's edge, then every 16th.
        for n in (16..80).chain((80..=1024).step_by(16)).map(f64::from) {
            let zero = libm::acos(1.0 - 16.0 / n); // not cut_exact: the test's own
            let twice = if model.angle() == LobeAngle::Half { 2.0 } else { 1.0 };
            let upper = (twice * zero).min(PI / 2.0);
            let int = integral(model, upper, |c| libm::pow(1.0 - n * (1.0 - c) / 16.0, 16.0));
            let residual = |line: LinearFactor<f64>| (2.0 * PI * line.at(n) * int - 1.0).abs();
            printed = printed.max(residual(cs_16_factor_printed(model)));
            refitted = refitted.max(residual(cs_16_factor(model)));
        }
        assert!(refitted < printed, "{}: {refitted:e} against {printed:e}", model.id());
    }
    // ∫ (1 - n w/16)¹⁶ dw = 16/(17 n): the best line for Phong is exact, 17/16 n/(2π).
    for n in [16.0, 100.0, 1024.0] {
        let want = 17.0 / 16.0 * n;
        near(2.0 * PI * cs_16_factor(Model::Phong).at(n), want, 4.0 * U64 * want);
    }
}

#[test]
fn models_name_themselves_as_files_and_table_do() {
    use Convention::{Heightfield, Ndf, Rdf, RdfCosine};
    use LobeAngle::{Full, Half};
    let rows = [
        ("phong", "Phong (RDF)", Rdf, Full),
        ("phong-modified", "Phong (modified) (RDF)", RdfCosine, Full),
        ("blinn-phong", "Blinn-Phong (RDF)", Rdf, Half),
        ("blinn-phong-modified", "Blinn-Phong (modified) (RDF)", RdfCosine, Half),
        ("blinn-phong-ndf", "Blinn-Phong (NDF)", Ndf, Full),
        ("blinn-phong-heightfield", "Blinn-Phong (heightfield)", Heightfield, Full),
    ];
    for (model, row) in Model::ALL.into_iter().zip(rows) {
        assert_eq!((model.id(), model.title(), model.convention(), model.angle()), row);
        assert_eq!(Model::from_id(row.0), Some(model));
    }
    assert!(Model::ALL.is_sorted());
    for id in ["", "Phong", "phong ", "blinn", "phong\0"] {
        assert_eq!(Model::from_id(id), None);
    }
}

// ---- Vectors and shading ----

#[test]
fn reflection_is_an_isometry_that_undoes_itself() {
    let mut random = Random(7);
    for _ in 0..5000 {
        let (l, n, v) = (random.direction(), random.direction(), random.direction());
        let mirrored = reflect(l, n);
        // The unit vectors' own rounding, a few u, enters twice.
        let tolerance = 20.0 * U64;
        near(dot(mirrored, mirrored), 1.0, tolerance);
        near(dot(mirrored, n), dot(l, n), tolerance);
        near(dot(mirrored, v), dot(reflect(v, n), l), tolerance); // reciprocity of R·V
        let back = reflect(mirrored, n);
        (0..3).for_each(|i| near(back[i], l[i], tolerance));
        let long = reflect(scale(8.0, l), n);
        (0..3).for_each(|i| assert_eq!(long[i], 8.0 * mirrored[i])); // linear, exact for powers of two
    }
}

#[test]
fn half_vector_bisects() {
    let mut random = Random(8);
    for _ in 0..5000 {
        let (l, v) = (random.direction(), random.direction());
        let sum = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
        let length = libm::sqrt(dot(sum, sum));
        let h = half_vector(l, v).expect("no two of these are opposite");
        assert_eq!(half_vector(v, l), Some(h));
        near(dot(h, h), 1.0, 10.0 * U64);
        // Rounding in L + V turns H by a few u over its length.
        let tolerance = 30.0 * U64 / length;
        near(dot(h, l), dot(h, v), tolerance);
        near(dot(h, l), length / 2.0, tolerance); // cos of half the angle
        let mirrored = reflect(l, h);
        (0..3).for_each(|i| near(mirrored[i], v[i], tolerance));
    }
}

#[test]
fn vectors_by_hand() {
    assert_eq!(dot([1.0_f32, 2.0, 3.0], [4.0, -5.0, 6.0]), 12.0);
    assert_eq!(add([1.0_f32, 2.0, 3.0], [4.0, -5.0, 6.0]), [5.0, -3.0, 9.0]);
    assert_eq!(sub([1.0_f32, 2.0, 3.0], [4.0, -5.0, 6.0]), [-3.0, 7.0, -3.0]);
    assert_eq!(scale(-2.0_f32, [1.0, 2.0, 3.0]), [-2.0, -4.0, -6.0]);
    assert_eq!(reflect([1.0_f64, 2.0, 3.0], [0.0, 1.0, 0.0]), [-1.0, 2.0, -3.0]);
    // (2, 3, 6)/7, a Pythagorean quadruple, from every size of the type.
    for size in [1.0, 1e-308, 1e307, f64::MIN_POSITIVE] {
        let unit = normalize([2.0 * size, -3.0 * size, 6.0 * size]).expect("finite and not zero");
        for (got, want) in unit.into_iter().zip([2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]) {
            near(got, want, 4.0 * U64);
        }
    }
    assert_eq!(normalize([0.0, -5e-324_f64, 0.0]), Some([0.0, -1.0, 0.0]));
    assert_eq!(normalize([0.0, 0.0, f32::MAX]), Some([0.0, 0.0, 1.0]));
}

const UP: Vec3<f64> = [0.0, 0.0, 1.0];
/// 3-4-5: N·L = 0.8, and R = (-0.6, 0, 0.8).
const SLANT: Vec3<f64> = [0.6, 0.0, 0.8];
const MATERIAL: PhongLambert<f64> = PhongLambert { ambient: 0.5, diffuse: 0.25, specular: 0.125, n: 2.0 };

#[test]
fn shading_by_hand() {
    // V = N: R·V = 0.8, I = 0.5·3 + 2 (0.25·0.8 + 0.125·0.64) = 2.06.
    near(phong_lambert(MATERIAL, 3.0, 2.0, UP, SLANT, UP), 2.06, 8.0 * U64 * 2.06);
    // V = L: R·V = 0.64 - 0.36 = 0.28, I = 1.5 + 2 (0.2 + 0.125·0.0784) = 1.9196.
    near(phong_lambert(MATERIAL, 3.0, 2.0, UP, SLANT, SLANT), 1.9196, 8.0 * U64 * 1.9196);
    // The lobe gets R·V and n, and its value is what k_s multiplies: 1.5 + 2 (0.2 + 0.125·4) = 2.9.
    let lobe = |c: f64, n: f64| {
        near(c, 0.8, 4.0 * U64);
        assert_eq!(n, 2.0);
        4.0
    };
    near(phong_lambert_with(MATERIAL, 3.0, 2.0, UP, SLANT, UP, lobe), 2.9, 8.0 * U64 * 2.9);
}

#[test]
fn shading_clamps_what_faces_away() {
    // The light below the surface: R = (-0.6, 0, -0.8) looks straight at V, and still only I_a k_a.
    let (below, mirror) = ([0.6, 0.0, -0.8], [-0.6, 0.0, -0.8]);
    assert_eq!(dot(reflect(below, UP), mirror), 1.0);
    assert_eq!(phong_lambert(MATERIAL, 3.0, 2.0, UP, below, mirror), 1.5);
    let grazing = [1.0, 0.0, 0.0];
    assert_eq!(phong_lambert(MATERIAL, 3.0, 2.0, UP, grazing, [-1.0, 0.0, 0.0]), 1.5);
    // R·V < 0: an even power must not bring it back, and the lobe sees 0.
    let away = [0.6, 0.0, -0.8];
    near(phong_lambert(MATERIAL, 3.0, 2.0, UP, SLANT, away), 1.9, 8.0 * U64);
    let lobe = |c: f64, _| {
        assert_eq!(c, 0.0);
        0.0
    };
    near(phong_lambert_with(MATERIAL, 3.0, 2.0, UP, SLANT, away, lobe), 1.9, 8.0 * U64);
}

// ---- Values by hand ----

#[test]
fn bells_by_hand() {
    fn test<F: Real>() {
        let exact = [
            (bell::<2, F>(r(1.0)), 0.25),
            (bell::<4, F>(r(1.0)), 0.31640625),    // (3/4)⁴ = 81/256
            (bell::<8, F>(r(4.0)), 0.00390625),    // (1/2)⁸
            (bell::<16, F>(r(8.0)), 1.0 / 65536.), // (1/2)¹⁶
            (bell::<32, F>(r(16.0)), 1.0 / 4294967296.0),
            (bell::<64, F>(r(32.0)), 1.0 / 4294967296.0 / 4294967296.0),
            (bell::<4, F>(r(-4.0)), 16.0), // 2⁴: the polynomial goes on below 0
            (cs::<4, F>(r(0.75), r(8.0)), 0.0625), // t = 2: (1/2)⁴
            (cs_versine::<4, F>(r(0.25), r(4.0)), 81.0 / 256.0),
            (cs_16(r(0.75), r(32.0)), 1.0 / 65536.0), // t = 8
            (cs_16(r(0.5), r(32.0)), 0.0),            // the zero, arccos((32 - 16)/32)
            (cs_16(r(0.0), r(8.0)), 1.0 / 65536.0),   // n < 16: not yet 0 at the edge
            (cs_16(r(-1.0), r(4.0)), 1.0 / 65536.0),  // n < 8: no zero on the sphere
            (cs_16(r(-0.3), r(0.0)), 1.0),
            (cs_16_cut(r(0.0), r(100.0), r(0.5)), 1.0),
            (cos_n(r(0.5), r(3.0)), 0.125),
            (cos_n(r(0.25), r(0.5)), 0.5),
            (cos_n_versine(r(1.0), r(3.0)), 0.0),
            (schlick(r(0.5), r(3.0)), 0.25), // ½/(½ + 3/2)
            (schlick_printed(r(0.5), r(3.0)), 0.25),
            (cut_paper(r(144.0)), 0.5),
            (cut_card(r(24.0)), 0.5),
        ];
        for (i, (got, want)) in exact.into_iter().enumerate() {
            assert_eq!(got.to_f64(), want, "row {i}");
        }
    }
    test::<f32>();
    test::<f64>();
    // e⁻¹ and e^(-1/2), from tables.
    let (e1, e05) = (0.367_879_441_171_442_33, 0.606_530_659_712_633_4);
    near(spherical_gaussian(0.5, 2.0), e1, 2.0 * U64);
    near(spherical_gaussian_versine(0.25, 4.0), e1, 2.0 * U64);
    near(gaussian(0.5, 4.0), e05, 2.0 * U64);
    near(gaussian(-0.5, 4.0), e05, 2.0 * U64);
}

#[test]
fn cuts_and_versines_by_hand() {
    // arccos 0 = π/2, arccos ½ = π/3, arccos(-1) = π; none below n = 8.
    for (n, want) in [(16.0, PI / 2.0), (32.0, PI / 3.0), (8.0, PI), (7.9, PI), (1e-300, PI)] {
        near(cut_exact(n), want, 4.0 * U64 * want);
    }
    // At large n, √(32/n): arccos would have lost every digit of it.
    near(cut_exact(32e20), 1e-10, 8.0 * U64 * 1e-10);
    near(versine(PI), 2.0, 4.0 * U64);
    near(versine(PI / 2.0), 1.0, 4.0 * U64);
    near(versine(PI / 3.0), 0.5, 4.0 * U64);
    near(versine(1e-10), 0.5e-20, 6.0 * U64 * 0.5e-20);
    assert_eq!(versine(-0.5), versine(0.5));
}

// ---- Bad input ----

#[test]
fn nan_in_any_argument_gives_nan() {
    fn test<F: Real>() {
        for (x, n) in [(NAN, 20.0), (0.5, NAN), (NAN, NAN), (NAN, 0.0), (1.0, NAN), (-0.5, NAN)] {
            let (x, n): (F, F) = (r(x), r(n));
            let lobes = [
                cos_n::<F>,
                cs_16,
                cs::<2, F>,
                cs::<64, F>,
                schlick,
                schlick_printed,
                spherical_gaussian,
                cos_n_versine,
                cs_versine::<16, F>,
                spherical_gaussian_versine,
                gaussian,
            ];
            for (i, lobe) in lobes.into_iter().enumerate() {
                assert!(lobe(x, n).is_nan(), "lobe {i}, ({x:?}, {n:?})");
            }
        }
        let nan = F::NAN;
        assert!(bell::<2, F>(nan).is_nan() && bell::<64, F>(nan).is_nan());
        assert!(versine(nan).is_nan());
        for (theta, n, cut) in [(NAN, 20.0, 1.0), (2.0, NAN, 1.0), (0.5, NAN, 1.0), (0.5, 20.0, NAN)] {
            assert!(cs_16_cut::<F>(r(theta), r(n), r(cut)).is_nan());
        }
        for cut in [cut_exact::<F>, cut_paper, cut_card] {
            assert!(cut(nan).is_nan());
        }
        for model in Model::ALL {
            assert!(cos_n_factor(model, nan).is_nan());
            assert!(cs_16_factor(model).at(nan).is_nan());
            assert!(cs_16_factor_printed(model).at(nan).is_nan());
        }
        let (unit, broken): (Vec3<F>, _) = ([F::ZERO, F::ZERO, F::ONE], [nan, F::ZERO, F::ONE]);
        assert!(dot(unit, broken).is_nan());
        assert!(add(unit, broken)[0].is_nan() && sub(unit, broken)[0].is_nan());
        assert!(scale(nan, unit).iter().all(|x| x.is_nan()));
        assert!(reflect(broken, unit).iter().all(|x| x.is_nan()));
        assert!(reflect(unit, broken).iter().all(|x| x.is_nan()));
    }
    test::<f32>();
    test::<f64>();
    let broken = [NAN, 0.0, 1.0];
    for (normal, light, view) in [(broken, UP, UP), (UP, broken, UP), (UP, UP, broken)] {
        assert!(phong_lambert(MATERIAL, 3.0, 2.0, normal, light, view).is_nan());
    }
    assert!(phong_lambert(PhongLambert { n: NAN, ..MATERIAL }, 3.0, 2.0, UP, UP, UP).is_nan());
    assert!(phong_lambert(MATERIAL, NAN, 2.0, UP, UP, UP).is_nan());
    assert!(phong_lambert(MATERIAL, 3.0, NAN, UP, UP, UP).is_nan());
    // No light on the surface, no term that its NaN could spoil.
    assert_eq!(phong_lambert(MATERIAL, 3.0, NAN, UP, [0.0, 0.0, -1.0], UP), 1.5);
}

#[test]
#[rustfmt::skip] // its tables
fn infinities_and_foreign_arguments_give_what_is_stated() {
    fn test<F: Real>() {
        // (x, n, value); NAN stands for itself.
        let check = |name: &str, lobe: fn(F, F) -> F, rows: &[(f64, f64, f64)]| {
            for &(x, n, want) in rows {
                let got = lobe(r(x), r(n)).to_f64();
                assert!(got == want || (got.is_nan() && want.is_nan()), "{name}({x}, {n}) = {got}");
            }
        };
        check("bell", |t, _| bell::<16, F>(t), &[(INF, 0., 0.), (-INF, 0., INF), (-16., 0., 65536.)]);
        let cos_rows = [
            (0.5, 0.0, 1.0), (0.0, 0.0, 1.0), (-1.0, 0.0, 1.0), (0.0, 3.0, 0.0), (-0.0, 3.0, 0.0),
            (-0.5, 2.0, 0.0), (-INF, 2.0, 0.0), (0.5, -1.0, 2.0), (0.0, -1.0, INF), (-0.0, -1.0, INF),
            (-1.0, -2.0, INF), (2.0, 3.0, 8.0), (INF, 2.0, INF), (0.5, INF, 0.0), (1.0, INF, 1.0),
            (-1.0, INF, 0.0),
        ];
        check("cos_n", cos_n, &cos_rows);
        assert!((F::ONE / cos_n(-F::ZERO, r(3.0))) > F::ZERO); // +0, not -0
        check(
            "cos_n_versine",
            cos_n_versine,
            &[
                (0.5, 0.0, 1.0), (1.0, 0.0, 1.0), (2.0, 0.0, 1.0), (1.0, 3.0, 0.0), (2.0, 3.0, 0.0),
                (INF, 3.0, 0.0), (1.0, -1.0, INF), (0.5, INF, 0.0), (0.0, INF, 1.0), (-INF, 2.0, INF),
                (-INF, 0.0, NAN),
            ],
        );
        for (name, lobe) in [("cs", cs::<16, F> as fn(F, F) -> F), ("cs_16", cs_16)] {
            check(
                name,
                lobe,
                &[
                    (-INF, 20.0, 0.0), (INF, 20.0, INF), (0.5, INF, 0.0), (1.0, INF, NAN), (INF, 0.0, NAN),
                    (2.0, 16.0, 65536.0), (0.0, -16.0, 65536.0), (0.5, -INF, INF),
                ],
            );
        }
        check(
            "cs_versine",
            cs_versine::<16, F>,
            &[(INF, 20.0, 0.0), (-INF, 20.0, INF), (0.5, INF, 0.0), (0.0, INF, NAN), (-1.0, 16.0, 65536.0)],
        );
        check(
            "schlick",
            schlick,
            &[
                (0.0, 20.0, 0.0), (-0.5, 20.0, 0.0), (-INF, 20.0, 0.0), (0.0, 0.0, 0.0), (0.5, 0.0, 1.0),
                (0.5, INF, 0.0), (1.0, INF, NAN), (INF, 2.0, NAN), (INF, 0.0, NAN), (2.0, 2.0, INF),
                (0.5, -2.0, -1.0),
            ],
        );
        check(
            "schlick_printed",
            schlick_printed,
            &[
                (0.0, 20.0, 0.0), (-0.5, 20.0, 0.0), (-INF, 20.0, 0.0), (0.5, 0.0, 1.0), (0.5, INF, NAN),
                (INF, 2.0, NAN), (2.0, 2.0, INF), (0.5, -2.0, -1.0),
            ],
        );
        check(
            "spherical_gaussian",
            spherical_gaussian,
            &[
                (-INF, 2.0, 0.0), (INF, 2.0, INF), (0.5, INF, 0.0), (1.0, INF, NAN), (INF, 0.0, NAN),
                (0.5, 0.0, 1.0), (0.5, -INF, INF),
            ],
        );
        check(
            "spherical_gaussian_versine",
            spherical_gaussian_versine,
            &[(INF, 2.0, 0.0), (0.5, INF, 0.0), (0.0, INF, NAN), (0.5, 0.0, 1.0)],
        );
        check(
            "gaussian",
            gaussian,
            &[
                (INF, 2.0, 0.0), (-INF, 2.0, 0.0), (INF, 0.0, NAN), (0.0, INF, NAN), (1e30, 0.0, 1.0),
                (0.5, -INF, INF), (1e30, 1.0, 0.0),
            ],
        );
        check(
            "cut_exact",
            |n, _| cut_exact(n),
            &[(INF, 0., 0.), (0.0, 0., NAN), (-1.0, 0., NAN), (-INF, 0., NAN), (1.0, 0., F::PI.to_f64())],
        );
        let none = [(INF, 0., 0.), (0.0, 0., NAN), (-0.0, 0., NAN), (-1.0, 0., NAN), (-INF, 0., NAN)];
        check("cut_paper", |n, _| cut_paper(n), &none);
        check("cut_card", |n, _| cut_card(n), &none);
        check("versine", |theta, _| versine(theta), &[(INF, 0., NAN), (-INF, 0., NAN), (0.0, 0., 0.)]);
        for (theta, n, cut, want) in [
            (INF, 20.0, 1.0, 0.0), (INF, 20.0, INF, NAN), (0.0, 20.0, -1.0, 0.0), (0.5, INF, 1.0, INF),
            (0.0, INF, 1.0, NAN),
        ] {
            let got = cs_16_cut::<F>(r(theta), r(n), r(cut)).to_f64();
            assert!(got == want || (got.is_nan() && want.is_nan()), "cs_16_cut({theta}, {n}, {cut}) = {got}");
        }
        for model in Model::ALL {
            assert_eq!(cos_n_factor::<F>(model, r(INF)).to_f64(), INF);
            assert_eq!(cos_n_factor::<F>(model, -F::ZERO), cos_n_factor(model, F::ZERO));
            // No overflow on the way to a finite factor.
            assert!(cos_n_factor::<F>(model, r(1e30)).is_finite());
            for n in [-1e-30, -2.0, -INF] {
                assert!(cos_n_factor::<F>(model, r(n)).is_nan());
            }
            for line in [cs_16_factor::<F>(model), cs_16_factor_printed(model)] {
                assert_eq!(line.at(r(INF)).to_f64(), INF);
                assert_eq!(line.at(r(-INF)).to_f64(), -INF);
                assert!(line.at(r(-100.0)) < F::ZERO);
            }
        }
        let (o, i): (F, F) = (F::ZERO, F::ONE);
        for v in [[o, o, o], [F::NAN, i, o], [i, o, F::NAN], [r(INF), o, o], [i, r(-INF), o]] {
            assert_eq!(normalize(v), None);
            assert_eq!(half_vector(v, [o, o, o]), None);
        }
        assert_eq!(half_vector([i, o, o], [-i, o, o]), None);
    }
    test::<f32>();
    test::<f64>();
    assert_eq!(cut_card(1e-39_f32), f32::INFINITY);
}

// ---- The trait ----

#[test]
fn real_is_the_type_it_says() {
    fn test<F: Real>(u: f64) {
        let close = |got: F, want: f64| near(got.to_f64(), want, 2.0 * u * want.abs());
        close(F::PI, PI);
        assert_eq!([F::ZERO, F::HALF, F::ONE, F::TWO].map(F::to_f64), [0.0, 0.5, 1.0, 2.0]);
        assert_eq!(F::from_u32(65537).to_f64(), 65537.0);
        assert_eq!(r::<F>(-6.25).abs().to_f64(), 6.25);
        assert_eq!(r::<F>(6.25).sqrt().to_f64(), 2.5);
        assert_eq!(r::<F>(10.0).exp2().to_f64(), 1024.0);
        assert_eq!(r::<F>(3.0).pow(r(4.0)).to_f64(), 81.0);
        // Each against a constant of its own: e, ln 2, π/6.
        close(F::ONE.exp(), std::f64::consts::E);
        close(F::TWO.log(), std::f64::consts::LN_2);
        close(F::ONE.log1p(), std::f64::consts::LN_2);
        close(F::HALF.asin(), PI / 6.0);
        close(r::<F>(PI / 6.0).sin(), 0.5);
        close(r::<F>(PI / 3.0).cos(), 0.5);
        assert_eq!(r::<F>(1e-30).log1p(), r(1e-30)); // ln(1 + x) in one piece
        for x in [-1.0, NAN] {
            assert!(r::<F>(x).sqrt().is_nan() && r::<F>(2.0 * x).log().is_nan());
            assert!(r::<F>(2.0 * x).asin().is_nan() && r::<F>(2.0 * x).log1p().is_nan());
        }
        assert!(r::<F>(INF).sin().is_nan() && r::<F>(-INF).cos().is_nan());
        assert_eq!(F::ZERO.log(), r(-INF));
        assert_eq!((-F::ONE).log1p(), r(-INF));
        assert_eq!(F::NAN.pow(F::ZERO), F::ONE);
        assert_eq!(F::ONE.pow(F::NAN), F::ONE);
        assert!(F::NAN.is_nan() && !r::<F>(INF).is_nan() && !F::ONE.is_nan());
        assert!(F::ONE.is_finite() && !F::NAN.is_finite() && !r::<F>(-INF).is_finite());
        // On the generic type these are Real's own: a NaN is not dropped.
        assert!(F::NAN.max(F::ONE).is_nan() && F::ONE.max(F::NAN).is_nan());
        assert!(F::NAN.min(F::ONE).is_nan() && F::ONE.min(F::NAN).is_nan());
        assert_eq!((F::ONE.max(F::TWO), F::TWO.max(F::ONE)), (F::TWO, F::TWO));
        assert_eq!((F::ONE.min(F::TWO), F::TWO.min(F::ONE)), (F::ONE, F::ONE));
    }
    test::<f32>(U32);
    test::<f64>(U64);
}
