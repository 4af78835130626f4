// SPDX-License-Identifier: MIT
// Lines that lie on a surface whatever the camera, as curves with a strength along them; and the parts of them that
// face a camera.
#pragma once

#include "curves/curves.h"
#include "curves/level.h"

namespace hrbfnpr::curves {

// CurvePoint::direction() runs along the line, and `gradient` is the surface's normal; f and g mean nothing.
struct SurfaceLines {
    explicit SurfaceLines(base::Memory& memory) : curves(memory), strength(memory) {}

    Curves curves;
    base::Array<float> strength; // the strength at each point

    [[nodiscard]] std::int64_t bytes() const noexcept { return curves.bytes() + strength.bytes(); }
};

// The tangent at a point of the circle through it and the points before and after it, by the ways to it and on from it;
// the nearer point counts more. It is not unit.
[[nodiscard]] inline glm::dvec3 tangent_between(const glm::dvec3& in, const glm::dvec3& out) noexcept {
    const double a = glm::dot(in, in);
    const double b = glm::dot(out, out);
    return a > 0.0 && b > 0.0 ? in / a + out / b : in + out;
}

// Adds lines point by point.
class LineBuilder {
public:
    // as_given: tangents are kept and normals made perpendicular to them, since the lines need not lie on the surface;
    // else it is the other way round.
    explicit LineBuilder(SurfaceLines& lines, bool as_given = false) noexcept : lines_(lines), as_given_(as_given) {}

    // A point in the place of the last one is left out. tangent: where it is known, of any length; 0: from the points.
    void add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
             const glm::dvec3& tangent = glm::dvec3(0.0));
    // The same of a point of other lines.
    void add(const SurfaceLines& from, std::int64_t point);
    // Ends the line, which is dropped if it has less than two points.
    void end(bool closed);

private:
    SurfaceLines& lines_;
    bool as_given_;
};

// The parts of lines whose points have a value below 0, or those whose points have not, by one value for each point;
// they end where it is 0 by interpolation. as_given: as LineBuilder has it.
[[nodiscard]] SurfaceLines parts_where(const SurfaceLines& lines, const base::Array<double>& value, bool below,
                                       bool as_given);
// The parts that show their outside to the eye, or those that show their inside; they end where the line of sight is
// tangent to the surface, by the normals that the lines have.
[[nodiscard]] SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view,
                                        bool outside);
// The lines with a point more on each piece that turns over, where grad f at the piece is perpendicular to the line of
// sight: parts that begin and end there fit to contours that end there.
[[nodiscard]] SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines,
                                      const implicit::Implicit& surface, const View& view);

} // namespace hrbfnpr::curves
