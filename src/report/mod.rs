//! Tables, plots and the report, all made from one [`Study`]: whatever is written here was computed
//! elsewhere.

pub mod chart;
pub mod figures;

mod albedo_table;
mod artifacts;
mod better;
mod choice;
mod choice_json;
mod choice_scene;
mod computed;
mod constants;
mod energy;
mod factor_table;
mod filter_images;
mod filter_section;
mod filter_table;
mod filter_time;
mod kernel_table;
mod markdown;
mod number;
mod pixel;
mod readme;
mod sample;
mod stability_section;
mod stability_table;
mod study;
mod summary;
mod suprema;
mod table_one;
mod tables;
mod terminal;
mod trade_figure;
mod trade_files;
mod trade_table;
mod trade_words;

pub use artifacts::{ArtifactError, Artifacts};
pub use choice::choice_lines;
pub use choice_json::{choice_json, scene_choice_json};
pub use choice_scene::scene_choice_lines;
pub use filter_images::filter_files;
pub use filter_table::{filter_csv, filter_lines};
pub use filter_time::measured_files;
pub use pixel::PixelStudy;
pub use sample::{SampleRow, sample_json, sample_lines};
pub use study::{NearestRow, PrintedFactor, Study, StudyError, SupremumRow};
pub use tables::judgements_json;
pub use terminal::{factor_json, factor_lines, fit_json, fit_lines, judgement_lines, verdict_lines};
pub use trade_files::trade_files;
pub use trade_table::trade_lines;
