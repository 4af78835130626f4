// SPDX-License-Identifier: MIT
// Polylines on the surface.
//   find_crests: waves at the vertices of a mesh -> lines along the crests of the finest wave
//   join_ends: lines whose ends face each other over a small gap -> one line
//   resampled: lines -> the same lines with points a step apart
//   even_out: lines -> the same lines, moved to the middle between their neighbours, and continued into forks
//   add_line_marks: lines -> marks on the surface
#pragma once

#include "hatching/field.h"
#include "marks/site.h"

namespace hrbfnpr::hatching {

struct Lines {
    // The bits of `border`.
    static constexpr std::uint8_t begins_at_border = 1;
    static constexpr std::uint8_t ends_at_border = 2;

    explicit Lines(base::Memory& memory)
        : first(memory), closed(memory), border(memory), position(memory), normal(memory), level(memory) {
        first.push_back(0);
    }

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t points(std::int64_t line) const noexcept { return first[line + 1] - first[line]; }
    void add_point(const glm::dvec3& at, const glm::dvec3& its_normal, std::uint8_t its_level,
                   const base::Progress& progress);
    // Ends a line. The line consists of the points that were added since the previous line ended.
    void end_line(bool is_closed, std::uint8_t its_border = 0);

    base::Array<std::int64_t> first;  // the index of the first point of each line; at the end, the number of points
    base::Array<std::uint8_t> closed; // for each line: 1 if it is closed, else 0
    // For each line: bits that tell which of its ends are at the mesh's border, where a face or the surface ends.
    base::Array<std::uint8_t> border;
    geometry::VecArray position;
    geometry::VecArray normal;       // for each point: the unit normal of the surface, approximately
    base::Array<std::uint8_t> level; // for each point: the index of the coarsest wave that has a crest there
};

// Finds lines along the crests of the finest wave. If there are fewer than `levels` waves, it inserts further lines
// between crests.
[[nodiscard]] Lines find_crests(const base::Work& work, const curves::SurfaceMesh& mesh, const Waves& waves,
                                int levels);

// Joins ends that are at most `reach` apart and point towards each other. Such gaps occur at forks, where a line may be
// interrupted although it continues on the other side.
[[nodiscard]] Lines join_ends(const Lines& lines, double reach, const base::Progress& progress);

// Returns the lines with new points at equal distances along each line. The distance is `step`, rounded so that it
// divides the length of the line. Lines shorter than `shortest` are left out, except those with both ends at the mesh's
// border: they cross a narrow face.
[[nodiscard]] Lines resampled(const Lines& lines, double step, double shortest, const base::Progress& progress);

// Moves lines sideways, so that they are evenly spaced. The amounts change slowly along each line, so that lines do not
// bend. The points of the result are about half a separation apart. The result has the same bits for any number of
// threads.
[[nodiscard]] Lines even_out(const base::Work& work, const Lines& lines, double separation);

// Appends marks along each line, a step apart, projected onto the surface. Lines with marks of a coarse level come
// first. `separation` is the distance between the lines of all levels together. Marks outside the region are dropped.
void add_line_marks(const marks::Site& site, const Lines& lines, double separation, double step,
                    const geometry::Bounds& region, marks::Marks& marks, marks::LayerReport& report);

} // namespace hrbfnpr::hatching
