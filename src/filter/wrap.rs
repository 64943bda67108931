//! Texels beyond the texture's edges.

/// What stands beyond an edge.
///
/// ```
/// use bellfit::filter::Wrap;
/// let row = |wrap: Wrap| (-4..8).map(|x| wrap.index(x, 3)).collect::<Vec<_>>();
/// assert_eq!(row(Wrap::Repeat), [2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1]);
/// assert_eq!(row(Wrap::Clamp), [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2]);
/// assert_eq!(row(Wrap::Mirror), [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The texture again.
    Repeat,
    /// Its last texel.
    Clamp,
    /// The texture mirrored at its edge, then itself again.
    Mirror,
}

impl Wrap {
    /// All three.
    pub const ALL: [Wrap; 3] = [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror];

    /// `repeat`, `clamp` or `mirror`.
    pub fn id(self) -> &'static str {
        match self {
            Wrap::Repeat => "repeat",
            Wrap::Clamp => "clamp",
            Wrap::Mirror => "mirror",
        }
    }

    /// The one with this id.
    pub fn from_id(id: &str) -> Option<Wrap> {
        Wrap::ALL.into_iter().find(|wrap| wrap.id() == id)
    }

    /// The place in 0..size that stands at `x`, for every integer x; size from 1 to 2⁶².
    #[inline]
    pub fn index(self, x: i64, size: usize) -> usize {
        let n = size as i64;
        if (0..n).contains(&x) {
            return x as usize;
        }
        let place = match self {
            Wrap::Repeat => x.rem_euclid(n),
            Wrap::Clamp => x.clamp(0, n - 1),
            Wrap::Mirror => {
                let m = x.rem_euclid(2 * n);
                if m < n { m } else { 2 * n - 1 - m }
            }
        };
        place as usize
    }

    /// A position, finite, brought within 2⁴⁰ texels, so that whole texels fit an `i64` with room to
    /// spare; what it reads stays the same, as the remainder is exact.
    #[inline(always)]
    pub(super) fn near(self, position: f64, size: usize) -> f64 {
        const FAR: f64 = (1u64 << 40) as f64;
        if position.abs() < FAR {
            return position;
        }
        match self {
            Wrap::Repeat => position % size as f64,
            Wrap::Clamp => position.clamp(-FAR, FAR),
            Wrap::Mirror => position % (2 * size) as f64,
        }
    }
}
