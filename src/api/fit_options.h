// SPDX-License-Identifier: MIT
#pragma once

#include "fit/fit.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Returns kernel, solver and regularization of a fit whose samples the library chooses.  Throws Error{invalid_argument}
// if samples, or settings for their choice, are given.
[[nodiscard]] fit::FitInput checked_options(const hrbfnpr_fit_desc& desc);

} // namespace hrbfnpr::api
