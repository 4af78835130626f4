// SPDX-License-Identifier: MIT
#include "mesh/pieces/creases.h"

#include "base/assert.h"
#include "mesh/pieces/patches.h"
#include "mesh/pieces/split_fading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double radians = 0.017453292519943295;
constexpr double no_crease = 180.0;
// A crease that ends is grown along edges that bend by so many degrees, ...
constexpr double least_bend = 8.0;
// ... and turn from it by an angle with at least this cosine.
constexpr double aligned = 0.6;
// A crease that parts nothing, and does not go from one other crease to another as the corner of a plate does, is noise
// if it is shorter than so many diagonals, or has fewer edges.
constexpr double shortest_fading = 0.03;
constexpr std::int64_t fewest_fading = 4;
// A patch of fewer faces than this, whose area is less than the square of this many diagonals, is no patch.
constexpr std::int64_t scrap_faces = 10;
constexpr double scrap_size = 0.002;

// An edge that bends.
struct Bend {
    std::int32_t from, to;
    std::int32_t left, right;
    double angle; // radians
    bool sharp;
};

class Finder {
public:
    // One sharpness for all faces, or several, and the number of its own for each face.  known: edges that are sharp.
    // may_be_sharp: the sides of the others that may be sharp; if it is empty, all may.
    Finder(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Sharpness>& sharpness,
           const base::Array<std::int32_t>& of_face, const base::Array<Crease>& known,
           const base::Array<std::uint8_t>& may_be_sharp, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), sharpness_(sharpness), of_face_(of_face), known_(known),
          may_be_sharp_(may_be_sharp), progress_(progress), bend_(runtime.memory), first_(runtime.memory),
          at_(runtime.memory), degree_(runtime.memory, mesh.vertex.size()),
          sides_(sides_by_edge(runtime, mesh.triangle, progress)), result_(runtime.memory) {}

    [[nodiscard]] Creases run() {
        find_bends();
        index_by_vertex();
        grow();
        sharpen_between_corners();
        progress_.check();
        find_patches();
        if (sharpen_coarse()) find_patches();
        if (drop_short_fading()) find_patches();
        while (join_scraps()) find_patches();
        describe();
        split_fading(runtime_, mesh_, sides_, result_, progress_);
        describe();
        return std::move(result_);
    }

private:
    [[nodiscard]] static bool is_plain(const Side* first, const Side* last) noexcept {
        return last - first == 2 && first[0].forward != first[1].forward;
    }

    [[nodiscard]] const Sharpness& sharpness_of(std::int32_t face) const noexcept {
        return sharpness_[sharpness_.size() == 1 ? 0 : of_face_[face]];
    }
    [[nodiscard]] double limit_of(std::int32_t face) const noexcept { return sharpness_of(face).angle * radians; }

    // Returns the number of the side of a face that begins in a vertex.
    [[nodiscard]] std::int64_t side_of(std::int32_t face, std::int32_t from) const noexcept {
        const Triangle& t = mesh_.triangle[face];
        return 3 * std::int64_t{face} + (t[0] == from ? 0 : t[1] == from ? 1 : 2);
    }
    [[nodiscard]] bool may_be_sharp(std::int32_t face, std::int32_t from) const noexcept {
        return may_be_sharp_.empty() || may_be_sharp_[side_of(face, from)] != 0;
    }

    [[nodiscard]] double length_of(const Bend& bend) const noexcept {
        return glm::distance(mesh_.vertex[bend.from], mesh_.vertex[bend.to]);
    }

    void find_bends() {
        base::Array<glm::dvec3> normal(runtime_.memory);
        for (std::int64_t face = 0; face < mesh_.faces(); ++face)
            normal.push_back(glm::normalize(doubled_area(mesh_.corners(face))));
        const Crease* known = known_.begin(); // in the same order
        for_edges(sides_, progress_, [&](const Side* first, const Side* last) {
            const auto low = static_cast<std::int32_t>(first->edge >> 32U);
            const auto high = static_cast<std::int32_t>(first->edge & 0xFFFFFFFFU);
            if (!is_plain(first, last)) { // patches end here, and so may creases
                ++degree_[low];
                ++degree_[high];
                return;
            }
            const Side& left = first[0].forward != 0 ? first[0] : first[1];
            const Side& right = first[0].forward != 0 ? first[1] : first[0];
            const glm::dvec3 a = normal[left.face];
            const glm::dvec3 b = normal[right.face];
            const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            const double limit = limit_of(left.face);
            const bool is_known = known != known_.end() && known->from == low && known->to == high;
            known += is_known ? 1 : 0;
            if (!is_known && angle < std::min(least_bend * radians, limit)) return;
            const bool sharp = is_known || (bends_more(angle, limit) && may_be_sharp(left.face, low));
            bend_.push_back({low, high, left.face, right.face, angle, sharp});
            degree_[low] += sharp ? 1 : 0;
            degree_[high] += sharp ? 1 : 0;
        });
    }

    void index_by_vertex() {
        first_.resize(mesh_.vertex.size() + 1);
        for (const Bend& bend : bend_) {
            ++first_[bend.from + 1];
            ++first_[bend.to + 1];
        }
        for (std::int64_t v = 0; v < mesh_.vertex.size(); ++v) first_[v + 1] += first_[v];
        at_.resize(2 * bend_.size());
        base::Array<std::int64_t> next(runtime_.memory);
        for (const std::int64_t i : first_) next.push_back(i);
        for (std::int64_t i = 0; i < bend_.size(); ++i) {
            at_[next[bend_[i].from]++] = i;
            at_[next[bend_[i].to]++] = i;
        }
    }

    // Those that end nowhere go on, until they meet another or nothing goes on.
    void grow() {
        const std::int64_t count = bend_.size();
        for (std::int64_t i = 0; i < count; ++i) {
            if (!bend_[i].sharp) continue;
            for (const bool forward : {true, false}) {
                const std::int32_t end = forward ? bend_[i].to : bend_[i].from;
                if (degree_[end] == 1) grow_from(forward ? bend_[i].from : bend_[i].to, end);
            }
        }
    }

    void grow_from(std::int32_t before, std::int32_t end) {
        while (degree_[end] == 1) {
            const glm::dvec3 along = glm::normalize(mesh_.vertex[end] - mesh_.vertex[before]);
            std::int64_t best = -1;
            double best_score = 0.0;
            for (std::int64_t k = first_[end]; k < first_[end + 1]; ++k) {
                const Bend& bend = bend_[at_[k]];
                if (bend.sharp) continue;
                const std::int32_t other = bend.from == end ? bend.to : bend.from;
                const double cosine = glm::dot(along, glm::normalize(mesh_.vertex[other] - mesh_.vertex[end]));
                if (cosine < aligned || cosine * bend.angle <= best_score) continue;
                best_score = cosine * bend.angle;
                best = at_[k];
            }
            if (best < 0) return;
            Bend& bend = bend_[best];
            bend.sharp = true;
            const std::int32_t other = bend.from == end ? bend.to : bend.from;
            ++degree_[end];
            ++degree_[other];
            before = end;
            end = other;
        }
    }

    // Whether creases meet in a vertex, and none of them goes straight on.
    [[nodiscard]] bool is_corner(std::int32_t vertex) const noexcept {
        const auto way = [&](const Bend& bend) {
            return glm::normalize(mesh_.vertex[bend.from == vertex ? bend.to : bend.from] - mesh_.vertex[vertex]);
        };
        std::int64_t creases = 0;
        for (std::int64_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
            if (!bend_[at_[i]].sharp) continue;
            ++creases;
            const double limit = limit_of(bend_[at_[i]].left);
            for (std::int64_t j = first_[vertex]; j < i; ++j) {
                if (!bend_[at_[j]].sharp) continue;
                const double cosine = -glm::dot(way(bend_[at_[i]]), way(bend_[at_[j]]));
                if (!bends_more(std::acos(std::clamp(cosine, -1.0, 1.0)), limit)) return false;
            }
        }
        return creases >= 2;
    }

    // Edges that bend less, from one corner of creases to another: a smooth patch does not have an outline with
    // corners there, so its faces are facets.
    void sharpen_between_corners() {
        base::Array<std::int64_t> found(runtime_.memory);
        for (std::int64_t i = 0; i < bend_.size(); ++i)
            if (!bend_[i].sharp && bend_[i].angle >= least_bend * radians && is_corner(bend_[i].from) &&
                is_corner(bend_[i].to))
                found.push_back(i);
        for (const std::int64_t i : found) {
            bend_[i].sharp = true;
            ++degree_[bend_[i].from];
            ++degree_[bend_[i].to];
        }
    }

    void find_patches() {
        base::Array<std::uint8_t> sharp(runtime_.memory, 3 * mesh_.faces());
        for (const Bend& bend : bend_)
            if (bend.sharp) {
                sharp[side_of(bend.left, bend.from)] = 1;
                sharp[side_of(bend.right, bend.to)] = 1;
            }
        Sets sets(runtime_.memory, mesh_.faces());
        for_edges(sides_, progress_, [&](const Side* first, const Side* last) {
            const bool joined = is_plain(first, last);
            const auto low = static_cast<std::int32_t>(first->edge >> 32U);
            const auto high = static_cast<std::int32_t>(first->edge & 0xFFFFFFFFU);
            for (const Side* side = first; side != last; ++side)
                if (!joined) sharp[side_of(side->face, side->forward != 0 ? low : high)] = 1;
            if (joined && sharp[side_of(first->face, first->forward != 0 ? low : high)] == 0)
                sets.join(first[0].face, first[1].face);
        });
        result_.cut = std::move(sharp);
        number(sets);
    }

    void number(Sets& sets) {
        base::Array<std::int32_t> number(runtime_.memory, mesh_.faces());
        result_.patch.resize(mesh_.faces());
        result_.patches = 0;
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            std::int32_t& of = number[sets.of(static_cast<std::int32_t>(face))];
            if (of == 0) of = ++result_.patches;
            result_.patch[face] = of - 1;
        }
    }

    // Whether there were faces too far from what is curved as their normals are.
    [[nodiscard]] bool sharpen_coarse() {
        const base::Array<glm::dvec3> normal = patch_normals(runtime_, mesh_, result_).normal;
        bool sharpened = false;
        for (Bend& bend : bend_) {
            if (bend.sharp || std::max(chord_error(mesh_, normal, bend.left), chord_error(mesh_, normal, bend.right)) <=
                                  sharpness_of(bend.left).coarse)
                continue;
            bend.sharp = sharpened = true;
        }
        return sharpened;
    }

    // Whether there were any.
    [[nodiscard]] bool drop_short_fading() {
        Sets sets(runtime_.memory, mesh_.vertex.size());
        for (const Bend& bend : bend_)
            if (is_fading(bend)) sets.join(bend.from, bend.to);
        base::Array<double> length(runtime_.memory, mesh_.vertex.size());
        base::Array<std::int64_t> edges(runtime_.memory, mesh_.vertex.size());
        for (const Bend& bend : bend_)
            if (is_fading(bend)) {
                length[sets.of(bend.from)] += length_of(bend);
                ++edges[sets.of(bend.from)];
            }
        base::Array<std::int32_t> anchors(runtime_.memory, mesh_.vertex.size());
        for (std::int32_t v = 0; v < mesh_.vertex.size(); ++v) anchors[sets.of(v)] += is_anchor(v) ? 1 : 0;
        bool dropped = false;
        for (Bend& bend : bend_) {
            if (!is_fading(bend)) continue;
            const std::int32_t set = sets.of(bend.from);
            if (anchors[set] >= 2) continue;
            if (length[set] >= shortest_fading * mesh_.bounds.diagonal() && edges[set] >= fewest_fading) continue;
            bend.sharp = false;
            dropped = true;
        }
        return dropped;
    }

    [[nodiscard]] bool is_fading(const Bend& bend) const noexcept {
        return bend.sharp && result_.patch[bend.left] == result_.patch[bend.right];
    }

    // Whether a crease that parts two patches passes there.
    [[nodiscard]] bool is_anchor(std::int32_t vertex) const noexcept {
        return std::any_of(at_.data() + first_[vertex], at_.data() + first_[vertex + 1],
                           [&](std::int64_t i) { return bend_[i].sharp && !is_fading(bend_[i]); });
    }

    // Tells which patches are a few faces too small to be seen.
    [[nodiscard]] base::Array<std::uint8_t> find_scraps() const {
        base::Array<std::int64_t> faces(runtime_.memory, result_.patches);
        base::Array<double> area(runtime_.memory, result_.patches);
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            ++faces[result_.patch[face]];
            area[result_.patch[face]] += 0.5 * glm::length(doubled_area(mesh_.corners(face)));
        }
        const double across = scrap_size * mesh_.bounds.diagonal();
        base::Array<std::uint8_t> is_scrap(runtime_.memory, result_.patches);
        for (std::int32_t patch = 0; patch < result_.patches; ++patch)
            is_scrap[patch] = faces[patch] < scrap_faces && area[patch] < across * across ? 1 : 0;
        return is_scrap;
    }

    // Joins each scrap with the patch beyond its flattest edge. Returns whether there were any.
    [[nodiscard]] bool join_scraps() {
        progress_.check();
        const base::Array<std::uint8_t> is_scrap = find_scraps();
        base::Array<std::int64_t> flattest(runtime_.memory, result_.patches); // numbers of bends, from 1
        for (std::int64_t i = 0; i < bend_.size(); ++i) {
            if (!bend_[i].sharp || is_fading(bend_[i])) continue;
            for (const std::int32_t face : {bend_[i].left, bend_[i].right}) {
                std::int64_t& best = flattest[result_.patch[face]];
                if (best == 0 || bend_[i].angle < bend_[best - 1].angle) best = i + 1;
            }
        }
        Sets joined_patches(runtime_.memory, result_.patches);
        for (std::int32_t patch = 0; patch < result_.patches; ++patch) {
            if (is_scrap[patch] == 0 || flattest[patch] == 0) continue;
            const Bend& bend = bend_[flattest[patch] - 1];
            joined_patches.join(result_.patch[bend.left], result_.patch[bend.right]);
        }
        bool joined = false;
        for (Bend& bend : bend_) {
            const std::int32_t left = result_.patch[bend.left], right = result_.patch[bend.right];
            if (!bend.sharp || left == right || joined_patches.of(left) != joined_patches.of(right)) continue;
            bend.sharp = false;
            joined = true;
        }
        return joined;
    }

    void describe() {
        result_.edge.clear();
        result_.length = result_.fading = 0.0;
        for (const Bend& bend : bend_) {
            if (!bend.sharp) continue;
            result_.edge.push_back({bend.from, bend.to, bend.left, bend.right});
            result_.length += length_of(bend);
            result_.fading += is_fading(bend) ? length_of(bend) : 0.0;
        }
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    const base::Array<Sharpness>& sharpness_;
    const base::Array<std::int32_t>& of_face_;
    const base::Array<Crease>& known_;
    const base::Array<std::uint8_t>& may_be_sharp_;
    const base::Progress& progress_;
    base::Array<Bend> bend_;
    base::Array<std::int64_t> first_; // of the bends at each vertex, in at_
    base::Array<std::int64_t> at_;
    base::Array<std::int32_t> degree_; // of each vertex: creases and ends of patches there
    base::Array<Side> sides_;
    Creases result_;
};

} // namespace

Creases find_creases(const base::Runtime& runtime, const Mesh& mesh, double angle, double coarse,
                     const base::Progress& progress) {
    base::Array<Sharpness> of_all(runtime.memory);
    of_all.push_back({angle, coarse});
    const base::Array<Crease> none(runtime.memory);
    const base::Array<std::uint8_t> all(runtime.memory);
    return Finder(runtime, mesh, of_all, mesh.component, none, all, progress).run();
}

Creases find_creases(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Sharpness>& of_component,
                     const base::Array<std::uint8_t>& sides, const base::Progress& progress) {
    HRBFNPR_ASSERT(sides.size() == 3 * mesh.faces());
    const base::Array<Crease> none(runtime.memory);
    return Finder(runtime, mesh, of_component, mesh.component, none, sides, progress).run();
}

Creases find_more_creases(const base::Runtime& runtime, const Mesh& mesh, const Creases& known,
                          const base::Array<std::uint8_t>& within, double angle, const base::Progress& progress) {
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    base::Array<Sharpness> of_patch(runtime.memory);
    for (const std::uint8_t is : within) of_patch.push_back({is != 0 ? angle : no_crease, no_limit});
    const base::Array<std::uint8_t> all(runtime.memory);
    return Finder(runtime, mesh, of_patch, known.patch, known.edge, all, progress).run();
}

} // namespace hrbfnpr::mesh
