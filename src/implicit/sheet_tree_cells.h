// SPDX-License-Identifier: MIT
// The cells and zones of an implicit function made of sheets. SheetTreeData is plain data that a fit makes and a file
// stores: sheets, and an octree of cells. Each cell has a program that takes minima and maxima of a few sheets. A cell
// reaches a place if its weight is above 0 there; it also reaches places a little outside its sides. A sheet rules a
// cell at a place if the program's result there is this sheet. SheetTreeZones make evaluation at many points faster:
// cells are divided into zones, and each zone stores which cells reach it and which of their sheets can be the largest
// or smallest. Far from creases this is a single sheet, and f equals it.
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
    // The operations of a program. Each takes two operands off a stack, and pushes the larger or the smaller one.
    static constexpr std::int32_t maximum = -1;
    static constexpr std::int32_t minimum = -2;
    static constexpr std::int32_t most_operands = 8; // the largest number of operands of a program
    static constexpr std::int32_t most_levels = 16;
    static constexpr std::int32_t most_nodes = 1 << 26;
    // the distance from the centre of the bounds within which cells have weight, in half diagonals
    static constexpr double reach = 1.8;
    static constexpr double cell_reach = 1.4; // how far a cell's weight extends from its centre, in half sides
    // Two distances from the centre of the bounds, in half diagonals. Beyond the first, the sphere has a weight above
    // 0. Beyond the second, f is the distance from the sphere alone, because the surface of an open sheet is cut off
    // there. So no surface is searched for beyond the second distance.
    static constexpr double sphere_begins = 1.45;
    static constexpr double sphere_rules = reach;

    explicit SheetTreeData(base::Memory& memory) noexcept
        : sheet(memory), child(memory), program_begin(memory), program(memory), plain(memory), sample_position(memory),
          sample_normal(memory) {}

    base::List<HrbfData> sheet; // all sheets have the same sign convention: values inside are below 0
    geometry::Bounds bounds;
    double spacing = 0.0; // mean distance from a sample to the nearest other sample
    // The corner with the lowest coordinates of the cube that is divided into cells. The centre of the cube is the
    // centre of the bounds.
    glm::dvec3 corner{0.0};
    double side = 1.0;
    // For each node, the index of the first of its eight children, in the order of bits x, y, z; or `-1 - leaf` if the
    // node is a leaf.
    base::Array<std::int32_t> child;
    // For each leaf, the beginning of its program; one more element has the end of the last program.
    base::Array<std::int32_t> program_begin;
    // Indices of sheets, and the operations `maximum` and `minimum`. Operands come before their operation.
    base::Array<std::int32_t> program;
    // For leaves without a program: four numbers for each leaf, the value at its centre and the gradient.
    base::Array<double> plain;
    // Places on the whole surface, about `spacing` apart, packed x y z.
    base::Array<double> sample_position;
    base::Array<double> sample_normal; // unit vectors

    // Returns the vector from the centre of a parent cell to the centre of its child k. `quarter` is a quarter of the
    // parent's side.
    [[nodiscard]] static glm::dvec3 child_offset(std::int32_t k, double quarter) noexcept {
        return {(k & 1) != 0 ? quarter : -quarter, (k & 2) != 0 ? quarter : -quarter,
                (k & 4) != 0 ? quarter : -quarter};
    }
    [[nodiscard]] std::int64_t leaves() const noexcept { return program_begin.size() - 1; }
    [[nodiscard]] std::span<const std::int32_t> program_of(std::int32_t leaf) const noexcept {
        return {program.data() + program_begin[leaf], program.data() + program_begin[leaf + 1]};
    }
    // Returns the number of centres of all sheets together.
    [[nodiscard]] std::int64_t centres() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
    // Returns the leaf that contains a place, or the nearest leaf if the place is outside the cube.
    [[nodiscard]] std::int32_t leaf_at(const glm::dvec3& place) const noexcept;
};

// Returns whether the programs and the tree of cells are valid, so that they can be evaluated safely.
[[nodiscard]] bool is_sound(const SheetTreeData& data) noexcept;

// A cell with its centre and half its side.
struct SheetTreeNode {
    std::int32_t node;
    glm::dvec3 centre;
    double half;

    [[nodiscard]] SheetTreeNode child(std::int32_t first_child, std::int32_t k) const noexcept {
        return {first_child + k, centre + SheetTreeData::child_offset(k, 0.5 * half), 0.5 * half};
    }
    // Returns whether the weight of the cell is above 0 at the place.
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
    // The object keeps a reference to `data`.
    SheetTreeZones(const base::Work& work, const SheetTreeData& data);

    // A cell that reaches a zone, and its program there without the sheets that cannot affect the result. The program
    // is empty if the cell has none.
    struct Part {
        std::int32_t leaf;
        std::int32_t begin, end;
    };
    // The parts of a zone. It has a single part if all cells that reach it have the same program.
    struct Zone {
        std::int32_t begin, end;
    };
    // The sheets and cells that may determine f at a place.
    struct Candidates {
        std::int32_t sheet = -1;     // the sheet that f is known to equal; -1: unknown
        std::span<const Part> parts; // if `sheet` is -1: cells of which some reach the place; empty: nothing is known
    };
    [[nodiscard]] Candidates candidates_at(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::span<const std::int32_t> program_of(const Part& part) const noexcept {
        return {program_.data() + part.begin, program_.data() + part.end};
    }
    [[nodiscard]] const SheetTreeNode& node(std::int32_t leaf) const noexcept { return node_[leaf]; }
    // The cells of implicit::Implicit: one for each sheet that f is known to equal, one for each leaf, and one for all
    // other places.
    [[nodiscard]] std::int64_t cells() const noexcept { return data_.sheet.size() + data_.leaves() + 1; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return top_.bytes() + node_.bytes() + level_.bytes() + cuts_.bytes() + first_.bytes() + code_.bytes() +
               zone_.bytes() + part_.bytes() + program_.bytes();
    }

private:
    static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();
    static constexpr int digits = 20; // number of bits of a place's coordinates in the root cube
    static constexpr int top_levels = 4;
    using Digits = std::array<std::uint32_t, 3>;

    [[nodiscard]] static std::int32_t octant(const Digits& digit, int level) noexcept {
        const int shift = digits - 1 - level;
        return static_cast<std::int32_t>((digit[0] >> shift & 1U) | (digit[1] >> shift & 1U) << 1U |
                                         (digit[2] >> shift & 1U) << 2U);
    }
    // Returns the index of the zone that contains a place; or `-1 - sheet` if f equals this sheet in the whole zone; or
    // `nowhere`.
    [[nodiscard]] std::int32_t code_at(const glm::dvec3& place) const noexcept;

    const SheetTreeData& data_;
    // For each cube of the level top_levels: its node, or `-1 - leaf` of the leaf that contains it.
    base::Array<std::int32_t> top_;
    base::Array<SheetTreeNode> node_; // for each leaf, its cell
    base::Array<std::int8_t> level_;  // for each leaf, its level
    base::Array<std::int8_t> cuts_;   // each leaf has 2^cuts zones along each side; -1: it has no zones
    base::Array<std::int32_t> first_; // for each leaf, the index of its first zone
    base::Array<std::int32_t> code_;  // for each zone, the result of code_at()
    base::Array<Zone> zone_;          // the zones in which f is not known to equal a single sheet
    base::Array<Part> part_;
    base::Array<std::int32_t> program_;
};

} // namespace hrbfnpr::implicit
