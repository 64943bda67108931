//! What the plots' colours become on a dark page: as light on it as they were dark on white, the hue kept.

use super::colour::{BANDS, FRAME, GREY, GRID, MISSING, Rgb, SERIES, WHITE};

/// The dark page's ground, in place of white.
const GROUND: Rgb = Rgb(0x15, 0x18, 0x1C);
/// In the order of [`SERIES`].
const DARK_SERIES: [Rgb; 8] = [
    Rgb(0x52, 0xA8, 0xE8),
    Rgb(0xF5, 0x83, 0x3B),
    Rgb(0x2B, 0xC4, 0x97),
    Rgb(0xDF, 0x9A, 0xC2),
    Rgb(0xE6, 0x9F, 0x00),
    Rgb(0x8F, 0xD0, 0xF5),
    Rgb(0xE4, 0xE7, 0xEA),
    Rgb(0x8C, 0x8C, 0x8C),
];
/// In the order of [`BANDS`].
const DARK_BANDS: [(Rgb, Rgb); 4] = [
    (Rgb(0x38, 0x31, 0x14), Rgb(0xA8, 0x8D, 0x30)),
    (Rgb(0x1C, 0x2B, 0x38), Rgb(0x5E, 0x86, 0xA3)),
    (Rgb(0x2A, 0x2D, 0x31), Rgb(0x7A, 0x7F, 0x85)),
    (Rgb(0x38, 0x22, 0x30), Rgb(0xA8, 0x76, 0x92)),
];
/// Text and lines.
const DARK_LINES: [(Rgb, Rgb); 5] = [
    (GREY, Rgb(0xA6, 0xAE, 0xB7)),
    (FRAME, Rgb(0x80, 0x88, 0x91)),
    (GRID, Rgb(0x30, 0x35, 0x3B)),
    (MISSING, Rgb(0x4A, 0x50, 0x57)),
    (WHITE, GROUND),
];

/// Every colour of the palettes, and what it is on a dark page, as SVG writes them. The ink is the series'
/// darkest; the cells of heat maps keep their colours.
pub(in crate::report) fn dark_colours() -> Vec<(String, String)> {
    let bands =
        BANDS.into_iter().zip(DARK_BANDS).flat_map(|(light, dark)| [(light.0, dark.0), (light.1, dark.1)]);
    let all = SERIES.into_iter().zip(DARK_SERIES).chain(bands).chain(DARK_LINES);
    all.map(|(light, dark)| (hex(light), hex(dark))).collect()
}

fn hex(Rgb(red, green, blue): Rgb) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::chart::colour::INK;

    /// WCAG 2.1's relative luminance.
    fn luminance(Rgb(red, green, blue): Rgb) -> f64 {
        let linear = |code: u8| {
            let s = f64::from(code) / 255.0;
            if s <= 0.04045 { s / 12.92 } else { libm::pow((s + 0.055) / 1.055, 2.4) }
        };
        0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
    }

    /// Its ratio of contrast.
    fn contrast(a: Rgb, b: Rgb) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn every_colour_is_told_from_the_dark_ground() {
        // WCAG 2.1 asks for 4.5 of text and for 3 of lines that mean something.
        assert!(SERIES.contains(&INK));
        for dark in DARK_SERIES {
            assert!(contrast(dark, GROUND) >= 4.5, "{dark:?}");
        }
        for (light, dark) in DARK_LINES {
            let least = if light == GREY {
                4.5
            } else if light == FRAME {
                3.0
            } else {
                1.0
            };
            assert!(contrast(dark, GROUND) >= least, "{dark:?}");
        }
        for (fill, border) in DARK_BANDS {
            assert!(contrast(border, GROUND) >= 3.0, "{border:?}");
            // Curves and text lie over bands as well.
            for over in DARK_SERIES {
                assert!(contrast(over, fill) >= 3.0, "{over:?} over {fill:?}");
            }
        }
        let colours = dark_colours();
        assert_eq!(colours.len(), SERIES.len() + 2 * BANDS.len() + DARK_LINES.len());
        assert!(colours.contains(&("#FFFFFF".to_owned(), "#15181C".to_owned())));
    }
}
