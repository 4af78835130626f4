// SPDX-License-Identifier: MIT
#include "marks/turn_clusters.h"

#include "marks/copy_array.h"

namespace hrbfnpr::marks {
namespace {

template <class Numbers>
void negate(Numbers& numbers) noexcept {
    for (float& number : numbers) number = -number;
}

} // namespace

void turn_clusters(const MarkClusters& clusters, MarkClusters& turned) {
    copy_array(clusters.block, turned.block);
    copy_array(clusters.width, turned.width);
    copy_array(clusters.cluster, turned.cluster);
    copy_array(clusters.piece, turned.piece);
    for (MarkBlock& block : turned.block) {
        negate(block.nx);
        negate(block.ny);
        negate(block.nz);
    }
    for (Cluster& cluster : turned.cluster) {
        negate(cluster.axis);
        negate(cluster.shape);
    }
    for (StrokePiece& piece : turned.piece) {
        negate(piece.axis);
        negate(piece.tone_axis);
    }
}

} // namespace hrbfnpr::marks
