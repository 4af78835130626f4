// SPDX-License-Identifier: MIT
// Which parts of a model's surface its samples do not bear out: an open scan's surface goes on where the samples end,
// and a fit may grow sheets where there never were any.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "surface/trim.h"

#include <memory>

namespace hrbfnpr::generate {

struct TrimSettings {
    double limit = 1.5;   // of s (surface/support.h), at which the surface ends
    double hole = 0.05;   // diagonals: holes that nowhere are farther from the samples stay closed
    double closest = 0.0; // diagonals: samples are taken to be no nearer to each other than this
};

struct TrimReport {
    std::int64_t samples = 0;
    std::int64_t parts = 0;        // connected ones, that are left out
    std::int64_t parts_to_end = 0; // of these, those that reach the end of the search box
    double share = 0.0;            // of the surface's area in the box
    double farthest = 0.0;         // of the places left out from the nearest sample
    double spacing = 0.0;          // of the samples, the median
};

struct FoundTrim {
    std::unique_ptr<surface::Trim> trim; // null: all of the surface stays
    TrimReport report;
};

// position, normal (unit): of the samples, one or more.  The surface is followed from them, on cells of half a spacing,
// as far as the box that marks may lie in.  Parts of it where s exceeds the limit are left out if they reach the end of
// that box, or if they are no mere hole between samples.  Throws Error{not_converged} where nothing would be left.
[[nodiscard]] FoundTrim find_trim(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                  const geometry::VecArray& position, const geometry::VecArray& normal,
                                  const TrimSettings& settings, const base::Progress& progress);

} // namespace hrbfnpr::generate
