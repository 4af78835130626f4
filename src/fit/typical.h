// SPDX-License-Identifier: MIT
// Finds the noisy sample that represents its neighbours best.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "geometry/neighbours.h"

namespace hrbfnpr::fit {

// Returns the index of the typical sample for each sample. The typical sample is the sample itself or a neighbour,
// whichever agrees best in position and normal with the samples around it. The samples with the largest errors are
// often the noisiest, for example at the rims of a scan, so they should not become centres.
[[nodiscard]] base::Array<std::int64_t> typical_samples(const base::Work& work, const Samples& samples,
                                                        const geometry::Neighbours& neighbours);

} // namespace hrbfnpr::fit
