// SPDX-License-Identifier: MIT
// Models that end where what they were fitted to does.
#pragma once

#include "api/model.h"

namespace hrbfnpr::api {

// Takes a model that was just fitted to the samples; the one with its end, or, where nothing is to be left out or that
// cannot be told, which is logged, the same one.
[[nodiscard]] hrbfnpr_model* ended_model(hrbfnpr_model* fitted, const geometry::VecArray& position,
                                         const geometry::VecArray& normal, const generate::TrimSettings& settings,
                                         const base::Progress& progress);

} // namespace hrbfnpr::api
