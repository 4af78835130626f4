// SPDX-License-Identifier: MIT
// Draws the common scene of examples/README.md with the crate hrbfnpr-sys: scene SAMPLES PICTURE.
use hrbfnpr_sys::*;
use std::ffi::CStr;
use std::mem::{size_of, MaybeUninit};
use std::ptr::{null, null_mut};

const WIDTH: i32 = 640;
const HEIGHT: i32 = 480;

/// A struct that its `_init` function has filled.
fn new<T>(init: unsafe extern "C" fn(*mut T, u32) -> hrbfnpr_status) -> T {
    let mut made = MaybeUninit::uninit();
    unsafe {
        assert_eq!(init(made.as_mut_ptr(), size_of::<T>() as u32), HRBFNPR_STATUS_OK);
        made.assume_init()
    }
}

/// Makes a call that takes an error, and panics with the error's message if it fails.
fn check(call: impl FnOnce(*mut hrbfnpr_error) -> hrbfnpr_status) {
    let mut error = new(hrbfnpr_error_init);
    if call(&mut error) != HRBFNPR_STATUS_OK {
        panic!("{}", unsafe { CStr::from_ptr(error.message.as_ptr()) }.to_string_lossy());
    }
}

/// The points (first = 0) or normals (first = 3) of samples, which have six numbers each.
fn array(numbers: &[f64], first: usize) -> hrbfnpr_array {
    hrbfnpr_array {
        data: numbers[first..].as_ptr().cast(),
        count: (numbers.len() / 6) as i64,
        stride: 48,
        scalar: HRBFNPR_SCALAR_FLOAT64,
        components: 3,
    }
}

fn draw(numbers: &[f64]) -> Vec<u8> {
    let mut source = new(hrbfnpr_picture_source_init);
    (source.points, source.normals) = (array(numbers, 0), array(numbers, 3));
    let mut desc = new(hrbfnpr_picture_desc_init);
    (desc.sources, desc.source_count) = (&source, 1);
    (desc.width, desc.height) = (WIDTH, HEIGHT);
    (desc.direction, desc.up) = ([0.0, 1.0, -1.0], [0.0, 0.0, 1.0]);
    let mut pixels = vec![0u8; 4 * WIDTH as usize * HEIGHT as usize];
    let mut image = new(hrbfnpr_image_init);
    (image.width, image.height, image.pixels) = (WIDTH, HEIGHT, pixels.as_mut_ptr().cast());

    let (mut context, mut picture, mut drawing) = (null_mut(), null_mut(), null_mut());
    unsafe {
        check(|error| hrbfnpr_context_create(null(), &mut context, error));
        check(|error| hrbfnpr_picture_create(context, &desc, null_mut(), &mut picture, error));
        check(|error| hrbfnpr_picture_draw(picture, null(), null_mut(), &mut drawing, error));
        check(|error| hrbfnpr_picture_rasterize(picture, drawing, null(), &image, error));
        hrbfnpr_drawing_release(drawing);
        hrbfnpr_picture_release(picture);
        hrbfnpr_context_release(context);
    }
    pixels
}

fn main() {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let text = std::fs::read_to_string(&paths[0]).expect("samples");
    let numbers: Vec<f64> = text.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    std::fs::write(&paths[1], draw(&numbers)).expect("a picture");
}
