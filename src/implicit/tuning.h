// SPDX-License-Identifier: MIT
// Tuning constants for evaluating trees of minima and maxima. They change a function by no more than rounding; all were
// set for speed.
#pragma once

#include <cstdint>

namespace hrbfnpr::implicit {

// Tuned with `scripts/bench edges --only=csg` and `--only=rows`.
struct CsgTuning {
    // Number of points that a run of steps works on at a time. Larger: less overhead for each step, but intermediate
    // results leave the fast caches.
    static constexpr std::int64_t block = 128;
    // The minimum of at least this many primitives is taken as a group, by a tree of boxes, and not two at a time.
    // Larger: more primitives that are far away are evaluated.
    std::int64_t primitives = 16;
    // A minimum with a model among its members is taken as a group from this many members on. Members of which two hold
    // a model are always a group.
    std::int64_t beside_model = 3;
    // Groups are nested at most this deep; deeper operands are combined two at a time. Larger: more stack.
    std::int32_t nested = 8;
    // A bound on how much rounding changes a place or a value, as a share of the largest number in its computation.
    // Larger: members are evaluated that are not needed; smaller: needed ones may be left out.
    double rounding = 1e-7;
};
inline constexpr CsgTuning csg_tuning;

// Tuned with `scripts/bench edges --only=pieces`.
struct PiecesTuning {
    // Number of points that are evaluated together; points of one sheet are placed side by side. Larger: fuller
    // vectors, more memory.
    static constexpr std::int64_t points = 256;
    // Zones are made for calls with at least this many points for each cell. A cell takes some 20 us, and a point takes
    // some 0.5 us less with zones. Larger: fewer calls make zones.
    double points_a_cell = 40.0;
    // Points are sorted by sheet if there are more sheets than this. Larger: a batch has fewer points of each sheet;
    // smaller: sorting takes longer than it saves.
    std::int64_t few_sheets = 8;
};
inline constexpr PiecesTuning pieces_tuning;

// Zones within cells, set on the same benchmark. Without zones, many points take 1.4 to 2.7 times as long.
struct ZoneTuning {
    // Zones are as small as cells of the level `level`, but a cell is cut into at most 2^cuts along each side. Larger:
    // more places are known to have one sheet, but zones take longer to make.
    int level = 6;
    int cuts = 2;
    // A cell that more cells than this reach gets no zones. Larger: more memory for crowded cells.
    std::int64_t parts = 64;
    // A maximum of two sheets leaves out the lower sheet if it is lower everywhere in the zone by more than this share
    // of the range of their difference over the zone's corners and middle. The same holds for a minimum. Smaller: the
    // sheet that equals f may be left out.
    double margin = 0.5;
    // Zones are widened by this share, for places that rounding puts beside them.
    double rounding = 1e-6;
};
inline constexpr ZoneTuning zone_tuning;

} // namespace hrbfnpr::implicit
