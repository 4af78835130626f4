// SPDX-License-Identifier: MIT
// Finds the noisy sample that represents its neighbours best.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "geometry/neighbours.h"

namespace hrbfnpr::fit {

// Returns for each sample the one among it and its neighbours that agrees best with the samples around it in position
// and normal. The samples that a fit misses most are also the noisiest, as a scan's rims have normals of all
// directions. So they should not become centres themselves.
[[nodiscard]] base::Array<std::int64_t> typical_samples(const base::Work& work, const Samples& samples,
                                                        const geometry::Neighbours& neighbours);

} // namespace hrbfnpr::fit
