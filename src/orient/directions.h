// SPDX-License-Identifier: MIT
// Planes through neighbouring points, and who the neighbours are.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/point_tree.h"

#include <array>
#include <span>

namespace hrbfnpr::orient {

// The nearest neighbours of every place, nearest first, without itself.
class Near {
public:
    static constexpr std::int64_t most = 63; // what the tree finds

    Near(const base::Runtime& runtime, const geometry::PointTree& tree, std::int64_t each,
         const base::Progress& progress);

    [[nodiscard]] std::int64_t each() const noexcept { return each_; }
    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t at) const noexcept {
        return index_.span().subspan(static_cast<std::size_t>(at * each_), static_cast<std::size_t>(each_));
    }

private:
    std::int64_t size_;
    std::int64_t each_;
    base::Array<std::int32_t> index_;
};

struct Moments {
    double count = 0.0;
    glm::dvec3 sum{0.0};
    std::array<double, 6> square{}; // xx xy xz yy yz zz

    void add(const glm::dvec3& p, double weight = 1.0) noexcept;
};

struct Plane {
    glm::dvec3 centre{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
    glm::dvec3 along{1.0, 0.0, 0.0};  // of the largest variance
    std::array<double, 3> variance{}; // ascending
};
[[nodiscard]] Plane plane_of(const Moments& moments) noexcept;

// Unit normals of any sign of the planes through each place and its nearest `count` neighbours.
[[nodiscard]] geometry::VecArray plane_normals(const base::Runtime& runtime, const geometry::PointTree& tree,
                                               const Near& near, std::int64_t count, const base::Progress& progress);

} // namespace hrbfnpr::orient
