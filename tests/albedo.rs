//! Energy at every angle: closed forms along the normal and at grazing light, theorems about the angles
//! between, references from another coordinate system, and a second route from vectors alone.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/references.rs"]
mod references;

use bellfit::integral::albedo::{
    AlbedoError, Profile, Reflectance, SupremumEvidence, Usage, ceiling, directional_albedo,
    directional_albedo_plain, supremum_over_angles,
};
use bellfit::integral::{Case, Estimate, Limit, Lobe, closed_form};
use bellfit::kernel::factor::cos_n_factor;
use bellfit::kernel::lobe::{cos_n_versine, cs_versine, spherical_gaussian_versine};
use bellfit::kernel::model::Model;
use bellfit::kernel::vector::Vec3;
use core::f64::consts::{FRAC_PI_2, PI};
use draw::Draw;
use references::rows;

const EXPONENTS: [f64; 7] = [1.0, 2.0, 16.0, 16.5, 64.0, 777.75, 1024.0];

/// What rounding leaves in a factor, and in the closed forms here: far below any error of interest.
const ROUNDING: f64 = 1e-13;

fn cos_n(n: f64) -> impl Fn(f64) -> f64 {
    move |w| cos_n_versine(w, n)
}

fn cs_16(n: f64) -> impl Fn(f64) -> f64 {
    move |w| cs_versine::<16, f64>(w, n)
}

fn degrees(angle: f64) -> f64 {
    (angle / 90.0 * FRAC_PI_2).min(FRAC_PI_2)
}

/// a(θ) of cosⁿ with the factor of Table 1.
fn normalised(of: Reflectance, n: f64, theta: f64) -> Estimate {
    let value = cos_n(n);
    let lobe = Profile::new(&value, 1.0, n).unwrap();
    directional_albedo(of, &lobe, cos_n_factor(of.model(), n), theta).unwrap()
}

fn assert_is(found: Estimate, exact: f64, relative: f64, what: &str) {
    let off = (found.value - exact).abs();
    assert!(off <= found.error + relative * exact, "{what}: {found:?}, exactly {exact}: {off:e}");
    assert!(found.error <= 1e-11 * exact.max(0.1), "{what}: {found:?}");
}

/// ∫ cᵏ dc from the cosine of one angle to that of a smaller one.
fn power(k: f64, outer: f64, inner: f64) -> f64 {
    (libm::pow(libm::cos(inner), k + 1.0) - libm::pow(libm::cos(outer), k + 1.0)) / (k + 1.0)
}

/// Along the normal the reflectances meet their condition, and of the half vectors those within π/4 have L
/// above the horizon. V-cavities shadow nothing up to π/6, and 2 cos 2α of what is left up to π/4: with
/// d = V·H = c there, min(1, 2 c L_z/d) = 2 (2 c² - 1).
#[test]
fn along_the_normal_the_condition_is_met() {
    for n in EXPONENTS {
        let quarter = PI / 4.0;
        let cavities = power(n + 1.0, PI / 6.0, 0.0) + 4.0 * power(n + 3.0, quarter, PI / 6.0)
            - 2.0 * power(n + 1.0, quarter, PI / 6.0);
        for of in Reflectance::ALL {
            let exact = match of {
                Reflectance::Ndf => (n + 1.0) * power(n, quarter, 0.0),
                Reflectance::Heightfield => (n + 2.0) * power(n + 1.0, quarter, 0.0),
                Reflectance::NdfMicrofacet => (n + 1.0) * cavities,
                Reflectance::HeightfieldMicrofacet => (n + 2.0) * cavities,
                _ => 1.0,
            };
            assert_is(normalised(of, n, 0.0), exact, ROUNDING, &format!("{of:?}, n = {n}"));
        }
        // The same for cs_16 with 1/(2π Int) on its support, where the half vectors' part is all of it.
        let n = n.max(64.0);
        for of in Reflectance::ALL.into_iter().filter(|of| of.usage() == Usage::Printed) {
            let case = Case { model: of.model(), lobe: Lobe::Cs16, limit: Limit::Support };
            let value = cs_16(n);
            let lobe = Profile::new(&value, 16.0 / n, n).unwrap();
            let found = directional_albedo(of, &lobe, 1.0 / (2.0 * PI * closed_form(case, n)), 0.0).unwrap();
            assert_is(found, 1.0, ROUNDING, &format!("cs_16, {of:?}, n = {n}"));
        }
    }
}

#[test]
fn what_is_below_the_horizon_neither_lights_nor_is_seen() {
    let value = cos_n(20.0);
    let lobe = Profile::new(&value, 1.0, 20.0).unwrap();
    let (above, below): (Vec3<f64>, Vec3<f64>) = ([0.6, 0.0, 0.8], [0.6, 0.0, -0.8]);
    for of in Reflectance::ALL {
        assert!(of.value(&lobe, 1.0, above, above) > 0.0, "{of:?}");
        for (to_light, to_view) in [(above, below), (below, above), (below, below)] {
            assert_eq!(of.value(&lobe, 1.0, to_light, to_view), 0.0, "{of:?}");
        }
    }
}

/// At θ = π/2 the horizon halves every circle: half of what is not weighted, integrals of cⁿ times a power
/// of the sine elsewhere, and the whole of ∫ D cos α for V-cavities.
#[test]
fn grazing_light_leaves_closed_forms() {
    for n in EXPONENTS {
        // ∫_0^1 cⁿ √(1 - c²) dc = B((n + 1)/2, 3/2)/2
        let (a, b) = (0.5 * (n + 1.0), 1.5);
        let sine = 0.5 * libm::exp(libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b));
        for of in Reflectance::ALL {
            let factor = cos_n_factor(of.model(), n);
            let exact = match of {
                Reflectance::Phong | Reflectance::Ndf | Reflectance::Heightfield => 0.5,
                Reflectance::PhongModified => factor * 2.0 * sine,
                Reflectance::BlinnPhong => factor * 8.0 * sine,
                Reflectance::BlinnPhongModified => factor * 4.0 * PI * (1.0 / (n + 2.0) - 1.0 / (n + 4.0)),
                Reflectance::NdfMicrofacet => (n + 1.0) / (n + 2.0),
                Reflectance::HeightfieldMicrofacet => 1.0,
            };
            // lgamma is some thousand at n = 1024, good to its last bits.
            assert_is(normalised(of, n, FRAC_PI_2), exact, 2e-12, &format!("{of:?}, n = {n}"));
        }
    }
}

/// Lobes without n ≥ 16: e^(-n w), which never ends, and cs_16 at n = 4, which reaches around to its axis'
/// far side. The hemisphere about the mirror direction is exact along the normal, half of all at π/2.
#[test]
fn other_lobes_and_other_supports() {
    let n = 3.0;
    let gaussian = |w: f64| spherical_gaussian_versine(w, n);
    let lobe = Profile::new(&gaussian, 2.0, n).unwrap();
    let at = |theta| directional_albedo(Reflectance::Phong, &lobe, 1.0 / (2.0 * PI), theta).unwrap();
    assert_is(at(0.0), -libm::expm1(-n) / n, ROUNDING, "e^(-n w), θ = 0");
    assert_is(at(FRAC_PI_2), -0.5 * libm::expm1(-2.0 * n) / n, ROUNDING, "e^(-n w), θ = π/2");
    let n = 4.0;
    let value = cs_16(n);
    let lobe = Profile::new(&value, 2.0, n).unwrap();
    let at = |theta| directional_albedo(Reflectance::Phong, &lobe, 1.0 / (2.0 * PI), theta).unwrap();
    // ∫_0^e (1 - n w/16)^16 dw = 16/(17 n) (1 - (1 - n e/16)^17)
    let whole = |end: f64| 16.0 / (17.0 * n) * (1.0 - libm::pow(1.0 - n * end / 16.0, 17.0));
    assert_is(at(0.0), whole(1.0), ROUNDING, "cs_16, θ = 0");
    assert_is(at(FRAC_PI_2), 0.5 * whole(2.0), ROUNDING, "cs_16, θ = π/2");
}

/// The furnace: V-cavities lose what they shadow, all of it comes back at grazing angles, and the missing
/// light vanishes with cos θ at the latest like √n cos θ.
#[test]
fn a_furnace_gains_nothing_and_loses_nothing_at_grazing_angles() {
    for n in EXPONENTS {
        for (of, most) in
            [(Reflectance::HeightfieldMicrofacet, 1.0), (Reflectance::NdfMicrofacet, (n + 1.0) / (n + 2.0))]
        {
            let angles = (0..=90).map(f64::from).chain([89.9, 89.999, 89.99999]);
            for angle in angles {
                let found = normalised(of, n, degrees(angle));
                assert!(found.value <= most + found.error + ROUNDING, "{of:?}, n = {n}, {angle}°: {found:?}");
            }
            for short in [1e-2, 1e-4, 1e-6, 1e-8] {
                let lost = most - normalised(of, n, FRAC_PI_2 - short).value;
                assert!(lost < short * libm::sqrt(n.max(2.0)), "{of:?}, n = {n}, {short:e}: {lost:e}");
                assert!(lost > 0.01 * short, "{of:?}, n = {n}, {short:e}: {lost:e}");
            }
        }
    }
    // In between it does lose: a single bounce is not all of the light.
    assert!(normalised(Reflectance::HeightfieldMicrofacet, 64.0, degrees(80.0)).value < 0.95);
}

/// The ceilings are theorems for every lobe that never rises, so for caps, of which all such lobes are
/// made, and for what lies between a cap and a needle.
#[test]
fn no_angle_exceeds_the_ceiling() {
    let mut draw = Draw(1934);
    let mut near = 0;
    for _ in 0..400 {
        let of = Reflectance::ALL[draw.below(8)];
        // At most 1 for those about the normal, with some that end where the horizon first cuts.
        let support = libm::pow(draw.real(0.02, 1.0), 2.0) * if draw.below(4) == 0 { 2.0 } else { 1.0 };
        let sharpness = [0.0, 0.5, 1.0, 4.0, 16.0][draw.below(5)];
        let value = move |w: f64| if w < support { libm::pow(1.0 - w / support, sharpness) } else { 0.0 };
        let value: Box<dyn Fn(f64) -> f64> =
            if sharpness == 0.0 { Box::new(|_| 1.0) } else { Box::new(value) };
        let lobe = Profile::new(&*value, support, (1.0 + sharpness) / support).unwrap();
        let theta = degrees(draw.real(0.0, 90.0));
        let (at, most) =
            (directional_albedo(of, &lobe, 1.0, theta).unwrap(), ceiling(of, &lobe, 1.0).unwrap());
        let margin = most.value + most.error - (at.value - at.error);
        assert!(margin >= 0.0, "{of:?}, support {support}, power {sharpness}, θ = {theta}: {at:?}, {most:?}");
        near += usize::from(at.value > 0.99 * most.value);
    }
    // The bounds are no idle ones.
    assert!(near > 20, "{near} within a hundredth");
}

#[test]
fn the_largest_albedo_is_found_where_the_theorems_put_it() {
    for n in EXPONENTS {
        for of in Reflectance::ALL {
            let value = cos_n(n);
            let lobe = Profile::new(&value, 1.0, n).unwrap();
            let factor = cos_n_factor(of.model(), n);
            let found = supremum_over_angles(of, &lobe, factor).unwrap();
            assert_eq!(found.evidence, SupremumEvidence::Bounded, "{of:?}, n = {n}: {found:?}");
            let looked = (0..=180).map(|k| normalised(of, n, degrees(f64::from(k) / 2.0)));
            let highest = looked.reduce(|a, b| if b.value > a.value { b } else { a }).unwrap();
            let value = found.at.value;
            assert!(value.value >= highest.value - highest.error - value.error, "{found:?}, {highest:?}");
            match of.usage() {
                Usage::Printed => assert_eq!(found.at.angle, 0.0, "{of:?}, n = {n}"),
                // Sharp enough a lobe loses nothing that shows along the normal either.
                Usage::Microfacet if n < 128.0 => assert_eq!(found.at.angle, FRAC_PI_2, "{of:?}, n = {n}"),
                Usage::Microfacet => assert!(value.value >= highest.value - ROUNDING),
            }
        }
    }
    // √c, wider than a cosine: the pairs' bound is not reached, and the angles are searched. At π/2 V sees
    // half of all half vectors; no angle sees more, as a fine scan says.
    let value = cos_n(0.5);
    let lobe = Profile::new(&value, 1.0, 0.5).unwrap();
    let found = supremum_over_angles(Reflectance::Ndf, &lobe, 1.5 / (2.0 * PI)).unwrap();
    assert_eq!(found.evidence, SupremumEvidence::Sampled);
    assert_is(found.at.value, 0.5, ROUNDING, "√c");
    assert!(found.ceiling.value > 0.5 + 0.01);
    let scan = (0..900).map(|k| normalised(Reflectance::Ndf, 0.5, degrees(f64::from(k) / 10.0)).value);
    assert!(scan.into_iter().all(|a| a < 0.5 + ROUNDING));
}

/// tests/references/albedo.csv: the light's own spherical coordinates, where the lobe has no axis.
#[test]
fn references_lie_within_the_stated_errors() {
    let table = rows::<7>("albedo.csv");
    assert_eq!(table.len(), 18);
    for [model, usage, lobe, n, theta, value, error] in table {
        let [n, theta, value, error] = [n, theta, value, error].map(|x| x.parse::<f64>().unwrap());
        let of = Reflectance::new(Model::from_id(&model).unwrap(), Usage::from_id(&usage).unwrap()).unwrap();
        let (cosine, bell) = (cos_n(n), cs_16(n));
        let (shape, support): (&dyn Fn(f64) -> f64, f64) =
            if lobe == "cos-n" { (&cosine, 1.0) } else { (&bell, 16.0 / n) };
        let profile = Profile::new(shape, support, n).unwrap();
        let found = directional_albedo(of, &profile, 1.0, theta).unwrap();
        let off = (found.value - value).abs();
        assert!(off <= found.error + error, "{of:?}, {lobe}, {n}, {theta}: {found:?}, {value} ± {error:e}");
        assert!(found.error < 1e-12 * value && error < 1e-10 * value);
        // No kink lies inside a panel: halving down to one costs some hundred evaluations each.
        assert!(found.evaluations < 900, "{of:?}, {lobe}, {n}, {theta}: {found:?}");
    }
}

/// The second route shares the rule and no formula: vectors, and an azimuth that is not told anything.
#[test]
fn two_numeric_dimensions_agree_with_one() {
    let mut draw = Draw(1977);
    for of in Reflectance::ALL {
        for _ in 0..3 {
            let n = libm::exp2(draw.real(2.0, 10.0));
            let theta = degrees(draw.real(0.0, 89.0));
            let (cosine, bell) = (cos_n(n), cs_16(n));
            let (shape, support): (&dyn Fn(f64) -> f64, f64) =
                if draw.below(2) == 0 { (&cosine, 1.0) } else { (&bell, (16.0 / n).min(2.0)) };
            let lobe = Profile::new(shape, support, n).unwrap();
            let factor = n / (2.0 * PI);
            let found = directional_albedo(of, &lobe, factor, theta).unwrap();
            let plain = directional_albedo_plain(of, &lobe, factor, theta).unwrap();
            let off = (found.value - plain.value).abs();
            // The plain route's azimuths halve their way to the kinks of V-cavities, and count none of it.
            assert!(off <= found.error + plain.error + 2e-8, "{of:?}, n = {n}, θ = {theta}: {off:e}");
            assert!(plain.error < 1e-6 && found.error < 1e-11, "{plain:?}, {found:?}");
        }
    }
}

fn direction(draw: &mut Draw) -> Vec3<f64> {
    let (z, azimuth) = (draw.real(0.02, 1.0), draw.real(-PI, PI));
    let across = libm::sqrt(1.0 - z * z);
    [across * libm::cos(azimuth), across * libm::sin(azimuth), z]
}

#[test]
fn reciprocity_is_what_the_table_says() {
    let mut draw = Draw(1856);
    let n = 8.0;
    let value = cos_n(n);
    let lobe = Profile::new(&value, 1.0, n).unwrap();
    for of in Reflectance::ALL {
        let (mut largest, mut counted) = (0.0_f64, 0);
        for _ in 0..500 {
            let (l, v) = (direction(&mut draw), direction(&mut draw));
            let (there, back) = (of.value(&lobe, 1.0, l, v), of.value(&lobe, 1.0, v, l));
            // Both lobes are 0 together: R·L < 0 for Phong.
            if there.max(back) > 1e-9 {
                largest = largest.max((there - back).abs() / there.max(back));
                counted += 1;
            }
        }
        assert!(counted > 100, "{of:?}: {counted}");
        if of.is_reciprocal() {
            // A few roundings of w, times the lobe's slope n/(1 - w) where it is 1e-9 yet: 8/0.07.
            assert!(largest < 1e-12, "{of:?}: {largest:e}");
        } else {
            // (N·L)/(N·V) is off by more than half somewhere.
            assert!(largest > 0.5, "{of:?}: {largest:e}");
        }
    }
    let reciprocal = Reflectance::ALL.iter().filter(|of| of.is_reciprocal()).count();
    assert_eq!(reciprocal, 4, "the modified ones and the microfacets");
}

/// What a reflectance that is not reciprocal does to a beam: of light from θ Phong's reflects ∫ f_r (N·V) dω
/// over V, which by R·V = R·L is the modified model's albedo over cos θ, and at grazing light no bound holds.
#[test]
fn without_reciprocity_a_beam_gains_what_a_furnace_does_not() {
    let n = 64.0;
    let value = cos_n(n);
    let lobe = Profile::new(&value, 1.0, n).unwrap();
    let factor = cos_n_factor(Model::Phong, n);
    let share = |theta: f64| {
        let found = directional_albedo(Reflectance::PhongModified, &lobe, factor, theta).unwrap();
        found.value / libm::cos(theta)
    };
    assert!(share(0.0) < 1.0 && normalised(Reflectance::Phong, n, degrees(89.0)).value < 1.0);
    assert!(share(degrees(89.0)) > 1.5 && share(degrees(89.9)) > 15.0);
    // The identity behind it, at directions: f_r(L, V) (N·L) is the modified one's f_r(V, L).
    let mut draw = Draw(1975);
    for _ in 0..100 {
        let (l, v) = (direction(&mut draw), direction(&mut draw));
        let [there, back] = [(Reflectance::Phong, l, v), (Reflectance::PhongModified, v, l)]
            .map(|(of, l, v)| of.value(&lobe, factor, l, v));
        // A few roundings of w = |R - L|²/2, times the lobe's slope.
        assert!((there * l[2] - back).abs() <= 1e-12 * factor, "{l:?}, {v:?}: {there}, {back}");
    }
}

#[test]
fn every_model_has_its_uses_and_no_others() {
    for (model, usage) in Model::ALL.into_iter().flat_map(|m| Usage::ALL.map(|u| (m, u))) {
        let normals = matches!(model, Model::BlinnPhongNdf | Model::BlinnPhongHeightfield);
        let of = Reflectance::new(model, usage);
        assert_eq!(of.is_some(), normals || usage == Usage::Printed, "{model:?}, {usage:?}");
        if let Some(of) = of {
            assert_eq!((of.model(), of.usage()), (model, usage));
        }
        assert_eq!(Usage::from_id(usage.id()), Some(usage));
    }
    assert_eq!(Usage::from_id("Printed"), None);
}

#[test]
fn what_lies_below_the_surface_reflects_nothing() {
    let value = cos_n(4.0);
    let lobe = Profile::new(&value, 1.0, 4.0).unwrap();
    let (up, down) = ([0.6, 0.0, 0.8], [0.6, 0.0, -0.8]);
    for of in Reflectance::ALL {
        assert_eq!([of.value(&lobe, 1.0, up, down), of.value(&lobe, 1.0, down, up)], [0.0; 2], "{of:?}");
        assert!(of.value(&lobe, 1.0, up, [-0.6, 0.0, 0.8]) > 0.0);
    }
}

#[test]
fn bad_input_is_named() {
    let value = cos_n(64.0);
    let lobe = Profile::new(&value, 1.0, 64.0).unwrap();
    for of in Reflectance::ALL {
        for bad in [-1e-9, FRAC_PI_2 + 1e-9, PI, f64::NAN, f64::INFINITY, -f64::INFINITY] {
            for found in
                [directional_albedo(of, &lobe, 1.0, bad), directional_albedo_plain(of, &lobe, 1.0, bad)]
            {
                let error = found.unwrap_err();
                assert!(matches!(error, AlbedoError::Angle(x) if x.to_bits() == bad.to_bits()), "{error:?}");
                assert!(error.to_string().contains(&format!("θ = {bad}")), "{error}");
            }
        }
        assert!(directional_albedo_plain(of, &lobe, 1.0, FRAC_PI_2).is_err(), "V is not above the surface");
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            let found = [
                directional_albedo(of, &lobe, bad, 0.5).unwrap_err(),
                ceiling(of, &lobe, bad).unwrap_err(),
                supremum_over_angles(of, &lobe, bad).unwrap_err(),
            ];
            assert!(found.iter().all(|e| matches!(e, AlbedoError::Factor(_))), "{found:?}");
        }
        assert_eq!(directional_albedo(of, &lobe, 0.0, 0.5).unwrap().value, 0.0);
    }
}

#[test]
fn a_lobe_of_another_shape_is_refused() {
    let new =
        |value: &dyn Fn(f64) -> f64, support, n| Profile::new(value, support, n).map(|_| ()).unwrap_err();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(new(&|_| 1.0, 1.0, bad), AlbedoError::Exponent(_)));
    }
    for bad in [0.0, -1.0, 2.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(new(&|_| 1.0, bad, 1.0), AlbedoError::Support(_)));
    }
    for bad in [0.0, 0.99, 1.01, f64::NAN] {
        assert!(matches!(new(&move |_| bad, 1.0, 1.0), AlbedoError::Axis(_)), "{bad}");
    }
    // Risen again behind its zero, negative there, and not a number anywhere.
    let uncut = |w: f64| {
        let b = 1.0 - 4.0 * w;
        b * b
    };
    assert!(matches!(new(&uncut, 0.5, 4.0), AlbedoError::Shape { .. }));
    assert!(matches!(new(&|w| 1.0 - 4.0 * w, 0.5, 4.0), AlbedoError::Shape { value, .. } if value < 0.0));
    let hole = |w: f64| if w > 0.3 { f64::NAN } else { 1.0 };
    assert!(matches!(new(&hole, 0.5, 4.0), AlbedoError::Shape { value, .. } if value.is_nan()));
}
