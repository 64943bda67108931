//! Where figures belong: to which kinds of claim, and to which files that hold their numbers.

use crate::paper::{Kind, PixelKind};

/// What figures a kind of claim has.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::report) struct Shown {
    /// Stems of those that show it: they stand at the first claim that has them.
    pub(in crate::report) own: Vec<&'static str>,
    /// Stems of those that show it beside something else.
    pub(in crate::report) see: Vec<&'static str>,
}

impl Shown {
    fn new(own: &[&'static str], see: &[&'static str]) -> Self {
        Shown { own: own.to_vec(), see: see.to_vec() }
    }

    /// The figures of a kind.
    pub(in crate::report) fn of(kind: &Kind) -> Self {
        match kind {
            Kind::Cut { .. } => Shown::new(&["cuts"], &[]),
            Kind::LobeZero { .. } => Shown::new(&[], &["cuts"]),
            Kind::CutEffect { .. } => Shown::new(&[], &["cuts", "difference-curves"]),
            Kind::LobeDifference { .. } => Shown::new(&["difference-curves", "difference-map"], &[]),
            Kind::FactorResidual { .. } => Shown::new(&["residuals"], &[]),
            Kind::Energy { .. } | Kind::Normalisation(_) => Shown::new(&[], &["residuals"]),
            Kind::EnergyAtEveryAngle { .. } => {
                Shown::new(&["albedo-16", "albedo-64", "albedo-difference"], &[])
            }
            Kind::Fit { .. } => Shown::new(&["integrals"], &["residuals"]),
            Kind::SameIntegral { .. } => Shown::new(&[], &["residuals"]),
            Kind::GaussianFalls { .. } => Shown::new(&["gaussians", "gaussian-curves"], &[]),
            Kind::GaussianBeatsLobe { .. } => Shown::new(&[], &["gaussians"]),
            Kind::BellFalls { .. } => Shown::new(&["bells"], &[]),
            // A figure that is redrawn says where.
            Kind::Definition { place } => Shown { own: named(place), see: vec![] },
            Kind::FactorIdentity { .. } | Kind::FactorInequality { .. } => Shown::default(),
            Kind::Pixel(kind) => Shown::of_pixel(kind),
        }
    }

    fn of_pixel(kind: &PixelKind) -> Self {
        match kind {
            PixelKind::Conic { .. } => Shown::new(&["pixel-ellipses"], &[]),
            PixelKind::Rotation { .. } => Shown::new(&[], &["pixel-ellipses"]),
            PixelKind::Tilt { .. } => Shown::new(&["pixel-tilts"], &[]),
            PixelKind::AxisFormula { .. } | PixelKind::AxesAre { .. } => {
                Shown::new(&["pixel-axes"], &["pixel-ellipses"])
            }
            PixelKind::BellNumber { .. } | PixelKind::BellIsNearest { .. } | PixelKind::BellUncut { .. } => {
                Shown::new(&[], &["bells"])
            }
            PixelKind::WeightNumber { .. }
            | PixelKind::WeightOnRim { .. }
            | PixelKind::WeightHas { .. }
            | PixelKind::WeightIsNearest { .. } => Shown::new(&["pixel-bells"], &["pixel-weights"]),
            PixelKind::ClipHas { .. } | PixelKind::ClipDistance { .. } | PixelKind::ClipFit { .. } => {
                Shown::new(&["clip-volume"], &[])
            }
            PixelKind::RimVolume { .. } => Shown::new(&[], &["clip-volume"]),
            PixelKind::DerivativesAgree { .. }
            | PixelKind::GaussianVolume { .. }
            | PixelKind::GaussianBeyondBase { .. }
            | PixelKind::RimTexel { .. } => Shown::default(),
        }
    }
}

/// The figures whose files a place names.
fn named(place: &str) -> Vec<&'static str> {
    let stems = DATA.iter().map(|(stem, _)| *stem);
    stems.filter(|stem| place.contains(&format!("reports/plots/{stem}."))).collect()
}

/// The files that hold the numbers of the figure with this stem, with all digits.
pub(in crate::report) fn data(stem: &str) -> &'static [&'static str] {
    DATA.iter().find(|(of, _)| *of == stem).map_or(&[], |(_, files)| files)
}

const DATA: [(&str, &[&str]); 27] = [
    ("lobes-128", &["fits/suprema.csv"]),
    ("difference-curves", &["fits/suprema.csv"]),
    ("difference-map", &["fits/suprema.csv"]),
    ("cuts", &["reports/verdicts.csv"]),
    ("residuals", &["fits/coefficients.csv"]),
    ("integrals", &["fits/integrals"]),
    ("gaussians", &["fits/suprema.csv"]),
    ("gaussian-curves", &["fits/suprema.csv"]),
    ("bells", &["fits/suprema.csv", "fits/kernels.csv"]),
    ("factors", &["fits/factors.csv"]),
    ("kernels", &["fits/kernels-cosn.csv", "fits/kernels.csv"]),
    ("kernels-over-n", &["fits/kernels-cosn.csv"]),
    ("kernels-error", &["fits/kernels.csv"]),
    ("albedo-16", &["fits/albedo.csv", "fits/albedo-suprema.csv"]),
    ("albedo-64", &["fits/albedo.csv", "fits/albedo-suprema.csv"]),
    ("albedo-difference", &["fits/albedo.csv"]),
    ("clip-volume", &["fits/clip.csv"]),
    ("pixel-axes", &["fits/footprint.csv"]),
    ("pixel-ellipses", &["fits/footprint.csv"]),
    ("pixel-tilts", &["fits/footprint.csv"]),
    ("pixel-bells", &["fits/pixel-weights.csv"]),
    ("pixel-weights", &["fits/weights.csv"]),
    ("stability-cs-16", &["fits/stability.csv"]),
    ("stability-cubic-4", &["fits/stability.csv"]),
    ("stability-cubic-8", &["fits/stability.csv"]),
    ("stability-pow", &["fits/stability.csv"]),
    ("stability-footprint", &["fits/stability-footprint.csv"]),
];
