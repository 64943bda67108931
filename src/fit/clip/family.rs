//! The polynomials among which a clip volume's stand-in is sought.

/// How the polynomial ends at the base, d = ½.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Anyhow.
    Free,
    /// At 0.
    Zero,
    /// At 0 with slope 0.
    Landing,
}

/// Polynomials in d of one degree, 2 or 3, with what is fixed of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClipFamily {
    /// The degree.
    pub degree: u32,
    /// Whether P(0) = ½.
    pub half: bool,
    /// The end at the base.
    pub ending: Ending,
}

/// Unknowns are kept in units of this where a condition at the base is to hold exactly: all coefficients
/// are then sums of few such numbers, exact in double precision.
const UNIT: f64 = 1.0 / (1_u64 << 36) as f64;

impl ClipFamily {
    /// The paper's form, p₀ free or ½.
    pub const fn quadratic(half: bool) -> Self {
        ClipFamily { degree: 2, half, ending: Ending::Free }
    }

    /// What is fixed: 0, ½ - d or 2 (½ - d)² where P(0) = ½, else 0.
    pub(super) const fn offset(self) -> [f64; 4] {
        match (self.half, self.ending) {
            (false, _) => [0.0; 4],
            (true, Ending::Free) => [0.5, 0.0, 0.0, 0.0],
            (true, Ending::Zero) => [0.5, -1.0, 0.0, 0.0],
            (true, Ending::Landing) => [0.5, -2.0, 2.0, 0.0],
        }
    }

    /// What the unknowns multiply: dᵏ times 1, ½ - d or (½ - d)².
    pub(super) fn basis(self) -> Vec<[f64; 4]> {
        let (factor, taken): (&[f64], u32) = match self.ending {
            Ending::Free => (&[1.0], 0),
            Ending::Zero => (&[0.5, -1.0], 1),
            Ending::Landing => (&[0.25, -1.0, 1.0], 2),
        };
        let first = u32::from(self.half);
        let shifted = |k: u32| {
            let mut b = [0.0; 4];
            for (i, c) in factor.iter().enumerate() {
                b[i + k as usize] = *c;
            }
            b
        };
        (first..=self.degree.saturating_sub(taken)).map(shifted).collect()
    }

    /// The polynomial of these unknowns.
    pub(super) fn polynomial(self, unknowns: &[f64]) -> [f64; 4] {
        let mut p = self.offset();
        for (u, b) in unknowns.iter().zip(self.basis()) {
            for (p, b) in p.iter_mut().zip(b) {
                *p += u * b;
            }
        }
        p
    }

    /// The polynomial with its unknowns rounded, so that what is fixed stays exact.
    pub(super) fn rounded(self, unknowns: &[f64]) -> [f64; 4] {
        let rounded: Vec<f64> = unknowns
            .iter()
            .map(|u| match self.ending {
                Ending::Free => crate::fit::digits::round_to(*u, crate::fit::DIGITS).parse().unwrap_or(*u),
                _ => libm::round(u / UNIT) * UNIT,
            })
            .collect();
        self.polynomial(&rounded)
    }
}

/// Whether p falls, or stands, all over [0, ½].
pub(super) fn falls([_, p1, p2, p3]: [f64; 4]) -> bool {
    let slope = |d: f64| p1 + d * (2.0 * p2 + d * 3.0 * p3);
    // The slope's own extreme, if it lies inside.
    let bend = -p2 / (3.0 * p3);
    let inside = p3 != 0.0 && (0.0..=0.5).contains(&bend);
    slope(0.0) <= 0.0 && slope(0.5) <= 0.0 && !(inside && slope(bend) > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::clip::at;

    #[test]
    fn what_is_fixed_holds_exactly() {
        for degree in [2, 3] {
            for half in [false, true] {
                for ending in [Ending::Free, Ending::Zero, Ending::Landing] {
                    let family = ClipFamily { degree, half, ending };
                    let unknowns: Vec<f64> =
                        (0..family.basis().len()).map(|i| 1.234567891234 - 0.7 * i as f64).collect();
                    let p = family.rounded(&unknowns);
                    assert!(!half || p[0] == 0.5, "{family:?}");
                    assert!(ending == Ending::Free || at(p, 0.5) == 0.0, "{family:?}");
                    let slope = p[1] + p[2] + 0.75 * p[3];
                    assert!(ending != Ending::Landing || slope == 0.0, "{family:?}");
                    assert!(degree == 3 || p[3] == 0.0);
                }
            }
        }
    }

    #[test]
    fn falling_is_told_from_rising() {
        assert!(falls([0.5, -2.0, 2.0, 0.0]) && falls([0.5, -1.0, 0.0, 0.0]));
        assert!(!falls([0.5, -2.151, 2.358, 0.0]));
        // Slope -1 + 12 d - 24 d²: below 0 at both ends, ½ at d = ¼.
        assert!(!falls([0.5, -1.0, 6.0, -8.0]));
    }
}
