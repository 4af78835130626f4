// SPDX-License-Identifier: MIT
// Decides which lines a drawing needs. This depends on the caller's request and the style.
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
    WantedLine(const WantedLine&) = delete; // A copy would allocate `levels` outside the pool.

    std::uint32_t kind;       // the kind, HRBFNPR_LINE_KIND_*
    int axis = 2;             // for SECTION: the axis perpendicular to the planes, 0 to 2
    std::int64_t planes = 10; // for SECTION: the number of planes, at least 1, evenly spaced between the bounds
    Vector<double> levels;    // for ISOPHOTE: values of n . l; empty for other kinds
};

// Reads a text such as "contour,suggestive,ridges,section=z:20,isophotes=0.3:0.6". "none" and "" mean no lines. Throws
// Error{invalid_argument} that says which texts are valid.
[[nodiscard]] Vector<WantedLine> parse_lines(std::string_view text, Pool& pool);

// Returns the lines that the caller asks for. If the caller asks for none, returns the lines that the style draws and
// that have to be found once. Contours are not among these. `is_mesh` means that the surface comes from a mesh, which
// may have creases.
[[nodiscard]] Vector<WantedLine> wanted_lines(const Call& call, const Style& style, bool is_mesh);

// Returns whether a style has lines that need curvatures in the line set.
[[nodiscard]] bool needs_curvature(const Style& style) noexcept;

// Sets the lines of a style to the caller's lines, if given, and scales all lines by the radius of the pen. `has_end`
// means that a surface ends, so its border is drawn.
void size_lines(const Call& call, Style& style, double pen, bool has_end);

} // namespace hrbfnpr::picture
