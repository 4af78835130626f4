// SPDX-License-Identifier: MIT
// What an implicit of pieces is made of: sheets, and the cells that say which of them rule where.
#pragma once

#include "base/list.h"
#include "implicit/hrbf.h"

namespace hrbfnpr::implicit {

// Plain data: what a file holds and what a fit makes.
struct PiecesData {
    // In a program: the two above are taken off the stack, and the larger, or the smaller, is laid onto it.
    static constexpr std::int32_t larger = -1;
    static constexpr std::int32_t smaller = -2;
    static constexpr std::int32_t most_operands = 8; // of one program
    static constexpr std::int32_t most_levels = 16;
    static constexpr std::int32_t most_nodes = 1 << 26;
    static constexpr double reach = 1.8;      // half diagonals
    static constexpr double cell_reach = 1.4; // half sides from its centre, that a cell has a say up to
    // Beyond these distances from the bounds' centre, in their half diagonals, a sphere begins to have a say, and has
    // all.  Beyond what is searched for surface, as that of an open sheet ends there.
    static constexpr double sphere_begins = 1.45;
    static constexpr double sphere_rules = reach;

    explicit PiecesData(base::Memory& memory) noexcept
        : sheet(memory), child(memory), program_begin(memory), program(memory), plain(memory), sample_position(memory),
          sample_normal(memory) {}

    base::List<HrbfData> sheet; // signed alike: below 0 is inside
    geometry::Bounds bounds;
    double spacing = 0.0; // mean distance of a sample to the nearest other one
    // The cube that is divided into cells reaches so far from the middle of the bounds, or farther.
    glm::dvec3 corner{0.0};
    double side = 1.0;
    base::Array<std::int32_t> child;         // of each node: the first of its eight (bits x, y, z), or -1 - leaf
    base::Array<std::int32_t> program_begin; // of each leaf, and the end
    base::Array<std::int32_t> program;       // sheets, larger, smaller: in Polish order from behind
    base::Array<double> plain;           // 4 of each leaf: value in its centre and gradient, where it has no program
    base::Array<double> sample_position; // places all over the surface, packed, of the spacing
    base::Array<double> sample_normal;   // unit

    // Of a child's centre from its parent's; quarter: of the parent's side.
    [[nodiscard]] static glm::dvec3 child_offset(std::int32_t k, double quarter) noexcept {
        return {(k & 1) != 0 ? quarter : -quarter, (k & 2) != 0 ? quarter : -quarter,
                (k & 4) != 0 ? quarter : -quarter};
    }
    [[nodiscard]] std::int64_t leaves() const noexcept { return program_begin.size() - 1; }
    // Of all sheets.
    [[nodiscard]] std::int64_t centres() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
    // The leaf that a place lies in; of one outside the cube, the nearest.
    [[nodiscard]] std::int32_t leaf_at(const glm::dvec3& place) const noexcept;
};

// Whether the programs and nodes are some, so that evaluating them is safe.
[[nodiscard]] bool is_sound(const PiecesData& data) noexcept;

} // namespace hrbfnpr::implicit
