//! Bounds of the error that are proved.

use super::subject::Subject;
use super::table::{END, Lookup, Over, Sampling};
use crate::bound::{Format, Interval, Measure, approximation as approximation_of};
use crate::integral::Field;
use crate::kernel::stand_in::StandIn;

/// What is proved of a subject's distance from cosⁿ, over every θ in [0, π/2].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Proven {
    /// Bounds |subject - cosⁿ| in exact arithmetic.
    pub approximation: Option<f64>,
    /// Bounds what the format's rounding adds, the cosine exact as it is in the format; fewer roundings, where
    /// operations are fused, are bounded as well.
    pub rounding: Option<f64>,
}

/// What is proved of a subject at n.
///
/// - Bells, Schlick's lobe and the spherical Gaussian: the approximation, as the certified supremum at n,
///   [`approximation`](crate::bound::approximation).
/// - Tables: the approximation by the theorem of the interpolation's error, h²/8 sup|f″| between samples h
///   apart and h/2 sup|f′| to the nearest, where f is cosⁿ: f′ and f″ are n and n (n - 1) over cos θ, and at
///   most 1 over t, where setting the end to 0 adds e⁻¹⁶. The rounding by counting: the place in the table is
///   off by u times its largest value, over t by u times n/h for the product and by four such roundings
///   besides; the samples and what is between them by 8 u. Second orders are in a hundredth.
/// - Others: nothing.
///
/// ```
/// use bellfit::{bound::Format, trade::{Subject, proven}};
/// let table = Subject::from_id("table-t-linear-64").expect("a table");
/// // h = 16/63
/// let found = proven(table, 64, Format::Double);
/// assert!(found.approximation.is_some_and(|bound| bound > 8.06e-3 && bound < 8.07e-3));
/// assert!(found.rounding.is_some_and(|bound| bound < 2e-14));
/// assert_eq!(proven(Subject::Powf, 64, Format::Double).approximation, None);
/// ```
pub fn proven(subject: Subject, n: u32, format: Format) -> Proven {
    Proven { approximation: approximation(subject, n), rounding: rounding(subject, n, format) }
}

/// The part that is the same in every format.
pub(super) fn approximation(subject: Subject, n: u32) -> Option<f64> {
    match subject {
        Subject::StandIn(stand_in) => of_stand_in(stand_in, n),
        Subject::Table(sampling) => Some(of_table(sampling, n)),
        Subject::Powf | Subject::Powi => None,
    }
}

/// The part of a format; for a stand-in none is proved here.
pub(super) fn rounding(subject: Subject, n: u32, format: Format) -> Option<f64> {
    let Subject::Table(sampling) = subject else { return None };
    let more = if sampling.over == Over::Cosine { 0.0 } else { 4.0 * END };
    Some(format.unit_roundoff() * (1.01 * (f64::from(n) + more) + 8.0))
}

/// For what is cosⁿ but for rounding there is nothing to state.
fn of_stand_in(stand_in: StandIn, n: u32) -> Option<f64> {
    let n = f64::from(n);
    let found = approximation_of(stand_in, (n, n), Measure::Absolute);
    found.filter(|_| !stand_in.is_exact()).map(|found| found.value.hi())
}

fn of_table(sampling: Sampling, n: u32) -> f64 {
    let int = |i: u32| Interval::int(i64::from(i));
    let end = if sampling.over == Over::Cosine { Interval::from(1.0) } else { Interval::from(END) };
    let step = end / int(sampling.samples - 1);
    let (slope, bend, lost) = match sampling.over {
        Over::Cosine => (int(n), int(n) * int(n - 1), Interval::from(0.0)),
        Over::Scaled => (Interval::from(1.0), Interval::from(1.0), (-end).exp()),
    };
    let error = match sampling.lookup {
        Lookup::Nearest => step * slope / int(2),
        Lookup::Linear => step * step * bend / int(8),
    };
    (error + lost).hi()
}
