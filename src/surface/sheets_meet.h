// SPDX-License-Identifier: MIT
// Finds points where two or three sheets of an implicit meet: Newton's steps of least length to the zero levels of all.
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

// Returns the shortest step to where all values are 0, by their linear approximations. Gradients parallel to others are
// ignored.
[[nodiscard]] glm::dvec3 step_to_zero(std::span<const SheetValue> values) noexcept;

// A set of up to three sheets.
struct Meeting {
    std::array<std::int32_t, 3> sheet{};
    std::size_t count = 0;

    [[nodiscard]] bool has(std::int32_t wanted) const noexcept;
    // Adds a sheet. If there are three already, it replaces the first.
    void add(std::int32_t other) noexcept;
};

struct MeetingPlace {
    glm::dvec3 position{0.0};
    std::array<glm::dvec3, 3> gradient{}; // gradients of the sheets at `position`
    bool found = false;
};

// Searches from a point. Succeeds when a step is shorter than the tolerance, or as short as rounding allows, and all
// sheets are 0 there. Fails if it goes farther away than `farthest`.
[[nodiscard]] MeetingPlace find_meeting(const implicit::Sheets& sheets, const Meeting& meeting, const glm::dvec3& from,
                                        double tolerance, double farthest);

} // namespace hrbfnpr::surface
