// SPDX-License-Identifier: MIT
#include "mesh/part_edges.h"

#include "mesh/edge_angles.h"

#include <algorithm>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t faces_a_check = 16384;

class Parter {
public:
    Parter(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle)
        : vertex_(vertex), triangle_(triangle), corners_(runtime.memory, 3 * triangle.size()),
          parted_(runtime.memory, vertex.size()), around_(runtime.memory), angles_(vertex, triangle) {
        for (std::uint8_t& is : parted_) is = 1;
    }

    std::int64_t run(const base::Array<Side>& sides, const base::Progress& progress) {
        for_edges(sides, progress, [&](const Side* first, const Side* last) {
            if (last - first == 1) parted_[low(*first)] = parted_[high(*first)] = 0;
        });
        for_edges(sides, progress, [&](const Side* first, const Side* last) {
            if (last - first >= 4 && turn(first, last))
                join_pairs();
            else
                for (const Side* side = first + 1; side != last; ++side) join(first[0], *side);
        });
        return renumber(progress);
    }

private:
    // Sorted about the edge, from a face that has the solid behind it, if every second one has.
    [[nodiscard]] bool turn(const Side* first, const Side* last) {
        angles_.measure(first, last, around_);
        std::sort(around_.begin(), around_.end(), [](const Turned& a, const Turned& b) {
            return a.angle != b.angle ? a.angle < b.angle : a.side->face < b.side->face;
        });
        end_before_begin();
        for (std::int64_t i = 0; i < around_.size(); ++i)
            if (around_[i].side->forward == around_[(i + 1) % around_.size()].side->forward) return pair_flattest();
        if (around_[0].side->forward != 0) std::rotate(around_.begin(), around_.begin() + 1, around_.end());
        return true;
    }

    // Of two solids that share a wall, but for rounding, the one ends there, and the other begins.
    void end_before_begin() noexcept {
        for (std::int64_t turns = 0; turns < around_.size(); ++turns) {
            bool moved = false;
            for (std::int64_t i = 0; i < around_.size(); ++i) {
                Turned& one = around_[i];
                Turned& next = around_[(i + 1) % around_.size()];
                const bool ends = next.side->forward != 0 && one.side->forward == 0;
                if (!ends || !EdgeAngles::alike(one, next)) continue;
                std::swap(one.side, next.side);
                moved = true;
            }
            if (!moved) return;
        }
    }

    // Solids that go through each other there, as round ones that touch along a line do by their flat faces: each goes
    // on straight.
    [[nodiscard]] bool pair_flattest() {
        std::sort(around_.begin(), around_.end(), [](const Turned& a, const Turned& b) {
            if (a.side->forward != b.side->forward) return a.side->forward < b.side->forward;
            return a.side->face < b.side->face;
        });
        if (around_.size() != 4 || around_[1].side->forward != 0 || around_[2].side->forward == 0) return false;
        const auto bend = [this](std::int64_t a, std::int64_t b) { return EdgeAngles::bend(around_[a], around_[b]); };
        const bool crossed = bend(0, 3) + bend(1, 2) < bend(0, 2) + bend(1, 3);
        std::swap(around_[1], around_[crossed ? 3 : 2]);
        return true;
    }

    // A face that runs through the edge backward looks against the turn: the solid follows it, up to the next one.
    void join_pairs() {
        for (std::int64_t i = 0; i < around_.size(); i += 2) join(*around_[i].side, *around_[i + 1].side);
        parted_[low(*around_[0].side)] = parted_[high(*around_[0].side)] = 1;
    }

    void join(const Side& a, const Side& b) noexcept {
        corners_.join(corner(a, low(a)), corner(b, low(b)));
        corners_.join(corner(a, high(a)), corner(b, high(b)));
    }

    // Corners of one set share a vertex; the first set keeps it.
    [[nodiscard]] std::int64_t renumber(const base::Progress& progress) {
        const std::int64_t before = vertex_.size();
        base::Array<std::int32_t> owner(vertex_.memory(), before); // a set and 1
        base::Array<std::int32_t> own(vertex_.memory(), 3 * triangle_.size());
        for (std::int64_t face = 0; face < triangle_.size(); ++face) {
            if (face % faces_a_check == 0) progress.check();
            for (std::size_t k = 0; k < 3; ++k) {
                std::int32_t& at = triangle_[face][k];
                if (parted_[at] == 0) continue;
                const std::int32_t set =
                    corners_.of(static_cast<std::int32_t>(3 * face) + static_cast<std::int32_t>(k));
                if (owner[at] == 0) owner[at] = set + 1;
                if (owner[at] == set + 1) continue;
                if (own[set] == 0) {
                    own[set] = static_cast<std::int32_t>(vertex_.size());
                    vertex_.push_back(vertex_[at]);
                }
                at = own[set];
            }
        }
        return vertex_.size() - before;
    }

    [[nodiscard]] std::int32_t corner(const Side& side, std::int32_t at) const noexcept {
        const Triangle& t = triangle_[side.face];
        return 3 * side.face + (t[0] == at ? 0 : t[1] == at ? 1 : 2);
    }

    base::Array<glm::dvec3>& vertex_;
    base::Array<Triangle>& triangle_;
    Sets corners_;                     // that share a vertex
    base::Array<std::uint8_t> parted_; // vertices of edges that are, and those that no border passes
    base::Array<Turned> around_;       // an edge
    EdgeAngles angles_;
};

} // namespace

std::int64_t part_edges(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                        const base::Progress& progress) {
    return Parter(runtime, vertex, triangle).run(sides_by_edge(runtime, triangle, progress), progress);
}

} // namespace hrbfnpr::mesh
