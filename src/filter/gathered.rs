//! What was gathered from the texels of one ellipse.
#![allow(clippy::needless_range_loop)] // one index for several arrays is the shape that becomes vectors

/// Columns that are read together.
pub(super) const LANES: usize = 8;
/// A value a column.
pub(super) type Lanes = [f32; LANES];

/// Sums over the texels with Q ≤ 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sum {
    /// Of the weights.
    pub weight: f64,
    /// Of weight × value; absent channels 0.
    pub values: [f64; 4],
    /// Of texels.
    pub texels: u64,
}

impl Sum {
    /// The weighted mean, or `None` without weight; absent channels 0.
    #[inline(always)]
    pub fn mean<const C: usize>(&self) -> Option<[f32; 4]> {
        let mut mean = [0.0; 4];
        for c in 0..C {
            mean[c] = (self.values[c] / self.weight) as f32;
        }
        (self.weight > 0.0).then_some(mean)
    }
}

/// Sums lane by lane, of the last rows in single precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gathered {
    /// Of the weights.
    pub weight: Lanes,
    /// Of weight × value: eight texels, channels side by side.
    pub values: [Lanes; 4],
    /// Of texels.
    pub texels: [u32; LANES],
    /// All of the rows before.
    pub sum: Sum,
}

impl Gathered {
    /// Nothing yet.
    pub const NONE: Gathered = Gathered {
        weight: [0.0; LANES],
        values: [[0.0; LANES]; 4],
        texels: [0; LANES],
        sum: Sum { weight: 0.0, values: [0.0; 4], texels: 0 },
    };

    /// Moves the lanes into the sum. A call that stays one: in sight of loops over lanes, sums across them
    /// keep those from becoming vectors.
    #[inline(never)]
    pub fn flush<const C: usize>(&mut self) {
        *self = Gathered { sum: self.total::<C>(), ..Gathered::NONE };
    }

    /// The sum with the lanes added.
    #[inline(always)]
    pub fn total<const C: usize>(&self) -> Sum {
        let mut sum = self.sum;
        let ([weight], values) = (across::<1>(&self.weight), across::<C>(self.values.as_flattened()));
        sum.weight += weight;
        for c in 0..C {
            sum.values[c] += values[c];
        }
        let texels: [u32; 4] = std::array::from_fn(|i| self.texels[i] + self.texels[i + 4]);
        sum.texels += u64::from((texels[0] + texels[2]) + (texels[1] + texels[3]));
        sum
    }
}

/// Sums over eight texels of C channels.
#[inline(always)]
fn across<const C: usize>(lanes: &[f32]) -> [f64; C] {
    let mut four = [[0.0; C]; LANES / 2];
    for i in 0..LANES / 2 {
        for c in 0..C {
            four[i][c] = lanes[i * C + c] + lanes[(i + LANES / 2) * C + c];
        }
    }
    std::array::from_fn(|c| f64::from((four[0][c] + four[2][c]) + (four[1][c] + four[3][c])))
}
