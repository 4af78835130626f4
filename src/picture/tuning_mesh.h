// SPDX-License-Identifier: MIT
// Constants of the steps that turn a mesh into surfaces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// Inspection, division and fit of a mesh. Set on figures, machine parts and balls of 80 to 300 000 faces.
struct MeshTuning {
    // The number of samples that decide which way a mesh faces and which direction is up. Larger: surer, in more time.
    std::int64_t looked_at = 2000;
    // The number of samples if neither the fit nor the options choose it. Larger: finer surfaces, in more time.
    std::int64_t samples = 1000;
    // A mesh has at most this many samples, as in hrbfnpr_mesh_sample.
    std::int64_t most_samples = 10'000'000;
    // Faces that meet at a larger angle, in degrees, do not share normals, unless the options set the angle. Larger:
    // normals of samples beside edges lean towards the other face.
    double crease_angle = 60.0;
    // Faces that bend by this many degrees are meant to be flat, and their edges are sharp. Larger: fewer edges are
    // sharp.
    double flat_bend = 5.0;

    // The tolerance of a fit in diagonals, as in hrbfnpr_model_fit_mesh. Larger: coarser surfaces in less time.
    double tolerance = 0.002;
    // Meshes with at most this many faces may be divided. Larger: finer meshes are examined, in more time.
    std::size_t most_coarse = 50'000;
    // A mesh whose mean edge is shorter than this, in diagonals, bends by noise and is not divided. Larger: fewer
    // meshes are divided.
    double coarse_edge = 0.025;
    // The limit of subdivision rounds. Each more: four times as many faces.
    std::int32_t most_rounds = 3;
    // No round surface goes through the vertices if they move by more than this factor times the bulge of the faces.
    // The factor of figures and rings is 1.2 at most. Larger: more meshes with long faces are divided.
    double most_moved = 1.5;
    // The same factor for places between the vertices: it is 1.8 for a ball of 156 faces, and 2.7 at most for figures.
    double most_raised = 3.0;
    // The places are compared at this percentile. Larger: a single fold counts.
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
    // The limits of the centres of a fit, and of those for each sheet of a fit with sharp edges, as in
    // hrbfnpr_model_fit_mesh.
    std::int64_t most_centres = 8000;
    std::int64_t centres_a_sheet = 32;

    // The number of places that show where a mesh ends, and of the random candidates for them. Three times as many
    // candidates leave no gaps. The places are about 0.005 diagonals apart. Larger: the end is more exact, in more
    // time.
    std::int64_t end_places = 60'000;
    std::int64_t end_candidates = 180'000;
    // Surface farther from a mesh than a limit between these two, in diagonals, does not belong to it. Larger: more of
    // the surface that a fit invents stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // Between these bounds, the limit is this factor times the 99th percentile of the mesh's distances from the
    // surface, or times the spacing of the samples, by which they round edges off. Larger: as above.
    double off_factor = 1.5;
    // A warning comes if more than this share of a closed surface is removed. Larger: fewer warnings.
    double doubted_share = 0.002;
    // The warning proposes this many times the samples.
    std::int64_t more_samples = 4;
};
inline constexpr MeshTuning mesh_tuning;

// Parts of an open mesh that are surfaces of their own, lost parts, and leftover faces.
struct ApartTuning {
    // Parts nearer than this, in diagonals, disturb each other. Larger: more groups.
    double near = 0.02;
    // Borders nearer than this, in diagonals, may be a single edge that the file has twice. Larger: fewer groups.
    double seam = 0.002;
    // They are one edge if this share of the border of either part is that near. Larger: more groups.
    double seam_share = 0.2;
    // The cosine between the normals of the faces there is at least this. Larger: more groups.
    double seam_cosine = 0.7;
    // About this many places are spread over all parts. Larger: no contact is missed, in more time.
    double places = 40'000.0;
    // Meshes with more faces are one group; the first limit is for parts connected by vertices. Larger: more meshes are
    // grouped, in more time.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;
    // A mesh with more parts is one group. Time and memory grow with the square of it.
    std::int64_t most_parts = 500;
    // The limit of the groups. Parts beyond the first ones share the last. Larger: more fits.
    std::int64_t most_groups = 8;
    // Parts with at most this many faces, and this share of the total area, are too small for a surface of their own.
    // Larger: more faces are removed where three meet in an edge.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;

    // All lost parts together have at most this share of the area. Larger: more parts are lost.
    double lost_area = 0.001;
    // Parts are lost beyond a distance of (this - 1) times the size of all other parts. Larger: fewer parts are lost.
    double lost_distance = 4.0;
};
inline constexpr ApartTuning apart_tuning;

// Division of meshes that stand for a round shape.
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
    // The normals say nothing if there are fewer edges.
    std::int64_t fewest = 8;
    // All edges are sharp if at least this share is, and none is if at most 1 minus this share is. Larger: more files
    // have some sharp edges.
    double nearly_all = 0.98;
};
inline constexpr SharpEdgesTuning sharp_edges_tuning;

} // namespace hrbfnpr::picture
