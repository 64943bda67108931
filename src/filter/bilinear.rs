//! Nearest and bilinear lookups in one level.

use super::{Texture, Wrap};

/// The texel that holds (s, t).
#[inline]
pub(super) fn nearest(level: &Texture, wrap: Wrap, s: f64, t: f64) -> [f32; 4] {
    level.texel(wrap.index(s.floor() as i64, level.width()), wrap.index(t.floor() as i64, level.height()))
}

/// The four texels whose centres surround (s, t), weighted by the areas of the opposite rectangles; computed
/// in double precision and rounded once.
pub(super) fn bilinear(level: &Texture, wrap: Wrap, s: f64, t: f64) -> [f32; 4] {
    let (x, y) = ((s - 0.5).floor(), (t - 0.5).floor());
    let (a, b) = (s - 0.5 - x, t - 0.5 - y);
    let column = |dx| wrap.index(x as i64 + dx, level.width());
    let row = |dy| wrap.index(y as i64 + dy, level.height());
    let (columns, rows) = ([column(0), column(1)], [row(0), row(1)]);
    let (texels, channels) = (level.texels(), level.channels());
    let mut value = [0.0_f32; 4];
    for (c, value) in value.iter_mut().enumerate().take(channels) {
        let texel =
            |i: usize, k: usize| f64::from(texels[(rows[k] * level.width() + columns[i]) * channels + c]);
        let along = |k| texel(0, k) * (1.0 - a) + texel(1, k) * a;
        *value = (along(0) * (1.0 - b) + along(1) * b) as f32;
    }
    value
}
