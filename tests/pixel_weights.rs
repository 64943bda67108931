//! The mapping to the texture, the weights, and what the pixel kernels do at the ends of their domains.
//!
//! References: tests/references/pixel_polygons.csv by pixel.py (mpmath); theorems; exact fractions. Errors are
//! counted in u, half an ulp at 1.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/pixel.rs"]
mod pixel;
#[path = "support/references.rs"]
mod references;

use bellfit::kernel::bell::bell;
use bellfit::kernel::cubic::cubic_bell;
use bellfit::kernel::pixel::*;
use bellfit::kernel::real::Real;
use draw::Draw;
use pixel::*;
use references::{Reference, rows};

const INF: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;

// ---- The mapping ----

#[test]
fn the_mapping_and_its_derivatives_against_references() {
    fn test<F: Real>() -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        let table = rows::<17>("pixel_polygons.csv");
        assert_eq!(table.len(), 60);
        for row in table {
            let at: [f64; 11] = std::array::from_fn(|i| row[i].parse().unwrap());
            let want: [Reference; 6] = std::array::from_fn(|i| Reference::parse(&row[11 + i]).unwrap());
            let f = |i: usize| F::from_f64(at[i]);
            let polygon = Polygon { u: [f(0), f(1), f(2)], v: [f(3), f(4), f(5)], w: [f(6), f(7), f(8)] };
            let (x, y) = (at[9], at[10]);
            let ((u, v), j) = (polygon.at(f(9), f(10)), polygon.jacobian(f(9), f(10)));
            // The pages' error counts, in doubles; w by its exact value.
            let size = |a: f64, b: f64, c: f64| (a * x).abs() + (b * y).abs() + c.abs();
            let [d, e, g] = [at[6], at[7], at[8]];
            let w = (d * x + e * y + g).abs();
            let lost = size(d, e, g) / w;
            for (k, (value, [jx, jy])) in [(u, [j.ux, j.uy]), (v, [j.vx, j.vy])].into_iter().enumerate() {
                let [a, b, c] = [at[3 * k], at[3 * k + 1], at[3 * k + 2]];
                let room = 4.0 * (size(a, b, c) / w + want[k].to_f64().abs() * lost) * unit::<F>();
                let error = distance(&want[k], value.to_f64());
                assert!(error <= room, "{row:?}: {value:?}, {error:e} against {room:e}");
                worst[0] = worst[0].max(error / room);
                let (ae, af, bf) = (a * e - b * d, a * g - c * d, b * g - c * e);
                let terms = [(ae * y).abs() + af.abs(), (ae * x).abs() + bf.abs()];
                for (i, value) in [jx, jy].into_iter().enumerate() {
                    let want = &want[2 + k + 2 * i];
                    let room = 6.0 * terms[i] / (w * w) + 8.0 * lost * want.to_f64().abs();
                    let error = distance(want, value.to_f64());
                    assert!(error <= room * unit::<F>(), "{row:?}: {value:?} for {}", want.to_f64());
                    worst[1] = worst[1].max(error / (room * unit::<F>()));
                }
            }
        }
        worst
    }
    println!("fraction of the bound met: f32 {:?}, f64 {:?}", test::<f32>(), test::<f64>());
}

#[test]
fn derivatives_are_the_limit_of_differences() {
    let mut draw = Draw(41);
    for _ in 0..200 {
        let mut row = || [0; 3].map(|_| draw.real(-2.0, 2.0));
        let polygon = Polygon { u: row(), v: row(), w: [0.1, -0.2, 8.0] };
        let (x, y) = (draw.real(-5.0, 5.0), draw.real(-5.0, 5.0));
        let j = polygon.jacobian(x, y);
        // Central: the error is h²/6 times the third derivative, and values of up to 10 are rounded.
        let h = 1e-4;
        let slope = |a: (f64, f64), b: (f64, f64)| ((b.0 - a.0) / (2.0 * h), (b.1 - a.1) / (2.0 * h));
        let (ux, vx) = slope(polygon.at(x - h, y), polygon.at(x + h, y));
        let (uy, vy) = slope(polygon.at(x, y - h), polygon.at(x, y + h));
        for (got, want) in [(j.ux, ux), (j.vx, vx), (j.uy, uy), (j.vy, vy)] {
            assert!((got - want).abs() < 1e-10, "{got} {want}");
        }
        // Where w is constant a pixel's difference is the derivative.
        let affine = Polygon { w: [0.0, 0.0, 4.0], ..polygon };
        let (a, b) = (affine.jacobian(x, y), affine.differences(x, y));
        for (a, b) in [(a.ux, b.ux), (a.vx, b.vx), (a.uy, b.uy), (a.vy, b.vy)] {
            assert!((a - b).abs() < 1e-14);
        }
        // det J w³ is the determinant of the nine, whatever the place.
        let w = 0.1 * x - 0.2 * y + 8.0;
        let ([a, b, c], [d, e, f], [g, h, i]) = (polygon.u, polygon.v, polygon.w);
        let nine = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
        assert!((j.determinant() * w * w * w - nine).abs() < 1e-12 * 100.0);
    }
}

#[test]
fn on_the_horizon_nothing_is_finite() {
    let plane = Polygon { u: [1.0, 0.0, 0.0], v: [0.0, 0.0, 1.0], w: [0.0, 1.0, 0.0] };
    assert_eq!(plane.at(3.0, 0.0), (INF, INF));
    let j = plane.jacobian(3.0, 0.0);
    assert!(!j.is_finite());
    assert!(Axes::of(j, Padding::Padded).major.is_nan());
    assert!(Inverse::of(j, Padding::Padded).q(0.0, 0.0).is_nan());
    assert!(Footprint::of(j, Padding::Padded).q(0.0, 0.0).is_nan());
}

// ---- The weights ----

fn weights<F: Real>() -> Vec<PixelWeight<F>> {
    let third = F::from_f64(1.0 / 3.0);
    let mut all = vec![PixelWeight::Gaussian(third), PixelWeight::Gaussian(F::ONE), PixelWeight::Box];
    for reading in PaperReading::ALL {
        all.extend([PixelWeight::Paper(reading), PixelWeight::PaperProduct(reading)]);
    }
    all.extend([2, 4, 8, 16, 32, 64].map(|k| PixelWeight::Bell(k, third)));
    all.extend([2, 4, 8].map(|k| PixelWeight::Cubic(k, third)));
    all
}

#[test]
fn weights_fall_from_one() {
    fn test<F: Real>() {
        for weight in weights::<F>() {
            assert_eq!(weight.at(F::ZERO, F::ZERO), F::ONE, "{weight:?}");
            let mut last = F::ONE;
            for k in 0..=40_000 {
                let q = F::from_f64(f64::from(k) / 4000.0);
                let value = weight.at(q, F::ZERO);
                // The cubic bells may rise by 4 ε between neighbours, as their page says.
                let rise = if matches!(weight, PixelWeight::Cubic(..)) { 8.0 * unit::<F>() } else { 0.0 };
                assert!(value >= F::ZERO && value.to_f64() <= last.to_f64() + rise, "{weight:?} at {q:?}");
                // A sum of squares, or one of two equal factors.
                assert_eq!(weight.at(F::ZERO, q), value);
                if weight.is_radial() {
                    assert_eq!(weight.at(F::HALF * q, F::HALF * q), value);
                }
                last = value;
            }
            let infinite = weight.at(F::INFINITY, F::ZERO);
            let end = if weight == PixelWeight::Box { F::ONE } else { F::ZERO };
            assert_eq!(infinite, end, "{weight:?}");
            assert!(weight.at(F::NAN, F::ZERO).is_nan() && weight.at(F::ZERO, F::NAN).is_nan(), "{weight:?}");
        }
        for k in [0, 1, 3, 5, 128] {
            assert!(PixelWeight::Bell(k, F::HALF).at(F::ZERO, F::ZERO).is_nan());
            assert!(PixelWeight::Cubic(k, F::HALF).at(F::ZERO, F::ZERO).is_nan());
        }
        assert!(PixelWeight::Cubic(16, F::HALF).at(F::ZERO, F::ZERO).is_nan());
    }
    test::<f32>();
    test::<f64>();
}

#[test]
fn readings_are_what_they_say() {
    fn test<F: Real>() {
        let at = |reading, q: f64| PixelWeight::Paper(reading).at(F::from_f64(q), F::ZERO).to_f64();
        for (reading, zero) in [
            (PaperReading::R1, 1.0),
            (PaperReading::R2, 16.0 / 9.0),
            (PaperReading::R3, 2.0),
            (PaperReading::R4, 8.0),
        ] {
            // 16/9 is not a float: a step beyond it.
            assert_eq!(at(reading, zero * (1.0 + 4.0 * unit::<F>())), 0.0);
            assert!(at(reading, zero * 0.9) > 0.0);
        }
        // On the ellipse, exact in both types: 0, (7/16)^8, (1/2)^8, (7/8)^8.
        assert_eq!(at(PaperReading::R1, 1.0), 0.0);
        assert_eq!(at(PaperReading::R3, 1.0), 1.0 / 256.0);
        assert!(
            (at(PaperReading::R2, 1.0) / (5_764_801.0 / 4_294_967_296.0) - 1.0).abs() < 8.0 * unit::<F>()
        );
        assert!((at(PaperReading::R4, 1.0) / (5_764_801.0 / 16_777_216.0) - 1.0).abs() < 8.0 * unit::<F>());
        let mut draw = Draw(42);
        for _ in 0..5000 {
            let (aa, bb) = (F::from_f64(draw.real(0.0, 2.0)), F::from_f64(draw.real(0.0, 1.0)));
            let q = aa + bb;
            // R2 is Lyon's bell with K = 8 of t = 9 Q/2: the bells' powers agree to 15 roundings each.
            let (r2, lyon) =
                (PixelWeight::Paper(PaperReading::R2).at(aa, bb), bell::<8, F>(F::from_f64(4.5) * q));
            // Next to the zero 1 - c Q has absolute error u, which the eighth power damps.
            assert!((r2 - lyon).abs().to_f64() <= 32.0 * unit::<F>() * lyon.to_f64().max(1e-6), "{q:?}");
            let sigma = F::from_f64(0.75);
            let t = q / (F::TWO * sigma * sigma);
            assert_eq!(PixelWeight::Bell(16, sigma).at(aa, bb), bell::<16, F>(t));
            assert_eq!(PixelWeight::Cubic(4, sigma).at(aa, bb), cubic_bell::<4, F>(t));
            assert_eq!(PixelWeight::Gaussian(sigma).at(aa, bb), (-t).exp());
            for reading in PaperReading::ALL {
                let alone = |x: F| PixelWeight::Paper(reading).at(x, F::ZERO);
                assert_eq!(PixelWeight::PaperProduct(reading).at(aa, bb), alone(aa) * alone(bb));
            }
        }
    }
    test::<f32>();
    test::<f64>();
}

#[test]
fn both_types_agree() {
    let mut draw = Draw(43);
    for (single, double) in weights::<f32>().into_iter().zip(weights::<f64>()) {
        for _ in 0..500 {
            let (aa, bb) = (draw.real(0.0, 1.5) as f32, draw.real(0.0, 1.5) as f32);
            let (a, b) = (f64::from(single.at(aa, bb)), double.at(f64::from(aa), f64::from(bb)));
            // Each weight's slope in Q is below 5, and K roundings of a power of 64 at most.
            assert!((a - b).abs() < 64.0 * unit::<f32>(), "{double:?} at {aa}, {bb}: {a} {b}");
        }
    }
}

// ---- The ends of the domains ----

#[test]
fn a_degenerate_ellipse_holds_nothing() {
    fn test<F: Real>() {
        for j in [[3.0, 1.0, 6.0, 2.0], [0.0; 4], [0.0, 5.0, 0.0, 0.0], [2.0, 0.0, -1.0, 0.0]] {
            let j = jacobian::<F>(j);
            let (footprint, inverse) = (Footprint::of(j, Padding::Plain), Inverse::of(j, Padding::Plain));
            assert_eq!(Axes::of(j, Padding::Plain).minor, F::ZERO);
            for (u, v) in [(0.0, 0.0), (1.0, 0.0), (3.0, 1.0), (-2.0, 5.0)] {
                let (u, v) = (F::from_f64(u), F::from_f64(v));
                assert_eq!((footprint.q(u, v), inverse.q(u, v)), (F::INFINITY, F::INFINITY), "{j:?}");
                assert_eq!(coverage(&footprint, u, v), F::ZERO);
                assert_eq!(half_plane(&footprint, u, v), F::ZERO);
            }
            assert!(footprint.q(F::NAN, F::ZERO).is_nan() && footprint.q(F::ZERO, F::NAN).is_nan());
            assert!(inverse.q(F::NAN, F::ZERO).is_nan() && inverse.q(F::ZERO, F::NAN).is_nan());
            // Padded it is an ellipse.
            assert_eq!(Footprint::of(j, Padding::Padded).q(F::ZERO, F::ZERO), F::ZERO);
            assert_eq!(Inverse::of(j, Padding::Padded).q(F::ZERO, F::ZERO), F::ZERO);
        }
        for bad in [NAN, INF, -INF] {
            for place in 0..4 {
                let mut j = [3.0, 1.0, 0.5, 2.0];
                j[place] = bad;
                let j = jacobian::<F>(j);
                for padding in [Padding::Plain, Padding::Padded] {
                    assert!(Footprint::of(j, padding).q(F::ZERO, F::ZERO).is_nan());
                    assert!(Inverse::of(j, padding).q(F::ZERO, F::ZERO).is_nan());
                    assert!(coverage(&Footprint::of(j, padding), F::ZERO, F::ZERO).is_nan());
                    assert!(half_plane(&Footprint::of(j, padding), F::ONE, F::ZERO).is_nan());
                    let axes = Axes::of(j, padding);
                    assert!(axes.major.is_nan() && axes.minor.is_nan() && axes.tilt.is_nan());
                }
            }
        }
    }
    test::<f32>();
    test::<f64>();
}

#[test]
fn the_footprints_domain_is_what_its_page_says() {
    fn test<F: Real>(high: i32, low: i32) {
        let power = |e: i32| F::ONE.scaled(e);
        // A round ellipse of the largest and the smallest size, and a long one between.
        let ends = [(high, high), (low / 2, low - low / 2), (high, low - high)];
        for (a, b) in ends {
            let j = Jacobian { ux: power(a), vx: F::ZERO, uy: F::ZERO, vy: power(b) };
            let q = Footprint::of(j, Padding::Plain).q(power(a), power(b));
            // The long one's row is too narrow for its square: `Inverse` is for it.
            if b >= low {
                assert_eq!(q, F::TWO, "2^{a}, 2^{b}");
            }
            assert_eq!(Inverse::of(j, Padding::Plain).q(power(a), power(b)), F::TWO);
        }
        // Long rows and |det J| at the lower end, but a chord that vanishes: nothing, in the middle too.
        let line =
            Jacobian { ux: power(high - 1), vx: power(high - 1), uy: power(low - high + 1), vy: F::ZERO };
        assert_eq!(Footprint::of(line, Padding::Plain).q(F::ZERO, F::ZERO), F::INFINITY);
        // Beyond: NaN above, nothing below, and never a plausible number.
        let round = |e| Jacobian { ux: power(e), vx: power(e), uy: -power(e), vy: power(e) };
        let above = Footprint::of(round(high + 2), Padding::Plain);
        assert!(above.q(F::ZERO, F::ZERO).is_nan());
        let below = Footprint::of(round(2 * low), Padding::Plain);
        assert_eq!(below.q(F::ZERO, F::ZERO), F::INFINITY);
        assert_eq!(Inverse::of(round(high + 2), Padding::Plain).q(power(high + 2), power(high + 2)), F::ONE);
        assert_eq!(Inverse::of(round(2 * low), Padding::Plain).q(power(2 * low), power(2 * low)), F::ONE);
    }
    test::<f32>(31, -63);
    test::<f64>(255, -511);
}

#[test]
fn the_skew_of_any_size_is_the_same() {
    fn test<F: Real>(exponents: [i32; 4]) {
        let third = Jacobian { ux: F::ONE, vx: F::ONE, uy: -F::ONE, vy: F::TWO };
        let want = Skew::of(third);
        // Of (1, 1) to (-1, 2): the cross product is 3, the inner one 1.
        assert!((want.angle.to_f64() - libm::atan(3.0)).abs() < 4.0 * unit::<F>());
        for e in exponents {
            let s = |x: F| x.scaled(e);
            let j = Jacobian { ux: s(third.ux), vx: s(third.vx), uy: s(third.uy), vy: s(third.vy) };
            assert_eq!(Skew::of(j), want, "2^{e}");
        }
        // Opposite and equal vectors, and the range's ends.
        let flat = |b: f64| Skew::of(jacobian::<F>([1.0, 0.0, b, 0.0])).angle;
        assert_eq!((flat(-2.0), flat(2.0)), (F::PI, F::ZERO));
        assert!(Skew::of(jacobian::<F>([INF, 0.0, 1.0, 0.0])).angle.is_nan());
        let half = F::HALF * F::PI;
        for (angle, ratio) in [(half, 2.0), (-half, 2.0), (-half, 4.0), (half, 4.0)] {
            let tilt = Skew { angle, ratio: F::from_f64(ratio) }.tilt();
            assert!(tilt > -half && tilt <= half, "{angle:?} {ratio}: {tilt:?}");
        }
    }
    test::<f32>([-100, -70, 70, 120]);
    test::<f64>([-900, -540, 540, 1000]);
}
