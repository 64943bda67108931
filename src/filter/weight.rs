//! Pixel weights with their constants folded in, for loops over lanes.

use crate::kernel::constants::CUBIC_EXP;
use crate::kernel::pixel::PixelWeight;

/// A weight that depends on Q alone. Q may be anything; beyond 1 the result is not used.
pub(super) trait LaneWeight: Copy {
    fn at(self, q: f32) -> f32;
}

/// max(1 - q (k₁ - q (k₂ - q k₃)), 0) to the power 2^S: the cubic bell, and with k₂ = k₃ = 0 Lyon's bell.
#[derive(Clone, Copy)]
pub(super) struct Cubic<const S: u32>(pub [f32; 3]);

impl<const S: u32> LaneWeight for Cubic<S> {
    #[inline(always)]
    fn at(self, q: f32) -> f32 {
        let [k1, k2, k3] = self.0;
        power::<S>(1.0 - q * (k1 - q * (k2 - q * k3)))
    }
}

/// max(1 - k q, 0) to the power 2^S.
#[derive(Clone, Copy)]
pub(super) struct Line<const S: u32>(pub f32);

impl<const S: u32> LaneWeight for Line<S> {
    #[inline(always)]
    fn at(self, q: f32) -> f32 {
        power::<S>(1.0 - q * self.0)
    }
}

#[inline(always)]
fn power<const S: u32>(base: f32) -> f32 {
    // The inherent `max`, one instruction: a NaN would be dropped afterwards anyway.
    let mut power = base.max(0.0);
    for _ in 0..S {
        power *= power;
    }
    power
}

/// 1.
#[derive(Clone, Copy)]
pub(super) struct One;

impl LaneWeight for One {
    #[inline(always)]
    fn at(self, _: f32) -> f32 {
        1.0
    }
}

/// exp(-q/(2σ²)) as 2^(-q k), k = 1/(2σ² ln 2).
#[derive(Clone, Copy)]
pub(super) struct Gaussian(pub f32);

impl LaneWeight for Gaussian {
    #[inline(always)]
    fn at(self, q: f32) -> f32 {
        exp2(-q * self.0)
    }
}

/// 2ˣ for x ≤ 0 without branches; 0 below -126.
#[inline(always)]
pub(super) fn exp2(x: f32) -> f32 {
    /// Adding it leaves the nearest whole number in the last bits.
    const ROUND: f32 = 12_582_912.0;
    let x = x.max(-126.0);
    let shifted = x + ROUND;
    let f = x - (shifted - ROUND);
    let p = EXP2.iter().rev().fold(0.0, |sum, c| sum * f + c);
    // The whole number, at most 0 and at least -126, into the exponent.
    let bits = shifted.to_bits().wrapping_sub(ROUND.to_bits()).wrapping_add(127) << 23;
    p * f32::from_bits(bits)
}

/// 2ᶠ for |f| ≤ ½: minimax in the relative error with p(0) = 1, within 1.6e-8 as rounded to `f32`.
const EXP2: [f32; 7] = [
    1.0,
    0.6931471824645996,
    0.24022647738456726,
    0.055503323674201965,
    0.00961843691766262,
    0.001339887734502554,
    0.00015353370690718293,
];

/// The constants of a weight, computed once a sampler: c₁ s, c₂ s² and c₃ s³ of a cubic bell, s = 1/(2σ² K);
/// of others the one factor of q, first.
pub(super) fn constants(weight: PixelWeight<f32>) -> [f32; 3] {
    let scale = |power: u32, sigma: f32| {
        let sigma = f64::from(sigma);
        1.0 / (2.0 * sigma * sigma * f64::from(power))
    };
    match weight {
        PixelWeight::Gaussian(sigma) => [(scale(1, sigma) / std::f64::consts::LN_2) as f32, 0.0, 0.0],
        PixelWeight::Paper(reading) | PixelWeight::PaperProduct(reading) => [reading.scale(), 0.0, 0.0],
        PixelWeight::Box => [0.0; 3],
        PixelWeight::Bell(power, sigma) => [scale(power, sigma) as f32, 0.0, 0.0],
        PixelWeight::Cubic(power, sigma) => {
            let [c1, c2, c3] = CUBIC_EXP[power.trailing_zeros() as usize - 1];
            let s = scale(power, sigma);
            [(c1 * s) as f32, (c2 * s * s) as f32, (c3 * s * s * s) as f32]
        }
    }
}

/// Calls `$then` with the folded form of a radial weight bound to `$weight`; a product or a power that is
/// not listed gives `$otherwise`.
macro_rules! with_lane_weight {
    ($of:expr, $k:expr, $weight:ident => $then:expr, else $otherwise:expr) => {{
        use $crate::filter::weight::{Cubic, Gaussian, Line, One};
        use $crate::kernel::pixel::PixelWeight as Of;
        macro_rules! with {
            ($value:expr) => {{
                let $weight = $value;
                $then
            }};
        }
        match $of {
            Of::Gaussian(_) => with!(Gaussian($k[0])),
            Of::Box => with!(One),
            Of::Bell(2, _) => with!(Line::<1>($k[0])),
            Of::Bell(4, _) => with!(Line::<2>($k[0])),
            Of::Bell(8, _) | Of::Paper(_) => with!(Line::<3>($k[0])),
            Of::Bell(16, _) => with!(Line::<4>($k[0])),
            Of::Bell(32, _) => with!(Line::<5>($k[0])),
            Of::Bell(64, _) => with!(Line::<6>($k[0])),
            Of::Cubic(2, _) => with!(Cubic::<1>($k)),
            Of::Cubic(4, _) => with!(Cubic::<2>($k)),
            Of::Cubic(8, _) => with!(Cubic::<3>($k)),
            Of::PaperProduct(_) | Of::Bell(..) | Of::Cubic(..) => $otherwise,
        }
    }};
}
pub(super) use with_lane_weight;

#[cfg(test)]
mod tests {
    use super::{Gaussian, LaneWeight, constants, exp2};
    use crate::kernel::pixel::PixelWeight;

    /// Largest relative error of 2^-x over every `step`-th float from 2⁻²⁶ to 126, against libm in double
    /// precision.
    fn largest(step: usize) -> f64 {
        let (from, to) = ((1.0_f32 / (1 << 26) as f32).to_bits(), 126.0_f32.to_bits());
        let error = |bits: u32| {
            let x = f32::from_bits(bits);
            let truth = libm::exp2(-f64::from(x));
            (f64::from(exp2(-x)) / truth - 1.0).abs()
        };
        (from..=to).step_by(step).map(error).fold(0.0, f64::max)
    }

    #[test]
    fn exp2_is_within_its_bound() {
        // 1.6e-8 of the polynomial, and 1.5 u at most of Horner's last steps.
        assert!(largest(101) < 1.3e-7);
        assert_eq!((exp2(0.0), exp2(-1.0), exp2(-126.0)), (1.0, 0.5, f32::MIN_POSITIVE));
    }

    /// All 277 million.
    #[test]
    #[ignore = "takes some seconds"]
    fn exp2_is_within_its_bound_at_every_float() {
        let error = largest(1);
        assert!(error < 1.3e-7, "{error:e}");
    }

    #[test]
    fn the_gaussian_is_exp() {
        for sigma in [0.2_f32, 1.0 / 3.0, 1.0] {
            let weight = Gaussian(constants(PixelWeight::Gaussian(sigma))[0]);
            for i in 0..=1000 {
                let q = i as f32 / 1000.0;
                let truth = PixelWeight::Gaussian(f64::from(sigma)).at(f64::from(q), 0.0);
                // The exponent t is rounded three times, the power as above; t e^-t ≤ 0.37.
                let bound = 1.8e-7 * truth * (1.0 + libm::log(1.0 / truth));
                assert!((f64::from(weight.at(q)) - truth).abs() <= bound, "σ = {sigma}, q = {q}");
            }
        }
    }
}
