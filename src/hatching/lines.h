// SPDX-License-Identifier: MIT
// Polylines on the surface.
//   find_crests: waves at the vertices of a mesh -> lines along the crests of the finest wave
//   join_ends: lines whose ends face each other over a small gap -> one line
//   resampled: lines -> the same lines with points a step apart
//   even_out: lines -> the same lines, moved to the middle between their neighbours
//   add_line_marks: lines -> marks on the surface
#pragma once

#include "hatching/field.h"
#include "marks/site.h"

namespace hrbfnpr::hatching {

struct Lines {
    explicit Lines(base::Memory& memory)
        : first(memory), closed(memory), position(memory), normal(memory), level(memory) {
        first.push_back(0);
    }

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t points(std::int64_t line) const noexcept { return first[line + 1] - first[line]; }
    void add_point(const glm::dvec3& at, const glm::dvec3& its_normal, std::uint8_t its_level,
                   const base::Progress& progress);
    // Makes a line of the points that were added since the last line.
    void end_line(bool is_closed);

    base::Array<std::int64_t> first;  // the first point of each line, and the end
    base::Array<std::uint8_t> closed; // for each line: 1 if its first point follows its last one, else 0
    geometry::VecArray position;
    geometry::VecArray normal;       // unit; the surface's normal at each point, approximately
    base::Array<std::uint8_t> level; // the number of the coarsest wave that has a crest at each point
};

// If the finest wave does not reach `levels` levels, further lines are inserted between its crests.
[[nodiscard]] Lines find_crests(const base::Work& work, const curves::SurfaceMesh& mesh, const Waves& waves,
                                int levels);

// Joins ends that are at most `reach` apart and run towards each other. The mesh does not always show a line that
// passes through a fork, which leaves such gaps.
[[nodiscard]] Lines join_ends(const Lines& lines, double reach, const base::Progress& progress);

// Points are as close to `step` apart as the length of the line allows. Lines shorter than `shortest` are left out.
[[nodiscard]] Lines resampled(const Lines& lines, double step, double shortest, const base::Progress& progress);

// Moves lines sideways, by amounts that change slowly along each line, so that no line is bent. The points of the
// result are about half a separation apart. The result has the same bits for any number of threads.
[[nodiscard]] Lines even_out(const base::Work& work, const Lines& lines, double separation);

// Appends marks a step apart along each line, projected onto the surface, line after line; lines with marks of a coarse
// level come first. `separation` is the distance between the lines of all levels together. Marks outside the region are
// dropped.
void add_line_marks(const marks::Site& site, const Lines& lines, double separation, double step,
                    const geometry::Bounds& region, marks::Marks& marks, marks::LayerReport& report);

} // namespace hrbfnpr::hatching
