//! Where the numbers of a measurement lie.

/// How a subject is called, and where its numbers lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Place {
    /// One scalar call after the other, inlined, what depends on n alone computed before: the throughput of
    /// calls that do not wait for each other. Argument and result are hidden from the compiler, so it
    /// makes no vectors of them.
    Single,
    /// A slice that stays in the nearest caches, out of place.
    Cache,
    /// A slice that comes from memory and goes there, out of place.
    Memory,
}

impl Place {
    /// All three.
    pub const ALL: [Place; 3] = [Place::Single, Place::Cache, Place::Memory];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Place::Single => "single",
            Place::Cache => "cache",
            Place::Memory => "memory",
        }
    }

    /// The place with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::trade::Place;
    /// assert!(Place::ALL.iter().all(|place| Place::from_id(place.id()) == Some(*place)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|place| place.id() == id)
    }
}
