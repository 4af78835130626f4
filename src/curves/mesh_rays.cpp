// SPDX-License-Identifier: MIT
// Seeking: the ray meets the next triangle of the mesh. Refining: Newton's method along the ray, from this place. A
// step that leaves the neighbourhood of a cell, or where f changes the other way than at the mesh, leaves the ray to a
// search without the mesh.
#include "curves/mesh_rays.h"

#include "curves/tuning.h"
#include "surface/ray_range.h"
#include "surface/region.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

using surface::RayHits;
using surface::RayRange;
using surface::Rays;
using surface::RayStatus;

constexpr std::int64_t rays_a_batch = 2048;
// Triangles that a ray meets within this distance, in diagonals, count as one crossing, because a ray through an edge
// meets two triangles.
constexpr double one_crossing = 1e-10;
constexpr auto lanes = static_cast<std::size_t>(rays_a_batch);
using Column = std::array<double, lanes>;

struct Ray {
    enum class Phase : std::uint8_t { refine, done };

    RayRange range;
    double walked = 0.0;   // the distance from the start of the walk up to which the mesh has been met
    double crossing = 0.0; // s at the place where the ray meets the mesh
    double trial = 0.0;    // the value of s for the next evaluation
    double last = -std::numeric_limits<double>::infinity(); // s of the last root
    std::int32_t steps = 0;
    std::int32_t hits = 0;
    bool entering = false; // whether f changes from + to - at the crossing
    Phase phase = Phase::done;
};

class MeshRayBatch {
public:
    MeshRayBatch(const implicit::Implicit& implicit, const RayMesh& mesh, const MeshRaySettings& settings,
                 RayHits& hits, base::Array<std::uint8_t>& unresolved) noexcept
        : implicit_(implicit), mesh_(mesh), settings_(settings.rays), hits_(hits), unresolved_(unresolved),
          refine_(settings.refine), region_(surface::search_region(implicit)),
          reach_(settings.refine ? mesh.mesh.side : 0.0), apart_(one_crossing * implicit.diagonal()),
          tolerance_(std::max(settings.rays.tolerance, 1e-15) * implicit.diagonal()) {}

    void run(const base::Work& work, const Rays& rays, std::int64_t begin, std::int64_t end);

private:
    void seek(std::size_t i);
    [[nodiscard]] bool store(std::size_t i, double s, const glm::dvec3& g);
    void take(std::size_t i, double f, const glm::dvec3& g);
    void take_root(std::size_t i, double s, const glm::dvec3& g);
    void end_with(std::size_t i, RayStatus status) noexcept;
    void leave(std::size_t i) noexcept;
    [[nodiscard]] glm::dvec3 gradient_at(std::int64_t face, const glm::dvec3& place) const noexcept;
    void evaluate(const base::Work& work);
    [[nodiscard]] std::int64_t number(std::size_t i) const noexcept { return begin_ + static_cast<std::int64_t>(i); }

    const implicit::Implicit& implicit_;
    const RayMesh& mesh_;
    const surface::RaySettings& settings_;
    RayHits& hits_;
    base::Array<std::uint8_t>& unresolved_;
    bool refine_;
    geometry::Bounds region_;
    double reach_;     // The mesh is met up to this distance before the start and after the end of a ray.
    double apart_;     // Triangles that a ray meets within this distance are one crossing.
    double tolerance_; // the accuracy of a root along its ray
    std::int64_t begin_ = 0;

    std::array<Ray, lanes> rays_;
    std::array<std::int64_t, lanes> keys_; // the cells and indices of the rays that are refined
    Column x_, y_, z_, f_, gx_, gy_, gz_;
};

void MeshRayBatch::end_with(std::size_t i, RayStatus status) noexcept {
    rays_[i].phase = Ray::Phase::done;
    hits_.count[number(i)] = rays_[i].hits;
    hits_.status[number(i)] = status;
}

void MeshRayBatch::leave(std::size_t i) noexcept {
    rays_[i].phase = Ray::Phase::done;
    unresolved_[number(i)] = 1;
}

// Returns the mean of the gradients at the corners of a face, weighted by the place on the face.
glm::dvec3 MeshRayBatch::gradient_at(std::int64_t face, const glm::dvec3& place) const noexcept {
    const auto p = corners_of(mesh_.mesh, face);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::dot(normal, normal);
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3& a = p[(k + 1) % 3];
        const double part = glm::dot(normal, glm::cross(p[(k + 2) % 3] - a, place - a));
        sum += part / area * mesh_.mesh.gradient[mesh_.mesh.corner[3 * face + static_cast<std::int64_t>(k)]];
    }
    return area > 0.0 ? sum : mesh_.mesh.gradient[mesh_.mesh.corner[3 * face]];
}

// Stores a hit. Returns whether the search goes on.
bool MeshRayBatch::store(std::size_t i, double s, const glm::dvec3& g) {
    Ray& ray = rays_[i];
    if (ray.hits == settings_.maximum_hits) {
        end_with(i, RayStatus::truncated);
        return false;
    }
    surface::store_hit(hits_, settings_, number(i), ray.hits++, ray.range, s, g, ray.entering);
    if (settings_.maximum_hits > 1) return true;
    end_with(i, RayStatus::hit);
    return false;
}

// Meets triangles of the mesh, up to the next place to refine or the end of the ray.
void MeshRayBatch::seek(std::size_t i) {
    Ray& ray = rays_[i];
    const glm::dvec3& along = ray.range.direction;
    for (;;) {
        const geometry::Bvh::Hit hit =
            mesh_.tree.first_hit(ray.range.start - reach_ * along, along, ray.walked, ray.range.end + 2.0 * reach_);
        if (hit.face < 0) return end_with(i, ray.hits > 0 ? RayStatus::hit : RayStatus::miss);
        ray.walked = hit.t + apart_;
        ray.crossing = ray.trial = hit.t - reach_;
        const auto p = corners_of(mesh_.mesh, hit.face);
        ray.entering = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), along) < 0.0;
        ray.steps = 0;
        ray.phase = Ray::Phase::refine;
        if (refine_ || !store(i, ray.crossing, gradient_at(hit.face, ray.range.at(ray.crossing)))) return;
    }
}

void MeshRayBatch::take(std::size_t i, double f, const glm::dvec3& g) {
    Ray& ray = rays_[i];
    const double slope = glm::dot(g, ray.range.direction);
    const double newton = ray.trial - f / slope;                 // NaN or infinite if the slope is 0
    const bool near = std::abs(newton - ray.crossing) <= reach_; // false for NaN
    if (!near || (slope < 0.0) != ray.entering || ++ray.steps > curve_tuning.most_ray_steps) return leave(i);
    if (std::abs(newton - ray.trial) <= tolerance_) return take_root(i, newton, g);
    ray.trial = newton;
}

void MeshRayBatch::take_root(std::size_t i, double s, const glm::dvec3& g) {
    Ray& ray = rays_[i];
    if (!(s > ray.last)) return leave(i); // the root of an earlier crossing
    ray.last = s;
    const glm::dvec3 place = ray.range.at(s);
    const implicit::Domain* const domain = mesh_.mesh.domain;
    const bool is_hit = s >= 0.0 && s <= ray.range.end && implicit_.contains(place, g) &&
                        (domain == nullptr || domain->contains(place, g));
    if (!is_hit || store(i, s, g)) seek(i);
}

// Evaluates f and its gradient for all rays that are refined, cell by cell.
void MeshRayBatch::evaluate(const base::Work& work) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
        if (rays_[i].phase != Ray::Phase::refine) continue;
        const std::int64_t cell = implicit_.cell_of(rays_[i].range.at(rays_[i].trial));
        keys_[count++] = cell * rays_a_batch + static_cast<std::int64_t>(i);
    }
    std::sort(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k) {
        const Ray& ray = rays_[static_cast<std::size_t>(keys_[k] % rays_a_batch)];
        const glm::dvec3 p = ray.range.at(ray.trial);
        x_[k] = p.x;
        y_[k] = p.y;
        z_[k] = p.z;
    }
    implicit::FieldBatch fields;
    fields.value = f_.data();
    fields.gradient = {gx_.data(), gy_.data(), gz_.data()};
    const implicit::PointBatch points{x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(count)};
    for (std::int64_t from = 0; from < points.count; from += implicit::batch_size) {
        work.check();
        const std::int64_t to = std::min(points.count, from + implicit::batch_size);
        implicit_.evaluate(implicit::slice(points, from, to), fields.from(from));
    }
    for (std::size_t k = 0; k < count; ++k)
        take(static_cast<std::size_t>(keys_[k] % rays_a_batch), f_[k], {gx_[k], gy_[k], gz_[k]});
}

void MeshRayBatch::run(const base::Work& work, const Rays& rays, std::int64_t begin, std::int64_t end) {
    begin_ = begin;
    surface::clear(hits_, settings_, begin, end);
    for (Ray& ray : rays_) ray = Ray();
    for (std::int64_t at = begin; at < end; ++at) {
        const auto i = static_cast<std::size_t>(at - begin);
        rays_[i].range = surface::range_in(region_, settings_, rays.origin[at], rays.direction[at]);
        if (rays_[i].range.empty)
            end_with(i, RayStatus::miss); // the ray is outside the region
        else
            seek(i);
    }
    const auto is_refined = [](const Ray& ray) { return ray.phase == Ray::Phase::refine; };
    while (std::any_of(rays_.begin(), rays_.end(), is_refined)) evaluate(work);
}

[[nodiscard]] base::Array<geometry::Bvh::Triangle> triangles_of(const base::Work& work, const SurfaceMesh& mesh) {
    base::Array<geometry::Bvh::Triangle> triangle(work.memory);
    for (const std::int64_t t : work.over(mesh.triangles()))
        triangle.push_back({mesh.corner[3 * t], mesh.corner[3 * t + 1], mesh.corner[3 * t + 2]});
    return triangle;
}

[[nodiscard]] base::Array<glm::dvec3> vertices_of(const base::Work& work, const SurfaceMesh& mesh) {
    base::Array<glm::dvec3> vertex(work.memory);
    for (const std::int64_t i : work.over(mesh.vertices())) vertex.push_back(mesh.position[i]);
    return vertex;
}

} // namespace

RayMesh::RayMesh(const base::Work& work, const SurfaceMesh& of)
    : mesh(of), tree(work, vertices_of(work, of), triangles_of(work, of)) {}

base::Array<std::int32_t> cast_rays(const base::Work& work, const implicit::Implicit& implicit, const RayMesh& mesh,
                                    const MeshRaySettings& settings, const Rays& rays, RayHits& hits) {
    const std::int64_t count = rays.origin.size();
    surface::resize(hits, count, settings.rays);
    base::Array<std::uint8_t> unresolved(work.memory, count);
    std::atomic<std::int64_t> done{0};
    const base::Work casting = settings.refine ? implicit.threads(work) : work;
    casting.for_chunks(count, rays_a_batch, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<MeshRayBatch> batch(work.memory, implicit, mesh, settings, hits, unresolved);
        batch->run(casting.without_progress(), rays, begin, end);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        casting.update(static_cast<double>(now) / static_cast<double>(count));
    });
    base::Array<std::int32_t> rest(work.memory);
    for (std::int64_t i = 0; i < count; ++i)
        if (unresolved[i] != 0) rest.push_back(static_cast<std::int32_t>(i));
    return rest;
}

} // namespace hrbfnpr::curves
