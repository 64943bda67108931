//! Shading code as a renderer without std would write it, in both float types.
//!
//! The panic handler is the proof: were std linked by anything below, it would stand twice, which does
//! not compile.
#![no_std]

use bellfit::kernel::bell::bell;
use bellfit::kernel::cubic::{CubicLobe, cubic_bell};
use bellfit::kernel::exact::cs_16_factor_exact;
use bellfit::kernel::factor::{cos_n_factor, cs_16_factor, cs_16_factor_printed};
use bellfit::kernel::lobe::{cos_n, cs, cs_16, cs_versine, cut_exact, gaussian, schlick, versine};
use bellfit::kernel::model::Model;
use bellfit::kernel::pixel::{
    Axes, Footprint, Inverse, Padding, PaperReading, PixelWeight, Polygon, RADIUS, SIGMA, clip_volume,
    clip_volume_cut, coverage, half_plane,
};
use bellfit::kernel::sampling::{Profile, pdf, sample};
use bellfit::kernel::shading::{PhongLambert, phong_lambert_with};
use bellfit::kernel::vector::{Vec3, dot, half_vector};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

/// Normalised Blinn-Phong highlight in single precision.
pub fn highlight(normal: Vec3<f32>, to_light: Vec3<f32>, to_view: Vec3<f32>, n: f32) -> f32 {
    let Some(half) = half_vector(to_light, to_view) else { return 0.0 };
    cs_16_factor(Model::BlinnPhong).at(n) * cs_16(dot(normal, half), n)
}

/// Phong with Lambert's term in double precision.
pub fn shade(normal: Vec3<f64>, to_light: Vec3<f64>, to_view: Vec3<f64>, n: f64) -> f64 {
    let specular = cs_16_factor_printed::<f64>(Model::Phong).at(n);
    let material = PhongLambert { ambient: 0.1, diffuse: 0.5, specular, n };
    phong_lambert_with(material, 0.2, 1.0, normal, to_light, to_view, cs::<8, f64>)
}

/// A direction to the light drawn in single precision, and its density.
pub fn draw(normal: Vec3<f32>, to_view: Vec3<f32>, n: f32, u1: f32, u2: f32) -> Option<(Vec3<f32>, f32)> {
    let (model, profile) = (Model::BlinnPhong, Profile::Cs16);
    let to_light = sample(model, profile, n, normal, to_view, u1, u2)?;
    Some((to_light, pdf(model, profile, n, normal, to_view, to_light)))
}

/// Normalised Phong lobe in single precision, with the factor for every n.
pub fn reflection(cos: f32, n: f32) -> f32 {
    cs_16_factor_exact(Model::Phong, n) * cs_16(cos, n)
}

/// The cubic lobe, and the bell for e⁻ᵗ.
pub fn cubic(cos: f32, n: f32, t: f64) -> (f32, f64) {
    (CubicLobe::<4, f32>::new(n).at(cos), cubic_bell::<8, f64>(t))
}

/// Weight of the texel at (u, v) from a pixel's middle in single precision, by the share of it that is inside.
pub fn texel(polygon: &Polygon<f32>, x: f32, y: f32, u: f32, v: f32) -> f32 {
    let j = polygon.jacobian(x, y).scaled(0.5);
    let footprint = Footprint::of(j, Padding::Padded);
    let weight = PixelWeight::Paper(PaperReading::R2).at(footprint.q(u, v), 0.0);
    weight * coverage(&footprint, u, v)
}

/// The same in double precision with the other forms, and the pixel's volume beyond a line.
pub fn rim(polygon: &Polygon<f64>, x: f64, y: f64, u: f64, v: f64) -> [f64; 4] {
    let j = polygon.jacobian(x, y).scaled(0.5);
    let (a, b) = Axes::of(j, Padding::Padded).frame().coordinates(u, v);
    let weight = PixelWeight::PaperProduct(PaperReading::R1).at(a * a, b * b);
    let tangent = half_plane(&Footprint::of(j, Padding::Padded), u, v);
    let q = Inverse::of(j, Padding::Padded).q(u, v);
    [weight * tangent, q, clip_volume(u, SIGMA), clip_volume_cut(v, SIGMA, RADIUS)]
}

/// Every elementary function that the kernels take from `libm`, in both types.
pub fn lobes(theta: f64, n: f64) -> [f64; 6] {
    let (single, exponent) = (theta as f32, n as f32);
    [
        cos_n(1.0 - versine(theta), n) * cos_n_factor(Model::BlinnPhongModified, n),
        f64::from(cos_n(1.0 - versine(single), exponent) * cos_n_factor(Model::BlinnPhong, exponent)),
        cs_versine::<32, f64>(versine(theta), n) - gaussian(theta, n),
        f64::from(cs_versine::<32, f32>(versine(single), exponent) - gaussian(single, exponent)),
        cut_exact(n) - bell::<16, f64>(n),
        f64::from(schlick(1.0 - versine(single), exponent) - cut_exact(exponent)),
    ]
}
