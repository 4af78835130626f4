// SPDX-License-Identifier: MIT
// Polylines on the surface.
//   find_crests: waves at the vertices of a mesh -> lines along the crests of the finest one
//   join_ends: lines whose ends face each other over a small gap -> one line
//   resampled: lines -> the same with points a step apart
//   even_out: lines -> the same, moved to the middle between those beside them
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
    // The points that were added since the last line become one.
    void end_line(bool is_closed);

    base::Array<std::int64_t> first;  // the first point of each line, and the end
    base::Array<std::uint8_t> closed; // one for each line: 1 if its first point follows its last one, else 0
    geometry::VecArray position;
    geometry::VecArray normal;       // about the surface's normal at each point, unit
    base::Array<std::uint8_t> level; // the coarsest wave that has a crest at each point, by number
};

// Between two crests of the finest wave more lines are put in until there are as many levels as wanted.
[[nodiscard]] Lines find_crests(const base::Work& work, const curves::SurfaceMesh& mesh, const Waves& waves,
                                int levels);

// Joins ends that are no farther apart than `reach` and run towards each other: a mesh does not always show a line
// through a fork.
[[nodiscard]] Lines join_ends(const Lines& lines, double reach, const base::Progress& progress);

// Points are as near to `step` apart as the length of their line allows; lines shorter than `shortest` are left out.
[[nodiscard]] Lines resampled(const Lines& lines, double step, double shortest, const base::Progress& progress);

// Moves lines across themselves, by amounts that change slowly along each line, so that none is bent. The points of
// the result are about half a separation apart. The same bits for any number of threads.
[[nodiscard]] Lines even_out(const base::Work& work, const Lines& lines, double separation);

// Appends marks a step apart along each line, brought onto the surface, line after line; those that are of a coarse
// level somewhere come first. `separation` is that of all levels together; beyond the region there is no surface.
void add_line_marks(const marks::Site& site, const Lines& lines, double separation, double step,
                    const geometry::Bounds& region, marks::Marks& marks, marks::LayerReport& report);

} // namespace hrbfnpr::hatching
