// SPDX-License-Identifier: MIT
// Finds where rays meet the surface: it marches in steps of |f| / L, and refines roots by Newton's method. [Hart 1996,
// "Sphere tracing"]
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <limits>

namespace hrbfnpr::surface {

// The values equal the constants HRBFNPR_RAY_*.
enum class RayStatus : std::uint8_t { hit = 0, miss = 1, truncated = 2, evaluation_limit = 3, not_finite = 4 };

struct RaySettings {
    std::int32_t maximum_hits = 1;         // the largest number of hits of a ray
    std::int32_t evaluation_limit = 20000; // the largest number of evaluations for a ray
    double t_min = 0.0;                    // in lengths of the direction vector
    double t_max = std::numeric_limits<double>::infinity();
    double lipschitz = 0.0;      // a bound on |grad f| in the search region; 0: lipschitz_estimate() is used
    double smallest_step = 1e-4; // in diagonals
    double tolerance = 1e-9;     // accuracy of a root's position, in diagonals
};

// Directions must be finite and not zero, but need not be unit vectors.
struct Rays {
    explicit Rays(base::Memory& memory) noexcept : origin(memory), direction(memory) {}

    geometry::VecArray origin;
    geometry::VecArray direction;
};

// Hit h of ray i is at index i * maximum_hits + h. Unused elements have an infinite t; their other members are zero.
struct RayHits {
    explicit RayHits(base::Memory& memory) noexcept
        : t(memory), position(memory), normal(memory), entering(memory), count(memory), status(memory) {}

    base::Array<double> t; // ascending for each ray; in lengths of the direction vector
    geometry::VecArray position;
    geometry::VecArray normal;          // the unit gradient; zero where the gradient is zero or not finite
    base::Array<std::uint8_t> entering; // 1 if f changes from + to - along the ray, else 0
    base::Array<std::int32_t> count;    // the number of hits of each ray
    base::Array<RayStatus> status;      // the status of each ray
};

// Casts all rays on all threads. Resizes `hits`. Each ray's result is the same bits, whatever other rays there are.
void cast_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
               const Rays& rays, RayHits& hits);

class RayCells;

// Does the same for the fit that `cells` were made for, by steps that take far fewer evaluations (search_rays.cpp).
// Most evaluations use prepared values. `implicit` sums over all centres, and it may have a domain. Roots that prepared
// values do not give within the tolerance are finished with it. settings.lipschitz is not used.
void cast_rays(const base::Work& work, const RayCells& cells, const implicit::Implicit& implicit,
               const RaySettings& settings, const Rays& rays, RayHits& hits);

} // namespace hrbfnpr::surface
