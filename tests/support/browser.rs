//! Debian's Chromium without a window: what a page says of itself when it is shown.

use std::path::Path;
use std::process::{Command, Stdio};

/// The browser's program, if there is one.
pub fn browser() -> Option<&'static str> {
    let starts = |name: &&str| {
        let mut command = Command::new(name);
        command.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    ["chromium", "chromium-browser"].into_iter().find(starts)
}

/// What came of showing a page.
pub struct Shown {
    /// What the page reported.
    pub report: serde_json::Value,
    /// The lines that it wrote on the console.
    pub console: Vec<String>,
}

/// What the page finds out about itself once it has loaded, and tells the page around it.
const SCRIPT: &str = "<script>addEventListener('load', () => {
  const style = (of, name) => { const e = document.querySelector(of); return e ? getComputedStyle(e)[name] : ''; };
  const root = document.documentElement;
  parent.postMessage(JSON.stringify({
    images: document.images.length,
    broken: [...document.images].filter(i => !i.complete || i.naturalWidth === 0).length,
    wide: root.scrollWidth - root.clientWidth,
    width: innerWidth,
    dark: matchMedia('(prefers-color-scheme: dark)').matches,
    paper: style('body', 'backgroundColor'),
    plot: style('.plot:not(.paper) svg > rect', 'fill'),
    beside: style('nav.beside', 'display'),
    folded: style('nav.folded', 'display'),
  }), '*');
});</script>";

/// A page in a frame of some width, as a window may not be as narrow as a phone; its own text, so that it
/// may hold a script that the file has not.
pub fn show(program: &str, folder: &Path, page: &str, width: u32, dark: bool) -> Shown {
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder).expect("a folder");
    let (body, end) = page.rsplit_once("</body>").expect("a body");
    std::fs::write(folder.join("page.html"), format!("{body}{SCRIPT}</body>{end}")).expect("written");
    let frame = format!(
        "<!DOCTYPE html><meta charset=\"utf-8\"><title>frame</title><pre id=\"found\"></pre><script>\
         addEventListener('message', e => {{ document.getElementById('found').textContent = 'FOUND' + e.data + 'END'; }});\
         </script><iframe src=\"page.html\" style=\"width:{width}px;height:900px;border:0\"></iframe>"
    );
    std::fs::write(folder.join("frame.html"), frame).expect("written");
    let output = Command::new(program)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .args(["--enable-logging=stderr", "--v=0", "--virtual-time-budget=10000", "--window-size=1400,1000"])
        .arg(format!("--blink-settings=preferredColorScheme={}", if dark { 0 } else { 1 }))
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg("--dump-dom")
        .arg(format!("file://{}", folder.join("frame.html").display()))
        .stdin(Stdio::null())
        .output()
        .expect("the browser starts");
    let dom = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    // The first is in the frame's own script.
    let found = dom.split_once("<pre id=\"found\">FOUND").and_then(|(_, rest)| rest.split_once("END"));
    let found = found.unwrap_or_else(|| panic!("the page reported nothing: {errors}")).0;
    let report = serde_json::from_str(found).expect("a report");
    let console = errors.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect();
    Shown { report, console }
}
