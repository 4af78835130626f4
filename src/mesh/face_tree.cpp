// SPDX-License-Identifier: MIT
#include "mesh/face_tree.h"

namespace hrbfnpr::mesh {
namespace {

// Ericson, Real-Time Collision Detection (2005), 5.1.5.
[[nodiscard]] glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& v, const glm::dvec3& p) noexcept {
    const glm::dvec3 ab = v[1] - v[0], ac = v[2] - v[0];
    const glm::dvec3 ap = p - v[0], bp = p - v[1], cp = p - v[2];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return v[0];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return v[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return v[0] + (d1 / (d1 - d3)) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return v[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return v[0] + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return v[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (v[2] - v[1]);
    const double sum = va + vb + vc;
    return v[0] + ab * (vb / sum) + ac * (vc / sum);
}

} // namespace

FaceTree::FaceTree(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                   const base::Array<Triangle>& triangle, const base::Progress& progress)
    : box_(runtime.memory), face_(runtime.memory), corners_(runtime.memory) {
    const std::int64_t count = triangle.size();
    base::Array<glm::dvec3> middle(runtime.memory);
    middle.resize_for_overwrite(count);
    face_.resize_for_overwrite(count);
    for (std::int64_t face = 0; face < count; ++face) {
        const Triangle& t = triangle[face];
        if (face % 16384 == 0) progress.check();
        const glm::dvec3 a = vertex[t[0]], b = vertex[t[1]], c = vertex[t[2]];
        middle[face] = glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c);
        face_[face] = static_cast<std::int32_t>(face);
    }
    std::int64_t nodes = 1;
    for (std::int64_t longest = count; longest > leaf_size; longest = (longest + 1) / 2) nodes = 2 * nodes + 1;
    box_.resize_for_overwrite(nodes);
    // The upper levels one after the other, what is below them side by side.
    constexpr std::int64_t upper = 4;
    std::array<Range, 1U << upper> below{Range{0, 0, count}};
    std::int64_t parts = 1;
    for (std::int64_t level = 0; level < upper && !below[0].leaf(); ++level) {
        progress.check();
        runtime.parallel.for_each(parts, [&](std::int64_t i) { split(middle, below[static_cast<std::size_t>(i)]); });
        for (std::int64_t i = parts - 1; i >= 0; --i) {
            const Range range = below[static_cast<std::size_t>(i)];
            below[static_cast<std::size_t>(2 * i)] = range.low();
            below[static_cast<std::size_t>(2 * i + 1)] = range.high();
        }
        parts *= 2;
    }
    const auto build = [&](auto&& self, const Range& range) -> void {
        if (range.leaf()) return;
        if (range.end - range.begin > 4096) progress.check();
        split(middle, range);
        self(self, range.low());
        self(self, range.high());
    };
    runtime.parallel.for_each(parts, [&](std::int64_t i) { build(build, below[static_cast<std::size_t>(i)]); });
    corners_.resize_for_overwrite(count);
    for (std::int64_t at = 0; at < count; ++at) {
        if (at % 16384 == 0) progress.check();
        const Triangle& t = triangle[face_[at]];
        corners_[at] = {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
    }
    bound({0, 0, count}, progress);
}

// Halves a range along its longest side. Equal middles are ordered by number.
void FaceTree::split(const base::Array<glm::dvec3>& middle, const Range& range) {
    if (range.leaf()) return;
    geometry::Bounds box;
    for (std::int64_t at = range.begin; at < range.end; ++at) box.extend(middle[face_[at]]);
    const glm::dvec3 size = box.size();
    const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::nth_element(face_.begin() + range.begin, face_.begin() + range.middle(), face_.begin() + range.end,
                     [&](std::int32_t a, std::int32_t b) {
                         return middle[a][axis] < middle[b][axis] || (middle[a][axis] == middle[b][axis] && a < b);
                     });
}

void FaceTree::bound(const Range& range, const base::Progress& progress) {
    if (range.end - range.begin > 4096) progress.check();
    geometry::Bounds box;
    if (range.leaf()) {
        for (std::int64_t at = range.begin; at < range.end; ++at)
            for (const glm::dvec3& corner : corners_[at]) box.extend(corner);
    } else {
        bound(range.low(), progress);
        bound(range.high(), progress);
        const geometry::Bounds& low = box_[range.low().node];
        const geometry::Bounds& high = box_[range.high().node];
        box = {glm::min(low.min, high.min), glm::max(low.max, high.max)};
    }
    box_[range.node] = box;
}

FaceTree::Nearest FaceTree::nearest(const glm::dvec3& p, double limit) const noexcept {
    struct Waiting {
        Range range;
        double squared;
    };
    Nearest best;
    best.squared = limit;
    std::array<Waiting, stack_size> stack;
    std::size_t depth = 0;
    stack[depth++] = {{0, 0, face_.size()}, squared_distance_to_box(p, 0)};
    while (depth > 0) {
        const auto [range, squared] = stack[--depth];
        if (squared > best.squared || (squared == best.squared && best.face >= 0)) continue;
        if (!range.leaf()) {
            const Waiting low{range.low(), squared_distance_to_box(p, range.low().node)};
            const Waiting high{range.high(), squared_distance_to_box(p, range.high().node)};
            const bool low_first = low.squared <= high.squared;
            stack[depth++] = low_first ? high : low;
            stack[depth++] = low_first ? low : high;
            continue;
        }
        for (std::int64_t at = range.begin; at < range.end; ++at) {
            const glm::dvec3 place = nearest_on_triangle(corners_[at], p);
            const double near = glm::dot(place - p, place - p);
            if (near < best.squared || (near == best.squared && best.face < 0)) best = {near, face_[at], place};
        }
    }
    return best;
}

// Moeller & Trumbore 1997.
double FaceTree::meet(const Corners& p, const glm::dvec3& origin, const glm::dvec3& direction) noexcept {
    const glm::dvec3 ab = p[1] - p[0];
    const glm::dvec3 ac = p[2] - p[0];
    const glm::dvec3 across = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, across);
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (determinant == 0.0) return none;
    const glm::dvec3 way = origin - p[0];
    const double u = glm::dot(way, across) / determinant;
    if (!(u >= 0.0 && u <= 1.0)) return none;
    const glm::dvec3 q = glm::cross(way, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (!(v >= 0.0 && u + v <= 1.0)) return none;
    return glm::dot(ac, q) / determinant;
}

FaceTree::Hit FaceTree::first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                  double t_max) const noexcept {
    Hit first;
    double limit = t_max;
    walk<true>(origin, direction, t_min, limit, [&](std::int64_t at, double t) {
        limit = t;
        first = {t, face_[at]};
    });
    return first;
}

} // namespace hrbfnpr::mesh
