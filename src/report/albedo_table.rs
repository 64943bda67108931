//! The tables of directional albedo, `fits/albedo.csv` and `fits/albedo-suprema.csv`.

use super::artifacts::ArtifactError;
use super::tables::csv_bytes;
use crate::integral::albedo::{AlbedoCurve, SupremumEvidence};
use serde::Serialize;

/// The angles of incidence in the tables, in degrees: every fifth, and one more where grazing light
/// changes fastest.
pub(super) const ALBEDO_DEGREES: [f64; 20] = [
    0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0,
    89.0, 90.0,
];

/// The exponents in the tables.
pub(super) const ALBEDO_EXPONENTS: [f64; 4] = [16.0, 64.0, 256.0, 1024.0];

#[derive(Serialize)]
struct PointLine<'a> {
    model: &'static str,
    #[serde(rename = "use")]
    usage: &'static str,
    lobe: &'a str,
    factor: &'a str,
    n: String,
    /// Degrees from the normal.
    angle: String,
    albedo: f64,
    error: f64,
}

/// `fits/albedo.csv`: a row an angle. At 90° a microfacet model's albedo is its limit.
///
/// # Errors
/// [`ArtifactError::Table`] if the text cannot be made.
pub(super) fn albedo_csv(curves: &[AlbedoCurve]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(curves.iter().flat_map(|curve| {
        curve.points.iter().map(|point| PointLine {
            model: curve.reflectance.model().id(),
            usage: curve.reflectance.usage().id(),
            lobe: &curve.lobe,
            factor: &curve.factor,
            n: curve.n.to_string(),
            angle: point.degrees().to_string(),
            albedo: point.value.value,
            error: point.value.error,
        })
    }))
}

#[derive(Serialize)]
struct SupremumLine<'a> {
    model: &'static str,
    #[serde(rename = "use")]
    usage: &'static str,
    lobe: &'a str,
    factor: &'a str,
    n: String,
    max_albedo: f64,
    /// Degrees from the normal.
    angle: String,
    evidence: &'static str,
    reciprocal: bool,
    error: f64,
    ceiling: f64,
    bounded: bool,
}

/// `fits/albedo-suprema.csv`: a row a curve; `bounded` where a theorem allows no more, and the ceiling that
/// the theorem gives.
///
/// # Errors
/// [`ArtifactError::Table`] if the text cannot be made.
pub(super) fn albedo_suprema_csv(curves: &[AlbedoCurve]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(curves.iter().map(|curve| SupremumLine {
        model: curve.reflectance.model().id(),
        usage: curve.reflectance.usage().id(),
        lobe: &curve.lobe,
        factor: &curve.factor,
        n: curve.n.to_string(),
        max_albedo: curve.supremum.at.value.value,
        angle: curve.supremum.at.degrees().to_string(),
        evidence: curve.supremum.evidence.id(),
        reciprocal: curve.reflectance.is_reciprocal(),
        error: curve.supremum.at.value.error,
        ceiling: curve.supremum.ceiling.value,
        bounded: curve.supremum.evidence == SupremumEvidence::Bounded,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::albedo::{AlbedoSubject, albedo_curves};

    #[test]
    fn the_tables_have_their_columns_and_a_row_each() {
        let curves = albedo_curves(&AlbedoSubject::all(), &[64.0], &[0.0, 90.0]).unwrap();
        let points = String::from_utf8(albedo_csv(&curves).unwrap()).unwrap();
        assert!(
            points.starts_with("model,use,lobe,factor,n,angle,albedo,error\nphong,printed,cos-n,exact,64,0,")
        );
        assert_eq!(points.lines().count(), 1 + 56 * 2);
        assert!(points.contains("\nblinn-phong-heightfield,microfacet,cs16,printed,64,90,1.00107"));
        let suprema = String::from_utf8(albedo_suprema_csv(&curves).unwrap()).unwrap();
        let head = "model,use,lobe,factor,n,max_albedo,angle,evidence,reciprocal,error,ceiling,bounded\n";
        assert!(suprema.starts_with(head), "{suprema}");
        assert_eq!(suprema.lines().count(), 1 + 56);
        assert!(
            suprema.lines().skip(1).all(|line| line.contains(",estimated,") && line.ends_with(",true")),
            "{suprema}"
        );
    }
}
