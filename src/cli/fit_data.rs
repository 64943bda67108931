//! `bellfit fit --data`.

use super::{Outcome, input, known, print};
use crate::fit::measured::{Comparison, EXAMPLE_DATA, Family, Samples, Unit};
use crate::report::{Artifacts, data_fit_figure, data_fit_json, data_fit_lines};
use anyhow::{Result, anyhow, bail};
use clap::Args;
use std::path::{Path, PathBuf};

/// The longest file that is read: two hundred bytes for each of the most rows.
const LONGEST: u64 = 1 << 30;

/// What a fit of measured samples takes.
#[derive(Debug, Args)]
#[command(next_help_heading = "Measured samples")]
pub struct DataArguments {
    /// Fit lobes to the samples of a CSV file (- for standard input): a header, then rows. Columns: theta_deg,
    /// theta_rad, cos_theta or one_minus_cos; value; weight or sigma if known.
    #[arg(long, value_name = "FILE", conflicts_with_all = [
        "model", "lobe", "limit", "objective", "n", "form", "over", "digits",
    ])]
    data: Option<PathBuf>,
    /// The unit of a column that is called theta or angle alone: deg, rad, cos or one-minus-cos.
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<Unit>,
    /// A family to fit, once or more; all if not given: cos-n, cs-16, linear-2, -4, -8 or -32, cubic-2, -4 or -8,
    /// spherical-gaussian, schlick, free-2, -4 or -8 (a cubic bell whose own shape is fitted too).
    #[arg(long, value_name = "NAME", value_parser = family)]
    family: Vec<Family>,
    /// Draw samples, lobes and residuals into a file that ends in .svg or .png.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print a commented file of samples to start from.
    #[arg(long, exclusive = true)]
    data_example: bool,
}

/// The formats of a plot.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
}

impl DataArguments {
    /// The answer, if samples or their example were asked for.
    pub(super) fn run(&self, json: bool) -> Result<Option<Outcome>> {
        if self.data_example {
            print(EXAMPLE_DATA)?;
            return Ok(Some(Outcome::AsExpected));
        }
        let Some(path) = &self.data else {
            // Not clap's to say: it asks for nothing that conflicts with what is there.
            let given = [
                ("unit", self.unit.is_some()),
                ("family", !self.family.is_empty()),
                ("plot", self.plot.is_some()),
            ];
            if let Some((name, _)) = given.iter().find(|(_, is_given)| *is_given) {
                bail!("--{name}: of measured samples alone, --data FILE is needed");
            }
            return Ok(None);
        };
        // A plot that cannot be is told before the work.
        let plot =
            self.plot.as_deref().map(|path| Ok::<_, anyhow::Error>((path, format(path)?))).transpose()?;
        let (name, bytes) = (input::name(path), input::bytes(path, "a file of samples", LONGEST)?);
        let samples = Samples::parse(&bytes, self.unit).map_err(|error| anyhow!("{name}: {error}"))?;
        let families = if self.family.is_empty() { &Family::ALL[..] } else { &self.family };
        let found = Comparison::of(&samples, families).map_err(|error| anyhow!("{name}: {error}"))?;
        if let Some((path, format)) = plot {
            let chart = data_fit_figure(&samples, &found);
            let bytes = match format {
                Format::Svg => chart.svg().map(String::into_bytes),
                Format::Png => chart.png(),
            };
            write(path, bytes.map_err(|error| anyhow!("--plot {}: {error}", path.display()))?)?;
        }
        let text = if json { data_fit_json(&samples, &found)? } else { data_fit_lines(&samples, &found) };
        print(&text)?;
        Ok(Some(Outcome::AsExpected))
    }
}

fn format(path: &Path) -> Result<Format> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("svg") => Ok(Format::Svg),
        Some("png") => Ok(Format::Png),
        _ => bail!("--plot {}: the name must end in .svg or .png", path.display()),
    }
}

/// Beside its place, then into it.
fn write(path: &Path, bytes: Vec<u8>) -> Result<()> {
    let name = path.file_name().and_then(|name| name.to_str());
    let name = name.ok_or_else(|| anyhow!("--plot {}: the name is not UTF-8 text", path.display()))?;
    let mut artifacts = Artifacts::default();
    artifacts.insert(name, bytes);
    let folder = path.parent().unwrap_or(Path::new("."));
    artifacts.write(folder).map_err(|error| anyhow!("--plot {error}"))?;
    Ok(())
}

fn unit(word: &str) -> Result<Unit, String> {
    known(Unit::from_id(word), Unit::ALL.map(Unit::id))
}

fn family(word: &str) -> Result<Family, String> {
    known(Family::from_id(word), Family::ALL.map(Family::id))
}
