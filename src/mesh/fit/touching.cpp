// SPDX-License-Identifier: MIT
#include "mesh/fit/touching.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t boxes_a_task = 256;

// Parts that are near to each other, and not crossing, have normals with at least this cosine, or the opposite.
constexpr double least_alike = 0.9;

// The component that a short line through a place meets besides the place's own, where their normals are alike or
// opposite by so much; -1: none.
std::int32_t other_component(const Mesh& mesh, const FaceTree& tree, const MeshSamples& places, std::int64_t i,
                             double near, double alike) noexcept {
    const std::int32_t own = mesh.component[places.face[i]];
    for (const double side : {near, -near}) {
        const FaceTree::Hit hit = tree.first_hit(places.position[i], side * places.normal[i], 1e-3, 1.0);
        if (hit.face < 0 || mesh.component[hit.face] == own) continue;
        const glm::dvec3 there = doubled_area(mesh.corners(hit.face));
        if (std::abs(glm::dot(there, places.normal[i])) >= alike * glm::length(there)) return mesh.component[hit.face];
    }
    return -1;
}

// The first face of another component that one of a face's own edges goes through; -1: there is none.
std::int32_t pierced_by(const Mesh& mesh, const FaceTree& tree, std::int64_t face, glm::dvec3& place) noexcept {
    constexpr int most_own = 8; // faces that an edge goes through before
    constexpr double beyond = 1e-9;
    const std::array<glm::dvec3, 3> p = mesh.corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 along = p[(k + 1) % 3] - p[k];
        FaceTree::Hit hit{0.0, face};
        for (int own = 0; own < most_own && hit.face >= 0; ++own) {
            hit = tree.first_hit(p[k], along, hit.t + beyond, 1.0);
            if (hit.face < 0 || mesh.component[hit.face] == mesh.component[face]) continue;
            place = p[k] + hit.t * along;
            return mesh.component[hit.face];
        }
    }
    return -1;
}

// The first of many for which find(i, place) is a component.
template <class F>
Touching first_of(const base::Runtime& runtime, std::int64_t count, const base::Progress& progress, F&& find) {
    base::Array<std::int32_t> other(runtime.memory, count);
    runtime.parallel.for_chunks(count, boxes_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        glm::dvec3 place;
        for (std::int64_t i = begin; i < end; ++i) other[i] = find(i, place);
    });
    const auto at = std::find_if(other.begin(), other.end(), [](std::int32_t one) { return one >= 0; });
    Touching found;
    if (at == other.end()) return found;
    found.one = static_cast<std::int32_t>(at - other.begin());
    found.other = find(found.one, found.place);
    return found;
}

} // namespace

bool has_parts(const Mesh& mesh) noexcept { return mesh.report.components - mesh.report.left_out_components >= 2; }

Touching find_crossing(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                       const base::Progress& progress) {
    if (!has_parts(mesh)) return {};
    Touching found = first_of(runtime, mesh.faces(), progress, [&](std::int64_t face, glm::dvec3& place) {
        return pierced_by(mesh, tree, face, place);
    });
    if (found.one >= 0) found.one = mesh.component[found.one];
    return found;
}

namespace {

Touching find_beside(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
                     double near, double alike, const base::Progress& progress) {
    Touching found = first_of(runtime, places.position.size(), progress, [&](std::int64_t i, glm::dvec3& place) {
        place = places.position[i];
        return other_component(mesh, tree, places, i, near, alike);
    });
    if (found.one >= 0) found.one = mesh.component[places.face[found.one]];
    return found;
}

} // namespace

Touching find_touching(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
                       double near, const base::Progress& progress) {
    const Touching found = find_crossing(runtime, mesh, tree, progress);
    return found.one >= 0 ? found : find_beside(runtime, mesh, tree, places, near, 0.0, progress);
}

Touching find_near(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
                   double near, const base::Progress& progress) {
    return find_beside(runtime, mesh, tree, places, near, least_alike, progress);
}

Touching warn_of_touching(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                          const MeshSamples& places, double near, bool solids_apart, const base::Progress& progress) {
    if (!has_parts(mesh)) return {};
    Touching found = solids_apart ? find_near(runtime, mesh, tree, places, near, progress)
                                  : find_touching(runtime, mesh, tree, places, near, progress);
    if (found.one < 0) return {};
    found.may_cross = !solids_apart;
    runtime.log(base::LogLevel::warning,
                "mesh fit: parts %d and %d of the mesh, and maybe others, %s nearer to each other than the "
                "tolerance, as near %.4g %.4g %.4g: the surface may join them there; a smaller tolerance holds apart "
                "what does not cross",
                static_cast<int>(found.one), static_cast<int>(found.other), found.may_cross ? "cross or are" : "are",
                found.place.x, found.place.y, found.place.z);
    return found;
}

} // namespace hrbfnpr::mesh
