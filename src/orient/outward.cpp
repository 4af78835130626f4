// SPDX-License-Identifier: MIT
// Finds which side of a cloud is outside. measure_winding() compares the winding numbers on both sides of the places.
// If they do not differ, side_by_rule() decides.
#include "orient/outward.h"

#include "base/assert.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// The area of a point divided by the squared distance of neighbours, in a hexagonal lattice.
constexpr double area_share = 0.8660254037844386;
constexpr double sphere = 12.566370614359172; // the solid angle of a whole sphere: 4 pi

// Returns 1 if most of the area faces up, else -1. With a viewpoint, it returns 1 if most of the area faces the
// viewpoint. If the area faces neither up nor down, as upright walls do, it tries z, y and x in turn.
[[nodiscard]] int side_by_rule(const Cloud& cloud, const base::Array<double>& spacing, const OutwardRule& rule,
                               const VecArray& normal) {
    glm::dvec3 area{0.0};
    double seen = 0.0;
    double all = 0.0;
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        const double own = spacing[at] * spacing[at];
        area += own * normal[at];
        all += own;
        seen += glm::dot(normal[at], rule.viewpoint - cloud.point(at)) > 0.0 ? own : -own;
    }
    if (rule.has_viewpoint) return seen >= 0.0 ? 1 : -1;
    constexpr double across = 1e-3; // A smaller share of the area is rounding.
    for (const glm::dvec3& axis :
         {rule.up, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0)})
        if (std::abs(glm::dot(area, axis)) > across * all) return glm::dot(area, axis) > 0.0 ? 1 : -1;
    return 1;
}

} // namespace

bool MeanWinding::closed() const noexcept { return std::min(along, against) < tuning.closed_below; }

bool MeanWinding::nearly_closed() const noexcept { return std::min(along, against) < tuning.nearly_closed_below; }

int MeanWinding::outward() const noexcept {
    return std::abs(along - against) > tuning.told_apart ? (along < against ? 1 : -1) : 0;
}

MeanWinding measure_winding(const base::Work& work, const geometry::PointTree& tree, const NeighbourLists& near,
                            const VecArray& normal) {
    HRBFNPR_ASSERT(normal.size() == tree.size() && tree.size() > 0);
    const base::Array<double> spacing = local_spacing(work, tree, near);
    VecArray moment(work.memory, tree.size()); // the dipole moments: normals times areas
    for (std::int64_t at = 0; at < tree.size(); ++at)
        moment.set(at, area_share * spacing[at] * spacing[at] * normal[at]);
    const auto winding_number = [&](const glm::dvec3& p) {
        double sum = 0.0;
        for (std::int64_t i = 0; i < tree.size(); ++i) {
            const glm::dvec3 d = tree.points()[i] - p;
            const double r2 = glm::dot(d, d) + 1e-12;
            sum += glm::dot(moment[i], d) / (r2 * std::sqrt(r2));
        }
        return sum / sphere;
    };
    const std::int64_t probes = std::min(tuning.probes, tree.size());
    base::Array<double> number(work.memory, 2 * probes);
    work.for_each(2 * probes, [&](std::int64_t i) {
        const std::int64_t at = (i / 2) * tree.size() / probes;
        const double way = (i % 2 == 0 ? 1.0 : -1.0) * tuning.probe_step * spacing[at];
        number[i] = std::min(1.5, std::abs(winding_number(tree.points()[at] + way * normal[at])));
    });
    MeanWinding sides{0.0, 0.0};
    for (std::int64_t i = 0; i < 2 * probes; ++i)
        (i % 2 == 0 ? sides.along : sides.against) += number[i] / static_cast<double>(probes);
    return sides;
}

OutwardResult turn_outward(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                           const OutwardRule& rule, VecArray& normal) {
    HRBFNPR_ASSERT(normal.size() == cloud.size());
    OutwardResult outward;
    int side = 0;
    if (cloud.is_of_curves()) {
        // Points along curves have no area around them. The first places of the cloud spread over the surface, so each
        // of them has an area.
        const CoarsePoints first(work, cloud, cloud.spread_count);
        const NeighbourLists around(work, *first.tree, NeighbourLists::of_spacing);
        const MeanWinding sides = measure_winding(work, *first.tree, around, first.pick(normal));
        outward.closed = sides.nearly_closed();
        side = sides.outward();
    } else {
        const MeanWinding sides = measure_winding(work, *cloud.tree, near, normal);
        outward.closed = sides.closed();
        side = sides.outward();
    }
    // If an open surface has a viewpoint, outside is the side that the viewpoint sees.
    if (side == 0 || (!outward.closed && rule.has_viewpoint)) {
        outward.decided_by = rule.has_viewpoint ? OutwardBy::viewpoint : OutwardBy::up;
        side = side_by_rule(cloud, local_spacing(work, *cloud.tree, near), rule, normal);
    }
    if (side < 0)
        for (std::int64_t at = 0; at < normal.size(); ++at) normal.set(at, -normal[at]);
    return outward;
}

} // namespace hrbfnpr::orient
