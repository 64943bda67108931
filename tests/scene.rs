//! PNG in and out, the camera, the supersampled references and the measures.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;
#[path = "support/png_file.rs"]
mod png_file;
#[path = "support/references.rs"]
mod references;

use bellfit::filter::Wrap;
use bellfit::kernel::pixel::PixelWeight;
use bellfit::scene::{
    Camera, Comparison, Image, ImageError, Pattern, PictureError, References, Scene, SceneError, SceneFile,
    Technique, Transfer, View, decode_srgb, encode_srgb, near,
};
use bellfit::scene::{cut_deviation, weight_from_id, weight_ids};
use draw::Draw;
use png::{BitDepth, ColorType};
use png_file::{folder, png_bytes};
use std::path::Path;

#[test]
fn srgb_is_the_standards_formula() {
    let rows = references::rows::<2>("srgb.csv");
    assert_eq!(rows.len(), 256);
    for [code, light] in rows {
        let reference: f64 = light.parse().unwrap();
        let v = code.parse::<f64>().unwrap() / 255.0;
        // (v + 0.055)/1.055 carries 2 roundings and v's own, times the exponent 2.4, and the power one more.
        assert!((decode_srgb(v) - reference).abs() <= 8.5 * 0.5 * f64::EPSILON * reference, "{code}");
        assert!((encode_srgb(reference) - v).abs() <= 4.0 * f64::EPSILON, "{code}");
    }
}

#[test]
fn every_code_survives_reading_and_writing() {
    let codes: Vec<u8> = (0..=255).collect();
    for (kind, samples) in
        [(ColorType::Grayscale, 1), (ColorType::GrayscaleAlpha, 2), (ColorType::Rgb, 3), (ColorType::Rgba, 4)]
    {
        let data: Vec<u8> =
            codes.iter().flat_map(|&c| (0..samples).map(move |i| c.wrapping_add(40 * i))).collect();
        let bytes = png_bytes((16, 16), kind, BitDepth::Eight, &data, |_| ());
        for transfer in [Transfer::Srgb, Transfer::Linear] {
            let image = Image::decode(&bytes, transfer).unwrap();
            assert_eq!(image.channels(), usize::from(samples));
            assert_eq!(png_file::png_data(&image.encode(transfer).unwrap()), (16, 16, data.clone()));
            for (i, (&value, &code)) in image.values().iter().zip(&data).enumerate() {
                let v = f64::from(code) / 255.0;
                let alpha = samples % 2 == 0 && i % usize::from(samples) == usize::from(samples) - 1;
                let light = if alpha || transfer == Transfer::Linear { v } else { decode_srgb(v) };
                assert_eq!(value, light as f32);
            }
        }
    }
}

#[test]
fn all_kinds_of_png_are_read() {
    let read = |bytes: &[u8]| {
        let image = Image::decode(bytes, Transfer::Linear).unwrap();
        (image.channels(), image.values().to_vec())
    };
    let of = |code: u16, largest: u16| (f64::from(code) / f64::from(largest)) as f32;
    // Two pixels of 1, 2 and 4 bits, packed from the left.
    for (depth, byte, largest, codes) in [
        (BitDepth::One, 0b0100_0000, 1, [0, 1]),
        (BitDepth::Two, 0b0111_0000, 3, [1, 3]),
        (BitDepth::Four, 0b0010_1101, 15, [2, 13]),
    ] {
        let bytes = png_bytes((2, 1), ColorType::Grayscale, depth, &[byte], |_| ());
        assert_eq!(read(&bytes), (1, codes.map(|c| of(c, largest)).to_vec()));
    }
    let deep = png_bytes(
        (2, 1),
        ColorType::GrayscaleAlpha,
        BitDepth::Sixteen,
        &[1, 2, 3, 4, 255, 255, 0, 0],
        |_| (),
    );
    assert_eq!(read(&deep), (2, vec![of(258, 65535), of(772, 65535), 1.0, 0.0]));
    let palette = |transparent: bool| {
        png_bytes((4, 1), ColorType::Indexed, BitDepth::Two, &[0b0001_1011], |encoder| {
            encoder.set_palette(vec![0, 0, 0, 10, 20, 30, 40, 50, 60, 255, 254, 253]);
            if transparent {
                encoder.set_trns(vec![0, 128]);
            }
        })
    };
    let colours = [[0, 0, 0, 0], [10, 20, 30, 128], [40, 50, 60, 255], [255, 254, 253, 255]];
    let values =
        |n: usize| colours.iter().flat_map(|c| c[..n].iter().map(|&c| of(c, 255))).collect::<Vec<_>>();
    assert_eq!(read(&palette(false)), (3, values(3)));
    assert_eq!(read(&palette(true)), (4, values(4)));
    // One colour of three is transparent.
    let keyed = png_bytes((2, 1), ColorType::Rgb, BitDepth::Eight, &[1, 2, 3, 4, 5, 6], |encoder| {
        encoder.set_trns(vec![0, 4, 0, 5, 0, 6]);
    });
    assert_eq!(read(&keyed), (4, [1, 2, 3, 255, 4, 5, 6, 0].map(|c| of(c, 255)).to_vec()));
}

/// A PNG's first chunk with a right checksum (ISO/IEC 15948, annex D), and nothing behind it.
fn header_only(width: u32, height: u32) -> Vec<u8> {
    let mut chunk = b"IHDR".to_vec();
    chunk.extend(width.to_be_bytes());
    chunk.extend(height.to_be_bytes());
    chunk.extend([8, 0, 0, 0, 0]);
    let crc = !chunk.iter().fold(!0u32, |crc, &byte| {
        (0..8).fold(
            crc ^ u32::from(byte),
            |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 },
        )
    });
    let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
    bytes.extend(chunk);
    bytes.extend(crc.to_be_bytes());
    bytes
}

#[test]
fn what_is_no_png_is_an_error() {
    let mut draw = Draw(31);
    let data: Vec<u8> = (0..48).map(|_| draw.bits() as u8).collect();
    let good = png_bytes((4, 4), ColorType::Rgb, BitDepth::Eight, &data, |_| ());
    // All but the last chunk, which says nothing but "end".
    for end in 0..good.len() - 12 {
        assert!(matches!(Image::decode(&good[..end], Transfer::Srgb), Err(ImageError::Decode(_))), "{end}");
    }
    let (mut spoilt, mut failed) = (0, 0);
    for _ in 0..400 {
        let mut bytes = good.clone();
        bytes[draw.below(good.len())] ^= 1 << draw.below(8);
        spoilt += 1;
        failed += usize::from(Image::decode(&bytes, Transfer::Srgb).is_err());
        let noise: Vec<u8> = (0..draw.below(200)).map(|_| draw.bits() as u8).collect();
        assert!(Image::decode(&noise, Transfer::Srgb).is_err());
    }
    // A flipped bit is seen by a checksum, but for those of lengths and types of what may be skipped.
    assert!(failed > spoilt / 2, "{failed} of {spoilt}");
    let error = Image::decode(&header_only(1 << 14, 1 << 13), Transfer::Srgb).unwrap_err();
    assert_eq!(error, ImageError::TooLarge { width: 1 << 14, height: 1 << 13 });
    for (width, height) in [(0, 5), (5, 0), (1 << 12, 1 << 12)] {
        let error = Image::decode(&header_only(width, height), Transfer::Srgb).unwrap_err();
        assert!(matches!(error, ImageError::Decode(_)), "{width} × {height}: {error}");
    }
    let out = folder("no-png");
    for path in [out.as_path(), Path::new("/nonexistent.png")] {
        let error = Image::read(path, Transfer::Srgb).unwrap_err().to_string();
        assert!(error.starts_with(path.to_str().unwrap()) && error.lines().count() == 1, "{error}");
    }
    assert!(Image::new(2, 2, 1, vec![0.0; 3]).is_err() && Image::new(0, 2, 1, vec![]).is_err());
    assert!(Image::new(1, 1, 5, vec![0.0; 5]).is_err());
}

#[test]
fn the_camera_sees_points_where_they_are() {
    let mut draw = Draw(7);
    for _ in 0..200 {
        let camera = Camera {
            height: draw.real(0.1, 5.0),
            pitch: draw.real(5.0, 90.0),
            roll: draw.real(-180.0, 180.0),
            field_of_view: draw.real(20.0, 120.0),
        };
        let (width, height, scale) = (192, 120, [draw.real(1.0, 100.0), draw.real(1.0, 100.0)]);
        let mapping = camera.mapping(width, height, scale);
        // The middle of the picture: straight ahead, at distance height/tan(pitch).
        let (s, t) = mapping.at(96.0, 60.0);
        let ahead = camera.height / libm::tan(camera.pitch.to_radians()) * scale[1];
        assert!(s.abs() < 1e-9 && (t - ahead).abs() < 1e-9 * (1.0 + ahead), "{camera:?}");
        // Elsewhere: the angle between the ray to the plane's point and the axis, which knows no roll.
        let (x, y) = (draw.real(0.0, 192.0), draw.real(0.0, 120.0));
        let below = mapping.w[0] * x + mapping.w[1] * y + mapping.w[2];
        if below < 0.05 {
            continue;
        }
        let (s, t) = mapping.at(x, y);
        let point = [s / scale[0], t / scale[1], -camera.height];
        let axis = [0.0, libm::cos(camera.pitch.to_radians()), -libm::sin(camera.pitch.to_radians())];
        let dot: f64 = point.iter().zip(axis).map(|(p, a)| p * a).sum();
        let length = point.iter().map(|p| p * p).sum::<f64>().sqrt();
        let focal = 96.0 / libm::tan(0.5 * camera.field_of_view.to_radians());
        let off = libm::hypot(x - 96.0, y - 60.0);
        let cosine = focal / libm::hypot(focal, off);
        assert!((dot / length - cosine).abs() < 1e-10, "{camera:?}");
    }
}

#[test]
fn the_jacobian_is_the_slope_of_the_mapping() {
    for name in ["checker", "rolled"] {
        let scene = Scene::built_in(name).unwrap();
        let view = View::new(&scene).unwrap();
        let (mapping, h) = (view.mapping(), 1e-3);
        let mut seen = 0;
        for i in (0..view.on_plane().len()).filter(|&i| view.on_plane()[i]).step_by(97) {
            let (x, y) = ((i % view.width()) as f64 + 0.5, (i / view.width()) as f64 + 0.5);
            let j = mapping.jacobian(x, y);
            let slope = |dx: f64, dy: f64| {
                let (a, b) = (mapping.at(x - dx, y - dy), mapping.at(x + dx, y + dy));
                ((b.0 - a.0) / (2.0 * h), (b.1 - a.1) / (2.0 * h))
            };
            let ((ux, vx), (uy, vy)) = (slope(h, 0.0), slope(0.0, h));
            let size = j.lengths().0 + j.lengths().1;
            // Central differences: h² of the third derivative, which is within 6/2² of the first two pixels and
            // more from the horizon; and rounding of positions up to 1e5 over h.
            for (exact, found) in [(j.ux, ux), (j.vx, vx), (j.uy, uy), (j.vy, vy)] {
                assert!((exact - found).abs() < 1e-5 * size, "{name} {x} {y}: {exact} {found}");
            }
            seen += 1;
        }
        assert!(seen > 50);
    }
}

/// Straight down on a texture, `texels` of them a pixel.
fn straight_down(pattern: Pattern, texels: f64, wrap: Wrap) -> Scene {
    let camera = Camera { height: 1.0, pitch: 90.0, roll: 0.0, field_of_view: 90.0 };
    // The picture's 32 pixels are 2 units.
    let scale = [16.0 * texels, 16.0 * texels];
    Scene { name: "down".to_owned(), width: 32, height: 32, camera, pattern, scale, wrap }
}

#[test]
fn references_of_a_cosine_are_the_filters_transfer_functions() {
    // ½ + 0.4 cos(2π x/64), 16 bits; 8 texels a pixel: ⅛ cycle a pixel.
    let value = |x: usize| 0.5 + 0.4 * libm::cos(std::f64::consts::TAU * (x as f64 + 0.5) / 64.0);
    let data: Vec<u8> =
        (0..4 * 64).flat_map(|i| (libm::round(65535.0 * value(i % 64)) as u16).to_be_bytes()).collect();
    let path = folder("cosine").join("cosine.png");
    std::fs::write(&path, png_bytes((64, 4), ColorType::Grayscale, BitDepth::Sixteen, &data, |_| ()))
        .unwrap();
    let pattern = Pattern::File { path, transfer: Transfer::Linear };
    let view = View::new(&straight_down(pattern, 8.0, Wrap::Repeat)).unwrap();
    let found = References::new(&view, 2);
    let sinc = |x: f64| libm::sin(std::f64::consts::PI * x) / (std::f64::consts::PI * x);
    // Linear interpolation keeps sinc² of a frequency in cycles a texel; its images are 1/63² and less.
    let interpolated = 0.4 * sinc(1.0 / 64.0) * sinc(1.0 / 64.0);
    let area = interpolated * sinc(0.125);
    let gaussian = interpolated * libm::exp(-2.0 * libm::pow(std::f64::consts::PI * 0.5 * 0.125, 2.0));
    for (reference, amplitude) in [(&found.area, area), (&found.gaussian, gaussian)] {
        assert!(reference.sampling_error < 1e-3 && reference.sampling_error > 0.0);
        for (i, &value) in reference.image.values().iter().enumerate() {
            let (s, _) = view.mapping().at((i % 32) as f64 + 0.5, 16.5);
            let exact = 0.5 + amplitude * libm::cos(std::f64::consts::TAU * s / 64.0);
            // The images, 0.4/63², the file's half unit, and the samples, of which 5 RMS errors are allowed.
            let slack = 0.4 / 3969.0 + 1e-5 + 5.0 * reference.sampling_error;
            assert!((f64::from(value) - exact).abs() < slack, "{i}: {value} {exact}");
        }
    }
    // The two differ by more than ten times what is allowed.
    assert!((area - gaussian).abs() > 5.0 * 5.0 * found.area.sampling_error, "{area} {gaussian}");
}

/// The checker's value between texel centres, from its definition alone.
fn checker(s: f64, t: f64, size: f64, square: f64) -> f64 {
    let texel = |x: f64, y: f64| {
        let cell = |v: f64| (v.rem_euclid(size) / square).floor();
        if (cell(x) + cell(y)).rem_euclid(2.0) == 0.0 { 0.9 } else { 0.1 }
    };
    let (x, y) = ((s - 0.5).floor(), (t - 0.5).floor());
    let (fx, fy) = (s - 0.5 - x, t - 0.5 - y);
    let row = |y: f64| (1.0 - fx) * texel(x, y) + fx * texel(x + 1.0, y);
    (1.0 - fy) * row(y) + fy * row(y + 1.0)
}

#[test]
fn references_of_a_checker_are_those_of_a_dense_grid() {
    let scene = Scene {
        width: 48,
        height: 32,
        pattern: Pattern::Checker { size: 64, square: 8 },
        ..Scene::built_in("rolled").unwrap()
    };
    let view = View::new(&scene).unwrap();
    let found = References::new(&view, 2);
    let mut checked = 0;
    for i in (0..view.on_plane().len()).filter(|&i| view.on_plane()[i]).step_by(131) {
        let (x, y) = ((i % 48) as f64, (i / 48) as f64);
        // Of 41² points a pixel, those within 2½ pixels of its middle along each axis.
        let (mut area, mut gaussian) = ((0.0, 0.0), (0.0, 0.0));
        for b in -82..123 {
            for a in -82..123 {
                let place = |i: i32| (f64::from(i) + 0.5) / 41.0;
                let (s, t) = view.mapping().at(x + place(a), y + place(b));
                let value = checker(s, t, 64.0, 8.0);
                let (dx, dy) = (place(a) - 0.5, place(b) - 0.5);
                let weight = libm::exp(-2.0 * (dx * dx + dy * dy));
                gaussian = (gaussian.0 + weight * value, gaussian.1 + weight);
                if (0..41).contains(&a) && (0..41).contains(&b) {
                    area = (area.0 + value, area.1 + 1.0);
                }
            }
        }
        // The grid's own error where a pixel has many squares is that of 41² points of spread 0.4.
        let slack = |own: f64| 5.0 * own + 0.4 / 41.0;
        let value = |reference: &bellfit::scene::Reference| f64::from(reference.image.values()[i]);
        assert!((value(&found.area) - area.0 / area.1).abs() < slack(found.area.sampling_error), "{i}");
        let off = value(&found.gaussian) - gaussian.0 / gaussian.1;
        assert!(off.abs() < slack(found.gaussian.sampling_error), "{i}");
        checked += 1;
    }
    assert!(checked > 5, "{checked}");
}

fn small(name: &str) -> Scene {
    Scene { width: 40, height: 30, ..Scene::built_in(name).unwrap() }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let techniques: Vec<Technique> = ["trilinear", "gaussian-half-padded", "paper-r1-product"]
        .map(|id| Technique::from_id(id).unwrap())
        .into();
    let run = |threads| Comparison::run(&small("rolled"), &techniques, threads, &|_| ()).unwrap();
    let one = run(1);
    assert_eq!(one, run(2));
    assert_eq!(one, run(7));
}

#[test]
fn a_constant_texture_is_a_constant_picture() {
    let path = folder("constant").join("constant.png");
    std::fs::write(
        &path,
        png_bytes((5, 3), ColorType::Rgba, BitDepth::Eight, &[60, 120, 180, 200].repeat(15), |_| ()),
    )
    .unwrap();
    let pattern = Pattern::File { path, transfer: Transfer::Linear };
    for wrap in Wrap::ALL {
        let scene = Scene { pattern: pattern.clone(), wrap, ..small("checker") };
        let view = View::new(&scene).unwrap();
        let references = References::new(&view, 2);
        let mut pictures = vec![references.area.image.clone(), references.gaussian.image.clone()];
        pictures.extend(Technique::all().iter().map(|t| view.picture(t, 2).unwrap().image));
        for picture in pictures {
            let pixels = picture.values().chunks_exact(4).zip(view.on_plane());
            for (pixel, _) in pixels.filter(|&(_, &on)| on) {
                for (&value, code) in pixel.iter().zip([60.0, 120.0, 180.0, 200.0]) {
                    // A weighted mean of equal values: a few roundings of the sums and the quotient.
                    assert!((f64::from(value) - code / 255.0).abs() < 1e-5, "{value} {code}");
                }
            }
        }
    }
}

#[test]
fn measures_of_known_differences() {
    let mut draw = Draw(3);
    let (width, height) = (32, 24);
    let reference: Vec<f32> = (0..width * height).map(|_| draw.real(0.2, 0.7) as f32).collect();
    let image = |values: Vec<f32>| Image::new(width, height, 1, values).unwrap();
    let counted = vec![true; width * height];
    let against = |values: Vec<f32>| {
        PictureError::between(&image(reference.clone()), &image(values), &counted).unwrap()
    };
    let same = against(reference.clone());
    assert_eq!((same.rmse, same.psnr, same.perceptual), (0.0, f64::INFINITY, 100.0));
    assert!((same.gain - 1.0).abs() < 1e-12 && same.alien < 1e-12);
    // An offset of 1/8, exact in f32 up to one rounding: 20 log₁₀ 8 dB, the contrast untouched.
    let shifted = against(reference.iter().map(|v| v + 0.125).collect());
    assert!((shifted.rmse - 0.125).abs() < 1e-7 && (shifted.psnr - 20.0 * libm::log10(8.0)).abs() < 1e-4);
    assert!((shifted.gain - 1.0).abs() < 1e-6 && shifted.alien < 1e-6 && shifted.perceptual < 100.0);
    let doubled = against(reference.iter().map(|v| 2.0 * v - 0.4).collect());
    assert!((doubled.gain - 2.0).abs() < 1e-6 && doubled.alien < 1e-6);
    // What does not count does not change the first two.
    let mut one_off = reference.clone();
    one_off[5] += 0.25;
    let mut but_one = counted.clone();
    but_one[5] = false;
    let (a, b) = (image(reference.clone()), image(one_off));
    assert_eq!(PictureError::between(&a, &b, &but_one).unwrap().rmse, 0.0);
    let expected = 0.25 / (width as f64 * height as f64).sqrt();
    assert!((PictureError::between(&a, &b, &counted).unwrap().rmse - expected).abs() < 1e-8);
}

#[test]
fn skew_of_known_views() {
    let scene = straight_down(Pattern::Checker { size: 8, square: 2 }, 4.0, Wrap::Repeat);
    let scene = Scene { scale: [64.0, 192.0], ..scene };
    let skew = Comparison::run(&scene, &[], 1, &|_| ()).unwrap().skew;
    assert!((skew.degrees - 90.0).abs() < 1e-5 && (skew.aspect - 3.0).abs() < 1e-9, "{skew:?}");
    assert!((skew.paper_aspect - 3.0).abs() < 1e-9 && skew.tilt_errors[1] < 1e-5, "{skew:?}");
    // Rolled by 45°, the vectors are (a, 3a) and (-a, 3a): 2 arctan(1/3) apart, of equal length.
    let rolled = Scene { camera: Camera { roll: 45.0, ..scene.camera }, ..scene };
    let skew = Comparison::run(&rolled, &[], 1, &|_| ()).unwrap().skew;
    assert!((skew.degrees - 2.0 * libm::atan(1.0 / 3.0).to_degrees()).abs() < 1e-6, "{skew:?}");
    assert!((skew.aspect - 3.0).abs() < 1e-9 && (skew.paper_aspect - 1.0).abs() < 1e-9, "{skew:?}");
}

#[test]
fn positions_near_the_origin_are_the_same_places() {
    let mut draw = Draw(11);
    for _ in 0..2000 {
        let (x, size) = (libm::floor(draw.real(-1e6, 1e6)), 1 + draw.below(300));
        for wrap in [Wrap::Repeat, Wrap::Mirror] {
            let moved = near(wrap, x + 0.5, size as f64);
            assert!((0.0..=2.0 * size as f64).contains(&moved));
            assert_eq!(
                wrap.index(moved.floor() as i64, size),
                wrap.index(x as i64, size),
                "{wrap:?} {x} {size}"
            );
        }
        let moved = near(Wrap::Clamp, 1e4 * x, size as f64);
        assert_eq!(Wrap::Clamp.index(moved as i64, size), Wrap::Clamp.index((1e4 * x) as i64, size));
    }
}

#[test]
fn scenes_out_of_their_domain_are_refused() {
    let good = small("checker");
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut scene = good.clone();
        change(&mut scene);
        View::new(&scene).map(|_| ()).unwrap_err().to_string()
    };
    assert!(with(&|s| s.width = 15).contains("15 × 30"));
    assert!(with(&|s| s.height = 1025).ends_with("each side must be 16 to 1024"));
    for bad in [f64::NAN, f64::INFINITY, -1e9] {
        assert!(with(&|s| s.camera.height = bad).contains("camera height"));
        assert!(with(&|s| s.camera.pitch = bad).contains("camera pitch"));
        assert!(with(&|s| s.camera.roll = bad).contains("camera roll"));
        assert!(with(&|s| s.camera.field_of_view = bad).contains("field of view"));
        assert!(with(&|s| s.scale[1] = bad).contains("texels a unit"));
    }
    assert!(with(&|s| s.pattern = Pattern::Checker { size: 8, square: 0 }).contains("square = 0"));
    assert!(with(&|s| s.pattern = Pattern::ZonePlate { size: 8, frequency: 0.6 }).contains("0.6"));
    let mut sky = good.clone();
    sky.camera.pitch = -60.0;
    assert_eq!(View::new(&sky).map(|_| ()).unwrap_err(), SceneError::Sky);
}

#[test]
fn scene_files_are_read_and_their_errors_placed() {
    let parse = |text: &str| SceneFile::parse(text, "mine", Path::new("textures"));
    let example = bellfit::scene::EXAMPLE_SCENE;
    let file = parse(example).unwrap();
    let built_in = Scene::built_in("checker").unwrap();
    assert_eq!(file.scene, Scene { name: "mine".to_owned(), ..built_in });
    assert_eq!(file.techniques.len(), 5);
    let all = example.replace("techniques = ", "# ");
    assert_eq!(parse(&all).unwrap().techniques, Technique::all());
    let image = example
        .replace("kind = \"checker\"", "kind = \"image\"\npath = \"a.png\"")
        .replace("size = 256\n", "linear = true\n")
        .replace("square = 16\n", "");
    let pattern = Pattern::File { path: Path::new("textures/a.png").to_owned(), transfer: Transfer::Linear };
    assert_eq!(parse(&image).unwrap().scene.pattern, pattern);
    let line_of = |word: &str| example.lines().position(|line| line.contains(word)).unwrap() + 1;
    for (from, to, line, names) in [
        ("version = 1", "version = 2", line_of("version"), "version 2: this program reads 1"),
        ("pitch = 14.0", "pich = 14.0", line_of("pitch"), "unknown field `pich`"),
        ("pitch = 14.0", "pitch = \"steep\"", line_of("pitch"), "invalid type"),
        ("pitch = 14.0", "pitch = 95", line_of("[camera]"), "camera pitch = 95: must be -89 to 90 degrees"),
        ("width = 192", "width = 4", line_of("width"), "4 × 120"),
        ("\"repeat\" ", "\"tile\" ", line_of("wrap"), "unknown wrap \"tile\""),
        ("\"bilinear\"", "\"blurry\"", line_of("techniques"), "unknown technique \"blurry\""),
        ("\"bilinear\", ", "\"trilinear\", ", line_of("techniques"), "technique \"trilinear\" twice"),
        ("techniques = [", "techniques = [] # [", line_of("techniques"), "techniques is empty"),
        ("kind = \"checker\"", "kind = \"stripes\"", line_of("kind ="), "unknown kind \"stripes\""),
        ("kind = \"checker\"", "kind = \"zone-plate\"", line_of("square = 16"), "has no square"),
        ("square = 16", "", line_of("kind ="), "needs square"),
        ("square = 16", "square = 999", line_of("kind ="), "checker square = 999"),
        ("scale = [96.0, 96.0]", "scale = [96.0]", line_of("scale"), "length"),
    ] {
        assert!(example.contains(from), "{from}");
        let error = parse(&example.replacen(from, to, 1)).unwrap_err();
        assert!(error.line == line && error.message.contains(names), "{to}: {error}");
        assert!(error.column >= 1 && !error.message.contains('\n'));
    }
    assert_eq!(parse("").unwrap_err().line, 1);
}

#[test]
fn techniques_have_their_own_names() {
    let all = Technique::all();
    let names: std::collections::BTreeSet<_> = all.iter().map(|t| &t.id).collect();
    assert_eq!(names.len(), all.len());
    for technique in &all {
        assert_eq!(Technique::from_id(&technique.id).as_ref(), Some(technique));
    }
}

/// Against the plain sum over rings; √¼ of the second moment of a disc, and the whole bell's σ where the cut takes
/// nothing.
#[test]
fn a_cut_weight_is_narrower() {
    for id in weight_ids() {
        for sigma in [0.1, 1.0 / 3.0, 0.5] {
            let weight = match weight_from_id(&id, sigma).unwrap() {
                PixelWeight::Gaussian(s) => PixelWeight::Gaussian(f64::from(s)),
                PixelWeight::Bell(k, s) => PixelWeight::Bell(k, f64::from(s)),
                PixelWeight::Cubic(k, s) => PixelWeight::Cubic(k, f64::from(s)),
                PixelWeight::Paper(reading) => PixelWeight::Paper(reading),
                PixelWeight::PaperProduct(reading) => PixelWeight::PaperProduct(reading),
                PixelWeight::Box => PixelWeight::Box,
            };
            let (mut first, mut mass) = (0.0, 0.0);
            for i in 0..200_000 {
                let q = (f64::from(i) + 0.5) / 200_000.0;
                let w = weight.at(q, 0.0);
                (first, mass) = (first + q * w, mass + w);
            }
            let (found, expected) = (cut_deviation(weight), (0.5 * first / mass).sqrt());
            assert!((found - expected).abs() < 1e-6, "{id} {sigma}: {found} {expected}");
            assert!(found <= 0.5);
            if let PixelWeight::Gaussian(s) = weight {
                assert!(found < s + 1e-12);
                assert!(s > 0.2 || s - found < 1e-12);
            }
        }
    }
}
