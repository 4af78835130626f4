// SPDX-License-Identifier: MIT
#include "mesh/pieces/split_winding.h"

#include "base/list.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();
// Two places are of two turns if they are so near to each other, in diagonals, ...
constexpr double layers_apart = 0.2;
// ... with normals that have at least this cosine, ...
constexpr double same_way = 0.3;
// ... and so many times as far apart on the patch, and so many diagonals, ...
constexpr double way_around = 5.0;
constexpr double least_way = 0.3;
// ... which has normals that differ by more than this cosine, or lie above each other: this part of their distance is
// along the normal.
constexpr double flat = 0.9;
constexpr double along_normal = 0.5;
constexpr std::int64_t winding_probes =
    256;                             // faces of a patch that are looked at: half of them are of turns, or it is not cut
constexpr std::int64_t known = 4096; // faces of a patch that others are looked for among
constexpr double most_parts = 256.0; // of a patch
constexpr double part_of_turn = 0.5;

class WindingSplitter {
public:
    WindingSplitter(const base::Runtime& runtime, const Mesh& mesh, Creases& creases, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), creases_(creases), progress_(progress), way_(runtime.memory),
          part_(runtime.memory, mesh.faces()), heap_(runtime.memory) {
        way_.resize_for_overwrite(mesh.faces());
        std::fill(way_.begin(), way_.end(), boundless);
    }

    void run() {
        index_corners();
        base::List<base::Array<std::int32_t>> faces(runtime_.memory);
        for (std::int32_t p = 0; p < creases_.patches; ++p) faces.add(runtime_.memory);
        for (std::int32_t face = 0; face < mesh_.faces(); ++face) faces[creases_.patch[face]].push_back(face);
        bool split = false;
        for (const base::Array<std::int32_t>& patch : faces) {
            progress_.check();
            split = split_patch(patch) || split;
        }
        if (split) number_parts();
    }

private:
    struct Reached {
        double way;
        std::int32_t vertex;
        [[nodiscard]] bool operator<(const Reached& other) const noexcept { // the nearest is on top of a heap
            return way > other.way || (way == other.way && vertex > other.vertex);
        }
    };

    [[nodiscard]] glm::dvec3 middle(std::int32_t face) const noexcept {
        const auto p = mesh_.corners(face);
        return (p[0] + p[1] + p[2]) / 3.0;
    }
    [[nodiscard]] glm::dvec3 normal(std::int32_t face) const noexcept {
        return glm::normalize(doubled_area(mesh_.corners(face)));
    }

    void index_corners() {
        first_.resize(mesh_.vertex.size() + 1);
        for (const Triangle& t : mesh_.triangle)
            for (const std::int32_t v : t) ++first_[v + 1];
        for (std::int64_t v = 0; v < mesh_.vertex.size(); ++v) first_[v + 1] += first_[v];
        at_.resize(3 * mesh_.faces());
        base::Array<std::int64_t> next(runtime_.memory);
        for (const std::int64_t i : first_) next.push_back(i);
        for (std::int64_t face = 0; face < mesh_.faces(); ++face)
            for (const std::int32_t v : mesh_.triangle[face]) at_[next[v]++] = static_cast<std::int32_t>(face);
    }

    // The way along a patch's edges from a face to its others; the one that is farthest, of those that hang together
    // with it.  (Along edges, as faces may be slivers: from middle to middle of these is a zigzag.)
    std::int32_t measure_ways(std::int32_t from, std::span<const std::int32_t> patch) {
        for (const std::int32_t face : patch)
            for (const std::int32_t v : mesh_.triangle[face]) to_vertex_[v] = boundless;
        const std::int32_t start = mesh_.triangle[from][0];
        to_vertex_[start] = 0.0;
        heap_.clear();
        heap_.push_back({0.0, start});
        while (!heap_.empty()) {
            std::pop_heap(heap_.begin(), heap_.end());
            const Reached at = heap_.back();
            heap_.resize(heap_.size() - 1);
            if (at.way > to_vertex_[at.vertex]) continue;
            for (std::int64_t i = first_[at.vertex]; i < first_[at.vertex + 1]; ++i)
                if (creases_.patch[at_[i]] == creases_.patch[from]) reach(at, mesh_.triangle[at_[i]]);
        }
        std::int32_t last = from;
        for (const std::int32_t face : patch) {
            const Triangle& t = mesh_.triangle[face];
            way_[face] = (to_vertex_[t[0]] + to_vertex_[t[1]] + to_vertex_[t[2]]) / 3.0;
            if (way_[face] < boundless && way_[face] > way_[last]) last = face;
        }
        return last;
    }
    void reach(const Reached& at, const Triangle& t) {
        for (const std::int32_t v : t) {
            const double way = at.way + glm::distance(mesh_.vertex[at.vertex], mesh_.vertex[v]);
            if (way >= to_vertex_[v]) continue;
            to_vertex_[v] = way;
            heap_.push_back({way, v});
            std::push_heap(heap_.begin(), heap_.end());
        }
    }

    [[nodiscard]] bool are_turns(std::int32_t a, std::int32_t b) const noexcept {
        const double around = std::abs(way_[a] - way_[b]);
        const glm::dvec3 off = middle(b) - middle(a);
        const double distance = glm::length(off);
        const glm::dvec3 n = normal(a);
        return around > std::max(way_around * distance, least_way * mesh_.bounds.diagonal()) &&
               distance < layers_apart * mesh_.bounds.diagonal() &&
               (!flat_ || std::abs(glm::dot(off, n)) > along_normal * distance) && glm::dot(n, normal(b)) > same_way;
    }

    // The way from one turn to the next; infinite: there are none.
    [[nodiscard]] double turn_of(std::span<const std::int32_t> patch) const {
        const std::size_t step = (patch.size() + known - 1) / known;
        geometry::VecArray place(runtime_.memory);
        for (std::size_t i = 0; i < patch.size(); i += step) place.push_back(middle(patch[i]));
        const geometry::PointTree tree(place, progress_);
        const auto face_at = [&](std::int64_t at) { return patch[static_cast<std::size_t>(tree.index(at)) * step]; };
        const auto count = std::min(winding_probes, static_cast<std::int64_t>(patch.size()));
        base::Array<double> around(runtime_.memory);
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int32_t face =
                patch[static_cast<std::size_t>(k) * patch.size() / static_cast<std::size_t>(count)];
            std::int64_t found = 0;
            const std::int64_t any = tree.nearest(
                middle(face), 1, [](std::int64_t) { return true; },
                [&](std::int64_t at) { return are_turns(face, face_at(at)); }, &found);
            if (any > 0) around.push_back(std::abs(way_[face] - way_[face_at(found)]));
        }
        if (around.empty() || 2 * around.size() < count) return boundless;
        // Not the least: where a flank runs out into a flat end, that lies above it a short way around.
        const std::int64_t quarter = around.size() / 4;
        std::nth_element(around.begin(), around.begin() + quarter, around.end());
        return around[quarter];
    }

    // Into bands across the way from one end of it to the other.
    bool split_patch(const base::Array<std::int32_t>& patch) {
        const std::int32_t end = measure_ways(patch[0], patch.span());
        const std::int32_t last = measure_ways(end, patch.span());
        if (way_[last] < least_way * mesh_.bounds.diagonal()) return false;
        const glm::dvec3 first = normal(patch[0]);
        flat_ = std::all_of(patch.begin(), patch.end(),
                            [&](std::int32_t face) { return glm::dot(normal(face), first) > flat; });
        const double turn = turn_of(patch.span());
        if (turn == boundless) return false;
        const double parts = std::clamp(std::ceil(way_[last] / (part_of_turn * turn)), 1.0, most_parts);
        for (const std::int32_t face : patch) {
            const double share = std::min(way_[face] / way_[last], 1.0);
            part_[face] = static_cast<std::int32_t>(std::min(parts - 1.0, std::floor(parts * share)));
        }
        return parts > 1.0;
    }

    // In the order of their first faces.
    void number_parts() {
        constexpr auto most = static_cast<std::int64_t>(most_parts);
        base::Array<std::int32_t> number(runtime_.memory, most * creases_.patches);
        std::int32_t count = 0;
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            std::int32_t& of = number[most * creases_.patch[face] + part_[face]];
            if (of == 0) of = ++count;
            creases_.patch[face] = of - 1;
        }
        creases_.patches = count;
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    Creases& creases_;
    const base::Progress& progress_;
    base::Array<std::int64_t> first_{runtime_.memory}; // of the faces at each vertex, in at_
    base::Array<std::int32_t> at_{runtime_.memory};
    base::Array<double> to_vertex_{runtime_.memory, mesh_.vertex.size()}; // the way there
    base::Array<double> way_;                                             // of each face, from one end of its patch
    base::Array<std::int32_t> part_;                                      // of its patch
    base::Array<Reached> heap_;
    bool flat_ = false; // the patch
};

} // namespace

void split_winding(const base::Runtime& runtime, const Mesh& mesh, Creases& creases, const base::Progress& progress) {
    WindingSplitter(runtime, mesh, creases, progress).run();
}

} // namespace hrbfnpr::mesh
