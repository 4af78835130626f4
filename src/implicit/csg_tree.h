// SPDX-License-Identifier: MIT
// A solid put together from others, as plain data: what a caller describes and a file holds.       docs/csg.md
#pragma once

#include "base/memory.h"
#include "geometry/vec.h"

#include <glm/mat3x3.hpp>

#include <cstdint>

namespace hrbfnpr::implicit {

// The numbers are those of HRBFNPR_CSG_... and of files.
enum class CsgKind : std::uint32_t {
    unite,
    intersect,
    subtract, // all others from the first child
    complement,
    offset, // f - distance
    shell,  // max(f, -f - distance)
    model,
    half_space, // z <= 0
    box,
    sphere,
    cylinder, // about the z axis, its middle at 0
    cone,     // the same, `second_radius` at the top
    torus     // about the z axis, its tube of `second_radius`
};
inline constexpr auto last_csg_kind = static_cast<std::uint32_t>(CsgKind::torus);

[[nodiscard]] constexpr bool is_leaf(CsgKind kind) noexcept { return kind >= CsgKind::model; }
// At most so many children; -1: any number from 1.
[[nodiscard]] constexpr std::int64_t children_of(CsgKind kind) noexcept {
    if (is_leaf(kind)) return 0;
    return kind <= CsgKind::subtract ? -1 : 1;
}

inline constexpr std::int64_t most_csg_nodes = 65536;

struct CsgNode {
    CsgKind kind = CsgKind::unite;
    std::int64_t parent = -1; // an earlier node; children are in the order of the nodes
    std::int64_t model = -1;  // which leaf
    // Where the node and all below it are: x = linear y + translation, affine.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
    glm::dvec3 size{1.0};
    double radius = 1.0;
    double second_radius = 0.5;
    double height = 1.0;
    double distance = 0.0;
    double blend = 0.0;    // radius; 0 = a crease
    double exponent = 0.0; // 0: the polynomial blend; else the super-elliptic one
};

// The first is the root.
using CsgTree = base::Array<CsgNode>;

} // namespace hrbfnpr::implicit
