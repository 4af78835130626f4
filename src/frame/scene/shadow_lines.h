// SPDX-License-Identifier: MIT
// The borders of shadows as lines on the surface of an item.
//
// A light sees outlines, as a camera does: contours, creases that are contours, and borders. An outline is the edge of
// a shadow if nothing lies between it and the light. On its own surface it then divides light from shade; this is the
// terminator. The rays of light that touch an outline go on to the first surface that they meet, and there they draw
// the border of the cast shadow.
//
//   find_outlines  a light, a caster → its outlines in the world, cut into sections that light may touch
//   follow         sections, casters, the item → for places of the outlines: whether the light sees them, and where
//                  their shadows fall. Places are added until lines through the shadows are smooth.
//   add_borders, add_terminators  sections → lines on the item
#pragma once

#include "frame/scene/shading.h"

namespace hrbfnpr::frame {

// Returns lines of the kinds `shadow` and `terminator`, for all lights that cast shadows. Their strength is the light's
// `shadow`. The item and all casters must have line sets. The result has the same bits for any number of threads.
[[nodiscard]] base::List<curves::FoundLines> find_shadow_lines(const base::Work& work, const Casters& casters,
                                                               const ShadedItem& item);

} // namespace hrbfnpr::frame
