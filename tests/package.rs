//! What the package says of itself is so.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use serde_json::Value;
use std::path::Path;
use std::process::Command;

fn read(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

/// Major and minor of "1.89" or "1.89.0".
fn version(text: &str) -> (u32, u32) {
    let mut parts = text.split('.').map(|part| part.parse().unwrap());
    (parts.next().unwrap(), parts.next().unwrap())
}

/// Everything that is compiled for this crate's users, by cargo's own account.
fn packages() -> Vec<Value> {
    let cargo = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked", "--offline"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo starts");
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let metadata: Value = serde_json::from_slice(&cargo.stdout).unwrap();
    metadata["packages"].as_array().unwrap().clone()
}

/// The stated Rust is as new as a dependency needs, and no newer than the README says. That the crate's
/// own code needs no newer one is clippy's to find (`incompatible_msrv`).
#[test]
fn the_minimum_rust_version_is_that_of_the_most_demanding_dependency() {
    let stated = version(env!("CARGO_PKG_RUST_VERSION"));
    let needed = packages()
        .iter()
        .filter(|package| package["name"] != "bellfit")
        .filter_map(|package| Some((version(package["rust_version"].as_str()?), package["name"].to_string())))
        .max()
        .unwrap();
    assert_eq!(stated, needed.0, "{} asks for it", needed.1);
    let words = format!("Rust {}.{} or newer", stated.0, stated.1);
    for file in ["README.md", "src/lib.rs"] {
        assert!(read(file).contains(&words), "{file} does not say \"{words}\"");
    }
}

#[test]
fn the_citation_is_of_this_version() {
    let citation = read("CITATION.cff");
    let line = format!("version: {}", env!("CARGO_PKG_VERSION"));
    assert_eq!(citation.lines().filter(|l| *l == line).count(), 1);
    for licence in env!("CARGO_PKG_LICENSE").split(" OR ") {
        assert!(citation.contains(&format!("  - {licence}\n")), "{licence}");
    }
}

/// Every feature is told on the front page and in the README.
#[test]
fn features_are_documented() {
    let packages = packages();
    let this = packages.iter().find(|package| package["name"] == "bellfit").unwrap();
    for feature in this["features"].as_object().unwrap().keys().filter(|name| *name != "default") {
        for file in ["README.md", "src/lib.rs"] {
            assert!(read(file).contains(&format!("`{feature}`")), "{file} does not tell of {feature}");
        }
    }
}

/// What is named in backquotes or links of the contributor's guide stands where it says.
#[test]
fn the_guide_names_files_that_are_there() {
    let guide = read("CONTRIBUTING.md");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut named, mut bare) = (0, 0);
    // A bare name stands in the folder of the path before it, or in the root.
    let mut folder = root.to_path_buf();
    for word in guide.split(['`', '(', ')', '\'']) {
        let is_word = !word.contains([' ', '\n', '*']);
        if is_word && word.contains('/') {
            let path = root.join(word);
            assert!(path.exists(), "{word}");
            folder = if path.is_dir() { path } else { path.parent().unwrap().to_path_buf() };
            named += 1;
        } else if is_word && [".rs", ".py", ".toml"].iter().any(|end| word.ends_with(end)) {
            let there = folder.join(word).exists() || root.join(word).exists();
            assert!(there, "{word} in {}", folder.display());
            bare += 1;
        }
    }
    assert!(named > 30 && bare > 10, "{named} paths, {bare} names");
}
