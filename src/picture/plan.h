// SPDX-License-Identifier: MIT
// Plans a drawing for a size and a view: the radius of the pen, the style, and the number of marks for the darkest
// tone.
#pragma once

#include "picture/call.h"
#include "picture/style.h"

#include <cstdint>

namespace hrbfnpr::picture {

// A side of a picture, in pixels, for questions about the style that do not depend on the size of the picture.
inline constexpr double any_side = 1000.0;

// Returns the radius of the pen for a picture, in pixels. The lengths in named styles are made for a radius of 1, and
// are multiplied by the result. For a style of the caller, the result is 1.
[[nodiscard]] double pen_of(const Call& call, double width, double height);

// Returns the style for a picture: a named style, a style from settings, or the caller's style. Marks and lines are
// sized for the picture, and the caller's changes are applied last. `has_end` means that a surface ends, so its border
// is drawn.
[[nodiscard]] Style plan_style(const Call& call, double width, double height, bool has_end);

// Returns whether a style draws hidden parts of lines, or marks as if nothing were in front of them.
[[nodiscard]] bool draws_hidden(const Style& style) noexcept;

// Plans the layers of marks that the style wants. Where the caller gives no number, the marks fill the darkest tone.
// Notes the limits that apply, and puts painted densities and directions into the layers.
//   area             area of the surface, in square units of the model
//   pixels_per_unit  length in pixels of a unit of the model at its middle, perpendicular to the line of sight
//   centres          number of centres of the model, 0 or more; the published recursion starts from centres
[[nodiscard]] Marks plan_marks(const Call& call, const Style& style, double area, double pixels_per_unit,
                               std::int64_t centres);

// Returns the marks for a part of the area: all budgets are multiplied by `share`, from 0 to 1.
[[nodiscard]] Marks share_of(const Marks& marks, double share);

// The drawing of a still picture.
struct StillDrawing {
    hrbfnpr_item item;
    hrbfnpr_camera camera;
};

// Generates the marks, in the stage MARKS. If `still` is not null, marks that its drawing does not need are left out.
[[nodiscard]] PointSet generate_marks(const Call& call, const Model& model, const Marks& marks,
                                      const StillDrawing* still);

// Returns the sides of the surface on which marks are drawn (HRBFNPR_SIDES_*). If a surface ends, its inside is
// visible, too. `model` is null for a point set.
[[nodiscard]] std::uint32_t sides_of(const Call& call, const Model& model);

} // namespace hrbfnpr::picture
