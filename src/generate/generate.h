// SPDX-License-Identifier: MIT
// Placing marks on an implicit surface.                              [NPAR 4.2, 5]
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "base/view.h"
#include "generate/settings.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"

namespace hrbfnpr::generate {

// What can be refused before any work: sizes that floats do not hold, and lengths that make no sense beside the
// model's.  generate() and step_patches() check it themselves.
void check_request(const implicit::Implicit& implicit, const Settings& settings);

// A set that is ready for frames.  Throws Error{invalid_argument, not_converged, out_of_memory, cancelled, callback}.
[[nodiscard]] marks::PointSet generate(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                       const SampleHint& samples, const Settings& given,
                                       const base::Progress& progress);

// Of the implicit, roughly, by completed() settings.
[[nodiscard]] double expected_evaluations(const SampleHint& samples, const Settings& settings) noexcept;

// Figure 5: `corners.count` squares of side 2 rho_0 in tangent planes of random seeds,
// 12 numbers each.  Returns rho_0.
double step_patches(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                    const Settings& given, const base::OutView& corners, const base::Progress& progress);

} // namespace hrbfnpr::generate
