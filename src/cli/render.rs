//! `bellfit render`.

use super::{Outcome, print, reason};
use crate::report::{filter_files, filter_lines, measured_files};
use crate::scene::{
    BUILT_IN, Comparison, EXAMPLE_SCENE, Pattern, Scene, SceneFile, Technique, Transfer, View, time_lookups,
};
use crate::trade::processor;
use anyhow::{Result, anyhow, bail};
use clap::Args;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Show a textured plane by every texture filter, and how far each picture is from a supersampled one.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit render                               the built-in checker to the horizon, into render/
  bellfit render --scene rolled --out /tmp/try
  bellfit render --image texture.png
  bellfit render --example > mine.toml; bellfit render --scene mine.toml
  bellfit render --measure                     time a lookup, on the built-in scenes

Pictures are PNG files: the two references, and for every technique the picture and its difference from the
Gaussian reference, grey where there is none, four times as strong. errors.csv has the table.")]
pub struct Arguments {
    /// A built-in scene (checker, zone-plate, rolled) or a scene file (TOML, version = 1).
    #[arg(long, value_name = "SCENE")]
    scene: Option<String>,
    /// A PNG file to lie on the plane instead of the scene's texture.
    #[arg(long, value_name = "PNG")]
    image: Option<PathBuf>,
    /// Take that file's values as they are, not as sRGB.
    #[arg(long, requires = "image")]
    linear: bool,
    /// Folder to write into; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "render")]
    out: PathBuf,
    /// Threads, 1 to 64; their number changes no byte. As many as the machine has if not given.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=64))]
    threads: Option<u8>,
    /// Write the time of a lookup instead of pictures, measured on one thread of this machine.
    #[arg(long)]
    measure: bool,
    /// Print a commented scene file to start from.
    #[arg(long, conflicts_with_all = ["scene", "image", "measure"])]
    example: bool,
}

/// Rounds of a measurement.
const ROUNDS: usize = 15;
/// Of the plane's pixels, every so many-th is measured.
const STRIDE: usize = 13;

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    if arguments.example {
        print(EXAMPLE_SCENE)?;
        return Ok(Outcome::AsExpected);
    }
    if arguments.out.exists() && !arguments.out.is_dir() {
        bail!("{}: not a folder", arguments.out.display());
    }
    let threads = match arguments.threads {
        Some(threads) => usize::from(threads),
        None => std::thread::available_parallelism().map_or(1, usize::from),
    };
    let watched = std::io::stderr().is_terminal();
    let start = Instant::now();
    let done = |what: &str| {
        if watched {
            eprintln!("{:>7.2} s  {what}", start.elapsed().as_secs_f64());
        }
    };
    let mut scenes = scenes(arguments)?;
    if let Some(path) = &arguments.image {
        let transfer = if arguments.linear { Transfer::Linear } else { Transfer::Srgb };
        for (scene, _) in &mut scenes {
            scene.pattern = Pattern::File { path: path.clone(), transfer };
        }
    }
    let mut text = String::new();
    let mut compared = Vec::new();
    for (scene, techniques) in &scenes {
        let named = |error| anyhow!("scene {}: {error}", scene.name);
        compared.push(Comparison::run(scene, techniques, threads, &done).map_err(named)?);
    }
    let artifacts = if arguments.measure {
        let mut timings = Vec::new();
        for (scene, techniques) in &scenes {
            timings.push(time_lookups(&View::new(scene)?, techniques, STRIDE, ROUNDS)?);
            done("times");
        }
        let (files, lines) = measured_files(&compared, &timings, STRIDE, &processor())?;
        text.push_str(&lines);
        files
    } else {
        for comparison in &compared {
            text.push_str(&filter_lines(comparison));
        }
        filter_files(&compared)?
    };
    let written = artifacts.write(&arguments.out)?;
    let all = artifacts.files().count();
    text.push_str(&format!(
        "{written} files written, {} unchanged, in {}\n",
        all - written,
        arguments.out.display()
    ));
    print(&text)?;
    Ok(Outcome::AsExpected)
}

/// What is to be shown: one scene, or all built-in ones to measure.
fn scenes(arguments: &Arguments) -> Result<Vec<(Scene, Vec<Technique>)>> {
    let built_in = |name: &str| Scene::built_in(name).map(|scene| (scene, Technique::all()));
    match arguments.scene.as_deref() {
        None if arguments.measure => Ok(BUILT_IN.iter().filter_map(|name| built_in(name)).collect()),
        None => Ok(built_in(BUILT_IN[0]).into_iter().collect()),
        Some(name) => match built_in(name) {
            Some(scene) => Ok(vec![scene]),
            None => Ok(vec![read(Path::new(name))?]),
        },
    }
}

fn read(path: &Path) -> Result<(Scene, Vec<Technique>)> {
    let name = path.display();
    if path.is_dir() {
        bail!("{name}: a folder, not a scene file");
    }
    let bytes = std::fs::read(path).map_err(|error| {
        let reason = reason(&error);
        anyhow!("{name}: {reason}; built-in scenes are {}", BUILT_IN.join(", "))
    })?;
    let text = String::from_utf8(bytes).map_err(|_| anyhow!("{name}: not UTF-8 text"))?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new("."));
    let SceneFile { scene, techniques } =
        SceneFile::parse(&text, &stem, folder).map_err(|error| anyhow!("{name}: {error}"))?;
    Ok((scene, techniques))
}
