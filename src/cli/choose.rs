//! `bellfit choose`.

use super::{Outcome, emit, input, known, print};
use crate::bound::{ELEMENTARY_ULPS, Format, Handed, Measure};
use crate::choose::{
    ANGLE_WORDS, Costs, ENERGY_ERROR, ENERGY_WORDS, EXAMPLE_NEEDS, EnergyDemand, Exponents, FLOOR, Need,
    NeedError, SceneNeeds, Weights, choose, energy_from_word, handed_from_word,
};
use crate::kernel::model::Model;
use crate::kernel::stand_in::StandIn;
use crate::report::{choice_json, choice_lines, scene_choice_json, scene_choice_lines};
use crate::shader::{Language, Piece};
use crate::trade::Record;
use anyhow::{Result, anyhow, bail};
use clap::Args;
use std::path::{Path, PathBuf};

/// The longest file that is read; records of every kernel are below a hundredth of it.
const LONGEST: u64 = 4 << 20;

/// Find the cheapest lobe that stands for cosⁿ within a scene's needs, with its proof.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit choose --n 16..1024 --max-error 1e-3 --float f32 --angle difference
  bellfit choose --roughness 0.1..0.4 --max-error 0.1 --relative --float f32 --no-transcendental
  bellfit choose --n 16..64 --max-error 0.02 --float f16 --angle difference --model phong --energy never-gains
  bellfit choose --n 16..256 --max-error 0.01 --float f32 --model phong --emit wgsl > lobe.wgsl
  bellfit choose --example > needs.toml; bellfit choose needs.toml
  bellfit trade --json > record.json; bellfit choose --n 64 --max-error 0.02 --float f32 --trade record.json

The error is that against cosⁿ over every angle and every n, the rounding of the format included; what is printed
is an upper bound. fails: an argument is known where the error is larger than allowed; not proved: none is known.

Exit code: 0 if something qualifies (in a file: for every material), 1 if nothing does, 2 bad input.")]
pub struct Arguments {
    /// A file (TOML, version = 1) with the needs of a whole scene; - reads standard input.
    #[arg(value_name = "SCENE", conflicts_with_all = [
        "n", "roughness", "whole", "max_error", "relative", "float", "angle", "model", "energy", "no_division",
        "no_transcendental", "ulps", "kernel",
    ])]
    scene: Option<PathBuf>,
    /// The specular exponents, ends included, or one: 1 to 1e12.
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, conflicts_with = "roughness")]
    n: Option<String>,
    /// Beckmann's roughness α in (0, 1], for n = 2/α² - 2 (Walter et al., EGSR 2007).
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    roughness: Option<String>,
    /// Whole n alone.
    #[arg(long)]
    whole: bool,
    /// The largest error, of the peak, which is 1.
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    max_error: Option<f64>,
    /// The error is of the value, where that is at least the floor.
    #[arg(long)]
    relative: bool,
    /// The part of the peak from which a relative error counts; 1/256 if not given.
    #[arg(long, value_name = "F", allow_hyphen_values = true, requires = "relative")]
    floor: Option<f64>,
    /// The arithmetic: f16 (each operation rounded), f16-stored (stored so, computed in f32), f32 or f64.
    #[arg(long, value_name = "FLOAT", value_parser = format)]
    float: Option<Format>,
    /// What is handed over: cos, versine (1 - cos θ) or difference (|a - b|²/2 of unit vectors); cos if not
    /// given.
    #[arg(long, value_name = "ANGLE", value_parser = angle)]
    angle: Option<Handed>,
    /// The model whose factor comes along: phong, phong-modified, blinn-phong, blinn-phong-modified,
    /// blinn-phong-ndf or blinn-phong-heightfield.
    #[arg(long, value_name = "MODEL", value_parser = model)]
    model: Option<Model>,
    /// never-gains: ∫ ≤ 1 of the exact lobe with the factor as rounded; unbiased: |∫ - 1| at most the energy's
    /// error.
    #[arg(long, value_name = "ENERGY", value_parser = energy)]
    energy: Option<EnergyDemand>,
    /// The largest |∫ - 1| of what is unbiased; 1e-3 if not given.
    #[arg(long, value_name = "E", allow_hyphen_values = true, requires = "energy")]
    energy_error: Option<f64>,
    /// No kernel that divides.
    #[arg(long)]
    no_division: bool,
    /// No kernel that takes pow, an exponential or a logarithm.
    #[arg(long)]
    no_transcendental: bool,
    /// Units in the last place within which exp, exp2, log2, log1p and pow are; 1 if not given.
    #[arg(long, value_name = "U", allow_hyphen_values = true)]
    ulps: Option<f64>,
    /// One kernel alone, by its name.
    #[arg(long, value_name = "ID", value_parser = kernel)]
    kernel: Option<StandIn>,
    /// What a division and a transcendental cost, in operations; 6,10 if not given.
    #[arg(long, value_name = "D,T", allow_hyphen_values = true, value_parser = weights)]
    weights: Option<Weights>,
    /// A record of `bellfit trade --json`: kernels are ranked by nanoseconds a value over slices in cache, where it
    /// has them, f32 and f64. Squarings are timed at one n alone and keep their operations.
    #[arg(long, value_name = "FILE")]
    trade: Option<PathBuf>,
    /// Print the best kernel as code instead: rust, wgsl, glsl, hlsl, msl or c. With a file: every material's best,
    /// and the footprint and weights of its surfaces.
    #[arg(long, value_name = "LANGUAGE", value_parser = emit::language, conflicts_with = "json")]
    emit: Option<Language>,
    /// With --emit, also: footprint, or the weight of a texel by its name (cubic-4, gaussian, paper-r2, …), σ half a
    /// pixel. Several, divided by commas.
    #[arg(long, value_name = "PIECES", value_delimiter = ',', value_parser = emit::extra, requires = "emit")]
    with: Vec<Piece>,
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
    /// Print a commented file to start from.
    #[arg(long, exclusive = true)]
    example: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    if arguments.example {
        print(EXAMPLE_NEEDS)?;
        return Ok(Outcome::AsExpected);
    }
    let record = arguments.trade.as_deref().map(record).transpose()?;
    let measured = |stand_in, format| {
        let record = record.as_ref().filter(|_| stand_in != StandIn::Squarings);
        record.and_then(|record| record.cost(stand_in, format))
    };
    let measured = record.is_some().then_some(&measured as &(dyn Fn(StandIn, Format) -> Option<f64> + Sync));
    let costs = Costs { weights: arguments.weights.unwrap_or_default(), measured };
    let (lines, code, is_met) = match &arguments.scene {
        Some(path) => {
            let answer = scene(path)?.answer(&costs)?;
            let code = arguments.emit.map(|language| emit::of_scene(&answer, &arguments.with, language));
            let lines = if arguments.json {
                scene_choice_json(&answer, &costs)?
            } else {
                scene_choice_lines(&answer, &costs)
            };
            (lines, code.transpose()?, answer.is_met())
        }
        None => {
            let answer = choose(&arguments.need()?, &costs)?;
            let code = arguments.emit.map(|language| emit::of_answer(&answer, &arguments.with, language));
            let lines =
                if arguments.json { choice_json(&answer, &costs)? } else { choice_lines(&answer, &costs) };
            (lines, code.transpose()?, answer.best().is_some())
        }
    };
    // Where code was asked for and nothing qualifies, what would go into a file stays empty.
    match code {
        Some(Some(code)) => print(&code)?,
        Some(None) => eprint!("{lines}"),
        None => print(&lines)?,
    }
    Ok(if is_met { Outcome::AsExpected } else { Outcome::Differs })
}

fn scene(path: &Path) -> Result<SceneNeeds> {
    let text = input::text(path, "a file of needs", LONGEST)?;
    SceneNeeds::parse(&text).map_err(|error| anyhow!("{}: {error}", input::name(path)))
}

fn record(path: &Path) -> Result<Record> {
    let text = input::text(path, "a record", LONGEST)?;
    Record::parse(&text).map_err(|error| anyhow!("{}: {error}", input::name(path)))
}

impl Arguments {
    fn need(&self) -> Result<Need> {
        let mut n = match (&self.n, &self.roughness) {
            (Some(n), _) => n.parse::<Exponents>()?,
            (None, Some(roughness)) => Exponents::parse_roughness(roughness)?,
            (None, None) => bail!("--n A..B or --roughness A..B, or a file, is needed"),
        };
        if self.whole {
            n = n.whole_only().ok_or(NeedError::NoWhole { range: n })?;
        }
        let max_error = self.max_error.ok_or_else(|| anyhow!("--max-error E is needed"))?;
        let format = self.float.ok_or_else(|| anyhow!("--float f16, f16-stored, f32 or f64 is needed"))?;
        let energy = match (self.energy, self.energy_error) {
            (Some(EnergyDemand::Unbiased { .. }), Some(error)) => Some(EnergyDemand::Unbiased { error }),
            (Some(EnergyDemand::NeverGains), Some(_)) => {
                bail!("--energy-error: of no use with --energy never-gains, only with unbiased")
            }
            (energy, _) => energy,
        };
        if let (Some(energy), None) = (energy, self.model) {
            bail!("--energy {}: --model is needed, whose integral it is of", energy.id());
        }
        let floor = self.floor.unwrap_or(FLOOR);
        let need = Need {
            measure: if self.relative { Measure::Relative { floor } } else { Measure::Absolute },
            format,
            handed: self.angle.unwrap_or(Handed::Cosine),
            model: self.model,
            energy,
            division: !self.no_division,
            transcendental: !self.no_transcendental,
            ulps: self.ulps.unwrap_or(ELEMENTARY_ULPS),
            only: self.kernel,
            ..Need::new(n, max_error)
        };
        need.check().map_err(|error| anyhow!("--{error}"))?;
        Ok(need)
    }
}

fn format(word: &str) -> Result<Format, String> {
    known(Format::from_id(word), Format::ALL.map(Format::id))
}

fn angle(word: &str) -> Result<Handed, String> {
    known(handed_from_word(word), ANGLE_WORDS)
}

fn model(word: &str) -> Result<Model, String> {
    known(Model::from_id(word), Model::ALL.map(Model::id))
}

fn energy(word: &str) -> Result<EnergyDemand, String> {
    known(energy_from_word(word, ENERGY_ERROR), ENERGY_WORDS)
}

fn kernel(word: &str) -> Result<StandIn, String> {
    known(StandIn::from_id(word), StandIn::ALL.map(StandIn::id))
}

fn weights(text: &str) -> Result<Weights, String> {
    let problem =
        || "two numbers of operations, of a division and of a transcendental, are needed".to_owned();
    let (division, transcendental) = text.split_once(',').ok_or_else(problem)?;
    let read = |word: &str| word.trim().parse::<f64>().map_err(|_| problem());
    let weights = Weights { division: read(division)?, transcendental: read(transcendental)? };
    weights.check().map_err(|error| error.to_string())?;
    Ok(weights)
}
