// SPDX-License-Identifier: MIT
// The tuning constants of point sets. `scripts/bench strokes` and `scripts/bench frame` measure their effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::marks {

struct MarksTuning {
    // ---- Clusters

    // A cluster with fewer marks than this is too small to compute how its normals turn. Larger: more clusters copy the
    // variation of normals of a neighbour.
    std::int64_t fewest_to_fit = 12;
    // Curvatures above this, per unit of the set, count as unknown. They occur for marks at the same place with
    // different normals.
    double most_curvature = 1e30;
    // A cluster with too few marks copies the variation of normals of a neighbour if the cosine between the axes of the
    // cones of their normals is above this.
    float neighbour_cosine = 0.7F;

    // ---- Gaps between lines; lengths are in separations

    // Lines are searched for up to this distance on either side, in separations. Larger: smoother gaps.
    double gap_reach = 2.5;
    // Half the width of the strip across a line in which marks of other lines are searched for, in separations. The
    // strip contains one or two marks of each line. Larger: near a bend, lines are found that are not beside the mark.
    double strip_half_width = 0.35;
    // A mark counts as on another sheet if its distance from the tangent plane of the measured mark is above about this
    // share of its offset across the line, or if the cosine between the normals of the two marks is at most
    // `gap_cosine`.
    double gap_steepest = 0.6;
    double gap_cosine = 0.5;
    // Marks belong to the same line if their offsets across the line differ by less than this, in separations. Larger:
    // close lines count as one.
    double same_line = 0.3;
    // The largest gap, in separations. Wider gaps are reduced to this. Larger: lines beside holes are drawn wider.
    double widest_gap = 2.0;
    // The gap of a line is measured once for this many marks. The second number is how many measurements on either side
    // are averaged, over about three separations. Larger: less time, slower changes.
    std::int64_t marks_per_measurement = 4;
    std::int64_t averaged_measurements = 2;
    // Gaps are not measured in a layer with more marks than this around each mark, because a file may have any
    // separation.
    std::int64_t most_neighbours = 4000;

    // ---- Normals for tone

    // Normals are averaged over marks within this many lengths of tone smoothing. The second number is about how many
    // marks are used.
    double tone_reach = 2.0;
    double tone_marks = 64.0;
    // A second mark counts as on another sheet if its distance from the tangent plane of the first mark is above this
    // share of the distance between the two marks.
    double tone_steepest = 0.7;

    // ---- The spacing of marks on an unknown surface

    // With at least this many marks, the area is estimated from the cells of a grid that contain marks. The second
    // number is the average number of marks in such a cell. Larger second number: cells of which the surface cuts only
    // a corner cause a smaller error, but fine forms cause a larger one.
    std::int64_t fewest_for_cells = 512;
    double marks_a_cell = 8.0;
};
inline constexpr MarksTuning marks_tuning;

} // namespace hrbfnpr::marks
