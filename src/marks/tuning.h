// SPDX-License-Identifier: MIT
// The tuning constants of point sets. scripts/bench strokes and frame measure their effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::marks {

struct MarksTuning {
    // ---- Clusters

    // Fewer marks do not tell how their normals turn. Larger: more clusters bend as those beside them do.
    std::int64_t fewest_to_fit = 12;
    // Curvatures beyond it, as of marks at one place with different normals, are not known; per unit of the set.
    double most_bend = 1e30;
    // A cluster whose marks are too few takes its bend from one beside it whose axis has a larger cosine with its own.
    float alike_cosine = 0.7F;

    // ---- Gaps between lines; lengths are in separations

    // Lines are looked for up to this far to either side. Larger: smoother gaps.
    double gap_reach = 2.5;
    // Half the width of the strip across a line in which marks of other lines are looked for. It holds a mark or two of
    // each line. Larger: lines beside a bend are counted where they are not.
    double strip = 0.35;
    // Places that leave the tangent plane by more than this part of their distance are on another sheet, and so are
    // marks whose normals have no larger cosine.
    double gap_steepest = 0.6;
    double gap_cosine = 0.5;
    // Marks whose offsets across differ by less are of one line. Larger: close lines count as one.
    double same_line = 0.3;
    // No gap counts as wider. Larger: lines at holes are drawn wider.
    double widest_gap = 2.0;
    // Gaps are measured at each of these marks of a line and averaged over this many measures to either side: over some
    // three separations. Larger: less time, slower changes.
    std::int64_t measured_each = 4;
    std::int64_t most_averaged = 2;
    // Layers with more marks than this around each mark have no gaps: a file may say any separation.
    std::int64_t most_visits = 4000;

    // ---- Normals for tone

    // Normals within this many lengths of tone smoothing are averaged, over about this many marks there.
    double tone_reach = 2.0;
    double tone_marks = 64.0;
    // What leaves the tangent plane more steeply is another sheet.
    double tone_steepest = 0.7;

    // ---- The spacing of marks on an unknown surface

    // Fewer marks say little of an area by the cells that they occupy, of which each holds this many on average.
    // Larger: corners that the surface hardly cuts count less, and fine forms less.
    std::int64_t fewest_for_cells = 512;
    double marks_a_cell = 8.0;
};
inline constexpr MarksTuning marks_tuning;

} // namespace hrbfnpr::marks
