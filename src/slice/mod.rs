//! Lobes, bells and pixel weights over slices, on the widest vector unit that the machine has.
//!
//! ```
//! use bellfit::kernel::stand_in::{Argument, StandIn};
//! use bellfit::slice::{Exponents, lobe, lobe_sum};
//! let cosines: Vec<f32> = (0..1000).map(|i| i as f32 / 1000.0).collect();
//! let mut highlights = vec![0.0; 1000];
//! lobe(StandIn::Cubic4, Argument::Cosine, Exponents::One(64.0), &cosines, &mut highlights)?;
//! assert!(highlights.iter().zip(&cosines).all(|(f, c)| (f - libm::powf(*c, 64.0)).abs() < 5e-4));
//! // A light's weight beside each, summed without storing the lobe.
//! let light = vec![0.001; 1000];
//! let sum = lobe_sum(StandIn::Cubic4, Argument::Cosine, Exponents::One(64.0), &cosines, &light)?;
//! assert!((sum - 1.0 / 65.0).abs() < 1e-3); // ∫ c⁶⁴ dc
//! # Ok::<(), bellfit::slice::LengthError>(())
//! ```
//!
//! Each function is compiled for every [`Unit`] and the widest is chosen by the call; `Unit` has the same functions
//! for a unit of one's choice. Nothing allocates. A slice of one is the scalar call. Ends and NaN are the scalar
//! kernels' own: a NaN stays one, and what a kernel has as 0 behind the surface is 0.
//!
//! **Which bits.** The value of an element depends on the element, on n and on the unit, not on its place nor on how
//! many there are from two on, nor on whether it is written elsewhere or in place: `pow` and `exp2-log2` go by
//! blocks of 256 elements, which changes the time alone. The units with AVX2 and AVX-512 have the same bits as each
//! other; both fuse each multiply with its add, which the plain one and the scalar kernels do not. A sum is 64
//! partial ones, element j in that of j mod 64, halves then added to halves: the same on every run.
//!
//! | | against the scalar kernel, u = 2⁻²⁴ or 2⁻⁵³ |
//! |---|---|
//! | [`Bell::Lyon`]; lobes by squarings; the box | same bits, every unit |
//! | cs, linear and cubic lobes with one n; Schlick's; [`Bell::Cubic`]; the paper's weights | same bits on the plain unit |
//! | lobes p^K with one n, of the versine and of the cosine | 32 K u; and 1.05 n u more |
//! | lobes p^K with an n an element | the same; and 2.1 n u: they go by 1 - c, which loses nothing |
//! | Schlick's; as printed | 9 u; (2 n + 9) u, relative |
//! | cubic bells, weights p^K | 32 K u |
//! | spherical Gaussian, [`Bell::Exponential`] | 5 u, relative |
//! | Gaussian weight of t = Q/(2σ²) | 32 (1 + t) u, relative |
//! | `pow` of the cosine; of the versine | 4 u; (6 + 3 \|n log₂ c\|) u, relative, most of it the scalar's |
//! | `exp2-log2` | (6 + 5 \|n log₂ c\|) u, relative; 0 where the result is subnormal |
//!
//! The bounds hold in the kernels' domains, n ≥ 16 where there is one. Those of a p^K count roundings: s c is
//! rounded where the scalar kernel works and not here, which moves p by s u and p^K by K s u ≤ n u (p^K falls
//! by at most n (1 + 0.02) a unit of c); of the rest each step rounds by at most u of numbers below 4, and K times
//! that is the power's.
//!
//! **How exact.** Beside the true value, in units in the last place, the largest of 3300 references to 60 digits
//! (`tests/references/slices.py`), which are dense where it is hard: near c = 1, near powers of two times √½, for
//! subnormal arguments and results.
//!
//! | | `f32` | `f64` | by |
//! |---|---|---|---|
//! | [`StandIn::Power`](crate::kernel::stand_in::StandIn::Power), either argument | 0.51 | 1.1 | log₂ in `f64`, or in two doubles |
//! | [`Bell::Exponential`] | 0.8 | 0.9 | ln 2 in two parts |
//! | [`StandIn::Exp2Log2`](crate::kernel::stand_in::StandIn::Exp2Log2) | (2 + 3 \|n log₂ c\|) u, relative | the same | log₂ and 2ʸ in the type |
//!
//! Sampled, then; but of the power in `f32` the parts add up to it, the polynomials' errors being estimates: n log₂ c is at most 150, its
//! logarithm off by 1.7e-11 of itself and 2ʸ by 2.4e-10, which together move the result by less than 3e-9, 0.05
//! ulp; the conversion rounds by ½. In `f64` the logarithm has 65 bits, so that n log₂ c ≤ 1075 is off by 2⁻⁵⁵,
//! and the last two steps round by 1 ulp together; a subnormal result once more. n up to 2⁹⁰⁰ for it.
//!
//! A [`Job`] is one `#[inline(always)]` body of one's own; [`Unit::run`] holds a copy of it compiled for each
//! vector unit. No copy fuses a multiply with an add unasked, so a job has the same bits on every unit.

mod bell;
mod choice;
mod error;
mod exponential;
mod float;
mod kernel;
mod lanes;
mod lobe;
mod pass;
mod power;
mod route;
mod second;
mod squarings;
mod streams;
mod unit;
mod weight;

pub use bell::{Bell, bell, bell_in_place, bell_sum};
pub use error::LengthError;
pub use float::Float;
pub use lobe::{Exponents, lobe, lobe_in_place, lobe_sum};
pub use unit::{Job, Unit};
pub use weight::{
    weight, weight_in_place, weight_of_two, weight_of_two_in_place, weight_of_two_sum, weight_sum,
};
