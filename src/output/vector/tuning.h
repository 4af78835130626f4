// SPDX-License-Identifier: MIT
// The tuning constants of pages. scripts/bench vector measures their effects. Formats, line types and fonts are data:
// page.h has them.
#pragma once

#include <cstdint>
#include <numbers>

namespace hrbfnpr::output {

struct LayOutTuning {
    // A stroke is cut where its opacity differs by more than this from the opacity at the start of the current part.
    // Larger: fewer parts, visible steps.
    float opacity_step = 1.0F / 32.0F;
    // The least side of the cells that detect overlapping inks, in pixels. Larger: more runs.
    double least_cell = 4.0;
    // The cells are enlarged if the page would have more than this number of cells times colours. Larger: more memory.
    double most_cells = 4e6;
    // The greatest number of runs. In the last run, overlapping inks may be painted in the wrong order. Larger: more
    // groups in the file.
    std::int32_t most_runs = 32;
};
inline constexpr LayOutTuning lay_out_tuning;

struct PlotTuning {
    // ---- Joining lines

    // Points closer than this count as one, mm.
    double same_point = 1e-6;
    // The greatest angle in radians between two joined lines, and between a line and its link to the next line. Larger:
    // more joins, with corners.
    double sharpest_join = 1.04719755;
    // The number of nearest other ends that an end is compared with, for joins and for moves of a tour. Larger: more
    // time.
    std::int32_t most_neighbours = 8;
    // Chains shorter than this, in line widths, are not closed to rings.
    double shortest_ring = 4.0;
    // A link longer than this share of the thinner line's width must run in about the direction of both lines.
    double longest_free_link = 0.5;

    // ---- Lines and dots that are too fine for the pen

    // Lines shorter than this, in line widths, are dropped. Dots closer than this to an earlier dot are dropped, too.
    double shortest_line = 0.5;

    // ---- Filling lines that are wider than their pen: all lengths are in widths of the pen

    // The distance between passes, in pen widths. It is smaller where the tolerance requires it. Larger: fewer passes,
    // with gaps.
    double most_spacing = 0.8;
    double least_spacing = 0.4;
    // A strip on each side of the line that is narrower than this, in pen widths, gets no pass. Larger: fewer passes,
    // narrower lines.
    double unfilled_strip = 0.1;
    // Passes shorter than this, in pen widths, are dropped. Larger: fewer passes.
    double shortest_pass = 0.5;
    // A pass continues across gaps up to this long, in pen widths. Larger: fewer passes.
    double longest_gap = 2.0;
    // The pen stays down between two passes if their ends are at most `longest_link` apart, and at most `longest_step`
    // along the line. Both are in pen widths. Larger: fewer lifts.
    double longest_link = 12.0;
    double longest_step = 3.0;
    // The greatest number of passes for a line.
    double most_passes = 10000.0;
    // A turn up to this angle, in radians, gets a single normal. Smaller: rounder outer sides.
    double widest_turn = 20.0 / 180.0 * std::numbers::pi;
    // A round end has this many steps. Larger: rounder ends.
    int parts_of_cap = 6;
    // The distance between turns of a dot's spiral, in pen widths. Larger: fewer turns, with gaps.
    double spiral_pitch = 0.9;
    // The greatest number of turns of a spiral.
    double most_turns = 1000.0;

    // ---- Tours

    // An Or-opt move takes at most this many stops.
    static constexpr std::int32_t longest_moved = 3;
    // A closed line may be entered at this many points in the first tour; the best point is found later.
    std::int64_t most_entry_points = 32;
    // The number of steps per stop that moves may take: before kicks, and after kicks. Larger: shorter tours, more
    // time.
    std::int64_t work_of_stop = 8000;
    std::int64_t work_of_kicks = 2000;
    // With few stops, moves after kicks may take `work_of_few` steps for each stop, up to `least_work` in total.
    std::int64_t work_of_few = 10000;
    std::int64_t least_work = 200000;
    // A kick swaps two parts of at most this many stops each.
    std::int64_t longest_swapped = 30;
    // The greatest number of stops that a move may reverse or pass: before kicks, and after kicks. Larger: shorter
    // tours of many stops, more time.
    std::int64_t longest_reversed = 50000;
    std::int64_t longest_kicked = 1000;
    // The tour's moves and the search for better starts of closed lines alternate at most this many times.
    int most_rounds = 4;
    // A move must shorten the tour by at least this, in mm. It is above rounding errors.
    double least_gain = 1e-9;
};
inline constexpr PlotTuning plot_tuning;

struct ShapeTuning {
    // A line has constant width if its widths differ by at most this share of the largest width. Larger: fewer
    // outlines.
    double even_width = 0.02;
    // Radii below this, in mm, count as this when lines are sorted into classes of width.
    double least_radius = 0.005;
    // Outlines are cut at turns above the angle with this cosine, 30 degrees. Larger: more cuts.
    double sharp_cosine = 0.866;
    // Outlines are also cut at a turn if its inner side would keep less than this share of a segment.
    double least_inner_share = 0.1;
};
inline constexpr ShapeTuning shape_tuning;

struct ArcTuning {
    // Arcs have at most this radius, mm. Controllers of plotters compute in single precision, which is exact to 0.001
    // mm up to about this radius. Larger: fewer lines, less exact arcs.
    double largest_radius = 2000.0;
    // Lines that replace cubics are within this share of the tolerance, and arcs, too, if there are several. Larger:
    // more arcs, also where the curve has none.
    double share_of_several = 0.2;
    // A single line may use the whole tolerance if the best arc's squared error is not smaller by this factor. Larger:
    // more lines, also where the curve bends evenly.
    double least_gain = 4.0;
    // Such arcs and lines meet at angles of at most this, in radians, and each arc turns by more than this. Larger:
    // more arcs, with visible corners. Set with share_of_several on sheets of a slotted link and a bush.
    double widest_kink = 0.1;
    // The largest sweep of an arc in SVG, in radians. An arc is given by its radius there, so its centre is uncertain
    // near half a turn.
    double most_sweep_by_radius = 2.0 * std::numbers::pi / 3.0;
    // The largest sweep of an arc in G-code. Some controllers do not draw full circles.
    double most_sweep_by_centre = std::numbers::pi;
};
inline constexpr ArcTuning arc_tuning;

// The number of steps between two checks for cancellation. A step is a point, line or dot, or a comparison of a sort.
inline constexpr std::int64_t steps_per_check = 512;
inline constexpr std::int64_t comparisons_per_check = 65536;

} // namespace hrbfnpr::output
