// SPDX-License-Identifier: MIT
// The line set of a surface: what its lines are drawn from.
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

// Lines that are found when a line set is made: hrbfnpr_line_desc with texts and lists of its own.
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
    glm::dvec3 plane{0.0, 0.0, 1.0};  // of SECTION
    Vector<double> levels;            // of SECTION
    Points points;                    // of OWN: the polylines, one after the other
    Vector<std::uint32_t> line_first; // of OWN: where each begins in `points`, and the end

    // Valid while this lives and is not changed.
    [[nodiscard]] hrbfnpr_line_desc view() const noexcept;
};

// The lines that are found once, without those of a plate and the edges of a mesh: those of the settings where the
// caller asks for no others, else the ones that are wanted.
[[nodiscard]] Vector<LinesOnce> lines_found_once(const Call& call, const hrbfnpr_model& model,
                                                 const Vector<WantedLine>& wanted);

// Makes the line set that the lines of a style want, with some more lines, such as the section of a plate.  A null
// handle: nothing is drawn of it.
[[nodiscard]] LineSet make_lines(const Call& call, const Surface& surface, const Style& style,
                                 const Vector<WantedLine>& wanted, const Vector<LinesOnce>& more);

// The edges of a mesh where faces meet at more than an angle (degrees), joined to polylines: through vertices that two
// such edges meet in, those that begin at corners first.  Throws Error{invalid_argument} for what has no faces.
[[nodiscard]] Vector<Polyline> mesh_creases(const Shape& shape, double angle, Pool& pool);

// Creases without the facets of a rounded shape: if most creases are short, the long ones alone.
[[nodiscard]] Vector<Polyline> without_facets(Vector<Polyline> creases, double diagonal);

// Warns of lines in a drawing that are not as sure as the rest.
void tell_doubts(Report& report, const hrbfnpr_drawing_info& info);

} // namespace hrbfnpr::picture
