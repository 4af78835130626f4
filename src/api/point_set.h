// A point set as a handle.
#pragma once

#include "api/handles.h"
#include "sampling/point_set.h"

struct hrbfnpr_point_set : hrbfnpr::api::Child {
    hrbfnpr_point_set(hrbfnpr_context& context, hrbfnpr::sampling::PointSet&& marks) noexcept
        : Child(context), set(std::move(marks)) {}

    const hrbfnpr::sampling::PointSet set;
};
