//! The two types of lanes, with the steps on their bits that the lanes' elementary functions need.

use super::power;
use crate::kernel::real::Real;

/// `f32` or `f64` as the lane of a loop. Every function is without branches and inlined, so that a loop over
/// it becomes a loop over vectors.
pub trait Lanes: Real {
    /// 1.5 · 2ᵐ, m the bits of the significand: adding it rounds to a whole number and leaves that in the last
    /// bits.
    const ROUND: Self;
    /// [`Self::ROUND`] and the exponent's bias more: the last bits are those of a power of two.
    const ROUND_BIASED: Self;
    /// The least normal number.
    const LEAST: Self;
    /// 2ᵐ⁺¹, which makes a subnormal number normal, and m + 1.
    const LIFT: [Self; 2];
    /// The whole exponents that the type's normal numbers have, and one more at the upper end.
    const EXPONENTS: [Self; 2];
    /// Beyond these eˣ is 0 and ∞.
    const EXP_RANGE: [Self; 2];
    /// log₂ e.
    const LOG2_E: Self;
    /// ln 2 in two parts, the first with so few bits that its product with an exponent is exact.
    const LN_2: [Self; 2];
    /// log₂(1 + f)/f on 1 + f in [√½, √2], by powers of f.
    const LOG2: &'static [Self];
    /// (2ᶠ - 1)/f on |f| ≤ ½.
    const EXP2: &'static [Self];
    /// (eʳ - 1)/r on |r| ≤ ln 2/2.
    const EXP: &'static [Self];

    /// a b + c, rounded once if fused.
    fn fma<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self;

    /// (m, e) with x = m 2ᵉ and m in [√½, √2), for normal x; for others numbers without meaning.
    fn split(self) -> (Self, Self);

    /// 2ᵏ from k + [`Self::ROUND_BIASED`].
    fn raised(self) -> Self;

    /// x 2ᵏ, x given and k + [`Self::ROUND`]: the exponent's bits added, exact where the result is normal.
    fn shifted(self, k: Self) -> Self;

    /// Whether [`Self::powers`] of several are faster: two doubles have steps enough side by side, and as arrays
    /// the compiler makes no vectors of them.
    const POWERS: bool;

    /// cosⁿ to a few ulp, of several at once; see [`power`].
    fn powers<const FUSED: bool, const VERSINE: bool, const U: usize>(
        x: [Self; U],
        n: [Self; U],
    ) -> [Self; U];

    /// The same of one.
    #[inline(always)]
    fn power<const FUSED: bool, const VERSINE: bool>(self, n: Self) -> Self {
        let [power] = Self::powers::<FUSED, VERSINE, 1>([self], [n]);
        power
    }

    /// x, or 0 where it is less; NaN stays.
    #[inline(always)]
    fn positive(self) -> Self {
        // In this order it is one instruction, whose second operand survives if either is NaN.
        if Self::ZERO > self { Self::ZERO } else { self }
    }

    /// x within [lo, hi]; NaN stays.
    #[inline(always)]
    fn clamped(self, lo: Self, hi: Self) -> Self {
        let x = if lo > self { lo } else { self };
        if hi < x { hi } else { x }
    }

    /// The polynomial with these coefficients, the constant one first.
    #[inline(always)]
    fn polynomial<const FUSED: bool>(self, coefficients: &[Self]) -> Self {
        let (mut sum, mut i) = (coefficients[coefficients.len() - 1], coefficients.len() - 1);
        while i > 0 {
            i -= 1;
            sum = Self::fma::<FUSED>(sum, self, coefficients[i]);
        }
        sum
    }

    /// The polynomial of several at once, each step of all before the next: one alone waits for its own steps.
    #[inline(always)]
    fn polynomials<const FUSED: bool, const U: usize>(x: [Self; U], coefficients: &[Self]) -> [Self; U] {
        let (mut sums, mut i) = ([coefficients[coefficients.len() - 1]; U], coefficients.len() - 1);
        while i > 0 {
            i -= 1;
            for (sum, x) in sums.iter_mut().zip(x) {
                *sum = Self::fma::<FUSED>(*sum, x, coefficients[i]);
            }
        }
        sums
    }
}

macro_rules! lanes {
    ($float:ident, $bits:ident, $digits:literal, $bias:literal, { $($constants:tt)* }) => {
        #[allow(clippy::approx_constant)] // coefficients, not the constants that the first are near
        impl Lanes for $float {
            const ROUND: Self = 1.5 * (1u64 << $digits) as $float;
            const ROUND_BIASED: Self = 1.5 * (1u64 << $digits) as $float + $bias as $float;
            const LEAST: Self = $float::MIN_POSITIVE;
            const LIFT: [Self; 2] = [(1u64 << ($digits + 1)) as $float, ($digits + 1) as $float];
            const EXPONENTS: [Self; 2] = [(1 - $bias) as $float, ($bias + 1) as $float];
            const LOG2_E: Self = std::$float::consts::LOG2_E;
            $($constants)*

            #[inline(always)]
            fn fma<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self {
                if FUSED { a.mul_add(b, c) } else { a * b + c }
            }

            #[inline(always)]
            fn split(self) -> (Self, Self) {
                const ROOT: $bits = std::$float::consts::FRAC_1_SQRT_2.to_bits();
                const WHOLE: $float = (1u64 << $digits) as $float;
                // √½'s bits become those of 1, so that the exponent's field changes there.
                let bits = self.to_bits().wrapping_add((1.0 as $float).to_bits() - ROOT);
                let exponent = $float::from_bits((bits >> $digits) | WHOLE.to_bits()) - (WHOLE + $bias as $float);
                let significand = (bits & ((1 << $digits) - 1)) + ROOT;
                ($float::from_bits(significand), exponent)
            }

            #[inline(always)]
            fn raised(self) -> Self {
                $float::from_bits(self.to_bits() << $digits)
            }

            #[inline(always)]
            fn shifted(self, k: Self) -> Self {
                $float::from_bits(self.to_bits().wrapping_add(k.to_bits() << $digits))
            }

            #[inline(always)]
            fn powers<const FUSED: bool, const VERSINE: bool, const U: usize>(
                x: [Self; U],
                n: [Self; U],
            ) -> [Self; U] {
                power::$float::<FUSED, VERSINE, U>(x, n)
            }
        }
    };
}

// The polynomials: tests/references/slices.py, which prints them; least largest relative error.
lanes!(f32, u32, 23, 127, {
    const POWERS: bool = true;
    const EXP_RANGE: [Self; 2] = [-105.0, 90.0];
    const LN_2: [Self; 2] = [0.693_359_375, -2.121_944_4e-4];
    const LOG2: &'static [Self] = &[
        1.442695,
        -0.72134733,
        0.48089823,
        -0.3606967,
        0.28856742,
        -0.23961607,
        0.20459956,
        -0.19107208,
        0.18618561,
        -0.10994127,
    ];
    const EXP2: &'static [Self] =
        &[0.6931472, 0.24022649, 0.055503573, 0.009618238, 0.0013390776, 0.000154036];
    const EXP: &'static [Self] = &[1.0, 0.49999997, 0.16666506, 0.041667137, 0.008369101, 0.0013888951];
});
lanes!(f64, u64, 52, 1023, {
    const POWERS: bool = false;
    const EXP_RANGE: [Self; 2] = [-746.0, 711.0];
    const LN_2: [Self; 2] = [6.931_471_803_691_238_2e-1, 1.908_214_929_270_587_7e-10];
    const LOG2: &'static [Self] = &[
        1.4426950408889634,
        -0.7213475204444824,
        0.48089834696298184,
        -0.3606737602218469,
        0.28853900817923095,
        -0.24044917355291684,
        0.20609929145605682,
        -0.18033687418684116,
        0.16029944907822008,
        -0.14426976996290433,
        0.13115435936157435,
        -0.12021768288348314,
        0.11096380710962371,
        -0.10315325790842388,
        0.09645998092682034,
        -0.08935751995040815,
        0.08162233196722335,
        -0.081933468701702,
        0.09426467340500837,
        -0.08667469121352384,
        0.037738432890065676,
    ];
    const EXP2: &'static [Self] = &[
        0.6931471805599453,
        0.24022650695910097,
        0.055504108664821236,
        0.009618129107607003,
        0.0013333558146531614,
        0.00015403530441572598,
        1.5252733701331089e-05,
        1.3215442675115585e-06,
        1.0178121213105094e-07,
        7.072570445469294e-09,
        4.445555085441639e-10,
    ];
    const EXP: &'static [Self] = &[
        1.0,
        0.5000000000000006,
        0.16666666666666563,
        0.04166666666657356,
        0.008333333333397865,
        0.0013888888932367283,
        0.0001984126970755668,
        2.4801504477521008e-05,
        2.755741457705554e-06,
        2.7626310481816585e-07,
        2.505220317348055e-08,
    ];
});
