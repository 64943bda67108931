//! The eight uses of a lobe whose directional albedo is asked for.

use super::Profile;
use crate::kernel::model::{Convention, Model};
use crate::kernel::vector::{Vec3, dot, half_vector, reflect, versine_between};

/// How a model's factor and lobe become reflected light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Usage {
    /// As the condition of Table 1 prints it.
    Printed,
    /// As the distribution of normals D of a microfacet model without loss: F = 1, G of V-cavities.
    Microfacet,
}

impl Usage {
    /// Both.
    pub const ALL: [Usage; 2] = [Usage::Printed, Usage::Microfacet];

    /// The name in files and claims.
    pub const fn id(self) -> &'static str {
        match self {
            Usage::Printed => "printed",
            Usage::Microfacet => "microfacet",
        }
    }

    /// The use of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|usage| usage.id() == id)
    }
}

/// A model of Table 1 in one of its uses: what is integrated over the directions L of light, seen
/// from V at the angle θ.
///
/// f_r is the reflectance, D = coef · lobe(N·H), all vectors of length 1, L and V above the surface:
///
/// | use | f_r (N·L) | reciprocal |
/// |---|---|---|
/// | Phong | coef · lobe(R·L) | no |
/// | Phong, modified | coef · lobe(R·L) (N·L) | yes |
/// | Blinn-Phong | coef · lobe(N·H) | no |
/// | Blinn-Phong, modified | coef · lobe(N·H) (N·L) | yes |
/// | NDF, printed | D/(4 V·H), so D dω_h: the share of the printed condition that V sees | no |
/// | heightfield, printed | D (N·H)/(4 V·H), so D (N·H) dω_h | no |
/// | NDF, microfacet | D G/(4 N·V) | yes |
/// | heightfield, microfacet | D G/(4 N·V) | yes |
///
/// R is the mirror direction of V, H the half vector; dω_h = dω/(4 V·H). G = min(1, 2 N·H N·V/V·H,
/// 2 N·H N·L/V·H) belongs to V-cavities.
///
/// Reciprocity, f_r(L, V) = f_r(V, L): R·L, N·H and V·H = L·H do not change when L and V change places,
/// nor do G and (N·L)(N·V). So a row is reciprocal exactly where f_r has no factor 1/(N·L) alone.
///
/// Source: the lobe paper, Table 1; Cook & Torrance, "A reflectance model for computer graphics", 1982,
/// for G and, with F = 1 and today's 4 in place of their π, the microfacet model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reflectance {
    /// [`Model::Phong`].
    Phong,
    /// [`Model::PhongModified`].
    PhongModified,
    /// [`Model::BlinnPhong`].
    BlinnPhong,
    /// [`Model::BlinnPhongModified`].
    BlinnPhongModified,
    /// [`Model::BlinnPhongNdf`] over half vectors, as printed.
    Ndf,
    /// [`Model::BlinnPhongHeightfield`] over half vectors, as printed.
    Heightfield,
    /// [`Model::BlinnPhongNdf`] as a microfacet model's D.
    NdfMicrofacet,
    /// [`Model::BlinnPhongHeightfield`] as a microfacet model's D.
    HeightfieldMicrofacet,
}

impl Reflectance {
    /// All eight, in the tables' order.
    pub const ALL: [Self; 8] = [
        Self::Phong,
        Self::PhongModified,
        Self::BlinnPhong,
        Self::BlinnPhongModified,
        Self::Ndf,
        Self::Heightfield,
        Self::NdfMicrofacet,
        Self::HeightfieldMicrofacet,
    ];

    /// The model whose factor belongs to it.
    pub const fn model(self) -> Model {
        match self {
            Self::Phong => Model::Phong,
            Self::PhongModified => Model::PhongModified,
            Self::BlinnPhong => Model::BlinnPhong,
            Self::BlinnPhongModified => Model::BlinnPhongModified,
            Self::Ndf | Self::NdfMicrofacet => Model::BlinnPhongNdf,
            Self::Heightfield | Self::HeightfieldMicrofacet => Model::BlinnPhongHeightfield,
        }
    }

    /// How it is used.
    pub const fn usage(self) -> Usage {
        match self {
            Self::NdfMicrofacet | Self::HeightfieldMicrofacet => Usage::Microfacet,
            _ => Usage::Printed,
        }
    }

    /// The model's title, and for a distribution of normals what is made of it.
    pub fn title(self) -> String {
        let title = self.model().title();
        match (self.model().convention(), self.usage()) {
            (Convention::Rdf | Convention::RdfCosine, _) => title.to_owned(),
            (_, Usage::Printed) => format!("{title}, as printed"),
            (_, Usage::Microfacet) => format!("{title}, V-cavities"),
        }
    }

    /// The model in that use; `None` for a reflectance, which is no distribution of normals.
    ///
    /// ```
    /// use bellfit::{integral::albedo::{Reflectance, Usage}, kernel::model::Model};
    /// assert_eq!(Reflectance::new(Model::BlinnPhongNdf, Usage::Microfacet), Some(Reflectance::NdfMicrofacet));
    /// assert_eq!(Reflectance::new(Model::Phong, Usage::Microfacet), None);
    /// ```
    pub fn new(model: Model, usage: Usage) -> Option<Self> {
        Self::ALL.into_iter().find(|of| of.model() == model && of.usage() == usage)
    }

    /// Whether f_r(L, V) = f_r(V, L) for all directions: see the table of [`Reflectance`].
    ///
    /// ```
    /// use bellfit::integral::albedo::Reflectance;
    /// assert!(Reflectance::PhongModified.is_reciprocal() && !Reflectance::Phong.is_reciprocal());
    /// ```
    pub const fn is_reciprocal(self) -> bool {
        match self.usage() {
            Usage::Microfacet => true,
            Usage::Printed => matches!(self.model().convention(), Convention::RdfCosine),
        }
    }

    /// Whether the lobe's axis is R; otherwise it is the normal, and the lobe takes H.
    pub(super) const fn is_about_mirror(self) -> bool {
        matches!(self, Self::Phong | Self::PhongModified)
    }

    /// f_r(L, V) with the normal (0, 0, 1), per steradian.
    ///
    /// Through the vectors of [`kernel::vector`](crate::kernel::vector), as a renderer would write it.
    /// Unit vectors; 0 where L or V is not above the surface; NaN in a component: 0 or NaN.
    ///
    /// ```
    /// use bellfit::integral::albedo::{Profile, Reflectance};
    /// use bellfit::kernel::lobe::cos_n_versine;
    /// let lobe = |w| cos_n_versine(w, 2.0);
    /// let lobe = Profile::new(&lobe, 1.0, 2.0)?;
    /// let (l, v) = ([0.6, 0.0, 0.8], [0.0, 0.0, 1.0]);
    /// // R = V here, so R·L = N·L = 0.8.
    /// assert!((Reflectance::Phong.value(&lobe, 1.5, l, v) - 1.5 * 0.8 * 0.8 / 0.8).abs() < 1e-15);
    /// # Ok::<(), bellfit::integral::albedo::AlbedoError>(())
    /// ```
    pub fn value(self, lobe: &Profile<'_>, factor: f64, to_light: Vec3<f64>, to_view: Vec3<f64>) -> f64 {
        let normal = [0.0, 0.0, 1.0];
        let (n_l, n_v) = (dot(normal, to_light), dot(normal, to_view));
        if n_l <= 0.0 || n_v <= 0.0 {
            return 0.0;
        }
        if self.is_about_mirror() {
            let d = factor * lobe.at(versine_between(reflect(to_view, normal), to_light));
            return if self == Self::PhongModified { d } else { d / n_l };
        }
        let Some(half) = half_vector(to_light, to_view) else { return 0.0 };
        let (n_h, v_h) = (dot(normal, half), dot(to_view, half));
        let d = factor * lobe.at(versine_between(normal, half));
        match self {
            Self::BlinnPhongModified => d,
            Self::BlinnPhong => d / n_l,
            Self::Ndf => d / (4.0 * v_h * n_l),
            Self::Heightfield => d * n_h / (4.0 * v_h * n_l),
            _ => {
                let shadowed = (2.0 * n_h * n_v / v_h).min(2.0 * n_h * n_l / v_h).min(1.0);
                d * shadowed / (4.0 * n_l * n_v)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distribution_of_normals_is_titled_by_its_use() {
        for (reflectance, end) in [
            (Reflectance::Phong, "Phong (RDF)"),
            (Reflectance::Ndf, ", as printed"),
            (Reflectance::HeightfieldMicrofacet, ", V-cavities"),
        ] {
            let title = reflectance.title();
            assert!(title.ends_with(end) && title.starts_with(reflectance.model().title()), "{title}");
        }
    }
}
