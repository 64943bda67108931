//! What an elliptical lookup costs, against the published shape of the job.
//!
//! `cargo bench --bench filter`. The published shape is Heckbert's and pbrt's: a scalar loop over the
//! bounding box of the padded conic, finite differences of Q along u, a test Q < 1, a table of 128 weights
//! looked up at ⌊128 Q⌋; here in its best form, compiled for its number of channels, with texels side by
//! side, no wrapping and the table's entries in the middle of their intervals. Ours is the public sampler with
//! its default filter, run-time dispatch and wrap modes included, 256 pixels a call as a renderer's rows have
//! them, and one a call beside it.
//!
//! All read the same ellipses of the same texture, minor semi-axis 2 to 4 texels before padding (what the
//! choice of level leaves at cover 2), 4 to 8 (cover 4) and 8 to 16 (cover 8), aspects 1 to 16, at tilts of 0,
//! 20, 45, 70, 90 and 135 degrees and random places, wholly inside the texture. The routes take turns run by
//! run, and the median run counts. Errors are against the exact mean under exp(-9Q/2) over Q ≤ 1, in double
//! precision, for a texture of independent values in [0, 1]; they are the same on every machine, the times
//! are not.

#[path = "../tests/support/draw.rs"]
mod draw;

use bellfit::filter::{
    EllipseFilter, Level, Lookup, Method, Pixel, Pyramid, Reduction, Sampler, Texture, Wrap,
};
use bellfit::kernel::pixel::{Jacobian, PixelWeight};
use bellfit::slice::Unit;
use draw::Draw;
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 15;
const SIZE: usize = 640;
/// So many that no branch predictor learns them.
const LOOKUPS: usize = 4096;
/// A call.
const ROW: usize = 256;
/// Of them, those whose error is looked at.
const CHECKED: usize = 120;
const TILTS: [f64; 6] = [0.0, 20.0, 45.0, 70.0, 90.0, 135.0];

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The textbook's loop over one level; texels of C channels side by side, row by row.
fn published<const C: usize>(
    texels: &[[f32; C]],
    width: usize,
    table: &[f32; 128],
    pixel: &Pixel,
) -> [f32; C] {
    let Jacobian { ux, vx, uy, vy } = pixel.jacobian;
    let (mut a, mut b, mut c) =
        (vx * vx + vy * vy + 1.0, -2.0 * (ux * vx + uy * vy), ux * ux + uy * uy + 1.0);
    let f = a * c - 0.25 * b * b;
    let (reach_u, reach_v) = (c.sqrt(), a.sqrt());
    (a, b, c) = (a / f, b / f, c / f);
    let (s, t) = (pixel.s - 0.5, pixel.t - 0.5);
    // Positive: a cast that rounds up or down.
    let (u0, u1) = ((s - reach_u) as usize + 1, (s + reach_u) as usize);
    let (v0, v1) = ((t - reach_v) as usize + 1, (t + reach_v) as usize);
    let (mut sum, mut value) = (0.0, [0.0; C]);
    let u = u0 as f32 - s;
    let second = 2.0 * a;
    for y in v0..=v1 {
        let v = y as f32 - t;
        let mut first = a * (2.0 * u + 1.0) + b * v;
        let mut q = (c * v + b * u) * v + a * u * u;
        for texel in &texels[y * width + u0..=y * width + u1] {
            if q < 1.0 {
                let w = table[((q * 128.0) as usize).min(127)];
                sum += w;
                for k in 0..C {
                    value[k] += w * texel[k];
                }
            }
            q += first;
            first += second;
        }
    }
    value.map(|x| x / sum)
}

/// The exact mean of the first channel.
fn exact(texture: &Texture, pixel: &Pixel) -> f64 {
    let j = [pixel.jacobian.ux, pixel.jacobian.vx, pixel.jacobian.uy, pixel.jacobian.vy].map(f64::from);
    let (uu, vv, uv) =
        (j[0] * j[0] + j[2] * j[2] + 1.0, j[1] * j[1] + j[3] * j[3] + 1.0, j[0] * j[1] + j[2] * j[3]);
    let det = uu * vv - uv * uv;
    let (mut sum, mut value) = (0.0, 0.0);
    for y in 0..SIZE {
        for x in 0..SIZE {
            let (u, v) = (x as f64 + 0.5 - f64::from(pixel.s), y as f64 + 0.5 - f64::from(pixel.t));
            let q = (vv * u * u - 2.0 * uv * u * v + uu * v * v) / det;
            if q <= 1.0 {
                let w = libm::exp(-4.5 * q);
                sum += w;
                value += w * f64::from(texture.texel(x, y)[0]);
            }
        }
    }
    value / sum
}

fn footprints(draw: &mut Draw, cover: f64, aspect: f64) -> Vec<Pixel> {
    (0..LOOKUPS)
        .map(|i| {
            let minor = cover * libm::exp2(draw.real(0.0, 1.0));
            let (sin, cos) = libm::sincos(TILTS[i % TILTS.len()].to_radians());
            let major = minor * aspect;
            let jacobian = Jacobian {
                ux: (major * cos) as f32,
                vx: (major * sin) as f32,
                uy: (-minor * sin) as f32,
                vy: (minor * cos) as f32,
            };
            let mut place = || draw.real(262.0, SIZE as f64 - 262.0) as f32;
            Pixel { s: place(), t: place(), jacobian }
        })
        .collect()
}

/// Fills the first channel's values in.
type Route<'a> = Box<dyn Fn(&[Pixel], &mut [f32]) + 'a>;

fn routes<'a, const C: usize>(
    pyramid: &'a Pyramid,
    texels: &'a [[f32; C]],
    table: &'a [f32; 128],
) -> Vec<(&'static str, Route<'a>)> {
    let sampler = |weight, unit: Unit| {
        let filter = EllipseFilter { weight, ..EllipseFilter::default() };
        let sampler = Sampler::new(pyramid, Wrap::Repeat, Method::Ellipse(filter)).expect("a valid filter");
        sampler.on(unit)
    };
    let rows = |weight, unit| -> Route<'a> {
        let sampler = sampler(weight, unit);
        Box::new(move |pixels, values| {
            let mut found = [Lookup::default(); ROW];
            for (pixels, values) in pixels.chunks(ROW).zip(values.chunks_mut(ROW)) {
                let found = &mut found[..pixels.len()];
                sampler.lookups(pixels, Level::Fixed(0), found).expect("slices of one length");
                for (value, found) in values.iter_mut().zip(found) {
                    *value = found.value[0];
                }
            }
        })
    };
    let third = 1.0 / 3.0;
    let one_by_one = sampler(PixelWeight::Cubic(4, third), Unit::best());
    vec![
        (
            "published",
            Box::new(|pixels, values| {
                for (pixel, value) in pixels.iter().zip(values) {
                    *value = published(texels, SIZE, table, pixel)[0];
                }
            }),
        ),
        ("cubic K=4", rows(PixelWeight::Cubic(4, third), Unit::best())),
        ("cubic K=8", rows(PixelWeight::Cubic(8, third), Unit::best())),
        ("Gaussian", rows(PixelWeight::Gaussian(third), Unit::best())),
        ("cubic K=4, plain", rows(PixelWeight::Cubic(4, third), Unit::plain())),
        (
            "cubic K=4, singly",
            Box::new(move |pixels, values| {
                for (Pixel { s, t, jacobian }, value) in pixels.iter().zip(values) {
                    *value = one_by_one.lookup_at(*s, *t, *jacobian, Level::Fixed(0)).value[0];
                }
            }),
        ),
    ]
}

fn table<const C: usize>() {
    let mut draw = Draw(7);
    let values: Vec<f32> = (0..SIZE * SIZE * C).map(|_| draw.real(0.0, 1.0) as f32).collect();
    let texture = Texture::new(SIZE, SIZE, C, &values).expect("as many values as texels");
    let pyramid = Pyramid::new(texture, Reduction::Box, Wrap::Repeat);
    let texels: Vec<[f32; C]> = values.chunks_exact(C).map(|t| std::array::from_fn(|k| t[k])).collect();
    let weights: [f32; 128] = std::array::from_fn(|i| libm::exp(-4.5 * (i as f64 + 0.5) / 128.0) as f32);
    for (cover, aspect) in [2.0, 4.0, 8.0].iter().flat_map(|c| [1.0, 2.0, 4.0, 8.0, 16.0].map(|a| (*c, a))) {
        let pixels = footprints(&mut draw, cover, aspect);
        let routes = routes(&pyramid, &texels, &weights);
        let mut times = vec![vec![]; routes.len()];
        let mut values = vec![0.0; LOOKUPS];
        let repeats = ((64.0 / aspect / cover) as usize).max(1);
        for run in 0..=RUNS {
            for ((_, route), times) in routes.iter().zip(&mut times) {
                let start = Instant::now();
                for _ in 0..repeats {
                    route(black_box(&pixels), &mut values);
                    black_box(&values);
                }
                if run > 0 {
                    // The first run warms up.
                    times.push(start.elapsed().as_nanos() as f64 / (repeats * pixels.len()) as f64);
                }
            }
        }
        let truth: Vec<f64> = pixels[..CHECKED].iter().map(|pixel| exact(pyramid.level(0), pixel)).collect();
        let medians: Vec<f64> = times.into_iter().map(median).collect();
        for ((name, route), ns) in routes.iter().zip(&medians) {
            route(&pixels, &mut values);
            let errors = values.iter().zip(&truth).map(|(&value, t)| (f64::from(value) - t).abs());
            let largest = errors.fold(0.0, f64::max);
            println!("{C:8} {cover:5} {aspect:6} {name:18} {ns:9.1} {:7.2} {largest:10.1e}", medians[0] / ns);
        }
    }
}

fn main() {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpu.lines().find_map(|line| line.strip_prefix("model name")).unwrap_or("unknown");
    println!("processor {}, unit {}", model.trim_matches([' ', '\t', ':']), Unit::best().id());
    println!(
        "ns a lookup, median of {RUNS} interleaved runs; times the published shape's speed; largest error\n"
    );
    println!(
        "{:>8} {:>5} {:>6} {:18} {:>9} {:>7} {:>10}",
        "channels", "cover", "aspect", "route", "ns", "speed", "error"
    );
    table::<1>();
    table::<3>();
    table::<4>();
}
