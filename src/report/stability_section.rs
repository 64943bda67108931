//! The report's part on rounding at the extremes.

use super::number::short;
use super::plots::Plots;
use super::source::source;
use crate::bound::{Format, Handed};
use crate::kernel::stand_in::StandIn;
use crate::stability::{Clip, Factor, Limit, QForm, Stability, limits};
use std::fmt::Write;

/// The section, its figures at the end.
pub(super) fn section(study: &Stability, plots: &Plots<'_>, text: &mut String) {
    text.push_str(
        "\n## Rounding at the extremes\n\n\
         n from 1 to 1e12, θ from 1e-8 to π/2, each kernel in `f16` (every operation rounded), `f16-stored` (argument and \
         result; binary32 between, and for what depends on n alone), `f32` and `f64`, against a reference of about \
         100 bits. What depends on n alone is computed in `f64` and rounded \
         to the format. The angle is handed over as cos θ or as 1 - cos θ, rounded once, or as the difference \
         |a - b|²/2 of rounded unit vectors. Everything here is *sampled*: 1, 2 and 5 times the powers of ten for n, \
         some 400 angles each, so that a little more may happen between; and no fused multiply-add.\n",
    );
    let limits = limits(&study.lobes);
    sentences(&limits, text);
    table(&limits, text);
    factors(study, text);
    footprints(study, text);
    clips(study, text);
    text.push_str(&plots.place(&[
        "stability-cs-16",
        "stability-cubic-4",
        "stability-cubic-8",
        "stability-pow",
        "stability-footprint",
    ]));
}

fn named(handed: Handed) -> &'static str {
    match handed {
        Handed::Cosine => "cos θ",
        Handed::Versine => "1 - cos θ",
        Handed::Difference => "|a - b|²/2",
    }
}

/// A power of ten with its digit, `5e4`; small ones as they are.
fn exponent(n: f64) -> String {
    if n < 1e4 { n.to_string() } else { format!("{n:e}") }
}

/// Whether the kernel takes 1 - cos θ as it is, not by way of cos θ.
fn has_versine(stand_in: StandIn) -> bool {
    !matches!(stand_in, StandIn::SchlickPrinted | StandIn::Squarings | StandIn::Exp2Log2)
}

/// The kernels that share a limit; the list is short, so that order is by first occurrence.
fn grouped(limits: &[&Limit], of: impl Fn(&Limit) -> Option<f64>) -> String {
    let mut groups: Vec<(Option<f64>, Vec<&str>)> = Vec::new();
    for limit in limits {
        let value = of(limit);
        match groups.iter_mut().find(|group| group.0 == value) {
            Some(group) => group.1.push(limit.stand_in.id()),
            None => groups.push((value, vec![limit.stand_in.id()])),
        }
    }
    groups.sort_by(|a, b| b.0.unwrap_or(0.0).total_cmp(&a.0.unwrap_or(0.0)));
    // The largest group need not be spelt out, if it is large.
    let most = groups.iter().map(|group| group.1.len()).max().filter(|most| *most > 3);
    let largest = groups.iter().position(|group| Some(group.1.len()) == most);
    let text = groups.iter().enumerate().map(|(i, (value, names))| {
        let value = value.map_or("at no n".to_owned(), |n| format!("to n ≤ {}", exponent(n)));
        let names = if Some(i) == largest { "every other".to_owned() } else { names.join(", ") };
        format!("{value} ({names})")
    });
    text.collect::<Vec<_>>().join("; ")
}

fn sentences(limits: &[Limit], text: &mut String) {
    text.push_str(
        "\n**The rule.** Rounding stays below a display's step, 1/256, at every n of the grid from where the kernel is \
         meant (16 for fitted bells, else 1) to the n stated (at no n: not even at the first, 1 or 20); 1e12 is the end of the grid, and `squarings` ends with \
         32-bit whole numbers.\n\n"
    );
    for format in Format::ALL {
        for handed in Handed::ALL {
            let own: Vec<&Limit> =
                limits.iter().filter(|l| (l.format, l.handed) == (format, handed)).collect();
            let by_cosine = if handed == Handed::Cosine { "" } else { ", cos θ formed again where needed" };
            let _ = writeln!(
                text,
                "- {} and {}{by_cosine}: good {}.",
                format.id(),
                named(handed),
                grouped(&own, |limit| limit.below_display)
            );
        }
    }
    // The least over the kernels that take a versine: what a user may count on.
    let least = |format: Format, handed: Handed| {
        let own = limits.iter().filter(|l| (l.format, l.handed) == (format, handed));
        let meant = own.filter(|l| has_versine(l.stand_in));
        let least = meant.map(|l| l.below_display.unwrap_or(0.0)).fold(f64::INFINITY, f64::min);
        if least > 0.0 { format!("n ≤ {}", exponent(least)) } else { "some at no n".to_owned() }
    };
    let _ = write!(
        text,
        "\n**What to hand over.** In `f64` whatever is at hand: even cos θ is good to {}. In `f32` cos θ as long \
         as n stays small ({} for a display), the difference of unit vectors to {}, and 1 - cos θ, from wherever \
         it is known without a subtraction (2 sin²(θ/2), a half vector's tangent), to {}. In `f16` store 1 - cos θ \
         or the difference and never cos θ: stored so with binary32 arithmetic they serve {} and {}, from cos θ {}; with \
         every operation in `f16` the cubic lobes' constants overflow beyond n of a few hundred. The kernels that \
         form cos θ again (`schlick-printed`, `squarings`, `exp2-log2`) are left out of these limits: they stand in the \
         list above.\n",
        least(Format::Double, Handed::Cosine),
        least(Format::Single, Handed::Cosine),
        least(Format::Single, Handed::Difference),
        least(Format::Single, Handed::Versine),
        least(Format::HalfStored, Handed::Versine),
        least(Format::HalfStored, Handed::Difference),
        least(Format::HalfStored, Handed::Cosine),
    );
}

fn table(limits: &[Limit], text: &mut String) {
    // By their names in the file: a bar would end the cell.
    let head =
        Format::ALL.iter().flat_map(|format| Handed::ALL.map(|h| format!("{}, {}", format.id(), h.id())));
    let _ = write!(
        text,
        "\nThe largest n for which rounding stays below the kernel's own largest distance from cosⁿ for n ≥ 16. The \
         spherical Gaussian's falls as 1/n: at large n rounding exceeds it long before.\n\n| kernel | its distance | {} |\n|---|---|{}\n",
        head.collect::<Vec<_>>().join(" | "),
        "---|".repeat(Format::ALL.len() * Handed::ALL.len())
    );
    for stand_in in StandIn::ALL.into_iter().filter(|s| !s.is_exact()) {
        let own: Vec<&Limit> = limits.iter().filter(|l| l.stand_in == stand_in).collect();
        let Some(first) = own.first() else { continue };
        let cells = own.iter().map(|l| l.below_approximation.map_or("none".to_owned(), exponent));
        let _ = writeln!(
            text,
            "| {} | {} | {} |",
            stand_in.id(),
            short(first.approximation),
            cells.collect::<Vec<_>>().join(" | ")
        );
    }
    text.push_str(&source(&["fits/stability.csv"]));
}

fn factors(study: &Stability, text: &mut String) {
    text.push_str(
        "\nThe normalising factors lose at most a few units in the last place, at any n (n ≥ 16, relative, over the \
         models; both `f16` end where n does, at 65504):\n\n| factor | f16 | f16-stored | f32 | f64 |\n|---|---|---|---|---|\n",
    );
    for factor in Factor::ALL {
        let cells = Format::ALL.map(|format| {
            let own =
                study.factors.iter().filter(|r| (r.factor, r.format) == (factor, format) && r.n >= 16.0);
            let worst = own.filter_map(|r| r.relative).max_by(|a, b| a.0.total_cmp(&b.0));
            worst.map_or(String::new(), |(error, model, n)| {
                format!("{} ({}, n = {})", short(error), model.id(), short(n))
            })
        });
        let _ = writeln!(text, "| {} | {} |", factor.id(), cells.join(" | "));
    }
    text.push_str(&source(&["fits/stability-factors.csv"]));
}

/// The aspects and sizes shown of the footprints.
const ASPECTS: [f64; 4] = [1.0, 100.0, 1e4, 1e6];
const SCALES: [f64; 5] = [1e-20, 1e-10, 1.0, 1e10, 1e20];

fn footprints(study: &Stability, text: &mut String) {
    let _ = write!(
        text,
        "\nThe footprint's Q ≤ 1: absolute error, for `inverse` relative; the worst \
         over major semi-axes of 1e-20 to 1e20 texels (*any*) and that of 1 texel. NaN or inf: beyond the range that the \
         form's page states.\n\n| form | format | size | {} |\n|---|---|---|{}\n",
        ASPECTS.map(|aspect| format!("aspect {}", exponent(aspect))).join(" | "),
        "---|".repeat(ASPECTS.len())
    );
    for form in QForm::ALL {
        for format in [Format::Single, Format::Double] {
            for any in [false, true] {
                let cells = ASPECTS.map(|aspect| {
                    let own = study.footprints.iter().filter(|r| {
                        (r.form, r.format) == (form, format)
                            && r.aspect == aspect
                            && SCALES.contains(&r.scale)
                            && (any || r.scale == 1.0)
                    });
                    // A NaN is worse than any error.
                    let worst = own.map(|r| r.error).fold(0.0, |worst: f64, error| {
                        if worst.is_nan() || error.is_nan() { f64::NAN } else { worst.max(error) }
                    });
                    if worst.is_finite() { short(worst) } else { worst.to_string() }
                });
                let size = if any { "any" } else { "1" };
                let _ =
                    writeln!(text, "| {} | {} | {size} | {} |", form.id(), format.id(), cells.join(" | "));
            }
        }
    }
    text.push_str(&source(&["fits/stability-footprint.csv"]));
}

fn clips(study: &Stability, text: &mut String) {
    text.push_str(
        "\nThe clip volumes for d from 1e-8 to ½ pixel, absolute:\n\n\
         | volume | f16 | f16-stored | f32 | f64 |\n|---|---|---|---|---|\n",
    );
    for clip in Clip::ALL {
        let cells = Format::ALL.map(|format| {
            let own = study.clips.iter().filter(|r| (r.clip, r.format) == (clip, format));
            own.max_by(|a, b| a.error.total_cmp(&b.error))
                .map_or(String::new(), |r| format!("{} (d = {})", short(r.error), short(r.at)))
        });
        let _ = writeln!(text, "| {} | {} |", clip.id(), cells.join(" | "));
    }
    text.push_str(&source(&["fits/stability-clip.csv"]));
}
