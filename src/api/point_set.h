// SPDX-License-Identifier: MIT
// The handle of a point set.
#pragma once

#include "api/handles.h"
#include "marks/point_set.h"

struct hrbfnpr_point_set : hrbfnpr::api::Child {
    hrbfnpr_point_set(hrbfnpr_context& context, hrbfnpr::marks::PointSet&& marks) noexcept
        : Child(context), set(std::move(marks)) {}

    const hrbfnpr::marks::PointSet set;
};

namespace hrbfnpr::api {

// Prepares a new set for frames, and makes a handle of it.
[[nodiscard]] hrbfnpr_point_set* adopt(hrbfnpr_context& context, marks::PointSet&& set);

} // namespace hrbfnpr::api
