//! Albedo curves: lobes with their factors, in every use, over the angles of a table.

use super::{
    AlbedoError, DirectionalAlbedo, Profile, Reflectance, Supremum, directional_albedo, supremum_over_angles,
};
use crate::kernel::constants::CUBIC_COS_N;
use crate::kernel::cubic::CubicLobe;
use crate::kernel::exact::cs_16_factor_exact;
use crate::kernel::factor::{cos_n_factor, cs_16_factor_one_sided, cs_16_factor_printed, cubic_factor};
use crate::kernel::lobe::{cos_n_versine, cs_versine};
use crate::kernel::model::Model;
use core::f64::consts::FRAC_PI_2;

/// A lobe of w = 1 - cos and n.
pub type Shape = Box<dyn Fn(f64, f64) -> f64 + Send + Sync>;
/// coef(n) of a model, per steradian.
pub type Factor = Box<dyn Fn(Model, f64) -> f64 + Send + Sync>;

/// Where a lobe ends, in t = n w, at an exponent n.
pub type Support = Box<dyn Fn(f64) -> f64 + Send + Sync>;

/// A lobe with its factors.
pub struct AlbedoSubject {
    /// The lobe's name in tables.
    pub lobe: String,
    /// The factors' name in tables.
    pub factor: String,
    /// The lobe.
    pub shape: Shape,
    /// Where it ends, in t = n w; beyond w = 1, where half vectors end, it is not followed.
    pub support: Support,
    /// The factors.
    pub coefficient: Factor,
}

impl AlbedoSubject {
    /// cosⁿ with its exact factors; the lobe paper's cs_16 with the printed, the exact and the one-sided
    /// ones; and the cubic lobes with theirs.
    ///
    /// ```
    /// use bellfit::integral::albedo::AlbedoSubject;
    /// let names: Vec<_> = AlbedoSubject::all().into_iter().map(|s| format!("{} {}", s.lobe, s.factor)).collect();
    /// assert_eq!(names[..4], ["cos-n exact", "cs16 printed", "cs16 exact", "cs16 one-sided"]);
    /// assert_eq!(names[4..], ["cubic2 one-sided", "cubic4 one-sided", "cubic8 one-sided"]);
    /// ```
    pub fn all() -> Vec<Self> {
        let subject = |lobe: &str, factor: &str, shape: Shape, support: Support, coefficient: Factor| {
            AlbedoSubject { lobe: lobe.to_owned(), factor: factor.to_owned(), shape, support, coefficient }
        };
        let cs_16 = |factor: &str, coefficient: Factor| {
            let shape: Shape = Box::new(|w: f64, n: f64| cs_versine::<16, f64>(w, n));
            subject("cs16", factor, shape, Box::new(|_| 16.0), coefficient)
        };
        vec![
            subject(
                "cos-n",
                "exact",
                Box::new(cos_n_versine::<f64>),
                Box::new(|_| f64::INFINITY),
                Box::new(cos_n_factor),
            ),
            cs_16("printed", Box::new(|model, n| cs_16_factor_printed(model).at(n))),
            cs_16("exact", Box::new(cs_16_factor_exact)),
            cs_16("one-sided", Box::new(|model, n| cs_16_factor_one_sided(model).at(n))),
            Self::cubic::<2>(),
            Self::cubic::<4>(),
            Self::cubic::<8>(),
        ]
    }

    fn cubic<const K: u32>() -> Self {
        let formula = CUBIC_COS_N.into_iter().find(|formula| formula.power == K);
        AlbedoSubject {
            lobe: format!("cubic{K}"),
            factor: "one-sided".to_owned(),
            shape: Box::new(|w, n| CubicLobe::<K, f64>::new(n).at_versine(w)),
            support: Box::new(move |n| formula.map_or(f64::INFINITY, |formula| formula.at(n).0)),
            coefficient: Box::new(cubic_factor::<K, f64>),
        }
    }
}

/// One lobe, factor, use and n over the angles of incidence.
#[derive(Clone, Debug, PartialEq)]
pub struct AlbedoCurve {
    /// The model and its use.
    pub reflectance: Reflectance,
    /// The lobe's name.
    pub lobe: String,
    /// The factor's name.
    pub factor: String,
    /// The exponent.
    pub n: f64,
    /// By angle, rising.
    pub points: Vec<DirectionalAlbedo>,
    /// The largest over all angles.
    pub supremum: Supremum,
}

/// Every use of every subject at every exponent, at the given angles in degrees: by use, then subject,
/// then n.
///
/// # Errors
/// [`AlbedoError`] for what any of them is outside its domain.
///
/// ```
/// use bellfit::integral::albedo::{AlbedoSubject, albedo_curves};
/// let curves = albedo_curves(&AlbedoSubject::all(), &[64.0], &[0.0, 45.0, 90.0])?;
/// assert_eq!(curves.len(), 8 * 7);
/// assert!((curves[0].points[0].value.value - 1.0).abs() < 1e-12); // Phong, cosⁿ, along the normal
/// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
/// ```
pub fn albedo_curves(
    subjects: &[AlbedoSubject],
    exponents: &[f64],
    degrees: &[f64],
) -> Result<Vec<AlbedoCurve>, AlbedoError> {
    let mut curves = Vec::new();
    for reflectance in Reflectance::ALL {
        for subject in subjects {
            for &n in exponents {
                curves.push(curve(reflectance, subject, n, degrees)?);
            }
        }
    }
    Ok(curves)
}

fn curve(
    of: Reflectance,
    subject: &AlbedoSubject,
    n: f64,
    degrees: &[f64],
) -> Result<AlbedoCurve, AlbedoError> {
    let value = |w: f64| (subject.shape)(w, n);
    let lobe = Profile::new(&value, ((subject.support)(n) / n).min(1.0), n)?;
    let factor = (subject.coefficient)(of.model(), n);
    let point = |&degrees: &f64| {
        // 90° is π/2 to the last bit.
        let angle = FRAC_PI_2 * (degrees / 90.0);
        Ok(DirectionalAlbedo { angle, value: directional_albedo(of, &lobe, factor, angle)? })
    };
    Ok(AlbedoCurve {
        reflectance: of,
        lobe: subject.lobe.clone(),
        factor: subject.factor.clone(),
        n,
        points: degrees.iter().map(point).collect::<Result<_, AlbedoError>>()?,
        supremum: supremum_over_angles(of, &lobe, factor)?,
    })
}

impl DirectionalAlbedo {
    /// The angle in degrees, without the conversion's rounding where there is none to state.
    pub fn degrees(&self) -> f64 {
        // To more digits than any search for an angle has.
        libm::round(self.angle / FRAC_PI_2 * 90.0 * 1e8) / 1e8
    }
}
