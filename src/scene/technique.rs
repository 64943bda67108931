//! The texture filters that are compared, by name.

use super::weight::{weight_from_id, weight_sigma};
use crate::filter::{AxesKind, EllipseFilter, Method, Rim};
use crate::kernel::pixel::{Padding, TiltFormula};

/// P4's σ = L/6, in semi-axes.
const THIRD: f32 = 1.0 / 3.0;

/// A filter under one name.
#[derive(Clone, Debug, PartialEq)]
pub struct Technique {
    /// In tables and file names.
    pub id: String,
    /// What the sampler does.
    pub method: Method,
    /// The weight's name, of the elliptical ones.
    pub weight: Option<&'static str>,
    /// Diameter of the pixel's base: 2 pixels, as the conic (2) has it, or 1, as the paper's words have it.
    pub diameter: u8,
}

impl Technique {
    fn plain(id: &str, method: Method) -> Self {
        Technique { id: id.to_owned(), method, weight: None, diameter: 2 }
    }

    fn ellipse(weight: &'static str, sigma: f32) -> Option<Self> {
        let filter = EllipseFilter {
            weight: weight_from_id(weight, sigma)?,
            padding: Padding::Plain,
            axes: AxesKind::True,
            anisotropy: f32::INFINITY,
            rim: Rim::None,
            ..EllipseFilter::default()
        };
        let word = match weight_sigma(filter.weight) {
            Some(0.5) => "-half",
            Some(_) => "-third",
            None => "",
        };
        let (id, method) = (format!("{weight}{word}"), Method::Ellipse(filter));
        Some(Technique { id, method, weight: Some(weight), diameter: 2 })
    }

    /// The same with another filter, its name with a word more.
    fn varied(&self, word: &str, change: impl Fn(&mut EllipseFilter)) -> Self {
        let mut varied = Technique { id: format!("{}-{word}", self.id), ..self.clone() };
        if let Method::Ellipse(filter) = &mut varied.method {
            change(filter);
        }
        varied
    }

    /// All that the tables compare: the weights with the plain conic; padded, with the paper's axes and
    /// with base diameter 1 those few where it shows.
    ///
    /// ```
    /// use bellfit::scene::Technique;
    /// let names: Vec<String> = Technique::all().into_iter().map(|t| t.id).collect();
    /// assert_eq!(names[..4], ["nearest", "bilinear", "trilinear", "gaussian-half"]);
    /// ```
    pub fn all() -> Vec<Technique> {
        let mut all = vec![
            Technique::plain("nearest", Method::Nearest),
            Technique::plain("bilinear", Method::Bilinear),
            Technique::plain("trilinear", Method::Trilinear),
        ];
        let weights = [
            ("gaussian", 0.5),
            ("gaussian", THIRD),
            ("paper-r1", THIRD),
            ("paper-r2", THIRD),
            ("paper-r3", THIRD),
            ("paper-r4", THIRD),
            ("paper-r1-product", THIRD),
            ("paper-r2-product", THIRD),
            ("paper-r3-product", THIRD),
            ("paper-r4-product", THIRD),
            ("box", THIRD),
            ("cubic-4", 0.5),
            ("cubic-4", THIRD),
            ("cubic-8", 0.5),
            ("cubic-8", THIRD),
        ];
        let ellipses: Vec<Technique> =
            weights.iter().filter_map(|&(weight, sigma)| Technique::ellipse(weight, sigma)).collect();
        let named = |id: &str| ellipses.iter().find(|t| t.id == id);
        let mut varied = Vec::new();
        for id in ["gaussian-half", "gaussian-third", "cubic-4-half", "paper-r1", "paper-r2"] {
            varied.extend(named(id).map(|t| t.varied("padded", |f| f.padding = Padding::Padded)));
        }
        for id in ["gaussian-half", "gaussian-third", "paper-r1"] {
            for (word, tilt) in [("vector-tilt", TiltFormula::Vector), ("conic-tilt", TiltFormula::Conic)] {
                varied.extend(named(id).map(|t| t.varied(word, |f| f.axes = AxesKind::Paper(tilt))));
            }
        }
        // Padded, so that what the axes do is not mixed with what thin ellipses miss.
        for (word, tilt) in
            [("padded-vector-tilt", TiltFormula::Vector), ("padded-conic-tilt", TiltFormula::Conic)]
        {
            let change = |f: &mut EllipseFilter| {
                (f.padding, f.axes) = (Padding::Padded, AxesKind::Paper(tilt));
            };
            varied.extend(named("gaussian-half").map(|t| t.varied(word, change)));
        }
        for id in ["gaussian-third", "paper-r1", "paper-r2", "paper-r4"] {
            let narrow = |t: &Technique| Technique { diameter: 1, ..t.varied("diameter-1", |_| ()) };
            varied.extend(named(id).map(narrow));
        }
        all.extend(ellipses);
        all.extend(varied);
        all
    }

    /// The one of this name.
    pub fn from_id(id: &str) -> Option<Technique> {
        Technique::all().into_iter().find(|technique| technique.id == id)
    }

    /// The elliptical filter's parameters, if it is one.
    pub fn filter(&self) -> Option<&EllipseFilter> {
        match &self.method {
            Method::Ellipse(filter) => Some(filter),
            _ => None,
        }
    }

    /// The weight's standard deviation in semi-axes, if it has one.
    pub fn sigma(&self) -> Option<f32> {
        self.filter().and_then(|filter| weight_sigma(filter.weight))
    }
}
