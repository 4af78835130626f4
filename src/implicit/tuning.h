// SPDX-License-Identifier: MIT
// Tuning constants for evaluating trees of minima and maxima. They affect speed, and change results by no more than
// rounding.
#pragma once

#include <cstdint>

namespace hrbfnpr::implicit {

// Tuned with `scripts/bench edges --only=csg` and `--only=rows`.
struct CsgTuning {
    // The number of points that a step works on at a time. Larger: less overhead for each step, but intermediate
    // results no longer fit into the fast caches.
    static constexpr std::int64_t block = 128;
    // A minimum of at least this many primitives becomes a group with a tree of boxes; smaller ones are combined two at
    // a time. Larger: more distant primitives are evaluated.
    std::int64_t primitives = 16;
    // A minimum with one model among its members becomes a group if it has at least this many members. If two or more
    // members have a model, it is always a group.
    std::int64_t beside_model = 3;
    // The greatest depth of nested groups. Deeper operands are combined two at a time. Larger: more stack.
    std::int32_t nested = 8;
    // A bound on how much rounding changes a place or a value, as a share of the largest number in the computation.
    // Larger: more members are evaluated than necessary; smaller: necessary members may be skipped.
    double rounding = 1e-7;
};
inline constexpr CsgTuning csg_tuning;

// Tuned with `scripts/bench edges --only=pieces`.
struct PiecesTuning {
    // The number of points that are evaluated together; points of the same sheet become consecutive. Larger: fuller
    // SIMD vectors, more memory.
    static constexpr std::int64_t points = 256;
    // Zones are made for calls with at least this many points for each cell. The zones of a cell take about 20 us to
    // make, and save about 0.5 us for each point. Larger: fewer calls make zones.
    double points_a_cell = 40.0;
    // Points are sorted by sheet if there are more sheets than this. Larger: batches have fewer points of each sheet;
    // smaller: sorting takes longer than it saves.
    std::int64_t few_sheets = 8;
};
inline constexpr PiecesTuning pieces_tuning;

// Zones within cells, tuned with the same benchmark. Without zones, evaluation at many points takes 1.4 to 2.7 times as
// long.
struct ZoneTuning {
    // Zones are as large as cells of this level, but a cell is divided into at most 2^cuts zones along each side.
    // Larger: more places are known to have a single sheet, but zones take longer to make.
    int level = 6;
    int cuts = 2;
    // A cell gets no zones if more cells than this reach it. Larger: more memory where many cells overlap.
    std::int64_t parts = 64;
    // The lower of two sheets is removed from a maximum if it is lower at the corners and the middle of the zone by
    // more than this share of the range of their difference. The same holds for the higher sheet of a minimum. Smaller:
    // the sheet that equals f may be removed.
    double margin = 0.5;
    // Zones are enlarged by this share of their size, for places that rounding puts just outside.
    double rounding = 1e-6;
};
inline constexpr ZoneTuning zone_tuning;

} // namespace hrbfnpr::implicit
