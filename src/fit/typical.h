// SPDX-License-Identifier: MIT
// Which of some neighbouring noisy samples stands for them best.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "geometry/neighbours.h"

namespace hrbfnpr::fit {

// For each sample, the one of it and its neighbours that agrees best with those around it in position and normal.
// What is worst off a fit is the worst of the noise, too: a scan's rims have normals of all directions.
[[nodiscard]] base::Array<std::int64_t> typical_samples(const base::Work& work, const Samples& samples,
                                                        const geometry::Neighbours& neighbours);

} // namespace hrbfnpr::fit
