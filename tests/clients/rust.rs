// SPDX-License-Identifier: MIT
// Draws the scene of reference.c step by step with the crate hrbfnpr-sys: rust SAMPLES PICTURE.
use hrbfnpr_sys::*;
use std::ffi::{c_void, CStr};
use std::mem::{size_of, MaybeUninit};
use std::ptr::{null, null_mut};

const WIDTH: usize = 640;
const HEIGHT: usize = 480;

/// A struct that its `_init` function has filled.
fn new<T>(init: unsafe extern "C" fn(*mut T, u32) -> hrbfnpr_status) -> T {
    let mut made = MaybeUninit::uninit();
    unsafe {
        assert_eq!(init(made.as_mut_ptr(), size_of::<T>() as u32), HRBFNPR_STATUS_OK);
        made.assume_init()
    }
}

/// Makes a call that takes an error, and returns the error's message if it fails.
fn check(call: impl FnOnce(*mut hrbfnpr_error) -> hrbfnpr_status) -> Result<(), String> {
    let mut error = new(hrbfnpr_error_init);
    if call(&mut error) == HRBFNPR_STATUS_OK {
        return Ok(());
    }
    let message = unsafe { CStr::from_ptr(error.message.as_ptr()) };
    Err(message.to_str().expect("a message is UTF-8").to_owned())
}

/// The handle that a call writes to its out parameter.
fn made<T>(call: impl FnOnce(*mut *mut T, *mut hrbfnpr_error) -> hrbfnpr_status) -> Result<*mut T, String> {
    let mut handle = null_mut();
    check(|error| call(&mut handle, error)).map(|()| handle)
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

struct Seen {
    calls: usize,
    last: f64,
}

unsafe extern "C" fn watch(user: *mut c_void, progress: f64) -> i32 {
    let seen = &mut *user.cast::<Seen>();
    assert!((seen.last..=1.0).contains(&progress));
    *seen = Seen { calls: seen.calls + 1, last: progress };
    0
}

fn fit(context: *mut hrbfnpr_context, numbers: &[f64]) -> Result<*mut hrbfnpr_model, String> {
    let mut desc = new(hrbfnpr_fit_desc_init);
    desc.points = array(numbers, 0);
    desc.normals = array(numbers, 3);
    desc.normals.count -= 1;
    let refused = unsafe { made(|out, error| hrbfnpr_model_fit(context, &desc, null_mut(), out, error)) };
    let message = refused.expect_err("a normal is missing");
    assert!(message.contains("normals"), "a failure's message does not name the argument: {message}");
    desc.normals.count += 1;

    let mut seen = Seen { calls: 0, last: 0.0 };
    let user: *mut Seen = &mut seen;
    unsafe {
        let operation = made(|out, error| hrbfnpr_operation_create(context, out, error))?;
        check(|error| hrbfnpr_operation_set_callback(operation, Some(watch), user.cast(), error))?;
        let model = made(|out, error| hrbfnpr_model_fit(context, &desc, operation, out, error))?;
        hrbfnpr_operation_release(operation);
        assert!((*user).calls > 0 && (*user).last == 1.0, "the callback was not called to the end");
        Ok(model)
    }
}

fn camera(model: *const hrbfnpr_model) -> Result<hrbfnpr_camera, String> {
    let (mut info, mut camera) = (new(hrbfnpr_model_info_init), new(hrbfnpr_camera_init));
    let (direction, up) = ([0.0, 1.0, -1.0], [0.0, 0.0, 1.0]);
    check(|error| unsafe { hrbfnpr_model_get_info(model, &mut info, error) })?;
    check(|error| unsafe {
        hrbfnpr_camera_fit_bounds(
            &mut camera, info.bounds_min.as_ptr(), info.bounds_max.as_ptr(), direction.as_ptr(), up.as_ptr(), 0.5,
            WIDTH as f64, HEIGHT as f64, 0.02, error,
        )
    })?;
    Ok(camera)
}

fn draw(numbers: &[f64]) -> Result<Vec<u8>, String> {
    let mut pixels = vec![0u8; 4 * WIDTH * HEIGHT];
    unsafe {
        let context = made(|out, error| hrbfnpr_context_create(null(), out, error))?;
        let model = fit(context, numbers)?;
        let (mut style, mut generate) = (new(hrbfnpr_style_init), new(hrbfnpr_generate_desc_init));
        let (size, preset) = (size_of::<hrbfnpr_style>() as u32, HRBFNPR_PRESET_CONTOUR_AND_STIPPLE);
        check(|error| hrbfnpr_style_init_preset(&mut style, size, preset, error))?;
        generate.layers = hrbfnpr_preset_layers(preset, &mut generate.layer_count);
        let marks =
            made(|out, error| hrbfnpr_point_set_generate(context, model, &generate, null_mut(), out, error))?;

        let (camera, mut item, mut image) = (camera(model)?, new(hrbfnpr_item_init), new(hrbfnpr_image_init));
        item.point_set = marks;
        item.style = &style;
        image.width = WIDTH as i32;
        image.height = HEIGHT as i32;
        image.pixels = pixels.as_mut_ptr().cast();
        let renderer = made(|out, error| hrbfnpr_renderer_create(context, out, error))?;
        let drawing = made(|out, error| hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, out, error))?;
        check(|error| hrbfnpr_drawing_rasterize(drawing, &image, null(), error))?;
        hrbfnpr_drawing_release(drawing);
        hrbfnpr_renderer_release(renderer);
        hrbfnpr_point_set_release(marks);
        hrbfnpr_model_release(model);
        hrbfnpr_context_release(context);
    }
    Ok(pixels)
}

fn main() {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    assert_eq!(unsafe { hrbfnpr_abi_version() }, HRBFNPR_ABI_VERSION);
    let text = std::fs::read_to_string(&paths[0]).expect("samples");
    let numbers: Vec<f64> = text.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    std::fs::write(&paths[1], draw(&numbers).expect("a drawing")).expect("a picture");
}
