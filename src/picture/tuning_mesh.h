// SPDX-License-Identifier: MIT
// Constants of the steps that turn a mesh into surfaces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// The story as a whole: what is looked at, divided, fitted and said.  Set on figures, machine parts and balls of 80 to
// 300 000 faces.
struct MeshTuning {
    // Samples that tell which way a mesh looks and what is up.  Larger: surer, and more time.
    std::int64_t looked_at = 2000;
    // Samples where the fit does not choose them and the options set no number.  Larger: finer surfaces, more time.
    std::int64_t samples = 1000;
    // The most samples of a mesh, as hrbfnpr_mesh_sample has it.
    std::int64_t most_samples = 10'000'000;
    // Degrees: faces that meet at a sharper angle do not share normals, unless the options say so.
    double crease_angle = 60.0;
    // Degrees by which flat faces bend to each other.  Larger: fewer edges of coarse polyhedra are sharp.
    double flat_bend = 5.0;

    // Diagonals: the tolerance of a fit, as hrbfnpr_model_fit_mesh has it.  Larger: coarser surfaces in less time.
    double tolerance = 0.002;
    // Faces of a mesh that may be coarse, at most.  Larger: finer meshes are asked, which takes time.
    std::size_t most_coarse = 50'000;
    // Diagonals: faces whose edges are shorter on average bend by noise.  Smaller: meshes with noise are divided.
    double coarse_edge = 0.025;
    // Rounds of subdivision, at most.  Each makes four times as many faces.
    std::int32_t most_rounds = 3;
    // Times how far the faces bulge: if vertices move farther, nothing round goes through them.  Figures and rings have
    // 1.2 at most.
    double most_moved = 1.5;
    // The same for places in the midst of faces: 1.8 for a ball of 156 faces, 2.7 at most for figures.
    double most_raised = 3.0;
    // The percentile of all places that this is asked of.  Larger: a single fold counts.
    double raised_percentile = 99.0;
    // The fit that would tell whether edges stand out: its tolerance in diagonals, and its centres.
    double rough_tolerance = 0.1;
    std::int64_t rough_centres = 100;

    // Diagonals: edges that stay smooth and are longer than this get a note.  Larger: fewer notes.
    double told_smooth_length = 0.01;
    // The share of a mesh within the tolerance, below which it is not for a few edges that the rest is farther.
    double mostly_reached = 0.9;
    // The share of the most centres from which on a fit that falls short had too few.
    double nearly_all_centres = 0.9;
    // Centres that a fit may have, and those for each sheet of one with sharp edges, as hrbfnpr_model_fit_mesh has it.
    std::int64_t most_centres = 8000;
    std::int64_t centres_a_sheet = 32;

    // Places on a mesh that show where it ends, chosen from three times as many: they are some 0.005 diagonals from
    // each other without gaps.  Larger: the end is more exact, in more time.
    std::int64_t end_places = 60'000;
    std::int64_t end_candidates = 180'000;
    // Diagonals: what is farther than this from a mesh is none of it; the least and the most.  Larger: more of what a
    // fit invents stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // Times the distance of 99 % of the mesh from the surface, or the spacing of the samples: rounded edges are so far.
    double off_factor = 1.5;
    // The share of a closed surface left out that is warned of.
    double doubted_share = 0.002;
    // Samples times this are proposed then.
    std::int64_t more_samples = 4;
};
inline constexpr MeshTuning mesh_tuning;

// Parts of an open mesh that are surfaces of their own, parts that are lost, and faces that are left over.
struct ApartTuning {
    // Diagonals: parts that are nearer than this disturb each other.  Larger: more groups.
    double near = 0.02;
    // Diagonals: borders that are nearer than this are one edge that the file has twice, if that is so along this share
    // of the border of either part, where the normals of their faces have this cosine at least.  Larger: fewer groups.
    double seam = 0.002;
    double seam_share = 0.2;
    double seam_cosine = 0.7;
    // Places on all parts, about.  Larger: no contact is missed, in more time.
    double places = 40'000.0;
    // Larger meshes are one group; those that hang together by their vertices, and others.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;
    // Meshes of more parts are one group.
    std::int64_t most_parts = 500;
    // Groups, at most: what finds no place in the first ones shares the last.
    std::int64_t most_groups = 8;
    // What has no more faces, and a smaller share of the area, is too little for a surface of its own.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;

    // Parts with this share of the area at most, together, are lost if they lie farther from all others than this many
    // times the size of those, less one.  Larger: more parts stay.
    double lost_area = 0.001;
    double lost_distance = 4.0;
};
inline constexpr ApartTuning apart_tuning;

// Meshes that are divided towards something round.
struct SubdivideTuning {
    // Faces after the last round, at most: these take some gigabytes.
    std::int64_t most_faces = 4'000'000;
    // Rounds, at most.
    std::int32_t most_rounds = 6;
    // How often vertices are corrected so that the surface goes through them.  What is left after four is some
    // hundredth of what plain subdivision moves them by.
    std::int32_t corrections = 4;
    // Degrees: a vertex stays where a border or crease turns by more.  Larger: rounder corners.
    double corner_angle = 60.0;
    // The share of the area of a flat face: a face beside it that has no more is a bevel.
    double narrow = 0.25;
    // Degrees by which edges of bevels bend at least.
    double bevel_angle = 15.0;
    // Degrees: triangles that bend by less to each other are one flat face.
    double flat_angle = 2.0;
    // The percentile of the edges that says how coarse a mesh is.  Larger: a few long faces make it coarse.
    double coarse_percentile = 90.0;
};
inline constexpr SubdivideTuning subdivide_tuning;

// Edges that are sharp by the normals of a file.
struct SharpEdgesTuning {
    // Degrees: faces that bend by less are one, as the triangles of a polygon.
    double bend_angle = 2.0;
    // Fewer edges that bend say nothing.
    std::int64_t fewest = 8;
    // The share of them from which on all are sharp, and below the rest of 1 none is.  Larger: fewer files tell either.
    double nearly_all = 0.98;
};
inline constexpr SharpEdgesTuning sharp_edges_tuning;

} // namespace hrbfnpr::picture
