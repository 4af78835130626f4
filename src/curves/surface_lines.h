// SPDX-License-Identifier: MIT
// Lines that lie on a surface whatever the camera, as curves with a strength along them; and the parts of them that
// face a camera.
#pragma once

#include "curves/curves.h"
#include "curves/view.h"

namespace hrbfnpr::curves {

// CurvePoint::direction() runs along the line, and `gradient` is the surface's normal; f and g mean nothing.
struct SurfaceLines {
    explicit SurfaceLines(base::Memory& memory) noexcept : curves(memory), strength(memory) {}

    Curves curves;
    base::Array<float> strength; // of each point

    [[nodiscard]] std::int64_t bytes() const noexcept { return curves.bytes() + strength.bytes(); }
};

// Points one after the other, with normals; closed or not.
class LineBuilder {
public:
    // as_given: of lines that need not lie on the surface tangents are kept, and normals made perpendicular to them;
    // else it is the other way round.
    explicit LineBuilder(SurfaceLines& lines, bool as_given = false);

    // tangent: where it is known, of any length; 0: from the points.
    void add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
             const glm::dvec3& tangent = glm::dvec3(0.0));
    // Ends the line.  Of less than two points it is none.
    void end(bool closed);

private:
    SurfaceLines& lines_;
    bool as_given_;
};

// The parts that show their outside to the eye, or those that show their inside; they end where the line of sight is
// tangent to the surface, by the normals that the lines have.
[[nodiscard]] SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view,
                                        bool outside);
// The lines with a point more on each piece that turns over, where grad f at the piece is perpendicular to the line of
// sight: parts that begin and end there fit to contours that end there.
[[nodiscard]] SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines,
                                      const implicit::Implicit& surface, const View& view);

} // namespace hrbfnpr::curves
