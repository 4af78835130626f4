// SPDX-License-Identifier: MIT
// Makes the line set of a surface, from which its lines are drawn.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/memory.h"
#include "picture/shape.h"
#include "picture/style.h"
#include "picture/wanted_lines.h"

#include <hrbfnpr.h>

namespace hrbfnpr::picture {

using Polyline = Points;

// Lines that are found once, when a line set is made. This is a hrbfnpr_line_desc that owns its texts and lists.
struct LinesOnce {
    LinesOnce(std::uint32_t line_kind, Pool& pool)
        : kind(line_kind), name(&pool), levels(&pool), points(&pool), line_first(&pool) {}
    LinesOnce(LinesOnce&&) noexcept = default;
    LinesOnce& operator=(LinesOnce&&) = default;
    LinesOnce(const LinesOnce&) = delete; // copies of its lists would leave the pool
    LinesOnce& operator=(const LinesOnce&) = delete;

    std::uint32_t kind;
    String name;
    double lower = 0.0;
    double upper = 0.0;
    double shortest = 0.01;
    glm::dvec3 plane{0.0, 0.0, 1.0};  // The normal of the planes of SECTION.
    Vector<double> levels;            // The offsets of the planes of SECTION.
    Points points;                    // The polylines of OWN, one after the other.
    Vector<std::uint32_t> line_first; // Where each polyline begins in `points`, and the end of `points`.

    // Returns a view that is valid while this object lives and is not changed.
    [[nodiscard]] hrbfnpr_line_desc view() const noexcept;
};

// Returns the lines that are found once, without those of a plate and the edges of a mesh. They come from the settings
// if these have lines and the caller names none. Otherwise they come from `wanted`.
[[nodiscard]] Vector<LinesOnce> lines_found_once(const Call& call, const hrbfnpr_model& model,
                                                 const Vector<WantedLine>& wanted);

// Makes the line set for the lines of a style and for `more` lines, such as the section of a plate. Returns a null
// handle if nothing is drawn from it.
[[nodiscard]] LineSet make_lines(const Call& call, const Surface& surface, const Style& style,
                                 const Vector<WantedLine>& wanted, const Vector<LinesOnce>& more);

// Returns the sharp edges of a mesh, as hrbfnpr_mesh_edges finds them where faces meet at more than `angle` degrees,
// joined to polylines. A polyline continues through a vertex where exactly two such edges meet. Polylines that begin at
// other vertices come first. Throws Error{invalid_argument} for a shape without faces.
[[nodiscard]] Vector<Polyline> mesh_creases(hrbfnpr_context& context, const Shape& shape, double angle,
                                            hrbfnpr_operation* operation, Pool& pool);

// Removes the facets of a rounded shape: if the mean crease is short, only long creases are kept.
[[nodiscard]] Vector<Polyline> without_facets(Vector<Polyline> creases, double diagonal);

// Warns of lines in a drawing that may be wrong or incomplete.
void tell_doubts(Report& report, const hrbfnpr_drawing_info& info);

} // namespace hrbfnpr::picture
