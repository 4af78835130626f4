// SPDX-License-Identifier: MIT
// The handle of a field.
#pragma once

#include "api/handles.h"
#include "paint/field.h"

struct hrbfnpr_field : hrbfnpr::api::Child {
    // The field may look at `hiding`, which may be NULL.
    hrbfnpr_field(hrbfnpr_context& context, hrbfnpr::paint::Field&& made, const hrbfnpr_occluders* hiding) noexcept;
    ~hrbfnpr_field();

    const hrbfnpr::paint::Field field;

private:
    const hrbfnpr_occluders* occluders_;
};
