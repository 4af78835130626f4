// SPDX-License-Identifier: MIT
// The part of a ray that lies in the search region, and the results of a ray that has no hits yet.
#pragma once

#include "surface/cast_rays.h"

namespace hrbfnpr::surface {

// s is the distance from the start.
struct RayRange {
    glm::dvec3 start{0.0};
    glm::dvec3 direction{0.0}; // unit vector
    double length = 1.0;       // length of the direction vector as given by the caller
    double offset = 0.0;       // distance from the origin as given by the caller to the start
    double end = 0.0;          // s at the end of the search
    bool empty = true;         // whether the ray does not meet the region

    [[nodiscard]] glm::dvec3 at(double s) const noexcept { return start + s * direction; }
};

[[nodiscard]] RayRange range_in(const geometry::Bounds& region, const RaySettings& settings, const glm::dvec3& origin,
                                const glm::dvec3& direction) noexcept;

// Makes room for the hits of `count` rays.
void resize(RayHits& hits, std::int64_t count, const RaySettings& settings);
// Sets the results of the rays [begin, end) to no hits.
void clear(RayHits& hits, const RaySettings& settings, std::int64_t begin, std::int64_t end) noexcept;
// Stores hit number h of a ray at the distance s from its start, where the gradient of f is g.
void store_hit(RayHits& hits, const RaySettings& settings, std::int64_t ray, std::int32_t h, const RayRange& range,
               double s, const glm::dvec3& g, bool entering) noexcept;

// Copies the hits of a ray to another ray. maximum_hits is the same for both.
void copy_ray(const RayHits& from, std::int64_t ray, std::int64_t to_ray, const RaySettings& settings, RayHits& to);

// Casts the rays of the list `which` by marching, and stores their hits. `lipschitz` is the bound on |grad f|.
void march_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
                double lipschitz, const Rays& rays, const std::int32_t* which, std::int64_t count, RayHits& hits);

} // namespace hrbfnpr::surface
