//! The files of a run: made in memory, then compared or written whole.

use super::figures::{self, Better, Figure, ResidualLine};
use super::measured::{FOLDER, Measured};
use super::study::Study;
use super::study::case;
use super::{
    albedo_table, constants, factor_table, filter_images, filter_table, html, kernel_table, markdown, pixel,
    readme, stability_table, table_one, tables,
};
use crate::fit::Objective;
use crate::integral::{Limit, Lobe};
use crate::kernel::model::Model;
use crate::scene::ImageError;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// What can go wrong between a study and its files.
#[derive(Debug, Error)]
pub enum ArtifactError {
    /// A table could not be formatted.
    #[error("table: {0}")]
    Table(String),
    /// A plot could not be drawn.
    #[error("plot: {0}")]
    Plot(#[from] figures::FigureError),
    /// A picture could not be made.
    #[error("picture: {0}")]
    Picture(#[from] ImageError),
    /// A file could not be read or written.
    #[error("{path}: {reason}")]
    File {
        /// Which file.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// The README has no place for the table.
    #[error("README.md: {0}")]
    Readme(String),
}

impl From<csv::Error> for ArtifactError {
    fn from(error: csv::Error) -> Self {
        ArtifactError::Table(error.to_string())
    }
}

/// Generated files by their path relative to the output folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Artifacts {
    files: BTreeMap<String, Vec<u8>>,
}

/// Where the adopted constants stand, relative to the crate.
const CONSTANTS: &str = "src/kernel/constants.rs";

impl Artifacts {
    /// Everything under fits/ and reports/ but what is measured, which the report shows as it is given.
    ///
    /// # Errors
    /// [`ArtifactError`] if a table or plot cannot be made.
    pub fn generate(study: &Study, measured: &Measured) -> Result<Self, ArtifactError> {
        let mut files = BTreeMap::new();
        for model in Model::ALL {
            files.insert(
                format!("fits/integrals/{}.csv", model.id()),
                tables::integrals(&study.integrals, model)?,
            );
        }
        files.insert(
            "fits/coefficients.csv".to_owned(),
            tables::coefficients(&study.integrals, &study.printed, &study.fits)?,
        );
        files.insert("fits/nearest.csv".to_owned(), tables::nearest(&study.nearest)?);
        files.insert("fits/suprema.csv".to_owned(), tables::suprema(&study.suprema)?);
        let factors = study.factors.iter().chain(&study.cubic_factors);
        files.insert("fits/factors.csv".to_owned(), factor_table::factors_csv(factors)?);
        files.insert("fits/kernels.csv".to_owned(), kernel_table::exponential(&study.exponential)?);
        files.insert("fits/kernels-cosn.csv".to_owned(), kernel_table::cosine(&study.cosine)?);
        files.insert("fits/albedo.csv".to_owned(), albedo_table::albedo_csv(&study.albedos)?);
        files.insert("fits/albedo-suprema.csv".to_owned(), albedo_table::albedo_suprema_csv(&study.albedos)?);
        files.insert("fits/clip.csv".to_owned(), pixel::clip_csv(&study.pixel.clip)?);
        files.insert("fits/footprint.csv".to_owned(), pixel::footprint_csv()?);
        files.insert("fits/weights.csv".to_owned(), pixel::texels_csv(&study.pixel.texels)?);
        files.insert("fits/pixel-weights.csv".to_owned(), pixel::weights_csv(&study.pixel.weights)?);
        files.insert("fits/table1.csv".to_owned(), table_one::csv(study)?);
        files.insert("fits/filter.csv".to_owned(), filter_table::filter_csv(&study.filters)?);
        files.insert("fits/stability.csv".to_owned(), stability_table::lobes(&study.stability)?);
        let of_factors = stability_table::factors(&study.stability)?;
        files.insert("fits/stability-factors.csv".to_owned(), of_factors);
        let of_footprints = stability_table::footprints(&study.stability)?;
        files.insert("fits/stability-footprint.csv".to_owned(), of_footprints);
        files.insert("fits/stability-clip.csv".to_owned(), stability_table::clips(&study.stability)?);
        for (name, bytes) in filter_images::sheets(&study.filters)? {
            files.insert(format!("reports/images/{name}"), bytes);
        }
        files.insert("reports/table1.md".to_owned(), table_one::markdown(study).into_bytes());
        files.insert("reports/table1.tex".to_owned(), table_one::latex(study).into_bytes());
        files.insert(
            "reports/verdicts.csv".to_owned(),
            tables::verdicts_csv(&study.judgements, &study.expectations)?,
        );
        files.insert(
            "reports/verdicts.json".to_owned(),
            tables::verdicts_json(&study.judgements, &study.expectations)?,
        );
        let mut figures = figures::figures(&residual_lines(study))?;
        figures.extend(figures::better(Better {
            factors: &study.factors,
            exponential: &study.exponential,
            cosine: &study.cosine,
            albedos: &study.albedo_curves,
        })?);
        figures.extend(figures::pixel(figures::Pixel {
            clip: &study.pixel.clip,
            weights: &study.pixel.weights,
            texels: &study.pixel.texels,
        }));
        figures.extend(figures::stability(&study.stability));
        for (name, bytes) in figures::render(&figures)? {
            files.insert(format!("reports/plots/{name}"), bytes);
        }
        let mut artifacts = Artifacts { files };
        artifacts.report(study, &figures, measured);
        Ok(artifacts)
    }

    /// Adds the report in both its forms, which lists the files that are there and itself.
    fn report(&mut self, study: &Study, figures: &[Figure], measured: &Measured) {
        const REPORTS: [&str; 2] = ["reports/report.html", "reports/report.md"];
        let mut paths: Vec<String> = measured.names().map(|name| format!("{FOLDER}/{name}")).collect();
        paths.extend(self.files.keys().cloned().chain(REPORTS.map(str::to_owned)));
        paths.sort();
        let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
        let report = markdown::report(study, figures, measured, &paths);
        let page = html::page(&report, &html::Pictures { files: &self.files, measured });
        let [html, markdown] = REPORTS;
        self.insert(html, page.into_bytes());
        self.insert(markdown, report.into_bytes());
    }

    /// Adds the README.md of `root`, if there is one, with the blocks it has markers for written anew.
    ///
    /// # Errors
    /// [`ArtifactError`] if it cannot be read or has lost an end marker.
    pub fn splice_readme(&mut self, study: &Study, root: &Path) -> Result<(), ArtifactError> {
        let path = root.join("README.md");
        match std::fs::read_to_string(&path) {
            Ok(text) => {
                let spliced = readme::splice_all(&text, study)?;
                self.files.insert("README.md".to_owned(), spliced.into_bytes());
                Ok(())
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(()),
            Err(error) => Err(file_error(&path, &error)),
        }
    }

    /// The kernels' constants as this study would adopt them, if `root` is this crate and has others.
    ///
    /// # Errors
    /// [`ArtifactError::Table`] if a model has no constants.
    pub fn constants(study: &Study, root: &Path) -> Result<Self, ArtifactError> {
        let source = constants::source(study);
        let source = source.ok_or_else(|| ArtifactError::Table("a model has no constants".to_owned()))?;
        let mut files = BTreeMap::new();
        if std::fs::read_to_string(root.join(CONSTANTS)).is_ok_and(|found| found.contains(constants::MARK)) {
            files.insert(CONSTANTS.to_owned(), source.into_bytes());
        }
        Ok(Artifacts { files })
    }

    /// The files, by path.
    pub fn files(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice()))
    }

    /// Adds or replaces one file.
    pub fn insert(&mut self, path: &str, bytes: Vec<u8>) {
        self.files.insert(path.to_owned(), bytes);
    }

    /// Every path whose file under `root` is missing or differs, with what is the matter.
    pub fn differences(&self, root: &Path) -> Vec<String> {
        let differs = |(path, bytes): (&String, &Vec<u8>)| match std::fs::read(root.join(path)) {
            Ok(found) if found == *bytes => None,
            Ok(found) => {
                let same = found.iter().zip(bytes.iter()).take_while(|(a, b)| a == b).count();
                let line = bytes[..same].iter().filter(|b| **b == b'\n').count() + 1;
                Some(format!("{path} differs, first at line {line}"))
            }
            Err(error) => Some(format!("{path}: {}", reason(&error))),
        };
        self.files.iter().filter_map(differs).collect()
    }

    /// Makes the folder `root` if it is missing, and a file in it that goes again: before a long computation
    /// whose result could not be written.
    ///
    /// # Errors
    /// [`ArtifactError::File`].
    pub fn try_folder(root: &Path) -> Result<(), ArtifactError> {
        let probe = root.join(".bellfit.tmp");
        std::fs::create_dir_all(root).map_err(|e| file_error(root, &e))?;
        std::fs::write(&probe, b"").map_err(|e| file_error(root, &e))?;
        std::fs::remove_file(&probe).map_err(|e| file_error(&probe, &e))
    }

    /// Writes every file that is not already as it should be: first all of them beside their places,
    /// then, when nothing can be missing any more, into them.
    ///
    /// # Errors
    /// [`ArtifactError::File`]; nothing that stood before is lost, and no half file is left.
    pub fn write(&self, root: &Path) -> Result<usize, ArtifactError> {
        let mut staged: Vec<(PathBuf, PathBuf)> = Vec::new();
        let result = self.stage(root, &mut staged);
        let moved = result.and_then(|()| {
            for (from, to) in &staged {
                std::fs::rename(from, to).map_err(|e| file_error(to, &e))?;
            }
            Ok(staged.len())
        });
        if moved.is_err() {
            for (from, _) in &staged {
                // What was renamed is gone from here already; the rest must not stay.
                let _ = std::fs::remove_file(from);
            }
        }
        moved
    }

    fn stage(&self, root: &Path, staged: &mut Vec<(PathBuf, PathBuf)>) -> Result<(), ArtifactError> {
        for (path, bytes) in &self.files {
            let to = root.join(path);
            if std::fs::read(&to).is_ok_and(|found| found == *bytes) {
                continue;
            }
            if to.is_dir() {
                return Err(ArtifactError::File {
                    path: to.display().to_string(),
                    reason: "is a folder".to_owned(),
                });
            }
            if let Some(parent) = to.parent() {
                std::fs::create_dir_all(parent).map_err(|e| file_error(parent, &e))?;
            }
            let mut name = to.file_name().unwrap_or_default().to_owned();
            name.push(".tmp");
            let beside = to.with_file_name(name);
            staged.push((beside.clone(), to.clone()));
            std::fs::write(&beside, bytes).map_err(|e| file_error(&to, &e))?;
        }
        Ok(())
    }
}

/// The lines of the residual figure: as printed, over the paper's limit and over the whole support,
/// and the refits over the whole support.
fn residual_lines(study: &Study) -> Vec<ResidualLine> {
    let mut lines = Vec::new();
    for model in Model::ALL {
        let on = |limit| case(model, Lobe::Cs16, limit);
        if let Some(printed) = study.printed(model) {
            let bound = printed.bound.as_ref().map(|b| crate::bound::enclose(&b.value).mid());
            for (limit, label) in
                [(Limit::Paper, "printed, integral to 6/√n"), (Limit::Support, "printed, whole support")]
            {
                let (case, line) = (on(limit), printed.line.clone());
                lines.push(ResidualLine { case, label: label.to_owned(), line, printed_bound: bound });
            }
        }
        for (objective, label) in [
            (Objective::LsRelative, "least squares, whole support"),
            (Objective::Minimax, "minimax, whole support"),
        ] {
            if let Some(row) = study.fit(on(Limit::Support), objective) {
                let (case, line) = (row.case, row.line.clone());
                lines.push(ResidualLine { case, label: label.to_owned(), line, printed_bound: None });
            }
        }
    }
    lines
}

fn file_error(path: &Path, error: &std::io::Error) -> ArtifactError {
    ArtifactError::File { path: path.display().to_string(), reason: reason(error) }
}

/// The system's words without its number, in one line.
fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}
