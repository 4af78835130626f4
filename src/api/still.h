// SPDX-License-Identifier: MIT
// The drawing of a still picture, read from a caller's item and camera.
#pragma once

#include "api/camera.h"
#include "api/checks.h"
#include "api/style.h"
#include "api/views.h"
#include "frame/scene/still.h"

namespace hrbfnpr::api {

// Throws Error{invalid_argument} if the drawing cannot be made.
struct CheckedStill {
    CheckedStill(base::Memory& memory, const hrbfnpr_item& item, const hrbfnpr_camera& camera) : lists(memory) {
        const Checks checks("item");
        checks.one_of("sides", item.sides, HRBFNPR_SIDES_BOTH + 1, "HRBFNPR_SIDES_*");
        still.camera = to_camera(camera);
        still.style = checked_style(read_optional_struct(item.style, "item.style"), "item.style", lists);
        still.style.layers = std::as_const(lists.layers).span();
        still.style.lights = std::as_const(lists.lights).span();
        still.both_sides = item.sides == HRBFNPR_SIDES_BOTH;
        still.transform = to_matrix(item.transform);
    }

    StyleLists lists;
    frame::Still still; // Its style refers to `lists`.
};

} // namespace hrbfnpr::api
