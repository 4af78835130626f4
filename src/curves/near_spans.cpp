// SPDX-License-Identifier: MIT
#include "curves/near_spans.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// All in sides: places in a span are no farther apart; spans that are nearer are one; crossings with edges and corners
// of triangles are found several times, this near to each other.
constexpr double spacing = 0.5;
constexpr double gap = 0.05;
constexpr double same = 1e-9;
constexpr double apart = 1e-3; // crossings between which f is asked for

} // namespace

Line::Line(const geometry::Bounds& within, const glm::dvec3& from, const glm::dvec3& to, double clear) noexcept
    : region(within), origin(to) {
    const double length = glm::distance(from, to);
    if (!(length > 0.0) || !std::isfinite(length)) return;
    direction = (from - to) / length;
    const geometry::TangentFrame frame = geometry::combing_frame(direction);
    right = frame.u;
    up = frame.r;
    low = clear;
    high = length;
    for (int axis = 0; axis < 3; ++axis) {
        const double first = region.min[axis] - origin[axis];
        const double last = region.max[axis] - origin[axis];
        if (direction[axis] == 0.0) {
            if (!(first <= 0.0 && last >= 0.0)) high = -1.0;
            continue;
        }
        const double a = first / direction[axis];
        const double b = last / direction[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    low_is_end = low == clear;
    high_is_end = high == length;
}

void SpanFinder::Range::keep(double at_zero, double slope) noexcept {
    if (slope == 0.0) {
        if (at_zero > 0.0) high = low - 1.0;
    } else if (slope > 0.0) {
        high = std::min(high, -at_zero / slope);
    } else {
        low = std::max(low, -at_zero / slope);
    }
}

// The line's part in a prism that holds the triangle and all that is no farther from it than its bulge.
void SpanFinder::look_at(const Line& line, std::int64_t triangle) {
    const std::array<glm::dvec3, 3> v = corners_of(mesh_, triangle);
    const std::array<glm::dvec3, 3> p{v[0] - line.origin, v[1] - line.origin, v[2] - line.origin};
    const double bulge = tree_.bulge(triangle);
    Range range{line.low, line.high};
    const auto keep = [&](const glm::dvec3& out, double most) { // out . (x - origin) <= most + bulge
        range.keep(-most - bulge, glm::dot(out, line.direction));
    };
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 out(0.0);
        out[axis] = 1.0;
        keep(out, std::max({p[0][axis], p[1][axis], p[2][axis]}));
        keep(-out, -std::min({p[0][axis], p[1][axis], p[2][axis]}));
    }
    if (!(range.low <= range.high)) return;
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (const double twice = glm::length(area); twice > 0.0) {
        const glm::dvec3 normal = area / twice;
        keep(normal, glm::dot(normal, p[0]));
        keep(-normal, -glm::dot(normal, p[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 out = glm::normalize(glm::cross(p[(k + 1) % 3] - p[k], normal));
            keep(out, glm::dot(out, p[k]));
        }
    }
    if (!(range.low <= range.high)) return;
    near_.push_back(range);
    // On which side of its edges the line passes, as seen along it.  All triangles of a corner see it in the same
    // place, and those of an edge find the same number with opposite signs, to the last bit: no line passes between
    // them.
    const std::array<glm::dvec2, 3> q{line.seen(p[0]), line.seen(p[1]), line.seen(p[2])};
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const glm::dvec3 side(cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1]));
    const double sum = side.x + side.y + side.z;
    const bool rising = glm::all(glm::greaterThanEqual(side, glm::dvec3(0.0)));
    const bool falling = glm::all(glm::lessThanEqual(side, glm::dvec3(0.0)));
    if (rising == falling || sum == 0.0) return;
    const double at = glm::dot(line.direction, (side.x * p[0] + side.y * p[1] + side.z * p[2]) / sum);
    if (at >= line.low && at <= line.high) crossing_.push_back({at, rising});
}

void SpanFinder::merge_ranges() noexcept {
    std::sort(near_.begin(), near_.end(),
              [](const Range& a, const Range& b) { return a.low < b.low || (a.low == b.low && a.high < b.high); });
    std::int64_t kept = 0;
    for (const Range& range : near_) {
        if (kept > 0 && range.low <= near_[kept - 1].high + gap * mesh_.side)
            near_[kept - 1].high = std::max(near_[kept - 1].high, range.high);
        else
            near_[kept++] = range;
    }
    near_.resize(kept);
}

void SpanFinder::merge_crossings() noexcept {
    std::sort(crossing_.begin(), crossing_.end(), [](const Crossing& a, const Crossing& b) {
        return a.at < b.at || (a.at == b.at && a.rising < b.rising);
    });
    std::int64_t kept = 0;
    for (const Crossing& crossing : crossing_) {
        bool known = false;
        for (std::int64_t i = kept; i-- > 0 && crossing.at - crossing_[i].at <= same * mesh_.side;)
            known = known || crossing_[i].rising == crossing.rising;
        if (!known) crossing_[kept++] = crossing;
    }
    crossing_.resize(kept);
}

// Between two crossings there is a place, so that each sheet has a part of its own.
void SpanFinder::add(const Line& line, const Range& range, std::int64_t number, Spans& found) const {
    const std::int64_t first = found.place.size();
    const double parts = std::ceil((range.high - range.low) / (spacing * mesh_.side));
    for (double k = 0.0; k < parts; ++k) found.place.push_back(range.low + (k / parts) * (range.high - range.low));
    found.place.push_back(range.high);
    std::int32_t crossings = 0;
    double before = 0.0;
    for (const Crossing& crossing : crossing_) {
        if (crossing.at < range.low || crossing.at > range.high) continue;
        if (crossings++ > 0 && crossing.at - before > apart * mesh_.side)
            found.place.push_back(0.5 * (before + crossing.at));
        before = crossing.at;
    }
    std::sort(found.place.data() + first, found.place.end());
    found.span.push_back({range.low, range.high, number, found.place.size() - first, crossings,
                          line.low_is_end && range.low == line.low, line.high_is_end && range.high == line.high});
}

void SpanFinder::find(const Line& line, std::int64_t number, Spans& found) {
    near_.clear();
    crossing_.clear();
    if (line.empty()) return;
    glm::dvec3 inverse(0.0);
    for (int axis = 0; axis < 3; ++axis)
        inverse[axis] = line.direction[axis] != 0.0 ? 1.0 / line.direction[axis] : 1e300;
    const auto meets = [&](const geometry::Bounds& box) {
        const glm::dvec3 a = (box.min - line.origin) * inverse;
        const glm::dvec3 b = (box.max - line.origin) * inverse;
        const glm::dvec3 low = glm::min(a, b);
        const glm::dvec3 high = glm::max(a, b);
        return std::max({low.x, low.y, low.z, line.low}) <= std::min({high.x, high.y, high.z, line.high});
    };
    tree_.visit(meets, [&](std::int64_t triangle) { look_at(line, triangle); });
    merge_ranges();
    merge_crossings();
    for (const Range& range : near_)
        if (range.low < range.high) add(line, range, number, found);
}

} // namespace hrbfnpr::curves
