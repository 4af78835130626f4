// SPDX-License-Identifier: MIT
// An implicit with creases: smooth sheets, each a Hermite fit of its own, and cells that say which of them rule where.
// In each cell f is a maximum or minimum of a few sheets, or, where no surface is near, a linear function that is as
// far from 0 as the surface is away; between cells it changes smoothly (a partition of unity as in Ohtake et al.,
// "Multi-level partition of unity implicits", 2003, whose pieces are global functions here: cells that are ruled by
// the same sheet change nothing).
#pragma once

#include "base/list.h"
#include "implicit/hrbf.h"
#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

// Plain data: what a file holds and what a fit makes.
struct PiecesData {
    // In a program: the two above are taken off the stack, and the larger, or the smaller, is laid onto it.
    static constexpr std::int32_t larger = -1;
    static constexpr std::int32_t smaller = -2;
    static constexpr std::int32_t most_operands = 8; // of one program
    static constexpr std::int32_t most_levels = 16;
    static constexpr std::int32_t most_nodes = 1 << 26;
    static constexpr double reach = 1.8; // half diagonals

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

    [[nodiscard]] std::int64_t leaves() const noexcept { return program_begin.size() - 1; }
    // Of all sheets.
    [[nodiscard]] std::int64_t centres() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
    // The leaf that a place lies in; of one outside the cube, the nearest.
    [[nodiscard]] std::int32_t leaf_at(const glm::dvec3& place) const noexcept;
};

// Whether the programs and nodes are some, so that evaluating them is safe.
[[nodiscard]] bool is_sound(const PiecesData& data) noexcept;

class Pieces final : public Implicit, public Sheets {
public:
    Pieces(base::InstructionSet set, PiecesData data) noexcept : set_(set), data_(std::move(data)) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] std::int64_t cells() const noexcept override { return data_.leaves(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept override { return data_.leaf_at(place); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return this; }

    // The last one is f itself, which is smooth where no surface is near.
    [[nodiscard]] std::int32_t count() const noexcept override {
        return static_cast<std::int32_t>(data_.sheet.size()) + 1;
    }
    void active(const PointBatch& points, std::int32_t* sheet) const override;
    void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;

    [[nodiscard]] const PiecesData& data() const noexcept { return data_; }
    [[nodiscard]] PiecesData take() && noexcept { return std::move(data_); }
    [[nodiscard]] base::InstructionSet instruction_set() const noexcept { return set_; }

private:
    base::InstructionSet set_;
    PiecesData data_;
};

} // namespace hrbfnpr::implicit
