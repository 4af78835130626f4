// Made by bindings/generate from bindings/api.json; do not edit.
//! Sizes, alignments and offsets as the C compiler has them; a crate that differs does not compile.
use super::*;
use core::mem::{align_of, size_of};

/// With 64-bit pointers, with 32-bit pointers, and with those of x86, whose f64 are aligned to 4.
#[allow(dead_code)] // of old compilers, which do not see it used
const fn either(lp64: usize, ilp32: usize, i386: usize) -> usize {
    if cfg!(target_pointer_width = "64") {
        lp64
    } else if cfg!(all(target_arch = "x86", not(windows))) {
        i386
    } else {
        ilp32
    }
}

const _: () = {
    assert!(size_of::<hrbfnpr_error>() == 256);
    assert!(align_of::<hrbfnpr_error>() == 4);
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_error, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_error, status) == 4);
    assert!(offset_of!(hrbfnpr_error, message) == 8);
};

const _: () = {
    assert!(size_of::<hrbfnpr_array>() == either(32, 32, 28));
    assert!(align_of::<hrbfnpr_array>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_array, data) == 0);
    assert!(offset_of!(hrbfnpr_array, count) == either(8, 8, 4));
    assert!(offset_of!(hrbfnpr_array, stride) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_array, scalar) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_array, components) == either(28, 28, 24));
};

const _: () = {
    assert!(size_of::<hrbfnpr_array_out>() == either(32, 32, 28));
    assert!(align_of::<hrbfnpr_array_out>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_array_out, data) == 0);
    assert!(offset_of!(hrbfnpr_array_out, count) == either(8, 8, 4));
    assert!(offset_of!(hrbfnpr_array_out, stride) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_array_out, scalar) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_array_out, components) == either(28, 28, 24));
};

const _: () = {
    assert!(size_of::<hrbfnpr_image>() == either(32, 32, 28));
    assert!(align_of::<hrbfnpr_image>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_image, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_image, format) == 4);
    assert!(offset_of!(hrbfnpr_image, width) == 8);
    assert!(offset_of!(hrbfnpr_image, height) == 12);
    assert!(offset_of!(hrbfnpr_image, pixels) == 16);
    assert!(offset_of!(hrbfnpr_image, row_stride) == either(24, 24, 20));
};

const _: () = {
    assert!(size_of::<hrbfnpr_context_desc>() == either(88, 60, 60));
    assert!(align_of::<hrbfnpr_context_desc>() == either(8, 4, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_context_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_context_desc, abi_version) == 4);
    assert!(offset_of!(hrbfnpr_context_desc, thread_count) == 8);
    assert!(offset_of!(hrbfnpr_context_desc, flags) == 12);
    assert!(offset_of!(hrbfnpr_context_desc, thread_backend) == 16);
    assert!(offset_of!(hrbfnpr_context_desc, highest_instruction_set) == 20);
    assert!(offset_of!(hrbfnpr_context_desc, allocate) == 24);
    assert!(offset_of!(hrbfnpr_context_desc, deallocate) == either(32, 28, 28));
    assert!(offset_of!(hrbfnpr_context_desc, allocator_user) == either(40, 32, 32));
    assert!(offset_of!(hrbfnpr_context_desc, log) == either(48, 36, 36));
    assert!(offset_of!(hrbfnpr_context_desc, log_user) == either(56, 40, 40));
    assert!(offset_of!(hrbfnpr_context_desc, log_level) == either(64, 44, 44));
    assert!(offset_of!(hrbfnpr_context_desc, reserved) == either(68, 48, 48));
    assert!(offset_of!(hrbfnpr_context_desc, run_tasks) == either(72, 52, 52));
    assert!(offset_of!(hrbfnpr_context_desc, run_tasks_user) == either(80, 56, 56));
};

const _: () = {
    assert!(size_of::<hrbfnpr_context_info>() == 32);
    assert!(align_of::<hrbfnpr_context_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_context_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_context_info, thread_count) == 4);
    assert!(offset_of!(hrbfnpr_context_info, instruction_set) == 8);
    assert!(offset_of!(hrbfnpr_context_info, thread_backend) == 12);
    assert!(offset_of!(hrbfnpr_context_info, bytes_now) == 16);
    assert!(offset_of!(hrbfnpr_context_info, bytes_peak) == 24);
};

const _: () = {
    assert!(size_of::<hrbfnpr_fit_desc>() == either(144, 144, 136));
    assert!(align_of::<hrbfnpr_fit_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_fit_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_fit_desc, kernel) == 4);
    assert!(offset_of!(hrbfnpr_fit_desc, points) == 8);
    assert!(offset_of!(hrbfnpr_fit_desc, normals) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_fit_desc, kernel_radius) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_fit_desc, polynomial_degree) == either(80, 80, 72));
    assert!(offset_of!(hrbfnpr_fit_desc, regularization_mode) == either(84, 84, 76));
    assert!(offset_of!(hrbfnpr_fit_desc, regularization) == either(88, 88, 80));
    assert!(offset_of!(hrbfnpr_fit_desc, outliers) == either(96, 96, 88));
    assert!(offset_of!(hrbfnpr_fit_desc, flipped_normals) == either(100, 100, 92));
    assert!(offset_of!(hrbfnpr_fit_desc, tolerance) == either(104, 104, 96));
    assert!(offset_of!(hrbfnpr_fit_desc, maximum_centres) == either(112, 112, 104));
    assert!(offset_of!(hrbfnpr_fit_desc, solver) == either(120, 120, 112));
    assert!(offset_of!(hrbfnpr_fit_desc, refinement_steps) == either(124, 124, 116));
    assert!(offset_of!(hrbfnpr_fit_desc, solver_tolerance) == either(128, 128, 120));
    assert!(offset_of!(hrbfnpr_fit_desc, iteration_limit) == either(136, 136, 128));
    assert!(offset_of!(hrbfnpr_fit_desc, preconditioner_neighbours) == either(140, 140, 132));
};

const _: () = {
    assert!(size_of::<hrbfnpr_custom_desc>() == either(88, 80, 76));
    assert!(align_of::<hrbfnpr_custom_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_custom_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_custom_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_custom_desc, function) == 8);
    assert!(offset_of!(hrbfnpr_custom_desc, user) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_custom_desc, release) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_custom_desc, bounds_min) == either(32, 24, 20));
    assert!(offset_of!(hrbfnpr_custom_desc, bounds_max) == either(56, 48, 44));
    assert!(offset_of!(hrbfnpr_custom_desc, difference_step) == either(80, 72, 68));
};

const _: () = {
    assert!(size_of::<hrbfnpr_model_info>() == 320);
    assert!(align_of::<hrbfnpr_model_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_model_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_model_info, kernel) == 4);
    assert!(offset_of!(hrbfnpr_model_info, polynomial_degree) == 8);
    assert!(offset_of!(hrbfnpr_model_info, choice_rounds) == 12);
    assert!(offset_of!(hrbfnpr_model_info, samples) == 16);
    assert!(offset_of!(hrbfnpr_model_info, centres) == 24);
    assert!(offset_of!(hrbfnpr_model_info, merged_samples) == 32);
    assert!(offset_of!(hrbfnpr_model_info, near_duplicates) == 40);
    assert!(offset_of!(hrbfnpr_model_info, rescaled_normals) == 48);
    assert!(offset_of!(hrbfnpr_model_info, outliers_found) == 56);
    assert!(offset_of!(hrbfnpr_model_info, outliers_dropped) == 64);
    assert!(offset_of!(hrbfnpr_model_info, flipped_found) == 72);
    assert!(offset_of!(hrbfnpr_model_info, flipped_repaired) == 80);
    assert!(offset_of!(hrbfnpr_model_info, bounds_min) == 88);
    assert!(offset_of!(hrbfnpr_model_info, bounds_max) == 112);
    assert!(offset_of!(hrbfnpr_model_info, spacing) == 136);
    assert!(offset_of!(hrbfnpr_model_info, kernel_radius) == 144);
    assert!(offset_of!(hrbfnpr_model_info, regularization) == 152);
    assert!(offset_of!(hrbfnpr_model_info, noise_estimate) == 160);
    assert!(offset_of!(hrbfnpr_model_info, value_residual_max) == 168);
    assert!(offset_of!(hrbfnpr_model_info, value_residual_rms) == 176);
    assert!(offset_of!(hrbfnpr_model_info, gradient_residual_max) == 184);
    assert!(offset_of!(hrbfnpr_model_info, gradient_residual_rms) == 192);
    assert!(offset_of!(hrbfnpr_model_info, input_distance_max) == 200);
    assert!(offset_of!(hrbfnpr_model_info, input_distance_rms) == 208);
    assert!(offset_of!(hrbfnpr_model_info, input_share_within) == 216);
    assert!(offset_of!(hrbfnpr_model_info, solver) == 224);
    assert!(offset_of!(hrbfnpr_model_info, solver_reason) == 228);
    assert!(offset_of!(hrbfnpr_model_info, iterations) == 232);
    assert!(offset_of!(hrbfnpr_model_info, fallback) == 236);
    assert!(offset_of!(hrbfnpr_model_info, solver_residual) == 240);
    assert!(offset_of!(hrbfnpr_model_info, condition_estimate) == 248);
    assert!(offset_of!(hrbfnpr_model_info, seconds_clean) == 256);
    assert!(offset_of!(hrbfnpr_model_info, seconds_choose) == 264);
    assert!(offset_of!(hrbfnpr_model_info, seconds_assemble) == 272);
    assert!(offset_of!(hrbfnpr_model_info, seconds_precondition) == 280);
    assert!(offset_of!(hrbfnpr_model_info, seconds_solve) == 288);
    assert!(offset_of!(hrbfnpr_model_info, seconds_total) == 296);
    assert!(offset_of!(hrbfnpr_model_info, bytes) == 304);
    assert!(offset_of!(hrbfnpr_model_info, peak_bytes) == 312);
};

const _: () = {
    assert!(size_of::<hrbfnpr_project_desc>() == 32);
    assert!(align_of::<hrbfnpr_project_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_project_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_project_desc, evaluation_limit) == 4);
    assert!(offset_of!(hrbfnpr_project_desc, tolerance) == 8);
    assert!(offset_of!(hrbfnpr_project_desc, armijo_slope) == 16);
    assert!(offset_of!(hrbfnpr_project_desc, armijo_factor) == 24);
};

const _: () = {
    assert!(size_of::<hrbfnpr_projection>() == either(112, 112, 100));
    assert!(align_of::<hrbfnpr_projection>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_projection, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_projection, reserved) == 4);
    assert!(offset_of!(hrbfnpr_projection, position) == 8);
    assert!(offset_of!(hrbfnpr_projection, normal) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_projection, status) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_projection, converged) == either(104, 104, 92));
};

const _: () = {
    assert!(size_of::<hrbfnpr_curvature>() == either(168, 168, 148));
    assert!(align_of::<hrbfnpr_curvature>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_curvature, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_curvature, reserved) == 4);
    assert!(offset_of!(hrbfnpr_curvature, k1) == 8);
    assert!(offset_of!(hrbfnpr_curvature, k2) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_curvature, d1) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_curvature, d2) == either(104, 104, 92));
    assert!(offset_of!(hrbfnpr_curvature, confidence) == either(136, 136, 120));
};

const _: () = {
    assert!(size_of::<hrbfnpr_cast_desc>() == 56);
    assert!(align_of::<hrbfnpr_cast_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_cast_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_cast_desc, maximum_hits) == 4);
    assert!(offset_of!(hrbfnpr_cast_desc, evaluation_limit) == 8);
    assert!(offset_of!(hrbfnpr_cast_desc, reserved) == 12);
    assert!(offset_of!(hrbfnpr_cast_desc, t_min) == 16);
    assert!(offset_of!(hrbfnpr_cast_desc, t_max) == 24);
    assert!(offset_of!(hrbfnpr_cast_desc, lipschitz) == 32);
    assert!(offset_of!(hrbfnpr_cast_desc, smallest_step) == 40);
    assert!(offset_of!(hrbfnpr_cast_desc, tolerance) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_ray_hits>() == either(208, 208, 184));
    assert!(align_of::<hrbfnpr_ray_hits>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_ray_hits, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_ray_hits, reserved) == 4);
    assert!(offset_of!(hrbfnpr_ray_hits, count) == 8);
    assert!(offset_of!(hrbfnpr_ray_hits, t) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_ray_hits, position) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_ray_hits, normal) == either(104, 104, 92));
    assert!(offset_of!(hrbfnpr_ray_hits, entering) == either(136, 136, 120));
    assert!(offset_of!(hrbfnpr_ray_hits, status) == either(168, 168, 148));
    assert!(offset_of!(hrbfnpr_ray_hits, hit_rays) == either(200, 200, 176));
};

const _: () = {
    assert!(size_of::<hrbfnpr_group_desc>() == 24);
    assert!(align_of::<hrbfnpr_group_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_group_desc, levels) == 0);
    assert!(offset_of!(hrbfnpr_group_desc, seeds) == 4);
    assert!(offset_of!(hrbfnpr_group_desc, seed_level) == 8);
    assert!(offset_of!(hrbfnpr_group_desc, reserved) == 12);
    assert!(offset_of!(hrbfnpr_group_desc, budget) == 16);
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer>() == 8);
    assert!(align_of::<hrbfnpr_layer>() == 4);
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer, begin) == 0);
    assert!(offset_of!(hrbfnpr_layer, end) == 4);
};

const _: () = {
    assert!(size_of::<hrbfnpr_generate_desc>() == either(272, 264, 260));
    assert!(align_of::<hrbfnpr_generate_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_generate_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_generate_desc, groups) == 4);
    assert!(offset_of!(hrbfnpr_generate_desc, distribution) == 8);
    assert!(offset_of!(hrbfnpr_generate_desc, seed_source) == 12);
    assert!(offset_of!(hrbfnpr_generate_desc, flags) == 16);
    assert!(offset_of!(hrbfnpr_generate_desc, box_resolution) == 20);
    assert!(offset_of!(hrbfnpr_generate_desc, box_jitter) == 24);
    assert!(offset_of!(hrbfnpr_generate_desc, initial_step) == 32);
    assert!(offset_of!(hrbfnpr_generate_desc, projection_tolerance) == 40);
    assert!(offset_of!(hrbfnpr_generate_desc, random_seed) == 48);
    assert!(offset_of!(hrbfnpr_generate_desc, seed_points) == 56);
    assert!(offset_of!(hrbfnpr_generate_desc, group) == either(88, 88, 84));
    assert!(offset_of!(hrbfnpr_generate_desc, stroke_separation) == either(160, 160, 156));
    assert!(offset_of!(hrbfnpr_generate_desc, stroke_step) == either(168, 168, 164));
    assert!(offset_of!(hrbfnpr_generate_desc, stroke_length) == either(176, 176, 172));
    assert!(offset_of!(hrbfnpr_generate_desc, stroke_field) == either(184, 184, 180));
    assert!(offset_of!(hrbfnpr_generate_desc, density) == either(188, 188, 184));
    assert!(offset_of!(hrbfnpr_generate_desc, density_strength) == either(192, 192, 188));
    assert!(offset_of!(hrbfnpr_generate_desc, density_function) == either(200, 200, 196));
    assert!(offset_of!(hrbfnpr_generate_desc, density_user) == either(208, 204, 200));
    assert!(offset_of!(hrbfnpr_generate_desc, order) == either(216, 208, 204));
    assert!(offset_of!(hrbfnpr_generate_desc, reserved2) == either(220, 212, 208));
    assert!(offset_of!(hrbfnpr_generate_desc, shared_budget) == either(224, 216, 212));
    assert!(offset_of!(hrbfnpr_generate_desc, layer) == either(232, 224, 220));
};

const _: () = {
    assert!(size_of::<hrbfnpr_group_arrays>() == either(256, 256, 224));
    assert!(align_of::<hrbfnpr_group_arrays>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_group_arrays, position) == 0);
    assert!(offset_of!(hrbfnpr_group_arrays, normal) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_group_arrays, direction) == either(64, 64, 56));
    assert!(offset_of!(hrbfnpr_group_arrays, curvature) == either(96, 96, 84));
    assert!(offset_of!(hrbfnpr_group_arrays, rank) == either(128, 128, 112));
    assert!(offset_of!(hrbfnpr_group_arrays, level) == either(160, 160, 140));
    assert!(offset_of!(hrbfnpr_group_arrays, stroke) == either(192, 192, 168));
    assert!(offset_of!(hrbfnpr_group_arrays, width) == either(224, 224, 196));
};

const _: () = {
    assert!(size_of::<hrbfnpr_point_set_desc>() == either(784, 784, 688));
    assert!(align_of::<hrbfnpr_point_set_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_point_set_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_point_set_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_point_set_desc, random_seed) == 8);
    assert!(offset_of!(hrbfnpr_point_set_desc, group) == 16);
};

const _: () = {
    assert!(size_of::<hrbfnpr_level_info>() == 48);
    assert!(align_of::<hrbfnpr_level_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_level_info, attempted) == 0);
    assert!(offset_of!(hrbfnpr_level_info, placed) == 8);
    assert!(offset_of!(hrbfnpr_level_info, dropped_not_converged) == 16);
    assert!(offset_of!(hrbfnpr_level_info, dropped_strayed) == 24);
    assert!(offset_of!(hrbfnpr_level_info, dropped_degenerate) == 32);
    assert!(offset_of!(hrbfnpr_level_info, dropped_budget) == 40);
};

const _: () = {
    assert!(size_of::<hrbfnpr_group_info>() == 672);
    assert!(align_of::<hrbfnpr_group_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_group_info, count) == 0);
    assert!(offset_of!(hrbfnpr_group_info, strokes) == 8);
    assert!(offset_of!(hrbfnpr_group_info, full_count) == 16);
    assert!(offset_of!(hrbfnpr_group_info, levels) == 24);
    assert!(offset_of!(hrbfnpr_group_info, reserved) == 28);
    assert!(offset_of!(hrbfnpr_group_info, step) == 32);
    assert!(offset_of!(hrbfnpr_group_info, seconds) == 40);
    assert!(offset_of!(hrbfnpr_group_info, level) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_point_set_info>() == 2184);
    assert!(align_of::<hrbfnpr_point_set_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_point_set_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_point_set_info, distribution) == 4);
    assert!(offset_of!(hrbfnpr_point_set_info, seed_source) == 8);
    assert!(offset_of!(hrbfnpr_point_set_info, reserved) == 12);
    assert!(offset_of!(hrbfnpr_point_set_info, origin) == 16);
    assert!(offset_of!(hrbfnpr_point_set_info, bounds_min) == 40);
    assert!(offset_of!(hrbfnpr_point_set_info, bounds_max) == 64);
    assert!(offset_of!(hrbfnpr_point_set_info, spacing) == 88);
    assert!(offset_of!(hrbfnpr_point_set_info, seconds_seeds) == 96);
    assert!(offset_of!(hrbfnpr_point_set_info, seconds_total) == 104);
    assert!(offset_of!(hrbfnpr_point_set_info, bytes) == 112);
    assert!(offset_of!(hrbfnpr_point_set_info, seeds) == 120);
    assert!(offset_of!(hrbfnpr_point_set_info, group) == 168);
};

const _: () = {
    assert!(size_of::<hrbfnpr_camera>() == 296);
    assert!(align_of::<hrbfnpr_camera>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_camera, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_camera, depth_convention) == 4);
    assert!(offset_of!(hrbfnpr_camera, view) == 8);
    assert!(offset_of!(hrbfnpr_camera, projection) == 136);
    assert!(offset_of!(hrbfnpr_camera, viewport) == 264);
};

const _: () = {
    assert!(size_of::<hrbfnpr_group_style>() == 36);
    assert!(align_of::<hrbfnpr_group_style>() == 4);
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_group_style, shown) == 0);
    assert!(offset_of!(hrbfnpr_group_style, sets) == 4);
    assert!(offset_of!(hrbfnpr_group_style, share) == 8);
    assert!(offset_of!(hrbfnpr_group_style, radius) == 12);
    assert!(offset_of!(hrbfnpr_group_style, radius_zoom) == 16);
    assert!(offset_of!(hrbfnpr_group_style, ink) == 20);
};

const _: () = {
    assert!(size_of::<hrbfnpr_style>() == either(312, 304, 300));
    assert!(align_of::<hrbfnpr_style>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_style, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_style, hidden_lines) == 4);
    assert!(offset_of!(hrbfnpr_style, silhouette_threshold) == 8);
    assert!(offset_of!(hrbfnpr_style, attenuation_front) == 16);
    assert!(offset_of!(hrbfnpr_style, attenuation_back) == 24);
    assert!(offset_of!(hrbfnpr_style, cover_radius) == 32);
    assert!(offset_of!(hrbfnpr_style, halo_width) == 36);
    assert!(offset_of!(hrbfnpr_style, cover_layers) == 40);
    assert!(offset_of!(hrbfnpr_style, visibility) == 44);
    assert!(offset_of!(hrbfnpr_style, tone) == 48);
    assert!(offset_of!(hrbfnpr_style, tone_rule) == 52);
    assert!(offset_of!(hrbfnpr_style, light_space) == 56);
    assert!(offset_of!(hrbfnpr_style, silhouette_groups) == 60);
    assert!(offset_of!(hrbfnpr_style, light) == 64);
    assert!(offset_of!(hrbfnpr_style, tone_exponent) == 88);
    assert!(offset_of!(hrbfnpr_style, tone_function) == 96);
    assert!(offset_of!(hrbfnpr_style, tone_user) == either(104, 100, 100));
    assert!(offset_of!(hrbfnpr_style, depth_min) == either(112, 104, 104));
    assert!(offset_of!(hrbfnpr_style, depth_max) == either(120, 112, 112));
    assert!(offset_of!(hrbfnpr_style, zoom_reference) == either(128, 120, 120));
    assert!(offset_of!(hrbfnpr_style, zoom_exponent) == either(136, 128, 128));
    assert!(offset_of!(hrbfnpr_style, paper) == either(144, 136, 136));
    assert!(offset_of!(hrbfnpr_style, silhouette_ink) == either(160, 152, 152));
    assert!(offset_of!(hrbfnpr_style, silhouette_radius) == either(176, 168, 168));
    assert!(offset_of!(hrbfnpr_style, silhouette_radius_zoom) == either(180, 172, 172));
    assert!(offset_of!(hrbfnpr_style, group) == either(184, 176, 176));
    assert!(offset_of!(hrbfnpr_style, tone_curve) == either(292, 284, 284));
    assert!(offset_of!(hrbfnpr_style, silhouette_law) == either(296, 288, 288));
    assert!(offset_of!(hrbfnpr_style, tone_fade) == either(300, 292, 292));
    assert!(offset_of!(hrbfnpr_style, silhouette_width) == either(304, 296, 296));
};

const _: () = {
    assert!(size_of::<hrbfnpr_item>() == either(160, 152, 148));
    assert!(align_of::<hrbfnpr_item>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_item, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_item, reserved) == 4);
    assert!(offset_of!(hrbfnpr_item, point_set) == 8);
    assert!(offset_of!(hrbfnpr_item, style) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_item, transform) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_item, model) == either(152, 144, 144));
};

const _: () = {
    assert!(size_of::<hrbfnpr_frame_info>() == 144);
    assert!(align_of::<hrbfnpr_frame_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_frame_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_frame_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_frame_info, marks) == 8);
    assert!(offset_of!(hrbfnpr_frame_info, outside) == 16);
    assert!(offset_of!(hrbfnpr_frame_info, front) == 24);
    assert!(offset_of!(hrbfnpr_frame_info, back) == 32);
    assert!(offset_of!(hrbfnpr_frame_info, silhouette) == 40);
    assert!(offset_of!(hrbfnpr_frame_info, shown) == 48);
    assert!(offset_of!(hrbfnpr_frame_info, dropped_tone) == 56);
    assert!(offset_of!(hrbfnpr_frame_info, dropped_depth) == 64);
    assert!(offset_of!(hrbfnpr_frame_info, dropped_zoom) == 72);
    assert!(offset_of!(hrbfnpr_frame_info, dropped_hidden) == 80);
    assert!(offset_of!(hrbfnpr_frame_info, painted) == 88);
    assert!(offset_of!(hrbfnpr_frame_info, nanoseconds_classify) == 96);
    assert!(offset_of!(hrbfnpr_frame_info, nanoseconds_visibility) == 104);
    assert!(offset_of!(hrbfnpr_frame_info, nanoseconds_sort) == 112);
    assert!(offset_of!(hrbfnpr_frame_info, nanoseconds_draw) == 120);
    assert!(offset_of!(hrbfnpr_frame_info, scratch_bytes) == 128);
    assert!(offset_of!(hrbfnpr_frame_info, culled) == 136);
};

const _: () = {
    assert!(size_of::<hrbfnpr_draw_desc>() == either(136, 136, 120));
    assert!(align_of::<hrbfnpr_draw_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_draw_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_draw_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_draw_desc, host_depth) == 8);
    assert!(offset_of!(hrbfnpr_draw_desc, depth) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_draw_desc, id) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_draw_desc, class_) == either(104, 104, 92));
};

const _: () = {
    assert!(size_of::<hrbfnpr_vertex_attribute>() == 16);
    assert!(align_of::<hrbfnpr_vertex_attribute>() == 4);
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_vertex_attribute, attribute) == 0);
    assert!(offset_of!(hrbfnpr_vertex_attribute, scalar) == 4);
    assert!(offset_of!(hrbfnpr_vertex_attribute, offset) == 8);
    assert!(offset_of!(hrbfnpr_vertex_attribute, reserved) == 12);
};

const _: () = {
    assert!(size_of::<hrbfnpr_vertex_layout>() == 272);
    assert!(align_of::<hrbfnpr_vertex_layout>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_vertex_layout, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_vertex_layout, attribute_count) == 4);
    assert!(offset_of!(hrbfnpr_vertex_layout, stride) == 8);
    assert!(offset_of!(hrbfnpr_vertex_layout, attributes) == 16);
};
