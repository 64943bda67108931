//! The embedded font: its registration with plotters, and its widths.
//!
//! `DejaVuSans-subset.ttf` is DejaVu Sans 2.37 (licence beside it), cut down with fonttools 4.68:
//!
//! ```text
//! pyftsubset DejaVuSans.ttf --output-file=DejaVuSans-subset.ttf --layout-features="" --no-hinting
//!   --unicodes="20-7E,A0-17F,2C6,2DC,391-3A9,3B1-3C9,3D1,3D5,3F5,1D40,1D4F,2013,2014,2018-201D,2020,
//!   2022,2026,2032,2033,2070-2093,2099,2113,2190-2194,21D2,2200,2202,2203,2205-2209,2211-2213,2215,
//!   2218-221E,2220,2227-222B,2245,2248,2260,2261,2264,2265,226A,226B,2295,2297,22C5,2308-230B,25A0,
//!   25CF,2713,2717" --name-IDs=0,1,2,3,5,13,14 --drop-tables+=MATH,kern,GPOS,GSUB,GDEF,FFTM,gasp
//! ```

use super::ChartError;
use super::colour::Rgb;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, TextStyle};
use std::collections::BTreeMap;
use std::sync::OnceLock;

static BYTES: &[u8] = include_bytes!("DejaVuSans-subset.ttf");

/// One name for both formats: plotters' key for the embedded font, and a browser's list of choices.
const FAMILY: FontFamily<'static> = FontFamily::Name("DejaVu Sans, Verdana, sans-serif");

/// Advance and left bearing of every glyph, in ems.
#[derive(Debug)]
pub(super) struct Font {
    glyphs: BTreeMap<char, (f64, f64)>,
    missing: (f64, f64),
    /// Ascent and descent together, which is what plotters' bitmap text calls its size.
    pub(super) height: f64,
}

/// The font, read and registered at the first call.
pub(super) fn font() -> Result<&'static Font, ChartError> {
    static FONT: OnceLock<Option<Font>> = OnceLock::new();
    FONT.get_or_init(|| {
        let FontFamily::Name(name) = FAMILY else { return None };
        plotters::style::register_font(name, FontStyle::Normal, BYTES).ok()?;
        Font::read(BYTES)
    })
    .as_ref()
    .ok_or(ChartError::Font)
}

/// Text in the embedded font, `size` in plotters' measure, placed by its anchor at the top.
pub(super) fn style(size: f64, colour: Rgb, across: HPos, upright: bool) -> TextStyle<'static> {
    let turn = if upright { FontTransform::None } else { FontTransform::Rotate270 };
    FontDesc::new(FAMILY, size, FontStyle::Normal)
        .transform(turn)
        .color(&RGBColor(colour.0, colour.1, colour.2))
        .pos(Pos::new(across, VPos::Top))
}

impl Font {
    /// Advance and left bearing of one character, in ems; of a box, where the font lacks it.
    pub(super) fn glyph(&self, c: char) -> (f64, f64) {
        self.glyphs.get(&c).copied().unwrap_or(self.missing)
    }

    /// The width of a text of this size.
    pub(super) fn width(&self, text: &str, size: f64) -> f64 {
        text.chars().map(|c| self.glyph(c).0).sum::<f64>() * size
    }

    /// The text in lines that fit the width, with room for a browser's wider font; one word is never
    /// broken.
    pub(super) fn wrap(&self, text: &str, size: f64, width: f64) -> Vec<String> {
        const ROOM: f64 = 0.92;
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            match lines.last_mut() {
                Some(line) if self.width(&format!("{line} {word}"), size) <= ROOM * width => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    }

    // plotters hides the glyphs' metrics, and its bitmap text leaves out the left bearing; the file
    // has both.
    fn read(bytes: &[u8]) -> Option<Self> {
        let units = f64::from(u16_at(bytes, table(bytes, b"head")? + 18)?);
        let hhea = table(bytes, b"hhea")?;
        let (ascent, descent) = (i16_at(bytes, hhea + 4)?, i16_at(bytes, hhea + 6)?);
        let full = usize::from(u16_at(bytes, hhea + 34)?);
        let hmtx = table(bytes, b"hmtx")?;
        let metrics = |glyph: usize| {
            // The last advance stands for all glyphs after it.
            let entry = hmtx + 4 * glyph.min(full.checked_sub(1)?);
            let bearing = if glyph < full { entry + 2 } else { hmtx + 4 * full + 2 * (glyph - full) };
            Some((f64::from(u16_at(bytes, entry)?) / units, f64::from(i16_at(bytes, bearing)?) / units))
        };
        let mut glyphs = BTreeMap::new();
        for (c, glyph) in characters(bytes)? {
            glyphs.insert(c, metrics(glyph)?);
        }
        Some(Self { glyphs, missing: metrics(0)?, height: (f64::from(ascent) - f64::from(descent)) / units })
    }
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?))
}

fn i16_at(bytes: &[u8], at: usize) -> Option<i16> {
    u16_at(bytes, at).map(u16::cast_signed)
}

fn u32_at(bytes: &[u8], at: usize) -> Option<usize> {
    Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize)
}

/// Where a table of the file begins.
fn table(bytes: &[u8], tag: &[u8; 4]) -> Option<usize> {
    let count = usize::from(u16_at(bytes, 4)?);
    let entry = (0..count).map(|i| 12 + 16 * i).find(|&at| bytes.get(at..at + 4) == Some(tag))?;
    u32_at(bytes, entry + 8)
}

/// The characters and their glyphs, from the format 4 map.
fn characters(bytes: &[u8]) -> Option<Vec<(char, usize)>> {
    let cmap = table(bytes, b"cmap")?;
    let count = usize::from(u16_at(bytes, cmap + 2)?);
    let map = (0..count)
        .filter_map(|i| u32_at(bytes, cmap + 4 + 8 * i + 4))
        .map(|offset| cmap + offset)
        .find(|&at| u16_at(bytes, at) == Some(4))?;
    let segments = usize::from(u16_at(bytes, map + 6)?) / 2;
    let mut found = Vec::new();
    for i in 0..segments {
        // Four arrays in a row: last codes (and a gap of two bytes), first codes, deltas, offsets.
        let column = |array: usize| map + 14 + 2 * (array * segments + i) + usize::from(array > 0) * 2;
        let (last, first) = (u16_at(bytes, column(0))?, u16_at(bytes, column(1))?);
        let (delta, offset) = (u16_at(bytes, column(2))?, u16_at(bytes, column(3))?);
        for code in first..=last {
            let glyph = if offset == 0 {
                code.wrapping_add(delta)
            } else {
                let at = column(3) + usize::from(offset) + 2 * usize::from(code - first);
                match u16_at(bytes, at) {
                    Some(glyph) if glyph != 0 => glyph.wrapping_add(delta),
                    _ => 0,
                }
            };
            if let (Some(c), true) = (char::from_u32(u32::from(code)), glyph != 0) {
                found.push((c, usize::from(glyph)));
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::font;

    #[test]
    fn the_characters_of_the_reports_are_there() {
        let font = font().unwrap();
        let needed = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿ₀₁₂₃₄₅₆₇₈₉₋₊ₙ−·×≤≥≈±√∞∫∂→′½¼°–—…ΔπθαΩ";
        let greek = ('α'..='ω').chain(('Α'..='Ω').filter(|&c| c != '\u{3a2}'));
        for c in (' '..='~').chain(needed.chars()).chain(greek) {
            assert!(font.glyphs.contains_key(&c), "{c:?} is not in the font");
        }
    }

    #[test]
    fn widths_are_those_of_the_file() {
        // DejaVu Sans: 2048 units an em, digits 1303 wide, M 1767, i 569.
        let font = font().unwrap();
        assert_eq!(font.width("0", 2048.0), 1303.0);
        assert_eq!(font.width("Mi", 2048.0), 1767.0 + 569.0);
        assert_eq!(font.height, (1901.0 + 483.0) / 2048.0);
    }

    #[test]
    fn long_texts_wrap_and_a_long_word_stays_whole() {
        let font = font().unwrap();
        let lines = font.wrap("a few short words and one loooooooooooong", 20.0, 200.0);
        assert!(lines.len() > 2);
        assert_eq!(lines.join(" "), "a few short words and one loooooooooooong");
    }
}
