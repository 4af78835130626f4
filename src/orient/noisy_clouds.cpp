// SPDX-License-Identifier: MIT
// refine_noisy() tries smooth_directions() with several widths, compares the misfits of chords, and then turns places
// of walls to the nearer face. means_of() replaces points by means, and normals_by_means() transfers the normals of the
// means back to the points.
#include "orient/noisy_clouds.h"

#include "base/assert.h"
#include "orient/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

[[nodiscard]] bool any_place(std::int64_t /*at*/) noexcept { return true; }

[[nodiscard]] double gaussian_weight(double square, double over) noexcept { return std::exp(-square / (over * over)); }

// ---- Means of normals

// A cloud, and the normals to refine.
struct Refinement {
    const base::Work& work;
    const geometry::PointTree& tree;
    const VecArray& normal;
    double spacing;
    base::Array<double> part; // for each place: a term of a sum, or a sign
};

// Returns the median spacing, computed from distances to the sixth neighbour. On an evenly sampled plane, the sixth
// neighbour is 1.38 spacings away.
[[nodiscard]] double median_spacing(const geometry::PointTree& tree, const NeighbourLists& near) {
    constexpr double distance_to_sixth = 1.38;
    base::Array<double> all(tree.points().memory());
    for (std::int64_t at = 0; at < tree.size(); ++at)
        all.push_back(glm::distance(tree.points()[at], tree.points()[near.of(at, 6).back()]));
    std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
    return all[all.size() / 2] / distance_to_sixth;
}

// Returns, for each place, the mean of the nearby places whose normals point the same way.
[[nodiscard]] VecArray mean_places(const Refinement& r, const NeighbourLists& near) {
    VecArray mean(r.work.memory, r.tree.size());
    for_places(r.work, r.tree.size(), [&](std::int64_t at) {
        glm::dvec3 sum = r.tree.points()[at];
        double all = 1.0;
        for (const std::int32_t other : near.of(at, tuning.mean_place_neighbours)) {
            const double alike = glm::dot(r.normal[at], r.normal[other]);
            if (!(alike > 0.0)) continue;
            const glm::dvec3 between = r.tree.points()[other] - r.tree.points()[at];
            const double share =
                alike * gaussian_weight(glm::dot(between, between), tuning.mean_place_over * r.spacing);
            sum += share * r.tree.points()[other];
            all += share;
        }
        mean.set(at, (1.0 / all) * sum);
    });
    return mean;
}

// Returns the sum of (2 sin)^2 over pairs of places on one face. The angle is between the chord of the pair and the
// tangent plane to the mean of both normals.
[[nodiscard]] double misfit(Refinement& r, const VecArray& place, const VecArray& normal) {
    const double from = tuning.chords_from * r.spacing;
    for_places(r.work, r.tree.size(), [&](std::int64_t at) {
        double sum = 0.0;
        r.tree.within(r.tree.points()[at], tuning.chords_to * r.spacing, [&](std::int64_t other, double square) {
            if (!(square > from * from) || !(glm::dot(r.normal[at], r.normal[other]) > tuning.same_face)) return;
            const double off = glm::dot(normal[at] + normal[other], place[other] - place[at]);
            sum += off * off / square;
        });
        r.part[at] = sum;
    });
    double all = 0.0;
    for (const double sum : r.part) all += sum;
    return all;
}

// Returns whether a place is nearer to the other face of a wall than to the face it is assigned to. The distance to a
// face is the mean distance to its places, measured along the mean of both normals, so that curved faces work, too.
[[nodiscard]] bool is_of_other_face(const Refinement& r, const VecArray& normal, std::int64_t at) noexcept {
    const glm::dvec3 own = normal[at];
    double here = 0.0, here_all = 0.0, there = 0.0, there_all = 0.0;
    r.tree.within(r.tree.points()[at], tuning.faces_within * r.spacing, [&](std::int64_t other, double square) {
        const double alike = glm::dot(own, normal[other]);
        if (other == at || !(std::abs(alike) > tuning.along_face)) return;
        const double share = std::abs(alike) * gaussian_weight(square, tuning.faces_over * r.spacing);
        const glm::dvec3 across = 0.5 * (own + (alike > 0.0 ? 1.0 : -1.0) * normal[other]);
        const double off = share * glm::dot(across, r.tree.points()[other] - r.tree.points()[at]);
        (alike > 0.0 ? here : there) += off;
        (alike > 0.0 ? here_all : there_all) += share;
    });
    if (!(there_all > tuning.least_other_face) || !(here_all > 0.0)) return false;
    here /= here_all;
    there /= there_all;
    return std::abs(there) < std::abs(here) && there < here;
}

// ---- Means of points

// Returns the nearest mean of points for each place. The means' coordinates are relative to `centre`, in units of
// `spacing`.
[[nodiscard]] base::Array<std::int64_t> nearest_means(const base::Work& work, const Cloud& cloud,
                                                      const geometry::PointTree& means, const glm::dvec3& centre,
                                                      double spacing) {
    base::Array<std::int64_t> nearest(work.memory, cloud.size());
    for_places(work, cloud.size(), [&](std::int64_t at) {
        means.nearest((cloud.point(at) - centre) / spacing, 1, any_place, any_place, &nearest[at]);
    });
    return nearest;
}

// Shifts moments about `origin` to moments about zero, and adds them to `sum`.
void add_moved(const Moments& moments, const glm::dvec3& origin, double weight, Moments& sum) noexcept {
    const double n = moments.count;
    const glm::dvec3& o = origin;
    const glm::dvec3& s = moments.sum;
    sum.count += weight * n;
    sum.sum += weight * (s + n * o);
    std::size_t k = 0;
    for (glm::length_t i = 0; i < 3; ++i)
        for (glm::length_t j = i; j < 3; ++j, ++k)
            sum.square[k] += weight * (moments.square[k] + o[i] * s[j] + s[i] * o[j] + n * o[i] * o[j]);
}

// Returns the normal at a place p, which is given in the coordinates of the means.
[[nodiscard]] glm::dvec3 normal_by_means(const Cloud& means, const base::Array<Moments>& moments,
                                         const VecArray& normal, const glm::dvec3& p) noexcept {
    std::array<std::int64_t, tuning.gathered_means> found;
    const auto there =
        static_cast<std::size_t>(means.tree->nearest(p, tuning.gathered_means, any_place, any_place, found.data()));
    const std::span<const std::int64_t> near(found.data(), there);
    const glm::dvec3 own = normal[near[0]];
    glm::dvec3 side = own;
    for (const std::int64_t mean : near.subspan(1, std::min(tuning.blended_means, there) - 1))
        if (glm::dot(own, normal[mean]) > 0.5) side += normal[mean];
    side = glm::normalize(side);
    Moments sum;
    for (const std::int64_t mean : near) {
        const glm::dvec3 away = means.point(mean) - p;
        const double alike = glm::dot(side, normal[mean]);
        if (alike > 0.0)
            add_moved(moments[mean], away,
                      alike * std::exp(-0.5 * glm::dot(away, away) / (tuning.means_reach * tuning.means_reach)), sum);
    }
    const glm::dvec3 plane = plane_of(sum).normal;
    const double cosine = glm::dot(plane, side);
    // A plane at a steep angle to the mean normal belongs to another face, so only the mean normal is used.
    if (std::abs(cosine) < tuning.plane_across) return side;
    return glm::normalize(side + std::copysign(tuning.plane_weight, cosine) * plane);
}

} // namespace

VecArray smooth_directions(const base::Work& work, const geometry::PointTree& tree, const NeighbourLists& near,
                           const VecArray& normal, double deviation) {
    HRBFNPR_ASSERT(normal.size() == tree.size() && deviation > 0.0);
    VecArray smooth(work.memory, tree.size());
    for_places(work, tree.size(), [&](std::int64_t at) {
        const glm::dvec3 own = normal[at];
        glm::dvec3 sum = own;
        for (const std::int32_t other : near.of(at)) {
            const glm::dvec3 between = tree.points()[other] - tree.points()[at];
            const double alike = glm::dot(own, normal[other]);
            if (alike > 0.0)
                sum += alike * std::exp(-0.5 * glm::dot(between, between) / (deviation * deviation)) * normal[other];
        }
        smooth.set(at, glm::normalize(sum));
    });
    return smooth;
}

void refine_noisy(const base::Work& work, const geometry::PointTree& tree, VecArray& normal) {
    HRBFNPR_ASSERT(normal.size() == tree.size() && tree.size() > 6);
    const NeighbourLists near(work, tree, tuning.mean_direction_neighbours);
    Refinement r{work, tree, normal, median_spacing(tree, near), base::Array<double>(work.memory, tree.size())};
    const VecArray place = mean_places(r, near);
    VecArray best(work.memory);
    double best_over = 0.0;
    double least = tuning.plainly_better * misfit(r, place, normal);
    for (double over = tuning.least_mean_over; over <= tuning.most_mean_over; over += tuning.mean_over_step) {
        VecArray means = smooth_directions(work, tree, near, normal, over * r.spacing / std::sqrt(2.0));
        const double now = misfit(r, place, means);
        if (!(now < least)) continue;
        least = now;
        best = std::move(means);
        best_over = over;
    }
    if (best.empty()) return;
    work.runtime().log(base::LogLevel::debug, "orient: directions are means over %.1f spacings", best_over);
    for (int round = 0; best_over >= tuning.smooth_enough && round < tuning.face_rounds; ++round) {
        for_places(work, tree.size(),
                   [&](std::int64_t at) { r.part[at] = is_of_other_face(r, best, at) ? -1.0 : 1.0; });
        for (std::int64_t at = 0; at < tree.size(); ++at) best.set(at, r.part[at] * best[at]);
    }
    normal = std::move(best);
}

Cloud means_of(const base::Work& work, const Cloud& cloud, std::int64_t count) {
    HRBFNPR_ASSERT(count > 0 && count <= cloud.size());
    VecArray first(work.memory, count);
    for (std::int64_t at = 0; at < cloud.size(); ++at)
        if (cloud.rank[at] < count) first.set(cloud.rank[at], cloud.point(at));
    const geometry::PointTree centres(first, work);
    const base::Array<std::int64_t> nearest = nearest_means(work, cloud, centres, glm::dvec3(0.0), 1.0);
    base::Array<Moments> sum(work.memory, count);
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        sum[nearest[at]].sum += cloud.point(at);
        sum[nearest[at]].count += 1.0;
    }
    base::Array<double> packed(work.memory, 3 * count);
    for (std::int64_t k = 0; k < count; ++k)
        for (glm::length_t c = 0; c < 3; ++c) packed[3 * k + c] = sum[k].sum[c] / sum[k].count;
    return read_cloud(work, {reinterpret_cast<const std::byte*>(packed.data()), count, 24, base::Scalar::float64, 3});
}

VecArray normals_by_means(const base::Work& work, const Cloud& cloud, const Cloud& means, const VecArray& normal) {
    HRBFNPR_ASSERT(normal.size() == means.size() && means.spacing > 0.0);
    const base::Array<std::int64_t> nearest = nearest_means(work, cloud, *means.tree, means.centre, means.spacing);
    const auto place = [&](std::int64_t at) { return (cloud.point(at) - means.centre) / means.spacing; };
    // for each mean: the moments of its points about the mean, in the unit of the means
    base::Array<Moments> moments(work.memory, means.size());
    for (std::int64_t at = 0; at < cloud.size(); ++at) moments[nearest[at]].add(place(at) - means.point(nearest[at]));
    VecArray result(work.memory, cloud.size());
    for_places(work, cloud.size(),
               [&](std::int64_t at) { result.set(at, normal_by_means(means, moments, normal, place(at))); });
    return result;
}

} // namespace hrbfnpr::orient
