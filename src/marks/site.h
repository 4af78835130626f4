// SPDX-License-Identifier: MIT
// What every stage of the sampling works on, and how a point comes to rest on the surface.
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
    double unit = 1.0; // of all lengths, in the caller's

    [[nodiscard]] base::Memory& memory() const noexcept { return runtime.memory; }
};

// Points that a stage handles at a time: bounds its scratch memory and the time between two
// looks for a cancel, and is enough work for all threads.
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
    // the gradient is so long or short that its square does not say how long.
    [[nodiscard]] double distance(std::int64_t i) const noexcept {
        const double slope = glm::length(gradient[i]);
        return surface::is_slope(slope) ? value[i] / slope : std::numeric_limits<double>::quiet_NaN();
    }
};
void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields, const base::Progress& progress);

} // namespace hrbfnpr::marks
