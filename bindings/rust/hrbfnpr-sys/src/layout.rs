// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
//! Compares sizes, alignments and offsets with those of the C compiler.  The crate does not compile if one differs.
use super::*;
use core::mem::{align_of, size_of};

/// Returns the number for 64-bit pointers, for 32-bit pointers, or for 32-bit x86, which aligns f64 to 4 bytes.
#[allow(dead_code)] // old compilers do not see its uses
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
    assert!(size_of::<hrbfnpr_fit_desc>() == either(152, 152, 144));
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
    assert!(offset_of!(hrbfnpr_fit_desc, normal_mode) == either(144, 144, 136));
    assert!(offset_of!(hrbfnpr_fit_desc, trim) == either(148, 148, 140));
};

const _: () = {
    assert!(size_of::<hrbfnpr_orient_desc>() == either(128, 128, 120));
    assert!(align_of::<hrbfnpr_orient_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_orient_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_orient_desc, mode) == 4);
    assert!(offset_of!(hrbfnpr_orient_desc, points) == 8);
    assert!(offset_of!(hrbfnpr_orient_desc, normals) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_orient_desc, up) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_orient_desc, viewpoint) == either(96, 96, 88));
    assert!(offset_of!(hrbfnpr_orient_desc, has_viewpoint) == either(120, 120, 112));
    assert!(offset_of!(hrbfnpr_orient_desc, reserved) == either(124, 124, 116));
};

const _: () = {
    assert!(size_of::<hrbfnpr_orient_info>() == 96);
    assert!(align_of::<hrbfnpr_orient_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_orient_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_orient_info, found) == 4);
    assert!(offset_of!(hrbfnpr_orient_info, turned) == 8);
    assert!(offset_of!(hrbfnpr_orient_info, made) == 16);
    assert!(offset_of!(hrbfnpr_orient_info, merged) == 24);
    assert!(offset_of!(hrbfnpr_orient_info, direction_change) == 32);
    assert!(offset_of!(hrbfnpr_orient_info, noise) == 40);
    assert!(offset_of!(hrbfnpr_orient_info, spacing) == 48);
    assert!(offset_of!(hrbfnpr_orient_info, energy) == 56);
    assert!(offset_of!(hrbfnpr_orient_info, confidence) == 64);
    assert!(offset_of!(hrbfnpr_orient_info, closed) == 72);
    assert!(offset_of!(hrbfnpr_orient_info, outward_by) == 76);
    assert!(offset_of!(hrbfnpr_orient_info, components) == 80);
    assert!(offset_of!(hrbfnpr_orient_info, seconds) == 88);
};

const _: () = {
    assert!(size_of::<hrbfnpr_depth_image_desc>() == either(64, 64, 60));
    assert!(align_of::<hrbfnpr_depth_image_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_depth_image_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_depth_image_desc, columns) == 4);
    assert!(offset_of!(hrbfnpr_depth_image_desc, rows) == 8);
    assert!(offset_of!(hrbfnpr_depth_image_desc, keep_points) == 12);
    assert!(offset_of!(hrbfnpr_depth_image_desc, points) == 16);
    assert!(offset_of!(hrbfnpr_depth_image_desc, noise) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_depth_image_desc, smoothing) == either(56, 56, 52));
};

const _: () = {
    assert!(size_of::<hrbfnpr_depth_image_info>() == 64);
    assert!(align_of::<hrbfnpr_depth_image_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_depth_image_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_depth_image_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_depth_image_info, seen) == 8);
    assert!(offset_of!(hrbfnpr_depth_image_info, left_out) == 16);
    assert!(offset_of!(hrbfnpr_depth_image_info, noise) == 24);
    assert!(offset_of!(hrbfnpr_depth_image_info, focal_length) == 32);
    assert!(offset_of!(hrbfnpr_depth_image_info, depth) == 40);
    assert!(offset_of!(hrbfnpr_depth_image_info, radius) == 48);
    assert!(offset_of!(hrbfnpr_depth_image_info, seconds) == 56);
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
    assert!(size_of::<hrbfnpr_model_info>() == 352);
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
    assert!(offset_of!(hrbfnpr_model_info, normals_found) == 320);
    assert!(offset_of!(hrbfnpr_model_info, normals_inward) == 324);
    assert!(offset_of!(hrbfnpr_model_info, normals_turned) == 328);
    assert!(offset_of!(hrbfnpr_model_info, normals_confidence) == 336);
    assert!(offset_of!(hrbfnpr_model_info, seconds_orient) == 344);
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
    assert!(size_of::<hrbfnpr_cast_desc>() == either(72, 72, 68));
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
    assert!(offset_of!(hrbfnpr_cast_desc, line_set) == 56);
    assert!(offset_of!(hrbfnpr_cast_desc, refine) == either(64, 60, 60));
    assert!(offset_of!(hrbfnpr_cast_desc, reserved2) == either(68, 64, 64));
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
    assert!(size_of::<hrbfnpr_trim_desc>() == either(96, 96, 88));
    assert!(align_of::<hrbfnpr_trim_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_trim_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_trim_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_trim_desc, limit) == 8);
    assert!(offset_of!(hrbfnpr_trim_desc, hole) == 16);
    assert!(offset_of!(hrbfnpr_trim_desc, closest) == 24);
    assert!(offset_of!(hrbfnpr_trim_desc, points) == 32);
    assert!(offset_of!(hrbfnpr_trim_desc, normals) == either(64, 64, 60));
};

const _: () = {
    assert!(size_of::<hrbfnpr_trim_info>() == 56);
    assert!(align_of::<hrbfnpr_trim_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_trim_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_trim_info, is_trimmed) == 4);
    assert!(offset_of!(hrbfnpr_trim_info, samples) == 8);
    assert!(offset_of!(hrbfnpr_trim_info, parts) == 16);
    assert!(offset_of!(hrbfnpr_trim_info, parts_to_end) == 24);
    assert!(offset_of!(hrbfnpr_trim_info, share) == 32);
    assert!(offset_of!(hrbfnpr_trim_info, farthest) == 40);
    assert!(offset_of!(hrbfnpr_trim_info, spacing) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_csg_node>() == either(224, 224, 220));
    assert!(align_of::<hrbfnpr_csg_node>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_csg_node, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_csg_node, kind) == 4);
    assert!(offset_of!(hrbfnpr_csg_node, parent) == 8);
    assert!(offset_of!(hrbfnpr_csg_node, model) == 16);
    assert!(offset_of!(hrbfnpr_csg_node, transform) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_csg_node, size) == either(152, 152, 148));
    assert!(offset_of!(hrbfnpr_csg_node, radius) == either(176, 176, 172));
    assert!(offset_of!(hrbfnpr_csg_node, second_radius) == either(184, 184, 180));
    assert!(offset_of!(hrbfnpr_csg_node, height) == either(192, 192, 188));
    assert!(offset_of!(hrbfnpr_csg_node, distance) == either(200, 200, 196));
    assert!(offset_of!(hrbfnpr_csg_node, blend) == either(208, 208, 204));
    assert!(offset_of!(hrbfnpr_csg_node, exponent) == either(216, 216, 212));
};

const _: () = {
    assert!(size_of::<hrbfnpr_csg_desc>() == either(80, 80, 76));
    assert!(align_of::<hrbfnpr_csg_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_csg_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_csg_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_csg_desc, nodes) == 8);
    assert!(offset_of!(hrbfnpr_csg_desc, node_count) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_csg_desc, node_stride) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_csg_desc, bounds_min) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_csg_desc, bounds_max) == either(56, 56, 52));
};

const _: () = {
    assert!(size_of::<hrbfnpr_csg_info>() == 48);
    assert!(align_of::<hrbfnpr_csg_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_csg_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_csg_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_csg_info, nodes) == 8);
    assert!(offset_of!(hrbfnpr_csg_info, depth) == 16);
    assert!(offset_of!(hrbfnpr_csg_info, models) == 24);
    assert!(offset_of!(hrbfnpr_csg_info, sheets) == 32);
    assert!(offset_of!(hrbfnpr_csg_info, lipschitz) == 40);
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer_desc>() == either(224, 200, 196));
    assert!(align_of::<hrbfnpr_layer_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_layer_desc, kind) == 4);
    assert!(offset_of!(hrbfnpr_layer_desc, name) == 8);
    assert!(offset_of!(hrbfnpr_layer_desc, budget) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_layer_desc, tone_begin) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_layer_desc, tone_end) == either(28, 28, 24));
    assert!(offset_of!(hrbfnpr_layer_desc, second_tone_begin) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_layer_desc, second_tone_end) == either(36, 36, 32));
    assert!(offset_of!(hrbfnpr_layer_desc, flags) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_layer_desc, density) == either(44, 44, 40));
    assert!(offset_of!(hrbfnpr_layer_desc, density_strength) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_layer_desc, density_function) == either(56, 56, 52));
    assert!(offset_of!(hrbfnpr_layer_desc, density_user) == either(64, 60, 56));
    assert!(offset_of!(hrbfnpr_layer_desc, direction_function) == either(72, 64, 60));
    assert!(offset_of!(hrbfnpr_layer_desc, direction_user) == either(80, 68, 64));
    assert!(offset_of!(hrbfnpr_layer_desc, guide) == either(88, 72, 68));
    assert!(offset_of!(hrbfnpr_layer_desc, start) == either(92, 76, 72));
    assert!(offset_of!(hrbfnpr_layer_desc, start_level) == either(96, 80, 76));
    assert!(offset_of!(hrbfnpr_layer_desc, levels) == either(100, 84, 80));
    assert!(offset_of!(hrbfnpr_layer_desc, separation) == either(104, 88, 84));
    assert!(offset_of!(hrbfnpr_layer_desc, step) == either(112, 96, 92));
    assert!(offset_of!(hrbfnpr_layer_desc, angle) == either(120, 104, 100));
    assert!(offset_of!(hrbfnpr_layer_desc, smoothing) == either(128, 112, 108));
    assert!(offset_of!(hrbfnpr_layer_desc, axis) == either(136, 120, 116));
    assert!(offset_of!(hrbfnpr_layer_desc, axis_weight) == either(160, 144, 140));
    assert!(offset_of!(hrbfnpr_layer_desc, guide_direction) == either(168, 152, 148));
    assert!(offset_of!(hrbfnpr_layer_desc, guide_weight) == either(192, 176, 172));
    assert!(offset_of!(hrbfnpr_layer_desc, tone_smoothing) == either(200, 184, 180));
    assert!(offset_of!(hrbfnpr_layer_desc, density_field) == either(208, 192, 188));
    assert!(offset_of!(hrbfnpr_layer_desc, direction_field) == either(216, 196, 192));
};

const _: () = {
    assert!(size_of::<hrbfnpr_generate_desc>() == either(120, 120, 112));
    assert!(align_of::<hrbfnpr_generate_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_generate_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_generate_desc, distribution) == 4);
    assert!(offset_of!(hrbfnpr_generate_desc, layers) == 8);
    assert!(offset_of!(hrbfnpr_generate_desc, layer_count) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_generate_desc, layer_stride) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_generate_desc, shared_budget) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_generate_desc, tone_ranges) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_generate_desc, seed_source) == either(44, 44, 40));
    assert!(offset_of!(hrbfnpr_generate_desc, seed_points) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_generate_desc, box_jitter) == either(80, 80, 72));
    assert!(offset_of!(hrbfnpr_generate_desc, box_resolution) == either(88, 88, 80));
    assert!(offset_of!(hrbfnpr_generate_desc, reserved) == either(92, 92, 84));
    assert!(offset_of!(hrbfnpr_generate_desc, initial_step) == either(96, 96, 88));
    assert!(offset_of!(hrbfnpr_generate_desc, projection_tolerance) == either(104, 104, 96));
    assert!(offset_of!(hrbfnpr_generate_desc, random_seed) == either(112, 112, 104));
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer_arrays>() == either(304, 304, 264));
    assert!(align_of::<hrbfnpr_layer_arrays>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer_arrays, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_layer_arrays, kind) == 4);
    assert!(offset_of!(hrbfnpr_layer_arrays, name) == 8);
    assert!(offset_of!(hrbfnpr_layer_arrays, position) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_layer_arrays, normal) == either(48, 48, 40));
    assert!(offset_of!(hrbfnpr_layer_arrays, stroke_first) == either(80, 80, 68));
    assert!(offset_of!(hrbfnpr_layer_arrays, stroke_direction) == either(112, 112, 96));
    assert!(offset_of!(hrbfnpr_layer_arrays, direction) == either(144, 144, 124));
    assert!(offset_of!(hrbfnpr_layer_arrays, curvature) == either(176, 176, 152));
    assert!(offset_of!(hrbfnpr_layer_arrays, rank) == either(208, 208, 180));
    assert!(offset_of!(hrbfnpr_layer_arrays, level) == either(240, 240, 208));
    assert!(offset_of!(hrbfnpr_layer_arrays, width) == either(272, 272, 236));
};

const _: () = {
    assert!(size_of::<hrbfnpr_point_set_desc>() == either(48, 40, 40));
    assert!(align_of::<hrbfnpr_point_set_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_point_set_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_point_set_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_point_set_desc, base) == 8);
    assert!(offset_of!(hrbfnpr_point_set_desc, layers) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_point_set_desc, layer_count) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_point_set_desc, layer_stride) == either(32, 24, 24));
    assert!(offset_of!(hrbfnpr_point_set_desc, random_seed) == either(40, 32, 32));
};

const _: () = {
    assert!(size_of::<hrbfnpr_point_set_info>() == 144);
    assert!(align_of::<hrbfnpr_point_set_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_point_set_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_point_set_info, distribution) == 4);
    assert!(offset_of!(hrbfnpr_point_set_info, seed_source) == 8);
    assert!(offset_of!(hrbfnpr_point_set_info, reserved) == 12);
    assert!(offset_of!(hrbfnpr_point_set_info, layers) == 16);
    assert!(offset_of!(hrbfnpr_point_set_info, marks) == 24);
    assert!(offset_of!(hrbfnpr_point_set_info, origin) == 32);
    assert!(offset_of!(hrbfnpr_point_set_info, bounds_min) == 56);
    assert!(offset_of!(hrbfnpr_point_set_info, bounds_max) == 80);
    assert!(offset_of!(hrbfnpr_point_set_info, spacing) == 104);
    assert!(offset_of!(hrbfnpr_point_set_info, seconds_seeds) == 112);
    assert!(offset_of!(hrbfnpr_point_set_info, seconds_total) == 120);
    assert!(offset_of!(hrbfnpr_point_set_info, bytes) == 128);
    assert!(offset_of!(hrbfnpr_point_set_info, field_count) == 136);
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer_info>() == 120);
    assert!(align_of::<hrbfnpr_layer_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_layer_info, kind) == 4);
    assert!(offset_of!(hrbfnpr_layer_info, name) == 8);
    assert!(offset_of!(hrbfnpr_layer_info, marks) == 72);
    assert!(offset_of!(hrbfnpr_layer_info, strokes) == 80);
    assert!(offset_of!(hrbfnpr_layer_info, full_count) == 88);
    assert!(offset_of!(hrbfnpr_layer_info, levels) == 96);
    assert!(offset_of!(hrbfnpr_layer_info, reserved) == 100);
    assert!(offset_of!(hrbfnpr_layer_info, step) == 104);
    assert!(offset_of!(hrbfnpr_layer_info, seconds) == 112);
};

const _: () = {
    assert!(size_of::<hrbfnpr_placement_info>() == 56);
    assert!(align_of::<hrbfnpr_placement_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_placement_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_placement_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_placement_info, attempted) == 8);
    assert!(offset_of!(hrbfnpr_placement_info, placed) == 16);
    assert!(offset_of!(hrbfnpr_placement_info, dropped_not_converged) == 24);
    assert!(offset_of!(hrbfnpr_placement_info, dropped_strayed) == 32);
    assert!(offset_of!(hrbfnpr_placement_info, dropped_degenerate) == 40);
    assert!(offset_of!(hrbfnpr_placement_info, dropped_budget) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mark_field>() == either(32, 20, 20));
    assert!(align_of::<hrbfnpr_mark_field>() == either(8, 4, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mark_field, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mark_field, reserved) == 4);
    assert!(offset_of!(hrbfnpr_mark_field, name) == 8);
    assert!(offset_of!(hrbfnpr_mark_field, field) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_mark_field, transform) == either(24, 16, 16));
};

const _: () = {
    assert!(size_of::<hrbfnpr_line_desc>() == either(160, 160, 144));
    assert!(align_of::<hrbfnpr_line_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_line_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_line_desc, kind) == 4);
    assert!(offset_of!(hrbfnpr_line_desc, name) == 8);
    assert!(offset_of!(hrbfnpr_line_desc, lower) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_line_desc, upper) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_line_desc, shortest) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_line_desc, plane) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_line_desc, levels) == either(64, 64, 60));
    assert!(offset_of!(hrbfnpr_line_desc, position) == either(96, 96, 88));
    assert!(offset_of!(hrbfnpr_line_desc, line_first) == either(128, 128, 116));
};

const _: () = {
    assert!(size_of::<hrbfnpr_line_set_desc>() == either(152, 152, 132));
    assert!(align_of::<hrbfnpr_line_set_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_line_set_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_line_set_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_line_set_desc, cell_size) == 8);
    assert!(offset_of!(hrbfnpr_line_set_desc, seed_points) == 16);
    assert!(offset_of!(hrbfnpr_line_set_desc, lines) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_line_set_desc, line_count) == either(56, 56, 48));
    assert!(offset_of!(hrbfnpr_line_set_desc, line_stride) == either(64, 64, 56));
    assert!(offset_of!(hrbfnpr_line_set_desc, support) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_line_set_desc, support_points) == either(80, 80, 72));
    assert!(offset_of!(hrbfnpr_line_set_desc, support_normals) == either(112, 112, 100));
    assert!(offset_of!(hrbfnpr_line_set_desc, mesh) == either(144, 144, 128));
};

const _: () = {
    assert!(size_of::<hrbfnpr_line_set_info>() == 88);
    assert!(align_of::<hrbfnpr_line_set_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_line_set_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_line_set_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_line_set_info, triangles) == 8);
    assert!(offset_of!(hrbfnpr_line_set_info, turned) == 16);
    assert!(offset_of!(hrbfnpr_line_set_info, missed_seeds) == 24);
    assert!(offset_of!(hrbfnpr_line_set_info, lines) == 32);
    assert!(offset_of!(hrbfnpr_line_set_info, borders) == 40);
    assert!(offset_of!(hrbfnpr_line_set_info, cell_size) == 48);
    assert!(offset_of!(hrbfnpr_line_set_info, seconds) == 56);
    assert!(offset_of!(hrbfnpr_line_set_info, bytes) == 64);
    assert!(offset_of!(hrbfnpr_line_set_info, left_out) == 72);
    assert!(offset_of!(hrbfnpr_line_set_info, creases) == 80);
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
    assert!(size_of::<hrbfnpr_light>() == 48);
    assert!(align_of::<hrbfnpr_light>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_light, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_light, kind) == 4);
    assert!(offset_of!(hrbfnpr_light, space) == 8);
    assert!(offset_of!(hrbfnpr_light, intensity) == 12);
    assert!(offset_of!(hrbfnpr_light, shadow) == 16);
    assert!(offset_of!(hrbfnpr_light, softness) == 20);
    assert!(offset_of!(hrbfnpr_light, place) == 24);
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer_style>() == either(176, 152, 152));
    assert!(align_of::<hrbfnpr_layer_style>() == either(8, 4, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer_style, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_layer_style, kind) == 4);
    assert!(offset_of!(hrbfnpr_layer_style, name) == 8);
    assert!(offset_of!(hrbfnpr_layer_style, shown) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_layer_style, contours) == either(20, 16, 16));
    assert!(offset_of!(hrbfnpr_layer_style, directions) == either(24, 20, 20));
    assert!(offset_of!(hrbfnpr_layer_style, shape) == either(28, 24, 24));
    assert!(offset_of!(hrbfnpr_layer_style, share) == either(32, 28, 28));
    assert!(offset_of!(hrbfnpr_layer_style, radius) == either(36, 32, 32));
    assert!(offset_of!(hrbfnpr_layer_style, radius_zoom) == either(40, 36, 36));
    assert!(offset_of!(hrbfnpr_layer_style, reserved) == either(44, 40, 40));
    assert!(offset_of!(hrbfnpr_layer_style, ink) == either(48, 44, 44));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_tone_begin) == either(64, 60, 60));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_tone_end) == either(68, 64, 64));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_coverage_begin) == either(72, 68, 68));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_coverage_end) == either(76, 72, 72));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_spacing) == either(80, 76, 76));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_pen) == either(84, 80, 80));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_white) == either(88, 84, 84));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_taper) == either(92, 88, 88));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_shortest) == either(96, 92, 92));
    assert!(offset_of!(hrbfnpr_layer_style, reserved2) == either(100, 96, 96));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_wobble) == either(104, 100, 100));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_overshoot) == either(108, 104, 104));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_seed) == either(112, 108, 108));
    assert!(offset_of!(hrbfnpr_layer_style, reserved3) == either(116, 112, 112));
    assert!(offset_of!(hrbfnpr_layer_style, density_field) == either(120, 116, 116));
    assert!(offset_of!(hrbfnpr_layer_style, tone_field) == either(128, 120, 120));
    assert!(offset_of!(hrbfnpr_layer_style, width_field) == either(136, 124, 124));
    assert!(offset_of!(hrbfnpr_layer_style, ink_field) == either(144, 128, 128));
    assert!(offset_of!(hrbfnpr_layer_style, mask_field) == either(152, 132, 132));
    assert!(offset_of!(hrbfnpr_layer_style, tone_field_rule) == either(160, 136, 136));
    assert!(offset_of!(hrbfnpr_layer_style, palette_rule) == either(164, 140, 140));
    assert!(offset_of!(hrbfnpr_layer_style, hatch_fade) == either(168, 144, 144));
    assert!(offset_of!(hrbfnpr_layer_style, reserved4) == either(172, 148, 148));
};

const _: () = {
    assert!(size_of::<hrbfnpr_line_style>() == either(160, 160, 152));
    assert!(align_of::<hrbfnpr_line_style>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_line_style, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_line_style, kind) == 4);
    assert!(offset_of!(hrbfnpr_line_style, name) == 8);
    assert!(offset_of!(hrbfnpr_line_style, hidden) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_line_style, cap) == either(20, 16, 16));
    assert!(offset_of!(hrbfnpr_line_style, width) == either(24, 20, 20));
    assert!(offset_of!(hrbfnpr_line_style, taper) == either(28, 24, 24));
    assert!(offset_of!(hrbfnpr_line_style, hidden_width) == either(32, 28, 28));
    assert!(offset_of!(hrbfnpr_line_style, hidden_opacity) == either(36, 32, 32));
    assert!(offset_of!(hrbfnpr_line_style, dash) == either(40, 36, 36));
    assert!(offset_of!(hrbfnpr_line_style, gap) == either(44, 40, 40));
    assert!(offset_of!(hrbfnpr_line_style, shortest) == either(48, 44, 44));
    assert!(offset_of!(hrbfnpr_line_style, fade) == either(52, 48, 48));
    assert!(offset_of!(hrbfnpr_line_style, lower) == either(56, 56, 52));
    assert!(offset_of!(hrbfnpr_line_style, upper) == either(64, 64, 60));
    assert!(offset_of!(hrbfnpr_line_style, levels) == either(72, 72, 68));
    assert!(offset_of!(hrbfnpr_line_style, ink) == either(104, 104, 96));
    assert!(offset_of!(hrbfnpr_line_style, outline_factor) == either(120, 120, 112));
    assert!(offset_of!(hrbfnpr_line_style, far_factor) == either(124, 124, 116));
    assert!(offset_of!(hrbfnpr_line_style, lit_factor) == either(128, 128, 120));
    assert!(offset_of!(hrbfnpr_line_style, curvature_factor) == either(132, 132, 124));
    assert!(offset_of!(hrbfnpr_line_style, curvature_radius) == either(136, 136, 128));
    assert!(offset_of!(hrbfnpr_line_style, wobble) == either(140, 140, 132));
    assert!(offset_of!(hrbfnpr_line_style, wobble_width) == either(144, 144, 136));
    assert!(offset_of!(hrbfnpr_line_style, wobble_length) == either(148, 148, 140));
    assert!(offset_of!(hrbfnpr_line_style, wobble_seed) == either(152, 152, 144));
    assert!(offset_of!(hrbfnpr_line_style, creases) == either(156, 156, 148));
};

const _: () = {
    assert!(size_of::<hrbfnpr_style>() == either(376, 368, 352));
    assert!(align_of::<hrbfnpr_style>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_style, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_style, tone) == 4);
    assert!(offset_of!(hrbfnpr_style, paper) == 8);
    assert!(offset_of!(hrbfnpr_style, layers) == 24);
    assert!(offset_of!(hrbfnpr_style, layer_count) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_style, layer_stride) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_style, tone_rule) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_style, tone_curve) == either(52, 52, 48));
    assert!(offset_of!(hrbfnpr_style, light) == either(56, 56, 52));
    assert!(offset_of!(hrbfnpr_style, tone_exponent) == either(80, 80, 76));
    assert!(offset_of!(hrbfnpr_style, tone_function) == either(88, 88, 84));
    assert!(offset_of!(hrbfnpr_style, tone_user) == either(96, 92, 88));
    assert!(offset_of!(hrbfnpr_style, light_space) == either(104, 96, 92));
    assert!(offset_of!(hrbfnpr_style, tone_fade) == either(108, 100, 96));
    assert!(offset_of!(hrbfnpr_style, silhouette_threshold) == either(112, 104, 100));
    assert!(offset_of!(hrbfnpr_style, silhouette_radius) == either(120, 112, 108));
    assert!(offset_of!(hrbfnpr_style, silhouette_radius_zoom) == either(124, 116, 112));
    assert!(offset_of!(hrbfnpr_style, silhouette_ink) == either(128, 120, 116));
    assert!(offset_of!(hrbfnpr_style, visibility) == either(144, 136, 132));
    assert!(offset_of!(hrbfnpr_style, hidden_lines) == either(148, 140, 136));
    assert!(offset_of!(hrbfnpr_style, attenuation_front) == either(152, 144, 140));
    assert!(offset_of!(hrbfnpr_style, attenuation_back) == either(160, 152, 148));
    assert!(offset_of!(hrbfnpr_style, splat_radius) == either(168, 160, 156));
    assert!(offset_of!(hrbfnpr_style, splat_overlap) == either(172, 164, 160));
    assert!(offset_of!(hrbfnpr_style, halo_width) == either(176, 168, 164));
    assert!(offset_of!(hrbfnpr_style, verify_lines) == either(180, 172, 168));
    assert!(offset_of!(hrbfnpr_style, depth_min) == either(184, 176, 172));
    assert!(offset_of!(hrbfnpr_style, depth_max) == either(192, 184, 180));
    assert!(offset_of!(hrbfnpr_style, zoom_reference) == either(200, 192, 188));
    assert!(offset_of!(hrbfnpr_style, zoom_exponent) == either(208, 200, 196));
    assert!(offset_of!(hrbfnpr_style, lines) == either(216, 208, 204));
    assert!(offset_of!(hrbfnpr_style, line_count) == either(224, 216, 208));
    assert!(offset_of!(hrbfnpr_style, line_stride) == either(232, 224, 216));
    assert!(offset_of!(hrbfnpr_style, fill_light) == either(240, 232, 224));
    assert!(offset_of!(hrbfnpr_style, reserved2) == either(244, 236, 228));
    assert!(offset_of!(hrbfnpr_style, light_intensity) == either(248, 240, 232));
    assert!(offset_of!(hrbfnpr_style, light_shadow) == either(252, 244, 236));
    assert!(offset_of!(hrbfnpr_style, light_softness) == either(256, 248, 240));
    assert!(offset_of!(hrbfnpr_style, evenness) == either(260, 252, 244));
    assert!(offset_of!(hrbfnpr_style, lights) == either(264, 256, 248));
    assert!(offset_of!(hrbfnpr_style, light_count) == either(272, 264, 252));
    assert!(offset_of!(hrbfnpr_style, light_stride) == either(280, 272, 260));
    assert!(offset_of!(hrbfnpr_style, ambient_up) == either(288, 280, 268));
    assert!(offset_of!(hrbfnpr_style, ambient_sky) == either(312, 304, 292));
    assert!(offset_of!(hrbfnpr_style, ambient_ground) == either(316, 308, 296));
    assert!(offset_of!(hrbfnpr_style, occlusion) == either(320, 312, 300));
    assert!(offset_of!(hrbfnpr_style, occlusion_exponent) == either(324, 316, 304));
    assert!(offset_of!(hrbfnpr_style, rim_light) == either(328, 320, 308));
    assert!(offset_of!(hrbfnpr_style, rim_exponent) == either(332, 324, 312));
    assert!(offset_of!(hrbfnpr_style, tone_black) == either(336, 328, 316));
    assert!(offset_of!(hrbfnpr_style, tone_white) == either(340, 332, 320));
    assert!(offset_of!(hrbfnpr_style, tone_gamma) == either(344, 336, 324));
    assert!(offset_of!(hrbfnpr_style, tone_steps) == either(348, 340, 328));
    assert!(offset_of!(hrbfnpr_style, curvature_contrast) == either(352, 344, 332));
    assert!(offset_of!(hrbfnpr_style, occlusion_lights) == either(356, 348, 336));
    assert!(offset_of!(hrbfnpr_style, palette) == either(360, 352, 340));
    assert!(offset_of!(hrbfnpr_style, palette_count) == either(368, 360, 344));
};

const _: () = {
    assert!(size_of::<hrbfnpr_dab>() == 104);
    assert!(align_of::<hrbfnpr_dab>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_dab, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_dab, map) == 4);
    assert!(offset_of!(hrbfnpr_dab, position) == 8);
    assert!(offset_of!(hrbfnpr_dab, normal) == 32);
    assert!(offset_of!(hrbfnpr_dab, radius) == 56);
    assert!(offset_of!(hrbfnpr_dab, strength) == 64);
    assert!(offset_of!(hrbfnpr_dab, value) == 72);
    assert!(offset_of!(hrbfnpr_dab, direction) == 80);
};

const _: () = {
    assert!(size_of::<hrbfnpr_field_desc>() == either(200, 184, 164));
    assert!(align_of::<hrbfnpr_field_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_field_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_field_desc, kind) == 4);
    assert!(offset_of!(hrbfnpr_field_desc, source) == 8);
    assert!(offset_of!(hrbfnpr_field_desc, flags) == 12);
    assert!(offset_of!(hrbfnpr_field_desc, range) == 16);
    assert!(offset_of!(hrbfnpr_field_desc, points) == 32);
    assert!(offset_of!(hrbfnpr_field_desc, triangles) == either(64, 64, 60));
    assert!(offset_of!(hrbfnpr_field_desc, values) == either(96, 96, 88));
    assert!(offset_of!(hrbfnpr_field_desc, reach) == either(128, 128, 116));
    assert!(offset_of!(hrbfnpr_field_desc, function) == either(136, 136, 124));
    assert!(offset_of!(hrbfnpr_field_desc, user) == either(144, 140, 128));
    assert!(offset_of!(hrbfnpr_field_desc, dabs) == either(152, 144, 132));
    assert!(offset_of!(hrbfnpr_field_desc, dab_count) == either(160, 152, 136));
    assert!(offset_of!(hrbfnpr_field_desc, dab_stride) == either(168, 160, 144));
    assert!(offset_of!(hrbfnpr_field_desc, image) == either(176, 168, 152));
    assert!(offset_of!(hrbfnpr_field_desc, camera) == either(184, 172, 156));
    assert!(offset_of!(hrbfnpr_field_desc, occluders) == either(192, 176, 160));
};

const _: () = {
    assert!(size_of::<hrbfnpr_layer_pose>() == either(112, 112, 100));
    assert!(align_of::<hrbfnpr_layer_pose>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_layer_pose, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_layer_pose, reserved) == 4);
    assert!(offset_of!(hrbfnpr_layer_pose, layer) == 8);
    assert!(offset_of!(hrbfnpr_layer_pose, position) == 16);
    assert!(offset_of!(hrbfnpr_layer_pose, normal) == either(48, 48, 44));
    assert!(offset_of!(hrbfnpr_layer_pose, direction) == either(80, 80, 72));
};

const _: () = {
    assert!(size_of::<hrbfnpr_item>() == either(200, 184, 176));
    assert!(align_of::<hrbfnpr_item>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_item, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_item, sides) == 4);
    assert!(offset_of!(hrbfnpr_item, point_set) == 8);
    assert!(offset_of!(hrbfnpr_item, style) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_item, model) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_item, transform) == either(32, 24, 20));
    assert!(offset_of!(hrbfnpr_item, poses) == either(160, 152, 148));
    assert!(offset_of!(hrbfnpr_item, pose_count) == either(168, 160, 152));
    assert!(offset_of!(hrbfnpr_item, pose_stride) == either(176, 168, 160));
    assert!(offset_of!(hrbfnpr_item, line_set) == either(184, 176, 168));
    assert!(offset_of!(hrbfnpr_item, shading) == either(192, 180, 172));
};

const _: () = {
    assert!(size_of::<hrbfnpr_shading_desc>() == either(40, 40, 36));
    assert!(align_of::<hrbfnpr_shading_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_shading_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_shading_desc, sky_rays) == 4);
    assert!(offset_of!(hrbfnpr_shading_desc, shadow_rays) == 8);
    assert!(offset_of!(hrbfnpr_shading_desc, flags) == 12);
    assert!(offset_of!(hrbfnpr_shading_desc, occlusion_reach) == 16);
    assert!(offset_of!(hrbfnpr_shading_desc, previous) == 24);
    assert!(offset_of!(hrbfnpr_shading_desc, curvature_scale) == either(32, 32, 28));
};

const _: () = {
    assert!(size_of::<hrbfnpr_drawing_info>() == 288);
    assert!(align_of::<hrbfnpr_drawing_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_drawing_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_drawing_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_drawing_info, items) == 8);
    assert!(offset_of!(hrbfnpr_drawing_info, layers) == 16);
    assert!(offset_of!(hrbfnpr_drawing_info, dots) == 24);
    assert!(offset_of!(hrbfnpr_drawing_info, strokes) == 32);
    assert!(offset_of!(hrbfnpr_drawing_info, stroke_points) == 40);
    assert!(offset_of!(hrbfnpr_drawing_info, marks) == 48);
    assert!(offset_of!(hrbfnpr_drawing_info, outside) == 56);
    assert!(offset_of!(hrbfnpr_drawing_info, front) == 64);
    assert!(offset_of!(hrbfnpr_drawing_info, back) == 72);
    assert!(offset_of!(hrbfnpr_drawing_info, silhouette) == 80);
    assert!(offset_of!(hrbfnpr_drawing_info, culled) == 88);
    assert!(offset_of!(hrbfnpr_drawing_info, shown) == 96);
    assert!(offset_of!(hrbfnpr_drawing_info, dropped_tone) == 104);
    assert!(offset_of!(hrbfnpr_drawing_info, dropped_depth) == 112);
    assert!(offset_of!(hrbfnpr_drawing_info, dropped_zoom) == 120);
    assert!(offset_of!(hrbfnpr_drawing_info, dropped_hidden) == 128);
    assert!(offset_of!(hrbfnpr_drawing_info, splats) == 136);
    assert!(offset_of!(hrbfnpr_drawing_info, nanoseconds_classify) == 144);
    assert!(offset_of!(hrbfnpr_drawing_info, nanoseconds_visibility) == 152);
    assert!(offset_of!(hrbfnpr_drawing_info, nanoseconds_sort) == 160);
    assert!(offset_of!(hrbfnpr_drawing_info, bytes) == 168);
    assert!(offset_of!(hrbfnpr_drawing_info, scratch_bytes) == 176);
    assert!(offset_of!(hrbfnpr_drawing_info, line_curves) == 184);
    assert!(offset_of!(hrbfnpr_drawing_info, line_cusps) == 192);
    assert!(offset_of!(hrbfnpr_drawing_info, line_crossings) == 200);
    assert!(offset_of!(hrbfnpr_drawing_info, line_broken) == 208);
    assert!(offset_of!(hrbfnpr_drawing_info, line_settled) == 216);
    assert!(offset_of!(hrbfnpr_drawing_info, line_contradictions) == 224);
    assert!(offset_of!(hrbfnpr_drawing_info, nanoseconds_lines) == 232);
    assert!(offset_of!(hrbfnpr_drawing_info, line_refined) == 240);
    assert!(offset_of!(hrbfnpr_drawing_info, line_tangles) == 248);
    assert!(offset_of!(hrbfnpr_drawing_info, line_pieces) == 256);
    assert!(offset_of!(hrbfnpr_drawing_info, line_agreeing) == 264);
    assert!(offset_of!(hrbfnpr_drawing_info, line_undecided) == 272);
    assert!(offset_of!(hrbfnpr_drawing_info, line_repaired) == 280);
};

const _: () = {
    assert!(size_of::<hrbfnpr_drawing_layer_info>() == 136);
    assert!(align_of::<hrbfnpr_drawing_layer_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_drawing_layer_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, mark_class) == 4);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, item) == 8);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, layer) == 16);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, kind) == 24);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, shape) == 28);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, name) == 32);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, ink) == 96);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, dots) == 112);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, strokes) == 120);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, ink_number) == 128);
    assert!(offset_of!(hrbfnpr_drawing_layer_info, reserved) == 132);
};

const _: () = {
    assert!(size_of::<hrbfnpr_raster_desc>() == either(136, 136, 120));
    assert!(align_of::<hrbfnpr_raster_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_raster_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_raster_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_raster_desc, host_depth) == 8);
    assert!(offset_of!(hrbfnpr_raster_desc, depth) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_raster_desc, id) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_raster_desc, mark_class) == either(104, 104, 92));
};

const _: () = {
    assert!(size_of::<hrbfnpr_vertex_attribute>() == 16);
    assert!(align_of::<hrbfnpr_vertex_attribute>() == 4);
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_vertex_attribute, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_vertex_attribute, attribute) == 4);
    assert!(offset_of!(hrbfnpr_vertex_attribute, scalar) == 8);
    assert!(offset_of!(hrbfnpr_vertex_attribute, offset) == 12);
};

const _: () = {
    assert!(size_of::<hrbfnpr_vertex_layout>() == either(40, 40, 36));
    assert!(align_of::<hrbfnpr_vertex_layout>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_vertex_layout, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_vertex_layout, primitive) == 4);
    assert!(offset_of!(hrbfnpr_vertex_layout, attributes) == 8);
    assert!(offset_of!(hrbfnpr_vertex_layout, attribute_count) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_vertex_layout, attribute_stride) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_vertex_layout, stride) == either(32, 32, 28));
};

const _: () = {
    assert!(size_of::<hrbfnpr_mark_results>() == either(104, 104, 92));
    assert!(align_of::<hrbfnpr_mark_results>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mark_results, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mark_results, reserved) == 4);
    assert!(offset_of!(hrbfnpr_mark_results, shown) == 8);
    assert!(offset_of!(hrbfnpr_mark_results, radius) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_mark_results, opacity) == either(72, 72, 64));
};

const _: () = {
    assert!(size_of::<hrbfnpr_mark_identity>() == 48);
    assert!(align_of::<hrbfnpr_mark_identity>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mark_identity, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mark_identity, id) == 4);
    assert!(offset_of!(hrbfnpr_mark_identity, item) == 8);
    assert!(offset_of!(hrbfnpr_mark_identity, layer) == 16);
    assert!(offset_of!(hrbfnpr_mark_identity, mark) == 24);
    assert!(offset_of!(hrbfnpr_mark_identity, stroke) == 32);
    assert!(offset_of!(hrbfnpr_mark_identity, place) == 40);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_desc>() == either(88, 88, 80));
    assert!(align_of::<hrbfnpr_mesh_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_desc, parts) == 4);
    assert!(offset_of!(hrbfnpr_mesh_desc, vertices) == 8);
    assert!(offset_of!(hrbfnpr_mesh_desc, triangles) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_mesh_desc, crease_angle) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_mesh_desc, faces) == either(80, 80, 72));
    assert!(offset_of!(hrbfnpr_mesh_desc, reserved) == either(84, 84, 76));
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_info>() == 256);
    assert!(align_of::<hrbfnpr_mesh_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_info, closed) == 4);
    assert!(offset_of!(hrbfnpr_mesh_info, given_vertices) == 8);
    assert!(offset_of!(hrbfnpr_mesh_info, given_faces) == 16);
    assert!(offset_of!(hrbfnpr_mesh_info, vertices) == 24);
    assert!(offset_of!(hrbfnpr_mesh_info, faces) == 32);
    assert!(offset_of!(hrbfnpr_mesh_info, welded_vertices) == 40);
    assert!(offset_of!(hrbfnpr_mesh_info, degenerate_faces) == 48);
    assert!(offset_of!(hrbfnpr_mesh_info, repeated_faces) == 56);
    assert!(offset_of!(hrbfnpr_mesh_info, turned_faces) == 64);
    assert!(offset_of!(hrbfnpr_mesh_info, components) == 72);
    assert!(offset_of!(hrbfnpr_mesh_info, turned_components) == 80);
    assert!(offset_of!(hrbfnpr_mesh_info, nested_components) == 88);
    assert!(offset_of!(hrbfnpr_mesh_info, left_out_components) == 96);
    assert!(offset_of!(hrbfnpr_mesh_info, left_out_faces) == 104);
    assert!(offset_of!(hrbfnpr_mesh_info, boundary_edges) == 112);
    assert!(offset_of!(hrbfnpr_mesh_info, boundary_loops) == 120);
    assert!(offset_of!(hrbfnpr_mesh_info, nonmanifold_edges) == 128);
    assert!(offset_of!(hrbfnpr_mesh_info, contrary_edges) == 136);
    assert!(offset_of!(hrbfnpr_mesh_info, euler_characteristic) == 144);
    assert!(offset_of!(hrbfnpr_mesh_info, genus) == 152);
    assert!(offset_of!(hrbfnpr_mesh_info, area) == 160);
    assert!(offset_of!(hrbfnpr_mesh_info, volume) == 168);
    assert!(offset_of!(hrbfnpr_mesh_info, bounds_min) == 176);
    assert!(offset_of!(hrbfnpr_mesh_info, bounds_max) == 200);
    assert!(offset_of!(hrbfnpr_mesh_info, seconds) == 224);
    assert!(offset_of!(hrbfnpr_mesh_info, bytes) == 232);
    assert!(offset_of!(hrbfnpr_mesh_info, crease_length) == 240);
    assert!(offset_of!(hrbfnpr_mesh_info, creases) == 248);
    assert!(offset_of!(hrbfnpr_mesh_info, cavities) == 252);
};

const _: () = {
    assert!(size_of::<hrbfnpr_sample_desc>() == 24);
    assert!(align_of::<hrbfnpr_sample_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_sample_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_sample_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_sample_desc, candidates) == 8);
    assert!(offset_of!(hrbfnpr_sample_desc, random_seed) == 16);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_edges_desc>() == 32);
    assert!(align_of::<hrbfnpr_mesh_edges_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, edges) == 4);
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, crease_angle) == 8);
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, far) == 16);
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, tangent) == 24);
    assert!(offset_of!(hrbfnpr_mesh_edges_desc, reserved) == 28);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_edges_info>() == 56);
    assert!(align_of::<hrbfnpr_mesh_edges_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_edges_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, edges) == 8);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, patches) == 16);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, length) == 24);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, fading) == 32);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, doubtful) == 40);
    assert!(offset_of!(hrbfnpr_mesh_edges_info, seconds) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_compare_desc>() == 56);
    assert!(align_of::<hrbfnpr_compare_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_compare_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_compare_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_compare_desc, tolerance) == 8);
    assert!(offset_of!(hrbfnpr_compare_desc, far) == 16);
    assert!(offset_of!(hrbfnpr_compare_desc, support) == 24);
    assert!(offset_of!(hrbfnpr_compare_desc, points) == 32);
    assert!(offset_of!(hrbfnpr_compare_desc, cell_size) == 40);
    assert!(offset_of!(hrbfnpr_compare_desc, random_seed) == 48);
};

const _: () = {
    assert!(size_of::<hrbfnpr_comparison>() == 168);
    assert!(align_of::<hrbfnpr_comparison>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_comparison, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_comparison, reserved) == 4);
    assert!(offset_of!(hrbfnpr_comparison, surface_points) == 8);
    assert!(offset_of!(hrbfnpr_comparison, surface_mean) == 16);
    assert!(offset_of!(hrbfnpr_comparison, surface_p99) == 24);
    assert!(offset_of!(hrbfnpr_comparison, surface_max) == 32);
    assert!(offset_of!(hrbfnpr_comparison, surface_share) == 40);
    assert!(offset_of!(hrbfnpr_comparison, invented_share) == 48);
    assert!(offset_of!(hrbfnpr_comparison, left_out_share) == 56);
    assert!(offset_of!(hrbfnpr_comparison, mesh_points) == 64);
    assert!(offset_of!(hrbfnpr_comparison, mesh_mean) == 72);
    assert!(offset_of!(hrbfnpr_comparison, mesh_p99) == 80);
    assert!(offset_of!(hrbfnpr_comparison, mesh_max) == 88);
    assert!(offset_of!(hrbfnpr_comparison, mesh_share) == 96);
    assert!(offset_of!(hrbfnpr_comparison, missed_share) == 104);
    assert!(offset_of!(hrbfnpr_comparison, normal_mean) == 112);
    assert!(offset_of!(hrbfnpr_comparison, normal_p99) == 120);
    assert!(offset_of!(hrbfnpr_comparison, components) == 128);
    assert!(offset_of!(hrbfnpr_comparison, genus) == 136);
    assert!(offset_of!(hrbfnpr_comparison, tolerance) == 144);
    assert!(offset_of!(hrbfnpr_comparison, diagonal) == 152);
    assert!(offset_of!(hrbfnpr_comparison, seconds) == 160);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_fit_desc>() == 72);
    assert!(align_of::<hrbfnpr_mesh_fit_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, tolerance) == 8);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, share) == 16);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, far) == 24);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, maximum_centres) == 32);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, candidates) == 40);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, random_seed) == 48);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, crease_angle) == 56);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, edges) == 64);
    assert!(offset_of!(hrbfnpr_mesh_fit_desc, reserved2) == 68);
};

const _: () = {
    assert!(size_of::<hrbfnpr_mesh_fit_info>() == 216);
    assert!(align_of::<hrbfnpr_mesh_fit_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_mesh_fit_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, reached) == 4);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, tolerance) == 8);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, far) == 16);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, candidates) == 24);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, centres) == 32);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, off_surface_centres) == 40);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, rounds) == 48);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, supported) == 52);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, surface_share) == 56);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, surface_p99) == 64);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, surface_max) == 72);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, mesh_share) == 80);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, mesh_p99) == 88);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, mesh_max) == 96);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, seconds_sample) == 104);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, seconds_fit) == 112);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, seconds_measure) == 120);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, seconds_total) == 128);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, sheets) == 136);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, reserved) == 140);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, crease_length) == 144);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, smooth_length) == 152);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, cells) == 160);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, poor_cells) == 168);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, touching_parts) == 176);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, touching_place) == 184);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, parts_may_cross) == 208);
    assert!(offset_of!(hrbfnpr_mesh_fit_info, reserved2) == 212);
};

const _: () = {
    assert!(size_of::<hrbfnpr_page_item>() == either(48, 48, 40));
    assert!(align_of::<hrbfnpr_page_item>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_page_item, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_page_item, reserved) == 4);
    assert!(offset_of!(hrbfnpr_page_item, drawing) == 8);
    assert!(offset_of!(hrbfnpr_page_item, x) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_page_item, y) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_page_item, scale) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_page_item, name) == either(40, 40, 36));
};

const _: () = {
    assert!(size_of::<hrbfnpr_pen>() == either(48, 48, 44));
    assert!(align_of::<hrbfnpr_pen>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_pen, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_pen, line_type) == 4);
    assert!(offset_of!(hrbfnpr_pen, groups) == 8);
    assert!(offset_of!(hrbfnpr_pen, width) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_pen, ink) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_pen, number) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_pen, reserved) == either(44, 44, 40));
};

const _: () = {
    assert!(size_of::<hrbfnpr_annotation>() == either(80, 72, 68));
    assert!(align_of::<hrbfnpr_annotation>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_annotation, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_annotation, line_type) == 4);
    assert!(offset_of!(hrbfnpr_annotation, group) == 8);
    assert!(offset_of!(hrbfnpr_annotation, text) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_annotation, points) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_annotation, width) == either(56, 48, 44));
    assert!(offset_of!(hrbfnpr_annotation, ink) == either(64, 56, 52));
};

const _: () = {
    assert!(size_of::<hrbfnpr_page_desc>() == either(224, 200, 192));
    assert!(align_of::<hrbfnpr_page_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_page_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_page_desc, format) == 4);
    assert!(offset_of!(hrbfnpr_page_desc, flags) == 8);
    assert!(offset_of!(hrbfnpr_page_desc, widths) == 12);
    assert!(offset_of!(hrbfnpr_page_desc, dots) == 16);
    assert!(offset_of!(hrbfnpr_page_desc, curves) == 20);
    assert!(offset_of!(hrbfnpr_page_desc, width) == 24);
    assert!(offset_of!(hrbfnpr_page_desc, height) == 32);
    assert!(offset_of!(hrbfnpr_page_desc, tolerance) == 40);
    assert!(offset_of!(hrbfnpr_page_desc, width_step) == 48);
    assert!(offset_of!(hrbfnpr_page_desc, join) == 56);
    assert!(offset_of!(hrbfnpr_page_desc, shortest) == 64);
    assert!(offset_of!(hrbfnpr_page_desc, dot_distance) == 72);
    assert!(offset_of!(hrbfnpr_page_desc, draw_speed) == 80);
    assert!(offset_of!(hrbfnpr_page_desc, travel_speed) == 88);
    assert!(offset_of!(hrbfnpr_page_desc, pen_seconds) == 96);
    assert!(offset_of!(hrbfnpr_page_desc, pen_down) == 104);
    assert!(offset_of!(hrbfnpr_page_desc, pen_up) == either(112, 108, 108));
    assert!(offset_of!(hrbfnpr_page_desc, title) == either(120, 112, 112));
    assert!(offset_of!(hrbfnpr_page_desc, description) == either(128, 116, 116));
    assert!(offset_of!(hrbfnpr_page_desc, metadata) == either(136, 120, 120));
    assert!(offset_of!(hrbfnpr_page_desc, items) == either(144, 124, 124));
    assert!(offset_of!(hrbfnpr_page_desc, item_count) == either(152, 128, 128));
    assert!(offset_of!(hrbfnpr_page_desc, item_stride) == either(160, 136, 136));
    assert!(offset_of!(hrbfnpr_page_desc, pens) == either(168, 144, 144));
    assert!(offset_of!(hrbfnpr_page_desc, pen_count) == either(176, 152, 148));
    assert!(offset_of!(hrbfnpr_page_desc, pen_stride) == either(184, 160, 156));
    assert!(offset_of!(hrbfnpr_page_desc, annotations) == either(192, 168, 164));
    assert!(offset_of!(hrbfnpr_page_desc, annotation_count) == either(200, 176, 168));
    assert!(offset_of!(hrbfnpr_page_desc, annotation_stride) == either(208, 184, 176));
    assert!(offset_of!(hrbfnpr_page_desc, longest) == either(216, 192, 184));
};

const _: () = {
    assert!(size_of::<hrbfnpr_page_info>() == 128);
    assert!(align_of::<hrbfnpr_page_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_page_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_page_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_page_info, bytes) == 8);
    assert!(offset_of!(hrbfnpr_page_info, groups) == 16);
    assert!(offset_of!(hrbfnpr_page_info, paths) == 24);
    assert!(offset_of!(hrbfnpr_page_info, segments) == 32);
    assert!(offset_of!(hrbfnpr_page_info, dots) == 40);
    assert!(offset_of!(hrbfnpr_page_info, joined) == 48);
    assert!(offset_of!(hrbfnpr_page_info, dropped_paths) == 56);
    assert!(offset_of!(hrbfnpr_page_info, dropped_dots) == 64);
    assert!(offset_of!(hrbfnpr_page_info, width) == 72);
    assert!(offset_of!(hrbfnpr_page_info, height) == 80);
    assert!(offset_of!(hrbfnpr_page_info, drawn) == 88);
    assert!(offset_of!(hrbfnpr_page_info, travelled) == 96);
    assert!(offset_of!(hrbfnpr_page_info, seconds) == 104);
    assert!(offset_of!(hrbfnpr_page_info, filled_paths) == 112);
    assert!(offset_of!(hrbfnpr_page_info, cut_paths) == 120);
};

const _: () = {
    assert!(size_of::<hrbfnpr_source_field>() == either(48, 48, 40));
    assert!(align_of::<hrbfnpr_source_field>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_source_field, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_source_field, kind) == 4);
    assert!(offset_of!(hrbfnpr_source_field, name) == 8);
    assert!(offset_of!(hrbfnpr_source_field, values) == either(16, 16, 12));
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_source>() == either(256, 240, 220));
    assert!(align_of::<hrbfnpr_picture_source>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_source, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_source, flags) == 4);
    assert!(offset_of!(hrbfnpr_picture_source, points) == 8);
    assert!(offset_of!(hrbfnpr_picture_source, normals) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_picture_source, triangles) == either(72, 72, 64));
    assert!(offset_of!(hrbfnpr_picture_source, sharp_edges) == either(104, 104, 92));
    assert!(offset_of!(hrbfnpr_picture_source, model) == either(136, 136, 120));
    assert!(offset_of!(hrbfnpr_picture_source, point_set) == either(144, 140, 124));
    assert!(offset_of!(hrbfnpr_picture_source, up) == either(152, 144, 128));
    assert!(offset_of!(hrbfnpr_picture_source, up_by) == either(176, 168, 152));
    assert!(offset_of!(hrbfnpr_picture_source, viewpoint) == either(184, 176, 156));
    assert!(offset_of!(hrbfnpr_picture_source, columns) == either(208, 200, 180));
    assert!(offset_of!(hrbfnpr_picture_source, rows) == either(216, 208, 188));
    assert!(offset_of!(hrbfnpr_picture_source, name) == either(224, 216, 196));
    assert!(offset_of!(hrbfnpr_picture_source, fields) == either(232, 220, 200));
    assert!(offset_of!(hrbfnpr_picture_source, field_count) == either(240, 224, 204));
    assert!(offset_of!(hrbfnpr_picture_source, field_stride) == either(248, 232, 212));
};

const _: () = {
    assert!(size_of::<hrbfnpr_change>() == either(24, 16, 16));
    assert!(align_of::<hrbfnpr_change>() == either(8, 4, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_change, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_change, reserved) == 4);
    assert!(offset_of!(hrbfnpr_change, field) == 8);
    assert!(offset_of!(hrbfnpr_change, value) == either(16, 12, 12));
};

const _: () = {
    assert!(size_of::<hrbfnpr_note>() == either(104, 96, 92));
    assert!(align_of::<hrbfnpr_note>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_note, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_note, code) == 4);
    assert!(offset_of!(hrbfnpr_note, severity) == 8);
    assert!(offset_of!(hrbfnpr_note, figure_count) == 12);
    assert!(offset_of!(hrbfnpr_note, figures) == 16);
    assert!(offset_of!(hrbfnpr_note, text) == 80);
    assert!(offset_of!(hrbfnpr_note, advice) == either(88, 84, 84));
    assert!(offset_of!(hrbfnpr_note, detail) == either(96, 88, 88));
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_event>() == either(56, 40, 40));
    assert!(align_of::<hrbfnpr_picture_event>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_event, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_event, stage) == 4);
    assert!(offset_of!(hrbfnpr_picture_event, fraction) == 8);
    assert!(offset_of!(hrbfnpr_picture_event, seconds) == 16);
    assert!(offset_of!(hrbfnpr_picture_event, name) == 24);
    assert!(offset_of!(hrbfnpr_picture_event, doing) == either(32, 28, 28));
    assert!(offset_of!(hrbfnpr_picture_event, says) == either(40, 32, 32));
    assert!(offset_of!(hrbfnpr_picture_event, note) == either(48, 36, 36));
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_desc>() == either(488, 456, 436));
    assert!(align_of::<hrbfnpr_picture_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_picture_desc, sources) == 8);
    assert!(offset_of!(hrbfnpr_picture_desc, source_count) == either(16, 16, 12));
    assert!(offset_of!(hrbfnpr_picture_desc, source_stride) == either(24, 24, 20));
    assert!(offset_of!(hrbfnpr_picture_desc, preset) == either(32, 32, 28));
    assert!(offset_of!(hrbfnpr_picture_desc, wording) == either(36, 36, 32));
    assert!(offset_of!(hrbfnpr_picture_desc, style_name) == either(40, 40, 36));
    assert!(offset_of!(hrbfnpr_picture_desc, style) == either(48, 44, 40));
    assert!(offset_of!(hrbfnpr_picture_desc, settings) == either(56, 48, 44));
    assert!(offset_of!(hrbfnpr_picture_desc, changes) == either(64, 52, 48));
    assert!(offset_of!(hrbfnpr_picture_desc, change_count) == either(72, 56, 52));
    assert!(offset_of!(hrbfnpr_picture_desc, change_stride) == either(80, 64, 60));
    assert!(offset_of!(hrbfnpr_picture_desc, dabs) == either(88, 72, 68));
    assert!(offset_of!(hrbfnpr_picture_desc, dab_count) == either(96, 80, 72));
    assert!(offset_of!(hrbfnpr_picture_desc, dab_stride) == either(104, 88, 80));
    assert!(offset_of!(hrbfnpr_picture_desc, width) == either(112, 96, 88));
    assert!(offset_of!(hrbfnpr_picture_desc, height) == either(116, 100, 92));
    assert!(offset_of!(hrbfnpr_picture_desc, size) == either(120, 104, 96));
    assert!(offset_of!(hrbfnpr_picture_desc, sides) == either(124, 108, 100));
    assert!(offset_of!(hrbfnpr_picture_desc, pen) == either(128, 112, 104));
    assert!(offset_of!(hrbfnpr_picture_desc, line_width) == either(136, 120, 112));
    assert!(offset_of!(hrbfnpr_picture_desc, camera) == either(144, 128, 120));
    assert!(offset_of!(hrbfnpr_picture_desc, up) == either(152, 136, 124));
    assert!(offset_of!(hrbfnpr_picture_desc, azimuth) == either(176, 160, 148));
    assert!(offset_of!(hrbfnpr_picture_desc, elevation) == either(184, 168, 156));
    assert!(offset_of!(hrbfnpr_picture_desc, direction) == either(192, 176, 164));
    assert!(offset_of!(hrbfnpr_picture_desc, eye) == either(216, 200, 188));
    assert!(offset_of!(hrbfnpr_picture_desc, target) == either(240, 224, 212));
    assert!(offset_of!(hrbfnpr_picture_desc, fov) == either(264, 248, 236));
    assert!(offset_of!(hrbfnpr_picture_desc, margin) == either(272, 256, 244));
    assert!(offset_of!(hrbfnpr_picture_desc, turn) == either(280, 264, 252));
    assert!(offset_of!(hrbfnpr_picture_desc, turn_frames) == either(288, 272, 260));
    assert!(offset_of!(hrbfnpr_picture_desc, normals) == either(292, 276, 264));
    assert!(offset_of!(hrbfnpr_picture_desc, samples) == either(296, 280, 268));
    assert!(offset_of!(hrbfnpr_picture_desc, tolerance) == either(304, 288, 276));
    assert!(offset_of!(hrbfnpr_picture_desc, maximum_centres) == either(312, 296, 284));
    assert!(offset_of!(hrbfnpr_picture_desc, parts) == either(320, 304, 292));
    assert!(offset_of!(hrbfnpr_picture_desc, edges) == either(324, 308, 296));
    assert!(offset_of!(hrbfnpr_picture_desc, edge_angle) == either(328, 312, 300));
    assert!(offset_of!(hrbfnpr_picture_desc, crease_angle) == either(336, 320, 308));
    assert!(offset_of!(hrbfnpr_picture_desc, subdivide) == either(344, 328, 316));
    assert!(offset_of!(hrbfnpr_picture_desc, profile) == either(348, 332, 320));
    assert!(offset_of!(hrbfnpr_picture_desc, viewpoint) == either(352, 336, 324));
    assert!(offset_of!(hrbfnpr_picture_desc, depth_smoothing) == either(376, 360, 348));
    assert!(offset_of!(hrbfnpr_picture_desc, random_seed) == either(384, 368, 356));
    assert!(offset_of!(hrbfnpr_picture_desc, mark_kinds) == either(392, 376, 364));
    assert!(offset_of!(hrbfnpr_picture_desc, seed_points) == either(400, 384, 368));
    assert!(offset_of!(hrbfnpr_picture_desc, hatch_angle) == either(432, 416, 396));
    assert!(offset_of!(hrbfnpr_picture_desc, lines) == either(440, 424, 404));
    assert!(offset_of!(hrbfnpr_picture_desc, scale_bar) == either(448, 428, 408));
    assert!(offset_of!(hrbfnpr_picture_desc, on_event) == either(456, 432, 412));
    assert!(offset_of!(hrbfnpr_picture_desc, event_user) == either(464, 436, 416));
    assert!(offset_of!(hrbfnpr_picture_desc, ground) == either(472, 440, 420));
    assert!(offset_of!(hrbfnpr_picture_desc, reserved) == either(476, 444, 424));
    assert!(offset_of!(hrbfnpr_picture_desc, ground_height) == either(480, 448, 428));
};

const _: () = {
    assert!(size_of::<hrbfnpr_source_info>() == 472);
    assert!(align_of::<hrbfnpr_source_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_source_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_source_info, kind) == 4);
    assert!(offset_of!(hrbfnpr_source_info, severity) == 8);
    assert!(offset_of!(hrbfnpr_source_info, normals_look) == 12);
    assert!(offset_of!(hrbfnpr_source_info, points) == 16);
    assert!(offset_of!(hrbfnpr_source_info, triangles) == 24);
    assert!(offset_of!(hrbfnpr_source_info, no_data) == 32);
    assert!(offset_of!(hrbfnpr_source_info, strays) == 40);
    assert!(offset_of!(hrbfnpr_source_info, points_not_finite) == 48);
    assert!(offset_of!(hrbfnpr_source_info, duplicates) == 56);
    assert!(offset_of!(hrbfnpr_source_info, bounds_min) == 64);
    assert!(offset_of!(hrbfnpr_source_info, bounds_max) == 88);
    assert!(offset_of!(hrbfnpr_source_info, diagonal) == 112);
    assert!(offset_of!(hrbfnpr_source_info, up) == 120);
    assert!(offset_of!(hrbfnpr_source_info, has_normals) == 144);
    assert!(offset_of!(hrbfnpr_source_info, along_curves) == 148);
    assert!(offset_of!(hrbfnpr_source_info, looks_down) == 152);
    assert!(offset_of!(hrbfnpr_source_info, reserved) == 156);
    assert!(offset_of!(hrbfnpr_source_info, normals_zero) == 160);
    assert!(offset_of!(hrbfnpr_source_info, normals_not_finite) == 168);
    assert!(offset_of!(hrbfnpr_source_info, normals_unit_share) == 176);
    assert!(offset_of!(hrbfnpr_source_info, normals_closed) == 184);
    assert!(offset_of!(hrbfnpr_source_info, normals_flipped_share) == 192);
    assert!(offset_of!(hrbfnpr_source_info, image_seen) == 200);
    assert!(offset_of!(hrbfnpr_source_info, image_dropped) == 208);
    assert!(offset_of!(hrbfnpr_source_info, image_depth) == 216);
    assert!(offset_of!(hrbfnpr_source_info, image_noise) == 224);
    assert!(offset_of!(hrbfnpr_source_info, closed) == 232);
    assert!(offset_of!(hrbfnpr_source_info, inside_out) == 236);
    assert!(offset_of!(hrbfnpr_source_info, components) == 240);
    assert!(offset_of!(hrbfnpr_source_info, components_inside_out) == 248);
    assert!(offset_of!(hrbfnpr_source_info, boundary_edges) == 256);
    assert!(offset_of!(hrbfnpr_source_info, boundary_loops) == 264);
    assert!(offset_of!(hrbfnpr_source_info, nonmanifold_edges) == 272);
    assert!(offset_of!(hrbfnpr_source_info, nonmanifold_left) == 280);
    assert!(offset_of!(hrbfnpr_source_info, contrary_edges) == 288);
    assert!(offset_of!(hrbfnpr_source_info, faces_not_finite) == 296);
    assert!(offset_of!(hrbfnpr_source_info, degenerate_faces) == 304);
    assert!(offset_of!(hrbfnpr_source_info, repeated_faces) == 312);
    assert!(offset_of!(hrbfnpr_source_info, unused_vertices) == 320);
    assert!(offset_of!(hrbfnpr_source_info, area) == 328);
    assert!(offset_of!(hrbfnpr_source_info, volume) == 336);
    assert!(offset_of!(hrbfnpr_source_info, up_reason) == 344);
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_info>() == 136);
    assert!(align_of::<hrbfnpr_picture_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_info, preset) == 4);
    assert!(offset_of!(hrbfnpr_picture_info, parts) == 8);
    assert!(offset_of!(hrbfnpr_picture_info, marks) == 16);
    assert!(offset_of!(hrbfnpr_picture_info, notes) == 24);
    assert!(offset_of!(hrbfnpr_picture_info, stages) == 32);
    assert!(offset_of!(hrbfnpr_picture_info, width) == 40);
    assert!(offset_of!(hrbfnpr_picture_info, height) == 44);
    assert!(offset_of!(hrbfnpr_picture_info, bounds_min) == 48);
    assert!(offset_of!(hrbfnpr_picture_info, bounds_max) == 72);
    assert!(offset_of!(hrbfnpr_picture_info, up) == 96);
    assert!(offset_of!(hrbfnpr_picture_info, pen) == 120);
    assert!(offset_of!(hrbfnpr_picture_info, seconds) == 128);
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_part>() == either(40, 24, 24));
    assert!(align_of::<hrbfnpr_picture_part>() == either(8, 4, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_part, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_part, sides) == 4);
    assert!(offset_of!(hrbfnpr_picture_part, model) == 8);
    assert!(offset_of!(hrbfnpr_picture_part, point_set) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_picture_part, line_set) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_picture_part, mesh) == either(32, 20, 20));
};

const _: () = {
    assert!(size_of::<hrbfnpr_picture_page_desc>() == either(64, 56, 52));
    assert!(align_of::<hrbfnpr_picture_page_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_picture_page_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_picture_page_desc, reserved) == 4);
    assert!(offset_of!(hrbfnpr_picture_page_desc, page) == 8);
    assert!(offset_of!(hrbfnpr_picture_page_desc, paper) == either(16, 12, 12));
    assert!(offset_of!(hrbfnpr_picture_page_desc, paper_margin) == either(24, 16, 16));
    assert!(offset_of!(hrbfnpr_picture_page_desc, pen_widths) == either(32, 24, 24));
};

const _: () = {
    assert!(size_of::<hrbfnpr_views_desc>() == either(128, 104, 96));
    assert!(align_of::<hrbfnpr_views_desc>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_views_desc, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_views_desc, flags) == 4);
    assert!(offset_of!(hrbfnpr_views_desc, projection) == 8);
    assert!(offset_of!(hrbfnpr_views_desc, hidden) == 12);
    assert!(offset_of!(hrbfnpr_views_desc, views) == 16);
    assert!(offset_of!(hrbfnpr_views_desc, sections) == either(24, 20, 20));
    assert!(offset_of!(hrbfnpr_views_desc, paper) == either(32, 24, 24));
    assert!(offset_of!(hrbfnpr_views_desc, scale) == either(40, 28, 28));
    assert!(offset_of!(hrbfnpr_views_desc, smooth) == either(48, 32, 32));
    assert!(offset_of!(hrbfnpr_views_desc, title) == either(56, 36, 36));
    assert!(offset_of!(hrbfnpr_views_desc, model) == either(64, 40, 40));
    assert!(offset_of!(hrbfnpr_views_desc, unit_mm) == either(72, 48, 44));
    assert!(offset_of!(hrbfnpr_views_desc, crease_angle) == either(80, 56, 52));
    assert!(offset_of!(hrbfnpr_views_desc, line_width) == either(88, 64, 60));
    assert!(offset_of!(hrbfnpr_views_desc, hatch_spacing) == either(96, 72, 68));
    assert!(offset_of!(hrbfnpr_views_desc, spacing) == either(104, 80, 76));
    assert!(offset_of!(hrbfnpr_views_desc, page) == either(112, 88, 84));
    assert!(offset_of!(hrbfnpr_views_desc, tangent) == either(120, 92, 88));
    assert!(offset_of!(hrbfnpr_views_desc, reserved) == either(124, 96, 92));
};

const _: () = {
    assert!(size_of::<hrbfnpr_views_info>() == 216);
    assert!(align_of::<hrbfnpr_views_info>() == either(8, 8, 4));
};
#[cfg(not(hrbfnpr_no_offset_of))]
const _: () = {
    use core::mem::offset_of;
    assert!(offset_of!(hrbfnpr_views_info, struct_size) == 0);
    assert!(offset_of!(hrbfnpr_views_info, reserved) == 4);
    assert!(offset_of!(hrbfnpr_views_info, views) == 8);
    assert!(offset_of!(hrbfnpr_views_info, bytes) == 16);
    assert!(offset_of!(hrbfnpr_views_info, width) == 24);
    assert!(offset_of!(hrbfnpr_views_info, height) == 32);
    assert!(offset_of!(hrbfnpr_views_info, scale) == 40);
    assert!(offset_of!(hrbfnpr_views_info, unit_mm) == 48);
    assert!(offset_of!(hrbfnpr_views_info, scale_text) == 56);
    assert!(offset_of!(hrbfnpr_views_info, paper) == 120);
    assert!(offset_of!(hrbfnpr_views_info, pieces) == 184);
    assert!(offset_of!(hrbfnpr_views_info, agreeing) == 192);
    assert!(offset_of!(hrbfnpr_views_info, undecided) == 200);
    assert!(offset_of!(hrbfnpr_views_info, repaired) == 208);
};
