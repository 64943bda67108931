//! The time of a lookup, measured.

use super::artifacts::{ArtifactError, Artifacts};
use super::chart::{Axis, Chart, LineChart, Mark, Panels, Scale, Series, Style};
use super::figures::{Figure, render};
use super::tables::csv_bytes;
use crate::kernel::pixel::Padding;
use crate::scene::{Comparison, Technique, Timing};
use crate::trade::file_name;
use serde::Serialize;
use std::fmt::Write;

#[derive(Serialize)]
struct Line<'a> {
    machine: &'a str,
    scene: &'a str,
    technique: &'a str,
    nanoseconds: f64,
    least: f64,
    most: f64,
    mean_texels: f64,
    gaussian_rmse: f64,
    area_rmse: f64,
}

/// One decimal: a clock tells no more.
fn tenth(x: f64) -> f64 {
    libm::round(10.0 * x) / 10.0
}

/// The files of `bellfit render --measure`: `filter-<machine>.csv` and, of the last measurement, `filter.md` and
/// the plot of error against time; and the table for the terminal. Every `stride`-th pixel was timed.
///
/// # Errors
/// [`ArtifactError`] if one cannot be made.
pub fn measured_files(
    comparisons: &[Comparison],
    timings: &[Vec<Timing>],
    stride: usize,
    machine: &str,
) -> Result<(Artifacts, String), ArtifactError> {
    let mut lines = Vec::new();
    for (comparison, timings) in comparisons.iter().zip(timings) {
        for timing in timings {
            let Some(row) = comparison.row(&timing.technique) else { continue };
            lines.push(Line {
                machine,
                scene: &comparison.scene.name,
                technique: &timing.technique,
                nanoseconds: tenth(timing.nanoseconds),
                least: tenth(timing.least),
                most: tenth(timing.most),
                mean_texels: row.mean_texels,
                gaussian_rmse: row.gaussian.rmse,
                area_rmse: row.area.rmse,
            });
        }
    }
    let (mut report, mut terminal) = (head(machine, stride, wander(timings)), String::new());
    for line in &lines {
        let Line { scene, technique, nanoseconds, least, most, mean_texels, gaussian_rmse, .. } = line;
        let _ = writeln!(
            report,
            "| {scene} | {technique} | {nanoseconds:.1} | {least:.1} to {most:.1} | {mean_texels:.1} | {gaussian_rmse:.4} |"
        );
        let _ = writeln!(terminal, "{scene:<12} {technique:<34} {nanoseconds:>9.1} ns  {gaussian_rmse:.4}");
    }
    let mut files = Artifacts::default();
    for (name, bytes) in render(&[figure(&lines, machine)])? {
        files.insert(&name, bytes);
    }
    files.insert(&format!("filter-{}.csv", file_name(machine)), csv_bytes(lines)?);
    files.insert("filter.md", report.into_bytes());
    Ok((files, terminal))
}

/// The largest median by its fastest round.
fn wander(timings: &[Vec<Timing>]) -> f64 {
    timings.iter().flatten().map(|timing| timing.nanoseconds / timing.least).fold(1.0, f64::max)
}

fn head(machine: &str, stride: usize, wander: f64) -> String {
    format!(
        "# Time of a texture lookup\n\n\
         Measured once by `bellfit render --measure` on one thread of: {machine}. Medians over interleaved rounds of the \
         mean over every {stride}th pixel of the plane; texels and RMSE are of all. A median is up to {wander:.2} times its \
         fastest round here, so ratios below that mean little. Never measured again by `bellfit reproduce`, nor \
         compared.\n\n\
         ![Error against time a lookup](filter-time.png)\n\n\
         | scene | technique | ns a lookup | fastest to slowest round | texels, mean | RMSE, Gaussian reference |\n\
         |---|---|---|---|---|---|\n"
    )
}

fn figure(lines: &[Line<'_>], machine: &str) -> Figure {
    let mut scenes: Vec<&str> = lines.iter().map(|line| line.scene).collect();
    scenes.dedup();
    let charts = scenes.into_iter().map(|scene| panel(lines, scene)).collect();
    Figure {
        stem: "filter-time",
        alt: format!(
            "Root mean square error of the texture filters against nanoseconds a lookup, on {machine}."
        ),
        chart: Chart::Panels(Panels {
            title: "Error against time a lookup".into(),
            subtitle: format!("RMSE against the Gaussian pixel, linear light; one thread of {machine}"),
            columns: 2,
            charts,
        }),
    }
}

/// What a technique is drawn as.
fn group(id: &str) -> &'static str {
    let technique = Technique::from_id(id);
    match technique.as_ref().and_then(Technique::filter) {
        None => "fixed number of texels",
        Some(_) if technique.as_ref().is_some_and(|t| t.diameter == 1) => "base diameter 1",
        Some(filter) if filter.axes.id() != "conic" => "the paper's axes",
        Some(filter) if filter.padding == Padding::Padded => "ellipse, padded",
        Some(_) => "ellipse, plain",
    }
}

const GROUPS: [&str; 5] =
    ["fixed number of texels", "ellipse, plain", "ellipse, padded", "the paper's axes", "base diameter 1"];
/// Those with a name in the plot; the table has all.
const MARKED: [&str; 4] = ["nearest", "trilinear", "cubic-4-half-padded", "paper-r1-product"];

fn panel(lines: &[Line<'_>], scene: &str) -> LineChart {
    let of_scene = || lines.iter().filter(|line| line.scene == scene);
    let at = |line: &Line<'_>| (line.nanoseconds, line.gaussian_rmse);
    let series = GROUPS.iter().enumerate().filter_map(|(colour, name)| {
        let points: Vec<_> = of_scene().filter(|line| group(line.technique) == *name).map(at).collect();
        let series = Series::new(*name, Style::Points, points);
        (!series.points.is_empty()).then_some(Series { colour: Some(colour), ..series })
    });
    let marks = of_scene()
        .filter(|line| MARKED.contains(&line.technique))
        .map(|line| Mark { at: at(line), text: line.technique.to_owned() });
    let range = |of: &dyn Fn(&Line<'_>) -> f64| {
        let (lo, hi) =
            of_scene().map(of).fold((f64::INFINITY, 0.0_f64), |(lo, hi), x| (lo.min(x), hi.max(x)));
        (0.6 * lo, 1.7 * hi)
    };
    LineChart {
        title: scene.to_owned(),
        subtitle: String::new(),
        x: Axis::new("nanoseconds a lookup", Scale::Log10, range(&|line| line.nanoseconds)),
        y: Axis::new("RMSE", Scale::Log10, range(&|line| line.gaussian_rmse)),
        bands: vec![],
        series: series.collect(),
        marks: marks.collect(),
    }
}
