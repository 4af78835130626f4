// SPDX-License-Identifier: MIT
// Tells what a line of sight meets, by marching along it.
#pragma once

#include "frame/hand_made.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace hrbfnpr::testing {

// The signed distance to a closed surface.
using Solid = std::function<double(const glm::dvec3&)>;

inline Solid ball(double radius, const glm::dvec3& centre = glm::dvec3(0.0)) {
    return [=](const glm::dvec3& p) { return glm::length(p - centre) - radius; };
}
// The solid of torus().
inline Solid ring(double minor = 0.45) {
    return [=](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - minor; };
}

// The least distance of the line from p towards the eye from a solid: < 0 if the line passes through it. It is about
// equal to the distance on the screen from the solid's contour.
inline double clearance(const Solid& solid, const glm::dvec3& p, const glm::dvec3& toward, double reach = 20.0) {
    double least = std::numeric_limits<double>::infinity();
    for (double t = 0.0; t < reach;) {
        const double d = solid(p + t * toward);
        least = std::min(least, d);
        t += std::max(0.004, 0.5 * std::abs(d));
    }
    return least;
}

// Does the same for a point of the solid's own surface. The solid counts from where the line, having left the surface,
// comes near to it again.
inline double own_clearance(const Solid& solid, const glm::dvec3& p, const glm::dvec3& toward, double reach = 20.0) {
    double least = std::numeric_limits<double>::infinity();
    double before = 0.0;
    bool falls = false;
    for (double t = 0.002; t < reach;) {
        const double d = solid(p + t * toward);
        falls = falls || d < before;
        if (falls) least = std::min(least, d);
        before = d;
        t += std::max(0.004, 0.25 * std::abs(d));
    }
    return least;
}

struct Mark {
    glm::dvec3 position, normal;
};

inline Mark mark_of(const marks::PointSet& set, std::int64_t i, std::int64_t layer = 0) {
    Mark mark{};
    for (int k = 0; k < 3; ++k) {
        mark.position[k] = static_cast<double>(set.layers[layer].position[3 * i + k]) + set.origin[k];
        mark.normal[k] = static_cast<double>(set.layers[layer].normal[3 * i + k]);
    }
    return mark;
}

// The visible share of each mark's ink, by its id; < 0: not drawn.
inline std::vector<float> seen_share(const DrawnFrame& frame, std::int64_t marks) {
    std::vector<float> share(static_cast<std::size_t>(marks) + 1, -1.0F);
    for (const Disc& disc : frame.discs()) share[disc.id] = disc.color.w;
    return share;
}

// All front marks are ink; only hidden surfaces decide which are shown.
inline Style all_front(frame::HiddenLines hidden_lines) {
    Style style;
    style.hidden_lines = hidden_lines;
    style.tone = frame::Tone::none;
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    style.contour_kinds = 0;
    return style;
}

// An orthographic camera far away from the origin in this direction.
inline frame::Camera camera_from(const glm::dvec3& toward, int pixels, double half) {
    frame::Camera camera = front_camera(pixels, pixels, half);
    const glm::dvec3 up = std::abs(toward.z) < 0.9 * glm::length(toward) ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    camera.view = frame::look_at(10.0 * glm::normalize(toward), glm::dvec3(0.0), up);
    return camera;
}

inline glm::dmat4 shifted(const glm::dvec3& by) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

} // namespace hrbfnpr::testing
