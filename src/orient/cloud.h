// SPDX-License-Identifier: MIT
// Points that are to get normals: normalised, merged, and in an order in which neighbours are near in memory.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "base/view.h"
#include "geometry/point_tree.h"

#include <memory>

namespace hrbfnpr::orient {

// Every index below is a place in the tree's order.
struct Cloud {
    explicit Cloud(base::Memory& memory) noexcept : place(memory), rank(memory), apart(memory) {}

    std::unique_ptr<geometry::PointTree> tree; // spacing 1, centred
    base::Array<std::int64_t> place;           // of each given point
    base::Array<std::int64_t> rank;            // of each place in the farthest-first order
    base::Array<double> apart;                 // of each rank, how far from those before
    glm::dvec3 centre{0.0};
    double spacing = 1.0; // median distance to the nearest other point, in the caller's unit
    std::int64_t merged = 0;

    [[nodiscard]] std::int64_t size() const noexcept { return tree->size(); }
    [[nodiscard]] glm::dvec3 point(std::int64_t at) const noexcept { return tree->points()[at]; }
};

// Throws Error{invalid_argument} naming "points": numbers that are not finite, fewer than `fewest` different points,
// or all of them on one line.
[[nodiscard]] Cloud read_cloud(const base::Runtime& runtime, const base::InView& points,
                               const base::Progress& progress);

inline constexpr std::int64_t fewest = 4;

} // namespace hrbfnpr::orient
