// SPDX-License-Identifier: MIT
// Finds where marks start from.                                       [NPAR 4.2, 5.1]
#pragma once

#include "generate/settings.h"
#include "marks/site.h"

namespace hrbfnpr::generate {

// Throws not_converged if none reaches the surface.
[[nodiscard]] marks::Seeds make_seeds(const marks::Site& site, const SampleHint& samples, const Settings& settings,
                                      const base::Progress& progress);

} // namespace hrbfnpr::generate
