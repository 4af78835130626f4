// SPDX-License-Identifier: MIT
// Projection onto the surface by steepest descent on f^2 with Armijo's rule.   [NPAR 4.2]
// At a crease descent goes to and fro between sheets, by steps that become shorter: what has not come to an end by it
// goes on with the sheets that meet there.  Minima and maxima of parts have least |f| off the surface, too, as between
// two parts of an intersection: from there, and where a bound on |grad f| is known, the surface is searched for.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// Same numbers as HRBFNPR_PROJECTION_...
enum class ProjectionStatus : std::uint8_t { converged = 0, not_converged = 1, zero_gradient = 2, not_finite = 3 };

struct ProjectionSettings {
    std::int32_t evaluation_limit = 50; // evaluations per point
    double tolerance = 1e-9;            // on |f| / |grad f|, in diagonals
    double armijo_slope = 1e-4;
    double armijo_factor = 0.5;
};

// Whether that is the length of a gradient: others are lost when they are squared.
[[nodiscard]] inline bool is_slope(double length) noexcept { return length >= 1e-150 && length <= 1e150; }

// position: in, where to start; out, the last iterate.  gradient and status: out, resized.
// gradient is that of f (not unit) at the last iterate.
struct Projection {
    explicit Projection(base::Memory& memory) noexcept : position(memory), gradient(memory), status(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient;
    base::Array<ProjectionStatus> status;
};

// Projects all points on all threads.  The bits of a point do not depend on the others.
void project(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
             Projection& points);

} // namespace hrbfnpr::surface
