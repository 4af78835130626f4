// SPDX-License-Identifier: MIT
#include "mesh/orient.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// An open component has an inside if its holes have less than this share of its area.
constexpr double small_holes = 0.25;

constexpr std::int64_t turned_a_look = 16384;

// Across each side of each face: the other face, and whether the two agree; none where not exactly two faces meet.
struct Across {
    std::int32_t face = -1;
    std::int32_t agrees = 0;
};

[[nodiscard]] base::Array<Across> across_of(const base::Runtime& runtime, const base::Array<Triangle>& triangle,
                                            const base::Progress& progress) {
    const base::Array<Side> sides = sides_by_edge(runtime, triangle, progress);
    base::Array<Across> across(runtime.memory);
    across.resize_for_overwrite(3 * triangle.size());
    std::fill(across.begin(), across.end(), Across{});
    const auto place = [&](const Side& side) -> Across& {
        for (std::int64_t k = 3 * static_cast<std::int64_t>(side.face);; ++k) {
            const Triangle& t = triangle[side.face];
            const auto corner = static_cast<std::size_t>(k % 3);
            const auto a = static_cast<std::uint64_t>(t[corner]);
            const auto b = static_cast<std::uint64_t>(t[(corner + 1) % 3]);
            if ((std::min(a, b) << 32U | std::max(a, b)) == side.edge) return across[k];
        }
    };
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        if (last - first != 2) return;
        const std::int32_t agrees = first[0].forward != first[1].forward ? 1 : 0;
        place(first[0]) = {first[1].face, agrees};
        place(first[1]) = {first[0].face, agrees};
    });
    return across;
}

// How much more often the faces at an edge run through it forward than backward.
[[nodiscard]] std::int64_t surplus(const Side* first, const Side* last) noexcept {
    std::int64_t sum = 0;
    for (const Side* side = first; side != last; ++side) sum += side->forward != 0 ? 1 : -1;
    return sum;
}

[[nodiscard]] std::array<std::int32_t, 2> ends_of(const Side& side) noexcept {
    return {static_cast<std::int32_t>(side.edge >> 32U), static_cast<std::int32_t>(side.edge & 0xffffffffU)};
}

// Adds to each component's volume what fans about the middles of its holes enclose.
void close_holes(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                 const base::Array<Triangle>& triangle, const base::Array<std::int32_t>& component,
                 const base::Array<glm::dvec3>& middle, base::Array<Component>& result,
                 const base::Progress& progress) {
    const base::Array<Side> sides = sides_by_edge(runtime, triangle, progress);
    Sets rims(runtime.memory, vertex.size());
    bool open = false;
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        Component& of = result[component[first->face]];
        of.manifold = of.manifold && last - first == 2;
        if (surplus(first, last) == 0) return;
        open = true;
        of.closed = false;
        rims.join(ends_of(*first)[0], ends_of(*first)[1]);
    });
    if (!open) return;
    base::Array<glm::dvec4> rim(runtime.memory, vertex.size()); // sum of the ends, and their number
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        if (surplus(first, last) == 0) return;
        for (const std::int32_t end : ends_of(*first)) rim[rims.of(end)] += glm::dvec4(vertex[end], 1.0);
    });
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        const auto more = static_cast<double>(surplus(first, last));
        if (more == 0.0) return;
        const auto [a, b] = ends_of(*first);
        const glm::dvec4& sum = rim[rims.of(a)];
        const glm::dvec3 apex = glm::dvec3(sum) / sum.w;
        const glm::dvec3 area = more * doubled_area({apex, vertex[b], vertex[a]});
        Component& of = result[component[first->face]];
        of.holes += 0.5 * glm::length(area);
        of.volume += glm::dot(apex - middle[component[first->face]], area) / 6.0;
    });
}

} // namespace

void turn(Triangle& triangle) noexcept { std::swap(triangle[1], triangle[2]); }

std::int64_t agree(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                   const base::Progress& progress) {
    const base::Array<Across> across = across_of(runtime, triangle, progress);
    base::Array<std::int8_t> way(runtime.memory, triangle.size()); // 1 as the first of its patch, -1 against it
    base::Array<std::int32_t> patch(runtime.memory);
    std::int64_t turned = 0;
    for (std::int64_t first = 0; first < triangle.size(); ++first) {
        if (way[first] != 0) continue;
        progress.check();
        patch.clear();
        patch.push_back(static_cast<std::int32_t>(first));
        way[first] = 1;
        double balance = 0.0; // of area
        for (std::int64_t at = 0; at < patch.size(); ++at) {
            if (at % 4096 == 0) progress.check();
            const std::int32_t face = patch[at];
            const Triangle& t = triangle[face];
            balance += way[face] * glm::length(doubled_area({vertex[t[0]], vertex[t[1]], vertex[t[2]]}));
            for (std::int64_t k = 3 * std::int64_t{face}; k < 3 * std::int64_t{face} + 3; ++k) {
                if (across[k].face < 0 || way[across[k].face] != 0) continue;
                way[across[k].face] = static_cast<std::int8_t>(across[k].agrees != 0 ? way[face] : -way[face]);
                patch.push_back(across[k].face);
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

base::Array<Component> measure_components(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                                          const base::Array<Triangle>& triangle,
                                          const base::Array<std::int32_t>& component, std::int64_t count,
                                          const base::Progress& progress) {
    base::Memory& memory = runtime.memory;
    base::Array<Component> result(memory);
    result.resize_for_overwrite(count);
    std::fill(result.begin(), result.end(), Component{});
    base::Array<glm::dvec3> middle(memory, count);
    for (std::int64_t face = 0; face < triangle.size(); ++face) {
        if (face % turned_a_look == 0) progress.check();
        ++result[component[face]].faces;
        for (const std::int32_t corner : triangle[face]) middle[component[face]] += vertex[corner];
    }
    for (std::int64_t i = 0; i < count; ++i) middle[i] /= 3.0 * static_cast<double>(result[i].faces);
    for (std::int64_t face = 0; face < triangle.size(); ++face) {
        if (face % turned_a_look == 0) progress.check();
        const Triangle& t = triangle[face];
        Component& of = result[component[face]];
        const glm::dvec3 area = doubled_area({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
        of.area += 0.5 * glm::length(area);
        of.volume += glm::dot(vertex[t[0]] - middle[component[face]], area) / 6.0;
    }
    close_holes(runtime, vertex, triangle, component, middle, result, progress);
    return result;
}

bool inside_out(const Component& component) noexcept {
    const bool has_inside = component.closed || component.holes < small_holes * component.area;
    return has_inside && component.volume < 0.0;
}

} // namespace hrbfnpr::mesh
