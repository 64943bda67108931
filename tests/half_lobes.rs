//! Every binary16 argument of every lobe, in both ways of computing with binary16, against the certified bound of its
//! rounding.
//!
//! Reference: the same kernel in f64, whose error is some 2⁻⁴⁰ of binary16's. An argument x stands for every angle
//! that rounds to it, so the exact lobe is taken at x and just inside both ends of what rounds there.
#![cfg(feature = "toolkit")]

use bellfit::bound::{Format, Handed, Measure, rounding};
use bellfit::kernel::prepared::Prepared;
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::StandIn;
use bellfit::stability::Half;

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
                // Its constants from f64, rounded once to the arithmetic.
                let half = Prepared::<Half>::new(stand_in, n);
                let single = Prepared::<f32>::new(stand_in, n);
                let double = Prepared::<f64>::new(stand_in, n);
                let (mut largest, mut at) = (0.0_f64, 0.0);
                for (x, exact) in arguments() {
                    let value = match format {
                        Format::Half => half.of(argument, Half::from_f64(x)).to_f64(),
                        _ => Half::from_f64(single.of(argument, x as f32).to_f64()).to_f64(),
                    };
                    for exact in exact {
                        let error = (value - double.of(argument, exact)).abs();
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
