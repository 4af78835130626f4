// SPDX-License-Identifier: MIT
#include "orient/means.h"

#include "orient/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr std::int64_t means_a_task = 1024;
// Means that tell the side of a place, and those whose points make its plane.
constexpr std::size_t blended = 4;
constexpr std::size_t gathered = 48;
// Standard deviation of the weights of these, in spacings of the means.
constexpr double reach = 2.0;
// Planes that stand across the side are a wall's, and no more is known than the side; the others count so much.
constexpr double across = 0.5; // cosine
constexpr double weight_of_planes = 2.0;

// Of each place, the mean nearest to it.
[[nodiscard]] base::Array<std::int64_t> nearest_means(const base::Runtime& runtime, const Cloud& cloud,
                                                      const geometry::PointTree& means, const glm::dvec3& centre,
                                                      double spacing, const base::Progress& progress) {
    base::Array<std::int64_t> nearest(runtime.memory, cloud.size());
    runtime.parallel.for_chunks(cloud.size(), means_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t at = begin; at < end; ++at)
            means.nearest((cloud.point(at) - centre) / spacing, 1, [](std::int64_t) { return true; },
                          [](std::int64_t) { return true; }, &nearest[at]);
    });
    return nearest;
}

// How the points of each mean lie, in its unit.
[[nodiscard]] base::Array<Moments> moments_of(const base::Runtime& runtime, const Cloud& cloud, const Cloud& means,
                                              const base::Progress& progress) {
    const base::Array<std::int64_t> nearest =
        nearest_means(runtime, cloud, *means.tree, means.centre, means.spacing, progress);
    base::Array<Moments> moments(runtime.memory, means.size());
    for (std::int64_t at = 0; at < cloud.size(); ++at)
        moments[nearest[at]].add((cloud.point(at) - means.centre) / means.spacing - means.point(nearest[at]));
    return moments;
}

// moments about `origin`, added to those about zero.
void add_moved(const Moments& moments, const glm::dvec3& origin, double weight, Moments& sum) noexcept {
    const double n = moments.count;
    const glm::dvec3& o = origin;
    const glm::dvec3& s = moments.sum;
    sum.count += weight * n;
    sum.sum += weight * (s + n * o);
    const auto add = [&](std::size_t k, glm::length_t i, glm::length_t j) {
        sum.square[k] += weight * (moments.square[k] + o[i] * s[j] + s[i] * o[j] + n * o[i] * o[j]);
    };
    add(0, 0, 0);
    add(1, 0, 1);
    add(2, 0, 2);
    add(3, 1, 1);
    add(4, 1, 2);
    add(5, 2, 2);
}

class ByMeans {
public:
    ByMeans(const Cloud& means, const base::Array<Moments>& moments, const VecArray& normal) noexcept
        : means_(means), moments_(moments), normal_(normal) {}

    // p in the means' coordinates.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& p) const noexcept {
        std::array<std::int64_t, gathered> found;
        const auto there = static_cast<std::size_t>(means_.tree->nearest(
            p, gathered, [](std::int64_t) { return true; }, [](std::int64_t) { return true; }, found.data()));
        const std::span<const std::int64_t> near(found.data(), there);
        const glm::dvec3 side = side_at(near.first(std::min(blended, there)));
        Moments sum;
        for (const std::int64_t mean : near) {
            const glm::dvec3 away = means_.point(mean) - p;
            const double alike = glm::dot(side, normal_[mean]);
            if (alike > 0.0)
                add_moved(moments_[mean], away, alike * std::exp(-0.5 * glm::dot(away, away) / (reach * reach)), sum);
        }
        const glm::dvec3 plane = plane_of(sum).normal;
        const double cosine = glm::dot(plane, side);
        if (std::abs(cosine) < across) return side;
        return glm::normalize(side + std::copysign(weight_of_planes, cosine) * plane);
    }

private:
    [[nodiscard]] glm::dvec3 side_at(std::span<const std::int64_t> near) const noexcept {
        const glm::dvec3 own = normal_[near[0]];
        glm::dvec3 sum = own;
        for (const std::int64_t mean : near.subspan(1))
            if (glm::dot(own, normal_[mean]) > 0.5) sum += normal_[mean];
        return glm::normalize(sum);
    }

    const Cloud& means_;
    const base::Array<Moments>& moments_;
    const VecArray& normal_;
};

} // namespace

Cloud means_of(const base::Runtime& runtime, const Cloud& cloud, std::int64_t count, const base::Progress& progress) {
    VecArray first(runtime.memory, count);
    for (std::int64_t at = 0; at < cloud.size(); ++at)
        if (cloud.rank[at] < count) first.set(cloud.rank[at], cloud.point(at));
    const geometry::PointTree centres(first, progress);
    const base::Array<std::int64_t> nearest = nearest_means(runtime, cloud, centres, glm::dvec3(0.0), 1.0, progress);
    VecArray mean(runtime.memory, count);
    base::Array<double> share(runtime.memory, count);
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        mean.set(nearest[at], mean[nearest[at]] + cloud.point(at));
        share[nearest[at]] += 1.0;
    }
    base::Array<double> packed(runtime.memory, 3 * count);
    for (std::int64_t k = 0; k < count; ++k)
        for (glm::length_t c = 0; c < 3; ++c) packed[3 * k + c] = mean[k][c] / share[k];
    return read_cloud(runtime, {reinterpret_cast<const std::byte*>(packed.data()), count, 24, base::Scalar::float64, 3},
                      progress);
}

VecArray normals_by_means(const base::Runtime& runtime, const Cloud& cloud, const Cloud& means, const VecArray& normal,
                          const base::Progress& progress) {
    const base::Array<Moments> moments = moments_of(runtime, cloud, means, progress);
    const ByMeans by_means(means, moments, normal);
    VecArray result(runtime.memory, cloud.size());
    runtime.parallel.for_chunks(cloud.size(), means_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t at = begin; at < end; ++at)
            result.set(at, by_means.at((cloud.point(at) - means.centre) / means.spacing));
    });
    return result;
}

} // namespace hrbfnpr::orient
