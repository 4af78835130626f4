// SPDX-License-Identifier: MIT
#include "mesh/split_slivers.h"

#include "mesh/edge_angles.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr int most_sliver_rounds = 32; // slivers may lie beside others; each round makes the longest sides shorter
constexpr double flattest = 1e-3;      // height, of the longest side
constexpr std::int64_t sliver_faces_a_look = 16384; // faces without a look for a cancel

constexpr std::uint64_t no_edge = ~std::uint64_t{0};

struct Sliver {
    std::uint64_t edge; // the longest side
    std::int32_t face;
    bool forward;             // whether it runs from the lower to the higher vertex there
    std::int32_t across = -1; // a face beside that edge, or none
    bool agrees = false;      // whether that runs the other way, as faces of one side do
};

[[nodiscard]] std::uint64_t edge_of(std::int32_t a, std::int32_t b) noexcept {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    return low << 32U | static_cast<std::uint64_t>(std::max(a, b));
}

class Splitter {
public:
    Splitter(Welded& welded, const base::Progress& progress)
        : welded_(welded), progress_(progress), rounding_(coordinate_rounding(welded.vertex)),
          found_(welded.vertex.memory()), longest_(welded.vertex.memory(), welded.triangle.size()),
          changed_(welded.vertex.memory(), welded.triangle.size()) {}

    [[nodiscard]] std::int64_t run() {
        join_ends();
        std::int64_t split = 0;
        for (int round = 0; round < most_sliver_rounds; ++round) {
            find();
            if (found_.empty()) break;
            find_across();
            const std::int64_t now = split_all();
            if (now == 0) break;
            split += now;
        }
        return split;
    }

private:
    // Of slivers as narrow as two places that are one but for rounding.
    void join_ends() {
        Sets places(welded_.vertex.memory(), welded_.vertex.size());
        bool any = false;
        for (const Triangle& t : welded_.triangle) {
            if (sliver_side(t) < 0) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                if (glm::distance(welded_.vertex[t[k]], welded_.vertex[t[(k + 1) % 3]]) > rounding_) continue;
                places.join(t[k], t[(k + 1) % 3]);
                any = true;
            }
        }
        if (!any) return;
        for (Triangle& t : welded_.triangle)
            for (std::int32_t& corner : t) corner = places.of(corner);
    }

    void find() {
        found_.clear();
        std::fill(longest_.begin(), longest_.end(), no_edge);
        for (std::int32_t face = 0; face < welded_.triangle.size(); ++face) {
            if (face % sliver_faces_a_look == 0) progress_.check();
            const int longest = sliver_side(welded_.triangle[face]);
            if (longest < 0) continue;
            const Triangle& t = welded_.triangle[face];
            const auto k = static_cast<std::size_t>(longest);
            longest_[face] = edge_of(t[k], t[(k + 1) % 3]);
            found_.push_back({longest_[face], face, t[k] < t[(k + 1) % 3]});
        }
        std::sort(found_.begin(), found_.end(), [](const Sliver& a, const Sliver& b) {
            return a.edge != b.edge ? a.edge < b.edge : a.face < b.face;
        });
    }

    // The number of the longest side of a face whose other corner lies within it; -1: it is no such face.
    [[nodiscard]] int sliver_side(const Triangle& t) const noexcept {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return -1;
        const std::array<glm::dvec3, 3> p{welded_.vertex[t[0]], welded_.vertex[t[1]], welded_.vertex[t[2]]};
        int longest = 0;
        double length = 0.0;
        for (int k = 0; k < 3; ++k) {
            const auto from = static_cast<std::size_t>(k);
            const double one = glm::distance(p[from], p[(from + 1) % 3]);
            if (one <= length) continue;
            length = one;
            longest = k;
        }
        const double height = glm::length(doubled_area(p)) / length;
        return height <= std::min(rounding_, flattest * length) ? longest : -1;
    }

    void find_across() {
        for (std::int32_t face = 0; face < welded_.triangle.size(); ++face) {
            if (face % sliver_faces_a_look == 0) progress_.check();
            const Triangle& t = welded_.triangle[face];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t edge = edge_of(t[k], t[(k + 1) % 3]);
                auto at = std::lower_bound(found_.begin(), found_.end(), edge,
                                           [](const Sliver& one, std::uint64_t wanted) { return one.edge < wanted; });
                for (; at != found_.end() && at->edge == edge; ++at) take(*at, face, t[k] < t[(k + 1) % 3]);
            }
        }
    }

    // Where solids touch there are more than one: faces of one solid come near to each other in most files.
    static void take(Sliver& sliver, std::int32_t face, bool forward) noexcept {
        if (sliver.face == face) return;
        const bool agrees = forward != sliver.forward;
        const auto off = [&](std::int32_t other) { return std::abs(std::int64_t{other} - sliver.face); };
        const bool better = sliver.across < 0 || (agrees && !sliver.agrees) ||
                            (agrees == sliver.agrees && off(face) < off(sliver.across));
        if (!better) return;
        sliver.across = face;
        sliver.agrees = agrees;
    }

    [[nodiscard]] std::int64_t split_all() {
        std::fill(changed_.begin(), changed_.end(), std::uint8_t{0});
        std::int64_t split = 0;
        for (const Sliver& sliver : found_) {
            if (sliver.across < 0 || changed_[sliver.face] != 0 || changed_[sliver.across] != 0) continue;
            // Another sliver is cut at its own longest side first: else the two would take turns for ever.
            if (longest_[sliver.across] != no_edge && longest_[sliver.across] != sliver.edge) continue;
            const auto a = static_cast<std::int32_t>(sliver.edge >> 32U);
            const auto b = static_cast<std::int32_t>(sliver.edge & 0xFFFFFFFFU);
            const Triangle& flat = welded_.triangle[sliver.face];
            const std::int32_t middle =
                *std::find_if(flat.begin(), flat.end(), [&](std::int32_t v) { return v != a && v != b; });
            const Triangle whole = welded_.triangle[sliver.across];
            if (std::find(whole.begin(), whole.end(), middle) != whole.end()) continue; // it lies on it
            const auto with = [&](std::int32_t instead) {
                Triangle half = whole;
                std::replace(half.begin(), half.end(), instead, middle);
                return half;
            };
            welded_.triangle[sliver.across] = with(a);
            welded_.triangle[sliver.face] = with(b);
            welded_.given_face[sliver.face] = welded_.given_face[sliver.across];
            changed_[sliver.face] = changed_[sliver.across] = 1;
            ++split;
        }
        return split;
    }

    Welded& welded_;
    const base::Progress& progress_;
    const double rounding_;
    base::Array<Sliver> found_;
    base::Array<std::uint64_t> longest_; // sides of slivers
    base::Array<std::uint8_t> changed_;  // faces in this round
};

} // namespace

std::int64_t split_slivers(Welded& welded, const base::Progress& progress) { return Splitter(welded, progress).run(); }

} // namespace hrbfnpr::mesh
