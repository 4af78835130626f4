// SPDX-License-Identifier: MIT
// Provides polylines on the paper and in space: lengths along them, and places between their points.
#pragma once

#include "base/assert.h"
#include "geometry/vec.h"
#include "picture/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace hrbfnpr::picture {

using PaperLine = Vector<glm::dvec2>; // points in mm; y grows downward
using Flags = Vector<std::uint8_t>;   // each element is 0 or 1

// Returns for each point the length of the line from its beginning to the point.
template <class Line>
[[nodiscard]] Vector<double> lengths_along(const Line& points, Pool& pool) {
    Vector<double> along(points.size(), 0.0, &pool);
    for (std::size_t i = 1; i < points.size(); ++i) along[i] = along[i - 1] + glm::length(points[i] - points[i - 1]);
    return along;
}

template <class Line>
[[nodiscard]] double length_of_line(const Line& points) noexcept {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::length(points[i] - points[i - 1]);
    return length;
}

// Returns the index of the last number that is at most `at`, or 0 if all are larger. The numbers ascend.
[[nodiscard]] inline std::size_t last_not_beyond(std::span<const double> numbers, double at) noexcept {
    const auto after = std::upper_bound(numbers.begin(), numbers.end(), at);
    return after == numbers.begin() ? 0 : static_cast<std::size_t>(after - numbers.begin()) - 1;
}

// Returns the interpolated value at `at`, where values[i] belongs to numbers[i]. The numbers ascend. If `at` is outside
// their range, returns the value of the nearest number.
template <class Value>
[[nodiscard]] Value interpolated(std::span<const double> numbers, std::span<const Value> values, double at) noexcept {
    HRBFNPR_ASSERT(!numbers.empty() && numbers.size() == values.size());
    if (at < numbers.front()) return values.front();
    const std::size_t i = last_not_beyond(numbers, at);
    if (i + 1 == numbers.size() || numbers[i] == at) return values[i];
    const Value slope = (values[i + 1] - values[i]) / (numbers[i + 1] - numbers[i]);
    return slope * (at - numbers[i]) + values[i];
}

// Returns the interpolated value at `at`, where values[i] belongs to the number i.
template <class Value>
[[nodiscard]] Value at_number(std::span<const Value> values, double at) noexcept {
    HRBFNPR_ASSERT(!values.empty());
    if (!(at > 0.0)) return values.front();
    const double last = static_cast<double>(values.size() - 1);
    if (at >= last) return values.back();
    const double whole = std::floor(at);
    const auto i = static_cast<std::size_t>(whole);
    if (whole == at) return values[i];
    return (values[i + 1] - values[i]) * (at - whole) + values[i];
}

// Returns `count` evenly spaced numbers between two numbers, including both. `count` is at least 2.
[[nodiscard]] inline Vector<double> evenly(double from, double to, std::size_t count, Pool& pool) {
    HRBFNPR_ASSERT(count >= 2);
    Vector<double> numbers(&pool);
    numbers.reserve(count);
    const double step = (to - from) / static_cast<double>(count - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) numbers.push_back(static_cast<double>(i) * step + from);
    numbers.push_back(to);
    return numbers;
}

// Returns the number of places, at most `step` apart, that divide a length. Both ends are included, so the number is at
// least 2.
[[nodiscard]] inline std::size_t count_on(double length, double step) noexcept {
    constexpr double most = 1e15;
    const double parts = std::ceil(length / step);
    return parts > 1.0 ? static_cast<std::size_t>(std::min(parts, most)) + 1 : 2;
}

// A square cell of a grid on the paper.
struct PaperCell {
    std::int64_t column;
    std::int64_t row;
    [[nodiscard]] bool operator==(const PaperCell&) const noexcept = default;
};

[[nodiscard]] inline PaperCell cell_of(const glm::dvec2& place, double side) noexcept {
    constexpr double far = 1e15; // NaN is replaced by -far.
    const auto whole = [&](double x) {
        const double cell = std::floor(x / side);
        return static_cast<std::int64_t>(cell > -far ? std::min(cell, far) : -far);
    };
    return {whole(place.x), whole(place.y)};
}

struct PaperCellHash {
    [[nodiscard]] std::size_t operator()(const PaperCell& cell) const noexcept {
        const auto x = static_cast<std::uint64_t>(cell.column) * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>((x ^ x >> 29U) + static_cast<std::uint64_t>(cell.row) * 0xC2B2AE3D27D4EB4FU);
    }
};

} // namespace hrbfnpr::picture
