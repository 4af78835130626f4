// SPDX-License-Identifier: MIT
// Tuning of how trees of minima and maxima are evaluated. No member changes a function by more than rounding; all were
// set for speed.
#pragma once

#include <cstdint>

namespace hrbfnpr::implicit {

// Set on `scripts/bench edges --only=csg` and `--only=rows`.
struct CsgTuning {
    // Points that a run of steps works on at a time. Larger: less overhead for each step, and intermediate results
    // leave the fast caches.
    static constexpr std::int64_t block = 128;
    // The least number of primitives whose minimum is taken as a group, by a tree of boxes, and not two at a time.
    // Larger: more of those that are far are evaluated.
    std::int64_t primitives = 16;
    // The same if one of the members holds a model; two that do are always a group.
    std::int64_t beside_model = 3;
    // Groups lie in groups this deep at most; what lies deeper is done two at a time. Larger: more stack.
    std::int32_t nested = 8;
    // The most that rounding changes a place or a value by, as a share of the largest number that they come from.
    // Larger: members are asked that are not needed; smaller: needed ones may be left out.
    double rounding = 1e-7;
};
inline constexpr CsgTuning csg_tuning;

// Set on `scripts/bench edges --only=pieces`.
struct PiecesTuning {
    // Points that are evaluated together; those of one sheet go side by side. Larger: fuller vectors, more memory.
    static constexpr std::int64_t points = 256;
    // The least number of points for each cell that zones are made for. A cell takes some 20 us, and a point takes
    // some 0.5 us less with zones. Larger: fewer calls make zones.
    double points_a_cell = 40.0;
    // Points are brought into the order of sheets if there are more sheets than this. Larger: a batch has fewer points
    // of each sheet; smaller: ordering takes longer than it saves.
    std::int64_t few_sheets = 8;
};
inline constexpr PiecesTuning pieces_tuning;

// Zones within cells, set on the same. Without any within cells, many points take 1.4 to 2.7 times as long.
struct ZoneTuning {
    // Zones are as small as the cells of this level, but a cell has 2^cuts along each side at most. Larger: more places
    // are known to have one sheet, and zones take longer to make.
    int level = 6;
    int cuts = 2;
    // Zones are not made where more cells than this have a say. Larger: more memory for cells that are crowded.
    std::int64_t parts = 64;
    // A sheet is left out of a maximum or minimum if it is less than the other by more than this share of what their
    // difference varies by between the corners and the middle of a zone. Smaller: a sheet may be missing that is f.
    double margin = 0.5;
    // Zones are wider than they are by this share, for places that rounding puts beside them.
    double rounding = 1e-6;
};
inline constexpr ZoneTuning zone_tuning;

} // namespace hrbfnpr::implicit
