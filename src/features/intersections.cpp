// SPDX-License-Identifier: MIT
// The smooth parts of both surfaces are combined in pairs, so that each pair of functions is smooth
// (find_intersections). For each pair whose boxes overlap:
//
// 1. near_triangles finds the triangles of the first part that are near triangles of the other part.
// 2. mesh_of makes a mesh of these triangles, except those on which both surfaces coincide.
// 3. trace finds the curves f = g = 0 on this mesh, and clips them to the parts of both surfaces (BothSurfaces).
//
// Then the curves of all pairs are collected (add_curves), and those along which the surfaces nearly touch are left
// out.
#include "features/intersections.h"

#include "base/assert.h"
#include "curves/mesh_edges.h"
#include "curves/trace.h"
#include "features/contours.h"
#include "geometry/box_tree.h"
#include "implicit/evaluate_all.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace hrbfnpr::curves {
namespace {

glm::dvec3 mapped(const glm::dmat4& map, const glm::dvec3& place) noexcept {
    return glm::dvec3(map * glm::dvec4(place, 1.0));
}

// Returns a box that contains the image of a box.
geometry::Bounds mapped(const glm::dmat4& map, const geometry::Bounds& box) noexcept {
    geometry::Bounds result;
    for (int i = 0; i < 8; ++i)
        result.extend(mapped(map, glm::mix(box.min, box.max, glm::bvec3((i & 1) != 0, (i & 2) != 0, (i & 4) != 0))));
    return result;
}

bool overlap(const geometry::Bounds& a, const geometry::Bounds& b) noexcept {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

geometry::Bounds common_box(const geometry::Bounds& a, const geometry::Bounds& b) noexcept {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

// Returns the length of the longest image of a unit vector.
double stretch_of(const glm::dmat4& map) noexcept {
    return std::max(
        {glm::length(glm::dvec3(map[0])), glm::length(glm::dvec3(map[1])), glm::length(glm::dvec3(map[2]))});
}

// The sine of the least angle at which surfaces cross.
double least_sine() noexcept { return std::sin(feature_tuning.least_crossing * std::numbers::pi / 180.0); }

// Returns the sine of the angle between two surfaces with these gradients.
double sine_between(const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
}

// ---- Both surfaces

// A pair of smooth parts, in the coordinates of the first one.
struct PartPair {
    SmoothPart first, other;
    const glm::dmat4& to_other;
    const glm::dmat4& from_other;
};

// The places that are on both surfaces. Places with f = g = 0 may be beyond the end of either of them.
class BothSurfaces final : public implicit::Domain {
public:
    // Consecutive points of a curve are at most `step` apart, in the coordinates of the first part.
    BothSurfaces(const PartPair& pair, double step) noexcept
        : pair_(pair), inner_(pair.other.mesh().region.grown(-step * stretch_of(pair.to_other))) {}

    [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
        const glm::dvec3 there = mapped(pair_.to_other, place);
        const implicit::Domain* const first = pair_.first.mesh().domain;
        const implicit::Domain* const other = pair_.other.mesh().domain;
        return (first != nullptr && first->near_end(place)) || (other != nullptr && other->near_end(there)) ||
               !inner_.contains(there);
    }
    // Both domains are asked, even if only one of them may end here: a curve that has left one surface may come near
    // the end of the other one.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
        const glm::dvec3 there = mapped(pair_.to_other, place);
        const geometry::Bounds& region = pair_.other.mesh().region;
        const glm::dvec3 outside = glm::max(region.min - there, there - region.max);
        // A surface may touch the wall of its region.
        double most = std::max({outside.x, outside.y, outside.z}) - curve_tuning.close * pair_.other.mesh().side;
        if (const implicit::Domain* const first = pair_.first.mesh().domain; first != nullptr)
            most = std::max(most, first->beyond(place, gradient));
        if (const implicit::Domain* const other = pair_.other.mesh().domain; other != nullptr) {
            glm::dvec3 slope(0.0);
            pair_.other.surface().evaluate({&there.x, &there.y, &there.z, 1},
                                           {nullptr, {&slope.x, &slope.y, &slope.z}, {}});
            most = std::max(most, other->beyond(there, slope));
        }
        return most;
    }

private:
    const PartPair& pair_;
    geometry::Bounds inner_; // the part of the other region that is farther than a step from its end
};

// ---- The mesh near the other surface

geometry::Bounds box_of(const SurfaceMesh& mesh) noexcept {
    geometry::Bounds box;
    for (std::int64_t v = 0; v < mesh.vertices(); ++v) box.extend(mesh.position[v]);
    return box;
}

// Returns the triangles of the first part whose boxes overlap that of a triangle of the other part. The boxes are
// enlarged, because the surfaces bulge beyond their triangles.
base::Array<std::int64_t> near_triangles(const base::Work& work, const PartPair& pair, const geometry::Bounds& common) {
    const SurfaceMesh& mesh = pair.first.mesh();
    const SurfaceMesh& other = pair.other.mesh();
    base::Array<geometry::Bounds> boxes(work.memory); // the triangles of the other part
    for (std::int64_t t = 0; t < other.triangles(); ++t) {
        geometry::Bounds box;
        for (const glm::dvec3& corner : corners_of(other, t)) box.extend(mapped(pair.from_other, corner));
        box = box.grown(feature_tuning.crossing_reach * other.side * stretch_of(pair.from_other));
        if (overlap(box, common)) boxes.push_back(box);
    }
    const geometry::BoxTree tree(work, boxes.size(), [&](std::int64_t i) { return boxes[i]; });
    base::Array<std::int64_t> near(work.memory);
    for (const std::int64_t t : work.over(mesh.triangles())) {
        geometry::Bounds box;
        for (const glm::dvec3& corner : corners_of(mesh, t)) box.extend(corner);
        box = box.grown(feature_tuning.crossing_reach * mesh.side);
        if (!overlap(box, common)) continue;
        bool is_near = false;
        tree.visit([&](const geometry::Bounds& node) { return !is_near && overlap(node, box); },
                   [&](std::int64_t i) { is_near = is_near || overlap(boxes[i], box); });
        if (is_near) near.push_back(t);
    }
    return near;
}

// Makes a mesh of the given triangles, except those on which both surfaces coincide: there, g is only noise.
SurfaceMesh mesh_of(const base::Work& work, const SurfaceMesh& whole, const IntersectionLevel& level,
                    const base::Array<std::int64_t>& triangles) {
    SurfaceMesh mesh(work.memory);
    base::Array<std::int32_t> number(work.memory, whole.vertices()); // 1 + the index of each vertex in `mesh`
    for (const std::int64_t t : triangles)
        for (std::int64_t e = 3 * t; e < 3 * t + 3; ++e) {
            std::int32_t& own = number[whole.corner[e]];
            if (own != 0) continue;
            mesh.position.push_back(whole.position[whole.corner[e]]);
            mesh.gradient.push_back(whole.gradient[whole.corner[e]]);
            own = static_cast<std::int32_t>(mesh.position.size());
        }
    base::Array<double> value(work.memory);
    geometry::VecArray gradient(work.memory);
    level.at_places(work, mesh.position, value, gradient);
    const auto coincide = [&](std::int64_t v) {
        return std::abs(value[v]) <= feature_tuning.coincident * whole.side * glm::length(gradient[v]) &&
               !(sine_between(mesh.gradient[v], gradient[v]) > least_sine());
    };
    for (const std::int64_t t : triangles) {
        const auto corner = [&](std::int64_t k) { return number[whole.corner[3 * t + k]] - 1; };
        if (coincide(corner(0)) && coincide(corner(1)) && coincide(corner(2))) continue;
        for (std::int64_t k = 0; k < 3; ++k) mesh.corner.push_back(corner(k));
    }
    mesh.neighbour = find_neighbours(work, mesh.corner, mesh.vertices());
    mesh.region = whole.region;
    mesh.side = whole.side;
    return mesh;
}

// ---- Curves

struct PairResult {
    explicit PairResult(base::Memory& memory) noexcept : curves(memory) {}

    Curves curves;
    std::int64_t broken = 0;
};

// Returns the number of ends of curves inside both surfaces. Where the surfaces touch, curves may cross each other, and
// end there.
std::int64_t broken_ends(const Curves& curves, const BothSurfaces& both, const SurfaceMesh& mesh) {
    const geometry::Bounds inner = mesh.region.grown(-2.0 * curve_tuning.close * mesh.side);
    std::int64_t broken = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        if (curves.closed[c] != 0) continue;
        for (const std::int64_t end : {curves.first[c], curves.first[c + 1] - 1}) {
            const CurvePoint& p = curves.point[end];
            if (inner.contains(p.position) && !both.near_end(p.position) &&
                sine_between(p.gradient, p.level_gradient) > least_sine())
                ++broken;
        }
    }
    return broken;
}

void trace_pair(const base::Work& work, const PartPair& pair, const geometry::Bounds& common, PairResult& out) {
    const IntersectionLevel level(pair.first.surface(), pair.other.surface(), pair.to_other);
    const base::Array<std::int64_t> near = near_triangles(work, pair, common);
    if (near.empty()) return;
    SurfaceMesh mesh = mesh_of(work, pair.first.mesh(), level, near);
    if (mesh.triangles() == 0) return;
    // Steps are no longer than a cell of either mesh, because ends are searched within a cell.
    TraceSettings settings;
    settings.longest = std::min(1.0, pair.other.mesh().side * stretch_of(pair.from_other) / mesh.side);
    const BothSurfaces both(pair, settings.longest * mesh.side);
    mesh.domain = &both;
    // Curves outside of the other region are cut off, so they need not be followed.
    mesh.region = common_box(mesh.region, mapped(pair.from_other, pair.other.mesh().region));
    TraceReport report;
    out.curves = trace(work, level, mesh, settings, report);
    out.broken = report.missed + broken_ends(out.curves, both, mesh);
}

// Adds the curves along which the surfaces cross at a sufficient mean angle.
void add_curves(const Curves& curves, Intersections& out) {
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        double length = 0.0;
        double sum = 0.0;
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const CurvePoint& a = curves.point[curves.first[c] + k];
            const CurvePoint& b = curves.point[curves.next(c, curves.first[c] + k)];
            const double its = glm::distance(a.position, b.position);
            const auto angle = [](const CurvePoint& p) {
                return std::asin(std::min(1.0, sine_between(p.gradient, p.level_gradient)));
            };
            const double mean = 0.5 * (angle(a) + angle(b));
            if (!std::isfinite(mean)) continue;
            length += its;
            sum += its * mean;
        }
        const double angle = length > 0.0 ? sum / length * 180.0 / std::numbers::pi : 0.0;
        if (!(angle >= feature_tuning.least_crossing)) continue;
        for (std::int64_t i = curves.first[c]; i < curves.first[c + 1]; ++i)
            out.curves.point.push_back(curves.point[i]);
        out.curves.end(curves.closed[c] != 0);
        out.angle.push_back(static_cast<float>(angle));
    }
}

} // namespace

// ---- The level

void IntersectionLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    surface_.evaluate(points, {out.value, {out.gradient[0], out.gradient[1], out.gradient[2]}, {}});
    std::array<std::array<double, static_cast<std::size_t>(implicit::batch_size)>, 3> place;
    HRBFNPR_ASSERT(points.count <= implicit::batch_size);
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 there = mapped(to_other_, {points.x[i], points.y[i], points.z[i]});
        for (int c = 0; c < 3; ++c) place[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] = there[c];
    }
    other_.evaluate({place[0].data(), place[1].data(), place[2].data(), points.count},
                    {out.level, {out.level_gradient[0], out.level_gradient[1], out.level_gradient[2]}, {}});
    const glm::dmat3 back = glm::transpose(glm::dmat3(to_other_));
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 slope =
            back * glm::dvec3(out.level_gradient[0][i], out.level_gradient[1][i], out.level_gradient[2][i]);
        for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = slope[c];
    }
}

void IntersectionLevel::at_places(const base::Work& work, const geometry::VecArray& places, base::Array<double>& level,
                                  geometry::VecArray& gradient) const {
    geometry::VecArray there(work.memory, places.size());
    for (std::int64_t i = 0; i < places.size(); ++i) there.set(i, mapped(to_other_, places[i]));
    level.resize_for_overwrite(places.size());
    gradient.resize(places.size());
    implicit::evaluate_all(work, other_, there,
                           {level.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    const glm::dmat3 back = glm::transpose(glm::dmat3(to_other_));
    for (std::int64_t i = 0; i < places.size(); ++i) gradient.set(i, back * gradient[i]);
}

void IntersectionLevel::at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const {
    geometry::VecArray gradient(work.memory);
    at_places(work, mesh.position, level, gradient);
}

// ---- All pairs

bool may_intersect(const LineSet& lines, const LineSet& other, const glm::dmat4& to_other) noexcept {
    return overlap(mapped(to_other, lines.sheets().bounds()), other.sheets().bounds());
}

Intersections find_intersections(const base::Work& work, const LineSet& lines, const LineSet& other,
                                 const glm::dmat4& to_other) {
    const glm::dmat4 from_other = glm::inverse(to_other);
    Intersections out(work.memory);
    const auto boxes_of = [&](const LineSet& set, double reach, const glm::dmat4* map) {
        base::Array<geometry::Bounds> boxes(work.memory);
        for (std::int64_t p = 0; p < smooth_parts_of(set); ++p) {
            const geometry::Bounds box = box_of(SmoothPart{set, p}.mesh());
            boxes.push_back((map != nullptr ? mapped(*map, box) : box).grown(reach));
        }
        return boxes;
    };
    const base::Array<geometry::Bounds> own =
        boxes_of(lines, feature_tuning.crossing_reach * lines.mesh().side, nullptr);
    const base::Array<geometry::Bounds> others =
        boxes_of(other, feature_tuning.crossing_reach * other.mesh().side * stretch_of(from_other), &from_other);
    struct Pair {
        std::int64_t first, other;
    };
    base::Array<Pair> pairs(work.memory);
    base::List<PairResult> found(work.memory);
    for (std::int64_t i = 0; i < own.size(); ++i)
        for (std::int64_t j = 0; j < others.size(); ++j)
            if (overlap(own[i], others[j])) {
                pairs.push_back({i, j});
                found.add(work.memory);
            }
    const auto trace_at = [&](const base::Work& with, std::int64_t p) {
        const PartPair pair{{lines, pairs[p].first}, {other, pairs[p].other}, to_other, from_other};
        trace_pair(with, pair, common_box(own[pairs[p].first], others[pairs[p].other]), found[p]);
    };
    const base::Work quiet = work.without_progress();
    const base::Work threads = lines.surface().threads(other.surface().threads(quiet));
    if (pairs.size() == 1) {
        trace_at(threads, 0);
    } else {
        const base::Runtime one_thread(work, base::Parallel());
        threads.for_each(pairs.size(), [&](std::int64_t p) { trace_at(base::Work{one_thread, quiet}, p); });
    }
    for (const PairResult& pair : found) {
        add_curves(pair.curves, out);
        out.broken += pair.broken;
    }
    return out;
}

} // namespace hrbfnpr::curves
