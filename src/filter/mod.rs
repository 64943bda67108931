//! Texture lookups: a mip pyramid of any size and the filters that read it.
//!
//! Nearest, bilinear and trilinear as graphics interfaces have them, and the weighted mean over the
//! ellipse under a pixel with any [`PixelWeight`](crate::kernel::pixel::PixelWeight). Values are taken as
//! they come: whoever filters colours passes linear ones. Positions and derivatives are in texels of
//! level 0, with texel centres at + ½.
//!
//! ```
//! use bellfit::filter::{EllipseFilter, Method, Pyramid, Reduction, Sampler, Texture, Wrap};
//! use bellfit::kernel::pixel::Jacobian;
//! let checks: Vec<f32> = (0..64 * 64).map(|i| ((i % 64 + i / 64) % 2) as f32).collect();
//! let pyramid = Pyramid::new(Texture::new(64, 64, 1, &checks)?, Reduction::Box, Wrap::Repeat);
//! let sampler = Sampler::new(&pyramid, Wrap::Repeat, Method::Ellipse(EllipseFilter::default()))?;
//! // A pixel 24 texels long and 6 wide, tilted: grey
//! let lookup = sampler.lookup(20.0, 30.5, Jacobian { ux: 10.0, vx: 6.0, uy: -1.5, vy: 2.5 });
//! assert!((lookup.value[0] - 0.5).abs() < 0.01);
//! # Ok::<(), bellfit::filter::FilterError>(())
//! ```

mod bilinear;
mod ellipse;
mod elliptical;
mod error;
mod gathered;
mod placed;
mod plan;
mod pyramid;
mod reduction;
mod rim;
mod sampler;
mod scan;
mod shape;
mod texture;
mod walk;
mod weight;
mod wrap;

pub use ellipse::{AxesKind, EllipseFilter, Rim};
pub use error::FilterError;
pub use pyramid::Pyramid;
pub use reduction::Reduction;
pub use sampler::{Level, Lookup, Method, Pixel, Sampler};
pub use texture::Texture;
pub use wrap::Wrap;
