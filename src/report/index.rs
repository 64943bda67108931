//! The report's last part: how to remake everything, and what each file holds.

use super::figures::Figure;
use super::measured::FOLDER;
use super::source::link;
use std::fmt::Write;

/// The commands, and every file of fits/ and reports/ among `paths` in one line.
pub(super) fn section(paths: &[&str], figures: &[Figure], text: &mut String) {
    text.push_str(COMMANDS);
    for (heading, folder) in [("The fits", "fits/"), ("The reports", "reports/")] {
        let _ = write!(text, "\n### {heading}\n\n");
        for path in paths.iter().filter(|path| path.starts_with(folder)) {
            let holds = holds(path, figures).unwrap_or_default();
            let _ = writeln!(text, "- {}: {holds} (`{}`)", link(path), command(path));
        }
    }
}

const COMMANDS: &str = "
## How to remake everything

- `bellfit` (in a checkout: `cargo run --release`) computes everything anew, writes fits/ and reports/, and prints the verdicts; \
`bellfit --check` compares and writes nothing.
- `bellfit fit --model blinn-phong --objective minimax` makes one fit; `bellfit fit --help` lists models, limits, forms and objectives.
- `bellfit verify my-claims.toml` judges claims of your own in the same way.
- `bellfit render --scene rolled` draws each filter's picture by itself.
- `bellfit trade --out reports/measured` and `bellfit render --measure --out reports/measured` measure times on the machine at hand.
";

/// What remakes a file.
fn command(path: &str) -> &'static str {
    match path.strip_prefix(FOLDER).map(|name| name.trim_start_matches('/')) {
        Some(name) if name.starts_with("filter") => "bellfit render --measure --out reports/measured",
        Some(_) => "bellfit trade --out reports/measured",
        None => "bellfit",
    }
}

/// What a file holds.
fn holds(path: &str, figures: &[Figure]) -> Option<String> {
    let told = FILES.iter().find(|(of, _)| *of == path).map(|(_, holds)| (*holds).to_owned());
    told.or_else(|| {
        let (folder, name) = path.rsplit_once('/')?;
        let (stem, ending) = name.rsplit_once('.')?;
        match folder {
            "fits/integrals" => Some(format!("Int(n) of {stem} for n = 16 to 1024, every lobe and limit")),
            "reports/plots" => {
                figures.iter().find(|figure| figure.stem == stem).map(|figure| figure.alt.clone())
            }
            "reports/images" => Some(match stem.strip_suffix("-difference") {
                Some(scene) => format!("how seven filters differ from the reference in scene {scene}"),
                None => format!("the reference and seven filters in scene {stem}"),
            }),
            FOLDER => Some(measured(stem, ending)),
            _ => None,
        }
    })
}

fn measured(stem: &str, ending: &str) -> String {
    let what = if stem.starts_with("filter") {
        "time of a texture lookup"
    } else {
        "speed against accuracy of cosⁿ"
    };
    match ending {
        "md" => format!("{what}, as measured, in words and tables"),
        "csv" | "json" => format!("{what}: the measurement itself"),
        _ => format!("{what}: the plot"),
    }
}

const FILES: [(&str, &str); 24] = [
    ("fits/albedo-suprema.csv", "the largest directional albedo of each model, lobe, factor and n"),
    ("fits/albedo.csv", "directional albedo by angle, with its error"),
    ("fits/clip.csv", "fits of the pixel's volume beyond a line, errors certified"),
    ("fits/coefficients.csv", "linear factors of cs_16, printed and refitted, residuals certified"),
    (
        "fits/factors.csv",
        "factors in more forms, minimax and one-sided, residuals certified over every real n",
    ),
    ("fits/filter.csv", "error of every texture filter on the built-in scenes"),
    ("fits/footprint.csv", "the paper's axes and tilts beside the ellipse's own, over skewed footprints"),
    ("fits/kernels-cosn.csv", "bells for cosⁿ with coefficients in n, errors certified"),
    ("fits/kernels.csv", "bells for e⁻ᵗ, errors certified"),
    ("fits/nearest.csv", "printed constants that break their bound, and the nearest that keep it"),
    ("fits/pixel-weights.csv", "weights of a texel against the Gaussian, errors certified"),
    ("fits/stability-clip.csv", "rounding of the volumes beyond a line"),
    ("fits/stability-factors.csv", "rounding of the factors over n"),
    ("fits/stability-footprint.csv", "rounding of the footprint's Q over aspects and sizes"),
    ("fits/stability.csv", "rounding of each kernel over n, in each format and from each argument"),
    ("fits/suprema.csv", "certified suprema, and where they are reached"),
    ("fits/table1.csv", "Table 1, printed and recomputed"),
    ("fits/weights.csv", "the weights of the texels of the pixel paper's figure"),
    ("reports/table1.md", "Table 1 as Markdown"),
    ("reports/table1.tex", "Table 1 as LaTeX"),
    ("reports/report.md", "this report as Markdown"),
    ("reports/report.html", "this report as one page with everything in it"),
    ("reports/verdicts.csv", "every reading with its number, verdict and witness"),
    ("reports/verdicts.json", "the same for programs"),
];
