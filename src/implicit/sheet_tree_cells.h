// SPDX-License-Identifier: MIT
// The cells and zones of an implicit of sheets. SheetTreeData is plain data, which a fit makes and a file holds:
// sheets, and an octree of cells, each with a program that takes minima and maxima of a few sheets. A cell reaches a
// place if its weight there is above 0, which it is beyond its sides, too. A sheet rules a cell at a place if the
// cell's program ends with it. SheetTreeZones are for many points: cells are divided into zones that know which cells
// reach them, and which sheets of these can be the largest or smallest. Far from a crease that is one sheet, and f is
// that sheet.
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

struct SheetTreeData {
    // Operations of a program: take two operands off the stack, and put the larger, or the smaller, onto it.
    static constexpr std::int32_t maximum = -1;
    static constexpr std::int32_t minimum = -2;
    static constexpr std::int32_t most_operands = 8; // the most operands of one program
    static constexpr std::int32_t most_levels = 16;
    static constexpr std::int32_t most_nodes = 1 << 26;
    static constexpr double reach = 1.8;      // reach of all cells, in half diagonals
    static constexpr double cell_reach = 1.4; // reach of one cell from its centre, in half sides
    // The distances from the bounds' centre, in their half diagonals, beyond which the weight of a sphere is above 0,
    // and beyond which f is the sphere alone. No surface is looked for there, because the surface of an open sheet ends
    // there.
    static constexpr double sphere_begins = 1.45;
    static constexpr double sphere_rules = reach;

    explicit SheetTreeData(base::Memory& memory) noexcept
        : sheet(memory), child(memory), program_begin(memory), program(memory), plain(memory), sample_position(memory),
          sample_normal(memory) {}

    base::List<HrbfData> sheet; // all signed alike: inside is below 0
    geometry::Bounds bounds;
    double spacing = 0.0; // mean distance of a sample to the nearest other one
    // The cube that is divided into cells. Its middle is the middle of the bounds.
    glm::dvec3 corner{0.0};
    double side = 1.0;
    base::Array<std::int32_t> child; // for each node: the first of its eight children (bits x, y, z), or `-1 - leaf`
    base::Array<std::int32_t> program_begin; // for each leaf: start of its program; then the end of the last
    base::Array<std::int32_t> program;       // sheets, `maximum` or `minimum`; operands come before their operation
    base::Array<double> plain;               // 4 for each leaf: value at its centre and gradient, if it has no program
    base::Array<double> sample_position;     // places all over the surface, packed, about `spacing` apart
    base::Array<double> sample_normal;       // unit

    // Returns the offset of a child's centre from its parent's; quarter: a quarter of the parent's side.
    [[nodiscard]] static glm::dvec3 child_offset(std::int32_t k, double quarter) noexcept {
        return {(k & 1) != 0 ? quarter : -quarter, (k & 2) != 0 ? quarter : -quarter,
                (k & 4) != 0 ? quarter : -quarter};
    }
    [[nodiscard]] std::int64_t leaves() const noexcept { return program_begin.size() - 1; }
    [[nodiscard]] std::span<const std::int32_t> program_of(std::int32_t leaf) const noexcept {
        return {program.data() + program_begin[leaf], program.data() + program_begin[leaf + 1]};
    }
    // Returns the number of centres of all sheets.
    [[nodiscard]] std::int64_t centres() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
    // Returns the leaf that a place lies in, or the nearest leaf if the place is outside the cube.
    [[nodiscard]] std::int32_t leaf_at(const glm::dvec3& place) const noexcept;
};

// Whether the programs and the tree of cells are valid, so that evaluating them is safe.
[[nodiscard]] bool is_sound(const SheetTreeData& data) noexcept;

// A cell with its centre and half its side.
struct SheetTreeNode {
    std::int32_t node;
    glm::dvec3 centre;
    double half;

    [[nodiscard]] SheetTreeNode child(std::int32_t first_child, std::int32_t k) const noexcept {
        return {first_child + k, centre + SheetTreeData::child_offset(k, 0.5 * half), 0.5 * half};
    }
    // Whether its weight is above 0 at the place.
    [[nodiscard]] bool reaches(const glm::dvec3& place) const noexcept {
        const glm::dvec3 off = glm::abs(place - centre);
        return std::max({off.x, off.y, off.z}) < SheetTreeData::cell_reach * half;
    }
};
[[nodiscard]] inline SheetTreeNode root_of(const SheetTreeData& data) noexcept {
    return {0, data.corner + 0.5 * data.side, 0.5 * data.side};
}

class SheetTreeZones {
public:
    // `data` must outlive this.
    SheetTreeZones(const base::Work& work, const SheetTreeData& data);

    // A cell that reaches a zone, and its program there, without the sheets that cannot matter; empty: it has no
    // program.
    struct Part {
        std::int32_t leaf;
        std::int32_t begin, end;
    };
    // The parts of a zone; only one if all cells that reach it have the same program. Equal programs are stored once.
    struct Zone {
        std::int32_t begin, end;
    };
    // The sheets that may matter at a place.
    struct Candidates {
        std::int32_t sheet = -1;     // the sheet that alone rules it; -1: none is known
        std::span<const Part> parts; // otherwise: cells, some of which reach the place; empty: nothing is known
    };
    [[nodiscard]] Candidates candidates_at(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::span<const std::int32_t> program_of(const Part& part) const noexcept {
        return {program_.data() + part.begin, program_.data() + part.end};
    }
    [[nodiscard]] const SheetTreeNode& node(std::int32_t leaf) const noexcept { return node_[leaf]; }
    // Cells in the sense of implicit::Implicit: one for each sheet that rules alone, one for each leaf, and one for all
    // other places.
    [[nodiscard]] std::int64_t cells() const noexcept { return data_.sheet.size() + data_.leaves() + 1; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return top_.bytes() + node_.bytes() + level_.bytes() + cuts_.bytes() + first_.bytes() + code_.bytes() +
               zone_.bytes() + part_.bytes() + program_.bytes();
    }

private:
    static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();
    static constexpr int digits = 20; // binary digits of a place's coordinates in the root cube
    static constexpr int top_levels = 4;
    using Digits = std::array<std::uint32_t, 3>;

    [[nodiscard]] static std::int32_t octant(const Digits& digit, int level) noexcept {
        const int shift = digits - 1 - level;
        return static_cast<std::int32_t>((digit[0] >> shift & 1U) | (digit[1] >> shift & 1U) << 1U |
                                         (digit[2] >> shift & 1U) << 2U);
    }
    // Returns the zone that a place lies in, or `-1 - sheet` if f equals this sheet all over the zone, or nowhere.
    [[nodiscard]] std::int32_t code_at(const glm::dvec3& place) const noexcept;

    const SheetTreeData& data_;
    base::Array<std::int32_t> top_;   // for each cube of level top_levels: its node, or `-1 - leaf` of its leaf
    base::Array<SheetTreeNode> node_; // for each leaf: the cell
    base::Array<std::int8_t> level_;  // for each leaf: its level
    base::Array<std::int8_t> cuts_;   // for each leaf: it has 2^cuts zones along each side; -1: it has none
    base::Array<std::int32_t> first_; // for each leaf: its first zone
    base::Array<std::int32_t> code_;  // for each zone: the result of code_at()
    base::Array<Zone> zone_;          // the zones in which f is not known to equal a single sheet
    base::Array<Part> part_;
    base::Array<std::int32_t> program_;
};

} // namespace hrbfnpr::implicit
