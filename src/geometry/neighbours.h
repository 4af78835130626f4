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

    // `each` is the number of neighbours per point, at most `most`. It is lowered if there are too few points.
    Neighbours(const base::Parallel& parallel, const VecArray& points, std::int64_t each,
               const base::Progress& progress);

    [[nodiscard]] std::int64_t each() const noexcept { return each_; }
    // Returns the neighbours of point i, nearest first. The point itself is not among them.
    [[nodiscard]] std::span<const std::int64_t> of(std::int64_t i) const noexcept {
        return index_.span().subspan(static_cast<std::size_t>(i * each_), static_cast<std::size_t>(each_));
    }

private:
    std::int64_t each_;
    base::Array<std::int64_t> index_;
};

} // namespace hrbfnpr::geometry
