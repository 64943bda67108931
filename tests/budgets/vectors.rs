//! Evaluations of vectors and of importance sampling.

use crate::exact::*;
use crate::seen::Seen;
use crate::{Draw, pick, pick_log};
use bellfit::kernel::model::Model;
use bellfit::kernel::real::Real;
use bellfit::kernel::sampling::{
    Density, Measure, Profile, direction_about, pdf, peak, radial_pdf, sample, sample_versine,
};
use bellfit::kernel::vector;

/// A unit vector but for the rounding of its components.
pub fn unit<F: Real>(draw: &mut Draw) -> [F; 3] {
    let (z, turn) = (draw.real(-1.0, 1.0), draw.real(0.0, 2.0 * std::f64::consts::PI));
    let r = libm::sqrt(1.0 - z * z);
    [r * libm::cos(turn), r * libm::sin(turn), z].map(F::from_f64)
}

/// Components of any sign and size within 2^±10.
fn any<F: Real>(draw: &mut Draw) -> [F; 3] {
    [0; 3].map(|_| {
        let size: F = pick_log(draw, 1e-3, 1e3);
        if draw.below(2) == 0 { size } else { -size }
    })
}

fn doubles<F: Real>(vectors: &[[F; 3]]) -> Vec<f64> {
    vectors.iter().flatten().map(|component| component.to_f64()).collect()
}

pub fn dot_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (a, b) = (any::<F>(draw), any::<F>(draw));
    let size: f64 = (0..3).map(|i| (a[i].to_f64() * b[i].to_f64()).abs()).sum();
    seen.of(vector::dot(a, b), dot(vector(a), vector(b)), size, &doubles(&[a, b]));
}

/// scale, add and sub: one rounding a component.
pub fn componentwise<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (a, b, s) = (any::<F>(draw), any::<F>(draw), pick::<F>(draw, -3.0, 3.0));
    let at = doubles(&[a, b, [s; 3]]);
    let values = [vector::scale(s, a), vector::add(a, b), vector::sub(a, b)];
    let exact = [scale(x(s), vector(a)), add(vector(a), vector(b)), sub(vector(a), vector(b))];
    for (value, exact) in values.into_iter().flatten().zip(exact.into_iter().flatten()) {
        seen.relative(value, exact, &at);
    }
}

pub fn versine_between<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (a, b) = (unit::<F>(draw), unit::<F>(draw));
    let gap = sub(vector(a), vector(b));
    seen.relative(vector::versine_between(a, b), number(0.5) * dot(gap, gap), &doubles(&[a, b]));
}

pub fn normalize<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let v = any::<F>(draw);
    let exact = scale(number(1.0) / length(vector(v)), vector(v));
    for (value, exact) in vector::normalize(v).expect("a length").into_iter().zip(exact) {
        seen.relative(value, exact, &doubles(&[v]));
    }
}

pub fn reflect_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (l, n) = (any::<F>(draw), unit::<F>(draw));
    let size = 2.0 * length(vector(l)).to_f64();
    for (value, exact) in vector::reflect(l, n).into_iter().zip(reflect(vector(l), vector(n))) {
        seen.of(value, exact, size, &doubles(&[l, n]));
    }
}

pub fn half_vector<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (l, v) = (unit::<F>(draw), unit::<F>(draw));
    let sum = add(vector(l), vector(v));
    let size = length(sum);
    if size.to_f64() < 0.05 {
        return;
    }
    for (value, exact) in vector::half_vector(l, v).expect("a direction").into_iter().zip(sum) {
        seen.of(value, exact / size, 1.0 + 2.0 / size.to_f64(), &doubles(&[l, v]));
    }
}

pub fn basis_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let a = unit::<F>(draw);
    let (tangent, side) = vector::basis(a);
    let [t, s] = basis(vector(a));
    for (value, exact) in tangent.into_iter().zip(t).chain(side.into_iter().zip(s)) {
        seen.of(value, exact, 1.0, &doubles(&[a]));
    }
}

fn density(draw: &mut Draw) -> Density {
    let measure = [Measure::SolidAngle, Measure::Projected][draw.below(2)];
    Density { profile: Profile::ALL[draw.below(7)], measure }
}

/// ∫ f(1 - v)(1 - v)^m dv over 0 ≤ v ≤ min(w, where f ends), f = (1 - x v)^K or (1 - v)ⁿ, in closed form.
fn mass(density: Density, n: Exact, w: Exact) -> Exact {
    let one = number(1.0);
    let projected = density.measure == Measure::Projected;
    let Some(k) = density.profile.power() else {
        let m = n + number(if projected { 2.0 } else { 1.0 });
        return (one - real_power(one - w, m)) / m;
    };
    let ratio = n / number(f64::from(k));
    let b = one - ratio * w;
    let b = if b.to_f64() > 0.0 { b } else { number(0.0) };
    let (k1, k2) = (number(f64::from(k + 1)), number(f64::from(k + 2)));
    let first = (one - power(b, k + 1)) / k1;
    if !projected {
        return first / ratio;
    }
    // 1 - v = (x - 1 + b)/x, dv = -db/x
    ((ratio - one) * first + (one - power(b, k + 2)) / k2) / (ratio * ratio)
}

/// The whole of it: to v = 1, which cosⁿ approaches.
fn whole(density: Density, n: Exact) -> Exact {
    if density.profile.power().is_none() {
        let m = if density.measure == Measure::Projected { 2.0 } else { 1.0 };
        return number(1.0) / (n + number(m));
    }
    mass(density, n, number(1.0))
}

pub fn peak_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (density, n): (_, F) = (density(draw), pick_log(draw, 0.5, 1e4));
    let exact = number(1.0) / (number(2.0) * Exact::pi() * whole(density, x(n)));
    seen.relative(peak(density, n), exact, &[density.profile as u32 as f64, n.to_f64()]);
}

fn value(profile: Profile, n: Exact, w: Exact) -> (Exact, f64) {
    match profile.power() {
        Some(k) => {
            let (value, slope) = lyon(k, n * w);
            (value, f64::from(2 * k) * value.to_f64() + (n * w).to_f64() * slope)
        }
        None => {
            let exponent = n * w.log_one_minus();
            (exponent.exp(), exponent.exp().to_f64() * (2.0 + 3.0 * exponent.to_f64().abs()))
        }
    }
}

/// n and a versine inside the lobe.
fn inside<F: Real>(draw: &mut Draw) -> (F, F) {
    let n: F = pick_log(draw, 1.0, 1e4);
    (n, pick(draw, 0.0, (8.0 / n.to_f64()).min(0.9)))
}

pub fn profile<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (n, w) = inside::<F>(draw);
    let profile = Profile::ALL[draw.below(7)];
    let (exact, scale) = value(profile, x(n), x(w));
    seen.of(profile.value(w, n), exact, scale, &[profile as u32 as f64, n.to_f64(), w.to_f64()]);
}

fn radial(density: Density, n: Exact, w: Exact) -> (Exact, f64) {
    let (value, scale) = value(density.profile, n, w);
    let mut on_axis = number(1.0) / (number(2.0) * Exact::pi() * whole(density, n));
    if density.measure == Measure::Projected {
        on_axis = on_axis * (number(1.0) - w);
    }
    (on_axis * value, on_axis.to_f64() * (11.0 * value.to_f64() + scale))
}

pub fn radial_pdf_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let ((n, w), density) = (inside::<F>(draw), density(draw));
    let (exact, scale) = radial(density, x(n), x(w));
    seen.of(
        radial_pdf(density, n, w),
        exact,
        scale,
        &[density.profile as u32 as f64, n.to_f64(), w.to_f64()],
    );
}

/// The distribution function at the inverse, against u.
pub fn sample_versine_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (density, n, u): (_, F, F) = (density(draw), pick_log(draw, 0.5, 1e4), pick(draw, 0.0, 0.999));
    let w = sample_versine(density, n, u);
    let reached = mass(density, x(n), x(w)) / whole(density, x(n));
    seen.off((reached - x(u)).abs().to_f64(), 1.0, &[density.profile as u32 as f64, n.to_f64(), u.to_f64()]);
}

pub fn direction_about_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (axis, w, u) = (unit::<F>(draw), pick_log::<F>(draw, 1e-8, 1.0), pick::<F>(draw, 0.0, 0.5));
    let exact = direction(vector(axis), x(w), x(u));
    for (value, exact) in direction_about(axis, w, u).into_iter().zip(exact) {
        seen.of(value, exact, 1.0, &doubles(&[axis, [w, u, F::ZERO]]));
    }
}

/// L by the formulas from the versine that was drawn, which has its own row.
pub fn sample_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (model, profile) = (Model::ALL[draw.below(6)], Profile::ALL[draw.below(7)]);
    let (normal, view) = (unit::<F>(draw), unit::<F>(draw));
    let (n, u1, u2): (F, F, F) = (pick_log(draw, 0.5, 1e4), pick(draw, 0.0, 0.999), pick(draw, 0.0, 0.5));
    let Some(light) = sample(model, profile, n, normal, view, u1, u2) else { return };
    let w = x(sample_versine(Density::of(model, profile), n, u1));
    let exact = match model {
        Model::Phong | Model::PhongModified => {
            // The basis jumps where the axis lies across: its side is the rounded axis' own.
            let axis = reflect(vector(view), vector(normal));
            if axis[2].abs().to_f64() < 1e-3 {
                return;
            }
            direction(axis, w, x(u2))
        }
        _ => reflect(vector(view), direction(vector(normal), w, x(u2))),
    };
    for (value, exact) in light.into_iter().zip(exact) {
        seen.of(value, exact, 1.0, &doubles(&[normal, view, [n, u1, u2]]));
    }
}

pub fn pdf_<F: Real>(draw: &mut Draw, seen: &mut Seen) {
    let (model, profile) = (Model::ALL[draw.below(6)], Profile::ALL[draw.below(7)]);
    let [normal, view, light] = [0; 3].map(|_| unit::<F>(draw));
    let (n_v, n_l) = (dot(vector(normal), vector(view)), dot(vector(normal), vector(light)));
    if n_v.to_f64() < 0.01 || n_l.to_f64() < 0.01 {
        return;
    }
    let n: F = pick_log(draw, 1.0, 64.0);
    let density = Density::of(model, profile);
    let (near, to, jacobian) = match model {
        Model::Phong | Model::PhongModified => {
            (vector(light), reflect(vector(view), vector(normal)), number(1.0))
        }
        _ => {
            let sum = add(vector(light), vector(view));
            let half = scale(number(1.0) / length(sum), sum);
            (half, vector(normal), number(4.0) * dot(vector(view), half))
        }
    };
    let gap = sub(near, to);
    let w = number(0.5) * dot(gap, gap);
    if w.to_f64() >= 0.9 {
        return;
    }
    let (exact, _) = radial(density, x(n), w);
    // Relative to the peak: w is off by some u √w, the lobe by n times that.
    let (on_axis, _) = radial(density, x(n), number(0.0));
    let scale =
        (on_axis / jacobian).to_f64() * (1.0 + n.to_f64() * libm::sqrt(w.to_f64()) + 1.0 / jacobian.to_f64());
    let value = pdf(model, profile, n, normal, view, light);
    seen.of(value, exact / jacobian, scale, &doubles(&[normal, view, light]));
}
