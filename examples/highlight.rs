//! What do I see if six multiplications take the place of `pow` in a highlight?
//!
//! ```sh
//! cargo run --release --example highlight -- highlight.png # target/highlight.png without a name
//! ```
//! Three spheres with the specular exponent 64, lit from the upper left: cosⁿ by `pow`, the lobe paper's cs_16, and
//! the cubic lobe of the same cost. The kernels are all that a renderer would take from here.

use bellfit::kernel::{cubic::CubicLobe, factor::cos_n_factor, lobe::cos_n, lobe::cs_16, model::Model};
use bellfit::scene::{Image, Transfer};
use std::error::Error;

/// Pixels to a sphere's side.
const SIZE: usize = 240;
const EXPONENT: f32 = 64.0;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "target/highlight.png".to_owned());
    let cubic = CubicLobe::<4, f32>::new(EXPONENT);
    let lobes: [&dyn Fn(f32) -> f32; 3] =
        [&|c| cos_n(c, EXPONENT), &|c| cs_16(c, EXPONENT), &|c| cubic.at(c)];

    let mut light = vec![0.0_f32; 3 * SIZE * SIZE];
    for (i, lobe) in lobes.iter().enumerate() {
        for y in 0..SIZE {
            for x in 0..SIZE {
                light[y * 3 * SIZE + i * SIZE + x] = sphere(x, y, lobe);
            }
        }
    }
    let image = Image::new(3 * SIZE, SIZE, 1, light)?;
    std::fs::write(&path, image.encode(Transfer::Srgb)?)?;

    println!("{path}: cosⁿ, cs_16, cubic 4");
    for (i, name) in [(1, "cs_16"), (2, "cubic 4")] {
        let of = |x: usize, y: usize| Transfer::Srgb.encode(f64::from(image.values()[y * 3 * SIZE + x]));
        let steps = (0..SIZE * SIZE).map(|k| (k % SIZE, k / SIZE));
        let worst = steps.map(|(x, y)| (of(i * SIZE + x, y) - of(x, y)).abs()).fold(0.0, f64::max);
        println!("  {name}: at most {:.2} of 255 steps of the display from cosⁿ", 255.0 * worst);
    }
    Ok(())
}

/// Light from one pixel of a sphere, seen from afar along z: a diffuse and a specular term.
fn sphere(x: usize, y: usize, lobe: &dyn Fn(f32) -> f32) -> f32 {
    let place = |k: usize| (2.0 * (k as f32 + 0.5) / SIZE as f32 - 1.0) * 1.05;
    let (u, v) = (place(x), -place(y));
    let zz = 1.0 - u * u - v * v;
    if zz <= 0.0 {
        return 0.0;
    }
    let normal = [u, v, zz.sqrt()];
    let (to_light, half) = ([-0.48, 0.6, 0.64], [-0.265_007, 0.331_259, 0.905_538]); // half: L + (0, 0, 1), normalised
    let n_dot = |a: [f32; 3]| (normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2]).max(0.0);
    let n_l = n_dot(to_light);
    // cosⁿ's factor for all three, so that they differ by their lobes alone (a renderer takes each lobe's own);
    // a twentieth of the light, as glass reflects.
    let specular = 0.05 * cos_n_factor(Model::BlinnPhongModified, EXPONENT) * lobe(n_dot(half));
    0.02 + 4.0 * n_l * (0.05 + specular)
}
