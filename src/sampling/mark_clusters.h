// The marks of a group in pieces that lie and face alike, in the order in which a tone shows them: what a frame
// passes over whole.
#pragma once

#include "base/memory.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::sampling {

// Marks [begin, end) of the arrays below, ranks falling.
struct Cluster {
    std::int32_t begin = 0, end = 0;
    std::uint32_t set = 0; // of directions; all marks of a cluster have the same
    float radius = 0.0F;   // around the centre
    std::array<float, 3> centre{};
    std::array<float, 3> axis{}; // of a cone that holds all normals
    float cone_cosine = 1.0F;    // of its half angle
    float cone_sine = 0.0F;
    float bend = 0.0F; // largest normal curvature by magnitude; < 0: not known
    // How the normal turns along the surface, dn/dp: xx, xy, xz, yy, yz, zz.  Outward normals: positive where convex.
    std::array<float, 6> shape{};
};

// Arrays of all marks, cluster by cluster; positions relative to the set's origin.
struct MarkClusters {
    explicit MarkClusters(base::Memory& memory) noexcept
        : x(memory), y(memory), z(memory), nx(memory), ny(memory), nz(memory), rank(memory), width(memory),
          mark(memory), cluster(memory) {}

    base::Array<float> x, y, z;
    base::Array<float> nx, ny, nz;
    base::Array<float> rank;
    base::Array<float> width;        // or empty: all 1
    base::Array<std::uint32_t> mark; // its number in the group
    base::Array<Cluster> cluster;

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

inline constexpr std::int64_t most_in_cluster = 128;

} // namespace hrbfnpr::sampling
