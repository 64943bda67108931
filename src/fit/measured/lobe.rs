//! One member of a family, ready to be evaluated at many samples.

use super::{Family, Shape};

/// A lobe with what depends on its parameters alone computed.
pub(super) enum Lobe {
    Power { n: f64 },
    Gaussian { n: f64 },
    Schlick { n: f64 },
    Bell(Bell),
}

/// p^K, p = 1 - w (k₁ - w (k₂ - w k₃)) up to its first zero.
pub(super) struct Bell {
    squarings: u32,
    reach: f64,
    horner: [f64; 3],
    /// k₁, k₂, k₃ differentiated by ln n, α and β.
    slopes: [[f64; 3]; 3],
}

impl Lobe {
    pub(super) fn new(family: Family, n: f64, shape: Shape) -> Self {
        match family {
            Family::CosN => Lobe::Power { n },
            Family::SphericalGaussian => Lobe::Gaussian { n },
            Family::Schlick => Lobe::Schlick { n },
            Family::Free2 => Lobe::Bell(Bell::free(2, n, shape)),
            Family::Free4 => Lobe::Bell(Bell::free(4, n, shape)),
            Family::Free8 => Lobe::Bell(Bell::free(8, n, shape)),
            _ => match family.stand_in().formula() {
                Some(formula) => {
                    let (reach, linear, square) = formula.at(n);
                    // With m = 1/n, d/d ln n = -m d/dm; of s = n/T(m) that is s (1 + m T'/T).
                    let m = 1.0 / n;
                    let down = |[_, b, c]: [f64; 3]| -m * (b + 2.0 * m * c);
                    let s = n / reach;
                    let slope = s * (1.0 - down(formula.reach) / reach);
                    let shape = Shape { linear, square };
                    let by_n = (slope, down(formula.linear), down(formula.square));
                    Lobe::Bell(Bell::new(formula.power, s, shape, [by_n, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)]))
                }
                // The three without a formula stand above.
                None => Lobe::Power { n: f64::NAN },
            },
        }
    }

    /// g at the versine; `ln_cos` is ln(1 - w), computed once a sample.
    #[inline]
    pub(super) fn value(&self, versine: f64, ln_cos: f64) -> f64 {
        match self {
            Lobe::Power { n } => libm::exp(n * ln_cos),
            Lobe::Gaussian { n } => libm::exp(-(n * versine)),
            Lobe::Schlick { n } => {
                let cos = 1.0 - versine;
                cos / (cos + n * versine)
            }
            Lobe::Bell(bell) => bell.value(versine),
        }
    }

    /// g, and its derivatives by ln n, α and β.
    #[inline]
    pub(super) fn slopes(&self, versine: f64, ln_cos: f64) -> (f64, [f64; 3]) {
        match self {
            Lobe::Power { n } => {
                let value = libm::exp(n * ln_cos);
                // At w = 1 the value is 0 and the logarithm infinite.
                (value, [if value > 0.0 { n * ln_cos * value } else { 0.0 }, 0.0, 0.0])
            }
            Lobe::Gaussian { n } => {
                let value = libm::exp(-(n * versine));
                (value, [-(n * versine) * value, 0.0, 0.0])
            }
            Lobe::Schlick { n } => {
                let cos = 1.0 - versine;
                let under = cos + n * versine;
                (cos / under, [-(n * versine / under) * (cos / under), 0.0, 0.0])
            }
            Lobe::Bell(bell) => bell.slopes(versine),
        }
    }

    /// k₁, k₂, k₃ of a bell and where it ends.
    pub(super) fn bell(&self) -> Option<([f64; 3], f64)> {
        match self {
            Lobe::Bell(bell) => Some((bell.horner, bell.reach)),
            _ => None,
        }
    }
}

impl Bell {
    /// y = s w, and s, α, β differentiated by each of the three parameters.
    fn new(power: u32, s: f64, shape: Shape, by: [(f64, f64, f64); 3]) -> Self {
        let Shape { linear, square } = shape;
        let slopes = by.map(|(ds, da, db)| {
            [
                (1.0 - linear) * ds - da * s,
                (db - da) * s * s + 2.0 * (square - linear) * s * ds,
                db * s * s * s + 3.0 * square * s * s * ds,
            ]
        });
        let horner = [(1.0 - linear) * s, (square - linear) * s * s, square * s * s * s];
        Bell { squarings: power.trailing_zeros(), reach: 1.0 / s, horner, slopes }
    }

    /// s = n/(K (1 - α)), so that the lobe falls from its peak as e^(-n w) does.
    fn free(power: u32, n: f64, shape: Shape) -> Self {
        let left = 1.0 - shape.linear;
        let s = n / (f64::from(power) * left);
        Self::new(power, s, shape, [(s, 0.0, 0.0), (s / left, 1.0, 0.0), (0.0, 0.0, 1.0)])
    }

    #[inline]
    fn base(&self, w: f64) -> f64 {
        let [k1, k2, k3] = self.horner;
        if w < self.reach { (1.0 - w * (k1 - w * (k2 - w * k3))).max(0.0) } else { 0.0 }
    }

    #[inline]
    fn value(&self, w: f64) -> f64 {
        let mut power = self.base(w);
        for _ in 0..self.squarings {
            power *= power;
        }
        power
    }

    #[inline]
    fn slopes(&self, w: f64) -> (f64, [f64; 3]) {
        let base = self.base(w);
        // p^K and p^(K - 1) = p^(K/2) p^(K/4) ⋯ p
        let (mut power, mut less) = (base, 1.0);
        for _ in 0..self.squarings {
            less *= power;
            power *= power;
        }
        let outer = f64::from(1_u32 << self.squarings) * less;
        (power, self.slopes.map(|[k1, k2, k3]| -outer * w * (k1 - w * (k2 - w * k3))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lobes are the kernels': a few roundings of p apart, raised to the power.
    #[test]
    fn the_lobes_are_the_kernels() {
        for family in Family::ALL.into_iter().filter(|family| !family.is_free()) {
            for n in [16.0, 40.5, 1000.0, 1e6] {
                for i in 0..200 {
                    let w = f64::from(i) * 0.1 / n;
                    let kernel = family.stand_in().at_versine(w.min(1.0), n);
                    let own = family.value(w.min(1.0), n, Shape::default());
                    assert!((own - kernel).abs() <= 1e-14, "{family} {n} {w}: {own} {kernel}");
                }
            }
        }
    }

    /// A cubic bell is a free one with its shape, whose n is the slope at the peak: K (1 - α) s.
    #[test]
    fn a_free_bell_holds_the_adopted_one() {
        for (free, cubic) in [
            (Family::Free2, Family::Cubic2),
            (Family::Free4, Family::Cubic4),
            (Family::Free8, Family::Cubic8),
        ] {
            let formula = cubic.stand_in().formula().unwrap();
            let (reach, linear, square) = formula.at(50.0);
            let n = f64::from(formula.power) * (1.0 - linear) * 50.0 / reach;
            for i in 0..300 {
                let w = f64::from(i) * 1e-3;
                let [own, other] =
                    [free.value(w, n, Shape { linear, square }), cubic.value(w, 50.0, Shape::default())];
                assert!((own - other).abs() < 1e-14, "{free} {w}: {own} {other}");
            }
        }
    }
}
