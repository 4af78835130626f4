// SPDX-License-Identifier: MIT
#include "paint/points.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::paint {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

[[nodiscard]] glm::dvec3 value_at(const base::Array<double>& values, int components, std::int64_t i) noexcept {
    glm::dvec3 value(0.0);
    for (int c = 0; c < components; ++c) value[c] = values[components * i + c];
    return value;
}

// Returns where a place divides a segment, from 0 at its begin to 1 at its end.
[[nodiscard]] double share_along(const glm::dvec3& begin, const glm::dvec3& end, const glm::dvec3& place) noexcept {
    const glm::dvec3 along = end - begin;
    const double squared = glm::dot(along, along);
    return squared > 0.0 ? std::clamp(glm::dot(place - begin, along) / squared, 0.0, 1.0) : 0.0;
}

// Returns the weights of the corners of a triangle at a place of it. In a triangle without area the place divides the
// longest side.
[[nodiscard]] glm::dvec3 corner_weights(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& place) noexcept {
    const auto& [a, b, c] = corner;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double squared = glm::dot(normal, normal);
    std::array<double, 3> side{}; // the squared lengths of the sides opposite to the corners
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 along = corner[(i + 2) % 3] - corner[(i + 1) % 3];
        side[i] = glm::dot(along, along);
    }
    const auto longest = static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
    // The square of twice the area, below which the corners lie on a line up to rounding.
    if (!(squared > 1e-28 * side[longest] * side[longest])) {
        const std::size_t from = (longest + 1) % 3, to = (longest + 2) % 3;
        const double share = share_along(corner[from], corner[to], place);
        glm::dvec3 weights(0.0);
        weights[static_cast<int>(from)] = 1.0 - share;
        weights[static_cast<int>(to)] = share;
        return weights;
    }
    glm::dvec3 weights(glm::dot(glm::cross(c - b, place - b), normal), glm::dot(glm::cross(a - c, place - c), normal),
                       glm::dot(glm::cross(b - a, place - a), normal));
    weights = glm::max(weights, glm::dvec3(0.0));
    return weights / (weights.x + weights.y + weights.z);
}

} // namespace

PointValues::PointValues(const base::Work& work, const geometry::VecArray& points, FieldKind kind,
                         base::Array<double>&& values, double reach)
    : tree_(points, work.progress()), values_(std::move(values)), components_(components_of(kind)),
      reach_(reach > 0.0 ? reach : everywhere) {
    HRBFNPR_ASSERT(points.size() > 0 && values_.size() == components_ * points.size());
}

Sample PointValues::at(const glm::dvec3& place) const noexcept {
    const auto all = [](std::int64_t /*node_or_point*/) { return true; };
    std::int64_t found = -1;
    if (tree_.nearest(place, 1, all, all, &found, reach_) == 0) return {};
    if (!(glm::distance(tree_.points()[found], place) <= reach_)) return {};
    return {value_at(values_, components_, tree_.index(found)), 1.0};
}

TriangleValues::TriangleValues(const base::Work& work, base::Array<glm::dvec3>&& points,
                               base::Array<Triangle>&& triangles, FieldKind kind, base::Array<double>&& values,
                               double reach)
    : points_(std::move(points)), triangles_(std::move(triangles)), tree_(work, points_, triangles_),
      values_(std::move(values)), kind_(kind), squared_reach_(reach > 0.0 ? reach * reach : everywhere) {
    HRBFNPR_ASSERT(!triangles_.empty() && values_.size() == components_of(kind) * points_.size());
}

Sample TriangleValues::at(const glm::dvec3& place) const noexcept {
    const geometry::Bvh::Nearest nearest = tree_.nearest(place, squared_reach_);
    if (nearest.face < 0) return {};
    const Triangle& triangle = triangles_[nearest.face];
    std::array<glm::dvec3, 3> corner, value;
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = points_[triangle[i]];
        value[i] = value_at(values_, components_of(kind_), triangle[i]);
    }
    const glm::dvec3 weight = corner_weights(corner, nearest.place);
    if (kind_ == FieldKind::direction) {
        // A direction has no sign. So those of all corners are turned towards that of the nearest corner.
        const int heaviest = weight.x >= weight.y && weight.x >= weight.z ? 0 : weight.y >= weight.z ? 1 : 2;
        const glm::dvec3 leading = value[static_cast<std::size_t>(heaviest)];
        for (glm::dvec3& direction : value)
            if (glm::dot(direction, leading) < 0.0) direction = -direction;
    }
    return {weight.x * value[0] + weight.y * value[1] + weight.z * value[2], 1.0};
}

} // namespace hrbfnpr::paint
