// SPDX-License-Identifier: MIT
// The marks of a layer in pieces that lie and face alike, in the order in which a tone shows them: what a frame
// passes over whole.
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

// Lengths and curvatures are in the set's unit.
struct Cluster {
    std::int64_t block = 0; // its first; a cluster's last may be part empty
    std::int32_t count = 0; // of marks
    std::uint32_t set = 0;  // of directions; all marks of a cluster have the same
    float radius = 0.0F;    // around the centre
    std::array<float, 3> centre{};
    std::array<float, 3> axis{}; // of a cone that holds all normals
    float cone_cosine = 1.0F;    // of its half angle
    float cone_sine = 0.0F;
    float bend = 0.0F; // largest normal curvature by magnitude; < 0: not known
    // How the normal turns along the surface, dn/dp: xx, xy, xz, yy, yz, zz.  Outward normals: positive where convex.
    std::array<float, 6> shape{};
};

struct MarkClusters {
    explicit MarkClusters(base::Memory& memory) noexcept : block(memory), width(memory), cluster(memory) {}

    base::Array<MarkBlock> block;
    base::Array<float> width; // of each place in the blocks; or empty: all 1
    base::Array<Cluster> cluster;

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

inline constexpr std::int64_t most_in_cluster = 128;

} // namespace hrbfnpr::marks
