//! An SVG that may stand in the page: one of ours by its tags, whole, and with nothing that runs or loads.

/// The tags that our plots have.
const TAGS: [&str; 8] = ["svg", "title", "rect", "polyline", "polygon", "circle", "text", "image"];

/// A plot's SVG, checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Drawing<'a> {
    svg: &'a str,
}

impl<'a> Drawing<'a> {
    /// The SVG if every tag in it is known, closed in its turn and free of handlers, names and addresses but
    /// those of pictures within; none else.
    pub(super) fn new(svg: &'a str) -> Option<Self> {
        let svg = svg.trim();
        if !svg.starts_with("<svg ") && !svg.starts_with("<svg>") {
            return None;
        }
        let (mut open, mut rest): (Vec<&str>, &str) = (Vec::new(), svg);
        while let Some(start) = rest.find('<') {
            let (before, tag) = rest.split_at(start);
            // Text beside the outermost element would be text of the page.
            if open.is_empty() && !before.is_empty() {
                return None;
            }
            let end = tag.find('>')?;
            let (inside, after) = (&tag[1..end], &tag[end + 1..]);
            rest = after;
            if let Some(name) = inside.strip_prefix('/') {
                if open.pop() != Some(name) || (open.is_empty() && !rest.is_empty()) {
                    return None;
                }
                continue;
            }
            let (inside, is_empty) =
                inside.strip_suffix('/').map_or((inside, false), |inside| (inside, true));
            let (name, attributes) = inside.split_once(' ').unwrap_or((inside, ""));
            if !TAGS.contains(&name) || !are_harmless(attributes) || (name == "svg") != open.is_empty() {
                return None;
            }
            if !is_empty {
                open.push(name);
            }
        }
        (open.is_empty() && rest.is_empty()).then_some(Drawing { svg })
    }

    /// Whether cells or pictures lie under its text, so that its colours must stay as they are.
    pub(super) fn has_cells(self) -> bool {
        self.svg.contains("<image ")
    }

    /// The element, named for those who do not see it; the text already escaped.
    pub(super) fn html(self, label: &str) -> String {
        format!("<svg aria-label=\"{label}\"{}", self.svg.strip_prefix("<svg").unwrap_or_default())
    }
}

/// `name="value"` after each other, none of which runs, loads or names something.
fn are_harmless(attributes: &str) -> bool {
    let mut rest = attributes.trim();
    while !rest.is_empty() {
        let Some((name, after)) = rest.split_once("=\"") else { return false };
        let Some((value, after)) = after.split_once('"') else { return false };
        let is_name = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
        let is_own = match name {
            "href" => value.starts_with("data:image/png;base64,"),
            "style" => value == "image-rendering:pixelated",
            "id" | "class" | "aria-label" => false,
            _ => !name.starts_with("on") && !value.contains("url("),
        };
        if !is_name || !is_own || value.contains('<') {
            return false;
        }
        rest = after.trim_start();
    }
    true
}

#[cfg(test)]
mod tests {
    use super::Drawing;

    #[test]
    fn ours_are_taken_and_others_not() {
        let ours = "<svg viewBox=\"0 0 1 1\">\n<title>a &lt; b</title>\n<rect x=\"1\"/><image href=\"data:image/png;base64,AA==\"/>\n</svg>\n";
        let drawing = Drawing::new(ours).unwrap();
        assert!(drawing.has_cells());
        assert!(drawing.html("words").starts_with("<svg aria-label=\"words\" viewBox="));
        for broken in [
            "",
            "<p></p>",
            "<svg",
            "<svg><title></svg>",
            "<svg></svg><svg></svg>",
            "<svg></svg>words",
            "<svg><script>x</script></svg>",
            "<svg onload=\"x()\"></svg>",
            "<svg><rect id=\"a\"/></svg>",
            "<svg><image href=\"http://x\"/></svg>",
            "<svg><rect fill=\"url(http://x)\"/></svg>",
            "<svg><rect fill=red/></svg>",
            "<svg><rect",
            "<svg><svg></svg></svg>",
        ] {
            assert_eq!(Drawing::new(broken), None, "{broken}");
        }
    }
}
