//! What a bell costs.

/// Operations of a bell p^K: multiply, add, fused multiply-add and maximum count one each, constants of
/// n folded beforehand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// From t, or from the versine w = 1 - cos θ.
    pub from_t: u32,
    /// From cos θ.
    pub from_cos: u32,
    /// From cos θ where nothing fuses, so that a fused multiply-add counts two.
    pub unfused: u32,
}

/// The cost of p^K with p of so high a degree.
///
/// `degree` fused multiply-adds, one cut and log₂ K squarings. From cos θ the same where p is written
/// in u = a + b cos θ: degree 1 is u, degree 2 u² + c, degree 3 (u² + c) u + d; where that form is
/// ill-conditioned (`by_difference`) 1 - cos θ costs one more.
pub const fn operations(degree: u32, power: u32, by_difference: bool) -> Cost {
    let from_t = degree + 1 + power.trailing_zeros();
    let from_cos = from_t + by_difference as u32;
    Cost { from_t, from_cos, unfused: from_cos + degree }
}
