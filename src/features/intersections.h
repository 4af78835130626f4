// SPDX-License-Identifier: MIT
// The curves in which the surfaces of two line sets cross.
#pragma once

#include "curves/curves.h"
#include "features/line_set.h"

namespace hrbfnpr::curves {

// The function g is the other surface's f, so curves f = g = 0 are those in which both surfaces cross.
class IntersectionLevel final : public Level {
public:
    // `to_other` maps the coordinates of `surface` to those of `other`. It is affine.
    IntersectionLevel(const implicit::Implicit& surface, const implicit::Implicit& other,
                      const glm::dmat4& to_other) noexcept
        : surface_(surface), other_(other), to_other_(to_other) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override;
    // Computes g and its gradient at places. Resizes both arrays.
    void at_places(const base::Work& work, const geometry::VecArray& places, base::Array<double>& level,
                   geometry::VecArray& gradient) const;

private:
    const implicit::Implicit& surface_;
    const implicit::Implicit& other_;
    glm::dmat4 to_other_;
};

struct Intersections {
    explicit Intersections(base::Memory& memory) noexcept : curves(memory), angle(memory) {}

    // In the coordinates of the first line set. A curve ends at a border or at a crease of one of the surfaces.
    Curves curves;
    // For each curve: the mean angle between the two surfaces along the curve, in degrees, from 0 to 90.
    base::Array<float> angle;
    // The number of curves that end inside both surfaces, plus the number of places where a curve was missed.
    std::int64_t broken = 0;
};

// Returns whether the boxes of two surfaces overlap, so that the surfaces may cross. `to_other` maps the coordinates of
// `lines` to those of `other`.
[[nodiscard]] bool may_intersect(const LineSet& lines, const LineSet& other, const glm::dmat4& to_other) noexcept;

// Traces the curves in which two surfaces cross, on the mesh of `lines`. Surfaces that coincide have no curve there.
// The result has the same bits for any number of threads.
[[nodiscard]] Intersections find_intersections(const base::Work& work, const LineSet& lines, const LineSet& other,
                                               const glm::dmat4& to_other);

} // namespace hrbfnpr::curves
