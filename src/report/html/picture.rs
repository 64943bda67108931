//! Where the page's images come from.

use super::drawing::Drawing;
use crate::report::measured::Measured;
use std::collections::BTreeMap;

/// An image to stand in the page.
#[derive(Debug, PartialEq)]
pub(super) enum Picture<'a> {
    /// A plot.
    Drawing(Drawing<'a>),
    /// A PNG with its width and height in pixels.
    Png { bytes: &'a [u8], width: u32, height: u32 },
}

/// The files that hold the images.
#[derive(Clone, Copy, Debug)]
pub(in crate::report) struct Pictures<'a> {
    /// Generated files by their path in the repository.
    pub(in crate::report) files: &'a BTreeMap<String, Vec<u8>>,
    /// What was measured.
    pub(in crate::report) measured: &'a Measured,
}

impl<'a> Pictures<'a> {
    /// The image at an address relative to reports/: as SVG where the same plot is there as such.
    pub(super) fn find(&self, url: &str) -> Option<Picture<'a>> {
        let drawn = url.strip_suffix(".png").and_then(|stem| self.bytes(&format!("{stem}.svg")));
        let drawing = drawn.and_then(|bytes| Drawing::new(std::str::from_utf8(bytes).ok()?));
        drawing.map(Picture::Drawing).or_else(|| png(self.bytes(url)?))
    }

    fn bytes(&self, url: &str) -> Option<&'a [u8]> {
        match url.strip_prefix("measured/") {
            Some(name) => self.measured.bytes(name),
            None => self.files.get(&format!("reports/{url}")).map(Vec::as_slice),
        }
    }
}

/// A PNG, by its signature and its header's first two numbers.
fn png(bytes: &[u8]) -> Option<Picture<'_>> {
    bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let number = |at: usize| Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    Some(Picture::Png { bytes, width: number(16)?, height: number(20)? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_measured_plot_gives_way_to_its_png_or_nothing() {
        let mut header = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x01\x02\0\0\0\x10".to_vec();
        let png = header.clone();
        let named = |name: &str, bytes: &[u8]| (name.to_owned(), bytes.to_vec());
        let measured = Measured::from_files([
            named("a.svg", b"<svg viewBox=\"0 0 1 1\"><g>"),
            named("a.png", &png),
            named("b.svg", b"\xff"),
        ]);
        let files =
            BTreeMap::from([("reports/plots/c.svg".to_owned(), b"<svg><title>t</title></svg>".to_vec())]);
        let pictures = Pictures { files: &files, measured: &measured };
        assert_eq!(
            pictures.find("measured/a.png"),
            Some(Picture::Png { bytes: &png, width: 258, height: 16 })
        );
        assert_eq!(pictures.find("measured/b.png"), None);
        assert!(matches!(pictures.find("plots/c.png"), Some(Picture::Drawing(_))));
        header.truncate(18);
        assert_eq!(super::png(&header), None);
    }
}
