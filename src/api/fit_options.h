// SPDX-License-Identifier: MIT
#pragma once

#include "fit/fit.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Returns the kernel, solver and regularization for a fit whose samples the library chooses. Throws
// Error{invalid_argument} if the caller gives samples, or settings for choosing samples.
[[nodiscard]] fit::FitInput checked_options(const hrbfnpr_fit_desc& desc);

} // namespace hrbfnpr::api
