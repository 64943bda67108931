//! Tables, plots and the report.
pub mod chart;
