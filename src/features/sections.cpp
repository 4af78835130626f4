// SPDX-License-Identifier: MIT
// 1. find_section_corners: where the planes cross creases.
// 2. end_at_corners: ends of lines move to the nearest corner.
// 3. join: lines that end where others begin become one with these.
#include "features/sections.h"

#include "features/tuning.h"
#include "geometry/point_grid.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr int corner_steps = 20;           // Newton's method makes at most this many steps
constexpr double corner_tolerance = 1e-10; // a step that is no longer than this is the last one, in sides
constexpr double same_place = 1e-9;        // ends that are no farther apart than this are joined, in sides

struct SectionCorner {
    glm::dvec3 place;
    glm::dvec3 left, right; // unit normals of both sheets
    std::int32_t level;
};

base::Array<SectionCorner> find_section_corners(base::Memory& memory, const implicit::Sheets& sheets,
                                                const Creases& creases, const glm::dvec3& plane,
                                                std::span<const double> levels, double side) {
    base::Array<SectionCorner> corners(memory);
    for (std::int64_t c = 0; c < creases.count(); ++c)
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const std::int64_t j = creases.next(c, i);
            if (j < 0) continue;
            const glm::dvec3 a = creases.point[i].position;
            const glm::dvec3 b = creases.point[j].position;
            for (std::size_t l = 0; l < levels.size(); ++l) {
                const double from = glm::dot(plane, a) - levels[l];
                const double to = glm::dot(plane, b) - levels[l];
                if ((from < 0.0) == (to < 0.0)) continue;
                const glm::dvec3 start = glm::mix(a, b, from / (from - to));
                std::array<surface::SheetValue, 3> values;
                glm::dvec3 at = start;
                const auto look = [&] {
                    values = {surface::sheet_at(sheets, creases.left[c], at),
                              surface::sheet_at(sheets, creases.right[c], at),
                              {glm::dot(plane, at) - levels[l], plane}};
                };
                look();
                for (int step = 0; step < corner_steps; ++step) {
                    const glm::dvec3 way = surface::way_to_zero(values);
                    const bool lost = !(glm::distance(at + way, start) <= feature_tuning.corner_reach * side);
                    at = lost ? start : at + way;
                    look();
                    if (lost || glm::length(way) <= corner_tolerance * side) break;
                }
                corners.push_back({at, glm::normalize(values[0].gradient), glm::normalize(values[1].gradient),
                                   static_cast<std::int32_t>(l)});
            }
        }
    return corners;
}

// Points before an end that lie beyond the corner come between it and the last one that does not. The normal at the
// corner is the normal of the line's own sheet.
void end_at_corners(const base::Runtime& runtime, const base::Array<SectionCorner>& corners, double side,
                    FeatureLines& lines) {
    geometry::VecArray places(runtime.memory);
    for (const SectionCorner& corner : corners) places.push_back(corner.place);
    const geometry::PointGrid grid(places, feature_tuning.corner_reach * side);
    for (std::int64_t l = 0; l < lines.lines(); ++l)
        for (const std::int64_t inward : {1, -1}) {
            if (lines.closed[l] != 0) continue;
            const std::int64_t end = inward > 0 ? lines.first[l] : lines.first[l + 1] - 1;
            const std::int64_t count = lines.first[l + 1] - lines.first[l];
            double least = feature_tuning.corner_reach * side;
            const SectionCorner* nearest = nullptr;
            grid.around(lines.position[end], [&](std::int64_t at) {
                const SectionCorner& corner = corners[grid.index(at)];
                const double distance = glm::distance(corner.place, lines.position[end]);
                if (corner.level != lines.level[l] || !(distance < least)) return;
                least = distance;
                nearest = &corner;
            });
            if (nearest == nullptr) continue;
            const auto at = [&](std::int64_t k) { return lines.position[end + k * inward]; };
            std::int64_t kept = 1;
            while (kept + 1 < count && glm::dot(nearest->place - at(kept), at(kept) - at(kept + 1)) <= 0.0) ++kept;
            const glm::dvec3 inner = glm::normalize(lines.normal[end + std::min(count - 1, kept) * inward]);
            const bool is_left = glm::dot(inner, nearest->left) >= glm::dot(inner, nearest->right);
            for (std::int64_t k = 0; k < kept; ++k) {
                const double share = static_cast<double>(k) / static_cast<double>(kept);
                lines.position.set(end + k * inward, glm::mix(nearest->place, at(kept), share));
                lines.normal.set(end + k * inward, glm::mix(is_left ? nearest->left : nearest->right, inner, share));
            }
        }
}

// Open lines become one where one ends in the very place where another begins, and closed where that is its own.
SurfaceLines join(base::Memory& memory, const SurfaceLines& lines, double side) {
    const Curves& curves = lines.curves;
    const auto start = [&](std::int64_t line) { return curves.first[line]; };
    const auto last = [&](std::int64_t line) { return curves.first[line + 1] - 1; };
    base::Array<std::int64_t> after(memory, curves.count()), before(memory, curves.count()); // each line; -1: none
    std::fill(after.begin(), after.end(), -1);
    std::fill(before.begin(), before.end(), -1);
    geometry::VecArray starts(memory);
    for (std::int64_t l = 0; l < curves.count(); ++l) starts.push_back(curves.point[start(l)].position);
    const geometry::PointGrid grid(starts, side);
    for (std::int64_t l = 0; l < curves.count(); ++l) {
        if (curves.closed[l] != 0) continue;
        const glm::dvec3 end = curves.point[last(l)].position;
        grid.around(end, [&](std::int64_t at) {
            const std::int64_t next = grid.index(at);
            if (curves.closed[next] != 0 || after[l] >= 0 || before[next] >= 0 ||
                !(glm::distance(starts[next], end) <= same_place * side))
                return;
            after[l] = next;
            before[next] = l;
        });
    }
    const auto turns = [&](std::int64_t line, std::int64_t next) {
        return glm::dot(glm::normalize(curves.point[last(line)].direction()),
                        glm::normalize(curves.point[start(next)].direction())) < feature_tuning.smooth;
    };
    SurfaceLines joined(memory);
    LineBuilder builder(joined);
    // A point, a little of the way to another point if it stands beside a corner.
    const auto put = [&](std::int64_t at, std::int64_t towards) {
        const CurvePoint& p = curves.point[at];
        const glm::dvec3 way = curves.point[towards].position - p.position;
        const double length = glm::length(way);
        const double share = length > 0.0 ? std::min(0.25, feature_tuning.around_corner * side / length) : 0.0;
        builder.add(p.position + share * way, p.gradient, static_cast<double>(lines.strength[at]), p.direction());
    };
    base::Array<std::uint8_t> done(memory, curves.count());
    for (const bool from_ends : {true, false}) // then those that go round
        for (std::int64_t l = 0; l < curves.count(); ++l) {
            if (done[l] != 0 || (from_ends && (before[l] >= 0 || curves.closed[l] != 0))) continue;
            for (std::int64_t at = l; at >= 0 && done[at] == 0; at = after[at]) {
                done[at] = 1;
                const std::int64_t a = before[at];
                const std::int64_t b = after[at];
                put(start(at), start(at) + (a >= 0 && turns(a, at) ? 1 : 0));
                for (std::int64_t i = start(at) + 1; i < last(at); ++i) put(i, i);
                // At smooth joints the last point is the next line's first one.
                if (b < 0 || turns(at, b)) put(last(at), last(at) - (b < 0 ? 0 : 1));
            }
            builder.end(!from_ends);
        }
    return joined;
}

} // namespace

SurfaceLines joined_sections(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                             const glm::dvec3& plane, std::span<const double> levels, double side,
                             FeatureLines& sections) {
    HRBFNPR_ASSERT(sections.kind == FeatureKind::section && side > 0.0);
    const base::Array<SectionCorner> corners =
        find_section_corners(runtime.memory, sheets, creases, plane, levels, side);
    if (!corners.empty()) end_at_corners(runtime, corners, side, sections);
    const SurfaceLines lines = as_lines(runtime.memory, sections);
    return lines.curves.count() > 0 ? join(runtime.memory, lines, side) : SurfaceLines(runtime.memory);
}

} // namespace hrbfnpr::curves
