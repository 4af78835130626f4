// SPDX-License-Identifier: MIT
#include "mesh/pieces/split_fading.h"

#include "mesh/corners.h"
#include "mesh/pieces/split_winding.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

class Splitter {
public:
    Splitter(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases,
             const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), creases_(creases), progress_(progress), across_(runtime.memory),
          seed_(runtime.memory), on_crease_(runtime.memory, mesh.vertex.size()),
          cuts_(runtime.memory, mesh.vertex.size()), sets_(runtime.memory, mesh.faces()), label_(runtime.memory),
          distance_(runtime.memory), from_cut_(runtime.memory), heap_(runtime.memory) {
        across_.resize_for_overwrite(3 * mesh.faces());
        std::fill(across_.begin(), across_.end(), -1);
        for_edges(sides, progress, [&](const Side* first, const Side* last) {
            if (last - first != 2) return;
            across_[number_of(mesh.triangle, first[0])] = first[1].face;
            across_[number_of(mesh.triangle, first[1])] = first[0].face;
        });
    }

    void run() {
        count_cuts();
        find_fading();
        find_tips();
        join_along_creases();
        spread_labels();
        progress_.check();
        number_parts();
        split_winding(runtime_, mesh_, creases_, progress_);
        mark_cuts();
        measure_from_cuts();
        add_bands();
    }

private:
    struct Reached {
        double distance;
        std::int32_t face;
        [[nodiscard]] bool operator<(const Reached& other) const noexcept { // the nearest is on top of a heap
            return distance > other.distance || (distance == other.distance && face > other.face);
        }
    };

    [[nodiscard]] bool is_fading(const Crease& crease) const noexcept {
        return creases_.patch[crease.left] == creases_.patch[crease.right];
    }
    [[nodiscard]] glm::dvec3 middle(std::int32_t face) const noexcept {
        const auto p = mesh_.corners(face);
        return (p[0] + p[1] + p[2]) / 3.0;
    }

    // Sides that are cut, at each vertex: two of each crease.
    void count_cuts() {
        for (std::int64_t side = 0; side < creases_.cut.size(); ++side) {
            if (creases_.cut[side] == 0) continue;
            const Triangle& t = mesh_.triangle[side / 3];
            ++cuts_[t[static_cast<std::size_t>(side % 3)]];
            ++cuts_[t[static_cast<std::size_t>((side + 1) % 3)]];
        }
    }

    void find_fading() {
        for (const Crease& crease : creases_.edge) {
            if (!is_fading(crease)) continue;
            for (const std::int32_t v : {crease.from, crease.to}) on_crease_[v] = cuts_[v] > 2 ? 1 : 0;
            for (const std::int32_t face : {crease.left, crease.right}) seed_.push_back(face);
        }
    }

    using TwoEdges = std::array<std::int32_t, 2>;

    // Where a step in a patch fades, its wall ends in a tip around which the patch goes from one crease to the other:
    // one sheet cannot be both above and below the wall there.
    void find_tips() {
        base::Array<TwoEdges> edge(runtime_.memory, mesh_.vertex.size()); // the last ones of each vertex
        std::fill(edge.begin(), edge.end(), TwoEdges{-1, -1});
        for (std::int32_t i = 0; i < creases_.edge.size(); ++i)
            for (const std::int32_t v : {creases_.edge[i].from, creases_.edge[i].to}) edge[v] = {i, edge[v][0]};
        base::Array<std::array<double, 2>> angle(runtime_.memory, mesh_.vertex.size());
        add_angles(edge, angle);
        base::Array<std::uint8_t> passed(runtime_.memory, creases_.edge.size());
        base::Array<std::int32_t> tips(runtime_.memory);
        for (std::int32_t v = 0; v < mesh_.vertex.size(); ++v) {
            if (!is_between_two(v, edge) || std::min(angle[v][0], angle[v][1]) > crease_tuning.widest_tip) continue;
            const std::int32_t around = pair_of(edge[v][0])[angle[v][0] < angle[v][1] ? 1 : 0];
            for (const std::int32_t i : edge[v]) follow_from_tip(v, i, around, edge, passed);
            tips.push_back(v);
        }
        for (const std::int32_t v : tips) on_crease_[v] = 0;
    }

    // Of both patches, at vertices where they and no others meet.
    void add_angles(const base::Array<TwoEdges>& edge, base::Array<std::array<double, 2>>& angle) const {
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            const auto p = mesh_.corners(face);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t v = mesh_.triangle[face][k];
                if (!is_between_two(v, edge)) continue;
                angle[v][creases_.patch[face] == pair_of(edge[v][0])[0] ? 0 : 1] += angle_at(p, k);
            }
        }
    }

    [[nodiscard]] std::array<std::int32_t, 2> pair_of(std::int32_t edge) const noexcept {
        const std::int32_t a = creases_.patch[creases_.edge[edge].left];
        const std::int32_t b = creases_.patch[creases_.edge[edge].right];
        return {std::min(a, b), std::max(a, b)};
    }
    [[nodiscard]] bool is_between_two(std::int32_t v, const base::Array<TwoEdges>& edge) const noexcept {
        if (cuts_[v] != 4 || edge[v][1] < 0) return false;
        const auto pair = pair_of(edge[v][0]);
        return pair[0] != pair[1] && pair == pair_of(edge[v][1]);
    }

    // As far as the crease parts the same two patches.
    void follow_from_tip(std::int32_t tip, std::int32_t first, std::int32_t around, const base::Array<TwoEdges>& edge,
                         base::Array<std::uint8_t>& passed) {
        std::int32_t v = tip;
        for (std::int32_t i = first; passed[i] == 0;) {
            passed[i] = 1;
            const Crease& crease = creases_.edge[i];
            seed_.push_back(creases_.patch[crease.left] == around ? crease.left : crease.right);
            v = crease.from == v ? crease.to : crease.from;
            on_crease_[v] = 1;
            if (!is_between_two(v, edge)) return;
            i = edge[v][0] == i ? edge[v][1] : edge[v][0];
        }
    }

    // Faces at the vertices of such a crease belong to one of its sides, but for its ends, where both are one.
    void join_along_creases() {
        for (std::int64_t side = 0; side < creases_.cut.size(); ++side) {
            if (creases_.cut[side] != 0 || across_[side] < 0) continue;
            const Triangle& t = mesh_.triangle[side / 3];
            if (on_crease_[t[static_cast<std::size_t>(side % 3)]] != 0 ||
                on_crease_[t[static_cast<std::size_t>((side + 1) % 3)]] != 0)
                sets_.join(static_cast<std::int32_t>(side / 3), across_[side]);
        }
    }

    // Visits faces by their distance from those in the heap; accept(face, from, distance).
    template <class Accept>
    void spread(Accept&& accept) {
        std::make_heap(heap_.begin(), heap_.end());
        while (!heap_.empty()) {
            std::pop_heap(heap_.begin(), heap_.end());
            const Reached at = heap_.back();
            heap_.resize(heap_.size() - 1);
            for (int k = 0; k < 3; ++k) {
                const std::int64_t side = 3 * std::int64_t{at.face} + k;
                const std::int32_t face = across_[side];
                if (creases_.cut[side] == 1 || face < 0) continue;
                const double distance = at.distance + glm::distance(middle(at.face), middle(face));
                if (!accept(face, at.face, at.distance, distance)) continue;
                heap_.push_back({distance, face});
                std::push_heap(heap_.begin(), heap_.end());
            }
        }
    }

    void spread_labels() {
        label_.resize_for_overwrite(mesh_.faces());
        distance_.resize_for_overwrite(mesh_.faces());
        std::fill(label_.begin(), label_.end(), -1);
        std::fill(distance_.begin(), distance_.end(), infinite);
        for (const std::int32_t face : seed_) {
            if (distance_[face] == 0.0) continue;
            label_[face] = sets_.of(face);
            distance_[face] = 0.0;
            heap_.push_back({0.0, face});
        }
        spread([&](std::int32_t face, std::int32_t from, double before, double distance) {
            if (before > distance_[from] || distance >= distance_[face]) return false;
            distance_[face] = distance;
            label_[face] = label_[from];
            return true;
        });
    }

    void number_parts() {
        base::Array<std::int32_t> of_patch(runtime_.memory, creases_.patches); // of those that stay whole
        base::Array<std::int32_t> of_label(runtime_.memory, mesh_.faces());
        std::int32_t count = 0;
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            std::int32_t& number = label_[face] < 0 ? of_patch[creases_.patch[face]] : of_label[label_[face]];
            if (number == 0) number = ++count;
            creases_.patch[face] = number - 1;
        }
        creases_.patches = count;
    }

    void mark_cuts() {
        for (std::int64_t side = 0; side < creases_.cut.size(); ++side)
            if (creases_.cut[side] == 0 && across_[side] >= 0 &&
                creases_.patch[across_[side]] != creases_.patch[side / 3])
                creases_.cut[side] = 2;
    }

    void measure_from_cuts() {
        from_cut_.resize_for_overwrite(mesh_.faces());
        std::fill(from_cut_.begin(), from_cut_.end(), infinite);
        for (std::int64_t side = 0; side < creases_.cut.size(); ++side) {
            const auto face = static_cast<std::int32_t>(side / 3);
            if (creases_.cut[side] != 2 || from_cut_[face] == 0.0) continue;
            from_cut_[face] = 0.0;
            heap_.push_back({0.0, face});
        }
    }

    // Faces of another part that are near to a smooth cut of both.
    void add_bands() {
        const double widest = crease_tuning.widest_band * mesh_.bounds.diagonal();
        base::Array<std::int32_t> other(runtime_.memory); // the part that a face is near to
        other.resize_for_overwrite(mesh_.faces());
        std::fill(other.begin(), other.end(), -1);
        for (const Reached& at : heap_)
            for (int k = 0; k < 3; ++k) {
                const std::int64_t side = 3 * std::int64_t{at.face} + k;
                if (creases_.cut[side] == 2 && other[at.face] < 0) other[at.face] = creases_.patch[across_[side]];
            }
        spread([&](std::int32_t face, std::int32_t from, double before, double distance) {
            if (before > from_cut_[from] || distance >= from_cut_[face]) return false;
            if (creases_.patch[face] != creases_.patch[from]) return false;
            if (distance > std::min(widest, crease_tuning.band_share * distance_[face])) return false;
            from_cut_[face] = distance;
            other[face] = other[from];
            return true;
        });
        for (std::int32_t face = 0; face < mesh_.faces(); ++face)
            if (other[face] >= 0 && (from_cut_[face] > 0.0 || distance_[face] > 0.0))
                creases_.shared.push_back({face, other[face]});
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    Creases& creases_;
    const base::Progress& progress_;
    base::Array<std::int32_t> across_;    // of each side: the face beyond, or -1
    base::Array<std::int32_t> seed_;      // faces beside creases on both sides of which the same patch is
    base::Array<std::uint8_t> on_crease_; // vertices of these, but for their ends
    base::Array<std::int32_t> cuts_;      // of each vertex
    Sets sets_;
    base::Array<std::int32_t> label_; // of each face: the side of a crease that it is nearest to; -1: of none
    base::Array<double> distance_;    // from that
    base::Array<double> from_cut_;
    base::Array<Reached> heap_;
};

} // namespace

void split_fading(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases,
                  const base::Progress& progress) {
    Splitter(runtime, mesh, sides, creases, progress).run();
}

} // namespace hrbfnpr::mesh
