// SPDX-License-Identifier: MIT
// What every stage of the sampling works on: the surface, seeds, the caller's directions, and how a point comes to rest
// on the surface.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"
#include "surface/project.h"

#include <limits>

namespace hrbfnpr::marks {

struct Site {
    const base::Runtime& runtime;
    const implicit::Implicit& implicit;
    double projection_tolerance; // in diagonals
    std::uint64_t random_seed;
    double unit = 1.0; // the unit of all lengths here, in the caller's unit

    [[nodiscard]] base::Memory& memory() const noexcept { return runtime.memory; }
};

// A stage handles this many points at a time, which bounds its scratch memory and the time between two looks for a
// cancel, and is enough work for all threads.
inline constexpr std::int64_t chunk_size = 16384;

// Projects a chunk of points and keeps those that converged near where they started.
class Settler {
public:
    explicit Settler(const Site& site) noexcept
        : start(site.memory()), site_(site), projection_(site.memory()), placed_(site.memory()) {}

    // Every start is counted in `report` as attempted and as placed or as dropped; one is dropped
    // as strayed if it lands farther than `stray_limit` from its start.
    void settle(double stray_limit, LevelReport& report, const base::Progress& progress);

    [[nodiscard]] bool placed(std::int64_t i) const noexcept { return placed_[i] != 0; }
    [[nodiscard]] glm::dvec3 position(std::int64_t i) const noexcept { return projection_.position[i]; }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const noexcept;
    // Takes back a placed point.
    void drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept;

    geometry::VecArray start; // filled by the caller

private:
    static constexpr std::uint8_t beyond = 2;

    void drop_beyond_end(LevelReport& report);

    const Site& site_;
    surface::Projection projection_;
    base::Array<std::uint8_t> placed_;
};

// Value and gradient at all points, on all threads.
struct FieldSamples {
    explicit FieldSamples(base::Memory& memory) noexcept : value(memory), gradient(memory) {}

    base::Array<double> value;
    geometry::VecArray gradient;

    // The distance to the surface to first order, f / |grad f|; infinite or NaN where that makes no sense, as where
    // the square of the gradient overflows or vanishes.
    [[nodiscard]] double distance(std::int64_t i) const noexcept {
        const double slope = glm::length(gradient[i]);
        return surface::is_slope(slope) ? value[i] / slope : std::numeric_limits<double>::quiet_NaN();
    }
};
void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields, const base::Progress& progress);

// Where marks start from.                                             [NPAR 4.2, 5.1]
struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // on the surface
    geometry::VecArray normal;   // unit
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0: as set, or the estimate for this source
};

// The caller's field of directions.
using DirectionFn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                     double* directions);

struct DirectionFunction {
    DirectionFn function = nullptr;
    void* user = nullptr;

    [[nodiscard]] bool operator==(const DirectionFunction& other) const noexcept = default;
};

// The unit part of d in the plane across n; 0: d has hardly a part there.
[[nodiscard]] glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept;

// Fills in unit tangents, or zero where the field has none. Calls the function on the thread that it is called on.
// Throws Error{callback}.
void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions, const base::Progress& progress);

// Diagonals of what marks, which are floats, can be placed on: their distances and curvatures, in the caller's unit,
// stay within a float's normal range.
inline constexpr double smallest_size = 1e-33;
inline constexpr double largest_size = 1e33;

// Throws Error{invalid_argument} for sizes beyond; `what` has that size, and `remedy` is scaled.
void require_size(const char* what, double size, const char* remedy);

} // namespace hrbfnpr::marks
