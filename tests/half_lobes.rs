//! Every binary16 argument of every lobe, in both ways of computing with binary16, against the certified bound of its
//! rounding.
//!
//! Reference: the same kernel in f64, whose error is some 2⁻⁴⁰ of binary16's. An argument x stands for every angle
//! that rounds to it, so the exact lobe is taken at x and just inside both ends of what rounds there.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use bellfit::bound::{Format, Handed, Measure, rounding};
use bellfit::kernel::cubic::CubicLobe;
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::{Argument, StandIn};
use bellfit::stability::Half;

/// The lobe with its constants computed in f64 and rounded once to the arithmetic.
fn lobe<A: Real>(stand_in: StandIn, argument: Argument, n: f64, x: A) -> A {
    let cosine = argument == Argument::Cosine;
    macro_rules! of {
        ($lobe:expr) => {{
            let lobe = $lobe.convert::<A>();
            if cosine { lobe.at(x) } else { lobe.at_versine(x) }
        }};
    }
    match stand_in {
        StandIn::Cs16 => of!(LinearLobe::<16, f64>::lyon(n)),
        StandIn::Linear2 => of!(LinearLobe::<2, f64>::new(n)),
        StandIn::Linear4 => of!(LinearLobe::<4, f64>::new(n)),
        StandIn::Linear8 => of!(LinearLobe::<8, f64>::new(n)),
        StandIn::Linear16 => of!(LinearLobe::<16, f64>::new(n)),
        StandIn::Linear32 => of!(LinearLobe::<32, f64>::new(n)),
        StandIn::Cubic2 => of!(CubicLobe::<2, f64>::new(n)),
        StandIn::Cubic4 => of!(CubicLobe::<4, f64>::new(n)),
        StandIn::Cubic8 => of!(CubicLobe::<8, f64>::new(n)),
        _ if cosine => stand_in.at(x, A::from_f64(n)),
        _ => stand_in.at_versine(x, A::from_f64(n)),
    }
}

/// (argument, the exact arguments that it stands for) for each binary16 number in [0, 1].
fn arguments() -> impl Iterator<Item = (f64, [f64; 3])> {
    let one = Half::from_f64(1.0).to_bits();
    (0..=one).map(move |bits| {
        let at = |bits: u16| Half::from_bits(bits).to_f64();
        let x = at(bits);
        let below = if bits == 0 { 0.0 } else { 0.5 * (x + at(bits - 1)) };
        let above = if bits == one { 1.0 } else { 0.5 * (x + at(bits + 1)) };
        // Just inside: a tie may go to the neighbour.
        (x, [x, below + (x - below) * 1e-9, above - (above - x) * 1e-9])
    })
}

#[test]
fn every_argument_stays_within_the_certified_rounding() {
    let mut checked = 0;
    for stand_in in StandIn::ALL {
        for (format, handed) in [Format::Half, Format::HalfStored]
            .into_iter()
            .flat_map(|format| [Handed::Cosine, Handed::Versine].map(|handed| (format, handed)))
        {
            for n in [1.0, 16.0, 64.0, 300.0] {
                let Some(bound) = rounding(stand_in, format, handed, (n, n), Measure::Absolute) else {
                    continue; // constants beyond binary16, or a denominator that may vanish
                };
                let (bound, argument) = (bound.value.hi(), handed.argument());
                let (mut largest, mut at) = (0.0_f64, 0.0);
                for (x, exact) in arguments() {
                    let value = match format {
                        Format::Half => lobe(stand_in, argument, n, Half::from_f64(x)).to_f64(),
                        _ => Half::from_f64(lobe(stand_in, argument, n, x as f32).to_f64()).to_f64(),
                    };
                    for exact in exact {
                        let error = (value - lobe(stand_in, argument, n, exact)).abs();
                        if error > largest || error.is_nan() {
                            (largest, at) = (error, x);
                        }
                    }
                }
                let case = format!("{}, {}, {}, n = {n}", stand_in.id(), format.id(), handed.id());
                assert!(largest <= bound, "{case}: {largest:e} at {at} over {bound:e}");
                // The bound adds what all roundings could do together; that it is not beyond all measure is
                // worth knowing: a twentieth is reached.
                assert!(largest >= 0.05 * bound, "{case}: {largest:e} at {at} of {bound:e}");
                checked += 1;
            }
        }
    }
    assert!(checked > 150, "{checked} cases have a bound");
}
