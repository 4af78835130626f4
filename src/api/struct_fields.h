// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
#pragma once
// clang-format off

#include "hrbfnpr.h"

#include <cstddef>

namespace hrbfnpr::api {

struct FieldLayout {
    const char* name;
    const char* type; // as C writes it, with [n] for an array
    std::size_t offset, size; // bytes
};

#define FIELD(field, type) {#field, type, offsetof(RECORD, field), sizeof(RECORD::field)}

#define RECORD hrbfnpr_error
inline constexpr FieldLayout fields_of_hrbfnpr_error[] = {
    FIELD(struct_size, "uint32_t"), FIELD(status, "hrbfnpr_status"), FIELD(message, "char[248]")};
#undef RECORD
#define RECORD hrbfnpr_array
inline constexpr FieldLayout fields_of_hrbfnpr_array[] = {
    FIELD(data, "const void*"), FIELD(count, "int64_t"), FIELD(stride, "int64_t"), FIELD(scalar, "uint32_t"),
    FIELD(components, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_array_out
inline constexpr FieldLayout fields_of_hrbfnpr_array_out[] = {
    FIELD(data, "void*"), FIELD(count, "int64_t"), FIELD(stride, "int64_t"), FIELD(scalar, "uint32_t"),
    FIELD(components, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_image
inline constexpr FieldLayout fields_of_hrbfnpr_image[] = {
    FIELD(struct_size, "uint32_t"), FIELD(format, "uint32_t"), FIELD(width, "int32_t"), FIELD(height, "int32_t"),
    FIELD(pixels, "void*"), FIELD(row_stride, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_context_desc
inline constexpr FieldLayout fields_of_hrbfnpr_context_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(abi_version, "uint32_t"), FIELD(thread_count, "int32_t"),
    FIELD(flags, "uint32_t"), FIELD(thread_backend, "uint32_t"), FIELD(highest_instruction_set, "uint32_t"),
    FIELD(allocate, "hrbfnpr_allocate_fn"), FIELD(deallocate, "hrbfnpr_deallocate_fn"), FIELD(allocator_user, "void*"),
    FIELD(log, "hrbfnpr_log_fn"), FIELD(log_user, "void*"), FIELD(log_level, "int32_t"), FIELD(reserved, "uint32_t"),
    FIELD(run_tasks, "hrbfnpr_run_tasks_fn"), FIELD(run_tasks_user, "void*")};
#undef RECORD
#define RECORD hrbfnpr_context_info
inline constexpr FieldLayout fields_of_hrbfnpr_context_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(thread_count, "int32_t"), FIELD(instruction_set, "uint32_t"),
    FIELD(thread_backend, "uint32_t"), FIELD(bytes_now, "int64_t"), FIELD(bytes_peak, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_fit_desc
inline constexpr FieldLayout fields_of_hrbfnpr_fit_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kernel, "uint32_t"), FIELD(points, "hrbfnpr_array"),
    FIELD(normals, "hrbfnpr_array"), FIELD(kernel_radius, "double"), FIELD(polynomial_degree, "int32_t"),
    FIELD(regularization_mode, "uint32_t"), FIELD(regularization, "double"), FIELD(outliers, "uint32_t"),
    FIELD(flipped_normals, "uint32_t"), FIELD(tolerance, "double"), FIELD(maximum_centres, "int64_t"),
    FIELD(solver, "uint32_t"), FIELD(refinement_steps, "int32_t"), FIELD(solver_tolerance, "double"),
    FIELD(iteration_limit, "int32_t"), FIELD(preconditioner_neighbours, "uint32_t"), FIELD(normal_mode, "uint32_t"),
    FIELD(trim, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_orient_desc
inline constexpr FieldLayout fields_of_hrbfnpr_orient_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(mode, "uint32_t"), FIELD(points, "hrbfnpr_array"),
    FIELD(normals, "hrbfnpr_array"), FIELD(up, "double[3]"), FIELD(viewpoint, "double[3]"),
    FIELD(has_viewpoint, "uint32_t"), FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_orient_info
inline constexpr FieldLayout fields_of_hrbfnpr_orient_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(found, "uint32_t"), FIELD(turned, "int64_t"), FIELD(made, "int64_t"),
    FIELD(merged, "int64_t"), FIELD(direction_change, "double"), FIELD(noise, "double"), FIELD(spacing, "double"),
    FIELD(energy, "double"), FIELD(confidence, "double"), FIELD(closed, "uint32_t"), FIELD(outward_by, "uint32_t"),
    FIELD(components, "int64_t"), FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_depth_image_desc
inline constexpr FieldLayout fields_of_hrbfnpr_depth_image_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(columns, "int32_t"), FIELD(rows, "int32_t"), FIELD(keep_points, "uint32_t"),
    FIELD(points, "hrbfnpr_array"), FIELD(noise, "double"), FIELD(smoothing, "double")};
#undef RECORD
#define RECORD hrbfnpr_depth_image_info
inline constexpr FieldLayout fields_of_hrbfnpr_depth_image_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(seen, "int64_t"), FIELD(left_out, "int64_t"),
    FIELD(noise, "double"), FIELD(focal_length, "double"), FIELD(depth, "double"), FIELD(radius, "double"),
    FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_custom_desc
inline constexpr FieldLayout fields_of_hrbfnpr_custom_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(function, "hrbfnpr_implicit_fn"),
    FIELD(user, "void*"), FIELD(release, "void (*)(void* user)"), FIELD(bounds_min, "double[3]"),
    FIELD(bounds_max, "double[3]"), FIELD(difference_step, "double")};
#undef RECORD
#define RECORD hrbfnpr_model_info
inline constexpr FieldLayout fields_of_hrbfnpr_model_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kernel, "uint32_t"), FIELD(polynomial_degree, "int32_t"),
    FIELD(choice_rounds, "int32_t"), FIELD(samples, "int64_t"), FIELD(centres, "int64_t"),
    FIELD(merged_samples, "int64_t"), FIELD(near_duplicates, "int64_t"), FIELD(rescaled_normals, "int64_t"),
    FIELD(outliers_found, "int64_t"), FIELD(outliers_dropped, "int64_t"), FIELD(flipped_found, "int64_t"),
    FIELD(flipped_repaired, "int64_t"), FIELD(bounds_min, "double[3]"), FIELD(bounds_max, "double[3]"),
    FIELD(spacing, "double"), FIELD(kernel_radius, "double"), FIELD(regularization, "double"),
    FIELD(noise_estimate, "double"), FIELD(value_residual_max, "double"), FIELD(value_residual_rms, "double"),
    FIELD(gradient_residual_max, "double"), FIELD(gradient_residual_rms, "double"), FIELD(input_distance_max, "double"),
    FIELD(input_distance_rms, "double"), FIELD(input_share_within, "double"), FIELD(solver, "uint32_t"),
    FIELD(solver_reason, "uint32_t"), FIELD(iterations, "int32_t"), FIELD(fallback, "uint32_t"),
    FIELD(solver_residual, "double"), FIELD(condition_estimate, "double"), FIELD(seconds_clean, "double"),
    FIELD(seconds_choose, "double"), FIELD(seconds_assemble, "double"), FIELD(seconds_precondition, "double"),
    FIELD(seconds_solve, "double"), FIELD(seconds_total, "double"), FIELD(bytes, "int64_t"),
    FIELD(peak_bytes, "int64_t"), FIELD(normals_found, "uint32_t"), FIELD(normals_inward, "uint32_t"),
    FIELD(normals_turned, "int64_t"), FIELD(normals_confidence, "double"), FIELD(seconds_orient, "double")};
#undef RECORD
#define RECORD hrbfnpr_project_desc
inline constexpr FieldLayout fields_of_hrbfnpr_project_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(evaluation_limit, "int32_t"), FIELD(tolerance, "double"),
    FIELD(armijo_slope, "double"), FIELD(armijo_factor, "double")};
#undef RECORD
#define RECORD hrbfnpr_projection
inline constexpr FieldLayout fields_of_hrbfnpr_projection[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(position, "hrbfnpr_array_out"),
    FIELD(normal, "hrbfnpr_array_out"), FIELD(status, "hrbfnpr_array_out"), FIELD(converged, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_curvature
inline constexpr FieldLayout fields_of_hrbfnpr_curvature[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(k1, "hrbfnpr_array_out"),
    FIELD(k2, "hrbfnpr_array_out"), FIELD(d1, "hrbfnpr_array_out"), FIELD(d2, "hrbfnpr_array_out"),
    FIELD(confidence, "hrbfnpr_array_out")};
#undef RECORD
#define RECORD hrbfnpr_cast_desc
inline constexpr FieldLayout fields_of_hrbfnpr_cast_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(maximum_hits, "int32_t"), FIELD(evaluation_limit, "int32_t"),
    FIELD(reserved, "uint32_t"), FIELD(t_min, "double"), FIELD(t_max, "double"), FIELD(lipschitz, "double"),
    FIELD(smallest_step, "double"), FIELD(tolerance, "double"), FIELD(line_set, "const hrbfnpr_line_set*"),
    FIELD(refine, "uint32_t"), FIELD(reserved2, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_ray_hits
inline constexpr FieldLayout fields_of_hrbfnpr_ray_hits[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(count, "hrbfnpr_array_out"),
    FIELD(t, "hrbfnpr_array_out"), FIELD(position, "hrbfnpr_array_out"), FIELD(normal, "hrbfnpr_array_out"),
    FIELD(entering, "hrbfnpr_array_out"), FIELD(status, "hrbfnpr_array_out"), FIELD(hit_rays, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_trim_desc
inline constexpr FieldLayout fields_of_hrbfnpr_trim_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(limit, "double"), FIELD(hole, "double"),
    FIELD(closest, "double"), FIELD(points, "hrbfnpr_array"), FIELD(normals, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_trim_info
inline constexpr FieldLayout fields_of_hrbfnpr_trim_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(is_trimmed, "uint32_t"), FIELD(samples, "int64_t"), FIELD(parts, "int64_t"),
    FIELD(parts_to_end, "int64_t"), FIELD(share, "double"), FIELD(farthest, "double"), FIELD(spacing, "double")};
#undef RECORD
#define RECORD hrbfnpr_csg_node
inline constexpr FieldLayout fields_of_hrbfnpr_csg_node[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(parent, "int64_t"),
    FIELD(model, "const hrbfnpr_model*"), FIELD(transform, "double[16]"), FIELD(size, "double[3]"),
    FIELD(radius, "double"), FIELD(second_radius, "double"), FIELD(height, "double"), FIELD(distance, "double"),
    FIELD(blend, "double"), FIELD(exponent, "double")};
#undef RECORD
#define RECORD hrbfnpr_csg_desc
inline constexpr FieldLayout fields_of_hrbfnpr_csg_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(nodes, "const hrbfnpr_csg_node*"),
    FIELD(node_count, "int64_t"), FIELD(node_stride, "int64_t"), FIELD(bounds_min, "double[3]"),
    FIELD(bounds_max, "double[3]")};
#undef RECORD
#define RECORD hrbfnpr_csg_info
inline constexpr FieldLayout fields_of_hrbfnpr_csg_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(nodes, "int64_t"), FIELD(depth, "int64_t"),
    FIELD(models, "int64_t"), FIELD(sheets, "int64_t"), FIELD(lipschitz, "double")};
#undef RECORD
#define RECORD hrbfnpr_layer_desc
inline constexpr FieldLayout fields_of_hrbfnpr_layer_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"), FIELD(budget, "int64_t"),
    FIELD(tone_begin, "float"), FIELD(tone_end, "float"), FIELD(second_tone_begin, "float"),
    FIELD(second_tone_end, "float"), FIELD(flags, "uint32_t"), FIELD(density, "uint32_t"),
    FIELD(density_strength, "double"), FIELD(density_function, "hrbfnpr_density_fn"), FIELD(density_user, "void*"),
    FIELD(direction_function, "hrbfnpr_direction_fn"), FIELD(direction_user, "void*"), FIELD(guide, "uint32_t"),
    FIELD(start, "uint32_t"), FIELD(start_level, "int32_t"), FIELD(levels, "int32_t"), FIELD(separation, "double"),
    FIELD(step, "double"), FIELD(angle, "double"), FIELD(smoothing, "double"), FIELD(axis, "double[3]"),
    FIELD(axis_weight, "double"), FIELD(guide_direction, "double[3]"), FIELD(guide_weight, "double"),
    FIELD(tone_smoothing, "double"), FIELD(density_field, "const hrbfnpr_field*"),
    FIELD(direction_field, "const hrbfnpr_field*")};
#undef RECORD
#define RECORD hrbfnpr_generate_desc
inline constexpr FieldLayout fields_of_hrbfnpr_generate_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(distribution, "uint32_t"), FIELD(layers, "const hrbfnpr_layer_desc*"),
    FIELD(layer_count, "int64_t"), FIELD(layer_stride, "int64_t"), FIELD(shared_budget, "int64_t"),
    FIELD(tone_ranges, "uint32_t"), FIELD(seed_source, "uint32_t"), FIELD(seed_points, "hrbfnpr_array"),
    FIELD(box_jitter, "double"), FIELD(box_resolution, "uint32_t"), FIELD(reserved, "uint32_t"),
    FIELD(initial_step, "double"), FIELD(projection_tolerance, "double"), FIELD(random_seed, "uint64_t")};
#undef RECORD
#define RECORD hrbfnpr_layer_arrays
inline constexpr FieldLayout fields_of_hrbfnpr_layer_arrays[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"),
    FIELD(position, "hrbfnpr_array"), FIELD(normal, "hrbfnpr_array"), FIELD(stroke_first, "hrbfnpr_array"),
    FIELD(stroke_direction, "hrbfnpr_array"), FIELD(direction, "hrbfnpr_array"), FIELD(curvature, "hrbfnpr_array"),
    FIELD(rank, "hrbfnpr_array"), FIELD(level, "hrbfnpr_array"), FIELD(width, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_point_set_desc
inline constexpr FieldLayout fields_of_hrbfnpr_point_set_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(base, "const hrbfnpr_point_set*"),
    FIELD(layers, "const hrbfnpr_layer_arrays*"), FIELD(layer_count, "int64_t"), FIELD(layer_stride, "int64_t"),
    FIELD(random_seed, "uint64_t")};
#undef RECORD
#define RECORD hrbfnpr_point_set_info
inline constexpr FieldLayout fields_of_hrbfnpr_point_set_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(distribution, "uint32_t"), FIELD(seed_source, "uint32_t"),
    FIELD(reserved, "uint32_t"), FIELD(layers, "int64_t"), FIELD(marks, "int64_t"), FIELD(origin, "double[3]"),
    FIELD(bounds_min, "double[3]"), FIELD(bounds_max, "double[3]"), FIELD(spacing, "double"),
    FIELD(seconds_seeds, "double"), FIELD(seconds_total, "double"), FIELD(bytes, "int64_t"),
    FIELD(field_count, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_layer_info
inline constexpr FieldLayout fields_of_hrbfnpr_layer_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "char[64]"), FIELD(marks, "int64_t"),
    FIELD(strokes, "int64_t"), FIELD(full_count, "int64_t"), FIELD(levels, "int32_t"), FIELD(reserved, "uint32_t"),
    FIELD(step, "double"), FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_placement_info
inline constexpr FieldLayout fields_of_hrbfnpr_placement_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(attempted, "int64_t"), FIELD(placed, "int64_t"),
    FIELD(dropped_not_converged, "int64_t"), FIELD(dropped_strayed, "int64_t"), FIELD(dropped_degenerate, "int64_t"),
    FIELD(dropped_budget, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_mark_field
inline constexpr FieldLayout fields_of_hrbfnpr_mark_field[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(name, "const char*"),
    FIELD(field, "const hrbfnpr_field*"), FIELD(transform, "const double*")};
#undef RECORD
#define RECORD hrbfnpr_line_desc
inline constexpr FieldLayout fields_of_hrbfnpr_line_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"), FIELD(lower, "double"),
    FIELD(upper, "double"), FIELD(shortest, "double"), FIELD(plane, "double[3]"), FIELD(levels, "hrbfnpr_array"),
    FIELD(position, "hrbfnpr_array"), FIELD(line_first, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_line_set_desc
inline constexpr FieldLayout fields_of_hrbfnpr_line_set_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(cell_size, "double"),
    FIELD(seed_points, "hrbfnpr_array"), FIELD(lines, "const hrbfnpr_line_desc*"), FIELD(line_count, "int64_t"),
    FIELD(line_stride, "int64_t"), FIELD(support, "double"), FIELD(support_points, "hrbfnpr_array"),
    FIELD(support_normals, "hrbfnpr_array"), FIELD(mesh, "const hrbfnpr_mesh*")};
#undef RECORD
#define RECORD hrbfnpr_line_set_info
inline constexpr FieldLayout fields_of_hrbfnpr_line_set_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(triangles, "int64_t"), FIELD(turned, "int64_t"),
    FIELD(missed_seeds, "int64_t"), FIELD(lines, "int64_t"), FIELD(borders, "int64_t"), FIELD(cell_size, "double"),
    FIELD(seconds, "double"), FIELD(bytes, "int64_t"), FIELD(left_out, "double"), FIELD(creases, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_camera
inline constexpr FieldLayout fields_of_hrbfnpr_camera[] = {
    FIELD(struct_size, "uint32_t"), FIELD(depth_convention, "uint32_t"), FIELD(view, "double[16]"),
    FIELD(projection, "double[16]"), FIELD(viewport, "double[4]")};
#undef RECORD
#define RECORD hrbfnpr_light
inline constexpr FieldLayout fields_of_hrbfnpr_light[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(space, "uint32_t"), FIELD(intensity, "float"),
    FIELD(shadow, "float"), FIELD(softness, "float"), FIELD(place, "double[3]")};
#undef RECORD
#define RECORD hrbfnpr_layer_style
inline constexpr FieldLayout fields_of_hrbfnpr_layer_style[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"), FIELD(shown, "uint32_t"),
    FIELD(contours, "uint32_t"), FIELD(directions, "uint32_t"), FIELD(shape, "uint32_t"), FIELD(share, "float"),
    FIELD(radius, "float"), FIELD(radius_zoom, "float"), FIELD(reserved, "uint32_t"), FIELD(ink, "float[4]"),
    FIELD(hatch_tone_begin, "float"), FIELD(hatch_tone_end, "float"), FIELD(hatch_coverage_begin, "float"),
    FIELD(hatch_coverage_end, "float"), FIELD(hatch_spacing, "float"), FIELD(hatch_pen, "float"),
    FIELD(hatch_white, "float"), FIELD(hatch_taper, "float"), FIELD(hatch_shortest, "float"),
    FIELD(reserved2, "uint32_t"), FIELD(hatch_wobble, "float"), FIELD(hatch_overshoot, "float"),
    FIELD(hatch_seed, "uint32_t"), FIELD(reserved3, "uint32_t"), FIELD(density_field, "const char*"),
    FIELD(tone_field, "const char*"), FIELD(width_field, "const char*"), FIELD(ink_field, "const char*"),
    FIELD(mask_field, "const char*"), FIELD(tone_field_rule, "uint32_t"), FIELD(palette_rule, "uint32_t"),
    FIELD(hatch_fade, "float"), FIELD(reserved4, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_line_style
inline constexpr FieldLayout fields_of_hrbfnpr_line_style[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"), FIELD(hidden, "uint32_t"),
    FIELD(cap, "uint32_t"), FIELD(width, "float"), FIELD(taper, "float"), FIELD(hidden_width, "float"),
    FIELD(hidden_opacity, "float"), FIELD(dash, "float"), FIELD(gap, "float"), FIELD(shortest, "float"),
    FIELD(fade, "float"), FIELD(lower, "double"), FIELD(upper, "double"), FIELD(levels, "hrbfnpr_array"),
    FIELD(ink, "float[4]"), FIELD(outline_factor, "float"), FIELD(far_factor, "float"), FIELD(lit_factor, "float"),
    FIELD(curvature_factor, "float"), FIELD(curvature_radius, "float"), FIELD(wobble, "float"),
    FIELD(wobble_width, "float"), FIELD(wobble_length, "float"), FIELD(wobble_seed, "uint32_t"),
    FIELD(creases, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_style
inline constexpr FieldLayout fields_of_hrbfnpr_style[] = {
    FIELD(struct_size, "uint32_t"), FIELD(tone, "uint32_t"), FIELD(paper, "float[4]"),
    FIELD(layers, "const hrbfnpr_layer_style*"), FIELD(layer_count, "int64_t"), FIELD(layer_stride, "int64_t"),
    FIELD(tone_rule, "uint32_t"), FIELD(tone_curve, "uint32_t"), FIELD(light, "double[3]"),
    FIELD(tone_exponent, "double"), FIELD(tone_function, "hrbfnpr_tone_fn"), FIELD(tone_user, "void*"),
    FIELD(light_space, "uint32_t"), FIELD(tone_fade, "float"), FIELD(silhouette_threshold, "double"),
    FIELD(silhouette_radius, "float"), FIELD(silhouette_radius_zoom, "float"), FIELD(silhouette_ink, "float[4]"),
    FIELD(visibility, "uint32_t"), FIELD(hidden_lines, "uint32_t"), FIELD(attenuation_front, "double"),
    FIELD(attenuation_back, "double"), FIELD(splat_radius, "float"), FIELD(splat_overlap, "float"),
    FIELD(halo_width, "float"), FIELD(verify_lines, "uint32_t"), FIELD(depth_min, "double"), FIELD(depth_max, "double"),
    FIELD(zoom_reference, "double"), FIELD(zoom_exponent, "double"), FIELD(lines, "const hrbfnpr_line_style*"),
    FIELD(line_count, "int64_t"), FIELD(line_stride, "int64_t"), FIELD(fill_light, "float"),
    FIELD(reserved2, "uint32_t"), FIELD(light_intensity, "float"), FIELD(light_shadow, "float"),
    FIELD(light_softness, "float"), FIELD(evenness, "uint32_t"), FIELD(lights, "const hrbfnpr_light*"),
    FIELD(light_count, "int64_t"), FIELD(light_stride, "int64_t"), FIELD(ambient_up, "double[3]"),
    FIELD(ambient_sky, "float"), FIELD(ambient_ground, "float"), FIELD(occlusion, "float"),
    FIELD(occlusion_exponent, "float"), FIELD(rim_light, "float"), FIELD(rim_exponent, "float"),
    FIELD(tone_black, "float"), FIELD(tone_white, "float"), FIELD(tone_gamma, "float"), FIELD(tone_steps, "uint32_t"),
    FIELD(curvature_contrast, "float"), FIELD(occlusion_lights, "float"), FIELD(palette, "const float*"),
    FIELD(palette_count, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_dab
inline constexpr FieldLayout fields_of_hrbfnpr_dab[] = {
    FIELD(struct_size, "uint32_t"), FIELD(map, "uint32_t"), FIELD(position, "double[3]"), FIELD(normal, "double[3]"),
    FIELD(radius, "double"), FIELD(strength, "double"), FIELD(value, "double"), FIELD(direction, "double[3]")};
#undef RECORD
#define RECORD hrbfnpr_field_desc
inline constexpr FieldLayout fields_of_hrbfnpr_field_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(source, "uint32_t"), FIELD(flags, "uint32_t"),
    FIELD(range, "double[2]"), FIELD(points, "hrbfnpr_array"), FIELD(triangles, "hrbfnpr_array"),
    FIELD(values, "hrbfnpr_array"), FIELD(reach, "double"), FIELD(function, "hrbfnpr_field_fn"), FIELD(user, "void*"),
    FIELD(dabs, "const hrbfnpr_dab*"), FIELD(dab_count, "int64_t"), FIELD(dab_stride, "int64_t"),
    FIELD(image, "const hrbfnpr_image*"), FIELD(camera, "const hrbfnpr_camera*"),
    FIELD(occluders, "const hrbfnpr_occluders*")};
#undef RECORD
#define RECORD hrbfnpr_layer_pose
inline constexpr FieldLayout fields_of_hrbfnpr_layer_pose[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(layer, "int64_t"),
    FIELD(position, "hrbfnpr_array"), FIELD(normal, "hrbfnpr_array"), FIELD(direction, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_item
inline constexpr FieldLayout fields_of_hrbfnpr_item[] = {
    FIELD(struct_size, "uint32_t"), FIELD(sides, "uint32_t"), FIELD(point_set, "const hrbfnpr_point_set*"),
    FIELD(style, "const hrbfnpr_style*"), FIELD(model, "const hrbfnpr_model*"), FIELD(transform, "double[16]"),
    FIELD(poses, "const hrbfnpr_layer_pose*"), FIELD(pose_count, "int64_t"), FIELD(pose_stride, "int64_t"),
    FIELD(line_set, "const hrbfnpr_line_set*"), FIELD(shading, "const hrbfnpr_shading*")};
#undef RECORD
#define RECORD hrbfnpr_shading_desc
inline constexpr FieldLayout fields_of_hrbfnpr_shading_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(sky_rays, "int32_t"), FIELD(shadow_rays, "int32_t"), FIELD(flags, "uint32_t"),
    FIELD(occlusion_reach, "double"), FIELD(previous, "const hrbfnpr_shading*"), FIELD(curvature_scale, "double")};
#undef RECORD
#define RECORD hrbfnpr_drawing_info
inline constexpr FieldLayout fields_of_hrbfnpr_drawing_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(items, "int64_t"), FIELD(layers, "int64_t"),
    FIELD(dots, "int64_t"), FIELD(strokes, "int64_t"), FIELD(stroke_points, "int64_t"), FIELD(marks, "int64_t"),
    FIELD(outside, "int64_t"), FIELD(front, "int64_t"), FIELD(back, "int64_t"), FIELD(silhouette, "int64_t"),
    FIELD(culled, "int64_t"), FIELD(shown, "int64_t"), FIELD(dropped_tone, "int64_t"), FIELD(dropped_depth, "int64_t"),
    FIELD(dropped_zoom, "int64_t"), FIELD(dropped_hidden, "int64_t"), FIELD(splats, "int64_t"),
    FIELD(nanoseconds_classify, "int64_t"), FIELD(nanoseconds_visibility, "int64_t"),
    FIELD(nanoseconds_sort, "int64_t"), FIELD(bytes, "int64_t"), FIELD(scratch_bytes, "int64_t"),
    FIELD(line_curves, "int64_t"), FIELD(line_cusps, "int64_t"), FIELD(line_crossings, "int64_t"),
    FIELD(line_broken, "int64_t"), FIELD(line_settled, "int64_t"), FIELD(line_contradictions, "int64_t"),
    FIELD(nanoseconds_lines, "int64_t"), FIELD(line_refined, "int64_t"), FIELD(line_tangles, "int64_t"),
    FIELD(line_pieces, "int64_t"), FIELD(line_agreeing, "int64_t"), FIELD(line_undecided, "int64_t"),
    FIELD(line_repaired, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_drawing_layer_info
inline constexpr FieldLayout fields_of_hrbfnpr_drawing_layer_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(mark_class, "uint32_t"), FIELD(item, "int64_t"), FIELD(layer, "int64_t"),
    FIELD(kind, "uint32_t"), FIELD(shape, "uint32_t"), FIELD(name, "char[64]"), FIELD(ink, "float[4]"),
    FIELD(dots, "int64_t"), FIELD(strokes, "int64_t"), FIELD(ink_number, "int32_t"), FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_raster_desc
inline constexpr FieldLayout fields_of_hrbfnpr_raster_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(host_depth, "hrbfnpr_array"),
    FIELD(depth, "hrbfnpr_array_out"), FIELD(id, "hrbfnpr_array_out"), FIELD(mark_class, "hrbfnpr_array_out")};
#undef RECORD
#define RECORD hrbfnpr_vertex_attribute
inline constexpr FieldLayout fields_of_hrbfnpr_vertex_attribute[] = {
    FIELD(struct_size, "uint32_t"), FIELD(attribute, "uint32_t"), FIELD(scalar, "uint32_t"), FIELD(offset, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_vertex_layout
inline constexpr FieldLayout fields_of_hrbfnpr_vertex_layout[] = {
    FIELD(struct_size, "uint32_t"), FIELD(primitive, "uint32_t"), FIELD(attributes, "const hrbfnpr_vertex_attribute*"),
    FIELD(attribute_count, "int64_t"), FIELD(attribute_stride, "int64_t"), FIELD(stride, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_mark_results
inline constexpr FieldLayout fields_of_hrbfnpr_mark_results[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(shown, "hrbfnpr_array_out"),
    FIELD(radius, "hrbfnpr_array_out"), FIELD(opacity, "hrbfnpr_array_out")};
#undef RECORD
#define RECORD hrbfnpr_mark_identity
inline constexpr FieldLayout fields_of_hrbfnpr_mark_identity[] = {
    FIELD(struct_size, "uint32_t"), FIELD(id, "uint32_t"), FIELD(item, "int64_t"), FIELD(layer, "int64_t"),
    FIELD(mark, "int64_t"), FIELD(stroke, "int64_t"), FIELD(place, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_mesh_desc
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(parts, "uint32_t"), FIELD(vertices, "hrbfnpr_array"),
    FIELD(triangles, "hrbfnpr_array"), FIELD(crease_angle, "double"), FIELD(faces, "uint32_t"),
    FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_mesh_info
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(closed, "uint32_t"), FIELD(given_vertices, "int64_t"),
    FIELD(given_faces, "int64_t"), FIELD(vertices, "int64_t"), FIELD(faces, "int64_t"),
    FIELD(welded_vertices, "int64_t"), FIELD(degenerate_faces, "int64_t"), FIELD(repeated_faces, "int64_t"),
    FIELD(turned_faces, "int64_t"), FIELD(components, "int64_t"), FIELD(turned_components, "int64_t"),
    FIELD(nested_components, "int64_t"), FIELD(left_out_components, "int64_t"), FIELD(left_out_faces, "int64_t"),
    FIELD(boundary_edges, "int64_t"), FIELD(boundary_loops, "int64_t"), FIELD(nonmanifold_edges, "int64_t"),
    FIELD(contrary_edges, "int64_t"), FIELD(euler_characteristic, "int64_t"), FIELD(genus, "int64_t"),
    FIELD(area, "double"), FIELD(volume, "double"), FIELD(bounds_min, "double[3]"), FIELD(bounds_max, "double[3]"),
    FIELD(seconds, "double"), FIELD(bytes, "int64_t"), FIELD(crease_length, "double"), FIELD(creases, "uint32_t"),
    FIELD(cavities, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_sample_desc
inline constexpr FieldLayout fields_of_hrbfnpr_sample_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(candidates, "int64_t"),
    FIELD(random_seed, "uint64_t")};
#undef RECORD
#define RECORD hrbfnpr_mesh_edges_desc
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_edges_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(edges, "uint32_t"), FIELD(crease_angle, "double"), FIELD(far, "double"),
    FIELD(tangent, "uint32_t"), FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_mesh_edges_info
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_edges_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(edges, "int64_t"), FIELD(patches, "int64_t"),
    FIELD(length, "double"), FIELD(fading, "double"), FIELD(doubtful, "double"), FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_compare_desc
inline constexpr FieldLayout fields_of_hrbfnpr_compare_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(tolerance, "double"), FIELD(far, "double"),
    FIELD(support, "double"), FIELD(points, "int64_t"), FIELD(cell_size, "double"), FIELD(random_seed, "uint64_t")};
#undef RECORD
#define RECORD hrbfnpr_comparison
inline constexpr FieldLayout fields_of_hrbfnpr_comparison[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(surface_points, "int64_t"),
    FIELD(surface_mean, "double"), FIELD(surface_p99, "double"), FIELD(surface_max, "double"),
    FIELD(surface_share, "double"), FIELD(invented_share, "double"), FIELD(left_out_share, "double"),
    FIELD(mesh_points, "int64_t"), FIELD(mesh_mean, "double"), FIELD(mesh_p99, "double"), FIELD(mesh_max, "double"),
    FIELD(mesh_share, "double"), FIELD(missed_share, "double"), FIELD(normal_mean, "double"),
    FIELD(normal_p99, "double"), FIELD(components, "int64_t"), FIELD(genus, "int64_t"), FIELD(tolerance, "double"),
    FIELD(diagonal, "double"), FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_mesh_fit_desc
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_fit_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(tolerance, "double"), FIELD(share, "double"),
    FIELD(far, "double"), FIELD(maximum_centres, "int64_t"), FIELD(candidates, "int64_t"),
    FIELD(random_seed, "uint64_t"), FIELD(crease_angle, "double"), FIELD(edges, "uint32_t"),
    FIELD(reserved2, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_mesh_fit_info
inline constexpr FieldLayout fields_of_hrbfnpr_mesh_fit_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reached, "uint32_t"), FIELD(tolerance, "double"), FIELD(far, "double"),
    FIELD(candidates, "int64_t"), FIELD(centres, "int64_t"), FIELD(off_surface_centres, "int64_t"),
    FIELD(rounds, "int32_t"), FIELD(supported, "uint32_t"), FIELD(surface_share, "double"),
    FIELD(surface_p99, "double"), FIELD(surface_max, "double"), FIELD(mesh_share, "double"), FIELD(mesh_p99, "double"),
    FIELD(mesh_max, "double"), FIELD(seconds_sample, "double"), FIELD(seconds_fit, "double"),
    FIELD(seconds_measure, "double"), FIELD(seconds_total, "double"), FIELD(sheets, "int32_t"),
    FIELD(reserved, "uint32_t"), FIELD(crease_length, "double"), FIELD(smooth_length, "double"),
    FIELD(cells, "int64_t"), FIELD(poor_cells, "int64_t"), FIELD(touching_parts, "int32_t[2]"),
    FIELD(touching_place, "double[3]"), FIELD(parts_may_cross, "uint32_t"), FIELD(reserved2, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_page_item
inline constexpr FieldLayout fields_of_hrbfnpr_page_item[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(drawing, "const hrbfnpr_drawing*"),
    FIELD(x, "double"), FIELD(y, "double"), FIELD(scale, "double"), FIELD(name, "const char*")};
#undef RECORD
#define RECORD hrbfnpr_pen
inline constexpr FieldLayout fields_of_hrbfnpr_pen[] = {
    FIELD(struct_size, "uint32_t"), FIELD(line_type, "uint32_t"), FIELD(groups, "const char*"), FIELD(width, "double"),
    FIELD(ink, "float[4]"), FIELD(number, "uint32_t"), FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_annotation
inline constexpr FieldLayout fields_of_hrbfnpr_annotation[] = {
    FIELD(struct_size, "uint32_t"), FIELD(line_type, "uint32_t"), FIELD(group, "const char*"),
    FIELD(text, "const char*"), FIELD(points, "hrbfnpr_array"), FIELD(width, "double"), FIELD(ink, "float[4]")};
#undef RECORD
#define RECORD hrbfnpr_page_desc
inline constexpr FieldLayout fields_of_hrbfnpr_page_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(format, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(widths, "uint32_t"),
    FIELD(dots, "uint32_t"), FIELD(curves, "uint32_t"), FIELD(width, "double"), FIELD(height, "double"),
    FIELD(tolerance, "double"), FIELD(width_step, "double"), FIELD(join, "double"), FIELD(shortest, "double"),
    FIELD(dot_distance, "double"), FIELD(draw_speed, "double"), FIELD(travel_speed, "double"),
    FIELD(pen_seconds, "double"), FIELD(pen_down, "const char*"), FIELD(pen_up, "const char*"),
    FIELD(title, "const char*"), FIELD(description, "const char*"), FIELD(metadata, "const char*"),
    FIELD(items, "const hrbfnpr_page_item*"), FIELD(item_count, "int64_t"), FIELD(item_stride, "int64_t"),
    FIELD(pens, "const hrbfnpr_pen*"), FIELD(pen_count, "int64_t"), FIELD(pen_stride, "int64_t"),
    FIELD(annotations, "const hrbfnpr_annotation*"), FIELD(annotation_count, "int64_t"),
    FIELD(annotation_stride, "int64_t"), FIELD(longest, "double")};
#undef RECORD
#define RECORD hrbfnpr_page_info
inline constexpr FieldLayout fields_of_hrbfnpr_page_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(bytes, "int64_t"), FIELD(groups, "int64_t"),
    FIELD(paths, "int64_t"), FIELD(segments, "int64_t"), FIELD(dots, "int64_t"), FIELD(joined, "int64_t"),
    FIELD(dropped_paths, "int64_t"), FIELD(dropped_dots, "int64_t"), FIELD(width, "double"), FIELD(height, "double"),
    FIELD(drawn, "double"), FIELD(travelled, "double"), FIELD(seconds, "double"), FIELD(filled_paths, "int64_t"),
    FIELD(cut_paths, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_source_field
inline constexpr FieldLayout fields_of_hrbfnpr_source_field[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(name, "const char*"), FIELD(values, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_picture_source
inline constexpr FieldLayout fields_of_hrbfnpr_picture_source[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(points, "hrbfnpr_array"),
    FIELD(normals, "hrbfnpr_array"), FIELD(triangles, "hrbfnpr_array"), FIELD(sharp_edges, "hrbfnpr_array"),
    FIELD(model, "const hrbfnpr_model*"), FIELD(point_set, "const hrbfnpr_point_set*"), FIELD(up, "double[3]"),
    FIELD(up_by, "const char*"), FIELD(viewpoint, "double[3]"), FIELD(columns, "int64_t"), FIELD(rows, "int64_t"),
    FIELD(name, "const char*"), FIELD(fields, "const hrbfnpr_source_field*"), FIELD(field_count, "int64_t"),
    FIELD(field_stride, "int64_t")};
#undef RECORD
#define RECORD hrbfnpr_change
inline constexpr FieldLayout fields_of_hrbfnpr_change[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(field, "const char*"),
    FIELD(value, "const char*")};
#undef RECORD
#define RECORD hrbfnpr_note
inline constexpr FieldLayout fields_of_hrbfnpr_note[] = {
    FIELD(struct_size, "uint32_t"), FIELD(code, "uint32_t"), FIELD(severity, "uint32_t"),
    FIELD(figure_count, "uint32_t"), FIELD(figures, "double[8]"), FIELD(text, "const char*"),
    FIELD(advice, "const char*"), FIELD(detail, "const char*")};
#undef RECORD
#define RECORD hrbfnpr_picture_event
inline constexpr FieldLayout fields_of_hrbfnpr_picture_event[] = {
    FIELD(struct_size, "uint32_t"), FIELD(stage, "uint32_t"), FIELD(fraction, "double"), FIELD(seconds, "double"),
    FIELD(name, "const char*"), FIELD(doing, "const char*"), FIELD(says, "const char*"),
    FIELD(note, "const hrbfnpr_note*")};
#undef RECORD
#define RECORD hrbfnpr_picture_desc
inline constexpr FieldLayout fields_of_hrbfnpr_picture_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(sources, "const hrbfnpr_picture_source*"),
    FIELD(source_count, "int64_t"), FIELD(source_stride, "int64_t"), FIELD(preset, "uint32_t"),
    FIELD(wording, "uint32_t"), FIELD(style_name, "const char*"), FIELD(style, "const hrbfnpr_style*"),
    FIELD(settings, "const hrbfnpr_settings*"), FIELD(changes, "const hrbfnpr_change*"), FIELD(change_count, "int64_t"),
    FIELD(change_stride, "int64_t"), FIELD(dabs, "const hrbfnpr_dab*"), FIELD(dab_count, "int64_t"),
    FIELD(dab_stride, "int64_t"), FIELD(width, "int32_t"), FIELD(height, "int32_t"), FIELD(size, "int32_t"),
    FIELD(sides, "uint32_t"), FIELD(pen, "double"), FIELD(line_width, "double"), FIELD(camera, "const hrbfnpr_camera*"),
    FIELD(up, "double[3]"), FIELD(azimuth, "double"), FIELD(elevation, "double"), FIELD(direction, "double[3]"),
    FIELD(eye, "double[3]"), FIELD(target, "double[3]"), FIELD(fov, "double"), FIELD(margin, "double"),
    FIELD(turn, "double"), FIELD(turn_frames, "int32_t"), FIELD(normals, "uint32_t"), FIELD(samples, "int64_t"),
    FIELD(tolerance, "double"), FIELD(maximum_centres, "int64_t"), FIELD(parts, "uint32_t"), FIELD(edges, "uint32_t"),
    FIELD(edge_angle, "double"), FIELD(crease_angle, "double"), FIELD(subdivide, "int32_t"), FIELD(profile, "uint32_t"),
    FIELD(viewpoint, "double[3]"), FIELD(depth_smoothing, "double"), FIELD(random_seed, "uint64_t"),
    FIELD(mark_kinds, "const char*"), FIELD(seed_points, "hrbfnpr_array"), FIELD(hatch_angle, "double"),
    FIELD(lines, "const char*"), FIELD(scale_bar, "const char*"), FIELD(on_event, "hrbfnpr_picture_event_fn"),
    FIELD(event_user, "void*"), FIELD(ground, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(ground_height, "double")};
#undef RECORD
#define RECORD hrbfnpr_source_info
inline constexpr FieldLayout fields_of_hrbfnpr_source_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(kind, "uint32_t"), FIELD(severity, "uint32_t"),
    FIELD(normals_look, "uint32_t"), FIELD(points, "int64_t"), FIELD(triangles, "int64_t"), FIELD(no_data, "int64_t"),
    FIELD(strays, "int64_t"), FIELD(points_not_finite, "int64_t"), FIELD(duplicates, "int64_t"),
    FIELD(bounds_min, "double[3]"), FIELD(bounds_max, "double[3]"), FIELD(diagonal, "double"), FIELD(up, "double[3]"),
    FIELD(has_normals, "uint32_t"), FIELD(along_curves, "uint32_t"), FIELD(looks_down, "uint32_t"),
    FIELD(reserved, "uint32_t"), FIELD(normals_zero, "int64_t"), FIELD(normals_not_finite, "int64_t"),
    FIELD(normals_unit_share, "double"), FIELD(normals_closed, "double"), FIELD(normals_flipped_share, "double"),
    FIELD(image_seen, "int64_t"), FIELD(image_dropped, "int64_t"), FIELD(image_depth, "double"),
    FIELD(image_noise, "double"), FIELD(closed, "uint32_t"), FIELD(inside_out, "uint32_t"),
    FIELD(components, "int64_t"), FIELD(components_inside_out, "int64_t"), FIELD(boundary_edges, "int64_t"),
    FIELD(boundary_loops, "int64_t"), FIELD(nonmanifold_edges, "int64_t"), FIELD(nonmanifold_left, "int64_t"),
    FIELD(contrary_edges, "int64_t"), FIELD(faces_not_finite, "int64_t"), FIELD(degenerate_faces, "int64_t"),
    FIELD(repeated_faces, "int64_t"), FIELD(unused_vertices, "int64_t"), FIELD(area, "double"), FIELD(volume, "double"),
    FIELD(up_reason, "char[128]")};
#undef RECORD
#define RECORD hrbfnpr_picture_info
inline constexpr FieldLayout fields_of_hrbfnpr_picture_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(preset, "uint32_t"), FIELD(parts, "int64_t"), FIELD(marks, "int64_t"),
    FIELD(notes, "int64_t"), FIELD(stages, "int64_t"), FIELD(width, "int32_t"), FIELD(height, "int32_t"),
    FIELD(bounds_min, "double[3]"), FIELD(bounds_max, "double[3]"), FIELD(up, "double[3]"), FIELD(pen, "double"),
    FIELD(seconds, "double")};
#undef RECORD
#define RECORD hrbfnpr_picture_part
inline constexpr FieldLayout fields_of_hrbfnpr_picture_part[] = {
    FIELD(struct_size, "uint32_t"), FIELD(sides, "uint32_t"), FIELD(model, "const hrbfnpr_model*"),
    FIELD(point_set, "const hrbfnpr_point_set*"), FIELD(line_set, "const hrbfnpr_line_set*"),
    FIELD(mesh, "const hrbfnpr_mesh*")};
#undef RECORD
#define RECORD hrbfnpr_picture_page_desc
inline constexpr FieldLayout fields_of_hrbfnpr_picture_page_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(page, "const hrbfnpr_page_desc*"),
    FIELD(paper, "const char*"), FIELD(paper_margin, "double"), FIELD(pen_widths, "hrbfnpr_array")};
#undef RECORD
#define RECORD hrbfnpr_views_desc
inline constexpr FieldLayout fields_of_hrbfnpr_views_desc[] = {
    FIELD(struct_size, "uint32_t"), FIELD(flags, "uint32_t"), FIELD(projection, "uint32_t"), FIELD(hidden, "uint32_t"),
    FIELD(views, "const char*"), FIELD(sections, "const char*"), FIELD(paper, "const char*"),
    FIELD(scale, "const char*"), FIELD(smooth, "const char*"), FIELD(title, "const char*"), FIELD(model, "const char*"),
    FIELD(unit_mm, "double"), FIELD(crease_angle, "double"), FIELD(line_width, "double"),
    FIELD(hatch_spacing, "double"), FIELD(spacing, "double"), FIELD(page, "const hrbfnpr_page_desc*"),
    FIELD(tangent, "uint32_t"), FIELD(reserved, "uint32_t")};
#undef RECORD
#define RECORD hrbfnpr_views_info
inline constexpr FieldLayout fields_of_hrbfnpr_views_info[] = {
    FIELD(struct_size, "uint32_t"), FIELD(reserved, "uint32_t"), FIELD(views, "int64_t"), FIELD(bytes, "int64_t"),
    FIELD(width, "double"), FIELD(height, "double"), FIELD(scale, "double"), FIELD(unit_mm, "double"),
    FIELD(scale_text, "char[64]"), FIELD(paper, "char[64]"), FIELD(pieces, "int64_t"), FIELD(agreeing, "int64_t"),
    FIELD(undecided, "int64_t"), FIELD(repaired, "int64_t")};
#undef RECORD
#undef FIELD

// X(name) of all structs, in the header's order.
#define HRBFNPR_STRUCTS(X) \
    X(hrbfnpr_error) X(hrbfnpr_array) X(hrbfnpr_array_out) X(hrbfnpr_image) X(hrbfnpr_context_desc) \
    X(hrbfnpr_context_info) X(hrbfnpr_fit_desc) X(hrbfnpr_orient_desc) X(hrbfnpr_orient_info) \
    X(hrbfnpr_depth_image_desc) X(hrbfnpr_depth_image_info) X(hrbfnpr_custom_desc) X(hrbfnpr_model_info) \
    X(hrbfnpr_project_desc) X(hrbfnpr_projection) X(hrbfnpr_curvature) X(hrbfnpr_cast_desc) X(hrbfnpr_ray_hits) \
    X(hrbfnpr_trim_desc) X(hrbfnpr_trim_info) X(hrbfnpr_csg_node) X(hrbfnpr_csg_desc) X(hrbfnpr_csg_info) \
    X(hrbfnpr_layer_desc) X(hrbfnpr_generate_desc) X(hrbfnpr_layer_arrays) X(hrbfnpr_point_set_desc) \
    X(hrbfnpr_point_set_info) X(hrbfnpr_layer_info) X(hrbfnpr_placement_info) X(hrbfnpr_mark_field) \
    X(hrbfnpr_line_desc) X(hrbfnpr_line_set_desc) X(hrbfnpr_line_set_info) X(hrbfnpr_camera) X(hrbfnpr_light) \
    X(hrbfnpr_layer_style) X(hrbfnpr_line_style) X(hrbfnpr_style) X(hrbfnpr_dab) X(hrbfnpr_field_desc) \
    X(hrbfnpr_layer_pose) X(hrbfnpr_item) X(hrbfnpr_shading_desc) X(hrbfnpr_drawing_info) \
    X(hrbfnpr_drawing_layer_info) X(hrbfnpr_raster_desc) X(hrbfnpr_vertex_attribute) X(hrbfnpr_vertex_layout) \
    X(hrbfnpr_mark_results) X(hrbfnpr_mark_identity) X(hrbfnpr_mesh_desc) X(hrbfnpr_mesh_info) X(hrbfnpr_sample_desc) \
    X(hrbfnpr_mesh_edges_desc) X(hrbfnpr_mesh_edges_info) X(hrbfnpr_compare_desc) X(hrbfnpr_comparison) \
    X(hrbfnpr_mesh_fit_desc) X(hrbfnpr_mesh_fit_info) X(hrbfnpr_page_item) X(hrbfnpr_pen) X(hrbfnpr_annotation) \
    X(hrbfnpr_page_desc) X(hrbfnpr_page_info) X(hrbfnpr_source_field) X(hrbfnpr_picture_source) X(hrbfnpr_change) \
    X(hrbfnpr_note) X(hrbfnpr_picture_event) X(hrbfnpr_picture_desc) X(hrbfnpr_source_info) X(hrbfnpr_picture_info) \
    X(hrbfnpr_picture_part) X(hrbfnpr_picture_page_desc) X(hrbfnpr_views_desc) X(hrbfnpr_views_info)

} // namespace hrbfnpr::api
