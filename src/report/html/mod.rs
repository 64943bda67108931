//! `reports/report.html`: one file, made from the very Markdown of `reports/report.md`.
//!
//! Everything is inside it: the style, plots as SVG that follow light and dark, pictures as base64. It has no
//! script and loads nothing; its links lead to the files of the checkout that it lies in.

mod block;
mod chip;
mod contents;
mod drawing;
mod figure;
mod number;
mod page;
mod picture;
mod style;

pub(super) use page::page;
pub(super) use picture::Pictures;
