// SPDX-License-Identifier: MIT
// Cubic Bezier curves through points.
#pragma once

#include "base/memory.h"
#include "geometry/vec.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::output {

// From where the one before it ends.
struct Cubic {
    glm::dvec2 control_1, control_2, end;
};

// Fits by least squares, halves where that is not near enough [Schneider 1990, "An algorithm for automatically fitting
// digitized curves", Graphics Gems].  Points where the line turns by more than 40 degrees stay corners.
class CurveFit {
public:
    explicit CurveFit(base::Memory& memory) noexcept : points_(memory), places_(memory), cubics_(memory) {}

    // All of the line through the points lies within the tolerance of the curves, and their ends are points of it.
    // closed: the last point stands where the first one does, and the curves go round without a corner unless there is
    // one.  Valid until the next call; empty if all points are in one place.
    std::span<const Cubic> fit(std::span<const glm::dvec2> points, double tolerance, bool closed);

private:
    void densify(std::span<const glm::dvec2> points);
    void fit_run(std::int64_t first, std::int64_t last, const glm::dvec2& from, const glm::dvec2& to, int depth);
    [[nodiscard]] Cubic least_squares(std::int64_t first, std::int64_t last, const glm::dvec2& from,
                                      const glm::dvec2& to) const noexcept;
    [[nodiscard]] double farthest(std::int64_t first, std::int64_t last, const Cubic& cubic,
                                  std::int64_t& where) const noexcept;
    void set_places(std::int64_t first, std::int64_t last) noexcept;
    void improve_places(std::int64_t first, std::int64_t last, const Cubic& cubic) noexcept;
    [[nodiscard]] glm::dvec2 direction(std::int64_t from, std::int64_t to) const noexcept;
    [[nodiscard]] glm::dvec2 direction_from(std::int64_t end, std::int64_t other) const noexcept;
    [[nodiscard]] glm::dvec2 direction_at(std::int64_t i, std::int64_t first, std::int64_t last) const noexcept;
    [[nodiscard]] bool is_corner(std::int64_t before, std::int64_t i, std::int64_t after) const noexcept;

    double square_ = 0.0; // of the tolerance
    base::Array<glm::dvec2> points_;
    base::Array<double> places_; // of points on the curve that is fitted, 0 to 1
    base::Array<Cubic> cubics_;
};

} // namespace hrbfnpr::output
