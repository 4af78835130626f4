// SPDX-License-Identifier: MIT
// Lines on the surface beyond its contours: suggestive contours, ridges, valleys, apparent ridges, parabolic lines,
// isophotes, plane sections.
//
// A mesh of the surface tells where they pass; each of their points is then brought onto the true curve, between the
// two vertices of the edge that it crosses.  A line that turns within a triangle is missed, so the mesh should be as
// fine as the lines that are to be drawn.
#pragma once

#include "curves/surface_lines.h"
#include "curves/surface_mesh.h"
#include "features/shape.h"

#include <span>

namespace hrbfnpr::curves {

struct FeatureRequest {
    FeatureKind kind = FeatureKind::suggestive_contour;
    glm::dvec4 towards{0.0, 0.0, 1.0, 0.0}; // view-dependent: the eye or light, a place (w = 1) or a direction to it
    glm::dvec3 plane{0.0, 0.0, 1.0};        // sections: the planes' unit normal
    std::span<const double> levels;         // isophotes, sections: one or several
    // A line goes on while it is at least `lower`, and is drawn if it is `upper` somewhere (hysteresis).  To fade it,
    // draw it with (strength - lower) / (upper - lower).
    double lower = 0.0;
    double upper = 0.0;
    double shortest = 0.0; // lines that are not as long, in diagonals, are dropped
    // Evaluations of g at most to find each point.  With none, points are where g is 0 by interpolation: a cubic one
    // for suggestive contours, parabolic lines and isophotes, which is enough to draw; a linear one else.
    std::int32_t rounds = 6;
};

// The surface that lines are looked for on. All of it outlives the call.
struct FeatureSurface {
    const implicit::Implicit& implicit;
    const implicit::ShapeSource& source;
    const SurfaceMesh& mesh;
    const base::Array<ShapePoint>& shape; // at the mesh's vertices; may be empty for sections
};

struct FeaturePoint {
    glm::dvec3 position{0.0}; // on the surface
    glm::dvec3 normal{0.0};   // unit
    double strength = 0.0;    // as feature_value() gives it; for sections the sine between plane and surface
    double facing = 1.0;      // the same
    bool resolved = false;    // a root was found
};

struct FeatureLines : Chains<FeaturePoint> {
    explicit FeatureLines(base::Memory& memory) : Chains(memory), level(memory) {}

    base::Array<std::int32_t> level; // the place of each line's level in the request's levels
    std::int64_t weak = 0;           // lines that stay below `upper`
    std::int64_t small = 0;          // lines that are too short
    std::int64_t unresolved = 0;     // crossings of the mesh that no point was found for, where lines end
};

// The same bits for any thread count.  Throws Error{out_of_memory, cancelled, callback}.
[[nodiscard]] FeatureLines find_feature_lines(const base::Runtime& runtime, const FeatureSurface& surface,
                                              const FeatureRequest& request, const base::Progress& progress);

[[nodiscard]] SurfaceLines as_lines(base::Memory& memory, const FeatureLines& features);

} // namespace hrbfnpr::curves
