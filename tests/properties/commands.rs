//! The program under argument lists of its real options with good and bad values: an exit code, one line for what is
//! refused, JSON that parses, and no file where nothing was to be written.
//!
//! Heavy work (reproduce, render, trade) is only asked for in ways that it refuses.

use crate::damage::{apply, damage};
use crate::holds;
use crate::png_file::{folder, png_bytes};
use crate::program::bellfit;
use bellfit::choose::EXAMPLE_NEEDS;
use bellfit::paper::EXAMPLE;
use bellfit::scene::EXAMPLE_SCENE;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::TestCaseResult;
use std::cell::Cell;
use std::path::Path;
use std::process::Output;

/// Words that no option takes.
const BAD: [&str; 11] =
    ["", " ", "nan", "-1", "1e400", "½", "0..0", "--", "--nonsense", "1,2,3,nan", "\u{1b}[2J"];

/// An option with a value that it takes, seldom one that it refuses; mostly not given at all.
fn option(name: &'static str, good: &[&str], wrong: &[&str]) -> BoxedStrategy<Vec<String>> {
    prop_oneof![24 => Just(vec![]), 6 => values(name, good), 1 => refused(name, wrong)].boxed()
}

/// The same for an option that must be given, and nearly always is.
fn needed(name: &'static str, good: &[&str], wrong: &[&str]) -> BoxedStrategy<Vec<String>> {
    prop_oneof![1 => Just(vec![]), 40 => values(name, good), 2 => refused(name, wrong)].boxed()
}

fn values(name: &str, values: &[&str]) -> BoxedStrategy<Vec<String>> {
    let given: Vec<Vec<String>> =
        values.iter().map(|value| vec![name.to_owned(), (*value).to_owned()]).collect();
    select(given).boxed()
}

fn refused(name: &str, wrong: &[&str]) -> BoxedStrategy<Vec<String>> {
    values(name, &[wrong, &BAD].concat())
}

fn flag(name: &'static str) -> BoxedStrategy<Vec<String>> {
    prop_oneof![3 => Just(vec![]), 1 => Just(vec![name.to_owned()])].boxed()
}

/// A subcommand with its words in any order.
fn command(name: &'static str, parts: Vec<BoxedStrategy<Vec<String>>>) -> BoxedStrategy<Vec<String>> {
    let order = Just((0..parts.len()).collect::<Vec<usize>>()).prop_shuffle();
    (parts, order)
        .prop_map(move |(parts, order)| {
            std::iter::once(name.to_owned()).chain(order.into_iter().flat_map(|i| parts[i].clone())).collect()
        })
        .boxed()
}

fn run(arguments: &[String]) -> Output {
    bellfit(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

/// How many runs were answered (0 or 1), and how many refused.
#[derive(Default)]
struct Count {
    answered: Cell<u32>,
    refused: Cell<u32>,
}

impl Count {
    /// A property of runs that are all answered, or all refused, would say nothing of the other.
    #[track_caller]
    fn saw_both(&self) {
        let (answered, refused) = (self.answered.get(), self.refused.get());
        assert!(answered >= 20 && refused >= 20, "{answered} answered, {refused} refused");
    }
}

/// What every run keeps to.
fn behaves(arguments: &[String], count: &Count) -> TestCaseResult {
    let output = run(arguments);
    let kind = if output.status.code() == Some(2) { &count.refused } else { &count.answered };
    kind.set(kind.get() + 1);
    let error = String::from_utf8(output.stderr).expect("UTF-8");
    let said = String::from_utf8(output.stdout).expect("UTF-8");
    match output.status.code() {
        Some(2) => {
            prop_assert!(
                error.starts_with("bellfit: ") && error.ends_with('\n'),
                "{:?}: {}",
                arguments,
                error
            );
            prop_assert_eq!(error.lines().count(), 1, "{:?}: {}", arguments, error);
            prop_assert!(!error.trim_end().contains(char::is_control), "{:?}: {:?}", arguments, error);
            prop_assert!(said.is_empty(), "{:?}: {}", arguments, said);
        }
        Some(code @ (0 | 1)) => {
            // Where code was asked for and nothing qualifies, why is told beside the empty file.
            let tells = code == 1 && arguments.iter().any(|word| word == "--emit");
            prop_assert_eq!(said.is_empty(), tells, "{:?}", arguments);
            prop_assert_eq!(error.is_empty(), !tells, "{:?}: {}", arguments, error);
            if arguments.iter().any(|word| word == "--json") {
                let json: Result<serde_json::Value, _> = serde_json::from_str(&said);
                prop_assert!(json.is_ok(), "{:?}: {}", arguments, said);
            }
        }
        code => prop_assert!(false, "{:?}: exit code {:?}: {}", arguments, code, error),
    }
    Ok(())
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn fit_answers_or_refuses() {
    let fit = command(
        "fit",
        vec![
            needed("--model", &["phong", "phong-modified", "blinn-phong", "blinn-phong-ndf"], &["lambert"]),
            option("--lobe", &["cs16", "cos-n"], &[]),
            option("--limit", &["support", "exact-zero", "paper", "card"], &[]),
            option("--objective", &["ls-relative", "ls-absolute", "minimax", "one-sided"], &[]),
            needed(
                "--n",
                &["16..20", "20..24", "30..40"],
                &["16..17", "16..inf", "18.5..19.5", "20..16", "16..16"],
            ),
            option("--form", &["proportional", "linear", "inverse", "ratio"], &[]),
            option("--over", &["integers", "reals"], &[]),
            option("--digits", &["3", "4", "8"], &["0", "16"]),
            flag("--json"),
        ],
    );
    let count = Count::default();
    holds(80, 200, fit, |arguments| behaves(&arguments, &count));
    count.saw_both();
}

#[test]
fn choose_answers_or_refuses() {
    let choose = command(
        "choose",
        vec![
            needed("--n", &["16", "16..24", "64", "1..2", "1e12", "16..16.5"], &["0.5..3", "3..2"]),
            needed("--max-error", &["0.1", "1e-3", "1e-15", "1"], &["0", "2"]),
            needed("--float", &["f16", "f16-stored", "f32", "f64"], &[]),
            option("--angle", &["cos", "versine", "difference"], &[]),
            option("--model", &["phong", "blinn-phong"], &[]),
            option("--energy", &["never-gains", "unbiased"], &[]),
            option("--energy-error", &["1e-3", "0.5"], &["0"]),
            option("--floor", &["0.1"], &["0", "1"]),
            option("--ulps", &["1", "4"], &["0"]),
            // One alone: cheap, and each in its turn.
            needed(
                "--kernel",
                &["cs-16", "cubic-4", "cubic-8", "linear-8", "schlick", "squarings", "pow"],
                &[],
            ),
            option("--weights", &["6,10", "1,1"], &["1"]),
            option("--emit", &["rust", "wgsl", "glsl", "c"], &[]),
            option("--with", &["footprint", "cubic-4,gaussian"], &["cubic-3"]),
            flag("--whole"),
            flag("--relative"),
            flag("--no-division"),
            flag("--no-transcendental"),
            flag("--json"),
        ],
    );
    let count = Count::default();
    holds(81, 200, choose, |arguments| behaves(&arguments, &count));
    count.saw_both();
}

#[test]
fn sample_answers_or_refuses() {
    let out = folder("properties-sample");
    let path = out.join("texture.png");
    let texels: Vec<u8> = (0..6 * 5 * 3).map(|i| (i * 37 % 256) as u8).collect();
    std::fs::write(&path, png_bytes((6, 5), png::ColorType::Rgb, png::BitDepth::Eight, &texels, |_| {}))
        .unwrap();
    let path = path.to_str().unwrap().to_owned();
    let image =
        prop_oneof![12 => Just(vec![path]), 1 => Just(vec![]), 1 => Just(vec!["Cargo.toml".to_owned()])];
    let sample = command(
        "sample",
        vec![
            image.boxed(),
            needed("--at", &["1.5,2", "-3,7.25", "1e9,-1e9", "0,-0", " 1 , 2 "], &["1", "1,2,3", "1e10,0"]),
            needed(
                "--jacobian",
                &["3,1,-1,2", "0,0,0,0", "1e-9,0,0,1e9", "1,1,1,1", "40,0,0,40"],
                &["1,2,3", "inf,0,0,1"],
            ),
            option("--method", &["nearest", "bilinear", "trilinear", "ellipse"], &[]),
            option(
                "--weight",
                &["gaussian", "box", "paper-r1", "paper-r2-product", "bell-16", "cubic-4"],
                &["cubic-3"],
            ),
            option("--sigma", &["0.5", "0.3333"], &["1e-30", "0"]),
            option("--wrap", &["repeat", "clamp", "mirror"], &[]),
            option("--conic", &["plain", "padded"], &[]),
            option("--axes", &["conic", "paper-vector", "paper-conic"], &[]),
            option("--anisotropy", &["1", "16"], &["0.5"]),
            option("--rim", &["none", "area", "half-plane", "volume"], &[]),
            option("--diameter", &["1", "2"], &["3"]),
            option("--level", &["0", "1"], &["99"]),
            option("--filter", &["box", "kaiser"], &[]),
            flag("--linear"),
            flag("--json"),
        ],
    );
    let count = Count::default();
    holds(82, 500, sample, |arguments| behaves(&arguments, &count));
    count.saw_both();
    assert_eq!(names(&out), ["texture.png"]);
}

/// Every list has a word in it that its command refuses before any work.
#[test]
fn heavy_commands_refuse_before_they_work() {
    let out = folder("properties-refused");
    let file = out.join("file");
    std::fs::write(&file, "mine\n").unwrap();
    let (file, inside) = (file.to_str().unwrap().to_owned(), out.join("new").to_str().unwrap().to_owned());
    let wrong =
        |words: &[&str]| Just(words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>()).boxed();
    let into = prop_oneof![Just(vec![]), Just(vec!["--out".to_owned(), inside])].boxed();
    let reproduce = command(
        "reproduce",
        vec![
            prop_oneof![
                wrong(&["--out", &file]),
                wrong(&["--check", "--adopt"]),
                wrong(&["--check", "--check"]),
                wrong(&["--nonsense"]),
                wrong(&["more"]),
            ]
            .boxed(),
        ],
    );
    let render = command(
        "render",
        vec![
            prop_oneof![
                wrong(&["--out", &file]),
                wrong(&["--scene", "no-such"]),
                wrong(&["--scene", &file]),
                wrong(&["--scene", "Cargo.toml"]),
                wrong(&["--threads", "0"]),
                wrong(&["--threads", "65"]),
                wrong(&["--image", "Cargo.toml"]),
                wrong(&["--image", "no-such.png"]),
                wrong(&["--linear"]),
                wrong(&["--example", "--measure"]),
                wrong(&["--measure", "--measure"]),
            ]
            .boxed(),
            flag("--measure"),
        ],
    );
    let trade = command(
        "trade",
        vec![
            prop_oneof![
                wrong(&["--n", "15"]),
                wrong(&["--n", "65537"]),
                wrong(&["--n", "16.5"]),
                wrong(&["--n", ""]),
                wrong(&["--nonsense"]),
                wrong(&["more"]),
            ]
            .boxed(),
            flag("--quick"),
            flag("--json"),
            into,
        ],
    );
    let bare = select(BAD.to_vec()).prop_map(|word| vec!["x".to_owned() + word]).boxed();
    holds(83, 150, prop_oneof![reproduce, render, trade, bare], |arguments| {
        let count = Count::default();
        behaves(&arguments, &count)?;
        prop_assert_eq!(count.refused.get(), 1, "{:?}", arguments);
        Ok(())
    });
    assert_eq!(names(&out), ["file"]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine\n");
}

/// Files as the program reads them: damaged ones, and bytes that are not UTF-8.
#[test]
fn files_are_read_or_refused_in_one_line() {
    let out = folder("properties-files");
    let path = out.join("file.toml");
    let name = path.to_str().unwrap().to_owned();
    // Scenes that cannot be drawn: a picture of one is minutes of tests.
    let scene = EXAMPLE_SCENE.replace("width = 192", "width = 1");
    let texts = [
        ("verify", vec![], EXAMPLE.to_owned()),
        ("choose", vec![], EXAMPLE_NEEDS.to_owned()),
        ("render", vec!["--scene"], scene),
    ];
    for (i, (command, before, text)) in texts.into_iter().enumerate() {
        // A last line that no TOML has, so that none is judged: that is other tests' work.
        let hurt = (damage(), proptest::collection::vec(any::<u8>(), 0..40));
        holds(84 + i as u8, 40, hurt, |(damage, bytes)| {
            for bytes in [[&apply(&text, &damage)[..], b"\n= ="].concat(), bytes] {
                std::fs::write(&path, bytes).unwrap();
                let words = std::iter::once(command).chain(before.iter().copied()).chain([name.as_str()]);
                let arguments: Vec<String> = words.map(str::to_owned).collect();
                let count = Count::default();
                behaves(&arguments, &count)?;
                prop_assert_eq!(count.refused.get(), 1, "{:?}", arguments);
            }
            Ok(())
        });
    }
    assert_eq!(names(&out), ["file.toml"]);
}
