// SPDX-License-Identifier: MIT
// What can be said of a whole cluster of marks before any of them is looked at.
#pragma once

#include "frame/scene/scene.h"
#include "frame/scene/see_loops.h"

#include <array>

namespace hrbfnpr::frame {

// One item seen from its own space.
struct ItemSight {
    Seer seer;
    bool rigid = false;    // the transform keeps angles, so that cones of normals stay cones
    float scale = 1.0F;    // eye units per object unit, the largest
    bool inside = false;   // all of it, surely
    glm::vec3 eye{0.0F};   // centre of projection, object space; or the unit direction of all lines of sight
    glm::vec3 light{0.0F}; // unit, object space
};

// The sides of the frustum in eye space: plane . (eye, 1) >= 0 inside.
struct Frustum {
    std::array<glm::vec4, 6> plane; // left, right, top, bottom, near, far
    std::array<float, 6> norm;      // of each plane's first three
    float w_norm = 0.0F;
};

[[nodiscard]] Frustum frustum_of(const Lens& lens) noexcept;

// n . l of a unit normal of the set's own space.
[[nodiscard]] float lit_of(const ItemView& item, const Seer& seer, const glm::vec3& normal) noexcept;

[[nodiscard]] ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept;

// Bounds that hold for all marks of a cluster or a piece of a stroke.
struct ClusterView {
    bool outside = false;         // surely
    bool inside = false;          // surely
    float pixels_per_unit = 1.0F; // at the centre
    float nearest = 0.0F;         // w of the projection, at least; 0: some may be behind the camera
    float nu_min = -1.0F;
    float nu_max = 1.0F;
    float lit_min = -1.0F;
};

// reach: the largest radius of a disc that a mark can bring, pixels.
[[nodiscard]] ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens,
                                       const Frustum& frustum, float reach) noexcept;

// Whether n . v > 0 at all marks; false where that is not known at once.
[[nodiscard]] bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept;

// No n . l of a normal for tone in the piece is less.
[[nodiscard]] float least_lit(const marks::StrokePiece& piece, const ItemSight& sight) noexcept;

// How far, in pixels, a mark's image lies from the contour's: it is at the angle nu from it along a circle whose
// curvature is the radial one.
[[nodiscard]] inline float contour_distance(float nu, float pixel_curvature) noexcept {
    return nu * nu / ((1.0F + std::sqrt(std::max(0.0F, 1.0F - nu * nu))) * pixel_curvature); // inf where flat
}

// Pixels per eye unit at the cluster's centre; 1 if that is behind the camera.
[[nodiscard]] float pixels_per_unit_at(const marks::Cluster& cluster, const ItemSight& sight,
                                       const Lens& lens) noexcept;

// Normal curvature of the cluster's surface where the normal is n, along the line of sight v; object space.  Positive
// where convex.
[[nodiscard]] float radial_curvature(const marks::Cluster& cluster, const glm::vec3& n, const glm::vec3& v) noexcept;

// The direction of the contour there, of any length: along it the normal stays across the line of sight, so that it is
// conjugate to that.  [Koenderink 1984, "What does the occluding contour tell us about solid shape?"]
[[nodiscard]] glm::vec3 contour_direction(const marks::Cluster& cluster, const glm::vec3& n,
                                          const glm::vec3& v) noexcept;

// |nu| up to which contour_distance() may be within `width` pixels, where no curvature is larger than `pixel_bend`.
[[nodiscard]] inline float contour_band(float width, float pixel_bend) noexcept {
    const float q = width * pixel_bend;
    return q < 1.0F ? std::sqrt(q * (2.0F - q)) : 1.0F;
}

} // namespace hrbfnpr::frame
