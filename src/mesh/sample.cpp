// SPDX-License-Identifier: MIT
#include "mesh/sample.h"

#include "base/random.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t samples_a_task = 4096;

[[nodiscard]] MeshSamples of_size(base::Memory& memory, std::int64_t count) {
    MeshSamples samples(memory);
    samples.position.resize(count);
    samples.normal.resize(count);
    samples.face.resize(count);
    return samples;
}

// Area up to the end of each face.
[[nodiscard]] base::Array<double> running_area(const Mesh& mesh, const base::Progress& progress) {
    base::Array<double> area(mesh.vertex.memory());
    area.reserve(mesh.faces());
    double sum = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        if (face % samples_a_task == 0) progress.check();
        sum += glm::length(doubled_area(mesh.corners(face)));
        area.push_back(sum);
    }
    return area;
}

} // namespace

glm::dvec3 normal_at(const Mesh& mesh, std::int64_t face, const glm::dvec3& shares) noexcept {
    const glm::dvec3* const n = mesh.corner_normal.data() + 3 * face;
    const glm::dvec3 sum = shares.x * n[0] + shares.y * n[1] + shares.z * n[2];
    const double length = glm::length(sum);
    return length > 1e-12 ? sum / length : glm::normalize(doubled_area(mesh.corners(face)));
}

MeshSamples random_samples(const base::Runtime& runtime, const Mesh& mesh, std::int64_t count, std::uint64_t seed,
                           std::uint32_t stream, const base::Progress& progress) {
    MeshSamples samples = of_size(runtime.memory, count);
    const base::Array<double> area = running_area(mesh, progress);
    runtime.parallel.for_chunks(count, samples_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            const auto random = base::uniform4(seed, static_cast<std::uint64_t>(i), base::Purpose::mesh_sample, stream);
            const double* const found = std::upper_bound(area.begin(), area.end(), random[0] * area[area.size() - 1]);
            const std::int64_t face = std::min<std::int64_t>(found - area.begin(), mesh.faces() - 1);
            const double root = std::sqrt(random[1]);
            const glm::dvec3 shares{1.0 - root, root * (1.0 - random[2]), root * random[2]};
            const auto p = mesh.corners(face);
            samples.position.set(i, shares.x * p[0] + shares.y * p[1] + shares.z * p[2]);
            samples.normal.set(i, normal_at(mesh, face, shares));
            samples.face[i] = static_cast<std::int32_t>(face);
        }
    });
    return samples;
}

MeshSamples even_samples(const base::Runtime& runtime, const Mesh& mesh, std::int64_t count, std::int64_t candidates,
                         std::uint64_t seed, const base::Progress& progress) {
    MeshSamples all = random_samples(runtime, mesh, std::max(count, candidates), seed, 0, progress.part(0.0, 0.2));
    if (candidates <= count) return all;
    const geometry::FarthestOrder chosen = geometry::farthest_order(all.position, count, progress.part(0.2, 1.0));
    MeshSamples samples = of_size(runtime.memory, count);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t i = chosen.order[k];
        samples.position.set(k, all.position[i]);
        samples.normal.set(k, all.normal[i]);
        samples.face[k] = all.face[i];
    }
    return samples;
}

} // namespace hrbfnpr::mesh
