// SPDX-License-Identifier: MIT
#include "features/section_corners.h"

#include "geometry/point_grid.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides.
constexpr double corner_reach = 0.75; // from the end of a line, which is on the chord between two vertices on a crease
constexpr double corner_tolerance = 1e-10;
constexpr double farthest_corner = 0.5;
constexpr int corner_steps = 20;

// Corners of all levels, and of which each is.
struct Corners {
    explicit Corners(base::Memory& memory) : place(memory), left(memory), right(memory), level(memory) {}
    geometry::VecArray place;
    geometry::VecArray left, right; // unit normals of both sheets
    base::Array<std::int32_t> level;
};

// On both sheets of a crease and on the plane; `from` again where there is no such place beside it.
glm::dvec3 corner_at(const implicit::Sheets& sheets, std::int32_t left, std::int32_t right, const glm::dvec3& plane,
                     double level, const glm::dvec3& from, double side) {
    glm::dvec3 at = from;
    for (int step = 0; step < corner_steps; ++step) {
        const std::array<surface::SheetValue, 3> values{surface::sheet_at(sheets, left, at),
                                                        surface::sheet_at(sheets, right, at),
                                                        {glm::dot(plane, at) - level, plane}};
        const glm::dvec3 way = surface::way_to_zero(values);
        if (!(glm::distance(at + way, from) <= farthest_corner * side)) return from;
        at += way;
        if (glm::length(way) <= corner_tolerance * side) break;
    }
    return at;
}

Corners find_corners(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                     const glm::dvec3& plane, std::span<const double> levels, double side) {
    Corners corners(runtime.memory);
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        const std::int64_t first = creases.first[c];
        const std::int64_t count = creases.first[c + 1] - first;
        const std::int64_t pieces = creases.closed[c] != 0 ? count : count - 1;
        for (std::int64_t k = 0; k < pieces; ++k) {
            const glm::dvec3 a = creases.point[first + k].position;
            const glm::dvec3 b = creases.point[first + (k + 1) % count].position;
            for (std::size_t l = 0; l < levels.size(); ++l) {
                const double from = glm::dot(plane, a) - levels[l];
                const double to = glm::dot(plane, b) - levels[l];
                if ((from < 0.0) == (to < 0.0)) continue;
                const glm::dvec3 at = corner_at(sheets, creases.left[c], creases.right[c], plane, levels[l],
                                                glm::mix(a, b, from / (from - to)), side);
                corners.place.push_back(at);
                corners.left.push_back(glm::normalize(surface::sheet_at(sheets, creases.left[c], at).gradient));
                corners.right.push_back(glm::normalize(surface::sheet_at(sheets, creases.right[c], at).gradient));
                corners.level.push_back(static_cast<std::int32_t>(l));
            }
        }
    }
    return corners;
}

// Moves an end, and points before it that lie beyond the corner: these come between it and the last one that does not.
// The normal there is that of the line's own sheet.  inward: 1 at the beginning of a line, -1 at its end; of `count`
// points.
void move_end(FeatureLines& lines, std::int64_t end, std::int64_t inward, std::int64_t count, const Corners& corners,
              std::int64_t corner) noexcept {
    const glm::dvec3 place = corners.place[corner];
    const auto at = [&](std::int64_t k) { return lines.position[end + k * inward]; };
    std::int64_t kept = 1;
    while (kept + 1 < count && glm::dot(place - at(kept), at(kept) - at(kept + 1)) <= 0.0) ++kept;
    const glm::dvec3 inner = glm::normalize(lines.normal[end + std::min(count - 1, kept) * inward]);
    const bool is_left = glm::dot(inner, corners.left[corner]) >= glm::dot(inner, corners.right[corner]);
    const glm::dvec3 normal = is_left ? corners.left[corner] : corners.right[corner];
    for (std::int64_t k = 0; k < kept; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(kept);
        lines.position.set(end + k * inward, glm::mix(place, at(kept), share));
        lines.normal.set(end + k * inward, glm::mix(normal, inner, share));
    }
}

} // namespace

void end_at_creases(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                    const glm::dvec3& plane, std::span<const double> levels, double side, FeatureLines& lines) {
    const Corners corners = find_corners(runtime, sheets, creases, plane, levels, side);
    if (corners.place.empty()) return;
    const geometry::PointGrid grid(corners.place, corner_reach * side);
    for (std::int64_t l = 0; l < lines.lines(); ++l) {
        if (lines.closed[l] != 0) continue;
        const std::int64_t begin = lines.first[l];
        const std::int64_t last = lines.first[l + 1] - 1;
        for (const bool at_end : {false, true}) {
            const std::int64_t end = at_end ? last : begin;
            double least = corner_reach * side;
            std::int64_t nearest = -1;
            grid.around(lines.position[end], [&](std::int64_t at) {
                const std::int64_t i = grid.index(at);
                const double distance = glm::distance(corners.place[i], lines.position[end]);
                if (corners.level[i] != lines.level[l] || !(distance < least)) return;
                least = distance;
                nearest = i;
            });
            if (nearest >= 0) move_end(lines, end, at_end ? -1 : 1, last + 1 - begin, corners, nearest);
        }
    }
}

} // namespace hrbfnpr::curves
