//! The page's style: one sheet, and the plots' colours in the dark.

use crate::report::chart::dark_colours;
use std::fmt::Write;

/// The sheet, with the plots' palette turned round where the reader asks for dark pages.
pub(super) fn style() -> String {
    let mut sheet = String::from(include_str!("style.css"));
    sheet.push_str("@media screen and (prefers-color-scheme: dark) {\n");
    for (light, dark) in dark_colours() {
        for property in ["fill", "stroke"] {
            // White text lies on cells, which only plots have that stay as they are; white areas are paper.
            let _ = writeln!(sheet, ".plot:not(.paper) [{property}=\"{light}\"] {{ {property}: {dark}; }}");
        }
    }
    sheet.push_str("}\n");
    sheet
}
