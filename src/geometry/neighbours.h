// SPDX-License-Identifier: MIT
// The nearest neighbours of every point.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/parallel.h"
#include "geometry/vec_array.h"

#include <span>

namespace hrbfnpr::geometry {

class Neighbours {
public:
    static constexpr std::int64_t most = 32;

    // each: how many of a point, at most `most`; fewer if there are not so many points.
    Neighbours(const base::Parallel& parallel, const VecArray& points, std::int64_t each,
               const base::Progress& progress);

    [[nodiscard]] std::int64_t each() const noexcept { return each_; }
    // Of point i, without itself, nearest first.
    [[nodiscard]] std::span<const std::int64_t> of(std::int64_t i) const noexcept {
        return index_.span().subspan(static_cast<std::size_t>(i * each_), static_cast<std::size_t>(each_));
    }

private:
    std::int64_t each_;
    base::Array<std::int64_t> index_;
};

} // namespace hrbfnpr::geometry
