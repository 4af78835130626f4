// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
#pragma once
// clang-format off

#include "picture/field_table.h"

#include <cstddef>

namespace hrbfnpr::picture {

#define FIELD(field, scalar, meaning, count, first_choice, choices) \
    {#field, offsetof(RECORD, field), Scalar::scalar, Meaning::meaning, count, first_choice, choices}

inline constexpr NamedConstant named_constants[] = {
    {"none", 0}, {"light", 1}, {"share", 0}, {"published", 1}, {"coverage", 0}, {"linear", 1}, {"world", 0},
    {"camera", 1}, {"item", 2}, {"depth_layers", 0}, {"published", 1}, {"attenuate", 0}, {"hide", 1}, {"show", 2},
    {"picture", 0}, {"surface", 1}, {"any", 0}, {"stipples", 1}, {"hatch", 2}, {"own", 3}, {"first", 1}, {"second", 2},
    {"dots", 0}, {"strokes", 1}, {"hatch", 2}, {"replace", 0}, {"scale", 1}, {"nearest", 0}, {"mixed", 1},
    {"contour", 1}, {"suggestive_contour", 2}, {"ridge", 3}, {"valley", 4}, {"apparent_ridge", 5}, {"parabolic", 6},
    {"isophote", 7}, {"section", 8}, {"border", 9}, {"own", 10}, {"crease", 11}, {"shadow", 12}, {"terminator", 13},
    {"soft_edge", 14}, {"intersection", 15}, {"tangent_edge", 16}, {"none", 0}, {"attenuated", 1}, {"dashed", 2},
    {"shown", 3}, {"round", 0}, {"flat", 1}, {"pointed", 2}, {"all", 0}, {"convex", 1}, {"concave", 2},
    {"triharmonic", 0}, {"gaussian", 1}, {"wendland_c2", 2}, {"given", 0}, {"auto", 1}, {"keep", 0}, {"drop", 1},
    {"keep", 0}, {"drop", 1}, {"reorient", 2}, {"auto", 0}, {"direct", 1}, {"iterative", 2}, {"given", 0}, {"none", 1},
    {"unoriented", 2}, {"mixed", 3}, {"inward", 4}, {"auto", 5}, {"never", 0}, {"auto", 1}, {"auto", 0}, {"smooth", 1},
    {"sharp", 2}, {"blue_noise", 0}, {"published", 1}, {"full", 0}, {"in_turn", 1}, {"auto", 0}, {"samples", 1},
    {"box", 2}, {"points", 3}, {"stipples", 1}, {"hatch", 2}, {"curvature", 1}, {"uniform", 0}, {"curvature", 1},
    {"curvature", 0}, {"combing", 1}, {"sections", 2}, {"light", 3}, {"silhouette", 4}, {"seeds", 0}, {"stipples", 1},
    {"ridge", 3}, {"valley", 4}, {"parabolic", 6}, {"section", 8}, {"soft_edge", 14}, {"tangent_edge", 16}, {"svg", 0},
    {"pdf", 1}, {"hpgl", 2}, {"gcode", 3}, {"dxf", 4}, {"in_plot_order", 1}, {"single_pass", 4}, {"without_paper", 2},
    {"outlines", 0}, {"classes", 1}, {"circles", 0}, {"lines", 1}, {"spirals", 2}, {"arcs", 0}, {"splines", 1},
    {"lines", 2}, {"with_lines", 1}, {"directional", 0}, {"place", 1}};

#define RECORD hrbfnpr_style
inline constexpr NamedField names_of_hrbfnpr_style[] = {
    FIELD(tone, uint32, choice, 1, 0, 2), FIELD(paper, float32, colour, 4, 0, 0),
    FIELD(tone_rule, uint32, choice, 1, 2, 2), FIELD(tone_curve, uint32, choice, 1, 4, 2),
    FIELD(light, float64, direction, 3, 0, 0), FIELD(tone_exponent, float64, number, 1, 0, 0),
    FIELD(light_space, uint32, choice, 1, 6, 3), FIELD(tone_fade, float32, number, 1, 0, 0),
    FIELD(silhouette_threshold, float64, number, 1, 0, 0), FIELD(silhouette_radius, float32, number, 1, 0, 0),
    FIELD(silhouette_radius_zoom, float32, number, 1, 0, 0), FIELD(silhouette_ink, float32, colour, 4, 0, 0),
    FIELD(visibility, uint32, choice, 1, 9, 2), FIELD(hidden_lines, uint32, choice, 1, 11, 3),
    FIELD(attenuation_front, float64, number, 1, 0, 0), FIELD(attenuation_back, float64, number, 1, 0, 0),
    FIELD(splat_radius, float32, number, 1, 0, 0), FIELD(splat_overlap, float32, number, 1, 0, 0),
    FIELD(halo_width, float32, number, 1, 0, 0), FIELD(verify_lines, uint32, yes_no, 1, 0, 0),
    FIELD(depth_min, float64, number, 1, 0, 0), FIELD(depth_max, float64, number, 1, 0, 0),
    FIELD(zoom_reference, float64, number, 1, 0, 0), FIELD(zoom_exponent, float64, number, 1, 0, 0),
    FIELD(fill_light, float32, number, 1, 0, 0), FIELD(light_intensity, float32, number, 1, 0, 0),
    FIELD(light_shadow, float32, number, 1, 0, 0), FIELD(light_softness, float32, number, 1, 0, 0),
    FIELD(evenness, uint32, choice, 1, 14, 2), FIELD(ambient_up, float64, direction, 3, 0, 0),
    FIELD(ambient_sky, float32, number, 1, 0, 0), FIELD(ambient_ground, float32, number, 1, 0, 0),
    FIELD(occlusion, float32, number, 1, 0, 0), FIELD(occlusion_exponent, float32, number, 1, 0, 0),
    FIELD(rim_light, float32, number, 1, 0, 0), FIELD(rim_exponent, float32, number, 1, 0, 0),
    FIELD(tone_black, float32, number, 1, 0, 0), FIELD(tone_white, float32, number, 1, 0, 0),
    FIELD(tone_gamma, float32, number, 1, 0, 0), FIELD(tone_steps, uint32, number, 1, 0, 0),
    FIELD(curvature_contrast, float32, number, 1, 0, 0), FIELD(occlusion_lights, float32, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_layer_style
inline constexpr NamedField names_of_hrbfnpr_layer_style[] = {
    FIELD(kind, uint32, choice, 1, 16, 4), FIELD(name, text, text, 1, 0, 0), FIELD(shown, uint32, yes_no, 1, 0, 0),
    FIELD(contours, uint32, yes_no, 1, 0, 0), FIELD(directions, uint32, bits, 1, 20, 2),
    FIELD(shape, uint32, choice, 1, 22, 3), FIELD(share, float32, number, 1, 0, 0),
    FIELD(radius, float32, number, 1, 0, 0), FIELD(radius_zoom, float32, number, 1, 0, 0),
    FIELD(ink, float32, colour, 4, 0, 0), FIELD(hatch_tone_begin, float32, number, 1, 0, 0),
    FIELD(hatch_tone_end, float32, number, 1, 0, 0), FIELD(hatch_coverage_begin, float32, number, 1, 0, 0),
    FIELD(hatch_coverage_end, float32, number, 1, 0, 0), FIELD(hatch_spacing, float32, number, 1, 0, 0),
    FIELD(hatch_pen, float32, number, 1, 0, 0), FIELD(hatch_white, float32, number, 1, 0, 0),
    FIELD(hatch_taper, float32, number, 1, 0, 0), FIELD(hatch_shortest, float32, number, 1, 0, 0),
    FIELD(hatch_wobble, float32, number, 1, 0, 0), FIELD(hatch_overshoot, float32, number, 1, 0, 0),
    FIELD(hatch_seed, uint32, number, 1, 0, 0), FIELD(density_field, text, text, 1, 0, 0),
    FIELD(tone_field, text, text, 1, 0, 0), FIELD(width_field, text, text, 1, 0, 0),
    FIELD(ink_field, text, text, 1, 0, 0), FIELD(mask_field, text, text, 1, 0, 0),
    FIELD(tone_field_rule, uint32, choice, 1, 25, 2), FIELD(palette_rule, uint32, choice, 1, 27, 2),
    FIELD(hatch_fade, float32, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_line_style
inline constexpr NamedField names_of_hrbfnpr_line_style[] = {
    FIELD(kind, uint32, choice, 1, 29, 16), FIELD(name, text, text, 1, 0, 0), FIELD(hidden, uint32, choice, 1, 45, 4),
    FIELD(cap, uint32, choice, 1, 49, 3), FIELD(width, float32, number, 1, 0, 0),
    FIELD(taper, float32, number, 1, 0, 0), FIELD(hidden_width, float32, number, 1, 0, 0),
    FIELD(hidden_opacity, float32, number, 1, 0, 0), FIELD(dash, float32, number, 1, 0, 0),
    FIELD(gap, float32, number, 1, 0, 0), FIELD(shortest, float32, number, 1, 0, 0),
    FIELD(fade, float32, number, 1, 0, 0), FIELD(lower, float64, number, 1, 0, 0),
    FIELD(upper, float64, number, 1, 0, 0), FIELD(ink, float32, colour, 4, 0, 0),
    FIELD(outline_factor, float32, number, 1, 0, 0), FIELD(far_factor, float32, number, 1, 0, 0),
    FIELD(lit_factor, float32, number, 1, 0, 0), FIELD(curvature_factor, float32, number, 1, 0, 0),
    FIELD(curvature_radius, float32, number, 1, 0, 0), FIELD(wobble, float32, number, 1, 0, 0),
    FIELD(wobble_width, float32, number, 1, 0, 0), FIELD(wobble_length, float32, number, 1, 0, 0),
    FIELD(wobble_seed, uint32, number, 1, 0, 0), FIELD(creases, uint32, choice, 1, 52, 3)};
#undef RECORD
#define RECORD hrbfnpr_fit_desc
inline constexpr NamedField names_of_hrbfnpr_fit_desc[] = {
    FIELD(kernel, uint32, choice, 1, 55, 3), FIELD(kernel_radius, float64, number, 1, 0, 0),
    FIELD(polynomial_degree, int32, number, 1, 0, 0), FIELD(regularization_mode, uint32, choice, 1, 58, 2),
    FIELD(regularization, float64, number, 1, 0, 0), FIELD(outliers, uint32, choice, 1, 60, 2),
    FIELD(flipped_normals, uint32, choice, 1, 62, 3), FIELD(tolerance, float64, number, 1, 0, 0),
    FIELD(maximum_centres, int64, number, 1, 0, 0), FIELD(solver, uint32, choice, 1, 65, 3),
    FIELD(refinement_steps, int32, number, 1, 0, 0), FIELD(solver_tolerance, float64, number, 1, 0, 0),
    FIELD(iteration_limit, int32, number, 1, 0, 0), FIELD(preconditioner_neighbours, uint32, number, 1, 0, 0),
    FIELD(normal_mode, uint32, choice, 1, 68, 6), FIELD(trim, uint32, choice, 1, 74, 2)};
#undef RECORD
#define RECORD hrbfnpr_mesh_fit_desc
inline constexpr NamedField names_of_hrbfnpr_mesh_fit_desc[] = {
    FIELD(tolerance, float64, number, 1, 0, 0), FIELD(share, float64, number, 1, 0, 0),
    FIELD(far, float64, number, 1, 0, 0), FIELD(maximum_centres, int64, number, 1, 0, 0),
    FIELD(candidates, int64, number, 1, 0, 0), FIELD(random_seed, uint64, number, 1, 0, 0),
    FIELD(crease_angle, float64, number, 1, 0, 0), FIELD(edges, uint32, choice, 1, 76, 3)};
#undef RECORD
#define RECORD hrbfnpr_generate_desc
inline constexpr NamedField names_of_hrbfnpr_generate_desc[] = {
    FIELD(distribution, uint32, choice, 1, 79, 2), FIELD(shared_budget, int64, number, 1, 0, 0),
    FIELD(tone_ranges, uint32, choice, 1, 81, 2), FIELD(seed_source, uint32, choice, 1, 83, 4),
    FIELD(box_jitter, float64, number, 1, 0, 0), FIELD(box_resolution, uint32, number, 1, 0, 0),
    FIELD(initial_step, float64, number, 1, 0, 0), FIELD(projection_tolerance, float64, number, 1, 0, 0),
    FIELD(random_seed, uint64, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_layer_desc
inline constexpr NamedField names_of_hrbfnpr_layer_desc[] = {
    FIELD(kind, uint32, choice, 1, 87, 2), FIELD(name, text, text, 1, 0, 0), FIELD(budget, int64, number, 1, 0, 0),
    FIELD(tone_begin, float32, number, 1, 0, 0), FIELD(tone_end, float32, number, 1, 0, 0),
    FIELD(second_tone_begin, float32, number, 1, 0, 0), FIELD(second_tone_end, float32, number, 1, 0, 0),
    FIELD(flags, uint32, bits, 1, 89, 1), FIELD(density, uint32, choice, 1, 90, 2),
    FIELD(density_strength, float64, number, 1, 0, 0), FIELD(guide, uint32, choice, 1, 92, 5),
    FIELD(start, uint32, choice, 1, 97, 2), FIELD(start_level, int32, number, 1, 0, 0),
    FIELD(levels, int32, number, 1, 0, 0), FIELD(separation, float64, number, 1, 0, 0),
    FIELD(step, float64, number, 1, 0, 0), FIELD(angle, float64, number, 1, 0, 0),
    FIELD(smoothing, float64, number, 1, 0, 0), FIELD(axis, float64, direction, 3, 0, 0),
    FIELD(axis_weight, float64, number, 1, 0, 0), FIELD(guide_direction, float64, direction, 3, 0, 0),
    FIELD(guide_weight, float64, number, 1, 0, 0), FIELD(tone_smoothing, float64, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_line_set_desc
inline constexpr NamedField names_of_hrbfnpr_line_set_desc[] = {
    FIELD(flags, uint32, bits, 1, 89, 1), FIELD(cell_size, float64, number, 1, 0, 0),
    FIELD(support, float64, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_line_desc
inline constexpr NamedField names_of_hrbfnpr_line_desc[] = {
    FIELD(kind, uint32, choice, 1, 99, 6), FIELD(name, text, text, 1, 0, 0), FIELD(lower, float64, number, 1, 0, 0),
    FIELD(upper, float64, number, 1, 0, 0), FIELD(shortest, float64, number, 1, 0, 0),
    FIELD(plane, float64, direction, 3, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_page_desc
inline constexpr NamedField names_of_hrbfnpr_page_desc[] = {
    FIELD(format, uint32, choice, 1, 105, 5), FIELD(flags, uint32, bits, 1, 110, 3),
    FIELD(widths, uint32, choice, 1, 113, 2), FIELD(dots, uint32, choice, 1, 115, 3),
    FIELD(curves, uint32, choice, 1, 118, 3), FIELD(width, float64, number, 1, 0, 0),
    FIELD(height, float64, number, 1, 0, 0), FIELD(tolerance, float64, number, 1, 0, 0),
    FIELD(width_step, float64, number, 1, 0, 0), FIELD(join, float64, number, 1, 0, 0),
    FIELD(shortest, float64, number, 1, 0, 0), FIELD(dot_distance, float64, number, 1, 0, 0),
    FIELD(draw_speed, float64, number, 1, 0, 0), FIELD(travel_speed, float64, number, 1, 0, 0),
    FIELD(pen_seconds, float64, number, 1, 0, 0), FIELD(pen_down, text, text, 1, 0, 0),
    FIELD(pen_up, text, text, 1, 0, 0), FIELD(title, text, text, 1, 0, 0), FIELD(description, text, text, 1, 0, 0),
    FIELD(metadata, text, text, 1, 0, 0), FIELD(longest, float64, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_shading_desc
inline constexpr NamedField names_of_hrbfnpr_shading_desc[] = {
    FIELD(sky_rays, int32, number, 1, 0, 0), FIELD(shadow_rays, int32, number, 1, 0, 0),
    FIELD(flags, uint32, bits, 1, 121, 1), FIELD(occlusion_reach, float64, number, 1, 0, 0),
    FIELD(curvature_scale, float64, number, 1, 0, 0)};
#undef RECORD
#define RECORD hrbfnpr_light
inline constexpr NamedField names_of_hrbfnpr_light[] = {
    FIELD(kind, uint32, choice, 1, 122, 2), FIELD(space, uint32, choice, 1, 6, 3),
    FIELD(intensity, float32, number, 1, 0, 0), FIELD(shadow, float32, number, 1, 0, 0),
    FIELD(softness, float32, number, 1, 0, 0), FIELD(place, float64, direction, 3, 0, 0)};
#undef RECORD
#undef FIELD

// Calls X for each of these structs, with its name without hrbfnpr_.
#define HRBFNPR_NAMED_STRUCTS(X) \
    X(style) X(layer_style) X(line_style) X(fit_desc) X(mesh_fit_desc) X(generate_desc) X(layer_desc) X(line_set_desc) \
    X(line_desc) X(page_desc) X(shading_desc) X(light)

} // namespace hrbfnpr::picture
