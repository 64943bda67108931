//! Files that say what a whole scene needs.

use super::{
    ANGLE_WORDS, ENERGY_ERROR, ENERGY_WORDS, EnergyDemand, Exponents, FLOOR, Need, NeedError, Shape, Surface,
    energy_from_word, handed_from_word,
};
use crate::bound::{Format, Measure};
use crate::kernel::model::Model;
use crate::kernel::pixel::Jacobian;
use crate::scene::{Places, SceneFileError};
use serde::Deserialize;
use toml::Spanned;

/// The schema this version reads.
const VERSION: u32 = 1;

/// A commented file to start from.
pub const EXAMPLE_NEEDS: &str = include_str!("example.toml");

/// A material of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// What it asks of a kernel.
    pub need: Need,
}

/// What a scene needs.
///
/// ```
/// use bellfit::choose::{EXAMPLE_NEEDS, SceneNeeds};
/// let scene = SceneNeeds::parse(EXAMPLE_NEEDS)?;
/// assert_eq!((scene.materials.len(), scene.surfaces.len()), (3, 4));
/// let wrong = EXAMPLE_NEEDS.replacen("f32", "f31", 1);
/// let error = SceneNeeds::parse(&wrong).expect_err("no such format").to_string();
/// assert!(error.starts_with("line ") && error.contains("unknown float \"f31\""), "{error}");
/// # Ok::<(), bellfit::scene::SceneFileError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SceneNeeds {
    /// The most that a lobe's value may cost: operations, or nanoseconds where they are measured.
    pub most_cost: Option<f64>,
    /// The lobes.
    pub materials: Vec<Material>,
    /// The textures.
    pub surfaces: Vec<Surface>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile {
    version: Spanned<u32>,
    budget: RawBudget,
    #[serde(default)]
    material: Vec<RawMaterial>,
    #[serde(default)]
    surface: Vec<RawSurface>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawBudget {
    max_error: Spanned<f64>,
    cost: Option<Spanned<f64>>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "a number or a pair [from, to] of numbers is needed")]
enum RawRange {
    One(f64),
    Two([f64; 2]),
}

impl RawRange {
    fn ends(self) -> (f64, f64) {
        match self {
            RawRange::One(x) => (x, x),
            RawRange::Two([from, to]) => (from, to),
        }
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawMaterial {
    name: Spanned<String>,
    n: Option<Spanned<RawRange>>,
    roughness: Option<Spanned<RawRange>>,
    #[serde(default)]
    whole: bool,
    float: Spanned<String>,
    angle: Option<Spanned<String>>,
    max_error: Option<Spanned<f64>>,
    #[serde(default)]
    relative: bool,
    floor: Option<Spanned<f64>>,
    model: Option<Spanned<String>>,
    energy: Option<Spanned<String>>,
    energy_error: Option<Spanned<f64>>,
    #[serde(default = "yes")]
    division: bool,
    #[serde(default = "yes")]
    transcendental: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawSurface {
    name: Spanned<String>,
    jacobians: Option<Spanned<Vec<[f64; 4]>>>,
    longest: Option<Spanned<f64>>,
    ratio: Option<Spanned<RawRange>>,
    skew: Option<Spanned<f64>>,
    max_error: Option<Spanned<f64>>,
}

fn yes() -> bool {
    true
}

/// Something wrong at a byte of the file.
type Wrong = (usize, String);

impl SceneNeeds {
    /// Reads a file (TOML, `version = 1`).
    ///
    /// # Errors
    /// [`SceneFileError`] for anything unknown, missing, doubled or out of its domain, with its place.
    pub fn parse(text: &str) -> Result<Self, SceneFileError> {
        let places = Places(text);
        let raw: RawFile = toml::from_str(text).map_err(|error| places.of_toml(&error))?;
        raw.needs().map_err(|(at, message)| places.error(at, message))
    }
}

impl RawFile {
    fn needs(self) -> Result<SceneNeeds, Wrong> {
        if *self.version.get_ref() != VERSION {
            let message = format!("version {}: this program reads {VERSION}", self.version.get_ref());
            return Err((self.version.span().start, message));
        }
        let allowed = error(&self.budget.max_error)?;
        let most_cost = match &self.budget.cost {
            Some(cost) if !(*cost.get_ref() > 0.0 && cost.get_ref().is_finite()) => {
                return Err((
                    cost.span().start,
                    format!("cost {}: a positive number is needed", cost.get_ref()),
                ));
            }
            cost => cost.as_ref().map(|cost| *cost.get_ref()),
        };
        if self.material.is_empty() && self.surface.is_empty() {
            return Err((self.version.span().start, "neither a [[material]] nor a [[surface]]".to_owned()));
        }
        let mut names: Vec<&Spanned<String>> = Vec::new();
        for name in self.material.iter().map(|m| &m.name).chain(self.surface.iter().map(|s| &s.name)) {
            if name.get_ref().trim().is_empty() || name.get_ref().contains(char::is_control) {
                return Err((name.span().start, "a name of printable characters is needed".to_owned()));
            }
            if names.iter().any(|known| known.get_ref() == name.get_ref()) {
                return Err((name.span().start, format!("the name \"{}\" twice", name.get_ref())));
            }
            names.push(name);
        }
        let materials = self.material.iter().map(|raw| raw.material(allowed)).collect::<Result<_, _>>()?;
        let surfaces = self.surface.iter().map(|raw| raw.surface(allowed)).collect::<Result<_, _>>()?;
        Ok(SceneNeeds { most_cost, materials, surfaces })
    }
}

/// A colour's or a lobe's error, in (0, 1].
fn error(value: &Spanned<f64>) -> Result<f64, Wrong> {
    let x = *value.get_ref();
    if x > 0.0 && x <= 1.0 {
        return Ok(x);
    }
    Err((value.span().start, format!("error {x}: more than 0 and at most 1 is needed")))
}

/// The word's meaning, or the words there are.
fn word<T>(
    given: &Spanned<String>,
    what: &str,
    found: Option<T>,
    known: impl IntoIterator<Item = &'static str>,
) -> Result<T, Wrong> {
    let known = || known.into_iter().collect::<Vec<_>>().join(", ");
    found.ok_or_else(|| {
        (given.span().start, format!("unknown {what} \"{}\": known are {}", given.get_ref(), known()))
    })
}

impl RawMaterial {
    fn exponents(&self) -> Result<Exponents, Wrong> {
        let at = |range: &Spanned<RawRange>| range.span().start;
        let said = |range: &Spanned<RawRange>, error: NeedError| (at(range), error.to_string());
        let range = match (&self.n, &self.roughness) {
            (Some(n), None) => {
                let (from, to) = n.get_ref().ends();
                Exponents::new(from, to).map_err(|e| said(n, e))?
            }
            (None, Some(roughness)) => {
                let (from, to) = roughness.get_ref().ends();
                Exponents::of_roughness(from, to).map_err(|e| said(roughness, e))?
            }
            (Some(_), Some(roughness)) => {
                return Err((at(roughness), "n and roughness: one of the two is needed".to_owned()));
            }
            (None, None) => {
                let message = format!("material \"{}\" needs n or roughness", self.name.get_ref());
                return Err((self.name.span().start, message));
            }
        };
        if !self.whole {
            return Ok(range);
        }
        let message = || (self.name.span().start, NeedError::NoWhole { range }.to_string());
        range.whole_only().ok_or_else(message)
    }

    fn material(&self, allowed: f64) -> Result<Material, Wrong> {
        let formats = Format::ALL.map(Format::id);
        let mut need = Need::new(self.exponents()?, self.max_error.as_ref().map_or(Ok(allowed), error)?);
        need.format = word(&self.float, "float", Format::from_id(self.float.get_ref()), formats)?;
        if let Some(angle) = &self.angle {
            need.handed = word(angle, "angle", handed_from_word(angle.get_ref()), ANGLE_WORDS)?;
        }
        match &self.floor {
            Some(floor) if !self.relative => {
                return Err((floor.span().start, "floor: of no use without relative = true".to_owned()));
            }
            Some(floor) if !(1e-300..1.0).contains(floor.get_ref()) => {
                let value = *floor.get_ref();
                return Err((floor.span().start, NeedError::Floor { value }.to_string()));
            }
            floor if self.relative => {
                need.measure = Measure::Relative { floor: floor.as_ref().map_or(FLOOR, |f| *f.get_ref()) };
            }
            _ => {}
        }
        if let Some(model) = &self.model {
            need.model =
                Some(word(model, "model", Model::from_id(model.get_ref()), Model::ALL.map(Model::id))?);
        }
        let energy_error = self.energy_error.as_ref().map(error).transpose()?;
        if let Some(energy) = &self.energy {
            let demand = energy_from_word(energy.get_ref(), energy_error.unwrap_or(ENERGY_ERROR));
            let demand = word(energy, "energy", demand, ENERGY_WORDS)?;
            if need.model.is_none() {
                return Err((energy.span().start, NeedError::NoModel { energy: demand.id() }.to_string()));
            }
            need.energy = Some(demand);
        }
        if let Some(given) = &self.energy_error
            && !matches!(need.energy, Some(EnergyDemand::Unbiased { .. }))
        {
            return Err((
                given.span().start,
                "energy_error: of no use without energy = \"unbiased\"".to_owned(),
            ));
        }
        (need.division, need.transcendental) = (self.division, self.transcendental);
        Ok(Material { name: self.name.get_ref().clone(), need })
    }
}

impl RawSurface {
    fn surface(&self, allowed: f64) -> Result<Surface, Wrong> {
        let max_error = self.max_error.as_ref().map_or(Ok(allowed), error)?;
        Ok(Surface { name: self.name.get_ref().clone(), shape: self.shape()?, max_error })
    }

    fn shape(&self) -> Result<Shape, Wrong> {
        let name_at = self.name.span().start;
        match (&self.jacobians, &self.longest, &self.ratio, &self.skew) {
            (Some(list), None, None, None) => {
                let jacobians: Vec<Jacobian<f64>> =
                    list.get_ref().iter().map(|&[ux, vx, uy, vy]| Jacobian { ux, vx, uy, vy }).collect();
                Shape::of(&jacobians).ok_or_else(|| {
                    let message =
                        "jacobians: at least one [ux, vx, uy, vy], each finite and with an area, is needed";
                    (list.span().start, message.to_owned())
                })
            }
            (None, Some(longest), Some(ratio), Some(skew)) => {
                let ((from, to), degrees) = (ratio.get_ref().ends(), *skew.get_ref());
                if !(*longest.get_ref() > 0.0 && longest.get_ref().is_finite()) {
                    let message = format!("longest {}: a positive length is needed", longest.get_ref());
                    return Err((longest.span().start, message));
                }
                if !(1e-9 <= from && from <= to && to <= 1e9) {
                    let message = format!("ratio {from}..{to}: 1e-9 ≤ from ≤ to ≤ 1e9 is needed");
                    return Err((ratio.span().start, message));
                }
                if !(0.0..=89.0).contains(&degrees) {
                    return Err((skew.span().start, format!("skew {degrees}: 0 to 89 degrees are needed")));
                }
                let skew = degrees * (core::f64::consts::PI / 180.0);
                Ok(Shape { longest: *longest.get_ref(), ratio: (from, to), skew })
            }
            _ => {
                let message = format!(
                    "surface \"{}\" needs jacobians, or longest, ratio and skew",
                    self.name.get_ref()
                );
                Err((name_at, message))
            }
        }
    }
}
