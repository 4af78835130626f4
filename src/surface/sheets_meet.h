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

// A sheet and a place where it is evaluated. Members have no initializers, so that blocks of requests are not cleared.
struct SheetRequest {
    std::int32_t sheet;
    glm::dvec3 place;
};

// Answers all requests. Those with the same sheet are evaluated together, which is faster than one by one. An answer
// does not depend on the other requests.
void sheets_at(const implicit::Sheets& sheets, std::span<const SheetRequest> requests, SheetValue* answers);

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

struct MeetingSearch {
    Meeting meeting;
    glm::dvec3 from{0.0};
    double farthest = 0.0; // The search fails if it goes farther away from `from` than this.
};

// Searches for a place from each start. A search succeeds if a step is shorter than the tolerance, or as short as
// rounding allows, and all its sheets are 0 there. Many searches together are faster than one by one, with the same
// results.
void find_meetings(const implicit::Sheets& sheets, std::span<const MeetingSearch> searches, double tolerance,
                   MeetingPlace* places);

[[nodiscard]] inline MeetingPlace find_meeting(const implicit::Sheets& sheets, const MeetingSearch& search,
                                               double tolerance) {
    MeetingPlace place;
    find_meetings(sheets, {&search, 1}, tolerance, &place);
    return place;
}

} // namespace hrbfnpr::surface
