//! A textured plane seen by a camera: pictures by every texture filter, a supersampled reference, and how
//! far each picture is from it.
//!
//! All values are linear light in 0..1; [`Image`] decodes and encodes PNG files. Rows are computed on threads
//! that share nothing, so that their number changes no byte.
//!
//! ```
//! use bellfit::scene::{References, Scene, Technique, View};
//! let scene = Scene { width: 48, height: 32, ..Scene::built_in("checker").expect("a built-in scene") };
//! let view = View::new(&scene)?;
//! let references = References::new(&view, 2);
//! let trilinear = Technique::from_id("trilinear").expect("a technique");
//! let picture = view.picture(&trilinear, 2)?;
//! let error = references.gaussian.error(&picture.image)?;
//! assert!(error.rmse > 0.0 && error.rmse < 0.2);
//! # Ok::<(), bellfit::scene::SceneError>(())
//! ```

mod axes;
mod camera;
mod comparison;
mod description;
mod difference;
mod error;
mod file;
mod image;
mod pattern;
mod place;
mod reference;
mod rows;
mod skew;
mod technique;
mod timing;
mod transfer;
mod view;
mod weight;

pub use axes::ellipse_axes;
pub use camera::Camera;
pub use comparison::{Compared, Comparison};
pub use description::{BUILT_IN, Scene};
pub use difference::PictureError;
pub use error::SceneError;
pub use file::{EXAMPLE_SCENE, SceneFile, SceneFileError};
pub use image::{Image, ImageError};
pub use pattern::Pattern;
pub use place::Places;
pub use reference::{Reference, References};
pub use skew::Skew;
pub use technique::Technique;
pub use timing::{Timing, time_lookups};
pub use transfer::{Transfer, decode_srgb, encode_srgb};
pub use view::{Rendered, View, near};
pub use weight::{cut_deviation, weight_from_id, weight_ids, weight_sigma};
