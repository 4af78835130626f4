// SPDX-License-Identifier: MIT
// The tuning constants of pages. scripts/bench vector measures their effects. Formats, line types and fonts are data,
// not tuning: page.h has them.
#pragma once

#include <cstdint>
#include <numbers>

namespace hrbfnpr::output {

struct LayOutTuning {
    // A stroke is cut where its opacity differs by more than this from that of the part's first point. Larger: fewer
    // parts, with visible steps.
    float opacity_step = 1.0F / 32.0F;
    // Inks are told to lie upon each other by cells of this side, in pixels. Larger: more runs.
    double least_cell = 4.0;
    // Cells are made wider where the page would have more of them than this, counted for each colour. Larger: more
    // memory.
    double most_cells = 4e6;
    // Groups begin anew at most this often; later inks are then in the last run, whatever they lie upon. Larger: more
    // groups in the file.
    std::int32_t most_runs = 32;
};
inline constexpr LayOutTuning lay_out_tuning;

struct PlotTuning {
    // ---- Joining lines

    // Points that are nearer to each other than this count as one, mm.
    double nowhere = 1e-6;
    // A line may turn by at most this angle at a join, and its link on either side, radians. Larger: more joins, with
    // corners.
    double sharpest_join = 1.04719755;
    // An end is compared with this many others that are nearest to it, and a tour's move with as many. Larger: more
    // time.
    std::int32_t most_near = 8;
    // Chains close to rings from this length on, in widths of the line.
    double shortest_ring = 4.0;
    // A link that is longer than this part of the thinner line's width must not be a step to the side.
    double seen_link = 0.5;

    // ---- Lines and dots that are too fine for the pen

    // Lines shorter than this, in widths, are dropped, and of dots that are nearer to each other the later ones.
    double shortest_line = 0.5;

    // ---- Filling lines that are wider than their pen: all in widths of the pen

    // Passes are this far apart, less where the tolerance asks for it. Larger: fewer passes, with gaps.
    double most_spacing = 0.8;
    double least_spacing = 0.4;
    // Another pass is left out where it would add no more than this on each side of the line. Larger: fewer passes,
    // narrower lines.
    double left_out = 0.1;
    // Shorter passes are left out. Larger: fewer passes.
    double shortest_pass = 0.5;
    // A pass goes on through gaps up to this long. Larger: fewer passes.
    double longest_gap = 2.0;
    // The pen stays down from a pass to the next one up to this far across the line and along it. Larger: fewer lifts.
    double longest_link = 12.0;
    double longest_step = 3.0;
    // No line has more passes than this.
    double most_passes = 10000.0;
    // One normal stands for a turn up to this angle, radians. Smaller: rounder outer sides.
    double widest_turn = 20.0 / 180.0 * std::numbers::pi;
    // Round ends are this many steps. Larger: rounder ends.
    int parts_of_cap = 6;
    // Turns of a dot's spiral are this far apart. Larger: fewer turns, with gaps.
    double spiral_pitch = 0.9;
    // No spiral has more turns than this.
    double most_turns = 1000.0;

    // ---- Tours

    // An Or-opt move takes at most this many stops elsewhere together.
    static constexpr std::int32_t longest_moved = 3;
    // This many points of a closed line may be entered before the best one is looked for.
    std::int64_t most_doors = 32;
    // Moves may take this many steps for each stop, and moves after kicks the second number. Larger: shorter tours,
    // more time.
    std::int64_t work_of_stop = 8000;
    std::int64_t work_of_kicks = 2000;
    // Where stops are few, moves after kicks take up to the first number of steps for each and the second together.
    std::int64_t work_of_few = 10000;
    std::int64_t least_work = 200000;
    // A kick exchanges two parts of at most this many stops.
    std::int64_t longest_swapped = 30;
    // A move turns round or passes by at most this many stops, and after a kick the second number. Larger: shorter
    // tours of many stops, more time.
    std::int64_t longest_reversed = 50000;
    std::int64_t longest_kicked = 1000;
    // Moves, and turning closed lines, take turns at most this often.
    int most_rounds = 4;
    // A move gains at least this much, mm, which is above what rounding changes.
    double least_gain = 1e-9;
};
inline constexpr PlotTuning plot_tuning;

struct ShapeTuning {
    // A line is of one width if its widths differ by no more than this part of the greatest. Larger: fewer outlines.
    double even = 0.02;
    // Lines count as no thinner than this where widths are put into classes, mm.
    double least_radius = 0.005;
    // Outlines are cut where they turn by more than the angle of this cosine, 30 degrees. Larger: more cuts.
    double sharp_cosine = 0.866;
    // They are cut as well where less than this part of a segment is left at the inner side of a turn.
    double left_inside = 0.1;
};
inline constexpr ShapeTuning shape_tuning;

// Steps of work between two looks for a cancel: points, lines or dots; and comparisons of a sort.
inline constexpr std::int64_t steps_a_look = 512;
inline constexpr std::int64_t comparisons_a_look = 65536;

} // namespace hrbfnpr::output
