//! The file that a command reads: from its path, or from standard input where that is `-`.

use super::reason;
use anyhow::{Result, anyhow, bail};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// How messages call it.
pub(super) fn name(path: &Path) -> String {
    if is_stdin(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// Its bytes, `longest` of them at most; `what` is how messages call what is read: "a claims file".
pub(super) fn bytes(path: &Path, what: &str, longest: u64) -> Result<Vec<u8>> {
    let name = name(path);
    let told = |error: std::io::Error| anyhow!("{name}: {}", reason(&error));
    let mut bytes = Vec::new();
    if is_stdin(path) {
        std::io::stdin().lock().take(longest + 1).read_to_end(&mut bytes).map_err(told)?;
    } else if path.is_dir() {
        bail!("{name}: a folder, not {what}");
    } else {
        File::open(path).and_then(|file| file.take(longest + 1).read_to_end(&mut bytes)).map_err(told)?;
    }
    if bytes.len() as u64 > longest {
        bail!("{name}: longer than {longest} bytes, the most of {what}");
    }
    Ok(bytes)
}

/// Its text.
pub(super) fn text(path: &Path, what: &str, longest: u64) -> Result<String> {
    String::from_utf8(bytes(path, what, longest)?).map_err(|_| anyhow!("{}: not UTF-8 text", name(path)))
}

fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == "-"
}
