//! The only place where a claim meets a computed value.

mod albedo;
mod algebra;
mod expected;
mod fits;
mod judge;
mod judgement;
mod lobes;
mod minimum;
mod normalisation;
mod pixel;
mod residuals;

pub use expected::{EXPECTED, EXPECTED_PIXEL, Expectation, Expectations, ExpectedError};
pub use judge::Judge;
pub use judgement::{Evidence, Judgement, Verdict};
pub use minimum::{MinimumProof, prove_minimum};
pub use normalisation::{Demand, DemandFinding, NormalisationFinding};
