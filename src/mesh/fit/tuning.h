// SPDX-License-Identifier: MIT
// The tuning constants of comparing a surface with a mesh, and of what a fit asks of a mesh. A diagonal is that of the
// mesh's bounds. Set on the meshes of tests/mesh and on fitted scans.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct MeshFitTuning {
    // ---- The inside of a mesh

    // A side is sure if at most this many of sixteen rays disagree. Larger: places near holes are taken for inside or
    // outside more often.
    int dissenters = 2;
    // The side of a face is asked at this distance from it, in diagonals. Larger: thin parts are missed.
    double beside_face = 1e-4;

    // ---- Parts that touch

    // An edge goes through at most this many faces of its own part before one of another. Larger: slower on folded
    // meshes.
    int most_own = 8;
    // The normals of parts that are near and do not cross have at least this cosine, or the opposite. Larger: fewer
    // parts touch.
    double least_alike = 0.9;

    // ---- Flat meshes

    // A mesh is flat if its corners are at most this far from the plane of its largest face, in diagonals.
    double flatness = 1e-6;
    // A flat mesh has no inside if more than this share of its area looks the other way.
    double other_way = 0.01;

    // ---- The surface beside a mesh

    // The surface is looked for from this many places along each axis of the box, too. Larger: slower, fewer small
    // parts are missed.
    std::int64_t lattice = 16;
    // Places go to the surface in at most this many evaluations, places of the mesh in the second number.
    int place_evaluations = 12;
    int mesh_evaluations = 20;
    // Places are on the surface to this, in diagonals, and those that lead to it to the second number.
    double on_surface = 1e-6;
    double on_surface_of_seeds = 1e-4;
    // Cells are halved where more than this share of the triangles looks away from the surface, which is more than
    // sharp edges make. Larger: thin walls are missed.
    double turned_share = 1e-2;
    // Meshes are not made finer beyond this many triangles.
    std::int64_t most_triangles = 1'200'000;
    // Where cells show no surface at all they are halved up to this many along a diagonal.
    double most_cells = 1024.0;
    // A surface with fewer triangles is looked at again in cells half as wide if its parts are not those of the mesh.
    std::int64_t most_to_look_closer = 400'000;
};
inline constexpr MeshFitTuning mesh_fit_tuning;

// A smooth fit to a mesh. Set by scripts/bench edges and by fits to the scans and figures of scripts/bench quality.
struct FitMeshTuning {
    // The number of even places on the mesh that a fit begins with. Larger: small fits take longer.
    std::int64_t first_centres = 400;
    // Candidates are at least and at most this many. Larger: finer details are seen, and rounds take longer.
    std::int64_t fewest_candidates = 20000;
    std::int64_t most_candidates = 100000;
    std::int32_t most_rounds = 40;
    // Centres are added for candidates beyond this share of the tolerance. Larger: more rounds.
    double inner = 0.8;
    // Centres are at least this many tolerances apart. Larger: sharp details are rounder.
    double apart = 0.5;
    // A fit aims at the share that is asked for and this much of the rest, because places that were not candidates are
    // slightly worse. Larger: more centres.
    double margin = 0.3;
    // The surface is looked for in this many cells a diagonal in all rounds, and once in finer ones when all is well.
    // Larger: thinner inventions are found, and rounds take longer.
    double cells_of_rounds = 72.0;
    double cells_of_last = 128.0;
    // A round gains if it brings what is outside down to this share. After this many rounds without a gain in turn no
    // end is in sight.
    double gain = 0.9;
    std::int32_t idle_rounds = 2;
    // A candidate at which f grows inward is off by at least this many tolerances.
    double wrong_side = 2.0;
    // The surface is looked at once this share of the mesh is within the tolerance, as most inventions go by
    // themselves before. Larger: more rounds; smaller: more centres off the surface.
    double first_look = 0.9;
    // The result is measured at this many other places of the mesh.
    std::int64_t verified_places = 10000;
    // The residual of the equations, in tolerances, and its bounds, relative. Larger: faster, and less exact.
    double residual = 5e-3;
    double finest_residual = 1e-8;
    double roughest_residual = 1e-5;
    // The precision of f and of the surface's vertices, in tolerances, and its lower bound, in diagonals.
    double precision = 5e-2;
    double finest_precision = 1e-9;
    // f is asked at about this many places for each vertex of the surface, and at first at this many in all. It decides
    // only how f is evaluated.
    std::int64_t places_a_vertex = 3;
    std::int64_t first_places = 100'000;
    // Surface of which the support of the candidates is worse than this limit is left out beyond a border.
    double support_limit = 3.0;
    // A look at the surface adds at most this many centres off it: each moves the surface around it, so more would be
    // in vain. Larger: fewer rounds, and centres that were not needed.
    std::int64_t most_held = 200;
    // Centres off the surface are this share of their distance from the mesh apart. Larger: fewer of them.
    double held_apart = 0.7;
    // Surface farther from the mesh than this many tolerances gets centres.
    double held_beyond = 2.0;
};
inline constexpr FitMeshTuning fit_mesh_tuning;

} // namespace hrbfnpr::mesh
