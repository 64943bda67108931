//! Gauss-Newton steps to where the sum of squares is stationary, by QR.

use super::lobe::Lobe;
use super::points::Points;
use super::triangle::{System, Triangle};
use super::{Family, Shape};

/// A member of a family with its scale.
#[derive(Clone, Copy)]
pub(super) struct Member {
    pub(super) family: Family,
    pub(super) scale: f64,
    pub(super) u: f64,
    pub(super) shape: Shape,
}

/// Steps at most: their sizes fall by a constant factor, which is small where the residuals are.
const STEPS: usize = 60;
/// Halvings of a step that overshoots.
const HALVINGS: u32 = 8;

impl Member {
    /// n, an end of the range exactly where u is the logarithm of it.
    pub(super) fn n(&self) -> f64 {
        let (from, to) = self.family.exponents();
        let ends = [from, to].into_iter().find(|end| self.u == libm::log(*end));
        ends.unwrap_or_else(|| libm::exp(self.u).clamp(from, to))
    }

    pub(super) fn lobe(&self) -> Lobe {
        Lobe::new(self.family, self.n(), self.shape)
    }

    /// The weighted Jacobian by ln scale, ln n, α and β, beside the weighted residuals: every column has the size
    /// of the values, whatever their unit.
    pub(super) fn system(&self, points: &Points) -> System {
        let lobe = self.lobe();
        let parameters = self.family.parameters();
        let mut triangle = Triangle::new(parameters);
        for (w, l, v, q) in points.iter() {
            let root = q.sqrt();
            let (g, [by_n, by_linear, by_square]) = lobe.slopes(w, l);
            let a = root * self.scale;
            let residual = root * (v - self.scale * g);
            if parameters == 2 {
                triangle.push([a * g, a * by_n, residual]);
            } else {
                triangle.push([a * g, a * by_n, a * by_linear, a * by_square, residual]);
            }
        }
        triangle.solve()
    }

    /// The member a step away; `None` outside the family.
    fn moved(&self, step: &[f64], by: f64) -> Option<Member> {
        let part = |i: usize| step.get(i).map_or(0.0, |s| by * s);
        let shape = Shape { linear: self.shape.linear + part(2), square: self.shape.square + part(3) };
        let member =
            Member { family: self.family, scale: self.scale * (1.0 + part(0)), u: self.u + part(1), shape };
        let (from, to) = self.family.exponents();
        let is_inside = (libm::log(from)..=libm::log(to)).contains(&member.u);
        (member.scale > 0.0 && is_inside && (!self.family.is_free() || shape.falls())).then_some(member)
    }
}

/// The member after its last step that came nearer to a stationary point without rising, and its system there.
pub(super) fn polish(points: &Points, start: Member) -> (Member, System) {
    let mut best = start;
    let mut system = best.system(points);
    for _ in 0..STEPS {
        let Some(step) = system.step() else { break };
        let (along, length) = (system.along(), libm::hypot(system.along(), system.rest));
        let next = (0..=HALVINGS).find_map(|half| {
            let member = best.moved(&step, libm::exp2(-f64::from(half)))?;
            let next = member.system(points);
            // A sum of N squares is itself rounded.
            let rises = libm::hypot(next.along(), next.rest) > length * (1.0 + 1e-10);
            (next.along() < along && !rises).then_some((member, next))
        });
        let Some((member, found)) = next else { break };
        (best, system) = (member, found);
    }
    (best, system)
}
