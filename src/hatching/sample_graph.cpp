// SPDX-License-Identifier: MIT
#include "hatching/sample_graph.h"

#include "base/sort.h"
#include "geometry/neighbours.h"
#include "geometry/tangent_frame.h"
#include "surface/creased.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hrbfnpr::hatching {
namespace {

constexpr std::int64_t neighbours = 8;
// Normals that differ by more, and steps that leave the tangent planes by more, belong to another sheet.
constexpr double least_cosine = 0.3;
constexpr double steepest_link = 0.5;
// In spacings: farther ones are none.
constexpr double farthest_link = 3.0;
// One look for a cancel for so many.
constexpr std::int64_t samples_a_check = 512;
constexpr std::int64_t pairs_a_check = 4096;

} // namespace

bool SampleGraph::is_linked(std::int64_t i, std::int64_t j) const noexcept {
    const glm::dvec3 way = position[j] - position[i];
    const double length = glm::length(way);
    if (!(length > 0.0 && length <= farthest_link * spacing)) return false;
    if (!(glm::dot(normal[i], normal[j]) > least_cosine)) return false;
    if (!sheet.empty() && surface::is_creased(sheet[i], sheet[j], normal[i], normal[j])) return false;
    return std::abs(glm::dot(way, normal[i])) <= steepest_link * length &&
           std::abs(glm::dot(way, normal[j])) <= steepest_link * length;
}

// By the rotation that takes one normal to the other along the shortest way.
double SampleGraph::turn(std::int64_t i, std::int64_t j) const noexcept {
    const glm::dvec3 a = normal[i];
    const glm::dvec3 b = normal[j];
    const glm::dvec3 axis = glm::cross(a, b);
    const glm::dvec3 t = u[i];
    const double cosine = glm::dot(a, b);
    const glm::dvec3 carried = t * cosine + glm::cross(axis, t) + axis * (glm::dot(axis, t) / (1.0 + cosine));
    return angle(j, carried);
}

glm::dvec3 SampleGraph::tangent(std::int64_t i, double angle) const noexcept {
    return std::cos(angle) * u[i] + std::sin(angle) * glm::cross(normal[i], u[i]);
}

double SampleGraph::angle(std::int64_t i, const glm::dvec3& tangent) const noexcept {
    return std::atan2(glm::dot(tangent, glm::cross(normal[i], u[i])), glm::dot(tangent, u[i]));
}

SampleGraph::SampleGraph(const base::Runtime& runtime, geometry::VecArray positions, geometry::VecArray normals,
                         base::Array<std::int32_t> sheets, double its_spacing, const base::Progress& progress)
    : position(std::move(positions)), normal(std::move(normals)), sheet(std::move(sheets)),
      u(runtime.memory, position.size()), spacing(its_spacing), first(runtime.memory, position.size() + 1),
      link(runtime.memory) {
    for (std::int64_t i = 0; i < size(); ++i) u.set(i, geometry::any_perpendicular(normal[i]));
    const geometry::Neighbours near(runtime.parallel, position, neighbours, progress);
    struct Pair {
        std::int64_t from, to;
        auto operator<=>(const Pair&) const = default;
    };
    base::Array<Pair> pairs(runtime.memory);
    for (std::int64_t i = 0; i < size(); ++i) {
        if (i % samples_a_check == 0) progress.check();
        for (const std::int64_t j : near.of(i)) {
            if (!is_linked(i, j)) continue;
            pairs.push_back({i, j});
            pairs.push_back({j, i});
        }
    }
    base::sort_long(pairs.begin(), pairs.end(), std::less<>(), progress); // equal ones are the same
    progress.check();
    pairs.resize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
    for (const Pair& pair : pairs) {
        if (link.size() % pairs_a_check == 0) progress.check();
        const double turned = turn(pair.from, pair.to);
        link.push_back(
            {static_cast<std::int32_t>(pair.to), static_cast<float>(turned), std::polar(1.0, -2.0 * turned)});
        first[pair.from + 1] = link.size();
    }
    for (std::int64_t i = 0; i < size(); ++i) first[i + 1] = std::max(first[i + 1], first[i]);
}

} // namespace hrbfnpr::hatching
