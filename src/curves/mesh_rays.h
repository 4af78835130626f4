// SPDX-License-Identifier: MIT
// Finds where rays meet a surface that has a mesh. A ray meets the mesh first, which takes no evaluation of f. Its hits
// are then moved along the ray to f = 0, or stay on the mesh.
#pragma once

#include "curves/surface_mesh.h"
#include "geometry/bvh.h"
#include "surface/cast_rays.h"

namespace hrbfnpr::curves {

// A mesh and a hierarchy of boxes over its triangles. The mesh must outlive it.
struct RayMesh {
    RayMesh(const base::Work& work, const SurfaceMesh& of);

    const SurfaceMesh& mesh;
    geometry::Bvh tree;
};

struct MeshRaySettings {
    surface::RaySettings rays; // smallest_step, lipschitz and evaluation_limit are not used
    bool refine = true;        // whether hits are moved to f = 0; false: hits are places of the mesh
};

// Casts all rays on all threads. Resizes `hits`, whose normals are those of the mesh if the hits stay on it. Returns
// the rays, in ascending order, with a hit on the mesh that does not lead to a zero of f within a side of a cell. Their
// hits are to be found without the mesh. Each ray's result is the same bits, whatever other rays there are.
[[nodiscard]] base::Array<std::int32_t> cast_rays(const base::Work& work, const implicit::Implicit& implicit,
                                                  const RayMesh& mesh, const MeshRaySettings& settings,
                                                  const surface::Rays& rays, surface::RayHits& hits);

} // namespace hrbfnpr::curves
