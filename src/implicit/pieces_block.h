// SPDX-License-Identifier: MIT
// Some points on their way through the cells and sheets of an implicit of pieces.
#pragma once

#include "implicit/pieces.h"

namespace hrbfnpr::implicit {

class PiecesBlock {
public:
    PiecesBlock(base::InstructionSet set, const PiecesData& data) noexcept : set_(set), data_(data) {}

    // Takes as many of the points as it has room for; how many, one at least.
    std::int64_t take(const PointBatch& points) noexcept;
    // Of those taken.
    void evaluate(const FieldBatch& fields) noexcept;
    void active(std::int32_t* sheet) noexcept;

private:
    static constexpr std::int64_t most_points = 64;
    static constexpr std::int64_t most_hits = 288;    // of all points
    static constexpr std::int64_t most_at_point = 96; // cells, and sheets, of one point
    static constexpr std::int64_t most_pairs = 256;
    static constexpr std::int32_t plain = -1;

    // A weight with its derivatives; the Hessian as in FieldBatch.
    struct Weight {
        double w;
        glm::dvec3 d;
        double h[6];
    };
    struct Node {
        std::int32_t node;
        glm::dvec3 centre;
        double half;
    };
    // A cell that has a say at a point.
    struct Hit {
        Node cell;
        std::int32_t leaf; // -1: what is far outside
        std::int32_t pair; // that rules it, or plain
        // Where not one sheet rules all cells of the point:
        Weight weight;
        double value; // of what is plain
        glm::dvec3 gradient;
    };
    // A sheet at a point.
    struct Pair {
        std::int32_t sheet;
        std::int32_t point;
        double value;
        glm::dvec3 gradient;
        double hessian[6];
        Weight weight;     // of all cells that it rules
        std::int32_t next; // pair of the sheet, or -1
    };
    struct Group {
        std::int32_t sheet, first, last;
    };
    [[nodiscard]] static Weight weight_of(const Node& cell, const glm::dvec3& place) noexcept;
    void find_hits(const glm::dvec3& place) noexcept;
    void weigh(Hit& hit, const glm::dvec3& place) const noexcept;
    void weigh_outside(Hit& hit, const glm::dvec3& place) const noexcept;
    [[nodiscard]] glm::dvec3 place(std::int64_t point) const noexcept {
        return {points_.x[point], points_.y[point], points_.z[point]};
    }
    void add_pairs(std::int64_t point) noexcept;
    void add_pair(std::int32_t sheet, std::int64_t point) noexcept;
    void evaluate_sheets(bool gradient) noexcept;
    void evaluate_hessians() noexcept;
    void choose(std::int64_t point) noexcept;
    [[nodiscard]] std::int32_t run(std::int32_t leaf, std::int64_t point) const noexcept;
    void combine(std::int64_t point, const FieldBatch& fields) const noexcept;
    void add_derivatives(std::int64_t point, double value, double total, const FieldBatch& fields) const noexcept;
    template <class Visit>
    void for_parts(std::int64_t point, Visit&& visit) const noexcept;

    base::InstructionSet set_;
    const PiecesData& data_;
    PointBatch points_;
    std::int64_t hits_ = 0;
    std::int64_t pairs_ = 0;
    std::int64_t first_hit_[most_points + 1];
    std::int64_t first_pair_[most_points + 1];
    Hit hit_[most_hits];
    Pair pair_[most_pairs];
    // The pairs of each sheet, one after the other.
    std::int64_t groups_ = 0;
    Group group_[most_pairs];
};

} // namespace hrbfnpr::implicit
