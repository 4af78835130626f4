// SPDX-License-Identifier: MIT
// Some points on their way through the cells and sheets of an implicit of pieces.
#pragma once

#include "implicit/pieces.h"

namespace hrbfnpr::implicit {

class PiecesBlock {
public:
    explicit PiecesBlock(const PiecesParts& parts) noexcept : parts_(parts), data_(parts.data) {}

    // What is known of a point: its zone, as PiecesZones::at says, and the part that has all the say there, or null.
    struct At {
        std::int32_t zone;
        const PiecesZones::Part* alone;
    };

    // Takes as many of the points as it has room for; how many, one at least.  at: of each; null: nothing
    // is known.
    std::int64_t take(const PointBatch& points, const At* at) noexcept;
    // Of those taken.
    void evaluate(const FieldBatch& fields);
    void active(std::int32_t* sheet);

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
    using Node = PiecesNode;
    // A cell that has a say at a point.
    struct Hit {
        Node cell;
        std::int32_t leaf;           // -1: what is far outside
        const std::int32_t* program; // what is left of it here ...
        std::int32_t codes;          // ... so much
        std::int32_t pair;           // that rules it, or plain
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
    void take_hits(const At& at, const glm::dvec3& place) noexcept;
    void add_hit(const Node& cell, std::int32_t leaf, const std::int32_t* program, std::int32_t codes) noexcept;
    void weigh(Hit& hit, const glm::dvec3& place) const noexcept;
    void weigh_outside(Hit& hit, const glm::dvec3& place) const noexcept;
    [[nodiscard]] glm::dvec3 place(std::int64_t point) const noexcept {
        return {points_.x[point], points_.y[point], points_.z[point]};
    }
    void add_pairs(std::int64_t point) noexcept;
    void add_pair(std::int32_t sheet, std::int64_t point) noexcept;
    void evaluate_sheets(bool gradient);
    void evaluate_hessians();
    void choose(std::int64_t point) noexcept;
    [[nodiscard]] std::int32_t run(const Hit& hit, std::int64_t point) const noexcept;
    void copy(std::int64_t point, const FieldBatch& fields) const noexcept;
    void combine(std::int64_t point, const FieldBatch& fields) const noexcept;
    void add_derivatives(std::int64_t point, double value, double total, const FieldBatch& fields) const noexcept;
    template <class Visit>
    void for_parts(std::int64_t point, Visit&& visit) const noexcept;

    const PiecesParts& parts_;
    const PiecesData& data_;
    PointBatch points_;
    std::int64_t hits_ = 0;
    std::int64_t pairs_ = 0;
    std::int64_t first_hit_[most_points + 1];
    std::int64_t first_pair_[most_points + 1];
    std::int32_t ruler_[most_points]; // the pair that alone rules each point, or plain
    Hit hit_[most_hits];
    Pair pair_[most_pairs];
    // The pairs of each sheet, one after the other.
    std::int64_t groups_ = 0;
    Group group_[most_pairs];
};

} // namespace hrbfnpr::implicit
