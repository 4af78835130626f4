// SPDX-License-Identifier: MIT
// From lines and their visibility to strokes: which parts are drawn, how wide, and how they end.
#pragma once

#include "base/runtime.h"
#include "frame/lines/width_laws.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

// Adds the strokes of all lines.
void add_strokes(const base::Runtime& runtime, const Scene& scene, const LineInput& input, const WidthLaws& laws,
                 LineStrokes& strokes);

} // namespace hrbfnpr::frame
