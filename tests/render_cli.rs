//! `bellfit render`: its files, its table, its refusals.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/png_file.rs"]
mod png_file;
#[path = "support/program.rs"]
mod program;

use png::{BitDepth, ColorType};
use png_file::{folder, png_bytes, png_data};
use program::{bellfit, refused};
use std::collections::BTreeMap;
use std::path::Path;

/// Every file below a folder.
fn files(root: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![root.to_path_buf()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(root).unwrap().to_str().unwrap().to_owned();
                found.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    found
}

/// The example scene, small.
fn small() -> String {
    let example = String::from_utf8(bellfit(&["render", "--example"]).stdout).unwrap();
    example.replace("width = 192", "width = 40").replace("height = 120", "height = 30")
}

fn run(arguments: &[&str]) -> String {
    let output = bellfit(arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn pictures_and_table_of_a_scene_file() {
    let out = folder("render");
    let scene = out.join("mine.toml");
    std::fs::write(&scene, small()).unwrap();
    let scene = scene.to_str().unwrap();
    let (one, two) = (out.join("one"), out.join("two"));
    let said = run(&["render", "--scene", scene, "--threads", "1", "--out", one.to_str().unwrap()]);
    run(&["render", "--scene", scene, "--threads", "2", "--out", two.to_str().unwrap()]);
    let written = files(&one);
    assert_eq!(written, files(&two));
    let techniques = ["bilinear", "trilinear", "gaussian-half", "gaussian-third", "paper-r1"];
    // Two references, and two pictures a technique, and the table.
    assert_eq!(written.len(), 2 + 2 * techniques.len() + 1);
    let picture = |name: &str| png_data(&written[&format!("mine/{name}.png")]);
    let reference = picture("reference-gaussian");
    assert_eq!((reference.0, reference.1, reference.2.len()), (40, 30, 1200));
    // Sky above, squares below.
    assert!(reference.2[..20].iter().all(|&code| code == reference.2[0]));
    let below = &reference.2[1000..];
    assert!(below.iter().max().unwrap() - below.iter().min().unwrap() > 100);
    let table = String::from_utf8(written["errors.csv"].clone()).unwrap();
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(header[..5], ["scene", "technique", "method", "weight", "sigma"]);
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 2 * techniques.len());
    let number = |row: &csv::StringRecord, name: &str| row[column(name)].parse::<f64>().unwrap();
    for (row, technique) in rows.iter().zip(techniques.iter().flat_map(|t| [t, t])) {
        assert_eq!((&row[0], &row[1]), ("mine", *technique));
        assert!(said.contains(*technique));
        // PSNR is RMSE in decibels.
        let psnr = -20.0 * libm::log10(number(row, "rmse"));
        assert!((number(row, "psnr") - psnr).abs() < 1e-12);
        assert!(number(row, "reference_error") < 0.01 && number(row, "rmse") < 0.5);
    }
    // The difference picture is ½ + 4 (picture - reference) in linear light: grey in the sky.
    assert!(picture("bilinear-difference").2[..20].iter().all(|&code| code == 128));
    // Run again, nothing changes.
    let again = run(&["render", "--scene", scene, "--out", one.to_str().unwrap()]);
    assert!(again.contains("0 files written, 13 unchanged"), "{again}");
}

#[test]
fn an_image_lies_on_the_plane_instead() {
    let out = folder("render-image");
    let scene = out.join("mine.toml");
    std::fs::write(&scene, small().replace("\"gaussian-third\", \"paper-r1\"", "\"nearest\"")).unwrap();
    let image = out.join("image.png");
    let bytes = png_bytes((1, 1), ColorType::Rgb, BitDepth::Eight, &[200, 100, 50], |_| ());
    std::fs::write(&image, bytes).unwrap();
    let paths = [&scene, &image, &out].map(|path| path.to_str().unwrap());
    run(&["render", "--scene", paths[0], "--image", paths[1], "--out", paths[2]]);
    let (width, _, data) = png_data(&std::fs::read(out.join("mine/trilinear.png")).unwrap());
    // The last row is plane: the image's one colour comes back through sRGB as it was.
    let last = &data[data.len() - 3 * width as usize..];
    assert!(last.chunks_exact(3).all(|pixel| pixel == [200, 100, 50]), "{last:?}");
}

#[test]
fn bad_scenes_get_one_line() {
    let out = folder("render-bad");
    let file = |name: &str, text: &str| {
        let path = out.join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let inside = out.join("never");
    let to = ["--out", inside.to_str().unwrap()];
    let scene = |scene: &str, names: &str| refused(&[&["render", "--scene", scene][..], &to].concat(), names);
    scene("/nonexistent.toml", "/nonexistent.toml: no such file or directory; built-in scenes are checker, ");
    scene(out.to_str().unwrap(), "a folder, not a scene file");
    scene(&file("empty.toml", ""), "line 1");
    let line = small().lines().position(|line| line.starts_with("pitch")).unwrap() + 1;
    let pich = file("pitch.toml", &small().replace("pitch", "pich"));
    scene(&pich, &format!("line {line}, column 1: unknown field `pich`"));
    scene(&file("sky.toml", &small().replace("pitch = 14.0", "pitch = -80.0")), "no pixel of the plane");
    let image = small().replace("kind = \"checker\"", "kind = \"image\"\npath = \"none.png\"");
    let image = image.replace("\nsize = 256\nsquare = 16", "");
    scene(&file("image.toml", &image), "none.png: no such file");
    refused(
        &[&["render", "--image", "/nonexistent.png"][..], &to].concat(),
        "/nonexistent.png: no such file",
    );
    refused(&["render", "--linear"], "--image");
    refused(&["render", "--threads", "0"], "0 is not in 1..=64");
    refused(&["render", "--example", "--measure"], "--measure");
    refused(&["render", "--out", env!("CARGO_BIN_EXE_bellfit")], "not a folder");
    assert!(!inside.exists());
}

#[test]
fn times_are_measured_and_written() {
    let out = folder("render-measure");
    let scene = out.join("mine.toml");
    std::fs::write(&scene, small()).unwrap();
    let paths = [&scene, &out].map(|path| path.to_str().unwrap());
    let said = run(&["render", "--measure", "--scene", paths[0], "--out", paths[1]]);
    assert!(said.contains("gaussian-half"));
    let written = files(&out);
    let tables: Vec<_> = written.keys().filter(|name| name.ends_with(".csv")).collect();
    assert_eq!(tables.len(), 1, "{:?}", written.keys());
    for name in ["filter.md", "filter-time.png", "filter-time.svg"] {
        assert!(written.contains_key(name), "{name}");
    }
    let mut reader = csv::Reader::from_reader(written[tables[0]].as_slice());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 5);
    for row in rows {
        let [nanoseconds, least, most]: [f64; 3] = [3, 4, 5].map(|i| row[i].parse().unwrap());
        assert!(0.0 < least && least <= nanoseconds && nanoseconds <= most, "{row:?}");
    }
}
