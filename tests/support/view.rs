//! A surface seen at an angle, with coordinates for what a model draws, and quadrature over them.
#![allow(dead_code)] // every test file uses its part

use super::draw::Draw;
use bellfit::kernel::model::Model;
use bellfit::kernel::sampling::{Profile, sample};
use bellfit::kernel::vector::{Vec3, dot};
use std::f64::consts::PI;

/// Along the normal, aslant, grazing.
pub const ANGLES: [f64; 3] = [0.0, 45.0 * PI / 180.0, 80.0 * PI / 180.0];

/// a x + b y.
pub fn mix(a: f64, x: Vec3<f64>, b: f64, y: Vec3<f64>) -> Vec3<f64> {
    [0, 1, 2].map(|i| a * x[i] + b * y[i])
}

/// A view of a surface, with coordinates of its own: (w, φ) of the direction that a model draws, about the
/// model's axis, φ from the plane of N and V.
#[derive(Clone, Copy)]
pub struct View {
    pub model: Model,
    pub cos: f64,
    pub sin: f64,
    pub normal: Vec3<f64>,
    pub to_view: Vec3<f64>,
    /// Across N, on V's side.
    pub along: Vec3<f64>,
    /// R or N.
    pub axis: Vec3<f64>,
    /// Across the axis: φ = 0.
    pub forth: Vec3<f64>,
    /// φ = π/2.
    pub side: Vec3<f64>,
}

impl View {
    /// N = (2, -3, 6)/7, and V at `angle` from it towards (3, 6, 2)/7, which with (6, -2, -3)/7 make an
    /// orthonormal matrix.
    pub fn new(model: Model, angle: f64) -> Self {
        let normal = [2.0, -3.0, 6.0].map(|x| x / 7.0);
        let along = [3.0, 6.0, 2.0].map(|x| x / 7.0);
        let side = [6.0, -2.0, -3.0].map(|x| x / 7.0);
        let (cos, sin) = (libm::cos(angle), libm::sin(angle));
        let to_view = mix(cos, normal, sin, along);
        // R = cos N - sin e, and across it cos e + sin N, on N's side.
        let (axis, forth) = if about_normal(model) {
            (normal, along)
        } else {
            (mix(cos, normal, -sin, along), mix(cos, along, sin, normal))
        };
        View { model, cos, sin, normal, to_view, along, axis, forth, side }
    }

    /// L at the coordinates, and dω of L over dw dφ.
    pub fn light(&self, w: f64, phi: f64) -> (Vec3<f64>, f64) {
        let across = mix(libm::cos(phi), self.forth, libm::sin(phi), self.side);
        let drawn = mix(1.0 - w, self.axis, libm::sqrt(w * (2.0 - w)), across);
        if !about_normal(self.model) {
            return (drawn, 1.0);
        }
        let v_h = dot(self.to_view, drawn);
        (mix(2.0 * v_h, drawn, -1.0, self.to_view), 4.0 * v_h)
    }

    /// The coordinates of L.
    pub fn of(&self, light: Vec3<f64>) -> (f64, f64) {
        let mut drawn = light;
        if about_normal(self.model) {
            let sum = mix(1.0, light, 1.0, self.to_view);
            drawn = sum.map(|x| x / libm::sqrt(dot(sum, sum)));
        }
        let gap = mix(1.0, drawn, -1.0, self.axis);
        (dot(gap, gap) / 2.0, libm::atan2(dot(drawn, self.side), dot(drawn, self.forth)))
    }

    /// The φ below which L is above the horizon, from N·L = 0: with c = 1 - w and s = sin γ, N·L is
    /// c cos + s sin cos φ about R, and 2c (c cos + s sin cos φ) - cos about N.
    pub fn horizon(&self, w: f64) -> f64 {
        let (c, s) = (1.0 - w, libm::sqrt(w * (2.0 - w)));
        let level =
            if about_normal(self.model) { self.cos * (1.0 - 2.0 * c * c) / (2.0 * c) } else { -c * self.cos };
        // 0/0 at the pole of an upright view, where every φ is above.
        let ratio = if level < 0.0 && s * self.sin == 0.0 { -1.0 } else { level / (s * self.sin) };
        libm::acos(ratio.clamp(-1.0, 1.0))
    }

    /// ∫ integrand(L) dω over a cell, as far as it is above the horizon.
    pub fn integrate(&self, w: [f64; 2], phi: [f64; 2], integrand: impl Fn(Vec3<f64>) -> f64) -> f64 {
        gauss(w, 6, |w| {
            let horizon = self.horizon(w);
            let (lo, hi) = (phi[0].max(-horizon), phi[1].min(horizon));
            if lo >= hi {
                return 0.0;
            }
            gauss([lo, hi], 1, |phi| {
                let (light, jacobian) = self.light(w, phi);
                integrand(light) * jacobian
            })
        })
    }

    /// The same over all of the hemisphere about the axis, in `n`'s scale.
    pub fn integrate_all(&self, n: f64, integrand: impl Fn(Vec3<f64>) -> f64) -> f64 {
        let cells = edges(n).windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>();
        let quarters = [-2.0, -1.0, 0.0, 1.0].map(|k| [k * PI / 2.0, (k + 1.0) * PI / 2.0]);
        let cell = |&w: &[f64; 2]| quarters.map(|phi| self.integrate(w, phi, &integrand)).iter().sum::<f64>();
        cells.iter().map(cell).sum()
    }
}

/// Whether the model draws the half vector, about N, rather than L about R.
pub fn about_normal(model: Model) -> bool {
    !matches!(model, Model::Phong | Model::PhongModified)
}

/// ∫ f over [lo, hi], Gauss-Legendre with 5 nodes in each of `panels`: the roots of the fifth Legendre
/// polynomial and their weights, in radicals.
pub fn gauss([lo, hi]: [f64; 2], panels: usize, f: impl Fn(f64) -> f64) -> f64 {
    let root = |sign: f64| libm::sqrt(5.0 + sign * 2.0 * libm::sqrt(10.0 / 7.0)) / 3.0;
    let weight = |sign: f64| (322.0 + sign * 13.0 * libm::sqrt(70.0)) / 900.0;
    let (inner, outer) = (root(-1.0), root(1.0));
    let rule = [
        (0.0, 128.0 / 225.0),
        (inner, weight(1.0)),
        (-inner, weight(1.0)),
        (outer, weight(-1.0)),
        (-outer, weight(-1.0)),
    ];
    let h = (hi - lo) / (2 * panels) as f64;
    let panel = |i: usize| {
        let middle = lo + (2 * i + 1) as f64 * h;
        rule.iter().map(|&(x, weight)| weight * f(middle + h * x)).sum::<f64>() * h
    };
    (0..panels).map(panel).sum()
}

/// Cells' edges in w, 0 to 1, in n's scale: steps of a twelfth in (1 - w)^(n + 2), and doublings of w
/// over the last of them, so that the density is smooth in every ring.
pub fn edges(n: f64) -> Vec<f64> {
    let step = |j: u32| 1.0 - libm::pow(1.0 - f64::from(j) / 12.0, 1.0 / (n + 2.0));
    let mut edges: Vec<f64> = (0..12).map(step).collect();
    while edges[edges.len() - 1] < 0.5 {
        edges.push(2.0 * edges[edges.len() - 1]);
    }
    // Where the horizon lies for half vectors, seen along the normal: a step of the integrand.
    edges.extend([1.0 - libm::sqrt(0.5), 1.0]);
    edges.sort_by(f64::total_cmp);
    edges
}

/// What the sampler gives for random pairs; `None` below the horizon.
pub fn drawn(view: &View, profile: Profile, n: f64, seed: u64, count: usize) -> Vec<Option<Vec3<f64>>> {
    let mut draw = Draw(seed);
    let mut one = || {
        let (u1, u2) = (draw.real(0.0, 1.0), draw.real(0.0, 1.0));
        sample(view.model, profile, n, view.normal, view.to_view, u1, u2)
    };
    (0..count).map(|_| one()).collect()
}
