// SPDX-License-Identifier: MIT
// The tree is built in two passes: it halves the faces by the middles of their boxes, level by level, and then computes
// the boxes from the leaves up.
#include "mesh/face_tree.h"

#include "base/select.h"

#include <utility>

namespace hrbfnpr::mesh {
namespace {

// The method of Ericson, Real-Time Collision Detection (2005), 5.1.5.
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

FaceTree::FaceTree(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle)
    : box_(work.memory), face_(work.memory), corners_(work.memory) {
    const std::int64_t count = triangle.size();
    base::Array<glm::dvec3> middle(work.memory);
    middle.resize_for_overwrite(count);
    face_.resize_for_overwrite(count);
    for (const std::int64_t face : work.over(count)) {
        const Triangle& t = triangle[face];
        const glm::dvec3 a = vertex[t[0]], b = vertex[t[1]], c = vertex[t[2]];
        middle[face] = glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c);
        face_[face] = static_cast<std::int32_t>(face);
    }
    box_.resize_for_overwrite(Range::nodes(count));
    base::Array<Range> ranges(work.memory); // the ranges of the nodes, level by level
    ranges.push_back({0, 0, count});
    for (std::int64_t first = 0, last = 1; first < last; first = std::exchange(last, ranges.size())) {
        const std::int64_t at_once = 1 + 4096 / (1 + ranges[first].end - ranges[first].begin);
        work.for_chunks(last - first, at_once, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = first + begin; i < first + end; ++i) split(middle, ranges[i]);
        });
        for (std::int64_t i = first; i < last; ++i) {
            if (ranges[i].leaf()) continue;
            ranges.push_back(ranges[i].low());
            ranges.push_back(ranges[i].high());
        }
    }
    corners_.resize_for_overwrite(count);
    for (const std::int64_t at : work.over(count)) {
        const Triangle& t = triangle[face_[at]];
        corners_[at] = {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
    }
    for (const std::int64_t i : work.over(ranges.size())) {
        // The order is from the leaves up: children come before their parents.
        set_box(ranges[ranges.size() - 1 - i]);
    }
}

FaceTree::FaceTree(base::Memory& memory, const FaceTree& all, const geometry::Bounds& box)
    : box_(memory), face_(memory), corners_(memory) {
    const auto overlaps = [&](const geometry::Bounds& one) {
        return glm::all(glm::lessThanEqual(one.min, box.max)) && glm::all(glm::lessThanEqual(box.min, one.max));
    };
    base::Array<std::int64_t> from(memory); // for each face: its place in the other tree
    base::Array<glm::dvec3> middle(memory);
    std::array<Range, geometry::most_heap_levels> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0, all.face_.size()};
    while (depth > 0) {
        const Range range = stack[--depth];
        if (!overlaps(all.box_[range.node])) continue;
        if (!range.leaf()) {
            stack[depth++] = range.high();
            stack[depth++] = range.low();
            continue;
        }
        for (std::int64_t at = range.begin; at < range.end; ++at) {
            geometry::Bounds one;
            for (const glm::dvec3& corner : all.corners_[at]) one.extend(corner);
            if (!overlaps(one)) continue;
            face_.push_back(static_cast<std::int32_t>(from.size()));
            from.push_back(at);
            middle.push_back(one.min + one.max);
        }
    }
    split_all(middle, {0, 0, face_.size()});
    corners_.resize_for_overwrite(face_.size());
    for (std::int64_t at = 0; at < face_.size(); ++at) {
        corners_[at] = all.corners_[from[face_[at]]];
        face_[at] = all.face_[from[face_[at]]];
    }
    box_.resize_for_overwrite(Range::nodes(face_.size()));
    set_boxes({0, 0, face_.size()});
}

void FaceTree::split_all(const base::Array<glm::dvec3>& middle, const Range& range) {
    if (range.leaf()) return;
    split(middle, range);
    split_all(middle, range.low());
    split_all(middle, range.high());
}

void FaceTree::set_boxes(const Range& range) noexcept {
    if (!range.leaf()) {
        set_boxes(range.low());
        set_boxes(range.high());
    }
    set_box(range);
}

void FaceTree::set_box(const Range& range) noexcept {
    geometry::Bounds& box = box_[range.node] = {};
    if (!range.leaf()) {
        const geometry::Bounds& low = box_[range.low().node];
        const geometry::Bounds& high = box_[range.high().node];
        box = {glm::min(low.min, high.min), glm::max(low.max, high.max)};
        return;
    }
    for (std::int64_t at = range.begin; at < range.end; ++at)
        for (const glm::dvec3& corner : corners_[at]) box.extend(corner);
}

// Halves a range of faces along the longest side of its box. Faces with equal middles are ordered by index.
void FaceTree::split(const base::Array<glm::dvec3>& middle, const Range& range) {
    if (range.leaf()) return;
    geometry::Bounds box;
    for (std::int64_t at = range.begin; at < range.end; ++at) box.extend(middle[face_[at]]);
    const glm::length_t axis = geometry::longest_axis(box);
    base::select(face_.begin() + range.begin, face_.begin() + range.middle(), face_.begin() + range.end,
                 [&](std::int32_t a, std::int32_t b) {
                     return middle[a][axis] < middle[b][axis] || (middle[a][axis] == middle[b][axis] && a < b);
                 });
}

FaceTree::Nearest FaceTree::nearest(const glm::dvec3& p, double limit) const noexcept {
    Nearest best;
    best.squared = limit;
    geometry::visit_nearest_first<leaf_size>(
        face_.size(), [&](std::int64_t node) { return geometry::squared_distance_to(box_[node], p); },
        [&](std::int64_t, double squared) {
            return !(squared > best.squared || (squared == best.squared && best.face >= 0));
        },
        [&](std::int64_t at) {
            const glm::dvec3 place = nearest_on_triangle(corners_[at], p);
            const double near = glm::dot(place - p, place - p);
            if (near < best.squared || (near == best.squared && best.face < 0)) best = {near, face_[at], place};
        });
    return best;
}

FaceTree::Alone FaceTree::nearest_alone(const glm::dvec3& p, double limit) const noexcept {
    constexpr double rounding = 1.0 + 1e-9; // the relative error of squared distances is less
    Alone best;
    double passes = limit; // places farther than this do not matter
    geometry::visit_nearest_first<leaf_size>(
        face_.size(), [&](std::int64_t node) { return geometry::squared_distance_to(box_[node], p); },
        [&](std::int64_t, double squared) { return squared <= passes; },
        [&](std::int64_t at) {
            const glm::dvec3 place = nearest_on_triangle(corners_[at], p);
            const double near = glm::dot(place - p, place - p);
            if (!(near <= passes)) return;
            const bool alone = near * rounding < best.squared;
            if (near < best.squared)
                best = {{near, face_[at], place}, alone};
            else
                best.alone = false;
            passes = rounding * best.squared;
        });
    return best;
}

// The method of Moeller & Trumbore 1997.
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
