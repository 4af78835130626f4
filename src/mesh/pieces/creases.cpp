// SPDX-License-Identifier: MIT
// The steps of find_creases(), in order:
//
//   find_bent_edges          finds edges that bend; those that bend by more than the angle are sharp
//   extend_creases           extends sharp edges that end, along edges that bend less
//   sharpen_between_corners  makes edges from one corner of creases to another sharp
//   find_patches             makes one patch of the faces that no sharp edge separates
//   sharpen_coarse           makes the edges of coarse faces that are far from a round surface sharp
//   drop_short_fading        drops short creases that separate nothing, as noise
//   join_scraps              joins patches of a few small faces with a neighbouring patch
//   split_patches            (split_patches.h) cuts patches that one sheet cannot represent, where they are smooth
#include "mesh/pieces/creases.h"

#include "base/assert.h"
#include "mesh/edges.h"
#include "mesh/pieces/patches.h"
#include "mesh/pieces/split_patches.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

constexpr double radians = 0.017453292519943295;
constexpr double no_crease = 180.0;

// All steps read this data.
struct CreaseTask {
    const base::Work& work;
    const Mesh& mesh;
    const base::Array<Side>& sides;
    // The limits beyond which edges are sharp: one element for all faces, or several. `of_face` then gives the index
    // for each face.
    const base::Array<Sharpness>& sharpness;
    const base::Array<std::int32_t>& of_face;

    [[nodiscard]] const Sharpness& sharpness_of(std::int32_t face) const noexcept {
        return sharpness[sharpness.size() == 1 ? 0 : of_face[face]];
    }
    [[nodiscard]] double limit_of(std::int32_t face) const noexcept { return sharpness_of(face).angle * radians; }
};

// An edge that bends.
struct BentEdge {
    std::int32_t from, to;
    std::int32_t left, right;
    double angle; // in radians
    bool sharp;

    [[nodiscard]] std::int32_t other_end(std::int32_t end) const noexcept { return from == end ? to : from; }
};

struct BentEdges {
    base::Array<BentEdge> edge;
    base::Groups at;                  // for each vertex: the indices in `edge` of the edges that end there
    base::Array<std::int32_t> degree; // for each vertex: the number of creases and patch borders there

    void sharpen(std::int64_t i) noexcept {
        HRBFNPR_ASSERT(!edge[i].sharp);
        edge[i].sharp = true;
        ++degree[edge[i].from];
        ++degree[edge[i].to];
    }
};

bool is_plain(const Side* first, const Side* last) noexcept {
    return last - first == 2 && first[0].forward != first[1].forward;
}

double length_of(const Mesh& mesh, const BentEdge& bend) noexcept {
    return glm::distance(mesh.vertex[bend.from], mesh.vertex[bend.to]);
}

bool is_fading(const Creases& creases, const BentEdge& bend) noexcept {
    return bend.sharp && creases.patch[bend.left] == creases.patch[bend.right];
}

// Finds the edges that bend. `known` are edges that are sharp already, in the order of the sides. Other edges may
// become sharp if `may_be_sharp`, indexed by the side of the left face, is not 0. If `may_be_sharp` is empty, all edges
// may.
BentEdges find_bent_edges(const CreaseTask& task, const base::Array<Crease>& known,
                          const base::Array<std::uint8_t>& may_be_sharp) {
    const Mesh& mesh = task.mesh;
    base::Array<BentEdge> edge(task.work.memory);
    base::Array<std::int32_t> degree(task.work.memory, mesh.vertex.size());
    const base::Array<glm::dvec3> normal = unit_normals(mesh, task.work);
    const Crease* next_known = known.begin();
    for_edges(task.sides, task.work, [&](const Side* first, const Side* last) {
        const std::int32_t from = low_end(*first);
        const std::int32_t to = high_end(*first);
        if (!is_plain(first, last)) { // A patch ends at this edge, so a crease may end here, too.
            ++degree[from];
            ++degree[to];
            return;
        }
        const std::int32_t left = first[0].forward != 0 ? first[0].face : first[1].face;
        const std::int32_t right = first[0].forward != 0 ? first[1].face : first[0].face;
        const glm::dvec3 a = normal[left];
        const glm::dvec3 b = normal[right];
        const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
        const double limit = task.limit_of(left);
        const bool is_known = next_known != known.end() && next_known->from == from && next_known->to == to;
        next_known += is_known ? 1 : 0;
        if (!is_known && angle < std::min(crease_tuning.least_bend * radians, limit)) return;
        const bool may_be = may_be_sharp.empty() || may_be_sharp[corner_at(mesh.triangle, left, from)] != 0;
        const bool sharp = is_known || (bends_more(angle, limit) && may_be);
        edge.push_back({from, to, left, right, angle, sharp});
        degree[from] += sharp ? 1 : 0;
        degree[to] += sharp ? 1 : 0;
    });
    base::Groups at(task.work.memory, mesh.vertex.size(), [&](auto&& put) {
        for (std::int32_t i = 0; i < edge.size(); ++i)
            for (const std::int32_t end : {edge[i].from, edge[i].to}) put(end, i);
    });
    return {std::move(edge), std::move(at), std::move(degree)};
}

// Extends sharp edges that end at a vertex along the edges that continue them, up to another sharp edge.
void extend_creases(const Mesh& mesh, BentEdges& bends) {
    const auto grow_from = [&](std::int32_t before, std::int32_t end) {
        while (bends.degree[end] == 1) {
            const glm::dvec3 along = glm::normalize(mesh.vertex[end] - mesh.vertex[before]);
            std::int64_t best = -1;
            double best_score = 0.0;
            for (const std::int32_t i : bends.at[end]) {
                const BentEdge& bend = bends.edge[i];
                if (bend.sharp) continue;
                const double cosine =
                    glm::dot(along, glm::normalize(mesh.vertex[bend.other_end(end)] - mesh.vertex[end]));
                if (cosine < crease_tuning.aligned || cosine * bend.angle <= best_score) continue;
                best_score = cosine * bend.angle;
                best = i;
            }
            if (best < 0) return;
            bends.sharpen(best);
            before = end;
            end = bends.edge[best].other_end(end);
        }
    };
    for (std::int64_t i = 0; i < bends.edge.size(); ++i) {
        const BentEdge bend = bends.edge[i];
        if (!bend.sharp) continue;
        grow_from(bend.from, bend.to);
        grow_from(bend.to, bend.from);
    }
}

// Returns whether creases meet in a vertex, and none of them passes straight through it.
bool is_corner(const CreaseTask& task, const BentEdges& bends, std::int32_t vertex) noexcept {
    const auto way = [&](const BentEdge& bend) {
        return glm::normalize(task.mesh.vertex[bend.other_end(vertex)] - task.mesh.vertex[vertex]);
    };
    std::int64_t creases = 0;
    for (const std::int32_t i : bends.at[vertex]) {
        const BentEdge& one = bends.edge[i];
        if (!one.sharp) continue;
        ++creases;
        for (const std::int32_t j : bends.at[vertex]) {
            const BentEdge& other = bends.edge[j];
            if (j >= i || !other.sharp) continue;
            const double turn = std::acos(std::clamp(-glm::dot(way(one), way(other)), -1.0, 1.0));
            if (!bends_more(turn, task.limit_of(one.left))) return false;
        }
    }
    return creases >= 2;
}

// Makes an edge sharp if it joins two corners of creases. Inside a smooth patch there is no such edge, so it must lie
// between two facets.
void sharpen_between_corners(const CreaseTask& task, BentEdges& bends) {
    base::Array<std::int64_t> found(task.work.memory);
    for (std::int64_t i = 0; i < bends.edge.size(); ++i) {
        const BentEdge& bend = bends.edge[i];
        if (!bend.sharp && bend.angle >= crease_tuning.least_bend * radians && is_corner(task, bends, bend.from) &&
            is_corner(task, bends, bend.to))
            found.push_back(i);
    }
    for (const std::int64_t i : found) bends.sharpen(i);
}

// Sets `cut`, `patch` and `patches` from the sharp edges.
void find_patches(const CreaseTask& task, const BentEdges& bends, Creases& creases) {
    const Mesh& mesh = task.mesh;
    base::Array<std::uint8_t> cut(task.work.memory, 3 * mesh.faces());
    for (const BentEdge& bend : bends.edge)
        if (bend.sharp)
            cut[corner_at(mesh.triangle, bend.left, bend.from)] = cut[corner_at(mesh.triangle, bend.right, bend.to)] =
                1;
    UnionFind sets(task.work.memory, mesh.faces());
    for_edges(task.sides, task.work, [&](const Side* first, const Side* last) {
        const bool joined = is_plain(first, last);
        for (const Side* side = first; side != last; ++side)
            if (!joined) cut[number_of(mesh.triangle, *side)] = 1;
        if (joined && cut[number_of(mesh.triangle, *first)] == 0) sets.join(first[0].face, first[1].face);
    });
    creases.cut = std::move(cut);
    NumbersByFirstUse numbers(task.work.memory, mesh.faces());
    creases.patch.resize(mesh.faces());
    for (std::int32_t face = 0; face < mesh.faces(); ++face) creases.patch[face] = numbers.of(sets.find(face));
    creases.patches = numbers.count();
}

// Makes the edges of coarse faces sharp. A face is coarse if it is far from the curved surface that its vertex normals
// imply. Returns whether it made any edge sharp.
bool sharpen_coarse(const CreaseTask& task, const Creases& creases, BentEdges& bends) {
    const base::Array<glm::dvec3> normal = patch_normals(task.work, task.mesh, creases).normal;
    bool sharpened = false;
    for (BentEdge& bend : bends.edge) {
        if (bend.sharp) continue;
        const double off =
            std::max(chord_error(task.mesh, normal, bend.left), chord_error(task.mesh, normal, bend.right));
        if (off <= task.sharpness_of(bend.left).coarse) continue;
        bend.sharp = sharpened = true;
    }
    return sharpened;
}

// Drops short creases that separate nothing. A crease that connects two others is kept, such as one at the corner of a
// plate. Returns whether it dropped any.
bool drop_short_fading(const CreaseTask& task, const Creases& creases, BentEdges& bends) {
    const std::int64_t vertices = task.mesh.vertex.size();
    UnionFind sets(task.work.memory, vertices); // sets of connected creases that separate nothing
    for (const BentEdge& bend : bends.edge)
        if (is_fading(creases, bend)) sets.join(bend.from, bend.to);
    base::Array<double> length(task.work.memory, vertices);
    base::Array<std::int64_t> edges(task.work.memory, vertices);
    for (const BentEdge& bend : bends.edge)
        if (is_fading(creases, bend)) {
            length[sets.find(bend.from)] += length_of(task.mesh, bend);
            ++edges[sets.find(bend.from)];
        }
    // For each set: the number of its vertices where other creases pass.
    base::Array<std::int32_t> anchors(task.work.memory, vertices);
    for (std::int32_t v = 0; v < vertices; ++v) {
        const std::span<const std::int32_t> at = bends.at[v];
        const bool is_anchor = std::any_of(at.begin(), at.end(), [&](std::int32_t i) {
            return bends.edge[i].sharp && !is_fading(creases, bends.edge[i]);
        });
        anchors[sets.find(v)] += is_anchor ? 1 : 0;
    }
    bool dropped = false;
    for (BentEdge& bend : bends.edge) {
        if (!is_fading(creases, bend)) continue;
        const std::int32_t set = sets.find(bend.from);
        const bool is_long = length[set] >= crease_tuning.shortest_fading * task.mesh.bounds.diagonal() &&
                             edges[set] >= crease_tuning.fewest_fading;
        if (anchors[set] >= 2 || is_long) continue;
        bend.sharp = false;
        dropped = true;
    }
    return dropped;
}

// Joins each patch that is too small to be seen with the neighbour beyond its flattest edge. Returns whether it joined
// any.
bool join_scraps(const CreaseTask& task, const Creases& creases, BentEdges& bends) {
    base::Memory& memory = task.work.memory;
    base::Array<std::int64_t> faces(memory, creases.patches);
    base::Array<double> area(memory, creases.patches);
    for (std::int64_t face = 0; face < task.mesh.faces(); ++face) {
        ++faces[creases.patch[face]];
        area[creases.patch[face]] += 0.5 * glm::length(doubled_area(task.mesh.corners(face)));
    }
    // For each patch, 1 + the index of its flattest bend; 0 if it has no bend.
    base::Array<std::int64_t> flattest(memory, creases.patches);
    for (std::int64_t i = 0; i < bends.edge.size(); ++i) {
        const BentEdge& bend = bends.edge[i];
        if (!bend.sharp || is_fading(creases, bend)) continue;
        for (const std::int32_t face : {bend.left, bend.right}) {
            std::int64_t& best = flattest[creases.patch[face]];
            if (best == 0 || bend.angle < bends.edge[best - 1].angle) best = i + 1;
        }
    }
    const double across = crease_tuning.scrap_size * task.mesh.bounds.diagonal();
    UnionFind joined_patches(memory, creases.patches);
    for (std::int32_t patch = 0; patch < creases.patches; ++patch) {
        const bool is_scrap = faces[patch] < crease_tuning.scrap_faces && area[patch] < across * across;
        if (!is_scrap || flattest[patch] == 0) continue;
        const BentEdge& bend = bends.edge[flattest[patch] - 1];
        joined_patches.join(creases.patch[bend.left], creases.patch[bend.right]);
    }
    bool joined = false;
    for (BentEdge& bend : bends.edge) {
        const std::int32_t left = creases.patch[bend.left], right = creases.patch[bend.right];
        if (!bend.sharp || left == right || joined_patches.find(left) != joined_patches.find(right)) continue;
        bend.sharp = false;
        joined = true;
    }
    return joined;
}

// Writes the list of sharp edges and their lengths.
void describe(const Mesh& mesh, const BentEdges& bends, Creases& creases) {
    creases.edge.clear();
    creases.length = creases.fading = 0.0;
    for (const BentEdge& bend : bends.edge) {
        if (!bend.sharp) continue;
        creases.edge.push_back({bend.from, bend.to, bend.left, bend.right});
        creases.length += length_of(mesh, bend);
        creases.fading += is_fading(creases, bend) ? length_of(mesh, bend) : 0.0;
    }
}

Creases found_creases(const base::Work& work, const Mesh& mesh, const base::Array<Sharpness>& sharpness,
                      const base::Array<std::int32_t>& of_face, const base::Array<Crease>& known,
                      const base::Array<std::uint8_t>& may_be_sharp) {
    HRBFNPR_ASSERT(!sharpness.empty() && of_face.size() == mesh.faces());
    const base::Array<Side> sides = sides_by_edge(work, mesh.triangle);
    const CreaseTask task{work, mesh, sides, sharpness, of_face};
    Creases creases(work.memory);
    BentEdges bends = find_bent_edges(task, known, may_be_sharp);
    extend_creases(mesh, bends);
    sharpen_between_corners(task, bends);
    work.check();
    find_patches(task, bends, creases);
    if (sharpen_coarse(task, creases, bends)) find_patches(task, bends, creases);
    if (drop_short_fading(task, creases, bends)) find_patches(task, bends, creases);
    while (join_scraps(task, creases, bends)) find_patches(task, bends, creases);
    describe(mesh, bends, creases);
    split_patches(work, mesh, sides, creases);
    describe(mesh, bends, creases);
    return creases;
}

} // namespace

Creases find_creases(const base::Work& work, const Mesh& mesh, const Sharpness& sharpness) {
    base::Array<Sharpness> of_all(work.memory);
    of_all.push_back(sharpness);
    const base::Array<Crease> none(work.memory);
    const base::Array<std::uint8_t> all(work.memory);
    return found_creases(work, mesh, of_all, mesh.component, none, all);
}

Creases find_creases(const base::Work& work, const Mesh& mesh, const base::Array<Sharpness>& of_component,
                     const base::Array<std::uint8_t>& sides) {
    HRBFNPR_ASSERT(sides.size() == 3 * mesh.faces());
    const base::Array<Crease> none(work.memory);
    return found_creases(work, mesh, of_component, mesh.component, none, sides);
}

Creases find_more_creases(const base::Work& work, const Mesh& mesh, const Creases& known,
                          const base::Array<std::uint8_t>& within, double angle) {
    HRBFNPR_ASSERT(within.size() == known.patches);
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    base::Array<Sharpness> of_patch(work.memory);
    for (const std::uint8_t is : within) of_patch.push_back({is != 0 ? angle : no_crease, no_limit});
    const base::Array<std::uint8_t> all(work.memory);
    return found_creases(work, mesh, of_patch, known.patch, known.edge, all);
}

base::Array<double> areas_of_components(const base::Work& work, const Mesh& mesh) {
    base::Array<double> area(work.memory, 1 + *std::max_element(mesh.component.begin(), mesh.component.end()));
    for (const std::int64_t face : work.over(mesh.faces()))
        area[mesh.component[face]] += 0.5 * glm::length(doubled_area(mesh.corners(face)));
    return area;
}

base::Array<Crumbs> find_crumbs(const base::Work& work, const Mesh& mesh, const Creases& creases) {
    HRBFNPR_ASSERT(creases.patch.size() == mesh.faces());
    const std::int64_t components = 1 + *std::max_element(mesh.component.begin(), mesh.component.end());
    base::Array<geometry::Bounds> bounds(work.memory);
    for (std::int64_t i = 0; i < components; ++i) bounds.push_back({});
    for (const std::int64_t face : work.over(mesh.faces()))
        for (const glm::dvec3& corner : mesh.corners(face)) bounds[mesh.component[face]].extend(corner);
    const base::Groups faces(work.memory, creases.patches, [&](auto&& put) {
        for (std::int32_t face = 0; face < mesh.faces(); ++face) put(creases.patch[face], face);
    });
    base::Array<Crumbs> crumbs(work.memory, components);
    for (const std::int64_t patch : work.over(creases.patches)) {
        const std::span<const std::int32_t> of_patch = faces[patch];
        if (faces.count(patch) > crease_tuning.crumb_faces) continue;
        const std::int32_t component = mesh.component[of_patch[0]];
        const glm::dvec3 first = unit_normal(mesh, of_patch[0]);
        double area = 0.0, cosine = 1.0;
        for (const std::int32_t face : of_patch) {
            area += 0.5 * glm::length(doubled_area(mesh.corners(face)));
            cosine = std::min(cosine, glm::dot(first, unit_normal(mesh, face)));
        }
        const double across = crease_tuning.crumb_size * bounds[component].diagonal();
        if (area >= across * across || (of_patch.size() > 1 && cosine >= crease_tuning.crumb_cosine)) continue;
        ++crumbs[component].count;
        crumbs[component].area += area;
    }
    return crumbs;
}

} // namespace hrbfnpr::mesh
