//! Lookups several at once against the same lookups one by one.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::filter::{
    AxesKind, EllipseFilter, FilterError, Level, Lookup, Method, Pixel, Pyramid, Reduction, Rim, Sampler,
    Texture, Wrap,
};
use bellfit::kernel::pixel::{Jacobian, Padding, PaperReading, PixelWeight, TiltFormula};
use bellfit::slice::Unit;
use draw::Draw;

fn pyramid(draw: &mut Draw, width: usize, height: usize, channels: usize) -> Pyramid {
    let values: Vec<f32> = (0..width * height * channels).map(|_| draw.real(0.0, 1.0) as f32).collect();
    Pyramid::new(Texture::new(width, height, channels, &values).unwrap(), Reduction::Box, Wrap::Repeat)
}

/// Every kind that a plan may meet, in random order: within one strip, within a few, across edges, far away, longer
/// than the lanes' 64 rows, without area, too large to be read, not finite.
fn pixel(draw: &mut Draw) -> Pixel {
    let (size, aspect) = (libm::exp2(draw.real(-3.0, 6.5)), libm::exp2(draw.real(0.0, 4.0)));
    let angle = draw.real(0.0, 6.3);
    let (sin, cos) = libm::sincos(angle);
    let minor = size / aspect;
    let mut pixel = Pixel {
        s: draw.real(-30.0, 190.0) as f32,
        t: draw.real(-30.0, 120.0) as f32,
        jacobian: Jacobian {
            ux: (size * cos) as f32,
            vx: (size * sin) as f32,
            uy: (-minor * sin) as f32,
            vy: (minor * cos) as f32,
        },
    };
    match draw.below(24) {
        0 => pixel.s = f32::NAN,
        1 => pixel.jacobian.uy = f32::INFINITY,
        2 => (pixel.jacobian.uy, pixel.jacobian.vy) = (pixel.jacobian.ux, pixel.jacobian.vx),
        3 => pixel.jacobian = Jacobian { ux: 0.0, vx: 0.0, uy: 0.0, vy: 0.0 },
        4 => (pixel.jacobian.ux, pixel.jacobian.vy) = (1e7, 1e7),
        5 => (pixel.s, pixel.t) = (3e30, -7e20),
        _ => {}
    }
    pixel
}

fn bits(found: &Lookup) -> ([u32; 4], u64, u32, bool, bool) {
    (found.value.map(f32::to_bits), found.texels, found.level.to_bits(), found.fallback, found.refused)
}

fn same(sampler: &Sampler, pixels: &[Pixel], level: Level, what: &str) -> [u32; 3] {
    // What is in the slice before must not matter.
    let stale = Lookup { value: [9.0; 4], texels: 7, level: 5.0, fallback: true, refused: true };
    let mut found = vec![stale; pixels.len()];
    sampler.lookups(pixels, level, &mut found).unwrap();
    let mut seen = [0; 3];
    for (pixel, found) in pixels.iter().zip(&found) {
        let alone = sampler.lookup_at(pixel.s, pixel.t, pixel.jacobian, level);
        assert_eq!(bits(found), bits(&alone), "{what} {pixel:?}");
        let kinds = [found.fallback, found.refused, found.value[0].is_nan()];
        for (seen, kind) in seen.iter_mut().zip(kinds) {
            *seen += u32::from(kind);
        }
    }
    seen
}

#[test]
fn many_at_once_are_each_as_alone() {
    let mut draw = Draw(71);
    let third = 1.0 / 3.0;
    let weights = [
        PixelWeight::Cubic(4, third),
        PixelWeight::Cubic(8, 0.5),
        PixelWeight::Gaussian(0.5),
        PixelWeight::Box,
        PixelWeight::Bell(16, third),
        PixelWeight::Paper(PaperReading::R2),
        PixelWeight::PaperProduct(PaperReading::R3),
    ];
    let mut seen = [0; 3];
    for channels in 1..=4 {
        let pyramid = pyramid(&mut draw, 160, 90, channels);
        for (i, weight) in weights.into_iter().enumerate() {
            let filter = EllipseFilter {
                weight,
                padding: [Padding::Plain, Padding::Padded][i % 2],
                anisotropy: [f32::INFINITY, 4.0][i / 2 % 2],
                ..EllipseFilter::default()
            };
            let method = Method::Ellipse(filter);
            let sampler = Sampler::new(&pyramid, Wrap::ALL[i % 3], method).unwrap();
            // Below, at and above the number that is planned together.
            for n in [0, 1, 2, 7, 15, 16, 17, 33, 50] {
                let pixels: Vec<Pixel> = (0..n).map(|_| pixel(&mut draw)).collect();
                for level in [Level::Auto, Level::Fixed(0), Level::Fixed(3)] {
                    let what = format!("{channels} channels, {weight:?}, {level:?}");
                    let some = same(&sampler, &pixels, level, &what);
                    for (seen, some) in seen.iter_mut().zip(some) {
                        *seen += some;
                    }
                }
            }
        }
    }
    assert!(seen.iter().all(|&seen| seen > 50), "too few of a kind: {seen:?}");
}

/// As many plans as there can be.
#[test]
fn lookups_that_all_lie_between_two_levels() {
    let mut draw = Draw(75);
    let pyramid = pyramid(&mut draw, 160, 90, 1);
    let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(EllipseFilter::default())).unwrap();
    let jacobian = Jacobian { ux: 7.0, vx: 1.0, uy: -1.0, vy: 6.0 };
    let pixels: Vec<Pixel> = (0..100).map(|i| Pixel { s: i as f32, t: 40.0, jacobian }).collect();
    assert_eq!(same(&sampler, &pixels, Level::Auto, "between"), [0; 3]);
    assert!(sampler.lookup(0.0, 40.0, jacobian).level.fract() > 0.0);
}

/// A million texels of 0.1: added up in single precision alone, thousands to a lane, they would drift from it by a
/// hundred times what the sums may round.
#[test]
fn the_largest_sums_are_no_less_accurate() {
    let texture = Texture::new(64, 64, 1, &[0.1; 64 * 64]).unwrap();
    let pyramid = Pyramid::new(texture, Reduction::Box, Wrap::Repeat);
    let filter = EllipseFilter { weight: PixelWeight::Box, ..EllipseFilter::default() };
    let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(filter)).unwrap();
    let jacobian = Jacobian { ux: 600.0, vx: 0.0, uy: 0.0, vy: 560.0 };
    let found = sampler.lookup_at(3.0, 7.0, jacobian, Level::Fixed(0));
    assert!(found.texels > 1_000_000);
    // 64 additions in a lane, three across the lanes and the mean's rounding; the weights' sums are exact.
    let bound = 70.0 / f64::from(1 << 24);
    assert!((f64::from(found.value[0]) / f64::from(0.1_f32) - 1.0).abs() < bound, "{}", found.value[0]);
}

#[test]
fn every_method_rim_and_axis_takes_many() {
    let mut draw = Draw(72);
    let pyramid = pyramid(&mut draw, 160, 90, 3);
    let plain = EllipseFilter::default();
    let vector = AxesKind::Paper(TiltFormula::Vector);
    let methods = [
        Method::Nearest,
        Method::Bilinear,
        Method::Trilinear,
        Method::Ellipse(EllipseFilter { rim: Rim::Area, ..plain }),
        Method::Ellipse(EllipseFilter { rim: Rim::Volume, axes: vector, ..plain }),
        Method::Ellipse(EllipseFilter { axes: vector, ..plain }),
    ];
    for method in methods {
        let sampler = Sampler::new(&pyramid, Wrap::Mirror, method).unwrap();
        let pixels: Vec<Pixel> = (0..40).map(|_| pixel(&mut draw)).collect();
        for level in [Level::Auto, Level::Fixed(1)] {
            same(&sampler, &pixels, level, &format!("{method:?}, {level:?}"));
        }
    }
}

#[test]
fn every_vector_unit_gives_the_same_bits_to_many() {
    let mut draw = Draw(73);
    for channels in 1..=4 {
        let pyramid = pyramid(&mut draw, 160, 90, channels);
        let method = Method::Ellipse(EllipseFilter::default());
        let pixels: Vec<Pixel> = (0..300).map(|_| pixel(&mut draw)).collect();
        let found = |unit: Unit| {
            let sampler = Sampler::new(&pyramid, Wrap::Repeat, method).unwrap().on(unit);
            let mut found = vec![sampler.lookup(0.0, 0.0, pixels[0].jacobian); pixels.len()];
            sampler.lookups(&pixels, Level::Auto, &mut found).unwrap();
            found.iter().map(bits).collect::<Vec<_>>()
        };
        let plain = found(Unit::plain());
        for unit in Unit::available() {
            assert_eq!(found(unit), plain, "{}", unit.id());
        }
    }
}

#[test]
fn slices_of_two_lengths_are_refused_and_nothing_is_written() {
    let mut draw = Draw(74);
    let pyramid = pyramid(&mut draw, 8, 8, 1);
    for method in [Method::Nearest, Method::Ellipse(EllipseFilter::default())] {
        let sampler = Sampler::new(&pyramid, Wrap::Repeat, method).unwrap();
        let pixels = [pixel(&mut draw); 3];
        let before = Lookup { texels: 99, ..Lookup::default() };
        for n in [0, 2, 4] {
            let mut out = vec![before; n];
            let error = sampler.lookups(&pixels, Level::Auto, &mut out).unwrap_err();
            assert_eq!(error, FilterError::Slices { pixels: 3, lookups: n });
            let message = format!("3 pixels, but room for {n} lookups: must be the same");
            assert_eq!(error.to_string(), message);
            assert!(out.iter().all(|found| *found == before));
        }
    }
}
