//! Speed against accuracy of what may stand for cosⁿ, measured on the machine at hand.
//!
//! A [`Subject`] is measured in every [`Place`], in both formats: [`measure`] times all of them one after the
//! other in each round, warm, and takes medians; [`Accuracy`] is of exactly the code that was timed. A
//! [`Record`] holds both and the machine's name; the [`frontier`] is what no other subject beats in both.
//! Times are the one thing here that another run does not repeat.
//!
//! ```
//! use bellfit::bound::Format;
//! use bellfit::kernel::stand_in::StandIn;
//! use bellfit::trade::{Plan, measure};
//! let plan = Plan { rounds: 1, sample: 0.0, elements: 64, memory: 1 << 12, window: 64, ..Plan::quick(64) };
//! let record = measure(&plan, &|_| ())?;
//! assert!(record.cost(StandIn::Cubic4, Format::Single).is_some_and(|nanoseconds| nanoseconds > 0.0));
//! # Ok::<(), bellfit::trade::TradeError>(())
//! ```

mod accuracy;
mod clock;
mod cosines;
mod element;
mod error;
mod frontier;
mod machine;
mod path;
mod place;
mod plan;
mod proven;
mod record;
mod row;
mod spread;
mod subject;
mod table;

pub use accuracy::Accuracy;
pub use clock::measure;
pub use cosines::REACH;
pub use error::TradeError;
pub use frontier::frontier;
pub use machine::{Machine, file_name, processor};
pub use place::Place;
pub use plan::{EXPONENTS, Plan};
pub use proven::{Proven, proven};
pub use record::{Record, VERSION};
pub use row::{Floor, Row};
pub use spread::Spread;
pub use subject::Subject;
pub use table::{Lookup, Over, SIZES, Sampling};
