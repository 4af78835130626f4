// SPDX-License-Identifier: MIT
#include "picture/strays.h"

#include "base/assert.h"
#include "geometry/point_tree.h"
#include "orient/cloud.h"
#include "picture/statistics.h"
#include "picture/tuning_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace hrbfnpr::picture {
namespace {

bool is_finite_point(const glm::dvec3& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::int64_t count_in(const PointMask& mask) noexcept { return std::count(mask.begin(), mask.end(), std::uint8_t{1}); }

PointMask without_those(const PointMask& mask, Pool& pool) {
    PointMask kept(mask.size(), 0, &pool);
    std::transform(mask.begin(), mask.end(), kept.begin(),
                   [](std::uint8_t out) { return static_cast<std::uint8_t>(1 - out); });
    return kept;
}

template <class T>
void keep_elements(Vector<T>& elements, const PointMask& kept) noexcept {
    std::size_t to = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (kept[i] != 0) elements[to++] = elements[i];
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(to), elements.end());
}

// Returns whether all points of a face or an edge are kept.
template <class Numbers>
bool has_all(const Numbers& numbers, const PointMask& kept) noexcept {
    return std::all_of(numbers.begin(), numbers.end(), [&](std::int64_t i) {
        HRBFNPR_ASSERT(i >= 0 && i < static_cast<std::int64_t>(kept.size()));
        return kept[static_cast<std::size_t>(i)] != 0;
    });
}

// Keeps the faces or edges whose points are all kept. Replaces the indices of their points by the new indices.
template <class Numbers>
void keep_joined(Vector<Numbers>& joined, const PointMask& kept, const Vector<std::int64_t>& number) noexcept {
    joined.erase(
        std::remove_if(joined.begin(), joined.end(), [&](const Numbers& each) { return !has_all(each, kept); }),
        joined.end());
    for (Numbers& each : joined)
        for (std::int64_t& i : each) i = number[static_cast<std::size_t>(i)];
}

PointMask points_at(const Points& points, double value, Pool& pool) {
    PointMask at(points.size(), 0, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        at[i] = points[i].x == value || points[i].y == value || points[i].z == value ? 1 : 0;
    return at;
}

// Returns whether a value is below the coordinates of all other points, by more than the extent of these points.
bool is_far_below(double value, const Points& points, const PointMask& at_it) noexcept {
    geometry::Bounds rest;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (at_it[i] == 0 && is_finite_point(points[i])) rest.extend(points[i]);
    if (rest.empty()) return false;
    const double least = std::min(std::min(rest.min.x, rest.min.y), rest.min.z);
    return least - value >= rest.longest_side();
}

} // namespace

bool keep_points(Shape& shape, const PointMask& kept, Pool& pool) {
    HRBFNPR_ASSERT(kept.size() == shape.points.size());
    const bool is_mesh = shape.is_mesh();
    const auto stays = [&](const Triangle& face) { return has_all(face, kept); };
    if (is_mesh && std::none_of(shape.triangles.begin(), shape.triangles.end(), stays)) return false;
    if (is_mesh) {
        Vector<std::int64_t> number(kept.size(), 0, &pool);
        std::int64_t next = 0;
        for (std::size_t i = 0; i < kept.size(); ++i) number[i] = kept[i] != 0 ? next++ : -1;
        keep_joined(shape.triangles, kept, number);
        keep_joined(shape.sharp_edges, kept, number);
    } else {
        shape.columns = shape.rows = 0; // Without some of its points, an image is only a set of points.
    }
    keep_elements(shape.points, kept);
    if (!shape.normals.empty()) keep_elements(shape.normals, kept);
    return true;
}

NoData leave_out_no_data(Shape& shape, Pool& pool) {
    const auto all = static_cast<std::int64_t>(shape.points.size());
    for (const double value : strays_tuning.no_data) {
        const PointMask at_it = points_at(shape.points, value, pool);
        const std::int64_t count = count_in(at_it);
        if (count == 0 || count == all || !is_far_below(value, shape.points, at_it)) continue;
        if (keep_points(shape, without_those(at_it, pool), pool)) return {count, value};
    }
    return {};
}

std::int64_t leave_out_far(Shape& shape, Pool& pool) {
    const PointMask far = far_from_most(shape.points, pool);
    const std::int64_t count = count_in(far);
    if (count == 0 || !keep_points(shape, without_those(far, pool), pool)) return 0;
    return count;
}

PointMask far_from_most(const Points& points, Pool& pool) {
    PointMask far(points.size(), 0, &pool);
    const auto finite = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_finite_point));
    if (static_cast<double>(finite) < 2.0 / strays_tuning.few) return far;

    glm::dvec3 middle(0.0);
    Vector<double> numbers(&pool);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        numbers.clear();
        for (const glm::dvec3& p : points)
            if (is_finite_point(p)) numbers.push_back(p[axis]);
        middle[axis] = median_of(numbers);
    }
    constexpr double nowhere = -1.0; // the value for a point that is not finite
    Vector<double> distance(points.size(), nowhere, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_finite_point(points[i])) distance[i] = glm::length(points[i] - middle);

    // The largest distances, in ascending order: those of the few points that may be far, and one more.
    const auto few = static_cast<std::size_t>(strays_tuning.few * static_cast<double>(finite));
    numbers = distance;
    const auto last = numbers.end() - static_cast<std::ptrdiff_t>(few + 1);
    std::nth_element(numbers.begin(), last, numbers.end());
    std::sort(last, numbers.end());
    for (auto at = last; at + 1 != numbers.end(); ++at) {
        if (!(at[1] > strays_tuning.far * at[0])) continue;
        if (at[0] > 0.0)
            for (std::size_t i = 0; i < points.size(); ++i) far[i] = distance[i] > at[0] ? 1 : 0;
        break;
    }
    return far;
}

// ---- Dust

namespace {

// The points in the order of a tree, scaled to size 1.
struct Dust {
    explicit Dust(const geometry::VecArray& points, Pool& pool)
        : tree(points, {}), reach(static_cast<std::size_t>(points.size()), 0.0, &pool),
          is_stray(reach.size(), 0, &pool) {}

    geometry::PointTree tree;
    Vector<double> reach; // for each place: the distance to the last of its neighbours
    PointMask is_stray;
};

using NearPlaces = std::array<std::int64_t, strays_tuning.neighbours>;

// Finds the nearest other places that are no strays. There are fewer than wanted only if nearly all places are strays.
std::span<const std::int64_t> near_places(const Dust& dust, std::int64_t at, NearPlaces& found) noexcept {
    const auto is_other = [&](std::int64_t other) {
        return other != at && dust.is_stray[static_cast<std::size_t>(other)] == 0;
    };
    const std::int64_t count = dust.tree.nearest(
        dust.tree.points()[at], std::ssize(found), [](std::int64_t /*node*/) { return true; }, is_other, found.data());
    return std::span<const std::int64_t>(found).first(static_cast<std::size_t>(count));
}

double reach_of(const Dust& dust, std::int64_t at, std::span<const std::int64_t> near) noexcept {
    return near.empty() ? 0.0 : glm::distance(dust.tree.points()[at], dust.tree.points()[near.back()]);
}

// Returns whether a place lies off the plane through its neighbours, or its neighbours lie in no plane.
bool is_off_neighbours(const Dust& dust, std::int64_t at, std::span<const std::int64_t> near) noexcept {
    const glm::dvec3 place = dust.tree.points()[at];
    orient::Moments moments;
    for (const std::int64_t other : near) moments.add(dust.tree.points()[other] - place);
    const orient::Plane plane = orient::plane_of(moments);
    const double along = std::sqrt(plane.variance[2]);
    return std::abs(glm::dot(moments.sum / moments.count, plane.normal)) > strays_tuning.off_plane * along ||
           std::sqrt(plane.variance[0]) > strays_tuning.thick * along;
}

// Returns whether a place is a stray: its neighbours are far away, farther than theirs, and it lies off their plane.
bool is_stray(const Dust& dust, std::int64_t at, double usual) {
    NearPlaces found;
    const auto near = near_places(dust, at, found);
    if (near.size() < found.size()) return true;
    const double reach = reach_of(dust, at, near);
    std::array<double, strays_tuning.neighbours> of_near{};
    std::transform(near.begin(), near.end(), of_near.begin(),
                   [&](std::int64_t other) { return dust.reach[static_cast<std::size_t>(other)]; });
    std::nth_element(of_near.begin(), of_near.begin() + of_near.size() / 2, of_near.end());
    const double limit = std::min(strays_tuning.sparse * std::max(usual, of_near[of_near.size() / 2]),
                                  strays_tuning.very_sparse * usual);
    return reach > limit && is_off_neighbours(dust, at, near);
}

} // namespace

PointMask find_strays(const Points& points, const base::Parallel& parallel, Pool& pool) {
    PointMask strays(points.size(), 0, &pool);
    Vector<std::size_t> number(&pool);
    geometry::Bounds bounds;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_finite_point(points[i])) {
            number.push_back(i);
            bounds.extend(points[i]);
        }
    const double side = bounds.empty() ? 0.0 : bounds.longest_side();
    if (number.size() < strays_tuning.fewest || !(side > 0.0) || !std::isfinite(side)) return strays;
    geometry::VecArray finite(pool.memory());
    for (const std::size_t i : number) finite.push_back((points[i] - bounds.min) / side);

    Dust dust(finite, pool);
    constexpr std::int64_t at_once = 1024;
    parallel.for_chunks(dust.tree.size(), at_once, [&](std::int64_t begin, std::int64_t end) {
        NearPlaces found;
        for (std::int64_t at = begin; at < end; ++at)
            dust.reach[static_cast<std::size_t>(at)] = reach_of(dust, at, near_places(dust, at, found));
    });
    Vector<double> reach(dust.reach, &pool);
    const double usual = median_of(reach);
    if (!(usual > 0.0)) return strays; // Most points are at places that several points share.
    Vector<std::int64_t> sparse(&pool);
    for (std::int64_t at = 0; at < dust.tree.size(); ++at)
        if (dust.reach[static_cast<std::size_t>(at)] > strays_tuning.sparse * usual) sparse.push_back(at);
    if (static_cast<double>(sparse.size()) > strays_tuning.most * static_cast<double>(number.size())) return strays;
    // Without strays that are found, other strays have fewer neighbours, and are found, too.
    for (int round = 0; round < strays_tuning.rounds; ++round) {
        Vector<std::int64_t> found(&pool);
        for (const std::int64_t at : sparse)
            if (dust.is_stray[static_cast<std::size_t>(at)] == 0 && is_stray(dust, at, usual)) found.push_back(at);
        if (found.empty()) break;
        for (const std::int64_t at : found) dust.is_stray[static_cast<std::size_t>(at)] = 1;
    }
    for (std::int64_t at = 0; at < dust.tree.size(); ++at)
        strays[number[static_cast<std::size_t>(dust.tree.index(at))]] = dust.is_stray[static_cast<std::size_t>(at)];
    return strays;
}

} // namespace hrbfnpr::picture
