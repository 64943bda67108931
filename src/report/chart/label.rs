//! One line of text as grey pixels, for pictures that are no charts.

use super::ChartError;
use super::colour::{INK, WHITE};
use super::font::{font, style};
use plotters::backend::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::HPos;

/// Writes a line of text into rows of 8-bit grey pixels, dark on white: `width` × `height` of them, the text at
/// the left, as large as the height allows.
///
/// ```
/// use bellfit::report::chart::label;
/// let pixels = label("Q ≤ 1", 60, 16)?;
/// assert!(pixels.len() == 60 * 16 && pixels.iter().any(|&p| p < 64) && pixels[0] == 255);
/// # Ok::<(), bellfit::report::chart::ChartError>(())
/// ```
///
/// # Errors
///
/// Where the font cannot be read or drawn.
pub fn label(text: &str, width: usize, height: usize) -> Result<Vec<u8>, ChartError> {
    let font = font()?;
    let side = |n: usize| u32::try_from(n).map_err(|e| ChartError::Encode(e.to_string()));
    let mut pixels = vec![WHITE.0; 3 * width * height];
    {
        let mut backend = BitMapBackend::with_buffer(&mut pixels, (side(width)?, side(height)?));
        // Whole halves, as in the charts: every glyph's baseline on one pixel.
        let size = 2.0 * libm::floor(0.5 * 0.9 * height as f64);
        let em = size / font.height;
        let style = style(size, INK, HPos::Left, true);
        // Half of plotters' size lies over the baseline, which keeps a quarter em below it.
        let top = height as i32 - libm::ceil(0.25 * em) as i32 - (0.5 * size) as i32;
        let mut pen = 0.0;
        for c in text.chars() {
            let (advance, bearing) = font.glyph(c);
            let at = (libm::round(pen + libm::floor(bearing * em)) as i32, top);
            backend.draw_text(c.encode_utf8(&mut [0; 4]), &style, at).map_err(ChartError::drawing)?;
            pen += advance * em;
        }
    }
    Ok(pixels.chunks_exact(3).map(|p| p[0]).collect())
}
