// SPDX-License-Identifier: MIT
#include "mesh/fit/touching.h"

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t grain = 256;

// The component that a short line through a place meets besides the place's own; -1: none.
std::int32_t other_component(const Mesh& mesh, const FaceTree& tree, const MeshSamples& places, std::int64_t i,
                             double near) noexcept {
    const std::int32_t own = mesh.component[places.face[i]];
    for (const double side : {near, -near}) {
        const FaceTree::Hit hit = tree.first_hit(places.position[i], side * places.normal[i], 1e-3, 1.0);
        if (hit.face >= 0 && mesh.component[hit.face] != own) return mesh.component[hit.face];
    }
    return -1;
}

} // namespace

Touching find_touching(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
                       double near, const base::Progress& progress) {
    base::Array<std::int32_t> other(runtime.memory, places.position.size());
    runtime.parallel.for_chunks(other.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) other[i] = other_component(mesh, tree, places, i, near);
    });
    for (std::int64_t i = 0; i < other.size(); ++i)
        if (other[i] >= 0) return {mesh.component[places.face[i]], other[i], places.position[i]};
    return {};
}

} // namespace hrbfnpr::mesh
