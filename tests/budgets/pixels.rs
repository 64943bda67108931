//! Evaluations of the pixel kernels.

use crate::exact::*;
use crate::references::{Reference, rows};
use crate::seen::Seen;
use crate::{Draw, pick, pick_log};
use bellfit::kernel::constants::{CLIP_MINIMAX, CUBIC_EXP};
use bellfit::kernel::pixel::{
    Axes, CLIP_PRINTED, ClipPolynomial, Conic, Footprint, Frame, Inverse, Jacobian, Padding, PaperReading,
    PixelWeight, Polygon, RADIUS, SIGMA, Skew, Tangent, TiltFormula, clip_volume, clip_volume_cut,
    clip_volume_paper, coverage, half_plane,
};
use bellfit::kernel::real::Real;
use bellfit::stability::{Clip, exact_q};
use std::f64::consts::PI;
use std::sync::OnceLock;

const PADDINGS: [Padding; 2] = [Padding::Plain, Padding::Padded];

/// A rotation times diag(major, minor) times a rotation, some mirrored; aspects to 100.
fn jacobian<F: Real>(draw: &mut Draw) -> (Jacobian<F>, f64) {
    let aspect = libm::exp(draw.real(0.0, libm::log(100.0)));
    let major = libm::exp(draw.real(-2.0, 3.0));
    let minor = major / aspect * if draw.below(2) == 0 { 1.0 } else { -1.0 };
    let (a, b) = (draw.real(-PI, PI), draw.real(-PI, PI));
    let ((ca, sa), (cb, sb)) = ((libm::cos(a), libm::sin(a)), (libm::cos(b), libm::sin(b)));
    let of = F::from_f64;
    let j = Jacobian {
        ux: of(ca * major * cb - sa * minor * sb),
        vx: of(sa * major * cb + ca * minor * sb),
        uy: of(-ca * major * sb - sa * minor * cb),
        vy: of(-sa * major * sb + ca * minor * cb),
    };
    (j, aspect)
}

fn words<F: Real>(j: Jacobian<F>) -> [f64; 4] {
    [j.ux, j.vx, j.uy, j.vy].map(F::to_f64)
}

fn exactly<F: Real>(j: Jacobian<F>) -> [Exact; 4] {
    words(j).map(number)
}

fn wide<F: Real>(j: Jacobian<F>) -> Jacobian<f64> {
    let [ux, vx, uy, vy] = words(j);
    Jacobian { ux, vx, uy, vy }
}

/// A point of the ellipse of J: J times one of the unit circle's.
fn point<F: Real>(draw: &mut Draw, j: Jacobian<F>) -> (F, F) {
    let (r, turn) = (libm::sqrt(draw.real(0.0, 0.98)), draw.real(-PI, PI));
    let (a, b, [ux, vx, uy, vy]) = (r * libm::cos(turn), r * libm::sin(turn), words(j));
    (F::from_f64(ux * a + uy * b), F::from_f64(vx * a + vy * b))
}

pub fn jacobian_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let ((j, _), s) = (jacobian::<F>(draw), pick::<F>(draw, 0.1, 3.0));
    let ([ux, vx, uy, vy], at) = (exactly(j), words(j));
    seen.relative(j.determinant(), ux * vy - uy * vx, &at);
    for (value, exact) in words(j.scaled(s)).into_iter().zip([ux, vx, uy, vy]) {
        seen.relative(F::from_f64(value), exact * x(s), &at);
    }
    let (first, second) = j.lengths();
    seen.relative(first, hypot(ux, vx), &at);
    seen.relative(second, hypot(uy, vy), &at);
}

struct Plane<F> {
    polygon: Polygon<F>,
    at: (F, F),
}

fn plane<F: Real>(draw: &mut Draw) -> Plane<F> {
    let mut row = |base: f64| [0.0, 0.0, base].map(|b| pick::<F>(draw, b - 1.0, b + 1.0));
    let polygon = Polygon { u: row(0.0), v: row(0.0), w: row(6.0) };
    Plane { polygon, at: (pick(draw, -1.0, 1.0), pick(draw, -1.0, 1.0)) }
}

/// a x + b y + c, and the sum of its terms' sizes.
fn line<F: Real>([a, b, c]: [F; 3], (sx, sy): (Exact, Exact)) -> (Exact, f64) {
    let (ax, by) = (x(a) * sx, x(b) * sy);
    (ax + by + x(c), (ax.abs() + by.abs() + x(c).abs()).to_f64())
}

/// The value u = top/w and its page's allowance: terms of the top, and of w times the value, over |w|.
fn quotient<F: Real>(top: [F; 3], below: [F; 3], at: (Exact, Exact)) -> (Exact, f64) {
    let ((top, t), (w, below)) = (line(top, at), line(below, at));
    let value = top / w;
    (value, (t + value.abs().to_f64() * below) / w.abs().to_f64())
}

pub fn polygon_at<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let Plane { polygon, at: (sx, sy) } = plane::<F>(draw);
    let (u, v) = polygon.at(sx, sy);
    for (value, top) in [(u, polygon.u), (v, polygon.v)] {
        let (exact, scale) = quotient(top, polygon.w, (x(sx), x(sy)));
        seen.of(value, exact, scale, &[sx.to_f64(), sy.to_f64()]);
    }
}

pub fn polygon_jacobian<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let Plane { polygon, at: (sx, sy) } = plane::<F>(draw);
    let j = polygon.jacobian(sx, sy);
    let (w, terms) = line(polygon.w, (x(sx), x(sy)));
    let [d, e, f] = polygon.w.map(x);
    for (top, along_x, along_y) in [(polygon.u, j.ux, j.uy), (polygon.v, j.vx, j.vy)] {
        let [a, b, c] = top.map(x);
        let (ae, af, bf) = (a * e - b * d, a * f - c * d, b * f - c * e);
        let square = w * w;
        for (value, first, second) in [(along_x, ae * x(sy), af), (along_y, -(ae * x(sx)), bf)] {
            let exact = (first + second) / square;
            let numerator = (first.abs() + second.abs()).to_f64() / square.to_f64();
            let scale = numerator + exact.abs().to_f64() * terms / w.abs().to_f64();
            seen.of(value, exact, scale, &[sx.to_f64(), sy.to_f64()]);
        }
    }
}

pub fn polygon_differences<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let Plane { polygon, at: (sx, sy) } = plane::<F>(draw);
    let j = polygon.differences(sx, sy);
    let here = (x(sx), x(sy));
    // x + 1 is the rounded one.
    let (right, below) = ((x(sx + F::ONE), x(sy)), (x(sx), x(sy + F::ONE)));
    for (top, along_x, along_y) in [(polygon.u, j.ux, j.uy), (polygon.v, j.vx, j.vy)] {
        let (start, lost) = quotient(top, polygon.w, here);
        for (value, place) in [(along_x, right), (along_y, below)] {
            let (end, too) = quotient(top, polygon.w, place);
            seen.of(value, end - start, lost + too, &[sx.to_f64(), sy.to_f64()]);
        }
    }
}

pub fn conic_of<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([ux, vx, uy, vy], at, conic) = (exactly(j), words(j), Conic::of(j));
    let (first, second) = (ux * vx, uy * vy);
    seen.relative(conic.a, vx * vx + vy * vy, &at);
    seen.of(conic.b, number(-2.0) * (first + second), 2.0 * (first.abs() + second.abs()).to_f64(), &at);
    seen.relative(conic.c, ux * ux + uy * uy, &at);
    let det = ux * vy - uy * vx;
    seen.relative(conic.f, det * det, &at);
}

/// The quotient as written, from the coefficients as they are.
pub fn conic_q<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ((u, v), conic) = (point(draw, j), Conic::of(j));
    let [a, b, c, f] = [conic.a, conic.b, conic.c, conic.f].map(x);
    let terms = [a * x(u) * x(u), b * x(u) * x(v), c * x(v) * x(v)];
    let size = terms.iter().map(|t| t.abs().to_f64()).sum::<f64>() / f.to_f64();
    seen.of(conic.q(u, v), (terms[0] + terms[1] + terms[2]) / f, size, &words(j));
}

pub fn footprint_of<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([ux, vx, uy, vy], at) = (exactly(j), words(j));
    let (uu, vv, det) = (ux * ux + uy * uy, vx * vx + vy * vy, ux * vy - uy * vx);
    for padding in PADDINGS {
        let pad = number(if padding == Padding::Padded { 1.0 } else { 0.0 });
        let footprint = Footprint::of(j, padding);
        seen.relative(footprint.uu, uu + pad, &at);
        seen.relative(footprint.vv, vv + pad, &at);
        let size = ((ux * vx).abs() + (uy * vy).abs()).to_f64();
        seen.of(footprint.uv, ux * vx + uy * vy, size, &at);
        seen.relative(footprint.determinant, det * det + pad * (uu + vv + pad), &at);
    }
}

fn frame<F: Real>(draw: &mut Draw) -> Frame<F> {
    let tilt = draw.real(-PI, PI);
    let major = draw.real(1.0, 8.0);
    let of = F::from_f64;
    Frame {
        cos: of(libm::cos(tilt)),
        sin: of(libm::sin(tilt)),
        major: of(major),
        minor: of(major * draw.real(0.1, 1.0)),
    }
}

fn words_of<F: Real>(frame: Frame<F>) -> [f64; 4] {
    [frame.cos, frame.sin, frame.major, frame.minor].map(F::to_f64)
}

pub fn frame_matrix<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let frame = frame::<F>(draw);
    let [c, s, major, minor] = words_of(frame).map(number);
    let (a, b) = (major * major, minor * minor);
    let exact = [a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c];
    let sizes = [exact[0].to_f64(), ((a + b) * (c * s).abs()).to_f64(), exact[2].to_f64()];
    let footprint = Footprint::along(&frame);
    for (i, value) in frame.matrix().into_iter().enumerate() {
        seen.of(value, exact[i], sizes[i], &words_of(frame));
    }
    for (i, value) in [footprint.uu, footprint.uv, footprint.vv].into_iter().enumerate() {
        seen.of(value, exact[i], sizes[i], &words_of(frame));
    }
    seen.relative(footprint.determinant, a * b, &words_of(frame));
}

pub fn frame_coordinates<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let frame = frame::<F>(draw);
    let [c, s, major, minor] = words_of(frame).map(number);
    let (u, v): (F, F) = (pick(draw, -4.0, 4.0), pick(draw, -4.0, 4.0));
    let (a, b) = frame.coordinates(u, v);
    let (uc, vs, vc, us) = (x(u) * c, x(v) * s, x(v) * c, x(u) * s);
    seen.of(a, (uc + vs) / major, ((uc.abs() + vs.abs()) / major).to_f64(), &words_of(frame));
    seen.of(b, (vc - us) / minor, ((vc.abs() + us.abs()) / minor).to_f64(), &words_of(frame));
}

/// bounds and row: from the matrix as it is.
pub fn footprint_row<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let footprint = Footprint::of(j, PADDINGS[draw.below(2)]);
    let [uu, uv, vv, det] = [footprint.uu, footprint.uv, footprint.vv, footprint.determinant].map(x);
    let ((width, height), at) = (footprint.bounds(), words(j));
    seen.relative(width, uu.sqrt(), &at);
    seen.relative(height, vv.sqrt(), &at);
    let v: F = pick(draw, -4.0, 4.0);
    let row = footprint.row(v);
    seen.relative(row.middle, x(v) * uv / vv, &at);
    seen.relative(row.least, x(v) * x(v) / vv, &at);
    seen.relative(row.curvature, vv / det, &at);
}

pub fn footprint_q<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, aspect) = jacobian::<F>(draw);
    let (u, v) = point(draw, j);
    for padding in PADDINGS {
        let exact = exact_q(wide(j), padding, (u.to_f64(), v.to_f64()));
        seen.of(Footprint::of(j, padding).q(u, v), exact, aspect, &words(j));
    }
}

fn inverse<F: Real>(draw: &mut Draw, seen: &mut Seen, padding: Padding) {
    let (j, _) = jacobian::<F>(draw);
    let (u, v) = point(draw, j);
    let exact = exact_q(wide(j), padding, (u.to_f64(), v.to_f64()));
    seen.relative(Inverse::of(j, padding).q(u, v), exact, &words(j));
}

pub fn inverse_plain<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    inverse::<F>(draw, seen, Padding::Plain);
}

pub fn inverse_padded<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    inverse::<F>(draw, seen, Padding::Padded);
}

/// Semi-axes by Blinn's sums.
fn axes_of(j: [Exact; 4]) -> [Exact; 3] {
    let [ux, vx, uy, vy] = j;
    let (e, f, g, h) = (ux + vy, ux - vy, vx + uy, vx - uy);
    let major = number(0.5) * (hypot(e, h) + hypot(f, g));
    let minor = (ux * vy - uy * vx).abs() / major;
    [major, minor, number(0.5) * (arctan2(g, f) + arctan2(h, e))]
}

/// a - b modulo π, in size.
fn apart(a: Exact, b: Exact) -> f64 {
    let turns = libm::round((a - b).to_f64() / PI);
    (a - b - number(turns) * Exact::pi()).abs().to_f64()
}

pub fn axes_lengths<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([major, minor, _], at) = (axes_of(exactly(j)), words(j));
    let axes = Axes::of(j, Padding::Plain);
    seen.relative(axes.major, major, &at);
    seen.relative(axes.minor, minor, &at);
    let (axes, one) = (Axes::of(j, Padding::Padded), number(1.0));
    seen.relative(axes.major, hypot(major, one), &at);
    seen.relative(axes.minor, hypot(minor, one), &at);
}

pub fn axes_tilt<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, aspect) = jacobian::<F>(draw);
    // A circle has no tilt.
    if aspect > 1.001 {
        let [_, _, tilt] = axes_of(exactly(j));
        seen.off(apart(x(Axes::of(j, Padding::Plain).tilt), tilt), PI, &words(j));
    }
}

/// The paper's lengths; its tilts have their own row. aspect, limited and frame: one operation each.
pub fn axes_simple<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([ux, vx, uy, vy], at) = (exactly(j), words(j));
    let axes = Axes::paper(j, TiltFormula::Vector);
    seen.relative(axes.major, hypot(ux, vx), &at);
    seen.relative(axes.minor, hypot(uy, vy), &at);
    seen.relative(axes.aspect(), x(axes.major) / x(axes.minor), &at);
    let most: F = pick(draw, 1.0, 16.0);
    let least = x(axes.major) / x(most);
    let limited = if least.to_f64() > axes.minor.to_f64() { least } else { x(axes.minor) };
    seen.relative(axes.limited(most).minor, limited, &at);
    let (frame, (sin, cos)) = (axes.frame(), turn(x(axes.tilt)));
    seen.of(frame.sin, sin, 1.0, &at);
    seen.of(frame.cos, cos, 1.0, &at);
}

pub fn tilt_formula<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([ux, vx, uy, vy], at) = (exactly(j), words(j));
    seen.of(TiltFormula::Vector.angle(j), arctan2(vx / ux, number(1.0)), 1.0, &at);
    let (a, b, c) = (vx * vx + vy * vy, number(-2.0) * (ux * vx + uy * vy), ux * ux + uy * uy);
    let exact = number(0.5) * arctan2(b / (a - c), number(1.0));
    // What A, B and C lose, through the slope of the arctangent.
    let (d, b, both) = ((a - c).to_f64(), b.to_f64(), (a + c).to_f64());
    let terms = 2.0 * ((ux * vx).abs() + (uy * vy).abs()).to_f64();
    let scale = 1.0 + (both * b.abs() + terms * d.abs()) / (d * d + b * b);
    seen.of(TiltFormula::Conic.angle(j), exact, scale, &at);
}

struct Texel {
    j: [f64; 4],
    padding: Padding,
    at: (f64, f64),
    area: Exact,
    /// None where no direction is nearest.
    half_plane: Option<Exact>,
}

/// tests/references/pixel_coverage.csv (mpmath).
fn texels() -> &'static [Texel] {
    static ROWS: OnceLock<Vec<Texel>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let row = |row: [String; 9]| {
            let number = |i: usize| row[i].parse::<f64>().expect("a number");
            let value = |i: usize| Reference::parse(&row[i]).map(|r| of_rational(&r.value));
            let padding = if row[4] == "padded" { Padding::Padded } else { Padding::Plain };
            let j = [number(0), number(1), number(2), number(3)];
            Texel {
                j,
                padding,
                at: (number(5), number(6)),
                area: value(7).expect("an area"),
                half_plane: value(8),
            }
        };
        rows::<9>("pixel_coverage.csv").into_iter().map(row).collect()
    })
}

/// A row as far as the type holds its arguments.
struct Drawn<F> {
    texel: &'static Texel,
    footprint: Footprint<F>,
    at: (F, F),
    axes: Axes<f64>,
}

fn texel<F: Real>(draw: &mut Draw) -> Option<Drawn<F>> {
    let texel = &texels()[draw.below(texels().len())];
    let (u, v) = texel.at;
    let holds = |value: f64| F::from_f64(value).to_f64() == value;
    if !(texel.j.into_iter().all(holds) && holds(u) && holds(v)) {
        return None;
    }
    let [ux, vx, uy, vy] = texel.j.map(F::from_f64);
    let j = Jacobian { ux, vx, uy, vy };
    let footprint = Footprint::of(j, texel.padding);
    let at = (F::from_f64(u), F::from_f64(v));
    Some(Drawn { texel, footprint, at, axes: Axes::of(wide(j), texel.padding) })
}

pub fn coverage_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let Some(Drawn { texel, footprint, at: (u, v), axes }) = texel::<F>(draw) else { return };
    seen.of(coverage(&footprint, u, v), texel.area, 1.0 + axes.major, &texel.j);
}

pub fn half_plane_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let Some(Drawn { texel, footprint, at: (u, v), axes }) = texel::<F>(draw) else { return };
    let (Some(exact), aspect) = (texel.half_plane, axes.aspect()) else { return };
    seen.of(half_plane(&footprint, u, v), exact, (1.0 + axes.major) * aspect * aspect, &texel.j);
}

/// The distance to the rim and the normal, by Q's gradient.
pub fn tangent_of<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, aspect) = jacobian::<F>(draw);
    let (u, v) = point(draw, j);
    let [ux, vx, uy, vy] = exactly(j);
    let (uu, uv, vv) = (ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy);
    let det = (ux * vy - uy * vx) * (ux * vy - uy * vx);
    let (gu, gv) = ((vv * x(u) - uv * x(v)) / det, (uu * x(v) - uv * x(u)) / det);
    let (root, size) = ((gu * x(u) + gv * x(v)).sqrt(), hypot(gu, gv));
    if root.to_f64() < 0.1 {
        return;
    }
    let tangent = Tangent::of(&Footprint::of(j, Padding::Plain), u, v);
    let (square, major) = (aspect * aspect, axes_of(exactly(j))[0].to_f64());
    seen.of(tangent.nu, gu / size, square / root.to_f64(), &words(j));
    seen.of(tangent.nv, gv / size, square / root.to_f64(), &words(j));
    let distance = (number(1.0) - root) * root / size;
    seen.of(tangent.distance, distance, square * major / root.to_f64(), &words(j));
}

/// The area of a unit square's part below a line, from the trapezium of the two heights where it crosses.
pub fn tangent_area<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let turn = draw.real(-PI, PI);
    let (nu, nv): (F, F) = (F::from_f64(libm::cos(turn)), F::from_f64(libm::sin(turn)));
    let distance: F = pick(draw, -0.75, 0.75);
    let (p, q, d) = (x(nu).abs(), x(nv).abs(), x(distance));
    let (a, b) = if p.to_f64() > q.to_f64() { (p, q) } else { (q, p) };
    // Along the larger component the line is at s(t) = (d - b t)/a, t across in [-½, ½]; the part inside is the
    // integral of s + ½ held to [0, 1]: of the ramp max(0, ·) less that of max(0, · - 1).
    let half = number(0.5);
    let ramp = |lo: Exact, hi: Exact| {
        // ∫ max(0, line) over a unit interval on which the line runs from lo to hi
        let (lo, hi) = if lo.to_f64() < hi.to_f64() { (lo, hi) } else { (hi, lo) };
        if lo.to_f64() >= 0.0 {
            half * (lo + hi)
        } else if hi.to_f64() <= 0.0 {
            number(0.0)
        } else {
            half * hi * hi / (hi - lo)
        }
    };
    let (first, last) = ((d + b * half) / a + half, (d - b * half) / a + half);
    let one = number(1.0);
    let exact = ramp(first, last) - ramp(first - one, last - one);
    let area = Tangent { distance, nu, nv }.area();
    seen.of(area, exact, 1.0, &[distance.to_f64(), nu.to_f64(), nv.to_f64()]);
}

pub fn clip<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (d, sigma): (F, F) = (pick(draw, 1e-3, 0.5), F::from_f64(SIGMA));
    let exact = Clip::Whole.exact(d.to_f64(), sigma.to_f64());
    let h = d.to_f64() / sigma.to_f64();
    let scale = exact.to_f64() * (4.0 + 3.0 * h * h);
    seen.of(clip_volume(d, sigma), exact, scale, &[d.to_f64()]);
}

pub fn clip_cut<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (d, sigma): (F, F) = (pick(draw, 1e-3, 0.499), F::from_f64(SIGMA));
    let exact = Clip::Cut.exact(d.to_f64(), sigma.to_f64());
    seen.of(clip_volume_cut(d, sigma, F::from_f64(RADIUS)), exact, 1.0, &[d.to_f64()]);
}

pub fn clip_paper<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let d: F = pick(draw, 0.0, 0.5);
    let [c0, c1, c2] = CLIP_PRINTED.map(number);
    let exact = c0 - x(d) * (c1 - c2 * x(d));
    let scale = (c0 + x(d) * (c1 + c2 * x(d))).to_f64();
    seen.of(clip_volume_paper(d), exact, scale, &[d.to_f64()]);
}

pub fn clip_polynomial<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (d, i): (F, _) = (pick(draw, 0.0, 0.5), draw.below(3));
    let [p0, p1, p2, p3] = CLIP_MINIMAX[i].map(number);
    let of = |d: Exact, [a, b, c, e]: [Exact; 4]| a + d * (b + d * (c + d * e));
    let scale = of(x(d), [p0.abs(), p1.abs(), p2.abs(), p3.abs()]).to_f64();
    seen.of(ClipPolynomial::ALL[i].at(d), of(x(d), [p0, p1, p2, p3]), scale, &[i as f64, d.to_f64()]);
}

pub fn skew_of<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (j, _) = jacobian::<F>(draw);
    let ([ux, vx, uy, vy], at, skew) = (exactly(j), words(j), Skew::of(j));
    seen.of(skew.angle, arctan2(ux * vy - uy * vx, ux * uy + vx * vy), PI, &at);
    seen.relative(skew.ratio, hypot(uy, vy) / hypot(ux, vx), &at);
}

fn skew<F: Real>(draw: &mut Draw) -> Skew<F> {
    let angle = draw.real(0.02, 0.98 * PI);
    Skew {
        angle: F::from_f64(if draw.below(2) == 0 { angle } else { -angle }),
        ratio: pick_log(draw, 0.1, 10.0),
    }
}

/// 1 + ρ² e^(2iφ), its parts and size.
fn circle<F: Real>(skew: Skew<F>) -> (Exact, Exact, Exact) {
    let (sin, cos) = turn(x(skew.angle));
    let (square, two) = (x(skew.ratio) * x(skew.ratio), number(2.0));
    let (re, im) = (number(1.0) + square * (number(1.0) - two * sin * sin), square * two * sin * cos);
    (re, im, hypot(re, im))
}

fn skew_major<F: Real>(skew: Skew<F>) -> Exact {
    let (_, _, size) = circle(skew);
    let longest = number(skew.ratio.to_f64().max(1.0));
    (number(0.5) * (number(1.0) + x(skew.ratio) * x(skew.ratio) + size)).sqrt() / longest
}

pub fn skew_axes<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let skew = skew::<F>(draw);
    let (at, major, (sin, _)) =
        ([skew.angle.to_f64(), skew.ratio.to_f64()], skew_major(skew), turn(x(skew.angle)));
    seen.relative(skew.major(), major, &at);
    seen.relative(skew.minor(), sin.abs() / major, &at);
    let axes = skew.axes();
    let ratio = skew.ratio.to_f64();
    seen.relative(axes.major, number(ratio.max(1.0)) * major, &at);
    seen.relative(axes.minor, number(ratio.min(1.0)) * sin.abs() / major, &at);
}

pub fn skew_simple<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let skew = skew::<F>(draw);
    let (at, (sin, cos)) = ([skew.angle.to_f64(), skew.ratio.to_f64()], turn(x(skew.angle)));
    seen.relative(skew.area(), number(1.0) / sin.abs(), &at);
    let j = skew.jacobian();
    seen.relative(j.uy, x(skew.ratio) * cos, &at);
    seen.relative(j.vy, x(skew.ratio) * sin, &at);
}

pub fn skew_tilt<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let skew = skew::<F>(draw);
    let (re, im, size) = circle(skew);
    let square = x(skew.ratio) * x(skew.ratio);
    // Of the parts' rounding what shows as an angle.
    let scale = ((number(1.0) + square) / size).to_f64();
    let exact = number(0.5) * arctan2(im, re);
    let at = [skew.angle.to_f64(), skew.ratio.to_f64()];
    seen.off(apart(x(skew.tilt()), exact), scale, &at);
    seen.off(apart(x(skew.axes().tilt), exact), scale, &at);
}

pub fn weight<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (aa, bb): (F, F) = (pick(draw, 0.0, 1.0), pick(draw, 0.0, 0.5));
    let sigma: F = pick(draw, 0.3, 0.6);
    let (q, one) = (x(aa) + x(bb), number(1.0));
    let t = q / (number(2.0) * x(sigma) * x(sigma));
    let reading = PaperReading::ALL[draw.below(4)];
    let c = number([1.0, 0.5625, 0.5, 0.125][reading as usize]);
    let eighth = |q: Exact| {
        let (value, slope) = lyon(8, number(8.0) * c * q);
        (value, 15.0 * value.to_f64() + 8.0 * (c * q).to_f64() * slope)
    };
    // The scale: what t's three roundings and those of the bell can move.
    let (weight, exact, scale) = match draw.below(6) {
        0 => {
            let exact = (-t).exp();
            (PixelWeight::Gaussian(sigma), exact, exact.to_f64() * (2.0 + 3.0 * t.to_f64()))
        }
        1 => {
            let (value, size) = eighth(q);
            (PixelWeight::Paper(reading), value, 2.0 * size)
        }
        2 => {
            let ((first, a), (second, b)) = (eighth(x(aa)), eighth(x(bb)));
            let scale = a * second.to_f64() + b * first.to_f64() + (first * second).to_f64();
            (PixelWeight::PaperProduct(reading), first * second, scale)
        }
        3 => (PixelWeight::Box, one, 1.0),
        4 => {
            let (value, slope) = lyon(16, t);
            (PixelWeight::Bell(16, sigma), value, 31.0 * value.to_f64() + 3.0 * t.to_f64() * slope)
        }
        _ => {
            let [c1, c2, c3] = CUBIC_EXP[1].map(number);
            let y = t / number(4.0);
            let p = one - y * (c1 - y * (c2 - y * c3));
            let value = if p.to_f64() > 0.0 { power(p, 4) } else { number(0.0) };
            // |t f'| ≤ ½ of what falls like e^-t: three times that, and the bell's own 4.
            (PixelWeight::Cubic(4, sigma), value, 5.5)
        }
    };
    let at = [aa.to_f64(), bb.to_f64(), sigma.to_f64()];
    seen.of(weight.at(aa, bb), exact, scale, &at);
}
