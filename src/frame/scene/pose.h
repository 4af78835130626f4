// SPDX-License-Identifier: MIT
// Marks that have moved since their set was made.
#pragma once

#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

// Takes the items' poses into the drawing, and lets the runs of those layers see them.  The runs stand already.
// Throws Error{invalid_argument}.
void pose(Scene& scene, std::span<const Item> items, drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
