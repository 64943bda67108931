#![doc = include_str!("schema.md")]

/// This page, as Markdown.
pub const SCHEMA: &str = include_str!("schema.md");
