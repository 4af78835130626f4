// SPDX-License-Identifier: MIT
// Places marks on an implicit surface. [NPAR 4.2, 5]
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "generate/settings.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"
#include "marks/site.h"

namespace hrbfnpr::generate {

// Checks sizes and lengths before any work. Throws if floats cannot hold a size, or if a length makes no sense for the
// model's size. generate() and step_patches() call it, too.
void check_request(const implicit::Implicit& implicit, const Settings& settings);

// Finds the seeds from which marks start. Throws Error{not_converged} if no seed reaches the surface. `settings` must
// come from completed().
[[nodiscard]] marks::Seeds make_seeds(const marks::Site& site, const SampleHint& samples, const Settings& settings);

// Makes a set that is ready for frames, in the model's unit:
//
// 1. make_seeds() projects samples, given points or a jittered grid (seeds.cpp).
// 2. Each layer grows from the seeds: by the published recursions, or as even stipples (stipples) and lines (hatching).
// 3. Normals are softened for tone, and the layers are assembled, scaled to the caller's unit, and clustered.
//
// Throws Error{invalid_argument, not_converged, out_of_memory, cancelled, callback}.
[[nodiscard]] marks::PointSet generate(const base::Work& work, const implicit::Implicit& implicit,
                                       const SampleHint& samples, const Settings& given);

// Returns roughly how many evaluations of the implicit function generate() needs. `settings` must come from
// completed().
[[nodiscard]] double expected_evaluations(const SampleHint& samples, const Settings& settings) noexcept;

// Writes the squares of [NPAR Figure 5]: `corners.count` squares with sides of 2 rho_0 in the tangent planes of random
// seeds, 12 numbers each. Returns rho_0.
double step_patches(const base::Work& work, const implicit::Implicit& implicit, const SampleHint& samples,
                    const Settings& given, const base::OutView& corners);

} // namespace hrbfnpr::generate
