// SPDX-License-Identifier: MIT
// Finds points where two or three sheets of an implicit function meet. It uses Newton's method with the shortest steps
// to the common zero of the sheets.
#pragma once

#include "geometry/vec.h"
#include "implicit/sheets.h"

#include <array>
#include <span>

namespace hrbfnpr::surface {

struct SheetValue {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
};

[[nodiscard]] SheetValue sheet_at(const implicit::Sheets& sheets, std::int32_t sheet, const glm::dvec3& place);
[[nodiscard]] std::int32_t active_at(const implicit::Sheets& sheets, const glm::dvec3& place);

// Returns the shortest step to the place where the linear approximations of all values are 0. Gradients that are
// parallel to others are ignored.
[[nodiscard]] glm::dvec3 step_to_zero(std::span<const SheetValue> values) noexcept;

// A set of up to three sheets.
struct Meeting {
    std::array<std::int32_t, 3> sheet{};
    std::size_t count = 0;

    [[nodiscard]] bool has(std::int32_t wanted) const noexcept;
    // Adds a sheet. If there are three sheets already, it replaces the first one.
    void add(std::int32_t other) noexcept;
};

struct MeetingPlace {
    glm::dvec3 position{0.0};
    std::array<glm::dvec3, 3> gradient{}; // gradients of the sheets at `position`
    bool found = false;
};

// Searches from a point. It succeeds if a step is shorter than the tolerance, or as short as rounding allows, and all
// sheets are 0 there. It fails if the search goes farther away than `farthest`.
[[nodiscard]] MeetingPlace find_meeting(const implicit::Sheets& sheets, const Meeting& meeting, const glm::dvec3& from,
                                        double tolerance, double farthest);

} // namespace hrbfnpr::surface
