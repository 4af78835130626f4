// SPDX-License-Identifier: MIT
// The tuning constants of point sets. scripts/bench strokes and frame measure their effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::marks {

struct MarksTuning {
    // ---- Clusters

    // Clusters of fewer marks do not show how their normals turn. Larger: more clusters take the bend of a neighbour.
    std::int64_t fewest_to_fit = 12;
    // Curvatures above this count as unknown, such as those of marks at one place with different normals; per unit of
    // the set.
    double most_curvature = 1e30;
    // A cluster with too few marks takes the bend of a neighbour if the cosine between their axes is larger than this.
    float neighbour_cosine = 0.7F;

    // ---- Gaps between lines; lengths are in separations

    // Lines are searched for up to this distance on either side. Larger: smoother gaps.
    double gap_reach = 2.5;
    // Half the width of the strip across a line in which marks of other lines are looked for. The strip holds a mark or
    // two of each line. Larger: lines beside a bend are counted where they are not.
    double strip_half_width = 0.35;
    // A mark lies on another sheet if it leaves the tangent plane by more than this part of its distance, or if the
    // cosine between the normals is not above `gap_cosine`.
    double gap_steepest = 0.6;
    double gap_cosine = 0.5;
    // Marks whose offsets across differ by less than this belong to one line. Larger: close lines count as one.
    double same_line = 0.3;
    // The largest gap: wider gaps count as this wide. Larger: lines beside holes are drawn wider.
    double widest_gap = 2.0;
    // The number of marks of a line from one measurement of its gap to the next, and the number of measurements on
    // either side that are averaged: over some three separations. Larger: less time, slower changes.
    std::int64_t marks_per_measurement = 4;
    std::int64_t averaged_measurements = 2;
    // Gaps are not measured in layers with more marks than this around each mark, because a file may give any
    // separation.
    std::int64_t most_neighbours = 4000;

    // ---- Normals for tone

    // Normals within this many lengths of tone smoothing are averaged, over about the second number of marks.
    double tone_reach = 2.0;
    double tone_marks = 64.0;
    // A mark lies on another sheet if it leaves the tangent plane by more than this part of its distance.
    double tone_steepest = 0.7;

    // ---- The spacing of marks on an unknown surface

    // From this many marks on, the area is estimated by the cells that the marks occupy, where each cell holds the
    // second number of marks on average. Larger: corners that the surface hardly cuts count less, and so do fine forms.
    std::int64_t fewest_for_cells = 512;
    double marks_a_cell = 8.0;
};
inline constexpr MarksTuning marks_tuning;

} // namespace hrbfnpr::marks
