// SPDX-License-Identifier: MIT
// Answers many questions about places in one small cube. A small tree of the faces near the cube answers most of them
// faster than the tree of all faces. The answers are those of the tree of all faces.
#pragma once

#include "mesh/face_tree.h"

namespace hrbfnpr::mesh {

class NearbyFaces {
public:
    // The small tree has the faces in the cube with this centre and half its side.
    NearbyFaces(base::Memory& memory, const FaceTree& all, const glm::dvec3& centre, double half)
        : all_(all), nearby_(memory, all, {centre - half, centre + half}), centre_(centre), half_(half) {}

    // These functions answer like those of FaceTree.
    [[nodiscard]] FaceTree::Nearest nearest(const glm::dvec3& p, double limit) const noexcept;
    [[nodiscard]] FaceTree::Hit first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                          double t_max) const noexcept {
        return tree_for(origin, origin + t_max * direction).first_hit(origin, direction, t_min, t_max);
    }
    [[nodiscard]] int winding_beyond(const glm::dvec3& place, const glm::dvec3& other) const noexcept {
        return tree_for(place, other).winding_beyond(place, other);
    }
    [[nodiscard]] const FaceTree& all() const noexcept { return all_; }

private:
    static constexpr double rounding = 1e-6; // the error of places, in half sides of the cube, is less

    // Returns how far a place is from the sides of the cube, or a value below 0 if it is outside.
    [[nodiscard]] double room_at(const glm::dvec3& p) const noexcept {
        const glm::dvec3 off = glm::abs(p - centre_);
        return (1.0 - rounding) * half_ - std::max({off.x, off.y, off.z});
    }
    [[nodiscard]] const FaceTree& tree_for(const glm::dvec3& one, const glm::dvec3& other) const noexcept {
        return room_at(one) >= 0.0 && room_at(other) >= 0.0 ? nearby_ : all_;
    }

    const FaceTree& all_;
    FaceTree nearby_;
    glm::dvec3 centre_;
    double half_;
};

} // namespace hrbfnpr::mesh
