// SPDX-License-Identifier: MIT
#include "curves/surface_end.h"

#include "curves/tuning.h"
#include "surface/sheets_meet.h"

#include <cmath>

namespace hrbfnpr::curves {
namespace {

bool has_near(const geometry::PointGrid& grid, const glm::dvec3& place) {
    bool near = false;
    grid.around(place, [&](std::int64_t) { near = true; });
    return near;
}

} // namespace

SupportEnd::SupportEnd(const surface::Support& support, double limit, const geometry::VecArray& border, double side)
    : support_(support), limit_(limit), border_(border, curve_tuning.border_reach * side) {
    HRBFNPR_ASSERT(side > 0.0);
}

bool SupportEnd::near_border(const glm::dvec3& place) const { return support_.has_kept() || has_near(border_, place); }

double SupportEnd::beyond(const glm::dvec3& place, const glm::dvec3& gradient) const {
    return support_.may_end_at(place) ? support_.value(place, gradient) - limit_ : -limit_;
}

std::shared_ptr<const geometry::PointGrid> SheetEnd::grid_of(const geometry::VecArray& creases, double side) {
    return std::make_shared<const geometry::PointGrid>(creases, curve_tuning.border_reach * side);
}

SheetEnd::SheetEnd(const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t sheet,
                   std::shared_ptr<const geometry::PointGrid> creases, const SurfaceMesh& own, const SurfaceEnd* base)
    : whole_(whole), sheets_(sheets), sheet_(sheet), vertices_(own.position), side_(own.side),
      creases_(std::move(creases)), own_(own.position, curve_tuning.vertex_reach * side_), base_(base) {
    HRBFNPR_ASSERT(sheet >= 0 && sheet < sheets.count() && creases_ != nullptr);
}

bool SheetEnd::near_border(const glm::dvec3& place) const {
    return (base_ != nullptr && base_->near_border(place)) || has_near(*creases_, place);
}

// Either of two equal sheets may be active: a place on the whole surface belongs to this sheet if one of its vertices
// is near.
double SheetEnd::beyond(const glm::dvec3& place, const glm::dvec3& gradient) const {
    const double on_surface = curve_tuning.on_sheet * side_;
    if (surface::active_at(sheets_, place) != sheet_) {
        double value = 0.0;
        glm::dvec3 slope(0.0);
        whole_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&slope.x, &slope.y, &slope.z}, {}});
        const double off = std::abs(value) / glm::length(slope);
        if (!(off <= on_surface)) return off;
        bool is_own = false;
        own_.around(place, [&](std::int64_t at) {
            is_own = is_own || glm::distance(vertices_[own_.index(at)], place) <= curve_tuning.vertex_reach * side_;
        });
        if (!is_own) return side_;
    }
    return base_ != nullptr && base_->near_border(place) ? base_->beyond(place, gradient) : -on_surface;
}

} // namespace hrbfnpr::curves
