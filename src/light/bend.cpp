// SPDX-License-Identifier: MIT
// A surface with the mean curvature H bends away from its tangent plane by H d^2 / 2 on average at the distance d. On a
// ball this holds for any distance. So H is found from means over the surface around a place: twice the mean depth
// below the tangent plane, divided by the mean square of the distance.
//
// 1. patches_of: triangles → patches of the triangles in each cell of a grid
// 2. curvature_at: a place → the means over the patches around it
#include "base/assert.h"
#include "light/cell_sort.h"
#include "light/light.h"
#include "light/tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::light {
namespace {

using geometry::CellGrid;
using geometry::VecArray;

constexpr std::int64_t bends_a_task = 1024;

struct MeshTriangle {
    glm::dvec3 a, b, c;

    [[nodiscard]] glm::dvec3 area() const noexcept { return 0.5 * glm::cross(b - a, c - a); }
    [[nodiscard]] glm::dvec3 centre() const noexcept { return (a + b + c) / 3.0; }
    // Returns the mean of the squared distances from a place.
    [[nodiscard]] double mean_square(const glm::dvec3& from) const noexcept {
        const glm::dvec3 p = a - from, q = b - from, r = c - from, sum = p + q + r;
        return (glm::dot(p, p) + glm::dot(q, q) + glm::dot(r, r) + glm::dot(sum, sum)) / 12.0;
    }
};

[[nodiscard]] MeshTriangle triangle_of(const SurfaceTriangles& mesh, std::int64_t t) noexcept {
    return {mesh.position[mesh.corner[3 * t]], mesh.position[mesh.corner[3 * t + 1]],
            mesh.position[mesh.corner[3 * t + 2]]};
}

[[nodiscard]] base::Array<InCell> sort_triangles(const base::Work& work, const SurfaceTriangles& mesh, double side) {
    const geometry::Bounds bounds = bounds_of(mesh.position);
    const CellGrid grid{bounds.min, std::max(side, bounds.longest_side() / static_cast<double>(CellGrid::most - 1))};
    return sort_into_cells(
        work, mesh.corner.size() / 3, grid, [&](std::int64_t t) { return triangle_of(mesh, t).centre(); },
        [&](std::int64_t t) { return triangle_of(mesh, t).area(); });
}

} // namespace

struct SurfaceBend::Patches {
    // Returns the patch of the triangles [begin, end) of the order.
    [[nodiscard]] static Patch sum(const SurfaceTriangles& mesh, const base::Array<InCell>& sorted, std::int64_t begin,
                                   std::int64_t end) noexcept {
        Patch patch;
        for (std::int64_t i = begin; i < end; ++i) {
            const MeshTriangle triangle = triangle_of(mesh, sorted[i].index);
            const double area = glm::length(triangle.area());
            patch.area += area;
            patch.mean += area * triangle.centre();
            patch.normal += triangle.area();
        }
        if (!(patch.area > 0.0) || !(glm::length(patch.normal) > 0.0)) return {};
        patch.mean /= patch.area;
        patch.normal = glm::normalize(patch.normal);
        for (std::int64_t i = begin; i < end; ++i) {
            const MeshTriangle triangle = triangle_of(mesh, sorted[i].index);
            patch.squares += glm::length(triangle.area()) * triangle.mean_square(patch.mean);
        }
        return patch;
    }
    // Returns the patches of the triangles in cells with this side.
    [[nodiscard]] static base::Array<Patch> of(const base::Work& work, const SurfaceTriangles& mesh, double side) {
        const base::Array<InCell> sorted = sort_triangles(work, mesh, side);
        base::Array<Patch> patches(work.memory);
        std::int64_t begin = 0;
        for (const std::int64_t i : work.over(sorted.size())) {
            if (i + 1 < sorted.size() && sorted[i + 1].is_with(sorted[i])) continue;
            const Patch patch = sum(mesh, sorted, begin, i + 1);
            if (patch.area > 0.0) patches.push_back(patch);
            begin = i + 1;
        }
        return patches;
    }
    [[nodiscard]] static VecArray means(const base::Work& work, const base::Array<Patch>& patches) {
        VecArray mean(work.memory);
        for (const Patch& patch : patches) mean.push_back(patch.mean);
        return mean;
    }
};

SurfaceBend::SurfaceBend(const base::Work& work, const SurfaceTriangles& mesh, double scale)
    // The weights fall to 0 at the reach, so that the root of the mean square of the distances is half of it.
    : scale_(scale), reach_(std::max(2.0 * scale, light_tuning.least_reach * mesh.side)),
      patch_(Patches::of(work, mesh, light_tuning.patch * 0.5 * reach_)),
      grid_(Patches::means(work, patch_), 0.5 * reach_,
            work) { // The boxes of queries have the other half of the reach.
    HRBFNPR_ASSERT(scale > 0.0);
    base::Array<Patch> in_grid(work.memory);
    for (std::int64_t at = 0; at < patch_.size(); ++at) in_grid.push_back(patch_[grid_.index(at)]);
    patch_ = std::move(in_grid);
    base::Array<double> bounded(work.memory, patch_.size());
    work.for_chunks(patch_.size(), bends_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            bounded[i] = patch_[i].area * bounded_at(patch_[i].mean, patch_[i].normal);
    });
    double area = 0.0;
    for (const Patch& patch : patch_) area += patch.area;
    for (const double part : bounded) mean_ += part / area;
}

double SurfaceBend::curvature_at(const glm::dvec3& place, const glm::dvec3& normal) const {
    double depth = 0.0;
    double squares = 0.0;
    const double half = 0.5 * reach_;
    grid_.around({place - half, place + half}, [&](std::int64_t at) {
        const Patch& patch = patch_[at];
        const glm::dvec3 off = patch.mean - place;
        const double square = glm::dot(off, off);
        const double near = 1.0 - square / (reach_ * reach_);
        if (!(near > 0.0)) return;
        // The other side of a thin wall does not count.
        const double faces = std::clamp(1.0 + 2.0 * glm::dot(patch.normal, normal), 0.0, 1.0);
        const double weight = near * near * faces;
        depth -= weight * patch.area * glm::dot(off, normal);
        squares += weight * (patch.area * square + patch.squares);
    });
    return squares > 0.0 ? 2.0 * depth / squares : 0.0;
}

double SurfaceBend::bounded_at(const glm::dvec3& place, const glm::dvec3& normal) const {
    return std::tanh(light_tuning.bend_gain * scale_ * curvature_at(place, normal));
}

base::Array<float> SurfaceBend::curvature(const base::Work& work, const Places& places) const {
    base::Array<float> found(work.memory, places.position.size());
    work.for_chunks(found.size(), bends_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            found[i] = static_cast<float>(scale_ * curvature_at(places.position[i], places.normal[i]));
    });
    return found;
}

base::Array<float> SurfaceBend::contrast(const base::Work& work, const Places& places) const {
    base::Array<float> found(work.memory, places.position.size());
    work.for_chunks(found.size(), bends_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            found[i] =
                static_cast<float>(std::clamp(bounded_at(places.position[i], places.normal[i]) - mean_, -1.0, 1.0));
    });
    return found;
}

} // namespace hrbfnpr::light
