// SPDX-License-Identifier: MIT
// Models whose surface ends where the samples of their fit end.
#pragma once

#include "api/model.h"

namespace hrbfnpr::api {

// Trims a model that was just fitted to the samples, and returns the trimmed model. Returns the given model if nothing
// is left out, or if the end of the surface cannot be found, which is logged.
[[nodiscard]] hrbfnpr_model* ended_model(hrbfnpr_model* fitted, const geometry::VecArray& position,
                                         const geometry::VecArray& normal, const generate::TrimSettings& settings,
                                         const base::Progress& progress);

} // namespace hrbfnpr::api
