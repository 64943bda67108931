//! The public functions and methods of src/kernel with their documentation, read from the sources.

use std::path::{Path, PathBuf};

pub struct Kernel {
    /// Below src/kernel.
    pub file: String,
    /// `function` or `Type::method`.
    pub name: String,
    doc: Vec<String>,
}

impl Kernel {
    /// What its page lacks, if anything: a formula in the text, an example that calls it and asserts.
    pub fn undocumented(&self) -> Option<&'static str> {
        let mut is_code = false;
        let (mut text, mut examples): (Vec<&str>, Vec<String>) = (vec![], vec![]);
        for line in &self.doc {
            if line.trim_start().starts_with("```") {
                is_code = !is_code;
                if is_code {
                    examples.push(line.clone());
                }
            } else if is_code {
                examples.last_mut().expect("a block is open").push_str(line);
            } else {
                text.push(line);
            }
        }
        let is_formula =
            |line: &&str| line.contains('=') || line.chars().any(|c| "√∫Σ±·²³ⁿᴷ½∛²⁻".contains(c));
        if !text.iter().any(is_formula) {
            return Some("states no formula");
        }
        let function = self.name.rsplit("::").next().expect("a name");
        let calls = |code: &str| {
            code.match_indices(function).any(|(i, _)| {
                let starts = !code[..i].ends_with(|c: char| c.is_alphanumeric() || c == '_');
                let rest = &code[i + function.len()..];
                starts && (rest.starts_with('(') || rest.starts_with("::<"))
            })
        };
        let evaluates =
            |code: &String| !code.contains("compile_fail") && code.contains("assert") && calls(code);
        if !examples.iter().any(evaluates) {
            return Some("has no example that evaluates it");
        }
        None
    }
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

pub fn kernels() -> Vec<Kernel> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/kernel");
    let mut paths = Vec::new();
    files(&root, &mut paths);
    paths.sort();
    let read = |path: &PathBuf| {
        let file = path.strip_prefix(&root).unwrap().to_str().unwrap().replace('\\', "/");
        // Real is the arithmetic that kernels are written in, not one of them: its methods are a trait's.
        of_file(&file, &std::fs::read_to_string(path).unwrap())
    };
    paths.iter().flat_map(read).collect()
}

/// The type that `impl<…> Type<…> {` or `impl Trait for Type {` is of.
fn type_of(line: &str) -> String {
    let mut rest = line.trim_start_matches("impl");
    if rest.starts_with('<') {
        let mut depth = 0;
        let end = rest.find(|c: char| {
            depth += i32::from(c == '<') - i32::from(c == '>');
            depth == 0
        });
        rest = &rest[end.map_or(0, |end| end + 1)..];
    }
    let rest = rest.rsplit(" for ").next().unwrap_or(rest).trim();
    rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

pub fn of_file(file: &str, source: &str) -> Vec<Kernel> {
    let code = source.split("#[cfg(test)]\nmod tests").next().expect("a part");
    let (mut found, mut doc, mut of): (Vec<Kernel>, Vec<String>, Option<String>) = (vec![], vec![], None);
    for line in code.lines() {
        let trimmed = line.trim_start();
        if let Some(text) = trimmed.strip_prefix("///") {
            doc.push(text.to_owned());
            continue;
        }
        if line.starts_with("impl") {
            of = Some(type_of(line));
        } else if line.starts_with('}') {
            of = None;
        } else if trimmed.starts_with("#[") {
            continue;
        }
        let function = trimmed.strip_prefix("pub fn ").or_else(|| trimmed.strip_prefix("pub const fn "));
        if let Some(rest) = function {
            let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let name = of.as_ref().map_or(name.clone(), |of| format!("{of}::{name}"));
            found.push(Kernel { file: file.to_owned(), name, doc: std::mem::take(&mut doc) });
        }
        doc.clear();
    }
    found
}
