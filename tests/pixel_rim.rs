//! What texels on the rim count: areas in the ellipse, and volumes beyond a line.
//!
//! References: tests/references/pixel_coverage.csv and pixel_clip.csv by pixel.py (mpmath); theorems. Errors are
//! counted in u, half an ulp at 1; every bound is the one that the kernel's page states.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/pixel.rs"]
mod pixel;
#[path = "support/references.rs"]
mod references;

use bellfit::kernel::pixel::*;
use bellfit::kernel::real::Real;
use draw::Draw;
use pixel::*;
use references::{Reference, rows};
use std::f64::consts::PI;

const INF: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;

fn ellipse(j: [f64; 4]) -> Footprint<f64> {
    Footprint::of(jacobian(j), Padding::Plain)
}

fn circle(radius: f64) -> Footprint<f64> {
    ellipse([radius, 0.0, 0.0, radius])
}

// ---- Areas ----

#[test]
fn areas_against_references() {
    fn test<F: Real>() -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        let table = rows::<9>("pixel_coverage.csv");
        assert!(table.len() > 130);
        for row in table {
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let j = jacobian::<F>([number(0), number(1), number(2), number(3)]);
            let padding = if row[4] == "padded" { Padding::Padded } else { Padding::Plain };
            let (u, v) = (F::from_f64(number(5)), F::from_f64(number(6)));
            let (footprint, axes) = (Footprint::of(j, padding), Axes::of(j, padding));
            let area = coverage(&footprint, u, v).to_f64();
            let major = axes.major.to_f64();
            let error = distance(&Reference::parse(&row[7]).unwrap(), area) / unit::<F>() / (1.0 + major);
            assert!(error <= 8.0, "{row:?}: {area}, {error} u (1 + major)");
            worst[0] = worst[0].max(error);
            if !row[8].is_empty() {
                let area = half_plane(&footprint, u, v).to_f64();
                // The distance is (1 - √Q)/|∇√Q|, and 1/|∇√Q| at most the major semi-axis.
                let room = unit::<F>() * (1.0 + major) * axes.aspect().to_f64();
                let error = distance(&Reference::parse(&row[8]).unwrap(), area) / room;
                assert!(error <= 8.0, "{row:?}: {area}, {error}");
                worst[1] = worst[1].max(error);
            }
        }
        worst
    }
    println!("in u (1 + major), and that times the aspect: {:?}, {:?}", test::<f32>(), test::<f64>());
}

/// Every texel once: the areas are a partition of the ellipse.
#[test]
fn all_texels_together_have_the_ellipses_area() {
    let mut draw = Draw(51);
    for round in 0..400 {
        let (major, aspect) = (libm::exp(draw.real(-2.0, 3.5)), libm::exp(draw.real(0.0, 5.0)));
        let footprint = ellipse(drawn(&mut draw, major, aspect));
        // The grid's place beside the middle; every fourth has a corner or a line right through it.
        let [x, y] =
            [0; 2].map(|_| if round % 4 == 0 { draw.below(2) as f64 * 0.5 } else { draw.real(0.0, 1.0) });
        let (width, height) = footprint.bounds();
        let (columns, lines) = (libm::ceil(width) as i32 + 1, libm::ceil(height) as i32 + 1);
        let (mut sum, mut full, mut texels) = (0.0, 0, 0);
        for line in -lines..=lines {
            for column in -columns..=columns {
                let (u, v) = (f64::from(column) + x, f64::from(line) + y);
                let area = coverage(&footprint, u, v);
                assert!((0.0..=1.0).contains(&area), "{area}");
                (sum, full, texels) = (sum + area, full + i32::from(area == 1.0), texels + 1);
                // In and out, by corners, which decide for a convex figure where no edge is crossed.
                let corner = |a: f64, b: f64| footprint.q(u + a, v + b) <= 1.0;
                let inside = corner(-0.5, -0.5) && corner(0.5, -0.5) && corner(-0.5, 0.5) && corner(0.5, 0.5);
                assert_eq!(inside, area == 1.0, "{footprint:?} at ({u}, {v}): {area}");
                if u.abs() - 0.5 > width || v.abs() - 0.5 > height {
                    assert_eq!(area, 0.0);
                }
            }
        }
        let want = PI * footprint.determinant.sqrt();
        // Neighbours share their edges' crossings up to their own rounding, u (1 + major) a texel on the rim.
        let room = 8.0 * unit::<f64>() * (1.0 + major) * (8.0 * (1.0 + width + height)) + want * 1e-14;
        assert!((sum - want).abs() <= room, "{footprint:?}: {sum} for {want}, {full} of {texels} full");
    }
}

#[test]
fn areas_have_the_ellipses_symmetries() {
    let mut draw = Draw(52);
    for _ in 0..2000 {
        let (major, aspect) = (libm::exp(draw.real(-1.0, 3.0)), libm::exp(draw.real(0.0, 4.0)));
        let f = ellipse(drawn(&mut draw, major, aspect));
        let (width, height) = f.bounds();
        let (u, v) = (draw.real(-1.2, 1.2) * width, draw.real(-1.2, 1.2) * height);
        let area = coverage(&f, u, v);
        let mirrored = Footprint { uv: -f.uv, ..f };
        let swapped = Footprint { uu: f.vv, vv: f.uu, ..f };
        let room = 16.0 * unit::<f64>() * (1.0 + major);
        for other in [coverage(&f, -u, -v), coverage(&mirrored, -u, v), coverage(&mirrored, u, -v)] {
            assert!((other - area).abs() <= room, "{f:?} at ({u}, {v}): {area} {other}");
        }
        assert!((coverage(&swapped, v, u) - area).abs() <= room);
        // A larger ellipse holds no less.
        let grown =
            Footprint { uu: 4.0 * f.uu, uv: 4.0 * f.uv, vv: 4.0 * f.vv, determinant: 16.0 * f.determinant };
        assert!(coverage(&grown, u, v) >= area - room);
    }
}

#[test]
fn areas_at_special_places() {
    // The rim through corners, along edges and touching them from either side.
    let third = PI / 3.0 - libm::sqrt(3.0) / 4.0; // of the circle 1 beyond the line at ½, times 1
    let near = |got: f64, want: f64| assert!((got - want).abs() < 4e-15, "{got} {want}");
    near(coverage(&circle(0.5), 0.0, 0.0), PI / 4.0); // the inscribed circle
    near(coverage(&circle(0.5), 1.0, 0.0), 0.0); // touches
    near(coverage(&circle(0.5), 0.5, 0.0), PI / 8.0); // an edge through the middle
    near(coverage(&circle(0.5), 0.5, 0.5), PI / 16.0); // a corner in the middle
    near(coverage(&circle(1.0), 1.0, 0.0), {
        // Beyond u = ½ within |v| ≤ ½: ∫ √(1 - v²) - ½ over v from -½ to ½
        PI / 6.0 + libm::sqrt(3.0) / 4.0 - 0.5
    });
    // Segments beyond the four lines at ½ overlap in the corners; what is beyond one is 3 texels' share.
    near(2.0 * coverage(&circle(1.0), 1.0, 1.0) + coverage(&circle(1.0), 1.0, 0.0), third);
    let circumscribed = circle(libm::sqrt(0.5) * (1.0 + 1e-15));
    assert_eq!(coverage(&circumscribed, 0.0, 0.0), 1.0);
    // Thinner than a texel, across it: 2·10⁻³ ∫ √(1 - 10⁻⁶u²) over a texel, = 2·10⁻³ (1 - 10⁻⁶/24 - 10⁻¹²/640 …).
    near(
        coverage(&ellipse([1000.0, 0.0, 0.0, 0.001]), 0.0, 0.0),
        0.002 * (1.0 - 1e-6 / 24.0 - 1e-12 / 640.0),
    );
    // What is not a place.
    for (u, v) in [(NAN, 0.0), (0.0, NAN)] {
        assert!(coverage(&circle(1.0), u, v).is_nan() && half_plane(&circle(1.0), u, v).is_nan());
    }
    assert_eq!(coverage(&circle(1.0), INF, 0.0), 0.0);
}

#[test]
fn half_planes_follow_the_tangent() {
    let mut draw = Draw(53);
    for _ in 0..2000 {
        let angle = draw.real(-PI, PI);
        let (nu, nv) = (libm::cos(angle), libm::sin(angle));
        let at = |distance| Tangent { distance, nu, nv }.area();
        assert_eq!((at(0.0), at(INF), at(-INF)), (0.5, 1.0, 0.0));
        let distance = draw.real(-0.8, 0.8);
        let area = at(distance);
        // The two sides of one line, and the direction's symmetries.
        assert!((area + at(-distance) - 1.0).abs() < 4.0 * unit::<f64>());
        assert_eq!(area, Tangent { distance, nu: nv, nv: -nu }.area());
        assert!(at(distance + 0.01) >= area);
        // Its derivative is the length of the line in the square: by differences of the formula against a
        // clipping of the line.
        let h = 1e-6;
        let slope = (at(distance + h) - at(distance - h)) / (2.0 * h);
        let (mut low, mut high) = (-INF, INF);
        for (normal, along) in [(nu, -nv), (nv, nu)] {
            let (a, b) = ((-0.5 - distance * normal) / along, (0.5 - distance * normal) / along);
            (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        }
        // At kinks of the length the central difference is off by half of h times the jump of its slope.
        let steepest = 1.0 / (nu * nv).abs().max(1e-3);
        assert!((slope - (high - low).max(0.0)).abs() < 1e-8 + 2.0 * h * steepest, "{angle}, {distance}");
        // The rim of a circle is where it is.
        let (radius, place) = (draw.real(0.5, 20.0), draw.real(0.1, 25.0));
        let tangent = Tangent::of(&circle(radius), place * nu, place * nv);
        assert!((tangent.distance - (radius - place)).abs() < 1e-13);
        assert!((tangent.nu - nu).abs() < 1e-14 && (tangent.nv - nv).abs() < 1e-14);
    }
    // In the middle no side is nearer.
    assert_eq!(half_plane(&circle(0.25), 0.0, 0.0), 1.0);
    // On the rim of a large circle it exceeds the area by ∫ t²/(2 r) along the line in the square: 1/(24 r)
    // for an edge of length 1, √2/(12 r) on the diagonal; what is left is of the order 1/r².
    for radius in [4.0, 64.0, 1024.0] {
        let gap = |u, v| half_plane(&circle(radius), u, v) - coverage(&circle(radius), u, v);
        assert!((gap(radius, 0.0) * 24.0 * radius - 1.0).abs() < 0.1 / radius);
        let place = radius * libm::sqrt(0.5);
        assert!((gap(place, place) * 12.0 * radius / libm::sqrt(2.0) - 1.0).abs() < 1.0 / radius);
    }
}

// ---- Volumes ----

#[test]
fn volumes_against_references() {
    fn test<F: Real>() -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        let table = rows::<5>("pixel_clip.csv");
        assert!(table.len() > 100);
        for row in table {
            let [d, sigma, radius] = [0, 1, 2].map(|i| F::from_f64(row[i].parse().unwrap()));
            let [whole, cut] = [3, 4].map(|i| Reference::parse(&row[i]).unwrap());
            let got = clip_volume(d, sigma).to_f64();
            let (absolute, relative) = (distance(&whole, got), relative(&whole, got));
            let z = (d / sigma).to_f64();
            assert!(absolute <= 2.0 * unit::<F>(), "{row:?}: {got}");
            // Beyond 12 σ single precision has only subnormals left, beyond 37 σ double precision.
            if z < 12.0 {
                assert!(relative <= (4.0 + 3.0 * z * z) * unit::<F>(), "{row:?}: {got}, {relative:e}");
            }
            let got = clip_volume_cut(d, sigma, radius).to_f64();
            let error = distance(&cut, got) / unit::<F>();
            assert!(error <= 8.0, "{row:?}: {got}, {error} u");
            worst = [worst[0].max(absolute / unit::<F>()), worst[1].max(error)];
        }
        worst
    }
    println!("in u, whole and cut: {:?}, {:?}", test::<f32>(), test::<f64>());
}

#[test]
fn volumes_fall_from_one_to_zero_and_mirror() {
    let mut draw = Draw(54);
    for _ in 0..2000 {
        let (sigma, radius) = (libm::exp(draw.real(-4.0, 4.0)), libm::exp(draw.real(-3.0, 3.0)));
        let (d, step) = (draw.real(0.0, 1.1) * radius, draw.real(0.0, 0.1) * radius);
        let cut = |d| clip_volume_cut(d, sigma, radius);
        assert!((cut(d) + cut(-d) - 1.0).abs() <= 4.0 * unit::<f64>());
        assert!((clip_volume(d, sigma) + clip_volume(-d, sigma) - 1.0).abs() <= 4.0 * unit::<f64>());
        assert!(cut(d + step) <= cut(d) + 16.0 * unit::<f64>() && (0.0..=0.5).contains(&cut(d)));
        // Cutting moves volume inwards, between the flat disc's and the whole Gaussian's.
        let alpha = libm::acos((d / radius).min(1.0));
        let disc = (alpha - libm::sin(alpha) * libm::cos(alpha)) / PI;
        let room = 16.0 * unit::<f64>();
        assert!(cut(d) <= clip_volume(d, sigma) + room && cut(d) <= disc + room, "{d}, {sigma}, {radius}");
        // The two expressions meet at d = r/√2.
        let middle = radius * std::f64::consts::FRAC_1_SQRT_2;
        let (below, above) = (middle * (1.0 - 1e-9), middle * (1.0 + 1e-9));
        assert!((cut(below) - cut(above)).abs() < 1e-8);
    }
}

/// From the middle outwards the volume falls by the pixel's density along the line.
#[test]
fn the_derivative_is_the_density_on_the_line() {
    for (sigma, radius) in [(SIGMA, RADIUS), (0.3, 0.5), (5.0, 0.5), (0.05, 0.5)] {
        let within = -libm::expm1(-radius * radius / (2.0 * sigma * sigma));
        for k in 1..40 {
            let (d, h) = (radius * f64::from(k) / 41.0, radius * 1e-5);
            let slope =
                (clip_volume_cut(d + h, sigma, radius) - clip_volume_cut(d - h, sigma, radius)) / (2.0 * h);
            let half = libm::sqrt(radius * radius - d * d);
            let normal = libm::exp(-d * d / (2.0 * sigma * sigma)) / (sigma * libm::sqrt(2.0 * PI));
            let line = normal * libm::erf(half / (sigma * libm::sqrt(2.0))) / within;
            // The difference's own error: h²/6 of the third derivative, and rounding over h.
            assert!((slope + line).abs() < 2e-7 * (1.0 / sigma).max(1.0), "{d}, {sigma}: {slope} {line}");
        }
    }
}

#[test]
fn volumes_of_bad_arguments() {
    for sigma in [0.0, -1.0, NAN] {
        assert!(clip_volume(0.1, sigma).is_nan() && clip_volume_cut(0.1, sigma, 0.5).is_nan());
    }
    for radius in [0.0, -0.5, NAN] {
        assert!(clip_volume_cut(0.1, SIGMA, radius).is_nan());
    }
    assert!(clip_volume(NAN, SIGMA).is_nan() && clip_volume_cut(NAN, SIGMA, RADIUS).is_nan());
    assert!(clip_volume(0.1, INF).is_nan());
    assert_eq!((clip_volume(INF, SIGMA), clip_volume(-INF, SIGMA)), (0.0, 1.0));
    assert_eq!((clip_volume_cut(INF, SIGMA, RADIUS), clip_volume_cut(-INF, SIGMA, RADIUS)), (0.0, 1.0));
    assert_eq!((clip_volume_cut(0.5, SIGMA, 0.5), clip_volume_cut(-0.5, SIGMA, 0.5)), (0.0, 1.0));
    assert_eq!(clip_volume_cut(0.2, SIGMA, INF), clip_volume(0.2, SIGMA));
    assert_eq!(clip_volume_cut(0.0, SIGMA, RADIUS), 0.5);
    // A flat disc: a quarter turn of the rim is beyond the line at r/√2. At 1e155 to 1e162, and 1e19 to 1e23 in
    // single precision, the square of r/σ is subnormal.
    let disc = (PI / 4.0 - 0.5) / PI;
    for sigma in [1e9, 1e150, 1e155, 1e160, 1e161, 2e161, 1e162, 1e200, INF] {
        assert!(
            (clip_volume_cut(libm::sqrt(0.5), sigma, 1.0) - disc).abs() <= 8.0 * unit::<f64>(),
            "{sigma}"
        );
    }
    for sigma in [1e3, 1e4, 1e10, 1e19, 1e20, 1e21, 5e21, 1e22, 1e23] {
        let got = f64::from(clip_volume_cut(libm::sqrtf(0.5), sigma, 1.0));
        assert!((got - disc).abs() <= 8.0 * unit::<f32>(), "{sigma}");
    }
    // The ends of the range: radii whose sums overflow, σ whose reciprocal does.
    assert!((clip_volume_cut(1.2e308, INF, 1.6e308) - clip_volume_cut(0.75, INF, 1.0)).abs() < 1e-15);
    assert_eq!((clip_volume_cut(0.0, 1e-310, 0.5), clip_volume_cut(0.1, 1e-310, 0.5)), (0.5, 0.0));
    // The printed parabola, in decimals worked by hand: 0.5 - 0.25 (2.151 - 0.5895) = 0.109625.
    assert!((clip_volume_paper(0.25_f64) - 0.109_625).abs() < 1e-16);
    assert!((clip_volume_paper(-0.1_f64) - 0.738_68).abs() < 1e-15);
    assert!(clip_volume_paper(NAN).is_nan());
    assert_eq!((clip_volume_paper(INF), clip_volume_paper(-INF)), (INF, INF));
}
