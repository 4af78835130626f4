// SPDX-License-Identifier: MIT
// 1. The mesh is copied, and measured at its vertices.
// 2. find_rough_edges: along these a curvature does not change as its derivatives at both ends say.
// 3. They are halved, and measured in the middle; 2 and 3 again, some times.
#include "features/feature_mesh.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "curves/edge_halving.h"
#include "features/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

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

// Whether the form's change is not what the trapezoid rule makes of its derivatives. A form that is off by e and
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

} // namespace

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
        geometry::VecArray position(runtime.memory), gradient(runtime.memory); // of the vertices that are new
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

} // namespace hrbfnpr::curves
