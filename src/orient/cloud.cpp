// SPDX-License-Identifier: MIT
// Reads a cloud: checks the points, merges points that coincide, scales them to a spacing of 1, and ranks them in a
// farthest-first order. Neighbours, and planes through them, are found in a tree of the points.
#include "orient/cloud.h"

#include "base/assert.h"
#include "geometry/along_curves.h"
#include "geometry/farthest_order.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t fewest_points = 4;
constexpr double coordinate_limit = 1e100; // No coordinate may be larger than this; the limit of a fit is the same.
// The least ratio of the points' variance across a line to their variance along it. A smaller ratio may come from
// rounding, so the points then count as lying on a line.
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

// Returns the representative of each place: the first of all places that are merged with it.
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

// Returns the median of the distances above `least`, or 0 if no distance is above it.
[[nodiscard]] double spacing_of(const base::Array<double>& distance, double least) {
    base::Array<double> positive(distance.memory());
    for (const double d : distance)
        if (d > least) positive.push_back(d);
    if (positive.empty()) return 0.0;
    double* const middle = positive.data() + positive.size() / 2;
    std::nth_element(positive.begin(), middle, positive.end());
    return *middle;
}

void require_area(const geometry::VecArray& position, const geometry::Bounds& bounds) {
    Moments moments;
    for (std::int64_t i = 0; i < position.size(); ++i)
        moments.add((position[i] - bounds.centre()) / bounds.longest_side());
    const Plane plane = plane_of(moments);
    if (!(plane.variance[1] > thinnest * plane.variance[2]))
        fail(Status::invalid_argument, "points all lie on one line, so they have no normals; give points of a surface");
}

void require(bool enough, std::int64_t count, const char* what) {
    if (!enough)
        fail(Status::invalid_argument,
             "points has %lld %s, and at least %lld different ones are needed to find normals; give more points, or "
             "normals",
             static_cast<long long>(count), what, static_cast<long long>(fewest_points));
}

struct Symmetric {
    double a[3][3];
    double v[3][3]; // The columns are the eigenvectors.
};

// Jacobi's rotation that zeroes a[p][q].
void rotate(Symmetric& m, int p, int q) noexcept {
    if (m.a[p][q] == 0.0) return;
    const double theta = (m.a[q][q] - m.a[p][p]) / (2.0 * m.a[p][q]);
    const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0);
    const double s = t * c;
    const auto mix = [&](double& x, double& y) { std::tie(x, y) = std::pair(c * x - s * y, s * x + c * y); };
    for (auto& row : m.a) mix(row[p], row[q]);
    for (int k = 0; k < 3; ++k) mix(m.a[p][k], m.a[q][k]);
    for (auto& row : m.v) mix(row[p], row[q]);
}

} // namespace

Cloud read_cloud(const base::Work& work, const base::InView& points) {
    Cloud cloud(work.memory);
    geometry::VecArray position = checked(work, points);
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < position.size(); ++i) bounds.extend(position[i]);
    require(position.size() >= fewest_points, position.size(), "elements");
    require(bounds.longest_side() > 1.0 / coordinate_limit, position.size(), "elements at one place");
    require_area(position, bounds);
    work.update(0.05);
    cloud.centre = bounds.centre();
    const geometry::PointTree all(position, work);
    base::Array<double> distance(work.memory, all.size());
    for_places(work, all.size(), [&](std::int64_t at) { distance[at] = all.nearest_other(at); });
    cloud.spacing = spacing_of(distance, 1e-9 * bounds.diagonal());
    if (!(cloud.spacing > 0.0)) cloud.spacing = bounds.diagonal();
    work.update(0.3);
    const base::Array<std::int64_t> first = representatives(all, distance, tuning.merged * cloud.spacing);
    base::Array<std::int64_t> kept(work.memory, all.size()); // for each place: its index among the points that are kept
    position.clear();
    for (std::int64_t at = 0; at < all.size(); ++at) {
        if (first[at] != at) continue;
        kept[at] = position.size();
        position.push_back((all.points()[at] - cloud.centre) / cloud.spacing);
    }
    require(position.size() >= fewest_points, position.size(), "different elements");
    cloud.merged = all.size() - position.size();
    cloud.tree = std::make_unique<geometry::PointTree>(position, work);
    base::Array<std::int64_t> at_of(work.memory, position.size());
    for (std::int64_t at = 0; at < cloud.size(); ++at) at_of[cloud.tree->index(at)] = at;
    cloud.place.resize(points.count);
    for (std::int64_t at = 0; at < all.size(); ++at) cloud.place[all.index(at)] = at_of[kept[first[at]]];
    work.update(0.5);
    geometry::FarthestOrder order = geometry::farthest_order(cloud.tree->points(), 0, work.part(0.5, 1.0));
    cloud.rank.resize(cloud.size());
    for (std::int64_t k = 0; k < order.order.size(); ++k) cloud.rank[order.order[k]] = k;
    cloud.rank_spacing = std::move(order.distance);
    if (cloud.size() >= 2 * tuning.fewest_all_over && geometry::lie_along_curves(*cloud.tree)) {
        cloud.spread_count = cloud.size();
        while (cloud.spread_count >= 2 * tuning.fewest_all_over) cloud.spread_count /= 2;
    }
    return cloud;
}

CoarsePoints::CoarsePoints(const base::Work& work, const Cloud& cloud, std::int64_t count)
    : OrderedPoints(work.memory), place(work.memory, count) {
    HRBFNPR_ASSERT(count > 0 && count <= cloud.size());
    geometry::VecArray points(work.memory);
    base::Array<std::int64_t> places(work.memory);
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        if (cloud.rank[at] >= count) continue;
        points.push_back(cloud.point(at));
        places.push_back(at);
    }
    tree = std::make_unique<geometry::PointTree>(points, work);
    rank.resize(count);
    for (std::int64_t at = 0; at < count; ++at) {
        place[at] = places[tree->index(at)];
        rank[at] = cloud.rank[place[at]];
    }
}

geometry::VecArray CoarsePoints::pick(const geometry::VecArray& normal) const {
    geometry::VecArray own(normal.memory(), place.size());
    for (std::int64_t at = 0; at < place.size(); ++at) own.set(at, normal[place[at]]);
    return own;
}

NeighbourLists::NeighbourLists(const base::Work& work, const geometry::PointTree& tree, std::int64_t each)
    : each_(std::clamp<std::int64_t>(each, 0, std::min(most, tree.size() - 1))), index_(work.memory) {
    index_.resize_for_overwrite(tree.size() * each_);
    for_places(work, tree.size(), [&](std::int64_t at) {
        std::array<std::int64_t, most> found;
        tree.nearest(
            tree.points()[at], each_, [](std::int64_t) { return true; },
            [&](std::int64_t other) { return other != at; }, found.data());
        std::transform(found.begin(), found.begin() + each_, index_.begin() + at * each_,
                       [](std::int64_t other) { return static_cast<std::int32_t>(other); });
    });
}

base::Array<double> local_spacing(const base::Runtime& runtime, const geometry::PointTree& tree,
                                  const NeighbourLists& near) {
    HRBFNPR_ASSERT(near.each() > 0);
    base::Array<double> spacing(runtime.memory, tree.size());
    for_places(runtime, tree.size(), [&](std::int64_t at) {
        const std::span<const std::int32_t> around = near.of(at, NeighbourLists::of_spacing);
        double sum = 0.0;
        for (const std::int32_t other : around) sum += glm::distance(tree.points()[at], tree.points()[other]);
        spacing[at] = sum / static_cast<double>(around.size());
    });
    return spacing;
}

std::int64_t count_components(const base::Runtime& runtime, const geometry::PointTree& tree,
                              const NeighbourLists& near) {
    const base::Array<double> spacing = local_spacing(runtime, tree, near);
    base::Array<std::int32_t> parent(runtime.memory, tree.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root_of = [&](std::int32_t at) {
        while (parent[at] != at) at = parent[at] = parent[parent[at]];
        return at;
    };
    for (std::int64_t at = 0; at < tree.size(); ++at)
        for (const std::int32_t other : near.of(at, tuning.linked)) {
            const double limit = tuning.link_length * std::max(spacing[at], spacing[other]);
            if (glm::distance(tree.points()[at], tree.points()[other]) > limit) continue;
            const std::int32_t a = root_of(static_cast<std::int32_t>(at));
            const std::int32_t b = root_of(other);
            parent[std::max(a, b)] = std::min(a, b);
        }
    std::int64_t pieces = 0;
    for (std::int64_t at = 0; at < tree.size(); ++at) pieces += parent[at] == at ? 1 : 0;
    return pieces;
}

void Moments::add(const glm::dvec3& p, double weight) noexcept {
    count += weight;
    sum += weight * p;
    const glm::dvec3 w = weight * p;
    square[0] += w.x * p.x;
    square[1] += w.x * p.y;
    square[2] += w.x * p.z;
    square[3] += w.y * p.y;
    square[4] += w.y * p.z;
    square[5] += w.z * p.z;
}

Plane plane_of(const Moments& moments) noexcept {
    // Sweeps converge quadratically, so four are enough for full precision; the others are a reserve.
    constexpr int sweeps = 8;
    Plane plane;
    if (!(moments.count > 0.0)) return plane;
    const glm::dvec3 c = moments.sum / moments.count;
    const auto& s = moments.square;
    const double k = 1.0 / moments.count;
    Symmetric m{{{s[0] * k - c.x * c.x, s[1] * k - c.x * c.y, s[2] * k - c.x * c.z},
                 {s[1] * k - c.x * c.y, s[3] * k - c.y * c.y, s[4] * k - c.y * c.z},
                 {s[2] * k - c.x * c.z, s[4] * k - c.y * c.z, s[5] * k - c.z * c.z}},
                {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) rotate(m, p, q);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return m.a[a][a] < m.a[b][b] || (m.a[a][a] == m.a[b][b] && a < b); });
    for (std::size_t i = 0; i < 3; ++i) plane.variance[i] = std::max(0.0, m.a[order[i]][order[i]]);
    plane.normal = glm::normalize(glm::dvec3(m.v[0][order[0]], m.v[1][order[0]], m.v[2][order[0]]));
    return plane;
}

geometry::VecArray plane_normals(const base::Work& work, const geometry::PointTree& tree, const NeighbourLists& near,
                                 std::int64_t count) {
    geometry::VecArray normal(work.memory, tree.size());
    for_places(work, tree.size(), [&](std::int64_t at) {
        const glm::dvec3 p = tree.points()[at];
        Moments moments;
        moments.add(glm::dvec3(0.0));
        for (const std::int32_t other : near.of(at, count)) moments.add(tree.points()[other] - p);
        normal.set(at, plane_of(moments).normal);
    });
    return normal;
}

double share_alike(const geometry::VecArray& a, const geometry::VecArray& b) noexcept {
    HRBFNPR_ASSERT(a.size() == b.size() && !a.empty());
    std::int64_t alike = 0;
    for (std::int64_t at = 0; at < a.size(); ++at) alike += glm::dot(a[at], b[at]) > 0.0 ? 1 : 0;
    const double share = static_cast<double>(alike) / static_cast<double>(a.size());
    return std::max(share, 1.0 - share);
}

} // namespace hrbfnpr::orient
