// SPDX-License-Identifier: MIT
// Shape:
// 1. shape_point, measure_shape compute curvatures and their derivatives from derivatives of f up to the third.
// 2. measured_mesh measures a copy of the mesh at its vertices. In each of several rounds it halves edges along which a
//    curvature does not change as its derivatives at both ends predict, and measures the middles.
// 3. feature_value computes g, strength and direction of each kind of line from a measured point.
//
// Lines:
// 1. vertex_values computes g, strength and facing at the mesh's vertices.
// 2. find_crossings makes chains of edges on which g changes its sign, each with the root by interpolation.
// 3. keep_candidates selects the parts of chains that may become lines.
// 4. refine_crossings, refine_section bring each root onto the surface and to g = level.
// 5. weigh_by_drop weakens ridges and valleys if the curvature hardly drops on their sides.
// 6. add_lines cuts chains where they are too weak, and makes lines of strong and long enough parts.
#include "features/feature_lines.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "curves/curves.h"
#include "curves/mesh_edges.h"
#include "features/tuning.h"
#include "geometry/tangent_frame.h"
#include "implicit/evaluate_all.h"
#include "surface/curvature.h"
#include "surface/project.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace hrbfnpr::curves {
namespace {

// ---- Shape

// The number of points that a task measures. It is small because third derivatives, which are sums over 100 000
// centres, take half a millisecond per point.
constexpr std::int64_t points_a_look = 32;
using ShapeColumn = std::array<double, static_cast<std::size_t>(points_a_look)>;

glm::dvec3 times(const std::array<double, 6>& h, const glm::dvec3& v) noexcept {
    return {h[0] * v.x + h[1] * v.y + h[2] * v.z, h[1] * v.x + h[3] * v.y + h[4] * v.z,
            h[2] * v.x + h[4] * v.y + h[5] * v.z};
}

// Returns T(v, ., .) as a symmetric matrix, where T is the tensor of third derivatives.
std::array<double, 6> contracted(const std::array<double, 10>& t, const glm::dvec3& v) noexcept {
    return {t[0] * v.x + t[1] * v.y + t[2] * v.z, t[1] * v.x + t[3] * v.y + t[4] * v.z,
            t[2] * v.x + t[4] * v.y + t[5] * v.z, t[3] * v.x + t[6] * v.y + t[7] * v.z,
            t[4] * v.x + t[7] * v.y + t[8] * v.z, t[5] * v.x + t[8] * v.y + t[9] * v.z};
}

struct ShapeBatch {
    std::array<ShapeColumn, 6> hessian;
    std::array<ShapeColumn, 10> third;

    [[nodiscard]] implicit::ThirdBatch out() noexcept {
        implicit::ThirdBatch to;
        for (std::size_t c = 0; c < hessian.size(); ++c) to.hessian[c] = hessian[c].data();
        for (std::size_t c = 0; c < third.size(); ++c) to.third[c] = third[c].data();
        return to;
    }
    [[nodiscard]] ShapePoint at(std::size_t i, const glm::dvec3& gradient) const noexcept {
        std::array<double, 6> h;
        std::array<double, 10> t;
        for (std::size_t c = 0; c < h.size(); ++c) h[c] = hessian[c][i];
        for (std::size_t c = 0; c < t.size(); ++c) t[c] = third[c][i];
        return shape_point(gradient, h, t);
    }
};

// Returns the derivatives of II(u, v) = -H(u, v) / |g| along w, for tangent vectors u and v that stay tangent.
// g, H and T are the first, second and third derivatives of f, and n = g / |g|.
//
// With D_w n = P H w / |g| and D_w |g| = H(n, w), the projections onto the tangent plane in -P H P / |g| add
//  C(u, v, w) = -T(u, v, w) / |g| + (H(u, w) H(n, v) + H(v, w) H(n, u) + H(u, v) H(n, w)) / |g|^2,
// which is symmetric, as Codazzi's equations require.
//
// [Rusinkiewicz 2004 has the case of a mesh.]
std::array<double, 4> change_of_curvature(const std::array<glm::dvec3, 2>& d, const glm::dvec2& bend,
                                          const glm::dvec2& normal_part, const std::array<double, 10>& third,
                                          double slope) noexcept {
    const std::array<double, 6> first = contracted(third, d[0]);
    const std::array<double, 6> other = contracted(third, d[1]);
    const glm::dvec3 first1 = times(first, d[0]);
    const glm::dvec3 other2 = times(other, d[1]);
    // In principal directions, H(d_i, d_j) / |g| is -k_i if i = j, else 0. normal_part is H(n, d_i) / |g|.
    return {-glm::dot(first1, d[0]) / slope - 3.0 * bend.x * normal_part.x,
            -glm::dot(first1, d[1]) / slope - bend.x * normal_part.y,
            -glm::dot(other2, d[0]) / slope - bend.y * normal_part.x,
            -glm::dot(other2, d[1]) / slope - 3.0 * bend.y * normal_part.y};
}

// ---- The mesh

constexpr std::int64_t edges_a_task = 8192;

double largest_change(const ShapePoint& s) noexcept {
    return std::max({std::abs(s.c[0]), std::abs(s.c[1]), std::abs(s.c[2]), std::abs(s.c[3])});
}

// The second fundamental form for an edge's direction and the direction across it, and its derivatives along the edge.
struct AlongEdge {
    std::array<double, 3> value;
    std::array<double, 3> change;

    AlongEdge(const ShapePoint& s, const glm::dvec3& edge) noexcept {
        const glm::dvec2 u = s.in_tangent(edge);
        const glm::dvec2 w(-u.y, u.x);
        value = {glm::dot(s.bend(u), u), glm::dot(s.bend(u), w), glm::dot(s.bend(w), w)};
        change = {glm::dot(s.change(u, u), u), glm::dot(s.change(u, u), w), glm::dot(s.change(w, w), u)};
    }
};

// Returns whether the change of the second fundamental form between two vertices differs too much from the integral of
// its derivatives by the trapezoid rule. If the form has the error e and changes at the rate C along the surface, its
// zeros are off by at most e / C. In fact they are off by less, because g is a cubic along edges.
bool is_rough(const ShapePoint& a, const ShapePoint& b, const glm::dvec3& edge, double least, double place) noexcept {
    const AlongEdge from(a, edge);
    const AlongEdge to(b, edge);
    double off = 0.0;
    for (std::size_t i = 0; i < from.value.size(); ++i)
        off = std::max(off, std::abs(to.value[i] - from.value[i] - 0.5 * (from.change[i] + to.change[i])));
    const double change = std::max({largest_change(a), largest_change(b), least});
    return off > place * change * glm::dot(edge, edge);
}

base::Array<std::int64_t> find_rough_edges(const base::Work& work, const ShapedMesh& shaped, double place) {
    const SurfaceMesh& mesh = shaped.mesh;
    HRBFNPR_ASSERT(shaped.shape.size() == mesh.vertices());
    double sum = 0.0;
    for (const ShapePoint& s : shaped.shape) sum += largest_change(s) * largest_change(s);
    const double least =
        feature_tuning.least_change * std::sqrt(sum / std::max(1.0, static_cast<double>(shaped.shape.size())));
    base::Array<std::uint8_t> rough(work.memory);
    rough.resize_for_overwrite(mesh.corner.size());
    work.for_chunks(rough.size(), edges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t e = begin; e < end; ++e) {
            const std::int32_t a = start_of(mesh, e);
            const std::int32_t b = end_of(mesh, e);
            rough[e] = is_first(mesh, e) &&
                       is_rough(shaped.shape[a], shaped.shape[b], mesh.position[b] - mesh.position[a], least, place);
        }
    });
    base::Array<std::int64_t> edges(work.memory);
    for (const std::int64_t e : work.over(rough.size())) {
        if (rough[e] != 0) edges.push_back(e);
    }
    return edges;
}

template <class T>
void copy(const base::Array<T>& from, base::Array<T>& to, const base::Progress& progress) {
    base::resize_long(to, from.size(), progress);
    std::copy(from.begin(), from.end(), to.begin());
}
void copy(const geometry::VecArray& from, geometry::VecArray& to, const base::Progress& progress) {
    copy(from.x, to.x, progress);
    copy(from.y, to.y, progress);
    copy(from.z, to.z, progress);
}

// ---- Feature values

// The unit direction v to the eye, split into its tangent part w and its normal part.
struct ViewAtPoint {
    glm::dvec2 w;
    double facing;   // n . v
    double nearness; // 1 / distance to the eye; 0: infinitely far

    ViewAtPoint(const ShapePoint& shape, const glm::dvec3& position, const glm::dvec4& towards) noexcept {
        const glm::dvec3 v = glm::dvec3(towards) - towards.w * position;
        const double length = glm::length(v);
        const double inverse = length > 0.0 ? 1.0 / length : 0.0;
        w = shape.in_tangent(inverse * v);
        facing = glm::dot(shape.normal, inverse * v);
        nearness = std::abs(towards.w) * inverse;
    }
    // The derivative of w along the surface, a symmetric map: D_u n = -bend(u), and v turns by -(u - v (v . u)) /
    // distance.
    [[nodiscard]] glm::dvec2 turn(const ShapePoint& shape, const glm::dvec2& u) const noexcept {
        return facing * shape.bend(u) - nearness * (u - glm::dot(w, u) * w);
    }
    [[nodiscard]] glm::dvec2 gradient_of_facing(const ShapePoint& shape) const noexcept {
        return nearness * facing * w - shape.bend(w);
    }
};

// Let B = -II, so that a ball has B > 0. The line is B(w, w) = 0 where D_w (B(w, w)) > 0, with
//   D_w (B(w, w)) = -C(w, w, w) - 2 (n . v) |B w|^2   [DeCarlo 2003, appendix].
FeatureValue suggestive(const ShapePoint& shape, const ViewAtPoint& view, double unit) noexcept {
    const glm::dvec2 bent = shape.bend(view.w);
    const double sine2 = glm::dot(view.w, view.w);
    const double rise = -glm::dot(shape.change(view.w, view.w), view.w) - 2.0 * view.facing * glm::dot(bent, bent);
    FeatureValue value;
    value.g = -glm::dot(bent, view.w);
    value.strength = sine2 > 1e-12 ? rise / sine2 * unit * unit : 0.0;
    value.facing = view.facing;
    value.gradient = shape.in_space(-shape.change(view.w, view.w) - 2.0 * view.turn(shape, bent));
    return value;
}

// Convex and concave crests have separate directions, so nothing changes abruptly where |k1| = |k2|.
FeatureValue crest(const ShapePoint& shape, bool convex, double unit) noexcept {
    FeatureValue value;
    value.along = convex ? shape.d2() : shape.d1;
    value.g = convex ? shape.c[3] : shape.c[0];
    value.strength = (convex ? -shape.k2 - std::abs(shape.k1) : shape.k1 - std::abs(shape.k2)) * unit;
    return value;
}

// The turn of the normal per unit of length in the image is Q = II P^-1, where P maps tangent vectors to the image
// plane through the point.  P shortens w by n . v, so that P^-1 P^-T = M = I + w w^T / (n . v)^2.  q1^2 is the larger
// eigenvalue of Q Q^T = II M II, with eigenvector x; t1 = Q^T x / q1 corresponds to s = M II x / q1 on the surface.
//   D_s q1^2 = 2 q1 C(x, s, s) + y^T (D_s M) y,     y = II x
FeatureValue apparent_ridge(const ShapePoint& shape, const ViewAtPoint& view, double unit) noexcept {
    FeatureValue value;
    value.facing = view.facing;
    const double facing = std::copysign(std::max(std::abs(view.facing), 1e-6), view.facing);
    const double inverse = 1.0 / facing;
    const glm::dvec2 m = inverse * view.w; // the vector m with M = I + m m^T
    const glm::dvec2 bm = shape.bend(m);
    const surface::Eigen2 eigen =
        surface::symmetric_eigen2(shape.k1 * shape.k1 + bm.x * bm.x, bm.x * bm.y, shape.k2 * shape.k2 + bm.y * bm.y);
    const glm::dvec2 x(eigen.cosine, eigen.sine);
    const glm::dvec2 y = shape.bend(x);
    const glm::dvec2 qs = y + glm::dot(m, y) * m; // q1 s
    const double length = glm::length(qs);
    if (!(length > 0.0)) return value;
    const glm::dvec2 s = qs / length;
    const double facing_change = glm::dot(view.gradient_of_facing(shape), s);
    const glm::dvec2 m_change = inverse * (view.turn(shape, s) - facing_change * m);
    value.g = 2.0 * (glm::dot(shape.change(x, s), qs) + glm::dot(y, m_change) * glm::dot(y, m));
    // The factor keeps the magnitude of g at that of a curvature as `facing` approaches 0.
    value.g *= std::abs(facing * facing * facing);
    value.along = shape.in_space(s);
    value.strength = std::sqrt(eigen.high) * unit;
    return value;
}

FeatureValue parabolic(const ShapePoint& shape, double unit) noexcept {
    const glm::dvec2 gradient =
        shape.k2 * glm::dvec2(shape.c[0], shape.c[1]) + shape.k1 * glm::dvec2(shape.c[2], shape.c[3]);
    return {shape.k1 * shape.k2 * unit * unit, glm::length(gradient) * unit * unit * unit, 1.0, glm::dvec3(0.0),
            unit * unit * shape.in_space(gradient)};
}

// ---- Values at the vertices

constexpr std::int64_t elements_a_task = 4096;

FeatureValue requested_value(const FeatureRequest& request, const ShapePoint& shape, const glm::dvec3& position,
                             double unit) noexcept {
    FeatureValue value = feature_value(request.kind, shape, position, request.towards, unit);
    if (request.kind == FeatureKind::apparent_ridge) value.facing -= feature_tuning.grazing;
    return value;
}

base::Array<FeatureValue> vertex_values(const base::Work& work, const FeatureSurface& surface,
                                        const FeatureRequest& request) {
    const SurfaceMesh& mesh = surface.mesh;
    base::Array<FeatureValue> value(work.memory);
    value.resize_for_overwrite(mesh.vertices());
    const bool section = request.kind == FeatureKind::section;
    HRBFNPR_ASSERT(section || surface.shape.size() == mesh.vertices());
    const double unit = surface.implicit.diagonal();
    work.for_chunks(mesh.vertices(), elements_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            value[i] = section ? FeatureValue{glm::dot(request.plane, mesh.position[i]), 1.0}
                               : requested_value(request, surface.shape[i], mesh.position[i], unit);
    });
    return value;
}

// ---- Chains of crossed edges

// Finds a root in [0, 1] of a cubic, given by its values and slopes at 0 and 1. The values have different signs.
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

// The values of g on the mesh. For directed kinds the sign of g depends on the sign of a principal direction.
struct FeatureField {
    const SurfaceMesh& mesh;
    const base::Array<FeatureValue>& value;
    bool directed;
    double least; // the least strength of a line

    [[nodiscard]] bool negative(std::int32_t vertex) const noexcept { return value[vertex].g < 0.0; }
    [[nodiscard]] bool turned(std::int32_t a, std::int32_t b) const noexcept {
        return directed && glm::dot(value[a].along, value[b].along) < 0.0;
    }
    // Returns whether g changes its sign along the edge. The result is the same for both triangles of the edge.
    [[nodiscard]] bool changes_sign(std::int32_t a, std::int32_t b) const noexcept {
        return negative(a) != (negative(b) != turned(a, b));
    }
    // Returns the root of g on the edge. It uses a cubic where gradients are known.
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
        // At a contour the g of an apparent ridge has a pole and not a root.
        const bool seen = facing >= 0.0 && (!directed || (value[a].facing >= 0.0 && value[b].facing >= 0.0));
        return {edge, a, b, s, g_a, g_b, strength, strength > 0.0 && strength >= least && seen, 0.0};
    }
    // Returns, as bits, the two edges of the triangle that a line crosses; 0: no line. Around an umbilic a direction
    // may return reversed, so that one or three edges are crossed.
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
    // Returns twice the triangle's area times the slope of the linearly interpolated g along the mean direction.
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

// Finds the chains. In chains of undirected kinds, g is negative to the left, as seen from outside. Crossings that do
// not count are included only next to a crossing that counts, because a line ends between the two.
Chains<FeatureCrossing> find_crossings(const base::Work& work, const FeatureField& field) {
    base::Array<std::uint8_t> crossed(work.memory);
    crossed.resize_for_overwrite(field.mesh.triangles());
    work.for_chunks(crossed.size(), elements_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) crossed[t] = field.crossed(t);
    });
    const auto enters = [&](std::int64_t edge) { return field.directed || field.negative(start_of(field.mesh, edge)); };
    Chains<std::int64_t> edges = walk_chains(field.mesh, crossed, enters);
    Chains<FeatureCrossing> chains(work.memory);
    chains.point.reserve(edges.point.size());
    for (std::int64_t c = 0; c < edges.count(); ++c)
        for (std::int64_t i = edges.first[c]; i < edges.first[c + 1]; ++i) {
            FeatureCrossing crossing = field.crossing(edges.point[i]);
            const std::int64_t next = edges.next(c, i);
            // The first two edges of an open chain belong to the same triangle, whose slope must count only once.
            const bool first = i == edges.first[c] && edges.closed[c] == 0;
            if (field.directed)
                crossing.slope = (first ? 0.0 : field.slope(edges.point[i] / 3)) +
                                 (next < 0 ? 0.0 : field.slope(edges.point[next] / 3));
            chains.point.push_back(crossing);
        }
    chains.first = std::move(edges.first);
    chains.closed = std::move(edges.closed);
    return chains;
}

// Keeps the parts of chains that may become lines. On chains of directed kinds, g must rise along the direction (sign =
// 1) or fall (-1), so that the function whose derivative is g has a minimum or a maximum. The strength must also be
// promising; `weak` counts the parts that fail this.
Chains<FeatureCrossing> keep_candidates(const Chains<FeatureCrossing>& chains, const FeatureRequest& request,
                                        std::int64_t& weak) {
    const bool directed = is_directed(request.kind);
    const double sign = request.kind == FeatureKind::ridge ? 1.0 : -1.0; // on a ridge the curvature k2 has a minimum
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

void evaluate(const base::Work& work, const FeatureSurface& surface, const FeatureRequest& request, double level,
              const surface::Projection& at, base::Array<ShapePoint>& shape, base::Array<FeatureValue>& value) {
    const std::int64_t count = at.position.size();
    value.resize_for_overwrite(count);
    if (request.kind == FeatureKind::isophote) {
        shape.resize(count); // isophotes need only normals
        for (std::int64_t i = 0; i < count; ++i) shape[i].normal = glm::normalize(at.gradient[i]);
    } else {
        measure_shape(work, surface.source, at.position, at.gradient, shape);
    }
    for (std::int64_t i = 0; i < count; ++i)
        value[i] = requested_value(request, shape[i], at.position[i], surface.implicit.diagonal());
    for (FeatureValue& v : value) v.g -= level;
}

struct FeatureSearch {
    std::int64_t crossing;
    Illinois root;   // the bracket of the root, in parameters from 0 to 1 along the edge
    double smallest; // the least |g|, which belongs to the best point
};

// Finds, in parallel, the root of g on the surface between the two vertices of each edge. The Illinois method runs
// along the edge, and its points are projected onto f = 0. `vertex` has the values from which the crossings were found.
base::Array<FeaturePoint> refine_crossings(const base::Work& work, const FeatureSurface& surface,
                                           const FeatureRequest& request, double level,
                                           const base::Array<FeatureValue>& vertex,
                                           const base::Array<FeatureCrossing>& crossing) {
    const SurfaceMesh& mesh = surface.mesh;
    base::Array<FeaturePoint> points(work.memory, crossing.size());
    base::Array<FeatureSearch> active(work.memory);
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
    surface::Projection at(work.memory);
    if (request.rounds <= 0) { // only project the points, without any evaluation of g
        for (const FeaturePoint& p : points) at.position.push_back(p.position);
        surface::project(work, surface.implicit, {}, at);
        for (std::int64_t i = 0; i < points.size(); ++i) {
            points[i].position = at.position[i];
            points[i].resolved = at.status[i] == surface::ProjectionStatus::converged;
            if (points[i].resolved) points[i].normal = glm::normalize(at.gradient[i]);
        }
    }
    base::Array<ShapePoint> shape(work.memory);
    base::Array<FeatureValue> values(work.memory);
    for (std::int32_t round = 0; round < request.rounds && !active.empty(); ++round) {
        at.position.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const FeatureCrossing& c = crossing[active[i].crossing];
            at.position.set(i, glm::mix(mesh.position[c.a], mesh.position[c.b], active[i].root.trial));
        }
        surface::project(work, surface.implicit, {}, at);
        evaluate(work, surface, request, level, at, shape, values);
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

// Finds the points of a section by Newton's method: zeros of f and of the height above the plane. The strength of a
// section is the sine of the angle between the plane and the surface.
base::Array<FeaturePoint> refine_section(const base::Work& work, const FeatureSurface& surface, const glm::dvec3& plane,
                                         double level, const base::Array<FeatureCrossing>& crossing) {
    constexpr int most_steps = 12;
    const double tolerance = feature_tuning.section_tolerance * surface.implicit.diagonal();
    const std::int64_t count = crossing.size();
    geometry::VecArray place(work.memory, count), gradient(work.memory, count);
    base::Array<double> value(work.memory, count);
    base::Array<FeaturePoint> points(work.memory, count);
    const auto start = [&](const FeatureCrossing& c) {
        return glm::mix(surface.mesh.position[c.a], surface.mesh.position[c.b], c.share);
    };
    for (std::int64_t i = 0; i < count; ++i) place.set(i, start(crossing[i]));
    bool left = count > 0;
    for (int step = 0; step < most_steps && left; ++step) {
        implicit::evaluate_all(work.without_progress(), surface.implicit, place,
                               {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
        left = false;
        for (std::int64_t i = 0; i < count; ++i) {
            if (points[i].resolved) continue;
            const CurvePoint at{place[i], gradient[i], plane, value[i], glm::dot(plane, place[i]) - level};
            const glm::dvec3 way = at.newton_step();
            if (!(glm::distance(at.position + way, start(crossing[i])) <= surface.mesh.side)) continue;
            place.set(i, at.position + way);
            const glm::dvec3 n = glm::normalize(at.gradient);
            points[i] = {place[i], n, glm::length(plane - glm::dot(plane, n) * n), 1.0, glm::length(way) <= tolerance};
            left = left || !points[i].resolved;
        }
    }
    return points;
}

// Multiplies the strengths of ridges and valleys by a factor from 0 to 1. The factor grows with the drop of the
// curvature on both sides, and is 0 on a cylinder. The drop is 2 (1 - k' / k) / (k s)^2, where k' is the mean curvature
// at the distance s on both sides. For small s this is -k'' / k^3. The distance is s = 1 / 2k, at which the surface has
// turned by half a radian.
void weigh_by_drop(const base::Work& work, const FeatureSurface& surface, FeatureKind kind,
                   base::Array<FeaturePoint>& points) {
    const bool convex = kind == FeatureKind::ridge;
    const auto bend = [&](const ShapePoint& s) { return convex ? -s.k2 : s.k1; };
    const double least = feature_tuning.least_aside * surface.mesh.side;
    const double most = std::max(least, feature_tuning.most_aside * surface.implicit.diagonal());
    const auto measure = [&](surface::Projection& at, base::Array<ShapePoint>& shape) {
        surface::project(work, surface.implicit, {}, at);
        measure_shape(work, surface.source, at.position, at.gradient, shape);
    };
    surface::Projection here(work.memory), aside(work.memory);
    base::Array<ShapePoint> shape(work.memory), beside(work.memory);
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
    // Adds the end of a line, by linear interpolation between a point that counts and one that does not.
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
    // Makes a line of the points since the last line, unless it is too weak or too short.
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
            ++(weak ? lines.weak : lines.too_short);
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
                // Where the line passes a vertex it crosses several edges. Points that are so close say nothing about
                // the direction of the line.
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

Chains<FeatureCrossing> find_candidates(const base::Work& work, const SurfaceMesh& mesh,
                                        const base::Array<FeatureValue>& value, const FeatureRequest& request,
                                        std::int64_t& weak) {
    return keep_candidates(find_crossings(work, {mesh, value, is_directed(request.kind), request.lower}), request,
                           weak);
}

ShapePoint shape_point(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                       const std::array<double, 10>& third) noexcept {
    const double slope = glm::length(gradient);
    if (!(slope > 0.0) || !std::isfinite(slope)) return {};
    ShapePoint result;
    result.normal = gradient / slope;
    const geometry::TangentFrame frame = geometry::combing_frame(result.normal);
    const glm::dvec3 hr = times(hessian, frame.r);
    const glm::dvec3 hu = times(hessian, frame.u);
    const surface::Eigen2 eigen = surface::symmetric_eigen2(
        -glm::dot(frame.r, hr) / slope, -glm::dot(frame.u, hr) / slope, -glm::dot(frame.u, hu) / slope);
    result.k1 = eigen.high;
    result.k2 = eigen.low;
    result.d1 = glm::normalize(eigen.cosine * frame.r + eigen.sine * frame.u);
    const glm::dvec3 hn = times(hessian, result.normal) / slope;
    result.c =
        change_of_curvature({result.d1, result.d2()}, {result.k1, result.k2}, result.in_tangent(hn), third, slope);
    const double sum = std::accumulate(result.c.begin(), result.c.end(), result.k1 + result.k2);
    return std::isfinite(sum) ? result : ShapePoint{};
}

void measure_shape(const base::Work& work, const implicit::ShapeSource& source, const geometry::VecArray& position,
                   const geometry::VecArray& gradient, base::Array<ShapePoint>& result) {
    const std::int64_t count = position.size();
    HRBFNPR_ASSERT(gradient.size() == count);
    result.resize_for_overwrite(count);
    std::atomic<std::int64_t> done{0};
    const base::Work threads = source.concurrent() ? work : work.on_one_thread();
    threads.for_chunks(count, points_a_look, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<ShapeBatch> at(work.memory);
        source.evaluate({position.x.data() + begin, position.y.data() + begin, position.z.data() + begin, end - begin},
                        at->out());
        for (std::int64_t i = begin; i < end; ++i) result[i] = at->at(static_cast<std::size_t>(i - begin), gradient[i]);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

ShapedMesh measured_mesh(const base::Work& work, const implicit::Implicit& implicit,
                         const implicit::ShapeSource& source, const SurfaceMesh& mesh) {
    ShapedMesh shaped(work.memory);
    copy(mesh.position, shaped.mesh.position, work);
    copy(mesh.gradient, shaped.mesh.gradient, work);
    copy(mesh.corner, shaped.mesh.corner, work);
    copy(mesh.neighbour, shaped.mesh.neighbour, work);
    shaped.mesh.region = mesh.region;
    shaped.mesh.side = mesh.side;
    measure_shape(work.part(0.0, 0.3), source, mesh.position, mesh.gradient, shaped.shape);
    for (int round = 0; round < feature_tuning.halvings; ++round) {
        const base::Work part = work.part(0.3 + 0.2 * round, 0.5 + 0.2 * round);
        const base::Array<std::int64_t> edges =
            find_rough_edges(part, shaped, feature_tuning.off_line * implicit.diagonal());
        if (edges.empty() || shaped.mesh.triangles() + 2 * edges.size() > feature_tuning.most_triangles ||
            !halve_edges(part.part(0.0, 0.3), implicit, edges, feature_tuning.farthest_middle, true, shaped.mesh))
            break;
        // The positions and gradients of the new vertices.
        geometry::VecArray position(work.memory), gradient(work.memory);
        for (std::int64_t i = shaped.shape.size(); i < shaped.mesh.vertices(); ++i) {
            position.push_back(shaped.mesh.position[i]);
            gradient.push_back(shaped.mesh.gradient[i]);
        }
        base::Array<ShapePoint> shape(work.memory);
        measure_shape(part.part(0.3, 0.7), source, position, gradient, shape);
        for (const ShapePoint& s : shape) base::push_back_long(shaped.shape, s, part);
    }
    return shaped;
}

FeatureValue feature_value(FeatureKind kind, const ShapePoint& shape, const glm::dvec3& position,
                           const glm::dvec4& towards, double unit) noexcept {
    if (shape.normal == glm::dvec3(0.0)) return {};
    switch (kind) {
    case FeatureKind::suggestive_contour: return suggestive(shape, ViewAtPoint(shape, position, towards), unit);
    case FeatureKind::ridge: return crest(shape, true, unit);
    case FeatureKind::valley: return crest(shape, false, unit);
    case FeatureKind::apparent_ridge: return apparent_ridge(shape, ViewAtPoint(shape, position, towards), unit);
    case FeatureKind::parabolic: return parabolic(shape, unit);
    case FeatureKind::isophote: {
        const ViewAtPoint view(shape, position, towards);
        const glm::dvec2 gradient = view.gradient_of_facing(shape);
        return {view.facing, glm::length(gradient) * unit, view.facing, glm::dvec3(0.0), shape.in_space(gradient)};
    }
    case FeatureKind::section: break;
    }
    return {};
}

FeatureLines find_feature_lines(const base::Work& work, const FeatureSurface& surface, const FeatureRequest& request) {
    FeatureLines lines(work.memory);
    base::Array<FeatureValue> value = vertex_values(work, surface, request);
    const bool has_levels = !needs_shape(request.kind) || request.kind == FeatureKind::isophote;
    constexpr std::array<double, 1> zero = {0.0};
    const std::span<const double> levels = has_levels ? request.levels : std::span<const double>(zero);
    double before = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        work.update(static_cast<double>(k) / static_cast<double>(levels.size()));
        for (FeatureValue& v : value) v.g += before - levels[k];
        before = levels[k];
        const Chains<FeatureCrossing> chains = find_candidates(work, surface.mesh, value, request, lines.weak);
        base::Array<FeaturePoint> points =
            request.kind == FeatureKind::section
                ? refine_section(work, surface, request.plane, levels[k], chains.point)
                : refine_crossings(work, surface, request, levels[k], value, chains.point);
        if (request.kind == FeatureKind::ridge || request.kind == FeatureKind::valley)
            weigh_by_drop(work, surface, request.kind, points);
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
