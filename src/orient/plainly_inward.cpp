// SPDX-License-Identifier: MIT
#include "orient/orient.h"

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t compared_at_most = 4096;
constexpr std::int64_t fewest_points = 16;
constexpr std::int64_t ring = 6;

} // namespace

bool plainly_inward(const base::Runtime& runtime, const base::InView& points, const base::InView& normals,
                    const base::Progress& progress) {
    if (points.count < fewest_points || normals.count != points.count) return false;
    const std::int64_t step = (points.count + compared_at_most - 1) / compared_at_most;
    geometry::VecArray position(runtime.memory);
    geometry::VecArray given(runtime.memory);
    for (std::int64_t i = 0; i < points.count; i += step) {
        const glm::dvec3 n{normals.get(i, 0), normals.get(i, 1), normals.get(i, 2)};
        const double length = glm::length(n);
        if (!(length > 0.0)) return false;
        position.push_back({points.get(i, 0), points.get(i, 1), points.get(i, 2)});
        given.push_back(n / length);
    }
    const geometry::PointTree tree(position, progress);
    geometry::VecArray normal(runtime.memory, tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at) normal.set(at, given[tree.index(at)]);
    const Near near(runtime, tree, ring, progress);
    const base::Array<double> spacing = local_spacing(runtime, tree, near);
    const Sides sides = measure_sides(runtime, tree, spacing, normal, {}, progress);
    return sides.closed() && sides.against < 0.5 * sides.along && sides.outward() < 0;
}

} // namespace hrbfnpr::orient
