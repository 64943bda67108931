//! The report that people read: the same in both forms, with no link that leads nowhere, no table without
//! its source, nothing loaded or run, and as it should look in a browser.
//!
//! The files are the committed ones; tests/cli.rs holds that they are what is generated.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

mod support {
    pub mod browser;
    pub mod html;
}

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use support::browser::{browser, show};
use support::html::{Token, elements, texts, tokens};

fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

fn read(name: &str) -> String {
    std::fs::read_to_string(reports().join(name)).unwrap()
}

fn events(markdown: &str) -> Vec<Event<'_>> {
    Parser::new_ext(markdown, Options::ENABLE_TABLES).collect()
}

/// The texts between the tags of every element that a test picks, in order.
fn between(markdown: &str, picks: impl Fn(&Tag<'_>) -> bool) -> Vec<String> {
    let (mut found, mut open, mut depth): (Vec<String>, bool, usize) = (Vec::new(), false, 0);
    for event in events(markdown) {
        match event {
            Event::Start(tag) if !open && picks(&tag) => {
                found.push(String::new());
                (open, depth) = (true, 0);
            }
            Event::Start(_) if open => depth += 1,
            Event::End(_) if open && depth == 0 => open = false,
            Event::End(_) if open => depth -= 1,
            Event::Text(text) | Event::Code(text) if open => found.last_mut().unwrap().push_str(&text),
            Event::SoftBreak if open => found.last_mut().unwrap().push('\n'),
            _ => {}
        }
    }
    found
}

/// GitHub's names of a page's headings: small letters, hyphens for spaces, no other signs, a number behind
/// the second of a name.
fn anchors(headings: &[String]) -> Vec<String> {
    let mut times: BTreeMap<String, usize> = BTreeMap::new();
    let name = |heading: &String| {
        let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        let name = kept.collect::<String>().to_lowercase().replace(' ', "-");
        let before = times.entry(name.clone()).or_default();
        *before += 1;
        if *before == 1 { name } else { format!("{name}-{}", *before - 1) }
    };
    headings.iter().map(name).collect()
}

fn is_heading(tag: &Tag<'_>) -> bool {
    matches!(tag, Tag::Heading { .. })
}

/// Where a page's links lead that lead nowhere: to a file that is not there or a name that no heading has.
fn dead_links<'a>(links: impl IntoIterator<Item = &'a str>, names: &BTreeSet<String>) -> Vec<String> {
    let is_dead = |link: &&str| match link.strip_prefix('#') {
        Some(name) => !names.contains(name),
        None => link.contains(':') || link.starts_with('/') || !reports().join(link).exists(),
    };
    links.into_iter().filter(is_dead).map(str::to_owned).collect()
}

fn links(markdown: &str) -> Vec<String> {
    let link = |event: Event<'_>| match event {
        Event::Start(Tag::Link { dest_url, .. }) => Some(dest_url.into_string()),
        _ => None,
    };
    events(markdown).into_iter().filter_map(link).collect()
}

/// The tables and images after which no source line stands, by the line before.
fn without_source(markdown: &str) -> Vec<String> {
    let events = events(markdown);
    let mut found = Vec::new();
    for (i, event) in events.iter().enumerate() {
        let next = match event {
            Event::End(TagEnd::Table) => i + 1,
            // The image ends, then its paragraph.
            Event::End(TagEnd::Image) => i + 2,
            _ => continue,
        };
        let is_source = matches!(
            events.get(next..next + 3),
            Some([Event::Start(Tag::Paragraph), Event::Start(Tag::Emphasis), Event::Text(word)])
                if word.as_ref() == "Source:"
        );
        let line: Vec<&Event<'_>> = events[next.min(events.len())..]
            .iter()
            .take_while(|e| **e != Event::End(TagEnd::Paragraph))
            .collect();
        let has_file = line.iter().any(|e| matches!(e, Event::Start(Tag::Link { .. })));
        let has_command = line.iter().any(|e| matches!(e, Event::Code(code) if code.starts_with("bellfit")));
        if !(is_source && has_file && has_command) {
            let before: Vec<String> =
                events[i.saturating_sub(4)..i].iter().map(|e| format!("{e:?}")).collect();
            found.push(before.join(" "));
        }
    }
    found
}

#[test]
fn every_link_leads_somewhere() {
    let markdown = read("report.md");
    let headings = between(&markdown, is_heading);
    let names: BTreeSet<String> = anchors(&headings).into_iter().collect();
    let all = links(&markdown);
    assert!(all.len() > 300, "{} links", all.len());
    assert_eq!(dead_links(all.iter().map(String::as_str), &names), Vec::<String>::new());
    let page = tokens(&read("report.html")).unwrap();
    let ids = page.iter().filter_map(|token| match token {
        Token::Open { attributes, .. } => attributes.get("id").cloned(),
        _ => None,
    });
    let ids: Vec<String> = ids.collect();
    let unique: BTreeSet<String> = ids.iter().cloned().collect();
    assert_eq!(ids.len(), unique.len(), "a name twice");
    assert!(names.is_subset(&unique), "{:?}", names.difference(&unique));
    let hrefs = || elements(&page, "a").map(|a| a["href"].as_str());
    assert_eq!(dead_links(hrefs(), &unique), Vec::<String>::new());
    // The page's own links, without those of its two lists of contents.
    let own: Vec<&str> = hrefs().skip(hrefs().count() - all.len()).collect();
    assert_eq!(own, all);
    // What the README leads to in the report is there as well.
    let readme = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).unwrap();
    let led: Vec<String> = links(&readme)
        .into_iter()
        .filter_map(|link| Some(format!("#{}", link.strip_prefix("reports/report.md#")?)))
        .collect();
    assert!(!led.is_empty());
    assert_eq!(dead_links(led.iter().map(String::as_str), &names), Vec::<String>::new());
    let planted = ["#no-such", "../fits/none.csv", "https://example.org", "/etc", "../fits/clip.csv"];
    assert_eq!(dead_links(planted, &unique), planted[..4]);
}

#[test]
fn every_table_and_figure_names_its_source() {
    let markdown = read("report.md");
    assert_eq!(without_source(&markdown), Vec::<String>::new());
    let good = "\n*Source:* [f](f); remade by `bellfit`.\n";
    for (planted, count) in [
        (format!("| a |\n|---|\n| 1 |\n{good}"), 0),
        (format!("| a |\n|---|\n| 1 |\n\nWords.\n{good}"), 1),
        (format!("![a](b.png)\n\n![a](b.png)\n{good}"), 1),
        ("| a |\n|---|\n| 1 |\n\n*Source:* somewhere.\n".to_owned(), 1),
        ("| a |\n|---|\n| 1 |\n".to_owned(), 1),
    ] {
        assert_eq!(without_source(&planted).len(), count, "{planted}");
    }
}

#[test]
fn both_forms_say_the_same() {
    let markdown = read("report.md");
    let page = tokens(&read("report.html")).unwrap();
    let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let same = |what: &str, from_markdown: Vec<String>, names: &[&str]| {
        let from_html: Vec<String> = texts(&page, names).iter().map(|(_, text)| squeezed(text)).collect();
        let from_markdown: Vec<String> = from_markdown.iter().map(|text| squeezed(text)).collect();
        assert!(from_markdown.len() > 30, "{what}: {}", from_markdown.len());
        let first = from_markdown.iter().zip(&from_html).position(|(a, b)| a != b);
        let at = first.map(|i| (&from_markdown[i], &from_html[i]));
        assert_eq!(at, None, "{what}");
        assert_eq!(from_markdown.len(), from_html.len(), "{what}");
    };
    same("headings", between(&markdown, is_heading), &["h1", "h2", "h3", "h4", "h5", "h6"]);
    same("cells", between(&markdown, |tag| matches!(tag, Tag::TableCell)), &["th", "td"]);
    same("quotations", between(&markdown, |tag| matches!(tag, Tag::BlockQuote(_))), &["blockquote"]);
    // Every sentence of paragraphs and lists; between an item and the items below it HTML breaks the line.
    let tight = |text: &str| text.split_whitespace().collect::<String>();
    let shown = page.iter().filter_map(|token| match token {
        Token::Text(text) => Some(tight(text)),
        _ => None,
    });
    let shown: String = shown.collect();
    let all = between(&markdown, |tag| matches!(tag, Tag::Paragraph | Tag::Item));
    // An image's words are an attribute.
    let alts = between(&markdown, |tag| matches!(tag, Tag::Image { .. }));
    let missing: Vec<&String> =
        all.iter().filter(|text| !shown.contains(&tight(text)) && !alts.contains(text)).collect();
    assert_eq!(missing, Vec::<&String>::new());
}

#[test]
fn every_picture_is_in_the_page_and_nothing_is_loaded_or_run() {
    let (markdown, html) = (read("report.md"), read("report.html"));
    assert!(html.len() < 4_000_000, "{} bytes", html.len());
    let page = tokens(&html).unwrap();
    let wanted = events(&markdown).iter().filter(|e| matches!(e, Event::Start(Tag::Image { .. }))).count();
    let (drawn, pictures) = (elements(&page, "svg").count(), elements(&page, "img").count());
    assert_eq!((drawn + pictures, elements(&page, "figure").count()), (wanted, wanted));
    assert!(elements(&page, "figure").all(|figure| figure["class"] != "absent"));
    for svg in elements(&page, "svg") {
        assert!(svg["aria-label"].len() > 10 && svg["role"] == "img", "{svg:?}");
    }
    for img in elements(&page, "img") {
        assert!(img["src"].starts_with("data:image/png;base64,") && img["alt"].len() > 10);
        assert!(img["width"].parse::<u32>().unwrap() > 100 && img["height"].parse::<u32>().unwrap() > 100);
    }
    for token in &page {
        let Token::Open { name, attributes, .. } = token else { continue };
        assert!(
            !["script", "iframe", "object", "embed", "link", "base", "form"].contains(&name.as_str()),
            "{name}"
        );
        for (key, value) in attributes {
            assert!(!key.starts_with("on"), "{name} {key}");
            let is_plain =
                key == "xmlns" || !value.contains("//") || value.starts_with("data:image/png;base64,");
            assert!(is_plain, "{name} {key}={value}");
        }
    }
    let style = &texts(&page, &["style"])[0].1;
    assert!(!style.contains("url(") && !style.contains("@import"), "the style loads something");
    for media in ["prefers-color-scheme: dark", "@media print", "color-scheme: light dark"] {
        assert!(style.contains(media), "{media}");
    }
    // A plot stands once, whichever claim or section shows it.
    for entry in std::fs::read_dir(reports().join("plots")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".png") {
            assert_eq!(markdown.matches(&format!("](plots/{name})\n")).count(), 1, "{name}");
        }
    }
}

#[test]
fn a_page_that_is_not_well_formed_is_seen() {
    let page = |body: &str| format!("<!DOCTYPE html>\n<html><body>{body}</body></html>");
    assert!(tokens(&page("<p id=\"a\">1 &lt; 2<br></p>")).is_ok());
    for broken in [
        "<p>",
        "<p></b>",
        "<p><b></p></b>",
        "<p class=a></p>",
        "a & b",
        "a > b",
        "&nope;",
        "<p a=\"1\" a=\"2\"></p>",
    ] {
        assert!(tokens(&page(broken)).is_err(), "{broken}");
    }
}

#[test]
fn the_index_holds_every_file_with_words() {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { walk(&path, found) } else { found.push(path) }
        }
    }
    let markdown = read("report.md");
    let (_, index) = markdown.split_once("\n## How to remake everything\n").unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    ["fits", "reports"].iter().for_each(|folder| walk(&root.join(folder), &mut paths));
    assert!(paths.len() > 90, "{}", paths.len());
    for path in paths {
        let name = path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
        let start = format!("- [{name}](");
        let line = index.lines().find(|line| line.starts_with(&start));
        let line = line.unwrap_or_else(|| panic!("{name} is not in the index"));
        let words = line.split_once("): ").unwrap().1;
        assert!(words.len() > 25 && !words.starts_with('('), "{line}");
        assert!(words.ends_with("`)") && words.contains("(`bellfit"), "{line}");
    }
}

fn skipped(what: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {what}");
}

#[test]
fn the_page_shows_whole_and_silent_in_chromium() {
    let Some(program) = browser() else {
        let required = std::env::var_os("REQUIRE_CHROMIUM").is_some_and(|value| value == "1");
        assert!(!required, "no chromium, and REQUIRE_CHROMIUM=1");
        return skipped("no chromium shows reports/report.html");
    };
    let folder = |name: &str| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("report-{name}"));
    let page = read("report.html");
    let images = page.matches("<img ").count();
    // A laptop and a phone.
    for width in [1280_u32, 390] {
        for dark in [false, true] {
            let name = format!("{width}-{dark}");
            let shown = show(program, &folder(&name), &page, width, dark);
            assert_eq!(shown.console, Vec::<String>::new(), "{name}");
            let found = &shown.report;
            assert_eq!((&found["width"], &found["dark"]), (&width.into(), &dark.into()), "{name}: {found}");
            assert_eq!((&found["images"], &found["broken"]), (&images.into(), &0.into()), "{name}: {found}");
            assert_eq!(found["wide"], 0, "{name} scrolls sideways: {found}");
            // The plots' ground is the page's in the dark, and white in the light.
            let ground = if dark { "rgb(21, 24, 28)" } else { "rgb(255, 255, 255)" };
            assert_eq!(
                (&found["paper"], &found["plot"]),
                (&ground.into(), &ground.into()),
                "{name}: {found}"
            );
            let (beside, folded) = if width > 1000 { ("block", "none") } else { ("none", "block") };
            assert_eq!(
                (&found["beside"], &found["folded"]),
                (&beside.into(), &folded.into()),
                "{name}: {found}"
            );
        }
    }
    // What is planted is seen: a missing image, a page too wide, a word on the console.
    let planted = "<img src=\"none.png\" alt=\"none\"><div style=\"width:3000px\">wide</div>\
        <script>console.error('planted')</script></main>";
    let broken = page.replacen("</main>", planted, 1);
    let shown = show(program, &folder("planted"), &broken, 390, false);
    assert_eq!((&shown.report["images"], &shown.report["broken"]), (&(images + 1).into(), &1.into()));
    assert!(shown.report["wide"].as_f64().unwrap() > 100.0, "{}", shown.report);
    assert!(shown.console.iter().any(|line| line.contains("planted")), "{:?}", shown.console);
}
