// SPDX-License-Identifier: MIT
// A camera that sees no face exactly edge-on: of such a face nothing tells on which side of its edges it lies.
#pragma once

#include "frame/scene/scene.h"

#include <span>

namespace hrbfnpr::frame {

// Of a scene in which an item's line set has creases the camera for all its lines: what is parallel to the axis of an
// orthographic one turns away a little, as seen from a finite distance, and the eye moves a little to one side.  No
// place in the scene moves by more than 2e-5 of the radius of all items.  Of other scenes the scene's own camera.
[[nodiscard]] Camera camera_off_planes(const Scene& scene, std::span<const Item> items);

} // namespace hrbfnpr::frame
