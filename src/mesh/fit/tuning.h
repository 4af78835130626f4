// SPDX-License-Identifier: MIT
// The tuning constants of comparing a surface with a mesh, of outer.h, and of a smooth fit. A diagonal is the diagonal
// of the mesh's bounds. Tuned on the meshes of tests/mesh and on fitted scans.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct MeshFitTuning {
    // ---- The inside of a mesh

    // The side of a place is certain if at most this many of sixteen rays disagree. Larger: near holes, wrong sides
    // count as certain more often.
    int dissenters = 2;
    // A face is tested for being inside another part at this distance from it, in diagonals. Larger: thin parts are
    // missed.
    double beside_face = 1e-4;

    // ---- Parts that touch

    // Along an edge, faces of other parts are searched for. The search skips at most this many faces of the part that
    // the edge belongs to. Larger: slower on folded meshes.
    int most_own = 8;
    // Parts that are near each other but do not cross count as touching if the cosine of their normals is at least
    // this, or at most minus this. Larger: fewer parts count as touching.
    double least_alike = 0.9;

    // ---- Flat meshes

    // A mesh is flat if all corners are at most this far from the plane of the largest face, in diagonals.
    double flatness = 1e-6;
    // A flat mesh has no inside if more than this share of its area faces opposite to the largest face.
    double other_way = 0.01;

    // ---- The surface beside a mesh

    // The search for the surface begins at the seeds and at a lattice of this many places along each axis of the box.
    // Larger: slower, fewer small parts are missed.
    std::int64_t lattice = 16;
    // The largest number of evaluations for projecting a place onto the surface: `place_evaluations` for points of the
    // lattice and of triangles, and `mesh_evaluations` for places of the mesh.
    int place_evaluations = 12;
    int mesh_evaluations = 20;
    // The tolerance for projecting a place onto the surface, in diagonals. `on_surface_of_seeds` is the tolerance for
    // the points of the lattice, which only begin the search.
    double on_surface = 1e-6;
    double on_surface_of_seeds = 1e-4;
    // Cells are halved if more than this share of the triangles faces against the gradient. Sharp edges alone cause a
    // smaller share. Larger: thin walls are missed.
    double turned_share = 1e-2;
    // Cells are not halved if more triangles than this would result.
    std::int64_t most_triangles = 1'200'000;
    // If no cell shows any surface, cells are halved until there are this many along a diagonal.
    double most_cells = 1024.0;
    // If the surface has other parts than the mesh, and fewer triangles than this, the search is repeated with cells of
    // half the width.
    std::int64_t most_to_look_closer = 400'000;
};
inline constexpr MeshFitTuning mesh_fit_tuning;

// The constants of a smooth fit to a mesh. Set by scripts/bench edges and by fits to the scans and figures of
// scripts/bench quality.
struct FitMeshTuning {
    // The number of evenly spread centres that a fit begins with. Larger: small fits take longer.
    std::int64_t first_centres = 400;
    // The least and the largest number of candidates. Larger: finer details are seen, and rounds take longer.
    std::int64_t fewest_candidates = 20000;
    std::int64_t most_candidates = 100000;
    // A round adds at most this many centres, as a share of the existing ones: `large_batch` while more than the share
    // `mostly_outside` of the candidates is outside the tolerance, then `batch`. Larger: fewer rounds, and more centres
    // that were not needed.
    double large_batch = 2.0;
    double batch = 1.0;
    double mostly_outside = 0.25;
    // A round looks only at this many candidates for each of its centres, because it adds fewer centres than that.
    // Larger: slower; smaller: centres are chosen less well.
    std::int64_t candidates_a_centre = 16;
    std::int32_t most_rounds = 40;
    // Candidates farther from the surface than this share of the tolerance become centres. Larger: more rounds.
    double inner = 0.8;
    // Centres are at least this many tolerances apart. Larger: sharp details are rounder.
    double apart = 0.5;
    // A fit aims for share + margin (1 - share) within the tolerance, because places that were not candidates have
    // slightly larger errors. Larger: more centres.
    double margin = 0.3;
    // The surface is searched for in cells. These are the numbers of cells along a diagonal: in each round, and in the
    // finer search at the end. Larger: thinner spurious parts of the surface are found, and rounds take longer.
    double cells_of_rounds = 72.0;
    double cells_of_last = 128.0;
    // A round gains if the share outside the tolerance, or the farthest distance, falls below this factor times its
    // value before. After this many consecutive rounds without a gain the fit ends.
    double gain = 0.9;
    std::int32_t idle_rounds = 2;
    // The error of a candidate where f grows inward is at least this many tolerances.
    double wrong_side = 2.0;
    // The surface is examined when this share of the mesh is within the tolerance, because most spurious parts have
    // disappeared by then. Larger: more rounds; smaller: more centres off the surface.
    double first_look = 0.9;
    // The result is measured at this many other places of the mesh.
    std::int64_t verified_places = 10000;
    // The residual of the linear system, in tolerances, and the smallest and largest relative residual that may result.
    // Larger: faster, and less exact.
    double residual = 5e-3;
    double finest_residual = 1e-8;
    double roughest_residual = 1e-5;
    // The relative residual to which the rounds solve. The last fit is solved to the residual above. Larger: rounds are
    // faster, and their errors are measured less exactly.
    double residual_of_rounds = 2e-3;
    // The precision of f and of the surface's vertices, in tolerances. `finest_precision` is the smallest value that is
    // used, in diagonals.
    double precision = 5e-2;
    double finest_precision = 1e-9;
    // The search for the surface evaluates f about this many times for each vertex of the surface. `first_vertices` is
    // the first estimate of their number. The numbers only decide whether a far field is worthwhile.
    std::int64_t places_a_vertex = 5;
    std::int64_t first_vertices = 30'000;
    // Beyond a border, surface is ignored if its support by the candidates (s of surface/support.h) is above this
    // limit.
    double support_limit = 3.0;
    // Each examination of the surface adds at most this many centres off the mesh. One centre changes the surface
    // around it, so close ones are not needed. Larger: fewer rounds, and centres that were not needed.
    std::int64_t most_held = 200;
    // The distance between centres off the surface, as a share of their distance from the mesh. Larger: fewer centres
    // off the surface.
    double held_apart = 0.7;
    // A place of the surface gets a centre if it is farther from the mesh than this many tolerances.
    double held_beyond = 2.0;
};
inline constexpr FitMeshTuning fit_mesh_tuning;

} // namespace hrbfnpr::mesh
