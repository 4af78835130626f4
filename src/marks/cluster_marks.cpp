// SPDX-License-Identifier: MIT
#include "marks/cluster_marks.h"

#include "base/long_array.h"
#include "base/sort.h"
#include "geometry/cell_grid.h"
#include "geometry/morton.h"
#include "geometry/unit.h"
#include "marks/cluster_shape.h"
#include "marks/line_gaps.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr int cell_bits = 16; // of each coordinate of a mark's place along the curve

struct Keyed {
    std::uint64_t key; // set of directions, side of the cube that the normal points at, place along the curve
    std::uint32_t mark;
};

[[nodiscard]] glm::dvec3 precise(const base::Array<float>& a, std::int64_t i) noexcept { return vector_at(a, i); }

// A power of two in which the positions of all layers are of ordinary size.
[[nodiscard]] double unit_of(const PointSet& set) noexcept {
    float largest = 0.0F;
    for (const Layer& layer : set.layers)
        for (const float coordinate : layer.position) largest = std::max(largest, std::abs(coordinate));
    return geometry::unit_for(double{largest});
}

[[nodiscard]] std::uint64_t side_of(const glm::dvec3& n) noexcept {
    const glm::dvec3 a = glm::abs(n);
    const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
    return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0.0 ? 1 : 0));
}

class Clustering {
public:
    Clustering(const Layer& layer, double unit, MarkClusters& result, const base::Progress& progress)
        : layer_(layer), strokes_(layer.has_strokes()), unit_(unit), result_(result), progress_(progress),
          order_(layer.rank.memory(), layer.count()) {}

    void run() {
        if (layer_.count() == 0) return;
        sort();
        split(0, order_.size(), 3 * cell_bits, Turn{});
        fill();
    }

private:
    [[nodiscard]] glm::dvec3 place(std::int64_t mark) const noexcept { return precise(layer_.position, mark) / unit_; }

    // Of marks by their places in the order.
    [[nodiscard]] auto places() const noexcept {
        return [this](std::int64_t i) { return place(order_[i].mark); };
    }
    [[nodiscard]] auto normals() const noexcept {
        return [this](std::int64_t i) { return precise(layer_.normal, order_[i].mark); };
    }

    void sort() {
        geometry::Bounds bounds;
        for (std::int64_t i = 0; i < order_.size(); ++i) bounds.extend(place(i));
        const glm::dvec3 size = bounds.size();
        const double side = std::max({size.x, size.y, size.z});
        const double scale = side > 0.0 ? ((1 << cell_bits) - 1) / side : 0.0;
        for (std::int64_t i = 0; i < order_.size(); ++i) {
            if (i % 16384 == 0) progress_.check();
            const glm::dvec3 at = (place(i) - bounds.min) * scale;
            constexpr std::int64_t last = (1 << cell_bits) - 1;
            const std::uint64_t code = geometry::morton_code(
                {geometry::whole(at.x, last), geometry::whole(at.y, last), geometry::whole(at.z, last)});
            const std::uint64_t set = strokes_ ? layer_.direction_of(i) : 0U;
            order_[i] = {(set * 8 + side_of(precise(layer_.normal, i))) << (3 * cell_bits) | code,
                         static_cast<std::uint32_t>(i)};
        }
        base::sort_long(
            order_.begin(), order_.end(),
            [](const Keyed& a, const Keyed& b) { return a.key != b.key ? a.key < b.key : a.mark < b.mark; }, progress_);
    }

    // Parts that agree in the key down to `shift`, until they are small enough.
    void split(std::int64_t begin, std::int64_t end, int shift, const Turn& parent) {
        while (begin < end) {
            const std::uint64_t head = order_[begin].key >> shift;
            const Keyed* const next = std::partition_point(order_.data() + begin, order_.data() + end,
                                                           [&](const Keyed& k) { return k.key >> shift == head; });
            const std::int64_t stop = next - order_.data();
            const Turn turn = stop - begin >= fewest_to_fit && stop - begin <= 16 * most_in_cluster
                                  ? fit_turn(begin, stop, places(), normals())
                                  : parent;
            if (stop - begin <= most_in_cluster || shift == 0)
                close(begin, stop, turn);
            else
                split(begin, stop, shift - 3, turn);
            begin = stop;
        }
    }

    void close(std::int64_t begin, std::int64_t end, const Turn& turn) {
        progress_.check();
        std::sort(order_.data() + begin, order_.data() + end, [&](const Keyed& a, const Keyed& b) {
            const float u = layer_.rank[a.mark];
            const float v = layer_.rank[b.mark];
            return u != v ? u > v : a.mark < b.mark;
        });
        // More marks than that are at one place only if they are all alike.
        for (; begin < end; begin += most_in_cluster)
            result_.cluster.push_back(cluster_of(begin, std::min(end, begin + most_in_cluster), turn));
    }

    [[nodiscard]] Cluster cluster_of(std::int64_t begin, std::int64_t end, const Turn& turn) const {
        Cluster cluster;
        cluster.count = static_cast<std::int32_t>(end - begin);
        cluster.set = strokes_ ? layer_.direction_of(order_[begin].mark) : 0U;
        set_extent(cluster, begin, end, places(), normals());
        set_turn(cluster, turn);
        return cluster;
    }

    void fill() {
        constexpr std::int64_t size = MarkBlock::size;
        std::int64_t blocks = 0;
        for (Cluster& cluster : result_.cluster) {
            cluster.block = blocks;
            blocks += (cluster.count + size - 1) / size;
        }
        base::resize_long(result_.block, blocks, progress_);
        if (!layer_.width.empty()) base::resize_long(result_.width, blocks * size, progress_);
        const Keyed* from = order_.data();
        for (const Cluster& cluster : result_.cluster) {
            progress_.check();
            for (std::int64_t i = 0; i < cluster.count; ++i) put(cluster.block * size + i, (from++)->mark);
        }
    }

    void put(std::int64_t slot, std::int64_t mark) {
        MarkBlock& block = result_.block[slot / MarkBlock::size];
        const std::int64_t at = slot % MarkBlock::size;
        const glm::vec3 p(place(mark));
        block.x[at] = p.x;
        block.y[at] = p.y;
        block.z[at] = p.z;
        block.nx[at] = layer_.normal[3 * mark];
        block.ny[at] = layer_.normal[3 * mark + 1];
        block.nz[at] = layer_.normal[3 * mark + 2];
        block.rank[at] = layer_.rank[mark];
        block.mark[at] = static_cast<std::uint32_t>(mark);
        if (!layer_.width.empty()) result_.width[slot] = layer_.width[mark];
    }

    const Layer& layer_;
    bool strokes_;
    double unit_;
    MarkClusters& result_;
    const base::Progress& progress_;
    base::Array<Keyed> order_;
};

void cut_strokes(const Layer& layer, double unit, base::Array<StrokePiece>& pieces, const base::Progress& progress) {
    const float* const tone_normal = layer.tone_normal.empty() ? layer.normal.data() : layer.tone_normal.data();
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        if (s % 1024 == 0) progress.check();
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t first = layer.stroke_first[s]; first < end; first += StrokePiece::most) {
            StrokePiece piece;
            piece.first = static_cast<std::uint32_t>(first);
            piece.count = static_cast<std::uint8_t>(std::min(end - first, StrokePiece::most));
            piece.level = layer.level[layer.mark_of(first)];
            for (std::int64_t i = 1; i < piece.count; ++i)
                piece.level = std::min(piece.level, layer.level[layer.mark_of(first + i)]);
            set_extent(piece, layer, {layer.position.data(), layer.normal.data(), tone_normal}, unit);
            base::push_back_long(pieces, piece, progress);
        }
    }
}

} // namespace

std::int64_t MarkClusters::bytes() const noexcept {
    return block.bytes() + width.bytes() + cluster.bytes() + piece.bytes() + gap.bytes();
}

void cluster_marks(const base::Runtime& runtime, PointSet& set, const base::Progress& progress) {
    set.unit = unit_of(set);
    runtime.parallel.for_each(set.layers.size(), [&](std::int64_t number) {
        Layer& layer = set.layers[number];
        layer.clusters = MarkClusters(runtime.memory);
        Clustering(layer, set.unit, layer.clusters, progress).run();
        cut_strokes(layer, set.unit, layer.clusters.piece, progress);
    });
    for (Layer& layer : set.layers) measure_gaps(runtime, layer, layer.clusters.gap, progress);
}

} // namespace hrbfnpr::marks
