// SPDX-License-Identifier: MIT
// The other side of surfaces that end: their inside is seen.
#pragma once

#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

// Gives the runs that are turned, which stand as those of their items, the normals and clusters of the other side.
// The poses are in the scene already.
void turn(Scene& scene);

} // namespace hrbfnpr::frame
