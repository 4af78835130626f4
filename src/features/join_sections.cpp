// SPDX-License-Identifier: MIT
#include "features/join_sections.h"

#include "geometry/point_grid.h"

#include <algorithm>

namespace hrbfnpr::curves {
namespace {

// In sides.
constexpr double same_place = 1e-9;
constexpr double around_corner = 1e-4;
// The cosine of an angle between lines that is no corner.
constexpr double smooth = 0.9999;

class SectionJoiner {
public:
    SectionJoiner(base::Memory& memory, const SurfaceLines& lines, double side)
        : memory_(memory), lines_(lines), side_(side), after_(memory, lines.curves.count()),
          before_(memory, lines.curves.count()) {}

    SurfaceLines run();

private:
    [[nodiscard]] const CurvePoint& first_of(std::int64_t line) const noexcept {
        return lines_.curves.point[lines_.curves.first[line]];
    }
    [[nodiscard]] const CurvePoint& last_of(std::int64_t line) const noexcept {
        return lines_.curves.point[lines_.curves.first[line + 1] - 1];
    }
    void find_followers();
    [[nodiscard]] bool turns(std::int64_t line, std::int64_t next) const noexcept;
    void put(LineBuilder& builder, std::int64_t line) const;
    void put_point(LineBuilder& builder, std::int64_t at, std::int64_t towards) const;

    base::Memory& memory_;
    const SurfaceLines& lines_;
    double side_;
    base::Array<std::int64_t> after_, before_; // of each line; -1: none
};

void SectionJoiner::find_followers() {
    const Curves& curves = lines_.curves;
    geometry::VecArray start(memory_);
    base::Array<std::int64_t> of(memory_);
    for (std::int64_t l = 0; l < curves.count(); ++l) {
        after_[l] = before_[l] = -1;
        if (curves.closed[l] != 0) continue;
        start.push_back(first_of(l).position);
        of.push_back(l);
    }
    if (start.empty()) return;
    const geometry::PointGrid grid(start, side_);
    for (std::int64_t l = 0; l < curves.count(); ++l) {
        if (curves.closed[l] != 0) continue;
        grid.around(last_of(l).position, [&](std::int64_t at) {
            const std::int64_t next = of[grid.index(at)];
            if (after_[l] >= 0 || before_[next] >= 0 ||
                !(glm::distance(first_of(next).position, last_of(l).position) <= same_place * side_))
                return;
            after_[l] = next;
            before_[next] = l;
        });
    }
}

bool SectionJoiner::turns(std::int64_t line, std::int64_t next) const noexcept {
    return glm::dot(glm::normalize(last_of(line).direction()), glm::normalize(first_of(next).direction())) < smooth;
}

// A little of the way to another point, if it is another one.
void SectionJoiner::put_point(LineBuilder& builder, std::int64_t at, std::int64_t towards) const {
    const CurvePoint& p = lines_.curves.point[at];
    const glm::dvec3 way = lines_.curves.point[towards].position - p.position;
    const double length = glm::length(way);
    const glm::dvec3 moved = length > 0.0 ? std::min(0.25, around_corner * side_ / length) * way : way;
    builder.add(p.position + moved, p.gradient, static_cast<double>(lines_.strength[at]), p.direction());
}

// Beside corners a little of the line is left out; at smooth joints its last point is the next line's first one.
void SectionJoiner::put(LineBuilder& builder, std::int64_t line) const {
    const std::int64_t first = lines_.curves.first[line];
    const std::int64_t last = lines_.curves.first[line + 1] - 1;
    const std::int64_t before = before_[line];
    const std::int64_t after = after_[line];
    put_point(builder, first, before >= 0 && turns(before, line) ? first + 1 : first);
    for (std::int64_t i = first + 1; i < last; ++i) put_point(builder, i, i);
    if (after < 0) put_point(builder, last, last);
    if (after >= 0 && turns(line, after)) put_point(builder, last, last - 1);
}

SurfaceLines SectionJoiner::run() {
    find_followers();
    const Curves& curves = lines_.curves;
    SurfaceLines joined(memory_);
    LineBuilder builder(joined);
    base::Array<std::uint8_t> done(memory_, curves.count());
    for (const bool from_ends : {true, false}) // then those that go round
        for (std::int64_t l = 0; l < curves.count(); ++l) {
            if (done[l] != 0 || (from_ends && (before_[l] >= 0 || curves.closed[l] != 0))) continue;
            if (curves.closed[l] != 0) {
                for (std::int64_t i = curves.first[l]; i < curves.first[l + 1]; ++i) put_point(builder, i, i);
                builder.end(true);
                done[l] = 1;
                continue;
            }
            std::int64_t at = l;
            while (at >= 0 && done[at] == 0) {
                put(builder, at);
                done[at] = 1;
                at = after_[at];
            }
            builder.end(!from_ends);
        }
    return joined;
}

} // namespace

SurfaceLines join_at_corners(base::Memory& memory, const SurfaceLines& lines, double side) {
    return SectionJoiner(memory, lines, side).run();
}

} // namespace hrbfnpr::curves
