//! The cheapest kernel inside a scene's needs, with the proof of it, and why the cheaper ones fail.
//!
//! [`choose`] takes one [`Need`]: the exponents, the error that is allowed, the number format and how the
//! lobe's angle is handed over; and what a value costs, [`Costs`]. A kernel qualifies if its approximation's
//! error and its rounding's, both enclosed ([`bound::approximation`](crate::bound::approximation),
//! [`bound::rounding`](crate::bound::rounding)), add up to no more than is allowed for every angle and every n,
//! and if a factor keeps the energy where that is asked. One that does not [fails](Verdict::Fails) where an
//! argument is known at which it exceeds what is allowed; else it is [unproved](Verdict::Unproved). [`SceneNeeds`]
//! asks for every material of a file and says of its surfaces what they do not need.
//!
//! ```
//! use bellfit::choose::{Costs, Need, choose};
//! use bellfit::kernel::stand_in::StandIn;
//! // A highlight of n = 16..1024 within 1e-3, computed in f32 from the difference of two vectors.
//! let answer = choose(&Need::new("16..1024".parse()?, 1e-3), &Costs::default())?;
//! let best = answer.best().expect("one qualifies");
//! assert_eq!(best.stand_in, StandIn::Cubic4);
//! assert!(best.bound.is_some_and(|bound| bound <= 1e-3));
//! # Ok::<(), bellfit::choose::NeedError>(())
//! ```

mod answer;
mod candidate;
mod cost;
mod energy;
mod file;
mod need;
mod range;
mod scene;
mod surface;
mod witness;
mod words;

pub use answer::{Answer, Demand, Miss, choose};
pub use candidate::{Candidate, Exclusion, Failure, Verdict};
pub use cost::{Costs, Measured, Price, Weights};
pub use energy::{EnergyDemand, Factor, FactorKind, Side};
pub use file::{EXAMPLE_NEEDS, Material, SceneNeeds};
pub use need::{Need, NeedError};
pub use range::Exponents;
pub use scene::{MaterialAnswer, SceneAnswer};
pub use surface::{Dispensable, Shape, Surface, SurfaceAnswer};
pub use witness::{Evidence, Witness, theta};
pub use words::{
    ANGLE_WORDS, ENERGY_ERROR, ENERGY_WORDS, FLOOR, energy_from_word, handed_from_word, handed_word,
};
