// SPDX-License-Identifier: MIT
// Where rays meet the surface: steps of |f| / L, then roots by Newton.   [Hart 1996, "Sphere tracing"]
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <limits>

namespace hrbfnpr::surface {

// Same numbers as HRBFNPR_RAY_...
enum class RayStatus : std::uint8_t { hit = 0, miss = 1, truncated = 2, evaluation_limit = 3, not_finite = 4 };

struct RaySettings {
    std::int32_t maximum_hits = 1;         // per ray
    std::int32_t evaluation_limit = 20000; // evaluations per ray
    double t_min = 0.0;                    // in lengths of the direction
    double t_max = std::numeric_limits<double>::infinity();
    double lipschitz = 0.0;      // bound on |grad f| in the search region; 0 = lipschitz_estimate()
    double smallest_step = 1e-4; // in diagonals
    double tolerance = 1e-9;     // on the place of a root, in diagonals
};

// Directions are finite, not zero, and of any length.
struct Rays {
    explicit Rays(base::Memory& memory) noexcept : origin(memory), direction(memory) {}

    geometry::VecArray origin;
    geometry::VecArray direction;
};

// Hit h of ray i is element i * maximum_hits + h; those that there are not have t infinite and zeros.
struct RayHits {
    explicit RayHits(base::Memory& memory) noexcept
        : t(memory), position(memory), normal(memory), entering(memory), count(memory), status(memory) {}

    base::Array<double> t; // rising; in lengths of the direction
    geometry::VecArray position;
    geometry::VecArray normal;          // the unit gradient; zero where there is none
    base::Array<std::uint8_t> entering; // 1: f goes from + to - along the ray
    base::Array<std::int32_t> count;    // of each ray
    base::Array<RayStatus> status;      // of each ray
};

// Casts all rays on all threads; hits is resized.  The bits of a ray do not depend on the others.
void cast_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
               const Rays& rays, RayHits& hits);

} // namespace hrbfnpr::surface
