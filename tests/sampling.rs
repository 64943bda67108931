//! Importance sampling: laws, references, bad input. What is drawn meets its density in histograms.rs.
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/view.rs"]
mod view;

use bellfit::kernel::factor::{cos_n_factor, cs_16_factor};
use bellfit::kernel::model::Model;
use bellfit::kernel::real::Real;
use bellfit::kernel::sampling::*;
use bellfit::kernel::vector::{Vec3, basis, dot, half_vector};
use draw::Draw;
use std::f64::consts::PI;
use view::{ANGLES, View, about_normal, drawn, mix};

/// Half an ulp at 1.
const U32: f64 = 1.0 / (1u32 << 24) as f64;
const U64: f64 = 1.0 / (1u64 << 53) as f64;

fn unit_of<F: Real>() -> f64 {
    if size_of::<F>() == 4 { U32 } else { U64 }
}

fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance, "got {got:e}, want {want:e} within {tolerance:e}");
}

fn single(v: Vec3<f64>) -> Vec3<f32> {
    v.map(|x| x as f32)
}

/// A number in [0, 1) that both types hold.
fn share(draw: &mut Draw) -> f64 {
    (draw.bits() >> 40) as f64 * U32
}

/// An exponent that both types hold, from every decade of 10⁻³..10⁴.
fn exponent(draw: &mut Draw) -> f64 {
    libm::pow(10.0, draw.real(-3.0, 4.0)) as f32 as f64
}

fn densities() -> impl Iterator<Item = Density> {
    let measures = [Measure::SolidAngle, Measure::Projected];
    measures.into_iter().flat_map(|measure| Profile::ALL.map(|profile| Density { profile, measure }))
}

// ---- Laws ----

#[test]
fn versine_grows_with_u_from_the_axis_to_the_edge() {
    fn test<F: Real>() {
        let mut draw = Draw(1);
        for density in densities() {
            for n in [0.0, 1e-3, 0.5, 2.0, 15.5, 16.0, 60.0, 1e3, 1e4] {
                let n = F::from_f64(n);
                let mut us: Vec<f64> = (0..400).map(|_| share(&mut draw)).collect();
                us.extend(
                    (1..=24).flat_map(|k| [libm::exp2(-f64::from(k)), 1.0 - libm::exp2(-f64::from(k))]),
                );
                us.push(0.0);
                us.sort_by(f64::total_cmp);
                let w: Vec<f64> =
                    us.iter().map(|&u| sample_versine(density, n, F::from_f64(u)).to_f64()).collect();
                assert_eq!(w[0], 0.0);
                // Within the stated error of a value and its neighbour.
                let steps = 2.0 * VERSINE * unit_of::<F>();
                assert!(w.windows(2).all(|pair| pair[1] >= pair[0] * (1.0 - steps)), "{density:?}, {n:?}");
                let edge = density.profile.power().map_or(1.0, |k| (f64::from(k) / n.to_f64()).min(1.0));
                assert!(w[us.len() - 1] <= edge * (1.0 + steps) && w[us.len() - 1] <= 1.0);
            }
        }
    }
    test::<f32>();
    test::<f64>();
}

/// The bell is nearly 1 for n → 0, and cᴷ for n = K: the inverse is cosⁿ's there.
#[test]
fn bells_join_cos_n_at_their_ends() {
    for Density { profile, measure } in densities() {
        let cosines = if measure == Measure::Projected { 1.0 } else { 0.0 };
        let Some(k) = profile.power().map(f64::from) else { continue };
        for u in [1e-9, 0.1, 0.5, 0.9, 0.999] {
            for (n, power) in [(0.0, 0.0), (1e-300, 0.0), (k, k)] {
                let want = -libm::expm1(libm::log1p(-u) / (power + cosines + 1.0));
                near(sample_versine(Density { profile, measure }, n, u), want, 10.0 * U64 * want);
            }
        }
    }
}

#[test]
fn phong_along_the_normal_is_the_normalised_lobe() {
    let mut draw = Draw(2);
    for _ in 0..2000 {
        let view = View::new(Model::Phong, 0.0);
        let (w, n) = (draw.real(0.0, 0.9), draw.real(16.0, 300.0));
        let light = view.light(w, draw.real(-PI, PI)).0;
        let at = |profile| pdf(Model::Phong, profile, n, view.normal, view.to_view, light);
        // The vectors' rounding, a few u in w, times n, the steepest ln f here but for the bell's edge.
        let c = 1.0 - w;
        let want = cos_n_factor(Model::Phong, n) * libm::pow(c, n);
        near(at(Profile::CosN), want, 40.0 * U64 * n / c * want);
        // ∫ (1 - n w/16)¹⁶ dw = 16/(17 n).
        let base = (1.0 - n * w / 16.0).max(0.0);
        let want = 17.0 * n / (32.0 * PI) * libm::pow(base, 16.0);
        near(at(Profile::Cs16), want, 17.0 * n / (32.0 * PI) * 40.0 * U64 * n);
        near(peak(Density::of(Model::Phong, Profile::Cs16), n), cs_16_factor(Model::Phong).at(n), 1e-15 * n);
    }
}

#[test]
fn the_density_of_half_vectors_is_the_pdf_times_four_cosines() {
    let mut draw = Draw(3);
    for _ in 0..4000 {
        let n = draw.real(0.0, 100.0);
        for model in Model::ALL.into_iter().filter(|&model| about_normal(model)) {
            let view = View::new(model, draw.real(0.0, 1.5));
            let (w, phi) = (draw.real(0.001, 0.99), draw.real(-PI, PI));
            let (light, jacobian) = view.light(w, phi);
            if dot(light, view.normal) < 1e-3 {
                continue;
            }
            for profile in Profile::ALL {
                let got = jacobian * pdf(model, profile, n, view.normal, view.to_view, light);
                let density = Density::of(model, profile);
                let want = radial_pdf(density, n, w);
                // As above; near-opposite L and V turn H by their rounding over 2 V·H.
                let tolerance = 100.0 * U64 * (n + 1.0) / (jacobian * (1.0 - w));
                near(got, want, tolerance * peak(density, n));
            }
        }
    }
}

#[test]
fn pdf_integrates_to_the_share_above_the_horizon() {
    let mut draw = Draw(4);
    for model in Model::ALL {
        for profile in Profile::ALL {
            for n in [0.0, 1.0, 8.0, 40.0, 500.0] {
                let total = |view: &View| {
                    view.integrate_all(n, |light| pdf(model, profile, n, view.normal, view.to_view, light))
                };
                // Along the normal L is above for every c > 0 about R, and for c² > ½ about N.
                let upright = total(&View::new(model, 0.0));
                let projected = Density::of(model, profile).measure == Measure::Projected;
                let power = n + if projected { 2.0 } else { 1.0 };
                // The rule's own error: 5 nodes a panel, over rings in which the density varies mildly.
                let tolerance = 1e-6;
                match profile {
                    _ if !about_normal(model) => near(upright, 1.0, tolerance),
                    Profile::CosN => near(upright, 1.0 - libm::exp2(-power / 2.0), tolerance),
                    // The zero 1 - K/n lies above √½.
                    _ if f64::from(profile.power().unwrap()) < 0.29 * n => near(upright, 1.0, tolerance),
                    _ => assert!(upright < 1.0),
                }
                let view = View::new(model, draw.real(0.1, 1.5));
                let (expected, count) = (total(&view), 10_000);
                let lights = drawn(&view, profile, n, draw.bits(), count);
                let got = lights.iter().flatten().count() as f64 / count as f64;
                let deviation = libm::sqrt((expected * (1.0 - expected)).max(0.0) / count as f64);
                near(got, expected, 5.0 * deviation + 1e-4); // and the horizon's kinks under the rule
            }
        }
    }
}

#[test]
fn what_the_lobe_lights_is_covered_and_nothing_below_the_horizon() {
    let mut draw = Draw(5);
    let (mut lit, mut dark) = (0, 0);
    for _ in 0..20_000 {
        let model = Model::ALL[draw.below(6)];
        let profile = Profile::ALL[draw.below(7)];
        let (n, view) = (exponent(&mut draw), View::new(model, draw.real(0.0, 1.57)));
        let mut v = [0.0; 3];
        while !(0.01..1.0).contains(&dot(v, v)) {
            v = [0; 3].map(|_| draw.real(-1.0, 1.0));
        }
        let light = v.map(|x| x / libm::sqrt(dot(v, v)));
        let got = pdf(model, profile, n, view.normal, view.to_view, light);
        let (w, _) = view.of(light);
        let above = dot(light, view.normal) > 0.0;
        // Half vectors of an L above lie above as well; the others' lobes end at c = 0.
        assert!(!(above && about_normal(model)) || w < 1.0);
        // Away from the lobe's edge, which rounding moves.
        let positive = profile.value(w, n) > 1e-280 && w < 1.0 - 1e-12;
        assert!(got >= 0.0 && got.is_finite());
        assert!(!(above && positive) || got > 0.0, "{}, {profile:?}, n = {n}, w = {w}", model.id());
        assert!(above || got == 0.0);
        lit += usize::from(above && positive);
        dark += usize::from(!above);
        // Nothing is seen from below.
        let below = view.to_view.map(|x| -x);
        assert_eq!(pdf(model, profile, n, view.normal, below, light), 0.0);
        assert_eq!(sample(model, profile, n, view.normal, below, 0.5, 0.5), None);
    }
    assert!(lit > 2000 && dark > 5000);
}

/// The table of the module's page: f times the model's other factors over the pdf, and its bounds.
#[test]
fn weights_are_as_stated_and_bounded() {
    let mut draw = Draw(6);
    for i in 0..30_000 {
        let (model, profile) = (Model::ALL[i % 6], Profile::ALL[draw.below(7)]);
        let (n, view) = (exponent(&mut draw), View::new(model, draw.real(0.0, 1.57)));
        let (u1, u2) = (share(&mut draw), share(&mut draw));
        let Some(light) = sample(model, profile, n, view.normal, view.to_view, u1, u2) else { continue };
        let sum = mix(1.0, light, 1.0, view.to_view);
        let h = sum.map(|x| x / libm::sqrt(dot(sum, sum)));
        let (n_l, n_h, v_h) = (dot(view.normal, light), dot(view.normal, h), dot(view.to_view, h));
        let w = view.of(light).0;
        let value = profile.value(w, n);
        // Where f falls by its own size within the vectors' rounding, its two values differ.
        if value < 1e-6 {
            continue;
        }
        let density = pdf(model, profile, n, view.normal, view.to_view, light);
        let weight = peak(Density::of(model, profile), n) * value / density;
        // V-cavities (Torrance & Sparrow 1967), a shadowing G ≤ 1.
        let g = (2.0 * n_h / v_h * view.cos.min(n_l)).min(1.0);
        let (weight, stated, bound) = match model {
            Model::Phong => (weight, 1.0, 1.0),
            Model::PhongModified => (weight * n_l, n_l, 1.0),
            Model::BlinnPhong => (weight / 4.0, v_h / n_h, 2.0 / view.cos),
            Model::BlinnPhongModified => (weight / 4.0 * n_l, n_l * v_h / n_h, 2.0),
            Model::BlinnPhongNdf => (weight / 4.0 * g / view.cos, g * v_h / view.cos, 1.0 / view.cos),
            Model::BlinnPhongHeightfield => {
                (weight / 4.0 * g / view.cos, g * v_h / (view.cos * n_h), 2.0 / (view.cos * view.cos))
            }
        };
        // w's rounding of a few u √w, times n; the bell's K-th root is as steep as it was at 1e-6.
        near(weight / stated, 1.0, 1e-9);
        assert!(stated <= bound * (1.0 + 1e-12), "{}: {stated} above {bound}", model.id());
    }
}

/// The mean of weights is the integral: coef f, with N·L for the modified models, and D G/(4 N·V) with
/// V-cavities for the two distributions of normals.
#[test]
fn the_mean_weight_is_the_albedo() {
    for model in Model::ALL {
        for (profile, n, coef) in [
            (Profile::CosN, 2.0, cos_n_factor(model, 2.0)),
            (Profile::Cs16, 24.0, cs_16_factor(model).at(24.0)),
        ] {
            for angle in ANGLES {
                let view = View::new(model, angle);
                let reflected = |light: Vec3<f64>| {
                    let (n_l, f) = (dot(view.normal, light), coef * profile.value(view.of(light).0, n));
                    match model {
                        Model::Phong | Model::BlinnPhong => f,
                        Model::PhongModified | Model::BlinnPhongModified => f * n_l,
                        Model::BlinnPhongNdf | Model::BlinnPhongHeightfield => {
                            let h = half_vector(light, view.to_view).unwrap();
                            let (n_h, v_h) = (dot(view.normal, h), dot(view.to_view, h));
                            f * (2.0 * n_h / v_h * view.cos.min(n_l)).min(1.0) / (4.0 * view.cos)
                        }
                    }
                };
                let weight = |light: &Option<Vec3<f64>>| {
                    light.map_or(0.0, |light| {
                        reflected(light) / pdf(model, profile, n, view.normal, view.to_view, light)
                    })
                };
                let weights: Vec<f64> =
                    drawn(&view, profile, n, 7 + model as u64, 50_000).iter().map(weight).collect();
                let count = weights.len() as f64;
                let mean = weights.iter().sum::<f64>() / count;
                let square = weights.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
                let albedo = view.integrate_all(n, reflected);
                // 1e-4 for the kinks of G and of the horizon under the rule.
                near(mean, albedo, 5.0 * libm::sqrt(square / count) + 1e-4 * albedo);
                assert!(albedo > 0.05 && albedo < 1.1, "{}: {albedo}", model.id());
            }
        }
    }
}

#[test]
fn large_exponents_keep_their_small_angles() {
    fn test<F: Real>(n: f64, to: impl Fn(Vec3<f64>) -> Vec3<F>) {
        let unit = unit_of::<F>();
        let mut draw = Draw(8);
        for _ in 0..3000 {
            let (model, profile) = (Model::ALL[draw.below(6)], Profile::ALL[draw.below(7)]);
            let (u1, u2) = (share(&mut draw).max(1e-4), share(&mut draw));
            let view = View::new(model, 0.7);
            let w = sample_versine(Density::of(model, profile), n, u1);
            let (one, two) = (F::from_f64(u1), F::from_f64(u2));
            let light =
                sample(model, profile, F::from_f64(n), to(view.normal), to(view.to_view), one, two).unwrap();
            let (got, phi) = view.of(light.map(F::to_f64));
            // A dozen roundings of vectors, N's and V's own among them, over the angle √(2w).
            near(libm::sqrt(got / w), 1.0, 12.0 * unit / libm::sqrt(2.0 * w));
            assert!(phi.is_finite());
            // The same for the density, whose ln moves by n √(2w) times the angle's error, or by more
            // near the bell's edge.
            let density = pdf(model, profile, F::from_f64(n), to(view.normal), to(view.to_view), light);
            let want = radial_pdf(Density::of(model, profile), n, w) / view.light(w, 0.0).1;
            if !about_normal(model) && u1 < 0.9 {
                near(density.to_f64() / want, 1.0, 100.0 * unit * libm::sqrt(n));
            }
        }
    }
    test::<f64>(1e6, |v| v);
    test::<f32>(1e4, single);
}

#[test]
fn basis_is_orthonormal_everywhere() {
    fn test<F: Real>(directions: &[Vec3<f64>], to: impl Fn(Vec3<f64>) -> Vec3<F>) {
        for &a in directions {
            let (a, (t, s)) = (to(a), basis(to(a)));
            let [a, t, s] = [a, t, s].map(|v| v.map(F::to_f64));
            // What the rounded a is short of a unit vector shows in the basis.
            let tolerance = 4.0 * unit_of::<F>() + (dot(a, a) - 1.0).abs();
            [dot(t, t), dot(s, s)].into_iter().for_each(|square| near(square, 1.0, tolerance));
            [dot(a, t), dot(a, s), dot(t, s)].into_iter().for_each(|product| near(product, 0.0, tolerance));
            // Right-handed: t × s = a.
            let cross = [t[1] * s[2] - t[2] * s[1], t[2] * s[0] - t[0] * s[2], t[0] * s[1] - t[1] * s[0]];
            (0..3).for_each(|i| near(cross[i], a[i], tolerance));
        }
    }
    let mut draw = Draw(9);
    let mut directions = vec![
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1.0, 0.0, 0.0],
        [1.0, 0.0, -0.0],
        [0.0, -1.0, 0.0],
        [0.0, 1.0, -1e-30],
        [1e-20, 1e-20, -1.0],
        [1e-5, 0.0, -1.0],
        [0.6, 0.0, -0.8],
    ];
    for _ in 0..5000 {
        let (z, phi) = (draw.real(-1.0, 1.0), draw.real(0.0, 2.0 * PI));
        // Half of them within 10⁻⁴ of -z, where Frisvad's form fails.
        let z = if draw.below(2) == 0 { z } else { -1.0 + 5e-9 * (1.0 + z) };
        let s = libm::sqrt(1.0 - z * z);
        directions.push([s * libm::cos(phi), s * libm::sin(phi), z]);
    }
    test(&directions, single);
    test(&directions, |v| v);
}

#[test]
fn directions_lie_where_they_are_asked_for() {
    let mut draw = Draw(10);
    for _ in 0..2000 {
        let view = View::new(Model::Phong, draw.real(0.0, 1.5));
        let (w, u) = (draw.real(0.0, 2.0), draw.real(0.0, 1.0));
        let [v, turned] = [u, u + 0.25].map(|u| direction_about(view.axis, w, u));
        near(dot(v, v), 1.0, 20.0 * U64);
        near(dot(v, view.axis), 1.0 - w, 20.0 * U64);
        // A quarter of a turn about the axis.
        near(dot(v, turned), (1.0 - w) * (1.0 - w), 20.0 * U64);
        let cross = [
            v[1] * turned[2] - v[2] * turned[1],
            v[2] * turned[0] - v[0] * turned[2],
            v[0] * turned[1] - v[1] * turned[0],
        ];
        near(dot(cross, view.axis), w * (2.0 - w), 20.0 * U64);
    }
}

// ---- References ----

/// A row of references/sampling.csv.
struct Row {
    density: Density,
    n: f64,
    /// `None`: the value is the density on the axis, times 2π.
    u: Option<f64>,
    value: f64,
}

fn references() -> Vec<Row> {
    let row = |line: &str| {
        let [power, cosines, n, u, value] = line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let power = (!power.is_empty()).then(|| power.parse().unwrap());
        let profile = Profile::ALL.into_iter().find(|p| p.power() == power).expect("a profile");
        let measure = if cosines == "1" { Measure::Projected } else { Measure::SolidAngle };
        Row {
            density: Density { profile, measure },
            n: n.parse().unwrap(),
            u: (!u.is_empty()).then(|| u.parse().unwrap()),
            value: value.parse().unwrap(),
        }
    };
    include_str!("references/sampling.csv").lines().skip(1).map(row).collect()
}

/// The stated accuracy, in u: of the peak; of the versine where u is at most ¾; of the distribution
/// function at the versine.
const PEAK: f64 = 8.0;
const VERSINE: f64 = 12.0;
const RESIDUAL: f64 = 6.0;

#[test]
fn inverses_and_peaks_are_those_of_the_table() {
    fn test<F: Real>() {
        let unit = unit_of::<F>();
        let (mut peaks, mut versines) = (0, 0);
        for Row { density, n, u, value } in references() {
            let place = format!("{density:?}, n = {n}, u = {u:?}");
            let Some(u) = u else {
                let got = 2.0 * PI * peak(density, F::from_f64(n)).to_f64();
                // π rounds in the type and again here.
                assert!((got / value - 1.0).abs() <= (PEAK + 2.0) * unit, "{place}: {got}, not {value}");
                peaks += 1;
                continue;
            };
            if F::from_f64(u).to_f64() != u {
                continue; // 1 - 2⁻⁵³ is for doubles
            }
            let got = sample_versine(density, F::from_f64(n), F::from_f64(u)).to_f64();
            let slope = 2.0 * PI * radial_pdf(density, n, value);
            assert!((got - value).abs() * slope <= RESIDUAL * unit, "{place}: {got}, not {value}");
            assert!(u > 0.75 || (got / value - 1.0).abs() <= VERSINE * unit, "{place}: {got}, not {value}");
            versines += 1;
        }
        assert!(peaks > 100 && versines > 1000);
    }
    test::<f32>();
    test::<f64>();
}

/// Between the table's rows: single precision against double, whose error is nothing here.
#[test]
fn single_precision_agrees_with_double() {
    let mut draw = Draw(11);
    for _ in 0..60_000 {
        let density = densities().nth(draw.below(14)).unwrap();
        let n = exponent(&mut draw);
        let u = if draw.below(2) == 0 {
            share(&mut draw)
        } else {
            libm::exp2(-draw.real(0.0, 23.0)) as f32 as f64
        };
        if u == 1.0 {
            continue;
        }
        let place = format!("{density:?}, n = {n}, u = {u}");
        let (got, want) = (sample_versine(density, n as f32, u as f32) as f64, sample_versine(density, n, u));
        let slope = 2.0 * PI * radial_pdf(density, n, want);
        assert!((got - want).abs() * slope <= RESIDUAL * U32, "{place}: {got}, not {want}");
        assert!(u > 0.75 || (got - want).abs() <= VERSINE * U32 * want, "{place}: {got}, not {want}");
        let (got, want) = (peak(density, n as f32) as f64, peak(density, n));
        assert!((got / want - 1.0).abs() <= PEAK * U32, "{place}: {got}, not {want}");
    }
}

// ---- Ends and bad input ----

#[test]
fn the_ends_of_the_unit_interval_give_directions() {
    fn test<F: Real>(last: F, to: impl Fn(Vec3<f64>) -> Vec3<F>) {
        assert!(last < F::ONE);
        for model in Model::ALL {
            for profile in Profile::ALL {
                for n in [0.0, 1e-20, 0.5, 3.0, 16.0, 100.0, 1e4].map(F::from_f64) {
                    for angle in [0.0, 0.5, 1.5] {
                        let view = View::new(model, angle);
                        let (normal, to_view) = (to(view.normal), to(view.to_view));
                        for (u1, u2) in [
                            (F::ZERO, F::ZERO),
                            (F::ZERO, last),
                            (last, F::ZERO),
                            (last, last),
                            (last, F::HALF),
                        ] {
                            let light = sample(model, profile, n, normal, to_view, u1, u2);
                            assert!(u1 > F::ZERO || light.is_some());
                            let Some(light) = light else { continue };
                            near(dot(light, light).to_f64(), 1.0, 30.0 * unit_of::<F>());
                            let density = pdf(model, profile, n, normal, to_view, light);
                            assert!(density >= F::ZERO && density.is_finite(), "{density:?}");
                            assert!(u1 > F::ZERO || density > F::ZERO);
                        }
                    }
                }
            }
        }
    }
    test(1.0 - U32 as f32, single);
    test(1.0 - U64, |v| v);
}

#[test]
fn what_is_out_of_the_domain_gives_none_and_nan() {
    fn test<F: Real>() {
        let (nan, infinity) = (F::NAN, F::ONE / F::ZERO);
        let (up, v): (Vec3<F>, Vec3<F>) = ([F::ZERO, F::ZERO, F::ONE], [0.6, 0.0, 0.8].map(F::from_f64));
        let broken = [nan, F::ZERO, F::ONE];
        let (n, u) = (F::TWO, F::HALF);
        for density in densities() {
            for bad in [nan, infinity, -infinity, -F::ONE, -F::from_f64(1e-30)] {
                assert!(sample_versine(density, bad, u).is_nan());
                assert!(peak(density, bad).is_nan() && radial_pdf(density, bad, u).is_nan());
            }
            for bad in [nan, infinity, F::ONE, -F::from_f64(1e-30)] {
                assert!(sample_versine(density, n, bad).is_nan());
            }
            assert!(radial_pdf(density, n, nan).is_nan());
            for outside in [F::ONE, F::TWO, infinity, -F::ONE] {
                assert_eq!(radial_pdf(density, n, outside), F::ZERO);
            }
        }
        for model in Model::ALL {
            for profile in Profile::ALL {
                let draw = |n, normal, view, u1, u2| sample(model, profile, n, normal, view, u1, u2);
                assert!(draw(n, up, v, u / F::from_u32(4), F::HALF).is_some());
                for bad in [nan, infinity, -F::ONE] {
                    assert_eq!(draw(bad, up, v, u, u), None);
                    assert!(pdf(model, profile, bad, up, v, v).is_nan());
                }
                for bad in [nan, -F::ONE, F::ONE, infinity] {
                    assert_eq!(draw(n, up, v, bad, u), None);
                    assert_eq!(draw(n, up, v, u, bad), None);
                }
                assert_eq!((draw(n, broken, v, u, u), draw(n, up, broken, u, u)), (None, None));
                for [normal, view, light] in [[broken, v, v], [up, broken, v], [up, v, broken]] {
                    assert!(pdf(model, profile, n, normal, view, light).is_nan());
                }
                // On the horizon nothing is seen, and nothing is lit.
                let flat = [F::ONE, F::ZERO, F::ZERO];
                assert_eq!(draw(n, up, flat, u, u), None);
                assert_eq!(pdf(model, profile, n, up, flat, v), F::ZERO);
                assert_eq!(pdf(model, profile, n, up, v, flat), F::ZERO);
            }
        }
        let (tangent, side) = basis(broken);
        assert!(tangent.iter().any(|x| x.is_nan()) && side.iter().any(|x| x.is_nan()));
        assert!(direction_about(up, nan, u).iter().all(|x| x.is_nan()));
        assert!(direction_about(up, F::from_u32(3), u).iter().take(2).all(|x| x.is_nan()));
    }
    test::<f32>();
    test::<f64>();
}

#[test]
fn expm1_keeps_small_arguments() {
    // eˣ - 1 = x + x²/2 + …
    assert_eq!(Real::expm1(1e-20_f64), 1e-20);
    assert_eq!(Real::expm1(1e-10_f32), 1e-10);
    assert_eq!((Real::expm1(f64::NEG_INFINITY), Real::expm1(0.0_f32)), (-1.0, 0.0));
}
