// SPDX-License-Identifier: MIT
// The walk through a bounding volume hierarchy, for every instruction set. It finds all triangles that a ray may meet,
// or that may be nearest to a place, and some others. The caller tests these exactly.
//
// The walk computes with floats. Its coordinates are scaled so that all triangles are in the cube from -1 to 1.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::geometry {

inline constexpr int bvh_width = 8; // the number of children of a node, and the largest number of triangles of a leaf

// Boxes are larger than their contents by this much on each side. It exceeds the sum of all rounding errors of a test
// of a ray and a box: the origin and the sides of the box are off by 2^-24, their difference by 2^-23, and the inverse
// and the product together by 2^-22.
inline constexpr float bvh_margin = 0x1p-19F;

// Eight boxes at once. Coordinates of a child that does not exist are `bvh_nowhere`, which no ray and no place reaches.
struct alignas(64) BvhNode {
    float side[6][bvh_width];       // the lowest x, y and z of each child, then the highest
    std::uint32_t child[bvh_width]; // the index of a node, or of a leaf with the bit `bvh_leaf`
};
inline constexpr std::uint32_t bvh_leaf = std::uint32_t{1} << 31U;
inline constexpr float bvh_nowhere = 1e15F;

// Triangles that are tested at once.
struct alignas(64) BvhLeaf {
    float corner[9][bvh_width]; // x, y and z of the first corner of each triangle, then of the second and third corner
    std::int32_t first;         // the triangles' numbers are first, first + 1, and so on
    std::int32_t count;
};

struct BvhView {
    const BvhNode* node;
    const BvhLeaf* leaf;
    std::uint32_t root; // a value as in BvhNode::child
};

// The largest component of the ray's direction is 1 or -1.
struct BvhRay {
    float origin[3];  // in the cube, up to rounding errors
    float inverse[3]; // 1 / direction
    int axis[3];      // The direction's component is largest along axis[2].
    float slope[2];   // the slopes of the ray along axis[0] and axis[1] over axis[2]
    float limit;      // the walk ends here
};

struct BvhPlace {
    float place[3];
    float error; // Each coordinate of the place, and of corners, is off by at most this.
    float limit; // a squared distance
};

// Called for each triangle found. Returns the new limit, which must not be higher than the last one. A value below 0
// ends the walk.
using BvhVisit = float (*)(void* user, std::int64_t number);

// The largest number of levels. See depth_of_halving in bvh_build.cpp.
inline constexpr int bvh_levels = 40;

struct BvhLoops {
    void (*along)(const BvhView& bvh, const BvhRay& ray, BvhVisit visit, void* user);
    void (*around)(const BvhView& bvh, const BvhPlace& place, BvhVisit visit, void* user);
};

[[nodiscard]] BvhLoops bvh_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::geometry
