// SPDX-License-Identifier: MIT
// Point-normal samples of analytic shapes, well spread and the same on every machine.
#pragma once

#include "support/samples.h"

namespace scenes {

using hrbfnpr::test::Samples;
using hrbfnpr::test::sphere_6;
using hrbfnpr::test::torus;

// Two linked tori with `count` samples each.
[[nodiscard]] Samples linked_tori(int count);
// A tube of radius 0.35 about the trefoil (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t).
[[nodiscard]] Samples trefoil(int count);

// Taubin's heart as a function for hrbfnpr_model_create_custom, with its gradient.
int taubin_heart(void* user, long long count, const double* points, double* value, double* gradient, double* hessian);

} // namespace scenes
