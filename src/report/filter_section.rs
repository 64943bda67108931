//! The report's part on texture filters.

use super::number::short;
use super::source::source_alone;
use crate::kernel::pixel::{PaperReading, PixelWeight};
use crate::scene::{Compared, Comparison, cut_deviation};
use std::fmt::Write;

/// The pictures' table, the pictures, and what they show.
pub(super) fn section(comparisons: &[Comparison], text: &mut String) {
    text.push_str(
        "\n## Texture filters, seen\n\n\
         A textured plane by every filter against a supersampled reference (`bellfit render` shows any \
         scene and image). The references: *Gaussian*, the weight exp(-2 r²), σ = ½ pixel, to where it is 4e-6, and *area*, the mean over the \
         pixel's square; both of the same samples, the texture bilinear between its texels. RMSE in linear light, peak 1; \
         *ssim2* is SSIMULACRA 2 (100: equal). *Gain* is how much of the reference's contrast a picture keeps, above 1 \
         sharper; *alien* the root mean square of what gain × reference leaves: aliasing, and contrast that is kept unequally, as a \
         blur does at edges.\n\n\
         These are measurements of pictures, not proofs.",
    );
    certainty(comparisons, text);
    for comparison in comparisons {
        table(comparison, text);
    }
    text.push_str("\n### What the pictures show\n\n");
    sigma(comparisons, text);
    readings(comparisons, text);
    padding(comparisons, text);
    skew(comparisons, text);
    bells(comparisons, text);
    text.push_str("\nWhat a lookup costs in time stands under [speed](#speed-against-accuracy).\n");
}

/// How small the references' error is against what is shown.
fn certainty(comparisons: &[Comparison], text: &mut String) {
    let rows = || comparisons.iter().flat_map(|c| &c.rows);
    let least = rows().map(|row| row.gaussian.rmse.min(row.area.rmse)).fold(f64::INFINITY, f64::min);
    let own = comparisons
        .iter()
        .map(|c| c.references.area.sampling_error.max(c.references.gaussian.sampling_error))
        .fold(0.0, f64::max);
    let _ = writeln!(
        text,
        " The smallest RMSE below is {}; the references' own sampling error, estimated from half sets of their samples, is at \
         most {}, and common to all filters of a scene.",
        short2(least),
        short2(own)
    );
}

fn table(comparison: &Comparison, text: &mut String) {
    let Comparison { scene, references, rows, .. } = comparison;
    let name = &scene.name;
    let command = format!("bellfit render --scene {name}");
    let _ = write!(
        text,
        "\n### Scene {name}\n\n![{name}: the reference and seven filters](images/{name}.png)\n{}\n\
         Differences from the reference, four times as strong, grey where there is none, black and white from 1/8 on:\n\n\
         ![{name}: differences of seven filters](images/{name}-difference.png)\n{}\n\
         Sampling error of the references, estimated from half sets: {} (Gaussian) and {} (area).\n\n\
         | technique | RMSE, Gaussian | PSNR, dB | ssim2 | gain | alien | RMSE, area | PSNR, dB | ssim2 | texels, mean | most |\n\
         |---|---|---|---|---|---|---|---|---|---|---|\n",
        source_alone(&[&format!("reports/images/{name}.png"), "fits/filter.csv"], &command),
        source_alone(&[&format!("reports/images/{name}-difference.png"), "fits/filter.csv"], &command),
        short2(references.gaussian.sampling_error),
        short2(references.area.sampling_error)
    );
    for row in rows {
        let Compared { technique, gaussian, area, mean_texels, largest_texels, .. } = row;
        let _ = writeln!(
            text,
            "| {} | {:.4} | {:.1} | {:.1} | {:.3} | {:.4} | {:.4} | {:.1} | {:.1} | {mean_texels:.1} | {largest_texels} |",
            technique.id,
            gaussian.rmse,
            gaussian.psnr,
            gaussian.perceptual,
            gaussian.gain,
            gaussian.alien,
            area.rmse,
            area.psnr,
            area.perceptual
        );
    }
    text.push_str(&source_alone(&["fits/filter.csv"], &command));
}

/// Two significant digits.
fn short2(x: f64) -> String {
    format!("{x:.1e}")
}

/// A number of a technique on each scene: `0.12 (checker), 0.34 (rolled)`.
fn each(comparisons: &[Comparison], id: &str, number: impl Fn(&Compared) -> f64, digits: usize) -> String {
    let one = |c: &Comparison| Some(format!("{:.digits$} ({})", number(c.row(id)?), c.scene.name));
    comparisons.iter().filter_map(one).collect::<Vec<_>>().join(", ")
}

fn sigma(comparisons: &[Comparison], text: &mut String) {
    let gain = |id| each(comparisons, id, |row| row.gaussian.gain, 2);
    let alien = |id| each(comparisons, id, |row| row.gaussian.alien, 3);
    let _ = writeln!(
        text,
        "- **Sharper.** Q = 1 is the circle of radius 1 pixel, so P4's σ = L/6 is 1/3 pixel, and 1/6 with base diameter 1; \
         renderers take exp(-2 Q), σ = ½ (P. S. Heckbert, 1989; M. Pharr, W. Jakob, G. Humphreys, \"Physically Based \
         Rendering\", 3rd ed., 10.4.5, which subtracts e^-2 besides). All end at Q = 1, which narrows the wide ones: as cut \
         the deviation is {} pixel for 1/3 and {} for ½. Padded, so that the weight alone counts, the gain with σ = 1/3 is {} \
         against {} with ½; the alien part, in which the zone plate's false rings show, {} against {}. Plain, with base \
         diameter 1, the alien part is {}.",
        short(cut_deviation(PixelWeight::Gaussian(1.0 / 3.0))),
        short(cut_deviation(PixelWeight::Gaussian(0.5))),
        gain("gaussian-third-padded"),
        gain("gaussian-half-padded"),
        alien("gaussian-third-padded"),
        alien("gaussian-half-padded"),
        alien("gaussian-third-diameter-1")
    );
    let area = |id| each(comparisons, id, |row| row.area.rmse, 4);
    let _ = writeln!(
        text,
        "- **Which pixel is meant decides.** Against the mean over the pixel's square σ = 1/3 has RMSE {}, ½ has {} (both \
         padded); against the Gaussian pixel 1/3 has {}, ½ has {}.",
        area("gaussian-third-padded"),
        area("gaussian-half-padded"),
        each(comparisons, "gaussian-third-padded", |row| row.gaussian.rmse, 4),
        each(comparisons, "gaussian-half-padded", |row| row.gaussian.rmse, 4)
    );
}

fn readings(comparisons: &[Comparison], text: &mut String) {
    text.push_str(
        "- **R1 to R4** of the paper's weight (1 - c Q)^8 stand for σ = 1/(4 √c); cut off at Q = 1, as they are, their \
         deviation is less:",
    );
    for (i, reading) in PaperReading::ALL.into_iter().enumerate() {
        let id = format!("paper-r{}", i + 1);
        let sigma = 0.25 / reading.scale::<f64>().sqrt();
        let rmse = each(comparisons, &id, |row| row.gaussian.rmse, 4);
        let cut = cut_deviation(PixelWeight::Paper(reading));
        let end = if i + 1 == PaperReading::ALL.len() { "." } else { ";" };
        let _ = write!(text, " R{} {} pixel, cut {}, RMSE {rmse}{end}", i + 1, short(sigma), short(cut));
    }
    let change = comparisons.iter().flat_map(|c| {
        (1..=4).filter_map(|i| {
            let (sum, product) = (c.row(&format!("paper-r{i}"))?, c.row(&format!("paper-r{i}-product"))?);
            Some((product.gaussian.rmse / sum.gaussian.rmse - 1.0).abs())
        })
    });
    let _ = writeln!(
        text,
        " As a product instead of a sum each changes by at most {:.1} %.",
        100.0 * change.fold(0.0, f64::max)
    );
}

fn padding(comparisons: &[Comparison], text: &mut String) {
    let rmse = |id| each(comparisons, id, |row| row.gaussian.rmse, 4);
    let _ = writeln!(
        text,
        "- **The plain conic misses texels.** Where an axis is shorter than a texel few centres or none lie inside; padded \
         by one texel the σ = ½ Gaussian comes from RMSE {} to {}.",
        rmse("gaussian-half"),
        rmse("gaussian-half-padded")
    );
}

fn skew(comparisons: &[Comparison], text: &mut String) {
    text.push_str("- **Skew.**");
    let most = comparisons.iter().min_by(|a, b| a.skew.degrees.total_cmp(&b.skew.degrees));
    if let Some(Comparison { scene, skew, .. }) = most {
        let _ = write!(
            text,
            " In {} the derivative vectors come as near to each other as {:.1}°, at pixel ({}, {}): the ellipse is {:.1} times \
             as long as wide there, by the paper's axes {:.1} times, and their longer one points {:.0}° (tilt of the first \
             vector) or {:.0}° (½ arctan(B/(A - C))) beside the ellipse's.",
            scene.name,
            skew.degrees,
            skew.pixel.0,
            skew.pixel.1,
            skew.aspect,
            skew.paper_aspect,
            skew.tilt_errors[0],
            skew.tilt_errors[1]
        );
    }
    let rmse = |id| each(comparisons, id, |row| row.gaussian.rmse, 4);
    let _ = writeln!(
        text,
        " For the padded σ = ½ Gaussian that is RMSE {} with the conic's axes, {} with the vector's tilt and {} with the \
         conic's tilt. (Plain, the paper's fatter ellipses can come out nearer than the true thin ones, which miss texels.)",
        rmse("gaussian-half-padded"),
        rmse("gaussian-half-padded-vector-tilt"),
        rmse("gaussian-half-padded-conic-tilt")
    );
}

fn bells(comparisons: &[Comparison], text: &mut String) {
    let off = |bell: &str, gaussian: &str| {
        let one = |c: &Comparison| Some((c.row(bell)?.gaussian.rmse - c.row(gaussian)?.gaussian.rmse).abs());
        comparisons.iter().filter_map(one).fold(0.0, f64::max)
    };
    let _ = writeln!(
        text,
        "- **The cubic bells stand for the Gaussian**: their RMSE differs from its own by at most {} (K = 4) and {} (K = 8), \
         σ = ½ and 1/3; the references' sampling error is common to both.",
        short2(off("cubic-4-half", "gaussian-half").max(off("cubic-4-third", "gaussian-third"))),
        short2(off("cubic-8-half", "gaussian-half").max(off("cubic-8-third", "gaussian-third")))
    );
}
