// SPDX-License-Identifier: MIT
// Decides which lines a drawing needs, from the caller's request and the style.
#pragma once

#include "picture/call.h"
#include "picture/memory.h"
#include "picture/style.h"

#include <cstdint>
#include <string_view>

namespace hrbfnpr::picture {

// One kind of lines, with its parameters.
struct WantedLine {
    WantedLine(std::uint32_t line_kind, Pool& pool) : kind(line_kind), levels(&pool) {}
    WantedLine(WantedLine&&) noexcept = default;
    WantedLine(const WantedLine&) = delete; // a copy of `levels` would leave the pool

    std::uint32_t kind;       // HRBFNPR_LINE_KIND_*
    int axis = 2;             // for SECTION: the axis perpendicular to the planes, 0 to 2
    std::int64_t planes = 10; // for SECTION: the number of planes, at least 1, evenly spaced between the bounds
    Vector<double> levels;    // for ISOPHOTE: values of n . l; empty for other kinds
};

// Reads a text such as "contour,suggestive,ridges,section=z:20,isophotes=0.3:0.6". "none" and "" mean no lines. Throws
// Error{invalid_argument} that says which texts are valid.
[[nodiscard]] Vector<WantedLine> parse_lines(std::string_view text, Pool& pool);

// Returns the lines that the caller asks for, or else the lines that the style draws besides contours and that have to
// be found once. `is_mesh` tells that the surface comes from a mesh, which may have creases.
[[nodiscard]] Vector<WantedLine> wanted_lines(const Call& call, const Style& style, bool is_mesh);

// Tells whether the line set of a style must hold curvatures.
[[nodiscard]] bool needs_curvature(const Style& style) noexcept;

// Sets the lines of a style: its own, or the lines that the caller asks for. Scales them by the radius of the pen.
// `has_end` tells that a surface ends, so that its border is drawn.
void size_lines(const Call& call, Style& style, double pen, bool has_end);

} // namespace hrbfnpr::picture
