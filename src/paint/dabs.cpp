// SPDX-License-Identifier: MIT
#include "paint/dabs.h"

#include "base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::paint {
namespace {

// Cell indices are clamped to this magnitude. Places that are farther away share cells, which only costs time.
constexpr double farthest_cell = 1e9;

[[nodiscard]] std::int64_t cell_along(double place, double side) noexcept {
    const double cell = std::floor(place / side);
    if (!(cell > -farthest_cell)) return static_cast<std::int64_t>(-farthest_cell);
    return static_cast<std::int64_t>(std::min(cell, farthest_cell));
}

// Returns a hash of a cell. If two cells have the same hash, this only costs time, because a dab has no weight outside
// its radius.
[[nodiscard]] std::uint64_t cell_number(std::int64_t x, std::int64_t y, std::int64_t z) noexcept {
    return static_cast<std::uint64_t>(x) * 73856093U ^ static_cast<std::uint64_t>(y) * 19349663U ^
           static_cast<std::uint64_t>(z) * 83492791U;
}

// Returns the weight of a dab at a place.
[[nodiscard]] double dab_weight(const Dab& dab, const Place& place) noexcept {
    const glm::dvec3 away = place.position - dab.position;
    const double share = glm::dot(away, away) / (dab.radius * dab.radius);
    // The comparisons are false for NaN, so NaN is never painted.
    if (!(share < 1.0) || !(glm::dot(place.normal, dab.normal) > 0.0)) return 0.0;
    return dab.strength * (1.0 - share) * (1.0 - share);
}

} // namespace

Dabs::Dabs(base::Memory& memory, FieldKind kind, std::span<const Dab> dabs)
    : kind_(kind), dabs_(memory), cells_(memory) {
    double largest = 0.0;
    for (const Dab& dab : dabs) {
        HRBFNPR_ASSERT(dab.radius > 0.0);
        dabs_.push_back(dab);
        largest = std::max(largest, dab.radius);
    }
    // A cell is as wide as the largest dab.
    if (largest > 0.0) cell_side_ = 2.0 * largest;
    for (std::int64_t i = 0; i < dabs_.size(); ++i) list_dab(static_cast<std::uint32_t>(i));
    std::sort(cells_.begin(), cells_.end(),
              [](const CellDab& a, const CellDab& b) { return a.cell != b.cell ? a.cell < b.cell : a.dab < b.dab; });
    // Two cells that a dab overlaps may have the same hash. The dab must be listed only once for this hash.
    const auto same = [](const CellDab& a, const CellDab& b) { return a.cell == b.cell && a.dab == b.dab; };
    cells_.resize(std::unique(cells_.begin(), cells_.end(), same) - cells_.begin());
}

// Lists a dab in all cells that it overlaps: at most two along each axis, or three after rounding.
void Dabs::list_dab(std::uint32_t number) {
    const Dab& dab = dabs_[number];
    std::array<std::int64_t, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double middle = dab.position[static_cast<int>(axis)];
        low[axis] = cell_along(middle - dab.radius, cell_side_);
        high[axis] = std::min(cell_along(middle + dab.radius, cell_side_), low[axis] + 2);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
            for (std::int64_t z = low[2]; z <= high[2]; ++z) cells_.push_back({cell_number(x, y, z), number});
}

std::span<const Dabs::CellDab> Dabs::near(const glm::dvec3& place) const noexcept {
    const std::uint64_t cell =
        cell_number(cell_along(place.x, cell_side_), cell_along(place.y, cell_side_), cell_along(place.z, cell_side_));
    const CellDab* const first = std::lower_bound(
        cells_.begin(), cells_.end(), cell, [](const CellDab& one, std::uint64_t number) { return one.cell < number; });
    const CellDab* const last = std::find_if(first, cells_.end(), [&](const CellDab& one) { return one.cell != cell; });
    return {first, last};
}

Sample Dabs::at(const Place& place) const noexcept {
    Sample sum; // the value is not yet divided by the weight
    for (const CellDab& one : near(place.position)) {
        const Dab& dab = dabs_[one.dab];
        const double weight = dab_weight(dab, place);
        const bool turned = kind_ == FieldKind::direction && glm::dot(sum.value, dab.value) < 0.0;
        sum.value = (1.0 - weight) * sum.value + (turned ? -weight : weight) * dab.value;
        sum.weight = (1.0 - weight) * sum.weight + weight;
    }
    if (!(sum.weight > 0.0)) return {};
    return {sum.value / sum.weight, std::min(sum.weight, 1.0)};
}

} // namespace hrbfnpr::paint
