//! The tables of tests/references, read exactly.
#![allow(dead_code)] // every test file uses its part

use bellfit::bound::{Interval, decimal, exact, power_of_ten};
use bellfit::integral::Field;
use dashu_ratio::RBig;

/// The rows of a table, each a field a column; empty fields stay empty.
pub fn rows<const COLUMNS: usize>(name: &str) -> Vec<[String; COLUMNS]> {
    let path = format!("{}/tests/references/{name}", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let fields = |row: csv::StringRecord| -> [String; COLUMNS] {
        let all: Vec<String> = row.iter().map(str::to_owned).collect();
        all.try_into().unwrap_or_else(|row| panic!("{path}: {row:?} has not {COLUMNS} columns"))
    };
    reader.records().map(|row| fields(row.unwrap_or_else(|e| panic!("{path}: {e}")))).collect()
}

/// A reference: the true number lies within half a unit of its last digit.
#[derive(Clone, Debug)]
pub struct Reference {
    pub value: RBig,
    half: RBig,
}

impl Reference {
    /// `None` where [`decimal`] reads no number: beyond 10^±400.
    pub fn parse(text: &str) -> Option<Self> {
        let (value, places) = decimal(text)?;
        // The scripts print "0" only for what is 0 itself.
        let half = if text == "0" { RBig::int(0) } else { power_of_ten(-places) / RBig::int(2) };
        Some(Reference { value, half })
    }

    /// Whether [lo, hi] can hold the true number, decided in rationals.
    pub fn is_within(&self, lo: &RBig, hi: &RBig) -> bool {
        *lo <= self.value.clone() + self.half.clone() && self.value.clone() - self.half.clone() <= *hi
    }

    /// The same for an enclosure in doubles; an infinite end holds everything on its side.
    pub fn is_enclosed(&self, by: Interval) -> bool {
        let end = |x: f64| exact(x).unwrap_or_else(|| self.value.clone());
        self.is_within(&end(by.lo()), &end(by.hi()))
    }

    /// |x - reference| less the reference's own half unit, exactly.
    pub fn distance(&self, x: f64) -> RBig {
        let difference = exact(x).expect("a finite number") - self.value.clone();
        let size = if difference < RBig::int(0) { RBig::int(0) - difference } else { difference };
        if size > self.half { size - self.half.clone() } else { RBig::int(0) }
    }

    /// Whether x is within `relative` of the reference.
    pub fn is_near(&self, x: f64, relative: f64) -> bool {
        let size =
            if self.value < RBig::int(0) { RBig::int(0) - self.value.clone() } else { self.value.clone() };
        self.distance(x) <= size * exact(relative).expect("a finite number")
    }

    /// The nearest double.
    pub fn to_f64(&self) -> f64 {
        self.value.to_f64().value()
    }
}
