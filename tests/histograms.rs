//! Histograms of what importance sampling draws against its density, by Pearson's χ²; and the same
//! tests on densities with planted errors.
//!
//! Expected counts integrate the public `pdf` over each cell by quadrature, in coordinates that are set
//! up in support/view.rs: never by the sampler's own distribution function.

#[path = "support/chi_square.rs"]
mod chi_square;
#[path = "support/draw.rs"]
mod draw;
#[path = "support/view.rs"]
mod view;

use bellfit::kernel::model::Model;
use bellfit::kernel::sampling::{Density, Measure, Profile, pdf, radial_pdf};
use bellfit::kernel::vector::{Vec3, dot};
use chi_square::{p_value, sidak, survival};
use std::f64::consts::PI;
use view::{ANGLES, View, about_normal, drawn, edges, gauss, mix};

/// All tests of histograms together fail by chance this often.
const LEVEL: f64 = 1e-4;
const PROFILES: [Profile; 3] = [Profile::CosN, Profile::Cs16, Profile::Cs4];
const EXPONENTS: [f64; 3] = [2.0, 16.0, 256.0];
/// Six models, lobes, exponents; three views about the axis and one in the world's angles.
const HISTOGRAMS: usize = 6 * 3 * 3 * (3 + 1);
const DRAWS: usize = 100_000;
const SECTORS: usize = 8;

/// The p-value of a density, given what was drawn at an exponent.
type Histogram = fn(&View, f64, &[Option<Vec3<f64>>], &dyn Fn(Vec3<f64>) -> f64) -> f64;

/// p-value over rings × sectors about the axis, and what is below the horizon.
fn about_the_axis(
    view: &View,
    n: f64,
    lights: &[Option<Vec3<f64>>],
    density: &dyn Fn(Vec3<f64>) -> f64,
) -> f64 {
    let edges = edges(n);
    let rings = edges.len() - 1;
    let mut observed = vec![0_u32; rings * SECTORS + 1];
    for light in lights {
        let cell = light.map_or(rings * SECTORS, |light| {
            let (w, phi) = view.of(light);
            let ring = edges.partition_point(|&edge| edge <= w).clamp(1, rings) - 1;
            let turn = (phi + PI) / (2.0 * PI) * SECTORS as f64;
            ring * SECTORS + (turn as usize).min(SECTORS - 1)
        });
        observed[cell] += 1;
    }
    let step = 2.0 * PI / SECTORS as f64;
    let expect = |cell: usize| {
        let (ring, sector) = (cell / SECTORS, (cell % SECTORS) as f64);
        let phi = [sector * step - PI, (sector + 1.0) * step - PI];
        lights.len() as f64 * view.integrate([edges[ring], edges[ring + 1]], phi, density)
    };
    let mut expected: Vec<f64> = (0..rings * SECTORS).map(expect).collect();
    expected.push(0.0);
    let above: f64 = expected.iter().sum();
    expected[rings * SECTORS] = (lights.len() as f64 - above).max(0.0);
    p_value(&observed, &expected)
}

/// p-value over a grid of the world's angles (θ, φ) about N around the mirror direction, with one cell
/// for what lies elsewhere.
fn in_the_world(
    view: &View,
    n: f64,
    lights: &[Option<Vec3<f64>>],
    density: &dyn Fn(Vec3<f64>) -> f64,
) -> f64 {
    const SIDE: usize = 10;
    let theta = libm::acos(view.cos);
    // Three widths of the lobe to either side, which the half vector doubles.
    let reach = if about_normal(view.model) { 6.0 } else { 3.0 } / libm::sqrt(n + 1.0);
    let (from, to) = ((theta - reach).max(0.0), (theta + reach).min(PI / 2.0));
    let wide = (reach / view.sin).min(PI);
    let mut observed = vec![0_u32; SIDE * SIDE + 1];
    for light in lights {
        let cell = light.map_or(SIDE * SIDE, |light| {
            // φ = 0 in the mirror direction.
            let phi = libm::atan2(dot(light, view.side), -dot(light, view.along));
            let row = (libm::acos(dot(light, view.normal)) - from) / (to - from) * SIDE as f64;
            let column = (phi + wide) / (2.0 * wide) * SIDE as f64;
            let inside = row >= 0.0 && row < SIDE as f64 && column >= 0.0 && column < SIDE as f64;
            if inside { row as usize * SIDE + column as usize } else { SIDE * SIDE }
        });
        observed[cell] += 1;
    }
    let mut expected: Vec<f64> = Vec::new();
    for row in 0..SIDE {
        for column in 0..SIDE {
            let edge = |from: f64, to: f64, i: usize| from + (to - from) * i as f64 / SIDE as f64;
            let rows = [edge(from, to, row), edge(from, to, row + 1)];
            let columns = [edge(-wide, wide, column), edge(-wide, wide, column + 1)];
            let cell = gauss(rows, 2, |theta| {
                libm::sin(theta)
                    * gauss(columns, 2, |phi| {
                        let across = mix(-libm::cos(phi), view.along, libm::sin(phi), view.side);
                        density(mix(libm::cos(theta), view.normal, libm::sin(theta), across))
                    })
            });
            expected.push(cell * lights.len() as f64);
        }
    }
    let rest = lights.len() as f64 - expected.iter().sum::<f64>();
    expected.push(rest.max(0.0));
    p_value(&observed, &expected)
}

fn histograms_match(model: Model) {
    let level = sidak(LEVEL, HISTOGRAMS);
    for (p, profile) in PROFILES.into_iter().enumerate() {
        for (e, n) in EXPONENTS.into_iter().enumerate() {
            for (a, angle) in ANGLES.into_iter().enumerate() {
                let view = View::new(model, angle);
                let seed = (((model as usize * 3 + p) * 3 + e) * 3 + a) as u64;
                let lights = drawn(&view, profile, n, seed, DRAWS);
                let density = |light| pdf(model, profile, n, view.normal, view.to_view, light);
                let value = about_the_axis(&view, n, &lights, &density);
                assert!(value > level, "{}, {profile:?}, n = {n}, view {angle}: {value:e}", model.id());
                if a == 1 {
                    let value = in_the_world(&view, n, &lights, &density);
                    assert!(value > level, "{}, {profile:?}, n = {n}, world: {value:e}", model.id());
                }
            }
        }
    }
}

macro_rules! histograms {
    ($($name:ident = $model:ident),+ $(,)?) => {
        $(
            #[test]
            fn $name() {
                histograms_match(Model::$model);
            }
        )+
    };
}

histograms!(
    histograms_of_phong = Phong,
    histograms_of_phong_modified = PhongModified,
    histograms_of_blinn_phong = BlinnPhong,
    histograms_of_blinn_phong_modified = BlinnPhongModified,
    histograms_of_blinn_phong_ndf = BlinnPhongNdf,
    histograms_of_blinn_phong_heightfield = BlinnPhongHeightfield,
);

/// Upper critical values of the NIST/SEMATECH e-Handbook, table 1.3.6.7.4, printed to three decimals.
#[test]
fn survival_is_that_of_the_table() {
    let table = [
        (2, 4.605, 0.1),
        (2, 13.816, 0.001),
        (10, 18.307, 0.05),
        (10, 29.588, 0.001),
        (30, 43.773, 0.05),
        (30, 59.703, 0.001),
        (100, 118.498, 0.1),
        (100, 135.807, 0.01),
        (100, 149.449, 0.001),
    ];
    for (dof, critical, level) in table {
        let (above, below) = (survival(dof, critical + 5e-4), survival(dof, critical - 5e-4));
        assert!(above <= level && level <= below, "{dof}: {above} to {below}");
    }
    // Šidák: 1 - (1 - level)^tests.
    let together = 1.0 - libm::pow(1.0 - sidak(1e-4, 200), 200.0);
    assert!((together - 1e-4).abs() < 1e-13, "{together}");
}

/// A density's mistake: what it makes of the right value at L.
type Mistake<'a> = &'a dyn Fn(Vec3<f64>, f64) -> f64;

#[test]
fn planted_errors_are_caught() {
    let level = sidak(LEVEL, HISTOGRAMS);
    for (i, profile) in PROFILES.into_iter().enumerate() {
        for model in Model::ALL {
            let view = View::new(model, ANGLES[1]);
            let right = |n, light| pdf(model, profile, n, view.normal, view.to_view, light);
            let caught = |n: f64, mistakes: &[(&str, Mistake)]| {
                let lights = drawn(&view, profile, n, 1000 + (i * 6 + model as usize) as u64, DRAWS);
                for test in [about_the_axis as Histogram, in_the_world] {
                    let value = test(&view, n, &lights, &|light| right(n, light));
                    assert!(value > level, "{}, {profile:?}: {value:e}", model.id());
                    for (name, wrong) in mistakes {
                        let value = test(&view, n, &lights, &|light| wrong(light, right(n, light)));
                        assert!(value < level, "{}, {profile:?}, {name}: {value:e}", model.id());
                    }
                }
            };
            let v_h = |light: Vec3<f64>| {
                let sum = mix(1.0, light, 1.0, view.to_view);
                dot(view.to_view, sum) / libm::sqrt(dot(sum, sum))
            };
            // Turned about the normal by 0.03.
            let turned = |light: Vec3<f64>| {
                let (x, y) = (dot(light, view.along), dot(light, view.side));
                let flat = mix(x - 0.03 * y, view.along, y + 0.03 * x, view.side);
                mix(1.0, flat, dot(light, view.normal), view.normal)
            };
            let mistakes: [(&str, Mistake); 6] = [
                ("an albedo of 1.1", &|_, pdf| 1.1 * pdf),
                ("an exponent 5 % off", &|light, _| right(16.8, light)),
                ("azimuth", &|light, pdf| pdf * (1.0 + 0.06 * libm::sin(view.of(light).1))),
                ("frame", &|light, _| right(16.0, turned(light))),
                // Of half vectors alone: 1/(4 V·H) left out; a constant in its place repairs nothing.
                ("Jacobian", &|light, pdf| pdf * 4.0 * v_h(light)),
                ("Jacobian but for its mean", &|light, pdf| pdf * v_h(light) / 0.7),
            ];
            caught(16.0, &mistakes[..if about_normal(model) { 6 } else { 4 }]);
            let Density { profile, measure } = Density::of(model, profile);
            let other = if measure == Measure::Projected { Measure::SolidAngle } else { Measure::Projected };
            let measured = |light: Vec3<f64>, pdf: f64| {
                let w = view.of(light).0;
                let [other, own] =
                    [other, measure].map(|measure| radial_pdf(Density { profile, measure }, 2.0, w));
                if own > 0.0 { pdf * other / own } else { 0.0 }
            };
            caught(2.0, &[("f for f c, or f c for f", &measured)]);
        }
    }
}
