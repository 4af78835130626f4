// SPDX-License-Identifier: MIT
// An adaptive octree over points: cubes are halved until they hold few points. Lists tell which cubes are near each
// other.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::geometry {

class Octree {
public:
    struct Node {
        std::int64_t begin; // the range of its points in the tree's order
        std::int64_t end;
        std::int64_t first_child;         // children are consecutive; 0 in a leaf
        std::int64_t parent;              // the root is its own parent
        std::array<std::int32_t, 3> cell; // position in the grid of its level
        std::int32_t level;
        std::int32_t children;

        [[nodiscard]] bool leaf() const noexcept { return children == 0; }
        [[nodiscard]] std::int64_t count() const noexcept { return end - begin; }
    };

    // Cubes with more than leaf_size points are divided, down to deepest_level. The root cube is wider than the points
    // by `margin` times their width.
    Octree(const VecArray& points, std::int64_t leaf_size, double margin, const base::Progress& progress);

    static constexpr std::int32_t deepest_level = 20;

    [[nodiscard]] const VecArray& points() const noexcept { return points_; }
    // Returns the original index of the point at position `at` of the tree's order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return index_[at]; }

    // Nodes are stored level by level, each level along a space-filling curve.
    [[nodiscard]] const base::Array<Node>& nodes() const noexcept { return nodes_; }
    [[nodiscard]] std::int32_t levels() const noexcept { return static_cast<std::int32_t>(level_begin_.size()) - 1; }
    [[nodiscard]] std::int64_t level_begin(std::int32_t level) const noexcept { return level_begin_[level]; }
    [[nodiscard]] std::int64_t level_end(std::int32_t level) const noexcept { return level_begin_[level + 1]; }

    [[nodiscard]] const glm::dvec3& corner() const noexcept { return corner_; } // the one with the lowest coordinates
    [[nodiscard]] double half_width(std::int32_t level) const noexcept {
        return 0.5 * width_ / static_cast<double>(1LL << level);
    }
    [[nodiscard]] glm::dvec3 centre(const Node& node) const noexcept;
    // Returns the index of the node among the children of its parent, as bits x, y, z.
    [[nodiscard]] static int octant(const Node& node) noexcept {
        return (node.cell[0] & 1) | ((node.cell[1] & 1) << 1) | ((node.cell[2] & 1) << 2);
    }

private:
    void sort(const VecArray& points, const base::Progress& progress);
    void divide(std::int64_t leaf_size, const base::Progress& progress);
    void divide_node(std::int64_t node);

    VecArray points_;
    base::Array<std::int64_t> index_;
    base::Array<std::uint64_t> key_; // Morton codes of the points, with deepest_level bits per axis
    base::Array<Node> nodes_;
    base::Array<std::int64_t> level_begin_;
    glm::dvec3 corner_{0.0};
    double width_ = 1.0;
};

// Pairs of cubes that together cover every pair of points once.
struct OctreeInteractions {
    explicit OctreeInteractions(base::Memory& memory) noexcept
        : far_begin(memory), far(memory), near_begin(memory), near(memory) {}

    // The far cubes of a node have the same size as the node and do not touch it, but their parents touch its parent.
    base::Array<std::int64_t> far_begin; // where the list of each node begins in `far`
    base::Array<std::int64_t> far;
    // The near cubes of a node: each of their points interacts with each point of the node directly.
    base::Array<std::int64_t> near_begin;
    base::Array<std::int64_t> near;
};

[[nodiscard]] OctreeInteractions octree_interactions(const Octree& tree, const base::Progress& progress = {});

} // namespace hrbfnpr::geometry
