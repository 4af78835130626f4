// SPDX-License-Identifier: MIT
#include "output/vector/near_tree.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::output {

void NearTree::build(std::span<const glm::dvec2> points, const base::Progress& progress) {
    const auto count = static_cast<std::int32_t>(points.size());
    points_.resize_for_overwrite(count);
    std::copy(points.begin(), points.end(), points_.begin());
    number_.resize_for_overwrite(count);
    for (std::int32_t i = 0; i < count; ++i) number_[i] = i;
    place_.resize_for_overwrite(count);
    leaf_.resize_for_overwrite(count);
    std::int64_t leaves = 1;
    while (leaves * leaf_size < count) leaves *= 2;
    Looks looks(progress, 16384); // points
    nodes_.clear();
    nodes_.resize(count > 0 ? 2 * leaves - 1 : 0);
    for (std::int64_t i = 0; i < nodes_.size(); ++i) {
        nodes_[i].is_leaf = i >= leaves - 1 ? 1 : 0;
        if (i == 0) nodes_[i].end = count;
        split(i);
        looks.count(nodes_[i].live);
    }
}

// Halves a node's points across its longer side.  Ties go by number, so that every standard library has one result.
void NearTree::split(std::int64_t number) {
    Node& node = nodes_[number];
    node.live = node.end - node.begin;
    node.min = glm::dvec2(std::numeric_limits<double>::infinity());
    node.max = -node.min;
    std::int32_t* const begin = number_.data() + node.begin;
    std::int32_t* const end = number_.data() + node.end;
    for (const std::int32_t* p = begin; p < end; ++p) {
        node.min = glm::min(node.min, points_[*p]);
        node.max = glm::max(node.max, points_[*p]);
    }
    if (node.is_leaf != 0) {
        std::sort(begin, end);
        for (std::int32_t i = node.begin; i < node.end; ++i) {
            place_[number_[i]] = i;
            leaf_[number_[i]] = static_cast<std::int32_t>(number);
        }
        return;
    }
    const int axis = node.max.x - node.min.x >= node.max.y - node.min.y ? 0 : 1;
    const std::int32_t middle = node.begin + node.live / 2;
    std::nth_element(begin, number_.data() + middle, end, [&](std::int32_t a, std::int32_t b) {
        return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
    });
    nodes_[2 * number + 1].begin = node.begin;
    nodes_[2 * number + 1].end = nodes_[2 * number + 2].begin = middle;
    nodes_[2 * number + 2].end = node.end;
}

void NearTree::remove(std::int32_t point) noexcept {
    if (!holds(point)) return;
    std::int64_t at = leaf_[point];
    const std::int32_t place = place_[point];
    const std::int32_t last = nodes_[at].begin + nodes_[at].live - 1;
    std::swap(number_[place], number_[last]);
    place_[number_[place]] = place;
    place_[point] = last;
    for (;; at = (at - 1) / 2) {
        --nodes_[at].live;
        if (at == 0) return;
    }
}

std::int32_t NearTree::nearest(const glm::dvec2& p) const noexcept {
    std::int32_t found = -1;
    double square = std::numeric_limits<double>::infinity();
    search(p, square, [&](std::int32_t point, double from) {
        square = from;
        found = point;
    });
    return found;
}

} // namespace hrbfnpr::output
