//! The figures of the report: what the papers draw, and what shows where their numbers hold.
//!
//! Every value comes from the kernels, the integrals and the enclosures; here they are only sampled.
//!
//! ```
//! use bellfit::report::figures::{ResidualLine, figures, render};
//! use bellfit::{fit::Line, integral::{Case, Limit, Lobe}, kernel::model::Model};
//!
//! let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
//! let line = Line::new("1.063", "0", "2").expect("decimals");
//! let printed = ResidualLine { case, label: "printed".into(), line, printed_bound: Some(4.7e-4) };
//! let drawn = figures(&[printed])?;
//! let files = render(&drawn[..1])?;
//! assert_eq!((files[0].0.as_str(), files[1].0.as_str()), ("lobes-128.svg", "lobes-128.png"));
//! # Ok::<(), bellfit::report::figures::FigureError>(())
//! ```

mod albedo;
mod bell;
mod cut;
mod difference;
mod error;
mod factor;
mod gaussian;
mod integral;
mod kernel;
mod lobe;
mod pixel;
mod place;
mod render;
mod residual;
mod sample;
mod stability;

pub use albedo::albedo_degrees;
pub use error::FigureError;
pub use pixel::{Pixel, pixel};
pub use render::render;
pub use stability::stability;

pub(in crate::report) use place::{Shown, data};

use super::chart::Chart;
use crate::fit::bell::{CosineBell, ExponentialBell};
use crate::fit::{FactorRow, Line};
use crate::integral::Case;
use crate::integral::albedo::AlbedoCurve;

/// One figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The files' name without its ending.
    pub stem: &'static str,
    /// The message in one sentence, for those who do not see the picture.
    pub alt: String,
    /// The picture.
    pub chart: Chart,
}

/// A factor whose residual is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct ResidualLine {
    /// The integral that it is held against; lobes other than cs_16 serve too.
    pub case: Case,
    /// The text in the legend, one colour a label; of neighbouring labels the second is dashed, so
    /// that both are seen where they coincide.
    pub label: String,
    /// The factor.
    pub line: Line,
    /// The largest residual that is printed for it, if one is.
    pub printed_bound: Option<f64>,
}

/// The figures of what the papers state, in the report's order; `residuals` are the lines of the figure
/// of that name, a panel a model.
///
/// # Errors
///
/// [`FigureError`] without any line of residuals.
pub fn figures(residuals: &[ResidualLine]) -> Result<Vec<Figure>, FigureError> {
    let highest = difference::highest();
    Ok(vec![
        lobe::lobes(),
        difference::curves(&highest)?,
        difference::map(&highest)?,
        cut::cuts(),
        residual::residuals(residuals)?,
        integral::integrals(),
        gaussian::distances(),
        gaussian::curves(),
        bell::bells(),
    ])
}

/// What the figures of better factors and bells draw.
#[derive(Clone, Copy, Debug)]
pub struct Better<'a> {
    /// Factors of cs_16 by form and objective.
    pub factors: &'a [FactorRow],
    /// Bells for e⁻ᵗ.
    pub exponential: &'a [ExponentialBell],
    /// Bells for cosⁿ.
    pub cosine: &'a [CosineBell],
    /// Albedo curves of n = 16 and 64.
    pub albedos: &'a [AlbedoCurve],
}

/// The figures of better factors and bells, in the report's order.
///
/// # Errors
///
/// [`FigureError`] without factors on the papers' range, or albedo curves of an exponent drawn.
pub fn better(drawn: Better) -> Result<Vec<Figure>, FigureError> {
    let mut figures = vec![
        factor::factors(drawn.factors)?,
        kernel::frontier(drawn.exponential, drawn.cosine),
        kernel::over_n(),
        kernel::equioscillation(drawn.exponential),
    ];
    figures.extend(albedo::albedos(drawn.albedos)?);
    Ok(figures)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::bell::{cosine_bells, exponential_bells};
    use crate::fit::clip::clip_rows;
    use crate::fit::{factor_rows, figure_weights, weight_rows};
    use crate::integral::albedo::{AlbedoSubject, albedo_curves};
    use crate::integral::{Limit, Lobe};
    use crate::kernel::model::Model;
    use std::collections::BTreeSet;

    fn lines() -> Vec<ResidualLine> {
        let line = |model, limit, label: &str, a| ResidualLine {
            case: Case { model, lobe: Lobe::Cs16, limit },
            label: label.into(),
            line: Line::new(a, "1", "2").unwrap(),
            printed_bound: (model != Model::BlinnPhongNdf).then_some(1e-3),
        };
        let of = |model| {
            [line(model, Limit::Paper, "printed", "1.063"), line(model, Limit::Support, "fit", "1.0625")]
        };
        Model::ALL.into_iter().flat_map(of).collect()
    }

    /// Real rows: figures of made-up ones would show nothing.
    fn better_figures() -> Vec<Figure> {
        let cases = Model::ALL.map(|model| Case { model, lobe: Lobe::Cs16, limit: Limit::Support });
        let subjects = AlbedoSubject::all();
        let drawn = Better {
            factors: &factor_rows(&cases, "16..1024".parse().unwrap()).unwrap(),
            exponential: &exponential_bells().unwrap(),
            cosine: &cosine_bells().unwrap(),
            albedos: &albedo_curves(&subjects, &[16.0, 64.0], &[0.0, 45.0, 90.0]).unwrap(),
        };
        assert!(better(Better { factors: &[], ..drawn }).is_err());
        assert!(better(Better { albedos: &[], ..drawn }).is_err());
        better(drawn).unwrap()
    }

    fn pixel_figures() -> Vec<Figure> {
        let (clip, weights, texels) = (clip_rows(), weight_rows(), figure_weights());
        pixel(Pixel { clip: &clip, weights: &weights, texels: &texels })
    }

    #[test]
    fn every_figure_has_its_own_name_and_words_and_renders() {
        let mut drawn = figures(&lines()).unwrap();
        drawn.extend(better_figures());
        drawn.extend(pixel_figures());
        drawn.extend(stability(&crate::stability::Stability::run().unwrap()));
        let stems: BTreeSet<_> = drawn.iter().map(|f| f.stem).collect();
        assert_eq!((drawn.len(), stems.len()), (27, 27));
        for figure in &drawn {
            assert!(!data(figure.stem).is_empty(), "{} has no file with its numbers", figure.stem);
            assert!(figure.alt.ends_with('.') && figure.alt.len() > 40, "{}", figure.stem);
        }
        let files = render(&drawn).unwrap();
        let names: Vec<_> = files.iter().map(|(name, _)| name.as_str()).collect();
        let expected: Vec<_> =
            drawn.iter().flat_map(|f| ["svg", "png"].map(|ending| format!("{}.{ending}", f.stem))).collect();
        assert_eq!(names, expected);
        for (name, bytes) in &files {
            let head: &[u8] = if name.ends_with("svg") { b"<svg " } else { b"\x89PNG" };
            assert!(bytes.starts_with(head), "{name}");
            if name.ends_with("svg") {
                let text = String::from_utf8_lossy(bytes);
                let drawn = text.lines().filter(|l| !l.starts_with("<image"));
                assert!(drawn.into_iter().all(|l| !l.contains("NaN") && !l.contains("inf")), "{name}");
            }
        }
    }

    #[test]
    fn the_same_data_give_the_same_bytes() {
        let first = render(&figures(&lines()).unwrap()[1..2]).unwrap();
        let second = render(&figures(&lines()).unwrap()[1..2]).unwrap();
        assert_eq!(first, second);
    }

    #[test]
    fn without_lines_there_is_no_figure_of_them() {
        assert_eq!(figures(&[]).unwrap_err(), FigureError::NoLines);
    }
}
