//! A scene as a PNG file.

use super::ChartError;
use super::clip::distance;
use super::colour::Rgb;
use super::font::style;
use super::palette::{Indexed, indexed};
use super::scene::{Anchor, Point, Raster, Scene, Shape, Text, WIDTH};
use plotters::backend::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, RGBAColor};

/// Every pixel is the mean of this many squared: plotters places glyphs on whole pixels.
const FINE: usize = 2;

/// The PNG file's bytes.
pub(super) fn render(scene: &Scene) -> Result<Vec<u8>, ChartError> {
    let (width, height) = (WIDTH as usize, libm::ceil(scene.height) as usize);
    let size = ((width * FINE) as u32, (height * FINE) as u32);
    let mut pixels = vec![0xFF; 3 * FINE * FINE * width * height];
    {
        let mut canvas = Canvas { backend: BitMapBackend::with_buffer(&mut pixels, size), size };
        for raster in &scene.rasters {
            canvas.raster(raster)?;
        }
        for shape in &scene.shapes {
            match shape {
                Shape::Stroke { points, colour, width } => canvas.stroke(points, *colour, *width)?,
                // A stroke's round end, twice.
                Shape::Dot { at, radius, colour } => canvas.stroke(&[*at, *at], *colour, 2.0 * radius)?,
                Shape::Fill { rect, colour, alpha } => {
                    canvas.fill((rect.left, rect.top), (rect.right, rect.bottom), *colour, *alpha)?;
                }
                Shape::Text(text) => canvas.text(text, scene)?,
            }
        }
    }
    // A ramp needs all that a palette holds, curves and texts look the same in 32 colours.
    let last = if scene.rasters.is_empty() { 31 } else { 255 };
    let Indexed { palette, pixels } = indexed(&shrink(&pixels, width, height), last);
    write(&pixels, width, height, |encoder| {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette);
        encoder.set_compression(png::Compression::High);
        // After the compression, which brings a filter of its own. Places in a palette do not rise and fall
        // like colours: differences between them say nothing.
        encoder.set_filter(png::Filter::NoFilter);
    })
}

/// 8-bit RGB pixels as a PNG file, every colour as it is.
pub(super) fn encode(pixels: &[u8], width: usize, height: usize) -> Result<Vec<u8>, ChartError> {
    write(pixels, width, height, |encoder| encoder.set_color(png::ColorType::Rgb))
}

fn write(
    pixels: &[u8],
    width: usize,
    height: usize,
    format: impl FnOnce(&mut png::Encoder<'_, &mut Vec<u8>>),
) -> Result<Vec<u8>, ChartError> {
    let fail = |e: png::EncodingError| ChartError::Encode(e.to_string());
    let side = |n: usize| u32::try_from(n).map_err(|e| ChartError::Encode(e.to_string()));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side(width)?, side(height)?);
    encoder.set_depth(png::BitDepth::Eight);
    format(&mut encoder);
    let mut writer = encoder.write_header().map_err(fail)?;
    writer.write_image_data(pixels).map_err(fail)?;
    writer.finish().map_err(fail)?;
    Ok(bytes)
}

fn shrink(pixels: &[u8], width: usize, height: usize) -> Vec<u8> {
    let stride = 3 * FINE * width;
    let count = FINE * FINE;
    let mut small = Vec::with_capacity(3 * width * height);
    for y in 0..height {
        for x in 0..width {
            for channel in 0..3 {
                let first = FINE * (y * stride + 3 * x) + channel;
                let sum: usize =
                    (0..count).map(|i| usize::from(pixels[first + i / FINE * stride + i % FINE * 3])).sum();
                small.push(((sum + count / 2) / count) as u8);
            }
        }
    }
    small
}

fn fine(length: f64) -> f64 {
    length * FINE as f64
}

fn whole(length: f64) -> i32 {
    libm::round(length) as i32
}

fn colour_of(colour: Rgb, alpha: f64) -> RGBAColor {
    RGBAColor(colour.0, colour.1, colour.2, alpha)
}

struct Canvas<'a> {
    backend: BitMapBackend<'a>,
    size: (u32, u32),
}

impl Canvas<'_> {
    fn fill(&mut self, from: Point, to: Point, colour: Rgb, alpha: f64) -> Result<(), ChartError> {
        let at = |p: Point| (whole(fine(p.0)), whole(fine(p.1)));
        let (from, to) = (at(from), at(to));
        self.backend.draw_rect(from, to, &colour_of(colour, alpha), true).map_err(ChartError::drawing)
    }

    fn raster(&mut self, raster: &Raster) -> Result<(), ChartError> {
        let r = raster.rect;
        let x = |i: usize| r.left + r.width() * i as f64 / raster.columns as f64;
        let y = |i: usize| r.top + r.height() * i as f64 / raster.rows as f64;
        for (i, &colour) in raster.cells.iter().enumerate() {
            let (column, row) = (i % raster.columns, i / raster.columns);
            self.fill((x(column), y(row)), (x(column + 1), y(row + 1)), colour, 1.0)?;
        }
        Ok(())
    }

    /// A line as the pixels near it. Not plotters' polygon around the line: its corners are whole
    /// pixels, and it opens holes where the line doubles back.
    fn stroke(&mut self, points: &[Point], colour: Rgb, width: f64) -> Result<(), ChartError> {
        let points: Vec<Point> = points.iter().map(|p| (fine(p.0), fine(p.1))).collect();
        let half = 0.5 * fine(width);
        let reach = half + 1.0;
        let span = |coordinate: fn(&Point) -> f64, of: &[Point], limit: u32| {
            let (lo, hi) = of
                .iter()
                .map(coordinate)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
            // Saturates: a line beyond the picture has an empty span.
            let end = ((hi + reach) as usize + 1).min(limit as usize);
            (((lo - reach) as usize).min(end), end)
        };
        let ((left, right), (top, bottom)) =
            (span(|p| p.0, &points, self.size.0), span(|p| p.1, &points, self.size.1));
        let stride = right - left;
        let mut cover = vec![0_u8; stride * (bottom - top)];
        for pair in points.windows(2) {
            let (x, y) = (span(|p| p.0, pair, self.size.0), span(|p| p.1, pair, self.size.1));
            for row in y.0..y.1 {
                for column in x.0..x.1 {
                    // A pixel's middle half a pixel inside the edge is covered, half outside is not.
                    let off = distance((column as f64 + 0.5, row as f64 + 0.5), pair[0], pair[1]);
                    let part = (255.0 * (half + 0.5 - off).clamp(0.0, 1.0)) as u8;
                    let cell = &mut cover[(row - top) * stride + column - left];
                    *cell = part.max(*cell);
                }
            }
        }
        for (i, &part) in cover.iter().enumerate().filter(|&(_, &part)| part > 0) {
            let at = ((left + i % stride) as i32, (top + i / stride) as i32);
            let colour = colour_of(colour, f64::from(part) / 255.0).to_backend_color();
            self.backend.draw_pixel(at, colour).map_err(ChartError::drawing)?;
        }
        Ok(())
    }

    /// Text glyph by glyph: plotters' own layout leaves out the glyphs' left bearings.
    fn text(&mut self, text: &Text, scene: &Scene) -> Result<(), ChartError> {
        let font = scene.font;
        // Half of plotters' size is its distance from top to baseline: whole, so that every glyph's
        // baseline is rounded to the same pixel.
        let size = 2.0 * libm::round(0.5 * fine(text.size) * font.height);
        let em = size / font.height;
        let width = font.width(&text.text, em);
        let back = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        let style = style(size, text.colour, HPos::Left, text.upright);
        let (x, y) = (fine(text.at.0), fine(text.at.1));
        let mut pen = -back;
        for c in text.text.chars() {
            let (advance, bearing) = font.glyph(c);
            let along = pen + libm::floor(bearing * em);
            let at = if text.upright {
                (whole(x + along), whole(y - 0.5 * size))
            } else {
                (whole(x - 0.5 * size), whole(y - along))
            };
            self.backend.draw_text(c.encode_utf8(&mut [0; 4]), &style, at).map_err(ChartError::drawing)?;
            pen += advance * em;
        }
        Ok(())
    }
}
