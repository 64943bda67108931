use super::ChartError;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    #[default]
    Line,
    /// A line of dashes.
    Dashed,
    /// A line of dots.
    Dotted,
    /// The points alone, unconnected.
    Points,
}

/// A curve, or a set of points.
///
/// A point with a coordinate that is not finite, or not positive on a logarithmic axis, is not drawn
/// and splits the line. What lies outside the axes' ranges is cut at the frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The text in the legend; empty: not in the legend. Series of one label share a colour.
    pub label: String,
    /// The points, in the order in which they are joined.
    pub points: Vec<(f64, f64)>,
    /// How they are drawn.
    pub style: Style,
    /// The place in the palette of eight colours, counted from 0 and around; none: the next one.
    pub colour: Option<usize>,
}

impl Series {
    /// A series in the palette's next colour.
    #[must_use]
    pub fn new(label: impl Into<String>, style: Style, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, style, colour: None }
    }

    pub(super) fn check(&self) -> Result<(), ChartError> {
        if self.points.is_empty() {
            return Err(ChartError::EmptySeries { label: self.label.clone() });
        }
        Ok(())
    }
}

/// A horizontal band, such as a printed bound; an end may be infinite.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// The text in the legend; empty: not in the legend.
    pub label: String,
    /// The lower end.
    pub lo: f64,
    /// The upper end, not below the lower.
    pub hi: f64,
}

impl Band {
    pub(super) fn check(&self) -> Result<(), ChartError> {
        if self.lo <= self.hi {
            return Ok(());
        }
        Err(ChartError::Band { label: self.label.clone(), lo: self.lo, hi: self.hi })
    }
}
