// SPDX-License-Identifier: MIT
#include "features/feature_mesh.h"

#include "curves/edge_halving.h"
#include "geometry/long_vec_array.h"
#include "surface/project.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr int rounds = 3;
constexpr std::int64_t at_once = 8192; // edges without a look for a cancel
// In diagonals: how far a line may be off, where a curvature's change along an edge is not what its derivatives say.
constexpr double feature_tolerance = 3e-4;
// Of the root mean square of C: where it is smaller, what lines there are is not decided by it.
constexpr double least_change = 0.3;
constexpr std::int64_t most_triangles = 4'000'000;

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

// Whether the form's change is not what the trapezoid rule makes of its derivatives.  A form that is off by so much,
// and changes by C along the surface, has its zeros off by their ratio; less, since g is a cubic along edges.
bool is_rough(const ShapePoint& a, const ShapePoint& b, const glm::dvec3& edge, double least, double place) noexcept {
    const AlongEdge from(a, edge);
    const AlongEdge to(b, edge);
    double off = 0.0;
    for (std::size_t i = 0; i < from.value.size(); ++i)
        off = std::max(off, std::abs(to.value[i] - from.value[i] - 0.5 * (from.change[i] + to.change[i])));
    const double length = glm::length(edge);
    const double change = std::max({largest_change(a), largest_change(b), least});
    return off > place * change * length * length;
}

class Halver {
public:
    Halver(const base::Runtime& runtime, const implicit::Implicit& implicit, const implicit::ShapeSource& source,
           ShapedMesh& shaped) noexcept
        : runtime_(runtime), implicit_(implicit), source_(source), mesh_(shaped.mesh), shape_(shaped.shape),
          middle_(runtime.memory) {}

    // Whether there was anything to halve.
    bool run(const base::Progress& progress) {
        find_rough(progress);
        if (!add_vertices(progress)) return false;
        cut_at_middles(runtime_, middle_, mesh_);
        return true;
    }

private:
    static constexpr std::int32_t whole = -1;
    static constexpr std::int32_t to_halve = -2;

    [[nodiscard]] std::int32_t start(std::int64_t edge) const noexcept { return start_of(mesh_, edge); }
    [[nodiscard]] std::int32_t end(std::int64_t edge) const noexcept { return end_of(mesh_, edge); }
    [[nodiscard]] glm::dvec3 vector(std::int64_t edge) const noexcept {
        return mesh_.position[end(edge)] - mesh_.position[start(edge)];
    }
    [[nodiscard]] double least() const noexcept {
        double sum = 0.0;
        for (const ShapePoint& s : shape_) sum += largest_change(s) * largest_change(s);
        return least_change * std::sqrt(sum / std::max(1.0, static_cast<double>(shape_.size())));
    }
    // Of the two triangles of an edge the first decides.
    void find_rough(const base::Progress& progress) {
        middle_.resize_for_overwrite(mesh_.corner.size());
        const double change = least();
        const double place = feature_tolerance * implicit_.diagonal();
        runtime_.parallel.for_chunks(mesh_.corner.size(), 8192, progress, [&](std::int64_t begin, std::int64_t stop) {
            for (std::int64_t e = begin; e < stop; ++e) {
                const bool rough =
                    is_first(mesh_, e) && is_rough(shape_[start(e)], shape_[end(e)], vector(e), change, place);
                middle_[e] = rough ? to_halve : whole;
            }
        });
    }
    // Not where the middle of an edge is nowhere near the surface, as across a wall that is thinner than the edge.
    [[nodiscard]] bool stays(std::int64_t edge, const glm::dvec3& middle, const glm::dvec3& gradient) const noexcept {
        const glm::dvec3 between = 0.5 * (mesh_.position[start(edge)] + mesh_.position[end(edge)]);
        const double length = glm::length(vector(edge));
        return glm::distance(middle, between) < 0.4 * length && glm::dot(gradient, mesh_.gradient[start(edge)]) > 0.0 &&
               glm::dot(gradient, mesh_.gradient[end(edge)]) > 0.0;
    }
    bool add_vertices(const base::Progress& progress) {
        base::Array<std::int64_t> edge(runtime_.memory);
        surface::Projection at(runtime_.memory);
        for (std::int64_t e = 0; e < middle_.size(); ++e) {
            if (e % at_once == 0) progress.check();
            if (middle_[e] != to_halve) continue;
            middle_[e] = whole;
            edge.push_back(e);
            at.position.push_back(0.5 * (mesh_.position[start(e)] + mesh_.position[end(e)]));
        }
        if (edge.empty() || mesh_.triangles() + 2 * edge.size() > most_triangles) return false;
        surface::project(runtime_, implicit_, {}, at, progress.part(0.0, 0.3));
        geometry::VecArray position(runtime_.memory);
        geometry::VecArray gradient(runtime_.memory);
        for (std::int64_t i = 0; i < edge.size(); ++i) {
            if (i % at_once == 0) progress.check();
            const bool found = at.status[i] == surface::ProjectionStatus::converged;
            if (!found || !stays(edge[i], at.position[i], at.gradient[i])) continue;
            const auto vertex = static_cast<std::int32_t>(mesh_.vertices() + position.size());
            middle_[edge[i]] = vertex;
            if (const std::int64_t other = opposite_of(mesh_, edge[i]); other >= 0) middle_[other] = vertex;
            position.push_back(at.position[i]);
            gradient.push_back(at.gradient[i]);
        }
        base::Array<ShapePoint> shape(runtime_.memory);
        measure_shape(runtime_, source_, position, gradient, shape, progress.part(0.3, 0.7));
        for (std::int64_t i = 0; i < shape.size(); ++i) {
            if (i % at_once == 0) progress.check();
            geometry::push_back_long(mesh_.position, position[i], progress);
            geometry::push_back_long(mesh_.gradient, gradient[i], progress);
            base::push_back_long(shape_, shape[i], progress);
        }
        return !shape.empty();
    }

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const implicit::ShapeSource& source_;
    SurfaceMesh& mesh_;
    base::Array<ShapePoint>& shape_;
    base::Array<std::int32_t> middle_; // of each edge: the vertex there, or `whole`
};

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
    for (int round = 0; round < rounds; ++round)
        if (!Halver(runtime, implicit, source, shaped).run(progress.part(0.3 + 0.2 * round, 0.5 + 0.2 * round))) break;
    return shaped;
}

} // namespace hrbfnpr::curves
