// SPDX-License-Identifier: MIT
// Creases as curves: where two sheets of an implicit are both 0 on its surface.
#pragma once

#include "creases/crease_mesh.h"
#include "curves/surface_lines.h"

#include <cmath>

namespace hrbfnpr::curves {

struct CreasePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 left{0.0}, right{0.0}; // unit normals of the sheets to either side, as seen from outside
    glm::dvec3 tangent{0.0};          // unit, along the crease

    // Between the normals, degrees: 0 where the surface is smooth; < 0 of a concave one.
    [[nodiscard]] double angle() const noexcept;
};

struct Creases {
    explicit Creases(base::Memory& memory) noexcept
        : first(memory), closed(memory), left(memory), right(memory), point(memory) {}

    base::Array<std::int64_t> first;  // of each crease's points, and the end
    base::Array<std::uint8_t> closed; // 1: the first point follows the last, and stands there once
    base::Array<std::int32_t> left;   // sheets of each
    base::Array<std::int32_t> right;
    base::Array<CreasePoint> point; // no two of a crease at one place

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return first.bytes() + closed.bytes() + left.bytes() + right.bytes() + point.bytes();
    }
};

// As many points as turning asks for, each on both sheets; ends are corners, or where the mesh ends.
[[nodiscard]] Creases trace_creases(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                    const CreaseChains& chains, double side, const base::Progress& progress);

// Of a whole crease, degrees: concave ones are negative.
struct AngleRange {
    float least = 0.0F, most = 0.0F;
};

// The parts of creases in a view, as lines.
struct CreaseParts {
    explicit CreaseParts(base::Memory& memory) noexcept
        : folds(memory), outside(memory), inside(memory), of_outside(memory), of_inside(memory) {}

    // One sheet faces the eye and the other one away: parts of the contour, with the front sheet to their left.
    SurfaceLines folds;
    SurfaceLines outside; // both face the eye
    SurfaceLines inside;  // neither does
    // The sharpest angles of the crease that each curve is a part of.
    base::Array<AngleRange> of_outside, of_inside;
};

// strength: the angle, degrees, < 0 of concave ones.
[[nodiscard]] CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets,
                                        const Creases& creases, const View& view);

// Of lines with angles for strengths: those of one way of bending, as positive angles, where they are `lower` or more,
// if the whole crease is `upper` somewhere: what goes on from a part of the contour does not end there.
enum class CreaseSide : std::uint32_t { both = 0, convex = 1, concave = 2 };
// That angle; the other way of bending is negative.
[[nodiscard]] inline float angle_on(CreaseSide side, float angle) noexcept {
    return side == CreaseSide::both ? std::abs(angle) : side == CreaseSide::convex ? angle : -angle;
}
[[nodiscard]] SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines,
                                      const base::Array<AngleRange>& of, CreaseSide side, double lower, double upper);

} // namespace hrbfnpr::curves
