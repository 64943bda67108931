//! How do I read a texture under a slanted pixel, and what does it change?
//!
//! ```sh
//! cargo run --release --example texture              # a chequered texture
//! cargo run --release --example texture -- mine.png
//! ```

use bellfit::filter::{EllipseFilter, Method, Pyramid, Reduction, Sampler, Wrap};
use bellfit::kernel::pixel::Jacobian;
use bellfit::scene::{Image, Pattern, Transfer};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let image = match std::env::args().nth(1) {
        Some(path) => Image::read(Path::new(&path), Transfer::Srgb)?,
        None => Pattern::Checker { size: 256, square: 8 }.image()?,
    };
    // Linear light, each level the mean of the finer one.
    let pyramid = Pyramid::new(image.texture()?, Reduction::Box, Wrap::Repeat);

    // ∂(u,v)/∂x and ∂(u,v)/∂y in texels: one step to the right in the picture crosses 12 texels, one down crosses 1.5.
    // A renderer has these from dFdx and dFdy or from ray differentials.
    let pixel = Jacobian { ux: 12.0, vx: 3.0, uy: -0.5, vy: 1.5 };
    let (s, t) = (0.37 * image.width() as f32, 0.61 * image.height() as f32);

    println!("{} × {} texels, at ({s}, {t}) under {pixel:?}", image.width(), image.height());
    for (name, method) in [
        ("bilinear", Method::Bilinear),
        ("trilinear", Method::Trilinear),
        ("elliptical", Method::Ellipse(EllipseFilter::default())),
    ] {
        let found = Sampler::new(&pyramid, Wrap::Repeat, method)?.lookup(s, t, pixel);
        let value: Vec<String> = found.value[..image.channels()].iter().map(|v| format!("{v:.4}")).collect();
        println!("  {name:<10} {:<28} {:>4} texels, level {:.2}", value.join(" "), found.texels, found.level);
    }
    Ok(())
}
