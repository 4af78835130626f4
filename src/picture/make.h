// SPDX-License-Identifier: MIT
// Creates pictures, and draws them.
#pragma once

#include "picture/handles.h"

#include <hrbfnpr.h>

namespace hrbfnpr::picture {

// Creates a picture of the sources of a descriptor. The caller of each function here gets one reference to the result.
[[nodiscard]] hrbfnpr_picture* create_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc,
                                              hrbfnpr_operation* operation);
// Creates another picture of the same surfaces.
[[nodiscard]] hrbfnpr_picture* restyle_picture(const hrbfnpr_picture& of, const hrbfnpr_picture_desc& desc,
                                               hrbfnpr_operation* operation);
// Draws a picture. If `camera` is null, the planned camera is used, and it must see something.
[[nodiscard]] hrbfnpr_drawing* draw_picture(hrbfnpr_picture& picture, const hrbfnpr_camera* camera,
                                            hrbfnpr_operation* operation);

// Throws Error{invalid_argument} for a picture of surfaces alone.
void require_planned(const hrbfnpr_picture& picture);

// Returns the number of marks in all layers, or 0 without marks.
[[nodiscard]] std::int64_t mark_count_of(const PointSet& marks);

} // namespace hrbfnpr::picture
