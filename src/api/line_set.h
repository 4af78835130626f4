// SPDX-License-Identifier: MIT
// The handle of a line set. It keeps the model.
#pragma once

#include "api/model.h"
#include "features/line_set.h"

struct hrbfnpr_line_set : hrbfnpr::api::Child {
    hrbfnpr_line_set(hrbfnpr_context& context, const hrbfnpr_model& of,
                     const hrbfnpr::curves::LineSetSettings& settings, const hrbfnpr::base::Progress& progress);
    ~hrbfnpr_line_set();

    const hrbfnpr_model& model;
    const hrbfnpr::curves::LineSet lines;
};
