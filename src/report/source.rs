//! Where numbers stand with all their digits, and what remakes them: the line below every table and figure.
//!
//! The report lies in reports/, so a path of the repository is linked from there.

/// What regenerates every computed file.
pub(super) const REPRODUCE: &str = "bellfit";

/// The target of a link in the report to a file or folder of the repository.
pub(super) fn target(path: &str) -> String {
    path.strip_prefix("reports/").map_or_else(|| format!("../{path}"), str::to_owned)
}

/// A file or folder of the repository as a link.
pub(super) fn link(path: &str) -> String {
    format!("[{path}]({})", target(path))
}

/// The line below a table or figure whose numbers `bellfit` regenerates.
pub(super) fn source(paths: &[&str]) -> String {
    source_by(paths, REPRODUCE)
}

/// The line below a table or figure: where its numbers stand, and the command that remakes them.
pub(super) fn source_by(paths: &[&str], command: &str) -> String {
    let links: Vec<String> = paths.iter().map(|path| link(path)).collect();
    format!("\n*Source:* {}; remade by `{command}`.\n", links.join(", "))
}

/// The same where another command makes this one part by itself.
pub(super) fn source_alone(paths: &[&str], alone: &str) -> String {
    source_by(paths, &format!("{REPRODUCE}`, and by itself by `{alone}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_start_from_the_folder_of_the_report() {
        assert_eq!(link("fits/clip.csv"), "[fits/clip.csv](../fits/clip.csv)");
        assert_eq!(link("reports/plots/cuts.svg"), "[reports/plots/cuts.svg](plots/cuts.svg)");
        let line = source(&["fits/a.csv", "reports/b.csv"]);
        let expected = "[fits/a.csv](../fits/a.csv), [reports/b.csv](b.csv); remade by `bellfit`.";
        assert_eq!(line, format!("\n*Source:* {expected}\n"));
    }
}
