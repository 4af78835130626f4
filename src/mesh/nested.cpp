// SPDX-License-Identifier: MIT
#include "mesh/nested.h"

#include "mesh/face_tree.h"

#include <algorithm>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t tested_faces = 16;  // of a component ...
constexpr std::int64_t places_of_face = 4; // ... the middle of each, and next to its corners
// In no direction that edges of meshes have.
const std::array<glm::dvec3, 3> directions{glm::dvec3{0.5773, 0.2161, 0.7874}, glm::dvec3{-0.6431, 0.7321, 0.2247},
                                           glm::dvec3{0.1713, -0.5119, -0.8418}};

// Those of a face that is large reach farther out than its middle.
glm::dvec3 place_of_face(const std::array<glm::dvec3, 3>& corners, std::int64_t number) noexcept {
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    return number == 0 ? middle : glm::mix(corners[static_cast<std::size_t>(number - 1)], middle, 0.01);
}

// Components that a ray meets an odd number of times, ascending.
void met_oddly(const FaceTree& tree, const base::Array<std::int32_t>& component, const glm::dvec3& from,
               const glm::dvec3& direction, base::Array<std::int32_t>& met) {
    met.clear();
    tree.crossings(from, direction, [&](std::int64_t face, double, int) { met.push_back(component[face]); });
    std::sort(met.begin(), met.end());
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < met.size();) {
        std::int64_t next = i;
        while (next < met.size() && met[next] == met[i]) ++next;
        if ((next - i) % 2 == 1) met[kept++] = met[i];
        i = next;
    }
    met.resize(kept);
}

// Components that most rays from a place say to be around it.
void around(const FaceTree& tree, const base::Array<std::int32_t>& component, const glm::dvec3& from,
            base::Array<std::int32_t>& result) {
    base::Array<std::int32_t> met(result.memory());
    base::Array<std::int32_t> all(result.memory());
    for (const glm::dvec3& direction : directions) {
        met_oddly(tree, component, from, direction, met);
        for (const std::int32_t i : met) all.push_back(i);
    }
    std::sort(all.begin(), all.end());
    result.clear();
    for (std::int64_t i = 0; i + 1 < all.size(); ++i)
        if (all[i] == all[i + 1] && (result.empty() || result.back() != all[i])) result.push_back(all[i]);
}

} // namespace

void find_nested(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                 const base::Array<Triangle>& triangle, const base::Array<std::int32_t>& component,
                 base::Array<Component>& measured, const base::Progress& progress) {
    if (measured.size() < 2) return;
    const FaceTree tree(runtime, vertex, triangle, progress);
    base::Array<std::int64_t> begin(runtime.memory, measured.size() + 1); // faces by component
    for (std::int64_t i = 0; i < measured.size(); ++i) begin[i + 1] = begin[i] + measured[i].faces;
    base::Array<std::int64_t> next(runtime.memory);
    base::Array<std::int32_t> face(runtime.memory, triangle.size());
    for (std::int64_t i = 0; i < measured.size(); ++i) next.push_back(begin[i]);
    for (std::int64_t i = 0; i < triangle.size(); ++i) face[next[component[i]]++] = static_cast<std::int32_t>(i);
    runtime.parallel.for_each(measured.size(), [&](std::int64_t i) {
        progress.check();
        base::Array<std::int32_t> holders(runtime.memory); // closed ones that all tested places lie inside
        base::Array<std::int32_t> here(runtime.memory);
        const std::int64_t tests = std::min(tested_faces, measured[i].faces);
        for (std::int64_t k = 0; k < places_of_face * tests; ++k) {
            const Triangle& t = triangle[face[begin[i] + k / places_of_face * measured[i].faces / tests]];
            around(tree, component, place_of_face({vertex[t[0]], vertex[t[1]], vertex[t[2]]}, k % places_of_face),
                   here);
            std::int64_t kept = 0;
            for (const std::int32_t other : here) {
                const bool before = k == 0 || std::binary_search(holders.begin(), holders.end(), other);
                if (other != i && measured[other].closed && before) here[kept++] = other;
            }
            here.resize(kept);
            std::swap(holders, here);
            if (holders.empty()) return;
        }
        measured[i].nested = true;
    });
}

} // namespace hrbfnpr::mesh
