// SPDX-License-Identifier: MIT
// Projection onto the surface by steepest descent on f^2 with Armijo's rule. [NPAR 4.2] At a crease, descent alternates
// between sheets in ever shorter steps. Points that do not reach the surface are then projected onto the sheets that
// meet there (project_creases.h). Minima and maxima of several functions also have local minima of |f| off the surface,
// for example between the two solids of an intersection. For such points, and wherever a bound on |grad f| is known,
// the neighbourhood is searched for the surface (project_search.h).
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// The values equal the constants HRBFNPR_PROJECTION_*.
enum class ProjectionStatus : std::uint8_t { converged = 0, not_converged = 1, zero_gradient = 2, not_finite = 3 };

struct ProjectionSettings {
    std::int32_t evaluation_limit = 50; // the largest number of evaluations for a point
    double tolerance = 1e-9;            // the largest |f| / |grad f| of a converged point, in diagonals
    double armijo_slope = 1e-4;
    double armijo_factor = 0.5;
};

// Returns whether a gradient of this length can be used. The square of other lengths would underflow or overflow.
[[nodiscard]] inline bool is_usable_slope(double length) noexcept { return length >= 1e-150 && length <= 1e150; }

// The points. `position` is the start on input and the last iterate on output. `gradient` and `status` are resized.
// `gradient` is grad f at the last iterate, not normalised.
struct Projection {
    explicit Projection(base::Memory& memory) noexcept : position(memory), gradient(memory), status(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient;
    base::Array<ProjectionStatus> status;
};

// Projects all points on all threads. Each point's result is the same bits, whatever other points there are.
void project(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
             Projection& points);

} // namespace hrbfnpr::surface
