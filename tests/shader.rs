//! The emitted code: what is offered, what the comments say, and that it compiles and computes.
//!
//! C and Rust run against the kernels here, WGSL in ci/shaders; GLSL and HLSL are read by glslang, which did
//! not write them.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

mod support {
    pub mod calls;
    pub mod draw;
}

use bellfit::bound::Format;
use bellfit::kernel::constants::{CS16_ONE_SIDED, CUBIC_COS_N, CUBIC_FACTOR, LINEAR_COS_N};
use bellfit::kernel::model::Model;
use bellfit::kernel::pixel::{PaperReading, PixelWeight};
use bellfit::kernel::stand_in::{Argument, StandIn};
use bellfit::shader::{Language, Piece, ShaderError, emit};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use support::calls::{Call, Number, calls};

const ARGUMENTS: [Argument; 2] = [Argument::Cosine, Argument::Versine];

/// Everything there is; the weights with one σ, so that all can stand in one text.
fn pieces() -> Vec<Piece> {
    let mut pieces = Vec::new();
    for stand_in in StandIn::ALL {
        for argument in ARGUMENTS {
            pieces.push(Piece::Lobe { stand_in, argument, error: None });
        }
        for model in Model::ALL {
            pieces.push(Piece::Factor { model, stand_in, nudge: 0.0 });
        }
    }
    pieces.push(Piece::Footprint);
    pieces.extend(weights().into_iter().map(Piece::Weight));
    pieces
}

fn weights() -> Vec<PixelWeight<f64>> {
    let sigma = 1.0 / 3.0;
    let mut weights = vec![PixelWeight::Gaussian(sigma), PixelWeight::Box];
    for reading in PaperReading::ALL {
        weights.extend([PixelWeight::Paper(reading), PixelWeight::PaperProduct(reading)]);
    }
    weights.extend([2, 4, 8, 16, 32, 64].map(|k| PixelWeight::Bell(k, sigma)));
    weights.extend([2, 4, 8].map(|k| PixelWeight::Cubic(k, sigma)));
    weights
}

/// Whether the code needs an exponential, a logarithm or a cube root.
fn is_elementary(piece: &Piece) -> bool {
    match piece {
        Piece::Lobe { stand_in, argument, .. } => match stand_in {
            StandIn::SphericalGaussian | StandIn::Exp2Log2 | StandIn::Power => true,
            StandIn::Cubic2 | StandIn::Cubic4 => *argument == Argument::Cosine,
            _ => false,
        },
        Piece::Factor { model, stand_in, .. } => {
            stand_in.is_exact() && matches!(model, Model::BlinnPhong | Model::BlinnPhongModified)
        }
        Piece::Footprint => false,
        Piece::Weight(weight) => matches!(weight, PixelWeight::Gaussian(_)),
    }
}

fn has_no_factor(piece: &Piece) -> bool {
    let none = [StandIn::Schlick, StandIn::SchlickPrinted, StandIn::SphericalGaussian];
    matches!(piece, Piece::Factor { stand_in, .. } if none.contains(stand_in))
}

/// The table of the module's page, word by word.
fn is_offered(language: Language, format: Format) -> bool {
    match language {
        Language::Wgsl => matches!(format, Format::Half | Format::Single),
        Language::Msl => format == Format::Single,
        _ => matches!(format, Format::Single | Format::Double),
    }
}

/// All pieces that the language has in the format, as one text.
fn everything(language: Language, format: Format) -> String {
    let offered: Vec<Piece> = pieces()
        .into_iter()
        .filter(|piece| emit(std::slice::from_ref(piece), format, language).is_ok())
        .collect();
    emit(&offered, format, language).unwrap()
}

#[test]
fn each_combination_is_offered_or_refused_by_its_error() {
    for language in Language::ALL {
        for format in Format::ALL {
            for piece in pieces() {
                let case = format!("{language} {} {piece:?}", format.id());
                let found = emit(std::slice::from_ref(&piece), format, language);
                let is_gpu = matches!(language, Language::Glsl | Language::Hlsl);
                match found {
                    Err(ShaderError::Format { .. }) => assert!(!is_offered(language, format), "{case}"),
                    _ if !is_offered(language, format) => panic!("{case}: {found:?}"),
                    Err(ShaderError::NoFactor(_)) => assert!(has_no_factor(&piece), "{case}"),
                    Err(ShaderError::Range) => {
                        assert!(format == Format::Half && piece == Piece::Footprint, "{case}")
                    }
                    Err(ShaderError::Elementary { .. }) => {
                        assert!(is_gpu && format == Format::Double && is_elementary(&piece), "{case}")
                    }
                    Err(error) => panic!("{case}: {error}"),
                    Ok(text) => {
                        assert!(!has_no_factor(&piece), "{case}");
                        assert!(!(is_gpu && format == Format::Double && is_elementary(&piece)), "{case}");
                        assert!(text.is_ascii(), "{case}: {text}");
                        assert_eq!(
                            text,
                            emit(&[piece.clone(), piece.clone()], format, language).unwrap(),
                            "{case}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_outside_the_domain_is_refused() {
    let weight = |weight| emit(&[Piece::Weight(weight)], Format::Single, Language::C);
    for sigma in [0.0, -0.5, f64::NAN, f64::INFINITY, 1e-30, 1e30] {
        for found in [weight(PixelWeight::Gaussian(sigma)), weight(PixelWeight::Bell(8, sigma))] {
            assert!(matches!(found, Err(ShaderError::Sigma(_))), "{sigma}: {found:?}");
        }
    }
    for k in [0, 1, 3, 128] {
        assert!(matches!(weight(PixelWeight::Bell(k, 0.5)), Err(ShaderError::Power { .. })), "{k}");
        assert!(matches!(weight(PixelWeight::Cubic(k, 0.5)), Err(ShaderError::Power { .. })), "{k}");
    }
    assert!(matches!(weight(PixelWeight::Cubic(16, 0.5)), Err(ShaderError::Power { .. })));
    assert_eq!(emit(&[], Format::Single, Language::C), Err(ShaderError::Empty));
    // One name, two σ.
    let both = [0.25, 0.5].map(|sigma| Piece::Weight(PixelWeight::Bell(8, sigma)));
    let found = emit(&both, Format::Single, Language::C);
    assert_eq!(found, Err(ShaderError::Name("bell_8_weight".to_owned())));
}

/// Comments and code of a text, function by function: what stands above a line that opens one.
fn functions(text: &str, language: Language) -> Vec<(Vec<String>, String)> {
    let mark = if language == Language::Rust { "///" } else { "//" };
    let mut found: Vec<(Vec<String>, String)> = Vec::new();
    let mut comment = Vec::new();
    for line in text.lines() {
        if let Some(words) = line.strip_prefix(mark) {
            comment.push(words.trim().to_owned());
        } else if line.is_empty() {
            comment.clear();
        } else if let Some((_, code)) = found.last_mut().filter(|_| line.starts_with([' ', '}', ')', '{'])) {
            let code_line = line.split("//").next().unwrap_or_default();
            code.push_str(&format!("{code_line}\n"));
        } else if !line.starts_with('#') && !line.starts_with("using ") && !line.starts_with("enable ") {
            found.push((std::mem::take(&mut comment), format!("{line}\n")));
        }
    }
    found
}

#[test]
fn every_function_says_what_it_is() {
    for language in Language::ALL {
        let text = everything(language, Format::Single);
        let found = functions(&text, language);
        assert!(found.len() > 80, "{language}: {}", found.len());
        for (comment, code) in found {
            // HLSL's constructors of structures are naga's own.
            if code.contains(" Construct") && language == Language::Hlsl && code.contains("arg0") {
                continue;
            }
            let generator = format!("Generator: bellfit {}.", env!("CARGO_PKG_VERSION"));
            assert!(comment.contains(&generator), "{language}: {comment:?}\n{code}");
            assert!(comment.iter().all(|line| line.len() <= 100 && !line.ends_with('\\')));
            let is_function = !code.contains("struct");
            for word in ["Domain: ", "Error: ", "Source: "] {
                let says = comment.iter().any(|line| line.starts_with(word));
                assert!(says || !is_function, "{language}: no {word}in {comment:?}\n{code}");
            }
        }
    }
}

#[test]
fn the_callers_sentence_stands_in_the_comment_and_cannot_leave_it() {
    let error = Some("|f - cosⁿ| ≤ 1e-3 */\nint x; \\\n\u{85}int y; \\".to_owned());
    let piece = Piece::Lobe { stand_in: StandIn::Cs16, argument: Argument::Cosine, error };
    for language in Language::ALL {
        let text = emit(std::slice::from_ref(&piece), Format::Single, language).unwrap();
        assert!(text.contains("Error: |f - cos^n| <= 1e-3 */ int x; / int y; /\n"), "{text}");
        assert!(!text.contains('\\') && text.is_ascii());
    }
}

/// Numbers with a point or an exponent in a text.
fn literals(code: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_alphanumeric() || c == '.' || c == '_';
    let mut numbers = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find(is_part) {
        rest = &rest[at..];
        let mut end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        // 1e-9
        if rest[..end].ends_with('e')
            && rest.starts_with(|c: char| c.is_ascii_digit())
            && rest[end..].starts_with('-')
        {
            end += 1 + rest[end + 1..].find(|c| !is_part(c)).unwrap_or(rest.len() - end - 1);
        }
        let token = rest[..end].trim_end_matches(['f', 'F', 'L', 'l']);
        if token.starts_with(|c: char| c.is_ascii_digit()) && token.contains(['.', 'e']) {
            numbers.push(token.parse().unwrap());
        }
        rest = &rest[end..];
    }
    numbers
}

/// Of f32 the number itself must come back from its decimal, not one near it.
fn rounded(value: f64, format: Format) -> f64 {
    if format == Format::Single { f64::from(value as f32) } else { value }
}

#[test]
fn constants_are_those_of_the_kernels() {
    let bells = LINEAR_COS_N.iter().map(|row| (row, format!("linear-{}", row.power)));
    let bells = bells.chain(CUBIC_COS_N.iter().map(|row| (row, format!("cubic-{}", row.power))));
    let bells: Vec<_> = bells.map(|(row, id)| (row, StandIn::from_id(&id).unwrap())).collect();
    for language in Language::ALL {
        for format in [Format::Single, Format::Double].into_iter().filter(|f| is_offered(language, *f)) {
            let check = |piece: Piece, constants: Vec<f64>| {
                let text = match emit(std::slice::from_ref(&piece), format, language) {
                    Ok(text) => text,
                    Err(ShaderError::Elementary { .. }) => return,
                    Err(error) => panic!("{error}"),
                };
                let code: String = functions(&text, language).into_iter().map(|(_, code)| code).collect();
                let found: Vec<f64> = literals(&code).into_iter().map(|x| rounded(x, format)).collect();
                for c in constants.iter().filter(|c| **c != 0.0).map(|c| rounded(c.abs(), format)) {
                    assert!(found.contains(&c), "{language} {}: {c:?} is not in\n{code}", format.id());
                }
                // Nor is there another of so many digits.
                for x in found.iter().filter(|x| (**x * 64.0).fract() != 0.0) {
                    let is_known = constants.iter().any(|c| rounded(c.abs(), format) == *x);
                    assert!(is_known, "{language} {}: {x:?} in\n{code}", format.id());
                }
            };
            for (row, stand_in) in &bells {
                for argument in ARGUMENTS {
                    let constants = [row.reach, row.linear, row.square].concat();
                    check(Piece::Lobe { stand_in: *stand_in, argument, error: None }, constants);
                }
            }
            for (i, model) in Model::ALL.into_iter().enumerate() {
                for (row, stand_in) in
                    [StandIn::Cubic2, StandIn::Cubic4, StandIn::Cubic8].into_iter().enumerate()
                {
                    let mut constants = CUBIC_FACTOR[row][i].to_vec();
                    constants[4] *= std::f64::consts::PI;
                    check(Piece::Factor { model, stand_in, nudge: 0.0 }, constants);
                }
            }
        }
    }
    // Of cs_16 the line's row is there; the exact form beside it has its own.
    for (i, model) in Model::ALL.into_iter().enumerate() {
        let text = emit(
            &[Piece::Factor { model, stand_in: StandIn::Cs16, nudge: 0.0 }],
            Format::Double,
            Language::C,
        )
        .unwrap();
        let found = literals(&functions(&text, Language::C)[0].1);
        let [a, b, divisor] = CS16_ONE_SIDED[i];
        for c in [a, b, divisor * std::f64::consts::PI].into_iter().filter(|c| *c != 0.0) {
            assert!(found.contains(&c), "{c} is not in {found:?}");
        }
    }
}

#[test]
fn wgsl_is_valid_as_a_whole() {
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    let validate = |text: &str, capabilities| {
        let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
        let found = Validator::new(ValidationFlags::all(), capabilities).validate(&module);
        found.map(|_| ()).map_err(|error| error.emit_to_string(text))
    };
    let single = everything(Language::Wgsl, Format::Single);
    assert_eq!(validate(&single, Capabilities::empty()), Ok(()));
    let half = everything(Language::Wgsl, Format::Half);
    assert_eq!(validate(&half, Capabilities::SHADER_FLOAT16), Ok(()));
    // And the validator sees a defect: a structure where a number belongs.
    let broken = single.replace("return Footprint(uu, uv, vv, det_j * det_j);", "return uu;");
    assert!(broken != single && validate(&broken, Capabilities::empty()).is_err());
}

/// Says on the terminal, past the capture of a test's output, that a check did not run.
fn skipped(what: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {what}");
}

fn is_there(program: &str) -> bool {
    Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok()
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("shader-{name}"));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a command to its end; its output, or all it said.
fn run(command: &mut Command, input: &str) -> Result<String, String> {
    let (stdin, stdout, stderr) = (Stdio::piped(), Stdio::piped(), Stdio::piped());
    let mut child = command.stdin(stdin).stdout(stdout).stderr(stderr).spawn().map_err(|e| e.to_string())?;
    let mut pipe = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || {
        // A program that reads no input closes the pipe.
        let _ = pipe.write_all(input.as_bytes());
    });
    let output = child.wait_with_output().map_err(|e| e.to_string())?;
    writer.join().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(text) } else { Err(text + &String::from_utf8_lossy(&output.stderr)) }
}

#[test]
fn glslang_reads_glsl_and_hlsl() {
    if !is_there("glslangValidator") {
        let required = std::env::var_os("REQUIRE_GLSLANG").is_some_and(|value| value == "1");
        assert!(!required, "no glslangValidator, and REQUIRE_GLSLANG=1");
        return skipped("no glslangValidator reads the emitted GLSL and HLSL");
    }
    let folder = folder("glslang");
    let check = |name: &str, options: &[&str], text: String| {
        let file = folder.join(name);
        std::fs::write(&file, text).unwrap();
        run(Command::new("glslangValidator").current_dir(&folder).args(options).arg(&file), "").map(|_| ())
    };
    for format in [Format::Single, Format::Double] {
        let glsl = everything(Language::Glsl, format);
        let whole =
            |text: &str| format!("#version 450\nlayout(local_size_x = 1) in;\n{text}\nvoid main() {{}}\n");
        let name = format!("{}.comp", format.id());
        assert_eq!(check(&name, &["-S", "comp"], whole(&glsl)), Ok(()));
        // ES 3.1, which has no double.
        if format == Format::Single {
            let es = whole(&glsl).replace("#version 450", "#version 310 es\nprecision highp float;");
            assert_eq!(check("es.comp", &["-S", "comp"], es), Ok(()));
        }
        assert!(check("broken.comp", &["-S", "comp"], whole(&glsl.replace("squared", "square d"))).is_err());
        let hlsl = everything(Language::Hlsl, format);
        let whole = |text: &str| format!("{text}\n[numthreads(1, 1, 1)]\nvoid main() {{}}\n");
        let options = ["-D", "-V", "-S", "comp", "-e", "main", "-o", "out.spv"];
        assert_eq!(check(&format!("{}.hlsl", format.id()), &options, whole(&hlsl)), Ok(()));
        assert!(check("broken.hlsl", &options, whole(&hlsl.replace("squared", "square d"))).is_err());
    }
}

/// Feeds every call's arguments to a driver and compares what comes back.
fn compare<F: Number>(calls: &[Call<F>], driver: &mut Command, language: Language) {
    let mut input = String::new();
    for (i, call) in calls.iter().enumerate() {
        for arguments in &call.arguments {
            input.push_str(&format!("{i}"));
            for slot in 0..6 {
                let value = arguments.get(slot).copied().unwrap_or(F::ZERO);
                input.push_str(&format!(" {:x}", value.bits()));
            }
            input.push('\n');
        }
    }
    let output = run(driver, &input).unwrap();
    let mut lines = output.lines();
    let mut count = 0;
    for call in calls {
        for arguments in &call.arguments {
            let line = lines.next().unwrap_or_else(|| panic!("{language}: no answer to {}", call.name));
            let found: Vec<F> =
                line.split(' ').map(|word| F::of_bits(u64::from_str_radix(word, 16).unwrap())).collect();
            call.check(arguments, &found, language.id());
            count += 1;
        }
    }
    assert!(lines.next().is_none() && count > 10_000, "{language}: {count} calls");
}

fn all_calls<F: Number>() -> Vec<Call<F>> {
    pieces().iter().flat_map(|piece| calls::<F>(piece)).collect()
}

fn c_gives_what_the_kernels_give<F: Number>() {
    let calls = all_calls::<F>();
    let cases: String = calls.iter().enumerate().map(|(i, call)| call.c_case(i)).collect();
    let (ty, bits, format) = F::C;
    let text = format!(
        "{}\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\
         static {ty} real(uint64_t bits) {{ {bits} b = ({bits})bits; {ty} x; memcpy(&x, &b, sizeof x); return x; }}\n\
         static uint64_t back({ty} x) {{ {bits} b; memcpy(&b, &x, sizeof b); return b; }}\n\
         int main(void) {{\n    unsigned i;\n    uint64_t b[6];\n    \
         while (scanf(\"%u %\" SCNx64 \" %\" SCNx64 \" %\" SCNx64 \" %\" SCNx64 \" %\" SCNx64 \" %\" SCNx64, &i, b, b + 1, \
         b + 2, b + 3, b + 4, b + 5) == 7) {{\n        {ty} x[6], y[4] = {{0, 0, 0, 0}};\n        \
         for (int k = 0; k < 6; k++) x[k] = real(b[k]);\n        switch (i) {{\n{cases}        default: return 1;\n        }}\n        \
         printf(\"%\" PRIx64 \" %\" PRIx64 \" %\" PRIx64 \" %\" PRIx64 \"\\n\", back(y[0]), back(y[1]), back(y[2]), back(y[3]));\n    \
         }}\n    return 0;\n}}\n",
        everything(Language::C, format)
    );
    let folder = folder(&format!("c-{}", format.id()));
    std::fs::write(folder.join("driver.c"), text).unwrap();
    // Neither contracted nor in wider registers: the kernels round every operation.
    let options =
        ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-ffp-contract=off", "driver.c"];
    run(Command::new("cc").current_dir(&folder).args(options).args(["-o", "driver", "-lm"]), "").unwrap();
    compare(&calls, &mut Command::new(folder.join("driver")), Language::C);
}

#[test]
fn c_compiles_without_a_warning_and_gives_what_the_kernels_give() {
    if !is_there("cc") {
        return skipped("no cc compiles the emitted C");
    }
    c_gives_what_the_kernels_give::<f32>();
    c_gives_what_the_kernels_give::<f64>();
}

fn rust_gives_what_the_kernels_give<F: Number>() {
    let calls = all_calls::<F>();
    let cases: String = calls.iter().enumerate().map(|(i, call)| call.rust_case(i)).collect();
    let (ty, bits, format) = F::RUST;
    let text = format!(
        "//! Driver.\n#![deny(warnings)]\n{}\nfn main() {{\n    use std::fmt::Write;\n    let mut out = String::new();\n    \
         for line in std::io::stdin().lines() {{\n        let line = line.unwrap();\n        \
         let mut words = line.split(' ');\n        let i: usize = words.next().unwrap().parse().unwrap();\n        \
         let x: Vec<{ty}> = words.map(|w| {ty}::from_bits({bits}::from_str_radix(w, 16).unwrap())).collect();\n        \
         let mut y: [{ty}; 4] = [0.0; 4];\n        match i {{\n{cases}            _ => std::process::exit(1),\n        }}\n        \
         let [a, b, c, d] = y.map({ty}::to_bits);\n        writeln!(out, \"{{a:x}} {{b:x}} {{c:x}} {{d:x}}\").unwrap();\n    }}\n    \
         print!(\"{{out}}\");\n}}\n",
        everything(Language::Rust, format)
    );
    let folder = folder(&format!("rust-{}", format.id()));
    std::fs::write(folder.join("driver.rs"), text).unwrap();
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    run(
        Command::new(rustc).current_dir(&folder).args([
            "--edition",
            "2024",
            "-O",
            "driver.rs",
            "-o",
            "driver",
        ]),
        "",
    )
    .unwrap();
    compare(&calls, &mut Command::new(folder.join("driver")), Language::Rust);
}

#[test]
fn rust_compiles_and_gives_what_the_kernels_give() {
    rust_gives_what_the_kernels_give::<f32>();
    rust_gives_what_the_kernels_give::<f64>();
}
