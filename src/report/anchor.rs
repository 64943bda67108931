//! The names of headings in links, as GitHub makes them of Markdown.

use std::collections::BTreeMap;

/// Names given so far: a heading that stands twice gets a number behind its name.
#[derive(Debug, Default)]
pub(super) struct Anchors {
    given: BTreeMap<String, u32>,
}

impl Anchors {
    /// The next heading's name.
    pub(super) fn next(&mut self, heading: &str) -> String {
        let name = anchor(heading);
        let times = self.given.entry(name.clone()).or_insert(0);
        *times += 1;
        if *times == 1 { name } else { format!("{name}-{}", *times - 1) }
    }
}

/// A heading's name by itself: small letters, spaces as hyphens, other signs dropped.
pub(super) fn anchor(heading: &str) -> String {
    let letters = heading.trim().chars().filter_map(|c| match c {
        ' ' | '-' => Some('-'),
        '_' => Some('_'),
        c => c.is_alphanumeric().then_some(c),
    });
    letters.flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_github() {
        assert_eq!(anchor("Texture filters, seen"), "texture-filters-seen");
        assert_eq!(anchor("Is cr_n ≈ √(6/n)?"), "is-cr_n--6n");
        let mut anchors = Anchors::default();
        let names = ["L3", "Scene one", "L3", "l3"].map(|heading| anchors.next(heading));
        assert_eq!(names, ["l3", "scene-one", "l3-1", "l3-2"]);
    }
}
