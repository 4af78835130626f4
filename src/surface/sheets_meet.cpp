// SPDX-License-Identifier: MIT
#include "surface/sheets_meet.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hrbfnpr::surface {
namespace {

// Sheets that meet at an angle whose squared sine is less than this count as parallel.
constexpr double parallel = 1e-10;
constexpr int steps_to_meet = 20;
// Where steps no longer become shorter, the search has converged up to rounding if a step is below this many
// tolerances. For sheets with thousands of centres and large weights, rounding exceeds 1e-9 of a cell.
constexpr double rounded = 1e3;

// The number of searches that make their steps together. Each asks for up to three sheets.
constexpr std::size_t searches_at_once = 64;
constexpr std::size_t requests_at_once = 3 * searches_at_once;

// Makes one step of a search. `at` has the values of the sheets at `place`, and `last` is the length of the last step.
// Returns whether the search goes on.
bool make_step(const MeetingSearch& search, double tolerance, std::span<const SheetValue> at, double& last,
               MeetingPlace& place) noexcept {
    for (std::size_t k = 0; k < at.size(); ++k) place.gradient[k] = at[k].gradient;
    const glm::dvec3 way = step_to_zero(at);
    const double length = glm::length(way);
    if (!(glm::distance(place.position + way, search.from) <= search.farthest)) return false;
    const bool rounding = length <= rounded * tolerance && length > 0.5 * last;
    // The step ignores a part of the values of parallel sheets, so these may not be 0 yet. They are checked here.
    if (length <= tolerance || rounding) {
        const double near = 2.0 * std::max(tolerance, length);
        place.found = std::all_of(at.begin(), at.end(), [&](const SheetValue& v) {
            return std::abs(v.value) <= near * glm::length(v.gradient);
        });
        return false;
    }
    last = length;
    place.position += way;
    return true;
}

void find_some_meetings(const implicit::Sheets& sheets, std::span<const MeetingSearch> searches, double tolerance,
                        MeetingPlace* places) {
    HRBFNPR_ASSERT(searches.size() <= searches_at_once);
    std::array<std::size_t, searches_at_once> active;
    std::array<double, searches_at_once> last;
    std::array<SheetRequest, requests_at_once> requests;
    std::array<SheetValue, requests_at_once> answers;
    std::size_t left = searches.size();
    for (std::size_t i = 0; i < left; ++i) {
        active[i] = i;
        last[i] = std::numeric_limits<double>::infinity();
        places[i] = {};
        places[i].position = searches[i].from;
    }
    for (int step = 0; step < steps_to_meet && left > 0; ++step) {
        std::size_t count = 0;
        for (std::size_t a = 0; a < left; ++a) {
            const Meeting& meeting = searches[active[a]].meeting;
            for (std::size_t k = 0; k < meeting.count; ++k)
                requests[count++] = {meeting.sheet[k], places[active[a]].position};
        }
        sheets_at(sheets, std::span(requests).first(count), answers.data());
        const SheetValue* at = answers.data();
        std::size_t kept = 0;
        for (std::size_t a = 0; a < left; ++a) {
            const std::size_t i = active[a];
            const std::size_t asked = searches[i].meeting.count;
            if (make_step(searches[i], tolerance, {at, asked}, last[i], places[i])) active[kept++] = i;
            at += asked;
        }
        left = kept;
    }
}

implicit::PointBatch single_point(const glm::dvec3& place) noexcept { return {&place.x, &place.y, &place.z, 1}; }

} // namespace

SheetValue sheet_at(const implicit::Sheets& sheets, std::int32_t sheet, const glm::dvec3& place) {
    SheetValue at;
    sheets.evaluate(sheet, single_point(place), {&at.value, {&at.gradient.x, &at.gradient.y, &at.gradient.z}, {}});
    return at;
}

void sheets_at(const implicit::Sheets& sheets, std::span<const SheetRequest> requests, SheetValue* answers) {
    std::array<std::uint16_t, requests_at_once> order;
    double at[3][requests_at_once];
    double value[requests_at_once];
    double gradient[3][requests_at_once];
    for (; !requests.empty(); requests = requests.subspan(std::min(requests.size(), requests_at_once))) {
        const auto block = requests.first(std::min(requests.size(), requests_at_once));
        std::iota(order.begin(), order.end(), std::uint16_t{0});
        std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(block.size()),
                  [&](std::uint16_t a, std::uint16_t b) { return block[a].sheet < block[b].sheet; });
        for (std::size_t first = 0, end = 0; first < block.size(); first = end) {
            const std::int32_t sheet = block[order[first]].sheet;
            for (; end < block.size() && block[order[end]].sheet == sheet; ++end)
                for (int c = 0; c < 3; ++c) at[c][end] = block[order[end]].place[c];
            sheets.evaluate(sheet,
                            {at[0] + first, at[1] + first, at[2] + first, static_cast<std::int64_t>(end - first)},
                            {value + first, {gradient[0] + first, gradient[1] + first, gradient[2] + first}, {}});
        }
        for (std::size_t k = 0; k < block.size(); ++k)
            answers[order[k]] = {value[k], {gradient[0][k], gradient[1][k], gradient[2][k]}};
        answers += block.size();
    }
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

void find_meetings(const implicit::Sheets& sheets, std::span<const MeetingSearch> searches, double tolerance,
                   MeetingPlace* places) {
    for (std::size_t first = 0; first < searches.size(); first += searches_at_once)
        find_some_meetings(sheets, searches.subspan(first, std::min(searches_at_once, searches.size() - first)),
                           tolerance, places + first);
}

} // namespace hrbfnpr::surface
