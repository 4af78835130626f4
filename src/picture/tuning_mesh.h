// SPDX-License-Identifier: MIT
// Constants of the steps that turn a mesh into surfaces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// Inspection, division and fit of a mesh. Tuned on figures, machine parts and balls of 80 to 300 000 faces.
struct MeshTuning {
    // The number of samples that decide which way a mesh faces and which direction is up. Larger: more reliable, in
    // more time.
    std::int64_t looked_at = 2000;
    // The number of samples if neither the fit nor the options choose it. Larger: finer surfaces, in more time.
    std::int64_t samples = 1000;
    // A mesh has at most this many samples, as in hrbfnpr_mesh_sample.
    std::int64_t most_samples = 10'000'000;
    // Faces that meet at a larger angle, in degrees, do not share normals, unless the options set the angle. Larger:
    // normals of samples beside edges lean towards the other face.
    double crease_angle = 60.0;

    // The heights of a divided mesh above the given faces are judged at this percentile. Larger: a single fold counts.
    double raised_percentile = 99.0;
    // A rough fit with this tolerance, in diagonals, shows whether a coarse mesh has edges. Larger: more of its faces
    // may be round.
    double rough_tolerance = 0.1;

    // Edges that stay smooth get a note if their length exceeds this, in diagonals. Larger: fewer notes.
    double told_smooth_length = 0.01;
    // If less than this share of a mesh is within the tolerance, the reason is coarse faces, not a few edges. Larger:
    // more meshes are called coarse.
    double mostly_reached = 0.9;
    // A fit that misses its tolerance had too few centres if it used more than this share of the limit. Larger: more
    // centres are proposed less often.
    double nearly_all_centres = 0.9;
    // The limits for the number of centres of a fit, and of each sheet of a fit with sharp edges, as in
    // hrbfnpr_model_fit_mesh.
    std::int64_t most_centres = 8000;
    std::int64_t centres_a_sheet = 32;

    // The number of places that show where a mesh ends, and of the random candidates for them. Three times as many
    // candidates leave no gaps. The places are about 0.005 diagonals apart. Larger: the end is more exact, in more
    // time.
    std::int64_t end_places = 60'000;
    std::int64_t end_candidates = 180'000;
    // A warning comes if more than this share of a closed surface is removed. Larger: fewer warnings.
    double doubted_share = 0.002;
    // The warning proposes this many times the samples.
    std::int64_t more_samples = 4;
};
inline constexpr MeshTuning mesh_tuning;

// Parts of an open mesh that are separate surfaces, tiny parts far away ("lost parts"), and leftover faces.
struct ApartTuning {
    // Parts nearer than this, in diagonals, disturb each other. Larger: more groups.
    double near = 0.02;
    // Borders nearer than this, in diagonals, may be a single edge that the file has twice. Larger: fewer groups.
    double seam = 0.002;
    // Two borders are one edge if at least this share of either border is nearer than `seam` to the other. Larger: more
    // groups.
    double seam_share = 0.2;
    // Two borders are one edge only if the cosine between the normals of the faces beside them exceeds this in
    // magnitude. Larger: more groups.
    double seam_cosine = 0.7;
    // About this many places are spread over all parts. Larger: no contact is missed, in more time.
    double places = 40'000.0;
    // A mesh with more parts is one group. Time and memory grow with the square of it.
    std::int64_t most_parts = 500;
    // The limit of the groups. Parts beyond the first ones share the last. Larger: more fits.
    std::int64_t most_groups = 8;
};
inline constexpr ApartTuning apart_tuning;

// Division of meshes that approximate a round shape.
struct SubdivideTuning {
    // The limit of faces after the last round. Larger: some gigabytes of memory more.
    std::int64_t most_faces = 4'000'000;
    std::int32_t most_rounds = 6;
    // The number of corrections that make the surface go through the vertices. After four it misses them by a hundredth
    // of the distance that plain subdivision moves them. Larger: nearer, in more time.
    std::int32_t corrections = 4;
    // A vertex stays where a border or crease turns by more than this, in degrees. Larger: rounder corners.
    double corner_angle = 60.0;
    // A bevel has at most this share of the area of the flat face beside it. Larger: more faces are bevels.
    double narrow = 0.25;
    // The edges of a bevel bend by at least this, in degrees. Larger: fewer faces are bevels.
    double bevel_angle = 15.0;
    // Triangles that bend by less than this to each other, in degrees, are one flat face. Larger: larger flat faces.
    double flat_angle = 2.0;
    // This percentile of the edges defines how coarse a mesh is. Larger: a few long faces make it coarse.
    double coarse_percentile = 90.0;
};
inline constexpr SubdivideTuning subdivide_tuning;

// Edges that the normals of a file mark as sharp.
struct SharpEdgesTuning {
    // Faces that bend by less than this, in degrees, are one face, like the triangles of a polygon. Larger: fewer edges
    // count.
    double bend_angle = 2.0;
};
inline constexpr SharpEdgesTuning sharp_edges_tuning;

} // namespace hrbfnpr::picture
