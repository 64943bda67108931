//! Scene files: read, and every error told with its place.

use super::{Camera, Pattern, Places, Scene, SceneError, Technique, Transfer};
use crate::filter::Wrap;
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;
use toml::Spanned;

/// The schema this version reads.
const VERSION: u32 = 1;

/// A commented scene file to start from.
pub const EXAMPLE_SCENE: &str = include_str!("example.toml");

/// What is wrong with a scene file, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("line {line}, column {column}: {message}")]
pub struct SceneFileError {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters.
    pub column: usize,
    /// What is wrong, in one line.
    pub message: String,
}

/// A scene file.
///
/// ```
/// use bellfit::scene::{EXAMPLE_SCENE, SceneFile};
/// let file = SceneFile::parse(EXAMPLE_SCENE, "mine", std::path::Path::new("."))?;
/// assert_eq!((file.scene.width, file.techniques.len()), (192, 5));
/// # Ok::<(), bellfit::scene::SceneFileError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    /// The scene.
    pub scene: Scene,
    /// What is to be compared; all if the file names none.
    pub techniques: Vec<Technique>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile {
    version: Spanned<u32>,
    width: Spanned<usize>,
    height: usize,
    techniques: Option<Spanned<Vec<Spanned<String>>>>,
    camera: Spanned<RawCamera>,
    plane: Spanned<RawPlane>,
    texture: RawTexture,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawCamera {
    height: f64,
    pitch: f64,
    #[serde(default)]
    roll: f64,
    field_of_view: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPlane {
    scale: [f64; 2],
    wrap: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawTexture {
    kind: Spanned<String>,
    size: Option<Spanned<usize>>,
    square: Option<Spanned<usize>>,
    frequency: Option<Spanned<f64>>,
    path: Option<Spanned<String>>,
    linear: Option<Spanned<bool>>,
}

impl SceneFile {
    /// Reads a scene file (TOML, `version = 1`); `folder` is where an image's path begins.
    ///
    /// # Errors
    /// [`SceneFileError`] for anything unknown, missing, out of its domain or unreadable, with its place.
    pub fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, SceneFileError> {
        let places = Places(text);
        let place = |at: usize, message: String| places.error(at, message);
        let raw: RawFile = toml::from_str(text).map_err(|error| places.of_toml(&error))?;
        if *raw.version.get_ref() != VERSION {
            let message = format!("version {}: this program reads {VERSION}", raw.version.get_ref());
            return Err(place(raw.version.span().start, message));
        }
        let texture_at = raw.texture.kind.span().start;
        let pattern = raw.texture.pattern(folder).map_err(|(at, message)| place(at, message))?;
        let mut techniques: Vec<Technique> = Vec::new();
        if let Some(list) = raw.techniques.as_ref().filter(|list| list.get_ref().is_empty()) {
            let message = "techniques is empty: leave the line out to have all of them".to_owned();
            return Err(place(list.span().start, message));
        }
        for name in raw.techniques.iter().flat_map(Spanned::get_ref) {
            if techniques.iter().any(|known| known.id == *name.get_ref()) {
                return Err(place(name.span().start, format!("technique \"{}\" twice", name.get_ref())));
            }
            techniques.push(Technique::from_id(name.get_ref()).ok_or_else(|| {
                let known: Vec<String> = Technique::all().into_iter().map(|t| t.id).collect();
                let message =
                    format!("unknown technique \"{}\": known are {}", name.get_ref(), known.join(", "));
                place(name.span().start, message)
            })?);
        }
        if raw.techniques.is_none() {
            techniques = Technique::all();
        }
        let (width_at, camera_at, plane_at) =
            (raw.width.span().start, raw.camera.span().start, raw.plane.span().start);
        let (camera, plane) = (raw.camera.into_inner(), raw.plane.into_inner());
        let wrap = match plane.wrap {
            None => Wrap::Repeat,
            Some(word) => Wrap::from_id(word.get_ref()).ok_or_else(|| {
                let message = format!("unknown wrap \"{}\": repeat, clamp or mirror", word.get_ref());
                place(word.span().start, message)
            })?,
        };
        let RawCamera { height, pitch, roll, field_of_view } = camera;
        let scene = Scene {
            name: name.to_owned(),
            width: raw.width.into_inner(),
            height: raw.height,
            camera: Camera { height, pitch, roll, field_of_view },
            pattern,
            scale: plane.scale,
            wrap,
        };
        scene.check().map_err(|error| {
            let at = match &error {
                SceneError::Size { .. } => width_at,
                SceneError::Number { name, .. } if name.contains("unit of length") => plane_at,
                SceneError::Number { name, .. } if name.contains("camera") || name.contains("view") => {
                    camera_at
                }
                _ => texture_at,
            };
            place(at, error.to_string())
        })?;
        Ok(SceneFile { scene, techniques })
    }
}

impl RawTexture {
    /// What the kind needs, and nothing else.
    fn pattern(self, folder: &Path) -> Result<Pattern, (usize, String)> {
        let at = self.kind.span().start;
        let kind = self.kind.into_inner();
        let takes: &[&str] = match kind.as_str() {
            "checker" => &["size", "square"],
            "zone-plate" => &["size", "frequency"],
            "image" => &["path", "linear"],
            _ => return Err((at, format!("unknown kind \"{kind}\": checker, zone-plate or image"))),
        };
        let given = [
            ("size", self.size.as_ref().map(Spanned::span)),
            ("square", self.square.as_ref().map(Spanned::span)),
            ("frequency", self.frequency.as_ref().map(Spanned::span)),
            ("path", self.path.as_ref().map(Spanned::span)),
            ("linear", self.linear.as_ref().map(Spanned::span)),
        ];
        for (key, span) in given {
            match span {
                Some(span) if !takes.contains(&key) => {
                    return Err((span.start, format!("kind \"{kind}\" has no {key}")));
                }
                None if takes.contains(&key) && key != "linear" => {
                    return Err((at, format!("kind \"{kind}\" needs {key}")));
                }
                _ => {}
            }
        }
        let number = |of: Option<Spanned<usize>>| of.map_or(0, Spanned::into_inner);
        Ok(match kind.as_str() {
            "checker" => Pattern::Checker { size: number(self.size), square: number(self.square) },
            "zone-plate" => Pattern::ZonePlate {
                size: number(self.size),
                frequency: self.frequency.map_or(f64::NAN, Spanned::into_inner),
            },
            _ => Pattern::File {
                path: folder.join(self.path.map_or(String::new(), Spanned::into_inner)),
                transfer: match self.linear.map(Spanned::into_inner) {
                    Some(true) => Transfer::Linear,
                    _ => Transfer::Srgb,
                },
            },
        })
    }
}
