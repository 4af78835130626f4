// SPDX-License-Identifier: MIT
#include "mesh/fit/outer.h"

namespace hrbfnpr::mesh {
namespace {

// In no direction that edges of meshes have.
const std::array<glm::dvec3, 3> directions{glm::dvec3{0.5773, 0.2161, 0.7874}, glm::dvec3{-0.6431, 0.7321, 0.2247},
                                           glm::dvec3{0.1713, -0.5119, -0.8418}};
constexpr double beside = 1e-4; // a face, in diagonals
constexpr std::int64_t grain = 512;

} // namespace

bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept {
    int votes = 0;
    for (const glm::dvec3& direction : directions) {
        int winding = 0;
        tree.crossings(place, direction, [&](std::int64_t, double, int sign) { winding += sign; });
        votes += winding > 0 ? 1 : 0;
    }
    return votes >= 2;
}

void keep_outer(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal, const base::Progress& progress) {
    const std::int64_t components = mesh.report.components - mesh.report.left_out_components;
    if (!mesh.report.closed || components < 2) return;
    base::Array<std::uint8_t> inside(runtime.memory, position.size());
    const double off = beside * mesh.bounds.diagonal();
    runtime.parallel.for_chunks(position.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) inside[i] = is_inside(tree, position[i] + off * normal[i]) ? 1 : 0;
    });
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < position.size(); ++i) {
        if (inside[i] != 0) continue;
        position.set(kept, position[i]);
        normal.set(kept++, normal[i]);
    }
    if (kept == 0) return; // all of them: a mesh of which nobody knows what is outside
    position.resize(kept);
    normal.resize(kept);
}

} // namespace hrbfnpr::mesh
