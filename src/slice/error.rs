//! What a call over slices refuses.

use thiserror::Error;

/// Slices that belong together have different lengths.
///
/// ```
/// use bellfit::slice::LengthError;
/// let error = LengthError { name: "out", length: 3, expected: 4 };
/// assert_eq!(error.to_string(), "out has 3 elements, the arguments 4");
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{name} has {length} elements, the arguments {expected}")]
pub struct LengthError {
    /// Which slice: `out`, `n`, `weights` or `bb`.
    pub name: &'static str,
    /// Its length.
    pub length: usize,
    /// The length of the arguments.
    pub expected: usize,
}

impl LengthError {
    #[inline]
    pub(super) fn check(name: &'static str, length: usize, expected: usize) -> Result<(), LengthError> {
        if length == expected { Ok(()) } else { Err(LengthError { name, length, expected }) }
    }
}
