// SPDX-License-Identifier: MIT
#include "marks/direction_function.h"

#include "geometry/unit.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr std::int64_t call_size = 4096;

// d in the plane across n, unit; zero if it has hardly a part there.
glm::dvec3 in_plane(const glm::dvec3& d, const glm::dvec3& n) noexcept {
    const double longest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if (!(longest > 0.0)) return glm::dvec3(0.0);
    const glm::dvec3 moderate = d / geometry::unit_for(longest);
    const glm::dvec3 flat = moderate - glm::dot(moderate, n) * n;
    const double length = glm::length(flat);
    return length > 1e-6 * glm::length(moderate) ? flat / length : glm::dvec3(0.0);
}

} // namespace

void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions, const base::Progress& progress) {
    const std::int64_t all = positions.size();
    directions.resize(all);
    progress.check();
    base::Array<double> packed(site.memory(), 9 * std::min(all, call_size));
    for (std::int64_t begin = 0; begin < all; begin += call_size) {
        progress.update(static_cast<double>(begin) / static_cast<double>(all));
        const std::int64_t count = std::min(call_size, all - begin);
        double* const places = packed.data();
        double* const sides = places + 3 * count;
        double* const result = sides + 3 * count;
        for (std::int64_t i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c) {
                places[3 * i + c] = site.unit * positions[begin + i][c];
                sides[3 * i + c] = normals[begin + i][c];
                result[3 * i + c] = 0.0;
            }
        if (const std::int32_t code = field.function(field.user, count, places, sides, result); code != 0)
            fail(Status::callback, "direction_function returned %d; it must return 0 unless it failed",
                 static_cast<int>(code));
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 d(result[3 * i], result[3 * i + 1], result[3 * i + 2]);
            if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z))
                fail(Status::callback,
                     "direction_function gave %g %g %g as a direction; it must be finite, or 0 0 0 where there is none",
                     d.x, d.y, d.z);
            directions.set(begin + i, in_plane(d, normals[begin + i]));
        }
    }
}

} // namespace hrbfnpr::marks
