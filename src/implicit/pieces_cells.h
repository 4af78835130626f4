// SPDX-License-Identifier: MIT
// Where which sheets of an implicit of pieces matter. PiecesData is plain data, what a file holds and what a fit makes:
// sheets, and an octree of cells, each with a program that takes minima and maxima of a few of them. A cell has a say
// beyond its sides, too. PiecesZones are for many points: cells are divided into zones that know which cells have a say
// there and which of their sheets can be the largest or smallest. Far from a crease that is one sheet, and f is that
// sheet.
#pragma once

#include "base/list.h"
#include "base/operation.h"
#include "base/work.h"
#include "implicit/hrbf.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace hrbfnpr::implicit {

struct PiecesData {
    // In a program: takes two operands off the stack, and puts the larger, or the smaller, onto it.
    static constexpr std::int32_t larger = -1;
    static constexpr std::int32_t smaller = -2;
    static constexpr std::int32_t most_operands = 8; // of one program
    static constexpr std::int32_t most_levels = 16;
    static constexpr std::int32_t most_nodes = 1 << 26;
    static constexpr double reach = 1.8;      // of all cells, in half diagonals
    static constexpr double cell_reach = 1.4; // of one cell's say from its centre, in half sides
    // Beyond these distances from the bounds' centre, in their half diagonals, a sphere begins to have a say, and has
    // all. No surface is looked for there, as that of an open sheet ends there.
    static constexpr double sphere_begins = 1.45;
    static constexpr double sphere_rules = reach;

    explicit PiecesData(base::Memory& memory) noexcept
        : sheet(memory), child(memory), program_begin(memory), program(memory), plain(memory), sample_position(memory),
          sample_normal(memory) {}

    base::List<HrbfData> sheet; // signed alike: below 0 is inside
    geometry::Bounds bounds;
    double spacing = 0.0; // mean distance of a sample to the nearest other one
    // The cube that is divided into cells. Its middle is that of the bounds.
    glm::dvec3 corner{0.0};
    double side = 1.0;
    base::Array<std::int32_t> child;         // of each node: the first of its eight (bits x, y, z), or -1 - leaf
    base::Array<std::int32_t> program_begin; // of each leaf, and the end
    base::Array<std::int32_t> program;       // sheets, larger, smaller: operands come before their operation
    base::Array<double> plain;           // 4 of each leaf: value in its centre and gradient, where it has no program
    base::Array<double> sample_position; // places all over the surface, packed, of the spacing
    base::Array<double> sample_normal;   // unit

    // The way to a child's centre from its parent's; quarter: of the parent's side.
    [[nodiscard]] static glm::dvec3 child_offset(std::int32_t k, double quarter) noexcept {
        return {(k & 1) != 0 ? quarter : -quarter, (k & 2) != 0 ? quarter : -quarter,
                (k & 4) != 0 ? quarter : -quarter};
    }
    [[nodiscard]] std::int64_t leaves() const noexcept { return program_begin.size() - 1; }
    [[nodiscard]] std::span<const std::int32_t> program_of(std::int32_t leaf) const noexcept {
        return {program.data() + program_begin[leaf], program.data() + program_begin[leaf + 1]};
    }
    // The centres of all sheets.
    [[nodiscard]] std::int64_t centres() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
    // The leaf that a place lies in, or that is nearest to a place outside the cube.
    [[nodiscard]] std::int32_t leaf_at(const glm::dvec3& place) const noexcept;
};

// Whether the programs and the tree of cells are whole, so that evaluating them is safe.
[[nodiscard]] bool is_sound(const PiecesData& data) noexcept;

// A cell and where it is.
struct PiecesNode {
    std::int32_t node;
    glm::dvec3 centre;
    double half;

    [[nodiscard]] PiecesNode child(std::int32_t first_child, std::int32_t k) const noexcept {
        return {first_child + k, centre + PiecesData::child_offset(k, 0.5 * half), 0.5 * half};
    }
    // Whether it has a say at the place.
    [[nodiscard]] bool reaches(const glm::dvec3& place) const noexcept {
        const glm::dvec3 off = glm::abs(place - centre);
        return std::max({off.x, off.y, off.z}) < PiecesData::cell_reach * half;
    }
};
[[nodiscard]] inline PiecesNode root_of(const PiecesData& data) noexcept {
    return {0, data.corner + 0.5 * data.side, 0.5 * data.side};
}

class PiecesZones {
public:
    // The data must outlive it.
    PiecesZones(const base::Work& work, const PiecesData& data);

    // A cell that has a say in a zone, and what is left of its program there; empty: the cell has none.
    struct Part {
        std::int32_t leaf;
        std::int32_t begin, end;
    };
    // The parts of a zone; one if all cells that have a say there have its program. Equal programs are the same one.
    struct Zone {
        std::int32_t begin, end;
    };
    // The rule of a place.
    struct At {
        std::int32_t sheet = -1;     // that alone rules it; -1: none is known to
        std::span<const Part> parts; // else: cells, some of which have a say; none: nothing is known
    };
    [[nodiscard]] At at(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::span<const std::int32_t> program_of(const Part& part) const noexcept {
        return {program_.data() + part.begin, program_.data() + part.end};
    }
    [[nodiscard]] const PiecesNode& node(std::int32_t leaf) const noexcept { return node_[leaf]; }
    // Cells of implicit::Implicit: one for each sheet that rules alone, one for each leaf, and one for all other
    // places.
    [[nodiscard]] std::int64_t cells() const noexcept { return data_.sheet.size() + data_.leaves() + 1; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return top_.bytes() + node_.bytes() + level_.bytes() + cuts_.bytes() + first_.bytes() + code_.bytes() +
               zone_.bytes() + part_.bytes() + program_.bytes();
    }

private:
    static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();
    static constexpr int digits = 20; // binary ones of a place's coordinates in the root cube
    static constexpr int top_levels = 4;
    using Digits = std::array<std::uint32_t, 3>;

    [[nodiscard]] static std::int32_t octant(const Digits& digit, int level) noexcept {
        const int shift = digits - 1 - level;
        return static_cast<std::int32_t>((digit[0] >> shift & 1U) | (digit[1] >> shift & 1U) << 1U |
                                         (digit[2] >> shift & 1U) << 2U);
    }
    // The zone that a place lies in, -1 - the sheet that alone rules that zone, or nowhere.
    [[nodiscard]] std::int32_t code_at(const glm::dvec3& place) const noexcept;

    const PiecesData& data_;
    base::Array<std::int32_t> top_;   // of each cube of that level: its node, or -1 - the leaf that it is part of
    base::Array<PiecesNode> node_;    // of each leaf
    base::Array<std::int8_t> level_;  // of each leaf
    base::Array<std::int8_t> cuts_;   // of each leaf: 2^that zones along each of its sides; -1: none
    base::Array<std::int32_t> first_; // of each leaf: its first zone
    base::Array<std::int32_t> code_;  // of each zone: as code_at() says
    base::Array<Zone> zone_;          // those that not one sheet rules
    base::Array<Part> part_;
    base::Array<std::int32_t> program_;
};

} // namespace hrbfnpr::implicit
