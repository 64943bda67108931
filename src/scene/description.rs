//! What a scene is made of.

use super::{Camera, Pattern, SceneError};
use crate::filter::Wrap;

/// A textured plane under a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// In tables and file names.
    pub name: String,
    /// Pixels across, 16 to 1024.
    pub width: usize,
    /// Pixels down, 16 to 1024.
    pub height: usize,
    /// Where it is seen from.
    pub camera: Camera,
    /// What lies on the plane.
    pub pattern: Pattern,
    /// Texels a unit of length along X and Y, each above 0: different ones compress the texture.
    pub scale: [f64; 2],
    /// What stands beyond the texture's edges.
    pub wrap: Wrap,
}

/// Names of the built-in scenes.
pub const BUILT_IN: [&str; 3] = ["checker", "zone-plate", "rolled"];

impl Scene {
    /// A built-in scene: `checker` and `zone-plate`, a plane to the horizon; `rolled`, the checker compressed
    /// along one axis and seen with the camera rolled, where the derivative vectors are far from
    /// perpendicular.
    pub fn built_in(name: &str) -> Option<Scene> {
        let plane = Scene {
            name: name.to_owned(),
            width: 192,
            height: 120,
            camera: Camera { height: 1.0, pitch: 14.0, roll: 0.0, field_of_view: 60.0 },
            pattern: Pattern::Checker { size: 256, square: 16 },
            scale: [96.0, 96.0],
            wrap: Wrap::Repeat,
        };
        match name {
            "checker" => Some(plane),
            "zone-plate" => {
                let pattern = Pattern::ZonePlate { size: 256, frequency: 0.25 };
                Some(Scene { pattern, ..plane })
            }
            "rolled" => Some(Scene {
                camera: Camera { height: 1.0, pitch: 24.0, roll: 40.0, field_of_view: 50.0 },
                scale: [80.0, 240.0],
                ..plane
            }),
            _ => None,
        }
    }

    /// Whether every number lies in its domain.
    ///
    /// # Errors
    /// [`SceneError::Size`] or [`SceneError::Number`].
    pub fn check(&self) -> Result<(), SceneError> {
        let side = 16..=1024;
        if !side.contains(&self.width) || !side.contains(&self.height) {
            return Err(SceneError::Size { width: self.width, height: self.height });
        }
        let camera = &self.camera;
        let inside = |name, value: f64, lo: f64, hi: f64, domain| {
            if (lo..=hi).contains(&value) { Ok(()) } else { Err(SceneError::Number { name, value, domain }) }
        };
        inside("camera height", camera.height, 1e-6, 1e6, "1e-6 to 1e6")?;
        inside("camera pitch", camera.pitch, -89.0, 90.0, "-89 to 90 degrees")?;
        inside("camera roll", camera.roll, -360.0, 360.0, "-360 to 360 degrees")?;
        inside("field of view", camera.field_of_view, 0.1, 175.0, "0.1 to 175 degrees")?;
        for scale in self.scale {
            inside("texels a unit of length", scale, 1e-6, 1e6, "1e-6 to 1e6")?;
        }
        match self.pattern {
            Pattern::Checker { size, square } => {
                inside("texture size", size as f64, 1.0, 4096.0, "1 to 4096 texels")?;
                inside("checker square", square as f64, 1.0, size as f64, "1 texel to the texture's size")
            }
            Pattern::ZonePlate { size, frequency } => {
                inside("texture size", size as f64, 1.0, 4096.0, "1 to 4096 texels")?;
                inside("zone plate frequency", frequency, 0.0, 0.5, "0 to 0.5 cycles a texel")
            }
            Pattern::File { .. } => Ok(()),
        }
    }
}
