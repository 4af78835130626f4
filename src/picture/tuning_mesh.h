// SPDX-License-Identifier: MIT
// Constants of the steps that turn a mesh into surfaces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// How a mesh is looked at, divided and fitted.  Set on figures, machine parts and balls of 80 to 300 000 faces.
struct MeshTuning {
    // Samples that tell which way a mesh looks and which direction is up.  Larger: surer, in more time.
    std::int64_t looked_at = 2000;
    // Samples where the fit does not choose them and the options set no number.  Larger: finer surfaces, in more time.
    std::int64_t samples = 1000;
    // The most samples of a mesh, as hrbfnpr_mesh_sample has it.
    std::int64_t most_samples = 10'000'000;
    // Degrees: faces that meet at a sharper angle do not share normals, unless the options say so.  Larger: samples
    // beside edges lean towards these.
    double crease_angle = 60.0;
    // Degrees by which faces bend that are meant to be flat; their edges are sharp then.  Larger: fewer of them are.
    double flat_bend = 5.0;

    // Diagonals: the tolerance of a fit, as hrbfnpr_model_fit_mesh has it.  Larger: coarser surfaces in less time.
    double tolerance = 0.002;
    // Faces of a mesh that may be divided, at most.  Larger: finer meshes are looked at, in more time.
    std::size_t most_coarse = 50'000;
    // Diagonals: a mesh whose edges are shorter on average bends by noise, and is not divided.  Larger: fewer are.
    double coarse_edge = 0.025;
    // Rounds of subdivision, at most.  Larger by 1: four times as many faces.
    std::int32_t most_rounds = 3;
    // A factor of how far the faces bulge: if vertices move farther than that, nothing round goes through them. Figures
    // and rings have 1.2 at most.  Larger: more meshes with long faces are divided.
    double most_moved = 1.5;
    // The same for places between the vertices: 1.8 for a ball of 156 faces, 2.7 at most for figures.
    double most_raised = 3.0;
    // The percentile of these places that is compared.  Larger: a single fold counts.
    double raised_percentile = 99.0;
    // Diagonals: the tolerance with which a coarse mesh is asked whether it has edges.  Larger: more of its faces may
    // be round.
    double rough_tolerance = 0.1;

    // Diagonals: longer edges that stay smooth get a note.  Larger: fewer notes.
    double told_smooth_length = 0.01;
    // The share of a mesh within the tolerance.  If it is less, coarse faces are the reason, and not a few edges.
    // Larger: more meshes are called coarse.
    double mostly_reached = 0.9;
    // The share of the most centres from which on a fit that falls short had too few.  Larger: more centres are
    // proposed less often.
    double nearly_all_centres = 0.9;
    // Centres that a fit may have, and those for each sheet of one with sharp edges, as hrbfnpr_model_fit_mesh has it.
    std::int64_t most_centres = 8000;
    std::int64_t centres_a_sheet = 32;

    // Places on a mesh that show where it ends, and random ones that they are chosen from: three times as many leave no
    // gaps.  They are some 0.005 diagonals from each other.  Larger: the end is more exact, in more time.
    std::int64_t end_places = 60'000;
    std::int64_t end_candidates = 180'000;
    // Diagonals: surface that is farther than this from a mesh is none of it; the least and the most.  Larger: more of
    // the surface that a fit invents stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // A factor between these two limits: of the distance of 99 % of the mesh from the surface, or of the spacing of the
    // samples, since they round edges off by that.  Larger: as above.
    double off_factor = 1.5;
    // The share of a closed surface that is left out and warned of.  Larger: fewer warnings.
    double doubted_share = 0.002;
    // The factor of the samples that is proposed then.
    std::int64_t more_samples = 4;
};
inline constexpr MeshTuning mesh_tuning;

// Parts of an open mesh that are surfaces of their own, parts that are lost, and faces that are left over.
struct ApartTuning {
    // Diagonals: parts that are nearer than this disturb each other.  Larger: more groups.
    double near = 0.02;
    // Diagonals: borders that are nearer than this may be one edge that the file has twice.  Larger: fewer groups.
    double seam = 0.002;
    // The share of the border of either part along which that has to be so.  Larger: more groups.
    double seam_share = 0.2;
    // The cosine between the normals of the faces there, at least.  Larger: more groups.
    double seam_cosine = 0.7;
    // Places on all parts, about.  Larger: no contact is missed, in more time.
    double places = 40'000.0;
    // Faces: larger meshes are one group; the first holds for those that hang together by their vertices.  Larger: more
    // meshes are grouped, in more time.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;
    // A mesh of more parts is one group.  Larger: time and memory with the square of it.
    std::int64_t most_parts = 500;
    // Groups, at most: parts that find no place in the first ones share the last.  Larger: more fits.
    std::int64_t most_groups = 8;
    // Faces, at most, and the share of all area, at most, of parts that are too little for a surface of their own.
    // Larger: more faces are left out where three meet in an edge.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;

    // The share of the area of all lost parts together, at most.  Larger: more parts are lost.
    double lost_area = 0.001;
    // The size of all other parts times this, less one, is the distance from which on parts are lost.  Larger: fewer
    // are.
    double lost_distance = 4.0;
};
inline constexpr ApartTuning apart_tuning;

// Meshes that are divided towards something round.
struct SubdivideTuning {
    // Faces after the last round, at most.  Larger: some gigabytes of memory more.
    std::int64_t most_faces = 4'000'000;
    // Rounds, at most.
    std::int32_t most_rounds = 6;
    // How often vertices are corrected so that the surface goes through them.  After four it passes them by a hundredth
    // of the way that plain subdivision moves them.  Larger: nearer, in more time.
    std::int32_t corrections = 4;
    // Degrees: a vertex stays where a border or crease turns by more.  Larger: rounder corners.
    double corner_angle = 60.0;
    // The share of the area of a flat face that a bevel beside it has at most.  Larger: more faces are bevels.
    double narrow = 0.25;
    // Degrees by which the edges of bevels bend at least.  Larger: fewer faces are bevels.
    double bevel_angle = 15.0;
    // Degrees: triangles that bend by less to each other are one flat face.  Larger: larger flat faces.
    double flat_angle = 2.0;
    // The percentile of the edges that says how coarse a mesh is.  Larger: a few long faces make it coarse.
    double coarse_percentile = 90.0;
};
inline constexpr SubdivideTuning subdivide_tuning;

// Edges that are sharp by the normals of a file.
struct SharpEdgesTuning {
    // Degrees: faces that bend by less are one, as the triangles of a polygon.  Larger: fewer edges are asked.
    double bend_angle = 2.0;
    // Fewer edges than this say nothing.
    std::int64_t fewest = 8;
    // The share of the edges from which on all are sharp; up to the rest of 1 none is.  Larger: more files say that
    // some are.
    double nearly_all = 0.98;
};
inline constexpr SharpEdgesTuning sharp_edges_tuning;

} // namespace hrbfnpr::picture
