// SPDX-License-Identifier: MIT
// The handles of occluders and of shadings.
#pragma once

#include "api/handles.h"
#include "frame/scene/shading.h"

struct hrbfnpr_occluders : hrbfnpr::api::Child {
    hrbfnpr_occluders(hrbfnpr_context& context, hrbfnpr::frame::Casters&& made)
        : Child(context), casters(std::move(made)) {}

    const hrbfnpr::frame::Casters casters;
};

struct hrbfnpr_shading : hrbfnpr::api::Child {
    hrbfnpr_shading(hrbfnpr_context& context, const hrbfnpr_point_set& of, hrbfnpr::frame::Shading&& made);
    ~hrbfnpr_shading();

    const hrbfnpr_point_set& set;
    const hrbfnpr::frame::Shading shading;
};
