// SPDX-License-Identifier: MIT
// Where a surface ends inside of its region: for want of samples, where s(x) = limit, s of surface/support.h; or where
// another sheet takes its place.
#pragma once

#include "curves/surface_mesh.h"
#include "geometry/point_grid.h"
#include "implicit/implicit.h"
#include "implicit/sheets.h"
#include "surface/support.h"

#include <memory>

namespace hrbfnpr::curves {

// It is asked for places on the surface. Far from the border of the mesh it is not: curves and rays shall find no holes
// that the mesh does not have.
class SurfaceEnd {
public:
    SurfaceEnd() = default;
    SurfaceEnd(const SurfaceEnd&) = delete;
    SurfaceEnd& operator=(const SurfaceEnd&) = delete;
    virtual ~SurfaceEnd() = default;

    // Whether the border is near, so that beyond() must be asked.
    [[nodiscard]] virtual bool near_border(const glm::dvec3& place) const = 0;
    // <= 0: the surface is there. It is right within two sides of the part of the surface that is there.
    [[nodiscard]] virtual double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const = 0;
    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_border(place) || beyond(place, gradient) <= 0.0;
    }
};

class SupportEnd final : public SurfaceEnd {
public:
    // border: places along the border, no farther apart than a side.
    SupportEnd(const surface::Support& support, double limit, const geometry::VecArray& border, double side);

    // It is always near where the support itself knows where it has no cells.
    [[nodiscard]] bool near_border(const glm::dvec3& place) const override;
    // s - limit.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override;

private:
    const surface::Support& support_;
    double limit_;
    geometry::PointGrid border_;
};

// Where a sheet of an implicit with creases ends: another one is f there.
class SheetEnd final : public SurfaceEnd {
public:
    // The grid of places along the creases of all sheets, no farther apart than a side. Near any crease a sheet may
    // end: a curve that leaves it may come to another sheet that is the same function, as for cylinders on one axis.
    [[nodiscard]] static std::shared_ptr<const geometry::PointGrid> grid_of(const geometry::VecArray& creases,
                                                                            double side);
    // own: the sheet's triangles, which must outlive it. base: the end of the whole surface, or null.
    SheetEnd(const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t sheet,
             std::shared_ptr<const geometry::PointGrid> creases, const SurfaceMesh& own, const SurfaceEnd* base);

    [[nodiscard]] bool near_border(const glm::dvec3& place) const override;
    // The distance from the whole surface, or a side where that is another sheet, unless the sheet is the active one.
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

} // namespace hrbfnpr::curves
