//! `bellfit sample` against a plain computation in double precision that shares no code with the filters.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/png_file.rs"]
mod png_file;
#[path = "support/program.rs"]
mod program;

use draw::Draw;
use png::{BitDepth, ColorType};
use png_file::{folder, png_bytes};
use program::{bellfit, refused};
use serde_json::Value;
use std::path::PathBuf;

fn json(arguments: &[&str]) -> Value {
    let output = bellfit(arguments);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {error}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A texture of random 8-bit values, as a file and as values in 0..1.
struct Texels {
    path: PathBuf,
    width: usize,
    height: usize,
    channels: usize,
    values: Vec<f64>,
}

impl Texels {
    fn random(name: &str, width: usize, height: usize, channels: usize) -> Texels {
        let mut draw = Draw(width as u64 * 1000 + channels as u64);
        let data: Vec<u8> = (0..width * height * channels).map(|_| draw.bits() as u8).collect();
        let kinds = [ColorType::Grayscale, ColorType::GrayscaleAlpha, ColorType::Rgb, ColorType::Rgba];
        let size = (width as u32, height as u32);
        let path = folder(name).join("texture.png");
        let bytes = png_bytes(size, kinds[channels - 1], BitDepth::Eight, &data, |_| ());
        std::fs::write(&path, bytes).unwrap();
        let values = data.iter().map(|&code| f64::from(code) / 255.0).collect();
        Texels { path, width, height, channels, values }
    }

    fn path(&self) -> &str {
        self.path.to_str().unwrap()
    }

    /// The texel at whole (x, y), anywhere.
    fn at(&self, x: i64, y: i64, wrap: &str) -> &[f64] {
        let place = |i: i64, size: usize| {
            let n = size as i64;
            let i = match wrap {
                "repeat" => ((i % n) + n) % n,
                "clamp" => i.max(0).min(n - 1),
                _ => {
                    let m = ((i % (2 * n)) + 2 * n) % (2 * n);
                    if m < n { m } else { 2 * n - 1 - m }
                }
            };
            i as usize
        };
        let first = self.channels * (place(y, self.height) * self.width + place(x, self.width));
        &self.values[first..first + self.channels]
    }

    fn bilinear(&self, s: f64, t: f64, wrap: &str) -> Vec<f64> {
        let (x, y) = ((s - 0.5).floor(), (t - 0.5).floor());
        let (fx, fy) = (s - 0.5 - x, t - 0.5 - y);
        let (x, y) = (x as i64, y as i64);
        let mut sum = vec![0.0; self.channels];
        for (dx, dy, w) in [
            (0, 0, (1.0 - fx) * (1.0 - fy)),
            (1, 0, fx * (1.0 - fy)),
            (0, 1, (1.0 - fx) * fy),
            (1, 1, fx * fy),
        ] {
            for (sum, value) in sum.iter_mut().zip(self.at(x + dx, y + dy, wrap)) {
                *sum += w * value;
            }
        }
        sum
    }

    /// The next mip level of an image whose sides are even.
    fn halved(&self) -> Texels {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut values = Vec::new();
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            for c in 0..self.channels {
                let at = |dx: usize, dy: usize| self.at((2 * x + dx) as i64, (2 * y + dy) as i64, "clamp")[c];
                values.push(0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
            }
        }
        Texels { path: PathBuf::new(), width, height, channels: self.channels, values }
    }

    /// Weighted mean over xᵀ M⁻¹ x ≤ 1, with the texels counted; none if one lies too near the rim to tell in
    /// single precision.
    fn ellipse(
        &self,
        [s, t]: [f64; 2],
        m: [f64; 3],
        wrap: &str,
        weight: &dyn Fn(f64, f64) -> f64,
    ) -> Option<(Vec<f64>, u64)> {
        let [uu, uv, vv] = m;
        let det = uu * vv - uv * uv;
        // Unit vectors and lengths of the axes, for weights along them.
        let angle = 0.5 * libm::atan2(2.0 * uv, uu - vv);
        let (c, n) = (libm::cos(angle), libm::sin(angle));
        let along = uu * c * c + 2.0 * uv * c * n + vv * n * n;
        let across = uu * n * n - 2.0 * uv * c * n + vv * c * c;
        let (mut sum, mut total, mut texels) = (vec![0.0; self.channels], 0.0, 0);
        let reach = |half: f64| half.sqrt().ceil() as i64 + 1;
        for y in t.floor() as i64 - reach(vv)..=t.floor() as i64 + reach(vv) {
            for x in s.floor() as i64 - reach(uu)..=s.floor() as i64 + reach(uu) {
                let (u, v) = (x as f64 + 0.5 - s, y as f64 + 0.5 - t);
                let q = (vv * u * u - 2.0 * uv * u * v + uu * v * v) / det;
                if (q - 1.0).abs() < 1e-4 {
                    return None;
                }
                if q > 1.0 {
                    continue;
                }
                let (a, b) = (u * c + v * n, v * c - u * n);
                let w = weight(a * a / along, b * b / across);
                if w > 0.0 {
                    texels += 1;
                }
                total += w;
                for (sum, value) in sum.iter_mut().zip(self.at(x, y, wrap)) {
                    *sum += w * value;
                }
            }
        }
        (total > 0.0).then(|| (sum.iter().map(|sum| sum / total).collect(), texels))
    }
}

fn matrix([ux, vx, uy, vy]: [f64; 4], padded: bool) -> [f64; 3] {
    let one = if padded { 1.0 } else { 0.0 };
    [ux * ux + uy * uy + one, ux * vx + uy * vy, vx * vx + vy * vy + one]
}

fn powi(x: f64, n: u32) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// The weight by its name, from its definition; of cubic ones the exponential they stand for.
fn weight(id: &str, sigma: f64) -> Box<dyn Fn(f64, f64) -> f64> {
    let t = move |q: f64| q / (2.0 * sigma * sigma);
    let eighth = |c: f64| move |q: f64| powi((1.0 - c * q).max(0.0), 8);
    let scale = |id: &str| match id.trim_end_matches("-product") {
        "paper-r1" => 1.0,
        "paper-r2" => 9.0 / 16.0,
        "paper-r3" => 0.5,
        _ => 0.125,
    };
    if id == "box" {
        Box::new(|_, _| 1.0)
    } else if id.ends_with("-product") {
        let f = eighth(scale(id));
        Box::new(move |a, b| f(a) * f(b))
    } else if id.starts_with("paper") {
        let f = eighth(scale(id));
        Box::new(move |a, b| f(a + b))
    } else if let Some(k) = id.strip_prefix("bell-") {
        let k: u32 = k.parse().unwrap();
        Box::new(move |a, b| powi((1.0 - t(a + b) / f64::from(k)).max(0.0), k))
    } else {
        Box::new(move |a, b| libm::exp(-t(a + b)))
    }
}

fn text(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
}

/// Places and Jacobians that single precision holds exactly: 1/256 and 1/64 texels.
fn place(draw: &mut Draw) -> ([f64; 2], [f64; 4]) {
    let mut part = |span: f64, parts: f64| libm::round(draw.real(-span, span) * parts) / parts;
    (
        [part(60.0, 256.0), part(60.0, 256.0)],
        [part(7.0, 64.0), part(7.0, 64.0), part(7.0, 64.0), part(7.0, 64.0)],
    )
}

#[test]
fn every_weight_is_the_plain_weighted_mean() {
    let mut draw = Draw(5);
    let mut compared = 0;
    let weights = [
        "gaussian",
        "box",
        "paper-r1",
        "paper-r2",
        "paper-r3",
        "paper-r4",
        "paper-r1-product",
        "paper-r2-product",
        "paper-r3-product",
        "paper-r4-product",
        "bell-2",
        "bell-4",
        "bell-8",
        "bell-16",
        "bell-32",
        "bell-64",
        "cubic-2",
        "cubic-4",
        "cubic-8",
    ];
    for channels in 1..=4 {
        let texels = Texels::random(&format!("weights-{channels}"), 32 + channels, 16 + channels, channels);
        for id in weights {
            for wrap in ["repeat", "clamp", "mirror"] {
                let (at, j) = place(&mut draw);
                let padded = draw.below(2) == 1;
                let sigma = if id == "gaussian" || id.contains("bell") || id.contains("cubic") {
                    Some([0.5, 0.25, 1.0 / 3.0][draw.below(3)])
                } else {
                    None
                };
                let of = weight(id, sigma.unwrap_or(1.0));
                // Thin ellipses put all weight on a texel or two, whose place in them is ill conditioned.
                let m = matrix(j, padded);
                let det = m[0] * m[2] - m[1] * m[1];
                if det < 0.02 * (m[0] + m[2]) * (m[0] + m[2]) {
                    continue;
                }
                let Some((expected, count)) = texels.ellipse(at, m, wrap, &of) else { continue };
                let (at, j) = (text(&at), text(&j));
                let sigma_text = sigma.map(|s| s.to_string()).unwrap_or_default();
                let conic = if padded { "padded" } else { "plain" };
                let mut arguments = vec![
                    "sample",
                    texels.path(),
                    "--at",
                    &at,
                    "--jacobian",
                    &j,
                    "--weight",
                    id,
                    "--wrap",
                    wrap,
                    "--conic",
                    conic,
                    "--level",
                    "0",
                    "--linear",
                    "--json",
                ];
                // 1/3 is what stands if nothing is given.
                if sigma.is_some_and(|s| s != 1.0 / 3.0) {
                    arguments.extend(["--sigma", &sigma_text]);
                }
                let found = json(&arguments);
                // Single precision: Q to 1e-5 relative, up to 32 powers of it, sums of up to some hundred texels;
                // the cubic bells are the exponential but for their certified 3.5e-3, 4.8e-4 and 5.4e-5 of the
                // peak, on texels whose mean weight is above a tenth of it.
                let slack = match id {
                    "cubic-2" => 5e-2,
                    "cubic-4" => 7e-3,
                    "cubic-8" => 8e-4,
                    _ => 2e-4,
                };
                let values = found["value"].as_array().unwrap();
                assert_eq!(values.len(), channels);
                for (value, expected) in values.iter().zip(&expected) {
                    let off = (value.as_f64().unwrap() - expected).abs();
                    assert!(off < slack, "{arguments:?}: {value} {expected}");
                }
                // A weight cut before the rim is 0 on some texels; the cubic ones are cut elsewhere.
                if !id.starts_with("cubic")
                    && !id.starts_with("bell")
                    && !id.contains("r1")
                    && !id.contains("r2")
                {
                    assert_eq!(found["texels"], count, "{arguments:?}");
                }
                assert_eq!(found["fallback"], false);
                compared += 1;
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn nearest_bilinear_and_trilinear_are_what_they_are_called() {
    let mut draw = Draw(8);
    let texels = Texels::random("four", 32, 32, 3);
    let levels = [texels.halved(), texels.halved().halved(), texels.halved().halved().halved()];
    let check = |found: &Value, expected: &[f64], arguments: &[&str]| {
        for (value, expected) in found["value"].as_array().unwrap().iter().zip(expected) {
            // A few roundings of values below 1 and of weights.
            let off = (value.as_f64().unwrap() - expected).abs();
            assert!(off < 2e-6, "{arguments:?}: {value} {expected}");
        }
    };
    for wrap in ["repeat", "clamp", "mirror"].repeat(6) {
        let (at, j) = place(&mut draw);
        let (at_text, j_text) = (text(&at), text(&j));
        let of = |method: &'static str| -> Vec<&str> {
            vec![
                "sample",
                texels.path(),
                "--at",
                &at_text,
                "--jacobian",
                &j_text,
                "--method",
                method,
                "--wrap",
                wrap,
                "--linear",
                "--json",
            ]
        };
        let arguments = of("nearest");
        let found = json(&arguments);
        check(&found, texels.at(at[0].floor() as i64, at[1].floor() as i64, wrap), &arguments);
        assert_eq!((&found["texels"], &found["level"]), (&1.into(), &0.0.into()));
        let arguments = of("bilinear");
        let found = json(&arguments);
        check(&found, &texels.bilinear(at[0], at[1], wrap), &arguments);
        let mut arguments = of("bilinear");
        arguments.extend(["--level", "1"]);
        check(&json(&arguments), &levels[0].bilinear(0.5 * at[0], 0.5 * at[1], wrap), &arguments);
        let arguments = of("trilinear");
        let found = json(&arguments);
        let longer = libm::hypot(j[0], j[1]).max(libm::hypot(j[2], j[3]));
        let lambda = libm::log2(longer).clamp(0.0, 3.0);
        let level = |i: usize| {
            let image = if i == 0 { &texels } else { &levels[i - 1] };
            let scale = 1.0 / f64::from(1 << i);
            image.bilinear(scale * at[0], scale * at[1], wrap)
        };
        let (fine, part) = (lambda.floor() as usize, lambda - lambda.floor());
        let coarse = if part > 0.0 { level(fine + 1) } else { level(fine) };
        let expected: Vec<f64> = level(fine).iter().zip(coarse).map(|(a, b)| a + part * (b - a)).collect();
        if longer < 8.0 {
            check(&found, &expected, &arguments);
            assert!((found["level"].as_f64().unwrap() - lambda).abs() < 1e-6);
        }
    }
}

#[test]
fn a_coarser_level_is_read_in_its_own_texels() {
    let mut draw = Draw(21);
    let texels = Texels::random("coarser", 64, 32, 2);
    let half = texels.halved();
    let mut compared = 0;
    for _ in 0..12 {
        let (at, j) = place(&mut draw);
        let padded = draw.below(2) == 1;
        let m = matrix(j.map(|x| 0.5 * x), padded);
        if m[0] * m[2] - m[1] * m[1] < 0.02 * (m[0] + m[2]) * (m[0] + m[2]) {
            continue;
        }
        let of = weight("gaussian", 1.0 / 3.0);
        let Some((expected, count)) = half.ellipse(at.map(|x| 0.5 * x), m, "repeat", &of) else { continue };
        let (at, j) = (text(&at), text(&j));
        let conic = if padded { "padded" } else { "plain" };
        let found = json(&[
            "sample",
            texels.path(),
            "--at",
            &at,
            "--jacobian",
            &j,
            "--conic",
            conic,
            "--level",
            "1",
            "--linear",
            "--json",
        ]);
        for (value, expected) in found["value"].as_array().unwrap().iter().zip(&expected) {
            assert!((value.as_f64().unwrap() - expected).abs() < 2e-5, "{at} {j}");
        }
        assert_eq!((&found["texels"], &found["level"]), (&count.into(), &1.0.into()));
        compared += 1;
    }
    assert!(compared > 4, "{compared}");
}

#[test]
fn axes_are_the_roots_of_the_matrix() {
    let texels = Texels::random("axes", 8, 8, 1);
    let mut draw = Draw(13);
    for _ in 0..8 {
        let (at, j) = place(&mut draw);
        for padded in [false, true] {
            let [uu, uv, vv] = matrix(j, padded);
            let (mean, half) = (0.5 * (uu + vv), libm::hypot(0.5 * (uu - vv), uv));
            let tilt = 0.5 * libm::atan2(2.0 * uv, uu - vv).to_degrees();
            let (at, j) = (text(&at), text(&j));
            let conic = if padded { "padded" } else { "plain" };
            let found =
                json(&["sample", texels.path(), "--at", &at, "--jacobian", &j, "--conic", conic, "--json"]);
            let number = |key: &str| found[key].as_f64().unwrap();
            let axis = |i: usize| found["axes"][i].as_f64().unwrap();
            assert!((axis(0) - (mean + half).sqrt()).abs() < 1e-9);
            // The difference cancels in the test's formula, not in the program's.
            assert!((axis(1) - (mean - half).max(0.0).sqrt()).abs() < 1e-5);
            let off = libm::fabs(number("tilt") - tilt) % 180.0;
            assert!(off.min(180.0 - off) < 1e-7, "{j}: {off}");
        }
    }
    // The paper's: lengths of the two vectors, and either tilt.
    let paper = |axes| {
        json(&["sample", texels.path(), "--at", "1,1", "--jacobian", "3,4,-1,0", "--axes", axes, "--json"])
    };
    let (vector, conic) = (paper("paper-vector"), paper("paper-conic"));
    assert_eq!(vector["axes"], serde_json::json!([5.0, 1.0]));
    assert!((vector["tilt"].as_f64().unwrap() - libm::atan(4.0 / 3.0).to_degrees()).abs() < 1e-12);
    // A = 16, B = -24, C = 10: ½ arctan(-24/6)
    assert!((conic["tilt"].as_f64().unwrap() - 0.5 * libm::atan(-4.0).to_degrees()).abs() < 1e-12);
    // Base diameter 1 halves every length.
    let narrow =
        json(&["sample", texels.path(), "--at", "1,1", "--jacobian", "4,0,0,2", "--diameter", "1", "--json"]);
    assert_eq!(narrow["axes"], serde_json::json!([2.0, 1.0]));
    let limited = json(&[
        "sample",
        texels.path(),
        "--at",
        "1,1",
        "--jacobian",
        "40,0,0,2",
        "--anisotropy",
        "4",
        "--json",
    ]);
    assert_eq!(limited["axes"], serde_json::json!([40.0, 10.0]));
}

#[test]
fn srgb_is_decoded_unless_values_are_linear() {
    let path = folder("decoded").join("texture.png");
    std::fs::write(&path, png_bytes((1, 1), ColorType::GrayscaleAlpha, BitDepth::Eight, &[188, 128], |_| ()))
        .unwrap();
    let at = ["--at", "0.5,0.5", "--jacobian", "1,0,0,1", "--json"];
    let path = path.to_str().unwrap();
    let found = json(&[&["sample", path][..], &at].concat());
    // ((188/255 + 0.055)/1.055)^2.4 = 0.50288645...; alpha is linear always.
    assert!((found["value"][0].as_f64().unwrap() - 0.502_886_45).abs() < 1e-7, "{found}");
    assert!((found["value"][1].as_f64().unwrap() - 128.0 / 255.0).abs() < 1e-7);
    let found = json(&[&["sample", path][..], &at, &["--linear"]].concat());
    assert!((found["value"][0].as_f64().unwrap() - 188.0 / 255.0).abs() < 1e-7);
    assert_eq!(found["channels"], serde_json::json!(["grey", "alpha"]));
}

#[test]
fn far_positions_are_the_same_texels() {
    let texels = Texels::random("far", 32, 32, 1);
    let value = |at: &str| {
        let arguments = ["sample", texels.path(), "--at", at, "--jacobian", "3,1,-1,2", "--json"];
        json(&arguments)["value"].clone()
    };
    assert_eq!(value("5.25,7.5"), value("320000005.25,-639999992.5"));
    // An ellipse without a texel: bilinear, and it says so.
    let thin = json(&["sample", texels.path(), "--at", "4,4", "--jacobian", "0,0,0,0", "--linear", "--json"]);
    assert_eq!(thin["fallback"], true);
    let expected = texels.bilinear(4.0, 4.0, "repeat")[0];
    assert!((thin["value"][0].as_f64().unwrap() - expected).abs() < 1e-6);
    let lines = bellfit(&["sample", texels.path(), "--at", "4,4", "--jacobian", "0,0,0,0"]);
    let lines = String::from_utf8(lines.stdout).unwrap();
    for word in ["value ", "axes ", "tilt ", "level ", "texels ", "fallback "] {
        assert!(lines.lines().any(|line| line.starts_with(word)), "{lines}");
    }
}

#[test]
fn bad_input_gets_one_line() {
    let texels = Texels::random("bad", 8, 8, 3);
    let path = texels.path();
    let at = |position: &'static str, jacobian: &'static str| {
        ["sample", path, "--at", position, "--jacobian", jacobian].map(str::to_owned)
    };
    for (position, jacobian, names) in [
        ("nan,1", "1,0,0,1", "--at"),
        ("inf,1", "1,0,0,1", "2 numbers"),
        ("1e10,1", "1,0,0,1", "-1e9 to 1e9"),
        ("1", "1,0,0,1", "--at"),
        ("1,2,3", "1,0,0,1", "--at"),
        ("a,b", "1,0,0,1", "--at"),
        ("", "1,0,0,1", "--at"),
        ("1,2", "1,0,0", "4 numbers"),
        ("1,2", "1,0,0,inf", "--jacobian"),
        ("1,2", "1,0,0,-1e300", "--jacobian"),
    ] {
        let arguments = at(position, jacobian);
        refused(&arguments.each_ref().map(String::as_str), names);
    }
    let with = |more: &[&'static str], names: &str| {
        let arguments = at("1,2", "2,0,0,1");
        let mut all: Vec<&str> = arguments.iter().map(String::as_str).collect();
        all.extend(more);
        refused(&all, names);
    };
    for (option, value) in [
        ("--weight", "box"),
        ("--sigma", "0.5"),
        ("--conic", "padded"),
        ("--axes", "paper-conic"),
        ("--anisotropy", "8"),
        ("--rim", "area"),
        ("--diameter", "1"),
    ] {
        for method in ["nearest", "bilinear", "trilinear"] {
            with(
                &["--method", method, option, value],
                &format!("{option}: of no use with --method {method}"),
            );
        }
    }
    with(&["--method", "bilinear", "--filter", "kaiser"], "--filter: of no use");
    with(&["--level", "0", "--filter", "box"], "--filter: of no use");
    for weight in ["box", "paper-r1", "paper-r4-product"] {
        with(&["--weight", weight, "--sigma", "0.5"], "--sigma: the weight");
    }
    for sigma in ["0", "-1", "nan", "inf", "1e9"] {
        with(&["--sigma", sigma], "must be 1/1024 to 1024");
    }
    with(&["--sigma", "wide"], "--sigma");
    with(&["--anisotropy", "0.5"], "must be 1 or more");
    with(&["--weight", "bell-3"], "known are gaussian, ");
    with(&["--weight", "cubic-16"], "cubic-8");
    with(&["--method", "cubic"], "known are nearest, bilinear, trilinear, ellipse");
    with(&["--wrap", "tile"], "known are repeat, clamp, mirror");
    with(&["--conic", "fat"], "known are plain, padded");
    with(&["--axes", "short"], "known are conic, paper-vector, paper-conic");
    with(&["--rim", "soft"], "known are none, ");
    with(&["--diameter", "3"], "known are 1, 2");
    with(&["--level", "4"], "--level 4: the image has levels 0 to 3");
    for level in ["-1", "1.5", "two", "99999999999999999999"] {
        with(&["--level", level], "a level is a whole number, 0 for the image itself");
    }
    refused(&["sample", path, "--at", "1,2"], "--jacobian");
    let wide = ["sample", path, "--at", "1,2", "--jacobian", "1e8,0,0,1e8", "--level", "0"];
    refused(&wide, "more than 2^28 texels");

    let out = folder("bad-images");
    let file = |name: &str, bytes: &[u8]| {
        let path = out.join(name);
        std::fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let whole = std::fs::read(path).unwrap();
    let mut spoilt = whole.clone();
    spoilt[29] ^= 1; // the header's checksum
    for (image, names) in [
        ("/nonexistent.png".to_owned(), "/nonexistent.png: no such file"),
        (out.to_str().unwrap().to_owned(), "a folder, not a PNG file"),
        (file("empty.png", b""), "not a readable PNG"),
        (file("text.png", b"not a picture"), "not a readable PNG"),
        (file("spoilt.png", &spoilt), "CRC error"),
        (file("cut.png", &whole[..whole.len() / 2]), "cut.png: not a readable PNG"),
    ] {
        refused(&["sample", &image, "--at", "1,2", "--jacobian", "1,0,0,1"], names);
    }
    // Nothing of the decoder's own structs.
    let dump = bellfit(&["sample", &file("spoilt.png", &spoilt), "--at", "1,2", "--jacobian", "1,0,0,1"]);
    assert!(!String::from_utf8(dump.stderr).unwrap().contains('{'));
}

#[test]
fn help_has_examples() {
    let output = bellfit(&["sample", "--help"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(String::from_utf8(output.stdout).unwrap().contains("Examples:"));
}
