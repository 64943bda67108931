//! The judge: one verdict a reading, by its kind alone.

use super::NormalisationFinding;
use super::judgement::{Evidence, Finding, Judgement, Verdict};
use super::{albedo, algebra, lobes, normalisation, pixel};
use crate::bound::{DifferenceExtreme, Extremes, Fixed, Formula, Gaussian, Interval};
use crate::fit::FitError;
use crate::integral::{Case, Limit};
use crate::paper::{ClaimsFile, Kind, Over};
use std::collections::BTreeMap;

/// What comes of one reading.
type Found = (Finding, Option<Evidence>, Option<Box<NormalisationFinding>>);

/// First and last n.
type Range = (u32, u32);

/// Judges claims, computing what several readings share only once.
#[derive(Debug, Default)]
pub struct Judge {
    pub(super) differences: BTreeMap<(Limit, Range), DifferenceExtreme>,
    pub(super) gaussians: BTreeMap<(Gaussian, Range), (Interval, f64)>,
    pub(super) scaled: BTreeMap<(Case, Range), Vec<Fixed>>,
    pub(super) below_16: BTreeMap<String, String>,
    pub(super) residuals: Vec<(Case, Formula, Range, Over, Extremes)>,
}

impl Judge {
    /// One judgement a reading, in the file's order.
    ///
    /// # Errors
    /// [`FitError`] when a fit that a claim is about cannot be made.
    ///
    /// ```
    /// use bellfit::{paper::ClaimsFile, verdict::{Judge, Verdict}};
    /// let file = ClaimsFile::parse(r#"
    ///     version = 1
    ///     [[claim]]
    ///     id = "mine"
    ///     paper = "my shader"
    ///     locator = "line 12"
    ///     text = "cos^n is normalised by (n + 1)/2π"
    ///     [[claim.reading]]
    ///     id = "exact"
    ///     kind = "factor-identity"
    ///     model = "phong"
    ///     factor = "(n + 1)/(2*pi)"
    /// "#).map_err(|e| e.to_string())?;
    /// let judged = Judge::default().judge(&file).map_err(|e| e.to_string())?;
    /// assert_eq!(judged[0].verdict, Verdict::Proved);
    /// # Ok::<(), String>(())
    /// ```
    pub fn judge(&mut self, file: &ClaimsFile) -> Result<Vec<Judgement>, FitError> {
        let mut judgements = Vec::new();
        for claim in &file.claims {
            for reading in &claim.readings {
                let (found, evidence, normalisation) = self.find(&reading.kind)?;
                let Finding { printed, computed, verdict, witness } = found;
                judgements.push(Judgement {
                    claim: claim.id.clone(),
                    paper: claim.paper.clone(),
                    locator: claim.locator.clone(),
                    reading: reading.id.clone(),
                    kind: reading.kind.id(),
                    printed,
                    computed,
                    evidence,
                    verdict,
                    witness,
                    normalisation,
                });
            }
        }
        Ok(judgements)
    }

    /// What comes of it, and how strong that is: only what there is nothing to judge about has no strength. Of
    /// one's own constants also the parts.
    fn find(&mut self, kind: &Kind) -> Result<Found, FitError> {
        let certified = match kind {
            Kind::Definition { place } => {
                let (printed, witness, verdict) = (String::new(), place.clone(), Verdict::Definition);
                return Ok((Finding { printed, computed: None, verdict, witness }, None, None));
            }
            Kind::EnergyAtEveryAngle { reflectance, lobe, factor, n } => {
                let found = albedo::energy_at_every_angle(*reflectance, *lobe, factor, *n);
                return Ok((found, Some(Evidence::Estimated), None));
            }
            Kind::FactorResidual { case, factor, n, over, statistic, relation, printed, place, .. } => {
                let of = (*case, factor, *n, *over);
                let mut found = self.factor_residual(of, *statistic, *relation, printed.as_ref());
                if let Some(place) = place {
                    found.witness = format!("{}; {place}", found.witness);
                }
                found
            }
            Kind::Normalisation(claim) => {
                let (found, parts) = normalisation::normalisation(claim)?;
                return Ok((found, Some(Evidence::Certified), Some(Box::new(parts))));
            }
            Kind::Energy { case, factor, n, over } => self.energy(*case, factor, *n, *over),
            Kind::LobeDifference { cut, n, statistic, relation, printed } => {
                self.lobe_difference(*cut, *n, *statistic, *relation, printed)
            }
            Kind::Cut { form, n, printed } => lobes::cut(*form, *n, printed),
            Kind::CutEffect { cut, n, comparison } => self.cut_effect(*cut, *n, *comparison),
            Kind::LobeZero { zero } => algebra::lobe_zero(zero),
            Kind::FactorIdentity { model, factor, .. } => algebra::factor_identity(*model, factor),
            Kind::FactorInequality { lower, upper, from } => algebra::factor_inequality(lower, upper, *from),
            Kind::SameIntegral { model, other } => algebra::same_integral(*model, *other),
            Kind::Fit { case, objective, form, n, a, b } => {
                self.fit(*case, (*objective, *form), *n, (a, b.as_ref()))?
            }
            Kind::GaussianFalls { gaussian, n } => self.gaussian_falls(*gaussian, *n),
            Kind::GaussianBeatsLobe { gaussian, n } => self.gaussian_beats_lobe(*gaussian, *n),
            Kind::BellFalls { powers } => lobes::bell_falls(powers),
            Kind::Pixel(kind) => pixel::judge(kind),
        };
        Ok((certified, Some(Evidence::Certified), None))
    }
}
