// SPDX-License-Identifier: MIT
// Projection onto the surface by steepest descent on f^2 with Armijo's rule.   [NPAR 4.2]
// At a crease descent goes back and forth between sheets, with ever shorter steps. Points that it does not bring onto
// the surface are then projected onto the sheets that meet there (project_creases.h). Minima and maxima of parts also
// have local minima of |f| off the surface, for example between two parts of an intersection. The surface is searched
// for around such points, and also where a bound on |grad f| is known (project_search.h).
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// The numbers equal those of HRBFNPR_PROJECTION_*
enum class ProjectionStatus : std::uint8_t { converged = 0, not_converged = 1, zero_gradient = 2, not_finite = 3 };

struct ProjectionSettings {
    std::int32_t evaluation_limit = 50; // evaluations per point
    double tolerance = 1e-9;            // on |f| / |grad f|, in diagonals
    double armijo_slope = 1e-4;
    double armijo_factor = 0.5;
};

// Tells whether a gradient of this length can be used: the squares of others underflow or overflow.
[[nodiscard]] inline bool is_usable_slope(double length) noexcept { return length >= 1e-150 && length <= 1e150; }

// `position` is the start on input, and the last iterate on output. `gradient` and `status` are resized. `gradient` is
// that of f (not unit) at the last iterate.
struct Projection {
    explicit Projection(base::Memory& memory) noexcept : position(memory), gradient(memory), status(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient;
    base::Array<ProjectionStatus> status;
};

// Projects all points on all threads. A point's result does not depend on the other points, bit for bit.
void project(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
             Projection& points);

} // namespace hrbfnpr::surface
