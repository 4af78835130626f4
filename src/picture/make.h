// SPDX-License-Identifier: MIT
// Making pictures, and drawings of them.
#pragma once

#include "picture/handles.h"

#include <hrbfnpr.h>

namespace hrbfnpr::picture {

// Makes a picture of the sources of a descriptor.  The caller of each of these gets one reference.
[[nodiscard]] hrbfnpr_picture* create_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc,
                                              hrbfnpr_operation* operation);
// Makes one of the same surfaces.
[[nodiscard]] hrbfnpr_picture* restyle_picture(const hrbfnpr_picture& of, const hrbfnpr_picture_desc& desc,
                                               hrbfnpr_operation* operation);
// camera: null is the planned one, by which something has to be seen.
[[nodiscard]] hrbfnpr_drawing* draw_picture(hrbfnpr_picture& picture, const hrbfnpr_camera* camera,
                                            hrbfnpr_operation* operation);

// Throws Error{invalid_argument} for a picture of surfaces alone.
void require_planned(const hrbfnpr_picture& picture);

// The marks of all layers; 0 of none.
[[nodiscard]] std::int64_t mark_count_of(const PointSet& marks);

} // namespace hrbfnpr::picture
