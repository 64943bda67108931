//! A scene as SVG text.

use super::ChartError;
use super::font::style;
use super::png::encode;
use super::scene::{Anchor, Point, Raster, Scene, Shape, Text, WIDTH};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::HPos;
use plotters::style::{RGBAColor, ShapeStyle};
use std::fmt::Write as _;

/// plotters' coordinates are integers: one pixel is this many of them.
const FINE: f64 = 4.0;
/// plotters writes its text sizes divided by this, ...
const SIZE: f64 = 1.24;
/// ... and text hung by its top this far down from there, in font sizes.
const DROP: f64 = 0.76;

/// The SVG element; the cells, which plotters cannot draw, lie between background and shapes.
pub(super) fn render(scene: &Scene) -> Result<String, ChartError> {
    let (width, height) = (fine(WIDTH), fine(scene.height));
    let mut body = String::new();
    {
        let mut backend = SVGBackend::with_string(&mut body, (width.cast_unsigned(), height.cast_unsigned()));
        for shape in &scene.shapes {
            draw(&mut backend, shape)?;
        }
        backend.present().map_err(ChartError::drawing)?;
    }
    // plotters' own opening tag fixes the size in its fine units.
    let (_, body) = body.split_once('\n').unwrap_or_default();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100%\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\"{COMMON} stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n",
        escape(&scene.title)
    );
    for raster in &scene.rasters {
        image(&mut svg, raster)?;
    }
    svg.push_str(&brief(body));
    Ok(svg)
}

fn draw(backend: &mut SVGBackend<'_>, shape: &Shape) -> Result<(), ChartError> {
    match shape {
        Shape::Stroke { points, colour, width } => {
            let style = ShapeStyle {
                color: RGBAColor(colour.0, colour.1, colour.2, 1.0),
                filled: false,
                stroke_width: fine(*width).cast_unsigned(),
            };
            let mut path: Vec<(i32, i32)> = points.iter().map(|&p| position(p)).collect();
            path.dedup();
            backend.draw_path(path, &style).map_err(ChartError::drawing)
        }
        Shape::Fill { rect, colour, alpha } => {
            let (from, to) = (position((rect.left, rect.top)), position((rect.right, rect.bottom)));
            let colour = RGBAColor(colour.0, colour.1, colour.2, *alpha);
            backend.draw_rect(from, to, &colour, true).map_err(ChartError::drawing)
        }
        Shape::Dot { at, radius, colour } => {
            let colour = RGBAColor(colour.0, colour.1, colour.2, 1.0);
            let radius = fine(*radius).cast_unsigned();
            backend.draw_circle(position(*at), radius, &colour, true).map_err(ChartError::drawing)
        }
        Shape::Text(Text { at, text, size, colour, anchor, upright }) => {
            let across = match anchor {
                Anchor::Start => HPos::Left,
                Anchor::Middle => HPos::Center,
                Anchor::End => HPos::Right,
            };
            let style = style(undivided(size * FINE), *colour, across, *upright);
            let drop = DROP * size;
            let top = if *upright { (at.0, at.1 - drop) } else { (at.0 - drop, at.1) };
            backend.draw_text(text, &style, position(top)).map_err(ChartError::drawing)
        }
    }
}

/// The cells as a tiny PNG stretched over their rectangle: a shape a cell would be megabytes.
fn image(svg: &mut String, raster: &Raster) -> Result<(), ChartError> {
    let pixels: Vec<u8> = raster.cells.iter().flat_map(|c| [c.0, c.1, c.2]).collect();
    let bytes = encode(&pixels, raster.columns, raster.rows)?;
    let ((x, y), (right, bottom)) =
        (position((raster.rect.left, raster.rect.top)), position((raster.rect.right, raster.rect.bottom)));
    let _ = writeln!(
        svg,
        "<image x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
         style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>",
        right - x,
        bottom - y,
        STANDARD.encode(&bytes)
    );
    Ok(())
}

/// The size that plotters' division turns into this one without a rounded last digit.
fn undivided(size: f64) -> f64 {
    let near = size * SIZE;
    [near.next_down(), near.next_up()].into_iter().find(|s| s / SIZE == size).unwrap_or(near)
}

fn fine(length: f64) -> i32 {
    libm::round(length * FINE) as i32
}

fn position((x, y): Point) -> (i32, i32) {
    (fine(x), fine(y))
}

/// What plotters says of every line and every text, said once for all of them.
const COMMON: &str = " fill=\"none\" font-family=\"DejaVu Sans, Verdana, sans-serif\"";

/// The shapes without what is common to all or the default.
fn brief(body: &str) -> String {
    let (line, family) = COMMON.split_at(" fill=\"none\"".len());
    let all = [line, family, " opacity=\"1\"", " stroke=\"none\"", " text-anchor=\"start\""];
    let body = all.iter().fold(body.to_owned(), |body, part| body.replace(part, ""));
    body.replace(" \"/>", "\"/>").replace("\">\n", "\">").replace("\n</text>", "</text>")
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
