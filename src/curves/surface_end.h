// SPDX-License-Identifier: MIT
// Where a surface ends for want of samples: s(x) = limit, s of surface/support.h.
#pragma once

#include "curves/level.h"
#include "geometry/point_grid.h"
#include "surface/support.h"

namespace hrbfnpr::curves {

// Asked for places on the surface.  Far from the mesh's border nothing is asked: holes that the mesh does not have, no
// curve and no ray shall find.
class SurfaceEnd {
public:
    // border: places along it, no farther apart than a side.
    SurfaceEnd(const surface::Support& support, double limit, const geometry::VecArray& border, double side);

    [[nodiscard]] const surface::Support& support() const noexcept { return support_; }
    [[nodiscard]] double limit() const noexcept { return limit_; }
    // Whether the border is nearer than `reach` sides, or little more; or the support itself knows where it is not.
    [[nodiscard]] bool near_border(const glm::dvec3& place) const;
    // s - limit.  <= 0: the surface is there.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept {
        return support_.may_end_at(place) ? support_.value(place, gradient) - limit_ : -limit_;
    }
    // Right for places within two sides of the surface that is left.
    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_border(place) || beyond(place, gradient) <= 0.0;
    }

private:
    static constexpr double reach = 3.0;

    const surface::Support& support_;
    double limit_;
    geometry::PointGrid grid_;
};

// g = s - limit: the border as a curve, the surface to its left.
class SupportLevel final : public Level {
public:
    SupportLevel(const implicit::Implicit& surface, const surface::Support& support, double limit) noexcept
        : surface_(surface), support_(support), limit_(limit) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress& progress) const override;

private:
    void evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const;

    const implicit::Implicit& surface_;
    const surface::Support& support_;
    double limit_;
};

} // namespace hrbfnpr::curves
