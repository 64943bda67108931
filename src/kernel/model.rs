//! The six lobes of Table 1, each with what its factor normalises.

/// A row of Table 1 of the lobe paper: a lobe and the condition that its factor coef(n) meets.
///
/// 2π coef(n) ∫ f(cos of [`angle`](Model::angle)) · weight · sin θ dθ = 1 over the hemisphere, weight by
/// [`convention`](Model::convention).
///
/// ```
/// use bellfit::kernel::{factor::cos_n_factor, model::Model};
/// let (n, steps) = (3.0_f64, 1000);
/// let h = std::f64::consts::FRAC_PI_2 / steps as f64;
/// // Midpoint rule for Phong, modified: f = cosⁿθ, weight cos θ.
/// let integral: f64 = (0..steps)
///     .map(|i| (i as f64 + 0.5) * h)
///     .map(|t| h * libm::pow(libm::cos(t), n) * libm::cos(t) * libm::sin(t))
///     .sum();
/// let one = 2.0 * std::f64::consts::PI * cos_n_factor(Model::PhongModified, n) * integral;
/// assert!((one - 1.0).abs() < 1e-5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Model {
    /// ∫ coef (R·V)ⁿ dω = 1.
    Phong,
    /// ∫ coef (R·V)ⁿ (N·L) dω = 1.
    PhongModified,
    /// ∫ coef (N·H)ⁿ dω = 1, V along the normal.
    BlinnPhong,
    /// ∫ coef (N·H)ⁿ (N·L) dω = 1, V along the normal.
    BlinnPhongModified,
    /// ∫ coef (N·H)ⁿ dω_h = 1.
    BlinnPhongNdf,
    /// ∫ coef (N·H)ⁿ (N·H) dω_h = 1.
    BlinnPhongHeightfield,
}

/// What the integral of coef · f runs over, and under which weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Convention {
    /// Reflectance: directions ω of light, no weight.
    Rdf,
    /// Reflectance: directions ω of light, weight N·L, so the albedo itself.
    RdfCosine,
    /// Distribution of normals: half vectors ω_h, no weight.
    Ndf,
    /// Normals over a flat base: half vectors ω_h, weight N·H.
    Heightfield,
}

/// The lobe's own angle in terms of the angle θ (or α) that is integrated over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LobeAngle {
    /// The angle itself: θ between R and V, or α between N and H.
    Full,
    /// θ/2: seen along the normal, N·H = cos(θ/2) where θ is the angle between L and N.
    Half,
}

impl Model {
    /// Every model, in the order of Table 1.
    pub const ALL: [Self; 6] = [
        Self::Phong,
        Self::PhongModified,
        Self::BlinnPhong,
        Self::BlinnPhongModified,
        Self::BlinnPhongNdf,
        Self::BlinnPhongHeightfield,
    ];

    /// The name in files and on the command line.
    ///
    /// ```
    /// use bellfit::kernel::model::Model;
    /// assert_eq!(Model::BlinnPhongNdf.id(), "blinn-phong-ndf");
    /// ```
    #[inline]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Phong => "phong",
            Self::PhongModified => "phong-modified",
            Self::BlinnPhong => "blinn-phong",
            Self::BlinnPhongModified => "blinn-phong-modified",
            Self::BlinnPhongNdf => "blinn-phong-ndf",
            Self::BlinnPhongHeightfield => "blinn-phong-heightfield",
        }
    }

    /// The model with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::kernel::model::Model;
    /// assert_eq!(Model::from_id("phong"), Some(Model::Phong));
    /// assert_eq!(Model::from_id("Phong"), None);
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|model| model.id() == id)
    }

    /// The name as Table 1 prints it.
    ///
    /// ```
    /// use bellfit::kernel::model::Model;
    /// assert_eq!(Model::PhongModified.title(), "Phong (modified) (RDF)");
    /// ```
    #[inline]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Phong => "Phong (RDF)",
            Self::PhongModified => "Phong (modified) (RDF)",
            Self::BlinnPhong => "Blinn-Phong (RDF)",
            Self::BlinnPhongModified => "Blinn-Phong (modified) (RDF)",
            Self::BlinnPhongNdf => "Blinn-Phong (NDF)",
            Self::BlinnPhongHeightfield => "Blinn-Phong (heightfield)",
        }
    }

    /// What the integral runs over, and its weight.
    ///
    /// ```
    /// use bellfit::kernel::model::{Convention, Model};
    /// assert_eq!(Model::PhongModified.convention(), Convention::RdfCosine);
    /// ```
    #[inline]
    pub const fn convention(self) -> Convention {
        match self {
            Self::Phong | Self::BlinnPhong => Convention::Rdf,
            Self::PhongModified | Self::BlinnPhongModified => Convention::RdfCosine,
            Self::BlinnPhongNdf => Convention::Ndf,
            Self::BlinnPhongHeightfield => Convention::Heightfield,
        }
    }

    /// The angle whose cosine the lobe takes.
    ///
    /// ```
    /// use bellfit::kernel::model::{LobeAngle, Model};
    /// assert_eq!(Model::BlinnPhong.angle(), LobeAngle::Half);
    /// ```
    #[inline]
    pub const fn angle(self) -> LobeAngle {
        match self {
            Self::BlinnPhong | Self::BlinnPhongModified => LobeAngle::Half,
            Self::Phong | Self::PhongModified | Self::BlinnPhongNdf | Self::BlinnPhongHeightfield => {
                LobeAngle::Full
            }
        }
    }
}
