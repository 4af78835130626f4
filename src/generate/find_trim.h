// SPDX-License-Identifier: MIT
// Finds where a surface ends: the parts of it that its samples do not support, and the box of a surface that closes
// beyond its samples. An open scan's surface continues where the samples end, and a fit may grow sheets where there
// never were any samples.
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
    double limit = 1.5; // the largest s (surface/support.h) at a place that samples support
    double hole = 0.05; // in diagonals: a hole stays closed if all its points are within this distance of a sample
    // In diagonals: spacings of samples that are smaller than this are raised to it.
    double closest = 0.0;
    // The largest distance of a sample from the surface, in units of the object. Infinite if the distance is unknown,
    // because the surface was not fitted to these samples.
    double off = std::numeric_limits<double>::infinity();
};

struct TrimReport {
    std::int64_t samples = 0;
    std::int64_t parts = 0;        // the number of connected parts that are left out
    std::int64_t parts_to_end = 0; // the number of connected left-out parts that reach the end of the search box
    double share = 0.0;            // the left-out share of the surface in the box
    double farthest = 0.0;         // the largest distance of a left-out place from the nearest sample
    double spacing = 0.0;          // the median of the samples' spacings (h of surface/support.h)
};

struct FoundTrim {
    std::unique_ptr<surface::SupportDomain> trim; // null: the whole surface stays
    TrimReport report;
};

// Returns the implicit function to use for an expected number of evaluations. The call may prepare a faster function
// first, which takes time.
using ImplicitFor = std::function<const implicit::Implicit&(double evaluations, const base::Progress& progress)>;

// Finds the parts of a surface to leave out. `position` and `normal` (unit) are those of one or more samples.
//
// 1. If the samples are on the surface, a first look follows the surface only from samples that are not surrounded by
// others (surface/surrounded.h). The look stops where surrounded samples support the surface. If the look finds nothing
// to leave out, the whole surface stays.
// 2. The surface is followed from all samples, on cells of half a spacing, within the box in which marks may lie.
// 3. Connected cells where s exceeds the limit form parts. A part is left out if it reaches the end of the box, or if
// it is larger than a hole between samples.
//
// Throws Error{not_converged} if nothing would be left.
[[nodiscard]] FoundTrim find_trim(const base::Work& work, const ImplicitFor& implicit_for,
                                  const geometry::VecArray& position, const geometry::VecArray& normal,
                                  const TrimSettings& settings);

// Returns the bounding box of a surface through samples at `position`. In most cases, this is the box of the implicit
// function. If samples lie along curves, and there are at most 20000 of them, or if there are at most 100, the surface
// may bulge out of the function's box: between the curves of a wire frame, outside the first and last of several cross
// sections, or between a few points. In this case, if the surface closes within a third of a diagonal around the
// samples, the result contains both the function's box and the closed surface.
[[nodiscard]] geometry::Bounds closed_bounds(const base::Work& work, const implicit::Implicit& implicit,
                                             const geometry::VecArray& position);

} // namespace hrbfnpr::generate
