// SPDX-License-Identifier: MIT
// Provides painted values as the functions of tone, density and direction that the library calls.
//
// Each dab is a ball with a value. The dabs act one after the other. A dab changes the value v of each place inside the
// ball, unless the surface faces away there: v += strength (1 - d^2 / radius^2)^2 (value - v), at the distance d.
#pragma once

#include "geometry/vec.h"
#include "picture/memory.h"
#include "picture/style.h"

#include <hrbfnpr.h>

#include <memory>
#include <span>

namespace hrbfnpr::picture {

// The dabs of one map, in the order in which they were painted. A grid finds the dabs near a place.
class PaintedMap {
public:
    // Takes the elements of `dabs` that belong to this map (HRBFNPR_DAB_*).
    PaintedMap(std::span<const hrbfnpr_dab> dabs, std::uint32_t map, Pool& pool);
    PaintedMap(PaintedMap&&) noexcept = default;
    PaintedMap(const PaintedMap&) = delete; // A copy would allocate outside the pool.
    PaintedMap& operator=(const PaintedMap&) = delete;
    ~PaintedMap() = default;

    [[nodiscard]] bool empty() const noexcept { return dabs_.empty(); }
    // Applies all dabs to a value at a place with a normal, and returns the new value.
    [[nodiscard]] double pulled(double value, const glm::dvec3& place, const glm::dvec3& normal) const noexcept;
    // Returns the painted direction at a place, or 0 where no direction is painted.
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& place, const glm::dvec3& normal) const noexcept;
    // Returns whether both maps have the same dabs.
    [[nodiscard]] bool operator==(const PaintedMap& other) const noexcept;

private:
    struct CellDab {
        std::uint64_t cell;
        std::uint32_t dab;
    };
    [[nodiscard]] std::span<const CellDab> near(const glm::dvec3& place) const noexcept;

    Vector<hrbfnpr_dab> dabs_;
    Vector<CellDab> cells_; // sorted by cell, then by dab
    double cell_side_ = 1.0;
};

// A painted map, and the light that gives the tones before painting. The functions below receive it as `user`.
struct PaintedTone {
    PaintedMap map;
    glm::dvec3 light{0.0, 0.0, 1.0}; // a unit vector in world coordinates
    double exponent = 1.0;
    double fill = 0.0;
    bool is_lit = true; // If false, tones are 0 before painting.
};

// painted_tone() implements hrbfnpr_tone_fn, and its `user` is a PaintedTone. The others implement hrbfnpr_density_fn
// and hrbfnpr_direction_fn, and their `user` is a PaintedMap.
std::int32_t painted_tone(void* user, std::int64_t count, const float* positions, const float* normals,
                          float* tau) noexcept;
std::int32_t painted_density(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* density) noexcept;
std::int32_t painted_direction(void* user, std::int64_t count, const double* positions, const double* normals,
                               double* directions) noexcept;

// Makes a style and layers of marks use painted maps, and keep these maps alive. `camera` gives the direction of a
// light that moves with the camera. Throws Error{invalid_argument} if a light has no direction.
void set_paint(std::span<const hrbfnpr_dab> dabs, const hrbfnpr_camera& camera, Style& style, Marks& marks, Pool& pool);

} // namespace hrbfnpr::picture
