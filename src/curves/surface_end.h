// SPDX-License-Identifier: MIT
// Where a surface ends inside of its region: for want of samples, where s(x) = limit, s of surface/support.h; or where
// another sheet takes its place.
#pragma once

#include "curves/level.h"
#include "curves/surface_mesh.h"
#include "geometry/point_grid.h"
#include "implicit/sheets.h"
#include "surface/support.h"

#include <memory>

namespace hrbfnpr::curves {

// Asked for places on the surface.
class SurfaceEnd {
public:
    SurfaceEnd() = default;
    SurfaceEnd(const SurfaceEnd&) = delete;
    SurfaceEnd& operator=(const SurfaceEnd&) = delete;
    virtual ~SurfaceEnd() = default;

    // Whether the border is near, so that it must be asked.
    [[nodiscard]] virtual bool near_border(const glm::dvec3& place) const = 0;
    // <= 0: the surface is there.
    [[nodiscard]] virtual double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const = 0;
    // Right for places within two sides of the surface that is left.
    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_border(place) || beyond(place, gradient) <= 0.0;
    }

protected:
    // Of the border's places, in sides.
    static constexpr double reach = 3.0;
};

// Far from the mesh's border nothing is asked: holes that the mesh does not have, no curve and no ray shall find.
class SupportEnd final : public SurfaceEnd {
public:
    // border: places along it, no farther apart than a side.
    SupportEnd(const surface::Support& support, double limit, const geometry::VecArray& border, double side);

    [[nodiscard]] const surface::Support& support() const noexcept { return support_; }
    [[nodiscard]] double limit() const noexcept { return limit_; }
    // Or the support itself knows where it is not.
    [[nodiscard]] bool near_border(const glm::dvec3& place) const override;
    // s - limit.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
        return support_.may_end_at(place) ? support_.value(place, gradient) - limit_ : -limit_;
    }

private:
    const surface::Support& support_;
    double limit_;
    geometry::PointGrid grid_;
};

// Where a sheet of an implicit with creases ends: another one is f there.
class SheetEnd final : public SurfaceEnd {
public:
    // Near any crease it may end: a curve that leaves one sheet may come to another one that is the same function, as
    // of cylinders on one axis.
    [[nodiscard]] static std::shared_ptr<const geometry::PointGrid> grid_of(const geometry::VecArray& creases,
                                                                            double side);

    // creases: places along those of all sheets, no farther apart than a side; own: the sheet's triangles, kept;
    // base: where the whole surface ends, or null.
    SheetEnd(const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t sheet,
             std::shared_ptr<const geometry::PointGrid> creases, const SurfaceMesh& own, const SurfaceEnd* base);

    [[nodiscard]] bool near_border(const glm::dvec3& place) const override;
    // How far from the whole surface, or from the sheet's triangles, unless the sheet is the active one.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override;

private:
    const implicit::Implicit& whole_;
    const implicit::Sheets& sheets_;
    std::int32_t sheet_;
    const geometry::VecArray& vertices_;
    double side_;
    std::shared_ptr<const geometry::PointGrid> creases_;
    geometry::PointGrid own_;
    const SurfaceEnd* base_;
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
