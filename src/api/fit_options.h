// SPDX-License-Identifier: MIT
#pragma once

#include "fit/fit.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// A fit's kernel, solver and regularization, for samples that the library chooses.  Throws Error{invalid_argument}
// where samples, or what says how to choose them, are given.
[[nodiscard]] fit::FitInput checked_options(const hrbfnpr_fit_desc& desc);

} // namespace hrbfnpr::api
