//! Directional albedo against the angle, a panel a use.

use super::sample::{empty, number};
use super::{Figure, FigureError};
use crate::integral::albedo::{AlbedoCurve, Reflectance};
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

/// The curves of n = 16 and of n = 64, a figure each, and of the latter how far each is from that of
/// cosⁿ, which a scale from 0 to 1 does not show.
///
/// # Errors
/// [`FigureError`] where an exponent has no curve.
pub(super) fn albedos(curves: &[AlbedoCurve]) -> Result<Vec<Figure>, FigureError> {
    let mut figures = Vec::new();
    for (n, stem) in FIGURES {
        figures.push(figure(&drawn(curves, n)?, n, stem));
    }
    let (n, _) = FIGURES[1];
    figures.push(differences(&drawn(curves, n)?, n));
    Ok(figures)
}

/// The curves of one exponent that are drawn.
fn drawn(curves: &[AlbedoCurve], n: f64) -> Result<Vec<&AlbedoCurve>, FigureError> {
    let shown = |c: &&AlbedoCurve| c.n == n && DRAWN.contains(&(c.lobe.as_str(), c.factor.as_str()));
    let found: Vec<&AlbedoCurve> = curves.iter().filter(shown).collect();
    if found.is_empty() { Err(FigureError::NoLines) } else { Ok(found) }
}

fn figure(curves: &[&AlbedoCurve], n: f64, stem: &'static str) -> Figure {
    let highest = curves.iter().map(|c| c.supremum.at.value.value).fold(0.0, f64::max);
    let message =
        format!("n = {n}: the lobes' albedos nearly coincide at every angle; the largest is {highest:.4}");
    let charts = Reflectance::ALL.into_iter().filter_map(|of| panel(of, curves)).collect();
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle:
            "What the eye sees of a surface lit by 1 from everywhere. Above 1 it gains energy. Scales differ."
                .into(),
        columns: 2,
        charts,
    });
    Figure { stem, alt: format!("{message}."), chart }
}

/// Each curve less that of cosⁿ with its exact factor.
fn differences(curves: &[&AlbedoCurve], n: f64) -> Figure {
    let panel = |of: Reflectance| {
        let mut own = curves.iter().filter(|c| c.reflectance == of);
        let cosine = own.next()?;
        let less = |c: &&AlbedoCurve| {
            let pairs = c.points.iter().zip(&cosine.points);
            let points = pairs.map(|(p, q)| (p.degrees(), p.value.value - q.value.value)).collect();
            Series { colour: Some(index(c)), ..Series::new(label(c), Style::Line, points) }
        };
        let series: Vec<Series> = own.map(less).collect();
        let size = series.iter().flat_map(|s| &s.points).map(|p| p.1.abs()).fold(1e-9, f64::max);
        let y = Axis::new("albedo less that of cosⁿ", Scale::Linear, (-1.1 * size, 1.1 * size));
        Some(LineChart { title: of.title(), series, ..empty(angles(), y) })
    };
    let largest = |lobe: &str| {
        let of = |reflectance| {
            let mut own = curves.iter().filter(move |c| c.reflectance == reflectance);
            let cosine = own.next()?;
            let other = own.find(|c| (c.lobe.as_str(), c.factor.as_str()) == (lobe, "one-sided"))?;
            let pairs = other.points.iter().zip(&cosine.points);
            Some(pairs.map(|(p, q)| (p.value.value - q.value.value).abs()).fold(0.0, f64::max))
        };
        Reflectance::ALL.into_iter().filter_map(of).fold(0.0, f64::max)
    };
    let message = format!(
        "n = {n}: at every angle the cubic lobe's albedo is within {} of cosⁿ's, cs_16's within {}",
        number(largest("cubic4")),
        number(largest("cs16"))
    );
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle:
            "Those two with one-sided factors; the printed ones are off along the normal already. Scales \
                   differ."
                .into(),
        columns: 2,
        charts: Reflectance::ALL.into_iter().filter_map(panel).collect(),
    });
    Figure { stem: "albedo-difference", alt: format!("{message}."), chart }
}

fn angles() -> Axis {
    Axis {
        ticks: (0..=6).map(|k| f64::from(15 * k)).map(|at| (at, format!("{at}"))).collect(),
        ..Axis::new("angle from the normal θ [°]", Scale::Linear, (0.0, 90.0))
    }
}

/// The place in [`DRAWN`], for colours.
fn index(curve: &AlbedoCurve) -> usize {
    DRAWN.iter().position(|drawn| *drawn == (curve.lobe.as_str(), curve.factor.as_str())).unwrap_or(0)
}

fn label(curve: &AlbedoCurve) -> String {
    format!("{}, factor {}", curve.lobe, curve.factor)
}

fn panel(of: Reflectance, curves: &[&AlbedoCurve]) -> Option<LineChart> {
    let series: Vec<Series> = curves.iter().filter(|c| c.reflectance == of).map(|c| series(c)).collect();
    if series.is_empty() {
        return None;
    }
    let reciprocal = if of.is_reciprocal() { "reciprocal" } else { "not reciprocal" };
    // Down to a tenth below the lowest, and up to where a gain would show.
    let lowest = series.iter().flat_map(|s| &s.points).map(|p| p.1).fold(1.0, f64::min);
    let floor = (libm::floor(10.0 * lowest - 0.2) / 10.0).max(0.0);
    let y = Axis::new("albedo a(θ)", Scale::Linear, (floor, 1.0 + 0.08 * (1.0 - floor)));
    let gain = Band { label: "gains energy".into(), lo: 1.0, hi: f64::INFINITY };
    Some(LineChart {
        title: of.title(),
        subtitle: reciprocal.into(),
        bands: vec![gain],
        series,
        ..empty(angles(), y)
    })
}

fn series(curve: &AlbedoCurve) -> Series {
    let index = index(curve);
    // Many coincide: later ones lie over earlier ones and must let them through.
    let style = [Style::Line, Style::Dashed, Style::Dotted, Style::Dashed][index % 4];
    let points = curve.points.iter().map(|p| (p.degrees(), p.value.value)).collect();
    Series { colour: Some(index), ..Series::new(label(curve), style, points) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::albedo::{AlbedoSubject, albedo_curves};
    use crate::kernel::exact::cs_16_factor_exact;
    use crate::kernel::factor::cs_16_factor_printed;
    use crate::kernel::model::Model;

    #[test]
    fn a_panel_a_use_and_the_largest_in_the_title() {
        let curves = albedo_curves(&AlbedoSubject::all(), &[16.0, 64.0], &[0.0, 30.0, 90.0]).unwrap();
        let figures = albedos(&curves).unwrap();
        let Chart::Panels(panels) = &figures[1].chart else { panic!("panels") };
        assert_eq!((figures.len(), panels.charts.len()), (3, 8));
        assert!(panels.charts.iter().all(|c| c.series.len() == DRAWN.len() && c.series[0].points.len() == 3));
        // 1.068 n + 0.96 at n = 64, the worst of the printed factors, over the exact one.
        let gain = cs_16_factor_printed(Model::BlinnPhong).at(64.0_f64)
            / cs_16_factor_exact(Model::BlinnPhong, 64.0_f64);
        assert!(panels.title.ends_with(&format!("{gain:.4}")), "{}", panels.title);
        let Chart::Panels(differences) = &figures[2].chart else { panic!("panels") };
        assert!(differences.charts.len() == 8 && differences.charts.iter().all(|c| c.series.len() == 3));
        assert_eq!(albedos(&curves[..0]).unwrap_err(), FigureError::NoLines);
    }
}
