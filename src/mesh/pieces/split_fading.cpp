// SPDX-License-Identifier: MIT
// The steps of split_fading():
//
//   find_seeds      faces beside creases on both sides of which the same patch lies, and beside tips of such creases
//   spread_labels   each face of such a patch goes to the side of a crease that is nearest to it
//   number_parts    the parts become patches
//   split_winding   (split_winding.h) patches that wind around beside themselves are cut, too
//   add_bands       faces near a smooth cut belong to the sheets on both sides of it
#include "mesh/pieces/split_fading.h"

#include "base/assert.h"
#include "mesh/corners.h"
#include "mesh/pieces/split_winding.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <array>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The data that all steps read.
struct Patched {
    const Mesh& mesh;
    const Creases& creases;
    const base::Array<std::int32_t>& across; // the face beyond each side; -1: there is not exactly one

    [[nodiscard]] glm::dvec3 middle(std::int32_t face) const noexcept {
        const auto p = mesh.corners(face);
        return (p[0] + p[1] + p[2]) / 3.0;
    }
    // The patches on both sides of a crease, the lower number first.
    [[nodiscard]] std::array<std::int32_t, 2> pair_of(const Crease& crease) const noexcept {
        const std::int32_t a = creases.patch[crease.left];
        const std::int32_t b = creases.patch[crease.right];
        return {std::min(a, b), std::max(a, b)};
    }
};

base::Array<std::int32_t> faces_across(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Side>& sides,
                                       const base::Progress& progress) {
    base::Array<std::int32_t> across(runtime.memory);
    across.resize_for_overwrite(3 * mesh.faces());
    std::fill(across.begin(), across.end(), -1);
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        if (last - first != 2) return;
        across[number_of(mesh.triangle, first[0])] = first[1].face;
        across[number_of(mesh.triangle, first[1])] = first[0].face;
    });
    return across;
}

// ---- Seeds

struct Seeds {
    explicit Seeds(base::Memory& memory, std::int64_t vertices) : face(memory), on_crease(memory, vertices) {}

    base::Array<std::int32_t> face;      // faces beside creases on both sides of which the same patch lies
    base::Array<std::uint8_t> on_crease; // 1 for the vertices of these creases, but for their ends
};

// Where a step in a patch fades, its wall ends in a tip, around which the patch goes from one crease to the other: one
// sheet cannot be both above and below the wall there. Adds seeds along such creases, as far as they part the same two
// patches. `cuts` is the number of sides at each vertex that are cut: two for each crease.
void add_tips(const Patched& patched, const base::Array<std::int32_t>& cuts, Seeds& seeds) {
    const auto& [mesh, creases, across] = patched;
    base::Memory& memory = mesh.vertex.memory();
    const std::int64_t vertices = mesh.vertex.size();
    base::Array<std::array<std::int32_t, 2>> edge(memory, vertices); // the last creases at each vertex
    std::fill(edge.begin(), edge.end(), std::array<std::int32_t, 2>{-1, -1});
    for (std::int32_t i = 0; i < creases.edge.size(); ++i)
        for (const std::int32_t v : {creases.edge[i].from, creases.edge[i].to}) edge[v] = {i, edge[v][0]};
    base::Array<std::uint8_t> is_between_two(memory, vertices); // two patches meet at the vertex, and no others
    for (std::int64_t v = 0; v < vertices; ++v) {
        if (cuts[v] != 4 || edge[v][1] < 0) continue;
        const auto pair = patched.pair_of(creases.edge[edge[v][0]]);
        is_between_two[v] = pair[0] != pair[1] && pair == patched.pair_of(creases.edge[edge[v][1]]) ? 1 : 0;
    }
    base::Array<std::array<double, 2>> angle(memory, vertices); // of both patches there
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t v = mesh.triangle[face][k];
            if (is_between_two[v] == 0) continue;
            const bool is_first = creases.patch[face] == patched.pair_of(creases.edge[edge[v][0]])[0];
            angle[v][is_first ? 0 : 1] += angle_at(mesh.corners(face), k);
        }
    base::Array<std::uint8_t> passed(memory, creases.edge.size());
    base::Array<std::int32_t> tips(memory);
    for (std::int32_t tip = 0; tip < vertices; ++tip) {
        if (is_between_two[tip] == 0 || std::min(angle[tip][0], angle[tip][1]) > crease_tuning.widest_tip) continue;
        const std::int32_t around = patched.pair_of(creases.edge[edge[tip][0]])[angle[tip][0] < angle[tip][1] ? 1 : 0];
        for (const std::int32_t first : edge[tip]) {
            std::int32_t v = tip;
            for (std::int32_t i = first; passed[i] == 0;) {
                passed[i] = 1;
                const Crease& crease = creases.edge[i];
                seeds.face.push_back(creases.patch[crease.left] == around ? crease.left : crease.right);
                v = crease.from == v ? crease.to : crease.from;
                seeds.on_crease[v] = 1;
                if (is_between_two[v] == 0) break;
                i = edge[v][0] == i ? edge[v][1] : edge[v][0];
            }
        }
        tips.push_back(tip);
    }
    for (const std::int32_t v : tips) seeds.on_crease[v] = 0;
}

Seeds find_seeds(const Patched& patched) {
    const auto& [mesh, creases, across] = patched;
    base::Array<std::int32_t> cuts(mesh.vertex.memory(), mesh.vertex.size());
    for (std::int64_t side = 0; side < creases.cut.size(); ++side) {
        if (creases.cut[side] == 0) continue;
        const Triangle& t = mesh.triangle[side / 3];
        ++cuts[t[static_cast<std::size_t>(side % 3)]];
        ++cuts[t[static_cast<std::size_t>((side + 1) % 3)]];
    }
    Seeds seeds(mesh.vertex.memory(), mesh.vertex.size());
    for (const Crease& crease : creases.edge) {
        if (creases.patch[crease.left] != creases.patch[crease.right]) continue;
        for (const std::int32_t v : {crease.from, crease.to}) seeds.on_crease[v] = cuts[v] > 2 ? 1 : 0;
        for (const std::int32_t face : {crease.left, crease.right}) seeds.face.push_back(face);
    }
    add_tips(patched, cuts, seeds);
    return seeds;
}

// ---- Spreading

struct Reached {
    double distance;
    std::int32_t face;
    [[nodiscard]] bool operator<(const Reached& other) const noexcept { // the nearest is on top of a heap
        return distance > other.distance || (distance == other.distance && face > other.face);
    }
};

// Visits faces by their distance from those in the heap, over sides that are no creases: accept(face, from, distance of
// `from`, distance) tells whether the face is reached that way.
template <class Accept>
void spread(const Patched& patched, base::Array<Reached>& heap, Accept&& accept) {
    std::make_heap(heap.begin(), heap.end());
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end());
        const Reached at = heap.back();
        heap.resize(heap.size() - 1);
        for (int k = 0; k < 3; ++k) {
            const std::int64_t side = 3 * std::int64_t{at.face} + k;
            const std::int32_t face = patched.across[side];
            if (patched.creases.cut[side] == 1 || face < 0) continue;
            const double distance = at.distance + glm::distance(patched.middle(at.face), patched.middle(face));
            if (!accept(face, at.face, at.distance, distance)) continue;
            heap.push_back({distance, face});
            std::push_heap(heap.begin(), heap.end());
        }
    }
}

struct Labels {
    explicit Labels(base::Memory& memory, std::int64_t faces) : label(memory), distance(memory) {
        label.resize_for_overwrite(faces);
        distance.resize_for_overwrite(faces);
        std::fill(label.begin(), label.end(), -1);
        std::fill(distance.begin(), distance.end(), infinite);
    }

    base::Array<std::int32_t> label; // the side of a crease that each face is nearest to; -1: none is
    base::Array<double> distance;    // its distance from there
};

Labels spread_labels(const Patched& patched, const Seeds& seeds) {
    const auto& [mesh, creases, across] = patched;
    base::Memory& memory = mesh.vertex.memory();
    // Faces at the vertices of such a crease belong to one of its sides, but for its ends, where both sides are one.
    Sets sets(memory, mesh.faces());
    for (std::int64_t side = 0; side < creases.cut.size(); ++side) {
        if (creases.cut[side] != 0 || across[side] < 0) continue;
        const Triangle& t = mesh.triangle[side / 3];
        if (seeds.on_crease[t[static_cast<std::size_t>(side % 3)]] != 0 ||
            seeds.on_crease[t[static_cast<std::size_t>((side + 1) % 3)]] != 0)
            sets.join(static_cast<std::int32_t>(side / 3), across[side]);
    }
    Labels labels(memory, mesh.faces());
    base::Array<Reached> heap(memory);
    for (const std::int32_t face : seeds.face) {
        if (labels.distance[face] == 0.0) continue;
        labels.label[face] = sets.of(face);
        labels.distance[face] = 0.0;
        heap.push_back({0.0, face});
    }
    spread(patched, heap, [&](std::int32_t face, std::int32_t from, double before, double distance) {
        if (before > labels.distance[from] || distance >= labels.distance[face]) return false;
        labels.distance[face] = distance;
        labels.label[face] = labels.label[from];
        return true;
    });
    return labels;
}

// ---- Parts

void number_parts(const Labels& labels, Creases& creases) {
    base::Memory& memory = creases.patch.memory();
    base::Array<std::int32_t> of_patch(memory, creases.patches); // of those that stay whole
    base::Array<std::int32_t> of_label(memory, creases.patch.size());
    std::int32_t count = 0;
    for (std::int64_t face = 0; face < creases.patch.size(); ++face) {
        const std::int32_t label = labels.label[face];
        std::int32_t& number = label < 0 ? of_patch[creases.patch[face]] : of_label[label];
        if (number == 0) number = ++count;
        creases.patch[face] = number - 1;
    }
    creases.patches = count;
}

// Lists the faces of one part that are near to a smooth cut, with the part beyond it.
base::Array<Creases::Shared> shared_bands(const Patched& patched, const Labels& labels) {
    const Mesh& mesh = patched.mesh;
    const Creases& creases = patched.creases;
    base::Memory& memory = mesh.vertex.memory();
    base::Array<double> from_cut(memory);
    base::Array<std::int32_t> other(memory); // the part that a face is near to
    from_cut.resize_for_overwrite(mesh.faces());
    other.resize_for_overwrite(mesh.faces());
    std::fill(from_cut.begin(), from_cut.end(), infinite);
    std::fill(other.begin(), other.end(), -1);
    base::Array<Reached> heap(memory);
    for (std::int64_t side = 0; side < creases.cut.size(); ++side) {
        const auto face = static_cast<std::int32_t>(side / 3);
        if (creases.cut[side] != 2 || from_cut[face] == 0.0) continue;
        from_cut[face] = 0.0;
        other[face] = creases.patch[patched.across[side]];
        heap.push_back({0.0, face});
    }
    const double widest = crease_tuning.widest_band * mesh.bounds.diagonal();
    spread(patched, heap, [&](std::int32_t face, std::int32_t from, double before, double distance) {
        if (before > from_cut[from] || distance >= from_cut[face]) return false;
        if (creases.patch[face] != creases.patch[from]) return false;
        if (distance > std::min(widest, crease_tuning.band_share * labels.distance[face])) return false;
        from_cut[face] = distance;
        other[face] = other[from];
        return true;
    });
    base::Array<Creases::Shared> shared(memory);
    for (std::int32_t face = 0; face < mesh.faces(); ++face)
        if (other[face] >= 0 && (from_cut[face] > 0.0 || labels.distance[face] > 0.0))
            shared.push_back({face, other[face]});
    return shared;
}

} // namespace

void split_fading(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases,
                  const base::Progress& progress) {
    HRBFNPR_ASSERT(creases.patch.size() == mesh.faces() && creases.cut.size() == 3 * mesh.faces());
    const base::Array<std::int32_t> across = faces_across(runtime, mesh, sides, progress);
    const Patched patched{mesh, creases, across};
    const Labels labels = spread_labels(patched, find_seeds(patched));
    progress.check();
    number_parts(labels, creases);
    split_winding(runtime, mesh, creases, progress);
    for (std::int64_t side = 0; side < creases.cut.size(); ++side)
        if (creases.cut[side] == 0 && across[side] >= 0 && creases.patch[across[side]] != creases.patch[side / 3])
            creases.cut[side] = 2;
    creases.shared = shared_bands(patched, labels);
}

} // namespace hrbfnpr::mesh
