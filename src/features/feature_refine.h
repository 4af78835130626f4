// SPDX-License-Identifier: MIT
// Crossings of the mesh's edges, brought onto the true curve.
#pragma once

#include "features/feature_chains.h"
#include "features/feature_lines.h"

namespace hrbfnpr::curves {

struct FeaturePoints {
    explicit FeaturePoints(base::Memory& memory) noexcept
        : position(memory), normal(memory), strength(memory), facing(memory), resolved(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal;
    base::Array<double> strength; // at the place
    base::Array<double> facing;
    base::Array<std::uint8_t> resolved; // 0: no root was found
};

// g and all else for a request, at a place with its shape; on the far side as it is seen from there, if it is wanted.
// There are lines where `facing` is not negative.
[[nodiscard]] FeatureValue requested_value(const FeatureRequest& request, const ShapePoint& shape,
                                           const glm::dvec3& position, double unit) noexcept;

// The root of g on the surface between the two vertices of each crossed edge: the Illinois method (Dowell & Jarratt
// 1971) along the edge, whose points are projected onto f = 0; all points side by side.  `value` is what the chains
// were found from.
[[nodiscard]] FeaturePoints refine_crossings(const base::Runtime& runtime, const FeatureSurface& surface,
                                             const FeatureRequest& request, double level,
                                             const base::Array<FeatureValue>& value,
                                             const base::Array<FeatureCrossing>& crossing,
                                             const base::Progress& progress);

// Newton's steps on the pair (f, plane . p - level) instead.
[[nodiscard]] FeaturePoints refine_section(const base::Runtime& runtime, const FeatureSurface& surface,
                                           const glm::dvec3& plane, double level,
                                           const base::Array<FeatureCrossing>& crossing,
                                           const base::Progress& progress);

// Ridges and valleys: multiplies strengths by how much the curvature drops to both sides, from 0 for none, as on a
// cylinder, to 1 where it is `full_drop`.  What is measured is 2 (1 - k' / k) / (k s)^2, which for small s is
// -k'' / k^3, at s = 1 / 2k, a turn of half a radian, but two cells at least: derivatives at the place itself would
// take the ripple of a fit for ridges.
void weigh_by_drop(const base::Runtime& runtime, const FeatureSurface& surface, FeatureKind kind, FeaturePoints& points,
                   const base::Progress& progress);

// An ellipse has 3 (1 - (b / a)^2) at the end of its longer axis.
inline constexpr double full_drop = 0.5;

} // namespace hrbfnpr::curves
