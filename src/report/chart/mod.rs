//! Plots, as SVG text and as PNG bytes, the same bytes on every run and machine.
//!
//! A [`Chart`] is data: axes, curves, bands, cells. Its picture is laid out once as a scene of
//! strokes, rectangles and texts, which both formats render; texts are measured in the embedded
//! font, so that no font need be installed.
//!
//! ```
//! use bellfit::report::chart::{Axis, Chart, LineChart, Scale, Series, Style};
//!
//! let curve = (0..=100).map(|i| f64::from(i) / 100.0).map(|t| (t, 1.0 - t * t)).collect();
//! let chart = Chart::Line(LineChart {
//!     title: "A parabola".into(),
//!     subtitle: String::new(),
//!     x: Axis::new("t", Scale::Linear, (0.0, 1.0)),
//!     y: Axis::new("1 − t²", Scale::Linear, (0.0, 1.0)),
//!     bands: vec![],
//!     series: vec![Series::new("1 − t²", Style::Line, curve)],
//!     marks: vec![],
//! });
//! assert!(chart.svg()?.starts_with("<svg"));
//! # Ok::<(), bellfit::report::chart::ChartError>(())
//! ```

mod axis;
mod clip;
mod colour;
mod dark;
mod error;
mod font;
mod frame;
mod header;
mod heat;
mod label;
mod legend;
mod line;
mod mark;
mod number;
mod palette;
mod panels;
mod png;
mod scene;
mod series;
mod stroke;
mod svg;
mod ticks;

pub(super) use dark::dark_colours;

pub use axis::{Axis, Scale};
pub use error::ChartError;
pub use heat::HeatMap;
pub use label::label;
pub use line::LineChart;
pub use mark::Mark;
pub use panels::Panels;
pub use series::{Band, Series, Style};

/// A picture, 1600 pixels wide and as tall as it needs, to be shown at about half that width.
#[derive(Clone, Debug, PartialEq)]
pub enum Chart {
    /// Curves over one pair of axes.
    Line(LineChart),
    /// A value over two arguments, as colour.
    Heat(HeatMap),
    /// Small multiples with one legend.
    Panels(Panels),
}

impl Chart {
    /// The picture as SVG text that scales to the width it is given.
    ///
    /// # Errors
    ///
    /// Where the chart has nothing to draw or a range that cannot be drawn.
    pub fn svg(&self) -> Result<String, ChartError> {
        svg::render(&self.scene()?)
    }

    /// The picture as the bytes of a PNG file.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    pub fn png(&self) -> Result<Vec<u8>, ChartError> {
        png::render(&self.scene()?)
    }

    fn scene(&self) -> Result<scene::Scene, ChartError> {
        match self {
            Self::Line(chart) => chart.scene(),
            Self::Heat(map) => map.scene(),
            Self::Panels(panels) => panels.scene(),
        }
    }
}
