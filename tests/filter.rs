//! The texture filters: laws, references, naive twins, bad input.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::filter::{
    AxesKind, EllipseFilter, FilterError, Level, Lookup, Method, Pyramid, Reduction, Rim, Sampler, Texture,
    Wrap,
};
use bellfit::kernel::pixel::{
    Axes, Footprint, Jacobian, Padding, PaperReading, PixelWeight, Tangent, TiltFormula, coverage, half_plane,
};
use bellfit::slice::Unit;
use draw::Draw;
use std::f64::consts::PI;

/// Relative rounding of a weighted mean of `f32` texels: each of its two sums rounds a product, 64 additions
/// in a lane, 4 over the lanes and once at the end.
const ROUNDING: f64 = 2.0 * 70.0 / (1u64 << 24) as f64;

fn random(draw: &mut Draw, width: usize, height: usize, channels: usize) -> Texture {
    let values: Vec<f32> = (0..width * height * channels).map(|_| draw.real(0.0, 1.0) as f32).collect();
    Texture::new(width, height, channels, &values).unwrap()
}

fn pyramid(texture: Texture) -> Pyramid {
    Pyramid::new(texture, Reduction::Box, Wrap::Repeat)
}

fn weights() -> Vec<PixelWeight<f32>> {
    let sigma = 1.0 / 3.0;
    let mut all = vec![PixelWeight::Box, PixelWeight::Gaussian(sigma), PixelWeight::Gaussian(0.7)];
    all.extend(PaperReading::ALL.map(PixelWeight::Paper));
    all.extend(PaperReading::ALL.map(PixelWeight::PaperProduct));
    all.extend([2, 4, 8, 16, 32, 64].map(|k| PixelWeight::Bell(k, sigma)));
    all.extend([2, 4, 8].map(|k| PixelWeight::Cubic(k, sigma)));
    all
}

fn double(weight: PixelWeight<f32>) -> PixelWeight<f64> {
    match weight {
        PixelWeight::Gaussian(sigma) => PixelWeight::Gaussian(sigma.into()),
        PixelWeight::Paper(reading) => PixelWeight::Paper(reading),
        PixelWeight::PaperProduct(reading) => PixelWeight::PaperProduct(reading),
        PixelWeight::Box => PixelWeight::Box,
        PixelWeight::Bell(k, sigma) => PixelWeight::Bell(k, sigma.into()),
        PixelWeight::Cubic(k, sigma) => PixelWeight::Cubic(k, sigma.into()),
    }
}

fn ellipse(weight: PixelWeight<f32>) -> EllipseFilter {
    EllipseFilter { weight, padding: Padding::Plain, ..EllipseFilter::default() }
}

/// A lookup in level 0 of a pyramid.
fn at(pyramid: &Pyramid, wrap: Wrap, filter: EllipseFilter, s: f32, t: f32, j: Jacobian<f32>) -> Lookup {
    let sampler = Sampler::new(pyramid, wrap, Method::Ellipse(filter)).unwrap();
    sampler.lookup_at(s, t, j, Level::Fixed(0))
}

fn jacobian(draw: &mut Draw, size: f64) -> Jacobian<f32> {
    let mut real = || draw.real(-size, size) as f32;
    Jacobian { ux: real(), vx: real(), uy: real(), vy: real() }
}

/// Axes of given lengths at an angle.
fn along(major: f64, minor: f64, angle: f64) -> Jacobian<f32> {
    let (sin, cos) = libm::sincos(angle);
    Jacobian {
        ux: (major * cos) as f32,
        vx: (major * sin) as f32,
        uy: (-minor * sin) as f32,
        vy: (minor * cos) as f32,
    }
}

/// The place of x in 0..n, walked one texel at a time.
fn walked(wrap: Wrap, x: i64, n: usize) -> usize {
    let (mut place, mut step) = (0_i64, x.signum());
    for _ in 0..x.abs() {
        let next = place + step;
        if (0..n as i64).contains(&next) {
            place = next;
            continue;
        }
        match wrap {
            Wrap::Repeat => place = if step > 0 { 0 } else { n as i64 - 1 },
            Wrap::Clamp => {}
            Wrap::Mirror => step = -step, // the edge texel comes twice
        }
    }
    place as usize
}

/// What a naive scan of a window finds: the weighted mean, and the texels with Q ≤ 1 - 1e-4 and ≤ 1 + 1e-4.
struct Naive {
    value: [f64; 4],
    surely: u64,
    perhaps: u64,
    /// Weight of the texels between, by the whole weight.
    doubtful: f64,
}

/// The mean over Q ≤ 1 by the conic's formula in double precision, over every texel of a window wider than
/// the ellipse, wrapped by walking. `m` = [M_uu, M_uv, M_vv]; a² and b² of the weight along `tilt`.
fn naive(
    texture: &Texture,
    wrap: Wrap,
    weight: PixelWeight<f32>,
    [s, t]: [f64; 2],
    [uu, uv, vv]: [f64; 3],
    tilt: f64,
) -> Naive {
    let det = uu * vv - uv * uv;
    let (sin, cos) = libm::sincos(tilt);
    let first = uu * cos * cos + 2.0 * uv * cos * sin + vv * sin * sin;
    let (mut sum, mut values, mut surely, mut perhaps, mut doubtful) = (0.0, [0.0; 4], 0, 0, 0.0);
    let reach = 3 + (uu.max(vv)).sqrt() as i64;
    for y in t.floor() as i64 - reach..=t.floor() as i64 + reach {
        for x in s.floor() as i64 - reach..=s.floor() as i64 + reach {
            let (u, v) = (x as f64 + 0.5 - s, y as f64 + 0.5 - t);
            let q = (vv * u * u - 2.0 * uv * u * v + uu * v * v) / det;
            surely += u64::from(q <= 1.0 - 1e-4);
            perhaps += u64::from(q <= 1.0 + 1e-4);
            let along = (u * cos + v * sin) * (u * cos + v * sin) / first;
            let w = double(weight).at(along.min(q), (q - along).max(0.0));
            if q > 1.0 - 1e-4 && q <= 1.0 + 1e-4 {
                doubtful += w;
            }
            if q <= 1.0 {
                let texel =
                    texture.texel(walked(wrap, x, texture.width()), walked(wrap, y, texture.height()));
                sum += w;
                for (value, texel) in values.iter_mut().zip(texel) {
                    *value += w * f64::from(texel);
                }
            }
        }
    }
    Naive { value: values.map(|value| value / sum), surely, perhaps, doubtful: doubtful / sum }
}

/// J Jᵀ, or J Jᵀ + I, in double precision.
fn matrix(j: Jacobian<f32>, padding: Padding) -> [f64; 3] {
    let [ux, vx, uy, vy] = [j.ux, j.vx, j.uy, j.vy].map(f64::from);
    let add = f64::from(u8::from(padding == Padding::Padded));
    [ux * ux + uy * uy + add, ux * vx + uy * vy, vx * vx + vy * vy + add]
}

fn tilt([uu, uv, vv]: [f64; 3]) -> f64 {
    0.5 * libm::atan2(2.0 * uv, uu - vv)
}

#[test]
fn every_integer_wraps_as_a_walk_does() {
    for wrap in Wrap::ALL {
        assert_eq!(Wrap::from_id(wrap.id()), Some(wrap));
        for n in [1, 2, 3, 5, 8] {
            for x in -40..40 {
                assert_eq!(wrap.index(x, n), walked(wrap, x, n), "{wrap:?} {x} of {n}");
            }
        }
        // 2⁶² = 4 mod 6 and mod 3: 1
        let far = 1_i64 << 62;
        assert_eq!(Wrap::Repeat.index(far, 3), 1);
        assert_eq!(Wrap::Mirror.index(far, 3), 1); // 2·3 - 1 - 4
        assert_eq!(Wrap::Clamp.index(-far, 3), 0);
    }
}

#[test]
fn a_constant_stays() {
    let mut draw = Draw(1);
    let value = [0.7_f32, -3.0, 1e-3, 1e6];
    for (width, height) in [(16, 16), (5, 3), (1, 7), (1, 1)] {
        for reduction in Reduction::ALL {
            for wrap in Wrap::ALL {
                let values: Vec<f32> = (0..width * height).flat_map(|_| value).collect();
                let texture = Texture::new(width, height, 4, &values).unwrap();
                let pyramid = Pyramid::new(texture, reduction, wrap);
                let mut methods = vec![Method::Nearest, Method::Bilinear, Method::Trilinear];
                for weight in weights() {
                    methods.push(Method::Ellipse(ellipse(weight)));
                }
                for rim in Rim::ALL {
                    methods.push(Method::Ellipse(EllipseFilter { rim, ..EllipseFilter::default() }));
                }
                for method in methods {
                    let sampler = Sampler::new(&pyramid, wrap, method).unwrap();
                    let (s, t) = (draw.real(-20.0, 20.0) as f32, draw.real(-20.0, 20.0) as f32);
                    let found = sampler.lookup(s, t, jacobian(&mut draw, 6.0)).value;
                    for (found, value) in found.into_iter().zip(value) {
                        let error = f64::from(found / value) - 1.0;
                        assert!(error.abs() < ROUNDING, "{method:?} {wrap:?} {width} × {height}: {found}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_box_keeps_the_mean_and_levels_halve() {
    let mut draw = Draw(2);
    for (width, height) in [(1, 1), (1, 7), (5, 3), (6, 10), (13, 1), (16, 8), (31, 33)] {
        let texture = random(&mut draw, width, height, 2);
        let pyramid = pyramid(texture);
        let mean = |level: &Texture, c: usize| {
            let plane: Vec<f32> = level.channel(c).collect();
            plane.iter().map(|&x| f64::from(x)).sum::<f64>() / plane.len() as f64
        };
        let (mut w, mut h) = (width, height);
        for i in 0..pyramid.levels() {
            let level = pyramid.level(i);
            assert_eq!((level.width(), level.height()), (w, h));
            (w, h) = ((w / 2).max(1), (h / 2).max(1));
            for c in 0..2 {
                // Each texel is rounded once, to 2⁻²⁴ of at most 1.
                assert!((mean(level, c) - mean(pyramid.level(0), c)).abs() < 1.0 / (1 << 24) as f64);
            }
        }
        let last = pyramid.level(pyramid.levels() - 1);
        assert_eq!((last.width(), last.height()), (1, 1));
    }
}

/// What a wave of `frequency` cycles a coarse texel becomes in level 1: the amplitude of the same wave there.
fn reduced_gain(reduction: Reduction, frequency: f64) -> f64 {
    let width = 4096;
    let omega = 2.0 * PI * frequency / 2.0;
    let values: Vec<f32> = (0..width).map(|x| libm::cos(omega * (x as f64 + 0.5 - 2048.0)) as f32).collect();
    let pyramid = Pyramid::new(Texture::new(width, 1, 1, &values).unwrap(), reduction, Wrap::Clamp);
    let (mut product, mut square) = (0.0, 0.0);
    // Far from the edges, where nothing is clamped.
    for x in 24..2024 {
        let wave = libm::cos(2.0 * omega * (x as f64 + 0.5 - 1024.0));
        product += wave * f64::from(pyramid.level(1).texels()[x]);
        square += wave * wave;
    }
    product / square
}

#[test]
fn the_better_reduction_passes_what_it_says() {
    for i in 0..=30 {
        let frequency = 0.01 * f64::from(i);
        let gain = reduced_gain(Reduction::Kaiser, frequency);
        assert!((gain - 1.0).abs() < 0.03, "{frequency}: {gain}");
    }
    // A half at Nyquist (sampled off it, where the wave of level 1 is not its own alias).
    assert!((reduced_gain(Reduction::Kaiser, 0.499) - 0.5).abs() < 0.05);
    for i in 0..20 {
        let frequency = 0.7 + 0.0131 * f64::from(i);
        let gain = reduced_gain(Reduction::Kaiser, frequency);
        assert!(gain.abs() < 0.03, "{frequency}: {gain}");
    }
    // The box of two texels: cos(π f/2), f in cycles a coarse texel.
    for frequency in [0.1, 0.3, 0.7] {
        let gain = reduced_gain(Reduction::Box, frequency);
        assert!((gain - libm::cos(PI * frequency / 2.0)).abs() < 1e-6, "{frequency}: {gain}");
    }
}

#[test]
fn nearest_and_bilinear_are_exact_where_they_must_be() {
    let mut draw = Draw(3);
    let texture = random(&mut draw, 7, 5, 3);
    let pixel = Jacobian { ux: 1.0, vx: 0.0, uy: 0.0, vy: 1.0 };
    let pyramid = pyramid(texture.clone());
    for wrap in Wrap::ALL {
        for method in [Method::Nearest, Method::Bilinear, Method::Trilinear] {
            let sampler = Sampler::new(&pyramid, wrap, method).unwrap();
            for y in -12..12 {
                for x in -12..12 {
                    let texel = texture.texel(walked(wrap, x, 7), walked(wrap, y, 5));
                    assert_eq!(sampler.lookup(x as f32 + 0.5, y as f32 + 0.5, pixel).value, texel);
                }
            }
        }
    }
    // A ramp u + 2v, inside: values and fractions are exact in f32.
    let ramp: Vec<f32> = (0..64).map(|i| (i % 8) as f32 + 0.5 + 2.0 * ((i / 8) as f32 + 0.5)).collect();
    let pyramid = self::pyramid(Texture::new(8, 8, 1, &ramp).unwrap());
    let sampler = Sampler::new(&pyramid, Wrap::Clamp, Method::Bilinear).unwrap();
    for i in 0..200 {
        let (s, t) = (0.5 + 7.0 * (i as f32 / 256.0), 7.5 - 7.0 * (i as f32 / 256.0));
        assert_eq!(sampler.lookup(s, t, pixel).value[0], s + 2.0 * t);
    }
}

#[test]
fn trilinear_blends_by_the_longer_vector() {
    let mut draw = Draw(4);
    let pyramid = pyramid(random(&mut draw, 64, 32, 1));
    let trilinear = Sampler::new(&pyramid, Wrap::Repeat, Method::Trilinear).unwrap();
    let bilinear = Sampler::new(&pyramid, Wrap::Repeat, Method::Bilinear).unwrap();
    for _ in 0..200 {
        let j = jacobian(&mut draw, 30.0);
        let (s, t) = (draw.real(0.0, 64.0) as f32, draw.real(0.0, 32.0) as f32);
        let length = |u: f32, v: f32| f64::from(u).hypot(f64::from(v));
        let longer = length(j.ux, j.vx).max(length(j.uy, j.vy));
        let level = libm::log2(longer).clamp(0.0, (pyramid.levels() - 1) as f64);
        let at = |i: usize| f64::from(bilinear.lookup_at(s, t, j, Level::Fixed(i)).value[0]);
        let (fine, coarse) = (at(level as usize), at((level as usize + 1).min(pyramid.levels() - 1)));
        let expected = fine + (level - level.floor()) * (coarse - fine);
        let found = trilinear.lookup(s, t, j);
        // The level is a float of at most 6: 2⁻²² of it, and three roundings.
        assert!((f64::from(found.value[0]) - expected).abs() < 1e-6, "{found:?} {expected}");
        assert!((f64::from(found.level) - level).abs() < 1e-6);
    }
}

#[test]
fn the_ellipse_is_the_naive_scan() {
    let mut draw = Draw(5);
    for round in 0..60 {
        let (w, h) = (1 + draw.below(40), 1 + draw.below(40));
        let texture = random(&mut draw, w, h, 1 + round % 4);
        let pyramid = pyramid(texture.clone());
        if pyramid.levels() == 1 {
            continue; // 1 × 1: not scanned
        }
        for weight in weights() {
            for wrap in Wrap::ALL {
                let padding = if draw.below(2) == 0 { Padding::Plain } else { Padding::Padded };
                let size = [0.8, 4.0, 12.0][draw.below(3)];
                let j = jacobian(&mut draw, size);
                let (s, t) = (draw.real(-30.0, 60.0) as f32, draw.real(-30.0, 60.0) as f32);
                let m = matrix(j, padding);
                let twin = naive(&texture, wrap, weight, [s.into(), t.into()], m, tilt(m));
                let found = at(&pyramid, wrap, EllipseFilter { padding, ..ellipse(weight) }, s, t, j);
                if found.fallback {
                    assert!(
                        twin.surely == 0 || twin.value[0].is_nan() || weight_vanishes(weight),
                        "{found:?}"
                    );
                    continue;
                }
                assert!(
                    twin.surely <= found.texels && found.texels <= twin.perhaps,
                    "{weight:?} {j:?} at {s}, {t}: {} of {}..{}",
                    found.texels,
                    twin.surely,
                    twin.perhaps
                );
                if twin.surely == 0 || weight_vanishes(weight) && twin.surely < 4 {
                    continue; // every texel is on the rim: its weight is rounding
                }
                // Weights are wrong by Q's rounding, 1e-5 of a long ellipse's, times the steepest slope of
                // a bell of Q, 32 at most (Bell(64) of σ = 1/3: 4.5); the rim's texels are in or out.
                let bound = 2e-4 + 2.0 * twin.doubtful;
                for (found, expected) in found.value.into_iter().zip(twin.value) {
                    let error = (f64::from(found) - expected).abs();
                    assert!(error < bound, "{weight:?} {wrap:?} {j:?} at {s}, {t}: {found} not {expected}");
                }
            }
        }
    }
}

/// Long ellipses whose bounding box ends within a texel of the texture's edges: the fast path reads whole tiles
/// and must not reach over them, nor lose a row.
#[test]
fn ellipses_up_to_the_edge_are_the_naive_scan() {
    let mut draw = Draw(91);
    let texture = random(&mut draw, 97, 83, 1);
    let levels = pyramid(texture.clone());
    let weight = PixelWeight::Bell(8, 1.0 / 3.0);
    for i in 0..600 {
        let minor = draw.real(1.0, 9.0);
        let j = along(minor * draw.real(1.0, 5.0), minor, draw.real(-1.6, 1.6));
        let m = matrix(j, Padding::Plain);
        let (width, height) = (m[0].sqrt(), m[2].sqrt());
        let near = draw.real(-0.7, 1.2);
        let (s, t) = match i % 4 {
            0 => (width + near, 41.0),
            1 => (97.0 - width - near, 41.0),
            2 => (48.0, height + near),
            _ => (48.0, 83.0 - height - near),
        };
        let (s, t) = (s as f32, t as f32);
        let found = at(&levels, Wrap::Clamp, ellipse(weight), s, t, j);
        let expected = naive(&texture, Wrap::Clamp, weight, [s.into(), t.into()], m, tilt(m));
        assert!((expected.surely..=expected.perhaps).contains(&found.texels), "{i}: {found:?}");
        // Doubtful texels have next to no weight; else as in the scan above.
        let error = (f64::from(found.value[0]) - expected.value[0]).abs();
        assert!(error < 2e-4 + 2.0 * expected.doubtful, "{i}: {error}");
    }
}

/// Whether the weight is 0 on the rim, so that a texel there may have none at all.
fn weight_vanishes(weight: PixelWeight<f32>) -> bool {
    matches!(weight, PixelWeight::Paper(PaperReading::R1) | PixelWeight::PaperProduct(_))
        || matches!(weight, PixelWeight::Bell(2 | 4, _))
}

#[test]
fn lattice_points_in_circles_are_counted_by_the_closed_rule() {
    let texture = Texture::new(64, 64, 1, &[1.0; 64 * 64]).unwrap();
    let pyramid = pyramid(texture);
    // Gauss's circle problem, N(r); powers of two, for which Q is exact: texels on the rim count.
    for (radius, count) in [(1.0, 5), (2.0, 13), (4.0, 49), (8.0, 197), (16.0, 797)] {
        let j = Jacobian { ux: radius, vx: 0.0, uy: 0.0, vy: radius };
        for wrap in Wrap::ALL {
            for s in [32.5, 0.5, -100.5] {
                assert_eq!(at(&pyramid, wrap, ellipse(PixelWeight::Box), s, 20.5, j).texels, count);
            }
        }
    }
}

#[test]
fn mirrored_is_the_same_to_the_texel() {
    let mut draw = Draw(6);
    let n = 48;
    let texture = random(&mut draw, n, n, 1);
    let mirrored: Vec<f32> = (0..n * n).map(|i| texture.texels()[(i / n) * n + (n - 1 - i % n)]).collect();
    let transposed: Vec<f32> = (0..n * n).map(|i| texture.texels()[(i % n) * n + i / n]).collect();
    let pyramids = [texture.texels().to_vec(), mirrored, transposed]
        .map(|values| pyramid(Texture::new(n, n, 1, &values).unwrap()));
    for i in 0..400 {
        // Every other time a circle with Pythagorean triples on its rim, around a texel's centre.
        let (j, s, t) = if i % 2 == 0 {
            let radius = [5.0, 10.0, 13.0][i / 2 % 3];
            let j = Jacobian { ux: radius, vx: 0.0, uy: 0.0, vy: radius };
            (j, draw.below(n) as f32 + 0.5, draw.below(n) as f32 + 0.5)
        } else {
            let place = |k: usize| k as f32 / 16.0;
            (jacobian(&mut draw, 9.0), place(draw.below(16 * n)), place(draw.below(16 * n)))
        };
        for weight in [PixelWeight::Box, PixelWeight::Cubic(4, 1.0 / 3.0), PixelWeight::Gaussian(0.5)] {
            let filter = ellipse(weight);
            let plain = at(&pyramids[0], Wrap::Repeat, filter, s, t, j);
            let turned = Jacobian { ux: -j.ux, uy: -j.uy, ..j };
            let other = at(&pyramids[1], Wrap::Repeat, filter, n as f32 - s, t, turned);
            // The same texels with the same weights, added up in another order.
            assert_eq!(plain.texels, other.texels, "{j:?} at {s}, {t}");
            assert!(f64::from((plain.value[0] - other.value[0]).abs()) < ROUNDING);
            // Transposed, rows become columns: Q is rounded differently, and the rim may differ with it.
            let turned = Jacobian { ux: j.vx, vx: j.ux, uy: j.vy, vy: j.uy };
            let other = at(&pyramids[2], Wrap::Repeat, filter, t, s, turned);
            if i % 2 == 1 && plain.texels == other.texels {
                assert!(f64::from((plain.value[0] - other.value[0]).abs()) < 1e-4, "{j:?} at {s}, {t}");
            }
        }
    }
}

#[test]
fn only_the_ellipse_counts_not_the_screen_axes() {
    let mut draw = Draw(7);
    let pyramid = pyramid(random(&mut draw, 64, 64, 2));
    for weight in weights() {
        let filter = EllipseFilter { padding: Padding::Padded, ..ellipse(weight) };
        let sampler = Sampler::new(&pyramid, Wrap::Mirror, Method::Ellipse(filter)).unwrap();
        for _ in 0..20 {
            let j = jacobian(&mut draw, 9.0);
            let (s, t) = (draw.real(0.0, 64.0) as f32, draw.real(0.0, 64.0) as f32);
            let plain = sampler.lookup(s, t, j);
            let swapped = Jacobian { ux: j.uy, vx: j.vy, uy: j.ux, vy: j.vx };
            let mirrored = Jacobian { ux: -j.ux, vx: -j.vx, ..j };
            // Sums of the same two squares: to the bit.
            assert_eq!(plain, sampler.lookup(s, t, swapped));
            assert_eq!(plain, sampler.lookup(s, t, mirrored));
            let (sin, cos) = libm::sincos(draw.real(0.0, 2.0 * PI));
            let (ux, vx, uy, vy) = (f64::from(j.ux), f64::from(j.vx), f64::from(j.uy), f64::from(j.vy));
            let rotated = Jacobian {
                ux: (ux * cos + uy * sin) as f32,
                vx: (vx * cos + vy * sin) as f32,
                uy: (uy * cos - ux * sin) as f32,
                vy: (vy * cos - vx * sin) as f32,
            };
            let other = sampler.lookup(s, t, rotated);
            // J rounded anew, 1e-7 of it; a texel of the rim may come or go, weighing up to 1/N.
            if plain.texels == other.texels {
                assert!((plain.value[0] - other.value[0]).abs() < 1e-4, "{weight:?} {plain:?} {other:?}");
            } else {
                assert!(plain.texels.abs_diff(other.texels) <= 2);
            }
        }
    }
}

#[test]
fn linear_in_the_texture_and_the_weights_sum_to_one() {
    let mut draw = Draw(8);
    let (w, h) = (11, 9);
    let (a, b) = (random(&mut draw, w, h, 1), random(&mut draw, w, h, 1));
    let sum: Vec<f32> = a.texels().iter().zip(b.texels()).map(|(a, b)| 0.5 * a - 2.0 * b).collect();
    let pyramids = [a.texels().to_vec(), b.texels().to_vec(), sum]
        .map(|values| pyramid(Texture::new(w, h, 1, &values).unwrap()));
    for wrap in Wrap::ALL {
        for weight in weights() {
            let j = jacobian(&mut draw, 4.0);
            let (s, t) = (draw.real(-5.0, 15.0) as f32, draw.real(-5.0, 15.0) as f32);
            let filter = EllipseFilter { padding: Padding::Padded, ..ellipse(weight) };
            let [a, b, sum] =
                pyramids.each_ref().map(|pyramid| f64::from(at(pyramid, wrap, filter, s, t, j).value[0]));
            assert!((sum - (0.5 * a - 2.0 * b)).abs() < 2.5 * 2.0 * ROUNDING);
            // Of every texel alone: its weight.
            let mut total = 0.0;
            for i in 0..w * h {
                let mut values = vec![0.0; w * h];
                values[i] = 1.0;
                let alone = pyramid(Texture::new(w, h, 1, &values).unwrap());
                let share = at(&alone, wrap, filter, s, t, j).value[0];
                assert!(share >= 0.0);
                total += f64::from(share);
            }
            assert!((total - 1.0).abs() < ROUNDING, "{weight:?} {wrap:?}: {total}");
        }
    }
}

#[test]
fn every_vector_unit_gives_the_same_bits() {
    let mut draw = Draw(9);
    assert_eq!(Unit::available().next(), Some(Unit::plain()));
    for channels in 1..=4 {
        let pyramid = pyramid(random(&mut draw, 150, 70, channels));
        for weight in weights() {
            let method = Method::Ellipse(EllipseFilter { padding: Padding::Padded, ..ellipse(weight) });
            for _ in 0..40 {
                let size = [0.5, 3.0, 30.0][draw.below(3)];
                let j = jacobian(&mut draw, size);
                let (s, t) = (draw.real(-20.0, 170.0) as f32, draw.real(-20.0, 90.0) as f32);
                let bits = |unit: Unit| {
                    let found =
                        Sampler::new(&pyramid, Wrap::Mirror, method).unwrap().on(unit).lookup(s, t, j);
                    (found.value.map(f32::to_bits), found.texels, found.level.to_bits(), found.fallback)
                };
                let plain = bits(Unit::plain());
                for unit in Unit::available() {
                    assert_eq!(bits(unit), plain, "{} {weight:?} {j:?} at {s}, {t}", unit.id());
                }
            }
        }
    }
}

#[test]
fn the_level_covers_the_minor_axis() {
    let mut draw = Draw(10);
    let pyramid = pyramid(random(&mut draw, 256, 256, 1));
    for cover in [1.0, 2.0, 3.5] {
        for anisotropy in [1.0, 4.0, f32::INFINITY] {
            let filter = EllipseFilter { cover, anisotropy, ..EllipseFilter::default() };
            let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(filter)).unwrap();
            for _ in 0..50 {
                let j = jacobian(&mut draw, 25.0);
                let (s, t) = (draw.real(0.0, 256.0) as f32, draw.real(0.0, 256.0) as f32);
                let [ux, vx, uy, vy] = [j.ux, j.vx, j.uy, j.vy].map(f64::from);
                let axes = Axes::of(Jacobian { ux, vx, uy, vy }, Padding::Plain).limited(anisotropy.into());
                let level = libm::log2(axes.minor / f64::from(cover)).clamp(0.0, 8.0);
                let found = sampler.lookup(s, t, j);
                assert!((f64::from(found.level) - level).abs() < 1e-5, "{found:?} {level}");
                let at = |i: usize| f64::from(sampler.lookup_at(s, t, j, Level::Fixed(i)).value[0]);
                let (fine, coarse) = (at(level as usize), at((level as usize + 1).min(8)));
                let expected = fine + (level - level.floor()) * (coarse - fine);
                assert!((f64::from(found.value[0]) - expected).abs() < 2e-5, "{found:?} {expected}");
            }
        }
    }
}

#[test]
fn limited_and_paper_axes_are_those_of_the_kernel() {
    let mut draw = Draw(11);
    let texture = random(&mut draw, 37, 41, 1);
    let pyramid = pyramid(texture.clone());
    for axes in AxesKind::ALL {
        assert_eq!(AxesKind::from_id(axes.id()), Some(axes));
        for anisotropy in [1.5_f32, f32::INFINITY] {
            for weight in [PixelWeight::Gaussian(0.4), PixelWeight::PaperProduct(PaperReading::R3)] {
                for _ in 0..40 {
                    let j = jacobian(&mut draw, 9.0);
                    let [ux, vx, uy, vy] = [j.ux, j.vx, j.uy, j.vy].map(f64::from);
                    let exact = Jacobian { ux, vx, uy, vy };
                    let mut kernel = match axes {
                        AxesKind::True => Axes::of(exact, Padding::Plain),
                        AxesKind::Paper(formula) => Axes::paper(exact, formula),
                    };
                    let (longer, limit) = (kernel.major.max(kernel.minor), f64::from(anisotropy));
                    kernel.major = kernel.major.max(longer / limit);
                    kernel.minor = kernel.minor.max(longer / limit);
                    let m = Footprint::along(&kernel.frame());
                    let (s, t) = (draw.real(0.0, 37.0) as f32, draw.real(0.0, 41.0) as f32);
                    let filter = EllipseFilter { axes, anisotropy, ..ellipse(weight) };
                    let found = at(&pyramid, Wrap::Repeat, filter, s, t, j);
                    let place = [s.into(), t.into()];
                    let twin = naive(&texture, Wrap::Repeat, weight, place, [m.uu, m.uv, m.vv], kernel.tilt);
                    if found.fallback || twin.surely == 0 {
                        continue;
                    }
                    let error = (f64::from(found.value[0]) - twin.value[0]).abs();
                    assert!(error < 2e-4 + 2.0 * twin.doubtful, "{axes:?} {weight:?} {j:?}: {error}");
                }
            }
        }
    }
    // Perpendicular vectors: the paper's ellipse is the true one.
    let j = along(7.0, 3.0, 0.6);
    let value = |axes| {
        at(
            &pyramid,
            Wrap::Repeat,
            EllipseFilter { axes, ..ellipse(PixelWeight::Gaussian(0.3)) },
            20.3,
            18.9,
            j,
        )
    };
    assert!(
        (value(AxesKind::True).value[0] - value(AxesKind::Paper(TiltFormula::Vector)).value[0]).abs() < 1e-5
    );
}

#[test]
fn a_rim_by_area_weighs_the_exact_area() {
    // The shares of all texels sum to the ellipse's area π a b, so a texel wholly inside has 1 of it.
    let n = 32;
    let mut values = vec![0.0; n * n];
    values[16 * n + 16] = 1.0;
    let pyramid = pyramid(Texture::new(n, n, 1, &values).unwrap());
    for (major, minor, angle) in [(6.0, 3.0, PI / 6.0), (4.0, 4.0, 0.0), (9.3, 1.7, 2.0)] {
        let filter = EllipseFilter { rim: Rim::Area, ..ellipse(PixelWeight::Box) };
        let share = at(&pyramid, Wrap::Repeat, filter, 16.4, 16.7, along(major, minor, angle)).value[0];
        assert!((f64::from(share) * PI * major * minor - 1.0).abs() < 1e-6);
    }
    // Half a plane and P(0) = 0.5: a texel with its centre on the rim counts half of one in the middle.
    for rim in [Rim::HalfPlane, Rim::Volume] {
        assert_eq!(Rim::from_id(rim.id()), Some(rim));
        let share = |s: f32| {
            let filter = EllipseFilter { rim, ..ellipse(PixelWeight::Box) };
            at(&pyramid, Wrap::Repeat, filter, s, 16.5, along(5.0, 5.0, 0.0)).value[0]
        };
        assert!((share(11.5) / share(16.5) - 0.5).abs() < 1e-6);
        // A quarter of a texel beyond: the half plane takes ¼, P(¼) = 0.5 - ¼ (2.151 - 2.358/4) = 0.109625.
        // Off the lattice all shares' sum changes as well: compare with the texel that is then inside.
        let mut inner = vec![0.0; n * n];
        inner[16 * n + 12] = 1.0;
        let inner = self::pyramid(Texture::new(n, n, 1, &inner).unwrap());
        let filter = EllipseFilter { rim, ..ellipse(PixelWeight::Box) };
        let whole = at(&inner, Wrap::Repeat, filter, 11.25, 16.5, along(5.0, 5.0, 0.0)).value[0];
        let expected = if rim == Rim::HalfPlane { 0.25 } else { 0.109625 };
        assert!((share(11.25) / whole - expected).abs() < 1e-5, "{rim:?}: {}", share(11.25) / whole);
    }
}

/// Every texel in a wide square about the ellipse, weighed by the kernel's shares, which have references of their
/// own: none is left out, none counts twice, and the weight is the one at the texel's centre.
#[test]
fn every_rim_counts_all_texels_with_a_share() {
    let mut draw = Draw(61);
    let n = 48;
    let texture = random(&mut draw, n, n, 1);
    let pyramid = pyramid(texture.clone());
    for round in 0..60 {
        let (major, aspect) = (libm::exp(draw.real(-1.5, 2.5)), libm::exp(draw.real(0.0, 2.5)));
        let j = along(major, major / aspect, draw.real(0.0, 2.0 * PI));
        let (s, t) = (draw.real(0.0, n as f64) as f32, draw.real(0.0, n as f64) as f32);
        let (padding, wrap) = ([Padding::Plain, Padding::Padded][round % 2], Wrap::ALL[round % 3]);
        let double = Jacobian { ux: j.ux.into(), vx: j.vx.into(), uy: j.uy.into(), vy: j.vy.into() };
        let footprint = Footprint::of(double, padding);
        for (rim, share) in [
            (Rim::Area, coverage as fn(&Footprint<f64>, f64, f64) -> f64),
            (Rim::HalfPlane, half_plane),
            (Rim::Volume, |footprint, u, v| match Tangent::of(footprint, u, v).distance {
                d if d.abs() >= 0.5 => f64::from(u8::from(d > 0.0)),
                d if d >= 0.0 => 0.5 + d * (2.151 - 2.358 * d),
                d => 0.5 + d * (2.151 + 2.358 * d),
            }),
        ] {
            for weight in [PixelWeight::Box, PixelWeight::Gaussian(0.5)] {
                let (mut sum, mut mass, mut texels) = (0.0, 0.0, 0);
                for y in -20..n as i64 + 20 {
                    for x in -20..n as i64 + 20 {
                        let (u, v) = (x as f64 + 0.5 - f64::from(s), y as f64 + 0.5 - f64::from(t));
                        let share =
                            if coverage(&footprint, u, v) > 0.0 { share(&footprint, u, v) } else { 0.0 };
                        let w = share * self::double(weight).at(footprint.q(u, v), 0.0);
                        let (x, y) = (walked(wrap, x, n), walked(wrap, y, n));
                        sum += w * f64::from(texture.texel(x, y)[0]);
                        mass += w;
                        texels += u64::from(share > 0.0);
                    }
                }
                let filter = EllipseFilter { rim, padding, ..ellipse(weight) };
                let sampler = Sampler::new(&pyramid, wrap, Method::Ellipse(filter)).unwrap();
                let found = sampler.lookup_at(s, t, j, Level::Fixed(0));
                if mass == 0.0 {
                    assert!(found.fallback, "{rim:?} {j:?}");
                    continue;
                }
                // The position's fraction is a float; a share may change by as much, and be 0 or not.
                assert!((f64::from(found.value[0]) - sum / mass).abs() < 1e-4 * aspect, "{rim:?} {j:?}");
                assert!(found.texels.abs_diff(texels) <= 1, "{rim:?} {j:?}: {} {texels}", found.texels);
            }
        }
    }
}

#[test]
fn waves_pass_as_the_cut_weights_integral_says() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/references/filter.csv");
    let mut reader = csv::Reader::from_path(path).unwrap();
    let n = 512;
    let (major, minor, angle) = (120.0, 80.0, 0.4);
    let j = along(major, minor, angle);
    let m = matrix(j, Padding::Plain);
    let mut rows = 0;
    for row in reader.records() {
        let row = row.unwrap();
        let (kappa, gain): (f64, f64) = (row[2].parse().unwrap(), row[3].parse().unwrap());
        let weight = match &row[0] {
            "gaussian" => PixelWeight::Gaussian(row[1].parse::<f32>().unwrap()),
            "box" => PixelWeight::Box,
            "paper-r1" => PixelWeight::Paper(PaperReading::R1),
            "paper-r2" => PixelWeight::Paper(PaperReading::R2),
            "paper-r3" => PixelWeight::Paper(PaperReading::R3),
            "paper-r4" => PixelWeight::Paper(PaperReading::R4),
            other => panic!("{other}"),
        };
        for direction in [0.0, 1.0] {
            // k with kᵀ M k = κ², radians a texel.
            let (sin, cos) = libm::sincos(direction);
            let length = kappa / (m[0] * cos * cos + 2.0 * m[1] * cos * sin + m[2] * sin * sin).sqrt();
            let (s, t) = (256.3_f64, 255.8_f64);
            let wave = |i: usize| {
                let (u, v) = ((i % n) as f64 + 0.5 - s, (i / n) as f64 + 0.5 - t);
                libm::cos(length * (cos * u + sin * v)) as f32
            };
            let values: Vec<f32> = (0..n * n).map(wave).collect();
            let pyramid = Pyramid::new(Texture::new(n, n, 1, &values).unwrap(), Reduction::Box, Wrap::Clamp);
            let found = at(&pyramid, Wrap::Clamp, ellipse(weight), s as f32, t as f32, j).value[0];
            // A sum over texels misses the integral by what the rim cuts off squares, less than the jump there
            // times half a texel's area along the perimeter, in the two sums; and by the smooth part's own
            // error and rounding, far below 1e-5.
            let rim = double(weight).at(1.0, 0.0);
            let mass = PI * major * minor * mean(weight);
            let bound = rim * PI * (major + minor) / mass + 1e-5;
            assert!((f64::from(found) - gain).abs() < bound, "{row:?}: {found}");
            // Against the uncut Gaussian the cut one differs by at most twice the mass it leaves out.
            if !row[4].is_empty() {
                let (uncut, sigma): (f64, f64) = (row[4].parse().unwrap(), row[1].parse().unwrap());
                let left = libm::exp(-0.5 / (sigma * sigma));
                assert!((gain - uncut).abs() <= 2.0 * left);
                assert!((f64::from(found) - uncut).abs() <= 2.0 * left + bound);
            }
        }
        rows += 1;
    }
    assert_eq!(rows, 42);
}

/// The weight's mean over the ellipse, ∫₀¹ w(q) dq, by the midpoint rule; only a bound is made of it.
fn mean(weight: PixelWeight<f32>) -> f64 {
    (0..1000).map(|i| double(weight).at((f64::from(i) + 0.5) / 1000.0, 0.0)).sum::<f64>() / 1000.0
}

#[test]
fn degenerate_and_huge_footprints_end_well() {
    let mut draw = Draw(12);
    let pyramid = pyramid(random(&mut draw, 100, 60, 3));
    let zero = Jacobian { ux: 0.0, vx: 0.0, uy: 0.0, vy: 0.0 };
    let bilinear = Sampler::new(&pyramid, Wrap::Repeat, Method::Bilinear).unwrap();
    for filter in
        [ellipse(PixelWeight::Gaussian(0.3)), EllipseFilter { rim: Rim::Area, ..ellipse(PixelWeight::Box) }]
    {
        let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(filter)).unwrap();
        // A point, and a line, hold no texel: bilinear.
        for j in [zero, Jacobian { ux: 2.0, vx: 1.0, uy: 4.0, vy: 2.0 }, along(1e-3, 1e-3, 0.0)] {
            let found = sampler.lookup(10.3, 20.1, j);
            if filter.rim == Rim::Area && j.ux == 1e-3 {
                // Small, but it has an area, all of it in one texel.
                assert_eq!((found.fallback, found.value), (false, pyramid.level(0).texel(10, 20)));
                continue;
            }
            assert!(found.fallback && found.texels == 4, "{found:?}");
            assert_eq!(found.value, bilinear.lookup(10.3, 20.1, j).value);
        }
        // The line widened by the limit is an ellipse.
        let limited = EllipseFilter { anisotropy: 4.0, ..filter };
        let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(limited)).unwrap();
        let found = sampler.lookup(10.3, 20.1, Jacobian { ux: 20.0, vx: 10.0, uy: 4.0, vy: 2.0 });
        assert!(!found.fallback && found.value[0].is_finite());
        // Far beyond the pyramid: its last texel.
        for j in [along(1e9, 1e8, 0.3), along(1e38, 1e38, 0.0), along(1e30, 1.0, 1.0)] {
            let found = sampler.lookup(3e38, -1e20, j);
            assert_eq!(found.value, pyramid.level(6).texel(0, 0), "{found:?}");
            assert!(!found.refused);
        }
    }
    // A needle longer than a lookup may be, without a limit: read from a level where it is not.
    let sampler = Sampler::new(&pyramid, Wrap::Clamp, Method::Ellipse(ellipse(PixelWeight::Box))).unwrap();
    let found = sampler.lookup(50.0, 30.0, along(3e7, 1.0, 0.1));
    assert!(found.level >= 3.0 && found.value[0].is_finite() && !found.refused, "{found:?}");
    // In a level of choice: refused.
    let found = sampler.lookup_at(50.0, 30.0, along(1e5, 1e5, 0.1), Level::Fixed(0));
    assert!(found.refused && found.texels == 0 && found.value[..3].iter().all(|x| x.is_nan()));
    assert_eq!(found.value[3], 0.0);
    // Beyond the last level: the last.
    let found = sampler.lookup_at(50.0, 30.0, along(3.0, 3.0, 0.1), Level::Fixed(99));
    assert_eq!((found.level, found.value), (6.0, pyramid.level(6).texel(0, 0)));
}

#[test]
fn what_is_not_finite_gives_nan_and_reads_nothing() {
    let pyramid = pyramid(Texture::new(2, 2, 1, &[1.0, 2.0, 3.0, 4.0]).unwrap());
    let good = [0.5, 0.5, 1.0, 0.0, 0.0, 1.0];
    let methods =
        [Method::Nearest, Method::Bilinear, Method::Trilinear, Method::Ellipse(EllipseFilter::default())];
    for method in methods {
        let sampler = Sampler::new(&pyramid, Wrap::Repeat, method).unwrap();
        for place in 0..6 {
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let mut x = good;
                x[place] = bad;
                let found = sampler.lookup(x[0], x[1], Jacobian { ux: x[2], vx: x[3], uy: x[4], vy: x[5] });
                assert!(found.value[0].is_nan() && found.texels == 0 && found.level.is_nan(), "{found:?}");
            }
        }
    }
}

#[test]
fn bad_input_is_refused_with_its_value() {
    let error = |w, h, c, values: &[f32]| Texture::new(w, h, c, values).unwrap_err();
    assert_eq!(error(0, 3, 1, &[]), FilterError::Size { width: 0, height: 3 });
    assert_eq!(error(1 << 25, 1, 1, &[]), FilterError::Size { width: 1 << 25, height: 1 });
    assert_eq!(error(1, 1, 5, &[0.0; 5]), FilterError::Channels { channels: 5 });
    assert_eq!(error(1, 1, 0, &[]), FilterError::Channels { channels: 0 });
    let short = error(2, 2, 1, &[0.0; 3]);
    assert_eq!(short, FilterError::Length { found: 3, width: 2, height: 2, channels: 1 });
    assert_eq!(short.to_string(), "3 values for 2 × 2 texels of 1 channels");
    assert_eq!(
        error(2, 1, 1, &[0.0, f32::INFINITY]),
        FilterError::NotFinite { index: 1, value: f32::INFINITY }
    );
    let pyramid = pyramid(Texture::new(1, 1, 1, &[0.0]).unwrap());
    let refused =
        |filter: EllipseFilter| Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(filter)).unwrap_err();
    for sigma in [0.0, -1.0, 1e-4, 2000.0, f32::INFINITY] {
        for weight in
            [PixelWeight::Gaussian(sigma), PixelWeight::Bell(8, sigma), PixelWeight::Cubic(4, sigma)]
        {
            assert_eq!(refused(ellipse(weight)), FilterError::Sigma { sigma });
        }
    }
    assert!(matches!(refused(ellipse(PixelWeight::Gaussian(f32::NAN))), FilterError::Sigma { .. }));
    for (weight, power) in
        [(PixelWeight::Bell(3, 0.3), 3), (PixelWeight::Bell(0, 0.3), 0), (PixelWeight::Cubic(16, 0.3), 16)]
    {
        assert!(matches!(refused(ellipse(weight)), FilterError::Power { power: p, .. } if p == power));
    }
    for limit in [0.5, -1.0] {
        let filter = EllipseFilter { anisotropy: limit, ..EllipseFilter::default() };
        assert_eq!(refused(filter), FilterError::Anisotropy { limit });
    }
    assert!(
        refused(EllipseFilter { anisotropy: f32::NAN, ..EllipseFilter::default() })
            .to_string()
            .contains("NaN")
    );
    for cover in [0.0, -1.0, 2000.0] {
        let filter = EllipseFilter { cover, ..EllipseFilter::default() };
        assert_eq!(refused(filter), FilterError::Cover { cover });
    }
}
