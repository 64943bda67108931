//! Every technique against the references of one scene.

use super::rows::rows;
use super::skew::{Skew, skewest};
use super::{Image, PictureError, References, Scene, SceneError, Technique, View};

/// One technique on one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// Which.
    pub technique: Technique,
    /// Its picture.
    pub image: Image,
    /// Texels a pixel, mean.
    pub mean_texels: f64,
    /// Texels of the pixel that reads most.
    pub largest_texels: u64,
    /// Against [`References::area`].
    pub area: PictureError,
    /// Against [`References::gaussian`].
    pub gaussian: PictureError,
}

/// A scene's references and the pictures beside them.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// What is seen.
    pub scene: Scene,
    /// What it should look like.
    pub references: References,
    /// Where the derivative vectors are farthest from perpendicular.
    pub skew: Skew,
    /// In the order asked for.
    pub rows: Vec<Compared>,
}

impl Comparison {
    /// Computes everything, on so many threads; `done` is told each part's name.
    ///
    /// # Errors
    /// [`SceneError`] for a scene or technique that cannot be shown.
    pub fn run(
        scene: &Scene,
        techniques: &[Technique],
        threads: usize,
        done: &dyn Fn(&str),
    ) -> Result<Self, SceneError> {
        let view = View::new(scene)?;
        let references = References::new(&view, threads);
        done("reference");
        let mut rendered = Vec::with_capacity(techniques.len());
        for technique in techniques {
            rendered.push(view.picture(technique, threads)?);
            done(&technique.id);
        }
        let errors = rows(rendered.len(), threads, |i| -> Result<_, SceneError> {
            let image = &rendered[i].image;
            Ok((references.area.error(image)?, references.gaussian.error(image)?))
        });
        done("errors");
        let mut compared = Vec::with_capacity(techniques.len());
        for ((technique, rendered), errors) in techniques.iter().zip(rendered).zip(errors) {
            let (area, gaussian) = errors?;
            compared.push(Compared {
                technique: technique.clone(),
                image: rendered.image,
                mean_texels: rendered.mean_texels,
                largest_texels: rendered.largest_texels,
                area,
                gaussian,
            });
        }
        let skew = skewest(&view);
        Ok(Comparison { scene: scene.clone(), references, skew, rows: compared })
    }

    /// The row of a technique, if it was compared.
    pub fn row(&self, id: &str) -> Option<&Compared> {
        self.rows.iter().find(|row| row.technique.id == id)
    }
}
