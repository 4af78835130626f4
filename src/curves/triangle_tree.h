// SPDX-License-Identifier: MIT
// A tree of boxes over a mesh's triangles, in their own order, which is along a space-filling curve.
#pragma once

#include "base/memory.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"

#include <array>

namespace hrbfnpr::curves {

class TriangleTree {
public:
    // The mesh must outlive it.
    TriangleTree(const base::Runtime& runtime, const SurfaceMesh& mesh, const base::Progress& progress = {});

    // Whether a triangle within the distance of p faces the way that the direction points to.
    [[nodiscard]] bool any_facing(const glm::dvec3& p, const glm::dvec3& direction, double distance) const noexcept;

    // How far the surface may be from a triangle that stands for it, by the gradients at its corners.
    [[nodiscard]] double bulge(std::int64_t triangle) const noexcept { return bulge_[triangle]; }

    // Calls visit(triangle) for all triangles whose boxes `meets(box)` lets pass, and for some that are beside them.
    // The boxes hold the surface that triangles stand for.
    template <class Meets, class Visit>
    void visit(Meets&& meets, Visit&& visit) const;

    [[nodiscard]] std::int64_t bytes() const noexcept { return box_.bytes() + bulge_.bytes(); }

private:
    static constexpr std::int64_t leaf_size = 4;
    static constexpr std::size_t stack_size = 64; // every level has one more

    const SurfaceMesh& mesh_;
    std::int64_t leaves_ = 1;           // a power of two
    base::Array<geometry::Bounds> box_; // of the nodes in heap order: 1 is the root, 2 i and 2 i + 1 are below i
    base::Array<double> bulge_;
};

[[nodiscard]] inline std::array<glm::dvec3, 3> corners_of(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::int32_t* corner = mesh.corner.data() + 3 * triangle;
    return {mesh.position[corner[0]], mesh.position[corner[1]], mesh.position[corner[2]]};
}

template <class Meets, class Visit>
void TriangleTree::visit(Meets&& meets, Visit&& visit) const {
    std::array<std::int64_t, stack_size> stack{1};
    std::size_t depth = 1;
    while (depth > 0) {
        const std::int64_t node = stack[--depth];
        if (box_[node].empty() || !meets(box_[node])) continue;
        if (node < leaves_) {
            stack[depth++] = 2 * node + 1;
            stack[depth++] = 2 * node;
            continue;
        }
        const std::int64_t begin = (node - leaves_) * leaf_size;
        for (std::int64_t t = begin; t < std::min(begin + leaf_size, mesh_.triangles()); ++t) visit(t);
    }
}

} // namespace hrbfnpr::curves
