//! The palettes.

/// A colour in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rgb(pub(super) u8, pub(super) u8, pub(super) u8);

pub(super) const INK: Rgb = Rgb(0x22, 0x22, 0x22);
pub(super) const GREY: Rgb = Rgb(0x60, 0x60, 0x60);
pub(super) const FRAME: Rgb = Rgb(0x70, 0x70, 0x70);
pub(super) const GRID: Rgb = Rgb(0xDE, 0xDE, 0xDE);
pub(super) const WHITE: Rgb = Rgb(0xFF, 0xFF, 0xFF);
/// A heat map's cells without a value.
pub(super) const MISSING: Rgb = Rgb(0xBD, 0xBD, 0xBD);

/// Okabe and Ito's colours, told apart under every common colour blindness; without their yellow,
/// which is lost on white, and with a grey.
pub(super) const SERIES: [Rgb; 8] = [
    Rgb(0x00, 0x72, 0xB2),
    Rgb(0xD5, 0x5E, 0x00),
    Rgb(0x00, 0x9E, 0x73),
    Rgb(0xCC, 0x79, 0xA7),
    Rgb(0xE6, 0x9F, 0x00),
    Rgb(0x56, 0xB4, 0xE9),
    Rgb(0x22, 0x22, 0x22),
    Rgb(0x8C, 0x8C, 0x8C),
];

/// Fill and border, pale enough to lie under curves.
pub(super) const BANDS: [(Rgb, Rgb); 4] = [
    (Rgb(0xFB, 0xF1, 0xCC), Rgb(0xC9, 0xA9, 0x3A)),
    (Rgb(0xE3, 0xEE, 0xF6), Rgb(0x86, 0xAE, 0xCB)),
    (Rgb(0xEC, 0xEC, 0xEC), Rgb(0xA0, 0xA0, 0xA0)),
    (Rgb(0xF6, 0xE4, 0xEE), Rgb(0xC8, 0x96, 0xB2)),
];

/// Viridis at equal steps: lightness rises evenly from dark to light.
const RISING: [Rgb; 9] = [
    Rgb(0x44, 0x01, 0x54),
    Rgb(0x47, 0x2D, 0x7B),
    Rgb(0x3B, 0x52, 0x8B),
    Rgb(0x2C, 0x72, 0x8E),
    Rgb(0x21, 0x91, 0x8C),
    Rgb(0x28, 0xAE, 0x80),
    Rgb(0x5E, 0xC9, 0x62),
    Rgb(0xAD, 0xDC, 0x30),
    Rgb(0xFD, 0xE7, 0x25),
];

/// Blue, white, red: lightness falls evenly and equally to both sides.
const DIVERGING: [Rgb; 9] = [
    Rgb(0x15, 0x3B, 0x7C),
    Rgb(0x2F, 0x69, 0xAF),
    Rgb(0x73, 0x9C, 0xCF),
    Rgb(0xB5, 0xCD, 0xE6),
    Rgb(0xF7, 0xF7, 0xF7),
    Rgb(0xF1, 0xBE, 0xAE),
    Rgb(0xDF, 0x84, 0x71),
    Rgb(0xBC, 0x45, 0x42),
    Rgb(0x7D, 0x15, 0x24),
];

/// The colour of the series with this index.
pub(super) fn series(index: usize) -> Rgb {
    SERIES[index % SERIES.len()]
}

/// Fill and border of the band with this index.
pub(super) fn band(index: usize) -> (Rgb, Rgb) {
    BANDS[index % BANDS.len()]
}

/// The colour of a place in [0, 1], without a diverging middle.
pub(super) fn rising(at: f64) -> Rgb {
    between(&RISING, at)
}

/// The colour of a place in [0, 1], whose middle is white.
pub(super) fn diverging(at: f64) -> Rgb {
    between(&DIVERGING, at)
}

fn between(stops: &[Rgb; 9], at: f64) -> Rgb {
    let x = at.clamp(0.0, 1.0) * 8.0;
    let i = (x as usize).min(7);
    let t = x - i as f64;
    let mix = |a: u8, b: u8| (f64::from(a) + t * (f64::from(b) - f64::from(a)) + 0.5) as u8;
    let (a, b) = (stops[i], stops[i + 1]);
    Rgb(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}
