// SPDX-License-Identifier: MIT
#include "orient/cloud.h"

#include "geometry/farthest_order.h"
#include "orient/directions.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

constexpr double coordinate_limit = 1e100; // as a fit's
// In spacings: nearer points are one.
constexpr double near = 0.01;
constexpr std::int64_t grain = 512;
// Variance across over that along of points that are on a line, but for rounding.
constexpr double thinnest = 1e-12;

[[nodiscard]] geometry::VecArray checked(const base::Runtime& runtime, const base::InView& points) {
    geometry::VecArray position(runtime.memory, points.count);
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p{points.get(i, 0), points.get(i, 1), points.get(i, 2)};
        for (glm::length_t c = 0; c < 3; ++c) {
            if (!std::isfinite(p[c]))
                fail(Status::invalid_argument, "points[%lld] is NaN or infinite; remove that point",
                     static_cast<long long>(i));
            if (std::abs(p[c]) > coordinate_limit)
                fail(Status::invalid_argument, "points[%lld] has a coordinate beyond 1e100; use a larger unit",
                     static_cast<long long>(i));
        }
        position.set(i, p);
    }
    return position;
}

[[nodiscard]] double median(base::Array<double> values) {
    if (values.empty()) return 0.0;
    double* middle = values.data() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

[[nodiscard]] base::Array<double> nearest_distances(const base::Runtime& runtime, const geometry::PointTree& tree,
                                                    const base::Progress& progress) {
    base::Array<double> distance(runtime.memory, tree.size());
    runtime.parallel.for_chunks(tree.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t at = begin; at < end; ++at) distance[at] = tree.nearest_other(at);
    });
    return distance;
}

// Of each place the first one that it is merged into.
[[nodiscard]] base::Array<std::int64_t> representatives(const geometry::PointTree& tree,
                                                        const base::Array<double>& distance, double reach) {
    base::Array<std::int64_t> first(tree.points().memory(), tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at) {
        first[at] = at;
        if (distance[at] > reach) continue;
        tree.within(tree.points()[at], reach, [&](std::int64_t other, double /*squared*/) {
            if (other < first[at] && first[other] == other) first[at] = other;
        });
    }
    return first;
}

// Median of the distances that are not 0.
[[nodiscard]] double spacing_of(const base::Array<double>& distance, double least) {
    base::Array<double> positive(distance.memory());
    for (const double d : distance)
        if (d > least) positive.push_back(d);
    return median(std::move(positive));
}

void require_area(const geometry::VecArray& position, const geometry::Bounds& bounds) {
    Moments moments;
    for (std::int64_t i = 0; i < position.size(); ++i)
        moments.add((position[i] - bounds.centre()) / bounds.longest_side());
    const Plane plane = plane_of(moments);
    if (!(plane.variance[1] > thinnest * plane.variance[2]))
        fail(Status::invalid_argument, "points lie all on one line: they have no normals; give points of a surface");
}

} // namespace

Cloud read_cloud(const base::Runtime& runtime, const base::InView& points, const base::Progress& progress) {
    Cloud cloud(runtime.memory);
    geometry::VecArray position = checked(runtime, points);
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < position.size(); ++i) bounds.extend(position[i]);
    if (position.size() < fewest || !(bounds.longest_side() > 1.0 / coordinate_limit))
        fail(Status::invalid_argument,
             "points has %lld elements%s; %lld different ones are the fewest that say how "
             "a surface lies: give more points, or normals",
             static_cast<long long>(position.size()), position.size() < fewest ? "" : " at one place",
             static_cast<long long>(fewest));
    require_area(position, bounds);
    progress.update(0.05);
    cloud.centre = bounds.centre();
    const geometry::PointTree all(position, progress);
    const base::Array<double> distance = nearest_distances(runtime, all, progress);
    cloud.spacing = spacing_of(distance, 1e-9 * bounds.diagonal());
    if (!(cloud.spacing > 0.0)) cloud.spacing = bounds.diagonal();
    progress.update(0.3);
    const base::Array<std::int64_t> first = representatives(all, distance, near * cloud.spacing);
    base::Array<std::int64_t> kept(runtime.memory, all.size()); // number among the kept
    position.clear();
    for (std::int64_t at = 0; at < all.size(); ++at) {
        if (first[at] != at) continue;
        kept[at] = position.size();
        position.push_back((all.points()[at] - cloud.centre) / cloud.spacing);
    }
    if (position.size() < fewest)
        fail(Status::invalid_argument,
             "points has %lld different elements; %lld are the fewest that say how a "
             "surface lies: give more points, or normals",
             static_cast<long long>(position.size()), static_cast<long long>(fewest));
    cloud.merged = all.size() - position.size();
    cloud.tree = std::make_unique<geometry::PointTree>(position, progress);
    base::Array<std::int64_t> at_of(runtime.memory, position.size());
    for (std::int64_t at = 0; at < cloud.size(); ++at) at_of[cloud.tree->index(at)] = at;
    cloud.place.resize(points.count);
    for (std::int64_t at = 0; at < all.size(); ++at) cloud.place[all.index(at)] = at_of[kept[first[at]]];
    progress.update(0.5);
    geometry::FarthestOrder order = geometry::farthest_order(cloud.tree->points(), 0, progress.part(0.5, 1.0));
    cloud.rank.resize(cloud.size());
    for (std::int64_t k = 0; k < order.order.size(); ++k) cloud.rank[order.order[k]] = k;
    cloud.apart = std::move(order.distance);
    return cloud;
}

} // namespace hrbfnpr::orient
