//! What is measured.

use super::table::{Lookup, Over, Sampling};
use crate::kernel::exact::Cost;
use crate::kernel::stand_in::{Argument, StandIn};

/// One way to a lobe's value, from cos θ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    /// A kernel of this crate: one by one [`StandIn::at`], with what depends on n alone computed before; over
    /// slices [`slice::lobe`](crate::slice::lobe).
    StandIn(StandIn),
    /// The platform's `powf` in a loop.
    Powf,
    /// The platform's `powi` in a loop.
    Powi,
    /// A table, over slices by the widest vector unit.
    Table(Sampling),
}

impl Subject {
    /// All of them: 15 stand-ins, the platform's two powers, 16 tables.
    ///
    /// ```
    /// use bellfit::trade::Subject;
    /// assert_eq!(Subject::all().count(), 33);
    /// ```
    pub fn all() -> impl Iterator<Item = Subject> {
        let stand_ins = StandIn::ALL.into_iter().map(Subject::StandIn);
        stand_ins.chain([Subject::Powf, Subject::Powi]).chain(Sampling::all().map(Subject::Table))
    }

    /// The name in files: a stand-in's own, `powf`, `powi` (both the platform's), `table-t-linear-256`.
    ///
    /// ```
    /// use bellfit::{kernel::stand_in::StandIn, trade::Subject};
    /// assert_eq!(Subject::StandIn(StandIn::Cubic4).id(), "cubic-4");
    /// ```
    pub fn id(&self) -> String {
        match self {
            Subject::StandIn(stand_in) => stand_in.id().to_owned(),
            Subject::Powf => "powf".to_owned(),
            Subject::Powi => "powi".to_owned(),
            Subject::Table(Sampling { over, lookup, samples }) => {
                let over = if *over == Over::Cosine { "cos" } else { "t" };
                let lookup = if *lookup == Lookup::Nearest { "nearest" } else { "linear" };
                format!("table-{over}-{lookup}-{samples}")
            }
        }
    }

    /// The one with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::trade::Subject;
    /// assert!(Subject::all().all(|subject| Subject::from_id(&subject.id()) == Some(subject)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::all().find(|subject| subject.id() == id)
    }

    /// What one value costs from cos θ at the exponent n, as [`StandIn::cost`] counts; a table's conversion to
    /// whole and each of its loads count one.
    ///
    /// ```
    /// use bellfit::trade::Subject;
    /// let table = Subject::from_id("table-cos-nearest-64").expect("a table");
    /// assert_eq!(table.cost(64).operations, 3);
    /// ```
    pub fn cost(&self, n: u32) -> Cost {
        let of = |stand_in: StandIn| stand_in.cost(Argument::Cosine, f64::from(n));
        match self {
            Subject::StandIn(stand_in) => of(*stand_in),
            Subject::Powf => of(StandIn::Power),
            Subject::Powi => of(StandIn::Squarings),
            Subject::Table(sampling) => sampling.cost(),
        }
    }
}
