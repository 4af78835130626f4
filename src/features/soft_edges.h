// SPDX-License-Identifier: MIT
// Soft edges: lines along edges and folds that are round, such as the worn rim of a base, or the fold below an ear.
//
// A soft edge is a line of greatest curvature at which the surface turns by an angle, while it turns little on both
// sides. Its strength is that angle less the turns on the sides, in degrees. A round limb has nearly none, since it
// turns as much on the sides. Noise and shallow waves have none, since their turns cancel.
//
// The lines are found at one scale, which is some cells of the mesh wide. Derivatives of f at single places are not
// used, because they show the ripples of a fit between its samples.
#pragma once

#include "curves/curves.h"
#include "curves/surface_mesh.h"

namespace hrbfnpr::curves {

struct SoftEdgeRequest {
    // A line goes on while its strength is at least `lower`, and is kept if it reaches `upper` somewhere, in degrees.
    double lower = 0.0;
    double upper = 0.0;
    double shortest = 0.0; // shorter lines are dropped, in diagonals
};

struct SoftEdges {
    explicit SoftEdges(base::Memory& memory) : convex(memory), concave(memory) {}

    SurfaceLines convex;
    SurfaceLines concave;
};

// Returns lines on the surface with their strengths. `mesh` is a mesh of the surface. Gives the same bits for any
// number of threads. Throws Error{out_of_memory, cancelled, callback}.
[[nodiscard]] SoftEdges find_soft_edges(const base::Work& work, const implicit::Implicit& surface,
                                        const SurfaceMesh& mesh, const SoftEdgeRequest& request);

} // namespace hrbfnpr::curves
