//! The fields of the kinds about pixels.

use super::fields::{Fields, Problem};
use super::pixel_kind::{ClipFormula, PixelKind, WeightFormula};
use super::pixel_words::{
    AxesProperty, Base, BellFigure, ClipProperty, ConstantTerm, Denominator, Octant, Region, RimShare, Shape,
    Sign, SignPair, Vectors, WeightFigure, WeightProperty, pixels,
};
use crate::bound::ClippedPixel;
use crate::integral::Field;
use crate::kernel::pixel::{PaperReading, TiltFormula};
use dashu_ratio::RBig;

/// Powers that (8) is looked at with.
const POWERS: [u32; 6] = [2, 4, 8, 16, 32, 64];
/// Fewer points than unknowns fit nothing; more than this take long.
const POINTS: core::ops::RangeInclusive<u32> = 3..=1001;

impl Fields<'_> {
    /// The kind, if it is one of these.
    pub(super) fn pixel_kind(&mut self, kind: &str) -> Result<Option<PixelKind>, Problem> {
        Ok(Some(match kind {
            "derivatives-agree" => PixelKind::DerivativesAgree {
                denominator: self.one_of("denominator", Denominator::ALL, Denominator::id)?,
            },
            "conic" => PixelKind::Conic {
                sign: self.sign("sign")?,
                inner: self.sign("inner")?,
                base: self.one_of("base", Base::ALL, Base::id)?,
            },
            "gaussian-volume" => {
                PixelKind::GaussianVolume { divisor: self.divisor()?, region: self.region()? }
            }
            "gaussian-beyond-base" => {
                PixelKind::GaussianBeyondBase { divisor: self.divisor()?, place: self.needed("place")?.0 }
            }
            "rotation" => PixelKind::Rotation {
                sign: self.sign("sign")?,
                second: self.one_of("second", SignPair::ALL, SignPair::id)?,
            },
            "tilt" => PixelKind::Tilt {
                formula: self.one_of("tilt", &TiltFormula::ALL, |tilt| match tilt {
                    TiltFormula::Vector => "vector",
                    TiltFormula::Conic => "conic",
                })?,
                octant: self.one_of("octant", Octant::ALL, Octant::id)?,
                vectors: self.vectors()?,
            },
            "axis-formula" => PixelKind::AxisFormula { sign: self.sign("sign")? },
            "axes" => PixelKind::AxesAre {
                property: self.one_of("property", AxesProperty::ALL, AxesProperty::id)?,
                vectors: self.vectors()?,
            },
            "bell-number" => {
                let (power, exponent) = self.bell()?;
                let figure = self.one_of("figure", BellFigure::ALL, BellFigure::id)?;
                PixelKind::BellNumber { power, exponent, figure, place: self.needed("place")?.0 }
            }
            "bell-is-nearest" => {
                let (power, exponent) = self.bell()?;
                PixelKind::BellIsNearest { power, exponent }
            }
            "bell-uncut" => {
                let (power, exponent) = self.bell()?;
                PixelKind::BellUncut { power, exponent }
            }
            "weight-number" => PixelKind::WeightNumber {
                weight: self.weight()?,
                figure: self.one_of("figure", WeightFigure::ALL, WeightFigure::id)?,
                region: self.region()?,
                place: self.needed("place")?.0,
            },
            "weight-on-rim" => {
                PixelKind::WeightOnRim { weight: self.weight()?, place: self.needed("place")?.0 }
            }
            "weight" => PixelKind::WeightHas {
                weight: self.weight()?,
                property: self.one_of("property", WeightProperty::ALL, WeightProperty::id)?,
            },
            "weight-is-nearest" => {
                PixelKind::WeightIsNearest { weight: self.weight()?, region: self.region()? }
            }
            "clipped-volume" => PixelKind::ClipHas {
                formula: self.clip_formula()?,
                property: self.one_of("property", ClipProperty::ALL, ClipProperty::id)?,
            },
            "clipped-volume-distance" => PixelKind::ClipDistance {
                formula: self.clip_formula()?,
                pixel: self.pixel()?,
                place: self.needed("place")?.0,
            },
            "clipped-volume-fit" => PixelKind::ClipFit {
                formula: self.clip_formula()?,
                pixel: self.pixel()?,
                points: self.points()?,
                constant: self.one_of("constant-term", ConstantTerm::ALL, ConstantTerm::id)?,
            },
            "rim-texel" => PixelKind::RimTexel { share: self.one_of("share", RimShare::ALL, RimShare::id)? },
            "rim-volume" => PixelKind::RimVolume { formula: self.clip_formula()? },
            _ => return Ok(None),
        }))
    }

    fn sign(&mut self, key: &'static str) -> Result<Sign, Problem> {
        self.one_of(key, Sign::ALL, Sign::id)
    }

    fn region(&mut self) -> Result<Region, Problem> {
        self.one_of("region", Region::ALL, Region::id)
    }

    fn vectors(&mut self) -> Result<Vectors, Problem> {
        self.one_of("vectors", Vectors::ALL, Vectors::id)
    }

    fn weight(&mut self) -> Result<WeightFormula, Problem> {
        let id = |reading| match reading {
            PaperReading::R1 => "R1",
            PaperReading::R2 => "R2",
            PaperReading::R3 => "R3",
            PaperReading::R4 => "R4",
        };
        Ok(WeightFormula {
            reading: self.one_of("weight", &PaperReading::ALL, id)?,
            shape: self.one_of("shape", Shape::ALL, Shape::id)?,
            divisor: self.divisor()?,
        })
    }

    /// A positive number of reasonable size.
    fn divisor(&mut self) -> Result<super::Printed, Problem> {
        let at = self.needed("divisor")?.1;
        let divisor = self.printed_needed("divisor")?;
        if divisor.value >= RBig::int(1) && divisor.value <= RBig::int(16) {
            Ok(divisor)
        } else {
            Err((at, format!("`divisor` is \"{}\"; σ is an axis by 1 to 16", divisor.text)))
        }
    }

    fn pixel(&mut self) -> Result<ClippedPixel, Problem> {
        let known = pixels().map(|(id, _)| id).join(", ");
        let read = |word: &str| pixels().into_iter().find(|(id, _)| *id == word).map(|(_, pixel)| pixel);
        self.word("pixel", read, &known)
    }

    fn points(&mut self) -> Result<u32, Problem> {
        let read = |word: &str| word.parse().ok().filter(|n| POINTS.contains(n));
        self.word("points", read, "whole numbers from 3 to 1001")
    }

    /// K and n of (8).
    fn bell(&mut self) -> Result<(u32, u32), Problem> {
        let read = |word: &str| word.parse().ok().filter(|k| POWERS.contains(k));
        let power = self.word("power", read, "2, 4, 8, 16, 32, 64")?;
        let read = |word: &str| word.parse().ok().filter(|n| (1..=1024).contains(n));
        let exponent = self.word("exponent", read, "whole numbers from 1 to 1024")?;
        Ok((power, exponent))
    }

    fn clip_formula(&mut self) -> Result<ClipFormula, Problem> {
        Ok(ClipFormula {
            constant: self.printed_needed("constant")?,
            linear: self.printed_needed("linear")?,
            square: self.printed_needed("square")?,
            sign: self.sign("sign")?,
            inner: self.sign("inner")?,
        })
    }
}
