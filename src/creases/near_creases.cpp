// SPDX-License-Identifier: MIT
#include "creases/near_creases.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides: pieces of creases are no longer.
constexpr double longest_part_beside = 1.0;
constexpr double farthest_beside = 0.5;

} // namespace

NearCreases::NearCreases(base::Memory& memory, const Creases& creases, double least, double side)
    : most_(farthest_beside * side), from_(memory), to_(memory) {
    geometry::VecArray middle(memory);
    const auto sharp = [&](std::int64_t i) { return std::abs(creases.point[i].angle()) >= least; };
    const auto add = [&](std::int64_t i, std::int64_t next) {
        if (!sharp(i) || !sharp(next)) return;
        from_.push_back(creases.point[i].position);
        to_.push_back(creases.point[next].position);
        middle.push_back(0.5 * (creases.point[i].position + creases.point[next].position));
    };
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        const std::int64_t last = creases.first[c + 1] - 1;
        for (std::int64_t i = creases.first[c]; i < last; ++i) add(i, i + 1);
        if (creases.closed[c] != 0) add(last, creases.first[c]);
    }
    grid_.emplace(middle, 0.5 * longest_part_beside * side + most_);
}

bool NearCreases::has(const glm::dvec3& place, double reach) const noexcept {
    bool found = false;
    grid_->around(place, [&](std::int64_t at) {
        const std::int64_t i = grid_->index(at);
        found = found || geometry::distance_to_segment(place, from_[i], to_[i]) <= std::min(reach, most_);
    });
    return found;
}

} // namespace hrbfnpr::curves
