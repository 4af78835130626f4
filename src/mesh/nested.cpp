// SPDX-License-Identifier: MIT
#include "mesh/nested.h"

#include "base/random.h"
#include "mesh/face_tree.h"

#include <algorithm>
#include <span>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t tested_faces = 64;  // of a component, and those that reach farthest along the axes ...
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

// Faces of every component.
class FacesOfComponents {
public:
    FacesOfComponents(const base::Array<std::int32_t>& component, const base::Array<Component>& measured)
        : begin_(measured.memory(), measured.size() + 1), face_(measured.memory(), component.size()) {
        for (std::int64_t i = 0; i < measured.size(); ++i) begin_[i + 1] = begin_[i] + measured[i].faces;
        base::Array<std::int64_t> next(measured.memory());
        for (std::int64_t i = 0; i < measured.size(); ++i) next.push_back(begin_[i]);
        for (std::int64_t i = 0; i < component.size(); ++i) face_[next[component[i]]++] = static_cast<std::int32_t>(i);
    }
    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t component) const noexcept {
        return face_.span().subspan(static_cast<std::size_t>(begin_[component]),
                                    static_cast<std::size_t>(begin_[component + 1] - begin_[component]));
    }

private:
    base::Array<std::int64_t> begin_;
    base::Array<std::int32_t> face_;
};

// Those with a corner that lies farthest along an axis, either way, and others: one at random of every so many, as
// every so many of a mesh of rows and columns may all lie at one place.
void faces_to_test(const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle,
                   std::span<const std::int32_t> faces, base::Array<std::int32_t>& result) {
    std::array<std::int32_t, 6> farthest;
    farthest.fill(faces[0]);
    std::array<double, 6> reach;
    reach.fill(-std::numeric_limits<double>::infinity());
    for (const std::int32_t face : faces)
        for (const std::int32_t corner : triangle[face])
            for (std::size_t way = 0; way < reach.size(); ++way) {
                const double along = vertex[corner][static_cast<glm::length_t>(way / 2)];
                const double far = way % 2 == 0 ? along : -along;
                if (far <= reach[way]) continue;
                reach[way] = far;
                farthest[way] = face;
            }
    result.clear();
    for (const std::int32_t face : farthest) result.push_back(face);
    const auto count = static_cast<std::int64_t>(faces.size());
    const std::int64_t tests = std::min(tested_faces, count);
    for (std::int64_t k = 0; k < tests; ++k) {
        const double share = base::uniform4(0, static_cast<std::uint64_t>(k), base::Purpose::probe)[0];
        const double at = (static_cast<double>(k) + share) * static_cast<double>(count) / static_cast<double>(tests);
        result.push_back(faces[static_cast<std::size_t>(std::min(static_cast<std::int64_t>(at), count - 1))]);
    }
}

} // namespace

void find_nested(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                 const base::Array<Triangle>& triangle, const base::Array<std::int32_t>& component,
                 base::Array<Component>& measured, const base::Progress& progress) {
    if (measured.size() < 2) return;
    const FaceTree tree(runtime, vertex, triangle, progress);
    const FacesOfComponents faces(component, measured);
    runtime.parallel.for_each(measured.size(), [&](std::int64_t i) {
        progress.check();
        base::Array<std::int32_t> holders(runtime.memory); // closed ones that all tested places lie inside
        base::Array<std::int32_t> here(runtime.memory);
        base::Array<std::int32_t> tested(runtime.memory);
        faces_to_test(vertex, triangle, faces.of(i), tested);
        for (std::int64_t k = 0; k < places_of_face * tested.size(); ++k) {
            const Triangle& t = triangle[tested[k / places_of_face]];
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
