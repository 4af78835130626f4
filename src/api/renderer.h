// SPDX-License-Identifier: MIT
// The handle of a renderer: the working memory of one thread, and its last drawings.
#pragma once

#include "api/drawing.h"
#include "api/handles.h"
#include "api/style.h"
#include "frame/frame.h"

struct hrbfnpr_renderer : hrbfnpr::api::Child {
    explicit hrbfnpr_renderer(hrbfnpr_context& context)
        : Child(context), frame(context.runtime), items(context.runtime.memory), styles(context.runtime.memory),
          poses(context.runtime.memory), drawings(context.runtime.memory) {}
    ~hrbfnpr_renderer() {
        for (const hrbfnpr_drawing* drawing : drawings) hrbfnpr::api::release_handle(drawing);
    }

    hrbfnpr::frame::Frame frame;
    // The items, styles and other inputs of the drawing that is being made.
    hrbfnpr::base::Array<hrbfnpr::frame::Item> items;
    hrbfnpr::api::StyleLists styles;
    hrbfnpr::base::Array<hrbfnpr::frame::Pose> poses;
    hrbfnpr::base::Array<hrbfnpr_drawing*> drawings; // The renderer holds a reference to each drawing.
};
