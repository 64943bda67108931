//! Directional albedo against the angle, a panel a use.

use super::sample::empty;
use super::{Figure, FigureError};
use crate::integral::albedo::{AlbedoCurve, Reflectance, Usage};
use crate::kernel::model::Convention;
use crate::report::chart::{Axis, Band, Chart, LineChart, Panels, Scale, Series, Style};

/// The exponents drawn, each a figure of its own name.
const FIGURES: [(f64, &str); 2] = [(16.0, "albedo-16"), (64.0, "albedo-64")];

/// The lobes and factors drawn; the others coincide with one of them to the eye.
const DRAWN: [(&str, &str); 4] =
    [("cos-n", "exact"), ("cs16", "printed"), ("cs16", "one-sided"), ("cubic4", "one-sided")];

/// Angles for a curve, in degrees: closer where grazing light changes fastest.
pub fn albedo_degrees() -> Vec<f64> {
    let whole = (0..80).map(f64::from);
    whole.chain((0..=100).map(|k| 80.0 + f64::from(k) / 10.0)).collect()
}

/// The curves of n = 16 and of n = 64, a figure each.
///
/// # Errors
/// [`FigureError`] where an exponent has no curve.
pub(super) fn albedos(curves: &[AlbedoCurve]) -> Result<Vec<Figure>, FigureError> {
    FIGURES.iter().map(|&(n, stem)| figure(curves, n, stem)).collect()
}

fn figure(curves: &[AlbedoCurve], n: f64, stem: &'static str) -> Result<Figure, FigureError> {
    let curves: Vec<&AlbedoCurve> =
        curves.iter().filter(|c| c.n == n && DRAWN.contains(&(c.lobe.as_str(), c.factor.as_str()))).collect();
    let highest = |best: Option<&AlbedoCurve>, c: &AlbedoCurve| {
        best.is_none_or(|b| c.supremum.at.value.value > b.supremum.at.value.value)
    };
    let mut worst: Option<&AlbedoCurve> = None;
    let mut labels: Vec<String> = Vec::new();
    for curve in &curves {
        if highest(worst, curve) {
            worst = Some(curve);
        }
        if !labels.contains(&label(curve)) {
            labels.push(label(curve));
        }
    }
    let Some(worst) = worst else { return Err(FigureError::NoLines) };
    let message = format!(
        "n = {n}: the largest albedo is {:.4}, {} with {}, at {}°",
        worst.supremum.at.value.value,
        title(worst.reflectance),
        label(worst),
        worst.supremum.at.degrees()
    );
    let charts = Reflectance::ALL.into_iter().filter_map(|of| panel(of, &curves, &labels)).collect();
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle:
            "What the eye sees of a surface lit by 1 from everywhere. Above 1 it gains energy. Scales differ."
                .into(),
        columns: 2,
        charts,
    });
    Ok(Figure { stem, alt: format!("{message}."), chart })
}

fn label(curve: &AlbedoCurve) -> String {
    format!("{}, factor {}", curve.lobe, curve.factor)
}

/// The model's title, and for a distribution of normals what is made of it.
fn title(of: Reflectance) -> String {
    let model = of.model();
    match (model.convention(), of.usage()) {
        (Convention::Rdf | Convention::RdfCosine, _) => model.title().into(),
        (_, Usage::Printed) => format!("{}, as printed", model.title()),
        (_, Usage::Microfacet) => format!("{}, V-cavities", model.title()),
    }
}

fn panel(of: Reflectance, curves: &[&AlbedoCurve], labels: &[String]) -> Option<LineChart> {
    let series: Vec<Series> =
        curves.iter().filter(|c| c.reflectance == of).map(|c| series(c, labels)).collect();
    if series.is_empty() {
        return None;
    }
    let reciprocal = if of.is_reciprocal() { "reciprocal" } else { "not reciprocal" };
    let x = Axis {
        ticks: (0..=6).map(|k| f64::from(15 * k)).map(|at| (at, format!("{at}"))).collect(),
        ..Axis::new("angle from the normal θ [°]", Scale::Linear, (0.0, 90.0))
    };
    // Down to a tenth below the lowest, and up to where a gain would show.
    let lowest = series.iter().flat_map(|s| &s.points).map(|p| p.1).fold(1.0, f64::min);
    let floor = (libm::floor(10.0 * lowest - 0.2) / 10.0).max(0.0);
    let y = Axis::new("albedo a(θ)", Scale::Linear, (floor, 1.0 + 0.08 * (1.0 - floor)));
    let gain = Band { label: "gains energy".into(), lo: 1.0, hi: f64::INFINITY };
    Some(LineChart {
        title: title(of),
        subtitle: reciprocal.into(),
        bands: vec![gain],
        series,
        ..empty(x, y)
    })
}

fn series(curve: &AlbedoCurve, labels: &[String]) -> Series {
    let label = label(curve);
    let index = labels.iter().position(|known| *known == label).unwrap_or(0);
    // Many coincide: later ones lie over earlier ones and must let them through.
    let style = [Style::Line, Style::Dashed, Style::Dotted, Style::Dashed][index % 4];
    let points = curve.points.iter().map(|p| (p.degrees(), p.value.value)).collect();
    Series { colour: Some(index), ..Series::new(label, style, points) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::albedo::{AlbedoSubject, albedo_curves};

    #[test]
    fn a_panel_a_use_and_the_largest_in_the_title() {
        let curves = albedo_curves(&AlbedoSubject::all(), &[16.0, 64.0], &[0.0, 30.0, 90.0]).unwrap();
        let figures = albedos(&curves).unwrap();
        let Chart::Panels(panels) = &figures[1].chart else { panic!("panels") };
        assert_eq!((figures.len(), panels.charts.len()), (2, 8));
        assert!(panels.charts.iter().all(|c| c.series.len() == DRAWN.len() && c.series[0].points.len() == 3));
        // 1.068 n + 0.96 at n = 64, the worst of the printed factors.
        assert!(
            panels.title.contains("Blinn-Phong (RDF) with cs16, factor printed, at 0°"),
            "{}",
            panels.title
        );
        assert_eq!(albedos(&curves[..0]).unwrap_err(), FigureError::NoLines);
    }
}
