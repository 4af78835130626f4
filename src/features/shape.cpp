// SPDX-License-Identifier: MIT
// 1. shape_point, measure_shape: curvatures and their derivatives from derivatives of f up to the third.
// 2. measured_mesh: a copy of the mesh is measured at its vertices; edges along which a curvature does not change as
// its
//    derivatives at both ends say are halved, and measured in the middle, some times.
// 3. feature_value: g, strength and direction of each kind of line, from a measured point.
#include "features/shape.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "curves/mesh_edges.h"
#include "features/tuning.h"
#include "geometry/tangent_frame.h"
#include "surface/curvature.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace hrbfnpr::curves {
namespace {

// Few, since third derivatives by sums over 100 000 centres take half a millisecond a point.
constexpr std::int64_t points_a_look = 32;
using ShapeColumn = std::array<double, static_cast<std::size_t>(points_a_look)>;

glm::dvec3 times(const std::array<double, 6>& h, const glm::dvec3& v) noexcept {
    return {h[0] * v.x + h[1] * v.y + h[2] * v.z, h[1] * v.x + h[3] * v.y + h[4] * v.z,
            h[2] * v.x + h[4] * v.y + h[5] * v.z};
}

// T(v, ., .) as a symmetric matrix.
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

// Derivatives of II(u, v) = -H(u, v) / |g| along w, for tangent vectors that keep to the surface.  With
// D_w n = P H w / |g| and D_w |g| = H(n, w), the projections onto the tangent plane in -P H P / |g| add
//   C(u, v, w) = -T(u, v, w) / |g| + (H(u, w) H(n, v) + H(v, w) H(n, u) + H(u, v) H(n, w)) / |g|^2,
// which is symmetric, as Codazzi's equations demand.  [Rusinkiewicz 2004 has the case of a mesh.]
std::array<double, 4> change_of_curvature(const std::array<glm::dvec3, 2>& d, const glm::dvec2& bend,
                                          const glm::dvec2& normal_part, const std::array<double, 10>& third,
                                          double slope) noexcept {
    const std::array<double, 6> first = contracted(third, d[0]);
    const std::array<double, 6> other = contracted(third, d[1]);
    const glm::dvec3 first1 = times(first, d[0]);
    const glm::dvec3 other2 = times(other, d[1]);
    // In principal directions H(d_i, d_j) / |g| = -k_i or 0; normal_part is H(n, d_i) / |g|.
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

// The second fundamental form on an edge's direction and across it, and its derivatives along the edge.
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

// Whether the form changes otherwise than its derivatives tell by the trapezoid rule. A form that is off by e and
// changes by C along the surface has its zeros off by e / C; less, since g is a cubic along edges.
bool is_rough(const ShapePoint& a, const ShapePoint& b, const glm::dvec3& edge, double least, double place) noexcept {
    const AlongEdge from(a, edge);
    const AlongEdge to(b, edge);
    double off = 0.0;
    for (std::size_t i = 0; i < from.value.size(); ++i)
        off = std::max(off, std::abs(to.value[i] - from.value[i] - 0.5 * (from.change[i] + to.change[i])));
    const double change = std::max({largest_change(a), largest_change(b), least});
    return off > place * change * glm::dot(edge, edge);
}

base::Array<std::int64_t> find_rough_edges(const base::Runtime& runtime, const ShapedMesh& shaped, double place,
                                           const base::Progress& progress) {
    const SurfaceMesh& mesh = shaped.mesh;
    HRBFNPR_ASSERT(shaped.shape.size() == mesh.vertices());
    double sum = 0.0;
    for (const ShapePoint& s : shaped.shape) sum += largest_change(s) * largest_change(s);
    const double least =
        feature_tuning.least_change * std::sqrt(sum / std::max(1.0, static_cast<double>(shaped.shape.size())));
    base::Array<std::uint8_t> rough(runtime.memory);
    rough.resize_for_overwrite(mesh.corner.size());
    runtime.parallel.for_chunks(rough.size(), edges_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t e = begin; e < end; ++e) {
            const std::int32_t a = start_of(mesh, e);
            const std::int32_t b = end_of(mesh, e);
            rough[e] = is_first(mesh, e) &&
                       is_rough(shaped.shape[a], shaped.shape[b], mesh.position[b] - mesh.position[a], least, place);
        }
    });
    base::Array<std::int64_t> edges(runtime.memory);
    for (std::int64_t e = 0; e < rough.size(); ++e) {
        if (e % edges_a_task == 0) progress.check();
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

// The direction v to the eye: unit, in the tangent basis and along the normal.
struct LookedFrom {
    glm::dvec2 w;
    double facing;   // n . v
    double nearness; // 1 / distance; 0: infinitely far

    LookedFrom(const ShapePoint& shape, const glm::dvec3& position, const glm::dvec4& towards) noexcept {
        const glm::dvec3 v = glm::dvec3(towards) - towards.w * position;
        const double length = glm::length(v);
        const double inverse = length > 0.0 ? 1.0 / length : 0.0;
        w = shape.in_tangent(inverse * v);
        facing = glm::dot(shape.normal, inverse * v);
        nearness = std::abs(towards.w) * inverse;
    }
    // The derivative of w along the surface, a symmetric map: D_u n = -bend(u), and v turns by
    // -(u - v (v . u)) / distance.
    [[nodiscard]] glm::dvec2 turn(const ShapePoint& shape, const glm::dvec2& u) const noexcept {
        return facing * shape.bend(u) - nearness * (u - glm::dot(w, u) * w);
    }
    [[nodiscard]] glm::dvec2 gradient_of_facing(const ShapePoint& shape) const noexcept {
        return nearness * facing * w - shape.bend(w);
    }
};

// With B = -II, so that a ball has B > 0, the line is B(w, w) = 0 where D_w (B(w, w)) > 0; there
//   D_w (B(w, w)) = -C(w, w, w) - 2 (n . v) |B w|^2   [DeCarlo 2003, appendix].
FeatureValue suggestive(const ShapePoint& shape, const LookedFrom& view, double unit) noexcept {
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

// Both signs of curvature have their own direction: where |k1| = |k2| nothing changes over.
FeatureValue crest(const ShapePoint& shape, bool convex, double unit) noexcept {
    FeatureValue value;
    value.along = convex ? shape.d2() : shape.d1;
    value.g = convex ? shape.c[3] : shape.c[0];
    value.strength = (convex ? -shape.k2 - std::abs(shape.k1) : shape.k1 - std::abs(shape.k2)) * unit;
    return value;
}

// The turn of the normal along a unit of the image is Q = II P^-1, where P takes tangent vectors to the image plane
// through the point.  P shortens w by n . v, so that P^-1 P^-T = M = I + w w^T / (n . v)^2.  q1^2 is the larger
// eigenvalue of Q Q^T = II M II, with x its eigenvector; t1 = Q^T x / q1 stands on the surface at s = M II x / q1.
//   D_s q1^2 = 2 q1 C(x, s, s) + y^T (D_s M) y,     y = II x
FeatureValue apparent_ridge(const ShapePoint& shape, const LookedFrom& view, double unit) noexcept {
    FeatureValue value;
    value.facing = view.facing;
    const double facing = std::copysign(std::max(std::abs(view.facing), 1e-6), view.facing);
    const double inverse = 1.0 / facing;
    const glm::dvec2 m = inverse * view.w; // M = I + m m^T
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
    // The factor keeps g at the size of a curvature where `facing` nears 0.
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

} // namespace

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

void measure_shape(const base::Runtime& runtime, const implicit::ShapeSource& source,
                   const geometry::VecArray& position, const geometry::VecArray& gradient,
                   base::Array<ShapePoint>& result, const base::Progress& progress) {
    const std::int64_t count = position.size();
    HRBFNPR_ASSERT(gradient.size() == count);
    result.resize_for_overwrite(count);
    std::atomic<std::int64_t> done{0};
    const base::Parallel threads = source.concurrent() ? runtime.parallel : base::Parallel();
    threads.for_chunks(count, points_a_look, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Boxed<ShapeBatch> at(runtime.memory);
        source.evaluate({position.x.data() + begin, position.y.data() + begin, position.z.data() + begin, end - begin},
                        at->out());
        for (std::int64_t i = begin; i < end; ++i) result[i] = at->at(static_cast<std::size_t>(i - begin), gradient[i]);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        progress.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

ShapedMesh measured_mesh(const base::Runtime& runtime, const implicit::Implicit& implicit,
                         const implicit::ShapeSource& source, const SurfaceMesh& mesh, const base::Progress& progress) {
    ShapedMesh shaped(runtime.memory);
    copy(mesh.position, shaped.mesh.position, progress);
    copy(mesh.gradient, shaped.mesh.gradient, progress);
    copy(mesh.corner, shaped.mesh.corner, progress);
    copy(mesh.neighbour, shaped.mesh.neighbour, progress);
    shaped.mesh.region = mesh.region;
    shaped.mesh.side = mesh.side;
    measure_shape(runtime, source, mesh.position, mesh.gradient, shaped.shape, progress.part(0.0, 0.3));
    for (int round = 0; round < feature_tuning.halvings; ++round) {
        const base::Progress part = progress.part(0.3 + 0.2 * round, 0.5 + 0.2 * round);
        const base::Array<std::int64_t> edges =
            find_rough_edges(runtime, shaped, feature_tuning.off_line * implicit.diagonal(), part);
        if (edges.empty() || shaped.mesh.triangles() + 2 * edges.size() > feature_tuning.most_triangles ||
            !halve_edges(runtime, implicit, edges, feature_tuning.farthest_middle, true, shaped.mesh,
                         part.part(0.0, 0.3)))
            break;
        geometry::VecArray position(runtime.memory), gradient(runtime.memory); // those of the new vertices
        for (std::int64_t i = shaped.shape.size(); i < shaped.mesh.vertices(); ++i) {
            position.push_back(shaped.mesh.position[i]);
            gradient.push_back(shaped.mesh.gradient[i]);
        }
        base::Array<ShapePoint> shape(runtime.memory);
        measure_shape(runtime, source, position, gradient, shape, part.part(0.3, 0.7));
        for (const ShapePoint& s : shape) base::push_back_long(shaped.shape, s, part);
    }
    return shaped;
}

FeatureValue feature_value(FeatureKind kind, const ShapePoint& shape, const glm::dvec3& position,
                           const glm::dvec4& towards, double unit) noexcept {
    if (shape.normal == glm::dvec3(0.0)) return {};
    switch (kind) {
    case FeatureKind::suggestive_contour: return suggestive(shape, LookedFrom(shape, position, towards), unit);
    case FeatureKind::ridge: return crest(shape, true, unit);
    case FeatureKind::valley: return crest(shape, false, unit);
    case FeatureKind::apparent_ridge: return apparent_ridge(shape, LookedFrom(shape, position, towards), unit);
    case FeatureKind::parabolic: return parabolic(shape, unit);
    case FeatureKind::isophote: {
        const LookedFrom view(shape, position, towards);
        const glm::dvec2 gradient = view.gradient_of_facing(shape);
        return {view.facing, glm::length(gradient) * unit, view.facing, glm::dvec3(0.0), shape.in_space(gradient)};
    }
    case FeatureKind::section: break;
    }
    return {};
}

} // namespace hrbfnpr::curves
