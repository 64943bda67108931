//! What a textured surface does not need of its filter.
//!
//! A filter is a weighted mean of colours in [0, 1], so two filters differ by no more than the total variation
//! between their normalised weights, whatever the texture. Of two Gaussians it is at most √(KL/2), KL
//! the one's relative entropy from the other (Pinsker's inequality), and that is closed:
//! 2 KL = tr(Σ₂⁻¹ Σ₁) - 2 - ln det(Σ₂⁻¹ Σ₁) in the plane. Sums over texels are taken as those integrals, so
//! texels as fine beside the footprint; where it spans no more than one, nothing but 1 is claimed.

use crate::bound::exponential_bell;
use crate::kernel::constants::CUBIC_EXP;
use crate::kernel::pixel::{Jacobian, Skew};

/// What is known of a surface's Jacobians: all of these shapes, and of every size between.
///
/// With the derivative vectors (ux, vx) and (uy, vy) in texels a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// The longest of all the vectors.
    pub longest: f64,
    /// Second vector's length by the first's, from and to.
    pub ratio: (f64, f64),
    /// How far the angle between the two is from a right one at most, radians, below π/2.
    pub skew: f64,
}

impl Shape {
    /// The hull of some Jacobians; `None` of none, and where one is not finite or has a vector of length 0 or
    /// no area.
    ///
    /// ```
    /// use bellfit::{choose::Shape, kernel::pixel::Jacobian};
    /// let j = |ux, vx, uy, vy| Jacobian { ux, vx, uy, vy };
    /// let shape = Shape::of(&[j(2.0, 0.0, 0.0, 1.0), j(0.0, 3.0, 3.0, 0.0)]).expect("an area each");
    /// assert_eq!((shape.longest, shape.ratio), (3.0, (0.5, 1.0)));
    /// assert!(shape.skew < 1e-15);
    /// assert!(Shape::of(&[j(1.0, 1.0, 2.0, 2.0)]).is_none());
    /// ```
    pub fn of(jacobians: &[Jacobian<f64>]) -> Option<Self> {
        let mut shape: Option<Shape> = None;
        for j in jacobians {
            let (first, second) = j.lengths();
            let Skew { angle, ratio } = Skew::of(*j);
            // cos φ without the cancellation of φ - π/2
            let skew = libm::asin(libm::cos(angle).abs());
            let is_area = j.is_finite() && first > 0.0 && second > 0.0 && libm::sin(angle).abs() > 1e-12;
            if !(is_area && ratio.is_finite() && ratio > 0.0) {
                return None;
            }
            let one = Shape { longest: first.max(second), ratio: (ratio, ratio), skew };
            shape = Some(shape.map_or(one, |s| Shape {
                longest: s.longest.max(one.longest),
                ratio: (s.ratio.0.min(ratio), s.ratio.1.max(ratio)),
                skew: s.skew.max(skew),
            }));
        }
        shape
    }

    /// Bound of a colour's difference if the lengths and directions of the derivative vectors are taken for the
    /// ellipse's axes, as the pixel paper does, in place of the conic's.
    ///
    /// With ρ the ratio and c = |cos φ|: M_paper⁻¹ M has the trace 2 + (ρ² - 1) c² and the determinant 1 - c²,
    /// so 2 KL = (ρ² - 1) c² - ln(1 - c²), which rises with ρ and with c: the corner of both bounds all.
    /// Equal vectors: about c/2. Of Gaussians that are not cut. Rounding, 1e-9 of it, is added.
    ///
    /// ```
    /// use bellfit::choose::Shape;
    /// let skewed = Shape { longest: 4.0, ratio: (1.0, 1.0), skew: 0.01 };
    /// assert!((skewed.axes_error() / 0.005 - 1.0).abs() < 1e-3);
    /// assert!(Shape { skew: 0.0, ..skewed }.axes_error() < 1e-14);
    /// ```
    pub fn axes_error(&self) -> f64 {
        let c = self.cosine();
        let squares = self.ratio.1 * self.ratio.1 * c * c;
        pinsker(squares - (c * c + libm::log1p(-c * c)) + 4.0 * f64::EPSILON * c * c)
    }

    /// Bound of a colour's difference if the best round footprint is taken for the ellipse: what trilinear
    /// filtering has at its best. Its pyramid's own steps and tents are not counted.
    ///
    /// For aspect a and the circle with the mean of the squared axes 2 KL = 2 ln((a + 1/a)/2), and a + 1/a =
    /// (ρ + 1/ρ)/|sin φ|: largest at the ratio farthest from 1 and the largest skew. Rounding, 1e-9 of it, is
    /// added.
    ///
    /// ```
    /// use bellfit::choose::Shape;
    /// let shape = Shape { longest: 4.0, ratio: (1.0, 2.0), skew: 0.0 };
    /// assert!((shape.round_error() - libm::sqrt(0.5 * libm::log(1.25))).abs() < 1e-8);
    /// ```
    pub fn round_error(&self) -> f64 {
        let c = self.cosine();
        let squares = |ratio: f64| 0.25 * (ratio - 1.0 / ratio) * (ratio - 1.0 / ratio);
        let most = squares(self.ratio.0).max(squares(self.ratio.1));
        pinsker(libm::log1p(most) - libm::log1p(-c * c))
    }

    /// The largest ratio of the ellipse's axes.
    ///
    /// ```
    /// use bellfit::choose::Shape;
    /// let shape = Shape { longest: 4.0, ratio: (0.25, 2.0), skew: 0.0 };
    /// assert!((shape.aspect() - 4.0).abs() < 1e-14);
    /// ```
    pub fn aspect(&self) -> f64 {
        let c = self.cosine();
        let sum = |ratio: f64| (ratio + 1.0 / ratio) / libm::sqrt((1.0 - c) * (1.0 + c));
        let s = 0.5 * sum(self.ratio.0).max(sum(self.ratio.1)).max(2.0);
        s + libm::sqrt((s - 1.0) * (s + 1.0))
    }

    /// |cos φ| at its largest, rounded up.
    fn cosine(&self) -> f64 {
        (libm::sin(self.skew) + if self.skew > 0.0 { 4.0 * f64::EPSILON } else { 0.0 }).min(1.0)
    }
}

/// √(KL/2) from 2 KL, at most 1, rounded up.
fn pinsker(twice: f64) -> f64 {
    let bound = 0.5 * libm::sqrt(twice.max(0.0)) * (1.0 + 1e-9);
    if bound < 1.0 { bound } else { 1.0 }
}

/// A surface of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Its name.
    pub name: String,
    /// What its Jacobians are.
    pub shape: Shape,
    /// The largest error of a colour in [0, 1].
    pub max_error: f64,
}

/// Something that a filter may do without, with the bound of what that changes in a colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Dispensable {
    /// `pyramid`, `anisotropy`, `axes` or a weight's name.
    pub id: String,
    /// What serves in its place.
    pub instead: &'static str,
    /// Operations of a weight, from t; none for the others.
    pub operations: Option<u32>,
    /// Upper bound of the change in a colour in [0, 1]: of the pyramid against trilinear filtering, else against
    /// the ellipse's Gaussian with texels fine beside it; 1 where no bound is known.
    pub bound: f64,
    /// Whether that is within what the surface allows.
    pub dispensable: bool,
}

/// What a surface needs.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceAnswer {
    /// What was asked.
    pub surface: Surface,
    /// What it may do without, in the order: pyramid, anisotropy, axes.
    pub parts: Vec<Dispensable>,
    /// Weights in place of the Gaussian, cheapest first.
    pub weights: Vec<Dispensable>,
    /// The sum of what is taken: the cheapest weight within what is allowed, and the paper's axes where they are.
    pub together: f64,
}

impl SurfaceAnswer {
    /// The cheapest weight within what is allowed.
    pub fn weight(&self) -> Option<&Dispensable> {
        self.weights.iter().find(|weight| weight.dispensable)
    }

    /// Whether the sum is within what is allowed.
    pub fn together_fits(&self) -> bool {
        self.together <= self.surface.max_error
    }
}

impl Surface {
    /// What it needs, each with its bound.
    ///
    /// ```
    /// use bellfit::choose::{Shape, Surface};
    /// let shape = Shape { longest: 8.0, ratio: (0.2, 0.25), skew: 0.0 };
    /// let answer = Surface { name: "floor".into(), shape, max_error: 0.01 }.answer();
    /// let done_without: Vec<&str> =
    ///     answer.parts.iter().filter(|part| part.dispensable).map(|part| part.id.as_str()).collect();
    /// assert_eq!(done_without, ["axes"]); // at right angles the vectors are the axes
    /// assert_eq!(answer.weight().map(|weight| weight.id.as_str()), Some("cubic-4"));
    /// ```
    pub fn answer(&self) -> SurfaceAnswer {
        let Surface { shape, max_error, .. } = self;
        let part = |id: &str, instead, bound: f64| Dispensable {
            id: id.to_owned(),
            instead,
            operations: None,
            bound,
            dispensable: bound <= *max_error,
        };
        // A level above 0 is read where a vector is longer than a texel. Where none is, a sum has few texels
        // or one, and is no integral.
        let is_fine = shape.longest > 1.0;
        let of_integrals = |bound: f64| if is_fine { bound } else { 1.0 };
        let round = of_integrals(shape.round_error());
        let parts = vec![
            part("pyramid", "bilinear filtering of level 0", if is_fine { 1.0 } else { 0.0 }),
            part("anisotropy", "the round footprint of trilinear filtering", round),
            part("axes", "the lengths of the derivative vectors", of_integrals(shape.axes_error())),
        ];
        let weights: Vec<Dispensable> = weights()
            .into_iter()
            .map(|(id, operations, bound)| Dispensable {
                operations: Some(operations),
                ..part(&id, "in place of the Gaussian", of_integrals(bound))
            })
            .collect();
        let taken = |part: Option<&Dispensable>| part.filter(|p| p.dispensable).map_or(0.0, |p| p.bound);
        let together = taken(parts.last()) + taken(weights.iter().find(|weight| weight.dispensable));
        SurfaceAnswer { surface: self.clone(), parts, weights, together }
    }
}

/// Bells in place of e⁻ᵗ, t = Q/(2σ²): names, operations from t and bounds of the total variation, by
/// operations.
///
/// The plane's area grows like t, so the densities are bell/∫ bell and e⁻ᵗ, and half their distance is at most
/// X = ∫ |bell - e⁻ᵗ| dt. Lyon's bells lie below e⁻ᵗ: X = 1 - K/(K + 1). The cubic ones: X is at most sup · cut +
/// e^(-cut), both enclosed.
fn weights() -> Vec<(String, u32, f64)> {
    let bells = [2, 4, 8, 16, 32, 64].map(|k: u32| {
        // 1 - t/K, the maximum, the squarings
        (format!("bell-{k}"), 2 + k.trailing_zeros(), 1.0 / (f64::from(k) + 1.0))
    });
    let cubics = [2, 4, 8].into_iter().zip(CUBIC_EXP).filter_map(|(k, coefficients)| {
        let (error, proof) = exponential_bell(k, coefficients, None, 1e-8)?;
        let beyond = libm::exp(-proof.cut.lo()) * (1.0 + 1e-12);
        let bound = (error.value.hi() * proof.cut.hi() + beyond) * (1.0 + 1e-12);
        Some((format!("cubic-{k}"), 4 + k.trailing_zeros(), bound))
    });
    let mut all: Vec<(String, u32, f64)> = bells.into_iter().chain(cubics).collect();
    all.sort_by(|a, b| a.1.cmp(&b.1).then(a.2.total_cmp(&b.2)));
    all
}
