//! WGSL validated by naga, and its translations with our comments put back.

use super::function::Program;
use super::language::Target;
use super::spelling::{self, comment};
use super::{Language, ShaderError};
use crate::bound::Format;
use naga::back::{glsl, hlsl, msl};
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::collections::BTreeSet;

/// naga writes nothing without an entry point; it is taken out again.
const ENTRY: &str = "\n@compute @workgroup_size(1)\nfn entry_point() {\n}\n";

/// WGSL as it is spelt, or its translation.
pub(super) fn text(program: &Program, target: Target) -> Result<String, ShaderError> {
    let language = target.language;
    let failure = |message: String| ShaderError::Translation { language, message };
    let wgsl = spelling::text(program, target);
    let module = naga::front::wgsl::parse_str(&format!("{wgsl}{ENTRY}"))
        .map_err(|error| failure(error.emit_to_string(&wgsl)))?;
    let capabilities = match target.format {
        Format::Half => Capabilities::SHADER_FLOAT16,
        Format::Double => Capabilities::FLOAT64,
        _ => Capabilities::empty(),
    };
    let info = Validator::new(ValidationFlags::all(), capabilities)
        .validate(&module)
        .map_err(|error| failure(error.emit_to_string(&wgsl)))?;
    let translated = match language {
        Language::Glsl => to_glsl(&module, &info).map_err(failure)?,
        Language::Hlsl => to_hlsl(&module, &info).map_err(failure)?,
        Language::Msl => to_msl(&module, &info).map_err(failure)?,
        _ => return Ok(wgsl),
    };
    Ok(with_comments(&translated, program, language))
}

fn to_glsl(module: &naga::Module, info: &ModuleInfo) -> Result<String, String> {
    let options = glsl::Options {
        version: glsl::Version::Desktop(450),
        writer_flags: glsl::WriterFlags::empty(),
        ..glsl::Options::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Compute,
        entry_point: "entry_point".to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    glsl::Writer::new(&mut text, module, info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn to_hlsl(module: &naga::Module, info: &ModuleInfo) -> Result<String, String> {
    let options = hlsl::Options {
        shader_model: hlsl::ShaderModel::V6_0,
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(module, info, None)
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn to_msl(module: &naga::Module, info: &ModuleInfo) -> Result<String, String> {
    let options =
        msl::Options { lang_version: (2, 0), force_loop_bounding: false, ..msl::Options::default() };
    let pipeline = msl::PipelineOptions::default();
    msl::write_string(module, info, &options, &pipeline).map(|(text, _)| text).map_err(|e| e.to_string())
}

/// The structures and functions of naga's text, each of ours with its comment above; its directives but
/// Metal's, and the entry point, left out.
fn with_comments(translated: &str, program: &Program, language: Language) -> String {
    let (mut text, mut block) = (String::new(), String::new());
    for line in translated.lines() {
        let is_kept =
            language == Language::Msl && (line.starts_with("#include") || line.starts_with("using "));
        if block.is_empty() {
            if is_kept {
                text.push_str(line);
                text.push('\n');
                continue;
            }
            let is_code = line.contains('{') || line.contains('(') || line.contains("struct ");
            if line.starts_with(['#', '/', '[', '}']) || line.starts_with("layout") || !is_code {
                continue;
            }
        }
        block.push_str(line);
        block.push('\n');
        if line.starts_with('}') {
            add(&block, program, language, &mut text);
            block.clear();
        }
    }
    text
}

fn add(block: &str, program: &Program, language: Language, text: &mut String) {
    if block.contains("entry_point") || block.contains("void main()") {
        return;
    }
    if !text.is_empty() {
        text.push('\n');
    }
    let first = block.lines().next().unwrap_or_default();
    let head = first.split('(').next().unwrap_or_default();
    let name = head.trim_end_matches(" {").rsplit(' ').next().unwrap_or_default();
    if let Some(item) = program.items().iter().find(|item| item.name() == name) {
        text.push_str(&comment(item, language));
    }
    text.push_str(&plain_names(block));
}

/// naga numbers a name that another function has as well: `uu_1` is `uu` again where its block has no other.
fn plain_names(block: &str) -> String {
    let words: BTreeSet<&str> = block.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
    let is_alone = |word: &str, base: &str| {
        let others = words.iter().filter(|other| **other != word);
        !words.contains(base) && others.filter_map(|other| unnumbered(other)).all(|other| other != base)
    };
    let mut text = String::new();
    let mut rest = block;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let end =
            if is_word(first) { rest.find(|c| !is_word(c)).unwrap_or(rest.len()) } else { first.len_utf8() };
        let (word, after) = rest.split_at(end);
        match unnumbered(word) {
            Some(base) if is_alone(word, base) => text.push_str(base),
            _ => text.push_str(word),
        }
        rest = after;
    }
    text
}

/// The name before a number that naga gave it.
fn unnumbered(word: &str) -> Option<&str> {
    let (base, number) = word.rsplit_once('_')?;
    let is_numbered = !base.is_empty() && !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
    is_numbered.then_some(base)
}
