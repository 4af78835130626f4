// SPDX-License-Identifier: MIT
#include "marks/move_clusters.h"

#include "marks/cluster_shape.h"
#include "marks/copy_array.h"

namespace hrbfnpr::marks {
namespace {

// Marks of clusters that follow each other, by their place in the blocks.
class Moved {
public:
    explicit Moved(MarkClusters& clusters) noexcept : clusters_(clusters) {}

    void describe(std::int64_t c) noexcept {
        Cluster& cluster = clusters_.cluster[c];
        const std::int64_t begin = cluster.block * MarkBlock::size;
        const std::int64_t end = begin + cluster.count;
        set_extent(cluster, begin, end, place_, normal_);
        if (cluster.count >= fewest_to_fit) {
            set_turn(cluster, fit_turn(begin, end, place_, normal_));
            return;
        }
        // Too few to tell how the surface bends there: it does as around the nearest cluster that tells.
        const Cluster* nearest = nullptr;
        for (const std::int64_t other : {c - 1, c + 1}) {
            if (other < 0 || other >= clusters_.cluster.size()) continue;
            const Cluster& o = clusters_.cluster[other];
            if (o.count >= fewest_to_fit && facing(o, cluster) > 0.7F &&
                (nearest == nullptr || distance(o, cluster) < distance(*nearest, cluster)))
                nearest = &o;
        }
        cluster.bend = nearest != nullptr ? nearest->bend : -1.0F;
        cluster.shape = nearest != nullptr ? nearest->shape : std::array<float, 6>{};
    }

private:
    [[nodiscard]] static float facing(const Cluster& a, const Cluster& b) noexcept {
        return a.axis[0] * b.axis[0] + a.axis[1] * b.axis[1] + a.axis[2] * b.axis[2];
    }
    [[nodiscard]] static float distance(const Cluster& a, const Cluster& b) noexcept {
        float square = 0.0F;
        for (std::size_t k = 0; k < 3; ++k) square += (a.centre[k] - b.centre[k]) * (a.centre[k] - b.centre[k]);
        return square;
    }

    MarkClusters& clusters_;
    struct Place {
        const MarkClusters& clusters;
        glm::dvec3 operator()(std::int64_t slot) const noexcept {
            const MarkBlock& b = clusters.block[slot / MarkBlock::size];
            const std::int64_t at = slot % MarkBlock::size;
            return {b.x[at], b.y[at], b.z[at]};
        }
    } place_{clusters_};
    struct Normal {
        const MarkClusters& clusters;
        glm::dvec3 operator()(std::int64_t slot) const noexcept {
            const MarkBlock& b = clusters.block[slot / MarkBlock::size];
            const std::int64_t at = slot % MarkBlock::size;
            return {b.nx[at], b.ny[at], b.nz[at]};
        }
    } normal_{clusters_};
};

} // namespace

void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved) {
    copy_array(layer.clusters.block, moved.block);
    copy_array(layer.clusters.width, moved.width);
    copy_array(layer.clusters.cluster, moved.cluster);
    copy_array(layer.clusters.piece, moved.piece);
    for (const Cluster& cluster : moved.cluster) {
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            MarkBlock& block = moved.block[cluster.block + i / MarkBlock::size];
            const std::int64_t at = i % MarkBlock::size;
            const std::int64_t mark = 3 * std::int64_t{block.mark[at]};
            block.x[at] = static_cast<float>(double{position[mark]} / unit);
            block.y[at] = static_cast<float>(double{position[mark + 1]} / unit);
            block.z[at] = static_cast<float>(double{position[mark + 2]} / unit);
            block.nx[at] = normal[mark];
            block.ny[at] = normal[mark + 1];
            block.nz[at] = normal[mark + 2];
        }
    }
    // Normals for tone turn with their marks' directions, too, which are not known here.
    const float* const tone_normal = layer.tone_normal.empty() ? normal : nullptr;
    for (StrokePiece& piece : moved.piece) set_extent(piece, layer, {position, normal, tone_normal}, unit);
    // Those that tell how the surface bends first: the others ask them.
    Moved clusters(moved);
    for (const bool few : {false, true})
        for (std::int64_t c = 0; c < moved.cluster.size(); ++c)
            if ((moved.cluster[c].count < fewest_to_fit) == few) clusters.describe(c);
}

} // namespace hrbfnpr::marks
