// SPDX-License-Identifier: MIT
// What can be said of many marks at once before any of them is looked at: of all that lie in a ball with normals in a
// cone.
#pragma once

#include "frame/scene/scene.h"
#include "frame/scene/see_loops.h"

#include <array>

namespace hrbfnpr::frame {

// One item seen from its own space.
struct ItemSight {
    Seer seer;             // `rigid` if the transform keeps angles, so that cones of normals stay cones
    float scale = 1.0F;    // eye units per object unit, the largest
    bool inside = false;   // all of it surely lies in the picture
    glm::vec3 eye{0.0F};   // centre of projection, object space; or the unit direction of all lines of sight
    glm::vec3 light{0.0F}; // unit, object space, if the transform is rigid
};

// The sides of the frustum in eye space: plane . (eye, 1) >= 0 inside.
struct Frustum {
    std::array<glm::vec4, 6> plane; // left, right, top, bottom, near, far
    std::array<float, 6> norm;      // the length of the first three numbers of each plane
    float w_norm = 0.0F;
};

[[nodiscard]] Frustum frustum_of(const Lens& lens) noexcept;
[[nodiscard]] ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept;

// Bounds that hold for all marks of a cluster or of a piece of a stroke.
struct ClusterView {
    float beyond = -1.0F; // all marks surely lie more than this outside of the picture, pixels; < 0: they may not
    bool inside = false;  // all marks surely lie in the picture
    float pixels_per_unit = 1.0F; // at the centre
    float nearest = 0.0F;         // w of the projection, at least; 0: some marks may be after the camera's plane
    float nu_min = -1.0F;
    float nu_max = 1.0F;
    float lit_min = -1.0F; // by the normals; tone may go by others
};

[[nodiscard]] ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens,
                                       const Frustum& frustum) noexcept;

// Whether n . v > 0 at all marks; false where that is not known at once.
[[nodiscard]] bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept;

// No n . l of a normal for tone in the piece is less.
[[nodiscard]] float least_lit(const marks::StrokePiece& piece, const ItemSight& sight) noexcept;

} // namespace hrbfnpr::frame
