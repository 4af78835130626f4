// SPDX-License-Identifier: MIT
#include "mesh/edge_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::mesh {
namespace {

constexpr double fine = 1e7;           // parts of a radian
constexpr double last_place = 0x1p-22; // of the largest coordinate
constexpr double most_rounding = 0.01; // radians

// -pi is pi.
std::int64_t rounded(double angle) noexcept {
    const std::int64_t half = std::llround(fine * std::numbers::pi);
    const std::int64_t parts = std::llround(fine * angle);
    return parts <= -half ? half : parts;
}

} // namespace

double coordinate_rounding(const base::Array<glm::dvec3>& vertex) noexcept {
    double largest = 0.0;
    for (const glm::dvec3& p : vertex) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return last_place * largest;
}

void EdgeAngles::measure(const Side* first, const Side* last, base::Array<Turned>& result) const {
    const glm::dvec3 from = vertex_[low(*first)];
    const glm::dvec3 axis = glm::normalize(vertex_[high(*first)] - from);
    result.clear();
    glm::dvec3 zero(0.0);
    for (const Side* side = first; side != last; ++side) {
        const glm::dvec3 way = vertex_[third(*side)] - from;
        const glm::dvec3 up = way - glm::dot(way, axis) * axis;
        const double height = glm::length(up);
        const glm::dvec3 off = up / height;
        if (side == first) zero = off;
        result.push_back({side, rounded(std::atan2(glm::dot(glm::cross(axis, zero), off), glm::dot(zero, off))),
                          fine * std::min(rounding_ / height, most_rounding)});
    }
}

bool EdgeAngles::alike(const Turned& a, const Turned& b) noexcept {
    const std::int64_t half = rounded(std::numbers::pi);
    const std::int64_t apart = half - std::abs(half - std::abs(a.angle - b.angle));
    return static_cast<double>(apart) <= a.rounding + b.rounding;
}

std::int64_t EdgeAngles::bend(const Turned& a, const Turned& b) noexcept {
    return std::abs(std::abs(a.angle - b.angle) - rounded(std::numbers::pi));
}

std::int32_t EdgeAngles::third(const Side& side) const noexcept {
    const Triangle& t = triangle_[side.face];
    return *std::find_if(t.begin(), t.end(), [&](std::int32_t v) { return v != low(side) && v != high(side); });
}

} // namespace hrbfnpr::mesh
