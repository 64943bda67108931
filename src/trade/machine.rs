//! What a measurement was made on.

use crate::slice::Unit;
use serde::{Deserialize, Serialize};

/// The machine as far as it bears on times; nothing that tells whose it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// The processor's name, [`processor`].
    pub processor: String,
    /// The architecture that the program was compiled for.
    pub architecture: String,
    /// The operating system that the program was compiled for.
    pub system: String,
    /// The vector unit that slices ran on: [`Unit::id`].
    pub unit: String,
    /// Bytes of the last-level cache, where the system tells them.
    pub cache: Option<usize>,
}

impl Machine {
    /// This one.
    ///
    /// ```
    /// let machine = bellfit::trade::Machine::this();
    /// assert_eq!(machine.architecture, std::env::consts::ARCH);
    /// ```
    pub fn this() -> Machine {
        Machine {
            processor: processor(),
            architecture: std::env::consts::ARCH.to_owned(),
            system: std::env::consts::OS.to_owned(),
            unit: Unit::best().id().to_owned(),
            cache: last_cache(),
        }
    }
}

/// The processor's name, where the system tells it; else the architecture.
///
/// ```
/// assert!(!bellfit::trade::processor().is_empty());
/// ```
pub fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    model.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

/// A machine's name as part of a file's: its words of letters and digits, small, with hyphens between.
///
/// ```
/// assert_eq!(bellfit::trade::file_name("Some(R) CPU @ 2.70GHz"), "some-r-cpu-2-70ghz");
/// ```
pub fn file_name(machine: &str) -> String {
    let words = machine.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

/// The largest cache that Linux tells of for the first core.
fn last_cache() -> Option<usize> {
    let folders = std::fs::read_dir("/sys/devices/system/cpu/cpu0/cache").ok()?;
    let size = |folder: std::io::Result<std::fs::DirEntry>| {
        let text = std::fs::read_to_string(folder.ok()?.path().join("size")).ok()?;
        let kibibytes: usize = text.trim().strip_suffix('K')?.parse().ok()?;
        kibibytes.checked_mul(1024)
    };
    folders.filter_map(size).max()
}
