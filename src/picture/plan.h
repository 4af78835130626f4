// SPDX-License-Identifier: MIT
// Plans a drawing for a size and a view: the radius of the pen, the style, and the marks that fill its darkest tone.
#pragma once

#include "picture/call.h"
#include "picture/style.h"

#include <cstdint>

namespace hrbfnpr::picture {

// The radius of the pen for a picture, in pixels: what the named styles, which are made for 1, are scaled by.  1 for a
// style of the caller's own.
[[nodiscard]] double pen_of(const Call& call, double width, double height);

// The style for a picture: the named one, that of settings or the caller's own, with its marks and lines sized for the
// picture, and then with the caller's changes.  has_end: whether a surface ends, so that its border is drawn.
[[nodiscard]] Style plan_style(const Call& call, double width, double height, bool has_end);

// The layers of marks that the style wants, with as many marks as fill its darkest tone where the caller does not say.
// Tells notes of what is limited, and puts what is painted into the style and the layers.
//   area             of the surface, in square units of the model
//   pixels_per_unit  of the picture, for a length across the view at the middle of the model
//   centres          of the model, 0 or more: where marks of PUBLISHED start
[[nodiscard]] Marks plan_marks(const Call& call, Style& style, double area, double pixels_per_unit,
                               std::int64_t centres, const hrbfnpr_camera& camera);

// As many of each budget's marks as a part of the area gets.  share: 0 to 1.
[[nodiscard]] Marks share_of(const Marks& marks, double share);

// Places the marks, as the stage MARKS.
[[nodiscard]] PointSet generate_marks(const Call& call, const Model& model, const Marks& marks);

// On which sides of the surface marks are drawn (HRBFNPR_SIDES_...): the inside of a surface that ends is seen, too.
// A null model: a point set.
[[nodiscard]] std::uint32_t sides_of(const Call& call, const Model& model);

} // namespace hrbfnpr::picture
