// SPDX-License-Identifier: MIT
// The handle of a drawing. It keeps the point sets that the drawing refers to.
#pragma once

#include "api/handles.h"
#include "api/point_set.h"
#include "drawing/drawing.h"

struct hrbfnpr_drawing : hrbfnpr::api::Child {
    explicit hrbfnpr_drawing(hrbfnpr_context& context)
        : Child(context), drawing(context.runtime.memory), sets(context.runtime.memory) {}
    ~hrbfnpr_drawing() { release_owners(); }

    void release_owners() noexcept {
        for (const hrbfnpr_point_set* set : sets) hrbfnpr::api::release_handle(set);
        sets.clear();
    }

    hrbfnpr::drawing::Drawing drawing;
    hrbfnpr::base::Array<const hrbfnpr_point_set*> sets; // The point sets. The drawing holds a reference to each.
};
