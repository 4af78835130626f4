// SPDX-License-Identifier: MIT
// The steps of split_patches(), in order:
//
//   find_seeds      finds faces beside creases with the same patch on both sides, and beside tips of such creases
//   spread_labels   assigns each face of such a patch to the nearest side of a crease
//   number_parts    turns the parts into patches
//   split_winding   cuts patches that wind around beside themselves
//     measure_ways    measures the lengths of paths along edges from one end of the patch to its faces
//     turn_of         finds the path length from one turn to the next, from faces beside or above each other
//   shared_bands    finds the faces near a smooth cut, which belong to the sheets on both sides of it
#include "mesh/pieces/split_patches.h"

#include "base/assert.h"
#include "geometry/point_tree.h"
#include "mesh/edges.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The data that all steps read.
struct PatchedMesh {
    const Mesh& mesh;
    const Creases& creases;
    const base::Array<std::int64_t>& beyond; // for each side: sides_beyond()

    // Returns the face on the other side of a side's edge, or -1.
    [[nodiscard]] std::int32_t across(std::int64_t side) const noexcept {
        return beyond[side] < 0 ? -1 : static_cast<std::int32_t>(beyond[side] / 3);
    }

    // Returns the two patches at a crease, the one with the lower index first.
    [[nodiscard]] std::array<std::int32_t, 2> pair_of(const Crease& crease) const noexcept {
        const std::int32_t a = creases.patch[crease.left];
        const std::int32_t b = creases.patch[crease.right];
        return {std::min(a, b), std::max(a, b)};
    }
};

// ---- Seeds

struct Seeds {
    explicit Seeds(base::Memory& memory, std::int64_t vertices) : face(memory), on_crease(memory, vertices) {}

    base::Array<std::int32_t> face; // faces at creases that have the same patch on both sides
    // For each vertex: 1 if it is on a crease with the same patch on both sides, but not at an end of the crease.
    base::Array<std::uint8_t> on_crease;
};

// Adds seeds at tips. Where a step in the surface fades out, its wall ends in a tip, and another patch passes around
// the tip from the crease above the wall to the crease below it. One sheet cannot represent both. So seeds are added
// along these creases, as long as they separate the same two patches. `cuts` is the number of cut sides at each vertex:
// two for each crease.
void add_tips(const PatchedMesh& patched, const base::Array<std::int32_t>& cuts, Seeds& seeds) {
    const Mesh& mesh = patched.mesh;
    const Creases& creases = patched.creases;
    base::Memory& memory = mesh.vertex.memory();
    const std::int64_t vertices = mesh.vertex.size();
    // For each vertex: the last two creases found there.
    base::Array<std::array<std::int32_t, 2>> edge(memory, vertices);
    std::fill(edge.begin(), edge.end(), std::array<std::int32_t, 2>{-1, -1});
    for (std::int32_t i = 0; i < creases.edge.size(); ++i)
        for (const std::int32_t v : {creases.edge[i].from, creases.edge[i].to}) edge[v] = {i, edge[v][0]};
    base::Array<std::uint8_t> is_between_two(memory, vertices); // for each vertex: 1 if exactly two patches meet there
    for (std::int64_t v = 0; v < vertices; ++v) {
        if (cuts[v] != 4 || edge[v][1] < 0) continue;
        const auto pair = patched.pair_of(creases.edge[edge[v][0]]);
        is_between_two[v] = pair[0] != pair[1] && pair == patched.pair_of(creases.edge[edge[v][1]]) ? 1 : 0;
    }
    base::Array<std::array<double, 2>> angle(memory, vertices); // for each vertex: the angle of each of the two patches
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

Seeds find_seeds(const PatchedMesh& patched) {
    const Mesh& mesh = patched.mesh;
    const Creases& creases = patched.creases;
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

// A face or a vertex with the distance at which it was reached.
struct QueueEntry {
    double distance;
    std::int32_t number;
    // The order makes the nearest one the top of the heap.
    [[nodiscard]] bool operator<(const QueueEntry& other) const noexcept {
        return distance > other.distance || (distance == other.distance && number > other.number);
    }
};

class DistanceQueue {
public:
    explicit DistanceQueue(base::Memory& memory) noexcept : heap_(memory) {}
    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    void add(const QueueEntry& one) {
        heap_.push_back(one);
        std::push_heap(heap_.begin(), heap_.end());
    }
    [[nodiscard]] QueueEntry take() noexcept {
        HRBFNPR_ASSERT(!heap_.empty());
        std::pop_heap(heap_.begin(), heap_.end());
        const QueueEntry nearest = heap_.back();
        heap_.resize(heap_.size() - 1);
        return nearest;
    }

private:
    base::Array<QueueEntry> heap_;
};

// Visits faces in the order of their distance from those in `reached`, without crossing creases. accept(face, from,
// distance of `from`, distance) returns whether the face is reached in this way.
template <class Accept>
void spread(const PatchedMesh& patched, DistanceQueue& reached, Accept&& accept) {
    while (!reached.empty()) {
        const QueueEntry at = reached.take();
        for (int k = 0; k < 3; ++k) {
            const std::int64_t side = 3 * std::int64_t{at.number} + k;
            const std::int32_t face = patched.across(side);
            if (patched.creases.cut[side] == 1 || face < 0) continue;
            const double distance =
                at.distance + glm::distance(middle_of(patched.mesh, at.number), middle_of(patched.mesh, face));
            if (!accept(face, at.number, at.distance, distance)) continue;
            reached.add({distance, face});
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

    base::Array<std::int32_t> label; // for each face: the nearest side of a crease, or -1
    base::Array<double> distance;    // for each face: the distance to the nearest crease
};

Labels spread_labels(const PatchedMesh& patched, const Seeds& seeds) {
    const Mesh& mesh = patched.mesh;
    const Creases& creases = patched.creases;
    base::Memory& memory = mesh.vertex.memory();
    // If a crease has the same patch on both sides, the faces at its vertices belong to one side or the other. At its
    // ends both sides are connected, so these vertices are left out.
    UnionFind sets(memory, mesh.faces());
    for (std::int64_t side = 0; side < creases.cut.size(); ++side) {
        if (creases.cut[side] != 0 || patched.across(side) < 0) continue;
        const Triangle& t = mesh.triangle[side / 3];
        if (seeds.on_crease[t[static_cast<std::size_t>(side % 3)]] != 0 ||
            seeds.on_crease[t[static_cast<std::size_t>((side + 1) % 3)]] != 0)
            sets.join(static_cast<std::int32_t>(side / 3), patched.across(side));
    }
    Labels labels(memory, mesh.faces());
    DistanceQueue reached(memory);
    for (const std::int32_t face : seeds.face) {
        if (labels.distance[face] == 0.0) continue;
        labels.label[face] = sets.find(face);
        labels.distance[face] = 0.0;
        reached.add({0.0, face});
    }
    spread(patched, reached, [&](std::int32_t face, std::int32_t from, double before, double distance) {
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
    const std::int64_t faces = creases.patch.size();
    // In the numbering, the labels come first, then the patches that stay whole.
    NumbersByFirstUse numbers(memory, faces + creases.patches);
    for (std::int64_t face = 0; face < faces; ++face) {
        const std::int32_t label = labels.label[face];
        creases.patch[face] = numbers.of(label < 0 ? faces + creases.patch[face] : label);
    }
    creases.patches = numbers.count();
}

// For each part, lists the faces of other parts near its smooth cuts.
base::Array<Creases::Shared> shared_bands(const PatchedMesh& patched, const Labels& labels) {
    const Mesh& mesh = patched.mesh;
    const Creases& creases = patched.creases;
    base::Memory& memory = mesh.vertex.memory();
    base::Array<double> from_cut(memory);
    base::Array<std::int32_t> other(memory); // for each face: the part beyond a smooth cut nearby, or -1
    from_cut.resize_for_overwrite(mesh.faces());
    other.resize_for_overwrite(mesh.faces());
    std::fill(from_cut.begin(), from_cut.end(), infinite);
    std::fill(other.begin(), other.end(), -1);
    DistanceQueue reached(memory);
    for (std::int64_t side = 0; side < creases.cut.size(); ++side) {
        const auto face = static_cast<std::int32_t>(side / 3);
        if (creases.cut[side] != 2 || from_cut[face] == 0.0) continue;
        from_cut[face] = 0.0;
        other[face] = creases.patch[patched.across(side)];
        reached.add({0.0, face});
    }
    const double widest = crease_tuning.widest_band * mesh.bounds.diagonal();
    spread(patched, reached, [&](std::int32_t face, std::int32_t from, double before, double distance) {
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

// ---- Patches that wind around

using Patch = std::span<const std::int32_t>; // the indices of a patch's faces

// Computes the lengths of paths on a patch from one face to all others. Returns the farthest face that is connected
// with it. Paths follow edges: through the middles of slivers, they would be zigzags.
[[nodiscard]] std::int32_t measure_ways(const Mesh& mesh, const Creases& creases, const base::Groups& corners,
                                        std::int32_t from, Patch patch, base::Array<double>& to_vertex,
                                        base::Array<double>& way) {
    for (const std::int32_t face : patch)
        for (const std::int32_t v : mesh.triangle[face]) to_vertex[v] = infinite;
    DistanceQueue reached(way.memory());
    const auto reach = [&](std::int32_t vertex, double length) {
        if (length >= to_vertex[vertex]) return;
        to_vertex[vertex] = length;
        reached.add({length, vertex});
    };
    reach(mesh.triangle[from][0], 0.0);
    while (!reached.empty()) {
        const QueueEntry at = reached.take();
        if (at.distance > to_vertex[at.number]) continue;
        for (const std::int32_t corner : corners[at.number])
            if (creases.patch[corner / 3] == creases.patch[from])
                for (const std::int32_t v : mesh.triangle[corner / 3])
                    reach(v, at.distance + glm::distance(mesh.vertex[at.number], mesh.vertex[v]));
    }
    std::int32_t last = from;
    for (const std::int32_t face : patch) {
        const Triangle& t = mesh.triangle[face];
        way[face] = (to_vertex[t[0]] + to_vertex[t[1]] + to_vertex[t[2]]) / 3.0;
        if (way[face] < infinite && way[face] > way[last]) last = face;
    }
    return last;
}

// Returns the path length from one turn of a winding patch to the next, or infinity if the patch does not wind.
[[nodiscard]] double turn_of(const Mesh& mesh, Patch patch, const base::Array<double>& way,
                             const base::Progress& progress) {
    const double diagonal = mesh.bounds.diagonal();
    const glm::dvec3 first = unit_normal(mesh, patch[0]);
    const bool flat = std::all_of(patch.begin(), patch.end(), [&](std::int32_t face) {
        return glm::dot(unit_normal(mesh, face), first) > winding_tuning.flat;
    });
    const auto are_turns = [&](std::int32_t a, std::int32_t b) {
        const double around = std::abs(way[a] - way[b]);
        const glm::dvec3 off = middle_of(mesh, b) - middle_of(mesh, a);
        const double distance = glm::length(off);
        const glm::dvec3 n = unit_normal(mesh, a);
        return around > std::max(winding_tuning.way_around * distance, winding_tuning.least_way * diagonal) &&
               distance < winding_tuning.layers_apart * diagonal &&
               (!flat || std::abs(glm::dot(off, n)) > winding_tuning.along_normal * distance) &&
               glm::dot(n, unit_normal(mesh, b)) > winding_tuning.same_way;
    };
    const auto known = static_cast<std::size_t>(winding_tuning.known);
    const std::size_t step = (patch.size() + known - 1) / known;
    geometry::VecArray place(mesh.vertex.memory());
    for (std::size_t i = 0; i < patch.size(); i += step) place.push_back(middle_of(mesh, patch[i]));
    const geometry::PointTree tree(place, progress);
    const auto face_at = [&](std::int64_t at) { return patch[static_cast<std::size_t>(tree.index(at)) * step]; };
    const std::size_t count = std::min(static_cast<std::size_t>(winding_tuning.probes), patch.size());
    base::Array<double> around(mesh.vertex.memory());
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t face = patch[k * patch.size() / count];
        std::int64_t found = 0;
        const std::int64_t any = tree.nearest(
            middle_of(mesh, face), 1, [](std::int64_t) { return true; },
            [&](std::int64_t at) { return are_turns(face, face_at(at)); }, &found);
        if (any > 0) around.push_back(std::abs(way[face] - way[face_at(found)]));
    }
    if (around.empty() || 2 * around.size() < static_cast<std::int64_t>(count)) return infinite;
    // The lower quartile of the path lengths is more robust than their minimum. Where a flank ends in a flat, a few
    // faces have a very short path to a place above them.
    double* const quarter = around.begin() + around.size() / 4;
    std::nth_element(around.begin(), quarter, around.end());
    return *quarter;
}

// Cuts patches that wind beside themselves, such as the flanks of a screw thread, into parts of at most half a turn. A
// sheet through turns above each other that face the same way would need another zero between them. A sheet of many
// turns beside each other would be evaluated everywhere, with all its centres.
void split_winding(const base::Work& work, const Mesh& mesh, Creases& creases) {
    HRBFNPR_ASSERT(creases.patch.size() == mesh.faces());
    const base::Groups corners = corners_at_vertices(mesh, work);
    const base::Groups patches(work.memory, creases.patches, [&](auto&& put) {
        for (std::int32_t face = 0; face < mesh.faces(); ++face) put(creases.patch[face], face);
    });
    base::Array<double> to_vertex(work.memory, mesh.vertex.size());
    base::Array<double> way(work.memory, mesh.faces()); // for each face: the path length from one end of its patch
    // For each face: the part of its patch that it belongs to.
    base::Array<std::int32_t> part(work.memory, mesh.faces());
    bool any = false;
    for (std::int32_t p = 0; p < creases.patches; ++p) {
        work.check();
        const Patch patch = patches[p];
        const std::int32_t end = measure_ways(mesh, creases, corners, patch[0], patch, to_vertex, way);
        const double length = way[measure_ways(mesh, creases, corners, end, patch, to_vertex, way)];
        if (length < winding_tuning.least_way * mesh.bounds.diagonal()) continue;
        const double turn = turn_of(mesh, patch, way, work);
        if (turn == infinite) continue;
        const double parts =
            std::clamp(std::ceil(length / (winding_tuning.part_of_turn * turn)), 1.0, winding_tuning.most_parts);
        for (const std::int32_t face : patch) {
            const double share = std::min(way[face] / length, 1.0);
            part[face] = static_cast<std::int32_t>(std::min(parts - 1.0, std::floor(parts * share)));
        }
        any = any || parts > 1.0;
    }
    if (!any) return;
    const auto most = static_cast<std::int64_t>(winding_tuning.most_parts);
    NumbersByFirstUse numbers(work.memory, most * creases.patches);
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        creases.patch[face] = numbers.of(most * creases.patch[face] + part[face]);
    creases.patches = numbers.count();
}

} // namespace

void split_patches(const base::Work& work, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases) {
    HRBFNPR_ASSERT(creases.patch.size() == mesh.faces() && creases.cut.size() == 3 * mesh.faces());
    const base::Array<std::int64_t> beyond = sides_beyond(mesh.triangle, sides, work);
    const PatchedMesh patched{mesh, creases, beyond};
    const Labels labels = spread_labels(patched, find_seeds(patched));
    work.check();
    number_parts(labels, creases);
    split_winding(work, mesh, creases);
    for (std::int64_t side = 0; side < creases.cut.size(); ++side)
        if (creases.cut[side] == 0 && beyond[side] >= 0 &&
            creases.patch[patched.across(side)] != creases.patch[side / 3])
            creases.cut[side] = 2;
    creases.shared = shared_bands(patched, labels);
}

} // namespace hrbfnpr::mesh
