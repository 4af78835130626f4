// SPDX-License-Identifier: MIT
// Provides random subsets and medians.
#pragma once

#include "base/assert.h"
#include "base/random.h"
#include "picture/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace hrbfnpr::picture {

// Returns `wanted` of the numbers 0 to count - 1, in ascending order. If count is not larger than `wanted`, returns all
// numbers [Knuth, "The Art of Computer Programming", 3.4.2, algorithm S].
[[nodiscard]] inline Vector<std::int64_t> random_subset(std::size_t count, std::size_t wanted, std::uint64_t seed,
                                                        std::uint32_t stream, Pool& pool) {
    Vector<std::int64_t> chosen(&pool);
    chosen.reserve(std::min(count, wanted));
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < count && chosen.size() < wanted; ++i) {
        if (i % 4 == 0) numbers = base::uniform4(seed, i / 4, base::Purpose::probe, stream);
        const auto left = static_cast<double>(count - i);
        if (numbers[i % 4] * left < static_cast<double>(wanted - chosen.size()))
            chosen.push_back(static_cast<std::int64_t>(i));
    }
    HRBFNPR_ASSERT(chosen.size() == std::min(count, wanted));
    return chosen;
}

// Returns the median of the numbers, and reorders them. For an even count, it is the mean of the two middle numbers. It
// is NaN for an empty list, or if a number is NaN.
[[nodiscard]] inline double median_of(Vector<double>& numbers) {
    if (numbers.empty() || std::any_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); }))
        return std::numeric_limits<double>::quiet_NaN();
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    if (numbers.size() % 2 == 1) return *middle;
    return (*std::max_element(numbers.begin(), middle) + *middle) / 2.0;
}

} // namespace hrbfnpr::picture
