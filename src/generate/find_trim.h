// SPDX-License-Identifier: MIT
// Where a surface ends: the parts of it that its samples do not bear out, and the box of one that closes beyond them.
// An open scan's surface goes on where the samples end, and a fit may grow sheets where there never were any.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "surface/support_domain.h"

#include <functional>
#include <limits>
#include <memory>

namespace hrbfnpr::generate {

struct TrimSettings {
    double limit = 1.5;   // the surface ends where s (surface/support.h) is above this
    double hole = 0.05;   // diagonals: holes whose points are all within this distance of a sample stay closed
    double closest = 0.0; // diagonals: samples are taken to be no nearer to each other than this
    // The most that samples are off the surface, where it was fitted to them.
    double off = std::numeric_limits<double>::infinity();
};

struct TrimReport {
    std::int64_t samples = 0;
    std::int64_t parts = 0;        // connected parts that are left out
    std::int64_t parts_to_end = 0; // those of `parts` that reach the end of the search box
    double share = 0.0;            // their share of the surface's area in the box
    double farthest = 0.0;         // the farthest of their places from the nearest sample
    double spacing = 0.0;          // the median of the samples' spacings (h of surface/support.h)
};

struct FoundTrim {
    std::unique_ptr<surface::SupportDomain> trim; // null: all of the surface stays
    TrimReport report;
};

// The function for a number of evaluations: a fast one may take some time to be made.
using ImplicitFor = std::function<const implicit::Implicit&(double evaluations, const base::Progress& progress)>;

// position, normal (unit): of the samples, one or more.
//
// 1. Where the samples are on the surface, a first look follows it only from those that are not surrounded by others
//    (surface/surrounded.h), and no farther than the surface is borne out by surrounded ones: where that finds nothing
//    to leave out, all stays.
// 2. The surface is followed from all samples, on cells of half a spacing, as far as the box that marks may lie in.
// 3. Cells where s exceeds the limit form parts. A part is left out if it reaches the end of the box, or if it is no
//    mere hole between samples.
//
// Throws Error{not_converged} where nothing would be left.
[[nodiscard]] FoundTrim find_trim(const base::Work& work, const ImplicitFor& implicit_for,
                                  const geometry::VecArray& position, const geometry::VecArray& normal,
                                  const TrimSettings& settings);

// The box of a surface through samples at `position`. It is the implicit's own one, but for 20 000 samples along curves
// at most: between wires and beyond the first and last of cross sections their surface bulges out of it. Where it
// closes within a third of a diagonal around them, the box is that of both.
[[nodiscard]] geometry::Bounds closed_bounds(const base::Work& work, const implicit::Implicit& implicit,
                                             const geometry::VecArray& position);

} // namespace hrbfnpr::generate
