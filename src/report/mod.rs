//! Tables, plots and the report, all made from one [`Study`]: whatever is written here was computed
//! elsewhere.

pub mod chart;
pub mod figures;

mod albedo_table;
mod artifacts;
mod better;
mod computed;
mod constants;
mod energy;
mod factor_table;
mod kernel_table;
mod markdown;
mod number;
mod pixel;
mod readme;
mod study;
mod summary;
mod suprema;
mod table_one;
mod tables;
mod terminal;

pub use artifacts::{ArtifactError, Artifacts};
pub use pixel::PixelStudy;
pub use study::{NearestRow, PrintedFactor, Study, StudyError, SupremumRow};
pub use tables::judgements_json;
pub use terminal::{factor_json, factor_lines, fit_json, fit_lines, judgement_lines, verdict_lines};
