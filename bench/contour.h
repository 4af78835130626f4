// SPDX-License-Identifier: MIT
// Which marks of a torus belong to its contour, by the torus's own equation, and which the library draws.
#pragma once

#include "analytic.h"
#include "orbit.h"
#include "painter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace bench {

// Of the torus of analytic.h, seen from a place that is higher above its plane than its tube.  With
// p = ((1 + t cos v) cos u, (1 + t cos v) sin u, t sin v) and its normal n, the contour is where
//   g = n . (p - eye) = a cos v + b sin v + t = 0,  a = 1 - (eye_x cos u + eye_y sin u),  b = -eye_z:
// for each u two v, so that it is two closed curves.
class TorusContour {
public:
    explicit TorusContour(const Lens& lens) : lens_(lens) {
        for (std::size_t side = 0; side < 2; ++side)
            for (int i = 0; i < pieces; ++i) {
                const double u = 2.0 * std::numbers::pi * i / pieces;
                image_[side].push_back(lens.image_of(place(u, height(u, side))));
            }
    }

    // Pixels from the image of a mark to that of the contour in the mark's own neighbourhood; infinity where there is
    // none.
    [[nodiscard]] double distance(const glm::dvec3& mark) const {
        double u = std::atan2(mark.y, mark.x);
        double v = std::atan2(mark.z, std::hypot(mark.x, mark.y) - 1.0);
        if (!walk(u, v) || glm::distance(place(u, v), mark) > neighbourhood)
            return std::numeric_limits<double>::infinity();
        const std::size_t side = apart(v, height(u, 0)) < apart(v, height(u, 1)) ? 0 : 1;
        const double reach = neighbourhood / (1.0 + tube * std::cos(v));
        const int first = static_cast<int>(std::floor((u - reach) / (2.0 * std::numbers::pi) * pieces));
        const int last = static_cast<int>(std::ceil((u + reach) / (2.0 * std::numbers::pi) * pieces));
        const glm::dvec2 at = lens_.image_of(mark);
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = first; i < last; ++i)
            nearest = std::min(nearest, to_segment(at, vertex(side, i), vertex(side, i + 1)));
        return nearest;
    }

    // The share of the contour's image, by length, that has one of the places within `width` pixels.
    [[nodiscard]] double covered(const std::vector<glm::dvec2>& places, double width) const {
        double whole = 0.0;
        double near = 0.0;
        for (std::size_t side = 0; side < 2; ++side)
            for (int i = 0; i < pieces; ++i) {
                const glm::dvec2 middle = 0.5 * (vertex(side, i) + vertex(side, i + 1));
                const double length = glm::distance(vertex(side, i), vertex(side, i + 1));
                whole += length;
                if (std::any_of(places.begin(), places.end(),
                                [&](const glm::dvec2& p) { return glm::distance(p, middle) <= width; }))
                    near += length;
            }
        return near / whole;
    }

private:
    static constexpr int pieces = 8192;
    static constexpr double neighbourhood = 0.6 * tube; // on the surface

    [[nodiscard]] static glm::dvec3 place(double u, double v) {
        const double ring = 1.0 + tube * std::cos(v);
        return {ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)};
    }
    [[nodiscard]] double a(double u) const { return 1.0 - lens_.eye.x * std::cos(u) - lens_.eye.y * std::sin(u); }
    [[nodiscard]] double height(double u, std::size_t side) const {
        const double b = -lens_.eye.z;
        const double open = std::acos(-tube / std::hypot(a(u), b));
        return std::atan2(b, a(u)) + (side == 0 ? open : -open);
    }
    [[nodiscard]] static double apart(double v, double w) {
        return std::abs(std::remainder(v - w, 2.0 * std::numbers::pi));
    }
    [[nodiscard]] const glm::dvec2& vertex(std::size_t side, int i) const {
        return image_[side][static_cast<std::size_t>((i % pieces + pieces) % pieces)];
    }
    [[nodiscard]] static double to_segment(const glm::dvec2& p, const glm::dvec2& from, const glm::dvec2& to) {
        const glm::dvec2 along = to - from;
        const double share = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
        return glm::distance(p, from + share * along);
    }
    // Newton's steps along the steepest change of g on the surface.
    [[nodiscard]] bool walk(double& u, double& v) const {
        for (int step = 0; step < 30; ++step) {
            const double b = -lens_.eye.z;
            const double g = a(u) * std::cos(v) + b * std::sin(v) + tube;
            if (std::abs(g) < 1e-12 * std::abs(b)) return true;
            const double ring = 1.0 + tube * std::cos(v);
            const double by_u = (lens_.eye.x * std::sin(u) - lens_.eye.y * std::cos(u)) * std::cos(v) / ring;
            const double by_v = (b * std::cos(v) - a(u) * std::sin(v)) / tube;
            const double squared = by_u * by_u + by_v * by_v;
            // No farther at a time than where the gradient is still much the same.
            const double length = std::min(1.0, 0.5 * tube * std::sqrt(squared) / std::abs(g));
            u -= length * g * by_u / squared / ring;
            v -= length * g * by_v / squared / tube;
        }
        return false;
    }

    const Lens& lens_;
    std::vector<glm::dvec2> image_[2];
};

struct Found {
    double precision = 1.0, nearly = 1.0; // within the width, and within 1.1 times
    double recall = 1.0;                  // by the contour's length
    double marks = 1.0;                   // of the marks within the width, the share that is drawn

    void take_worse(const Found& other) {
        precision = std::min(precision, other.precision);
        nearly = std::min(nearly, other.nearly);
        recall = std::min(recall, other.recall);
        marks = std::min(marks, other.marks);
    }
};

// The silhouette's marks that are drawn: how many lie within `width` pixels of their own contour, and how much of the
// contour has one of them as near as that.
[[nodiscard]] inline Found found(const std::vector<Disc>& discs, const std::vector<double>& distance,
                                 const hrbfnpr_camera& camera, double width) {
    const Lens lens(camera);
    std::vector<glm::dvec2> places;
    std::vector<bool> drawn(distance.size(), false);
    for (const Disc& disc : discs)
        if (disc.is_paper == 0 && disc.mark_class == HRBFNPR_CLASS_SILHOUETTE && disc.color[3] > 0.0F) {
            drawn[disc.id - 1] = true;
            places.emplace_back(disc.window[0], disc.window[1]);
        }
    double drawn_count = 0.0;
    double good = 0.0;
    double nearly = 0.0;
    double wanted = 0.0;
    for (std::size_t i = 0; i < distance.size(); ++i) {
        if (distance[i] <= width) wanted += 1.0;
        if (!drawn[i]) continue;
        drawn_count += 1.0;
        if (distance[i] <= width) good += 1.0;
        if (distance[i] <= 1.1 * width) nearly += 1.0;
    }
    return {drawn_count > 0.0 ? good / drawn_count : 0.0, drawn_count > 0.0 ? nearly / drawn_count : 0.0,
            TorusContour(lens).covered(places, width), good / wanted};
}

// Of each stipple of a torus.
[[nodiscard]] inline std::vector<double> contour_distances(const hrbfnpr_point_set* set, const hrbfnpr_camera& camera) {
    const hrbfnpr_point_set_info info = info_of(set);
    std::int64_t count = 0;
    const float* position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* normal = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    const Lens lens(camera);
    const TorusContour contour(lens);
    std::vector<double> distances;
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 place = glm::make_vec3(info.origin) + glm::dvec3(glm::make_vec3(position + 3 * i));
        const bool faces = std::abs(lens.facing(place, glm::make_vec3(normal + 3 * i))) > 0.7;
        distances.push_back(faces ? std::numeric_limits<double>::infinity() : contour.distance(place));
    }
    return distances;
}

} // namespace bench
