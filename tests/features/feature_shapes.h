// SPDX-License-Identifier: MIT
// A surface with its mesh and shape, and a measure of the distance between curves and points.
#pragma once

#include "curves/shapes.h"
#include "features/feature_lines.h"
#include "support/runtime.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hrbfnpr::curves::test_features {

using test::AnyField;
using test::Field;
using test::operator+;

// A ring whose tube is an ellipse: `wide` outwards and `high` upwards. The value is not a distance.
inline Field elliptic_torus(const glm::dvec3& p, double wide, double high) {
    const double rho = std::hypot(p.x, p.y);
    const glm::dvec3 out(p.x / rho, p.y / rho, 0.0);
    const glm::dvec3 around(-out.y, out.x, 0.0);
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const double s = (rho - 1.0) / (wide * wide);
    const double t = p.z / (high * high);
    return {s * (rho - 1.0) + t * p.z - 1.0, 2.0 * (s * out + t * up),
            test::outer(out, out, 2.0 / (wide * wide)) + test::outer(up, up, 2.0 / (high * high)) +
                test::outer(around, around, 2.0 * s / rho)};
}

inline Field ellipsoid(const glm::dvec3& p, const glm::dvec3& axes) {
    const glm::dvec3 q = p / axes;
    const glm::dvec3 w = 2.0 / (axes * axes);
    return {glm::dot(q, q) - 1.0, w * p, {w.x, 0.0, 0.0, w.y, 0.0, w.z}};
}

// Holds everything that find_feature_lines() needs. It makes its own `source` unless one is given.
struct Subject {
    Subject(const base::Runtime& runtime, const implicit::Implicit& implicit, const geometry::VecArray& seeds,
            double side, const implicit::ShapeSource* given = nullptr)
        : differenced(implicit), source(given != nullptr ? *given : differenced), surface(implicit),
          mesh(triangulate(runtime, implicit, seeds, test_shapes::settings(implicit, side))), shape(runtime.memory) {
        measure_shape(runtime, source, mesh.position, mesh.gradient, shape);
    }
    [[nodiscard]] FeatureLines find(const base::Runtime& runtime, const FeatureRequest& request) const {
        return find_feature_lines(runtime, {surface, source, mesh, shape}, request);
    }

    implicit::DifferencedShape differenced;
    const implicit::ShapeSource& source;
    const implicit::Implicit& surface;
    SurfaceMesh mesh;
    base::Array<ShapePoint> shape;
};

inline double length(const FeatureLines& lines, std::int64_t line) {
    double sum = 0.0;
    for (std::int64_t i = lines.first[line]; i < lines.first[line + 1]; ++i) {
        const bool last = i + 1 == lines.first[line + 1];
        if (last && lines.closed[line] == 0) break;
        sum += glm::distance(lines.point[i].position, lines.point[last ? lines.first[line] : i + 1].position);
    }
    return sum;
}

// A set of points that tells whether one of them is near a given point, by a brute search in slabs.
class Places {
public:
    Places(std::vector<glm::dvec3> places, double reach) : places_(std::move(places)), reach_(reach) {
        std::sort(places_.begin(), places_.end(), [](const glm::dvec3& a, const glm::dvec3& b) { return a.x < b.x; });
    }
    [[nodiscard]] bool near(const glm::dvec3& p) const {
        auto at = std::lower_bound(places_.begin(), places_.end(), p.x - reach_,
                                   [](const glm::dvec3& a, double x) { return a.x < x; });
        for (; at != places_.end() && at->x <= p.x + reach_; ++at)
            if (glm::distance(*at, p) <= reach_) return true;
        return false;
    }
    // Returns the share of `others` that are near one of the points.
    [[nodiscard]] double share(const std::vector<glm::dvec3>& others) const {
        if (others.empty()) return 0.0;
        std::int64_t count = 0;
        for (const glm::dvec3& p : others) count += near(p) ? 1 : 0;
        return static_cast<double>(count) / static_cast<double>(others.size());
    }

private:
    std::vector<glm::dvec3> places_;
    double reach_;
};

// Returns points along the polylines, at most a quarter of `step` apart, where the strength is at least `least`.
inline std::vector<glm::dvec3> along(const FeatureLines& lines, double step, double least = 0.0) {
    std::vector<glm::dvec3> result;
    for (std::int64_t line = 0; line < lines.count(); ++line) {
        const std::int64_t begin = lines.first[line];
        const std::int64_t end = lines.first[line + 1];
        for (std::int64_t i = begin; i < end; ++i) {
            const std::int64_t next = i + 1 < end ? i + 1 : lines.closed[line] != 0 ? begin : i;
            if (std::min(lines.point[i].strength, lines.point[next].strength) < least) continue;
            const glm::dvec3 a = lines.point[i].position;
            const glm::dvec3 b = lines.point[next].position;
            const int pieces = 1 + static_cast<int>(glm::distance(a, b) / (0.25 * step));
            for (int k = 0; k < pieces; ++k) result.push_back(glm::mix(a, b, static_cast<double>(k) / pieces));
        }
    }
    return result;
}

} // namespace hrbfnpr::curves::test_features
