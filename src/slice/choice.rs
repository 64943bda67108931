//! From what is asked for to the kernel that computes it, its constants folded.

use super::Unit;
use super::bell::Bell;
use super::kernel::{
    Cubic, Depressed, Each, Exponential, Gaussian, Guarded, Horner, Kernel, Line, Lyon, One, OneLess,
    Product, Reach, Schlick, SchlickPrinted, Singly, With,
};
use super::lanes::Lanes;
use super::pass::{Added, Beside, Pass, Pass2};
use super::squarings::Squarings;
use super::streams::{Exp2Log2, Power};
use crate::kernel::constants::{CUBIC_COS_N, CUBIC_EXP, LINEAR_COS_N};
use crate::kernel::cubic::CubicLobe;
use crate::kernel::linear::LinearLobe;
use crate::kernel::pixel::PixelWeight;
use crate::kernel::stand_in::{Argument, StandIn};

/// A lobe with one n.
pub(super) fn lobe<F: Lanes, P: Pass<F>>(
    unit: Unit,
    lobe: StandIn,
    argument: Argument,
    n: F,
    pass: P,
) -> P::Output {
    let cosine = argument == Argument::Cosine;
    let line = |[_, slope]: [F; 2], offset: F| if cosine { [offset, slope] } else { [F::ONE, -slope] };
    macro_rules! line {
        ($power:literal, $new:ident) => {{
            let constants = LinearLobe::<$power, F>::$new(n).constants();
            let kernel = Line::<{ u32::ilog2($power) }, F>(line(constants, constants[0]));
            // From slope 1 on the base is at most 0 behind the surface, so that no test is needed.
            guarded(unit, argument, kernel, constants[1] >= F::ONE, pass)
        }};
    }
    macro_rules! cubic {
        ($power:literal, $cosine:expr) => {{
            let lobe = CubicLobe::<$power, F>::new(n);
            let ends = ends(lobe.horner());
            if cosine {
                guarded(unit, argument, $cosine(&lobe), ends, pass)
            } else {
                let kernel = Horner::<{ u32::ilog2($power) }, F>(lobe.horner());
                guarded(unit, argument, kernel, ends, pass)
            }
        }};
    }
    macro_rules! of_argument {
        ($kernel:ident) => {
            if cosine {
                pass.one(unit, With($kernel::<false>, n))
            } else {
                pass.one(unit, With($kernel::<true>, n))
            }
        };
    }
    match lobe {
        StandIn::Cs16 => line!(16, lyon),
        StandIn::Linear2 => line!(2, new),
        StandIn::Linear4 => line!(4, new),
        StandIn::Linear8 => line!(8, new),
        StandIn::Linear16 => line!(16, new),
        StandIn::Linear32 => line!(32, new),
        StandIn::Cubic2 => cubic!(2, |lobe: &CubicLobe<2, F>| Depressed::<1, F>(lobe.depressed())),
        StandIn::Cubic4 => cubic!(4, |lobe: &CubicLobe<4, F>| Depressed::<2, F>(lobe.depressed())),
        StandIn::Cubic8 => cubic!(8, |lobe: &CubicLobe<8, F>| OneLess(Horner::<3, F>(lobe.horner()))),
        StandIn::Schlick => of_argument!(Schlick),
        StandIn::SchlickPrinted if cosine => pass.one(unit, With(SchlickPrinted, n)),
        StandIn::SchlickPrinted => pass.one(unit, OneLess(With(SchlickPrinted, n))),
        StandIn::SphericalGaussian => of_argument!(Gaussian),
        StandIn::Squarings if cosine => pass.one(unit, Squarings::<false>::new(n)),
        StandIn::Squarings => pass.one(unit, Squarings::<true>::new(n)),
        StandIn::Exp2Log2 => of_argument!(Exp2Log2),
        StandIn::Power => of_argument!(Power),
    }
}

/// The kernel, with a test for what is behind the surface unless it ends before.
fn guarded<F: Lanes, K: Kernel<F>, P: Pass<F>>(
    unit: Unit,
    argument: Argument,
    kernel: K,
    ends: bool,
    pass: P,
) -> P::Output {
    if ends {
        return pass.one(unit, kernel);
    }
    pass.one(unit, Guarded { kernel, range: front(argument) })
}

/// The arguments that are not behind the surface.
fn front<F: Lanes>(argument: Argument) -> [F; 2] {
    match argument {
        Argument::Cosine => [F::ZERO, F::INFINITY],
        Argument::Versine => [-F::INFINITY, F::ONE],
    }
}

/// Whether p = 1 - w (k₁ - w (k₂ - w k₃)) is below 0 for every w ≥ 1, by more than rounding can lift it:
/// -1/64 or less at 1, and falling from there on.
fn ends<F: Lanes>([k1, k2, k3]: [F; 3]) -> bool {
    let three = F::from_u32(3);
    let at_one = F::ONE - (k1 - (k2 - k3));
    // -p' = k₁ - 2 k₂ w + 3 k₃ w² is least at w = k₂/(3 k₃).
    let falls =
        if k2 <= three * k3 { k1 - F::TWO * k2 + three * k3 > F::ZERO } else { k2 * (k2 / k1) < three * k3 };
    k3 > F::ZERO && k1 > F::ZERO && falls && at_one <= F::from_f64(-0.015625)
}

/// A lobe with one n an element.
pub(super) fn lobes<F: Lanes, P: Pass2<F>>(
    unit: Unit,
    lobe: StandIn,
    argument: Argument,
    pass: P,
) -> P::Output {
    let cosine = argument == Argument::Cosine;
    let place = if cosine { [F::ONE, -F::ONE] } else { [F::ZERO, F::ONE] };
    macro_rules! each {
        ($of:expr) => {
            pass.two(unit, Each { of: $of, place, range: front(argument) })
        };
    }
    macro_rules! of_argument {
        ($kernel:ident) => {
            if cosine { pass.two(unit, $kernel::<false>) } else { pass.two(unit, $kernel::<true>) }
        };
    }
    match lobe {
        StandIn::Cs16 => each!(Lyon::<4>),
        StandIn::Linear2 => each!(Reach::<1, F>::new(&LINEAR_COS_N[0])),
        StandIn::Linear4 => each!(Reach::<2, F>::new(&LINEAR_COS_N[1])),
        StandIn::Linear8 => each!(Reach::<3, F>::new(&LINEAR_COS_N[2])),
        StandIn::Linear16 => each!(Reach::<4, F>::new(&LINEAR_COS_N[3])),
        StandIn::Linear32 => each!(Reach::<5, F>::new(&LINEAR_COS_N[4])),
        StandIn::Cubic2 => each!(Cubic::<1, F>::new(&CUBIC_COS_N[0])),
        StandIn::Cubic4 => each!(Cubic::<2, F>::new(&CUBIC_COS_N[1])),
        StandIn::Cubic8 => each!(Cubic::<3, F>::new(&CUBIC_COS_N[2])),
        StandIn::Schlick => of_argument!(Schlick),
        StandIn::SphericalGaussian => of_argument!(Gaussian),
        StandIn::Exp2Log2 => of_argument!(Exp2Log2),
        StandIn::Power => of_argument!(Power),
        // An n of its own has squarings of its own: nothing for lanes.
        StandIn::SchlickPrinted | StandIn::Squarings if cosine => {
            pass.two(unit, Singly(move |x, n| lobe.at(x, n)))
        }
        StandIn::SchlickPrinted | StandIn::Squarings => {
            pass.two(unit, Singly(move |x, n| lobe.at_versine(x, n)))
        }
    }
}

/// A bell of t.
pub(super) fn bell<F: Lanes, P: Pass<F>>(unit: Unit, bell: Bell, pass: P) -> P::Output {
    match bell {
        Bell::Lyon(power) => lyon(unit, power, F::ONE, pass),
        Bell::Cubic(power) => cubic(unit, power, F::ONE, pass),
        Bell::Exponential => pass.one(unit, Exponential(-F::ONE)),
    }
}

/// (1 - s t/K)^K.
fn lyon<F: Lanes, P: Pass<F>>(unit: Unit, power: u32, scale: F, pass: P) -> P::Output {
    macro_rules! line {
        ($squarings:literal) => {
            pass.one(unit, Line::<$squarings, F>([F::ONE, -(scale / F::from_u32(power))]))
        };
    }
    match power {
        2 => line!(1),
        4 => line!(2),
        8 => line!(3),
        16 => line!(4),
        32 => line!(5),
        64 => line!(6),
        _ => pass.one(unit, Singly(|_| F::NAN)),
    }
}

/// The cubic bell of s t.
fn cubic<F: Lanes, P: Pass<F>>(unit: Unit, power: u32, scale: F, pass: P) -> P::Output {
    macro_rules! horner {
        ($squarings:literal) => {{
            let [c1, c2, c3] = CUBIC_EXP[$squarings - 1].map(F::from_f64);
            let s = scale / F::from_u32(power);
            pass.one(unit, Horner::<$squarings, F>([c1 * s, c2 * s * s, c3 * s * s * s]))
        }};
    }
    match power {
        2 => horner!(1),
        4 => horner!(2),
        8 => horner!(3),
        _ => pass.one(unit, Singly(|_| F::NAN)),
    }
}

/// Whether a factor and its cube are normal numbers.
fn folds<F: Lanes>(scale: F) -> bool {
    let cube = scale * scale * scale;
    // 64⁻³ and the coefficients' product stay normal too.
    cube.is_finite() && cube >= F::LEAST * F::from_u32(1 << 24)
}

/// A weight of Q alone; of a product weight its first factor.
pub(super) fn weight<F: Lanes, P: Pass<F>>(unit: Unit, weight: PixelWeight<F>, pass: P) -> P::Output {
    let scale = |sigma: F| F::ONE / (F::TWO * sigma * sigma);
    match weight {
        PixelWeight::Paper(reading) | PixelWeight::PaperProduct(reading) => {
            pass.one(unit, Line::<3, F>([F::ONE, -reading.scale::<F>()]))
        }
        PixelWeight::Box => pass.one(unit, One),
        PixelWeight::Gaussian(sigma) if folds(scale(sigma)) => pass.one(unit, Exponential(-scale(sigma))),
        PixelWeight::Bell(power, sigma) if folds(scale(sigma)) => lyon(unit, power, scale(sigma), pass),
        PixelWeight::Cubic(power, sigma) if folds(scale(sigma)) => cubic(unit, power, scale(sigma), pass),
        _ => pass.one(unit, Singly(move |q| weight.at(q, F::ZERO))),
    }
}

/// A weight of the squares along two axes: a product, or a weight of their sum.
pub(super) fn weights<'a, F: Lanes, P>(
    unit: Unit,
    weight: PixelWeight<F>,
    pass: Beside<'a, P, F>,
) -> P::Output
where
    P: Pass<F>,
    Beside<'a, P, F>: Pass2<F, Output = P::Output>,
    Added<'a, P, F>: Pass<F, Output = P::Output>,
{
    match weight {
        PixelWeight::PaperProduct(reading) => {
            pass.two(unit, Product(Line::<3, F>([F::ONE, -reading.scale::<F>()])))
        }
        _ => self::weight(unit, weight, Added(pass)),
    }
}
