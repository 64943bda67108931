//! PNG files: read as they were written, and refused before their header's word is taken for it.

use crate::holds;
use crate::png_file::png_bytes;
use bellfit::scene::{Image, ImageError, Transfer};
use proptest::prelude::*;

/// (kind, channels) of what the reader takes.
const KINDS: [(png::ColorType, usize); 4] = [
    (png::ColorType::Grayscale, 1),
    (png::ColorType::GrayscaleAlpha, 2),
    (png::ColorType::Rgb, 3),
    (png::ColorType::Rgba, 4),
];

fn picture() -> impl Strategy<Value = (u32, u32, usize, Vec<u8>)> {
    (1..9_u32, 1..9_u32, 0..4_usize).prop_flat_map(|(width, height, kind)| {
        let bytes = (width * height) as usize * KINDS[kind].1;
        (Just(width), Just(height), Just(kind), proptest::collection::vec(any::<u8>(), bytes))
    })
}

#[test]
fn a_picture_is_read_as_it_was_written() {
    holds(70, 300, picture(), |(width, height, kind, data)| {
        let (color, channels) = KINDS[kind];
        let bytes = png_bytes((width, height), color, png::BitDepth::Eight, &data, |_| {});
        let image = Image::decode(&bytes, Transfer::Linear).unwrap();
        prop_assert_eq!(
            (image.width(), image.height(), image.channels()),
            (width as usize, height as usize, channels)
        );
        for (value, code) in image.values().iter().zip(&data) {
            prop_assert_eq!(*value, (f64::from(*code) / 255.0) as f32);
        }
        // Printed, it reads back: 8 bits are kept by either curve.
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            let image = Image::decode(&bytes, transfer).unwrap();
            prop_assert_eq!(Image::decode(&image.encode(transfer).unwrap(), transfer).unwrap(), image);
        }
        // Half of it is no picture: the pixels come before the last twelve bytes.
        for end in [0, 7, 20, 33, bytes.len() / 2, bytes.len() - 20] {
            prop_assert!(
                Image::decode(&bytes[..end], Transfer::Linear).is_err(),
                "{} of {}",
                end,
                bytes.len()
            );
        }
        Ok(())
    });
}

/// CRC-32 as the PNG specification states it, bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 })
    })
}

/// The bytes with another size in the header, its checksum right.
fn resized(bytes: &[u8], width: u32, height: u32) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let sum = crc(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&sum.to_be_bytes());
    bytes
}

fn is_one_line(error: &ImageError) -> bool {
    let text = error.to_string();
    !text.is_empty() && !text.contains('\n') && text.len() < 300
}

#[test]
fn a_header_that_states_a_huge_size_is_not_believed() {
    let bytes = png_bytes((2, 2), png::ColorType::Rgb, png::BitDepth::Eight, &[0; 12], |_| {});
    assert_eq!(resized(&bytes, 2, 2), bytes); // the checksum is the encoder's
    let start = std::time::Instant::now();
    let side = prop_oneof![
        0..5_u32,
        8000..9000_u32,
        any::<u32>(),
        Just(u32::MAX),
        Just(1 << 31),
        Just((1 << 31) - 1)
    ];
    holds(71, 200, (side.clone(), side), |(width, height)| {
        prop_assume!((width, height) != (2, 2));
        let large = u64::from(width) * u64::from(height) > Image::LARGEST;
        match Image::decode(&resized(&bytes, width, height), Transfer::Srgb) {
            Err(ImageError::TooLarge { width: w, height: h }) => {
                prop_assert!(large && (w, h) == (width, height));
            }
            Err(error) => prop_assert!(is_one_line(&error), "{}", error),
            // Smaller than what is there.
            Ok(image) => prop_assert!(image.width() <= 2 && image.height() <= 2),
        }
        Ok(())
    });
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}

#[test]
fn damaged_pictures_are_read_or_refused_in_one_line() {
    let hurt = (picture(), any::<u16>(), proptest::collection::vec(any::<u8>(), 0..9), 0..9_usize);
    holds(72, 1500, hurt, |((width, height, kind, data), at, new, gone)| {
        let mut bytes = png_bytes((width, height), KINDS[kind].0, png::BitDepth::Eight, &data, |_| {});
        let from = usize::from(at) * bytes.len() / 65_536;
        let to = (from + gone).min(bytes.len());
        bytes.splice(from..to, new);
        match Image::decode(&bytes, Transfer::Srgb) {
            Ok(image) => {
                prop_assert_eq!(image.values().len(), image.width() * image.height() * image.channels())
            }
            Err(error) => prop_assert!(is_one_line(&error), "{}", error),
        }
        Ok(())
    });
    holds(73, 500, proptest::collection::vec(any::<u8>(), 0..200), |bytes| {
        let signed = [&b"\x89PNG\r\n\x1a\n"[..], &bytes].concat();
        for bytes in [bytes, signed] {
            prop_assert!(Image::decode(&bytes, Transfer::Linear).is_err_and(|error| is_one_line(&error)));
        }
        Ok(())
    });
}
