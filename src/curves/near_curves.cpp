// SPDX-License-Identifier: MIT
#include "curves/near_curves.h"

#include <algorithm>

namespace hrbfnpr::curves {
namespace {

// Of a piece's length: a cubic between points that turns by less than a right angle is no farther from its chord.
constexpr double bulge = 0.25;
// Points before and after the guess that are tried.
constexpr std::int64_t guesses = 2;

geometry::VecArray places_of(base::Memory& memory, const Curves& curves) {
    geometry::VecArray places(memory, curves.point.size());
    for (std::int64_t i = 0; i < curves.point.size(); ++i) places.set(i, curves.point[i].position);
    return places;
}

} // namespace

NearCurves::NearCurves(base::Memory& memory, const Curves& curves, double longest, double farthest)
    : curves_(curves), curve_(memory, curves.point.size()), grid_(places_of(memory, curves), longest + farthest) {
    for (std::int64_t c = 0; c < curves.count(); ++c)
        std::fill(curve_.data() + curves.first[c], curve_.data() + curves.first[c + 1], static_cast<std::int32_t>(c));
}

// On the pieces on both sides of a point of a curve, that point itself if they are farther than `within`.
NearCurves::Foot NearCurves::foot_beside(std::int64_t point, const glm::dvec3& place, double within) const noexcept {
    const std::int64_t curve = curve_[point];
    const std::int64_t begin = curves_.first[curve];
    const std::int64_t end = curves_.first[curve + 1];
    const CurvePoint& p = curves_.point[point];
    Foot best{p.position, glm::distance(p.position, place)};
    for (const std::int64_t other : {point - 1, point + 1}) {
        std::int64_t at = other;
        if (other < begin || other >= end) {
            if (curves_.closed[curve] == 0) continue;
            at = other < begin ? end - 1 : begin;
        }
        const glm::dvec3 way = curves_.point[at].position - p.position;
        const double share = glm::dot(place - p.position, way) / glm::dot(way, way);
        if (!(share > 0.0 && share < 1.0)) continue;
        const double reach = within + bulge * glm::length(way);
        if (glm::distance(p.position + share * way, place) > reach) continue;
        const CurvePoint& q = curves_.point[at];
        const glm::dvec3 foot = other > point ? CubicPiece(p, q).at(share) : CubicPiece(q, p).at(1.0 - share);
        if (const double distance = glm::distance(foot, place); distance < best.distance) best = {foot, distance};
    }
    return best;
}

NearCurves::Foot NearCurves::nearest(const glm::dvec3& place, const glm::dvec3& along) const {
    Foot best;
    grid_.around(place, [&](std::int64_t at) {
        const std::int64_t point = grid_.index(at);
        if (!(glm::dot(curves_.point[point].direction(), along) >= 0.0)) return;
        const Foot foot = foot_beside(point, place, best.distance);
        if (foot.distance < best.distance) best = foot;
    });
    return best;
}

std::int64_t NearCurves::passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                 std::int64_t but) const {
    std::int64_t found = -1;
    grid_.around(place, [&](std::int64_t at) {
        const std::int64_t point = grid_.index(at);
        if (found < 0 && curve_[point] != but && passes(point, place, along, distance)) found = curve_[point];
    });
    return found;
}

std::int64_t NearCurves::point_by(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                  std::int64_t guess) const {
    if (guess >= 0)
        for (std::int64_t point = std::max(guess - guesses, std::int64_t{0});
             point <= std::min(guess + guesses, curves_.point.size() - 1); ++point)
            if (passes(point, place, along, distance)) return point;
    std::int64_t found = -1;
    grid_.around(place, [&](std::int64_t at) {
        const std::int64_t point = grid_.index(at);
        if (found < 0 && passes(point, place, along, distance)) found = point;
    });
    return found;
}

} // namespace hrbfnpr::curves
