// SPDX-License-Identifier: MIT
// The orientation spreads from face to face across edges with two faces. Volumes are sums over the faces, and over fans
// of triangles that close holes. A component lies inside a closed component if rays from its faces cross the closed
// component an odd number of times.
#include "mesh/orient.h"

#include "base/random.h"
#include "mesh/edges.h"
#include "mesh/face_tree.h"
#include "mesh/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

[[nodiscard]] glm::dvec3 doubled_area_of(const base::Array<glm::dvec3>& vertex, const Triangle& t) noexcept {
    return doubled_area({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
}

// Returns the number of faces that run through an edge forward, minus the number that run backward.
[[nodiscard]] std::int64_t excess_faces(const Side* first, const Side* last) noexcept {
    std::int64_t sum = 0;
    for (const Side* side = first; side != last; ++side) sum += side->forward != 0 ? 1 : -1;
    return sum;
}

// Closes the holes of each component by fans of triangles, and adds the volumes between these fans and the middle of
// the component.
void close_holes(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle,
                 const base::Array<std::int32_t>& component, const base::Array<glm::dvec3>& middle,
                 base::Array<Component>& result) {
    const base::Array<Side> sides = sides_by_edge(work, triangle);
    UnionFind rims(work.memory, vertex.size());
    bool open = false;
    for_edges(sides, work, [&](const Side* first, const Side* last) {
        if (excess_faces(first, last) == 0) return;
        open = true;
        result[component[first->face]].closed = false;
        rims.join(low_end(*first), high_end(*first));
    });
    if (!open) return;
    // For each rim of a hole: the sum of the positions of its sides' ends, and the count of these ends.
    base::Array<glm::dvec4> rim(work.memory, vertex.size());
    for_edges(sides, work, [&](const Side* first, const Side* last) {
        if (excess_faces(first, last) == 0) return;
        for (const std::int32_t end : {low_end(*first), high_end(*first)})
            rim[rims.find(end)] += glm::dvec4(vertex[end], 1.0);
    });
    for_edges(sides, work, [&](const Side* first, const Side* last) {
        const auto more = static_cast<double>(excess_faces(first, last));
        if (more == 0.0) return;
        const std::int32_t a = low_end(*first);
        const glm::dvec4& sum = rim[rims.find(a)];
        const glm::dvec3 apex = glm::dvec3(sum) / sum.w;
        const glm::dvec3 area = more * doubled_area({apex, vertex[high_end(*first)], vertex[a]});
        Component& of = result[component[first->face]];
        of.holes += 0.5 * glm::length(area);
        of.volume += glm::dot(apex - middle[component[first->face]], area) / 6.0;
    });
}

// ---- Nested components

constexpr std::int64_t places_of_face = 4; // the middle, and a place near each corner

// Returns one of a face's test places. On a large face, places near its corners are farther out than its middle.
[[nodiscard]] glm::dvec3 place_of_face(const std::array<glm::dvec3, 3>& corners, std::int64_t number) noexcept {
    HRBFNPR_ASSERT(number >= 0 && number < places_of_face);
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    return number == 0 ? middle : glm::mix(corners[static_cast<std::size_t>(number - 1)], middle, 0.01);
}

// Calls visit(value, count) for each value in a sorted array.
template <class Visit>
void for_values(const base::Array<std::int32_t>& sorted, Visit&& visit) {
    HRBFNPR_ASSERT(std::is_sorted(sorted.begin(), sorted.end()));
    for (const std::int32_t *at = sorted.begin(), *next = at; at != sorted.end(); at = next) {
        next = std::upper_bound(at, sorted.end(), *at);
        visit(*at, next - at);
    }
}

// Returns in rising order the components that enclose a place: most rays from the place cross them an odd number of
// times.
[[nodiscard]] base::Array<std::int32_t>
components_around(const FaceTree& tree, const base::Array<std::int32_t>& component, const glm::dvec3& from) {
    base::Array<std::int32_t> met(component.memory());
    base::Array<std::int32_t> odd(component.memory());
    base::Array<std::int32_t> around(component.memory());
    for (const glm::dvec3& direction : ray_directions) {
        met.clear();
        tree.crossings(from, direction, [&](std::int64_t face, double, int) { met.push_back(component[face]); });
        std::sort(met.begin(), met.end());
        for_values(met, [&](std::int32_t one, std::ptrdiff_t count) {
            if (count % 2 == 1) odd.push_back(one);
        });
    }
    std::sort(odd.begin(), odd.end());
    for_values(odd, [&](std::int32_t one, std::ptrdiff_t count) {
        if (count >= 2) around.push_back(one);
    });
    return around;
}

// Returns the faces with the extreme corners along each axis, and one random face from each of several ranges of face
// indices. Every n-th face would be a bad choice: in a mesh of rows and columns, these may all lie in one column.
[[nodiscard]] base::Array<std::int32_t> faces_to_test(const base::Array<glm::dvec3>& vertex,
                                                      const base::Array<Triangle>& triangle,
                                                      std::span<const std::int32_t> faces) {
    HRBFNPR_ASSERT(!faces.empty());
    std::array<double, 6> reach;
    reach.fill(-std::numeric_limits<double>::infinity());
    base::Array<std::int32_t> result(triangle.memory(), 6);
    for (const std::int32_t face : faces)
        for (const std::int32_t corner : triangle[face])
            for (std::size_t way = 0; way < reach.size(); ++way) {
                const double along = vertex[corner][static_cast<glm::length_t>(way / 2)];
                const double far = way % 2 == 0 ? along : -along;
                if (far <= reach[way]) continue;
                reach[way] = far;
                result[static_cast<std::int64_t>(way)] = face;
            }
    const auto count = static_cast<std::int64_t>(faces.size());
    const std::int64_t tests = std::min(mesh_tuning.tested_faces, count);
    for (std::int64_t k = 0; k < tests; ++k) {
        const double share = base::uniform4(0, static_cast<std::uint64_t>(k), base::Purpose::probe)[0];
        const double at = (static_cast<double>(k) + share) * static_cast<double>(count) / static_cast<double>(tests);
        result.push_back(faces[static_cast<std::size_t>(std::min(static_cast<std::int64_t>(at), count - 1))]);
    }
    return result;
}

} // namespace

std::int64_t orient_consistently(const base::Work& work, const base::Array<glm::dvec3>& vertex,
                                 base::Array<Triangle>& triangle) {
    const base::Array<std::int64_t> beyond = sides_beyond(triangle, sides_by_edge(work, triangle), work);
    // 1 if the face has the orientation of the first face of its patch, -1 if it has the opposite one
    base::Array<std::int8_t> way(work.memory, triangle.size());
    base::Array<std::int32_t> patch(work.memory);
    std::int64_t turned = 0;
    for (std::int64_t first = 0; first < triangle.size(); ++first) {
        if (way[first] != 0) continue;
        work.check();
        patch.clear();
        patch.push_back(static_cast<std::int32_t>(first));
        way[first] = 1;
        double balance = 0.0; // the area of the faces that agree with the first face, minus the area of the other faces
        for (std::int64_t at = 0; at < patch.size(); ++at) {
            work.check();
            const std::int32_t face = patch[at];
            balance += way[face] * glm::length(doubled_area_of(vertex, triangle[face]));
            for (std::int64_t k = 3 * std::int64_t{face}; k < 3 * std::int64_t{face} + 3; ++k) {
                const auto other = static_cast<std::int32_t>(beyond[k] / 3);
                if (beyond[k] < 0 || way[other] != 0) continue;
                way[other] = static_cast<std::int8_t>(run_opposite(triangle, k, beyond[k]) ? way[face] : -way[face]);
                patch.push_back(other);
            }
        }
        for (const std::int32_t face : patch) {
            if ((way[face] > 0) == (balance >= 0.0)) continue;
            turn(triangle[face]);
            ++turned;
        }
    }
    return turned;
}

base::Array<Component> measure_components(const base::Work& work, const base::Array<glm::dvec3>& vertex,
                                          const base::Array<Triangle>& triangle,
                                          const base::Array<std::int32_t>& component, std::int64_t count) {
    HRBFNPR_ASSERT(component.size() == triangle.size());
    base::Array<Component> result(work.memory);
    result.resize_for_overwrite(count);
    std::fill(result.begin(), result.end(), Component{});
    base::Array<glm::dvec3> middle(work.memory, count);
    for (const std::int64_t face : work.over(triangle.size())) {
        ++result[component[face]].faces;
        for (const std::int32_t corner : triangle[face]) middle[component[face]] += vertex[corner];
    }
    for (std::int64_t i = 0; i < count; ++i) middle[i] /= 3.0 * static_cast<double>(result[i].faces);
    for (const std::int64_t face : work.over(triangle.size())) {
        Component& of = result[component[face]];
        const glm::dvec3 area = doubled_area_of(vertex, triangle[face]);
        of.area += 0.5 * glm::length(area);
        of.volume += glm::dot(vertex[triangle[face][0]] - middle[component[face]], area) / 6.0;
    }
    close_holes(work, vertex, triangle, component, middle, result);
    return result;
}

bool inside_out(const Component& component) noexcept {
    const bool has_inside = component.closed || component.holes < mesh_tuning.small_holes * component.area;
    return has_inside && component.volume < 0.0;
}

void find_nested(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle,
                 const base::Array<std::int32_t>& component, base::Array<Component>& measured) {
    if (measured.size() < 2) return;
    const FaceTree tree(work, vertex, triangle);
    const base::Groups faces(work.memory, measured.size(), [&](auto&& put) {
        for (std::int64_t face = 0; face < component.size(); ++face)
            put(component[face], static_cast<std::int32_t>(face));
    });
    work.for_each(measured.size(), [&](std::int64_t i) {
        base::Array<std::int32_t> holders(work.memory); // the closed components around all tested places
        const base::Array<std::int32_t> tested = faces_to_test(vertex, triangle, faces[i]);
        for (std::int64_t k = 0; k < places_of_face * tested.size(); ++k) {
            const Triangle& t = triangle[tested[k / places_of_face]];
            const glm::dvec3 place = place_of_face({vertex[t[0]], vertex[t[1]], vertex[t[2]]}, k % places_of_face);
            base::Array<std::int32_t> here = components_around(tree, component, place);
            std::int64_t kept = 0;
            for (const std::int32_t other : here) {
                const bool before = k == 0 || std::binary_search(holders.begin(), holders.end(), other);
                if (other != i && measured[other].closed && before) here[kept++] = other;
            }
            here.resize(kept);
            holders = std::move(here);
            if (holders.empty()) return;
        }
        measured[i].around = static_cast<std::int32_t>(holders.size());
    });
}

} // namespace hrbfnpr::mesh
