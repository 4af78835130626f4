// SPDX-License-Identifier: MIT
#include "geometry/farthest_order.h"

#include "base/long_array.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::geometry {
namespace {

constexpr std::int64_t leaf_size = 16;
constexpr double picked = -1.0; // marks a picked point; it is below any squared distance

// A few points are picked by scans of all points, because a tree takes as long to build as this many scans take.
constexpr std::int64_t picks_by_scans = 16;

// A k-d tree in which each node knows which of its points is farthest from the picked points. The next pick is read
// from the root, and a pick visits only nodes that hold a point whose distance it may shorten.
class FarthestTree {
public:
    FarthestTree(const VecArray& points, const base::Progress& progress);

    [[nodiscard]] std::int64_t nearest_to_centre() const noexcept;
    [[nodiscard]] std::int64_t farthest() const noexcept { return nodes_[0].farthest; }
    // Returns the squared distance of farthest() from the picked points.
    [[nodiscard]] double squared_distance() const noexcept { return nodes_[0].squared_distance; }
    void pick(std::int64_t at) noexcept;

    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return tree_.index(at); }

private:
    struct Node { // the size of a cache line
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        double squared_distance = 0.0;
        std::int64_t farthest = 0; // index in the tree's order
    };
    using Range = HeapNode<leaf_size>;

    [[nodiscard]] Range whole() const noexcept { return {0, 0, tree_.size()}; }
    Bounds build(const Range& range, const base::Progress& progress);
    void lower_distances(const Range& range, const glm::dvec3& p) noexcept;
    void scan(const Range& leaf) noexcept;
    void update_from_children(Node& node, const Range& range) noexcept;
    // Returns whether point a, with its distance, is picked before point b.
    [[nodiscard]] bool before(double a_distance, std::int64_t a, double b_distance, std::int64_t b) const noexcept {
        return a_distance > b_distance || (a_distance == b_distance && index(a) < index(b));
    }

    PointTree tree_;
    // For each point, in the tree's order, the squared distance to the picked points.
    base::Array<double> squared_distance_;
    base::Array<Node> nodes_; // in heap order
};

FarthestTree::FarthestTree(const VecArray& points, const base::Progress& progress)
    : tree_(points, progress), squared_distance_(points.memory()), nodes_(points.memory()) {
    base::resize_long(nodes_, Range::nodes(points.size()), progress);
    base::fill_long(squared_distance_, points.size(), HUGE_VAL, progress);
    build(whole(), progress);
}

Bounds FarthestTree::build(const Range& range, const base::Progress& progress) {
    if (range.end - range.begin > 16384) progress.check();
    Bounds box;
    if (range.leaf()) {
        for (std::int64_t at = range.begin; at < range.end; ++at) box.extend(tree_.points()[at]);
    } else {
        box = build(range.low(), progress);
        const Bounds other = build(range.high(), progress);
        box.extend(other.min);
        box.extend(other.max);
    }
    nodes_[range.node] = {box.min, box.max, HUGE_VAL, range.begin};
    return box;
}

std::int64_t FarthestTree::nearest_to_centre() const noexcept {
    const glm::dvec3 centre = 0.5 * nodes_[0].low + 0.5 * nodes_[0].high;
    std::int64_t best = 0;
    double best_distance = HUGE_VAL;
    for (std::int64_t at = 0; at < tree_.size(); ++at) {
        const glm::dvec3 between = tree_.points()[at] - centre;
        const double squared = glm::dot(between, between);
        if (squared > best_distance || (squared == best_distance && index(at) > index(best))) continue;
        best = at;
        best_distance = squared;
    }
    return best;
}

void FarthestTree::pick(std::int64_t at) noexcept {
    squared_distance_[at] = picked;
    lower_distances(whole(), tree_.points()[at]);
}

void FarthestTree::lower_distances(const Range& range, const glm::dvec3& p) noexcept {
    Node& node = nodes_[range.node];
    const glm::dvec3 outside = glm::max(glm::max(node.low - p, p - node.high), glm::dvec3(0.0));
    // For distances alone, nodes at equal distance could be skipped, too. But the node that holds p must be updated,
    // because p is picked.
    if (glm::dot(outside, outside) > node.squared_distance) return;
    if (!range.leaf()) {
        lower_distances(range.low(), p);
        lower_distances(range.high(), p);
        update_from_children(node, range);
        return;
    }
    const VecArray& points = tree_.points();
    for (std::int64_t i = range.begin; i < range.end; ++i) {
        const double x = points.x[i] - p.x;
        const double y = points.y[i] - p.y;
        const double z = points.z[i] - p.z;
        squared_distance_[i] = std::min(squared_distance_[i], x * x + y * y + z * z);
    }
    scan(range);
}

void FarthestTree::scan(const Range& leaf) noexcept {
    std::int64_t best = leaf.begin;
    for (std::int64_t i = leaf.begin + 1; i < leaf.end; ++i)
        if (before(squared_distance_[i], i, squared_distance_[best], best)) best = i;
    nodes_[leaf.node].farthest = best;
    nodes_[leaf.node].squared_distance = squared_distance_[best];
}

void FarthestTree::update_from_children(Node& node, const Range& range) noexcept {
    const Node& low = nodes_[range.low().node];
    const Node& high = nodes_[range.high().node];
    const bool low_first = before(low.squared_distance, low.farthest, high.squared_distance, high.farthest);
    node.farthest = low_first ? low.farthest : high.farthest;
    node.squared_distance = low_first ? low.squared_distance : high.squared_distance;
}

// Sets the picks of `result`. Each scan finds the point that is farthest from the points picked before.
void pick_by_scans(const VecArray& points, const base::Progress& progress, FarthestOrder& result) {
    Bounds box;
    for (const std::int64_t i : progress.over(points.size())) box.extend(points[i]);
    const glm::dvec3 centre = 0.5 * box.min + 0.5 * box.max;
    const auto squared_to = [&](const glm::dvec3& p, std::int64_t i) {
        const double x = points.x[i] - p.x;
        const double y = points.y[i] - p.y;
        const double z = points.z[i] - p.z;
        return x * x + y * y + z * z;
    };
    std::int64_t next = 0;
    for (const std::int64_t i : progress.over(points.size()))
        if (squared_to(centre, i) < squared_to(centre, next)) next = i;
    base::Array<double> squared(points.memory()); // for each point: the squared distance from the picked points
    base::fill_long(squared, points.size(), HUGE_VAL, progress);
    for (std::int64_t k = 0; k < result.order.size(); ++k) {
        progress.check();
        result.order[k] = next;
        result.distance[k] = std::sqrt(squared[next]);
        const glm::dvec3 p = points[next];
        for (std::int64_t i = 0; i < points.size(); ++i) squared[i] = std::min(squared[i], squared_to(p, i));
        squared[next] = picked;
        next = std::max_element(squared.begin(), squared.end()) - squared.begin(); // the first of the farthest
    }
    progress.update(1.0);
}

} // namespace

FarthestOrder farthest_order(const VecArray& points, std::int64_t count, const base::Progress& progress) {
    FarthestOrder result(points.memory());
    const std::int64_t picks = count > 0 ? std::min(count, points.size()) : points.size();
    if (picks == 0) return result;
    result.order.resize(picks);
    result.distance.resize(picks);
    if (picks <= picks_by_scans) {
        pick_by_scans(points, progress, result);
        return result;
    }
    FarthestTree tree(points, progress);
    for (std::int64_t k = 0; k < picks; ++k) {
        if (k % 256 == 0) progress.update(static_cast<double>(k) / static_cast<double>(picks));
        progress.check(); // the first picks examine all points
        const std::int64_t at = k == 0 ? tree.nearest_to_centre() : tree.farthest();
        result.order[k] = tree.index(at);
        result.distance[k] = k == 0 ? HUGE_VAL : std::sqrt(tree.squared_distance());
        tree.pick(at);
    }
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::geometry
