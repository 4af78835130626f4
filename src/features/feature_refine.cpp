// SPDX-License-Identifier: MIT
#include "features/feature_refine.h"

#include "surface/project.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr auto batch = static_cast<std::size_t>(implicit::batch_size);

// A root is found where g is this much smaller than at the ends of its edge, and good enough if no better is found.
constexpr double small_enough = 1e-4;
constexpr double acceptable = 0.1;

// Apparent ridges end so near to the contour, as n . v: there their curvature q1 grows without bound.
constexpr double grazing = 0.02;

// The search for one root between the shares low and high of an edge.
struct FeatureSearch {
    std::int64_t crossing;
    double first;         // share of the edge to try first
    double low, high;     // shares of the edge
    double g_low, g_high; // unlike signs; Illinois halves the one that stays
    double smallest;      // |g| so far
    int side;             // which end moved last

    [[nodiscard]] double trial() const noexcept {
        if (side == 0) return first;
        const double s = low + (high - low) * (g_low / (g_low - g_high));
        return s >= low && s <= high ? s : 0.5 * (low + high);
    }
    void take(double share, double g) noexcept {
        const bool to_low = (g < 0.0) == (g_low < 0.0);
        if (to_low) {
            if (side < 0) g_high *= 0.5;
            low = share;
            g_low = g;
        } else {
            if (side > 0) g_low *= 0.5;
            high = share;
            g_high = g;
        }
        side = to_low ? -1 : 1;
    }
};

// g at the points, and for a kind that needs it all else.
void evaluate(const base::Runtime& runtime, const FeatureSurface& surface, const FeatureRequest& request, double level,
              const surface::Projection& at, base::Array<ShapePoint>& shape, base::Array<FeatureValue>& value,
              const base::Progress& progress) {
    const std::int64_t count = at.position.size();
    value.resize_for_overwrite(count);
    if (request.kind == FeatureKind::isophote) {
        for (std::int64_t i = 0; i < count; ++i) {
            ShapePoint flat; // all that n . l needs
            flat.normal = glm::normalize(at.gradient[i]);
            value[i] = requested_value(request, flat, at.position[i], 0.0);
            value[i].g -= level;
        }
        return;
    }
    if (!needs_shape(request.kind)) {
        const base::Parallel threads = request.function->concurrent() ? runtime.parallel : base::Parallel();
        threads.for_chunks(count, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
            std::array<double, batch> g;
            request.function->evaluate(
                implicit::slice({at.position.x.data(), at.position.y.data(), at.position.z.data(), count}, begin, end),
                g.data());
            for (std::int64_t i = begin; i < end; ++i) value[i] = {g[static_cast<std::size_t>(i - begin)] - level, 1.0};
        });
        return;
    }
    measure_shape(runtime, surface.source, at.position, at.gradient, shape, progress);
    const double unit = surface.implicit.diagonal();
    for (std::int64_t i = 0; i < count; ++i) {
        value[i] = requested_value(request, shape[i], at.position[i], unit);
        value[i].g -= level;
    }
}

class Refiner {
public:
    Refiner(const base::Runtime& runtime, const FeatureSurface& surface, const FeatureRequest& request, double level,
            const base::Array<FeatureValue>& vertex, const base::Array<FeatureCrossing>& crossing)
        : runtime_(runtime), surface_(surface), request_(request), level_(level), vertex_(vertex), crossing_(crossing),
          points_(runtime.memory), active_(runtime.memory), at_(runtime.memory), shape_(runtime.memory),
          value_(runtime.memory) {}

    [[nodiscard]] FeaturePoints run(const base::Progress& progress) && {
        begin();
        if (request_.rounds <= 0) project_all();
        for (std::int32_t round = 0; round < request_.rounds && !active_.empty(); ++round) this->round(progress);
        return std::move(points_);
    }

private:
    // Where the mesh has them.
    void begin() {
        const SurfaceMesh& mesh = surface_.mesh;
        active_.reserve(crossing_.size());
        for (std::int64_t i = 0; i < crossing_.size(); ++i) {
            const FeatureCrossing& c = crossing_[i];
            points_.position.push_back(glm::mix(mesh.position[c.a], mesh.position[c.b], c.share));
            points_.normal.push_back(glm::normalize(glm::mix(unit(c.a), unit(c.b), c.share)));
            points_.strength.push_back(c.strength);
            points_.facing.push_back(glm::mix(vertex_[c.a].facing, vertex_[c.b].facing, c.share));
            points_.resolved.push_back(0);
            active_.push_back({i, c.share, 0.0, 1.0, c.g_a, c.g_b, std::max(std::abs(c.g_a), std::abs(c.g_b)), 0});
        }
    }
    [[nodiscard]] glm::dvec3 unit(std::int32_t vertex) const noexcept {
        return glm::normalize(surface_.mesh.gradient[vertex]);
    }
    // Without any evaluation of g.
    void project_all() {
        std::swap(at_.position, points_.position);
        surface::project(runtime_, surface_.implicit, {}, at_, {});
        std::swap(at_.position, points_.position);
        for (std::int64_t i = 0; i < crossing_.size(); ++i) {
            points_.resolved[i] = at_.status[i] == surface::ProjectionStatus::converged ? 1 : 0;
            if (points_.resolved[i] != 0) points_.normal.set(i, glm::normalize(at_.gradient[i]));
        }
    }
    void round(const base::Progress& progress) {
        const SurfaceMesh& mesh = surface_.mesh;
        at_.position.resize(active_.size());
        for (std::int64_t i = 0; i < active_.size(); ++i) {
            const FeatureCrossing& c = crossing_[active_[i].crossing];
            at_.position.set(i, glm::mix(mesh.position[c.a], mesh.position[c.b], active_[i].trial()));
        }
        surface::project(runtime_, surface_.implicit, {}, at_, {});
        evaluate(runtime_, surface_, request_, level_, at_, shape_, value_, progress);
        std::int64_t kept = 0;
        for (std::int64_t i = 0; i < active_.size(); ++i) {
            FeatureSearch search = active_[i];
            if (goes_on(i, search)) active_[kept++] = search;
        }
        active_.resize(kept);
    }
    [[nodiscard]] bool goes_on(std::int64_t i, FeatureSearch& search) {
        if (at_.status[i] != surface::ProjectionStatus::converged) return false;
        const FeatureCrossing& c = crossing_[search.crossing];
        const FeatureValue& value = value_[i];
        const double largest = std::max(std::abs(c.g_a), std::abs(c.g_b));
        const bool turned = glm::dot(value.along, vertex_[c.a].along) < 0.0;
        const double g = turned ? -value.g : value.g;
        if (!std::isfinite(g)) return false;
        if (std::abs(g) <= search.smallest) {
            search.smallest = std::abs(g);
            points_.position.set(search.crossing, at_.position[i]);
            points_.normal.set(search.crossing, glm::normalize(at_.gradient[i]));
            if (request_.kind != FeatureKind::isophote) points_.strength[search.crossing] = value.strength;
            points_.facing[search.crossing] = value.facing;
            points_.resolved[search.crossing] = search.smallest <= acceptable * largest ? 1 : 0;
        }
        search.take(search.trial(), g);
        return search.smallest > small_enough * largest;
    }

    const base::Runtime& runtime_;
    const FeatureSurface& surface_;
    const FeatureRequest& request_;
    double level_;
    const base::Array<FeatureValue>& vertex_;
    const base::Array<FeatureCrossing>& crossing_;
    FeaturePoints points_;
    base::Array<FeatureSearch> active_;
    surface::Projection at_;
    base::Array<ShapePoint> shape_;
    base::Array<FeatureValue> value_;
};

// A batch of points on their way to where f and the plane meet.
struct Pair {
    std::array<double, batch> x, y, z, f, gx, gy, gz;

    void evaluate(const implicit::Implicit& implicit, std::int64_t count) {
        implicit::FieldBatch fields;
        fields.value = f.data();
        fields.gradient = {gx.data(), gy.data(), gz.data()};
        implicit.evaluate({x.data(), y.data(), z.data(), count}, fields);
    }
    [[nodiscard]] double height(std::size_t i, const glm::dvec3& plane, double level) const noexcept {
        return plane.x * x[i] + plane.y * y[i] + plane.z * z[i] - level;
    }
    // By what was evaluated, before the last step.
    [[nodiscard]] bool arrived(std::size_t i, const glm::dvec3& plane, double level, double tolerance) const noexcept {
        const double slope = std::sqrt(gx[i] * gx[i] + gy[i] * gy[i] + gz[i] * gz[i]);
        return std::abs(f[i]) <= tolerance * slope && std::abs(height(i, plane, level)) <= tolerance;
    }
    // The shortest step with J step = -(f, h), J = (grad f, plane); whether there is still one to take.
    [[nodiscard]] bool step(std::size_t i, const glm::dvec3& plane, double level, double tolerance) noexcept {
        const glm::dvec3 g(gx[i], gy[i], gz[i]);
        const double slope = glm::length(g);
        const double h = height(i, plane, level);
        const double d = f[i] / slope;
        if (arrived(i, plane, level, tolerance)) return false;
        const double mixed = glm::dot(g, plane) / slope;
        const double determinant = 1.0 - mixed * mixed;
        if (!(determinant > 1e-12)) return false;
        const double along_g = -(d - mixed * h) / determinant;
        const double along_plane = -(h - mixed * d) / determinant;
        x[i] += along_g * g.x / slope + along_plane * plane.x;
        y[i] += along_g * g.y / slope + along_plane * plane.y;
        z[i] += along_g * g.z / slope + along_plane * plane.z;
        return true;
    }
};

} // namespace

FeatureValue requested_value(const FeatureRequest& request, const ShapePoint& shape, const glm::dvec3& position,
                             double unit) noexcept {
    FeatureValue value = feature_value(request.kind, shape, position, request.towards, unit);
    if (request.far_side && value.facing < 0.0) {
        // Seen with the normal turned over, which changes the sign of a suggestive contour's slope.
        if (request.kind == FeatureKind::suggestive_contour) value.strength = -value.strength;
        value.facing = -value.facing;
    }
    if (request.kind == FeatureKind::apparent_ridge) value.facing -= grazing;
    return value;
}

FeaturePoints refine_crossings(const base::Runtime& runtime, const FeatureSurface& surface,
                               const FeatureRequest& request, double level, const base::Array<FeatureValue>& value,
                               const base::Array<FeatureCrossing>& crossing, const base::Progress& progress) {
    return Refiner(runtime, surface, request, level, value, crossing).run(progress);
}

FeaturePoints refine_section(const base::Runtime& runtime, const FeatureSurface& surface, const glm::dvec3& plane,
                             double level, const base::Array<FeatureCrossing>& crossing,
                             const base::Progress& progress) {
    constexpr int steps = 8;
    const double tolerance = 1e-9 * surface.implicit.diagonal();
    FeaturePoints points(runtime.memory);
    points.position.resize(crossing.size());
    points.normal.resize(crossing.size());
    points.strength.resize(crossing.size());
    points.facing.resize(crossing.size());
    points.resolved.resize(crossing.size());
    const base::Parallel threads = surface.implicit.threads(runtime.parallel);
    threads.for_chunks(crossing.size(), implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Boxed<Pair> at(runtime.memory);
        for (std::int64_t i = begin; i < end; ++i) {
            const FeatureCrossing& c = crossing[i];
            const glm::dvec3 p = glm::mix(surface.mesh.position[c.a], surface.mesh.position[c.b], c.share);
            const auto lane = static_cast<std::size_t>(i - begin);
            at->x[lane] = p.x;
            at->y[lane] = p.y;
            at->z[lane] = p.z;
        }
        bool moving = true;
        for (int step = 0; step < steps && moving; ++step) {
            at->evaluate(surface.implicit, end - begin);
            moving = false;
            for (std::int64_t i = begin; i < end; ++i)
                moving = at->step(static_cast<std::size_t>(i - begin), plane, level, tolerance) || moving;
        }
        for (std::int64_t i = begin; i < end; ++i) {
            const auto lane = static_cast<std::size_t>(i - begin);
            const glm::dvec3 n = glm::normalize(glm::dvec3(at->gx[lane], at->gy[lane], at->gz[lane]));
            points.position.set(i, {at->x[lane], at->y[lane], at->z[lane]});
            points.normal.set(i, n);
            points.strength[i] = glm::length(plane - glm::dot(plane, n) * n);
            points.facing[i] = 1.0;
            points.resolved[i] = at->arrived(lane, plane, level, tolerance) ? 1 : 0;
        }
    });
    return points;
}

void weigh_by_drop(const base::Runtime& runtime, const FeatureSurface& surface, FeatureKind kind, FeaturePoints& points,
                   const base::Progress& progress) {
    const bool convex = kind == FeatureKind::ridge;
    const auto bend = [&](const ShapePoint& s) { return convex ? -s.k2 : s.k1; };
    const std::int64_t count = points.position.size();
    const double least = 2.0 * surface.mesh.side;
    const double most = std::max(least, 0.1 * surface.implicit.diagonal());
    surface::Projection here(runtime.memory);
    for (std::int64_t i = 0; i < count; ++i) here.position.push_back(points.position[i]);
    surface::project(runtime, surface.implicit, {}, here, {});
    base::Array<ShapePoint> shape(runtime.memory);
    measure_shape(runtime, surface.source, here.position, here.gradient, shape, progress);
    surface::Projection aside(runtime.memory);
    base::Array<double> curvature(runtime.memory, count);
    base::Array<double> turn(runtime.memory, count);
    for (std::int64_t i = 0; i < count; ++i) {
        curvature[i] = bend(shape[i]);
        const double step = curvature[i] > 0.0 ? std::clamp(0.5 / curvature[i], least, most) : least;
        turn[i] = step * curvature[i];
        const glm::dvec3 along = convex ? shape[i].d2() : shape[i].d1;
        aside.position.push_back(points.position[i] - step * along);
        aside.position.push_back(points.position[i] + step * along);
    }
    surface::project(runtime, surface.implicit, {}, aside, {});
    measure_shape(runtime, surface.source, aside.position, aside.gradient, shape, progress);
    for (std::int64_t i = 0; i < count; ++i) {
        const double mean = 0.5 * (bend(shape[2 * i]) + bend(shape[2 * i + 1]));
        const double drop = 2.0 * (1.0 - mean / curvature[i]) / (turn[i] * turn[i]);
        points.strength[i] *= turn[i] > 0.0 ? std::clamp(drop / full_drop, 0.0, 1.0) : 0.0;
    }
}

} // namespace hrbfnpr::curves
