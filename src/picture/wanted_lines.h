// SPDX-License-Identifier: MIT
// Which lines a drawing wants, from what the caller says and from its style.
#pragma once

#include "picture/call.h"
#include "picture/memory.h"
#include "picture/style.h"

#include <cstdint>
#include <string_view>

namespace hrbfnpr::picture {

// One kind of lines, and what is said of it.
struct WantedLine {
    WantedLine(std::uint32_t line_kind, Pool& pool) : kind(line_kind), levels(&pool) {}
    WantedLine(WantedLine&&) noexcept = default;
    WantedLine(const WantedLine&) = delete; // a copy of `levels` would leave the pool

    std::uint32_t kind;       // HRBFNPR_LINE_KIND_...
    int axis = 2;             // of SECTION: planes stand across this axis, 0 to 2
    std::int64_t planes = 10; // of SECTION: how many there are, 1 and more, evenly between the bounds
    Vector<double> levels;    // of ISOPHOTE: n . l; empty of others
};

// Reads "contour,suggestive,ridges,section=z:20,isophotes=0.3:0.6"; "none" and "" are no lines.  Throws
// Error{invalid_argument} that says what would be right.
[[nodiscard]] Vector<WantedLine> parse_lines(std::string_view text, Pool& pool);

// The lines that the caller asks for, or those that the style draws beside contours and that have to be found once.
// is_mesh: whether the surface comes from a mesh, which may have creases.
[[nodiscard]] Vector<WantedLine> wanted_lines(const Call& call, const Style& style, bool is_mesh);

// Whether the line set of a style must hold curvatures.
[[nodiscard]] bool needs_curvature(const Style& style) noexcept;

// Sets the lines of a style: its own, or those that the caller asks for.  Scales them by the radius of the pen.
// has_end: whether a surface ends, so that its border is drawn.
void size_lines(const Call& call, Style& style, double pen, bool has_end);

} // namespace hrbfnpr::picture
