// SPDX-License-Identifier: MIT
#include "orient/spanning_tree.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t edges_a_task = 1024;
constexpr std::int64_t edges_a_look = 16384;

struct Edge {
    float doubt;
    std::int32_t a;
    std::int32_t b;
    std::int32_t turned; // 1: the signs differ
};

// Sets of places that are joined, each with its sign relative to the set's first (Tarjan 1975).
class SignedSets {
public:
    SignedSets(base::Memory& memory, std::int64_t size) : parent_(memory, size), turned_(memory, size) {
        for (std::int64_t i = 0; i < size; ++i) parent_[i] = static_cast<std::int32_t>(i);
    }

    // The set's first, and whether the place has the other sign.
    std::pair<std::int32_t, bool> find(std::int32_t at) noexcept {
        bool turned = false;
        std::int32_t root = at;
        while (parent_[root] != root) {
            turned ^= turned_[root] != 0;
            root = parent_[root];
        }
        bool rest = turned;
        while (parent_[at] != root && at != root) {
            const std::int32_t next = parent_[at];
            const bool own = turned_[at] != 0;
            parent_[at] = root;
            turned_[at] = rest ? 1 : 0;
            rest ^= own;
            at = next;
        }
        return {root, turned};
    }
    void join(const Edge& edge) noexcept {
        const auto [a, a_turned] = find(edge.a);
        const auto [b, b_turned] = find(edge.b);
        if (a == b) return;
        const std::int32_t low = std::min(a, b);
        const std::int32_t high = std::max(a, b);
        parent_[high] = low;
        turned_[high] = (a_turned ^ b_turned ^ (edge.turned != 0)) ? 1 : 0;
    }

private:
    base::Array<std::int32_t> parent_;
    base::Array<std::uint8_t> turned_; // against the parent
};

[[nodiscard]] Edge edge_between(const geometry::PointTree& tree, const geometry::VecArray& normal, Spreading spreading,
                                std::int64_t a, std::int64_t b) noexcept {
    glm::dvec3 expected = normal[a];
    if (spreading == Spreading::reflected) {
        const glm::dvec3 between = glm::normalize(tree.points()[b] - tree.points()[a]);
        expected -= 2.0 * glm::dot(expected, between) * between;
    }
    const double cosine = glm::dot(expected, normal[b]);
    return {static_cast<float>(1.0 - std::min(1.0, std::abs(cosine))), static_cast<std::int32_t>(std::min(a, b)),
            static_cast<std::int32_t>(std::max(a, b)), cosine < 0.0 ? 1 : 0};
}

} // namespace

Signs spread_signs(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                   std::int64_t neighbours, const geometry::VecArray& normal, Spreading spreading,
                   const base::Progress& progress) {
    const std::int64_t each = std::min(neighbours, near.each());
    base::Array<Edge> edges(runtime.memory);
    edges.resize_for_overwrite(tree.size() * each);
    runtime.parallel.for_chunks(tree.size(), edges_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at)
            for (std::int64_t k = 0; k < each; ++k)
                edges[at * each + k] =
                    edge_between(tree, normal, spreading, at, near.of(at)[static_cast<std::size_t>(k)]);
    });
    progress.check();
    // Two places that are each other's neighbours have an edge twice: those that are equal are the same.
    base::sort_long(
        edges.begin(), edges.end(),
        [](const Edge& x, const Edge& y) {
            return std::tie(x.doubt, x.a, x.b, x.turned) < std::tie(y.doubt, y.a, y.b, y.turned);
        },
        progress);
    SignedSets sets(runtime.memory, tree.size());
    for (std::int64_t k = 0; k < edges.size(); ++k) {
        if (k % edges_a_look == 0) progress.check();
        sets.join(edges[k]);
    }
    Signs signs(runtime.memory, tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at)
        signs[at] = sets.find(static_cast<std::int32_t>(at)).second ? std::int8_t{-1} : std::int8_t{1};
    return signs;
}

} // namespace hrbfnpr::orient
