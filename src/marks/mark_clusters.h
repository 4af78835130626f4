// SPDX-License-Identifier: MIT
// The marks of a layer in groups that lie and face alike, in the order in which a tone shows them. A frame passes over
// whole groups.
#pragma once

#include "base/memory.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::marks {

// Sixteen marks, each number of all of them in a line of the cache.
struct MarkBlock {
    static constexpr std::int64_t size = 16;
    float x[size], y[size], z[size]; // relative to the set's origin, in the set's unit
    float nx[size], ny[size], nz[size];
    float rank[size];         // falling, from block to block of a cluster
    std::uint32_t mark[size]; // its number in the layer
};

// Where some marks lie and how they face. Lengths and curvatures are in the set's unit.
struct Extent {
    float radius = 0.0F; // around the centre
    std::array<float, 3> centre{};
    std::array<float, 3> axis{}; // the axis of a cone that holds all normals
    float cone_cosine = 1.0F;    // the cosine of the cone's half angle
    float cone_sine = 0.0F;      // the sine of the same angle
};

struct Cluster : Extent {
    std::int64_t block = 0; // its first block; its last block may be partly empty
    std::int32_t count = 0; // the number of marks
    std::uint32_t set = 0;  // the direction, 0 or 1, of all its marks' strokes; 0 without strokes
    float bend = 0.0F;      // largest normal curvature by magnitude; < 0: not known
    // How the normal turns along the surface, dn/dp: xx, xy, xz, yy, yz, zz. Outward normals: positive where convex.
    std::array<float, 6> shape{};
};

// Marks that follow each other along a stroke. The pieces of all strokes follow each other, too, and a stroke of n
// marks has pieces_of(n).
struct StrokePiece : Extent {
    static constexpr std::int64_t most = 32;
    // A cone that holds all normals for tone, which may lie outside of the normals' own.
    std::array<float, 3> tone_axis{};
    float tone_cosine = 1.0F;
    float tone_sine = 0.0F;
    std::uint32_t first = 0; // place in the order of the strokes
    std::uint8_t count = 0;
    std::uint8_t level = 0; // the lowest level of its marks
};

[[nodiscard]] constexpr std::int64_t pieces_of(std::int64_t marks) noexcept {
    return (marks + StrokePiece::most - 1) / StrokePiece::most;
}

struct MarkClusters {
    explicit MarkClusters(base::Memory& memory) noexcept
        : block(memory), width(memory), cluster(memory), piece(memory), gap(memory) {}

    base::Array<MarkBlock> block;
    base::Array<float> width; // the width of the mark at each place in the blocks; empty: all are 1
    base::Array<Cluster> cluster;
    base::Array<StrokePiece> piece; // the pieces of all strokes
    base::Array<float> gap;         // the gap of each mark, in separations, by measure_gaps(); or empty

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

inline constexpr std::int64_t most_in_cluster = 128;

} // namespace hrbfnpr::marks
