// SPDX-License-Identifier: MIT
// Points on curves f = g = 0, and Newton's steps to them.
#pragma once

#include "curves/level.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::curves {

// What is known at a place near a curve.
struct CurvePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 gradient{0.0};       // of f
    glm::dvec3 level_gradient{0.0}; // of g
    double value = 0.0;             // f
    double level = 0.0;             // g

    // Along the curve, negative g to the left; not unit.
    [[nodiscard]] glm::dvec3 direction() const noexcept { return glm::cross(gradient, level_gradient); }
    // The shortest way to f = g = 0 as both are linear: -J^T (J J^T)^-1 (f, g).  Not finite where there is none.
    [[nodiscard]] glm::dvec3 newton_step() const noexcept;
};

// All at their positions, on all threads.
void evaluate(const base::Runtime& runtime, const Level& level, base::Array<CurvePoint>& points,
              const base::Progress& progress);

// Points of cubics onto their curves, by so many of Newton's steps.  Adds up evaluations.
void bring_close(const base::Runtime& runtime, const Level& level, int steps, base::Array<CurvePoint>& points,
                 std::int64_t& evaluations, const base::Progress& progress);

// The same by one step, and by a second one where that was longer than `enough`, of each point.
void bring_closer(const base::Runtime& runtime, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations, const base::Progress& progress);

struct NewtonSettings {
    double tolerance = 0.0; // a step that is shorter is the last one; a longer one if the next would be nothing
    double farthest = 0.0;  // from where a point began
    int steps = 12;
};

// Brings points onto the curve, all at once; `found` is 1 where that succeeded.  Returns how many evaluations it took.
std::int64_t bring_to_curve(const base::Runtime& runtime, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found,
                            const base::Progress& progress);

} // namespace hrbfnpr::curves
