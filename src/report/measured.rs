//! What was measured on one machine, as data for the report: read, never measured again, and free to be
//! missing or broken.

use std::collections::BTreeMap;
use std::path::Path;

/// Where measurements lie below the root folder.
pub(super) const FOLDER: &str = "reports/measured";

/// The files of reports/measured/ by name.
///
/// ```
/// use bellfit::report::Measured;
/// // A folder that is not there holds nothing, which is no error.
/// assert_eq!(Measured::read("no such folder".as_ref()), Measured::default());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Measured {
    files: BTreeMap<String, Vec<u8>>,
}

impl Measured {
    /// What lies under `root` in reports/measured; what cannot be read is not there.
    pub fn read(root: &Path) -> Self {
        let Ok(entries) = std::fs::read_dir(root.join(FOLDER)) else { return Measured::default() };
        let readable = entries.filter_map(|entry| {
            let path = entry.ok()?.path();
            let name = path.file_name()?.to_str()?.to_owned();
            // What is written beside its place, and hidden files, are no measurements.
            let is_one = !name.starts_with('.') && !name.ends_with(".tmp") && path.is_file();
            if is_one { Some((name, std::fs::read(&path).ok()?)) } else { None }
        });
        Measured { files: readable.collect() }
    }

    /// The same from files by name.
    pub fn from_files(files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Self {
        Measured { files: files.into_iter().collect() }
    }

    /// The files' names, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// A file that is text.
    pub(super) fn text(&self, name: &str) -> Option<&str> {
        std::str::from_utf8(self.files.get(name)?).ok()
    }

    /// A file's bytes.
    pub(super) fn bytes(&self, name: &str) -> Option<&[u8]> {
        self.files.get(name).map(Vec::as_slice)
    }
}
