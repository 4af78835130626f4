// SPDX-License-Identifier: MIT
// 1. vertex_values: g, strength and facing at the mesh's vertices.
// 2. find_crossings: chains of edges between whose ends g changes its sign, each with the root by interpolation.
// 3. keep_candidates: the parts of chains that may become lines.
// 4. refine_crossings, refine_section: each root, brought onto the surface and to g = level.
// 5. weigh_by_drop: ridges and valleys are weaker where the curvature hardly drops beside them.
// 6. add_lines: chains are cut where they are too weak; strong and long enough parts are lines.
#include "features/feature_lines.h"

#include "curves/curves.h"
#include "curves/mesh_edges.h"
#include "features/tuning.h"
#include "surface/project.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t vertices_a_task = 4096;

struct FeatureCrossing {
    std::int32_t a, b; // vertices, a < b
    double share;      // the place on the way from a to b, in [0, 1], by interpolation
    double g_a, g_b;   // they have unlike signs, in the direction of a's
    double strength;   // linear between both
    bool counts;       // strong enough, and facing the eye
    // Directed kinds: the slope of g along the direction, summed over the triangles on both sides by area.
    double slope;
};

FeatureValue requested_value(const FeatureRequest& request, const ShapePoint& shape, const glm::dvec3& position,
                             double unit) noexcept {
    FeatureValue value = feature_value(request.kind, shape, position, request.towards, unit);
    if (request.kind == FeatureKind::apparent_ridge) value.facing -= feature_tuning.grazing;
    return value;
}

base::Array<FeatureValue> vertex_values(const base::Runtime& runtime, const FeatureSurface& surface,
                                        const FeatureRequest& request, const base::Progress& progress) {
    const SurfaceMesh& mesh = surface.mesh;
    base::Array<FeatureValue> value(runtime.memory);
    value.resize_for_overwrite(mesh.vertices());
    const bool section = request.kind == FeatureKind::section;
    HRBFNPR_ASSERT(section || surface.shape.size() == mesh.vertices());
    const double unit = surface.implicit.diagonal();
    runtime.parallel.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i)
            value[i] = section ? FeatureValue{glm::dot(request.plane, mesh.position[i]), 1.0}
                               : requested_value(request, surface.shape[i], mesh.position[i], unit);
    });
    return value;
}

// ---- Chains of crossed edges

// A root in [0, 1] of the cubic with these values and slopes at 0 and 1; the values have unlike signs.
double cubic_root(double at_0, double at_1, double slope_0, double slope_1, double start) noexcept {
    const double c2 = 3.0 * (at_1 - at_0) - 2.0 * slope_0 - slope_1;
    const double c3 = slope_0 + slope_1 - 2.0 * (at_1 - at_0);
    double low = 0.0;
    double high = 1.0;
    double s = start;
    for (int step = 0; step < 8; ++step) {
        const double g = at_0 + s * (slope_0 + s * (c2 + s * c3));
        ((g < 0.0) == (at_0 < 0.0) ? low : high) = s;
        const double newton = s - g / (slope_0 + s * (2.0 * c2 + s * 3.0 * c3));
        s = newton > low && newton < high ? newton : 0.5 * (low + high);
    }
    return s;
}

// g on the mesh. A directed g has a sign only together with a direction, as derivatives along principal directions do.
struct FeatureField {
    const SurfaceMesh& mesh;
    const base::Array<FeatureValue>& value;
    bool directed;
    double least; // strength

    [[nodiscard]] bool negative(std::int32_t vertex) const noexcept { return value[vertex].g < 0.0; }
    [[nodiscard]] bool turned(std::int32_t a, std::int32_t b) const noexcept {
        return directed && glm::dot(value[a].along, value[b].along) < 0.0;
    }
    // Both triangles of an edge say the same.
    [[nodiscard]] bool changes_sign(std::int32_t a, std::int32_t b) const noexcept {
        return negative(a) != (negative(b) != turned(a, b));
    }
    // By a cubic where gradients are known.
    [[nodiscard]] double root(std::int32_t a, std::int32_t b, double g_a, double g_b) const noexcept {
        const double linear = g_a / (g_a - g_b);
        if (!(linear >= 0.0 && linear <= 1.0)) return 0.5;
        if (directed) return linear;
        const glm::dvec3 edge = mesh.position[b] - mesh.position[a];
        const double slope_a = glm::dot(value[a].gradient, edge);
        const double slope_b = glm::dot(value[b].gradient, edge);
        return slope_a != 0.0 || slope_b != 0.0 ? cubic_root(g_a, g_b, slope_a, slope_b, linear) : linear;
    }
    [[nodiscard]] FeatureCrossing crossing(std::int64_t edge) const noexcept {
        const auto [a, b] = std::minmax({start_of(mesh, edge), end_of(mesh, edge)});
        const double g_a = value[a].g;
        const double g_b = turned(a, b) ? -value[b].g : value[b].g;
        const double s = root(a, b, g_a, g_b);
        const double strength = (1.0 - s) * value[a].strength + s * value[b].strength;
        const double facing = (1.0 - s) * value[a].facing + s * value[b].facing;
        // At a contour an apparent ridge's g has a pole, not a root.
        const bool seen = facing >= 0.0 && (!directed || (value[a].facing >= 0.0 && value[b].facing >= 0.0));
        return {a, b, s, g_a, g_b, strength, strength > 0.0 && strength >= least && seen, 0.0};
    }
    // The two edges that a line through the triangle crosses, as bits; 0: there is no line. Around an umbilic
    // directions do not return to themselves, and one or three edges are crossed.
    [[nodiscard]] std::uint8_t crossed(std::int64_t triangle) const noexcept {
        unsigned bits = 0;
        int count = 0;
        bool counts = false;
        for (unsigned k = 0; k < 3; ++k) {
            const std::int64_t edge = 3 * triangle + k;
            if (!changes_sign(start_of(mesh, edge), end_of(mesh, edge))) continue;
            bits |= 1U << k;
            ++count;
            counts = counts || crossing(edge).counts;
        }
        return count == 2 && counts ? static_cast<std::uint8_t>(bits) : std::uint8_t{0};
    }
    // The slope of the linear g along the mean direction, times twice the area.
    [[nodiscard]] double slope(std::int64_t triangle) const noexcept {
        const std::int32_t a = mesh.corner[3 * triangle];
        const std::int32_t b = mesh.corner[3 * triangle + 1];
        const std::int32_t c = mesh.corner[3 * triangle + 2];
        const double b_sign = turned(a, b) ? -1.0 : 1.0;
        const double c_sign = turned(a, c) ? -1.0 : 1.0;
        const glm::dvec3 along = value[a].along + b_sign * value[b].along + c_sign * value[c].along;
        const glm::dvec3 ab = mesh.position[b] - mesh.position[a];
        const glm::dvec3 ac = mesh.position[c] - mesh.position[a];
        const double to_b = b_sign * value[b].g - value[a].g;
        const double to_c = c_sign * value[c].g - value[a].g;
        const double bb = glm::dot(ab, ab);
        const double bc = glm::dot(ab, ac);
        const double cc = glm::dot(ac, ac);
        const double area = std::sqrt(bb * cc - bc * bc);
        const double sum =
            (cc * to_b - bc * to_c) * glm::dot(ab, along) + (bb * to_c - bc * to_b) * glm::dot(ac, along);
        return area > 0.0 ? sum / area : 0.0;
    }
};

// Undirected chains have negative g to the left, as seen from outside. Crossings that do not count are there only next
// to one that counts, to tell where between them a line ends.
Chains<FeatureCrossing> find_crossings(const base::Runtime& runtime, const FeatureField& field,
                                       const base::Progress& progress) {
    base::Array<std::uint8_t> crossed(runtime.memory);
    crossed.resize_for_overwrite(field.mesh.triangles());
    runtime.parallel.for_chunks(crossed.size(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t t = begin; t < end; ++t) crossed[t] = field.crossed(t);
    });
    const auto enters = [&](std::int64_t edge) { return field.directed || field.negative(start_of(field.mesh, edge)); };
    Chains<std::int64_t> edges = walk_chains(field.mesh, crossed, enters);
    Chains<FeatureCrossing> chains(runtime.memory);
    chains.point.reserve(edges.point.size());
    for (std::int64_t c = 0; c < edges.count(); ++c)
        for (std::int64_t i = edges.first[c]; i < edges.first[c + 1]; ++i) {
            FeatureCrossing crossing = field.crossing(edges.point[i]);
            const std::int64_t next = edges.next(c, i);
            const bool first = i == edges.first[c] && edges.closed[c] == 0; // the next one leaves the same triangle
            if (field.directed)
                crossing.slope = (first ? 0.0 : field.slope(edges.point[i] / 3)) +
                                 (next < 0 ? 0.0 : field.slope(edges.point[next] / 3));
            chains.point.push_back(crossing);
        }
    chains.first = std::move(edges.first);
    chains.closed = std::move(edges.closed);
    return chains;
}

// The parts that may become lines: of directed chains those where g rises along the direction (sign = 1) or falls (-1),
// since there what g is the derivative of has a minimum or a maximum; and of these the promising ones. weak: adds up
// the others.
Chains<FeatureCrossing> keep_candidates(const Chains<FeatureCrossing>& chains, const FeatureRequest& request,
                                        std::int64_t& weak) {
    const bool directed = is_directed(request.kind);
    const double sign = request.kind == FeatureKind::ridge ? 1.0 : -1.0; // a ridge's curvature is least
    Chains<FeatureCrossing> kept(chains.first.memory());
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        const FeatureCrossing* const crossing = chains.point.data() + chains.first[c];
        const std::int64_t count = chains.size_of(c);
        const bool closed = chains.closed[c] != 0;
        const auto is_extremum = [&](std::int64_t i) {
            if (!directed) return true;
            double sum = 0.0;
            for (std::int64_t k = i - feature_tuning.crossings_beside; k <= i + feature_tuning.crossings_beside; ++k)
                if (closed || (k >= 0 && k < count)) sum += crossing[(k + 2 * count) % count].slope;
            return sign * sum > 0.0;
        };
        for_parts(count, closed, is_extremum, [&](std::int64_t begin, std::int64_t end, bool whole) {
            double strongest = 0.0;
            for (std::int64_t i = begin; i < end; ++i) strongest = std::max(strongest, crossing[i % count].strength);
            if (strongest < feature_tuning.promising * request.upper) {
                ++weak;
                return;
            }
            for (std::int64_t i = begin; i < end; ++i) kept.point.push_back(crossing[i % count]);
            kept.end(whole);
        });
    }
    return kept;
}

// ---- Points of lines

void evaluate(const base::Runtime& runtime, const FeatureSurface& surface, const FeatureRequest& request, double level,
              const surface::Projection& at, base::Array<ShapePoint>& shape, base::Array<FeatureValue>& value,
              const base::Progress& progress) {
    const std::int64_t count = at.position.size();
    value.resize_for_overwrite(count);
    if (request.kind == FeatureKind::isophote) {
        shape.resize(count); // all that n . l needs are normals
        for (std::int64_t i = 0; i < count; ++i) shape[i].normal = glm::normalize(at.gradient[i]);
    } else {
        measure_shape(runtime, surface.source, at.position, at.gradient, shape, progress);
    }
    for (std::int64_t i = 0; i < count; ++i)
        value[i] = requested_value(request, shape[i], at.position[i], surface.implicit.diagonal());
    for (FeatureValue& v : value) v.g -= level;
}

struct FeatureSearch {
    std::int64_t crossing;
    Illinois root;   // between the shares 0 and 1 of the edge
    double smallest; // |g| at its best point
};

// The root of g on the surface between the two vertices of each edge, by the Illinois method along the edge, whose
// points are projected onto f = 0; all side by side. vertex: the values that the crossings were found from.
base::Array<FeaturePoint> refine_crossings(const base::Runtime& runtime, const FeatureSurface& surface,
                                           const FeatureRequest& request, double level,
                                           const base::Array<FeatureValue>& vertex,
                                           const base::Array<FeatureCrossing>& crossing,
                                           const base::Progress& progress) {
    const SurfaceMesh& mesh = surface.mesh;
    base::Array<FeaturePoint> points(runtime.memory, crossing.size());
    base::Array<FeatureSearch> active(runtime.memory);
    active.reserve(crossing.size());
    for (std::int64_t i = 0; i < crossing.size(); ++i) {
        const FeatureCrossing& c = crossing[i];
        const glm::dvec3 normal =
            glm::mix(glm::normalize(mesh.gradient[c.a]), glm::normalize(mesh.gradient[c.b]), c.share);
        points[i] = {glm::mix(mesh.position[c.a], mesh.position[c.b], c.share), glm::normalize(normal), c.strength,
                     glm::mix(vertex[c.a].facing, vertex[c.b].facing, c.share), false};
        active.push_back({i, Illinois(c.g_a, c.g_b), std::max(std::abs(c.g_a), std::abs(c.g_b))});
        active.back().root.trial = c.share;
    }
    surface::Projection at(runtime.memory);
    if (request.rounds <= 0) { // without any evaluation of g
        for (const FeaturePoint& p : points) at.position.push_back(p.position);
        surface::project(runtime, surface.implicit, {}, at, {});
        for (std::int64_t i = 0; i < points.size(); ++i) {
            points[i].position = at.position[i];
            points[i].resolved = at.status[i] == surface::ProjectionStatus::converged;
            if (points[i].resolved) points[i].normal = glm::normalize(at.gradient[i]);
        }
    }
    base::Array<ShapePoint> shape(runtime.memory);
    base::Array<FeatureValue> values(runtime.memory);
    for (std::int32_t round = 0; round < request.rounds && !active.empty(); ++round) {
        at.position.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const FeatureCrossing& c = crossing[active[i].crossing];
            at.position.set(i, glm::mix(mesh.position[c.a], mesh.position[c.b], active[i].root.trial));
        }
        surface::project(runtime, surface.implicit, {}, at, {});
        evaluate(runtime, surface, request, level, at, shape, values, progress);
        std::int64_t kept = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            FeatureSearch search = active[i];
            const FeatureCrossing& c = crossing[search.crossing];
            const bool turned = glm::dot(values[i].along, vertex[c.a].along) < 0.0;
            const double g = turned ? -values[i].g : values[i].g;
            if (at.status[i] != surface::ProjectionStatus::converged || !std::isfinite(g)) continue;
            const double largest = std::max(std::abs(c.g_a), std::abs(c.g_b));
            if (std::abs(g) <= search.smallest) {
                search.smallest = std::abs(g);
                FeaturePoint& p = points[search.crossing];
                const double strength = request.kind != FeatureKind::isophote ? values[i].strength : p.strength;
                p = {at.position[i], glm::normalize(at.gradient[i]), strength, values[i].facing,
                     search.smallest <= feature_tuning.acceptable * largest};
            }
            search.root.take(g);
            if (search.smallest > feature_tuning.small_enough * largest) active[kept++] = search;
        }
        active.resize(kept);
    }
    return points;
}

// The height above a plane: its zero line is a section.
class PlaneLevel final : public Level {
public:
    PlaneLevel(const implicit::Implicit& surface, const glm::dvec3& plane, double level) noexcept
        : surface_(surface), plane_(plane), level_(level) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override {
        surface_.evaluate(points, {out.value, out.gradient, {}});
        for (std::int64_t i = 0; i < points.count; ++i) {
            out.level[i] = glm::dot(plane_, {points.x[i], points.y[i], points.z[i]}) - level_;
            for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = plane_[c];
        }
    }
    void at_vertices(const base::Runtime&, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress&) const override {
        level.resize(mesh.vertices());
        for (std::int64_t i = 0; i < mesh.vertices(); ++i) level[i] = glm::dot(plane_, mesh.position[i]) - level_;
    }

private:
    const implicit::Implicit& surface_;
    glm::dvec3 plane_;
    double level_;
};

// The strength of a section is the sine of the angle between the plane and the surface.
base::Array<FeaturePoint> refine_section(const base::Runtime& runtime, const FeatureSurface& surface,
                                         const glm::dvec3& plane, double level,
                                         const base::Array<FeatureCrossing>& crossing, const base::Progress& progress) {
    base::Array<CurvePoint> at(runtime.memory, crossing.size());
    for (std::int64_t i = 0; i < crossing.size(); ++i) {
        const FeatureCrossing& c = crossing[i];
        at[i].position = glm::mix(surface.mesh.position[c.a], surface.mesh.position[c.b], c.share);
    }
    base::Array<std::uint8_t> found(runtime.memory);
    bring_to_curve(runtime, PlaneLevel(surface.implicit, plane, level),
                   {feature_tuning.section_tolerance * surface.implicit.diagonal(), surface.mesh.side}, at, found,
                   progress);
    base::Array<FeaturePoint> points(runtime.memory, crossing.size());
    for (std::int64_t i = 0; i < at.size(); ++i) {
        const glm::dvec3 n = glm::normalize(at[i].gradient);
        points[i] = {at[i].position, n, glm::length(plane - glm::dot(plane, n) * n), 1.0, found[i] != 0};
    }
    return points;
}

// Multiplies the strengths of ridges and valleys by how much the curvature drops to both sides, from 0 for none, as on
// a cylinder, to 1. The measure is 2 (1 - k' / k) / (k s)^2, which for small s is -k'' / k^3, at s = 1 / 2k, a
// turn of half a radian.
void weigh_by_drop(const base::Runtime& runtime, const FeatureSurface& surface, FeatureKind kind,
                   base::Array<FeaturePoint>& points, const base::Progress& progress) {
    const bool convex = kind == FeatureKind::ridge;
    const auto bend = [&](const ShapePoint& s) { return convex ? -s.k2 : s.k1; };
    const double least = feature_tuning.least_aside * surface.mesh.side;
    const double most = std::max(least, feature_tuning.most_aside * surface.implicit.diagonal());
    const auto measure = [&](surface::Projection& at, base::Array<ShapePoint>& shape) {
        surface::project(runtime, surface.implicit, {}, at, {});
        measure_shape(runtime, surface.source, at.position, at.gradient, shape, progress);
    };
    surface::Projection here(runtime.memory), aside(runtime.memory);
    base::Array<ShapePoint> shape(runtime.memory), beside(runtime.memory);
    for (const FeaturePoint& p : points) here.position.push_back(p.position);
    measure(here, shape);
    const auto step = [&](double curvature) {
        return curvature > 0.0 ? std::clamp(0.5 / curvature, least, most) : least;
    };
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 way = step(bend(shape[i])) * (convex ? shape[i].d2() : shape[i].d1);
        aside.position.push_back(points[i].position - way);
        aside.position.push_back(points[i].position + way);
    }
    measure(aside, beside);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const double curvature = bend(shape[i]);
        const double turn = step(curvature) * curvature;
        const double mean = 0.5 * (bend(beside[2 * i]) + bend(beside[2 * i + 1]));
        const double drop = 2.0 * (1.0 - mean / curvature) / (turn * turn);
        points[i].strength *= turn > 0.0 ? std::clamp(drop / feature_tuning.full_drop, 0.0, 1.0) : 0.0;
    }
}

// ---- Lines

// Cuts chains where points are too weak, and adds strong and long enough parts to the lines.
void add_lines(const Chains<FeatureCrossing>& chains, const base::Array<FeaturePoint>& points,
               const FeatureRequest& request, double diagonal, double gap, std::int32_t level, FeatureLines& lines) {
    HRBFNPR_ASSERT(points.size() == chains.point.size());
    const auto counts = [&](const FeaturePoint& p) {
        return p.strength > 0.0 && p.strength >= request.lower && p.facing >= 0.0 && p.resolved;
    };
    // Between a point that counts and one that does not, where the line ends by linear interpolation.
    const auto add_end = [&](const FeaturePoint& in, const FeaturePoint& out) {
        if (!out.resolved) return;
        const auto root = [](double from, double to) { return to < 0.0 && from >= 0.0 ? from / (from - to) : 1.0; };
        const double share =
            std::min(root(in.strength - request.lower, out.strength - request.lower), root(in.facing, out.facing));
        if (!(share > 0.0 && share < 1.0)) return;
        lines.point.push_back({glm::mix(in.position, out.position, share),
                               glm::normalize(glm::mix(in.normal, out.normal, share)),
                               std::max(glm::mix(in.strength, out.strength, share), 0.0)});
    };
    // The points since the last line are one, unless they are too weak or too short.
    const auto finish = [&](bool closed) {
        const std::int64_t begin = lines.first.back();
        const std::int64_t end = lines.point.size();
        double strongest = 0.0;
        double length = 0.0;
        for (std::int64_t i = begin; i < end; ++i) {
            strongest = std::max(strongest, lines.point[i].strength);
            if (i + 1 < end || closed)
                length += glm::distance(lines.point[i].position, lines.point[i + 1 < end ? i + 1 : begin].position);
        }
        const bool weak = strongest < request.upper;
        if (weak || length < request.shortest * diagonal || end < begin + (closed ? 3 : 2)) {
            ++(weak ? lines.weak : lines.small);
            return lines.point.resize(begin);
        }
        lines.end(closed);
        lines.level.push_back(level);
    };
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        const std::int64_t count = chains.size_of(c);
        const bool closed = chains.closed[c] != 0;
        const auto at = [&](std::int64_t i) -> const FeaturePoint& {
            return points[chains.first[c] + (i + count) % count];
        };
        for_parts(
            count, closed, [&](std::int64_t i) { return counts(at(i)); },
            [&](std::int64_t begin, std::int64_t end, bool whole) {
                if (!whole && (closed || begin > 0)) add_end(at(begin), at(begin - 1));
                // A vertex that the line passes is crossed by several edges: their points would say nothing of its
                // direction.
                for (std::int64_t i = begin; i < end; ++i)
                    if (lines.point.size() == lines.first.back() ||
                        !(glm::distance(at(i).position, lines.point.back().position) < gap))
                        lines.point.push_back(at(i));
                if (!whole && (closed || end < count)) add_end(at(end - 1), at(end));
                finish(whole);
            });
    }
}

} // namespace

FeatureLines find_feature_lines(const base::Runtime& runtime, const FeatureSurface& surface,
                                const FeatureRequest& request, const base::Progress& progress) {
    FeatureLines lines(runtime.memory);
    base::Array<FeatureValue> value = vertex_values(runtime, surface, request, progress);
    const bool directed = is_directed(request.kind);
    const bool has_levels = !needs_shape(request.kind) || request.kind == FeatureKind::isophote;
    constexpr std::array<double, 1> zero = {0.0};
    const std::span<const double> levels = has_levels ? request.levels : std::span<const double>(zero);
    double before = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        progress.update(static_cast<double>(k) / static_cast<double>(levels.size()));
        for (FeatureValue& v : value) v.g += before - levels[k];
        before = levels[k];
        const Chains<FeatureCrossing> chains = keep_candidates(
            find_crossings(runtime, {surface.mesh, value, directed, request.lower}, progress), request, lines.weak);
        base::Array<FeaturePoint> points =
            request.kind == FeatureKind::section
                ? refine_section(runtime, surface, request.plane, levels[k], chains.point, progress)
                : refine_crossings(runtime, surface, request, levels[k], value, chains.point, progress);
        if (request.kind == FeatureKind::ridge || request.kind == FeatureKind::valley)
            weigh_by_drop(runtime, surface, request.kind, points, progress);
        for (const FeaturePoint& p : points) lines.unresolved += p.resolved ? 0 : 1;
        add_lines(chains, points, request, surface.implicit.diagonal(), feature_tuning.least_gap * surface.mesh.side,
                  static_cast<std::int32_t>(k), lines);
    }
    return lines;
}

SurfaceLines as_lines(base::Memory& memory, const FeatureLines& features) {
    SurfaceLines lines(memory);
    LineBuilder builder(lines);
    for (std::int64_t l = 0; l < features.count(); ++l) {
        for (std::int64_t i = features.first[l]; i < features.first[l + 1]; ++i)
            builder.add(features.point[i].position, features.point[i].normal, features.point[i].strength);
        builder.end(features.closed[l] != 0);
    }
    return lines;
}

} // namespace hrbfnpr::curves
