// SPDX-License-Identifier: MIT
// Places where two or three sheets of an implicit meet: Newton's steps of least length on all of them.
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

// The shortest way to where all are 0, as far as they are linear.  What is parallel to others counts for nothing.
[[nodiscard]] glm::dvec3 way_to_zero(std::span<const SheetValue> values) noexcept;

// Up to three sheets.
struct Meeting {
    std::array<std::int32_t, 3> sheet{};
    std::size_t count = 0;

    [[nodiscard]] bool has(std::int32_t wanted) const noexcept;
    // In the place of the first, where there are three.
    void add(std::int32_t other) noexcept;
};

struct MeetingPlace {
    glm::dvec3 position{0.0};
    std::array<glm::dvec3, 3> gradient{}; // of the sheets there
    bool found = false;
};

// From a place, by steps until one is shorter than the tolerance, or as short as rounding makes it, and no farther away
// than `farthest`.
[[nodiscard]] MeetingPlace find_meeting(const implicit::Sheets& sheets, const Meeting& meeting, const glm::dvec3& from,
                                        double tolerance, double farthest);

} // namespace hrbfnpr::surface
