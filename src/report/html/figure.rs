//! Plots and pictures with their source lines.

use super::picture::{Picture, Pictures};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The figure at an address, its words, and its caption as HTML.
///
/// Where no picture is, its words stand alone: a measurement may be missing.
pub(super) fn figure(url: &str, alt: &str, caption: &str, pictures: &Pictures<'_>) -> String {
    let alt = escaped(alt);
    let (class, picture) = match pictures.find(url) {
        // Colours that lie under text say something: such a plot stays on white.
        Some(Picture::Drawing(drawing)) if drawing.has_cells() => ("plot paper", drawing.html(&alt)),
        Some(Picture::Drawing(drawing)) => ("plot", drawing.html(&alt)),
        Some(Picture::Png { bytes, width, height }) => {
            let data = STANDARD.encode(bytes);
            let src = format!("data:image/png;base64,{data}");
            ("picture", format!("<img src=\"{src}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\">"))
        }
        None => ("absent", format!("<p>{alt}</p>")),
    };
    let stem = url.rsplit('/').next().unwrap_or(url);
    let stem = stem.split_once('.').map_or(stem, |(stem, _)| stem);
    format!(
        "<figure class=\"{class}\" id=\"figure-{}\">\n<div class=\"scroll\" tabindex=\"0\" role=\"group\" \
         aria-label=\"Figure\">\n{picture}\n</div>\n<figcaption>{caption}</figcaption>\n</figure>\n",
        escaped(stem)
    )
}

/// Text as an attribute's value or between tags.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::measured::Measured;
    use std::collections::BTreeMap;

    #[test]
    fn words_stand_where_no_picture_is() {
        let pictures = Pictures { files: &BTreeMap::new(), measured: &Measured::default() };
        let html = figure("measured/a.png", "|a| < \"b\"", "", &pictures);
        assert!(html.contains("<p>|a| &lt; &quot;b&quot;</p>") && !html.contains("<img"), "{html}");
    }
}
