// SPDX-License-Identifier: MIT
// Finds where rays meet the surface: steps of |f| / L, then roots by Newton's method.   [Hart 1996, "Sphere tracing"]
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <limits>

namespace hrbfnpr::surface {

// The numbers equal those of HRBFNPR_RAY_*
enum class RayStatus : std::uint8_t { hit = 0, miss = 1, truncated = 2, evaluation_limit = 3, not_finite = 4 };

struct RaySettings {
    std::int32_t maximum_hits = 1;         // per ray
    std::int32_t evaluation_limit = 20000; // evaluations per ray
    double t_min = 0.0;                    // in lengths of the direction vector
    double t_max = std::numeric_limits<double>::infinity();
    double lipschitz = 0.0;      // bound on |grad f| in the search region; 0 = lipschitz_estimate()
    double smallest_step = 1e-4; // in diagonals
    double tolerance = 1e-9;     // accuracy of a root's position, in diagonals
};

// Directions are finite and not zero. They need not be unit vectors.
struct Rays {
    explicit Rays(base::Memory& memory) noexcept : origin(memory), direction(memory) {}

    geometry::VecArray origin;
    geometry::VecArray direction;
};

// Hit h of ray i is element i * maximum_hits + h. Unused elements have an infinite t and zeros.
struct RayHits {
    explicit RayHits(base::Memory& memory) noexcept
        : t(memory), position(memory), normal(memory), entering(memory), count(memory), status(memory) {}

    base::Array<double> t; // ascending per ray; in lengths of the direction vector
    geometry::VecArray position;
    geometry::VecArray normal;          // the unit gradient; zero where the gradient is zero or not finite
    base::Array<std::uint8_t> entering; // 1: f changes from + to - along the ray
    base::Array<std::int32_t> count;    // hits per ray
    base::Array<RayStatus> status;      // per ray
};

// Casts all rays on all threads, and resizes `hits`. A ray's result does not depend on the other rays, bit for bit.
void cast_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
               const Rays& rays, RayHits& hits);

} // namespace hrbfnpr::surface
