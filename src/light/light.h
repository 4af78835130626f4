// SPDX-License-Identifier: MIT
// How much light reaches places of a surface past the meshes that cast shadows, and how the surface bends there.
//
//   find_openness   places → how much of the sky each sees                      [Zhukov, Iones, Kronin 1998]
//   find_visible    places, a lamp → how much of the lamp each sees
//   SurfaceBend     places, their surface's mesh → the mean curvature around each
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "geometry/bvh.h"
#include "geometry/point_grid.h"
#include "geometry/vec_array.h"

#include <cstdint>

namespace hrbfnpr::light {

// Places on a surface, with unit normals. Rays begin at `offset` above them, so that they do not meet
// the surface's own mesh. The offset is the largest distance of the mesh from the surface.
struct Places {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    double offset;
};

struct Sky {
    double reach;                 // Parts farther away than this hide no sky. Above 0.
    std::int32_t rays = 64;       // the number of rays of a place
    std::int64_t samples = 24000; // At most about this number of places have own rays, unless others differ from them.
};

// Returns for each place how much of the sky it sees, from 0 to 1: one minus the mean of 1 - t / reach over directions,
// weighted by the cosine, where t is the distance at which the ray meets a mesh. Most places take the mean of samples
// around them. Places whose samples differ have own rays. The result is the same for any number of threads.
[[nodiscard]] base::Array<float> find_openness(const base::Work& work, const geometry::Bvh& casters,
                                               const Places& places, const Sky& sky);

struct Lamp {
    glm::dvec3 place; // the direction to the lamp, or its place
    bool is_place = false;
    double softness = 0.0;  // the radius of the lamp's disc, as an angle that is seen from the surface, in radians
    std::int32_t rays = 32; // the number of rays of a place in the penumbra
};

// Returns for each place which part of the lamp it sees, from 0 to 1. Places that face away see 0.
[[nodiscard]] base::Array<float> find_visible(const base::Work& work, const geometry::Bvh& casters,
                                              const Places& places, const Lamp& lamp);

// The mesh of a surface. The corners of a triangle are counter-clockwise as seen from outside.
struct SurfaceTriangles {
    const geometry::VecArray& position;
    const base::Array<std::int32_t>& corner; // three indices for each triangle
    double side;                             // the longest side of a cell
};

// How a surface bends, as means over distances of about a scale.
class SurfaceBend {
public:
    // The scale is at least about a side of a cell.
    SurfaceBend(const base::Work& work, const SurfaceTriangles& mesh, double scale);

    // Returns the mean curvature around each place times the scale: positive on ridges and hills, negative in hollows.
    // The result of both functions is the same for any number of threads.
    [[nodiscard]] base::Array<float> curvature(const base::Work& work, const Places& places) const;
    // Returns how much more the surface bends outward around each place than it does on average, from -1 in hollows to
    // 1 on ridges.
    [[nodiscard]] base::Array<float> contrast(const base::Work& work, const Places& places) const;

private:
    // Sums over some triangles of the mesh.
    struct Patch {
        double area = 0.0;
        double squares = 0.0;   // the sum of the squared distances from `mean`
        glm::dvec3 mean{0.0};   // the centre of the area
        glm::dvec3 normal{0.0}; // the unit mean of the normals
    };
    struct Patches;

    [[nodiscard]] double curvature_at(const glm::dvec3& place, const glm::dvec3& normal) const;
    [[nodiscard]] double bounded_at(const glm::dvec3& place, const glm::dvec3& normal) const;

    double scale_;
    double reach_;
    base::Array<Patch> patch_;
    geometry::PointGrid grid_; // holds the patches, which are in its order
    double mean_ = 0.0;        // the mean of bounded_at() over the surface
};

} // namespace hrbfnpr::light
