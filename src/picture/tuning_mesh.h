// SPDX-License-Identifier: MIT
// Constants of the steps that turn a mesh into surfaces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// Inspection, division and fit of a mesh. Tuned on figures, machine parts and balls of 80 to 300 000 faces.
struct MeshTuning {
    // The number of samples that show which way a mesh faces, and which direction is up. Larger: more reliable, in more
    // time.
    std::int64_t looked_at = 2000;
    // The number of samples, if neither the fit nor the options choose a number. Larger: finer surfaces, in more time.
    std::int64_t samples = 1000;
    // The largest number of samples of a mesh, as in hrbfnpr_mesh_sample.
    std::int64_t most_samples = 10'000'000;
    // Faces that meet at more than this angle, in degrees, do not share normals, unless the options give an angle.
    // Larger: normals of samples near edges lean towards the other face.
    double crease_angle = 60.0;

    // A divided mesh is judged by this percentile of its heights above the given faces. Larger: a single fold counts.
    double raised_percentile = 99.0;
    // The tolerance, in diagonals, of a rough fit that shows whether a coarse mesh has edges. Larger: more of its faces
    // may be round.
    double rough_tolerance = 0.1;

    // A note names the edges that stay smooth if their total length is above this, in diagonals. Larger: fewer notes.
    double told_smooth_length = 0.01;
    // If less than this share of a mesh is within the tolerance, its faces are too coarse; otherwise only a few edges
    // are the reason. Larger: more meshes are called coarse.
    double mostly_reached = 0.9;
    // A fit that misses its tolerance needs more centres if it used more than this share of the limit. Larger: more
    // centres are proposed less often.
    double nearly_all_centres = 0.9;
    // The largest number of centres of a fit, and of each sheet of a fit with sharp edges, as in
    // hrbfnpr_model_fit_mesh.
    std::int64_t most_centres = 8000;
    std::int64_t centres_a_sheet = 32;

    // The number of places that show where a mesh ends, about 0.005 diagonals apart, and of the random candidates for
    // them. Three times as many candidates as places leave no gaps. Larger: the end is more exact, in more time.
    std::int64_t end_places = 60'000;
    std::int64_t end_candidates = 180'000;
    // A warning comes if more than this share of a closed surface is removed. Larger: fewer warnings.
    double doubted_share = 0.002;
    // The warning proposes this many times the present number of samples.
    std::int64_t more_samples = 4;
};
inline constexpr MeshTuning mesh_tuning;

// Open meshes with parts that need separate surfaces, tiny parts far away ("lost parts"), and leftover faces.
struct ApartTuning {
    // Parts closer than this, in diagonals, cannot be fitted together. Larger: more groups.
    double near = 0.02;
    // Borders closer than this, in diagonals, may be a single edge that the file stores twice. Larger: fewer groups.
    double seam = 0.002;
    // Two borders are one edge if at least this share of one of them is closer than `seam` to the other. Larger: more
    // groups.
    double seam_share = 0.2;
    // Two borders are one edge only if the cosine between the normals of the faces beside them exceeds this in
    // magnitude. Larger: more groups.
    double seam_cosine = 0.7;
    // About this many places are spread over all parts. Larger: fewer contacts are missed, in more time.
    double places = 40'000.0;
    // A mesh with more parts than this is one group, because time and memory grow with the square of the number of
    // parts.
    std::int64_t most_parts = 500;
    // The largest number of groups. All parts that do not fit into the other groups share the last one. Larger: more
    // fits.
    std::int64_t most_groups = 8;
};
inline constexpr ApartTuning apart_tuning;

// Division of meshes that approximate a round shape.
struct SubdivideTuning {
    // The largest number of faces after the last round. Larger: some more gigabytes of memory.
    std::int64_t most_faces = 4'000'000;
    std::int32_t most_rounds = 6;
    // The number of corrections that make the surface pass through the vertices. Plain subdivision moves the vertices.
    // After four corrections, a hundredth of their distance from the given places is left. Larger: nearer, in more
    // time.
    std::int32_t corrections = 4;
    // A vertex does not move if a border or crease turns there by more than this, in degrees. Larger: rounder corners.
    double corner_angle = 60.0;
    // A bevel has at most this share of the area of the flat face that it borders. Larger: more faces are bevels.
    double narrow = 0.25;
    // The edges of a bevel bend by at least this, in degrees. Larger: fewer faces are bevels.
    double bevel_angle = 15.0;
    // Triangles that meet at less than this angle, in degrees, belong to one flat face. Larger: larger flat faces.
    double flat_angle = 2.0;
    // The coarseness of a mesh is this percentile of its edges' bulges. Larger: a few long faces make it coarse.
    double coarse_percentile = 90.0;
};
inline constexpr SubdivideTuning subdivide_tuning;

// Edges that the normals of a file mark as sharp.
struct SharpEdgesTuning {
    // Two triangles that meet at less than this angle, in degrees, belong to one flat polygon. Larger: fewer edges
    // count.
    double bend_angle = 2.0;
};
inline constexpr SharpEdgesTuning sharp_edges_tuning;

} // namespace hrbfnpr::picture
