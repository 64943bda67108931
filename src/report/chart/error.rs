/// Why a chart cannot be drawn; each message names the offending value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ChartError {
    /// A chart without series.
    #[error("chart \"{title}\" has no series")]
    NoSeries {
        /// The chart's title.
        title: String,
    },
    /// A series without points.
    #[error("series \"{label}\" has no points")]
    EmptySeries {
        /// The series' label.
        label: String,
    },
    /// A range that is reversed, empty or not finite.
    #[error("axis \"{axis}\": the range {lo} to {hi} is not finite and rising")]
    Range {
        /// The axis' label.
        axis: String,
        /// The range's first end.
        lo: f64,
        /// The range's second end.
        hi: f64,
    },
    /// A logarithmic axis that reaches zero or below.
    #[error("axis \"{axis}\": the range {lo} to {hi} is not positive, as a logarithmic scale needs")]
    LogRange {
        /// The axis' label.
        axis: String,
        /// The range's first end.
        lo: f64,
        /// The range's second end.
        hi: f64,
    },
    /// A band with a NaN end or with its ends reversed.
    #[error("band \"{label}\": {lo} to {hi} is not in order")]
    Band {
        /// The band's label.
        label: String,
        /// The lower end.
        lo: f64,
        /// The upper end.
        hi: f64,
    },
    /// A heat map whose values do not fill its cells, or without cells.
    #[error("heat map \"{title}\": {given} values for {columns} columns × {rows} rows")]
    Cells {
        /// The map's title.
        title: String,
        /// Cells across.
        columns: usize,
        /// Cells down.
        rows: usize,
        /// The values that were given.
        given: usize,
    },
    /// No panels, or no columns to put them in.
    #[error("panels \"{title}\": {charts} charts in {columns} columns")]
    Panels {
        /// The figure's title.
        title: String,
        /// The columns asked for.
        columns: usize,
        /// The charts given.
        charts: usize,
    },
    /// The embedded font is damaged.
    #[error("the embedded font cannot be read")]
    Font,
    /// The drawing library failed.
    #[error("drawing failed: {0}")]
    Draw(String),
    /// The PNG encoder failed.
    #[error("PNG encoding failed: {0}")]
    Encode(String),
}

impl ChartError {
    /// plotters' errors, whose type has no name outside its backends.
    pub(super) fn drawing(error: impl std::fmt::Display) -> Self {
        Self::Draw(error.to_string())
    }
}
