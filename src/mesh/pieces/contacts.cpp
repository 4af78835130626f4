// SPDX-License-Identifier: MIT
#include "mesh/pieces/contacts.h"

namespace hrbfnpr::mesh {
namespace {

constexpr double most_opposite = -0.95; // cosine of normals that look the other way
constexpr std::int64_t places_a_task = 256;

// Such a face of another component; -1: none.
std::int32_t face_against(const Mesh& mesh, const FaceTree& tree, const MeshSamples& places, std::int64_t i,
                          double near) noexcept {
    const glm::dvec3 normal = glm::normalize(doubled_area(mesh.corners(places.face[i])));
    std::int32_t found = -1;
    tree.crossings(places.position[i] - near * normal, 2.0 * near * normal, [&](std::int32_t face, double t, int sign) {
        if (t > 1.0 || sign > 0 || mesh.component[face] == mesh.component[places.face[i]]) return;
        const glm::dvec3 there = doubled_area(mesh.corners(face));
        if (glm::dot(there, normal) < most_opposite * glm::length(there)) found = face;
    });
    return found;
}

} // namespace

base::Array<std::uint8_t> patches_in_contact(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                             const Creases& creases, const MeshSamples& places, double near,
                                             const base::Progress& progress) {
    base::Array<std::uint8_t> touches(runtime.memory, creases.patches);
    const std::int64_t count = places.position.size();
    base::Array<std::int32_t> against(runtime.memory, count);
    runtime.parallel.for_chunks(count, places_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) against[i] = face_against(mesh, tree, places, i, near);
    });
    for (std::int64_t i = 0; i < count; ++i) {
        if (against[i] < 0) continue;
        touches[creases.patch[places.face[i]]] = 1;
        touches[creases.patch[against[i]]] = 1;
    }
    return touches;
}

} // namespace hrbfnpr::mesh
