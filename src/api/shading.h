// SPDX-License-Identifier: MIT
// The handles of occluders and of shadings.
#pragma once

#include "api/handles.h"
#include "api/line_set.h"
#include "frame/scene/shading.h"

struct hrbfnpr_occluders : hrbfnpr::api::Child {
    hrbfnpr_occluders(hrbfnpr_context& context, hrbfnpr::base::Array<const hrbfnpr_line_set*>&& line_sets,
                      hrbfnpr::frame::Casters&& made);
    ~hrbfnpr_occluders();

    const hrbfnpr::base::Array<const hrbfnpr_line_set*> sets; // The occluders keep them.
    const hrbfnpr::frame::Casters casters;
};

struct hrbfnpr_shading : hrbfnpr::api::Child {
    hrbfnpr_shading(hrbfnpr_context& context, const hrbfnpr_point_set& of, hrbfnpr::frame::Shading&& made);
    ~hrbfnpr_shading();

    const hrbfnpr_point_set& set;
    const hrbfnpr::frame::Shading shading;
};
