// SPDX-License-Identifier: MIT
// Creates pictures, and draws them.
#pragma once

#include "picture/handles.h"
#include "picture/look.h"

#include <hrbfnpr.h>

namespace hrbfnpr::picture {

// Creates a picture of the sources in a descriptor. The caller owns one reference to the result of each function here.
[[nodiscard]] hrbfnpr_picture* create_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc,
                                              hrbfnpr_operation* operation);
// Creates a picture of the surfaces of the picture `of`, as the descriptor asks.
[[nodiscard]] hrbfnpr_picture* restyle_picture(const hrbfnpr_picture& of, const hrbfnpr_picture_desc& desc,
                                               hrbfnpr_operation* operation);
// Draws a picture. If `camera` is null, uses the picture's planned camera, and throws if nothing can be seen.
[[nodiscard]] hrbfnpr_drawing* draw_picture(hrbfnpr_picture& picture, const hrbfnpr_camera* camera,
                                            hrbfnpr_operation* operation);

// Returns the camera for a view of a picture, which includes shadows on its ground. `for_orbit`: an orbit begins with
// it.
[[nodiscard]] hrbfnpr_camera camera_of_view(const hrbfnpr_picture& picture, const View& view, bool for_orbit);

// Throws Error{invalid_argument} if the picture was made with the flag SURFACE_ONLY, and so has no plan for a drawing.
void require_planned(const hrbfnpr_picture& picture);

// Returns the number of marks in all layers, or 0 for null.
[[nodiscard]] std::int64_t mark_count_of(const PointSet& marks);

} // namespace hrbfnpr::picture
