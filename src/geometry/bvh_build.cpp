// SPDX-License-Identifier: MIT
// A node begins with one range of items. The range with the largest surface is divided in two, again and again, until
// there are eight. Of all planes that divide a range, the heuristic chooses the one with the least expected cost of a
// ray: the sum, over both parts, of their surface times their number of leaves (MacDonald, Booth, "Heuristics for ray
// tracing using space subdivision", 1990). Only planes between a few bins of equal width are considered (Wald, "On fast
// construction of SAH-based bounding volume hierarchies", 2007).
//
// Large ranges are divided one after the other, with all threads filling the bins. Ranges of at most `items_of_task`
// items are then made into parts of the hierarchy, each on one thread, and the parts are joined.
#include "geometry/bvh_build.h"

#include "base/assert.h"
#include "base/list.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace hrbfnpr::geometry {
namespace {

// The number of bins along each axis. Fewer: building is a little faster, and rays and nearest places a little slower.
constexpr int bins_of_axis = 16;
// The largest range that one task builds. Larger: fewer tasks, so threads may wait for the last one.
constexpr std::int64_t items_of_task = 16384;
// Nodes on lower levels than this divide their ranges in the middle, which ends after at most log8(2^31) levels more.
constexpr int depth_of_halving = 24;
static_assert(depth_of_halving + 12 <= bvh_levels);

struct FloatBox {
    float low[4] = {infinite, infinite, infinite, infinite};
    float high[4] = {-infinite, -infinite, -infinite, -infinite};

    void extend(const float* from, const float* to) noexcept {
        for (int k = 0; k < 4; ++k) {
            low[k] = from[k] < low[k] ? from[k] : low[k];
            high[k] = to[k] > high[k] ? to[k] : high[k];
        }
    }
    void extend(const FloatBox& box) noexcept { extend(box.low, box.high); }
    // Returns half of the surface.
    [[nodiscard]] float area() const noexcept {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x * y + (y + x) * z;
    }

private:
    static constexpr float infinite = std::numeric_limits<float>::infinity();
};

struct ItemRange {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    FloatBox box;

    [[nodiscard]] std::int64_t size() const noexcept { return end - begin; }
};

struct Bin {
    FloatBox box;
    std::int64_t count = 0;
};
using BinsOfAxis = std::array<Bin, bins_of_axis>;
using Bins = std::array<BinsOfAxis, 3>;

// Divides the middles of items into bins. It works with sums of both sides, which are twice the middles.
struct Binning {
    explicit Binning(const FloatBox& sums) noexcept {
        for (int k = 0; k < 3; ++k) {
            const float size = sums.high[k] - sums.low[k];
            from[k] = sums.low[k];
            // The factor is a little below the number of bins, so that the last place is in the last bin.
            per[k] = size > 1e-30F ? 0.999F * bins_of_axis / size : 0.0F;
        }
    }
    [[nodiscard]] int bin(const BvhItem& item, int k) const noexcept {
        return static_cast<int>((item.low[k] + item.high[k] - from[k]) * per[k]);
    }

    float from[3];
    float per[3];
};

[[nodiscard]] FloatBox sums_of(const BvhItem* begin, const BvhItem* end) noexcept {
    FloatBox sums;
    for (; begin < end; ++begin) {
        float sum[4];
        for (int k = 0; k < 4; ++k) sum[k] = begin->low[k] + begin->high[k];
        sums.extend(sum, sum);
    }
    return sums;
}

void fill(const BvhItem* begin, const BvhItem* end, const Binning& binning, Bins& bins) noexcept {
    for (; begin < end; ++begin)
        for (int k = 0; k < 3; ++k) {
            Bin& bin = bins[static_cast<std::size_t>(k)][static_cast<std::size_t>(binning.bin(*begin, k))];
            bin.box.extend(begin->low, begin->high);
            ++bin.count;
        }
}

// The first part holds the items of the bins before `bin`.
struct Plane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    int bin = 0;
    FloatBox low;
    FloatBox high;
};

[[nodiscard]] float leaves(std::int64_t items) noexcept {
    return static_cast<float>((items + bvh_width - 1) / bvh_width);
}

[[nodiscard]] Plane best_plane(const Bins& bins) noexcept {
    Plane best;
    for (int axis = 0; axis < 3; ++axis) {
        const BinsOfAxis& bin = bins[static_cast<std::size_t>(axis)];
        std::array<Bin, bins_of_axis> above; // all bins from this one
        Bin sum;
        for (int i = bins_of_axis - 1; i > 0; --i) {
            sum.box.extend(bin[static_cast<std::size_t>(i)].box);
            sum.count += bin[static_cast<std::size_t>(i)].count;
            above[static_cast<std::size_t>(i)] = sum;
        }
        sum = {};
        for (int i = 1; i < bins_of_axis; ++i) {
            sum.box.extend(bin[static_cast<std::size_t>(i - 1)].box);
            sum.count += bin[static_cast<std::size_t>(i - 1)].count;
            const Bin& rest = above[static_cast<std::size_t>(i)];
            if (sum.count == 0 || rest.count == 0) continue;
            const float cost = sum.box.area() * leaves(sum.count) + rest.box.area() * leaves(rest.count);
            if (cost < best.cost) best = {cost, axis, i, sum.box, rest.box};
        }
    }
    return best;
}

[[nodiscard]] FloatBox box_of(const BvhItem* begin, const BvhItem* end) noexcept {
    FloatBox box;
    for (; begin < end; ++begin) box.extend(begin->low, begin->high);
    return box;
}

using TwoRanges = std::pair<ItemRange, ItemRange>;

[[nodiscard]] TwoRanges halve(const BvhItem* item, const ItemRange& range) noexcept {
    const std::int64_t middle = range.begin + range.size() / 2;
    return {{range.begin, middle, box_of(item + range.begin, item + middle)},
            {middle, range.end, box_of(item + middle, item + range.end)}};
}

[[nodiscard]] TwoRanges divide_at(BvhItem* item, const ItemRange& range, const Binning& binning, const Plane& plane) {
    const BvhItem* const middle = std::partition(item + range.begin, item + range.end, [&](const BvhItem& one) {
        return binning.bin(one, plane.axis) < plane.bin;
    });
    return {{range.begin, middle - item, plane.low}, {middle - item, range.end, plane.high}};
}

[[nodiscard]] TwoRanges divide(BvhItem* item, const ItemRange& range) {
    const Binning binning(sums_of(item + range.begin, item + range.end));
    Bins bins;
    fill(item + range.begin, item + range.end, binning, bins);
    const Plane plane = best_plane(bins);
    return plane.axis < 0 ? halve(item, range) : divide_at(item, range, binning, plane);
}

// The same with the bins filled by all threads.
[[nodiscard]] TwoRanges divide_on_threads(const base::Work& work, BvhItem* item, const ItemRange& range) {
    constexpr std::int64_t at_once = 16384;
    const std::int64_t chunks = (range.size() + at_once - 1) / at_once;
    base::Array<FloatBox> sums(work.memory, chunks);
    base::Array<Bins> part(work.memory, chunks);
    const auto for_chunks = [&](auto&& f) {
        work.for_chunks(range.size(), at_once, [&](std::int64_t begin, std::int64_t end) {
            f(begin / at_once, item + range.begin + begin, item + range.begin + end);
        });
    };
    for_chunks(
        [&](std::int64_t chunk, const BvhItem* begin, const BvhItem* end) { sums[chunk] = sums_of(begin, end); });
    for (std::int64_t chunk = 1; chunk < chunks; ++chunk) sums[0].extend(sums[chunk]);
    const Binning binning(sums[0]);
    for_chunks([&](std::int64_t chunk, const BvhItem* begin, const BvhItem* end) {
        part[chunk] = {};
        fill(begin, end, binning, part[chunk]);
    });
    for (std::int64_t chunk = 1; chunk < chunks; ++chunk)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < bins_of_axis; ++i) {
                part[0][axis][i].box.extend(part[chunk][axis][i].box);
                part[0][axis][i].count += part[chunk][axis][i].count;
            }
    const Plane plane = best_plane(part[0]);
    return plane.axis < 0 ? halve(item, range) : divide_at(item, range, binning, plane);
}

// The ranges of a node's children.
struct Children {
    std::array<ItemRange, bvh_width> range;
    std::size_t count = 0;
};

// Divides a range into up to eight. divide_range(range) returns two parts. If `halving`, the longest range is divided
// next, else the one with the largest surface.
template <class Divide>
[[nodiscard]] Children divide_by_eight(const ItemRange& all, bool halving, Divide&& divide_range) {
    Children children;
    children.range[children.count++] = all;
    while (children.count < bvh_width) {
        ItemRange* next = nullptr;
        float most = -1.0F;
        for (std::size_t i = 0; i < children.count; ++i) {
            ItemRange& range = children.range[i];
            const float size = halving ? static_cast<float>(range.size()) : range.box.area();
            if (range.size() <= bvh_width || !(size > most)) continue;
            next = &range;
            most = size;
        }
        if (next == nullptr) break;
        const TwoRanges two = divide_range(*next);
        *next = two.first;
        children.range[children.count++] = two.second;
    }
    return children;
}

// A range that becomes a node, or a part of the hierarchy.
struct Waiting {
    ItemRange range;
    std::int64_t node; // the index of its node in the array of nodes
    int depth;
};

[[nodiscard]] BvhNode without_children() noexcept {
    BvhNode node;
    for (auto& row : node.side) std::fill(std::begin(row), std::end(row), bvh_nowhere);
    std::fill(std::begin(node.child), std::end(node.child), std::uint32_t{0});
    return node;
}

void set_child(BvhNode& node, std::size_t i, const FloatBox& box, std::uint32_t child) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        node.side[k][i] = box.low[k] - bvh_margin;
        node.side[k + 3][i] = box.high[k] + bvh_margin;
    }
    node.child[i] = child;
}

[[nodiscard]] BvhLeaf leaf_of(const ItemRange& range) noexcept {
    HRBFNPR_ASSERT(range.size() > 0 && range.size() <= bvh_width);
    BvhLeaf leaf;
    leaf.first = static_cast<std::int32_t>(range.begin);
    leaf.count = static_cast<std::int32_t>(range.size());
    return leaf;
}

// Appends the nodes and leaves of a range of more than eight items. The first node is that of the whole range.
void build_part(const base::Work& work, BvhItem* item, const ItemRange& all, int depth, BvhBoxes& boxes) {
    base::Array<Waiting> waiting(work.memory);
    waiting.push_back({all, 0, depth});
    boxes.node.push_back(without_children());
    for (std::int64_t at = 0; at < waiting.size(); ++at) {
        const Waiting now = waiting[at];
        const bool halving = now.depth >= depth_of_halving;
        const Children children = divide_by_eight(now.range, halving, [&](const ItemRange& range) {
            return halving ? halve(item, range) : divide(item, range);
        });
        for (std::size_t i = 0; i < children.count; ++i) {
            const ItemRange& range = children.range[i];
            const bool is_leaf = range.size() <= bvh_width;
            const std::int64_t child = is_leaf ? boxes.leaf.size() : boxes.node.size();
            set_child(boxes.node[now.node], i, range.box, static_cast<std::uint32_t>(child) | (is_leaf ? bvh_leaf : 0));
            if (is_leaf) {
                boxes.leaf.push_back(leaf_of(range));
                continue;
            }
            boxes.node.push_back(without_children());
            waiting.push_back({range, child, now.depth + 1});
        }
    }
}

// A part that one task builds. It becomes child `child` of node `node`.
struct Part {
    ItemRange range;
    std::int64_t node;
    std::size_t child;
    int depth;
    std::int64_t first_node; // where its nodes and leaves begin in the hierarchy
    std::int64_t first_leaf;
};

// Makes the nodes of ranges that are too large for one task. Returns the parts below.
[[nodiscard]] base::Array<Part> build_top(const base::Work& work, base::Array<BvhItem>& item, BvhBoxes& boxes) {
    base::Array<Part> parts(work.memory);
    base::Array<Waiting> waiting(work.memory);
    waiting.push_back({{0, item.size(), box_of(item.begin(), item.end())}, 0, 0});
    boxes.node.push_back(without_children());
    for (std::int64_t at = 0; at < waiting.size(); ++at) {
        const Waiting now = waiting[at];
        const bool halving = now.depth >= depth_of_halving;
        const Children children = divide_by_eight(now.range, halving, [&](const ItemRange& range) {
            if (halving) return halve(item.data(), range);
            return range.size() > items_of_task ? divide_on_threads(work, item.data(), range)
                                                : divide(item.data(), range);
        });
        for (std::size_t i = 0; i < children.count; ++i) {
            const ItemRange& range = children.range[i];
            set_child(boxes.node[now.node], i, range.box, static_cast<std::uint32_t>(boxes.node.size()));
            if (range.size() <= items_of_task) {
                parts.push_back({range, now.node, i, now.depth + 1, 0, 0});
                continue;
            }
            boxes.node.push_back(without_children());
            waiting.push_back({range, boxes.node.size() - 1, now.depth + 1});
        }
    }
    return parts;
}

} // namespace

BvhBoxes build_bvh(const base::Work& work, base::Array<BvhItem>& item) {
    BvhBoxes boxes(work.memory);
    if (item.size() <= items_of_task) {
        if (item.size() > bvh_width) {
            build_part(work, item.data(), {0, item.size(), box_of(item.begin(), item.end())}, 0, boxes);
            return boxes;
        }
        if (!item.empty()) boxes.leaf.push_back(leaf_of({0, item.size(), {}}));
        boxes.root = bvh_leaf;
        return boxes;
    }
    base::Array<Part> parts = build_top(work, item, boxes);
    base::List<BvhBoxes> built(work.memory);
    for (std::int64_t i = 0; i < parts.size(); ++i) built.add(work.memory);
    work.for_each(parts.size(), [&](std::int64_t i) {
        if (parts[i].range.size() <= bvh_width)
            built[i].leaf.push_back(leaf_of(parts[i].range));
        else
            build_part(work, item.data(), parts[i].range, parts[i].depth, built[i]);
    });
    std::int64_t nodes = boxes.node.size(), all_leaves = 0;
    for (std::int64_t i = 0; i < parts.size(); ++i) {
        parts[i].first_node = std::exchange(nodes, nodes + built[i].node.size());
        parts[i].first_leaf = std::exchange(all_leaves, all_leaves + built[i].leaf.size());
        boxes.node[parts[i].node].child[parts[i].child] =
            static_cast<std::uint32_t>(built[i].node.empty() ? parts[i].first_leaf : parts[i].first_node) |
            (built[i].node.empty() ? bvh_leaf : 0);
    }
    boxes.node.resize_for_overwrite(nodes);
    boxes.leaf.resize_for_overwrite(all_leaves);
    work.for_each(parts.size(), [&](std::int64_t i) {
        std::copy(built[i].leaf.begin(), built[i].leaf.end(), boxes.leaf.begin() + parts[i].first_leaf);
        for (std::int64_t n = 0; n < built[i].node.size(); ++n) {
            BvhNode& node = boxes.node[parts[i].first_node + n] = built[i].node[n];
            for (std::size_t k = 0; k < bvh_width; ++k)
                node.child[k] += static_cast<std::uint32_t>((node.child[k] & bvh_leaf) != 0 ? parts[i].first_leaf
                                                                                            : parts[i].first_node);
        }
    });
    return boxes;
}

} // namespace hrbfnpr::geometry
