// SPDX-License-Identifier: MIT
// Which parts of a model's surface its samples do not bear out: an open scan's surface goes on where the samples end,
// and a fit may grow sheets where there never were any.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "surface/trim.h"

#include <functional>
#include <limits>
#include <memory>

namespace hrbfnpr::generate {

struct TrimSettings {
    double limit = 1.5;   // of s (surface/support.h), at which the surface ends
    double hole = 0.05;   // diagonals: holes that nowhere are farther from the samples stay closed
    double closest = 0.0; // diagonals: samples are taken to be no nearer to each other than this
    // How far they are from the surface at most, where it was fitted to them.
    double off = std::numeric_limits<double>::infinity();
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

// The function for so many evaluations: a fast one may take some time to be made.
using ImplicitFor = std::function<const implicit::Implicit&(double evaluations, const base::Progress& progress)>;

// position, normal (unit): of the samples, one or more.  The surface is followed from them, on cells of half a spacing,
// as far as the box that marks may lie in.  Parts of it where s exceeds the limit are left out if they reach the end of
// that box, or if they are no mere hole between samples.  Where the samples are on the surface a
// first look goes only from those that are not surrounded by others (surface/surrounded.h), and no farther than the
// surface is borne out by such: where that finds nothing to leave out there is nothing.  Throws Error{not_converged}
// where nothing would be left.
[[nodiscard]] FoundTrim find_trim(const base::Runtime& runtime, const ImplicitFor& implicit_for,
                                  const geometry::VecArray& position, const geometry::VecArray& normal,
                                  const TrimSettings& settings, const base::Progress& progress);

} // namespace hrbfnpr::generate
