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

} // namespace hrbfnpr::mesh
