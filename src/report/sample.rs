//! One texture lookup, printed.

use super::artifacts::ArtifactError;
use crate::filter::{EllipseFilter, Lookup};
use crate::kernel::pixel::{Axes, Padding};
use crate::scene::weight_sigma;
use serde::Serialize;
use std::fmt::Write;

/// A lookup and what was asked for.
#[derive(Clone, Debug)]
pub struct SampleRow<'a> {
    /// What was found.
    pub lookup: Lookup,
    /// Channels of the image.
    pub channels: usize,
    /// The ellipse under the pixel, in texels of level 0.
    pub axes: Axes<f64>,
    /// The method's name.
    pub method: &'static str,
    /// The weight's name, of an elliptical method.
    pub weight: Option<&'a str>,
    /// Its other parameters.
    pub filter: Option<EllipseFilter>,
}

/// Names of so many channels.
fn channel_names(channels: usize) -> &'static [&'static str] {
    match channels {
        1 => &["grey"],
        2 => &["grey", "alpha"],
        3 => &["red", "green", "blue"],
        _ => &["red", "green", "blue", "alpha"],
    }
}

fn padding_id(padding: Padding) -> &'static str {
    match padding {
        Padding::Plain => "plain",
        Padding::Padded => "padded",
    }
}

fn degrees(radians: f64) -> f64 {
    radians * (180.0 / std::f64::consts::PI)
}

/// A lookup for readers.
pub fn sample_lines(row: &SampleRow<'_>) -> String {
    let values = channel_names(row.channels).iter().zip(row.lookup.value);
    let values: Vec<String> = values.map(|(name, value)| format!("{name} {value}")).collect();
    let mut text = format!(
        "value      {}\naxes       major {}, minor {} (semi-axes, texels of level 0)\ntilt       {} degrees\n\
         level      {}\ntexels     {}\n",
        values.join(", "),
        row.axes.major,
        row.axes.minor,
        degrees(row.axes.tilt),
        row.lookup.level,
        row.lookup.texels
    );
    if row.lookup.fallback {
        text.push_str("fallback   no texel in the ellipse has weight: bilinear there\n");
    }
    let weight = row.weight.map(|weight| format!(", weight {weight}")).unwrap_or_default();
    let _ = write!(text, "method     {}{weight}", row.method);
    if let Some(filter) = &row.filter {
        if let Some(sigma) = weight_sigma(filter.weight) {
            let _ = write!(text, ", σ {sigma}");
        }
        let (conic, axes, rim) = (padding_id(filter.padding), filter.axes.id(), filter.rim.id());
        let _ = write!(text, ", conic {conic}, axes {axes}, rim {rim}");
    }
    text.push('\n');
    text
}

#[derive(Serialize)]
struct Line<'a> {
    value: &'a [f32],
    channels: &'static [&'static str],
    /// Semi-axes, the major and the minor one.
    axes: [f64; 2],
    /// Degrees.
    tilt: f64,
    level: f32,
    texels: u64,
    fallback: bool,
    method: &'static str,
    weight: Option<&'a str>,
    sigma: Option<f32>,
    conic: Option<&'static str>,
    axes_from: Option<&'static str>,
    rim: Option<&'static str>,
}

/// A lookup as one JSON object.
///
/// # Errors
/// [`ArtifactError::Table`] if it cannot be formatted.
pub fn sample_json(row: &SampleRow<'_>) -> Result<String, ArtifactError> {
    let filter = row.filter.as_ref();
    let line = Line {
        value: &row.lookup.value[..row.channels],
        channels: channel_names(row.channels),
        axes: [row.axes.major, row.axes.minor],
        tilt: degrees(row.axes.tilt),
        level: row.lookup.level,
        texels: row.lookup.texels,
        fallback: row.lookup.fallback,
        method: row.method,
        weight: row.weight,
        sigma: filter.and_then(|f| weight_sigma(f.weight)),
        conic: filter.map(|f| padding_id(f.padding)),
        axes_from: filter.map(|f| f.axes.id()),
        rim: filter.map(|f| f.rim.id()),
    };
    let text = serde_json::to_string(&line).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}
