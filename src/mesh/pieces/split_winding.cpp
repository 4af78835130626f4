// SPDX-License-Identifier: MIT
#include "mesh/pieces/split_winding.h"

#include "base/list.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Two places are of two layers if they are so near to each other, in diagonals, ...
constexpr double layers_apart = 0.2;
// ... this part of it along the normal, ...
constexpr double along_normal = 0.5;
// ... with normals that have at least this cosine, ...
constexpr double same_way = 0.3;
// ... and so many times as far apart on the patch.
constexpr double way_around = 5.0;
constexpr std::int64_t probes = 256; // faces of a patch that are looked at
constexpr std::int64_t layered = 16; // of these in layers, so that it is cut
constexpr std::int64_t known = 4096; // faces of a patch that others are looked for among
constexpr double most_parts = 256.0; // of a patch
constexpr double part_of_turn = 0.5;

class Splitter {
public:
    Splitter(const base::Runtime& runtime, const Mesh& mesh, const base::Array<std::int32_t>& across, Creases& creases,
             const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), across_(across), creases_(creases), progress_(progress), way_(runtime.memory),
          part_(runtime.memory, mesh.faces()), heap_(runtime.memory) {
        way_.resize_for_overwrite(mesh.faces());
        std::fill(way_.begin(), way_.end(), infinite);
    }

    void run() {
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
        std::int32_t face;
        [[nodiscard]] bool operator<(const Reached& other) const noexcept { // the nearest is on top of a heap
            return way > other.way || (way == other.way && face > other.face);
        }
    };

    [[nodiscard]] glm::dvec3 middle(std::int32_t face) const noexcept {
        const auto p = mesh_.corners(face);
        return (p[0] + p[1] + p[2]) / 3.0;
    }
    [[nodiscard]] glm::dvec3 normal(std::int32_t face) const noexcept {
        return glm::normalize(doubled_area(mesh_.corners(face)));
    }

    // The way on the patch from a face to all that hang together with it; the last that is reached.
    std::int32_t measure_ways(std::int32_t from, std::span<const std::int32_t> patch) {
        for (const std::int32_t face : patch) way_[face] = infinite;
        way_[from] = 0.0;
        heap_.clear();
        heap_.push_back({0.0, from});
        std::int32_t last = from;
        while (!heap_.empty()) {
            std::pop_heap(heap_.begin(), heap_.end());
            const Reached at = heap_.back();
            heap_.resize(heap_.size() - 1);
            if (at.way > way_[at.face]) continue;
            last = at.face;
            for (int k = 0; k < 3; ++k) {
                const std::int64_t side = 3 * std::int64_t{at.face} + k;
                const std::int32_t face = across_[side];
                if (creases_.cut[side] == 1 || face < 0 || creases_.patch[face] != creases_.patch[at.face]) continue;
                const double way = at.way + glm::distance(middle(at.face), middle(face));
                if (way >= way_[face]) continue;
                way_[face] = way;
                heap_.push_back({way, face});
                std::push_heap(heap_.begin(), heap_.end());
            }
        }
        return last;
    }

    [[nodiscard]] bool are_layers(std::int32_t a, std::int32_t b) const noexcept {
        const double around = std::abs(way_[a] - way_[b]);
        const glm::dvec3 off = middle(b) - middle(a);
        const double distance = glm::length(off);
        const glm::dvec3 n = normal(a);
        return around > way_around * distance && distance < layers_apart * mesh_.bounds.diagonal() &&
               std::abs(glm::dot(off, n)) > along_normal * distance && glm::dot(n, normal(b)) > same_way;
    }

    // The way from one layer to the next; infinite: there are none.
    [[nodiscard]] double turn_of(std::span<const std::int32_t> patch) const {
        const std::size_t step = (patch.size() + known - 1) / known;
        geometry::VecArray place(runtime_.memory);
        for (std::size_t i = 0; i < patch.size(); i += step) place.push_back(middle(patch[i]));
        const geometry::PointTree tree(place, progress_);
        const auto face_at = [&](std::int64_t at) { return patch[static_cast<std::size_t>(tree.index(at)) * step]; };
        const auto count = std::min(probes, static_cast<std::int64_t>(patch.size()));
        base::Array<double> around(runtime_.memory);
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int32_t face =
                patch[static_cast<std::size_t>(k) * patch.size() / static_cast<std::size_t>(count)];
            std::int64_t found = 0;
            const std::int64_t any = tree.nearest(
                middle(face), 1, [](std::int64_t) { return true; },
                [&](std::int64_t at) { return are_layers(face, face_at(at)); }, &found);
            if (any > 0) around.push_back(std::abs(way_[face] - way_[face_at(found)]));
        }
        if (around.size() < std::min(layered, count / 4)) return infinite;
        // Not the least: where a flank runs out into a flat end, that lies above it a short way around.
        const std::int64_t quarter = around.size() / 4;
        std::nth_element(around.begin(), around.begin() + quarter, around.end());
        return around[quarter];
    }

    // Into bands across the way from one end of it to the other.
    bool split_patch(const base::Array<std::int32_t>& patch) {
        const std::int32_t end = measure_ways(patch[0], patch.span());
        const std::int32_t last = measure_ways(end, patch.span());
        if (way_[last] < way_around * glm::distance(middle(end), middle(last)) / 4.0) return false;
        const double turn = turn_of(patch.span());
        if (turn == infinite) return false;
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
    const base::Array<std::int32_t>& across_;
    Creases& creases_;
    const base::Progress& progress_;
    base::Array<double> way_;        // of each face, from one end of its patch
    base::Array<std::int32_t> part_; // of its patch
    base::Array<Reached> heap_;
};

} // namespace

void split_winding(const base::Runtime& runtime, const Mesh& mesh, const base::Array<std::int32_t>& across,
                   Creases& creases, const base::Progress& progress) {
    Splitter(runtime, mesh, across, creases, progress).run();
}

} // namespace hrbfnpr::mesh
