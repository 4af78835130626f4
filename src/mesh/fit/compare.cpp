// SPDX-License-Identifier: MIT
#include "mesh/fit/compare.h"

#include "base/clock.h"
#include "curves/surface_mesh.h"
#include "mesh/fit/outer.h"
#include "mesh/fit/surface_places.h"
#include "mesh/sample.h"
#include "surface/project.h"
#include "surface/region.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t grain = 256;
constexpr std::int64_t points_a_look = 16; // some are far from all faces
constexpr double degrees = 57.29577951308232;
constexpr int evaluations = 20;
constexpr double projected_tolerance = 1e-6;
constexpr std::int64_t most_to_look_closer = 400'000; // triangles
constexpr std::uint32_t stream = 77;                  // other places than those that a fit is made of

// The triangles as faces for a tree.
[[nodiscard]] FaceTree tree_of(const base::Runtime& runtime, const curves::SurfaceMesh& surface,
                               const base::Progress& progress) {
    base::Array<glm::dvec3> vertex(runtime.memory);
    base::Array<Triangle> triangle(runtime.memory);
    vertex.reserve(surface.vertices());
    triangle.reserve(surface.triangles());
    for (std::int64_t v = 0; v < surface.vertices(); ++v) vertex.push_back(surface.position[v]);
    for (std::int64_t t = 0; t < surface.triangles(); ++t)
        triangle.push_back({surface.corner[3 * t], surface.corner[3 * t + 1], surface.corner[3 * t + 2]});
    return {runtime, vertex, triangle, progress};
}

[[nodiscard]] base::Array<double> distances(const base::Runtime& runtime, const geometry::VecArray& from,
                                            const FaceTree& tree, const base::Progress& progress) {
    base::Array<double> result(runtime.memory, from.size());
    runtime.parallel.for_chunks(from.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            if (i % points_a_look == 0) progress.check();
            result[i] = tree.distance(from[i]);
        }
    });
    return result;
}

class Comparer {
public:
    Comparer(const base::Runtime& runtime, const implicit::Implicit& implicit, const Mesh& mesh, const FaceTree& tree,
             const surface::Support* support, const CompareSettings& given, const base::Progress& progress)
        : runtime_(runtime), implicit_(implicit), mesh_(mesh), tree_(tree), outer_(runtime, mesh, tree, progress),
          progress_(progress) {
        result_.diagonal = mesh.bounds.diagonal();
        result_.tolerance = given.tolerance > 0.0 ? given.tolerance : default_tolerance * result_.diagonal;
        far_ = given.far > 0.0 ? given.far : default_far * result_.diagonal;
        search_.region = search_region(mesh);
        search_.side = given.cell_size > 0.0 ? given.cell_size : result_.diagonal / cells_a_diagonal;
        search_.finer = !(given.cell_size > 0.0);
        search_.count = given.points > 0 ? given.points : default_points;
        search_.seed = given.seed;
        search_.support = given.support > 0.0 ? support : nullptr;
        search_.limit = given.support;
    }

    [[nodiscard]] Comparison run() {
        MeshSamples samples =
            random_samples(runtime_, mesh_, search_.count, search_.seed, stream, progress_.part(0.0, 0.1));
        keep_outer(runtime_, mesh_, tree_, samples.position, samples.normal, progress_);
        curves::SurfaceMesh surface =
            find_surface(runtime_, implicit_, samples.position, search_, progress_.part(0.1, 0.3));
        parts_ = parts_of(runtime_, surface);
        if (search_.finer && differs_from_mesh() && surface.triangles() < most_to_look_closer) {
            search_.side = 0.5 * surface.side;
            surface = find_surface(runtime_, implicit_, samples.position, search_, progress_.part(0.3, 0.4));
            parts_ = parts_of(runtime_, surface);
        }
        from_surface(surface);
        from_mesh(surface, samples);
        result_.seconds = watch_.seconds();
        progress_.update(1.0);
        return result_;
    }

private:
    // A closed mesh has other parts or handles: the cells may not show a wall, or a gap.
    [[nodiscard]] bool differs_from_mesh() const noexcept {
        const MeshReport& report = mesh_.report;
        return report.closed &&
               (parts_.genus != report.genus || parts_.components != report.components - report.left_out_components);
    }

    void from_surface(const curves::SurfaceMesh& surface) {
        const SurfacePlaces places = places_on(runtime_, implicit_, surface, search_, progress_.part(0.4, 0.6));
        base::Array<double> distance(runtime_.memory, places.position.size());
        runtime_.parallel.for_chunks(distance.size(), grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                if (i % points_a_look == 0) progress_.check();
                const FaceTree::Nearest nearest = outer_.tree().nearest(places.position[i]);
                distance[i] = on_border(mesh_, nearest.face, nearest.place) ? -1.0 : std::sqrt(nearest.squared);
            }
        });
        std::int64_t kept = 0;
        for (const double d : distance)
            if (d >= 0.0) distance[kept++] = d;
        distance.resize(kept);
        result_.surface = spread_of(distance, result_.tolerance, far_);
        result_.components = parts_.components;
        result_.genus = parts_.genus;
        result_.left_out =
            static_cast<double>(places.found - kept) / static_cast<double>(std::max<std::int64_t>(places.found, 1));
    }

    // A projection may end farther away than need be; the triangles are off the surface by their bulge.
    void from_mesh(const curves::SurfaceMesh& surface, const MeshSamples& samples) {
        surface::Projection on(runtime_.memory);
        for (std::int64_t i = 0; i < samples.position.size(); ++i) on.position.push_back(samples.position[i]);
        surface::ProjectionSettings settings;
        settings.evaluation_limit = evaluations;
        settings.tolerance = projected_tolerance;
        surface::project(runtime_, implicit_, settings, on, progress_.part(0.7, 0.9));
        base::Array<double> distance(runtime_.memory, samples.position.size());
        const bool some = surface.triangles() > 0;
        if (some) distance = distances(runtime_, samples.position, tree_of(runtime_, surface, progress_), progress_);
        base::Array<double> angle(runtime_.memory);
        for (std::int64_t i = 0; i < distance.size(); ++i) {
            const double slope = glm::length(on.gradient[i]);
            if (!some) distance[i] = std::numeric_limits<double>::infinity();
            if (on.status[i] != surface::ProjectionStatus::converged || !(slope > 0.0)) continue;
            distance[i] = std::min(distance[i], glm::distance(on.position[i], samples.position[i]));
            if (distance[i] > far_) continue;
            const double cosine = glm::dot(on.gradient[i], samples.normal[i]) / slope;
            angle.push_back(degrees * std::acos(std::clamp(cosine, -1.0, 1.0)));
        }
        result_.mesh = spread_of(distance, result_.tolerance, far_);
        const Spread normals = spread_of(angle, 180.0, 180.0);
        result_.normal_mean = normals.mean;
        result_.normal_p99 = normals.p99;
    }

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const Mesh& mesh_;
    const FaceTree& tree_;
    const OuterFaces outer_;
    const base::Progress& progress_;
    const base::Stopwatch watch_;
    SurfaceSearch search_;
    double far_ = 0.0;
    SurfaceParts parts_;
    Comparison result_;
};

} // namespace

geometry::Bounds search_region(const Mesh& mesh) noexcept {
    return mesh.bounds.grown(surface::region_margin * mesh.bounds.diagonal());
}

Spread spread_of(base::Array<double>& distance, double tolerance, double far) {
    Spread spread;
    spread.points = distance.size();
    if (distance.empty()) return spread;
    const auto count = static_cast<double>(distance.size());
    double sum = 0.0;
    std::int64_t within = 0;
    std::int64_t beyond = 0;
    spread.most = 0.0;
    for (const double d : distance) {
        sum += d;
        within += d <= tolerance ? 1 : 0;
        beyond += d > far ? 1 : 0;
        spread.most = std::max(spread.most, d);
    }
    spread.mean = sum / count;
    spread.share = static_cast<double>(within) / count;
    spread.beyond = static_cast<double>(beyond) / count;
    double* const at = distance.begin() + std::min(distance.size() - 1, distance.size() * 99 / 100);
    std::nth_element(distance.begin(), at, distance.end());
    spread.p99 = *at;
    return spread;
}

Comparison compare(const base::Runtime& runtime, const implicit::Implicit& implicit, const Mesh& mesh,
                   const FaceTree& tree, const surface::Support* support, const CompareSettings& settings,
                   const base::Progress& progress) {
    return Comparer(runtime, implicit, mesh, tree, support, settings, progress).run();
}

} // namespace hrbfnpr::mesh
