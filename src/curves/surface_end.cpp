// SPDX-License-Identifier: MIT
#include "curves/surface_end.h"

#include "curves/level_block.h"
#include "surface/sheets_meet.h"

#include <cmath>

namespace hrbfnpr::curves {
namespace {

// Where no sample is near s has no slope: large enough that nothing is led there.
constexpr double nowhere = 1e6;
// In sides: a place of a sheet that is nearer to the whole surface is on it, whichever of two equal sheets is active,
// if it is nearer than that to a vertex of the sheet.
constexpr double on_surface_end = 1e-7;
constexpr double of_own = 1.5;

} // namespace

SupportEnd::SupportEnd(const surface::Support& support, double limit, const geometry::VecArray& border, double side)
    : support_(support), limit_(limit), grid_(border, reach * side) {}

bool SupportEnd::near_border(const glm::dvec3& place) const {
    if (support_.has_kept()) return true;
    bool near = false;
    grid_.around(place, [&](std::int64_t) { near = true; });
    return near;
}

std::shared_ptr<const geometry::PointGrid> SheetEnd::grid_of(const geometry::VecArray& creases, double side) {
    return std::make_shared<const geometry::PointGrid>(creases, reach * side);
}

SheetEnd::SheetEnd(const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t sheet,
                   std::shared_ptr<const geometry::PointGrid> creases, const SurfaceMesh& own, const SurfaceEnd* base)
    : whole_(whole), sheets_(sheets), sheet_(sheet), vertices_(own.position), side_(own.side),
      creases_(std::move(creases)), own_(own.position, of_own * side_), base_(base) {}

bool SheetEnd::near_border(const glm::dvec3& place) const {
    bool near = base_ != nullptr && base_->near_border(place);
    if (!near) creases_->around(place, [&](std::int64_t) { near = true; });
    return near;
}

double SheetEnd::beyond(const glm::dvec3& place, const glm::dvec3& gradient) const {
    if (surface::active_at(sheets_, place) != sheet_) {
        double value = 0.0;
        glm::dvec3 slope(0.0);
        whole_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&slope.x, &slope.y, &slope.z}, {}});
        const double off = std::abs(value) / glm::length(slope);
        if (!(off <= on_surface_end * side_)) return off;
        bool is_own = false;
        own_.around(place, [&](std::int64_t at) {
            is_own = is_own || glm::distance(vertices_[own_.index(at)], place) <= of_own * side_;
        });
        if (!is_own) return side_;
    }
    return base_ != nullptr && base_->near_border(place) ? base_->beyond(place, gradient) : -on_surface_end * side_;
}

void SupportLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    in_blocks(points, out, [&](const implicit::PointBatch& some, const LevelBatch& to) { evaluate_block(some, to); });
}

// The normal changes along with the place by the Hessian over |grad f|.
void SupportLevel::evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const {
    HessianBlock h;
    h.evaluate(surface_, points, out);
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 gradient(out.gradient[0][i], out.gradient[1][i], out.gradient[2][i]);
        const surface::Support::Answer s = support_.evaluate({points.x[i], points.y[i], points.z[i]}, gradient);
        const glm::dvec3 level = s.by_place + h.times(i, s.by_normal) / glm::length(gradient);
        out.level[i] = std::isfinite(s.value) ? s.value - limit_ : nowhere;
        for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = level[c];
    }
}

void SupportLevel::at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                               const base::Progress& progress) const {
    support_.evaluate_all(runtime, mesh.position, mesh.gradient, level, progress);
    for (double& value : level) value = std::isfinite(value) ? value - limit_ : nowhere;
}

} // namespace hrbfnpr::curves
