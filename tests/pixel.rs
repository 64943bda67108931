//! The footprint of a pixel and the weights of its texels: laws, references, bad input.
//!
//! References: tests/references/pixel_*.csv by pixel.py (mpmath). Errors are counted in u, half an ulp at 1;
//! every bound is the one that the kernel's page states.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/pixel.rs"]
mod pixel;
#[path = "support/references.rs"]
mod references;

use bellfit::bound::exact;
use bellfit::kernel::pixel::*;
use bellfit::kernel::real::Real;
use draw::Draw;
use pixel::*;
use references::{Reference, rows};
use std::f64::consts::PI;

/// A row of pixel_footprints.csv.
struct Case {
    j: [f64; 4],
    /// u, v and Q, plain and padded.
    point: Option<([f64; 2], [Reference; 2])>,
    /// major, minor, tilt, and padded major and minor.
    axes: [Reference; 5],
}

fn cases() -> Vec<Case> {
    let parse = |text: &String| Reference::parse(text).unwrap();
    let case = |row: [String; 13]| Case {
        j: [0, 1, 2, 3].map(|i| row[i].parse().unwrap()),
        point: row[4].parse().ok().map(|u| ([u, row[5].parse().unwrap()], [parse(&row[6]), parse(&row[7])])),
        axes: [8, 9, 10, 11, 12].map(|i| parse(&row[i])),
    };
    let cases: Vec<Case> = rows("pixel_footprints.csv").into_iter().map(case).collect();
    assert!(cases.len() > 130);
    cases
}

/// Against exact rationals, where the products agree to all but a few bits.
#[test]
fn cross_keeps_its_digits_where_the_products_cancel() {
    fn test<F: Real>(bound: f64) {
        let mut draw = Draw(30);
        for _ in 0..20_000 {
            let mut number = || F::from_f64(draw.real(-2.0, 2.0) * libm::exp2(draw.real(-20.0, 20.0)));
            let (a, b, c) = (number(), number(), number());
            let nudge = F::ONE + F::from_f64(draw.below(5) as f64 * 2.0 * unit::<F>());
            let d = b * c / a * nudge;
            let [ra, rb, rc, rd] = [a, b, c, d].map(|x| exact(x.to_f64()).unwrap());
            let want = ra * rd - rb * rc;
            let error = exact(F::cross(a, b, c, d).to_f64()).unwrap() - want.clone();
            let [error, size] = [error, want].map(|x| x.to_f64().value().abs());
            assert!(error <= bound * unit::<F>() * size, "{a:?} {b:?} {c:?} {d:?}: {error:e} of {size:e}");
        }
    }
    test::<f32>(1.0 + 1e-8);
    test::<f64>(2.0);
}

#[test]
fn the_inverse_keeps_q_at_any_aspect_and_scale() {
    fn test<F: Real>() -> (usize, f64) {
        let (mut count, mut worst) = (0, 0.0_f64);
        for Case { j, point, .. } in cases() {
            let Some(([u, v], qs)) = point else { continue };
            if !fits::<F>(&j) || !fits::<F>(&[u, v]) {
                continue;
            }
            for (padding, q) in [Padding::Plain, Padding::Padded].into_iter().zip(&qs) {
                // Q itself is to be a normal number: 1e-300 in double precision, 1e-36 in single.
                if q.to_f64() < if unit::<F>() < 1e-10 { 1e-290 } else { 1e-36 } {
                    continue;
                }
                let got = Inverse::of(jacobian::<F>(j), padding).q(F::from_f64(u), F::from_f64(v));
                let error = relative(q, got.to_f64()) / unit::<F>();
                assert!(error <= 12.0, "{j:?} at ({u:e}, {v:e}), {padding:?}: {error} u");
                (count, worst) = (count + 1, worst.max(error));
            }
        }
        (count, worst)
    }
    let (single, double) = (test::<f32>(), test::<f64>());
    println!("f32: {single:?}, f64: {double:?}");
    assert!(single.0 > 200 && double.0 > 240, "{single:?} {double:?}");
}

/// Single precision against double, whose range and digits are ample and were checked above.
#[test]
fn the_inverse_holds_to_the_ends_of_its_domain() {
    let (mut draw, mut count) = (Draw(36), [0; 2]);
    for _ in 0..20_000 {
        let (size, aspect) = (draw.real(-100.0, 99.0), libm::exp2(draw.real(0.0, 100.0)));
        let j = jacobian::<f32>(drawn(&mut draw, libm::exp2(size), aspect));
        let of = f64::from;
        let wide = Jacobian { ux: of(j.ux), vx: of(j.vx), uy: of(j.uy), vy: of(j.vy) };
        let largest = wide.ux.abs().max(wide.vx.abs()).max(wide.uy.abs()).max(wide.vy.abs());
        let (x, y) = (draw.real(-1.0, 1.0), draw.real(-1.0, 1.0));
        let (u, v) = ((wide.ux * x + wide.uy * y) as f32, (wide.vx * x + wide.vy * y) as f32);
        let long = wide.determinant().abs() < libm::exp2(-100.0) * largest * largest;
        for (kind, padding) in [Padding::Plain, Padding::Padded].into_iter().enumerate() {
            let want = Inverse::of(wide, padding).q(of(u), of(v));
            // Q and the larger terms in it normal numbers.
            if (padding == Padding::Plain && long) || !(1e-30..1e30).contains(&want) {
                continue;
            }
            let got = of(Inverse::of(j, padding).q(u, v));
            assert!(
                (got / want - 1.0).abs() <= 12.0 * unit::<f32>(),
                "{j:?} at ({u:e}, {v:e}), {padding:?}: {got:e}"
            );
            count[kind] += 1;
        }
    }
    assert!(count[0] > 5000 && count[1] > 5000, "{count:?}");
}

#[test]
fn the_footprint_loses_the_aspect_and_the_conic_its_square() {
    fn test<F: Real>() -> [f64; 3] {
        // Errors over u, u aspect and u aspect² for the three forms.
        let mut worst = [0.0_f64; 3];
        for Case { j, point, axes } in cases() {
            let Some(([u, v], [q, _])) = point else { continue };
            let (major, minor) = (axes[0].to_f64(), axes[1].to_f64());
            // Within the footprint's domain, near or in the ellipse.
            if !fits::<F>(&j) || !(1e-9..1e9).contains(&major) || major * minor < 1e-19 || q.to_f64() > 1.5 {
                continue;
            }
            let (at, aspect) = ((F::from_f64(u), F::from_f64(v)), major / minor);
            let inverse = Inverse::of(jacobian::<F>(j), Padding::Plain).q(at.0, at.1).to_f64();
            let footprint = Footprint::of(jacobian::<F>(j), Padding::Plain).q(at.0, at.1).to_f64();
            let conic = Conic::of(jacobian::<F>(j)).q(at.0, at.1).to_f64();
            let error = |x: f64| distance(&q, x) / unit::<F>();
            assert!(error(footprint) <= 16.0 * aspect, "{j:?}: {footprint} for {q:?}");
            for (worst, error) in worst.iter_mut().zip([
                error(inverse),
                error(footprint) / aspect,
                error(conic) / (aspect * aspect),
            ]) {
                *worst = worst.max(error);
            }
        }
        worst
    }
    for worst in [test::<f32>(), test::<f64>()] {
        println!("over u, u aspect, u aspect²: {worst:?}");
        // That the stated growth is met and not merely bounded: a tenth of a unit times it at least.
        assert!(worst[0] > 0.5 && worst[1] > 0.1 && worst[2] > 0.1, "{worst:?}");
        assert!(worst[2] <= 16.0, "{worst:?}");
    }
    // In figures: aspect 2e4 at 45°, single precision. (ux, vx) is on the ellipse.
    let j = Jacobian { ux: 100.0_f32, vx: 100.01, uy: 0.005, vy: -0.005 };
    let naive = Conic::of(j).q(j.ux, j.vx);
    assert!((naive - 1.0).abs() > 0.5, "{naive}");
    assert!((Inverse::of(j, Padding::Plain).q(j.ux, j.vx) - 1.0).abs() < 12.0 * unit::<f32>() as f32);
}

#[test]
fn the_padded_footprint_keeps_its_digits_by_its_own_aspect() {
    let mut draw = Draw(31);
    for _ in 0..2000 {
        let (major, aspect) = (libm::exp(draw.real(-8.0, 8.0)), libm::exp(draw.real(0.0, 20.0)));
        let j = jacobian::<f32>(drawn(&mut draw, major, aspect));
        let axes = Axes::of(j, Padding::Padded);
        let (x, y) = (draw.real(-1.0, 1.0), draw.real(-1.0, 1.0));
        let (u, v) = axes.frame().place(x, y);
        let wide =
            Jacobian { ux: f64::from(j.ux), vx: f64::from(j.vx), uy: f64::from(j.uy), vy: f64::from(j.vy) };
        // The double-precision inverse was checked against references above.
        let want = Inverse::of(wide, Padding::Padded).q(f64::from(u), f64::from(v));
        let got = f64::from(Footprint::of(j, Padding::Padded).q(u, v));
        let bound = 16.0 * unit::<f32>() * f64::from(axes.aspect()) * want.max(1.0);
        assert!((got - want).abs() <= bound, "{j:?} at ({u}, {v}): {got} for {want}");
    }
}

trait Place<F> {
    fn place(&self, a: f64, b: f64) -> (F, F);
}

impl Place<f32> for Frame<f32> {
    /// The point at fractions a, b of the semi-axes.
    fn place(&self, a: f64, b: f64) -> (f32, f32) {
        let (a, b) = (a as f32 * self.major, b as f32 * self.minor);
        (a * self.cos - b * self.sin, a * self.sin + b * self.cos)
    }
}

#[test]
fn axes_and_tilt_against_references() {
    fn test<F: Real>() -> (f64, f64) {
        let (mut axis, mut angle) = (0.0_f64, 0.0_f64);
        for Case { j, axes: want, .. } in cases() {
            if !fits::<F>(&j) {
                continue;
            }
            let (plain, padded) =
                (Axes::of(jacobian::<F>(j), Padding::Plain), Axes::of(jacobian::<F>(j), Padding::Padded));
            let largest = if unit::<F>() < 1e-10 { f64::MAX } else { f64::from(f32::MAX) };
            let least = if unit::<F>() < 1e-10 { f64::MIN_POSITIVE } else { f64::from(f32::MIN_POSITIVE) };
            let got = [plain.major, plain.minor, padded.major, padded.minor];
            for (got, want) in got.into_iter().zip([&want[0], &want[1], &want[3], &want[4]]) {
                let size = want.to_f64();
                assert!(size < largest, "no row reaches beyond the type");
                // A subnormal axis is within a spacing of the subnormals.
                let error = if size < least {
                    distance(want, got.to_f64()) / (2.0 * least * unit::<F>()) * 8.0
                } else {
                    relative(want, got.to_f64()) / unit::<F>()
                };
                assert!(error <= 8.0, "{j:?}: {got:?} for {size:e}, {error} u");
                axis = axis.max(if size < least { 0.0 } else { error });
            }
            // Modulo π: next to ±π/2 either is near.
            let off = (plain.tilt.to_f64() - want[2].to_f64()).abs();
            let error = off.min((PI - off).abs()) / (unit::<F>() * PI);
            assert!(error <= 6.0, "{j:?}: tilt {:?} for {}", plain.tilt, want[2].to_f64());
            assert_eq!(plain.tilt, padded.tilt);
            angle = angle.max(error);
        }
        (axis, angle)
    }
    println!("f32: {:?}, f64: {:?}", test::<f32>(), test::<f64>());
}

#[test]
fn the_tilt_is_in_its_range_and_zero_for_a_circle() {
    fn test<F: Real>() {
        let half = F::HALF * F::PI;
        let tilt = |j: [f64; 4]| Axes::of(jacobian::<F>(j), Padding::Plain).tilt;
        for (sign, other) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            assert_eq!(tilt([0.0, 3.0 * sign, 2.0 * other, 0.0]), half);
            assert_eq!(tilt([0.0, 2.0 * sign, 3.0 * other, 0.0]), F::ZERO);
            assert_eq!(tilt([3.0 * sign, 0.0, 0.0, 2.0 * other]), F::ZERO);
            assert_eq!(tilt([2.0 * sign, -0.0, 0.0, 3.0 * other]), half);
            // Circles: turned, and mirrored.
            for j in [[3.0, 4.0, -4.0, 3.0], [3.0, 4.0, 4.0, -3.0]] {
                let axes = Axes::of(jacobian::<F>(j.map(|x| x * sign)), Padding::Plain);
                assert_eq!((axes.major, axes.minor), (F::from_u32(5), F::from_u32(5)));
                assert_eq!(axes.tilt, F::ZERO);
            }
        }
        // Eight octants and the directions between, seen from every turn of the screen.
        for k in -16..=16 {
            let angle = f64::from(k) * PI / 16.0;
            for turn in 0..7 {
                let turn = f64::from(turn);
                let (c, s, ct, st) = (libm::cos(angle), libm::sin(angle), libm::cos(turn), libm::sin(turn));
                let (x, y) = ([3.0 * c, 3.0 * s], [-s, c]);
                let j = [
                    x[0] * ct + y[0] * st,
                    x[1] * ct + y[1] * st,
                    -x[0] * st + y[0] * ct,
                    -x[1] * st + y[1] * ct,
                ];
                let got = tilt(j);
                assert!(got > -half && got <= half, "{k}: {got:?}");
                let off = (got.to_f64() - angle) / PI;
                // J's own rounding turns the axis by as much again.
                assert!((off - libm::round(off)).abs() < 12.0 * unit::<F>(), "{k}, {turn}: {got:?}");
            }
        }
        let mut draw = Draw(32);
        for _ in 0..20_000 {
            // Small whole numbers meet the ends of the range often.
            let j = [0; 4].map(|_| draw.below(5) as f64 - 2.0);
            let got = tilt(j);
            assert!(got > -half && got <= half, "{j:?}: {got:?}");
        }
    }
    test::<f32>();
    test::<f64>();
}

/// Two ellipses are the same if their Q is, everywhere.
fn same(a: Jacobian<f64>, b: Jacobian<f64>, padding: Padding, draw: &mut Draw, tolerance: f64) {
    let (fa, fb) = (Inverse::of(a, padding), Inverse::of(b, padding));
    for _ in 0..4 {
        let (x, y) = (draw.real(-1.0, 1.0), draw.real(-1.0, 1.0));
        let (u, v) = (a.ux * x + a.uy * y, a.vx * x + a.vy * y);
        let (qa, qb) = (fa.q(u, v), fb.q(u, v));
        assert!((qa - qb).abs() <= tolerance * qa, "{a:?}, {b:?} at ({u}, {v}): {qa} and {qb}");
    }
}

#[test]
fn turning_and_mirroring_the_screen_leaves_the_ellipse() {
    let mut draw = Draw(33);
    for _ in 0..500 {
        let aspect = libm::exp(draw.real(0.0, 6.0));
        let j = jacobian::<f64>(drawn(&mut draw, 8.0, aspect));
        let angle = draw.real(-PI, PI);
        let (c, s) = (libm::cos(angle), libm::sin(angle));
        let turned = Jacobian {
            ux: j.ux * c + j.uy * s,
            vx: j.vx * c + j.vy * s,
            uy: j.uy * c - j.ux * s,
            vy: j.vy * c - j.vx * s,
        };
        let swapped = Jacobian { ux: j.uy, vx: j.vy, uy: j.ux, vy: j.vx };
        let mirrored = Jacobian { ux: -j.ux, vx: -j.vx, ..j };
        for padding in [Padding::Plain, Padding::Padded] {
            // Rounding J R moves the rim by u times the major axis; the exact changes leave no room but Q's.
            same(j, turned, padding, &mut draw, 64.0 * unit::<f64>() * aspect);
            same(j, swapped, padding, &mut draw, 24.0 * unit::<f64>());
            same(j, mirrored, padding, &mut draw, 24.0 * unit::<f64>());
            let of = |j| Footprint::of(j, padding);
            assert_eq!(of(j), of(mirrored));
            let (a, b) = (Axes::of(j, padding), Axes::of(swapped, padding));
            assert!((a.major / b.major - 1.0).abs() < 16.0 * unit::<f64>());
            assert!((a.minor / b.minor - 1.0).abs() < 16.0 * unit::<f64>());
        }
        assert!((turned.determinant() / j.determinant() - 1.0).abs() < 16.0 * unit::<f64>() * aspect);
        // Which product Kahan's form takes first may move the last bit.
        assert!((swapped.determinant() / j.determinant() + 1.0).abs() <= 4.0 * unit::<f64>());
    }
}

#[test]
fn the_ellipse_goes_through_both_derivatives_and_touches_its_box() {
    let mut draw = Draw(34);
    for _ in 0..500 {
        let aspect = libm::exp(draw.real(0.0, 6.0));
        let j = jacobian::<f64>(drawn(&mut draw, 8.0, aspect));
        let (conic, inverse) = (Conic::of(j), Inverse::of(j, Padding::Plain));
        for (u, v) in [(j.ux, j.vx), (j.uy, j.vy), (-j.ux, -j.vx)] {
            assert!((inverse.q(u, v) - 1.0).abs() <= 12.0 * unit::<f64>());
            assert!((conic.q(u, v) - 1.0).abs() <= 16.0 * unit::<f64>() * aspect * aspect);
        }
        // B² - 4 A C = -4 F, by Lagrange's identity; the left side cancels.
        let discriminant = conic.b * conic.b - 4.0 * conic.a * conic.c;
        // By count: 16 u A C from B, rounded beside √(A C), 24 u from 4 A C, and the difference.
        let room = 48.0 * unit::<f64>() * conic.a * conic.c;
        assert!((discriminant + 4.0 * conic.f).abs() <= room);
        for padding in [Padding::Plain, Padding::Padded] {
            let f = Footprint::of(j, padding);
            let (width, height) = f.bounds();
            // Where u is extreme v is u uv/uu, and a step outwards nothing is inside.
            let (v, u) = (width * f.uv / f.uu, height * f.uv / f.vv);
            let room = 64.0 * unit::<f64>() * aspect;
            assert!((f.q(width, v) - 1.0).abs() <= room && (f.q(u, height) - 1.0).abs() <= room);
            for _ in 0..8 {
                let (v, u) = (draw.real(-2.0, 2.0) * height, draw.real(-2.0, 2.0) * width);
                assert!(f.q(1.000_001 * width, v) > 1.0 && f.q(u, 1.000_001 * height) > 1.0);
            }
            // The same entries by the axes.
            let axes = Axes::of(j, padding);
            let along = Footprint::along(&axes.frame());
            for (a, b) in [(f.uu, along.uu), (f.uv, along.uv), (f.vv, along.vv)] {
                assert!((a - b).abs() <= 32.0 * unit::<f64>() * axes.major * axes.major);
            }
            assert!((f.determinant / along.determinant - 1.0).abs() <= 32.0 * unit::<f64>());
        }
    }
}

#[test]
fn axes_have_the_sum_and_the_product_of_the_jacobian() {
    let mut draw = Draw(35);
    for _ in 0..2000 {
        let aspect = libm::exp(draw.real(0.0, 30.0));
        let j = jacobian::<f64>(drawn(&mut draw, 8.0, aspect));
        let axes = Axes::of(j, Padding::Plain);
        let square = j.ux * j.ux + j.vx * j.vx + j.uy * j.uy + j.vy * j.vy;
        let close = |a: f64, b: f64| (a / b - 1.0).abs() <= 24.0 * unit::<f64>();
        assert!(close(axes.major * axes.major + axes.minor * axes.minor, square));
        assert!(close(axes.major * axes.minor, j.determinant().abs()));
        assert!(axes.minor <= axes.major);
        let padded = Axes::of(j, Padding::Padded);
        assert!(close(padded.major * padded.major, axes.major * axes.major + 1.0));
        // The semi-diameters lie between the axes.
        let (x, y) = j.lengths();
        assert!(x.max(y) <= axes.major * (1.0 + 1e-15) && x.min(y) >= axes.minor * (1.0 - 1e-15));
    }
}
