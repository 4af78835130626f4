// SPDX-License-Identifier: MIT
#include "surface/sheets_meet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::surface {
namespace {

// Sheets that meet at an angle whose squared sine is less than this count as parallel.
constexpr double parallel = 1e-10;
constexpr int steps_to_meet = 20;
// Where steps no longer become shorter, the search has converged up to rounding if a step is below this many
// tolerances. For sheets with thousands of centres and large weights, rounding exceeds 1e-9 of a cell.
constexpr double rounded = 1e3;

implicit::PointBatch single_point(const glm::dvec3& place) noexcept { return {&place.x, &place.y, &place.z, 1}; }

} // namespace

SheetValue sheet_at(const implicit::Sheets& sheets, std::int32_t sheet, const glm::dvec3& place) {
    SheetValue at;
    sheets.evaluate(sheet, single_point(place), {&at.value, {&at.gradient.x, &at.gradient.y, &at.gradient.z}, {}});
    return at;
}

std::int32_t active_at(const implicit::Sheets& sheets, const glm::dvec3& place) {
    std::int32_t sheet = 0;
    sheets.active(single_point(place), &sheet);
    return sheet;
}

// By Gram and Schmidt's method, the step for each sheet is perpendicular to the gradients of the previous sheets, so
// their values do not change.
glm::dvec3 step_to_zero(std::span<const SheetValue> values) noexcept {
    std::array<glm::dvec3, 3> across{};
    std::size_t count = 0;
    glm::dvec3 way(0.0);
    for (const SheetValue& v : values) {
        const double slope = glm::length(v.gradient);
        if (!(slope > 0.0) || count == across.size()) continue;
        const glm::dvec3 normal = v.gradient / slope;
        glm::dvec3 rest = normal;
        for (std::size_t k = 0; k < count; ++k) rest -= glm::dot(rest, across[k]) * across[k];
        const double square = glm::dot(rest, rest);
        if (!(square > parallel)) continue;
        way -= (v.value / slope + glm::dot(normal, way)) / square * rest;
        across[count++] = rest / std::sqrt(square);
    }
    return way;
}

bool Meeting::has(std::int32_t wanted) const noexcept {
    return std::find(sheet.begin(), sheet.begin() + static_cast<std::ptrdiff_t>(count), wanted) !=
           sheet.begin() + static_cast<std::ptrdiff_t>(count);
}

void Meeting::add(std::int32_t other) noexcept {
    if (count == sheet.size()) {
        std::rotate(sheet.begin(), sheet.begin() + 1, sheet.end());
        --count;
    }
    sheet[count++] = other;
}

MeetingPlace find_meeting(const implicit::Sheets& sheets, const Meeting& meeting, const glm::dvec3& from,
                          double tolerance, double farthest) {
    MeetingPlace place;
    place.position = from;
    std::array<SheetValue, 3> at;
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step < steps_to_meet; ++step) {
        for (std::size_t k = 0; k < meeting.count; ++k) {
            at[k] = sheet_at(sheets, meeting.sheet[k], place.position);
            place.gradient[k] = at[k].gradient;
        }
        const glm::dvec3 way = step_to_zero(std::span<const SheetValue>(at).first(meeting.count));
        const double length = glm::length(way);
        if (!(glm::distance(place.position + way, from) <= farthest)) return place;
        const bool rounding = length <= rounded * tolerance && length > 0.5 * last;
        // The step ignores a part of the values of parallel sheets, so these may not be 0 yet. They are checked here.
        if (length <= tolerance || rounding) {
            const double near = 2.0 * std::max(tolerance, length);
            place.found =
                std::all_of(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(meeting.count),
                            [&](const SheetValue& v) { return std::abs(v.value) <= near * glm::length(v.gradient); });
            return place;
        }
        last = length;
        place.position += way;
    }
    return place;
}

} // namespace hrbfnpr::surface
